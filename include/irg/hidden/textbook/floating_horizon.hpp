// SPDX-License-Identifier: MIT
// The floating horizon by the rules of the source: points, the simple step and the improved step. irg::floating_horizon
// (hidden/floating_horizon.hpp) draws no line that the curves do not have.
#pragma once

#include <irg/hidden/floating_horizon.hpp>

namespace irg::textbook {

/// What is drawn of a step.
enum class horizon_rule {
  points,  // the sample alone, where it moves a horizon: steep parts look scattered
  simple_step,  // both horizons, whether the step lies on them or not
  improved_step  // a horizon on which one end of the step lies after it was moved
};

/// The horizons of all columns, and the curve that is being drawn.
/// shape   as irg::floating_horizon
/// gives   lines that no curve has, where both horizons meet or a column is new; of several samples in one column
///         points alone, since the horizon where a step begins has moved already
/// source  Special-cases chapter, 2.1, with a flag for the first sample of a curve where x > 0 is printed
template <class Column = horizon_column>
class floating_horizon {
public:
  IRG_APART constexpr explicit floating_horizon(int columns, horizon_rule rule = horizon_rule::improved_step)
      : columns_(static_cast<std::size_t>(columns < 0 ? 0 : columns), Column{}), rule_(rule) {}

  [[nodiscard]] IRG_APART constexpr int columns() const noexcept { return static_cast<int>(columns_.size()); }
  IRG_APART constexpr const Column& operator[](int x) const noexcept { return columns_[static_cast<std::size_t>(x)]; }
  IRG_APART constexpr void begin_curve() noexcept { drawing_ = false; }

  /// Adds a sample, and calls sink(from, to, side) for what the rule draws.
  template <class Sink>
  IRG_APART constexpr void add(const cell& sample, Sink&& sink) {
    if (sample.x < 0 || sample.x >= columns()) return begin_curve();
    Column& here = columns_[static_cast<std::size_t>(sample.x)];
    const Column before = here;
    detail::extend_horizon(here, sample.y);
    if (rule_ == horizon_rule::points) {
      if (!before.is_set || here.upper != before.upper)
        sink(sample, sample, horizon_side::upper);
      else if (here.lower != before.lower)
        sink(sample, sample, horizon_side::lower);
    } else if (drawing_) {
      const Column& there = columns_[static_cast<std::size_t>(last_.x)];
      const bool all = rule_ == horizon_rule::simple_step;
      if (all || last_.y == there.upper || sample.y == here.upper)
        sink(cell{last_.x, there.upper}, cell{sample.x, here.upper}, horizon_side::upper);
      if (all || last_.y == there.lower || sample.y == here.lower)
        sink(cell{last_.x, there.lower}, cell{sample.x, here.lower}, horizon_side::lower);
    }
    last_ = sample;
    drawing_ = true;
  }

private:
  std::vector<Column> columns_;
  horizon_rule rule_;
  cell last_{};
  bool drawing_ = false;
};

}  // namespace irg::textbook
