// SPDX-License-Identifier: MIT
#include <irg/math/solve_exact.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <irg/math/exact_matrix.hpp>

#include "math/mixed_cases.hpp"
#include "support/big_rational.hpp"
#include "support/check_both.hpp"
#include "support/exact.hpp"
#include "support/random.hpp"

using irg::mat;
using irg::solve_exact;
using irg::system_status;
using irg::vec;

namespace {

using rows3 = mat<double, 3, 4>;
constexpr double huge = std::numeric_limits<double>::max(), tiny = 0x1p-1074;

}  // namespace

TEST_CASE("solve_exact: the course's exercise 2, and Hank's values") {
  CHECK_BOTH(solve_exact(rows3{{{1, 1, 1, 6}, {-1, -2, 1, -2}, {2, 1, 3, 13}}}).x == vec<double, 3>{1, 2, 3});
  constexpr auto dependent = solve_exact(rows3{{{1, 1, 1, 6}, {2, 2, 2, 12}, {1, -1, 0, 0}}});
  CHECK_BOTH((dependent.status == system_status::dependent && dependent.rank == 2 && !dependent));
  CHECK_BOTH(solve_exact(rows3{{{1, 1, 1, 6}, {2, 2, 2, 13}, {1, -1, 0, 0}}}).status == system_status::inconsistent);
  CHECK_BOTH(solve_exact(rows3{{{2, 1, -1, 8}, {-3, -1, 2, -11}, {-2, 1, 2, -3}}}).x == vec<double, 3>{2, 3, -1});
  CHECK_BOTH(solve_exact(rows3{{{0, 2, 1, 7}, {1, 1, 1, 6}, {2, 0, -1, -1}}}).x == vec<double, 3>{1, 2, 3});
  CHECK_BOTH(solve_exact(mat<float, 3, 3>{{{4, -2, 1}, {-2, 4, -2}, {1, -2, 4}}}, vec<float, 3>{11, -16, 17}).x ==
             vec<float, 3>{1, -2, 3});
  CHECK_BOTH(solve_exact(mat<double, 2, 3>{{{1e-7, 0, 1e-7}, {0, 1e-7, 1e-7}}}).x == vec<double, 2>{1, 1});
}

TEST_CASE("solve_exact: decided for the numbers as they are") {
  // 0.1 + 0.2 is not 0.3 in doubles: the third row is not the sum of the other two.
  constexpr rows3 sum{{{0.1, 1, 2, 1}, {0.2, 3, 4, 2}, {0.3, 4, 6, 3}}};
  CHECK_BOTH(solve_exact(sum).status == system_status::ok);
  CHECK_BOTH(solve_gauss(sum).status == system_status::dependent);  // which rounding makes of it
  // 0.5 + 0.25 is 0.75.
  CHECK_BOTH(solve_exact(rows3{{{0.5, 1, 2, 1}, {0.25, 3, 4, 2}, {0.75, 4, 6, 3}}}).status == system_status::dependent);
  CHECK_BOTH(solve_exact(rows3{{{0.5, 1, 2, 1}, {0.25, 3, 4, 2}, {0.75, 4, 6, 3 + 0x1p-51}}}).status ==
             system_status::inconsistent);
  // Every rank.
  CHECK_BOTH((solve_exact(rows3{}).status == system_status::dependent && solve_exact(rows3{}).rank == 0));
  CHECK_BOTH(solve_exact(rows3{{{0, 0, 0, 0}, {0, 0, 0, tiny}, {}}}).status == system_status::inconsistent);
  constexpr auto one_plane = solve_exact(rows3{{{1, 2, 3, 4}, {2, 4, 6, 8}, {-3, -6, -9, -12}}});
  CHECK_BOTH((one_plane.status == system_status::dependent && one_plane.rank == 1));
  CHECK_BOTH(solve_exact(rows3{{{1, 2, 3, 4}, {2, 4, 6, 8}, {-3, -6, -9, 12}}}).status == system_status::inconsistent);
  CHECK_BOTH(solve_exact(rows3{{{1, 2, 3, 4}, {2, 4, 6, 9}, {1, 0, 0, 1}}}).status == system_status::inconsistent);
}

