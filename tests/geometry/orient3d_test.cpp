// SPDX-License-Identifier: MIT
#include <irg/geometry/orient3d.hpp>

#include <array>
#include <cstdint>
#include <limits>

#include <irg/geometry/plane.hpp>

#include "support/check_both.hpp"
#include "support/predicate_trials.hpp"
#include "support/rational.hpp"

using irg::orient3d;

namespace {

using P = irg::point<double, 3>;
using I = irg::point<std::int64_t, 3>;
constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
constexpr std::int64_t low = std::numeric_limits<std::int64_t>::min(), high = std::numeric_limits<std::int64_t>::max();

struct predicate {
  static constexpr int points = 4, size = 3, stages = 6;
  static constexpr test::figure shape = test::figure::flat;
  template <class Q>
  static constexpr int whole(const std::array<Q, 4>& p) {
    return orient3d(p[0], p[1], p[2], p[3]);
  }
  static constexpr bool stage(int i, const irg::detail::point_table<double, 4, 3>& t, int& sign) {
    if (i == 0) return (sign = irg::detail::filtered_sign(t, 0x1p-320)) != 0;
    if (i == 1) return (sign = irg::detail::orient3d_compensated(t)) != 0;
    if (i == 2) return irg::detail::sign_by_words(t, sign);
    if (i == 3) return irg::detail::sign_by_double_words(t, sign);
    if (i == 4) return irg::detail::sign_by_range(t, sign);
    sign = irg::detail::sign_by_sum(t);
    return true;
  }
};

constexpr int stage_of(const P& a, const P& b, const P& c, const P& d, int expected) {
  const irg::detail::point_table<double, 4, 3> t{{a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z}};
  for (int i = 0; i < predicate::stages; ++i) {
    int sign = 0;
    if (predicate::stage(i, t, sign)) return sign == expected && orient3d(a, b, c, d) == expected ? i : -1;
  }
  return -1;
}

}  // namespace

TEST_CASE("orient3d: above, below, on the plane") {
  constexpr P o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  CHECK_BOTH(orient3d(o, x, y, z) == 1);
  CHECK_BOTH(orient3d(o, y, x, z) == -1);
  CHECK_BOTH(orient3d(o, x, y, P{0, 0, -1}) == -1);
  CHECK_BOTH(orient3d(o, x, y, P{5, -7, 0}) == 0);
  CHECK_BOTH(orient3d(o, x, P{2, 0, 0}, z) == 0);
  CHECK_BOTH(orient3d(x, x, y, z) == 0);
  CHECK_BOTH(orient3d(P{-0.0, 0, 0}, P{0, -0.0, 0}, P{0, 0, -0.0}, o) == 0);
  using F = std::array<float, 3>;
  CHECK_BOTH(orient3d(F{0.1f, 0, 0}, F{0, 0.1f, 0}, F{0, 0, 0.1f}, F{0.1f, 0.1f, -0.1f}) == 0);
  CHECK_BOTH(orient3d(F{0.1f, 0, 0}, F{0, 0.1f, 0}, F{0, 0, 0.1f}, F{0.1f, 0.1f, -0.099999994f}) == 1);
  static_assert(noexcept(orient3d(o, x, y, z)));
}

TEST_CASE("orient3d: as the plane through three points") {
  test::random r(4);
  for (int i = 0; i < 20'000; ++i) {
    irg::point<std::int64_t, 3> p[4];
    for (auto& q : p) q = {r.integer(-4, 4), r.integer(-4, 4), r.integer(-4, 4)};
    const auto plane = irg::plane_through(p[0], p[1], p[2]);
    const std::int64_t value = plane ? irg::plane_value(*plane, p[3]) : 0;
    REQUIRE(orient3d(p[0], p[1], p[2], p[3]) == (value > 0 ? 1 : value < 0 ? -1 : 0));
  }
}

TEST_CASE("orient3d: the ends of the range of doubles") {
  CHECK_BOTH(orient3d(P{0, 0, 0}, P{least, 0, 0}, P{0, least, 0}, P{0, 0, least}) == 1);
  CHECK_BOTH(orient3d(P{least, 0, 0}, P{0, least, 0}, P{0, 0, least}, P{least, least, -least}) == 0);
  CHECK_BOTH(orient3d(P{-most, -most, 0}, P{most, -most, 0}, P{0, most, 0}, P{0, 0, least}) == 1);
  CHECK_BOTH(orient3d(P{-most, -most, 0}, P{most, -most, 0}, P{0, most, 0}, P{most, 1, 0}) == 0);
  CHECK_BOTH(orient3d(P{-most, -most, -most}, P{most, -most, -most}, P{0, most, -most}, P{0, 0, most}) == 1);
  CHECK_BOTH(orient3d(P{most, least, 0}, P{-most, least, 1}, P{1, least, most}, P{3, 0, 3}) == -1);
}

