// SPDX-License-Identifier: MIT
#include <irg/solid/self_intersections.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <utility>
#include <vector>

#include <irg/mesh/shapes.hpp>
#include <irg/solid/boolean.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::self_intersections;
using place = irg::point<double, 3>;

constexpr irg::mesh<double> two_triangles(const place& a, const place& b, const place& c) {
  irg::mesh<double> m;
  m.positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, a, b, c};
  irg::add_face(m, std::initializer_list<int>{0, 1, 2});
  irg::add_face(m, std::initializer_list<int>{3, 4, 5});
  return m;
}
constexpr std::size_t meetings(const place& a, const place& b, const place& c) {
  return self_intersections(two_triangles(a, b, c)).size();
}

}  // namespace

TEST_CASE("self_intersections: two triangles, at compile time, too") {
  CHECK_BOTH(meetings({1, 1, -1}, {1, 1, 1}, {2, 2, 1}) == 1);  // through each other
  CHECK_BOTH(meetings({1, 1, 0}, {1, 1, 1}, {2, 2, 1}) == 1);  // a corner in a face
  CHECK_BOTH(meetings({2, 0, 0}, {1, -1, 1}, {2, -2, 1}) == 1);  // a corner on a side
  CHECK_BOTH(meetings({1, 1, 0}, {3, 3, 0}, {1, 3, 0}) == 1);  // in one plane
  CHECK_BOTH(meetings({0, 0, 0}, {0, 4, 0}, {4, 0, 0}) == 1);  // on each other
  CHECK_BOTH(meetings({0, 0, 0}, {4, 0, 0}, {0, -4, 1}) == 0);  // a side in common
  CHECK_BOTH(meetings({0, 0, 0}, {-4, 0, 0}, {0, -4, 1}) == 0);  // a corner in common
  CHECK_BOTH(meetings({0, 0, 0}, {2, 0, 0}, {0, -4, 1}) == 1);  // half a side
  CHECK_BOTH(meetings({1, 1, 5e-324}, {1, 1, 1}, {2, 2, 1}) == 0);
  CHECK_BOTH(self_intersections(irg::mesh<float>{}).empty());
}

TEST_CASE("self_intersections: none in bodies; those of two bodies that cut each other are the pairs of all pairs") {
  CHECK(self_intersections(irg::shape_torus<double>()).empty());
  CHECK(self_intersections(irg::shape_sphere<float>()).empty());
  CHECK(self_intersections(irg::shape_cube<double>()).empty());
  test::random r(20);
  for (int trial = 0; trial < 20; ++trial) {
    irg::mesh<double> m = irg::shape_icosahedron<double>();
    const auto second = irg::shape_torus<double>({.major_segments = 9, .minor_segments = 7});
    const double x = static_cast<double>(r.integer(-4, 4)) * 0.25;
    const auto first = static_cast<std::uint32_t>(m.positions.size());
    for (const place& p : second.positions) m.positions.push_back({p.x + x, p.y, p.z});
    for (std::size_t f = 0; f < second.face_count(); ++f) {
      std::vector<std::uint32_t> corners;
      corners.reserve(second.face_size(f));
      for (std::size_t k = 0; k < second.face_size(f); ++k) corners.push_back(first + second.corner(f, k).position);
      irg::add_face(m, corners);
    }
    std::vector<irg::face_pair> expected;
    for (std::uint32_t s = 0; s < m.face_count(); ++s)
      for (std::uint32_t t = s + 1; t < m.face_count(); ++t) {
        irg::mesh<double> two;
        two.positions = m.positions;
        for (const std::uint32_t f : {s, t})
          irg::add_face(two, std::vector<std::uint32_t>{m.corner(f, 0).position, m.corner(f, 1).position,
                                                        m.corner(f, 2).position});
        if ((s < 20) != (t < 20) && !self_intersections(two).empty()) expected.push_back({s, t});
      }
    CHECK(self_intersections(m) == expected);
  }
}

