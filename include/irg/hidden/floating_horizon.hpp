// SPDX-License-Identifier: MIT
// The floating horizon: a surface y = f(x, z) is drawn as curves, near ones first. In each column of the picture two
// horizons say how far up and how far down curves have reached; of a new curve what lies above the upper or below the
// lower one is seen, and moves the horizon there.
//
// A curve is a row of samples, pixels whose columns change by one at most. Each step from a sample to the next is drawn
// on a horizon when both ends lie on it, or when one end lies on that horizon alone. textbook/floating_horizon.hpp has
// the rules of the source, which draw some lines that no curve has.
#pragma once

#include <cstddef>
#include <vector>

#include <irg/core/sinks.hpp>

namespace irg {

/// The two horizons.
enum class horizon_side { upper, lower };

/// The rows that a column's curves have reached; nothing where `is_set` is false.
struct horizon_column {
  int lower = 0, upper = 0;
  bool is_set = false;
  bool operator==(const horizon_column&) const = default;
};

namespace detail::inline IRG_ABI {

// Moves the horizons to a sample that reaches beyond them.
template <class Column>
constexpr void extend_horizon(Column& c, int row) noexcept {
  if (!c.is_set)
    c = {row, row, true};
  else if (row > c.upper)
    c.upper = row;
  else if (row < c.lower)
    c.lower = row;
}

}  // namespace detail::inline IRG_ABI

/// The horizons of all columns, and the curve that is being drawn.
/// shape   columns 0 to columns() - 1; y points up
/// source  Special-cases chapter, 2.1, with its equality test made strict
template <class Column = horizon_column>
class floating_horizon {
public:
  IRG_APART constexpr explicit floating_horizon(int columns)
      : columns_(static_cast<std::size_t>(columns < 0 ? 0 : columns), Column{}) {}

  [[nodiscard]] IRG_APART constexpr int columns() const noexcept { return static_cast<int>(columns_.size()); }
  /// needs   0 <= x < columns()
  IRG_APART constexpr const Column& operator[](int x) const noexcept { return columns_[static_cast<std::size_t>(x)]; }

  /// The next sample begins a curve, or a part of one after a gap.
  IRG_APART constexpr void begin_curve() noexcept { drawing_ = false; }

  /// Adds a sample, and calls sink(from, to, side) for what is seen of the step that leads there: the upper part first.
  /// gives   nothing for the first sample of a curve; a gap for a sample outside of the columns
  /// exact   integers; where the sample before lies in the same column, the step begins at the horizon as it was
  /// cost    constant
  template <class Sink>
  IRG_APART constexpr void add(const cell& sample, Sink&& sink) {
    if (sample.x < 0 || sample.x >= columns()) return begin_curve();
    Column& here = columns_[static_cast<std::size_t>(sample.x)];
    const Column before = drawing_ && last_.x == sample.x ? here : Column{};
    detail::extend_horizon(here, sample.y);
    if (drawing_) {
      const Column& there = before.is_set ? before : columns_[static_cast<std::size_t>(last_.x)];
      const bool upper[] = {last_.y == there.upper, sample.y == here.upper};
      const bool lower[] = {last_.y == there.lower, sample.y == here.lower};
      const auto is_drawn = [](const bool(&on)[2], const bool(&other)[2]) {
        return (on[0] && on[1]) || (on[0] && !other[0]) || (on[1] && !other[1]);
      };
      if (is_drawn(upper, lower)) sink(cell{last_.x, there.upper}, cell{sample.x, here.upper}, horizon_side::upper);
      if (is_drawn(lower, upper)) sink(cell{last_.x, there.lower}, cell{sample.x, here.lower}, horizon_side::lower);
    }
    last_ = sample;
    drawing_ = true;
  }

private:
  std::vector<Column> columns_;
  cell last_{};
  bool drawing_ = false;
};

}  // namespace irg
