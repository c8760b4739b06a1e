// SPDX-License-Identifier: MIT
#include <irg/hidden/textbook/grid_surface.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::textbook::facet_corner;
using irg::textbook::leaving_corners;
using irg::textbook::perimeter_crossing;
using place = irg::point<double, 2>;

TEST_CASE("pseudo_angle: the source's values, rising from -45 degrees to 315") {
  using irg::textbook::pseudo_angle;
  CHECK_BOTH(pseudo_angle(1.0, 0.0) == 0);
  CHECK_BOTH(pseudo_angle(2.0, 1.0) == 0.5);
  CHECK_BOTH(pseudo_angle(1.0, 1.0) == 1);
  CHECK_BOTH(pseudo_angle(1.0, 2.0) == 1.5);
  CHECK_BOTH(pseudo_angle(0.0, 1.0) == 2);
  CHECK_BOTH(pseudo_angle(-1.0, 2.0) == 2.5);
  CHECK_BOTH(pseudo_angle(-1.0, 1.0) == 3);
  CHECK_BOTH(pseudo_angle(-2.0, 1.0) == 3.5);
  CHECK_BOTH(pseudo_angle(-1.0, 0.0) == 4);
  CHECK_BOTH(pseudo_angle(-2.0, -1.0) == 4.5);
  CHECK_BOTH(pseudo_angle(-1.0, -1.0) == 5);
  CHECK_BOTH(pseudo_angle(-1.0, -2.0) == 5.5);
  CHECK_BOTH(pseudo_angle(0.0, -1.0) == 6);
  CHECK_BOTH(pseudo_angle(1.0, -2.0) == 6.5);
  CHECK_BOTH(pseudo_angle(1.0, -1.0) == -1);
  CHECK_BOTH(pseudo_angle(2.0, -1.0) == -0.5);
  CHECK(pseudo_angle(0.0, 0.0) != pseudo_angle(0.0, 0.0));
  double last = -2;
  for (int degrees = -45; degrees < 315; ++degrees) {
    const double a = degrees * 3.14159265358979 / 180, now = pseudo_angle(std::cos(a), std::sin(a));
    if (degrees > -45) CHECK(now > last);
    last = now;
  }
}

TEST_CASE("angle_precedes, advances_perimeter: cyclic; at equal angles the facet goes on") {
  using irg::textbook::angle_precedes;
  CHECK_BOTH(angle_precedes(6.0, 0.0));
  CHECK_BOTH(!angle_precedes(0.0, 6.0));
  CHECK_BOTH(!angle_precedes(3.0, 3.0));
  CHECK_BOTH(!angle_precedes(-1.0, 6.5));
  CHECK_BOTH(angle_precedes(6.5, -1.0));
  CHECK_BOTH(irg::textbook::advances_perimeter(1.0, 1.5));
  CHECK_BOTH(!irg::textbook::advances_perimeter(1.5, 1.5));
}

