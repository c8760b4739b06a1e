// SPDX-License-Identifier: MIT
#include <irg/spatial/triangle_bvh.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <vector>

#include <doctest/doctest.h>
#include <irg/core/threads.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/mesh/triangulate.hpp>

#include "spatial/bvh_boxes.hpp"
#include "support/random.hpp"

namespace {

template <class T>
using triangles_of = std::vector<std::array<irg::point<T, 3>, 3>>;
using R = irg::ray<double, 3>;
using P = irg::point<double, 3>;
constexpr double infinite = std::numeric_limits<double>::infinity();

int trials(int few, int many) { return std::getenv("IRG_RELEASE_TIER") != nullptr ? many : few; }

// The triangles of a body, times s.
template <class T>
triangles_of<T> triangles(const irg::mesh<double>& body, double s = 1) {
  const irg::mesh<double> m = irg::triangulated(body);
  triangles_of<T> out;
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    out.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
      for (int axis = 0; axis < 3; ++axis)
        out.back()[k][axis] = static_cast<T>(m.positions[m.corner(f, k).position][axis] * s);
  }
  return out;
}

template <class T>
irg::triangle_bvh<T> build(const triangles_of<T>& all, const irg::bvh_options& config = {}) {
  return irg::triangle_bvh<T>(std::span<const std::array<irg::point<T, 3>, 3>>(all), config);
}

template <class T>
std::vector<irg::triangle_hit> crossings(const irg::triangle_bvh<T>& tree, const R& r) {
  std::vector<irg::triangle_hit> all;
  irg::all_hits(tree, r, [&](const irg::triangle_hit& h) { all.push_back(h); });
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.triangle < b.triangle; });
  return all;
}

TEST_CASE("triangle_bvh: constant evaluation, none, one to five, corners that are no numbers") {
  static_assert([] {
    triangles_of<double> two{{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}}}};
    const irg::triangle_bvh<double> tree{std::span<const std::array<P, 3>>(two)};
    const auto hit = irg::closest_hit(tree, R{{0.25, 0.25, 3}, {0, 0, -1}});
    return hit && hit->triangle == 1 && hit->at.t == 2 &&
           irg::any_hit(tree, R{{0.25, 0.25, 0.5}, {0, 0, 1}, 0, 0.75}) &&
           !irg::any_hit(tree, R{{0.25, 0.25, 0.5}, {0, 0, 1}, 0, 0.25});
  }());
  CHECK(!irg::closest_hit(irg::triangle_bvh<float>(), R{{0, 0, 0}, {0, 0, 1}}));
  CHECK(!irg::any_hit(build(triangles_of<float>{}), R{{0, 0, 0}, {0, 0, 1}}));
  triangles_of<double> stack;
  for (int n = 1; n <= 5; ++n) {
    const auto z = static_cast<double>(n);
    stack.push_back({{{0, 0, z}, {1, 0, z}, {0, 1, z}}});
    const auto tree = build(stack);
    CHECK(crossings(tree, R{{0.25, 0.25, 0}, {0, 0, 1}}).size() == stack.size());
    CHECK(irg::closest_hit(tree, R{{0.25, 0.25, 9}, {0, 0, -1}})->triangle == stack.size() - 1);
  }
  stack[2][1].y = std::numeric_limits<double>::quiet_NaN();
  stack[4][0].x = infinite;
  CHECK(crossings(build(stack), R{{0.25, 0.25, 0}, {0, 0, 1}}).size() == 3);
  for (const R& none : {R{{0.25, 0.25, 0}, {0, 0, 0}}, R{{0.25, 0.25, 0}, {0, 0, infinite}},
                        R{{0.25, 0.25, 0}, {0, 0, 1}, 0, -1}, R{{0.25, 0.25, 0}, {0, 0, 1}, 0, 0}})
    CHECK(!irg::any_hit(build(stack), none));
}

