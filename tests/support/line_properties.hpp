// SPDX-License-Identifier: MIT
// The course's criteria of a good raster line, for every function that makes one: straight, right ends, a density that
// depends on neither direction nor length, no gap. `line_fault` judges one line; `check_line_criteria` a function.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <irg/core/raster_concept.hpp>
#include <irg/core/sinks.hpp>
#include <irg/raster/line_style.hpp>

#include "random.hpp"

namespace test {

using cells = std::vector<irg::cell>;

/// Steps of a line along its longer axis.
constexpr std::int64_t line_steps(irg::cell a, irg::cell b) {
  const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
  return std::max(dx < 0 ? -dx : dx, dy < 0 ? -dy : dy);
}

/// Which criterion the cells of the whole line from a to b, in drawing order, break; nullptr when they meet all.
constexpr const char* line_fault(irg::cell a, irg::cell b, const cells& line,
                                 irg::line_ends ends = irg::line_ends::closed) {
  __extension__ using product_type = __int128;
  const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y, n = line_steps(a, b);
  const bool closed = ends == irg::line_ends::closed, by_x = (dx < 0 ? -dx : dx) > (dy < 0 ? -dy : dy);
  if (line.size() != static_cast<std::size_t>(closed ? n + 1 : n)) return "density: one cell per driving step";
  if (line.empty()) return nullptr;
  if (line.front() != a) return "ends: the first cell";
  if (closed && line.back() != b) return "ends: the last cell";
  for (std::size_t i = 0; i < line.size(); ++i) {
    const std::int64_t x = std::int64_t{line[i].x} - a.x, y = std::int64_t{line[i].y} - a.y;
    const product_type across = 2 * (product_type{dx} * y - product_type{dy} * x);
    if ((across < 0 ? -across : across) > n) return "straight: at most half a cell off";
    const std::int64_t along = by_x ? (dx < 0 ? -x : x) : (dy < 0 ? -y : y);
    if (along != static_cast<std::int64_t>(i)) return "density: each step one further along";
    if (i == 0) continue;
    const std::int64_t gap_x = std::int64_t{line[i].x} - line[i - 1].x, gap_y = std::int64_t{line[i].y} - line[i - 1].y;
    if (gap_x < -1 || gap_x > 1 || gap_y < -1 || gap_y > 1) return "8-connected";
  }
  return nullptr;
}

/// Sorts cells found in a raster into the drawing order of the line from a to b.
constexpr cells in_drawing_order(irg::cell a, irg::cell b, cells line) {
  const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
  const bool by_x = (dx < 0 ? -dx : dx) > (dy < 0 ? -dy : dy);
  const auto along = [&](irg::cell c) -> std::int64_t {
    return by_x ? (dx < 0 ? -std::int64_t{c.x} : c.x) : (dy < 0 ? -std::int64_t{c.y} : c.y);
  };
  std::sort(line.begin(), line.end(), [&](irg::cell p, irg::cell q) { return along(p) < along(q); });
  return line;
}

/// The cells of a raster that differ from `empty`, row by row.
template <irg::ReadableRaster R>
constexpr cells cells_in(const R& raster, const irg::pixel_of<R>& empty) {
  cells found;
  for (int y = 0; y < irg::height_of(raster); ++y)
    for (int x = 0; x < irg::width_of(raster); ++x)
      if (irg::get_pixel(raster, x, y) != empty) found.push_back({x, y});
  return found;
}

/// Checks a line function on all ends within [0, side) x [0, side) and on `trials` random ends within [0, reach) x
/// [0, reach). `draw(a, b)` returns the cells of the whole line in drawing order.
template <class Draw>
void check_line_criteria(const Draw& draw, irg::line_ends ends = irg::line_ends::closed, int side = 9, int reach = 300,
                         int trials = 300) {
  long faults = 0;
  const auto judge = [&](irg::cell a, irg::cell b) {
    const char* const fault = line_fault(a, b, draw(a, b), ends);
    if (fault == nullptr) return;
    if (++faults <= 5)
      MESSAGE(std::string(fault) << ": (" << a.x << ", " << a.y << ") to (" << b.x << ", " << b.y << ")");
  };
  for (int from = 0; from < side * side; ++from)
    for (int to = 0; to < side * side; ++to) judge({from % side, from / side}, {to % side, to / side});
  random r(17);
  const auto coordinate = [&] { return static_cast<int>(r.integer(0, reach - 1)); };
  for (int i = 0; i < trials; ++i) {
    const int x = coordinate(), y = coordinate(), u = coordinate();
    judge({x, y}, {u, coordinate()});
  }
  CHECK(faults == 0);
}

/// The same for a function that draws into a raster: `draw(raster, a, b)` sets the line's cells to true.
template <class Raster, class Draw>
void check_line_criteria_in(const Draw& draw, irg::line_ends ends = irg::line_ends::closed) {
  constexpr int reach = 60;
  Raster raster(reach, reach);
  const Raster blank = raster;
  check_line_criteria(
      [&](irg::cell a, irg::cell b) {
        raster = blank;
        draw(raster, a, b);
        return in_drawing_order(a, b, cells_in(raster, irg::get_pixel(blank, 0, 0)));
      },
      ends, 8, reach, 200);
}

}  // namespace test
