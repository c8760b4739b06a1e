// SPDX-License-Identifier: MIT
// Systems and matrices that are well conditioned although their numbers are of all sizes: entries that are negligible
// or zero beside others, rows and columns times powers of two over the whole range of exponents. What matters is that no
// entry, and no scaling, hides a good column: nothing may be refused, nothing wrong.
#include <algorithm>
#include <cmath>
#include <limits>

#include <irg/math/inverse.hpp>
#include <irg/math/lu.hpp>
#include <irg/math/matrix.hpp>
#include <irg/math/solve.hpp>
#include <irg/math/solve_exact.hpp>

#include "support/check_both.hpp"
#include "support/exact.hpp"

using irg::inverse_accurate;
using irg::lu_solve_refined;
using irg::mat;
using irg::solve_gauss;
using irg::system_status;
using irg::vec;

TEST_CASE("mixed systems: a negligible entry hides no good column") {
  constexpr mat<double, 3, 4> hidden{{{2, 1, 1, 1}, {1, 6e-17, 1, 2}, {1, 4e-33, 3, 3}}};  // condition 22.5
  CHECK_BOTH((solve_gauss(hidden).x == vec<double, 3>{1.5, -2.5, 0.5}));
  constexpr mat<double, 3, 4> refused{{{0.7, 1.1, 0.3, 1}, {1.3, 1e-15, 1.7, 2}, {0.9, 1e-300, 2.1, 3}}};  // 14
  constexpr mat<double, 3, 3> matrix{{{0.7, 1.1, 0.3}, {1.3, 1e-15, 1.7}, {0.9, 1e-300, 2.1}}};
  CHECK_BOTH(solve_gauss(refused).status == system_status::ok);
  CHECK_BOTH(*lu_solve_refined(matrix, vec<double, 3>{1, 2, 3}) == irg::solve_exact(refused).x);
  CHECK_BOTH(inverse_accurate(matrix).has_value());
  // A component that is small only as the columns are: in units of its own it is as good as the other one.
  constexpr mat<double, 2, 3> two{{{1, 2, 1}, {0, 1, 0x1p-1000}}};
  CHECK_BOTH(solve_gauss(two).x == vec<double, 2>{1, 0x1p-1000});
  CHECK_BOTH(*lu_solve_refined(mat<double, 2, 2>{{{1, 2}, {0, 1}}}, vec<double, 2>{1, 0x1p-1000}) ==
             vec<double, 2>{1, 0x1p-1000});
  // A triangle's inverse has zeros, and one entry far below the others.
  constexpr mat<double, 3, 3> triangle{{{1, 3, 0x1p-900}, {0, 7, 0x1p-900}, {0, 0, 0x1p-900}}};
  constexpr auto back = *inverse_accurate(triangle);
  CHECK_BOTH((back(1, 0) == 0 && back(2, 0) == 0 && back(2, 1) == 0 && back(2, 2) == 0x1p900));
}

#ifdef IRG_HAVE_MPFR

namespace {

using test::big_rational;

// b_ij * 2^(row_i + column_j), and on the right b_i * 2^row_i: b is of condition 1 to 10^12 and has entries of all sizes
// below 1, the powers are of any size. Where numbers underflow b is what is left of them.
template <class T, int N>
struct mixed_system {
  mat<T, N, N> a{};
  vec<T, N> b{};
  int row[static_cast<unsigned>(N)]{}, column[static_cast<unsigned>(N)]{};

