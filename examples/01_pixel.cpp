// SPDX-License-Identifier: MIT
// 01_pixel - an image is a rectangle of pixels of any type; (0, 0) is at the top left, y points down.
// next: 02_line
//
//   . . . . .
//   . . . @ .
//   . . . . .
#include <cstdio>

#include <irg/raster/image.hpp>

#include "support/step.hpp"

int main(int argc, char** argv) {
  program::step(argc, argv, "01_pixel",
                "an image is a rectangle of pixels of any type; (0, 0) is at the top left, y points down");
  irg::image<char> picture(5, 3, '.');
  picture(3, 1) = '@';

  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) std::printf("%c ", picture(x, y));
    std::puts("");
  }

  // The same in constant evaluation: everything in irg is constexpr.
  constexpr auto marked = [] {
    irg::image<char> image(5, 3, '.');
    image(3, 1) = '@';
    return image(3, 1);
  };
  static_assert(marked() == '@');
  return picture.row(1)[3] == '@' && picture(0, 0) == '.' ? 0 : 1;
}
