// SPDX-License-Identifier: MIT
#include <irg/geometry/orient2d.hpp>

#include <array>
#include <cstdint>
#include <limits>

#include "support/check_both.hpp"
#include "support/predicate_trials.hpp"
#include "support/rational.hpp"

using irg::orient2d;

namespace {

using P = irg::point<double, 2>;
using I = irg::point<std::int64_t, 2>;
constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
constexpr std::int64_t low = std::numeric_limits<std::int64_t>::min(), high = std::numeric_limits<std::int64_t>::max();

struct predicate {
  static constexpr int points = 3, size = 2, stages = 6;
  static constexpr test::figure shape = test::figure::flat;
  template <class Q>
  static constexpr int whole(const std::array<Q, 3>& p) {
    return orient2d(p[0], p[1], p[2]);
  }
  static constexpr bool stage(int i, const irg::detail::point_table<double, 3, 2>& t, int& sign) {
    if (i == 0) return (sign = irg::detail::filtered_sign(t, 0x1p-480)) != 0;
    if (i == 1) return (sign = irg::detail::compensated_sign(t)) != 0;
    if (i == 2) return irg::detail::sign_by_words(t, sign);
    if (i == 3) return irg::detail::sign_by_double_words(t, sign);
    if (i == 4) return irg::detail::sign_by_range(t, sign);
    sign = irg::detail::sign_by_sum(t);
    return true;
  }
};

// The number of the first stage that decides, and that it decides as it should.
constexpr int stage_of(const P& a, const P& b, const P& c, int expected) {
  const irg::detail::point_table<double, 3, 2> t{{a.x, a.y, b.x, b.y, c.x, c.y}};
  for (int i = 0; i < predicate::stages; ++i) {
    int sign = 0;
    if (predicate::stage(i, t, sign)) return sign == expected && orient2d(a, b, c) == expected ? i : -1;
  }
  return -1;
}

}  // namespace

TEST_CASE("orient2d: left, right, on a line") {
  CHECK_BOTH(orient2d(P{0, 0}, P{1, 0}, P{0, 1}) == 1);
  CHECK_BOTH(orient2d(P{0, 0}, P{0, 1}, P{1, 0}) == -1);
  CHECK_BOTH(orient2d(P{0, 0}, P{1, 1}, P{2, 2}) == 0);
  CHECK_BOTH(orient2d(P{0, 0}, P{2, 2}, P{1, 1}) == 0);
  CHECK_BOTH(orient2d(P{3, 4}, P{3, 4}, P{7, -2}) == 0);
  CHECK_BOTH(orient2d(P{3, 4}, P{7, -2}, P{3, 4}) == 0);
  CHECK_BOTH(orient2d(P{-0.0, 0.0}, P{0.0, -0.0}, P{0, 0}) == 0);
  CHECK_BOTH(orient2d(P{-0.0, 1}, P{0.0, 2}, P{-0.0, 3}) == 0);
  using F = std::array<float, 2>;
  CHECK_BOTH(orient2d(F{0.1f, 0.1f}, F{0.2f, 0.2f}, F{0.3f, 0.3f}) == 0);
  CHECK_BOTH(orient2d(F{0.1f, 0.1f}, F{0.2f, 0.2f}, F{0.3f, 0.30000004f}) == 1);
  static_assert(noexcept(orient2d(P{}, P{}, P{})) && noexcept(orient2d(I{}, I{}, I{})));
}

TEST_CASE("orient2d: the ends of the range of doubles") {
  CHECK_BOTH(orient2d(P{0, 0}, P{least, 0}, P{0, least}) == 1);
  CHECK_BOTH(orient2d(P{0, 0}, P{least, least}, P{3 * least, 3 * least}) == 0);
  CHECK_BOTH(orient2d(P{0, 0}, P{2 * least, 3 * least}, P{3 * least, 4 * least}) == -1);
  CHECK_BOTH(orient2d(P{-most, -most}, P{most, -most}, P{most, most}) == 1);
  CHECK_BOTH(orient2d(P{-most, -most}, P{0, 0}, P{most, most}) == 0);
  CHECK_BOTH(orient2d(P{-most, -most}, P{0, least}, P{most, most}) == -1);
  CHECK_BOTH(orient2d(P{0, 0}, P{most, least}, P{-most, -least}) == 0);
  CHECK_BOTH(orient2d(P{0, 0}, P{most, least}, P{-most, 0}) == 1);
  CHECK_BOTH(orient2d(P{most, least}, P{0, 0}, P{most, 0}) == 1);
}

TEST_CASE("orient2d: each stage decides what it is for") {
  constexpr double u = 0x1p-53;
  CHECK_BOTH(stage_of({0, 0}, {1, 0}, {0, 1}, 1) == 0);
  CHECK_BOTH(stage_of({0.5, 0.5 + u}, {12, 12}, {24, 24}, 1) == 1);
  CHECK_BOTH(stage_of({0.5 + u, 0.5 + u}, {12, 12}, {24, 24}, 0) == 2);
  CHECK_BOTH(stage_of({least, 0}, {0, least}, {-least, 0}, 1) == 3);
  CHECK_BOTH(stage_of({1, 1}, {0x1p60, 0x1p60}, {3, 3}, 0) == 2);
  CHECK_BOTH(stage_of({1, 1}, {0x1p61, 0x1p61}, {3, 3}, 0) == 3);
  CHECK_BOTH(stage_of({1, 1}, {0x1p124, 0x1p124}, {3, 3}, 0) == 3);
  CHECK_BOTH(stage_of({1, 1}, {0x1p125, 0x1p125}, {3, 3}, 0) == 5);
  CHECK_BOTH(stage_of({0x1p200, 0x1p200}, {1, 2}, {0, 0}, 1) == 4);
  CHECK_BOTH(stage_of({0x1p200, 0x1p200}, {1, 1 + 2 * u}, {0, 0}, 1) == 5);
  CHECK(stage_of({most, most}, {least, least}, {0, 0}, 0) == 5);  // what overflows is no constant
  CHECK(stage_of({0x1p900, 1}, {0x1p900, 2}, {0x1p900, 3}, 0) == 5);
}

