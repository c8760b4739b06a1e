// SPDX-License-Identifier: MIT
#include <irg/math/mat.hpp>

#include <array>
#include <cmath>
#include <sstream>
#include <vector>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

using irg::determinant;
using irg::hpoint;
using irg::identity_matrix;
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
  return irg::generate_mat<rational, N, N>([&](int i, int j) { return rational::of(static_cast<double>(a(i, j))); });
}

}  // namespace

TEST_CASE("mat: type facts") {
  static_assert(std::is_standard_layout_v<mat4<float>> && std::is_trivially_copyable_v<mat4<float>>);
  static_assert(mat<int, 2, 2>{{1, 2}, {3, 4}} == mat<int, 2, 2>{{{1, 2}, {3, 4}}});
  static_assert(mat<int, 3, 3>{{1}, {0, 1}, {0, 0, 1}} == irg::identity_matrix<int, 3>());
  static_assert(mat<int, 4, 1>{{1}, {2}, {3}, {4}} == mat<int, 4, 1>{{{1}, {2}, {3}, {4}}});
  static_assert(mat<int, 1, 2>{{1, 2}}(0, 1) == 2 && mat<int, 1, 1>{{{5}}}(0, 0) == 5);
  static_assert(mat<int, 5, 2>{{{1, 2}, {3, 4}, {5, 6}, {7, 8}, {9, 10}}}(4, 1) == 10);
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

TEST_CASE("mat: written row by row") {
  std::ostringstream out;
  out << mat<int, 2, 3>{{1, 2, 3}, {4, 5, 6}};
  CHECK(out.str() == "((1, 2, 3), (4, 5, 6))");
}

TEST_CASE("mat: by hand") {
  constexpr mat<int, 2, 3> a{{{1, 2, 3}, {4, 5, 6}}};
  constexpr mat<int, 3, 2> b{{{7, 8}, {9, 10}, {11, 12}}};
  CHECK_BOTH((a(0, 2) == 3 && a(1, 0) == 4));
  CHECK_BOTH(a * b == mat<int, 2, 2>{{{58, 64}, {139, 154}}});
  CHECK_BOTH(transpose(a) == mat<int, 3, 2>{{{1, 4}, {2, 5}, {3, 6}}});
  CHECK_BOTH((a + a == a * 2 && 2 * a == a * 2 && a - a == mat<int, 2, 3>{} && -a == a * -1));
  CHECK_BOTH(a * vec<int, 3>{1, 0, -1} == vec<int, 2>{-2, -2});
  CHECK_BOTH(identity_matrix<int, 4>() * hpoint<int, 3>{1, 2, 3, 4} == hpoint<int, 3>{1, 2, 3, 4});

  constexpr mat4<int> m{{{1, 0, 0, 5}, {0, 2, 0, 6}, {0, 0, 3, 7}, {0, 0, 0, 1}}};
  CHECK_BOTH(m * point<int, 3>{1, 1, 1} == hpoint<int, 3>{6, 8, 10, 1});
  CHECK_BOTH(transform_point(m, point<int, 3>{1, 1, 1}) == point<int, 3>{6, 8, 10});
  CHECK_BOTH(transform_vector(m, vec<int, 3>{1, 1, 1}) == vec<int, 3>{1, 2, 3});
  CHECK_BOTH(transform_point(m, std::array<int, 3>{1, 1, 1}) == std::array<int, 3>{6, 8, 10});
  CHECK_BOTH(submatrix(m, 0, 1) == mat<int, 3, 3>{{{0, 0, 6}, {0, 3, 7}, {0, 0, 1}}});
  CHECK_BOTH((determinant(m) == 6 && determinant(mat<int, 1, 1>{{{9}}}) == 9));
}

TEST_CASE("mat: the course's exercise 1") {
  using R = rational;
  constexpr mat3<R> A{{{1, 2, 3}, {2, 1, 3}, {4, 5, 1}}}, B{{{-1, 2, -3}, {5, -2, 7}, {-4, -1, 3}}};
  CHECK_BOTH(A + B == mat3<R>{{{0, 4, 0}, {7, -1, 10}, {0, 4, 4}}});
  CHECK_BOTH(A - B == mat3<R>{{{2, 0, 6}, {-3, 3, -4}, {8, 6, -2}}});
  CHECK_BOTH(A * transpose(B) == mat3<R>{{{-6, 22, 3}, {-9, 29, 0}, {3, 17, -18}}});
  CHECK_BOTH(A * B == mat3<R>{{{-3, -5, 20}, {-9, -1, 10}, {17, -3, 26}}});
  CHECK_BOTH(B * A == mat3<R>{{{-9, -15, 0}, {29, 43, 16}, {6, 6, -12}}});
  CHECK_BOTH((determinant(A) == R(24) && determinant(B) == R(-48)));
}

TEST_CASE("mat: one result in every life") {
  constexpr mat3<double> ordinary{{{0.1, 0.7, -0.3}, {1.3, 0.2, 0.9}, {-0.4, 0.6, 1.1}}};
  volatile double one = 1;
  constexpr auto square = ordinary * ordinary;
  CHECK((ordinary * one) * (ordinary * one) == square);
  constexpr double d = determinant(ordinary);
  CHECK(determinant(ordinary * one) == d);
  CHECK_BOTH(determinant(mat3<double>{{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}}) == 0);
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
    CHECK(transpose(cofactor_matrix(a4)) * a4 == identity_matrix<std::int64_t, 4>() * determinant(a4));
    CHECK(transpose(cofactor_matrix(a3)) * a3 == identity_matrix<std::int64_t, 3>() * determinant(a3));
    CHECK(transpose(cofactor_matrix(a2)) * a2 == identity_matrix<std::int64_t, 2>() * determinant(a2));
  }
  CHECK(determinant(identity_matrix<double, 7>() * 2.0) == 128);
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

TEST_CASE("mat: points as rows, the course's form") {
  static_assert(!multipliable<vec<double, 2>, mat<double, 3, 2>>);
  static_assert(multipliable<vec<double, 3>, mat<double, 3, 2>>);
  static_assert(!multipliable<point<double, 3>, mat<double, 3, 3>>);
  static_assert(!multipliable<hpoint<double, 3>, mat<double, 3, 3>>);
  static_assert(std::same_as<decltype(point<float, 3>{} * mat4<float>{}), hpoint<float, 3>>);
  // (x y z 1) times a translation, then times a scaling: from left to right.
  constexpr mat4<int> moved{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {5, 6, 7, 1}}};
  constexpr mat4<int> scaled{{{2, 0, 0, 0}, {0, 2, 0, 0}, {0, 0, 2, 0}, {0, 0, 0, 1}}};
  constexpr point<int, 3> p{1, 2, 3};
  CHECK_BOTH(p * moved * scaled == hpoint<int, 3>{12, 16, 20, 1});
  CHECK_BOTH(p * (moved * scaled) == p * moved * scaled);
  CHECK_BOTH(vec<int, 2>{1, 2} * mat<int, 2, 3>{{{1, 2, 3}, {4, 5, 6}}} == vec<int, 3>{9, 12, 15});
  // Bit for bit the column form of the transposed matrix, and the product of a matrix of one row.
  test::random r(5);
  for (int i = 0; i < 500; ++i) {
    mat4<double> a;
    for (auto& row : a.m)
      for (double& entry : row) entry = r.unit() - 0.5;
    const hpoint<double, 3> h{r.unit(), r.unit(), r.unit(), r.unit()};
    const mat<double, 1, 4> row{{{h.x, h.y, h.z, h.w}}};
    CHECK(h * a == transpose(a) * h);
    CHECK(row * a == mat<double, 1, 4>{{{(h * a).x, (h * a).y, (h * a).z, (h * a).w}}});
    CHECK(point<double, 3>{h.x, h.y, h.z} * a == transpose(a) * point<double, 3>{h.x, h.y, h.z});
    CHECK(vec<double, 4>{h.x, h.y, h.z, h.w} * a == transpose(a) * vec<double, 4>{h.x, h.y, h.z, h.w});
  }
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

TEST_CASE("determinant: of short integers") {
  CHECK_BOTH(irg::determinant(irg::mat<short, 3, 3>{{{2, 0, 1}, {0, 3, 0}, {1, 0, 4}}}) == 21);
}

TEST_CASE("generate_mat: entries by row and column, of any number type, called once each in order") {
  constexpr auto digits = [](int r, int c) { return 10 * r + c; };
  CHECK_BOTH(irg::generate_mat<int, 2, 3>(digits) == mat<int, 2, 3>{{0, 1, 2}, {10, 11, 12}});
  CHECK_BOTH(irg::generate_mat<rational, 1, 1>([](int, int) { return rational(3); })(0, 0) == rational(3));
  std::vector<int> order;
  static_cast<void>(irg::generate_mat<double, 2, 2>([&](int r, int c) { return order.push_back(2 * r + c), 0.0; }));
  CHECK(order == std::vector{0, 1, 2, 3});
}
