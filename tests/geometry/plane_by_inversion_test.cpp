// SPDX-License-Identifier: MIT
#include <irg/geometry/plane_by_inversion.hpp>

#include <limits>

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
