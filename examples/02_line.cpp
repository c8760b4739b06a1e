// SPDX-License-Identifier: MIT
// 02_line - a line is a stream of cells; draw it into anything that accepts cells.
// previous: 01_pixel, next: 03_polygon
//
//   @ @ . . .
//   . . @ @ .     from (0, 0) to (5, 2); the end outside the window changes no cell inside it
//   . . . . @
#include <cstdio>
#include <string_view>

#include <irg/raster/line_bresenham.hpp>

#include "support/step.hpp"

int main(int argc, char** argv) {
  program::step(argc, argv, "02_line", "a line is a stream of cells; draw it into anything that accepts cells");
  char rows[3][6] = {".....", ".....", "....."};
  irg::line_bresenham({0, 0}, {5, 2}, {0, 0, 5, 3}, [&](irg::cell c) { rows[c.y][c.x] = '@'; });
  for (const auto& row : rows) std::puts(row);

  // No coordinate is too far away, and cells outside the window cost nothing.
  int visible = 0;
  irg::line_bresenham({-2000000000, -2000000000}, {2000000000, 2000000000}, {0, 0, 100, 100},
                      [&](irg::cell) { ++visible; });
  std::printf("%d of 4000000001 cells are visible\n", visible);

  const std::string_view top = rows[0], middle = rows[1], bottom = rows[2];
  return top == "@@..." && middle == "..@@." && bottom == "....@" && visible == 100 ? 0 : 1;
}
