// SPDX-License-Identifier: MIT
// Pictures of clipping: segments and polygons against windows and convex polygons, and operations on polygons.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include <irg/geometry/clip_line_cyrus_beck.hpp>
#include <irg/geometry/clip_line_liang_barsky.hpp>
#include <irg/geometry/clip_sutherland_hodgman.hpp>
#include <irg/geometry/polygon_overlay.hpp>
#include <irg/geometry/textbook/clip_weiler_atherton.hpp>
#include <irg/raster/fill_polygon_aa.hpp>
#include <irg/raster/line_aa.hpp>

#include "enlarged.hpp"

namespace clipping_pictures {

using namespace enlarging;
using P = irg::point<double, 2>;
using Ring = std::vector<P>;
constexpr irg::rgba8 blue{120, 166, 212, 255}, red{204, 96, 72, 255}, faint{178, 184, 196, 255};

inline P moved(const P& p, double x) { return {p.x + x, p.y}; }
inline Ring moved(Ring ring, double x) {
  for (P& p : ring) p = moved(p, x);
  return ring;
}

inline Ring round(P centre, double radius, int corners, double dent = 1) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 6.283185307179586 * i / corners - 1.2, r = i % 2 == 0 ? radius : radius * dent;
    ring.push_back({centre.x + r * std::cos(angle), centre.y + r * std::sin(angle)});
  }
  return ring;
}

inline void segment(picture& p, const P& a, const P& b, irg::rgba8 colour) {
  irg::draw_line_aa(p, a, b, colour, {.width = 384});
}
inline void outline(picture& p, const Ring& ring, irg::rgba8 colour) {
  for (std::size_t i = 0; i < ring.size(); ++i) segment(p, ring[i], ring[(i + 1) % ring.size()], colour);
}
inline void mark(picture& p, const P& at, irg::rgba8 colour) {
  dot(p, {static_cast<int>(at.x), static_cast<int>(at.y)}, 3, colour);
}

inline const irg::box<double, 2> window{{70, 60}, {230, 180}};
inline const Ring frame{{70, 60}, {230, 60}, {230, 180}, {70, 180}};

// The same segments against a window and against a hexagon: what is kept is dark.
inline picture lines() {
  picture p(640, 240, paper);
  const std::array<std::array<P, 2>, 7> given{{{P{20, 100}, P{280, 40}},
                                               {P{40, 30}, P{150, 230}},
                                               {P{100, 90}, P{190, 150}},
                                               {P{20, 200}, P{290, 110}},
                                               {P{30, 140}, P{100, 25}},
                                               {P{200, 230}, P{290, 130}},
                                               {P{250, 30}, P{190, 220}}}};
  const Ring hexagon = round({150, 120}, 88, 6);
  outline(p, frame, red);
  outline(p, moved(hexagon, 320), red);
  for (const auto& [a, b] : given) {
    segment(p, a, b, faint);
    segment(p, moved(a, 320), moved(b, 320), faint);
    if (const auto kept = clip_line_liang_barsky(a, b, window)) {
      segment(p, kept->first, kept->second, ink);
      mark(p, kept->first, ink), mark(p, kept->second, ink);
    }
    if (const auto kept = clip_line_cyrus_beck(a, b, hexagon)) {
      segment(p, moved(kept->first, 320), moved(kept->second, 320), ink);
      mark(p, moved(kept->first, 320), ink), mark(p, moved(kept->second, 320), ink);
    }
  }
  return p;
}

// A star against both; the dots are the vertices that come out.
inline picture polygons() {
  picture p(640, 240, paper);
  const Ring star = round({150, 120}, 110, 14, 0.5), hexagon = round({150, 120}, 88, 6);
  const Ring kept[] = {clip_sutherland_hodgman(star, window), moved(clip_sutherland_hodgman(star, hexagon), 320)};
  const Ring regions[] = {frame, moved(hexagon, 320)}, stars[] = {star, moved(star, 320)};
  for (int i = 0; i < 2; ++i) {
    irg::fill_polygon_aa(p, kept[i], irg::fill_rule::non_zero, blue);
    outline(p, stars[i], faint);
    outline(p, regions[i], red);
    for (const P& v : kept[i]) mark(p, v, ink);
  }
  return p;
}

// A star with a hole and a square with a hole: intersection, union, difference, symmetric difference.
inline picture operations() {
  picture p(880, 220, paper);
  const std::vector<Ring> a{round({95, 110}, 85, 10, 0.55), round({95, 110}, 22, 12)};
  const std::vector<Ring> b{{{90, 60}, {200, 60}, {200, 170}, {90, 170}},
                            {{130, 90}, {170, 90}, {170, 140}, {130, 140}}};
  double left = 0;
  for (const auto operation : {irg::boolean_operation::intersection, irg::boolean_operation::union_,
                               irg::boolean_operation::difference, irg::boolean_operation::symmetric_difference}) {
    std::vector<Ring> rings = polygon_boolean(a, b, operation).rings;
    for (Ring& ring : rings) ring = moved(ring, left);
    irg::fill_polygon_aa(p, rings, irg::fill_rule::non_zero, blue);
    for (const Ring& ring : a) outline(p, moved(ring, left), faint);
    for (const Ring& ring : b) outline(p, moved(ring, left), faint);
    for (const Ring& ring : rings) outline(p, ring, ink);
    left += 220;
  }
  return p;
}

// A comb and a lens: entering points are blue, leaving ones red. On the right what the walk from each entering point gives.
inline picture entering_and_leaving() {
  picture p(640, 240, paper);
  const Ring comb{{30, 30},   {270, 30},  {270, 70},  {110, 70},  {110, 95},  {270, 95},
                  {270, 145}, {110, 145}, {110, 170}, {270, 170}, {270, 210}, {30, 210}};
  const Ring lens = round({225, 120}, 98, 16);
  const auto clip = irg::textbook::clip_weiler_atherton(comb, lens);
  outline(p, comb, ink);
  outline(p, lens, faint);
  for (const P& at : clip.entering) mark(p, at, blue);
  for (const P& at : clip.leaving) mark(p, at, red);
  for (const Ring& ring : clip.rings) {
    irg::fill_polygon_aa(p, moved(ring, 310), irg::fill_rule::non_zero, blue);
    outline(p, moved(ring, 310), ink);
  }
  return p;
}

}  // namespace clipping_pictures
