// SPDX-License-Identifier: MIT
// 03_polygon - a frame and a star: rings, holes, and two ways to say what is inside.
// previous: 02_line, next: 04_smooth_edges
//
//       . . # # . .
//   # # # o o # # #     # has a winding number of 1, o of 2: the star's ring runs twice round its middle.
//     # # o o # #       even_odd fills # alone, non_zero both
//     # # # # # #
#include <cstdio>

#include <irg/raster/fill_polygon.hpp>
#include <irg/raster/image.hpp>

#include "support/step.hpp"

namespace {

using point = irg::point<double, 2>;
using ids = irg::image<int>;

int count(const ids& picture, int id) {
  int n = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) n += picture(x, y) == id;
  return n;
}

void print(const ids& picture) {
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) std::printf("%c ", ".o#"[picture(x, y)]);
    std::puts("");
  }
}

}  // namespace

int main(int argc, char** argv) {
  program::step(argc, argv, "03_polygon", "a frame and a star: rings, holes, and two ways to say what is inside");
  // A polygon is one ring or several; a ring inside another is a hole. Pixels are of any type: here they are numbers.
  const point frame[2][4] = {{{1, 1}, {21, 1}, {21, 9}, {1, 9}}, {{4, 3}, {18, 3}, {18, 7}, {4, 7}}};
  ids picture(22, 10, 0);
  irg::fill_polygon(picture, frame, irg::fill_rule::even_odd, 1);
  print(picture);
  const int pixels_of_frame = count(picture, 1);  // 20 x 8 less 14 x 4

  const point star[] = {{11, 0}, {17.5, 20}, {0.5, 7.6}, {21.5, 7.6}, {4.5, 20}};
  ids even_odd(22, 20, 0), non_zero(22, 20, 0);
  irg::fill_polygon(even_odd, star, irg::fill_rule::even_odd, 1);
  irg::fill_polygon(non_zero, star, irg::fill_rule::non_zero, 1);
  const int middle = count(non_zero, 1) - count(even_odd, 1);

  // A paint may be a function of the pixel that is there: here it marks the pixels that both rules fill.
  irg::fill_polygon(non_zero, star, irg::fill_rule::even_odd, [](int there) { return there + 1; });
  print(non_zero);
  std::printf("the frame has %d pixels, the middle of the star %d\n", pixels_of_frame, middle);
  return pixels_of_frame == 20 * 8 - 14 * 4 && middle == 40 && count(non_zero, 1) == middle ? 0 : 1;
}