TEST_CASE("triangle_bvh: what all triangles asked one by one give, of floats and doubles, for every tree") {
  test::random r(31);
  for (int round = 0; round < 6; ++round) {
    triangles_of<double> all;
    const double s = round % 3 == 0 ? 1 : round % 3 == 1 ? 1e-30 : 1e30;
    const int reach = round < 3 ? 4 : 1000;  // a lattice where most crossings tie, and one where few do
    for (int i = 0; i < 200; ++i) {
      const auto c = [&] {
        return static_cast<double>(static_cast<float>(static_cast<double>(r.integer(-reach, reach)) * s));
      };
      all.push_back({{{c(), c(), c()}, {c(), c(), c()}, {c(), c(), c()}}});
    }
    triangles_of<float> floats(all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k)
        for (int axis = 0; axis < 3; ++axis) floats[i][k][axis] = static_cast<float>(all[i][k][axis]);
    const auto by_area = build(all), by_place = build(all, {irg::bvh_method::morton});
    const auto of_floats = build(floats), by_cuts = build(floats, {irg::bvh_method::spatial_splits, 16, 4});
    for (int i = 0; i < 100; ++i) {
      const auto c = [&] { return static_cast<double>(r.integer(-reach, reach)) * s; };
      const R ray{{c(), c(), c()}, {c(), c(), c()}, 0, i % 2 == 0 ? infinite : 0.5};
      std::vector<irg::triangle_hit> expected;
      for (std::uint32_t k = 0; k < all.size(); ++k)
        if (const auto x = irg::intersect_triangle(ray, all[k][0], all[k][1], all[k][2])) expected.push_back({k, *x});
      CHECK(crossings(by_area, ray) == expected);
      CHECK(crossings(of_floats, ray) == expected);
      CHECK(crossings(by_cuts, ray) == expected);
      const auto first = irg::closest_hit(by_area, ray);
      CHECK(first == irg::closest_hit(by_place, ray));
      CHECK(first == irg::closest_hit(of_floats, ray));
      CHECK(first == irg::closest_hit(by_cuts, ray));
      CHECK(irg::any_hit(by_cuts, ray) == !expected.empty());
      CHECK(first.has_value() == !expected.empty());
      CHECK(irg::any_hit(of_floats, ray) == !expected.empty());
      if (first)
        for (const irg::triangle_hit& h : expected) CHECK(first->at.t <= h.at.t + 0x1p-40 * (reach + 1));
    }
  }
}

// Of rays of floats against triangles of floats, those that a tree answers otherwise than all triangles asked one by
// one: towards what triangles are made of, from and to what is a step of a float beside a crossing, with directions of
// all sizes.
int wrong_of_floats(int reach, float s, int rays, std::uint64_t seed) {
  test::random r(seed);
  const auto c = [&] { return static_cast<float>(r.integer(-reach, reach)) * s; };
  triangles_of<float> all(200);
  for (auto& t : all)
    for (auto& p : t) p = {c(), c(), c()};
  const auto tree = build(all);
  int wrong = 0;
  for (int i = 0; i < rays; ++i) {
    const auto corner = [&] {
      return all[static_cast<std::size_t>(r.integer(0, 199))][static_cast<std::size_t>(r.integer(0, 2))];
    };
    irg::ray<float, 3> ray{{c(), c(), c()}, {c(), c(), c()}};
    if (i % 3 == 0) ray.direction = corner() - ray.origin;
    if (i % 3 == 1) ray = irg::ray<float, 3>{corner(), corner() - corner()};
    const int sizes[] = {0, -64, -40, 25, 60, 0};
    const float size = std::ldexp(1.0f, sizes[i % 6]);
    for (int axis = 0; axis < 3; ++axis) ray.direction[axis] *= size;
    const auto asked = [&] {
      std::vector<irg::triangle_hit> expected, given;
      for (std::uint32_t k = 0; k < all.size(); ++k)
        if (const auto x = irg::intersect_triangle(ray, all[k][0], all[k][1], all[k][2])) expected.push_back({k, *x});
      irg::all_hits(tree, ray, [&](const irg::triangle_hit& h) { given.push_back(h); });
      std::sort(given.begin(), given.end(), [](const auto& a, const auto& b) { return a.triangle < b.triangle; });
      const auto first = irg::closest_hit(tree, ray);
      wrong += given != expected || first.has_value() == expected.empty() ||
               irg::any_hit(tree, ray) == expected.empty() ||
               (first && std::find(expected.begin(), expected.end(), *first) == expected.end());
      return expected;
    };
    const auto met = asked();
    if (met.empty()) continue;
    const float t = static_cast<float>(met[met.size() / 2].at.t);
    for (const float low : {std::nextafter(t, 0.0f), t, std::nextafter(t, std::numeric_limits<float>::infinity())}) {
      ray.low = low;
      asked();
    }
  }
  return wrong;
}

