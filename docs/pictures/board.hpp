// SPDX-License-Identifier: MIT
// A part of a picture in which y points up, with coordinates of its own, to draw points, edges and polygons on.
#pragma once

#include <vector>

#include <irg/raster/fill_polygon_aa.hpp>

#include "sketch.hpp"

namespace sketching {

struct board {
  picture& p;
  double left, bottom, scale;
  point2 at(const point2& q) const { return {left + q.x * scale, bottom - q.y * scale}; }
  point2 back(const point2& pixel) const { return {(pixel.x - left) / scale, (bottom - pixel.y) / scale}; }
  ring at(ring r) const {
    for (point2& q : r) q = at(q);
    return r;
  }

  void fill(const ring& r, irg::rgba8 colour) const { area(p, at(r), colour); }
  void fill_rings(std::vector<ring> rings, irg::rgba8 colour) const {
    for (ring& r : rings) r = at(r);
    irg::fill_polygon_aa(p, rings, irg::fill_rule::even_odd, colour);
  }
  void line(const point2& a, const point2& b, double width, irg::rgba8 colour) const {
    stroke(p, {at(a), at(b)}, width, colour);
  }
  void outline(const ring& r, double width, irg::rgba8 colour) const { sketching::outline(p, at(r), width, colour); }
  // An edge with an arrow's tip at a part of its length.
  void edge(const point2& a, const point2& b, double width, irg::rgba8 colour, double tip = 0.6) const {
    line(a, b, width, colour);
    arrow(p, at(a), at(a + (b - a) * tip), width, colour);
  }
  void edges(const ring& r, double width, irg::rgba8 colour, double tip = 0.6) const {
    for (std::size_t i = 0; i < r.size(); ++i) edge(r[i], r[(i + 1) % r.size()], width, colour, tip);
  }
  void dot(const point2& centre, double radius, irg::rgba8 colour) const { disc(p, at(centre), radius, colour); }
  void dots(const ring& r, double radius, irg::rgba8 colour) const {
    for (const point2& q : r) dot(q, radius, colour);
  }
};

}  // namespace sketching
