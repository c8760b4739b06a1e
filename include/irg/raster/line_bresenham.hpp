// SPDX-License-Identifier: MIT
// line_bresenham: the cells of a straight line, one per step along its longer axis, in integers.
#pragma once

#include <irg/raster/detail/line_frame.hpp>

namespace irg::detail::inline IRG_ABI {

template <class Sink>
constexpr void emit_bresenham(const bresenham_frame& f, const step_range& steps, Sink& sink) {
  if (steps.first >= steps.last) return;
  std::int64_t aside = f.aside_at(steps.first), error = f.error_at(steps.first, aside);
  for (std::int64_t i = steps.first; i < steps.last; ++i) {
    sink(f.at(i, aside));
    if (error > 0) {
      ++aside;
      error -= 2 * f.n;
    }
    error += 2 * f.m;
  }
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

/// Calls sink(cell) for the cells of the line from a to b that lie in the window, in the order from a to b.
/// shape   8-connected; of the whole line, max(|dx|, |dy|) + 1 cells, both ends among them
/// gives   no call when the line misses the window or the window is empty
/// exact   for all int coordinates; clipped cells are the unclipped line's; ties go where the options say
/// cost    one addition per visible cell and four divisions per line, whatever its length
/// source  Bresenham 1965; Kuzmin 1995 for entering the window exactly
template <CellSink Sink>
constexpr void line_bresenham(cell a, cell b, const cell_window& window, Sink&& sink,
                              const line_options& options = {}) {
  if (window.empty()) return;
  const detail::bresenham_frame f = detail::frame_of(a, b, options.ties);
  detail::emit_bresenham(f, detail::visible_steps(f, window, options.ends), sink);
}

/// Calls sink(cell) for all cells of the line, up to 2^32 of them.
template <CellSink Sink>
constexpr void line_bresenham(cell a, cell b, Sink&& sink, const line_options& options = {}) {
  const detail::bresenham_frame f = detail::frame_of(a, b, options.ties);
  detail::emit_bresenham(f, {0, detail::steps_drawn(f, options.ends)}, sink);
}

}  // namespace irg::inline IRG_ABI
