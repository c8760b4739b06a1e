// SPDX-License-Identifier: MIT
// Pictures of the course's convex fill, of seed fill, of a tiling, and of where points lie: few cells, enlarged.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include <irg/colour/pixel.hpp>
#include <irg/geometry/point_in_polygon.hpp>
#include <irg/raster/draw_line.hpp>
#include <irg/raster/fill_convex.hpp>
#include <irg/raster/textbook/fill_convex.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/seed_fill.hpp>

#include "enlarged.hpp"

namespace textbook_fill {

using namespace enlarging;
constexpr irg::rgba8 blue{120, 166, 212, 255}, red{204, 96, 72, 255};

// One polygon by the four rules; the samples are the dots, y points up.
inline picture rules() {
  constexpr int size = 16, columns = 12, rows = 13, gap = 20;
  picture big(4 * (columns * size + 1) + 3 * gap, rows * size + 1, {255, 255, 255, 255});
  const std::array<irg::subpixel, 5> ring{irg::subpixel{1 * 256, 5 * 256}, irg::subpixel{4 * 256 + 128, 11 * 256},
                                          irg::subpixel{9 * 256, 10 * 256}, irg::subpixel{10 * 256 + 90, 4 * 256},
                                          irg::subpixel{5 * 256, 1 * 256}};
  int left = 0;
  for (const auto rule : {irg::textbook::sample_rule::course, irg::textbook::sample_rule::closed,
                          irg::textbook::sample_rule::rounded, irg::textbook::sample_rule::half_open}) {
    picture small(columns, rows, paper);
    irg::textbook::convex_spans(ring, rule, irg::window_of(small), [&](irg::span_of_cells s) {
      irg::fill_span(small, {rows - 1 - s.y, s.x_first, s.x_last}, blue);
    });
    paste(big, enlarged(small, size), left, 0);
    const auto place = [&](irg::subpixel p) {
      return irg::cell{left + size / 2 + p.x * size / 256, (rows - 1) * size + size / 2 - p.y * size / 256};
    };
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < columns; ++x) dot(big, place({x * 256, y * 256}), 1, ink);
    for (std::size_t i = 0; i < ring.size(); ++i)
      irg::draw_line(big, place(ring[i]), place(ring[(i + 1) % ring.size()]), red);
    left += columns * size + 1 + gap;
  }
  return big;
}

// The same drawing filled over sides, and over corners too; the seed is the dot.
inline picture seeds() {
  constexpr std::string_view rows[] = {"....................", "..######....####....", ".#......#..#....##..",
                                       "#........##.......#.", "#........##.......#.", "#.......#..#......#.",
                                       ".#.....#....######..", "..#...#.........##..", "...#.#....####....#.",
                                       "....#....#....#...#.", ".........#....####..", "..........####......"};
  constexpr int size = 14, columns = 20, height = 12, gap = 24;
  picture big(2 * (columns * size + 1) + gap, height * size + 1, {255, 255, 255, 255});
  int left = 0;
  for (const auto next_to : {irg::neighbours::four, irg::neighbours::eight}) {
    picture small(columns, height, paper);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < columns; ++x)
        if (rows[y][static_cast<std::size_t>(x)] == '#') small(x, y) = ink;
    irg::flood_fill(small, {4, 3}, blue, next_to);
    paste(big, enlarged(small, size), left, 0);
    dot(big, {left + 4 * size + size / 2, 3 * size + size / 2}, 3, red);
    left += columns * size + 1 + gap;
  }
  return big;
}

// A fan of triangles: every centre belongs to one of them.
inline picture tiling() {
  constexpr int size = 22;
  picture small(18, 13, paper);
  const irg::subpixel hub{2176, 1664};  // on a centre
  const std::array<irg::subpixel, 8> rim{
      irg::subpixel{300, 300},   irg::subpixel{2176, 128},  irg::subpixel{3900, 500}, irg::subpixel{4480, 1664},
      irg::subpixel{4100, 2900}, irg::subpixel{2176, 3200}, irg::subpixel{640, 3200}, irg::subpixel{128, 1664}};
  const irg::rgba8 tints[] = {{120, 166, 212, 255}, {216, 150, 130, 255}, {168, 200, 150, 255}, {226, 206, 140, 255}};
  for (std::size_t i = 0; i < rim.size(); ++i)
    irg::fill_triangle(small, hub, rim[i], rim[(i + 1) % rim.size()], tints[i % 4]);
  picture big(small.width() * size + 1, small.height() * size + 1, paper);
  paste(big, enlarged(small, size), 0, 0);
  const auto place = [](irg::subpixel p) { return irg::cell{p.x * size / 256, p.y * size / 256}; };
  for (int y = 0; y < small.height(); ++y)
    for (int x = 0; x < small.width(); ++x) dot(big, {x * size + size / 2, y * size + size / 2}, 1, ink);
  for (std::size_t i = 0; i < rim.size(); ++i) {
    irg::draw_line(big, place(hub), place(rim[i]), ink);
    irg::draw_line(big, place(rim[i]), place(rim[(i + 1) % rim.size()]), ink);
  }
  return big;
}

// Points of a grid against a convex polygon and a pentagram: inside, on the boundary, outside.
inline picture locations() {
  constexpr int size = 20, columns = 14, height = 12;
  picture p(2 * columns * size, height * size, paper);
  using P = irg::point<int, 2>;
  const std::vector<P> rings[] = {{P{2, 4}, P{6, 10}, P{12, 6}, P{8, 2}, P{4, 2}},
                                  {P{7, 11}, P{11, 1}, P{1, 7}, P{13, 7}, P{3, 1}}};
  for (int k = 0; k < 2; ++k) {
    const auto place = [&](P q) { return irg::cell{(k * columns + q.x) * size, (height - q.y) * size}; };
    for (std::size_t i = 0; i < rings[k].size(); ++i)
      irg::draw_line(p, place(rings[k][i]), place(irg::ring_vertex(rings[k], i + 1)), ink);
    for (int y = 1; y < height; ++y)
      for (int x = 1; x < columns; ++x) {
        const auto where = irg::locate_point(rings[k], P{x, y});
        const bool on = where == irg::location::boundary;
        dot(p, place({x, y}), on ? 4 : 3, on ? red : where == irg::location::inside ? blue : pale);
      }
  }
  return p;
}

}  // namespace textbook_fill
