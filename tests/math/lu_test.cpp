// SPDX-License-Identifier: MIT
#include <irg/math/lu.hpp>

#include <cmath>
#include <limits>

#include <irg/math/inverse.hpp>

#include "support/big_rational.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

using irg::lu_factor;
using irg::lu_solve;
using irg::lu_solve_refined;
using irg::mat;
using irg::norm_1;
using irg::reciprocal_condition;
using irg::vec;
using test::rational;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();

// L*U, its rows in the matrix's order.
template <class T, int N>
constexpr mat<T, N, N> product_of(const irg::lu_factors<T, N>& f) {
  mat<T, N, N> lower = irg::identity_matrix<T, N>(), upper{}, a{};
  for (int r = 0; r < N; ++r)
    for (int c = 0; c < N; ++c) (c < r ? lower : upper)(r, c) = f.lu(r, c);
  const mat<T, N, N> p = lower * upper;
  for (int r = 0; r < N; ++r)
    for (int c = 0; c < N; ++c) a(f.order[r], c) = p(r, c);
  return a;
}

}  // namespace

TEST_CASE("lu: rationals") {
  using R = rational;
  constexpr mat<R, 3, 3> a{{{0, 2, 1}, {1, 1, 1}, {2, 0, -1}}};
  CHECK_BOTH(product_of(*lu_factor(a)) == a);
  CHECK_BOTH(lu_solve(*lu_factor(a), vec<R, 3>{7, 6, -1}) == vec<R, 3>{1, 2, 3});
  CHECK_BOTH(!lu_factor(mat<R, 2, 2>{{{1, 2}, {2, 4}}}));
  CHECK_BOTH((norm_1(a) == R(3) && norm_1(mat<int, 2, 3>{{{1, -2, 3}, {-4, 5, -6}}}) == 9));
  CHECK_BOTH(reciprocal_condition(mat<R, 2, 2>{{{1, 2}, {3, 4}}}) == R(1, 21));  // norms 6 and 7/2
  test::random r(1);
  for (int i = 0; i < 200; ++i) {
    mat<R, 4, 4> b{};
    for (auto& row : b.m)
      for (R& entry : row) entry = r.integer(-3, 3);
    const auto f = lu_factor(b);
    CHECK(f.has_value() == (determinant(b) != R(0)));
    if (!f) continue;
    CHECK(product_of(*f) == b);
    CHECK(lu_solve(*f, b * vec<R, 4>{1, -2, 3, 5}) == vec<R, 4>{1, -2, 3, 5});
    CHECK(reciprocal_condition(b) == R(1) / norm_1(b) / norm_1(*inverse(b)));
  }
}

TEST_CASE("lu: degenerate and hostile") {
  using M = mat<double, 2, 2>;
  using V = vec<double, 2>;
  CHECK_BOTH((!lu_factor(M{}) && reciprocal_condition(M{}) == 0));
  CHECK_BOTH((!lu_factor(M{{{none, 1}, {1, 1}}}) && !lu_factor(M{{{1, inf}, {1, 1}}})));
  CHECK_BOTH((!lu_factor(M{{{inf, inf}, {inf, 1}}}) && reciprocal_condition(M{{{1, inf}, {none, 1}}}) == 0));
  CHECK((!lu_solve_refined(M{{{none, 1}, {1, 1}}}, V{1, 1}) && !lu_solve_refined(M{{{1, 0}, {0, 1}}}, V{1, inf})));
  CHECK_BOTH((!lu_solve_refined(M{{{1, 2}, {2, 4}}}, V{1, 2}) && !lu_solve_refined(M{{{1, 0}, {0, 0}}}, V{1, 0})));
  CHECK_BOTH(*lu_solve_refined(M{{{0, 1}, {1, 0}}}, V{3, 4}) == V{4, 3});
  CHECK_BOTH(*lu_solve_refined(M{{{1, 2}, {3, 4}}}, V{}) == V{});
  CHECK_BOTH(reciprocal_condition(irg::identity_matrix<float, 3>()) == 1);
  // Sizes at the ends of the range; a solution beyond it.
  CHECK_BOTH(*lu_solve_refined(M{{{0x1p-1074, 0}, {0, 0x1p1023}}}, V{0x1p-1074, 0x1p1023}) == V{1, 1});
  CHECK_BOTH(*lu_solve_refined(M{{{3, 1}, {0x1p-1060, 0x1p-1060}}}, V{5, 0x1p-1059}) == V{1.5, 0.5});
  CHECK_BOTH(!lu_solve_refined(M{{{0x1p-1074, 0}, {0, 1}}}, V{1, 1}));
  CHECK_BOTH(!lu_solve_refined(mat<float, 2, 2>{{{0x1p-100f, 0}, {0, 1}}}, vec<float, 2>{0x1p100f, 1}));
  // Singular up to rounding: 0.1 + 0.2 is not 0.3, and still not far from it.
  CHECK_BOTH(!lu_solve_refined(mat<double, 3, 3>{{{0.1, 0.2, 0.3}, {0.3, 0.6000000000000001, 0.9}, {1, 2, 4}}},
                               vec<double, 3>{1, 2, 3}));
}

