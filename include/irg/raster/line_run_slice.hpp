// SPDX-License-Identifier: MIT
// line_run_slice: a straight line as its runs of cells in one row or column, for those who can draw a run at once.
//
// A line of n steps along and m aside has at most m + 1 runs. The one at aside k begins at the first step i with
// i * m / n > k - 1/2: at floor(((2k - 1) * n - tie) / 2m) + 1. From run to run the numerator grows by 2n; so a run has
// n / m cells, or one more when the remainders carry.
#pragma once

#include <cstdint>

#include <irg/raster/detail/line_frame.hpp>

namespace irg {

/// Cells of one row or one column, from the first to the last, both included. Lines driven by x have runs in rows,
/// those driven by y in columns.
struct line_run {
  cell first, last;  // cells of the line, not bounds: `last` is drawn, too, where that of windows and spans is not
  friend constexpr bool operator==(const line_run&, const line_run&) = default;
};

/// Receives runs of a line's cells, one call each.
template <class S>
concept LineRunSink = requires(S& sink, const line_run run) { sink(run); };

namespace detail::inline IRG_ABI {

template <class Sink>
constexpr void emit_runs(const bresenham_frame& f, const step_range& steps, Sink& sink) {
  if (steps.first >= steps.last) return;
  if (f.m == 0) return static_cast<void>(sink(line_run{f.at(steps.first, 0), f.at(steps.last - 1, 0)}));
  std::int64_t aside = f.aside_at(steps.first), first = steps.first;
  const int128 numerator = (int128{2} * aside + 1) * f.n - f.tie, denominator = int128{2} * f.m;
  const std::int64_t quotient = f.n / f.m, remainder = f.n % f.m;
  std::int64_t next = static_cast<std::int64_t>(numerator / denominator) + 1;  // where the next run begins
  auto rest = static_cast<std::int64_t>(numerator % denominator);
  while (next < steps.last) {
    sink(line_run{f.at(first, aside), f.at(next - 1, aside)});
    first = next;
    ++aside;
    next += quotient;
    rest += 2 * remainder;
    if (rest >= 2 * f.m) {
      rest -= 2 * f.m;
      ++next;
    }
  }
  sink(line_run{f.at(first, aside), f.at(steps.last - 1, aside)});
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// Calls sink(line_run) for the runs of the line from a to b that lie in the window, in the order from a to b.
/// shape   one run per row of a line with |dx| > |dy|, one per column of any other; 45 degrees has runs of one cell
/// gives   no call when the line misses the window or the window is empty; runs are cut where they leave the window
/// exact   the cells of line_bresenham with the same options, for all int coordinates
/// cost    two additions per run and six divisions per line, whatever the length of its runs
/// source  Bresenham 1985; Abrash 1992
template <LineRunSink Sink>
constexpr void line_run_slice(cell a, cell b, const cell_window& window, Sink&& sink,
                              const line_options& options = {}) {
  if (window.empty()) return;
  const detail::bresenham_frame f = detail::frame_of(a, b, options.ties);
  detail::emit_runs(f, detail::visible_steps(f, window, options.ends), sink);
}

/// Calls sink(line_run) for all runs of the line, up to 2^32 of them.
template <LineRunSink Sink>
constexpr void line_run_slice(cell a, cell b, Sink&& sink, const line_options& options = {}) {
  const detail::bresenham_frame f = detail::frame_of(a, b, options.ties);
  detail::emit_runs(f, {0, detail::steps_drawn(f, options.ends)}, sink);
}

}  // namespace IRG_ABI
}  // namespace irg