TEST_CASE("facet_corner_order: the four positions of the source, and the four that it leaves out") {
  using irg::textbook::facet_corner_order;
  using corners = std::array<facet_corner, 4>;
  CHECK_BOTH(facet_corner_order(2, 4, 2, 2) == corners{{{1, 0}, {1, 1}, {0, 1}, {0, 0}}});
  CHECK_BOTH(facet_corner_order(2, 0, 2, 2) == corners{{{0, 1}, {0, 0}, {1, 0}, {1, 1}}});
  CHECK_BOTH(facet_corner_order(4, 2, 2, 2) == corners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  CHECK_BOTH(facet_corner_order(0, 2, 2, 2) == corners{{{1, 1}, {0, 1}, {0, 0}, {1, 0}}});
  CHECK_BOTH(facet_corner_order(4, 4, 2, 2) == corners{{{1, 0}, {0, 0}, {1, 1}, {0, 1}}});
  CHECK_BOTH(facet_corner_order(0, 4, 2, 2) == corners{{{1, 1}, {1, 0}, {0, 1}, {0, 0}}});
  CHECK_BOTH(facet_corner_order(0, 0, 2, 2) == corners{{{0, 1}, {1, 1}, {0, 0}, {1, 0}}});
  CHECK_BOTH(facet_corner_order(4, 0, 2, 2) == corners{{{0, 0}, {0, 1}, {1, 0}, {1, 1}}});
}

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

namespace {

// What a test's transform gives: the vertex's own numbers.
struct named_vertex {
  int i = -1, j = -1;
  friend bool operator==(const named_vertex&, const named_vertex&) = default;
};

}  // namespace

static_assert([] {
  // A grid of 2 x 2 facets from a corner: 9 vertices, for which 16 are transformed without memory.
  const std::array<double, 3> places{0, 1, 2};
  const auto loops = irg::covering_loops(places, places, -1, -1);
  const auto number = [](int i, int j) { return 10 * i + j; };
  const auto nothing = [](const irg::grid_facet&, const std::array<int, 4>&) {};
  return irg::textbook::visit_transformed_facets(loops, number, nothing).transforms == 9 &&
         irg::textbook::visit_transformed_facets(loops, number, nothing, irg::textbook::vertex_memory::none)
                 .transforms == 16;
}());

TEST_CASE("visit_transformed_facets: the covering order, right corners, no vertex three times") {
  using irg::textbook::vertex_memory;
  test::random r(12);
  int front = 0, corner = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const int n = static_cast<int>(r.integer(1, 7)), m = static_cast<int>(r.integer(1, 7));
    std::vector<double> xs, zs;
    for (int i = 0; i <= n; ++i) xs.push_back(i);
    for (int j = 0; j <= m; ++j) zs.push_back(j);
    // Eyes on grid lines, between them and on all sides.
    const double x = static_cast<double>(r.integer(-2, 2 * n + 2)) / 2;
    const double z = static_cast<double>(r.integer(-2, 2 * m + 2)) / 2;
    const irg::grid_covering loops = irg::covering_loops(xs, zs, x, z);
    for (const vertex_memory memory : {vertex_memory::none, vertex_memory::row}) {
      std::vector<int> asked(static_cast<std::size_t>((n + 1) * (m + 1)), 0);
      std::vector<irg::grid_facet> order, visited;
      int wrong = 0;
      const auto transform = [&](int i, int j) {
        ++asked[static_cast<std::size_t>(i * (m + 1) + j)];
        return named_vertex{i, j};
      };
      const auto counts = irg::textbook::visit_transformed_facets(
          loops, transform,
          [&](const irg::grid_facet& f, const std::array<named_vertex, 4>& c) {
            visited.push_back(f);
            for (int k = 0; k < 4; ++k)
              if (!(c[static_cast<std::size_t>(k)] == named_vertex{f.i - 1 + k / 2, f.j - 1 + k % 2})) ++wrong;
          },
          memory);
      irg::visit_in_covering_order(loops, [&](const irg::grid_facet& f) { order.push_back(f); });
      CHECK(wrong == 0);
      CHECK(visited == order);
      CHECK(counts.facets == n * m);
      int most = 0, least = 9, sum = 0;
      for (const int a : asked) most = std::max(most, a), least = std::min(least, a), sum += a;
      CHECK(counts.transforms == sum);
      CHECK(least >= 1);
      if (memory == vertex_memory::none) {
        CHECK(sum == 4 * n * m);
        continue;
      }
      const int over = loops.first_i <= n && loops.last_i >= 1 ? m : 0;  // beside the vertex under the eye
      const int across = loops.first_j <= m && loops.last_j >= 1 ? n : 0;
      CHECK(sum == (n + 1) * (m + 1) + over + across);
      CHECK(most <= 2);
      if (over == 0 && across == 0) {
        CHECK(most == 1);
        ++corner;
      }
      if (over > 0 && across > 0) ++front;
    }
  }
  CHECK(front > 50);
  CHECK(corner > 50);
}

TEST_CASE("visit_transformed_facets: the counts that the page shows") {
  std::vector<double> places;
  for (int i = 0; i <= 100; ++i) places.push_back(i);
  const auto transforms = [&](double x, double z, irg::textbook::vertex_memory memory) {
    const auto nothing = [](const irg::grid_facet&, const auto&) {};
    return irg::textbook::visit_transformed_facets(
               irg::covering_loops(places, places, x, z), [](int i, int j) { return named_vertex{i, j}; }, nothing,
               memory)
        .transforms;
  };
  using irg::textbook::vertex_memory;
  for (const double x : {-5.0, 50.5})
    for (const double z : {-5.0, 50.5}) CHECK(transforms(x, z, vertex_memory::none) == 40000);
  CHECK(transforms(-5, 105, vertex_memory::row) == 10201);
  CHECK(transforms(-5, 50.5, vertex_memory::row) == 10301);
  CHECK(transforms(30.25, 105, vertex_memory::row) == 10301);
  CHECK(transforms(30.25, 50.5, vertex_memory::row) == 10401);
}