namespace {

irg::detail::body_triangles body_of(const irg::mesh<double>& m) {
  irg::detail::body_triangles b;
  irg::detail::append_body(b, m);
  irg::detail::merge_bodies(b);
  return b;
}

// Every triangle against every other, without a search.
std::vector<irg::face_pair> all_pairs(const irg::mesh<double>& m) {
  const irg::detail::body_triangles b = body_of(m);
  std::vector<irg::detail::seen_triangle> seen;
  for (std::uint32_t t = 0; t < b.triangles.size(); ++t)
    seen.push_back(irg::detail::see_triangle(b.positions, b.triangles[t], t));
  std::vector<irg::face_pair> found;
  for (std::uint32_t s = 0; s < seen.size(); ++s)
    for (std::uint32_t t = s + 1; t < seen.size(); ++t)
      if (b.face[s] != b.face[t] && seen[s].turn != 0 && seen[t].turn != 0 &&
          irg::detail::pass_through(seen[s], seen[t]))
        found.push_back({std::min(b.face[s], b.face[t]), std::max(b.face[s], b.face[t])});
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

// Triangles round the corner at the origin, or round the side from there to a second corner, and some elsewhere.
enum class round_family { fan, flat_fan, few_directions, book, two_corners, decades, tiny, around };

irg::mesh<double> make_round(round_family family, test::random& r) {
  irg::mesh<double> m;
  const auto put = [&](const place& p) {
    m.positions.push_back(p);
    return static_cast<std::uint32_t>(m.positions.size() - 1);
  };
  const auto number = [&](int most) { return static_cast<double>(r.integer(-most, most)); };
  const auto spread = [&](int powers) {
    return std::ldexp(number(1000), static_cast<int>(r.integer(-powers, powers)) - 10);
  };
  const auto elsewhere = [&]() -> place {
    switch (family) {
      case round_family::flat_fan: return {number(30), number(30), 0};
      case round_family::few_directions: {
        const double k = static_cast<double>(r.integer(1, 4));
        return {k * number(1), k * number(1), k * number(1)};
      }
      case round_family::decades: return {spread(1000), spread(1000), spread(1000)};
      case round_family::tiny: return {number(30) * 0x1p-1074, number(30) * 0x1p-1074, number(30) * 0x1p-1074};
      default: return {number(30), number(30), number(30)};
    }
  };
  const std::uint32_t hub = put({0, 0, 0}), second = put(elsewhere());
  const auto n = static_cast<std::uint32_t>(r.integer(40, 90));
  if (family == round_family::around) {  // a fan that mostly does not meet itself, and one triangle turned
    for (std::uint32_t i = 0; i < n; ++i) {
      const double a = i * 6.283185307179586 / n;
      put({std::cos(a), std::sin(a), 0.1 * static_cast<double>(r.integer(0, 1))});
    }
    for (std::uint32_t i = 0; i < n; ++i)
      irg::add_face(m, std::vector<std::uint32_t>{hub, 2 + i, 2 + (i + (r.integer(0, 20) == 0 ? 4 : 1)) % n});
    return m;
  }
  std::uint32_t last = put(elsewhere());
  for (std::uint32_t i = 0; i < n; ++i) {
    std::uint32_t next = put(elsewhere());
    if (family == round_family::book || r.integer(0, 9) == 0) last = second;
    if (r.integer(0, 19) == 0) m.positions[next] = m.positions[last];
    const std::uint32_t at = family == round_family::two_corners && r.integer(0, 1) == 0 ? second : hub;
    irg::add_face(m, std::vector<std::uint32_t>{r.integer(0, 14) == 0 ? put(elsewhere()) : at, last, next});
    last = next;
  }
  return m;
}

}  // namespace

TEST_CASE("self_intersections: round one corner or side the pairs of all pairs") {
  test::random r(62);
  const int rounds = std::getenv("IRG_RELEASE_TIER") ? 2000 : 6;
  for (const auto family : {round_family::fan, round_family::flat_fan, round_family::few_directions, round_family::book,
                            round_family::two_corners, round_family::decades, round_family::tiny, round_family::around})
    for (int trial = 0; trial < rounds; ++trial) {
      irg::mesh<double> m = make_round(family, r);
      // A hub elsewhere, where directions are rounded.
      if (family != round_family::decades && family != round_family::tiny && r.integer(0, 1) == 0)
        for (place& p : m.positions) p = {p.x * 0.1 + 7, p.y * 0.3 - 1e5, p.z * 0.7 + 0.01};
      INFO(static_cast<int>(family) << " " << trial);
      CHECK(self_intersections(m) == all_pairs(m));
    }
}

namespace {

// Bodies made of rings of n corners, fans and the strips between rings, turned and moved.
struct rings {
  irg::mesh<double> m{};
  double turn = 0;
  place origin{};
  std::uint32_t n = 0;

