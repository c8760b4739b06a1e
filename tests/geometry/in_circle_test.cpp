// SPDX-License-Identifier: MIT
#include <irg/geometry/in_circle.hpp>

#include <array>
#include <cstdint>
#include <limits>

#include <irg/geometry/orient3d.hpp>

#include "support/check_both.hpp"
#include "support/predicate_trials.hpp"
#include "support/rational.hpp"

using irg::in_circle;
using irg::in_sphere;

namespace {

using P = irg::point<double, 2>;
using Q = irg::point<double, 3>;
using I = irg::point<std::int64_t, 2>;
using J = irg::point<std::int64_t, 3>;
constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
constexpr std::int64_t low = std::numeric_limits<std::int64_t>::min(), high = std::numeric_limits<std::int64_t>::max();

struct circle {
  static constexpr int points = 4, size = 2, stages = 5;
  static constexpr test::figure shape = test::figure::round;
  template <class T>
  static constexpr int whole(const std::array<T, 4>& p) {
    return in_circle(p[0], p[1], p[2], p[3]);
  }
  static constexpr bool stage(int i, const irg::detail::point_table<double, 4, 2>& t, int& sign) {
    if (i == 0) return (sign = irg::detail::filtered_sign(t, 0x1p-240)) != 0;
    if (i == 1) return irg::detail::sign_by_words(t, sign);
    if (i == 2) return irg::detail::sign_by_double_words(t, sign);
    if (i == 3) return irg::detail::sign_by_range(t, sign);
    sign = irg::detail::sign_by_sum(t);
    return true;
  }
};
struct sphere {
  static constexpr int points = 5, size = 3, stages = 5;
  static constexpr test::figure shape = test::figure::round;
  template <class T>
  static constexpr int whole(const std::array<T, 5>& p) {
    return in_sphere(p[0], p[1], p[2], p[3], p[4]);
  }
  static constexpr bool stage(int i, const irg::detail::point_table<double, 5, 3>& t, int& sign) {
    if (i == 0) return (sign = irg::detail::filtered_sign(t, 0x1p-192)) != 0;
    if (i == 1) return irg::detail::sign_by_words(t, sign);
    if (i == 2) return irg::detail::sign_by_double_words(t, sign);
    if (i == 3) return irg::detail::sign_by_range(t, sign);
    sign = irg::detail::sign_by_sum(t);
    return true;
  }
};

// The number of the first stage that decides, and that it decides as it should.
template <class Predicate, class T>
constexpr int stage_of(const std::array<T, static_cast<std::size_t>(Predicate::points)>& p, int expected) {
  irg::detail::point_table<double, Predicate::points, Predicate::size> t{};
  for (int i = 0; i < Predicate::points * Predicate::size; ++i)
    t.v[i] = p[static_cast<std::size_t>(i / Predicate::size)][i % Predicate::size];
  for (int i = 0; i < Predicate::stages; ++i) {
    int sign = 0;
    if (Predicate::stage(i, t, sign)) return sign == expected && Predicate::whole(p) == expected ? i : -1;
  }
  return -1;
}
constexpr int circle_stage(const std::array<P, 4>& p, int expected) { return stage_of<circle>(p, expected); }
constexpr int sphere_stage(const std::array<Q, 5>& p, int expected) { return stage_of<sphere>(p, expected); }

}  // namespace

TEST_CASE("in_circle: inside, outside, on it") {
  constexpr P a{1, 0}, b{0, 1}, c{-1, 0};
  CHECK_BOTH(in_circle(a, b, c, P{0, 0}) == 1);
  CHECK_BOTH(in_circle(a, b, c, P{0, -1}) == 0);
  CHECK_BOTH(in_circle(a, b, c, P{1, 1}) == -1);
  CHECK_BOTH(in_circle(c, b, a, P{0, 0}) == -1);
  CHECK_BOTH(in_circle(a, b, c, P{0, -1.0000000000000002}) == -1);
  CHECK_BOTH(in_circle(a, b, c, P{least, 0}) == 1);
  CHECK_BOTH(in_circle(a, b, c, b) == 0);
  using F = std::array<float, 2>;
  CHECK_BOTH(in_circle(F{3, 4}, F{-4, 3}, F{-5, 0}, F{0, -5}) == 0);
  CHECK_BOTH(in_circle(F{3, 4}, F{-4, 3}, F{-5, 0}, F{0, -4.9999995f}) == 1);
  static_assert(noexcept(in_circle(a, b, c, a)));
}

TEST_CASE("in_circle: three points on a line") {
  constexpr P a{0, 0}, b{1, 0}, c{3, 0};
  CHECK_BOTH(in_circle(a, b, c, P{2, 0}) == 0);
  CHECK_BOTH(in_circle(a, b, c, P{2, 1}) == -in_circle(a, b, c, P{2, -1}));
  CHECK_BOTH(in_circle(a, b, c, P{2, 1}) != 0);
  CHECK_BOTH(in_circle(a, a, c, P{2, 1}) == 0);
}

