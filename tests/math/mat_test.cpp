// SPDX-License-Identifier: MIT
#include <irg/math/mat.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

using irg::determinant;
using irg::hpoint;
using irg::identity;
using irg::inverse;
using irg::mat;
using irg::point;
using irg::transpose;
using irg::vec;
using test::rational;

namespace {

template <class A, class B>
concept multipliable = requires(const A a, const B b) { a* b; };

template <class T>
using mat3 = mat<T, 3, 3>;
template <class T>
using mat4 = mat<T, 4, 4>;

// The determinant by Leibniz's sum over all permutations.
template <class T, int N>
constexpr T leibniz(const mat<T, N, N>& a) {
  T sum = T(0);
  int order[static_cast<std::size_t>(N)];
  const auto visit = [&](auto&& self, int k) -> void {
    if (k == N) {
      T term = T(1);
      for (int i = 0; i < N; ++i) {
        term = term * a(i, order[i]);
        for (int j = 0; j < i; ++j)
          if (order[j] > order[i]) term = -term;
      }
      sum = sum + term;
      return;
    }
    for (int c = 0; c < N; ++c) {
      bool used = false;
      for (int j = 0; j < k; ++j) used = used || order[j] == c;
      if (used) continue;
      order[k] = c;
      self(self, k + 1);
    }
  };
  visit(visit, 0);
  return sum;
}

template <class T, int N>
mat<T, N, N> random_integers(test::random& r, std::int64_t size) {
  mat<T, N, N> a;
  for (auto& row : a.m)
    for (T& entry : row) entry = static_cast<T>(r.integer(-size, size));
  return a;
}

template <class T, int N>
mat<rational, N, N> exact(const mat<T, N, N>& a) {
  return irg::detail::filled_mat<rational, N, N>(
      [&](int i, int j) { return rational::of(static_cast<double>(a(i, j))); });
}

}  // namespace

TEST_CASE("mat: type facts") {
  static_assert(std::is_aggregate_v<mat4<float>> && std::is_trivially_copyable_v<mat4<float>>);
  static_assert(sizeof(mat<float, 3, 4>) == 12 * sizeof(float));
  static_assert(!multipliable<mat<double, 2, 3>, mat<double, 2, 3>>);
  static_assert(multipliable<mat<double, 2, 3>, mat<double, 3, 5>>);
  static_assert(!multipliable<mat<double, 2, 3>, vec<double, 2>>);
  static_assert(!multipliable<mat<double, 3, 3>, point<double, 3>>);  // neither linear nor projective: say which
  static_assert(!multipliable<mat<double, 4, 4>, vec<double, 3>>);
  static_assert(!multipliable<mat<double, 4, 4>, vec<float, 4>>);
  static_assert(std::same_as<decltype(mat4<float>{} * point<float, 3>{}), hpoint<float, 3>>);
  static_assert(std::same_as<decltype(mat3<float>{} * hpoint<float, 2>{}), hpoint<float, 2>>);
}

TEST_CASE("mat: by hand") {
  constexpr mat<int, 2, 3> a{{{1, 2, 3}, {4, 5, 6}}};
  constexpr mat<int, 3, 2> b{{{7, 8}, {9, 10}, {11, 12}}};
  CHECK_BOTH((a(0, 2) == 3 && a(1, 0) == 4));
  CHECK_BOTH(a * b == mat<int, 2, 2>{{{58, 64}, {139, 154}}});
  CHECK_BOTH(transpose(a) == mat<int, 3, 2>{{{1, 4}, {2, 5}, {3, 6}}});
  CHECK_BOTH((a + a == a * 2 && 2 * a == a * 2 && a - a == mat<int, 2, 3>{} && -a == a * -1));
  CHECK_BOTH(a * vec<int, 3>{1, 0, -1} == vec<int, 2>{-2, -2});
  CHECK_BOTH(identity<int, 4>() * hpoint<int, 3>{1, 2, 3, 4} == hpoint<int, 3>{1, 2, 3, 4});

  constexpr mat4<int> m{{{1, 0, 0, 5}, {0, 2, 0, 6}, {0, 0, 3, 7}, {0, 0, 0, 1}}};
  CHECK_BOTH(m * point<int, 3>{1, 1, 1} == hpoint<int, 3>{6, 8, 10, 1});
  CHECK_BOTH(transform_point(m, point<int, 3>{1, 1, 1}) == point<int, 3>{6, 8, 10});
  CHECK_BOTH(transform_vector(m, vec<int, 3>{1, 1, 1}) == vec<int, 3>{1, 2, 3});
  CHECK_BOTH(transform_point(m, std::array<int, 3>{1, 1, 1}) == std::array<int, 3>{6, 8, 10});
  CHECK_BOTH(submatrix(m, 0, 1) == mat<int, 3, 3>{{{0, 0, 6}, {0, 3, 7}, {0, 0, 1}}});
  CHECK_BOTH((determinant(m) == 6 && determinant(mat<int, 1, 1>{{{9}}}) == 9));
}

