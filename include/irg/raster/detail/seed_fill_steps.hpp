// SPDX-License-Identifier: MIT
// The steps of seed_fill.hpp.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <irg/core/sinks.hpp>
#include <irg/raster/fill_span.hpp>
#include <irg/raster/window.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// One bit per cell of a window: set once the cell has been asked about. Columns count from the window's first one.
template <class Word = std::uint64_t>
class seed_marks {
public:
  constexpr explicit seed_marks(const cell_window& w)
      : y_first_(w.y_first), words_per_row_((std::int64_t{w.x_last} - w.x_first + 63) / 64),
        words_(countable(words_per_row_ * (std::int64_t{w.y_last} - w.y_first)), 0) {}

  constexpr Word* row(int y) noexcept { return words_.data() + (std::int64_t{y} - y_first_) * words_per_row_; }
  static constexpr bool is_marked(const Word* row, std::int64_t i) noexcept {
    return (row[i >> 6] >> (i & 63) & 1) != 0;
  }
  // Marks the columns i to j - 1; i < j.
  static constexpr void mark(Word* row, std::int64_t i, std::int64_t j) noexcept {
    --j;
    const Word from = ~Word{0} << (i & 63), to = ~Word{0} >> (63 - (j & 63));
    if (i >> 6 == j >> 6) {
      row[i >> 6] |= from & to;
      return;
    }
    row[i >> 6] |= from;
    for (std::int64_t k = (i >> 6) + 1; k < j >> 6; ++k) row[k] = ~Word{0};
    row[j >> 6] |= to;
  }
  // The first column from i on that is not marked; end when there is none before it.
  static constexpr std::int64_t next_unmarked(const Word* row, std::int64_t i, std::int64_t end) noexcept {
    while (i < end) {
      const Word unmarked = ~row[i >> 6] >> (i & 63);
      if (unmarked != 0) return lesser(i + std::countr_zero(unmarked), end);
      i = (i | 63) + 1;
    }
    return end;
  }

private:
  // More words than a size_t of 32 bits can count become as many as no vector holds, so that it refuses them.
  static constexpr std::size_t countable(std::int64_t words) noexcept {
    return static_cast<std::size_t>(lesser<std::int64_t>(words, (std::numeric_limits<std::ptrdiff_t>::max)()));
  }

  std::int64_t y_first_, words_per_row_;
  std::vector<Word> words_;
};

// What one call of seed_fill_spans is made of.
template <class Inside, class Sink>
struct seed_filler {
  const cell_window& window;
  Inside& inside;
  Sink& sink;
  seed_marks<> marks;
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
    while (asked_first == first && first > 0 && !seed_marks<>::is_marked(row, first - 1))
      if (belongs(--asked_first, y)) first = asked_first;
    while (asked_last == last && last < width && !seed_marks<>::is_marked(row, last))
      if (++asked_last; belongs(last, y)) last = asked_last;
    seed_marks<>::mark(row, asked_first, asked_last);
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
    std::int64_t i = seed_marks<>::next_unmarked(row, std::int64_t{first} - window.x_first, end);
    while (i < end) {
      std::int64_t next = i + 1;
      if (belongs(i, y))
        next = take_run(row, i, y);
      else
        seed_marks<>::mark(row, i, next);
      i = seed_marks<>::next_unmarked(row, next, end);
    }
  }
};

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
