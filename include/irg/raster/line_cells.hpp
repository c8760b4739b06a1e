// SPDX-License-Identifier: MIT
// line_cells: the cells of a straight line as a range, made when they are asked for: for range-for, for the standard
// algorithms, and for any cell of a line without the walk to it.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>

#include <irg/core/contract.hpp>
#include <irg/raster/detail/line_frame.hpp>

namespace irg {

/// The cells of a line from a to b, in this order, exactly those of line_bresenham with the same options.
/// shape   a random-access range; its iterators do not refer to it and outlive it
/// exact   for all int coordinates; without a window even the cells at the greatest int, which no window holds
/// cost    a few divisions to make, an addition or two per step, a 128-bit division for a jump; no memory
class line_cells {
public:
  /// Steps along a line and reads its cells. Jumps and differences count steps.
  class iterator {
  public:
    using value_type = cell;
    using difference_type = std::int64_t;

    iterator() = default;

    IRG_INLINE constexpr cell operator*() const noexcept { return line_.at(step_, aside_); }
    IRG_INLINE constexpr cell operator[](std::int64_t k) const noexcept {
      return line_.at(step_ + k, line_.aside_at(step_ + k));
    }

    IRG_INLINE constexpr iterator& operator++() noexcept {
      if (error_ > 0) {
        ++aside_;
        error_ -= 2 * line_.n;
      }
      error_ += 2 * line_.m;
      ++step_;
      return *this;
    }
    // The error was above 2 * (m - n) before the step when the step did not move aside, and is not when it did. A line
    // of one cell has an error of no meaning.
    IRG_INLINE constexpr iterator& operator--() noexcept {
      error_ -= 2 * line_.m;
      if (error_ <= 2 * (line_.m - line_.n) && line_.n > 0) {
        --aside_;
        error_ += 2 * line_.n;
      }
      --step_;
      return *this;
    }
    IRG_INLINE constexpr iterator& operator+=(std::int64_t k) noexcept { return *this = iterator(line_, step_ + k); }
    IRG_INLINE constexpr iterator& operator-=(std::int64_t k) noexcept { return *this = iterator(line_, step_ - k); }
    IRG_INLINE constexpr iterator operator++(int) noexcept {
      const iterator before = *this;
      ++*this;
      return before;
    }
    IRG_INLINE constexpr iterator operator--(int) noexcept {
      const iterator before = *this;
      --*this;
      return before;
    }

    // Forced inline one by one, as all members of public types.
    IRG_INLINE friend constexpr iterator operator+(iterator it, std::int64_t k) noexcept { return it += k; }
    IRG_INLINE friend constexpr iterator operator+(std::int64_t k, iterator it) noexcept { return it += k; }
    IRG_INLINE friend constexpr iterator operator-(iterator it, std::int64_t k) noexcept { return it -= k; }
    IRG_INLINE friend constexpr std::int64_t operator-(const iterator& a, const iterator& b) noexcept {
      return a.step_ - b.step_;
    }
    IRG_INLINE friend constexpr bool operator==(const iterator& a, const iterator& b) noexcept {
      return a.step_ == b.step_;
    }
    IRG_INLINE friend constexpr std::strong_ordering operator<=>(const iterator& a, const iterator& b) noexcept {
      return a.step_ <=> b.step_;
    }

  private:
    friend class line_cells;
    IRG_INLINE constexpr iterator(const detail::bresenham_frame& line, std::int64_t step) noexcept
        : line_(line), step_(step), aside_(line.aside_at(step)), error_(line.error_at(step, aside_)) {}

    detail::bresenham_frame line_{};
    std::int64_t step_ = 0, aside_ = 0, error_ = 0;
  };

  /// All cells of the line.
  IRG_INLINE constexpr line_cells(cell a, cell b, const line_options& options = {}) noexcept
      : line_(detail::frame_of(a, b, options.ties)), steps_{0, detail::steps_drawn(line_, options.ends)} {}

  /// The cells of the line that lie in the window; none when the window is empty.
  IRG_INLINE constexpr line_cells(cell a, cell b, const cell_window& window, const line_options& options = {}) noexcept
      : line_(detail::frame_of(a, b, options.ties)), steps_{0, 0} {
    if (window.empty()) return;
    steps_ = detail::visible_steps(line_, window, options.ends);
    if (steps_.last < steps_.first) steps_ = {0, 0};
  }

  [[nodiscard]] IRG_INLINE constexpr iterator begin() const noexcept { return {line_, steps_.first}; }
  [[nodiscard]] IRG_INLINE constexpr iterator end() const noexcept { return {line_, steps_.last}; }
  [[nodiscard]] IRG_INLINE constexpr bool empty() const noexcept { return steps_.first == steps_.last; }

  /// How many cells there are: up to 2^32.
  [[nodiscard]] IRG_INLINE constexpr std::int64_t size() const noexcept { return steps_.last - steps_.first; }

  /// Cell i, without walking to it.
  /// needs   0 <= i < size()
  IRG_INLINE constexpr cell operator[](std::int64_t i) const noexcept {
    IRG_EXPECTS(i >= 0 && i < size());
    return line_.at(steps_.first + i, line_.aside_at(steps_.first + i));
  }

  /// needs   !empty()
  [[nodiscard]] IRG_INLINE constexpr cell front() const noexcept { return (*this)[0]; }
  [[nodiscard]] IRG_INLINE constexpr cell back() const noexcept { return (*this)[size() - 1]; }

private:
  detail::bresenham_frame line_;
  detail::step_range steps_;
};

}  // namespace irg