TEST_CASE("in_sphere: inside, outside, on it") {
  constexpr Q a{1, 0, 0}, b{0, 1, 0}, c{-1, 0, 0}, d{0, 0, 1};
  static_assert(irg::orient3d(a, b, c, d) == 1);
  CHECK_BOTH(in_sphere(a, b, c, d, Q{0, 0, 0}) == 1);
  CHECK_BOTH(in_sphere(a, b, c, d, Q{0, 0, -1}) == 0);
  CHECK_BOTH(in_sphere(a, b, c, d, Q{1, 1, 1}) == -1);
  CHECK_BOTH(in_sphere(a, c, b, d, Q{0, 0, 0}) == -1);
  CHECK_BOTH(in_sphere(a, b, c, d, Q{0, 0, -1.0000000000000002}) == -1);
  CHECK_BOTH(in_sphere(a, b, c, d, c) == 0);
  using F = std::array<float, 3>;
  CHECK_BOTH(in_sphere(F{1, 2, 2}, F{-2, 2, 1}, F{-2, -1, 2}, F{2, -2, 1}, F{0, -3, 0}) == 0);
}

TEST_CASE("in_circle, in_sphere: the ends of the range of doubles") {
  CHECK_BOTH(in_circle(P{least, 0}, P{0, least}, P{-least, 0}, P{0, 0}) == 1);
  CHECK_BOTH(in_circle(P{least, 0}, P{0, least}, P{-least, 0}, P{0, -least}) == 0);
  CHECK_BOTH(in_circle(P{most, 0}, P{0, most}, P{-most, 0}, P{0, -most}) == 0);
  CHECK_BOTH(in_circle(P{most, 0}, P{0, most}, P{-most, 0}, P{least, -most}) == -1);
  CHECK_BOTH(in_circle(P{most, -most}, P{most, most}, P{-most, most}, P{-most, -most}) == 0);
  CHECK(in_sphere(Q{least, 0, 0}, Q{0, least, 0}, Q{-least, 0, 0}, Q{0, 0, least}, Q{0, 0, 0}) == 1);
  CHECK(in_sphere(Q{most, 0, 0}, Q{0, most, 0}, Q{-most, 0, 0}, Q{0, 0, most}, Q{0, 0, -most}) == 0);
  CHECK(in_sphere(Q{most, 0, 0}, Q{0, most, 0}, Q{-most, 0, 0}, Q{0, 0, most}, Q{least, 0, -most}) == -1);
}