TEST_CASE("solve_exact: the ends of the range") {
  constexpr double inf = std::numeric_limits<double>::infinity(), none = std::numeric_limits<double>::quiet_NaN();
  CHECK_BOTH(solve_exact(mat<double, 1, 2>{{{3, 1}}}).x[0] == 1.0 / 3);
  CHECK_BOTH(solve_exact(mat<double, 2, 3>{{{huge, 0, huge}, {0, tiny, tiny}}}).x == vec<double, 2>{1, 1});
  CHECK_BOTH(solve_exact(mat<double, 2, 3>{{{huge, huge, huge}, {huge, -huge, huge}}}).x == vec<double, 2>{1, 0});
  CHECK_BOTH(solve_exact(mat<double, 2, 3>{{{tiny, tiny, 0}, {tiny, -tiny, tiny}}}).x == vec<double, 2>{0.5, -0.5});
  CHECK_BOTH(solve_exact(mat<double, 2, 3>{{{huge, tiny, huge}, {tiny, huge, tiny}}}).x == vec<double, 2>{1, 0});
  CHECK_BOTH(solve_exact(mat<double, 1, 2>{{{tiny, 1}}}).status == system_status::not_finite);
  CHECK_BOTH(solve_exact(mat<double, 1, 2>{{{inf, 1}}}).status == system_status::not_finite);
  CHECK_BOTH(solve_exact(mat<double, 2, 3>{{{1, 0, none}, {0, 1, 0}}}).status == system_status::not_finite);
  CHECK_BOTH(solve_exact(mat<float, 1, 2>{{{0x1p-100f, 0x1p100f}}}).status == system_status::not_finite);
  // Ties: half of the smallest number and one and a half of it; half a place beyond the largest, and a bit less.
  CHECK_BOTH(solve_exact(mat<double, 1, 2>{{{2, tiny}}}).x[0] == 0);
  CHECK_BOTH(solve_exact(mat<double, 1, 2>{{{2, 3 * tiny}}}).x[0] == 2 * tiny);
  CHECK_BOTH(solve_exact(mat<double, 2, 3>{{{1, -1, huge}, {0, 1, 0x1p970}}}).status == system_status::not_finite);
  CHECK_BOTH(solve_exact(mat<double, 2, 3>{{{1, -1, huge}, {0, 1, 0x1p970 - 0x1p917}}}).x[0] == huge);
  CHECK_BOTH(solve_exact(mat<double, 2, 3>{{{1, -1, -0x1p53}, {0, 1, -1}}}).x[0] == -0x1p53);
  CHECK_BOTH(solve_exact(mat<double, 2, 3>{{{1, -1, 0x1p53 + 2}, {0, 1, 1}}}).x[0] == 0x1p53 + 4);
  // Within 2^-107 of the middle.
  CHECK_BOTH(solve_exact(mat<double, 2, 3>{{{1, -1, 0x1p53}, {0, 1, 1 + 0x1p-52}}}).x[0] == 0x1p53 + 2);
}

#ifdef IRG_HAVE_MPFR

TEST_CASE("solve_exact: against rationals") {
  using test::big_rational;
  test::random r(6);
  const int count = std::getenv("IRG_RELEASE_TIER") != nullptr ? 300000 : 3000;
  int of_kind[4] = {};
  int wrong = 0;
  for (int i = 0; i < count; ++i) {
    rows3 a{};
    for (auto& row : a.m)
      for (double& entry : row) {
        entry = static_cast<double>(r.integer(-2, 2));
        if (i % 3 == 1) entry = std::ldexp(r.unit() - 0.5, static_cast<int>(r.integer(-1070, 1020)));
      }
    if (i % 3 == 2) {  // the third row the sum of the others, by a lattice of doubles, sometimes an ulp off
      for (int c = 0; c < 4; ++c) {
        for (int k = 0; k < 2; ++k) a(k, c) = std::ldexp(static_cast<double>(r.integer(-(1 << 20), 1 << 20)), -700);
        a(2, c) = a(0, c) * 1024 + a(1, c);
      }
      if (i % 2 == 0) a(2, i % 4) = std::nextafter(a(2, i % 4), HUGE_VAL);
    }
    const auto got = solve_exact(a);
    const auto truth =
        solve_gauss(irg::generate_mat<big_rational, 3, 4>([&](int y, int x) { return big_rational(a(y, x)); }));
    ++of_kind[static_cast<int>(got.status)];
    if (got.status == system_status::not_finite) {
      bool is_large = false;
      for (int k = 0; k < 3; ++k) is_large = is_large || std::fabs(static_cast<double>(truth.x[k])) > huge / 2;
      CHECK(is_large);
      continue;
    }
    CHECK((got.status == truth.status && got.rank == truth.rank));
    for (int k = 0; got && k < 3; ++k) wrong += got.x[k] == test::nearest<double>(truth.x[k]) ? 0 : 1;
  }
  MESSAGE("solve_exact: not the nearest ", wrong, "; unique ", of_kind[0], ", dependent ", of_kind[1],
          ", inconsistent ", of_kind[2], ", too large ", of_kind[3]);
  CHECK(wrong == 0);
  CHECK((of_kind[1] > 10 && of_kind[2] > 10));
}

