// SPDX-License-Identifier: MIT
#include <irg/math/solve.hpp>

#include <cmath>
#include <limits>

#include <irg/math/lu.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

using irg::mat;
using irg::solve_gauss;
using irg::system_status;
using irg::vec;
using test::rational;

namespace {

template <class T>
using rows3 = mat<T, 3, 4>;

constexpr double inf = std::numeric_limits<double>::infinity(), none = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("solve_gauss: what comes out is a value") {
  using R = rational;
  CHECK_BOTH(solve_gauss(mat<R, 2, 3>{{{2, 0, 6}, {0, 1, 4}}}) == solve_gauss(mat<R, 2, 3>{{{1, 0, 3}, {0, 1, 4}}}));
  CHECK_BOTH(solve_gauss(mat<R, 2, 3>{{{2, 0, 6}, {0, 1, 4}}}) != solve_gauss(mat<R, 2, 3>{{{1, 0, 3}, {0, 1, 5}}}));
}

TEST_CASE("solve_gauss: the course's exercise 2, and Hank's values") {
  using R = rational;
  constexpr auto course = solve_gauss(rows3<R>{{{1, 1, 1, 6}, {-1, -2, 1, -2}, {2, 1, 3, 13}}});
  CHECK_BOTH((course && course.rank == 3 && course.x == vec<R, 3>{1, 2, 3}));
  CHECK_BOTH(solve_gauss(rows3<R>{{{1, 1, 1, 6}, {2, 2, 2, 12}, {1, -1, 0, 0}}}).status == system_status::dependent);
  CHECK_BOTH(solve_gauss(rows3<R>{{{1, 1, 1, 6}, {2, 2, 2, 13}, {1, -1, 0, 0}}}).status == system_status::inconsistent);
  CHECK_BOTH(solve_gauss(rows3<R>{{{2, 1, -1, 8}, {-3, -1, 2, -11}, {-2, 1, 2, -3}}}).x == vec<R, 3>{2, 3, -1});
  CHECK_BOTH(solve_gauss(rows3<R>{{{0, 2, 1, 7}, {1, 1, 1, 6}, {2, 0, -1, -1}}}).x == vec<R, 3>{1, 2, 3});
  CHECK_BOTH(solve_gauss(rows3<R>{{{4, -2, 1, 11}, {-2, 4, -2, -16}, {1, -2, 4, 17}}}).x == vec<R, 3>{1, -2, 3});
  CHECK_BOTH(solve_gauss(mat<R, 2, 3>{{{1, 2, 3}, {2, 4, 6}}}).status == system_status::dependent);
  CHECK_BOTH(solve_gauss(mat<R, 2, 3>{{{1, 2, 3}, {2, 4, 6}}}).rank == 1);
  // The same in floats.
  CHECK_BOTH(solve_gauss(rows3<double>{{{1, 1, 1, 6}, {2, 2, 2, 12}, {1, -1, 0, 0}}}).status ==
             system_status::dependent);
  CHECK_BOTH(solve_gauss(rows3<float>{{{1, 1, 1, 6}, {2, 2, 2, 13}, {1, -1, 0, 0}}}).status ==
             system_status::inconsistent);
  CHECK_BOTH(solve_gauss(rows3<double>{{{0, 2, 1, 7}, {1, 1, 1, 6}, {2, 0, -1, -1}}}).x == vec<double, 3>{1, 2, 3});
  CHECK_BOTH(solve_gauss(mat<float, 2, 2>{{{1, 2}, {3, 4}}}, vec<float, 2>{5, 11}).x == vec<float, 2>{1, 2});
}

TEST_CASE("solve_gauss: the printed order of the pivots does not matter, nor does size") {
  // Small is not singular.
  CHECK_BOTH(solve_gauss(mat<double, 2, 3>{{{1e-7, 0, 1e-7}, {0, 1e-7, 1e-7}}}).x == vec<double, 2>{1, 1});
  CHECK_BOTH(solve_gauss(mat<double, 2, 3>{{{0x1p-1070, 0, 0x1p-1070}, {0, 0x1p1000, 0x1p1001}}}).x ==
             vec<double, 2>{1, 2});
  CHECK_BOTH(solve_gauss(mat<double, 2, 3>{{{0x1p-1000, 0x1p20, 0x1p20}, {0x1p-1000, 0x1p1000, 0x1p1000}}}).x ==
             vec<double, 2>{0, 1});
  CHECK_BOTH(solve_gauss(mat<double, 1, 2>{{{4, 2}}}).x[0] == 0.5);
  // Scaled by any powers of two, dependent stays dependent.
  test::random r(2);
  for (int i = 0; i < 1000; ++i) {
    mat<double, 3, 4> a{};
    for (int c = 0; c < 4; ++c) {
      a(0, c) = static_cast<double>(r.integer(-9, 9));
      a(1, c) = static_cast<double>(r.integer(-9, 9));
      a(2, c) = 3 * a(0, c) - 7 * a(1, c);
    }
    for (int k = 0; k < 3; ++k) {
      const int power = static_cast<int>(r.integer(-200, 200));
      for (int c = 0; c < 4; ++c) a(k, c) = std::ldexp(a(k, c), power);
      const int column_power = static_cast<int>(r.integer(-200, 200));
      for (int row = 0; row < 3; ++row) a(row, k) = std::ldexp(a(row, k), column_power);
    }
    const auto s = solve_gauss(a);
    if (s.rank < 2) continue;  // the first two rows happen to be proportional
    CHECK(s.status == system_status::dependent);
    if (a(2, 3) == 0) continue;
    a(2, 3) *= 1.25;
    CHECK(solve_gauss(a).status == system_status::inconsistent);
  }
}

TEST_CASE("solve_gauss: degenerate and hostile") {
  CHECK_BOTH(solve_gauss(mat<double, 2, 3>{}).status == system_status::dependent);
  CHECK_BOTH(solve_gauss(mat<double, 2, 3>{{{0, 0, 1}, {0, 0, 0}}}).status == system_status::inconsistent);
  CHECK_BOTH(solve_gauss(mat<double, 2, 3>{{{1, 0, 1}, {0, 0, 0x1p-1074}}}).status == system_status::inconsistent);
  CHECK_BOTH(solve_gauss(mat<double, 2, 3>{{{none, 0, 1}, {0, 1, 0}}}).status == system_status::not_finite);
  CHECK_BOTH(solve_gauss(mat<double, 2, 3>{{{1, 0, 1}, {0, 1, inf}}}).status == system_status::not_finite);
  CHECK_BOTH(solve_gauss(mat<double, 1, 2>{{{0x1p-1074, 1}}}).status == system_status::not_finite);  // 2^1074
  CHECK_BOTH(solve_gauss(mat<float, 1, 2>{{{0x1p-100f, 0x1p100f}}}).status == system_status::not_finite);
  CHECK_BOTH(solve_gauss(mat<double, 1, 2>{{{0x1p1023, 0x1p-51}}}).x[0] == 0x1p-1074);
  CHECK_BOTH(solve_gauss(mat<double, 1, 2>{{{0x1p1023, 0x1p-52}}}).x[0] == 0);
}

TEST_CASE("solve_gauss: rationals, any size") {
  test::random r(1);
  int singular = 0;
  for (int i = 0; i < 500; ++i) {
    mat<rational, 4, 5> a{};
    for (auto& row : a.m)
      for (rational& entry : row) entry = r.integer(-2, 2);
    mat<rational, 4, 4> left{};
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 4; ++x) left(y, x) = a(y, x);
    const auto s = solve_gauss(a);
    CHECK(static_cast<bool>(s) == (determinant(left) != rational(0)));
    singular += s ? 0 : 1;
    for (int y = 0; s && y < 4; ++y) {
      rational sum = 0;
      for (int x = 0; x < 4; ++x) sum = sum + a(y, x) * s.x[x];
      CHECK(sum == a(y, 4));
    }
    const auto f =
        solve_gauss(irg::generate_mat<double, 4, 5>([&](int y, int x) { return static_cast<double>(a(y, x)); }));
    CHECK((f.status == s.status && f.rank == s.rank));
  }
  CHECK(singular > 20);
}

TEST_CASE("back_substitution: Hank's values") {
  using R = rational;
  constexpr mat<R, 2, 3> triangle{{{1, 2, 5}, {0, 3, 6}}};
  CHECK_BOTH(back_substitution(triangle) == vec<R, 2>{1, 2});
}
