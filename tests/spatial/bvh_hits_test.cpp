// SPDX-License-Identifier: MIT
#include <irg/spatial/bvh_hits.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <doctest/doctest.h>

#include "spatial/bvh_boxes.hpp"

namespace {

using R = irg::ray<double, 3>;
constexpr double infinite = std::numeric_limits<double>::infinity();

// Every box is met wherever it is asked: what the tree finds are boxes that it could not exclude.
constexpr auto always = [](std::uint32_t, const auto& r) { return std::optional(r.low); };

template <class T>
bool finds(const irg::bvh& tree, const irg::ray<T, 3>& r, std::uint32_t number) {
  bool found = false;
  irg::all_hits(tree, r, always, [&](const irg::primitive_hit<T>& h) { found = found || h.primitive == number; });
  return found;
}

// Rays of whole numbers through points of boxes: corners, sides, faces, insides, along faces and sides.
template <class T>
int missed(double s, int rays, std::uint64_t seed) {
  test::random r(seed);
  const auto boxes = test::lattice_boxes<T>(r, 100, s);
  const irg::bvh tree = irg::build_bvh(std::span<const irg::box<T, 3>>(boxes));
  int missed = 0;
  for (int i = 0; i < rays; ++i) {
    const auto number = static_cast<std::uint32_t>(r.integer(0, 99));
    const irg::box<T, 3>& b = boxes[number];
    irg::ray<T, 3> ray;
    const auto steps = r.integer(0, 4);
    for (int axis = 0; axis < 3; ++axis) {
      const T at = r.integer(0, 1) == 0 ? b.low[axis] : b.high[axis];
      const auto d = r.integer(-3, 3);
      ray.direction[axis] = static_cast<T>(static_cast<double>(d) * s);
      ray.origin[axis] = static_cast<T>(static_cast<double>(at) - static_cast<double>(d * steps) * s);
    }
    if (ray.empty()) continue;
    ray.low = ray.high = static_cast<T>(steps);
    missed += !finds(tree, ray, number);
    ray.low = 0;
    ray.high = static_cast<T>(infinite);
    missed += !finds(tree, ray, number);
    irg::ray<T, 3> slow = ray;
    for (int axis = 0; axis < 3; ++axis) slow.direction[axis] = static_cast<T>(slow.direction[axis] * T(0x1p-30));
    if (!slow.empty() && sizeof(T) == 8 && s > 1e-290) missed += !finds(tree, slow, number);
  }
  return missed;
}

TEST_CASE("bvh: no box that a ray meets is missed, at any scale") {
  for (const double s : {1.0, 3.0, 1e-300, 1e300, 0x1p-1074, 0x1p-1030, 0x1p1018, 1e-150})
    CHECK(missed<double>(s, 2000, 7) == 0);
  for (const double s : {1.0, 0x1p-149, 0x1p-120, 0x1p120}) CHECK(missed<float>(s, 2000, 8) == 0);
}

TEST_CASE("bvh: boxes that no ray comes near are not asked, of a ray without points nothing is") {
  test::random r(9);
  const auto boxes = test::lattice_boxes<double>(r, 1000, 1, 100);
  const irg::bvh tree = irg::build_bvh(std::span<const irg::box<double, 3>>(boxes));
  int asked = 0;
  const auto count = [&](std::uint32_t, const R&) -> std::optional<double> { return ++asked, std::nullopt; };
  CHECK(!irg::closest_hit(tree, R{{-300, 0.25, 0.25}, {1, 0, 0}}, count));
  CHECK(asked < 60);
  asked = 0;
  for (const R& none : {R{{0, 0, 0}, {0, 0, 0}}, R{{infinite, 0, 0}, {0, 0, 1}}, R{{0, 0, 0}, {0, 0, 1}, 3, 2},
                        R{{0, 0, 0}, {0, 0, 1}, -3, -2}}) {
    CHECK(!irg::closest_hit(tree, none, count));
    CHECK(!irg::any_hit(tree, none, count));
  }
  CHECK(!irg::any_hit(irg::bvh{}, R{{0, 0, 0}, {0, 0, 1}}, count));
  CHECK(asked == 0);
  // Far origins, slow and fast directions, an end at the origin.
  CHECK(!irg::any_hit(tree, R{{1e300, 1e300, 1e300}, {1e-300, 0, 0}}, count));
  CHECK(irg::any_hit(tree, R{{boxes[3].low.x - 1e9, boxes[3].low.y, boxes[3].low.z}, {1e-300, 0, 0}}, always));
  CHECK(irg::any_hit(tree, R{boxes[3].low, {5e-324, 0, 0}, 0, 0}, always));
}

// Spheres about the middles of boxes.
TEST_CASE("bvh: closest, any and all hits of primitives of the caller's, against all of them one by one") {
  test::random r(10);
  struct sphere {
    irg::point<double, 3> middle;
    double radius;
  };
  std::vector<sphere> spheres;
  std::vector<irg::box<double, 3>> boxes;
  for (int i = 0; i < 300; ++i) {
    const sphere s{{r.unit() * 10, r.unit() * 10, r.unit() * 10}, 0.1 + r.unit() * 0.5};
    spheres.push_back(i % 10 == 9 ? spheres.back() : s);
    const irg::vec<double, 3> half{spheres.back().radius, spheres.back().radius, spheres.back().radius};
    boxes.push_back({spheres.back().middle - half, spheres.back().middle + half});
  }
  const auto meet = [&](std::uint32_t i, const R& ray) -> std::optional<double> {
    const irg::vec<double, 3> m = ray.origin - spheres[i].middle;
    const double a = irg::dot(ray.direction, ray.direction), b = irg::dot(m, ray.direction),
                 c = irg::dot(m, m) - spheres[i].radius * spheres[i].radius, under = b * b - a * c;
    if (under < 0) return std::nullopt;
    const double t = (-b - irg::sqrt(under)) / a;
    return t >= ray.low && t <= ray.high ? std::optional(t) : std::nullopt;
  };
  for (const irg::bvh_method method :
       {irg::bvh_method::surface_area, irg::bvh_method::morton, irg::bvh_method::spatial_splits}) {
    const irg::bvh tree = irg::build_bvh(std::span<const irg::box<double, 3>>(boxes), {method});
    for (int i = 0; i < 500; ++i) {
      const R ray{{r.unit() * 10, r.unit() * 10, r.unit() * 10},
                  {r.unit() - 0.5, r.unit() - 0.5, r.unit() - 0.5},
                  0,
                  i % 2 == 0 ? infinite : 3.0};
      std::optional<irg::primitive_hit<double>> best;
      std::size_t all = 0;
      for (std::uint32_t k = 0; k < spheres.size(); ++k)
        if (const auto t = meet(k, ray)) {
          ++all;
          if (!best || *t < best->t) best = {k, *t};
        }
      CHECK(irg::closest_hit(tree, ray, meet) == best);
      CHECK(irg::any_hit(tree, ray, meet) == best.has_value());
      irg::all_hits(tree, ray, meet, [&](const auto&) { --all; });
      CHECK(all == 0);
    }
  }
}

// Sheets across z, and rays so fast that times are subnormal: many are one number, and as many come out as zero.
TEST_CASE("bvh: of what is met at times that underflow to one number, the lowest number") {
  test::random r(31);
  for (const float fast : {0x1p100f, 0x1p96f, 0x1p90f, 0x1p80f}) {
    std::vector<irg::box<float, 3>> boxes;
    for (int i = 0; i < 60; ++i) {
      const float z = static_cast<float>(r.unit() + 0.01) * 0x1p-50f;
      boxes.push_back({{-1, -1, z}, {1, 1, z}});
    }
    const irg::bvh tree = irg::build_bvh(std::span<const irg::box<float, 3>>(boxes));
    const irg::ray<float, 3> ray{{0.25f, 0.5f, 0}, {0, 0, fast}};
    const auto test = [&](std::uint32_t i, const auto&) { return std::optional<float>(boxes[i].low.z / fast); };
    irg::primitive_hit<float> first{0, *test(0, ray)};
    for (std::uint32_t i = 1; i < 60; ++i)
      if (*test(i, ray) < first.t) first = {i, *test(i, ray)};
    CHECK((irg::closest_hit(tree, ray, test) == first));
  }
}

TEST_CASE("bvh: what stands in a box, against all boxes") {
  test::random r(13);
  const auto boxes = test::lattice_boxes<double>(r, 500, 0.25, 30);
  const irg::bvh tree = irg::build_bvh(std::span<const irg::box<double, 3>>(boxes));
  for (const auto& asked : test::lattice_boxes<double>(r, 50, 0.25, 30)) {
    std::vector<int> seen(boxes.size(), 0);
    irg::each_in_box(tree, asked, [&](std::uint32_t i) { ++seen[i]; });
    int more = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const bool meets = irg::overlap(boxes[i], asked);
      CHECK(seen[i] <= 1);
      CHECK((seen[i] == 1 || !meets));
      more += seen[i] == 1 && !meets;
    }
    CHECK(more < 100);  // leaves are asked as a whole
  }
  irg::each_in_box(tree, irg::box<double, 3>{}, [](std::uint32_t) { CHECK(false); });
}

