// SPDX-License-Identifier: MIT
#include <irg/geometry/clip_line_liang_barsky.hpp>

#include <array>
#include <cmath>
#include <limits>

#include "line_clip_cases.hpp"
#include "support/check_both.hpp"
#include "support/rational.hpp"

using irg::box;
using irg::clip_line_liang_barsky;
using irg::point;
using P = point<double, 2>;
using L = irg::clipped_line<P>;

namespace {

constexpr box<double, 2> window{{0, 0}, {4, 3}};

constexpr bool gives(P a, P b, P first, P second) {
  const auto kept = clip_line_liang_barsky(a, b, window);
  return kept && kept->first == first && kept->second == second;
}
constexpr bool gives_nothing(P a, P b) { return !clip_line_liang_barsky(a, b, window); }

template <class T>
int exponent_range() {
  return std::numeric_limits<T>::max_exponent;
}

}  // namespace

TEST_CASE("clip_line_liang_barsky: by hand, in every life") {
  CHECK_BOTH(gives({1, 1}, {2, 2}, {1, 1}, {2, 2}));
  CHECK_BOTH(gives({-1, 1}, {5, 1}, {0, 1}, {4, 1}));
  CHECK_BOTH(gives({-1, -1}, {5, 5}, {0, 0}, {3, 3}));
  CHECK_BOTH(gives({-2, 1}, {4, 4}, {0, 2}, {2, 3}));
  CHECK_BOTH(gives({4, 4}, {-2, 1}, {2, 3}, {0, 2}));
  CHECK_BOTH(gives({-1, 1}, {1, -1}, {0, 0}, {0, 0}));  // touches a corner
  CHECK_BOTH(gives({4, -1}, {4, 5}, {4, 0}, {4, 3}));   // along an edge
  CHECK_BOTH(gives({2, 2}, {2, 2}, {2, 2}, {2, 2}));    // of no length
  CHECK_BOTH(gives_nothing({-2, 1}, {1, -2}));          // past a corner
  CHECK_BOTH(gives_nothing({5, 1}, {6, 2}));
  CHECK_BOTH(gives_nothing({5, 5}, {5, 5}));
  CHECK_BOTH(clip_line_liang_barsky(P{-2, 1}, P{4, 4}, window) == L{{0, 2}, {2, 3}, 1.0 / 3, 2.0 / 3});
  volatile double minus_two = -2;
  CHECK(clip_line_liang_barsky(P{minus_two, 1}, P{4, 4}, window) == L{{0, 2}, {2, 3}, 1.0 / 3, 2.0 / 3});
  // Correctly rounded where the textbook's formula is not.
  CHECK_BOTH(gives({-1, 0.1}, {2, 0.2}, {0, 0.1 + 0.1 / 3}, {2, 0.2}));
}

