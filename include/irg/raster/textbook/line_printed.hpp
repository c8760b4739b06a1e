// SPDX-License-Identifier: MIT
// The line procedures of two lectures' texts exactly as they are printed, each with the domain in which it is meant and
// the faults it has there. textbook::line_bresenham is what they mean; irg::line_bresenham is what to use.
//
// All take D > 0 literally. Up to line_bresenham_steps steps rounding can spoil that test only where D should be 0: at
// exact ties, whose cells then may lie one aside. A longer line, or one outside of the domain, gives false and no call.
#pragma once

#include <irg/raster/textbook/line_bresenham.hpp>

namespace irg::textbook::inline IRG_ABI {

/// Calls sink(cell) for the cells of the line from a to b but the last, and says whether it did.
/// needs   0 to 45 degrees: 0 <= b.y - a.y <= b.x - a.x and a.x < b.x
/// exact   in exact numbers the cells of the half-open line_bresenham
/// source  Mihajlovic 2016, 2.6.1 steps 1 to 8: "for D > 0" is a loop, and the end point is not plotted
template <Real Number = double, CellSink Sink>
constexpr bool line_bresenham_printed(cell a, cell b, Sink&& sink) {
  const std::int64_t x0 = std::int64_t{b.x} - a.x, y0 = std::int64_t{b.y} - a.y;
  if (x0 <= 0 || y0 < 0 || y0 > x0 || x0 > line_bresenham_steps<Number>) return false;
  const Number slope = Number(y0) / Number(x0);
  Number distance = slope - Number(1) / Number(2);
  int x = a.x, y = a.y;
  for (std::int64_t i = 0; i < x0; ++i) {
    sink(cell{x, y});
    while (Number(0) < distance) {
      ++y;
      distance = distance - Number(1);
    }
    ++x;
    distance = distance + slope;
  }
  return true;
}

/// Calls sink(cell) for the line from (0, 0) to `to` in the first quadrant, corrected before it is plotted, and says
/// whether it did.
/// needs   to.x >= 0 and to.y >= 0, not both 0
/// exact   never meant to be: each cell lies where line_bresenham has the next one, so the line to (5, 3) begins at
///         (0, 1); the line to (8, 4) is that of the opposite direction
/// source  Fabris 2012, 3.2, first listing, D moved on in every pass (its indentation is lost in print)
template <Real Number = double, CellSink Sink>
constexpr bool line_quadrant(cell to, Sink&& sink) {
  const bool flat = to.x > to.y;
  const int along = flat ? to.x : to.y, aside = flat ? to.y : to.x;
  if (along <= 0 || aside < 0 || along > line_bresenham_steps<Number>) return false;
  const Number slope = Number(std::int64_t{aside}) / Number(std::int64_t{along});
  Number distance = slope - Number(1) / Number(2);
  int at = 0;
  for (int i = 0; i < along; ++i) {
    if (Number(0) < distance) {
      ++at;
      distance = distance - Number(1);
    }
    distance = distance + slope;
    sink(flat ? cell{i, at} : cell{at, i});
  }
  sink(cell{to});
  return true;
}

/// The same in the first octant alone.
/// needs   to.x > to.y >= 0
/// source  Fabris 2012, 3.1
template <Real Number = double, CellSink Sink>
constexpr bool line_octant(cell to, Sink&& sink) {
  return to.x > to.y && line_quadrant<Number>(to, sink);
}

/// Calls sink(cell) for the cells of the line from a to b, in any direction, and says whether it did.
/// needs   two different ends
/// gives   false, and no call, also where the fault would leave int: lines driven by x move y by the sign of x, so
///         those with b.x > a.x and b.y < a.y go up instead of down, and the other way round
/// exact   in exact numbers all other lines have the cells of line_bresenham
/// source  Fabris 2012, 3.2, last listing (`linija`)
template <Real Number = double, CellSink Sink>
constexpr bool line_plane(cell a, cell b, Sink&& sink) {
  const detail::bresenham_frame f = detail::frame_of(a, b);
  const int sign_aside = b.x < a.x ? -1 : 1;  // of y in the listing's first branch, of x in its second
  const std::int64_t last = (f.steep ? a.x : a.y) + sign_aside * f.m;
  if (f.n == 0 || f.n > line_bresenham_steps<Number> || last != static_cast<int>(last)) return false;
  const Number slope = Number(f.m) / Number(f.n);
  Number distance = slope - Number(1) / Number(2);
  cell c = a;
  int &along = f.steep ? c.y : c.x, &aside = f.steep ? c.x : c.y;
  sink(cell{c});
  for (std::int64_t i = 0; i < f.n; ++i) {
    if (Number(0) < distance) {
      aside += sign_aside;
      distance = distance - Number(1);
    }
    along += f.sign_along;
    distance = distance + slope;
    sink(cell{c});
  }
  return true;
}

}  // namespace irg::textbook::inline IRG_ABI
