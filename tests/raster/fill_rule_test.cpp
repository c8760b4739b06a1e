// SPDX-License-Identifier: MIT
#include <irg/raster/subpixel.hpp>

#include <array>
#include <vector>

#include "support/check_both.hpp"
#include "support/own_types.hpp"

namespace {

using own_point = own::plain2<float>;
using pixel_point = own::plain_cell;

TEST_CASE("fill_rule: the two rules are told apart") {
  CHECK_BOTH(irg::fill_rule::even_odd != irg::fill_rule::non_zero);
}

TEST_CASE("FillableRing: snapped positions and floating points in the plane, nothing else") {
  CHECK_BOTH(irg::FillableRing<std::vector<irg::subpixel>>);
  CHECK_BOTH(irg::FillableRing<irg::subpixel[4]>);
  CHECK_BOTH(irg::FillableRing<std::array<irg::point<float, 2>, 3>>);
  CHECK_BOTH(irg::FillableRing<std::vector<own_point>>);
  CHECK_BOTH(irg::FillableRing<std::vector<std::array<double, 2>>>);
  CHECK_BOTH(!irg::FillableRing<std::vector<irg::point<float, 3>>>);
  CHECK_BOTH(!irg::FillableRing<std::vector<irg::vec<float, 2>>>);  // a displacement is no position
  CHECK_BOTH(!irg::FillableRing<std::vector<pixel_point>>);  // whole pixels, or 1/256? One has to say
  CHECK_BOTH(!irg::FillableRing<std::vector<float>>);
}

TEST_CASE("FillablePolygon: one ring or a container of rings") {
  CHECK_BOTH(irg::FillablePolygon<std::vector<irg::subpixel>>);
  CHECK_BOTH(irg::FillablePolygon<std::vector<std::vector<irg::subpixel>>>);
  CHECK_BOTH(irg::FillablePolygon<std::array<std::array<own_point, 3>, 2>>);
  CHECK_BOTH(irg::FillablePolygon<irg::subpixel[2][3]>);
  CHECK_BOTH(!irg::FillablePolygon<std::vector<std::vector<std::vector<irg::subpixel>>>>);
}

}  // namespace