TEST_CASE("orient3d: each stage decides what it is for") {
  constexpr double u = 0x1p-53;
  constexpr P b{12, 12, 12}, c{24, 24, 24}, d{12, 24, 18};
  CHECK_BOTH(stage_of({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 1) == 0);
  CHECK_BOTH(stage_of({0.5, 0.5 + u, 0.5}, b, c, d, 1) == 1);
  CHECK_BOTH(stage_of({0.5 + u, 0.5 + u, 0.5 + u}, b, c, d, 0) == 2);
  CHECK_BOTH(stage_of({1, 1, 0}, {0x1p60, 0x1p60, 7}, {3, 3, -5}, {0, 0, 1}, 0) == 2);
  CHECK_BOTH(stage_of({1, 1, 0}, {0x1p61, 0x1p61, 7}, {3, 3, -5}, {0, 0, 1}, 0) == 3);
  CHECK_BOTH(stage_of({1, 1, 0}, {0x1p124, 0x1p124, 7}, {3, 3, -5}, {0, 0, 1}, 0) == 3);
  CHECK_BOTH(stage_of({1, 1, 0}, {0x1p125, 0x1p125, 7}, {3, 3, -5}, {0, 0, 1}, 0) == 5);
  CHECK_BOTH(stage_of({0x1p200, 0x1p200, 0}, {1, 2, 0}, {0, 0, 1}, {0, 0, 0}, -1) == 4);
  CHECK_BOTH(stage_of({least, 0, 0}, {0, least, 0}, {0, 0, least}, {0, 0, 0}, -1) == 3);
}

TEST_CASE("orient3d: integers and rationals, exactly") {
  CHECK_BOTH(orient3d(I{low, low, low}, I{high, high, high}, I{low, high, 0}, I{0, 0, 0}) == 0);
  CHECK_BOTH(orient3d(I{low, low, low}, I{high, low, low}, I{low, high, low}, I{low, low, high}) == 1);
  CHECK_BOTH(orient3d(I{high, high, high}, I{low, high, high}, I{high, low, high}, I{high, high, low}) == -1);
  using U = irg::point<std::uint64_t, 3>;
  constexpr std::uint64_t whole = std::numeric_limits<std::uint64_t>::max();
  CHECK_BOTH(orient3d(U{0, 0, 0}, U{whole, 0, 0}, U{0, whole, 0}, U{0, 0, whole}) == 1);
  using B = irg::point<std::int16_t, 3>;
  CHECK_BOTH(orient3d(B{-32768, -32768, -32768}, B{32767, -32768, -32768}, B{-32768, 32767, -32768},
                      B{-32768, -32768, 32767}) == 1);
  using N = irg::point<int, 3>;
  constexpr int n = std::numeric_limits<int>::max(), m = -n - 1;
  CHECK_BOTH(orient3d(N{m, m, m}, N{n, m, m}, N{m, n, m}, N{m, m, n}) == 1);
  CHECK_BOTH(orient3d(N{m, m, m}, N{n, m, m}, N{m, n, m}, N{n, n, m}) == 0);
  using R = irg::point<test::rational, 3>;
  CHECK_BOTH(orient3d(R{{1, 3}, 0, 0}, R{0, {1, 3}, 0}, R{0, 0, {1, 3}}, R{{1, 9}, {1, 9}, {1, 9}}) == 0);
  CHECK_BOTH(orient3d(R{{1, 3}, 0, 0}, R{0, {1, 3}, 0}, R{0, 0, {1, 3}}, R{{1, 9}, {1, 9}, {1, 8}}) == 1);
}

TEST_CASE("orient3d: equal points, exponents far apart") { CHECK(test::wrong_for_equal_points<predicate>(1000) == 0); }

TEST_CASE("orient3d: floats that the processor takes for zero") {
  CHECK(test::wrong_floats_while_flushing<predicate>(20'000) == 0);
}

TEST_CASE("orient3d: rounded stages are right where errors are largest") {
  CHECK(test::wrong_next_to_the_bound<predicate>(2, test::trial_count(50'000, 10'000'000)) == 0);
}

TEST_CASE("orient3d: the filter decides 999 of 1000 uniform points, and is right") {
  const test::filter_score s = test::score_of_filter<predicate>(2, test::trial_count(100'000, 300'000'000));
  CHECK(s.decided >= 0.999);
  CHECK(s.wrong == 0);
}

#ifdef IRG_HAVE_MPFR

TEST_CASE("orient3d: against GMP, in all distributions, with subnormals and without") {
  const auto result = test::run_all_trials<predicate>(test::gmp_trial_count(100'000, 10'000'000), 30, -1);
  CHECK(result.wrong == 0);
  CHECK(result.wrong_flushed == 0);
  CHECK(result.wrong_order == 0);
  CHECK(result.zeros > 1000);
  for (int i = 0; i + 1 < predicate::stages; ++i) CHECK(result.decided[static_cast<std::size_t>(i)] > 20);
  const auto whole = test::run_integer_trials<predicate>(test::trial_count(20'000, 10'000'000), 31, -1);
  CHECK(whole.wrong == 0);
  CHECK(whole.zeros > 100);
}

#endif
