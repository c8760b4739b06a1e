// SPDX-License-Identifier: MIT
#include <irg/math/matrix.hpp>

#include <cmath>
#include <limits>

#include <irg/math/inverse.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

using irg::mat;
using irg::matrix;
using irg::matrix_error;
using test::rational;

namespace {

template <int R, int C, class T = int>
constexpr matrix<T> of(const mat<T, R, C>& a) {
  return matrix<T>(a);
}
template <class T, class E>
constexpr bool is(const irg::result<T, E>& r, const std::type_identity_t<T>& value) {
  return r && *r == value;
}
template <class T, class E>
constexpr bool fails(const irg::result<T, E>& r, E error) {
  return !r && r.error() == error;
}

}  // namespace

TEST_CASE("matrix: by hand") {
  constexpr mat<int, 2, 3> A{{{1, 2, 3}, {4, 5, 6}}};
  constexpr mat<int, 3, 2> B{{{7, 8}, {9, 10}, {11, 12}}};
  CHECK_BOTH((of(A).rows() == 2 && of(A).columns() == 3 && of(A)(1, 2) == 6));
  CHECK_BOTH(is(multiply(of(A), of(B)), of(A * B)));
  CHECK_BOTH(is(pre_multiply(of(A), of(B)), of(B * A)));
  CHECK_BOTH(is(add(of(A), of(A)), multiply(of(A), 2)));
  CHECK_BOTH(is(subtract(of(A), of(A)), matrix<int>(2, 3)));
  CHECK_BOTH(transpose(of(A)) == of(transpose(A)));
  CHECK_BOTH(is(multiply(irg::identity_matrix<int>(2), of(A)), of(A)));
  // Scalars: whole numbers and numbers of the matrix's own type.
  constexpr mat<double, 1, 2> D{{{1.5, -2}}};
  CHECK_BOTH((multiply(of(D), 2) == of(D * 2.0) && multiply(of(D), 0.5) == of(D * 0.5)));
  CHECK_BOTH(multiply(matrix<rational>(mat<rational, 1, 1>{{{3}}}), 2)(0, 0) == rational(6));
}

TEST_CASE("matrix: the course's exercise 1") {
  using R = rational;
  constexpr mat<R, 3, 3> A{{{1, 2, 3}, {2, 1, 3}, {4, 5, 1}}}, B{{{-1, 2, -3}, {5, -2, 7}, {-4, -1, 3}}};
  CHECK_BOTH(is(add(of(A), of(B)), of(mat<R, 3, 3>{{{0, 4, 0}, {7, -1, 10}, {0, 4, 4}}})));
  CHECK_BOTH(is(multiply(of(A), transpose(of(B))), of(mat<R, 3, 3>{{{-6, 22, 3}, {-9, 29, 0}, {3, 17, -18}}})));
  CHECK_BOTH((is(determinant(of(A)), R(24)) && is(determinant(of(B)), R(-48))));
  CHECK_BOTH(is(multiply(of(A), *inverse(of(B))),
                of(mat<R, 3, 3>{{{R(31, 12), R(5, 4), R(2, 3)}, {R(5, 3), 1, R(1, 3)}, {R(14, 3), 2, R(1, 3)}}})));
  CHECK_BOTH(is(solve(of(mat<R, 3, 3>{{{1, 1, 1}, {-1, -2, 1}, {2, 1, 3}}}), of(mat<R, 3, 1>{{{6}, {-2}, {13}}})),
                of(mat<R, 3, 1>{{{1}, {2}, {3}}})));
}

