// SPDX-License-Identifier: MIT
// Pictures of the anti-aliased fills: a convex polygon, both fill rules, the seam between neighbours, a run of
// coverages.
#pragma once

#include <array>

#include <irg/raster/fill_polygon_aa.hpp>

#include "fills.hpp"

namespace fills_aa {

using namespace enlarging;
using fills::blue, fills::cell_size, fills::ring;

inline picture convex() {
  const ring polygon{{384, 384}, {2500, 128}, {4300, 1500}, {2176, 2676}, {300, 1500}};
  picture small(18, 11, paper);
  irg::fill_convex_aa(small, polygon, blue);
  picture big = enlarged(small, cell_size);
  fills::outline(big, polygon);
  return big;
}

// A pentagram with a square in its core: even-odd on the left, non-zero on the right.
inline picture rules() {
  const ring star{{2200, 60}, {3560, 4200}, {60, 1660}, {4340, 1660}, {840, 4200}};
  const ring square{{1844, 2048}, {2612, 2048}, {2612, 2816}, {1844, 2816}};
  const int width = 18 * cell_size + 1;
  picture both(2 * width + cell_size, 17 * cell_size + 1, {255, 255, 255, 255});
  int left = 0;
  for (const irg::fill_rule rule : {irg::fill_rule::even_odd, irg::fill_rule::non_zero}) {
    picture small(18, 17, paper);
    irg::fill_polygon_aa(small, std::array<ring, 2>{star, square}, rule, blue);
    paste(both, enlarged(small, cell_size), left, 0);
    left += width + cell_size;
  }
  return both;
}

// Two polygons that share an edge, one colour: smooth on the left, with a seam, and aliased on the right, without.
inline picture seam() {
  const ring above{{0, 0}, {4096, 0}, {4096, 700}, {0, 2100}}, below{{0, 2100}, {4096, 700}, {4096, 2816}, {0, 2816}};
  const int width = 16 * cell_size + 1;
  picture both(2 * width + cell_size, 11 * cell_size + 1, {255, 255, 255, 255});
  picture smooth(16, 11, paper), aliased(16, 11, paper);
  for (const ring& r : {above, below}) {
    irg::fill_convex_aa(smooth, r, blue);
    irg::fill_convex(aliased, r, blue);
  }
  paste(both, enlarged(smooth, cell_size), 0, 0);
  paste(both, enlarged(aliased, cell_size), width + cell_size, 0);
  return both;
}

// Runs of coverages from 0 to 255, mixed into two backgrounds.
inline picture run() {
  picture small(18, 2, paper);
  irg::fill_span(small, {1, 0, 18}, ink);
  std::uint8_t coverage[18];
  for (int i = 0; i < 18; ++i) coverage[i] = static_cast<std::uint8_t>(i * 15);
  for (int y = 0; y < 2; ++y) irg::blend_span(small, {y, 0, 18, coverage}, blue);
  return enlarged(small, cell_size);
}

}  // namespace fills_aa
