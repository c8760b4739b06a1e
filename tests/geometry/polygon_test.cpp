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

TEST_CASE("polygons: one ring, or any number of them") {
  static_assert(irg::PlanePolygon<std::vector<P>> && irg::PlaneRing<P[3]> && irg::PlanePolygon<std::array<I, 4>>);
  static_assert(irg::PlaneRings<std::vector<std::vector<P>>> && irg::PlaneRings<P[2][3]>);
  static_assert(std::is_same_v<irg::polygon_point<std::vector<std::vector<P>>>, P>);
  static_assert(std::is_same_v<irg::polygon_point<std::array<I, 3>>, I>);
  static_assert(!irg::PlanePolygon<std::vector<irg::point<double, 3>>> && !irg::PlanePolygon<std::vector<int>>);
}

}  // namespace