TEST_CASE("matrix: sizes that do not fit, and other failures") {
  const matrix<double> wide(2, 3), tall(3, 2), square(2, 2), column(2, 1);
  CHECK(fails(add(wide, tall), matrix_error::size_mismatch));
  CHECK(fails(subtract(wide, square), matrix_error::size_mismatch));
  CHECK(fails(multiply(wide, square), matrix_error::size_mismatch));
  CHECK(fails(pre_multiply(wide, tall), matrix_error::size_mismatch) == false);
  CHECK(fails(pre_multiply(square, wide), matrix_error::size_mismatch));
  CHECK(fails(determinant(wide), matrix_error::not_square));
  CHECK(fails(inverse(tall), matrix_error::not_square));
  CHECK(fails(solve(wide, column), matrix_error::not_square));
  CHECK(fails(solve(square, tall), matrix_error::size_mismatch));
  CHECK(fails(solve(square, square), matrix_error::size_mismatch));
  CHECK(fails(inverse(square), matrix_error::singular));
  CHECK(fails(solve(square, column), matrix_error::dependent));
  matrix<double> one = column, broken = square;
  one(0, 0) = 1;
  CHECK(fails(solve(square, one), matrix_error::inconsistent));
  broken(0, 1) = std::numeric_limits<double>::quiet_NaN();
  CHECK((fails(inverse(broken), matrix_error::not_finite) && fails(solve(broken, one), matrix_error::not_finite)));
  // Elimination overflows on the way, the inverse does not.
  for (const double size : {1.7e308, -0x1p1023, 0x1p-1024}) {
    CHECK(is(inverse(of(mat<double, 2, 2>{{{size, size}, {-size, size}}})),
             of(mat<double, 2, 2>{{{0.5 / size, -0.5 / size}, {0.5 / size, 0.5 / size}}})));
    CHECK(fails(inverse(of(mat<double, 2, 2>{{{size, size}, {size, size}}})), matrix_error::singular));
  }
  CHECK(fails(inverse(of(mat<double, 2, 2>{{{1e-320, 0}, {0, 1}}})), matrix_error::not_finite));
  static_assert(fails(multiply(matrix<int>(1, 2), matrix<int>(3, 1)), matrix_error::size_mismatch));
  // Nothing at all is a matrix too.
  CHECK_BOTH(
      (is(determinant(matrix<int>(0, 0)), 1) && is(multiply(matrix<int>(2, 0), matrix<int>(0, 3)), matrix<int>(2, 3))));
  CHECK_BOTH((is(inverse(matrix<double>()), matrix<double>()) && transpose(matrix<int>(0, 5)).rows() == 5));
  CHECK_BOTH(is(solve(matrix<double>(0, 0), matrix<double>(0, 1)), matrix<double>(0, 1)));
}

TEST_CASE("matrix: agrees with mat bit for bit") {
  test::random r(1);
  for (int i = 0; i < 200; ++i) {
    mat<double, 4, 4> a{}, b{};
    mat<std::int64_t, 4, 4> whole{};
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 4; ++x) {
        a(y, x) = r.unit() - 0.5;
        b(y, x) = r.unit() - 0.5;
        whole(y, x) = r.integer(i % 2 == 0 ? -2 : -1000, i % 2 == 0 ? 2 : 1000);
      }
    CHECK(is(multiply(of(a), of(b)), of(a * b)));
    const auto close = inverse(of(a));  // by elimination, where mat's is by cofactors if they are good enough
    CHECK(close.has_value());
    for (int y = 0; close && y < 4; ++y)
      for (int x = 0; x < 4; ++x) CHECK((*close)(y, x) == doctest::Approx((*irg::inverse(a))(y, x)).epsilon(1e-9));
    CHECK(is(determinant(of(whole)), determinant(whole)));
    const auto x = solve(of(a), of(mat<double, 4, 1>{{{1}, {2}, {3}, {4}}}));
    const auto y = solve_gauss(a, irg::vec<double, 4>{1, 2, 3, 4});
    CHECK((x && y));
    for (int k = 0; x && k < 4; ++k) CHECK((*x)(k, 0) == y.x[k]);
  }
  // Larger than any mat here: the determinant of the second difference of size n is n + 1.
  const int n = 60;
  matrix<double> difference(n, n), ones(n, 1);
  for (int k = 0; k < n; ++k) {
    difference(k, k) = 2;
    ones(k, 0) = 1;
    if (k > 0) difference(k, k - 1) = difference(k - 1, k) = -1;
  }
  CHECK(*determinant(difference) == doctest::Approx(n + 1));
  const auto x = solve(difference, ones);
  for (int k = 0; x && k < n; ++k) CHECK((*x)(k, 0) == doctest::Approx((k + 1) * (n - k) / 2.0));
}