TEST_CASE("bvh: lanes and scalars go the same way") {
  test::random r(11);
  const auto boxes = test::lattice_boxes<float>(r, 2000, 0.5, 60);
  const irg::bvh tree = irg::build_bvh(std::span<const irg::box<float, 3>>(boxes));
  for (int i = 0; i < 300; ++i) {
    const auto c = [&] { return static_cast<double>(r.integer(-60, 60)) * 0.5; };
    const R ray{{c(), c(), c()}, {c(), c(), c()}};
    if (ray.empty()) continue;
    const auto way = [&]<class F>() {
      std::vector<std::uint32_t> leaves;
      irg::detail::box_ray b{};
      irg::detail::set_box_ray(b, ray, tree.scale);
      irg::detail::walk_sorted<F, irg::detail::box_arithmetic::portable>(
          tree.nodes.data(), b, [&](std::uint32_t leaf) { leaves.push_back(leaf); });
      return leaves;
    };
    const auto scalar = way.template operator()<float>();
    CHECK(scalar == (way.template operator()<irg::pack<float, 4>>()));
    CHECK(scalar == (way.template operator()<irg::pack<float, 8>>()));
  }
}

static_assert([] {
  test::random r(12);
  const auto boxes = test::lattice_boxes<double>(r, 20, 1);
  const irg::bvh tree = irg::build_bvh(std::span<const irg::box<double, 3>>(boxes));
  return irg::any_hit(tree, R{boxes[5].low, {1, 2, 3}, 0, 0}, always) &&
         irg::closest_hit(tree, R{boxes[5].low, {1, 2, 3}}, always)->t == 0;
}());