  std::uint32_t put(double x, double y, double z) {
    const double c = std::cos(turn), s = std::sin(turn), u = c * x - s * z;
    m.positions.push_back({c * u - s * y + origin.x, s * u + c * y + origin.y, s * x + c * z + origin.z});
    return static_cast<std::uint32_t>(m.positions.size() - 1);
  }
  std::uint32_t ring(double radius, double z) {
    const auto first = static_cast<std::uint32_t>(m.positions.size());
    for (std::uint32_t i = 0; i < n; ++i)
      put(radius * std::cos(i * 6.283185307179586 / n), radius * std::sin(i * 6.283185307179586 / n), z);
    return first;
  }
  void fan(std::uint32_t hub, std::uint32_t ring) {
    for (std::uint32_t i = 0; i < n; ++i)
      irg::add_face(m, std::vector<std::uint32_t>{hub, ring + i, ring + (i + 1) % n});
  }
  void strip(std::uint32_t low, std::uint32_t high) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t next = (i + 1) % n;
      irg::add_face(m, std::vector<std::uint32_t>{low + i, low + next, high + next});
      irg::add_face(m, std::vector<std::uint32_t>{low + i, high + next, high + i});
    }
  }
  void cone(double radius, double height, double z) {
    const std::uint32_t base = ring(radius, z);
    fan(put(0, 0, z + height), base);
    fan(put(0, 0, z), base);
  }
};

enum class hub_family {
  fan,
  cone,
  turned_cone,
  bipyramid,
  frustum,
  book,
  poles,
  flat_cone,
  crossing_cones,
  cone_on_polygon,
  crossing_fans,
  facing_cones,
  nested_cones
};
constexpr hub_family all_hubs[] = {hub_family::fan,
                                   hub_family::cone,
                                   hub_family::turned_cone,
                                   hub_family::bipyramid,
                                   hub_family::frustum,
                                   hub_family::book,
                                   hub_family::poles,
                                   hub_family::flat_cone,
                                   hub_family::cone_on_polygon,
                                   hub_family::crossing_cones,
                                   hub_family::crossing_fans,
                                   hub_family::facing_cones,
                                   hub_family::nested_cones};

