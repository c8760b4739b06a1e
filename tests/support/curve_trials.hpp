// SPDX-License-Identifier: MIT
// What closed curves of cells, a circle say, can be put to: comparison with their definition, and being of one piece.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include <irg/core/sinks.hpp>
#include <irg/raster/window.hpp>

namespace test {

/// Whether line(sink) gives, each once, just those cells of the window for which on(cell) holds, and spans(sink), in
/// order and at most one in a row, those for which in(cell) holds.
template <class Line, class Spans, class On, class In>
bool is_as_defined(const irg::cell_window& w, const Line& line, const Spans& spans, const On& on, const In& in) {
  const int width = w.x_last - w.x_first, height = w.y_last - w.y_first;
  const auto index = [&](int x, int y) { return static_cast<std::size_t>((y - w.y_first) * width + x - w.x_first); };
  std::vector<int> drawn(static_cast<std::size_t>(width * height), 0), filled = drawn;
  bool inside = true;
  line([&](irg::cell c) {
    inside &= c.x >= w.x_first && c.x < w.x_last && c.y >= w.y_first && c.y < w.y_last;
    if (inside) ++drawn[index(c.x, c.y)];
  });
  int last = std::numeric_limits<int>::min();
  spans([&](irg::span_of_cells s) {
    inside &= s.y > last && s.y >= w.y_first && s.y < w.y_last && s.x_first >= w.x_first && s.x_last <= w.x_last &&
              s.x_first < s.x_last;
    last = s.y;
    for (int x = s.x_first; inside && x < s.x_last; ++x) ++filled[index(x, s.y)];
  });
  for (int y = w.y_first; inside && y < w.y_last; ++y)
    for (int x = w.x_first; x < w.x_last; ++x)
      inside &= drawn[index(x, y)] == (on({x, y}) ? 1 : 0) && filled[index(x, y)] == (in({x, y}) ? 1 : 0);
  return inside;
}

/// How many cells that are 1 hang together with `from`, by steps in eight directions. They become 2.
/// shape   at(x, y) refers to the value of a cell
template <class At>
std::size_t count_connected(irg::cell from, const At& at) {
  std::vector<irg::cell> unvisited{from};
  std::size_t reached = 0;
  at(from.x, from.y) = 2;
  while (!unvisited.empty()) {
    const irg::cell c = unvisited.back();
    unvisited.pop_back();
    ++reached;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        if (at(c.x + dx, c.y + dy) == 1) {
          at(c.x + dx, c.y + dy) = 2;
          unvisited.push_back({c.x + dx, c.y + dy});
        }
  }
  return reached;
}

}  // namespace test