TEST_CASE("triangle_bvh: rays of floats, what all triangles asked one by one give") {
  const int rays = trials(60, 5000);
  for (const float s : {1.0f, 0x1p-30f, 0x1p30f, 0x1p-90f, 0x1p80f}) {
    CHECK(wrong_of_floats(4, s, rays, 91) == 0);
    CHECK(wrong_of_floats(100000, s, rays, 92) == 0);
  }
}

// Long slats side by side, all across the axes, times s.
template <class T>
triangles_of<T> slats(double s) {
  triangles_of<T> all;
  for (int i = 0; i < 10; ++i)
    for (int k = 0; k < 20; ++k) {
      const irg::point<double, 3> p{5.0 * k - 100, 10.0 * i - 100, -90};
      const auto at = [&](double x, double y, double z) {
        return irg::point<T, 3>{static_cast<T>((p.x + x) * s), static_cast<T>((p.y + y) * s),
                                static_cast<T>((p.z + z) * s)};
      };
      all.push_back({{at(0, 0, 0), at(100, 100, 180), at(3, 0, 0)}});
    }
  return all;
}

// Of rays through slats: those that a tree answers otherwise than all triangles asked one by one.
template <class T>
int wrong_through_slats(double s, int rays, std::uint64_t seed) {
  const triangles_of<T> all = slats<T>(s);
  const auto tree = build(all, {irg::bvh_method::spatial_splits, 16, 4});
  const auto by_area = build(all);
  CHECK(tree.tree().earlier.size() > 2 * all.size());  // cut in many parts
  test::random r(seed);
  int wrong = 0;
  for (int i = 0; i < rays; ++i) {
    const auto c = [&] { return static_cast<double>(r.integer(-100, 100)); };
    R ray{{c() * s, c() * s, c() * s}, {c(), c(), c()}, 0, i % 3 == 0 ? s : infinite};
    if (i % 2 == 0) {  // from a corner to a corner
      const auto corner = [&] {
        return all[static_cast<std::size_t>(r.integer(0, 199))][static_cast<std::size_t>(r.integer(0, 2))];
      };
      const auto from = corner(), to = corner();
      for (int axis = 0; axis < 3; ++axis) {
        ray.origin[axis] = static_cast<double>(from[axis]);
        ray.direction[axis] = static_cast<double>(to[axis]) - ray.origin[axis];
      }
      ray.high = i % 4 == 0 ? 1 : 2;
    }
    std::vector<irg::triangle_hit> expected;
    const auto point_of = [](const irg::point<T, 3>& p) {
      return P{static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
    };
    for (std::uint32_t k = 0; k < all.size(); ++k)
      if (const auto x = irg::intersect_triangle(ray, point_of(all[k][0]), point_of(all[k][1]), point_of(all[k][2])))
        expected.push_back({k, *x});
    const auto first = irg::closest_hit(tree, ray);
    wrong += crossings(tree, ray) != expected || first.has_value() == expected.empty() ||
             first != irg::closest_hit(by_area, ray) || irg::any_hit(tree, ray) == expected.empty();
  }
  return wrong;
}

TEST_CASE("triangle_bvh: triangles in parts are crossed once, where all asked one by one are") {
  for (const double s : {1.0, 1e-30, 1e30}) {
    CHECK(wrong_through_slats<double>(s, trials(60, 5000), 61) == 0);
    CHECK(wrong_through_slats<float>(s, trials(60, 5000), 62) == 0);
  }
}

TEST_CASE("triangle_bvh: of triangles crossed in one point the first is decided exactly") {
  // Two planes that cross within a step of a double of the ray, and one triangle many times.
  const double step = 0x1p-52;
  const triangles_of<double> all{{{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}},
                                 {{{0, 0, 1 - step}, {1, 0, 1 - step}, {0, 1, 1 + step}}},
                                 {{{0, 0, 1 - step}, {1, 0, 1 - step}, {0, 1, 1 + step}}}};
  const auto tree = build(all);
  CHECK(irg::closest_hit(tree, R{{0.25, 0.25, 0}, {0, 0, 1}})->triangle == 1);
  CHECK(irg::closest_hit(tree, R{{0.25, 0.5 + step, 0}, {0, 0, 1}})->triangle == 0);
  CHECK(irg::closest_hit(tree, R{{0.25, 0.5, 0}, {0, 0, 1}})->triangle == 0);
  CHECK(irg::closest_hit(tree, R{{0.25, 0.5 - step, 0}, {0, 0, 1}})->triangle == 1);
  const triangles_of<double> equal(5000, all[0]);
  CHECK(irg::closest_hit(build(equal), R{{0.25, 0.25, 0}, {0, 0, 1}})->triangle == 0);
  CHECK(crossings(build(equal), R{{0.25, 0.25, 0}, {0, 0, 1}}).size() == 5000);
}

// Rays from inside of a closed body through its corners and the middles of its sides: how many get out without a
// crossing, and how many do not cross outwards once more than inwards.
template <class T>
std::array<int, 2> leaks(const irg::mesh<double>& body, double s, const P& inside, int rays, std::uint64_t seed,
                         const irg::bvh_options& config = {}) {
  const triangles_of<T> all = triangles<T>(body, s);
  const auto tree = build(all, config);
  test::random random(seed);
  std::array<int, 2> wrong{};
  for (int i = 0; i < rays; ++i) {
    const auto& t = all[static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(all.size()) - 1))];
    const auto k = static_cast<std::size_t>(random.integer(0, 2));
    const double share = i % 2 == 0 ? 0 : i % 4 == 1 ? 0.5 : random.unit();
    R ray{{(inside.x + random.unit() * 0.01) * s, (inside.y + random.unit() * 0.01) * s,
           (inside.z + random.unit() * 0.01) * s},
          {}};
    if (i % 3 == 0) ray.origin = {inside.x * s, inside.y * s, inside.z * s};
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<double>(t[k][axis]), b = static_cast<double>(t[(k + 1) % 3][axis]);
      ray.direction[axis] = a + (b - a) * share - ray.origin[axis];
    }
    int around = 0;
    irg::all_hits(tree, ray, [&](const irg::triangle_hit& h) { around += h.at.side == irg::facing::back ? 1 : -1; });
    wrong[0] += !irg::closest_hit(tree, ray);
    wrong[1] += around != 1;
  }
  return wrong;
}