irg::mesh<double> make_hubs(hub_family family, std::uint32_t n) {
  rings r;
  const auto turn = [&](double by, const place& to) { r.turn = by, r.origin = to; };
  switch (family) {
    case hub_family::fan:
      r.n = n;
      r.fan(r.put(0, 0, 0), r.ring(1, 0));
      break;
    case hub_family::turned_cone: turn(0.7, {0.1, 0.2, 0.3}); [[fallthrough]];
    case hub_family::cone:
      r.n = n / 2;
      r.cone(1, 2, 0);
      break;
    case hub_family::flat_cone:
      turn(0.7, {0.1, 0.2, 0.3});
      r.n = n / 2;
      r.cone(1, 0.001, 0);
      break;
    case hub_family::bipyramid: {
      turn(0.3, {});
      r.n = n / 2;
      const std::uint32_t ring = r.ring(1, 0);
      r.fan(r.put(0, 0, 1), ring);
      r.fan(r.put(0, 0, -1), ring);
      break;
    }
    case hub_family::cone_on_polygon: {
      turn(0.3, {});
      r.n = n / 2;
      const std::uint32_t ring = r.ring(1, 0);
      r.fan(r.put(0, 0, 1), ring);
      std::vector<std::uint32_t> base;
      for (std::uint32_t i = r.n; i-- > 0;) base.push_back(ring + i);
      irg::add_face(r.m, base);
      break;
    }
    case hub_family::frustum: {
      turn(0.5, {});
      r.n = n / 4;
      const std::uint32_t low = r.ring(1, 0), high = r.ring(0.5, 2);
      r.strip(low, high);
      r.fan(r.put(0, 0, 0), low);
      r.fan(r.put(0, 0, 2), high);
      break;
    }
    case hub_family::book: {
      turn(0.5, {});
      r.n = n;
      const std::uint32_t a = r.put(0, 0, 0), b = r.put(0, 0, 1), ring = r.ring(1, 0.3);
      for (std::uint32_t i = 0; i < n; ++i) irg::add_face(r.m, std::vector<std::uint32_t>{a, b, ring + i});
      break;
    }
    case hub_family::poles: {  // eight stacks
      turn(0.5, {});
      r.n = n / 14;
      std::uint32_t last = 0;
      for (int i = 1; i < 8; ++i) {
        const double a = i * 3.141592653589793 / 8;
        const std::uint32_t ring = r.ring(std::sin(a), std::cos(a));
        if (i > 1) r.strip(last, ring);
        if (i == 1) r.fan(r.put(0, 0, 1), ring);
        if (i == 7) r.fan(r.put(0, 0, -1), ring);
        last = ring;
      }
      break;
    }
    case hub_family::crossing_cones:
      r.n = n / 4;
      r.cone(1, 2, 0);
      turn(0.7, {0.3, 0.2, 0.3});
      r.cone(1, 2, 0);
      break;
    case hub_family::crossing_fans:
      r.n = n / 2;
      for (const double by : {0.5, 1.1}) {
        turn(by, {0.4 * by, 0.2 * by, 0});
        r.fan(r.put(0, 0, 0), r.ring(1, 0));
      }
      break;
    case hub_family::facing_cones:
      r.n = n / 4;
      r.cone(1, 2, 0);
      r.cone(1, -2, 1.5);
      break;
    case hub_family::nested_cones:
      turn(0.4, {});
      r.n = n / 20;
      for (int i = 0; i < 10; ++i) r.cone(1.1 + 0.1 * i, 2.2 + 0.2 * i, -0.05 * i);
      break;
  }
  return std::move(r.m);
}

}  // namespace

TEST_CASE("self_intersections: fans, cones and their like, the pairs of all pairs") {
  for (const hub_family family : all_hubs) {
    const irg::mesh<double> m = make_hubs(family, 300);
    INFO(static_cast<int>(family));
    CHECK(self_intersections(m) == all_pairs(m));
  }
}

TEST_CASE("self_intersections: growth, looks at triangles round a corner") {
  const bool is_release = std::getenv("IRG_RELEASE_TIER") != nullptr;
  for (const hub_family family : all_hubs) {
    const bool are_dear = family > hub_family::crossing_cones;
    const std::uint32_t most = (is_release ? 1'000'000u : 10'000u) / (are_dear ? 10u : 1u);
    for (std::uint32_t n = 1000; n <= most; n *= 10) {
      std::size_t looks = 0;
      const std::size_t found = irg::detail::meeting_faces(body_of(make_hubs(family, n)), looks).size();
      INFO(static_cast<int>(family) << " " << n << ": " << looks << " looks, " << found << " pairs");
      CHECK(static_cast<double>(looks) <= 320.0 * n * std::log2(n) + 8 * static_cast<double>(found));
    }
  }
}

namespace {

using irg::detail::space_box;

// Boxes of faces of which none is told from the others by the middle planes of the longest axis, or of any.
enum class box_family { bars, rods, rows, shells, level };

std::vector<space_box> make_boxes(box_family family, int n) {
  test::random r(61);
  std::vector<space_box> boxes;
  const auto number = [&] { return static_cast<double>(r.integer(0, 1 << 20)); };
  for (int i = 0; i < n; ++i) {
    const double k = i;
    switch (family) {
      case box_family::bars: boxes.push_back({{-1e9, 2 * k, 0}, {1e9, 2 * k + 1, 1}}); break;
      case box_family::rods: {
        const double at[] = {number(), number(), number()};
        space_box b{{at[0], at[1], at[2]}, {at[0], at[1], at[2]}};
        b.low[i % 3] = -1, b.high[i % 3] = 1 << 21;
        boxes.push_back(b);
        break;
      }
      case box_family::rows: boxes.push_back({{-1e6, k / 64, double(i % 64)}, {1e6, k / 64, i % 64 + 0.5}}); break;
      case box_family::shells: {  // the six faces of cubes round each other
        const double side = 1 + i / 6;
        space_box b{{-side, -side, -side}, {side, side, side}};
        (i % 2 != 0 ? b.low : b.high)[i / 2 % 3] = i % 2 != 0 ? side : -side;
        boxes.push_back(b);
        break;
      }
      case box_family::level: boxes.push_back({{-k, -k, k}, {k, k, k}}); break;
    }
  }
  return boxes;
}

struct pairs_found {
  std::vector<irg::face_pair> pairs;
  std::size_t looks;
};
pairs_found find_pairs(const std::vector<space_box>& boxes) {
  pairs_found found{};
  std::vector<std::uint32_t> all;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) all.push_back(i);
  const auto use = [&](std::uint32_t a, std::uint32_t b) { found.pairs.push_back({a, b}); };
  irg::detail::box_pair_search<decltype(use)> search(boxes, use);
  search.search(all, all);
  found.looks = search.looks;
  std::sort(found.pairs.begin(), found.pairs.end());
  return found;
}

constexpr box_family all_families[] = {box_family::bars, box_family::rods, box_family::rows, box_family::shells,
                                       box_family::level};

}  // namespace