  mixed_system(test::random& r, int kind) {
    constexpr bool is_double = sizeof(T) == 8;
    const int span = kind % 2 == 0 ? 0 : is_double ? 480 : 40, depth = is_double ? 996 : 100;
    const auto number = [&](std::int64_t rare) {
      const double x = 2 * r.unit() - 1;
      const auto fate = r.integer(0, 3 * rare);
      return fate == 0 ? 0 : fate < rare ? std::ldexp(x, -static_cast<int>(r.integer(0, depth))) : x;
    };
    for (int i = 0; i < N; ++i) row[i] = static_cast<int>(r.integer(-span, span));
    for (int i = 0; i < N; ++i) column[i] = static_cast<int>(r.integer(-span, span));
    double exact[static_cast<unsigned>(N)][static_cast<unsigned>(N)];
    for (auto& line : exact)
      for (double& entry : line) entry = number(1 + kind % 3);
    if (kind % 5 == 4) {  // a row near another one
      const double step = std::ldexp(1.0, -static_cast<int>(r.integer(1, is_double ? 38 : 16)));
      for (int c = 0; c < N; ++c)
        exact[N - 1][c] = static_cast<double>(static_cast<T>(exact[0][c] + step * exact[N - 1][c]));
    }
    for (int i = 0; i < N; ++i) {
      for (int j = 0; j < N; ++j) a(i, j) = static_cast<T>(std::ldexp(exact[i][j], row[i] + column[j]));
      b[i] = static_cast<T>(std::ldexp(number(kind % 7 == 0 ? 1 : 100), row[i]));
    }
  }
  mat<big_rational, N, N> exact() const {
    return irg::generate_mat<big_rational, N, N>([&](int i, int j) {
      return big_rational(static_cast<double>(a(i, j))).times_power_of_two(-row[i] - column[j]);
    });
  }
  big_rational exact_right(int i) const { return big_rational(static_cast<double>(b[i])).times_power_of_two(-row[i]); }
};

template <int N>
double norm_of(const mat<big_rational, N, N>& a) {
  return irg::norm_1(irg::generate_mat<double, N, N>([&](int i, int j) { return a(i, j).rounded(); }));
}

// What the runs found. Errors of solve_gauss are in units of u times the condition times the largest component, u of
// double; those of the others in ulp, of entries that are no less than 2^-8 of the largest.
struct tally {
  int tested = 0, refused = 0, wrong = 0;
  double gauss = 0, refined = 0, inverted = 0;
};

template <class T, int N>
void judge(const mixed_system<T, N>& s, tally& t) {
  constexpr double unit = static_cast<double>(std::numeric_limits<T>::epsilon()) / 2;
  const auto exact = s.exact();
  const auto undo = inverse(exact);
  if (!undo) return;
  const double condition = norm_of(exact) * norm_of(*undo);
  if (!(condition < 1e12)) return;
  ++t.tested;
  big_rational x[static_cast<unsigned>(N)];
  double largest = 0;
  for (int i = 0; i < N; ++i) {
    x[i] = 0;
    for (int j = 0; j < N; ++j) x[i] = x[i] + (*undo)(i, j) * s.exact_right(j);
    largest = std::fmax(largest, std::fabs(x[i].rounded()));
  }
  const auto solution = solve_gauss(s.a, s.b);
  const auto refined = lu_solve_refined(s.a, s.b);
  const auto inverted = inverse_accurate(s.a);
  const auto plain = inverse(s.a);
  bool fits = true, inverse_fits = true;
  for (int i = 0; i < N; ++i) {
    const big_rational truth = x[i].times_power_of_two(-s.column[i]);
    fits = fits && std::isfinite(test::nearest<T>(truth));
    if (solution) {
      const big_rational got = big_rational(static_cast<double>(solution.x[i])).times_power_of_two(s.column[i]);
      const double off = std::fabs((got - x[i]).rounded()) - unit * std::fabs(x[i].rounded()) -
                         std::ldexp(static_cast<double>(std::numeric_limits<T>::denorm_min()), s.column[i]);
      if (off > 0) t.gauss = std::fmax(t.gauss, off * 0x1p53 / condition / largest);
    }
    if (refined && std::fabs(x[i].rounded()) >= largest * 0x1p-8)
      t.refined = std::fmax(t.refined, test::error_in_ulp((*refined)[i], truth));
  }
  for (int j = 0; j < N; ++j) {
    double largest_of_column = 0;
    for (int i = 0; i < N; ++i) largest_of_column = std::fmax(largest_of_column, std::fabs((*undo)(i, j).rounded()));
    for (int i = 0; i < N; ++i) {
      const big_rational truth = (*undo)(i, j).times_power_of_two(-s.column[i] - s.row[j]);
      inverse_fits = inverse_fits && std::isfinite(test::nearest<T>(truth));
      if (inverted && std::fabs((*undo)(i, j).rounded()) >= largest_of_column * 0x1p-8)
        t.inverted = std::fmax(t.inverted, test::error_in_ulp((*inverted)(i, j), truth));
    }
  }
  t.wrong += (solution && !fits) || (refined && !fits) || (inverted && !inverse_fits) ? 1 : 0;
  t.refused += (!solution && fits) || (!refined && fits) || (!inverted && inverse_fits) ? 1 : 0;
  t.refused += !plain && inverse_fits && condition < 1e-4 / unit ? 1 : 0;
}

template <class T, int N>
tally judge_many(int count, int kinds) {
  test::random r(40 + N);
  tally t;
  for (int i = 0; i < count; ++i) judge(mixed_system<T, N>(r, kinds * i), t);
  MESSAGE(N, " unknowns, ", t.tested, " systems: refused ", t.refused, ", wrong ", t.wrong, "; errors: solve_gauss ",
          t.gauss, " u*condition, refined ", t.refined, " ulp, inverse_accurate ", t.inverted, " ulp");
  return t;
}

void check(const tally& t) {
  CHECK((t.refused == 0 && t.wrong == 0));
  CHECK(t.gauss <= 8);
  CHECK(t.refined <= 0.51);
  CHECK(t.inverted <= 0.51);
}

}  // namespace

