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

#include <irg/core/sinks.hpp>
#include <irg/raster/subpixel.hpp>
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
                                       Sink&& sink);

/// Paints the region around the seed that has the seed's value: all cells connected to it with an equal pixel. Returns
/// their number.
/// gives   0, and nothing painted, when the seed is outside of the raster's window, or its pixel does not equal itself
///         (NaN). The same region and number whatever the paint, also one that leaves pixels as they are
/// cost    as seed_fill_spans
template <WritableRaster R, CellOrPosition P = cell, PaintFor<R> Paint = pixel_of<R>>
  requires std::equality_comparable<pixel_of<R>>
constexpr std::int64_t flood_fill(R& raster, const P& place, const Paint& paint,
                                  neighbours next_to = neighbours::four) {
  const cell seed = as_cell(place);
  const cell_window w = window_of(raster);
  if (seed.x < w.x_first || seed.x >= w.x_last || seed.y < w.y_first || seed.y >= w.y_last) return 0;
  const pixel_of<R> value = get_pixel(raster, seed.x, seed.y);
  return seed_fill_spans(
      w, [&](const cell& c) { return get_pixel(raster, c.x, c.y) == value; }, seed, next_to,
      [&](const span_of_cells& s) { fill_span(raster, s, paint); });
}

/// Paints the region around the seed up to pixels of the boundary's value, whatever else it has. Returns the number of
/// its cells.
/// gives   0, and nothing painted, when the seed is outside of the raster's window, or on the boundary. Pixels that
///         have the paint's value already are no boundary
/// cost    as seed_fill_spans
template <WritableRaster R, CellOrPosition P = cell, PaintFor<R> Paint = pixel_of<R>>
  requires std::equality_comparable<pixel_of<R>>
constexpr std::int64_t boundary_fill(R& raster, const P& seed, const pixel_of<R>& boundary, const Paint& paint,
                                     neighbours next_to = neighbours::four) {
  const pixel_of<R> edge = boundary;  // a copy: the argument may be one of the pixels that are painted
  return seed_fill_spans(
      window_of(raster), [&](const cell& c) { return !(get_pixel(raster, c.x, c.y) == edge); }, as_cell(seed), next_to,
      [&](const span_of_cells& s) { fill_span(raster, s, paint); });
}

}  // namespace IRG_ABI

namespace detail::inline IRG_ABI {

// One bit per cell of a window: set once the cell has been asked about. Columns count from the window's first one.
class seed_marks {
public:
  constexpr explicit seed_marks(const cell_window& w)
      : y_first_(w.y_first), words_per_row_((std::int64_t{w.x_last} - w.x_first + 63) / 64),
        words_(countable(words_per_row_ * (std::int64_t{w.y_last} - w.y_first)), 0) {}

  constexpr std::uint64_t* row(int y) noexcept { return words_.data() + (std::int64_t{y} - y_first_) * words_per_row_; }
  static constexpr bool is_marked(const std::uint64_t* row, std::int64_t i) noexcept {
    return (row[i >> 6] >> (i & 63) & 1) != 0;
  }
  // Marks the columns i to j - 1; i < j.
  static constexpr void mark(std::uint64_t* row, std::int64_t i, std::int64_t j) noexcept {
    --j;
    const std::uint64_t from = ~std::uint64_t{0} << (i & 63), to = ~std::uint64_t{0} >> (63 - (j & 63));
    if (i >> 6 == j >> 6) {
      row[i >> 6] |= from & to;
      return;
    }
    row[i >> 6] |= from;
    for (std::int64_t k = (i >> 6) + 1; k < j >> 6; ++k) row[k] = ~std::uint64_t{0};
    row[j >> 6] |= to;
  }
  // The first column from i on that is not marked; end when there is none before it.
  static constexpr std::int64_t next_unmarked(const std::uint64_t* row, std::int64_t i, std::int64_t end) noexcept {
    while (i < end) {
      const std::uint64_t unmarked = ~row[i >> 6] >> (i & 63);
      if (unmarked != 0) return minimum(i + std::countr_zero(unmarked), end);
      i = (i | 63) + 1;
    }
    return end;
  }

private:
  // More words than a size_t of 32 bits can count become as many as no vector holds, so that it refuses them.
  static constexpr std::size_t countable(std::int64_t words) noexcept {
    return static_cast<std::size_t>(minimum<std::int64_t>(words, (std::numeric_limits<std::ptrdiff_t>::max)()));
  }

  std::int64_t y_first_, words_per_row_;
  std::vector<std::uint64_t> words_;
};

// What one call of seed_fill_spans is made of.
template <class Inside, class Sink>
struct seed_filler {
  const cell_window& window;
  Inside& inside;
  Sink& sink;
  seed_marks marks;
  std::vector<span_of_cells> found;  // runs whose neighbours are not searched yet
  std::int64_t cells = 0;

  constexpr bool belongs(std::int64_t i, int y) const {
    return static_cast<bool>(inside(cell{static_cast<int>(i + window.x_first), y}));
  }

  // Emits the run of the cell in column i, which is inside, and marks it and the cells that end it. Returns the column
  // after them.
  constexpr std::int64_t take_run(std::uint64_t* row, std::int64_t i, int y) {
    const std::int64_t width = std::int64_t{window.x_last} - window.x_first;
    std::int64_t first = i, last = i + 1, asked_first = i, asked_last = last;
    while (asked_first == first && first > 0 && !seed_marks::is_marked(row, first - 1))
      if (belongs(--asked_first, y)) first = asked_first;
    while (asked_last == last && last < width && !seed_marks::is_marked(row, last))
      if (++asked_last; belongs(last, y)) last = asked_last;
    seed_marks::mark(row, asked_first, asked_last);
    const span_of_cells run{y, static_cast<int>(first + window.x_first), static_cast<int>(last + window.x_first)};
    found.push_back(run);
    cells += last - first;
    sink(run);
    return asked_last;
  }

  // Takes all runs of row y that have a cell in the columns first to last - 1.
  constexpr void search(int y, int first, int last) {
    std::uint64_t* const row = marks.row(y);
    const std::int64_t end = std::int64_t{last} - window.x_first;
    std::int64_t i = seed_marks::next_unmarked(row, std::int64_t{first} - window.x_first, end);
    while (i < end) {
      std::int64_t next = i + 1;
      if (belongs(i, y))
        next = take_run(row, i, y);
      else
        seed_marks::mark(row, i, next);
      i = seed_marks::next_unmarked(row, next, end);
    }
  }
};

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

template <CellPredicate Inside, SpanSink Sink>
constexpr std::int64_t seed_fill_spans(const cell_window& window, Inside&& inside, cell seed, neighbours next_to,
                                       Sink&& sink) {
  if (seed.x < window.x_first || seed.x >= window.x_last || seed.y < window.y_first || seed.y >= window.y_last)
    return 0;
  if (!static_cast<bool>(inside(seed))) return 0;
  detail::seed_filler<std::remove_reference_t<Inside>, std::remove_reference_t<Sink>> fill{
      window, inside, sink, detail::seed_marks(window), {}};
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

}  // namespace IRG_ABI
}  // namespace irg
