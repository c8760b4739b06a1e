// SPDX-License-Identifier: MIT
// textbook::line_bresenham: Bresenham's line as textbooks tell it, with a real-valued distance D, in every direction.
//
// D is the distance of the true line from the cell's centre line at the next step, less one half: where it is
// positive, the line has come nearer to the next row, and the walk moves aside. In exact numbers D is a multiple of
// 1/(2n) for a line of n steps. In floating point each step adds the rounding errors of the slope, of D + slope and of
// D - 1, each at most half a unit in the last place of a number below 1. So "D > 0" fails first at exact ties, where D
// should be 0 and comes out as 1e-16 (the slope 5/6, say). Asking "D > 1/(4n)" instead, half-way between 0 and the
// least positive D, gives the right answer as long as the errors together stay below 1/(4n). With p binary digits they
// stay below 3n * 2^-(p+1), which is less than 1/(4n) while 12 * n^2 < 2^(p+1).
#pragma once

#include <cstdint>
#include <limits>

#include <irg/core/scalar.hpp>
#include <irg/raster/detail/line_frame.hpp>

namespace irg::detail::inline IRG_ABI {

// 2^exponent, the largest number of steps for which a bound is proven; every line in int where numbers are exact.
template <Real T>
constexpr std::int64_t proven_steps(int digits_for_exponent_0, int digits_per_exponent) noexcept {
  if (!std::numeric_limits<T>::is_specialized || std::numeric_limits<T>::is_exact) return std::int64_t{1} << 32;
  const int exponent = (std::numeric_limits<T>::digits - digits_for_exponent_0) / digits_per_exponent;
  return std::int64_t{1} << (exponent < 32 ? exponent : 32);
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::textbook {

/// The most steps (max(|dx|, |dy|)) for which line_bresenham is proven right: 2^25 for double, 2^10 for float,
/// all of int's 2^32 for exact numbers.
template <Real T>
inline constexpr std::int64_t line_bresenham_steps = detail::proven_steps<T>(3, 2);

inline namespace IRG_ABI {

/// Calls sink(cell) for the cells of the line from a to b, in this order, and says whether it did; sink(cell, D) where
/// sink takes two arguments, D being the distance with which the step to the next cell is decided.
/// shape   8-connected; max(|dx|, |dy|) + 1 cells, both ends among them; 45 degrees is y-driven
/// needs   a Real made from std::int64_t
/// gives   false, and no call, when the line has more than line_bresenham_steps<Number> steps
/// exact   the cells of irg::line_bresenham: ties on the start's side
/// cost    two additions per cell; nothing is clipped
/// source  Bresenham 1965; Mihajlovic 2016, 2.4.1, for every direction and with the last cell
template <Real Number = double, class Sink>
  requires CellSink<Sink> || requires(Sink& sink, const cell c, const Number& d) { sink(c, d); }
constexpr bool line_bresenham(cell a, cell b, Sink&& sink) {
  const detail::bresenham_frame f = detail::frame_of(a, b);
  if (f.n > line_bresenham_steps<Number>) return false;
  const auto plot = [&](std::int64_t along, std::int64_t aside, const Number& distance) {
    if constexpr (requires(cell c) { sink(c, distance); })
      sink(f.at(along, aside), distance);
    else
      sink(f.at(along, aside));
  };
  const Number one(1);
  if (f.n == 0) return plot(0, 0, -one / Number(2)), true;
  const Number n = Number(f.n), slope = Number(f.m) / n, half_way_to_least_positive = one / (Number(4) * n);
  Number distance = slope - one / Number(2);
  std::int64_t aside = 0;
  for (std::int64_t i = 0; i < f.n; ++i) {
    plot(i, aside, distance);
    if (half_way_to_least_positive < distance) {
      ++aside;
      distance = distance - one;
    }
    distance = distance + slope;
  }
  plot(f.n, aside, distance);
  return true;
}

}  // namespace IRG_ABI
}  // namespace irg::textbook