TEST_CASE_TEMPLATE("mixed systems: none refused, none wrong, against rationals", T, double, float) {
  const int count = test::trials(3000);
  check(judge_many<T, 2>(count, 1));
  check(judge_many<T, 3>(count, 1));
  check(judge_many<T, 4>(count, 1));
  check(judge_many<T, 5>(count / 10, 2));  // rows and columns as they are
}

#endif

// Small integers, one row made of two others, rows and columns times powers of two: no solution may come out, and the
// kind and the rank are those of the numbers as they are.
TEST_CASE_TEMPLATE("mixed systems: singular ones are told apart", T, double, float) {
  const auto run = []<int N>(std::integral_constant<int, N>) {
    test::random r(60 + N);
    int singular = 0, inconsistent = 0, wrong = 0;
    for (int i = test::trials(2000); i > 0; --i) {
      mat<T, N, N + 1> a{};
      for (int y = 0; y < N - 1; ++y)
        for (int x = 0; x <= N; ++x) a(y, x) = static_cast<T>(r.integer(0, 3) == 0 ? 0 : r.integer(-9, 9));
      const auto p = static_cast<T>(r.integer(-3, 3)), q = static_cast<T>(r.integer(-3, 3));
      for (int x = 0; x <= N; ++x) a(N - 1, x) = p * a(0, x) + q * a(N - 2, x);
      if (i % 2 == 0) a(N - 1, N) += static_cast<T>(r.integer(-2, 2));
      irg::detail::swap_rows(a, static_cast<int>(r.integer(0, N - 1)), N - 1, N + 1);
      const int span = i % 3 == 0 ? 0 : sizeof(T) == 8 ? 400 : 40;
      for (int k = 0; k < N; ++k) {
        const auto row = static_cast<int>(r.integer(-span, span)), column = static_cast<int>(r.integer(-span, span));
        for (int x = 0; x <= N; ++x) a(k, x) = std::ldexp(a(k, x), row);
        for (int y = 0; y < N; ++y) a(y, k) = std::ldexp(a(y, k), column);
      }
      const auto left = irg::generate_mat<T, N, N>([&](int y, int x) { return a(y, x); });
      const auto right = irg::generate_coordinates<vec<T, N>>([&](int y) { return a(y, N); });
      const auto exact = irg::solve_exact(a), got = solve_gauss(a);
      wrong += got.status != exact.status || got.rank != exact.rank || lu_solve_refined(left, right) ||
               inverse_accurate(left);
      singular += exact ? 0 : 1;
      inconsistent += exact.status == system_status::inconsistent ? 1 : 0;
    }
    CHECK(wrong == 0);
    CHECK((singular == test::trials(2000) && inconsistent > singular / 10));
  };
  run(std::integral_constant<int, 2>{});
  run(std::integral_constant<int, 3>{});
  run(std::integral_constant<int, 4>{});
}

