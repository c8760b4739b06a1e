// SPDX-License-Identifier: MIT
#include <irg/geometry/clip_line_cohen_sutherland.hpp>

#include <irg/geometry/clip_line_liang_barsky.hpp>

#include "line_clip_cases.hpp"
#include "support/check_both.hpp"

using irg::box;
using irg::clip_line_cohen_sutherland;
using P = irg::point<double, 2>;

namespace {
constexpr auto clip = [](const auto& a, const auto& b, const auto& window) {
  return clip_line_cohen_sutherland(a, b, window);
};
}  // namespace

TEST_CASE("clip_line_cohen_sutherland: by hand, in every life") {
  CHECK_BOTH(line_cases::does_by_hand(clip));
  line_cases::check_refusals(clip);
}

TEST_CASE("clip_line_cohen_sutherland: an end rounded to a corner is told by the exact line") {
  // Left of the corner's ray by less than any double can say at the boundary.
  constexpr box<double, 2> window{{0, 0}, {4, 3}};
  const auto gives = [&](P from, P to, P first, P second) {
    const auto kept = clip(from, to, window);
    return kept && kept->first == first && kept->second == second;
  };
  CHECK(gives({-1, -1e-30}, {1, 1e-30}, {0, 0}, {1, 1e-30}));
  CHECK(gives({-1, -1e-30}, {1, 2e-30}, {0, 5e-31}, {1, 2e-30}));
  const box<double, 2> high{{0, 1}, {4, 3}};
  // At x = 0 the line is at 1 - 1e-30: it enters through the lower boundary, later.
  const auto kept = clip(P{-1, 1 - 0x1p-53}, P{0x1p60, 1 + 0x1p-52}, high);
  CHECK(kept == clip_line_liang_barsky(P{-1, 1 - 0x1p-53}, P{0x1p60, 1 + 0x1p-52}, high));
  CHECK(!kept);
}

TEST_CASE("clip_line_cohen_sutherland: the bits of Liang and Barsky") {
  line_cases::check_as_liang_barsky<double>(clip, 11, 60000);
  line_cases::check_as_liang_barsky<float>(clip, 12, 60000);
  line_cases::check_as_liang_barsky<int>(clip, 13, 60000);
}
