// SPDX-License-Identifier: MIT
// Pictures of the production fills: an edge walked row by row, a convex polygon, both fill rules, a batch.
#pragma once

#include <array>
#include <vector>

#include <irg/colour/pixel.hpp>
#include <irg/raster/draw_line.hpp>
#include <irg/raster/edge_walk.hpp>
#include <irg/raster/fill_convex.hpp>
#include <irg/raster/fill_polygons.hpp>
#include <irg/raster/image.hpp>

#include "enlarged.hpp"

namespace fills {

using namespace enlarging;
using ring = std::vector<irg::subpixel>;
constexpr irg::rgba8 blue{120, 166, 212, 255}, red{204, 96, 72, 255}, light_blue{196, 216, 236, 255};
constexpr int cell_size = 24;

// Each pixel as a square with a dot at its centre.
inline picture with_centres(const picture& small) {
  picture big = enlarged(small, cell_size);
  for (int y = 0; y < small.height(); ++y)
    for (int x = 0; x < small.width(); ++x)
      for (int row = -1; row <= 1; ++row)
        irg::fill_span(
            big,
            {y * cell_size + cell_size / 2 + row, x * cell_size + cell_size / 2 - 1, x * cell_size + cell_size / 2 + 2},
            ink);
  return big;
}

inline irg::cell place(irg::subpixel p) { return {p.x * cell_size / 256, p.y * cell_size / 256}; }

inline void outline(picture& big, const ring& r, irg::rgba8 colour = red) {
  for (std::size_t i = 0; i < r.size(); ++i) irg::draw_line(big, place(r[i]), place(r[(i + 1) % r.size()]), colour);
}

// The first column whose centre is on or right of the edge, row by row; the pixels from there on are pale blue.
inline picture edge() {
  picture small(16, 9, paper);
  const irg::subpixel upper{600, 140}, lower{3456, 2176};  // the lower end is a centre: its row is not crossed
  const irg::row_range rows = irg::rows_of_edge(upper, lower);
  auto e = irg::walk_edge(upper, lower, rows.first);
  for (int y = static_cast<int>(rows.first); y < static_cast<int>(rows.last); ++y, e.next()) {
    irg::fill_span(small, {y, e.column, 16}, light_blue);
    irg::fill_span(small, {y, e.column, e.column + 1}, blue);
  }
  picture big = with_centres(small);
  irg::draw_line(big, place(upper), place(lower), red);
  return big;
}

inline picture convex() {
  picture small(18, 12, paper);
  const ring left{{384, 384}, {1408, 128}, {2300, 900}, {2176, 2176}, {1100, 2700}, {300, 1500}},
      right{{2300, 900}, {4224, 300}, {4400, 2176}, {2176, 2176}};
  irg::fill_convex(small, left, blue);
  irg::fill_convex(small, right, {230, 178, 120, 255});
  picture big = with_centres(small);
  outline(big, left);
  outline(big, right);
  return big;
}

// A pentagram with a square in its core: even-odd on the left, non-zero on the right.
inline picture rules() {
  const ring star{{2200, 60}, {3560, 4200}, {60, 1660}, {4340, 1660}, {840, 4200}};
  const ring square{{1844, 2048}, {2612, 2048}, {2612, 2816}, {1844, 2816}};
  picture both(2 * (19 * cell_size + 1) + cell_size, 18 * cell_size + 1, {255, 255, 255, 255});
  int left = 0;
  for (const irg::fill_rule rule : {irg::fill_rule::even_odd, irg::fill_rule::non_zero}) {
    picture small(19, 18, paper);
    irg::fill_polygon(small, std::array<ring, 2>{star, square}, rule, blue);
    picture big = with_centres(small);
    outline(big, star);
    outline(big, square);
    for (int y = 0; y < big.height(); ++y)
      for (int x = 0; x < big.width(); ++x) both(left + x, y) = big(x, y);
    left += big.width() + cell_size;
  }
  return both;
}

struct lightly {
  irg::rgba8 colour;
  irg::rgba8 operator()(irg::rgba8 there) const { return irg::mix(there, colour, 110); }
};

inline picture batch() {
  picture p(480, 240, paper);
  std::vector<ring> polygons;
  std::vector<lightly> paints;
  std::uint32_t state = 7;
  const auto number = [&](int limit) {
    state = state * 1664525u + 1013904223u;
    return static_cast<int>((state >> 8) % static_cast<std::uint32_t>(limit));
  };
  for (int i = 0; i < 60; ++i) {
    const int x = number(480 * 256), y = number(240 * 256), s = 256 * (12 + number(50));
    polygons.push_back({{x, y - s}, {x + s, y + number(s)}, {x - number(s), y + s}, {x - s, y}});
    paints.push_back({i % 3 == 0   ? irg::rgba8{204, 96, 72, 255}
                      : i % 3 == 1 ? irg::rgba8{92, 142, 196, 255}
                                   : irg::rgba8{222, 178, 80, 255}});
  }
  irg::fill_polygons(p, polygons, irg::fill_rule::non_zero, paints);
  return p;
}

}  // namespace fills
