// SPDX-License-Identifier: MIT
#include <irg/solid/self_intersections.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
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
