// SPDX-License-Identifier: MIT
#include <irg/geometry/polygon.hpp>

#include <array>
#include <vector>

#include <irg/math/vec.hpp>

#include "support/archetypes.hpp"
#include "support/check_both.hpp"
#include "support/rational.hpp"

namespace {

using P = irg::point<double, 2>;
using I = irg::point<int, 2>;
constexpr std::array<P, 4> course{P{50, 200}, P{150, 350}, P{300, 150}, P{100, 50}};  // GOLDEN 3

TEST_CASE("edge_through: GOLDEN 3, the coefficients of the course's polygon") {
  using E = irg::edge_equation<double>;
  CHECK_BOTH(irg::edge_through(course[0], course[1]) == E{-150, 100, -12500});
  CHECK_BOTH(irg::edge_through(course[1], course[2]) == E{200, 150, -82500});
  CHECK_BOTH(irg::edge_through(course[2], course[3]) == E{100, -200, 0});
  CHECK_BOTH(irg::edge_through(course[3], course[0]) == E{-150, -50, 17500});
  CHECK_BOTH(irg::edge_through(I{3, 4}, I{3, 4}) == irg::edge_equation<int>{0, 0, 0});
}

TEST_CASE("edge_through: any number type") {
  using Q = irg::point<test::rational, 2>;
  CHECK(irg::edge_through(Q{{1, 3}, 0}, Q{0, {1, 2}}) == irg::edge_equation<test::rational>{{-1, 2}, {-1, 3}, {1, 6}});
  using F = irg::point<float, 2>;
  CHECK_BOTH(irg::edge_through(F{0x1p60f, 1}, F{1, 0x1p60f}).c == 0x1p120f);
}

TEST_CASE("polygons: one ring, or any number of them") {
  static_assert(irg::PlanePolygon<std::vector<P>> && irg::PlaneRing<P[3]> && irg::PlanePolygon<std::array<I, 4>>);
  static_assert(irg::PlaneRings<std::vector<std::vector<P>>> && irg::PlaneRings<P[2][3]>);
  static_assert(std::is_same_v<irg::polygon_point<std::vector<std::vector<P>>>, P>);
  static_assert(std::is_same_v<irg::polygon_point<std::array<I, 3>>, I>);
  static_assert(!irg::PlanePolygon<std::vector<irg::point<double, 3>>> && !irg::PlanePolygon<std::vector<int>>);
}

}  // namespace