TEST_CASE("lu: one result in every life") {
  constexpr mat<double, 3, 3> a{{{0.1, 0.7, -0.3}, {1.3, 0.2, 0.9}, {-0.4, 0.6, 1.1}}};
  constexpr vec<double, 3> b{0.3, 0.1, 0.7};
  constexpr auto x = *lu_solve_refined(a, b), y = lu_solve(*lu_factor(a), b);
  constexpr double condition = reciprocal_condition(a);
  volatile double one = 1;
  CHECK((*lu_solve_refined(a * one, b) == x && lu_solve(*lu_factor(a * one), b) == y));
  CHECK(reciprocal_condition(a * one) == condition);
}

#ifdef IRG_HAVE_MPFR

TEST_CASE("lu: errors of solutions, against rationals") {
  using test::big_rational;
  test::random r(4);
  const int count = std::getenv("IRG_RELEASE_TIER") != nullptr ? 20000 : 300;
  double refined = 0, plain = 0;
  for (int i = 0; i < count; ++i) {
    // Rows that are nearly dependent: condition 2^10 to 2^48.
    mat<double, 4, 4> a{};
    for (auto& row : a.m)
      for (double& entry : row) entry = r.unit() - 0.5;
    const double step = std::ldexp(1.0, -10 - i % 36);
    for (int c = 0; c < 4; ++c) a(3, c) = a(0, c) + a(1, c) + step * a(3, c);
    const vec<double, 4> b{r.unit(), r.unit(), r.unit(), r.unit()};
    const auto exact = irg::generate_mat<big_rational, 4, 4>([&](int y, int x) { return big_rational(a(y, x)); });
    const auto undo = inverse(exact);
    const auto x = lu_solve_refined(a, b);
    if (!undo || !x) {
      CHECK(reciprocal_condition(a) < 1e-14);
      continue;
    }
    const vec<double, 4> y = lu_solve(*lu_factor(a), b);
    double worst = 0, worst_plain = 0, largest = 0;
    for (int k = 0; k < 4; ++k) {
      big_rational truth = 0;
      for (int j = 0; j < 4; ++j) truth = truth + (*undo)(k, j) * big_rational(b[j]);
      worst = std::fmax(worst, test::distance((*x)[k], truth));
      worst_plain = std::fmax(worst_plain, test::distance(y[k], truth));
      largest = std::fmax(largest, std::fabs(static_cast<double>(truth)));
    }
    refined = std::fmax(refined, worst / largest * 0x1p53);
    plain = std::fmax(plain, worst_plain / largest * 0x1p53 * reciprocal_condition(a));
  }
  MESSAGE("relative errors: refined ", refined, " u, plain ", plain, " u*condition");
  CHECK(refined <= 1.1);
  CHECK(plain <= 4);
}

#endif