TEST_CASE("triangle_bvh: nothing gets out of a closed body through its corners and sides, at any scale") {
  const auto sphere = irg::shape_sphere<double>({.slices = 24, .stacks = 12});
  const auto torus = irg::shape_torus<double>({.major_segments = 24, .minor_segments = 12});
  const int rays = trials(500, 100000);
  const irg::bvh_options in_parts{irg::bvh_method::spatial_splits, 4, 4, 0};
  for (const double s : {1.0, 1e-3, 1e-30, 1e30, 1e-300, 1e300}) {
    const bool narrow = s < 1e-37 || s > 1e37;
    CHECK(leaks<double>(sphere, s, {0, 0, 0}, narrow ? rays / 10 : rays, 41) == std::array{0, 0});
    CHECK(leaks<double>(torus, s, {1, 0, 0}, narrow ? rays / 10 : rays, 42) == std::array{0, 0});
    if (!narrow) CHECK(leaks<float>(sphere, s, {0, 0, 0}, rays, 43) == std::array{0, 0});
    if (!narrow) CHECK(leaks<float>(torus, s, {1, 0, 0}, rays, 45, in_parts) == std::array{0, 0});
  }
  CHECK(leaks<float>(irg::shape_cube<double>(), 1, {0.5, 0.5, 0.5}, rays, 44) == std::array{0, 0});
}