TEST_CASE("box_pair_search: each pair that meets, once") {
  for (const box_family family : all_families) {
    const auto boxes = make_boxes(family, 300);
    std::vector<irg::face_pair> expected;
    for (std::uint32_t a = 0; a < boxes.size(); ++a)
      for (std::uint32_t b = 0; b < boxes.size(); ++b)
        if (boxes[a].meets(boxes[b])) expected.push_back({a, b});
    CHECK(find_pairs(boxes).pairs == expected);
  }
}

TEST_CASE("box_pair_search: growth, looks at boxes that straddle the middle planes") {
  const int most = std::getenv("IRG_RELEASE_TIER") ? 1'000'000 : 10'000;
  for (const box_family family : all_families)
    for (int n = 1000; n <= most; n *= 10) {
      // Rods along three axes pass close by each other: any tree of boxes meets the square root of them with each.
      const bool are_rods = family == box_family::rods;
      if (are_rods && n > 100'000) continue;
      const pairs_found found = find_pairs(make_boxes(family, n));
      INFO(static_cast<int>(family) << " " << n << ": " << found.looks << " looks, " << found.pairs.size() << " pairs");
      const double size = static_cast<double>(n), each = are_rods ? 16 * std::sqrt(size) : 60 * std::log2(size);
      CHECK(static_cast<double>(found.looks) <= size * each + 8 * static_cast<double>(found.pairs.size()));
    }
}

TEST_CASE("box_tree: growth, boxes asked for many places") {
  const int most = std::getenv("IRG_RELEASE_TIER") ? 1'000'000 : 10'000;
  for (const box_family family : {box_family::rows, box_family::bars})
    for (int n = 1000; n <= most; n *= 10) {
      const auto boxes = make_boxes(family, n);
      std::vector<std::uint32_t> all;
      for (std::uint32_t i = 0; i < boxes.size(); ++i) all.push_back(i);
      irg::detail::box_tree tree(all, 2);
      std::size_t asked = 0;
      int wrong = 0;
      for (int k = 0; k < 1000; ++k) {
        const space_box& at = boxes[static_cast<std::size_t>(k) * boxes.size() / 1000];
        std::size_t found = 0;
        const auto is_off = [&](const space_box& b) {
          return b.high[1] < at.low[1] || at.low[1] < b.low[1] || b.high[2] < at.low[2];
        };
        asked += tree.each(boxes, is_off, [&](std::uint32_t) { ++found; });
        if (k % 100 == 0)
          wrong += found != static_cast<std::size_t>(std::count_if(boxes.begin(), boxes.end(),
                                                                   [&](const space_box& b) { return !is_off(b); }));
      }
      CHECK(wrong == 0);
      CHECK(asked <= 16 * boxes.size() + 1000 * 200);
    }
}
