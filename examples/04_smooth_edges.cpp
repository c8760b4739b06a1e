// SPDX-License-Identifier: MIT
// 04_smooth_edges - coverage is an area: pixels that a shape covers in part get a part of its paint.
// previous: 03_polygon, next: 05_triangle
//
//         - * * -
//     - * # # # # * -     a pixel's coverage is its exact area inside the shape, in 255ths;
//     - * # # # # * -     all of them together are the area of the shape
//         - * * -
#include <cmath>
#include <cstdint>
#include <cstdio>

#include <irg/raster/fill_convex_aa.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/line_aa.hpp>

#include "support/step.hpp"

namespace {

using point = irg::point<double, 2>;
using coverage = irg::image<std::uint8_t>;

double area(const coverage& picture) {
  double sum = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) sum += picture(x, y) / 255.0;
  return sum;
}

void print(const coverage& picture) {
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) std::printf("%c ", " .-+*#"[(picture(x, y) + 50) / 51]);
    std::puts("");
  }
}

}  // namespace

int main(int argc, char** argv) {
  program::step(argc, argv, "04_smooth_edges",
                "coverage is an area: pixels that a shape covers in part get a part of its paint");
  // A diamond with diagonals of 16 and 8 pixels has an area of 64.
  const point diamond[] = {{2, 5}, {10, 1}, {18, 5}, {10, 9}};
  coverage filled(20, 10, 0);
  irg::fill_convex_aa(filled, diamond, 255);
  print(filled);

  // A line is a rectangle, one pixel wide unless told otherwise: a length of 15 covers 15 pixels.
  coverage drawn(20, 12, 0);
  irg::draw_line_aa(drawn, point{3, 1.5}, point{15, 10.5}, 255);
  print(drawn);

  std::printf("the diamond covers %.2f pixels, the line %.2f\n", area(filled), area(drawn));
  return std::abs(area(filled) - 64) < 0.1 && std::abs(area(drawn) - 15) < 0.1 ? 0 : 1;
}