TEST_CASE("bvh: what rays ask is counted as each box by itself tells, and counting changes nothing") {
  // Two boxes in one node; a ray that meets one of them, one that has no points, a tree of nothing.
  constexpr auto one = [] {
    const std::vector<irg::box<double, 3>> two{{{0, 0, 0}, {1, 1, 1}}, {{4, 0, 0}, {5, 1, 1}}};
    const irg::bvh tree = irg::build_bvh(std::span<const irg::box<double, 3>>(two));
    irg::ray_counts counts;
    const R up{{0.5, 0.5, -1}, {0, 0, 1}};
    const bool met = irg::any_hit(tree, up, always, counts) && !irg::any_hit(irg::bvh{}, up, always, counts) &&
                     !irg::any_hit(tree, R{{0.5, 0.5, -1}, {0, 0, 0}}, always, counts);
    return met ? counts : irg::ray_counts{};
  };
  static_assert(one().rays == 3 && one().nodes == 1 && one().leaves == 1);
  CHECK(one() == irg::ray_counts{3, 1, 1, one().primitives});
  test::random r(15);
  const auto boxes = test::lattice_boxes<double>(r, 900, 1, 40);
  for (const irg::bvh_method method :
       {irg::bvh_method::surface_area, irg::bvh_method::morton, irg::bvh_method::spatial_splits}) {
    const irg::bvh tree = irg::build_bvh(std::span<const irg::box<double, 3>>(boxes), {method});
    std::size_t far = 0;
    for (int i = 0; i < 200; ++i) {
      const double x = static_cast<double>(r.integer(-40, 40)) + 0.375;
      const double y = static_cast<double>(r.integer(-40, 40)) + 0.625;
      const R up{{x, y, -100}, {0, 0, 1}};
      const irg::ray_counts expected = test::asked_along_z(tree, x, y, infinite);
      std::uint64_t asked = 0;
      const auto never = [&](std::uint32_t, const R&) -> std::optional<double> { return ++asked, std::nullopt; };
      irg::ray_counts first, any, all;
      CHECK(!irg::closest_hit(tree, up, never, first));
      CHECK(asked == first.primitives);
      CHECK(!irg::any_hit(tree, up, never, any));
      CHECK(asked == 2 * any.primitives);
      std::vector<irg::primitive_hit<double>> counted, uncounted;
      irg::all_hits(tree, up, always, [&](const auto& h) { counted.push_back(h); }, all);
      irg::all_hits(tree, up, always, [&](const auto& h) { uncounted.push_back(h); });
      CHECK(first == expected);
      CHECK(any == expected);
      CHECK(all == expected);
      CHECK(counted == uncounted);
      far += expected.nodes > 3;
    }
    CHECK(far > 100);
  }
}