// Systems of integers times 0.1, by tenths or by sevenths: every number is rounded, so that the determinants of what is
// stored tell nothing, and kind and rank must be those of the integers. What has zeros in any pattern is told apart as
// surely as what has none, whatever powers of two rows and columns are multiplied by.
TEST_CASE("mixed systems: tenths are told apart as rounding has it") {
  // Of the issue: four zeros or more.
  CHECK_BOTH(solve_gauss(mat<double, 3, 4>{{{.1, 0, 0, .7}, {0, 1, 0, 1}, {.3, 0, 0, 2.1}}}).status ==
             system_status::dependent);
  CHECK_BOTH(solve_gauss(mat<double, 3, 4>{{{.7, 0, .4, -1.5}, {0, 0, 0, 0}, {2.1, 0, 1.2, -4.5}}}).rank == 1);
  CHECK_BOTH(solve_gauss(mat<double, 3, 4>{{{.1, 0, 0, .7}, {0, 1, 0, 1}, {.3, 0, 0, 2.2}}}).status ==
             system_status::inconsistent);
  CHECK_BOTH(solve_gauss(mat<double, 5, 6>{{{.1, 0, 0, 0, 0, .7}, {0, 1, 0, 0, 0, 1}, {.3, 0, 0, 0, 0, 2.1}}}).rank ==
             2);
}

namespace {

// The number of independent rows of N rows of integers, `columns` of each, modulo a prime number below 2^31.
template <int N>
int rank_modulo(mat<std::int64_t, N, N + 1> a, int columns, std::int64_t prime) {
  for (auto& row : a.m)
    for (std::int64_t& entry : row) entry = (entry % prime + prime) % prime;
  int rank = 0;
  for (int c = 0; c < columns && rank < N; ++c) {
    int pivot = rank;
    while (pivot < N && a(pivot, c) == 0) ++pivot;
    if (pivot == N) continue;
    irg::detail::swap_rows(a, rank, pivot, N + 1);
    for (int r = rank + 1; r < N; ++r) {
      const std::int64_t f = a(r, c), g = a(rank, c);
      for (int x = c; x < columns; ++x) a(r, x) = ((a(r, x) * g - a(rank, x) * f) % prime + prime) % prime;
    }
    ++rank;
  }
  return rank;
}

// The rank itself: minors of the systems below are less than the product of two primes.
template <int N>
int rank_of(const mat<std::int64_t, N, N + 1>& a, int columns) {
  const int first = rank_modulo(a, columns, 2147483647), second = rank_modulo(a, columns, 2147483629);
  return first < second ? second : first;
}

// N equations with integers: any; of a low rank; with rows that are zero, a unit's, or another's multiple; of blocks.
template <int N>
mat<std::int64_t, N, N + 1> integer_system(test::random& r) {
  mat<std::int64_t, N, N + 1> a{};
  const std::int64_t zeros = r.integer(0, 4), kind = r.integer(0, 4), right = r.integer(0, 3);
  const auto number = [&](std::int64_t limit) { return r.integer(0, 4) < zeros ? 0 : r.integer(-limit, limit); };
  const std::int64_t limit = kind == 0 && r.integer(0, 3) == 0 ? 99 : 9;
  const auto copy_row = [&](int to, int from, std::int64_t f) {
    for (int x = 0; x < N; ++x) a(to, x) = f * a(from, x);
  };
  const auto any = [&](int count) { return static_cast<int>(r.integer(0, count - 1)); };
  const int terms = any(N + 1), cut_row = any(N + 1), cut_column = any(N + 1);
  for (int y = 0; y < N; ++y) {
    const std::int64_t fate = r.integer(0, 3);
    for (int x = 0; x < N; ++x) a(y, x) = kind == 1 || kind == 2 || (kind == 3 && fate < 2) ? 0 : number(limit);
    if (kind == 3 && fate == 1) a(y, any(N)) = r.integer(1, 9);
    if (kind == 3 && fate == 2 && y > 0) copy_row(y, any(y), r.integer(-3, 3));
    for (int x = 0; kind == 4 && y >= cut_row && x < cut_column; ++x) a(y, x) = 0;
  }
  for (int k = 0; (kind == 1 || kind == 2) && k < terms; ++k) {
    std::int64_t u[static_cast<unsigned>(N)], v[static_cast<unsigned>(N)];
    for (int i = 0; i < N; ++i) u[i] = number(3), v[i] = number(kind == 1 ? 9 : 3);
    for (int y = 0; y < N; ++y)
      for (int x = 0; x < N; ++x) a(y, x) += u[y] * v[x];
  }
  if (kind == 4) copy_row(any(N), any(N), r.integer(1, 3));
  for (int x = 0; x < N; ++x) {
    const std::int64_t component = r.integer(-5, 5);
    for (int y = 0; y < N; ++y) a(y, N) += component * a(y, x);
  }
  if (right == 0) a(any(N), N) += r.integer(-2, 2);
  if (right == 1)
    for (int y = 0; y < N; ++y) a(y, N) = number(9);
  return a;
}

}  // namespace

