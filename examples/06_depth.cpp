// SPDX-License-Identifier: MIT
// 06_depth - two triangles that pass through each other: the depth buffer decides pixel by pixel.
// previous: 05_triangle, next: 07_cube
//
//   a a a a a b b b b .
//   . a a a a b b b . .
//   . . a a a b b . . .     a is near on the left and far on the right, b the other way round;
//   . . . a a b . . . .     the right border runs through pixel centres, which a right edge does not own
//   . . . . a . . . . .
#include <cstdio>

#include <irg/raster/draw_triangle.hpp>
#include <irg/raster/fill_span.hpp>
#include <irg/raster/image.hpp>

#include "support/step.hpp"

int main(int argc, char** argv) {
  program::step(argc, argv, "06_depth",
                "two triangles that pass through each other: the depth buffer decides pixel by pixel");
  irg::image<char> picture(10, 5, '.');
  irg::image<float> depth(10, 5, irg::nearer_is_greater::farthest);  // reversed depth: 1 is near, 0 is far

  const auto draw = [&](float left, float right, char value) {
    const float middle = (left + right) / 2;
    return irg::shade_triangle(picture, depth, {{{0, 0}, left}, {{10 * 256, 0}, right}, {{5 * 256, 5 * 256}, middle}},
                               irg::solid_shader<char>{value});
  };
  const irg::draw_counts a = draw(0.9f, 0.1f, 'a');
  const irg::draw_counts b = draw(0.1f, 0.9f, 'b');

  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 10; ++x) std::printf("%c ", picture(x, y));
    std::puts("");
  }
  std::printf("a: %lld of %lld pixels drawn, b: %lld of %lld\n", static_cast<long long>(a.shaded),
              static_cast<long long>(a.tested), static_cast<long long>(b.shaded), static_cast<long long>(b.tested));
  return a.shaded == 25 && b.shaded == 10 && picture(4, 0) == 'a' && picture(5, 0) == 'b' ? 0 : 1;
}
