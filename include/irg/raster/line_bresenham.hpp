// SPDX-License-Identifier: MIT
// line_bresenham: the cells of a straight line, one per step along its longer axis, in integers.
//
// With n steps along the longer axis and m <= n along the shorter one, step i is aside by the integer nearest to
// i * m / n, an exact tie staying on the start point's side:
//     aside(i) = ceil(i*m/n - 1/2) = floor((2*i*m + n - 1) / 2n)
// Because this names every cell without walking to it, a clipped line starts at its first visible cell and has
// exactly the cells that the whole line has in the window.
#pragma once

#include <cstdint>

#include <irg/core/sinks.hpp>
#include <irg/raster/window.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

__extension__ typedef __int128 int128;

// A line seen along its longer axis: `along` counts steps 0..n, `aside` is 0..m; signs lead back to x and y.
struct bresenham_frame {
  std::int64_t n, m;
  int sign_along, sign_aside;
  bool steep;
  cell start;

  IRG_INLINE constexpr cell at(std::int64_t along, std::int64_t aside) const noexcept {
    const std::int64_t a = sign_along * along, b = sign_aside * aside;
    return {static_cast<int>(start.x + (steep ? b : a)), static_cast<int>(start.y + (steep ? a : b))};
  }
  IRG_INLINE constexpr std::int64_t aside_at(std::int64_t i) const noexcept {
    return n == 0 ? 0 : static_cast<std::int64_t>((int128{2} * i * m + n - 1) / (int128{2} * n));
  }
};

constexpr bresenham_frame frame_of(cell a, cell b) noexcept {
  const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
  const std::int64_t width = dx < 0 ? -dx : dx, height = dy < 0 ? -dy : dy;
  const int sx = dx < 0 ? -1 : 1, sy = dy < 0 ? -1 : 1;
  const bool steep = height >= width;  // 45 degrees counts as steep, as in the course's text
  return steep ? bresenham_frame{height, width, sy, sx, true, a} : bresenham_frame{width, height, sx, sy, false, a};
}

struct step_range {
  std::int64_t first, last;
};

// The steps t >= 0 for which start + sign * t lies in [low, high).
constexpr step_range steps_within(std::int64_t start, int sign, std::int64_t low, std::int64_t high) noexcept {
  return sign > 0 ? step_range{greater(low - start, std::int64_t{0}), high - start}
                  : step_range{greater(start - high + 1, std::int64_t{0}), start - low + 1};
}

// The first step whose aside is >= k, for k >= 1 and m >= 1: i*m/n > k - 1/2.
constexpr std::int64_t first_step_aside(const bresenham_frame& f, std::int64_t k) noexcept {
  return static_cast<std::int64_t>((int128{2} * k - 1) * f.n / (int128{2} * f.m)) + 1;
}

// The steps [first, last) of a line that lie in a window: a run, because a line is monotone in both axes.
constexpr step_range visible_steps(const bresenham_frame& f, const cell_window& w) noexcept {
  const step_range x = steps_within(f.start.x, f.steep ? f.sign_aside : f.sign_along, w.x_first, w.x_last);
  const step_range y = steps_within(f.start.y, f.steep ? f.sign_along : f.sign_aside, w.y_first, w.y_last);
  const step_range along = f.steep ? y : x, aside = f.steep ? x : y;
  step_range steps{along.first, lesser(along.last, f.n + 1)};
  if (aside.first > f.m || aside.last <= 0) return {0, 0};
  if (aside.first > 0) steps.first = greater(steps.first, first_step_aside(f, aside.first));
  if (aside.last <= f.m) steps.last = lesser(steps.last, first_step_aside(f, aside.last));
  return steps;
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// Calls emit(cell) for the cells of the line from a to b that lie in the window, in the order from a to b.
/// shape   8-connected; of the whole line, max(|dx|, |dy|) + 1 cells, both ends among them
/// gives   no call when the line misses the window or the window is empty
/// exact   for all int coordinates; clipped cells are the unclipped line's; ties stay on the side of a
/// cost    one addition per visible cell and four divisions per line, whatever its length
/// source  Bresenham 1965; Kuzmin 1995 for entering the window exactly
template <CellSink Sink>
constexpr void line_bresenham(cell a, cell b, const cell_window& window, Sink&& emit) {
  if (window.empty()) return;
  const detail::bresenham_frame f = detail::frame_of(a, b);
  const detail::step_range steps = detail::visible_steps(f, window);
  if (steps.first >= steps.last) return;
  std::int64_t aside = f.aside_at(steps.first);
  // error = 2*i*m - 2*n*aside + 2*m - n: positive when step i + 1 is nearer to aside + 1.
  auto error =
      static_cast<std::int64_t>(detail::int128{2} * (steps.first + 1) * f.m - detail::int128{2} * f.n * aside - f.n);
  for (std::int64_t i = steps.first; i < steps.last; ++i) {
    emit(f.at(i, aside));
    if (error > 0) {
      ++aside;
      error -= 2 * f.n;
    }
    error += 2 * f.m;
  }
}

/// Writes the pixels of the line from a to b, both ends included, that lie in the window.
template <WritableRaster R>
constexpr void draw_line(R& raster, cell a, cell b, const pixel_of<R>& value, const cell_window& window) {
  line_bresenham(a, b, intersect(window, window_of(raster)), [&](cell c) { set_pixel(raster, c.x, c.y, value); });
}

/// Writes the pixels of the line from a to b, both ends included.
template <WritableRaster R>
constexpr void draw_line(R& raster, cell a, cell b, const pixel_of<R>& value) {
  draw_line(raster, a, b, value, window_of(raster));
}

}  // namespace IRG_ABI
}  // namespace irg