// The solution of integers times powers of two is undo * b for a matrix of integers and determinant 1: sums of a few
// products that often end in one bit more than a number has.
TEST_CASE_TEMPLATE("solve_exact: ties go to even, also where subnormal numbers and infinity begin", T, double, float) {
  using test::big_rational;
  constexpr int digits = std::numeric_limits<T>::digits, least = std::numeric_limits<T>::min_exponent - digits;
  test::random r(7);
  const int count = test::trials(10'000);
  int wrong = 0, ties = 0, subnormal_ties = 0, too_large = 0;
  for (int i = 0; i < count; ++i) {
    mat<T, 3, 3> a = irg::identity_matrix<T, 3>(), undo = a;
    for (int k = 0; k < 4; ++k) {
      const int from = static_cast<int>(r.integer(0, 2)), to = (from + 1 + k % 2) % 3;
      mat<T, 3, 3> shear = irg::identity_matrix<T, 3>(), back = shear;
      shear(to, from) = static_cast<T>(r.integer(-3, 3));
      back(to, from) = -shear(to, from);
      a = shear * a;
      undo = undo * back;
    }
    const std::int64_t limit = (std::int64_t{1} << (i % 3 == 1 ? r.integer(1, digits) : digits)) - 1;
    vec<T, 3> b{};
    for (int k = 0; k < 3; ++k) b[k] = static_cast<T>(r.integer(-limit, limit));
    if (i % 2 == 0) b[2] = std::ldexp(T(i % 4 - 1), static_cast<int>(-r.integer(1, digits + 30)));  // a bit off a tie
    // the solution's last bit: anywhere, about the smallest number's, or such that it is about the largest
    const int shift = i % 3 == 0   ? static_cast<int>(r.integer(-50, 50))
                      : i % 3 == 1 ? static_cast<int>(least - r.integer(0, 3))
                                   : std::numeric_limits<T>::max_exponent - digits - static_cast<int>(r.integer(0, 3));
    const int of_matrix = -shift / 2;
    // A row times 3 or 5 leaves the solution, but its determinants are no powers of two.
    const vec<T, 3> right = b;
    const T factor = static_cast<T>(2 * (i / 2 % 3) + 1);
    const int changed = i / 6 % 3;
    if (std::fmod(b[changed] * factor, factor) == 0 && b[changed] * factor / factor == b[changed]) {
      b[changed] *= factor;
      for (int c = 0; c < 3; ++c) a(changed, c) *= factor;
    }
    for (auto& row : a.m)
      for (T& entry : row) entry = std::ldexp(entry, of_matrix);
    for (int k = 0; k < 3; ++k) b[k] = std::ldexp(b[k], shift + of_matrix);
    const auto got = solve_exact(a, b);
    bool is_large = false;
    for (int k = 0; k < 3; ++k) {
      big_rational truth = 0;
      for (int j = 0; j < 3; ++j)
        truth = truth + big_rational(static_cast<double>(undo(k, j))) * big_rational(static_cast<double>(right[j]));
      truth = truth.times_power_of_two(shift);
      const T nearest = test::nearest<T>(truth);
      is_large = is_large || std::isinf(nearest);
      if (got && std::isinf(nearest)) ++wrong;
      if (!got || std::isinf(nearest)) continue;
      wrong += got.x[k] == nearest ? 0 : 1;
      const bool is_tie = test::error_in_ulp(nearest, truth) == 0.5;
      ties += is_tie ? 1 : 0;
      subnormal_ties += is_tie && std::fabs(nearest) < std::numeric_limits<T>::min() ? 1 : 0;
    }
    wrong += static_cast<bool>(got) == is_large ? 1 : 0;
    too_large += is_large ? 1 : 0;
  }
  MESSAGE("ties ", ties, ", subnormal ", subnormal_ties, ", too large ", too_large, "; wrong ", wrong);
  CHECK(wrong == 0);
  CHECK((ties > count / 10 && subnormal_ties > count / 20 && too_large > count / 100));
}

namespace {
namespace sweeps {

using namespace test::mixed;

// Exactly, where the sum is wide enough: by Leibniz' formula.
template <int N, class Entry>
void set_determinant(mpfr_ptr out, Entry entry) {
  static test::real product;
  int order[static_cast<std::size_t>(N)];
  for (int i = 0; i < N; ++i) order[i] = i;
  mpfr_set_zero(out, 1);
  do {
    double sign = 1;
    for (int i = 0; i < N; ++i)
      for (int j = 0; j < i; ++j) sign = order[j] > order[i] ? -sign : sign;
    mpfr_set_d(product, sign, MPFR_RNDN);
    for (int i = 0; i < N; ++i) mpfr_mul_d(product, product, static_cast<double>(entry(i, order[i])), MPFR_RNDN);
    mpfr_add(out, out, product, MPFR_RNDN);
  } while (std::next_permutation(order, order + N));
}

// Cramer's rule for the unit vectors and for one more right side.
template <class T, int N>
void sweep_exact_systems(const std::string& type) {
  constexpr int bits = N * (sizeof(T) == 8 ? 2200 : 360) + 200;
  test::real determinant, numerator, quotient;
  for (mpfr_ptr x : {mpfr_ptr(determinant), mpfr_ptr(numerator), mpfr_ptr(quotient)}) mpfr_set_prec(x, bits);
  sweep("determinant_exact, inverse_exact, solve_exact, " + type, 0, [&](test::random& r, sizes which) {
    auto a = irg::generate_mat<T, N, N>([&](int, int) { return number<T>(r, which); });
    if (r.integer(0, 3) == 0)  // a row that is nearly, or exactly, another one times a number
      for (int c = 0; c < N; ++c) a(N - 1, c) = a(0, c) * T(0.75);
    const auto b = vector<T, N>(r, which);
    const auto with_b = irg::generate_mat<T, N, N + 1>([&](int i, int j) { return j == N ? b[i] : a(i, j); });
    set_determinant<N>(determinant, [&](int i, int j) { return a(i, j); });
    const auto undo = inverse_exact(a);
    const auto x = irg::solve_exact(with_b);
    const bool right = determinant_exact(a) == nearest_to<T>(determinant);
    if (!right || determinant_sign(a) != sign_of(determinant)) return 1;
    if (sign_of(determinant) == 0) return undo || x ? 1 : 0;
    bool fits[2]{true, true}, all_right[2]{true, true};
    for (int p = 0; p < N; ++p)
      for (int q = 0; q <= N; ++q) {
        set_determinant<N>(numerator, [&](int i, int j) {
          return j != p ? a(i, j) : q == N ? b[i] : i == q ? T(1) : T(0);
        });
        mpfr_div(quotient, numerator, determinant, MPFR_RNDN);
        const T want = nearest_to<T>(quotient);
        fits[q / N] = fits[q / N] && std::isfinite(want);
        all_right[q / N] = all_right[q / N] && (q == N ? x.x[p] == want : undo && (*undo)(p, q) == want);
      }
    const bool kinds = undo.has_value() == fits[0] && (x.status == irg::system_status::ok) == fits[1];
    return kinds && (all_right[0] || !fits[0]) && (all_right[1] || !fits[1]) ? 0 : 1;
  });
}

TEST_CASE("determinant_exact, inverse_exact, solve_exact: numbers of all sizes") {
  sweep_exact_systems<double, 2>("2 doubles");
  sweep_exact_systems<float, 3>("3 floats");
}

}  // namespace sweeps
}  // namespace

#endif
