// SPDX-License-Identifier: MIT
// line_subpixel: the cells of a line whose ends lie between pixels, in 1/256 pixel. Two rules: the nearest centre in
// every column (row) that the line passes, and the diamond-exit rule of OpenGL and Vulkan. Both are exact.
//
// A diamond-exit line has at most one cell per step of its longer axis, and it is the nearest one: a line no steeper
// than 45 degrees that passes a column's centre line does so inside a diamond and touches no other diamond of that
// column. The two rules differ in ties and in the cells at the ends only, so one walk serves both.
#pragma once

#include <irg/raster/detail/line_frame.hpp>
#include <irg/raster/paint.hpp>

namespace irg {

/// Which cells belong to a line with sub-pixel ends.
enum class line_rule {
  nearest,  // one per column (rows, from 45 degrees up) whose centre lies between the ends: the nearest to the line
  diamond_exit,  // those whose diamond |x - xc| + |y - yc| < 1/2 the line leaves
};

/// The choices for a line with sub-pixel ends. diamond_exit fixes ends and ties itself and reads neither.
struct line_subpixel_options {
  line_rule rule = line_rule::nearest;
  line_ends ends = line_ends::closed;  // whether a centre exactly level with b counts as between the ends
  line_ties ties = line_ties::start_side;
  bool operator==(const line_subpixel_options&) const = default;
};

namespace detail::inline IRG_ABI {

// Column or row c seen from the other side: cells keep their centres at +128.
IRG_INLINE constexpr std::int64_t mirrored_cell(std::int64_t c, int sign) noexcept { return sign > 0 ? c : -1 - c; }

// A line turned so that it runs to the right and not up, at most at 45 degrees. Column c has the row
// floor((at_zero + c * dv) / du): the line's height there in 1/256 pixel, less than a step of which decides the tie.
struct subpixel_walk {
  std::int64_t at_zero = 0, du = 1, dv = 0;
  std::int64_t first = 0, last = 0;  // columns
  int sign_along = 1, sign_aside = 1;
  bool steep = false;