TEST_CASE("clip_line_liang_barsky: hostile input") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  for (const double bad : {nan, inf, -inf})
    for (int i = 0; i < 4; ++i) {
      double v[] = {1, 1, 2, 2};
      v[i] = bad;
      CHECK(gives_nothing({v[0], v[1]}, {v[2], v[3]}));
      v[0] += i == 0 ? 0 : 50;
      CHECK(gives_nothing({v[0], v[1]}, {v[2], v[3]}));
    }
  CHECK_BOTH(!clip_line_liang_barsky(P{1, 1}, P{2, 2}, box<double, 2>{}));
  CHECK_BOTH(!clip_line_liang_barsky(P{1, 1}, P{2, 2}, box<double, 2>{{3, 0}, {2, 9}}));
  CHECK(!clip_line_liang_barsky(P{1, 1}, P{2, 2}, box<double, 2>{{nan, 0}, {2, 9}}));
  CHECK_BOTH(gives({-most, -most}, {most, most}, {0, 0}, {3, 3}));
  CHECK_BOTH(gives({-most, 1}, {most, 2}, {0, 1.5}, {4, 1.5}));
  // 2^1000 away, passing one ulp beside a corner and through it.
  CHECK_BOTH(gives({-0x1p1000, 0x1p1000}, {0x1p1000, -0x1p1000}, {0, 0}, {0, 0}));
  CHECK_BOTH(gives_nothing({-0x1p1000, 0x1p1000}, {0x1p1000, -0x1.0000000000001p1000}));
  CHECK_BOTH(gives({-0x1p60, 0x1p60}, {0x1p60, -0x1p60}, {0, 0}, {0, 0}));
  CHECK_BOTH(gives_nothing({-least, 0}, {0, -least}));
  CHECK_BOTH(gives({-least, least}, {least, -least}, {0, 0}, {0, 0}));
  constexpr box<double, 2> dust{{least, least}, {3 * least, 2 * least}};
  constexpr auto in_dust = clip_line_liang_barsky(P{0, 0}, P{1, 1}, dust);
  CHECK_BOTH((in_dust && in_dust->first == P{least, least} && in_dust->second == P{2 * least, 2 * least}));
  // A window that is a point, and one that is a line.
  constexpr box<double, 2> dot{{1, 1}, {1, 1}}, bar{{1, 0}, {1, 3}};
  CHECK_BOTH(clip_line_liang_barsky(P{0, 0}, P{3, 3}, dot)->first == P{1, 1});
  CHECK_BOTH(!clip_line_liang_barsky(P{0, 0}, P{3, 3.5}, dot));
  CHECK_BOTH(clip_line_liang_barsky(P{0, 0}, P{3, 3}, bar) == L{{1, 1}, {1, 1}, 1.0 / 3, 1.0 / 3});
  // A window without end on one side.
  constexpr box<double, 2> half{{0, -inf}, {inf, inf}};
  CHECK_BOTH(clip_line_liang_barsky(P{-1, 7}, P{3, 3}, half)->first == P{0, 6});
}

TEST_CASE("clip_line_liang_barsky: integers, rationals, space, foreign points") {
  using I = point<int, 2>;
  constexpr box<int, 2> cells{{0, 0}, {10, 10}};
  constexpr auto kept = clip_line_liang_barsky(I{-3, 1}, I{7, 8}, cells);  // y = 3.1 at x = 0
  CHECK_BOTH((kept && kept->first == I{0, 3} && kept->second == I{7, 8} && kept->t_first == 0.3));
  CHECK_BOTH(clip_line_liang_barsky(I{-1, 0}, I{1, 1}, cells)->first == I{0, 1});    // halves go up,
  CHECK_BOTH(clip_line_liang_barsky(I{1, 1}, I{-1, 0}, cells)->second == I{0, 1});   // whichever way round
  CHECK_BOTH(clip_line_liang_barsky(I{-1, 1}, I{1, 0}, cells)->first == I{0, 1});
  CHECK_BOTH(!clip_line_liang_barsky(I{-3, 2}, I{2, -3}, cells));
  constexpr int high = std::numeric_limits<int>::max(), low = std::numeric_limits<int>::min();
  CHECK_BOTH(clip_line_liang_barsky(I{low, low}, I{high, high}, cells)->first == I{0, 0});
  CHECK_BOTH(clip_line_liang_barsky(I{low, low}, I{high, high}, cells)->second == I{10, 10});
  using W = point<std::int64_t, 2>;
  constexpr auto far = std::numeric_limits<std::int64_t>::max();
  constexpr auto wide =
      clip_line_liang_barsky(W{-far - 1, -far - 1}, W{far, far}, box<std::int64_t, 2>{{0, 0}, {10, 9}});
  CHECK_BOTH((wide && wide->first == W{0, 0} && wide->second == W{9, 9}));

  using test::rational;
  using R = point<rational, 2>;
  constexpr auto part = clip_line_liang_barsky(R{-1, 1}, R{2, 5}, box<rational, 2>{{0, 0}, {4, 3}});
  CHECK_BOTH((part && part->first == R{0, rational(7, 3)} && part->second == R{rational(1, 2), 3}));
  CHECK_BOTH((part->t_first == rational(1, 3) && part->t_second == rational(1, 2)));

  using S = point<double, 3>;
  constexpr auto beam = clip_line_liang_barsky(S{-1, -1, -1}, S{3, 5, 7}, box<double, 3>{{0, 0, 0}, {2, 2, 2}});
  CHECK_BOTH((beam && beam->first == S{0, 0.5, 1} && beam->second == S{0.5, 1.25, 2}));
  using A = std::array<float, 2>;
  CHECK_BOTH(clip_line_liang_barsky(A{-1, 1}, A{5, 1}, box<float, 2>{{0, 0}, {4, 3}})->second == A{4, 1});
}