// While it lives, the processor takes subnormal numbers for zero, as Embree and others have it: where it can.
struct subnormals_flushed {
#if defined(__SSE2__) && defined(__GNUC__)
  unsigned before = __builtin_ia32_stmxcsr();
  subnormals_flushed() { __builtin_ia32_ldmxcsr(before | 0x8040u); }
  ~subnormals_flushed() { __builtin_ia32_ldmxcsr(before); }
#else
  subnormals_flushed() {}
#endif
  subnormals_flushed(const subnormals_flushed&) = delete;
  subnormals_flushed& operator=(const subnormals_flushed&) = delete;
};

TEST_CASE("triangle_bvh: nothing gets out where subnormal numbers are taken for zero") {
  const auto sphere = irg::shape_sphere<double>({.slices = 24, .stacks = 12});
  const auto torus = irg::shape_torus<double>({.major_segments = 24, .minor_segments = 12});
  const int rays = trials(300, 100000);
  const subnormals_flushed here;
  for (const double s : {1.0, 1e-3, 1e-30, 1e30}) {
    CHECK(leaks<double>(sphere, s, {0, 0, 0}, rays, 51) == std::array{0, 0});
    CHECK(leaks<double>(torus, s, {1, 0, 0}, rays, 52) == std::array{0, 0});
    CHECK(leaks<float>(sphere, s, {0, 0, 0}, rays, 53) == std::array{0, 0});
    CHECK(leaks<float>(torus, s, {1, 0, 0}, rays, 54) == std::array{0, 0});
  }
}

// Rays of a kind: 0 those of a camera's squares, 1 the same with parallel rays, 2 every way, 3 with numbers that no
// packet takes. Every 16th or so of the last is empty.
std::vector<irg::ray<float, 3>> packet_rays(test::random& r, int kind, std::size_t count, float s) {
  std::vector<irg::ray<float, 3>> rays;
  const auto c = [&r](double most) { return static_cast<float>((2 * r.unit() - 1) * most); };
  const irg::point<float, 3> eye{2 + c(1), c(3), c(3)};
  for (std::size_t i = 0; i < count; ++i) {
    irg::ray<float, 3> ray{{eye.x * s, eye.y * s, eye.z * s}, {c(0.3) - eye.x, c(0.3) - eye.y, c(0.3) - eye.z}};
    if (kind == 1) ray = irg::ray<float, 3>{{c(1) * s, c(1) * s, -3 * s}, {0, i % 32 < 16 ? 0.0f : -0.0f, 1}};
    if (kind >= 2) ray = irg::ray<float, 3>{{c(1) * s, c(1) * s, c(1) * s}, {c(1), c(1), c(1)}};
    if (kind == 3) {
      const std::int64_t what = r.integer(0, 40);
      if (what == 0) ray.direction = {0, 0, 0};
      if (what == 1) ray.origin.x = std::numeric_limits<float>::quiet_NaN();
      if (what == 2) ray.direction.y = 0x1p-140f;
      if (what == 3) ray.direction.z = 0x1p100f;
      if (what == 4) ray.origin = {0x1p120f, 0x1p120f, 0x1p120f};
      if (what == 5) ray.low = std::numeric_limits<float>::quiet_NaN();
      if (what == 6) ray.low = -1, ray.high = s;
      if (what == 7) ray.low = ray.high = s;
      if (what == 8) ray.high = -1;
    }
    if (i % 5 == 0) ray.low = 0.5f * s;
    if (i % 7 == 0) ray.high = 2 * s;
    rays.push_back(ray);
  }
  return rays;
}

