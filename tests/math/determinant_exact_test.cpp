// SPDX-License-Identifier: MIT
#include <irg/math/determinant_exact.hpp>

#include <cmath>
#include <limits>

#include "support/big_rational.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/ulp.hpp"

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
