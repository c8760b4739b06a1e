// SPDX-License-Identifier: MIT
#include <irg/geometry/clip_line_cohen_sutherland.hpp>

#include <limits>

#include <irg/geometry/clip_line_liang_barsky.hpp>

#include "line_clip_cases.hpp"
#include "support/check_both.hpp"

using irg::box;
using irg::clip_line_cohen_sutherland;
using irg::point;
using P = point<double, 2>;

namespace {

constexpr box<double, 2> window{{0, 0}, {4, 3}};
constexpr bool gives(P a, P b, P first, P second) {
  const auto kept = clip_line_cohen_sutherland(a, b, window);
  return kept && kept->first == first && kept->second == second;
}

template <class T>
void as_liang_barsky(std::uint64_t seed, int count) {
  test::random r(seed);
  int visible = 0, wrong = 0;
  for (int k = 0; k < line_cases::release_or(count); ++k) {
    const auto c = line_cases::draw_case<T>(r);
    const auto kept = clip_line_cohen_sutherland(c.a, c.b, c.window);
    visible += kept ? 1 : 0;
    wrong += kept == clip_line_liang_barsky(c.a, c.b, c.window) ? 0 : 1;
  }
  CHECK(wrong == 0);
  CHECK(visible > count / 4);
}

}  // namespace

TEST_CASE("clip_line_cohen_sutherland: by hand, in every life") {
  CHECK_BOTH(gives({1, 1}, {2, 2}, {1, 1}, {2, 2}));
  CHECK_BOTH(gives({-1, -1}, {5, 5}, {0, 0}, {3, 3}));
  CHECK_BOTH(gives({-2, 1}, {4, 4}, {0, 2}, {2, 3}));
  CHECK_BOTH(gives({-1, 1}, {1, -1}, {0, 0}, {0, 0}));
  CHECK_BOTH(!clip_line_cohen_sutherland(P{-2, 1}, P{1, -2}, window));
  CHECK_BOTH(!clip_line_cohen_sutherland(P{1, 1}, P{2, 2}, box<double, 2>{}));
  volatile double minus_two = -2;
  CHECK(gives({minus_two, 1}, {4, 4}, {0, 2}, {2, 3}));
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, inf, -inf}) {
    CHECK(!clip_line_cohen_sutherland(P{bad, 1}, P{1, 1}, window));
    CHECK(!clip_line_cohen_sutherland(P{9, 1}, P{1, bad}, window));
  }
}

TEST_CASE("clip_line_cohen_sutherland: an end rounded to a corner is told by the exact line") {
  // Left of the corner's ray by less than any double can say at the boundary.
  const P a{-1, -1e-30}, b{1, 1e-30};
  CHECK(gives(a, b, {0, 0}, {1, 1e-30}));
  CHECK(gives({-1, -1e-30}, {1, 2e-30}, {0, 5e-31}, {1, 2e-30}));
  const box<double, 2> high{{0, 1}, {4, 3}};
  // At x = 0 the line is at 1 - 1e-30: it enters through the lower boundary, later.
  const auto kept = clip_line_cohen_sutherland(P{-1, 1 - 0x1p-53}, P{0x1p60, 1 + 0x1p-52}, high);
  CHECK(kept == clip_line_liang_barsky(P{-1, 1 - 0x1p-53}, P{0x1p60, 1 + 0x1p-52}, high));
  CHECK(!kept);
}

TEST_CASE("clip_line_cohen_sutherland: the bits of Liang and Barsky") {
  as_liang_barsky<double>(11, 60000);
  as_liang_barsky<float>(12, 60000);
  test::random r(13);
  int wrong = 0;
  for (int k = 0; k < line_cases::release_or(60000); ++k) {
    const auto c = [&] { return static_cast<int>(r.integer(-9, 9)); };
    const point<int, 2> a{c(), c()}, b{c(), c()}, p{c(), c()}, q{c(), c()};
    const auto w = irg::enclosing_box(irg::enclosing_box(box<int, 2>{}, p), q);
    wrong += clip_line_cohen_sutherland(a, b, w) == clip_line_liang_barsky(a, b, w) ? 0 : 1;
  }
  CHECK(wrong == 0);
}