TEST_CASE("closest_hits: what closest_hit gives of each ray, bit for bit") {
  test::random r(29);
  const auto body = irg::shape_torus<double>({.major_segments = 24, .minor_segments = 12});
  for (const double s : {1.0, 1e-3, 1e-30, 1e30}) {
    const auto all = triangles<float>(body, s);
    const auto tree = build(all);
    const auto wide = build(triangles<double>(body, s));
    for (int kind = 0; kind < 4; ++kind) {
      std::size_t met = 0;
      for (int i = 0; i < trials(12, 2000); ++i) {
        auto rays = packet_rays(r, kind, 16 * 5 + static_cast<std::size_t>(i) % 16, static_cast<float>(s));
        if (kind == 0 && i % 2 == 1)  // as near to corners as floats can tell
          for (std::size_t k = 0; k < rays.size(); ++k) {
            const auto& corner = all[(static_cast<std::size_t>(i) * 7 + k / 6) % all.size()][k % 3];
            for (int axis = 0; axis < 3; ++axis) rays[k].direction[axis] = corner[axis] - rays[k].origin[axis];
          }
        std::vector<std::optional<irg::triangle_hit>> hits(rays.size()), of_wide(rays.size());
        irg::closest_hits(tree, std::span<const irg::ray<float, 3>>(rays), std::span(hits));
        irg::closest_hits(wide, std::span<const irg::ray<float, 3>>(rays), std::span(of_wide));
        std::size_t differ = 0;
        for (std::size_t k = 0; k < rays.size(); ++k) {
          differ +=
              hits[k] != irg::closest_hit(tree, rays[k]) || of_wide[k] != irg::closest_hit(wide, rays[k]) ? 1u : 0u;
          met += hits[k].has_value() ? 1u : 0u;
        }
        CHECK(differ == 0);
      }
      CHECK(met > 100);
    }
  }
  static_assert([] {
    const triangles_of<double> one{{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}}};
    const irg::triangle_bvh<double> tree{std::span<const std::array<P, 3>>(one)};
    const R rays[2] = {{{0.25, 0.25, 3}, {0, 0, -1}}, {{2, 2, 3}, {0, 0, -1}}};
    std::optional<irg::triangle_hit> hits[2];
    irg::closest_hits(tree, std::span<const R>(rays), std::span<std::optional<irg::triangle_hit>>(hits));
    return hits[0] && hits[0]->at.t == 3 && !hits[1];
  }());
}

// Counts of both, which have to be equal, where the hits are: of rays along z from below, at places that no box ends at.
template <class T, class U>
int miscounted(const irg::triangle_bvh<T>& tree, const irg::ray<U, 3>& up, const irg::ray_counts& expected) {
  irg::ray_counts first, any, all;
  std::vector<irg::triangle_hit> counted, uncounted;
  const bool same_first = irg::closest_hit(tree, up, first) == irg::closest_hit(tree, up);
  const bool same_any = irg::any_hit(tree, up, any) == irg::any_hit(tree, up);
  const bool none = !irg::any_hit(tree, up, [](std::uint32_t) { return false; }, any);
  irg::all_hits(tree, up, [&](const irg::triangle_hit& h) { counted.push_back(h); }, all);
  irg::all_hits(tree, up, [&](const irg::triangle_hit& h) { uncounted.push_back(h); });
  const bool some = !counted.empty();
  const auto within = [&](const irg::ray_counts& c, std::uint64_t rays, std::uint64_t times) {
    return c.rays == rays && c.nodes <= times * expected.nodes && c.leaves <= times * expected.leaves &&
           c.primitives <= times * expected.primitives && (!some || (c.leaves > 0 && c.primitives >= c.leaves));
  };
  return !same_first + !same_any + !none + (counted != uncounted) + (all != expected) + !within(first, 1, 1) +
         !within(any, 2, 2) + (!some && first != expected) +
         (!some && (any.nodes != 2 * expected.nodes || any.primitives != 2 * expected.primitives));
}

