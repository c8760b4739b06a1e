// SPDX-License-Identifier: MIT
#include <irg/geometry/textbook/parametric_plane.hpp>

#include <limits>

#include "support/check_both.hpp"

using irg::mat;
using irg::parametric_plane;

namespace {

using P = irg::point<double, 3>;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("textbook::parametric_plane_at_middle: Hank's values, the middle point is the origin") {
  constexpr auto p = *irg::textbook::parametric_plane_at_middle(P{1, 0, 0}, P{0, 0, 0}, P{0, 1, 0});
  CHECK_BOTH(p == parametric_plane<double>{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}});
  CHECK_BOTH(columns_of(*irg::textbook::parametric_plane_at_middle(P{1, 2, 3}, P{4, 0, 0}, P{7, 8, 9})) ==
             mat<double, 3, 3>{{{-3, 3, 4}, {2, 8, 0}, {3, 9, 0}}});
  // Collinear points are no plane; the source lets them pass.
  CHECK_BOTH(!irg::textbook::parametric_plane_at_middle(P{0, 0, 0}, P{1, 1, 1}, P{2, 2, 2}));
  CHECK_BOTH(irg::textbook::parametric_plane_as_printed(P{0, 0, 0}, P{1, 1, 1}, P{2, 2, 2}) ==
             parametric_plane<double>{{-1, -1, -1}, {1, 1, 1}, {1, 1, 1}});
  CHECK_BOTH(!irg::textbook::parametric_plane_as_printed(P{0, 0, 0}, P{1, 1, 1}, P{0, 0, 0}));
  CHECK_BOTH(!implicit_plane_of(*irg::textbook::parametric_plane_as_printed(P{0, 0, 0}, P{1, 1, 1}, P{2, 2, 2})));
  // Nearly collinear is not collinear.
  CHECK_BOTH(irg::textbook::parametric_plane_at_middle(P{0, 0, 0}, P{1, 1, 1}, P{2, 2, 2 + 0x1p-51}).has_value());
  CHECK_BOTH(!irg::textbook::parametric_plane_at_middle(P{0, 0, not_a_number}, P{1, 1, 1}, P{2, 2, 5}));
}
