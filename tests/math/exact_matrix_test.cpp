// SPDX-License-Identifier: MIT
#include <irg/math/exact_matrix.hpp>

#include <cmath>
#include <limits>

#include <irg/math/inverse.hpp>

#include "support/big_rational.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/ulp.hpp"
#include "support/exact.hpp"

using irg::determinant;
using irg::determinant_exact;
using irg::determinant_sign;
using irg::mat;

namespace {

template <class T>
using mat3 = mat<T, 3, 3>;
constexpr double inf = std::numeric_limits<double>::infinity(), none = std::numeric_limits<double>::quiet_NaN();
constexpr double huge = std::numeric_limits<double>::max(), tiny = std::numeric_limits<double>::denorm_min();

}  // namespace

TEST_CASE("determinant_exact: the course's values, and by hand") {
  CHECK_BOTH(determinant_exact(mat3<double>{{{1, 2, 3}, {2, 1, 3}, {4, 5, 1}}}) == 24);
  CHECK_BOTH(determinant_exact(mat3<float>{{{-1, 2, -3}, {5, -2, 7}, {-4, -1, 3}}}) == -48);
  CHECK_BOTH(determinant_exact(mat<double, 1, 1>{{{9}}}) == 9);
  // 0.1 * 0.3 - 0.3 * 0.1 in the plane; rows that are equal up to one bit.
  CHECK_BOTH(determinant_exact(mat<double, 2, 2>{{{0.1, 0.3}, {0.1, 0.3}}}) == 0);
  CHECK_BOTH(determinant_exact(mat<double, 2, 2>{{{1 + 0x1p-30, 1 + 0x1p-29}, {1, 1 + 0x1p-30}}}) == 0x1p-60);
  CHECK_BOTH(determinant(mat<double, 2, 2>{{{1 + 0x1p-30, 1 + 0x1p-29}, {1, 1 + 0x1p-30}}}) == 0);
  // 2^24 + 1 and a little: a float is rounded once.
  CHECK_BOTH(determinant_exact(mat<float, 2, 2>{{{16777216, -1}, {1 + 0x1p-23f, 1}}}) == 16777218.0f);
}

TEST_CASE("determinant_exact: degenerate and hostile") {
  CHECK_BOTH((determinant_exact(mat3<double>{}) == 0 && determinant_sign(mat3<double>{}) == 0));
  CHECK_BOTH(determinant_exact(mat<double, 2, 2>{{{huge, huge}, {huge, huge}}}) == 0);
  CHECK_BOTH(determinant_exact(mat<double, 2, 2>{{{huge, 0}, {0, -huge}}}) == -inf);
  CHECK_BOTH(determinant_exact(mat<double, 2, 2>{{{huge, 0}, {0, tiny}}}) == huge * 0x1p-1022 * 0x1p-52);
  // Too small for a double, and still not singular.
  CHECK_BOTH(determinant_exact(mat<double, 2, 2>{{{tiny, 0}, {0, tiny}}}) == 0);
  CHECK_BOTH(determinant_sign(mat<double, 2, 2>{{{0, tiny}, {tiny, 0}}}) == -1);
  CHECK(std::isnan(determinant_exact(mat<double, 2, 2>{{{none, 0}, {0, 1}}})));
  CHECK(determinant_exact(mat<double, 1, 1>{{{inf}}}) == inf);
  CHECK_BOTH(determinant_sign(mat<double, 1, 1>{{{inf}}}) == 0);
  static_assert(noexcept(determinant_exact(mat3<float>{})));
}

#ifdef IRG_HAVE_MPFR

TEST_CASE("determinant_exact: against rationals, rounded by MPFR") {
  using test::big_rational;
  test::random r(1);
  int singular = 0, plain_wrong = 0;
  for (int i = 0, n = test::count_of(1500); i < n; ++i) {
    mat<double, 4, 4> a{};
    for (auto& row : a.m)
      for (double& entry : row)
        entry = i % 3 == 0   ? test::any_double(r)
                : i % 3 == 1 ? static_cast<double>(r.integer(-99, 99))
                             : std::ldexp(r.unit() - 0.5, static_cast<int>(r.integer(-9, 9)));
    if (i % 2 == 0)  // the last row depends on the others, but for roundings
      for (int c = 0; c < 4; ++c) a(3, c) = a(0, c) * 0.5 + (i % 3 == 0 ? 0 : a(1, c) * 0.3);
    const auto exact_of = irg::generate_mat<big_rational, 4, 4>([&](int y, int x) { return big_rational(a(y, x)); });
    const big_rational truth = determinant(exact_of);
    CHECK(determinant_sign(a) == truth.sign());
    singular += truth.sign() == 0 ? 1 : 0;
    const double got = determinant_exact(a);
    CHECK(test::error_in_ulp(got, truth) <= 0.5);
    plain_wrong += test::same(determinant(a), got) ? 0 : 1;
  }
  CHECK(singular > 10);
  CHECK(plain_wrong > 100);
}

