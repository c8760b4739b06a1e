// SPDX-License-Identifier: MIT
#include <irg/geometry/textbook/planes.hpp>
#include <irg/geometry/textbook/intersect_plane_line.hpp>
#include <irg/geometry/intersect_plane_line.hpp>

#include <array>
#include <limits>

#include "geometry/mixed_cases.hpp"
#include "support/check_both.hpp"
#include "support/exact.hpp"
#include "support/rational.hpp"

using irg::flat_relation;
using irg::intersect_plane_line;
using irg::parametric_line;
using irg::parametric_plane;
using irg::plane;
using irg::point;
using test::rational;

namespace {

using P = point<double, 3>;
using Q = point<rational, 3>;
constexpr auto none = flat_relation::none, crossing = flat_relation::crossing, parallel = flat_relation::parallel,
               contained = flat_relation::coincident;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double huge = (std::numeric_limits<double>::max)();

// The course's values.
constexpr plane<rational> golden{6, 3, 2, -6};
constexpr auto at_golden(const Q& a, const Q& b) { return intersect_plane_line(golden, a, b); }
constexpr Q common{rational(6, 11), rational(6, 11), rational(6, 11)};

}  // namespace

TEST_CASE("intersect_plane_line: the course's values") {
  CHECK_BOTH(at_golden({0, 0, 0}, {1, 1, 1}).t == rational(6, 11));
  CHECK_BOTH(at_golden({0, 0, 0}, {1, 1, 1}).at == common);
  CHECK_BOTH(at_golden({0, 0, 0}, {6, 6, 6}).t == rational(1, 11));
  CHECK_BOTH(at_golden({0, 0, 0}, {6, 6, 6}).at == common);
  CHECK_BOTH(at_golden({2, 0, 0}, {0, 4, 0}).relation == parallel);
  CHECK_BOTH(at_golden({1, 0, 0}, {0, 2, 0}).relation == contained);
  CHECK_BOTH(at_golden({0, 0, 0}, {1, -2, 0}).relation == parallel);
  CHECK_BOTH(at_golden({0, 0, 10}, {0, 0, 9}).t == rational(7));
  CHECK_BOTH(at_golden({0, 0, 10}, {0, 0, 9}).at == Q{0, 0, 3});
  CHECK_BOTH(irg::textbook::intersect_plane_line(golden, Q{0, 0, 0}, Q{1, 1, 1}) == rational(6, 11));
  CHECK_BOTH(!irg::textbook::intersect_plane_line(golden, Q{2, 0, 0}, Q{0, 4, 0}));
  CHECK_BOTH(intersect_plane_line(plane<double>{6, 3, 2, -6}, P{0, 0, 10}, P{0, 0, 9}).at == P{0, 0, 3});
  CHECK_BOTH(intersect_plane_line(P{1, 0, 0}, P{0, 2, 0}, P{0, 0, 3}, P{0, 0, 10}, P{0, 0, 9}).at == P{0, 0, 3});
}

TEST_CASE("intersect_plane_line: Hank's values, s1, s2 and t") {
  constexpr auto p = *irg::textbook::parametric_plane_at_middle(P{1, 0, 0}, P{0, 0, 0}, P{0, 1, 0});
  constexpr auto line = [](const P& a, const P& b) constexpr { return *irg::parametric_line_through(a, b); };
  constexpr auto is = [=](const P& a, const P& b, double s1, double s2, double t, const P& at) constexpr {
    const auto m = intersect_plane_line(p, line(a, b));
    return m.relation == crossing && m.s1 == s1 && m.s2 == s2 && m.t == t && m.at == at;
  };
  CHECK_BOTH(is(P{0.25, 0.5, 1}, P{0.25, 0.5, -1}, 0.25, 0.5, 0.5, P{0.25, 0.5, 0}));
  CHECK_BOTH(is(P{0, 0, 2}, P{2, 4, 1}, 4, 8, 2, P{4, 8, 0}));
  CHECK_BOTH(intersect_plane_line(p, line(P{0, 0, 1}, P{1, 0, 1})).relation == parallel);
  CHECK_BOTH(intersect_plane_line(p, line(P{0, 0, 0}, P{1, 1, 0})).relation == contained);
}