TEST_CASE("bvh: rays from nowhere meet nothing, and nothing is asked") {
  constexpr float nowhere = std::numeric_limits<float>::quiet_NaN();
  const std::vector<irg::box<float, 3>> boxes{{{-1, -1, -1}, {1, 1, 1}}};
  const irg::bvh tree = irg::build_bvh(std::span<const irg::box<float, 3>>(boxes));
  for (const float d : {1.0f, 0.5f, 0.7f, -1.0f, 0x1p-70f, 0x1p30f, nowhere})
    for (unsigned mask = 0; mask < 8; ++mask) {
      irg::ray<float, 3> ray{{0.1f, 0.1f, -1}, {d, d, d}};
      for (int axis = 0; axis < 3; ++axis)
        if ((mask >> axis & 1) != 0) ray.origin[axis] = nowhere;
      if (mask == 0 && d == d) continue;
      int asked = 0;
      const auto test = [&](std::uint32_t, const irg::ray<float, 3>&) {
        ++asked;
        return std::optional<float>(1.0f);
      };
      CHECK(!irg::any_hit(tree, ray, test));
      CHECK(!irg::closest_hit(tree, ray, test));
      CHECK(asked == 0);
    }
}

TEST_CASE("bvh: what stands in a box, where boxes are so close that many do") {
  test::random r(14);
  const auto boxes = test::lattice_boxes<double>(r, 400, 0.25, 6);
  for (const irg::bvh_method method :
       {irg::bvh_method::surface_area, irg::bvh_method::morton, irg::bvh_method::spatial_splits}) {
    const irg::bvh tree = irg::build_bvh(std::span<const irg::box<double, 3>>(boxes), {method});
    int met = 0, wrong = 0;
    for (const auto& asked : test::lattice_boxes<double>(r, 60, 0.25, 6)) {
      std::vector<int> seen(boxes.size(), 0);
      irg::each_in_box(tree, asked, [&](std::uint32_t i) { ++seen[i]; });
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        const bool meets = irg::overlap(boxes[i], asked);
        wrong += meets ? seen[i] != 1 : seen[i] > 1;
        met += meets;
      }
    }
    CHECK(wrong == 0);
    CHECK(met > 120);
  }
}

TEST_CASE("bvh: nothing behind the origin of a ray is met, wherever the ray begins") {
  const std::vector<irg::box<double, 3>> boxes{{{-1, -1, -1}, {1, 1, 1}}};
  const irg::bvh tree = irg::build_bvh(std::span<const irg::box<double, 3>>(boxes));
  const R ray{{0, 0, 0}, {0, 0, 1}, -10, 10};
  double least = 1;
  for (const double t : {-9.0, -0.5, 0.5}) {
    const auto test = [&](std::uint32_t, const R& asked) {
      least = std::min(least, asked.low);
      return std::optional(t);
    };
    int all = 0;
    irg::all_hits(tree, ray, test, [&](const auto&) { ++all; });
    CHECK(all == (t > 0));
    CHECK(irg::any_hit(tree, ray, test) == (t > 0));
    CHECK(irg::closest_hit(tree, ray, test).has_value() == (t > 0));
  }
  CHECK(least == 0);
}

}  // namespace
