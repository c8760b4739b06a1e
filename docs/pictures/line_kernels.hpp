// SPDX-License-Identifier: MIT
// Pictures of draw_line, draw_lines and draw_polyline: few pixels, enlarged.
#pragma once

#include <vector>

#include <irg/colour/srgb.hpp>
#include <irg/raster/draw_lines.hpp>
#include <irg/raster/draw_polyline.hpp>
#include <irg/raster/image.hpp>

#include "enlarged.hpp"

namespace line_kernels {

using namespace enlarging;
constexpr irg::rgba8 blue{92, 142, 196, 255}, red{204, 96, 72, 255}, light{255, 255, 255, 255};

// Lines through a window: the cells reached by a step aside in red, the others in blue, the rest of the line pale.
inline picture steps() {
  constexpr int size = 16;
  picture small(46, 24, paper);
  const irg::cell_window window{6, 3, 40, 21};
  for (int y = window.y_first; y < window.y_last; ++y) irg::fill_span(small, {y, window.x_first, window.x_last}, light);
  const irg::cell ends[][2] = {{{-30, 2}, {60, 17}}, {{12, -40}, {30, 50}}, {{2, 22}, {44, 10}}};
  for (const auto& [a, b] : ends) {
    irg::draw_line(small, a, b, pale);
    irg::cell last = a;
    irg::line_bresenham(a, b, {-100, -100, 100, 100}, [&](irg::cell c) {
      const bool aside = c.x != last.x && c.y != last.y;
      last = c;
      irg::draw_line(irg::within(small, window), c, c, aside ? red : blue);
    });
  }
  picture big = enlarged(small, size);
  for (const auto& [a, b] : ends)
    irg::draw_line(big, {a.x * size + size / 2, a.y * size + size / 2}, {b.x * size + size / 2, b.y * size + size / 2},
                   ink);
  return big;
}

// Lines cut at the borders of tiles.
inline picture tiles() {
  constexpr int size = 8, tile_bits = 4;
  picture small(96, 48, paper);
  const irg::detail::tile_grid grid{irg::window_of(small), tile_bits, tile_bits, 6, 18};
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 96; ++x)
      if (((x >> tile_bits) + (y >> tile_bits)) % 2) small(x, y) = {238, 236, 228, 255};
  const irg::cell ends[][2] = {{{3, 40}, {92, 7}}, {{10, 2}, {31, 46}}, {{90, 44}, {40, 20}}, {{70, 3}, {70, 45}}};
  for (const auto& [a, b] : ends) {
    const auto f = irg::detail::frame_of(a, b);
    irg::detail::cut_walk(irg::detail::walk_of_steps_32(f, {0, f.n + 1}), grid, 0,
                          [&](const irg::detail::line_piece& piece, std::uint32_t tile) {
                            const bool odd = (tile % 6 + tile / 6) % 2 != 0;
                            irg::cell c = piece.start;
                            auto part = piece.part;
                            for (int i = 0; i < piece.cells; ++i) {
                              small(c.x, c.y) = odd ? red : blue;
                              const bool aside = part + piece.slope < part;
                              part += piece.slope;
                              if (f.steep || aside) c.y += piece.octant & 2 ? -1 : 1;
                              if (!f.steep || aside) c.x += piece.octant & 1 ? -1 : 1;
                            }
                          });
  }
  return enlarged(small, size);
}

// A closed and an open polyline, painted with a function that darkens: what is painted once is blue everywhere.
inline picture polylines() {
  constexpr int size = 16;
  picture small(46, 18, paper);
  const auto darker = [](const irg::rgba8& there) { return there == paper ? blue : red; };
  const std::vector<irg::cell> closed{{2, 3}, {17, 1}, {20, 12}, {9, 15}, {12, 8}};
  const std::vector<irg::cell> open{{25, 14}, {29, 3}, {34, 13}, {38, 3}, {43, 14}, {24, 9}};
  irg::draw_polyline(small, closed, darker, irg::polyline_shape::closed);
  irg::draw_polyline(small, open, darker);
  picture big = enlarged(small, size);
  for (const auto& vertices : {closed, open})
    for (const irg::cell v : vertices)
      for (int y = 6; y <= 10; ++y) irg::fill_span(big, {v.y * size + y, v.x * size + 6, v.x * size + 11}, ink);
  return big;
}

}  // namespace line_kernels