#endif

using irg::inverse_exact;
using irg::mat;

TEST_CASE("inverse_exact: by hand") {
  CHECK_BOTH(*inverse_exact(mat<double, 2, 2>{{{3, 1}, {5, 2}}}) == mat<double, 2, 2>{{{2, -1}, {-5, 3}}});
  CHECK_BOTH(*inverse_exact(mat<float, 2, 2>{{{3, 0}, {0, 7}}}) == mat<float, 2, 2>{{{1.0f / 3, 0}, {0, 1.0f / 7}}});
  CHECK_BOTH(!inverse_exact(mat<double, 2, 2>{{{3, 1}, {6, 2}}}));
  // 2^53 + 1 is half-way between two doubles.
  CHECK_BOTH((*inverse_exact(mat<double, 2, 2>{{{1, -0x1p53}, {0, 1}}}))(0, 1) == 0x1p53);
  CHECK_BOTH((*inverse_exact(mat<double, 3, 3>{{{1, 0x1p53, 1}, {0, 1, 1}, {0, 0, 1}}}))(0, 2) == 0x1p53 - 1);
  CHECK_BOTH((*inverse_exact(mat<double, 3, 3>{{{1, 0x1p53, -1}, {0, 1, 1}, {0, 0, 1}}}))(0, 2) == 0x1p53);
}

TEST_CASE("inverse_exact: a matrix of integers and determinant 1 has an inverse of integers, found without error") {
  test::random r(1);
  for (int i = 0; i < 200; ++i) {
    mat<double, 4, 4> a = irg::identity_matrix<double, 4>(), undo = a;
    for (int k = 0; k < 12; ++k) {
      const int from = static_cast<int>(r.integer(0, 3)), to = static_cast<int>(r.integer(0, 3));
      if (from == to) continue;
      const auto factor = static_cast<double>(r.integer(-9, 9));
      mat<double, 4, 4> shear = irg::identity_matrix<double, 4>(), back = shear;
      shear(to, from) = factor;
      back(to, from) = -factor;
      a = shear * a;
      undo = undo * back;
    }
    CHECK(inverse_exact(a) == undo);
  }
}

#ifdef IRG_HAVE_MPFR

// The inverse of a triangle of ones on the diagonal has a*b - c in its corner: as long as both factors together.
TEST_CASE_TEMPLATE("inverse_exact: ties go to even, subnormal ones too", T, double, float) {
  using test::big_rational;
  constexpr int digits = std::numeric_limits<T>::digits, least = std::numeric_limits<T>::min_exponent - digits;
  test::random r(2);
  const int count = test::trials(10'000);
  int wrong = 0, ties = 0;
  for (int i = 0; i < count; ++i) {
    mat<T, 3, 3> a = irg::identity_matrix<T, 3>();
    const bool is_subnormal = i % 2 != 0;
    const auto factor = [&] {  // the product has one bit more than a number, or one less or two more
      const std::int64_t size = std::int64_t{1} << (is_subnormal ? r.integer(1, digits / 2 - 1) : (digits + 1) / 2);
      return static_cast<T>(r.integer(size / 2, size + size / 2));
    };
    a(0, 1) = factor(), a(1, 2) = factor(), a(0, 2) = static_cast<T>(r.integer(-2, 2));
    if (i % 3 == 0) a(0, 2) = std::ldexp(a(0, 2), static_cast<int>(-r.integer(1, digits + 30)));  // a bit off a tie
    // Column 0 and row 2 times a power: the corner is a few halves of the smallest number.
    const int power = is_subnormal ? static_cast<int>(r.integer(1, 3)) - least : 0, half = power / 2;
    for (int k = 0; k < 3; ++k) {
      a(k, 0) = std::ldexp(a(k, 0), half);
      a(2, k) = std::ldexp(a(2, k), power - half);
    }
    const auto x = inverse_exact(a);
    const auto exact = irg::inverse(irg::generate_mat<big_rational, 3, 3>(
        [&](int p, int q) { return big_rational(static_cast<double>(a(p, q))); }));
    bool is_large = false;
    for (int p = 0; p < 3; ++p)
      for (int q = 0; q < 3; ++q) {
        const T nearest = test::nearest<T>((*exact)(p, q));
        is_large = is_large || std::isinf(nearest);
        if (!x || std::isinf(nearest)) continue;
        wrong += (*x)(p, q) == nearest ? 0 : 1;
        ties += test::error_in_ulp(nearest, (*exact)(p, q)) == 0.5 ? 1 : 0;
      }
    wrong += x.has_value() == is_large ? 1 : 0;
  }
  MESSAGE("ties ", ties, "; wrong ", wrong);
  CHECK(wrong == 0);
  CHECK(ties > count / 10);
}

#endif
