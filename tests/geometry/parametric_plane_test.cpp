// SPDX-License-Identifier: MIT
#include <irg/geometry/parametric_plane.hpp>

#include <limits>

#include "geometry/mixed_cases.hpp"
#include "support/check_both.hpp"
#include "support/exact.hpp"
#include "support/rational.hpp"

using irg::implicit_plane_of;
using irg::in_triangle;
using irg::mat;
using irg::parameters_of;
using irg::parametric_plane;
using irg::parametric_plane_of;
using irg::parametric_plane_through;
using irg::plane;
using irg::plane_parameters;
using irg::point;
using test::rational;

namespace {

using P = point<double, 3>;
using Q = point<rational, 3>;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr rational third(1, 3), half(1, 2);

}  // namespace

TEST_CASE("parametric_plane: the course's values, the characteristic matrix K") {
  constexpr auto p = *parametric_plane_through(Q{1, 0, 0}, Q{0, 2, 0}, Q{0, 0, 3});
  CHECK_BOTH(characteristic_matrix(p) == mat<rational, 3, 4>{{{-1, 2, 0, 0}, {-1, 0, 3, 0}, {1, 0, 0, 1}}});
  CHECK_BOTH(point_at(p, 0, 0) == Q{1, 0, 0});
  CHECK_BOTH(point_at(p, 1, 0) == Q{0, 2, 0});
  CHECK_BOTH(point_at(p, 0, 1) == Q{0, 0, 3});
  CHECK_BOTH(point_at(p, third, third) == Q{third, rational(2, 3), 1});
  CHECK_BOTH(point_at(p, half, half) == Q{0, 1, rational(3, 2)});
  CHECK_BOTH(point_at(p, 1, 1) == Q{-1, 2, 3});
  // [u w 1] K
  CHECK_BOTH(mat<rational, 1, 3>{{{third, third, 1}}} * characteristic_matrix(p) ==
             mat<rational, 1, 4>{{{third, rational(2, 3), 1, 1}}});
}

TEST_CASE("parametric_plane: to the implicit form and back") {
  constexpr auto p = *parametric_plane_through(Q{1, 0, 0}, Q{0, 2, 0}, Q{0, 0, 3});
  CHECK_BOTH(implicit_plane_of(p) == plane<rational>{6, 3, 2, -6});
  CHECK_BOTH(implicit_plane_of(*parametric_plane_of(plane<rational>{6, 3, 2, -6})) == plane<rational>{36, 18, 12, -36});
  CHECK_BOTH(implicit_plane_of(*parametric_plane_of(plane<rational>{1, 2, -4, 3})) == plane<rational>{4, 8, -16, 12});
  CHECK_BOTH(implicit_plane_of(*parametric_plane_of(plane<double>{1, -5, 2, 3})) == plane<double>{5, -25, 10, 15});
  CHECK_BOTH(!parametric_plane_of(plane<double>{0, 0, 0, 3}));
  CHECK_BOTH(!parametric_plane_of(plane<double>{0, not_a_number, 1, 3}));
}

TEST_CASE("parametric_plane: parameters of points, and the triangle") {
  constexpr auto p = *parametric_plane_through(Q{1, 0, 0}, Q{0, 2, 0}, Q{0, 0, 3});
  CHECK_BOTH(parameters_of(p, Q{third, rational(2, 3), 1}) == plane_parameters<rational>{third, third});
  CHECK_BOTH(parameters_of(p, Q{third + 6, rational(2, 3) + 3, 3}) ==
             plane_parameters<rational>{third, third});  // above
  CHECK_BOTH(!parameters_of(parametric_plane<double>{{1, 1, 1}, {2, 2, 2}, {0, 0, 0}}, P{1, 2, 3}));
  CHECK_BOTH(!parameters_of(parametric_plane<double>{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}, P{1, not_a_number, 3}));
  CHECK_BOTH(in_triangle(plane_parameters<double>{0, 0}));
  CHECK_BOTH(in_triangle(plane_parameters<double>{0.5, 0.5}));
  CHECK_BOTH(!in_triangle(plane_parameters<double>{0.5, 0.5 + 0x1p-53}));
  CHECK_BOTH(!in_triangle(plane_parameters<double>{1, 5e-324}));
  CHECK_BOTH(!in_triangle(plane_parameters<double>{-5e-324, 0.5}));
  CHECK_BOTH(!in_triangle(plane_parameters<double>{not_a_number, 0.5}));
  CHECK_BOTH(in_triangle(plane_parameters<rational>{third, rational(2, 3)}));
}

#ifdef IRG_HAVE_MPFR
TEST_CASE("parametric_plane: parameters are half an ulp from the exact ones") {
  using E = test::exact;
  test::random r(21);
  double worst = 0;
  int wrong = 0, some = 0;
  for (const test::spread kind : test::all_spreads)
    for (int i = 0; i < test::trials(150); ++i) {
      double c[12];
      E e[12];
      for (int k = 0; k < 12; ++k) c[k] = test::any_coordinate<double>(r, kind), e[k] = E(c[k]);
      const parametric_plane<double> p{{c[0], c[1], c[2]}, {c[3], c[4], c[5]}, {c[6], c[7], c[8]}};
      const auto got = parameters_of(p, P{c[9], c[10], c[11]});
      // Normal equations of the least squares: unlike the cross products of the library.
      E aa = 0, ab = 0, bb = 0, aw = 0, bw = 0;
      for (int k = 0; k < 3; ++k) {
        const E w = e[9 + k] - e[6 + k];
        aa = aa + e[k] * e[k], ab = ab + e[k] * e[3 + k], bb = bb + e[3 + k] * e[3 + k];
        aw = aw + e[k] * w, bw = bw + e[3 + k] * w;
      }
      const E n = aa * bb - ab * ab;
      wrong += got.has_value() != (n.sign() != 0);
      if (!got || n.sign() == 0) continue;
      ++some;
      worst = std::fmax(worst, test::error_in_ulp(got->s1, (aw * bb - bw * ab) / n));
      worst = std::fmax(worst, test::error_in_ulp(got->s2, (bw * aa - aw * ab) / n));
    }
  MESSAGE(some, " points, worst ", worst, " ulp");
  CHECK(wrong == 0);
  CHECK(worst <= 0.501);
  CHECK(some > 500);
}

TEST_CASE_TEMPLATE("implicit_plane_of, parameters_of: numbers of all sizes", T, double, float) {
  using namespace test::mixed;
  sweep(
      named<T>("implicit_plane_of and parameters_of"), 0.501,
      [&](test::random& r, sizes which) {
        const auto p = points<T, 3, 4>(r, which);
        const irg::parametric_plane<T> given{to_vec(p[0]), to_vec(p[1]), p[2]};
        const auto u = exactly(p[0]), v = exactly(p[1]), o = exactly(p[2]), w = exactly(p[3]) - o;
        const auto n = minors(u, v);
        const double worst = off_from_plane<T>(implicit_plane_of(given), {n[0], n[1], n[2], -determinant(u, v, o)});
        const auto at = parameters_of(given, p[3]);
        const E whole = gram(u, v);
        if (at.has_value() != (whole.sign() != 0)) return wrong;
        if (!at) return worst;
        const double first = quotient_error(at->s1, dot(u, w) * dot(v, v) - dot(v, w) * dot(u, v), whole);
        const double second = quotient_error(at->s2, dot(v, w) * dot(u, u) - dot(u, w) * dot(u, v), whole);
        return std::fmax(worst, std::fmax(first, second));
      },
      1500);
}
#endif
