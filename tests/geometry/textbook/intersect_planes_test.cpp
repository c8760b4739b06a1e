// SPDX-License-Identifier: MIT
#include <irg/geometry/textbook/intersect_planes.hpp>

#include <irg/geometry/textbook/planes.hpp>

#include "support/check_both.hpp"
#include "support/rational.hpp"

using irg::flat_relation;
using irg::point;
using test::rational;

namespace {

using Q = point<rational, 3>;
constexpr auto crossing = flat_relation::crossing, parallel = flat_relation::parallel,
               coincident = flat_relation::coincident;
using held = irg::textbook::planes_meeting<rational>::parameter;
constexpr auto ground = *irg::textbook::parametric_plane_at_middle(Q{1, 0, 0}, Q{0, 0, 0}, Q{0, 1, 0});
constexpr bool held_at(const Q& a, const Q& b, const Q& c, held which, const Q& at_zero, const Q& at_one,
                       irg::textbook::held_parameter order = irg::textbook::held_parameter::s4_then_s3) {
  const auto m = irg::textbook::intersect_planes(ground, *irg::textbook::parametric_plane_at_middle(a, b, c), order);
  return m.relation == crossing && m.held == which && m.at_zero == at_zero && m.at_one == at_one;
}
constexpr flat_relation held_at(const Q& a, const Q& b, const Q& c) {
  return irg::textbook::intersect_planes(ground, *irg::textbook::parametric_plane_at_middle(a, b, c)).relation;
}

}  // namespace

TEST_CASE("textbook::intersect_planes: Hank's values") {
  CHECK_BOTH(held_at({1, 1, 0}, {1, 0, 0}, {1, 0, 1}, held::s3, {1, 0, 0}, {1, 1, 0}));
  CHECK_BOTH(held_at({3, 0, 0}, {0, 3, 0}, {0, 0, 3}, held::s3, {0, 3, 0}, {3, 0, 0}));
  CHECK_BOTH(held_at({1, 0, 1}, {1, 0, 0}, {1, 1, 0}, held::s4, {1, 0, 0}, {1, 1, 0}));
  CHECK_BOTH(held_at({1, 0, 1}, {0, 0, 1}, {0, 1, 1}) == parallel);
  CHECK_BOTH(held_at({5, 5, 0}, {1, 2, 0}, {7, 1, 0}) == coincident);
  // The text's order: another pair of points, the same line.
  CHECK_BOTH(held_at({1, 1, 1}, {1, 0, 0}, {1, 0, 1}, held::s4, {1, 0, 0}, {1, -1, 0}));
  CHECK_BOTH(held_at({1, 1, 1}, {1, 0, 0}, {1, 0, 1}, held::s3, {1, 0, 0}, {1, 1, 0},
                     irg::textbook::held_parameter::s3_then_s4));
  CHECK_BOTH(irg::textbook::intersect_planes(irg::parametric_plane<double>{{1, 1, 1}, {2, 2, 2}, {0, 0, 0}},
                                             irg::parametric_plane<double>{{1, 1, 1}, {2, 2, 0}, {0, 0, 0}})
                 .relation == flat_relation::none);
}