TEST_CASE("mat: GOLDEN 1, exercise 1") {
  using R = rational;
  constexpr mat3<R> A{{{1, 2, 3}, {2, 1, 3}, {4, 5, 1}}}, B{{{-1, 2, -3}, {5, -2, 7}, {-4, -1, 3}}};
  CHECK_BOTH(A + B == mat3<R>{{{0, 4, 0}, {7, -1, 10}, {0, 4, 4}}});
  CHECK_BOTH(A - B == mat3<R>{{{2, 0, 6}, {-3, 3, -4}, {8, 6, -2}}});
  CHECK_BOTH(A * transpose(B) == mat3<R>{{{-6, 22, 3}, {-9, 29, 0}, {3, 17, -18}}});
  CHECK_BOTH(A * B == mat3<R>{{{-3, -5, 20}, {-9, -1, 10}, {17, -3, 26}}});
  CHECK_BOTH(B * A == mat3<R>{{{-9, -15, 0}, {29, 43, 16}, {6, 6, -12}}});
  CHECK_BOTH((determinant(A) == R(24) && determinant(B) == R(-48)));
  CHECK_BOTH(*inverse(A) ==
             mat3<R>{{{R(-7, 12), R(13, 24), R(1, 8)}, {R(5, 12), R(-11, 24), R(1, 8)}, {R(1, 4), R(1, 8), R(-1, 8)}}});
  CHECK_BOTH(
      *inverse(B) ==
      mat3<R>{{{R(-1, 48), R(1, 16), R(-1, 6)}, {R(43, 48), R(5, 16), R(1, 6)}, {R(13, 48), R(3, 16), R(1, 6)}}});
  CHECK_BOTH(A * *inverse(B) ==
             mat3<R>{{{R(31, 12), R(5, 4), R(2, 3)}, {R(5, 3), 1, R(1, 3)}, {R(14, 3), 2, R(1, 3)}}});
}

TEST_CASE("mat: one result in every life") {
  constexpr mat3<double> ordinary{{{0.1, 0.7, -0.3}, {1.3, 0.2, 0.9}, {-0.4, 0.6, 1.1}}};
  constexpr auto at_compile_time = *inverse(ordinary);
  volatile double one = 1;
  const auto at_run_time = *inverse(ordinary * one);
  CHECK(at_run_time == at_compile_time);
  CHECK(ordinary * one * (at_run_time * one) == [&] {
    constexpr auto p = ordinary * at_compile_time;
    return p;
  }());
  constexpr double d = determinant(ordinary);
  CHECK(determinant(ordinary * one) == d);
  CHECK_BOTH(!inverse(mat3<double>{{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}}));                  // degenerate
  CHECK_BOTH(
      !inverse(mat3<float>{{{1e-40f, 0, 0}, {0, 1, 0}, {0, 0, std::numeric_limits<float>::quiet_NaN()}}}));  // hostile
}

TEST_CASE("mat: determinants agree with the sum over all permutations") {
  test::random r(1);
  for (int i = 0; i < 300; ++i) {
    const auto a2 = random_integers<std::int64_t, 2>(r, 1000);
    const auto a3 = random_integers<std::int64_t, 3>(r, 1000);
    const auto a4 = random_integers<std::int64_t, 4>(r, 1000);
    const auto a5 = random_integers<rational, 5>(r, 50);
    CHECK(determinant(a2) == leibniz(a2));
    CHECK(determinant(a3) == leibniz(a3));
    CHECK(determinant(a4) == leibniz(a4));
    CHECK(determinant(a5) == leibniz(a5));
    CHECK(determinant(transpose(a4)) == determinant(a4));
    CHECK(transpose(cofactor_matrix(a4)) * a4 == identity<std::int64_t, 4>() * determinant(a4));
    CHECK(transpose(cofactor_matrix(a3)) * a3 == identity<std::int64_t, 3>() * determinant(a3));
    CHECK(transpose(cofactor_matrix(a2)) * a2 == identity<std::int64_t, 2>() * determinant(a2));
  }
  CHECK(determinant(identity<double, 7>() * 2.0) == 128);
  CHECK(determinant(mat<double, 5, 5>{}) == 0);
}

TEST_CASE("mat: the determinant's error bound, against rationals") {
  test::random r(2);
  for (int i = 0; i < 2000; ++i) {
    mat4<float> a;
    for (auto& row : a.m)
      for (float& entry : row) entry = static_cast<float>(r.integer(-4096, 4096)) / 64;
    mat4<float> size = a;
    for (auto& row : size.m)
      for (float& entry : row) entry = entry < 0 ? -entry : entry;
    // The sum of the absolute products is the permanent of the absolute values: Leibniz without signs, through
    // rationals.
    double permanent = 0;
    int p[] = {0, 1, 2, 3};
    const auto term = [&] {
      double t = 1;
      for (int k = 0; k < 4; ++k) t *= static_cast<double>(size(k, p[k]));
      permanent += t;
    };
    for (p[0] = 0; p[0] < 4; ++p[0])
      for (p[1] = 0; p[1] < 4; ++p[1])
        for (p[2] = 0; p[2] < 4; ++p[2])
          if ((p[3] = 6 - p[0] - p[1] - p[2], p[0] != p[1] && p[0] != p[2] && p[1] != p[2])) term();
    const double error = static_cast<double>(determinant(a)) - static_cast<double>(leibniz(exact(a)));
    CHECK(std::abs(error) <= 10 * 0x1p-24 * permanent);
  }
}

