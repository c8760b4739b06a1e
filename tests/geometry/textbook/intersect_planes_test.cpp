// SPDX-License-Identifier: MIT
#include <irg/geometry/textbook/intersect_planes.hpp>

#include <irg/geometry/textbook/planes.hpp>

#include "geometry/mixed_cases.hpp"
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

#ifdef IRG_HAVE_MPFR

TEST_CASE_TEMPLATE("textbook::intersect_planes: numbers of all sizes", T, double, float) {
  using namespace test::mixed;
  sweep(
      named<T>("textbook::intersect_planes"), 0.501,
      [](test::random& r, sizes which) {
        const auto p = points<T, 3, 6>(r, which);
        place<3> e[6];
        for (std::size_t i = 0; i < 6; ++i) e[i] = exactly(p[i]);
        const irg::parametric_plane<T> one{to_vec(p[0]), to_vec(p[1]), p[2]}, two{to_vec(p[3]), to_vec(p[4]), p[5]};
        const auto got = irg::textbook::intersect_planes(one, two);
        const auto n = minors(e[0], e[1]);
        const bool exist = !all_zero(n) && !all_zero(minors(e[3], e[4]));
        const bool do_cross = exist && !(dot(n, e[3]).sign() == 0 && dot(n, e[4]).sign() == 0);
        if ((got.relation == irg::flat_relation::crossing) != do_cross) return wrong;
        if (!do_cross) return 0.0;
        const bool hold_s4 = dot(n, e[3]).sign() != 0;
        const place<3>&along = e[hold_s4 ? 3 : 4], &held = e[hold_s4 ? 4 : 3];
        const E whole = dot(n, along);
        double worst = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          const E zero = e[5][k] * whole + along[k] * dot(n, e[2] - e[5]);
          const E one_held = zero + held[k] * whole - along[k] * dot(n, held);
          worst = std::fmax(worst, quotient_error(got.at_zero[static_cast<int>(k)], zero, whole));
          worst = std::fmax(worst, quotient_error(got.at_one[static_cast<int>(k)], one_held, whole));
        }
        return worst;
      },
      1000);
}

#endif
