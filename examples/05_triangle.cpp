// SPDX-License-Identifier: MIT
// 05_triangle - two triangles that share an edge: every pixel of the square belongs to exactly one of them.
// previous: 04_smooth_edges, next: 06_depth
//
//   a a a a a a a b
//   a a a a a a b b
//   a a a a a b b b     vertices are snapped to 1/256 pixel, coverage is decided in integers:
//   a a a a b b b b     a pixel is covered when its centre is inside, or on a left or top edge
//   a a a b b b b b
//   a a b b b b b b
//   a b b b b b b b
//   b b b b b b b b
#include <cstdio>

#include <irg/raster/fill_span.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/triangle_coverage.hpp>

#include "support/step.hpp"

int main(int argc, char** argv) {
  program::step(argc, argv, "05_triangle",
                "two triangles that share an edge: every pixel of the square belongs to exactly one of them");
  irg::image<char> picture(8, 8, '.');
  const irg::subpixel corner[4] = {{0, 0}, {8 * 256, 0}, {8 * 256, 8 * 256}, {0, 8 * 256}};
  int drawn = 0;

  const auto fill = [&](irg::subpixel a, irg::subpixel b, irg::subpixel c, char value) {
    irg::covered_spans(irg::cover_triangle(a, b, c), irg::window_of(picture), [&](irg::span_of_cells span) {
      irg::fill_span(picture, span, value);
      drawn += span.x_last - span.x_first;
    });
  };
  fill(corner[0], corner[1], corner[3], 'a');
  fill(corner[1], corner[2], corner[3], 'b');

  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) std::printf("%c ", picture(x, y));
    std::puts("");
  }
  std::printf("%d pixels drawn for 64 pixels\n", drawn);
  return drawn == 64 && picture(6, 0) == 'a' && picture(7, 0) == 'b' ? 0 : 1;
}