TEST_CASE("mat: inverses") {
  test::random r(3);
  int singular = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto a = random_integers<rational, 4>(r, 2);
    const auto undo = inverse(a);
    CHECK(undo.has_value() == (determinant(a) != rational(0)));
    singular += undo ? 0 : 1;
    if (undo) CHECK((*undo * a == identity<rational, 4>() && a * *undo == identity<rational, 4>()));

    // The same matrix in floats: absent exactly when singular, and near the rational inverse.
    const auto b = irg::detail::filled_mat<float, 4, 4>(
        [&](int y, int x) { return static_cast<float>(static_cast<double>(a(y, x))); });
    const auto close = inverse(b);
    CHECK(close.has_value() == undo.has_value());
    if (!close || !undo) continue;
    double worst = 0, largest = 0, size = 0;
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 4; ++x) {
        const double truth = static_cast<double>((*undo)(y, x));
        worst = std::max(worst, std::abs(static_cast<double>((*close)(y, x)) - truth));
        largest = std::max(largest, std::abs(truth));
        size = std::max(size, std::abs(static_cast<double>(b(y, x))));
      }
    const double condition = 16 * largest * size;
    CHECK(worst <= 8 * condition * 0x1p-24 * largest);
  }
  CHECK(singular > 20);
}

TEST_CASE("mat: inverse, hostile") {
  constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_BOTH(!inverse(mat<double, 3, 3>{}));
  CHECK_BOTH(!inverse(mat<double, 1, 1>{{{0.0}}}));
  CHECK_BOTH(*inverse(mat<double, 1, 1>{{{4.0}}}) == mat<double, 1, 1>{{{0.25}}});
  CHECK(!inverse(mat<double, 2, 2>{{{nan, 1}, {1, 1}}}));
  CHECK(!inverse(mat<double, 2, 2>{{{1, 0}, {0, nan}}}));
  CHECK(!inverse(mat<double, 2, 2>{{{inf, 1}, {1, 1}}}));
  CHECK(!inverse(mat<double, 2, 2>{{{1e-320, 0}, {0, 1}}}));  // its inverse does not fit
  // A zero on the diagonal needs the exchange of rows; badly scaled but regular matrices stay regular.
  CHECK_BOTH(*inverse(mat<double, 2, 2>{{{0, 1}, {1, 0}}}) == mat<double, 2, 2>{{{0, 1}, {1, 0}}});
  CHECK_BOTH(*inverse(mat<double, 3, 3>{{{0x1p-900, 0, 0}, {0, 0, 0x1p900}, {0, 1, 0}}}) ==
             mat<double, 3, 3>{{{0x1p900, 0, 0}, {0, 0, 1}, {0, 0x1p-900, 0}}});
  CHECK(inverse(mat<double, 2, 2>{{{1e-7, 0}, {0, 1e-7}}}).has_value());  // GOLDEN 12: tiny but regular
  // A tiny pivot must not be divided by while there is a larger one.
  CHECK_BOTH(*inverse(mat<double, 2, 2>{{{1e-20, 1}, {1, 1}}}) == mat<double, 2, 2>{{{-1, 1}, {1, -1e-20}}});
  // Equal rows up to rounding: singular to working precision, not a wild result.
  CHECK(!inverse(mat<double, 3, 3>{{{0.1, 0.2, 0.3}, {0.3, 0.6000000000000001, 0.9}, {1, 2, 4}}}));
  // Hilbert matrices: condition 1.6e4 at size 4; beyond 1e16 at size 13 the answer is a refusal.
  const auto hilbert = []<int N>(std::integral_constant<int, N>) {
    return irg::detail::filled_mat<double, N, N>([](int y, int x) { return 1.0 / (y + x + 1); });
  };
  const auto h4 = inverse(hilbert(std::integral_constant<int, 4>{}));
  CHECK(h4.has_value());
  if (h4) CHECK((*h4)(3, 3) == doctest::Approx(2800).epsilon(1e-10));
  CHECK(!inverse(hilbert(std::integral_constant<int, 13>{})));
}

TEST_CASE("mat: a product rounds as its formula says") {
  // Fused, the second product would be exact and the sum not zero.
  constexpr double x = 1 + 0x1p-30;
  constexpr mat<double, 1, 2> row{{{x, -x}}};
  constexpr mat<double, 2, 1> column{{{x}, {x}}};
  CHECK_BOTH((row * column)(0, 0) == 0.0);
  volatile double v = x;
  CHECK((mat<double, 1, 2>{{{v, -v}}} * mat<double, 2, 1>{{{v}, {v}}})(0, 0) == 0.0);
  CHECK(determinant(mat<double, 2, 2>{{{v, v}, {v, v}}}) == 0.0);
}