TEST_CASE("mixed systems: integers times 0.1 with zeros anywhere, against ranks modulo primes") {
  const auto run = []<int N>(std::integral_constant<int, N>) {
    test::random r(80 + N);
    int singular = 0, inconsistent = 0, wrong = 0;
    const int count = test::many_trials(200);
    for (int i = 0; i < count; ++i) {
      const auto whole = integer_system<N>(r);
      const int rank = rank_of<N>(whole, N);
      const system_status kind = rank == N                         ? system_status::ok
                                 : rank_of<N>(whole, N + 1) > rank ? system_status::inconsistent
                                                                   : system_status::dependent;
      auto a = irg::generate_mat<double, N, N + 1>([&](int y, int x) {
        const auto entry = static_cast<double>(whole(y, x));
        return i % 3 == 0 ? entry * 0.1 : i % 3 == 1 ? entry / 10 : entry / 7;
      });
      const int span = i % 2 == 0 ? 0 : 200;
      for (int k = 0; k < N; ++k) {
        const auto row = static_cast<int>(r.integer(-span, span)), column = static_cast<int>(r.integer(-span, span));
        for (int x = 0; x <= N; ++x) a(k, x) = std::ldexp(a(k, x), row);
        for (int y = 0; y < N; ++y) a(y, k) = std::ldexp(a(y, k), column);
      }
      const auto got = solve_gauss(a);
      wrong += got.status != kind || got.rank != rank ? 1 : 0;
      const auto square = irg::generate_mat<double, N, N>([&](int y, int x) { return a(y, x); });
      const auto right = irg::generate_coordinates<vec<double, N>>([&](int y) { return a(y, N); });
      if (rank < N) wrong += lu_solve_refined(square, right) || inverse_accurate(square) ? 1 : 0;
      if (N >= 5 && i % 8 < 2) {  // the same at run-time sizes
        irg::matrix<double> left(N, N), b(N, 1);
        for (int y = 0; y < N; ++y)
          for (int x = 0; x <= N; ++x) (x < N ? left(y, x) : b(y, 0)) = a(y, x);
        const auto dynamic = solve(left, b);
        wrong += static_cast<bool>(dynamic) != (kind == system_status::ok) ||
                 (!dynamic && dynamic.error() != (kind == system_status::dependent ? irg::matrix_error::dependent
                                                                                   : irg::matrix_error::inconsistent));
      }
      singular += rank < N ? 1 : 0;
      inconsistent += kind == system_status::inconsistent ? 1 : 0;
    }
    CHECK_MESSAGE(wrong == 0, N << " unknowns: " << wrong << " of " << count);
    CHECK((singular > count / 3 && singular < count * 9 / 10 && inconsistent > count / 10));
  };
  run(std::integral_constant<int, 2>{});
  run(std::integral_constant<int, 3>{});
  run(std::integral_constant<int, 4>{});
  run(std::integral_constant<int, 5>{});
  run(std::integral_constant<int, 6>{});
}
