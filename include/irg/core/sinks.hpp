// SPDX-License-Identifier: MIT
// What rasterizers and clippers send their output to: callables that take one cell, one span or one segment.
#pragma once

#include <concepts>

#include <irg/core/config.hpp>

namespace irg {

/// One pixel of the infinite grid: column x, row y.
struct cell {
  int x = 0, y = 0;
  friend constexpr bool operator==(const cell&, const cell&) = default;
};

/// A run of pixels of row y: the columns x_first to x_last - 1, none when x_last <= x_first.
struct span_of_cells {
  int y = 0, x_first = 0, x_last = 0;
  friend constexpr bool operator==(const span_of_cells&, const span_of_cells&) = default;
};

/// Receives cells, one call each.
template <class S>
concept CellSink = std::invocable<S&, cell>;

/// Receives runs of cells, one call each.
template <class S>
concept SpanSink = std::invocable<S&, span_of_cells>;

/// Receives segments between two points, one call each.
template <class S, class P>
concept SegmentSink = std::invocable<S&, const P&, const P&>;

}  // namespace irg
