// SPDX-License-Identifier: MIT
// A line as a walk along its longer axis, and the part of the walk that a window sees.
//
// With n steps along the longer axis and m <= n along the shorter one, step i is aside by the integer nearest to
// i * m / n, an exact tie staying on the start's side (tie = 0) or going to the end's (tie = 1):
//     aside(i) = floor((2*i*m + n - 1 + tie) / 2n)
// Because this names every cell without walking to it, a clipped line starts at its first visible cell and has
// exactly the cells that the whole line has in the window.
#pragma once

#include <cstdint>

#include <irg/core/sinks.hpp>
#include <irg/math/floor_division.hpp>
#include <irg/raster/line_style.hpp>
#include <irg/raster/window.hpp>

namespace irg::detail {

// A line seen along its longer axis: `along` counts steps 0..n, `aside` is 0..m; signs lead back to x and y. An exact
// tie stays on the start's side when tie is 0, goes to the end's side when it is 1.
struct bresenham_frame {
  std::int64_t n, m;
  int sign_along, sign_aside;
  bool steep;
  cell start;
  int tie = 0;

  IRG_INLINE constexpr cell at(std::int64_t along, std::int64_t aside) const noexcept {
    const std::int64_t a = sign_along * along, b = sign_aside * aside;
    return {static_cast<int>(start.x + (steep ? b : a)), static_cast<int>(start.y + (steep ? a : b))};
  }
  IRG_INLINE constexpr std::int64_t aside_at(std::int64_t i) const noexcept {
    return n == 0 ? 0 : static_cast<std::int64_t>((int128{2} * i * m + n - 1 + tie) / (int128{2} * n));
  }
  // Positive when step i + 1 lies nearer to aside + 1 than to the aside of step i; from 2*(m - n) + 1 to 2*m.
  IRG_INLINE constexpr std::int64_t error_at(std::int64_t i, std::int64_t aside) const noexcept {
    return static_cast<std::int64_t>(int128{2} * (i + 1) * m - int128{2} * n * aside - n + tie);
  }
};

// The steps from first to last - 1.
struct step_range {
  std::int64_t first, last;
};

inline namespace IRG_ABI {

// steps_drawn: n + 1 of a closed line, n of a half-open one.
constexpr std::int64_t steps_drawn(const bresenham_frame& f, line_ends ends) noexcept {
  return ends == line_ends::closed ? f.n + 1 : f.n;
}

constexpr bresenham_frame frame_of(cell a, cell b, line_ties ties = line_ties::start_side) noexcept {
  const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
  const std::int64_t width = dx < 0 ? -dx : dx, height = dy < 0 ? -dy : dy;
  const int sx = dx < 0 ? -1 : 1, sy = dy < 0 ? -1 : 1;
  const bool steep = height >= width;  // 45 degrees counts as steep, as in Fabris's text
  const int tie = ties == line_ties::symmetric && (steep ? sy : sx) < 0 ? 1 : 0;
  return steep ? bresenham_frame{height, width, sy, sx, true, a, tie}
               : bresenham_frame{width, height, sx, sy, false, a, tie};
}

// The places [first, last) as they are seen from the other side of 0, place c being -1 - c there; or as they are.
constexpr step_range turned(std::int64_t first, std::int64_t last, bool mirrored) noexcept {
  return mirrored ? step_range{-last, -first} : step_range{first, last};
}

// The steps t >= 0 for which start + sign * t lies in [low, high).
constexpr step_range steps_within(std::int64_t start, int sign, std::int64_t low, std::int64_t high) noexcept {
  return sign > 0 ? step_range{maximum(low - start, std::int64_t{0}), high - start}
                  : step_range{maximum(start - high + 1, std::int64_t{0}), start - low + 1};
}

// The first step whose aside is >= k, for k >= 1 and m >= 1: i*m/n > k - 1/2, or equal to it where ties go there.
template <class J>
constexpr std::int64_t first_step_aside(const bresenham_frame& f, std::int64_t k) noexcept {
  return static_cast<std::int64_t>(((J{2} * k - 1) * f.n - f.tie) / (J{2} * f.m)) + 1;
}

// The steps [first, last) of a line that lie in a window: a run, because a line is monotone in both axes. J holds
// 2 * n * m.
template <class J = int128>
constexpr step_range visible_steps(const bresenham_frame& f, const cell_window& w,
                                   line_ends ends = line_ends::closed) noexcept {
  const step_range x = steps_within(f.start.x, f.steep ? f.sign_aside : f.sign_along, w.x_first, w.x_last);
  const step_range y = steps_within(f.start.y, f.steep ? f.sign_along : f.sign_aside, w.y_first, w.y_last);
  const step_range along = f.steep ? y : x, aside = f.steep ? x : y;
  step_range steps{along.first, minimum(along.last, steps_drawn(f, ends))};
  if (aside.first > f.m || aside.last <= 0) return {0, 0};
  if (aside.first > 0) steps.first = maximum(steps.first, first_step_aside<J>(f, aside.first));
  if (aside.last <= f.m) steps.last = minimum(steps.last, first_step_aside<J>(f, aside.last));
  return steps;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
