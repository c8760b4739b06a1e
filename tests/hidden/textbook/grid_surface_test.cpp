// SPDX-License-Identifier: MIT
#include <irg/hidden/textbook/grid_surface.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::textbook::leaving_corners;
using irg::textbook::perimeter_crossing;
using place = irg::point<double, 2>;

namespace {

// The edges of the new chain that leave the one drawn, outwards (1) or inwards (-1), by comparing distances from the
// vanishing point along rays.
std::set<int> edges_beyond(const std::vector<place>& drawn, const std::vector<std::array<int, 2>>& edges,
                           const std::array<place, 4>& f, int side) {
  const auto reach = [](const place& a, const place& b, const place& towards) {
    const double d = towards.x * (b.y - a.y) - towards.y * (b.x - a.x);
    return std::array{(a.x * (b.y - a.y) - a.y * (b.x - a.x)) / d, (a.x * towards.y - a.y * towards.x) / d};
  };
  std::set<int> found;
  for (const auto& e : edges)
    for (int k = 1; k < 40; ++k) {
      const place &a = f[static_cast<std::size_t>(e[0] - 1)], &b = f[static_cast<std::size_t>(e[1] - 1)];
      const place p{a.x + (b.x - a.x) * k / 40, a.y + (b.y - a.y) * k / 40};
      for (std::size_t c = 0; c + 1 < drawn.size(); ++c) {
        const auto [s, u] = reach(drawn[c], drawn[c + 1], p);
        if (s > 0 && u >= 0 && u <= 1 && side * (1 - s) > 1e-6) found.insert(10 * e[0] + e[1]);
      }
    }
  return found;
}

std::set<int> edges_of(int corners) {
  std::set<int> found;
  for (; corners > 9; corners /= 10) found.insert(corners % 100);
  return found;
}

}  // namespace

TEST_CASE("leaving corners: the source's tables hold every edge that leaves a perimeter") {
  test::random r(9);
  std::set<std::pair<int, int>> side_cases, corner_cases;
  for (int trial = 0; trial < 1500; ++trial) {
    std::array<double, 4> angle{};
    for (double& a : angle) a = 0.6 + 1.9 * r.unit();
    std::sort(angle.begin(), angle.end());
    std::array<place, 4> f{};
    for (std::size_t k = 0; k < 4; ++k) {
      const double away = 1 + 2 * r.unit();
      f[k] = {away * std::cos(angle[k]), away * std::sin(angle[k])};
    }
    const leaving_corners side = irg::textbook::leaving_side_corners(f);
    side_cases.insert({side.outer, side.inner});
    const std::vector<std::array<int, 2>> three{{1, 2}, {2, 3}, {3, 4}}, two{{1, 3}, {3, 4}};
    const auto within = [](const std::set<int>& a, int corners) {
      const std::set<int> b = edges_of(corners);
      return std::includes(b.begin(), b.end(), a.begin(), a.end());
    };
    CHECK(within(edges_beyond({f[0], f[3]}, three, f, 1), side.outer));
    CHECK(within(edges_beyond({f[0], f[3]}, three, f, -1), side.inner));
    if (r.integer(0, 1) == 0) std::swap(f[1], f[2]);
    const leaving_corners corner = irg::textbook::leaving_corner_corners(f);
    corner_cases.insert({corner.outer, corner.inner});
    CHECK(within(edges_beyond({f[0], f[1], f[3]}, two, f, 1), corner.outer));
    CHECK(within(edges_beyond({f[0], f[1], f[3]}, two, f, -1), corner.inner));
  }
  CHECK(side_cases.size() == 4);
  CHECK(corner_cases.size() == 6);
}

TEST_CASE("crossing_of_perimeter: outwards, inwards, none; where") {
  using irg::textbook::crossing_of_perimeter;
  using irg::textbook::meeting_with_perimeter;
  constexpr place p1{1, -1}, p2{1, 1};
  CHECK_BOTH(crossing_of_perimeter(p1, p2, place{0.5, 0}, place{2, 0.5}) == perimeter_crossing::outwards);
  CHECK_BOTH(crossing_of_perimeter(p1, p2, place{2, -0.5}, place{0.5, 0.25}) == perimeter_crossing::inwards);
  CHECK_BOTH(crossing_of_perimeter(p1, p2, place{2, 0}, place{3, 1}) == perimeter_crossing::none);
  CHECK_BOTH(meeting_with_perimeter(p1, p2, place{2, -0.5}, place{0.5, 0.25}) == place{1, 0});
  CHECK(std::abs(meeting_with_perimeter(p1, p2, place{0.5, 0}, place{2, 0.5}).y - 1.0 / 6) < 1e-15);
}
