// SPDX-License-Identifier: MIT
#include <irg/hidden/grid_covering_order.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <vector>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

// Facets in covering order over the places 0..n and 0..m, as "11 12 ".
std::string order(int n, int m, double x, double z) {
  std::vector<double> xs, zs;
  for (int i = 0; i <= n; ++i) xs.push_back(i);
  for (int j = 0; j <= m; ++j) zs.push_back(j);
  std::string text;
  irg::visit_in_covering_order(irg::covering_loops(xs, zs, x, z), [&](const irg::grid_facet& f) {
    text += std::to_string(f.i) + std::to_string(f.j) + " ";
  });
  return text;
}

constexpr std::array<double, 4> three{0, 1, 2, 3};
constexpr std::array<double, 3> two{0, 1, 2};

constexpr bool loops_are(const irg::grid_covering& c, std::array<int, 6> v) {
  return c.k == v[0] && c.l == v[1] && c.first_i == v[2] && c.last_i == v[3] && c.first_j == v[4] && c.last_j == v[5];
}

}  // namespace

TEST_CASE("visit_in_covering_order: the source's orders") {
  CHECK(order(3, 3, 1.5, 1.5) == "22 23 32 33 12 13 21 31 11 ");
  CHECK(order(4, 3, 2.5, 1.5) == "32 33 42 43 22 23 12 13 31 41 21 11 ");
  CHECK(order(2, 2, 0.5, 0.5) == "11 12 21 22 ");
  CHECK(order(3, 2, 1.5, 5) == "22 21 32 31 12 11 ");
  CHECK(order(3, 2, 1.5, -2) == "21 22 31 32 11 12 ");
  CHECK(order(2, 3, -1, 1.5) == "12 13 22 23 11 21 ");
  CHECK(order(2, 2, -1, -1) == "11 12 21 22 ");
  CHECK(order(3, 2, 9, 9) == "32 31 22 21 12 11 ");
  CHECK(order(2, 2, -1, 4) == "12 11 22 21 ");
  CHECK_BOTH(irg::grid_facet{} == irg::grid_facet{0, 0});
  CHECK_BOTH(loops_are({}, {0, 0, 1, 0, 1, 0}));
  CHECK(order(4, 4, 1.5, 1.75) == "22 23 24 32 33 34 42 43 44 12 13 14 21 31 41 11 ");
}

TEST_CASE("covering_loops: where the eye stands, on grid lines the smaller one") {
  const std::vector<double> xs(three.begin(), three.end()), zs(two.begin(), two.end());
  CHECK(loops_are(irg::covering_loops(xs, zs, 1.5, 5), {2, 3, 2, 1, 3, 2}));
  CHECK(loops_are(irg::covering_loops(xs, zs, 1.5, -2), {2, 0, 2, 1, 1, -1}));
  CHECK(loops_are(irg::covering_loops(xs, zs, 9, 9), {4, 3, 4, 3, 3, 2}));
  CHECK(loops_are(irg::covering_loops(xs, zs, 0, 2), {0, 2, 1, -1, 2, 1}));
  CHECK(loops_are(irg::covering_loops(xs, zs, 1, 1), {1, 1, 1, 0, 1, 0}));
  constexpr double infinite = std::numeric_limits<double>::infinity();
  CHECK_BOTH(loops_are(irg::covering_loops(three, three, -infinite, infinite), {0, 4, 1, -1, 4, 3}));
  CHECK_BOTH(irg::grid_interval(three, 2.0) == 2);
  CHECK_BOTH(irg::grid_interval(three, 2.0000000000000004) == 3);
}

TEST_CASE("grid_view_from: the border belongs to the front") {
  using enum irg::grid_view;
  CHECK_BOTH(irg::grid_view_from(three, three, 0, 1, 3) == front);
  CHECK_BOTH(irg::grid_view_from(three, three, 1, 0, 1) == front);
  CHECK_BOTH(irg::grid_view_from(three, three, -1, 1, 3) == side);
  CHECK_BOTH(irg::grid_view_from(three, three, 1, -1, 3.5) == side);
  CHECK_BOTH(irg::grid_view_from(three, three, -1, 1, 4) == corner);
  CHECK_BOTH(irg::grid_view_from(three, three, -1, 0, 1) == horizontal);
  CHECK_BOTH(irg::grid_view_from(three, three, -1, -0.0, 9) == horizontal);
}

TEST_CASE("visit_in_covering_order: every sight plane meets the facets in their order") {
  test::random r(4);
  for (int trial = 0; trial < 200; ++trial) {
    const auto n = static_cast<int>(r.integer(1, 6)), m = static_cast<int>(r.integer(1, 6));
    std::vector<int> xs, zs;
    const auto places = [&](std::vector<int>& v, int count) {
      int at = static_cast<int>(r.integer(-50, -10));
      for (int k = 0; k <= count; ++k, at += static_cast<int>(r.integer(1, 20))) v.push_back(at);
    };
    places(xs, n);
    places(zs, m);
    const auto ex = static_cast<int>(r.integer(-70, 90)), ez = static_cast<int>(r.integer(-70, 90));
    std::vector<irg::grid_facet> facets;
    irg::visit_in_covering_order(irg::covering_loops(xs, zs, ex, ez),
                                 [&](const irg::grid_facet& f) { facets.push_back(f); });
    REQUIRE(facets.size() == static_cast<std::size_t>(n * m));
    for (int ray = 0; ray < 30; ++ray) {
      const auto dx = static_cast<double>(r.integer(-1000, 1000)) + 0.5;
      const auto dz = static_cast<double>(r.integer(-1000, 1000)) + 0.25;
      double reached = 0;
      bool rises = true;
      for (const irg::grid_facet& f : facets) {  // where the ray enters and leaves the facet's cell
        const auto i = static_cast<std::size_t>(f.i), j = static_cast<std::size_t>(f.j);
        const double a = (xs[i - 1] - ex) / dx, b = (xs[i] - ex) / dx, c = (zs[j - 1] - ez) / dz, d = (zs[j] - ez) / dz;
        const double enters = std::max({0.0, std::min(a, b), std::min(c, d)});
        const double leaves = std::min(std::max(a, b), std::max(c, d));
        if (!(enters + 1e-9 < leaves)) continue;
        rises = rises && enters >= reached - 1e-9;
        reached = enters;
      }
      CHECK(rises);
    }
  }
}
