// SPDX-License-Identifier: MIT
#include <irg/geometry/clip_line_nicholl_lee_nicholl.hpp>

#include <limits>

#include <irg/geometry/clip_line_liang_barsky.hpp>

#include "line_clip_cases.hpp"
#include "support/check_both.hpp"

using irg::box;
using irg::clip_line_nicholl_lee_nicholl;
using irg::point;
using P = point<double, 2>;

namespace {

constexpr box<double, 2> window{{0, 0}, {4, 3}};
constexpr bool gives(P a, P b, P first, P second) {
  const auto kept = clip_line_nicholl_lee_nicholl(a, b, window);
  return kept && kept->first == first && kept->second == second;
}

template <class T>
void as_liang_barsky(std::uint64_t seed, int count) {
  test::random r(seed);
  int visible = 0, wrong = 0;
  for (int k = 0; k < line_cases::release_or(count); ++k) {
    const auto c = line_cases::draw_case<T>(r);
    const auto kept = clip_line_nicholl_lee_nicholl(c.a, c.b, c.window);
    visible += kept ? 1 : 0;
    wrong += kept == clip_line_liang_barsky(c.a, c.b, c.window) ? 0 : 1;
  }
  CHECK(wrong == 0);
  CHECK(visible > count / 4);
}

}  // namespace

TEST_CASE("clip_line_nicholl_lee_nicholl: by hand, in every life") {
  CHECK_BOTH(gives({1, 1}, {2, 2}, {1, 1}, {2, 2}));
  CHECK_BOTH(gives({-1, -1}, {5, 5}, {0, 0}, {3, 3}));
  CHECK_BOTH(gives({-2, 1}, {4, 4}, {0, 2}, {2, 3}));
  CHECK_BOTH(gives({-1, 1}, {1, -1}, {0, 0}, {0, 0}));
  CHECK_BOTH(!clip_line_nicholl_lee_nicholl(P{-2, 1}, P{1, -2}, window));
  CHECK_BOTH(!clip_line_nicholl_lee_nicholl(P{1, 1}, P{2, 2}, box<double, 2>{}));
  volatile double minus_two = -2;
  CHECK(gives({minus_two, 1}, {4, 4}, {0, 2}, {2, 3}));
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, inf, -inf}) {
    CHECK(!clip_line_nicholl_lee_nicholl(P{bad, 1}, P{1, 1}, window));
    CHECK(!clip_line_nicholl_lee_nicholl(P{9, 1}, P{1, bad}, window));
  }
}

TEST_CASE("clip_line_nicholl_lee_nicholl: from every region to every region") {
  // Places left of, on, in and beyond the window, along each axis: 625 segments, each against rationals' decision.
  const double xs[] = {-2, 0, 1, 4, 6}, ys[] = {-3, 0, 2, 3, 4};
  int visible = 0;
  for (const double ax : xs)
    for (const double ay : ys)
      for (const double bx : xs)
        for (const double by : ys) {
          const auto kept = clip_line_nicholl_lee_nicholl(P{ax, ay}, P{bx, by}, window);
          CHECK(kept == clip_line_liang_barsky(P{ax, ay}, P{bx, by}, window));
          visible += kept ? 1 : 0;
        }
  CHECK(visible == 465);
}

TEST_CASE("clip_line_nicholl_lee_nicholl: the bits of Liang and Barsky") {
  as_liang_barsky<double>(21, 60000);
  as_liang_barsky<float>(22, 60000);
  test::random r(23);
  int wrong = 0;
  for (int k = 0; k < line_cases::release_or(60000); ++k) {
    const auto c = [&] { return static_cast<int>(r.integer(-9, 9)); };
    const point<int, 2> a{c(), c()}, b{c(), c()}, p{c(), c()}, q{c(), c()};
    const auto w = irg::enclosing_box(irg::enclosing_box(box<int, 2>{}, p), q);
    wrong += clip_line_nicholl_lee_nicholl(a, b, w) == clip_line_liang_barsky(a, b, w) ? 0 : 1;
  }
  CHECK(wrong == 0);
}
