// SPDX-License-Identifier: MIT
// Seed fill: the cells that can be reached from a seed without leaving a region, found run by run.
//
// A run is a longest row of cells that belong together. A run is marked and emitted when it is found; later the rows
// above and below it are searched for further ones. Cells are marked when they are asked about, so each is asked about
// once and emitted once, whatever the sink or the paint makes of it, and there is no recursion.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <irg/raster/cell_position.hpp>
#include <irg/raster/detail/seed_fill_steps.hpp>
#include <irg/raster/fill_span.hpp>
#include <irg/raster/window.hpp>

namespace irg {

/// Which cells are next to each other: those that share a side, or those that share a corner, too.
enum class neighbours { four, eight };

/// inside(cell) tells whether a cell belongs to a region.
template <class F>
concept CellPredicate = requires(F& inside, const cell c) {
  { inside(c) } -> std::convertible_to<bool>;
};

inline namespace IRG_ABI {

/// Calls sink(span) for every run of the region: the cells of the window that can be reached from the seed over
/// neighbouring cells that are all inside. Returns the number of cells.
/// shape   spans do not overlap; each is as long as the region and the window let it be; their order is not specified
/// needs   nothing of inside: it is asked about each cell of the window at most once, and before that is emitted
/// gives   0, and no call, when the seed is outside of the window or not inside the region
/// cost    one question per cell of the region and per cell beside it. Memory: one bit per cell of the window, whose
///         rows take whole words of 64, and 24 bytes per run of the front at most, which is never more than
///         height * (width + 1) / 2 runs
/// source  Smith 1979; Heckbert 1990: runs in place of cells
template <CellPredicate Inside, SpanSink Sink>
constexpr std::int64_t seed_fill_spans(const cell_window& window, Inside&& inside, cell seed, neighbours next_to,
                                       Sink&& sink) {
  if (seed.x < window.x_first || seed.x >= window.x_last || seed.y < window.y_first || seed.y >= window.y_last)
    return 0;
  if (!static_cast<bool>(inside(seed))) return 0;
  detail::seed_filler<std::remove_reference_t<Inside>, std::remove_reference_t<Sink>> fill{
      window, inside, sink, detail::seed_marks<>(window), {}};
  const int reach = next_to == neighbours::eight ? 1 : 0;
  fill.take_run(fill.marks.row(seed.y), std::int64_t{seed.x} - window.x_first, seed.y);
  std::vector<span_of_cells> front;  // from front to front, not depth first: fronts are short, and stay in the caches
  while (!fill.found.empty()) {
    front.swap(fill.found);
    fill.found.clear();
    for (const span_of_cells& run : front) {
      const int first = run.x_first > window.x_first ? run.x_first - reach : run.x_first;
      const int last = run.x_last < window.x_last ? run.x_last + reach : run.x_last;
      if (run.y > window.y_first) fill.search(run.y - 1, first, last);
      if (run.y < window.y_last - 1) fill.search(run.y + 1, first, last);
    }
  }
  return fill.cells;
}

/// Paints the region around the seed that has the seed's value: all cells connected to it with an equal pixel. Returns
/// their number.
/// gives   0, and nothing painted, when the seed is outside of the raster's window, or its pixel does not equal itself
///         (NaN). The same region and number whatever the paint, also one that leaves pixels as they are
/// cost    as seed_fill_spans
template <WritableRaster R, PaintFor<R> Paint = pixel_of<R>>
  requires std::equality_comparable<pixel_of<R>>
constexpr std::int64_t flood_fill(R& raster, cell seed, const Paint& paint, neighbours next_to = neighbours::four) {
  const cell_window w = window_of(raster);
  if (seed.x < w.x_first || seed.x >= w.x_last || seed.y < w.y_first || seed.y >= w.y_last) return 0;
  const pixel_of<R> value = get_pixel(raster, seed.x, seed.y);
  return seed_fill_spans(
      w, [&](const cell& c) { return get_pixel(raster, c.x, c.y) == value; }, seed, next_to,
      [&](const span_of_cells& s) { fill_span(raster, s, paint); });
}

/// The same around a position of another type.
template <WritableRaster R, CellPosition P, PaintFor<R> Paint = pixel_of<R>>
  requires std::equality_comparable<pixel_of<R>>
constexpr std::int64_t flood_fill(R& raster, const P& seed, const Paint& paint, neighbours next_to = neighbours::four) {
  return flood_fill(raster, as_cell(seed), paint, next_to);
}

/// Paints the region around the seed up to pixels of the boundary's value, whatever else it has. Returns the number of
/// its cells.
/// gives   0, and nothing painted, when the seed is outside of the raster's window, or on the boundary. Pixels that
///         have the paint's value already are no boundary
/// cost    as seed_fill_spans
template <WritableRaster R, PaintFor<R> Paint = pixel_of<R>>
  requires std::equality_comparable<pixel_of<R>>
constexpr std::int64_t boundary_fill(R& raster, cell seed, const pixel_of<R>& boundary, const Paint& paint,
                                     neighbours next_to = neighbours::four) {
  const pixel_of<R> edge = boundary;  // a copy: the argument may be one of the pixels that are painted
  return seed_fill_spans(
      window_of(raster), [&](const cell& c) { return !(get_pixel(raster, c.x, c.y) == edge); }, seed, next_to,
      [&](const span_of_cells& s) { fill_span(raster, s, paint); });
}

/// The same around a position of another type.
template <WritableRaster R, CellPosition P, PaintFor<R> Paint = pixel_of<R>>
  requires std::equality_comparable<pixel_of<R>>
constexpr std::int64_t boundary_fill(R& raster, const P& seed, const pixel_of<R>& boundary, const Paint& paint,
                                     neighbours next_to = neighbours::four) {
  return boundary_fill(raster, as_cell(seed), boundary, paint, next_to);
}

}  // namespace IRG_ABI
}  // namespace irg