TEST_CASE("intersect_plane_line: bad input and the ends of the range") {
  constexpr plane<double> xy{0, 0, 1, 0};
  CHECK_BOTH(intersect_plane_line(plane<double>{0, 0, 0, 1}, P{0, 0, 0}, P{1, 1, 1}).relation == none);
  CHECK_BOTH(intersect_plane_line(xy, P{1, 1, 1}, P{1, 1, 1}).relation == none);
  CHECK_BOTH(intersect_plane_line(xy, P{1, 1, not_a_number}, P{1, 1, 1}).relation == none);
  CHECK_BOTH(intersect_plane_line(plane<double>{0, 0, 1, not_a_number}, P{1, 1, 0}, P{1, 1, 1}).relation == none);
  CHECK_BOTH(intersect_plane_line(P{0, 0, 0}, P{1, 1, 1}, P{2, 2, 2}, P{0, 0, 1}, P{1, 0, 0}).relation == none);
  CHECK_BOTH(intersect_plane_line(parametric_plane<double>{{1, 1, 1}, {2, 2, 2}, {0, 0, 0}},
                                  parametric_line<double, 3>{{0, 0, 1}, {1, 0, 0}})
                 .relation == none);
  CHECK_BOTH(intersect_plane_line(xy, parametric_line<double, 3>{{0, 0, 1}, {0, 0, 0}}).relation == none);
  CHECK_BOTH(intersect_plane_line(xy, P{huge, 1, -huge}, P{huge, 1, huge}).at == P{huge, 1, 0});
  CHECK_BOTH(intersect_plane_line(xy, P{1, 1, -5e-324}, P{3, 5, 5e-324}).at == P{2, 3, 0});
}

#ifdef IRG_HAVE_MPFR
namespace {

using E = test::exact;
struct tally {
  int wrong = 0, crossings = 0, others = 0;
  double worst = 0;
  void worse(double got, const E& want) { worst = std::fmax(worst, test::error_in_ulp(got, want)); }
};

// The oracle: heights of both ends over the plane, n.a + d and n.b + d; the crossing divides ab by their ratio.
void compare(const irg::plane_line_meeting<P>& got, const E (&n)[3], const E& d, const P& a, const P& b, tally& sum) {
  E height_a = d, height_b = d;
  for (int k = 0; k < 3; ++k) height_a = height_a + n[k] * E(a[k]), height_b = height_b + n[k] * E(b[k]);
  const bool no_plane = n[0].sign() == 0 && n[1].sign() == 0 && n[2].sign() == 0;
  flat_relation want = crossing;
  if (height_a == height_b) want = height_a.sign() == 0 ? contained : parallel;
  if (no_plane || a == b) want = none;
  sum.wrong += got.relation != want;
  if (want != crossing || got.relation != crossing) {
    ++sum.others;
    return;
  }
  ++sum.crossings;
  const E t = height_a / (height_a - height_b);
  sum.worse(got.t, t);
  for (int k = 0; k < 3; ++k) sum.worse(got.at[k], E(a[k]) * (E(1) - t) + E(b[k]) * t);
}

}  // namespace