TEST_CASE("triangle_bvh: what rays ask is counted as each box by itself tells, and counting changes nothing") {
  static_assert([] {
    const triangles_of<double> one{{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}}};
    const irg::triangle_bvh<double> tree{std::span<const std::array<P, 3>>(one)};
    irg::ray_counts counts;
    const bool met = irg::closest_hit(tree, R{{0.25, 0.25, 3}, {0, 0, -1}}, counts).has_value() &&
                     !irg::any_hit(tree, R{{9, 9, 3}, {0, 0, -1}}, counts);
    return met && counts == irg::ray_counts{2, 2, 1, 1};
  }());
  test::random r(33);
  triangles_of<double> all(700);
  const auto c = [&](std::int64_t most) { return static_cast<double>(r.integer(-most, most)); };
  for (auto& t : all) {
    const P p{c(30), c(30), c(30)};
    for (auto& q : t) q = {p.x + c(4), p.y + c(4), p.z + c(4)};
  }
  triangles_of<float> floats(all.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      for (int axis = 0; axis < 3; ++axis) floats[i][k][axis] = static_cast<float>(all[i][k][axis]);
  const auto by_area = build(all);
  const auto of_floats = build(floats, {irg::bvh_method::spatial_splits, 16, 4});
  int wrong = 0;
  for (int i = 0; i < 300; ++i) {
    const double x = c(34) + 0.3125, y = c(34) + 0.6875;
    wrong += miscounted(by_area, R{{x, y, -99}, {0, 0, 1}}, test::asked_along_z(by_area.tree(), x, y, infinite));
    wrong += miscounted(of_floats, irg::ray<float, 3>{{static_cast<float>(x), static_cast<float>(y), -99}, {0, 0, 1}},
                        test::asked_along_z(of_floats.tree(), x, y, infinite));
  }
  CHECK(wrong == 0);
  // Sheets one over the other: what stands behind the first hit is skipped, for one ray and for 16 that go as one.
  triangles_of<float> stack;
  for (int z = 0; z < 500; ++z) {
    const auto h = static_cast<float>(z);
    stack.push_back({{{-900, -900, h}, {900, -900, h}, {0, 900, h}}});
  }
  const auto tree = build(stack);
  for (const float low : {0.0f, 100.5f, 250.5f, 600.0f}) {
    const irg::ray<float, 3> up{{0.25f, 0.5f, -1}, {0, 0, 1}, low};
    irg::ray_counts one, many, all_of_them;
    const auto hit = irg::closest_hit(tree, up, one);
    CHECK(hit.has_value() == (low < 501));
    const std::vector<irg::ray<float, 3>> rays(17, up);
    std::vector<std::optional<irg::triangle_hit>> hits(rays.size());
    irg::closest_hits(tree, std::span<const irg::ray<float, 3>>(rays), std::span(hits), many);
    CHECK(hits[0] == hit);
    CHECK(hits[16] == hit);
    CHECK(many == irg::ray_counts{17, 2 * one.nodes, 2 * one.leaves, 2 * one.primitives});
    if (low == 0) CHECK(one == test::asked_along_z(tree.tree(), 0.25, 0.5, 0));
    irg::all_hits(tree, up, [](const irg::triangle_hit&) {}, all_of_them);
    CHECK(one.primitives < (hit ? 17u : 9u));
    if (low == 0) CHECK(all_of_them.primitives == 500);
  }
}

TEST_CASE("triangle_bvh: executors, moved triangles, any_hit that passes some over") {
  const auto all = triangles<float>(irg::shape_sphere<double>({.slices = 200, .stacks = 100}));
  using span = std::span<const std::array<irg::point<float, 3>, 3>>;
  irg::triangle_bvh<float> tree{span(all)};
  const irg::triangle_bvh<float> parallel(span(all), {}, irg::parallel{3});
  CHECK(tree.tree() == parallel.tree());
  triangles_of<float> moved = all;
  for (auto& t : moved)
    for (auto& p : t) p.x += 5;
  tree.refit(span(moved));
  const irg::ray<float, 3> ray{{5.01f, 0.02f, 0.03f}, {0.3f, 0.4f, 1}};
  const auto hit = irg::closest_hit(tree, ray);
  REQUIRE(hit.has_value());
  CHECK(hit->at.side == irg::facing::back);
  CHECK(irg::closest_hit(build(moved), ray) == hit);
  CHECK(!irg::any_hit(tree, ray, [&](std::uint32_t t) { return t != hit->triangle; }));
}