TEST_CASE("clip_line_liang_barsky: random integers against rationals") {
  test::random r(5);
  using test::rational;
  int visible = 0;
  for (int k = 0; k < line_cases::release_or(20000); ++k) {
    const auto c = [&] { return static_cast<int>(r.integer(-12, 12)); };
    const point<int, 2> a{c(), c()}, b{c(), c()}, p{c(), c()}, q{c(), c()};
    const auto w = irg::bounding_box(irg::bounding_box(box<int, 2>{}, p), q);
    const auto exact = [](const point<int, 2>& v) { return point<rational, 2>{v.x, v.y}; };
    const auto kept = clip_line_liang_barsky(a, b, w);
    const auto oracle = clip_line_liang_barsky(exact(a), exact(b), {exact(w.low), exact(w.high)});
    REQUIRE(kept.has_value() == oracle.has_value());
    if (!kept) continue;
    ++visible;
    const auto rounds_to = [](const rational& x, int n) {
      return !(x + rational(1, 2) < n) && x < rational(2 * n + 1, 2);
    };
    CHECK((rounds_to(oracle->first.x, kept->first.x) && rounds_to(oracle->first.y, kept->first.y)));
    CHECK((rounds_to(oracle->second.x, kept->second.x) && rounds_to(oracle->second.y, kept->second.y)));
    CHECK(clip_line_liang_barsky(kept->first, kept->second, w)->first == kept->first);
  }
  CHECK(visible > 5000);
}

#ifdef IRG_HAVE_MPFR

namespace {

template <class T>
void against_rationals(std::uint64_t seed, int count) {
  test::random r(seed);
  int visible = 0, wrong = 0;
  for (int k = 0; k < line_cases::release_or(count); ++k) {
    const auto c = line_cases::draw_case<T>(r);
    const auto kept = clip_line_liang_barsky(c.a, c.b, c.window), back = clip_line_liang_barsky(c.b, c.a, c.window);
    wrong += line_cases::is_exact<2>(kept, c.a, c.b, c.window) ? 0 : 1;
    wrong += back.has_value() == kept.has_value() ? 0 : 1;
    if (!kept || !back) continue;
    ++visible;
    wrong += back->first == kept->second && back->second == kept->first ? 0 : 1;
    const auto again = clip_line_liang_barsky(kept->first, kept->second, c.window);
    wrong += again && again->first == kept->first && again->second == kept->second ? 0 : 1;
  }
  CHECK(wrong == 0);
  CHECK(visible > count / 4);
}

}  // namespace

TEST_CASE("clip_line_liang_barsky: decisions exact, coordinates correctly rounded, by rationals") {
  against_rationals<double>(1, 30000);
  against_rationals<float>(2, 30000);
}

TEST_CASE("clip_line_liang_barsky: boxes in space, by rationals") {
  test::random r(3);
  int visible = 0, wrong = 0;
  for (int k = 0; k < line_cases::release_or(8000); ++k) {
    const auto c = line_cases::draw_case<double>(r), d = line_cases::draw_case<double>(r);
    const point<double, 3> a{c.a.x, c.a.y, d.a.x}, b{c.b.x, c.b.y, d.b.x};
    const box<double, 3> w{{c.window.low.x, c.window.low.y, d.window.low.x},
                           {c.window.high.x, c.window.high.y, d.window.high.x}};
    const auto kept = clip_line_liang_barsky(a, b, w);
    visible += kept ? 1 : 0;
    wrong += line_cases::is_exact<3>(kept, a, b, w) ? 0 : 1;
  }
  CHECK(wrong == 0);
  CHECK(visible > 800);
}

#endif