  IRG_INLINE constexpr cell at(std::int64_t column, std::int64_t row) const noexcept {
    const int a = static_cast<int>(mirrored_cell(column, sign_along));
    const int b = static_cast<int>(mirrored_cell(row, sign_aside));
    return steep ? cell{b, a} : cell{a, b};
  }
};

// Where a point stands in its cell after the infinitesimal move by (-e, -e^2) that takes it off every boundary.
struct diamond_place {
  std::int64_t x, y;  // the cell
  bool right_of_centre, below_centre, inside;  // inside: in the cell's diamond
};

constexpr diamond_place diamond_place_of(const subpixel& p) noexcept {
  const std::int64_t x = (p.x - 1) >> subpixel_bits, y = (p.y - 1) >> subpixel_bits;
  const std::int64_t dx = p.x - (x * one_pixel + half_pixel), dy = p.y - (y * one_pixel + half_pixel);
  const std::int64_t distance = (dx < 0 ? -dx : dx) + (dy < 0 ? -dy : dy);
  return {x, y, dx > 0, dy > 0, distance < half_pixel || (distance == half_pixel && dx > 0)};
}

// The columns that a diamond-exit line draws, seen along the walk.
constexpr void set_diamond_columns(subpixel_walk& w, const subpixel& a, const subpixel& b) noexcept {
  const diamond_place from = diamond_place_of(a), to = diamond_place_of(b);
  const auto past_centre = [&](const diamond_place& p) {
    return (w.steep ? p.below_centre : p.right_of_centre) == (w.sign_along > 0);
  };
  w.first = mirrored_cell(w.steep ? from.y : from.x, w.sign_along) + (past_centre(from) && !from.inside ? 1 : 0);
  w.last = mirrored_cell(w.steep ? to.y : to.x, w.sign_along) + (past_centre(to) && !to.inside ? 1 : 0);
}

// 1 when a height exactly between two rows of the walk goes to the farther one, 0 when to the one before.
constexpr int subpixel_tie(const subpixel_walk& w, const line_subpixel_options& options) noexcept {
  if (options.rule == line_rule::diamond_exit) {
    // The move by (-e, -e^2) takes a steep line to the left, and a flat one up unless it falls to the right.
    if (w.steep || w.dv == 0) return w.sign_aside < 0 ? 1 : 0;
    return w.sign_along > 0 ? 1 : 0;
  }
  return w.dv == 0 || (options.ties == line_ties::symmetric && w.sign_along < 0) ? 1 : 0;
}

constexpr subpixel_walk subpixel_walk_of(const subpixel& a, const subpixel& b,
                                         const line_subpixel_options& options) noexcept {
  const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
  const std::int64_t width = dx < 0 ? -dx : dx, height = dy < 0 ? -dy : dy;
  subpixel_walk w;
  w.steep = height >= width;  // 45 degrees counts as steep, as for whole cells
  w.sign_along = (w.steep ? dy : dx) < 0 ? -1 : 1;
  w.sign_aside = (w.steep ? dx : dy) < 0 ? -1 : 1;
  w.du = maximum(maximum(width, height), std::int64_t{1});
  w.dv = minimum(width, height);
  const std::int64_t u = std::int64_t{w.sign_along} * (w.steep ? a.y : a.x);
  const std::int64_t v = std::int64_t{w.sign_aside} * (w.steep ? a.x : a.y);
  w.at_zero = (v * w.du + (half_pixel - u) * w.dv - 1 + subpixel_tie(w, options)) >> subpixel_bits;
  if (options.rule == line_rule::diamond_exit) {
    set_diamond_columns(w, a, b);
  } else {
    const std::int64_t end = u + maximum(width, height) + (options.ends == line_ends::closed ? 1 : 0);
    w.first = (u + half_pixel - 1) >> subpixel_bits;  // the first centre at or after the start
    w.last = (end + half_pixel - 1) >> subpixel_bits;  // the first one past the end
  }
  return w;
}

// Cuts the columns to those whose cells lie in the window: a run, because rows never fall.
constexpr void clip_walk(subpixel_walk& w, const cell_window& window) noexcept {
  const step_range x = turned(window.x_first, window.x_last, (w.steep ? w.sign_aside : w.sign_along) < 0);
  const step_range y = turned(window.y_first, window.y_last, (w.steep ? w.sign_along : w.sign_aside) < 0);
  const step_range along = w.steep ? y : x, aside = w.steep ? x : y;
  w.first = maximum(w.first, along.first);
  w.last = minimum(w.last, along.last);
  if (w.dv > 0) {
    w.first = maximum(w.first, ceil_div(aside.first * w.du - w.at_zero, w.dv));
    w.last = minimum(w.last, ceil_div(aside.last * w.du - w.at_zero, w.dv));
  } else if (w.at_zero < aside.first * w.du || w.at_zero >= aside.last * w.du) {
    w.last = w.first;
  }
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// Calls sink(cell) for the cells of the line from a to b that lie in the window, in the order from a to b.
/// shape   8-connected, one cell per column whose centre lies between the ends (per row, from 45 degrees up)
/// units   points in pixels, snapped to 1/256 pixel once; pixel (0, 0) has its centre at (128, 128) of these
/// gives   false, and no call, when a position cannot be snapped; else true. No call when the line misses the window,
///         or passes no centre because it is too short
/// exact   clipped cells are the unclipped line's; a height half-way between two centres goes where the options say,
///         on a level line to the greater row (column), with diamond_exit as if both ends were moved by (-e, -e^2)
/// cost    one addition per visible cell and three divisions per line, whatever its length
/// source  Vulkan 1.3, "Bresenham line segment rasterization", and OpenGL 4.6, 14.5.1, for diamond_exit
template <ScreenPosition P, CellSink Sink>
constexpr bool line_subpixel(const P& a, const P& b, const cell_window& window, Sink&& sink,
                             const line_subpixel_options& options = {}) {
  if (!can_snap(a) || !can_snap(b)) return false;
  if (window.empty()) return true;
  detail::subpixel_walk w = detail::subpixel_walk_of(snap(a), snap(b), options);
  detail::clip_walk(w, window);
  if (w.first >= w.last) return true;
  const std::int64_t height = w.at_zero + w.first * w.dv;
  std::int64_t row = height >= 0 ? height / w.du : -((-height + w.du - 1) / w.du);
  std::int64_t rest = height - row * w.du;  // in [0, du)
  for (std::int64_t column = w.first; column < w.last; ++column) {
    sink(w.at(column, row));
    rest += w.dv;
    if (rest >= w.du) {
      ++row;
      rest -= w.du;
    }
  }
  return true;
}

/// Paints the pixels of the line from a to b.
/// gives   false, and no pixel, when a position cannot be snapped
/// exact   the cells of line_subpixel with the same options
template <WritableRaster R, ScreenPosition P, PaintFor<R> Paint = pixel_of<R>>
constexpr bool draw_line_subpixel(R& raster, const P& a, const P& b, const Paint& paint,
                                  const line_subpixel_options& options = {}) {
  return line_subpixel(a, b, window_of(raster), [&](cell c) { paint_pixel(raster, c.x, c.y, paint); }, options);
}

}  // namespace IRG_ABI
}  // namespace irg