// What the only triangle of a tree is met by, in all three ways, and by itself.
template <class T>
void check_met(const std::array<irg::point<T, 3>, 3>& triangle, const irg::ray<T, 3>& ray) {
  REQUIRE(irg::intersect_triangle(ray, triangle[0], triangle[1], triangle[2]));
  const auto tree = build(triangles_of<T>{triangle});
  CHECK(irg::closest_hit(tree, ray).has_value());
  CHECK(irg::any_hit(tree, ray));
  int hits = 0;
  irg::all_hits(tree, ray, [&](const irg::triangle_hit&) { ++hits; });
  CHECK(hits == 1);
}

TEST_CASE("triangle_bvh: sizes, distances and directions near the ends of their types") {
  using PF = irg::point<float, 3>;
  using RF = irg::ray<float, 3>;
  for (const float m : {0x1p39f, 0x1p41f, 7.2e12f, 0x1p45f, 0x1p59f, 0x1p61f, 0x1p100f})
    check_met<float>(
        {PF{m, 0, -1.1f * m}, PF{-0.5f * m, 0.8660254f * m, 0.9f * m}, PF{-0.5f * m, -0.8660254f * m, 0.9f * m}},
        RF{{0, 0, 0}, {0, 0, 1}});
  for (const float z : {0x1p-30f, 0x1.cp-41f, 0x1p-46f, 0x1p-80f})
    for (const float s : {0x1p-5f, 0x1p-15f, 0x1p-30f}) {
      const float r = z * s;
      check_met<float>({PF{r, 0, -z}, PF{-0.5f * r, 0.866f * r, 0.67f * z}, PF{-0.5f * r, -0.866f * r, 0.67f * z}},
                       RF{{0, 0, 0}, {0, 0, 1}});
    }
  for (const double far : {0x1p100, 0x1p126, 0x1p128, 0x1p130, 0x1p200, 0x1p900})
    check_met<double>({P{-1, -1, 0.1}, P{1, -1, 0.1}, P{0, 1, -0.3}},
                      R{{-1.75 * far, -0.5 * far, -0.25 * far}, {1.75, 0.5, 0.25}});
  constexpr double k = 0x1p-60;
  for (const double slow : {5e-324, 0x1p-1070, 0x1p-1060, 0x1p-1023, 0x1p-1022, 1e-300})
    check_met<double>({P{0, -k, k}, P{k * 0x1p-75, -k, k}, P{0, k, k}}, R{{k * 0x1p-78, 0, -k}, {0, 0, slow}});
}

TEST_CASE("triangle_bvh: which is first where all parameters round to nothing") {
  test::random r(27);
  int met = 0;
  for (const int exponent : {996, 664, 80, 77, 74}) {
    for (int trial = 0; trial < 60; ++trial) {
      constexpr double s = 1e-300;
      triangles_of<double> all(20);
      for (auto& t : all)
        for (P& p : t) p = {(r.unit() * 2 - 1) * s, (r.unit() * 2 - 1) * s, r.unit() * 2 * s};
      const auto tree = build(all);
      R ray{{(r.unit() - 0.5) * 0.2 * s, (r.unit() - 0.5) * 0.2 * s, -s},
            {(r.unit() - 0.5) * 0.2, (r.unit() - 0.5) * 0.2, 1}};
      const auto slow = irg::closest_hit(tree, ray);
      for (int axis = 0; axis < 3; ++axis) ray.direction[axis] = std::ldexp(ray.direction[axis], exponent);
      const auto fast = irg::closest_hit(tree, ray);
      REQUIRE(fast.has_value() == slow.has_value());
      if (!fast) continue;
      CHECK(fast->triangle == slow->triangle);
      ++met;
    }
  }
  CHECK(met > 100);
}

}  // namespace