TEST_CASE("orient2d: integers and rationals, exactly") {
  CHECK_BOTH(orient2d(I{low, low}, I{high, high}, I{0, 0}) == 0);
  CHECK_BOTH(orient2d(I{low, low}, I{high, high}, I{0, 1}) == 1);
  CHECK_BOTH(orient2d(I{low, high}, I{high, low}, I{high, high}) == 1);
  CHECK_BOTH(orient2d(I{low, low}, I{high, high - 1}, I{high - 1, high}) == 1);
  CHECK_BOTH(orient2d(I{low, low}, I{high, high}, I{high - 1, high - 1}) == 0);
  using U = irg::point<std::uint64_t, 2>;
  constexpr std::uint64_t whole = std::numeric_limits<std::uint64_t>::max();
  CHECK_BOTH(orient2d(U{0, 0}, U{whole, whole}, U{whole - 1, whole}) == 1);
  CHECK_BOTH(orient2d(U{0, whole}, U{0, 0}, U{whole, 0}) == 1);
  using B = irg::point<std::int8_t, 2>;
  CHECK_BOTH(orient2d(B{-128, -128}, B{127, -128}, B{127, 127}) == 1);
  using N = irg::point<int, 2>;
  constexpr int n = std::numeric_limits<int>::max();
  CHECK_BOTH(orient2d(N{-n - 1, -n - 1}, N{n, n}, N{n, n - 1}) == -1);
  CHECK_BOTH(orient2d(N{-n - 1, -n - 1}, N{n, -n - 1}, N{n, n}) == 1);
  using R = irg::point<test::rational, 2>;
  CHECK_BOTH(orient2d(R{{1, 3}, {1, 7}}, R{{2, 3}, {2, 7}}, R{1, {3, 7}}) == 0);
  CHECK_BOTH(orient2d(R{{1, 3}, {1, 7}}, R{{2, 3}, {2, 7}}, R{1, {4, 7}}) == 1);
}

TEST_CASE("orient2d: on the grid of ulps around a line") {
  // Kettner and others 2008: p in a grid of 2^-53 around (0.5, 0.5), against (12, 12) and (24, 24); in 128-bit integers.
  __extension__ typedef __int128 wide;
  const auto as_integer = [](double x) { return static_cast<wide>(static_cast<std::int64_t>(x * 0x1p53)); };
  long wrong = 0, rounded_wrong = 0;
  for (int i = 0; i < 256; ++i)
    for (int j = 0; j < 256; ++j) {
      const P p{0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53}, q{12, 12}, r{24, 24};
      const wide det = (as_integer(q.x) - as_integer(p.x)) * (as_integer(r.y) - as_integer(p.y)) -
                       (as_integer(q.y) - as_integer(p.y)) * (as_integer(r.x) - as_integer(p.x));
      const int expected = det < 0 ? -1 : det > 0 ? 1 : 0;
      wrong += orient2d(p, q, r) != expected;
      wrong += orient2d(q, r, p) != expected;
      wrong += orient2d(r, q, p) != -expected;
      const double left = (p.x - r.x) * (q.y - r.y), right = (p.y - r.y) * (q.x - r.x);
      rounded_wrong += (left < right ? -1 : left > right ? 1 : 0) != expected;
    }
  CHECK(wrong == 0);
  CHECK(rounded_wrong > 1000);
}

TEST_CASE("orient2d: equal points, exponents far apart") { CHECK(test::wrong_for_equal_points<predicate>(2000) == 0); }

TEST_CASE("orient2d: floats that the processor takes for zero") {
  CHECK(test::wrong_floats_while_flushing<predicate>(20'000) == 0);
}

TEST_CASE("orient2d: rounded stages are right where errors are largest") {
  CHECK(test::wrong_next_to_the_bound<predicate>(2, test::trial_count(50'000, 10'000'000)) == 0);
}

TEST_CASE("orient2d: the filter decides 999 of 1000 uniform points, and is right") {
  const test::filter_score s = test::score_of_filter<predicate>(2, test::trial_count(200'000, 1'000'000'000));
  CHECK(s.decided >= 0.999);
  CHECK(s.wrong == 0);
}

#ifdef IRG_HAVE_MPFR

TEST_CASE("orient2d: against GMP, in all distributions, with subnormals and without") {
  const auto result = test::run_all_trials<predicate>(test::gmp_trial_count(100'000, 10'000'000), 20, 1);
  CHECK(result.wrong == 0);
  CHECK(result.wrong_flushed == 0);
  CHECK(result.wrong_order == 0);
  CHECK(result.zeros > 1000);
  for (int i = 0; i + 1 < predicate::stages; ++i) CHECK(result.decided[static_cast<std::size_t>(i)] > 20);
  const auto whole = test::run_integer_trials<predicate>(test::trial_count(50'000, 100'000'000), 21, 1);
  CHECK(whole.wrong == 0);
  CHECK(whole.zeros > 100);
}

#endif
