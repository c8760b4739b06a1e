// SPDX-License-Identifier: MIT
// Sinks of the wrong argument. CASE 0 is the control and compiles.
#include <irg/raster/line_bresenham.hpp>

void use() {
  constexpr irg::cell a{0, 0}, b{3, 2};
  constexpr irg::cell_window window{0, 0, 8, 8};
#if CASE == 0
  irg::line_bresenham(a, b, window, [](irg::cell) {});
  irg::line_bresenham(a, b, window, [n = 0](const irg::cell&) mutable { return ++n; });
#elif CASE == 1  // takes text
  // expect: no matching function for call to .*line_bresenham
  irg::line_bresenham(a, b, window, [](const char*) {});
#elif CASE == 2  // takes two numbers
  // expect: no matching function for call to .*line_bresenham
  irg::line_bresenham(a, b, window, [](int, int) {});
#elif CASE == 3  // takes spans
  // expect: no matching function for call to .*line_bresenham
  irg::line_bresenham(a, b, window, [](irg::span_of_cells) {});
#elif CASE == 4  // wants to change the cell
  // expect: no matching function for call to .*line_bresenham
  irg::line_bresenham(a, b, window, [](irg::cell&) {});
#endif
}