TEST_CASE("in_circle, in_sphere: each stage decides what it is for") {
  constexpr double u = 0x1p-53;
  CHECK_BOTH(circle_stage({P{1, 0}, {0, 1}, {-1, 0}, {0, 0}}, 1) == 0);
  CHECK_BOTH(circle_stage({P{24, 0.5}, {24, 12}, {0.5, 12}, {0.5, 0.5}}, 0) == 1);
  CHECK_BOTH(circle_stage({P{24, 0.5}, {24, 12}, {0.5, 12}, {0.5 + u, 0.5}}, 1) == 1);
  CHECK_BOTH(circle_stage({P{0x1p60, 0}, {0x1p60, 1}, {0, 1}, {0, 0}}, 0) == 1);
  CHECK_BOTH(circle_stage({P{0x1p61, 0}, {0x1p61, 1}, {0, 1}, {0, 0}}, 0) == 2);
  CHECK_BOTH(circle_stage({P{0x1p124, 0}, {0x1p124, 1}, {0, 1}, {0, 0}}, 0) == 2);
  CHECK_BOTH(circle_stage({P{0x1p125, 0}, {0x1p125, 1}, {0, 1}, {0, 0}}, 0) == 4);
  CHECK_BOTH(circle_stage({P{0x1p200, 0x1p200}, {1, 2}, {1, 1}, {0, 0}}, -1) == 3);
  CHECK_BOTH(sphere_stage({Q{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 0, 0}}, 1) == 0);
  CHECK_BOTH(sphere_stage({Q{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 0, -1}}, 0) == 1);
  CHECK_BOTH(sphere_stage({Q{0x1p60, 0, 0}, {0x1p60, 1, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}, 0) == 1);
  CHECK_BOTH(sphere_stage({Q{0x1p61, 0, 0}, {0x1p61, 1, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}, 0) == 2);
  CHECK_BOTH(sphere_stage({Q{0x1p124, 0, 0}, {0x1p124, 1, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}, 0) == 2);
  CHECK_BOTH(sphere_stage({Q{0x1p200, 0x1p200, 0}, {1, 2, 0}, {0, 0, 1}, {1, 1, 1}, {0, 0, 0}}, 1) == 3);
  CHECK(sphere_stage({Q{0x1p125, 0, 0}, {0x1p125, 1, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}, 0) == 4);
}

TEST_CASE("in_circle, in_sphere: integers and rationals, exactly") {
  CHECK_BOTH(in_circle(I{high, low}, I{high, high}, I{low, high}, I{low, low}) == 0);
  CHECK_BOTH(in_circle(I{high, low}, I{high, high}, I{low, high}, I{low + 1, low}) == 1);
  CHECK_BOTH(in_circle(I{high, low}, I{high, high}, I{low, high}, I{0, 0}) == 1);
  CHECK_BOTH(in_sphere(J{high, low, low}, J{high, high, low}, J{low, high, low}, J{low, low, high}, J{low, low, low}) ==
             0);
  CHECK_BOTH(in_sphere(J{high, low, low}, J{high, high, low}, J{low, high, low}, J{low, low, high},
                       J{low, low + 1, low}) == 1);
  using B = irg::point<std::int16_t, 2>;
  CHECK_BOTH(in_circle(B{32767, -32768}, B{32767, 32767}, B{-32768, 32767}, B{-32768, -32768}) == 0);
  CHECK_BOTH(in_circle(B{32767, -32768}, B{32767, 32767}, B{-32768, 32767}, B{-32767, -32768}) == 1);
  using N = irg::point<int, 2>;
  constexpr int n = std::numeric_limits<int>::max(), m = -n - 1;
  CHECK_BOTH(in_circle(N{n, m}, N{n, n}, N{m, n}, N{m, m}) == 0);
  CHECK_BOTH(in_circle(N{n, m}, N{n, n}, N{m, n}, N{m + 1, m}) == 1);
  using S = irg::point<int, 3>;
  CHECK_BOTH(in_sphere(S{n, m, m}, S{n, n, m}, S{m, n, m}, S{m, m, n}, S{m, m, m + 1}) == 1);
  using R = irg::point<test::rational, 2>;
  CHECK_BOTH(in_circle(R{{1, 2}, 0}, R{0, {1, 2}}, R{{-1, 2}, 0}, R{{3, 10}, {4, 10}}) == 0);
  CHECK_BOTH(in_circle(R{{1, 2}, 0}, R{0, {1, 2}}, R{{-1, 2}, 0}, R{{3, 11}, {4, 10}}) == 1);
}

TEST_CASE("in_circle, in_sphere: equal points, exponents far apart") {
  CHECK(test::wrong_for_equal_points<circle>(500) == 0);
  CHECK(test::wrong_for_equal_points<sphere>(100) == 0);
}

TEST_CASE("in_circle, in_sphere: floats that the processor takes for zero") {
  CHECK(test::wrong_floats_while_flushing<circle>(5'000) == 0);
  CHECK(test::wrong_floats_while_flushing<sphere>(1'000) == 0);
}

TEST_CASE("in_circle, in_sphere: rounded stages are right where errors are largest") {
  CHECK(test::wrong_next_to_the_bound<circle>(1, test::trial_count(200'000, 10'000'000)) == 0);
  CHECK(test::wrong_next_to_the_bound<sphere>(1, test::trial_count(50'000, 10'000'000)) == 0);
}

TEST_CASE("in_circle, in_sphere: the filters decide 999 of 1000 uniform points, and are right") {
  const test::filter_score flat = test::score_of_filter<circle>(1, test::trial_count(100'000, 300'000'000));
  const test::filter_score round = test::score_of_filter<sphere>(1, test::trial_count(30'000, 100'000'000));
  CHECK(flat.decided >= 0.999);
  CHECK(flat.wrong == 0);
  CHECK(round.decided >= 0.999);
  CHECK(round.wrong == 0);
}

#ifdef IRG_HAVE_MPFR

namespace {

template <class Predicate>
void check_all(long few, std::uint64_t seed, int orientation) {
  const auto result = test::run_all_trials<Predicate>(test::gmp_trial_count(few, 10'000'000), seed, orientation);
  CHECK(result.wrong == 0);
  CHECK(result.wrong_flushed == 0);
  CHECK(result.wrong_order == 0);
  CHECK(result.zeros > 200);
  for (int i = 0; i + 1 < Predicate::stages; ++i) CHECK(result.decided[static_cast<std::size_t>(i)] > 5);
  const auto whole =
      test::run_integer_trials<Predicate>(test::gmp_trial_count(4 * few, 10'000'000), seed + 50, orientation);
  CHECK(whole.wrong == 0);
  CHECK(whole.zeros > 20);
}

}  // namespace

TEST_CASE("in_circle: against GMP, in all distributions, with subnormals and without") {
  check_all<circle>(100'000, 40, 1);
}
TEST_CASE("in_sphere: against GMP, in all distributions, with subnormals and without") {
  check_all<sphere>(10'000, 60, -1);
}

#endif
