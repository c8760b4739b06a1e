// SPDX-License-Identifier: MIT
#include <irg/geometry/clip_line_nicholl_lee_nicholl.hpp>

#include <irg/geometry/clip_line_liang_barsky.hpp>

#include "line_clip_cases.hpp"
#include "support/check_both.hpp"

using irg::box;
using irg::clip_line_nicholl_lee_nicholl;
using P = irg::point<double, 2>;

namespace {
constexpr auto clip = [](const auto& a, const auto& b, const auto& window) {
  return clip_line_nicholl_lee_nicholl(a, b, window);
};
}  // namespace

TEST_CASE("clip_line_nicholl_lee_nicholl: by hand, in every life") {
  CHECK_BOTH(line_cases::does_by_hand(clip));
  line_cases::check_refusals(clip);
}

TEST_CASE("clip_line_nicholl_lee_nicholl: from every region to every region") {
  // Places left of, on, in and beyond the window, along each axis: 625 segments, each against rationals' decision.
  constexpr box<double, 2> window{{0, 0}, {4, 3}};
  const double xs[] = {-2, 0, 1, 4, 6}, ys[] = {-3, 0, 2, 3, 4};
  int visible = 0;
  for (const double ax : xs)
    for (const double ay : ys)
      for (const double bx : xs)
        for (const double by : ys) {
          const auto kept = clip(P{ax, ay}, P{bx, by}, window);
          CHECK(kept == clip_line_liang_barsky(P{ax, ay}, P{bx, by}, window));
          visible += kept ? 1 : 0;
        }
  CHECK(visible == 465);
}

TEST_CASE("clip_line_nicholl_lee_nicholl: the bits of Liang and Barsky") {
  line_cases::check_as_liang_barsky<double>(clip, 21, 60000);
  line_cases::check_as_liang_barsky<float>(clip, 22, 60000);
  line_cases::check_as_liang_barsky<int>(clip, 23, 60000);
}
