// SPDX-License-Identifier: MIT
#include <irg/geometry/plane_by_inversion.hpp>

#include <limits>

#include "geometry/mixed_cases.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

#include <irg/math/mat.hpp>

using irg::hpoint;
using irg::inversion_status;
using irg::plane;
using irg::plane_by_inversion;
using test::rational;

namespace {

using H = hpoint<double, 3>;
using Q = hpoint<rational, 3>;

template <class P, class T>
constexpr bool gives(const P& p, const P& q, const P& r, const T& d, const plane<T>& want) {
  const auto got = plane_by_inversion(p, q, r, d);
  return got.status == inversion_status::ok && got.value == want;
}

}  // namespace

TEST_CASE("plane_by_inversion: the course's values") {
  constexpr Q a{1, 0, 0, 1}, b{0, 2, 0, 1}, c{0, 0, 3, 1};
  CHECK_BOTH(gives(a, b, c, rational(1), {-1, rational(-1, 2), rational(-1, 3), 1}));
  CHECK_BOTH(gives(a, b, c, rational(-6), {6, 3, 2, -6}));
  CHECK_BOTH(gives(H{1, 0, 0, 1}, H{0, 2, 0, 1}, H{0, 0, 3, 1}, -6.0, {6, 3, 2, -6}));
  // z = 4 avoids the origin, so the inversion exists.
  CHECK_BOTH(gives(Q{0, 0, 4, 1}, Q{1, 0, 4, 1}, Q{0, 1, 4, 1}, rational(1), {0, 0, rational(-1, 4), 1}));
}

TEST_CASE("plane_by_inversion: where there is none") {
  CHECK_BOTH(plane_by_inversion(H{1, 0, 1, 1}, H{0, 1, 1, 1}, H{1, 1, 2, 1}).status ==
             inversion_status::through_origin);
  CHECK_BOTH(plane_by_inversion(H{1, 0, 0, 1}, H{2, 0, 0, 1}, H{3, 0, 0, 1}).status == inversion_status::collinear);
  CHECK_BOTH(plane_by_inversion(H{1, 2, 3, 1}, H{2, 4, 6, 2}, H{0, 0, 1, 1}).status == inversion_status::collinear);
  CHECK_BOTH(plane_by_inversion(H{1, 0, 0, 1}, H{0, 2, 0, 1}, H{0, 0, 3, 1}, 0).status == inversion_status::invalid);
  constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
  CHECK_BOTH(plane_by_inversion(H{1, 0, 0, 1}, H{0, 2, 0, 1}, H{0, 0, not_a_number, 1}).status ==
             inversion_status::invalid);
  CHECK_BOTH(plane_by_inversion(H{1, 0, 0, 1}, H{0, 2, 0, 1}, H{0, 0, 3, 1}, not_a_number).status ==
             inversion_status::invalid);
}

TEST_CASE("plane_by_inversion: a subnormal last coefficient") {
  constexpr double least = 0x1p-1074;
  CHECK_BOTH(gives(H{1, 0, 0, 0x1p40}, H{0, 2, 0, 0x1p41}, H{0, 0, 1, 0x1p30}, least,
                   {-0x1p-1034, -0x1p-1034, -0x1p-1044, least}));
}

TEST_CASE("plane_by_inversion: the equations hold in rationals") {
  test::random r(9);
  int planes = 0, wrong = 0;
  for (int i = 0; i < 500; ++i) {
    Q p[3];
    for (Q& q : p)
      for (int k = 0; k < 4; ++k) q[k] = rational(r.integer(-4, 4));
    const auto got = plane_by_inversion(p[0], p[1], p[2], rational(r.integer(1, 5)));
    irg::mat<rational, 4, 4> m;
    for (int row = 0; row < 4; ++row)
      for (int k = 0; k < 4; ++k) m(row, k) = row < 3 ? p[row][k] : rational(k == 3);
    wrong += (got.status == inversion_status::ok) != !(determinant(m) == rational(0));
    if (got.status != inversion_status::ok) continue;
    ++planes;
    for (const Q& q : p) wrong += !(plane_value(got.value, q) == rational(0));
  }
  CHECK(wrong == 0);
  CHECK(planes > 300);
}

#ifdef IRG_HAVE_MPFR

TEST_CASE_TEMPLATE("plane_through, plane_by_inversion: homogeneous numbers of all sizes", T, double, float) {
  using namespace test::mixed;
  sweep(
      named<T>("plane_through, homogeneous, and plane_by_inversion"), 0.501,
      [&](test::random& r, sizes which) {
        auto c = numbers<T, 13>(r, which);
        if (r.integer(0, 3) == 0) c[11] = c[7] = c[3] = 1;
        const irg::hpoint<T, 3> p{c[0], c[1], c[2], c[3]}, q{c[4], c[5], c[6], c[7]}, s{c[8], c[9], c[10], c[11]};
        const auto e = rationals(c);
        const auto want =
            plane_coefficients({e[0], e[1], e[2], e[3]}, {e[4], e[5], e[6], e[7]}, {e[8], e[9], e[10], e[11]});
        const auto inverted = plane_by_inversion(p, q, s, c[12]);
        using irg::inversion_status;
        const bool collinear = want[0].sign() == 0 && want[1].sign() == 0 && want[2].sign() == 0;
        const auto outcome = c[12] == 0            ? inversion_status::invalid
                             : want[3].sign() != 0 ? inversion_status::ok
                             : collinear           ? inversion_status::collinear
                                                   : inversion_status::through_origin;
        if (inverted.status != outcome) return wrong;
        double worst = off_from_plane<T>(plane_through(p, q, s), want);
        if (outcome != inversion_status::ok) return worst;
        const T got[3] = {inverted.value.a, inverted.value.b, inverted.value.c};
        for (std::size_t k = 0; k < 3; ++k) worst = std::fmax(worst, quotient_error(got[k], want[k] * e[12], want[3]));
        return inverted.value.d == c[12] ? worst : wrong;
      },
      3000);
}

#endif