TEST_CASE("intersect_plane_line: relations and positions against rationals, all magnitudes") {
  test::random r(17);
  tally by_coefficients, by_points, by_parameters;
  for (const test::spread kind : test::all_spreads)
    for (int i = 0; i < test::trials(150); ++i) {
      double c[15];
      for (double& x : c) x = test::any_coordinate<double>(r, kind);
      if (i % 4 == 1) c[6] = c[3], c[7] = c[4], c[8] = c[2];  // often contained, collinear or parallel
      if (i % 4 == 2) c[2] = c[5] = c[8] = 0;
      const P p{c[0], c[1], c[2]}, q{c[3], c[4], c[5]}, s{c[6], c[7], c[8]}, a{c[9], c[10], c[11]};
      const P b = i % 4 == 3 ? P{c[12], c[13], c[11]} : P{c[12], c[13], c[14]};
      const E given[3] = {E(c[0]), E(c[1]), E(c[2])};
      compare(intersect_plane_line(plane<double>{c[0], c[1], c[2], c[3]}, a, b), given, E(c[3]), a, b, by_coefficients);
      E n[3], d = 0, m[3], e = 0;
      for (int k = 0; k < 3; ++k) {
        const int u = (k + 1) % 3, v = (k + 2) % 3;
        n[k] = (E(q[u]) - E(p[u])) * (E(s[v]) - E(p[v])) - (E(q[v]) - E(p[v])) * (E(s[u]) - E(p[u]));
        m[k] = E(p[u]) * E(q[v]) - E(p[v]) * E(q[u]);
        d = d - n[k] * E(s[k]), e = e - m[k] * E(s[k]);
      }
      compare(intersect_plane_line(p, q, s, a, b), n, d, a, b, by_points);
      // p and q as directions, s as origin; the line's end must be exact to be compared with.
      const irg::vec<double, 3> u{c[12], c[13], c[14]};
      const auto got = intersect_plane_line(parametric_plane<double>{to_vec(p), to_vec(q), s}, {a, u});
      if (got.relation != crossing || !std::isfinite(got.t + got.s1 + got.s2)) continue;
      ++by_parameters.crossings;
      for (int k = 0; k < 3; ++k) {  // the point by the parameters is the point by the line, as far as rounding lets
        const E on_line = E(a[k]) + E(got.t) * E(u[k]);
        const E in_plane = E(s[k]) + E(got.s1) * E(p[k]) + E(got.s2) * E(q[k]);
        const auto size = [](const E& x) { return x.sign() < 0 ? -x : x; };
        const E scale = size(E(a[k])) + size(E(got.t) * E(u[k])) + size(E(s[k])) + size(E(got.s1) * E(p[k])) +
                        size(E(got.s2) * E(q[k]));
        const bool fits = !(scale * E(0x1p-52) + E(5e-324) * (E(1) + size(E(u[k])) + size(E(p[k])) + size(E(q[k]))) <
                            size(on_line - in_plane));
        by_parameters.wrong += !fits;
      }
    }
  for (const tally& sum : {by_coefficients, by_points, by_parameters}) {
    MESSAGE(sum.crossings, " crossings, ", sum.others, " others, worst ", sum.worst, " ulp");
    CHECK(sum.wrong == 0);
    CHECK(sum.worst <= 0.501);
    CHECK(sum.crossings > 300);
  }
}

TEST_CASE_TEMPLATE("intersect_plane_line: numbers of all sizes", T, double, float) {
  using namespace test::mixed;
  sweep(
      named<T>("intersect_plane_line, parametric"), 0.501,
      [](test::random& r, sizes which) {
        const auto p = points<T, 3, 5>(r, which);
        const place<3> u = exactly(p[0]), v = exactly(p[1]), o = exactly(p[2]), a = exactly(p[3]), w = exactly(p[4]);
        const auto got = intersect_plane_line(irg::parametric_plane<T>{to_vec(p[0]), to_vec(p[1]), p[2]},
                                              irg::parametric_line<T, 3>{p[3], to_vec(p[4])});
        // s1 u + s2 v - t w = a - o
        const std::array<std::array<E, 3>, 3> rows{{{u[0], v[0], w[0]}, {u[1], v[1], w[1]}, {u[2], v[2], w[2]}}};
        const E whole = determinant(rows[0], rows[1], rows[2]);
        using irg::flat_relation;
        if ((got.relation == flat_relation::crossing) != (whole.sign() != 0)) return wrong;
        if (whole.sign() == 0) return 0.0;
        const E t = -replaced(rows, a - o, 2);
        const double first = quotient_error(got.s1, replaced(rows, a - o, 0), whole);
        const double second = quotient_error(got.s2, replaced(rows, a - o, 1), whole);
        double worst = std::fmax(std::fmax(first, second), quotient_error(got.t, t, whole));
        for (std::size_t k = 0; k < 3; ++k)
          worst = std::fmax(worst, quotient_error(got.at[static_cast<int>(k)], a[k] * whole + w[k] * t, whole));
        return worst;
      },
      1000);
}
#endif
