// SPDX-License-Identifier: MIT
#include <irg/math/homogeneous.hpp>

#include <cmath>
#include <limits>

#include "math/mixed_cases.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

using irg::homogeneous_kind;
using irg::homogeneous_kind_of;
using irg::hpoint;
using irg::point;
using irg::same_position;
using irg::to_homogeneous;
using irg::try_to_cartesian;
using irg::vec;
using test::rational;

namespace {

using H = hpoint<double, 3>;
constexpr double none = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("homogeneous: the course's values") {
  CHECK_BOTH(to_homogeneous(point<int, 2>{3, 4}, 2) == hpoint<int, 2>{6, 8, 2});
  CHECK_BOTH(*try_to_cartesian(hpoint<double, 2>{6, 8, 2}) == point<double, 2>{3, 4});
  CHECK_BOTH(*try_to_cartesian(hpoint<rational, 2>{6, 8, 2}) == point<rational, 2>{3, 4});
  CHECK_BOTH(homogeneous_kind_of(hpoint<int, 2>{-16, 8, 0}) == irg::homogeneous_kind::direction);
}

TEST_CASE("homogeneous: Hank's values") {
  CHECK_BOTH(*try_to_cartesian(H{4, 6, 2, 2}) == point<double, 3>{2, 3, 1});
  CHECK_BOTH(homogeneous_kind_of(H{1, 2, 3, 0}) == homogeneous_kind::direction);
  CHECK_BOTH(!try_to_cartesian(H{1, 2, 3, 0}));
  CHECK_BOTH(same_position(H{2, 4, 6, 2}, H{1, 2, 3, 1}));
  CHECK_BOTH(!same_position(H{2, 4, 6, 2}, H{1, 2, 3, 2}));
  CHECK_BOTH(same_position(to_homogeneous(point<double, 3>{1, 2, 3}, -0.25), H{1, 2, 3, 1}));
  CHECK_BOTH(to_homogeneous(vec<int, 2>{3, 4}) == hpoint<int, 2>{3, 4, 0});
  CHECK_BOTH(to_homogeneous(point<int, 2>{3, 4}, 5) == hpoint<int, 2>{15, 20, 5});
  CHECK_BOTH(same_position(hpoint<rational, 2>{1, 2, 3}, hpoint<rational, 2>{rational(1, 3), rational(2, 3), 1}));
}

TEST_CASE("homogeneous: degenerate and hostile") {
  constexpr H nothing{};
  CHECK_BOTH(homogeneous_kind_of(nothing) == homogeneous_kind::nothing);
  CHECK_BOTH((!same_position(nothing, nothing) && !same_position(nothing, H{1, 2, 3, 4})));
  CHECK_BOTH((!try_to_cartesian(nothing) && !try_to_cartesian(H{none, 0, 0, 1}) && !try_to_cartesian(H{1, 0, 0, inf})));
  CHECK_BOTH(homogeneous_kind_of(H{0, inf, 0, 1}) == homogeneous_kind::nothing);
  CHECK_BOTH(!same_position(H{none, 0, 0, 1}, H{none, 0, 0, 1}));
  CHECK_BOTH(!try_to_cartesian(H{1, 0, 0, 0x1p-1074}));  // 2^1074
  CHECK_BOTH(homogeneous_kind_of(H{1, 0, 0, -0.0}) == homogeneous_kind::direction);
  // Directions: a factor may be negative, weights differ from positions'.
  CHECK_BOTH(same_position(H{1, -2, 3, 0}, H{-2, 4, -6, 0}));
  CHECK_BOTH(!same_position(H{1, 2, 3, 0}, H{1, 2, 3, 0x1p-1074}));
  CHECK_BOTH(!same_position(H{0, 0, 0, 1}, H{0x1p-1074, 0, 0, 0x1p1023}));
  // Products that are beyond the range, or lose bits below it.
  constexpr double huge = std::numeric_limits<double>::max(), tiny = 0x1p-1074;
  CHECK_BOTH(same_position(H{huge, 0, huge, huge}, H{tiny, 0, tiny, tiny}));
  CHECK_BOTH(!same_position(H{huge, 0, huge, 0x1.ffffffffffffep1023}, H{tiny, 0, tiny, tiny}));
  CHECK_BOTH(same_position(H{3 * tiny, tiny, 0, tiny}, H{0.75, 0.25, 0, 0.25}));
  CHECK_BOTH(!same_position(H{3 * tiny, tiny, 0, tiny}, H{std::bit_cast<double>(0x3fe8000000000001u), 0.25, 0, 0.25}));
  constexpr std::int64_t low = std::numeric_limits<std::int64_t>::min(),
                         high = std::numeric_limits<std::int64_t>::max();
  CHECK_BOTH(same_position(hpoint<std::int64_t, 2>{low, low, low}, hpoint<std::int64_t, 2>{high, high, high}));
  CHECK_BOTH(!same_position(hpoint<std::int64_t, 2>{low, high, 1}, hpoint<std::int64_t, 2>{high, low, 1}));
  CHECK_BOTH(same_position(hpoint<std::uint32_t, 2>{1u << 31, 2, 0}, hpoint<std::uint32_t, 2>{1u << 30, 1, 0}));
}

TEST_CASE("homogeneous: equality is exact") {
  // a factor keeps the position when every product is exact; one ulp more in one coordinate does not.
  test::random r(1);
  for (int i = 0; i < 20000; ++i) {
    const auto coordinate = [&] { return static_cast<double>(r.integer(-(1 << 26), 1 << 26)); };
    const double factor = coordinate() + 0.5, size = std::ldexp(1.0, static_cast<int>(r.integer(-900, 900)));
    const H p{coordinate(), coordinate(), coordinate(), coordinate()};
    if (homogeneous_kind_of(p) == homogeneous_kind::nothing) continue;
    H q{};
    for (int k = 0; k < 4; ++k) q[k] = p[k] * factor * size;
    CHECK((same_position(p, q) && same_position(q, p)));
    const int k = static_cast<int>(r.integer(0, 3));
    if (q[k] == 0) continue;
    q[k] = std::nextafter(q[k], HUGE_VAL);
    CHECK(!same_position(p, q));
    const hpoint<float, 2> f{static_cast<float>(r.integer(1, 4096)), static_cast<float>(r.integer(1, 4096)), 1.0f};
    hpoint<float, 2> g{f.x * 4095, f.y * 4095, 4095};
    CHECK(same_position(f, g));
    g.y = std::nextafterf(g.y, 0.0f);
    CHECK(!same_position(f, g));
  }
}

#ifdef IRG_HAVE_MPFR

namespace {
namespace sweeps {

using namespace test::mixed;
using test::mixed::rational;

template <class T, int N>
void sweep_homogeneous() {
  using H = irg::hpoint<T, N>;
  const auto any = [](test::random& r, sizes which) {
    H p{};
    for (int i = 0; i <= N; ++i) p[i] = r.integer(0, 9) == 0 ? T(0) : number<T>(r, which);
    return p;
  };
  sweep("try_to_cartesian", 0, [&](test::random& r, sizes which) {
    const H p = any(r, which);
    const auto got = try_to_cartesian(p);
    bool fits = p[N] != 0, right = true;
    for (int i = 0; fits && i < N; ++i) {
      const T want = test::nearest<T>(rational(p[i]) / rational(p[N]));
      fits = std::isfinite(want);
      right = right && (!got || (*got)[i] == want);
    }
    return fits == got.has_value() && (!fits || right) ? 0 : 1;
  });
  sweep("to_homogeneous", 0, [&](test::random& r, sizes which) {
    const auto v = vector<T, N>(r, which);
    const T h = number<T>(r, all_sizes[r.integer(0, 3)]);
    if (h == 0) return 0;
    const H p = to_homogeneous(irg::to_point(v), h);
    bool right = p[N] == h;
    for (int i = 0; i < N; ++i) right = right && p[i] == test::nearest<T>(rational(v[i]) * rational(h));
    return right ? 0 : 1;
  });
  sweep("same_position", 0, [&](test::random& r, sizes which) {
    const H p = any(r, which);
    H q = any(r, which);
    if (r.integer(0, 2) > 0) {  // p times a number, each coordinate rounded
      const T factor = r.integer(0, 1) == 0 ? T(3) : std::ldexp(T(1), static_cast<int>(r.integer(-100, 100)));
      for (int i = 0; i <= N; ++i) q[i] = p[i] * factor;
    }
    bool finite = true, p_is_zero = true, q_is_zero = true, same = true;
    for (int i = 0; i <= N; ++i) {
      finite = finite && std::isfinite(q[i]);
      p_is_zero = p_is_zero && p[i] == 0;
      q_is_zero = q_is_zero && q[i] == 0;
    }
    for (int i = 0; finite && i <= N; ++i)
      for (int j = 0; j < i; ++j) same = same && rational(p[i]) * rational(q[j]) == rational(p[j]) * rational(q[i]);
    return same_position(p, q) == (finite && same && !p_is_zero && !q_is_zero) ? 0 : 1;
  });
}

TEST_CASE_TEMPLATE("homogeneous coordinates: numbers of all sizes", T, double, float) { sweep_homogeneous<T, 3>(); }

}  // namespace sweeps
}  // namespace

#endif
