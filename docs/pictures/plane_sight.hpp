// SPDX-License-Identifier: MIT
// What is seen from points of the plane: visibility polygons. Included by pictures.cpp.
#pragma once

#include <algorithm>
#include <vector>

#include <irg/visibility/guard_cover.hpp>
#include <irg/visibility/visibility_polygon.hpp>
#include <irg/visibility/weak_visibility.hpp>

#include "sketch.hpp"

namespace plane_sight {

using namespace sketching;
using wall = irg::segment<double, 2>;
constexpr irg::rgba8 night{74, 82, 104, 255}, glow{255, 232, 158, 255}, ink{30, 34, 48, 255}, stone{140, 146, 160, 255};

// A panel of 330 x 330 pixels that shows the square from -5.5 to 5.5, y up.
struct panel {
  picture image{330, 330, paper};
  static point2 at(const point2& p) { return {165 + 30 * p.x, 165 - 30 * p.y}; }
  static ring placed(const ring& r) {
    ring out;
    for (const point2& p : r) out.push_back(at(p));
    return out;
  }
  void fill(const ring& r, irg::rgba8 colour) { area(image, placed(r), colour); }
  void line(const point2& a, const point2& b, double width, irg::rgba8 colour) {
    stroke(image, {at(a), at(b)}, width, colour);
  }
};

inline picture side_by_side(const std::vector<panel>& panels) {
  picture all(static_cast<int>(panels.size()) * 342 - 12, 330, paper);
  for (std::size_t i = 0; i < panels.size(); ++i)
    for (int y = 0; y < 330; ++y)
      for (int x = 0; x < 330; ++x) all(static_cast<int>(i) * 342 + x, y) = panels[i].image(x, y);
  return all;
}

// What is seen from `source`: bright; the obstacles and edges of which something is seen: red.
inline panel seen_from(const point2& source, const std::vector<ring>& rings, const std::vector<wall>& walls,
                       irg::obstacle_ends ends = irg::obstacle_ends::closed) {
  panel p;
  std::vector<ring> outlines;
  for (const ring& r : rings) outlines.push_back(panel::placed(r));
  irg::fill_polygon_aa(p.image, outlines, irg::fill_rule::even_odd, glaze(night));
  const auto seen = irg::visibility_polygon(source, rings, walls, {.ends = ends});
  ring lit;
  for (const auto& v : seen.ring) lit.push_back(v.at);
  p.fill(lit, glow);
  for (std::size_t i = 0; i + 1 < lit.size(); ++i)
    if (i > 0 && lit[i - 1] == lit[i + 1]) p.line(lit[i - 1], lit[i], 2.0, glow);
  for (const ring& r : rings)
    for (std::size_t i = 0; i < r.size(); ++i) p.line(r[i], r[(i + 1) % r.size()], 2.0, ink);
  for (const wall& w : walls) p.line(w.a, w.b, 4.0, stone);
  for (std::size_t i = 0; i < seen.ring.size(); ++i)
    if (seen.ring[i].stop != irg::sight_stop::nothing) p.line(lit[i], lit[(i + 1) % lit.size()], 3.0, red);
  mark(p.image, panel::at(source), 5, blue);
  return p;
}

inline picture polygons() {
  const ring square{{-5, -5}, {5, -5}, {5, 5}, {-5, 5}};
  const ring house{{-5, -5}, {5, -5}, {5, 1},  {2, 1},  {2, 3},  {5, 3},
                   {5, 5},   {-5, 5}, {-5, 2}, {-2, 2}, {-2, 1}, {-5, 1}};
  const ring pillar{{-1, -2}, {1, -2}, {0, -0.5}};
  const std::vector<wall> crossing{{{-4, 1}, {-1, 4}},       {{-4, 3}, {-2, 0}},  {{1, 2}, {4, 2}},
                                   {{2, 1}, {3, 4}},         {{2, -3}, {2, 0.5}}, {{-3, -3}, {1, -2}},
                                   {{-2, -4}, {-1.5, -1.5}}, {{4, -4}, {4, 4}}};
  const std::vector<wall> fence{{{-3, 2}, {-1, 3}}, {{-1, 3}, {1, 3}},    {{1, 3}, {3, 2}},
                                {{3, -1}, {3, 2}},  {{-3, -2}, {-1, -3}}, {{-1, -3}, {2, -2}}};
  return side_by_side({seen_from({0, 0}, {square}, crossing), seen_from({2, -5}, {house, pillar}, {}),
                       seen_from({0, 0}, {square}, fence, irg::obstacle_ends::open)});
}

// Light, penumbra and umbra of a source: bright, half bright and dark.
inline panel lit_by(const ring& source, const std::vector<wall>& walls) {
  panel p;
  const irg::box<double, 2> window{{-5, -5}, {5, 5}};
  const auto regions = irg::weak_visibility(std::span<const point2>(source), walls, window);
  constexpr irg::rgba8 half{176, 166, 146, 255};
  const auto paint = [&](const std::vector<ring>& rings, irg::rgba8 colour) {
    std::vector<ring> placed;
    for (const ring& r : rings) placed.push_back(panel::placed(r));
    irg::fill_polygon_aa(p.image, placed, irg::fill_rule::even_odd, glaze(colour));
  };
  paint(regions.none, night);
  paint(regions.some, half);
  paint(regions.all, glow);
  for (const wall& w : walls) p.line(w.a, w.b, 4.0, ink);
  if (source.size() == 1)
    mark(p.image, panel::at(source[0]), 5, red);
  else if (source.size() == 2)
    p.line(source[0], source[1], 5.0, red);
  else
    p.fill(source, red);
  return p;
}

inline picture shadows() {
  const std::vector<wall> walls{{{-3, 0}, {-1, 0.5}},   {{0, -1}, {1.5, -0.5}}, {{2.5, 1}, {3.5, 0}},
                                {{-2, -3}, {-1, -2.5}}, {{1, -2.5}, {1, -3.5}}, {{-1, 0.5}, {-1, 1.5}}};
  return side_by_side({lit_by({{0, 3.5}}, walls), lit_by({{-1.5, 3.5}, {1.5, 3.5}}, walls),
                       lit_by({{-1.5, 3}, {0, 3.8}, {1.5, 3}, {0.8, 4.6}, {-0.8, 4.6}}, walls)});
}

// A town of houses: what is seen from a place, from places on a path, and the places that see all of the path or some.
inline panel town(const ring& places, bool as_a_whole) {
  const std::vector<ring> houses{
      {{-4.5, -4}, {-2, -4}, {-2, -2.5}, {-4.5, -2.5}}, {{-0.5, -4.5}, {1, -4.5}, {1, -1.5}, {-0.5, -1.5}},
      {{2.5, -3.5}, {4.5, -3.5}, {4.5, -1}, {2.5, -1}}, {{-4, 0.5}, {-1.5, 0.5}, {-1.5, 2}, {-3, 3.5}, {-4, 3.5}},
      {{0.5, 1}, {2, 1.5}, {1.5, 3}, {0, 2.5}},         {{3, 2}, {4.5, 2}, {4.5, 4}, {3, 4}}};
  std::vector<wall> walls;
  for (const ring& h : houses)
    for (std::size_t i = 0; i < h.size(); ++i) walls.push_back({h[i], h[(i + 1) % h.size()]});
  const irg::box<double, 2> window{{-5, -5}, {5, 5}};
  panel p;
  p.fill({{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}, night);
  if (as_a_whole) {
    const auto parts = irg::weak_visibility(std::span<const point2>(places), walls, window);
    for (const auto& [rings, colour] :
         {std::pair{&parts.some, irg::rgba8{176, 166, 146, 255}}, std::pair{&parts.all, glow}}) {
      std::vector<ring> placed;
      for (const ring& r : *rings) placed.push_back(panel::placed(r));
      irg::fill_polygon_aa(p.image, placed, irg::fill_rule::even_odd, glaze(colour));
    }
  } else {
    for (const point2& from : places) {
      ring seen;
      for (const auto& v : irg::visibility_polygon(from, window, walls).ring) seen.push_back(v.at);
      p.fill(seen, glow);
    }
  }
  for (const ring& h : houses) p.fill(h, {150, 104, 84, 255});
  if (as_a_whole) p.line(places.front(), places.back(), 4.0, red);
  for (const point2& from : places) mark(p.image, panel::at(from), 4, red);
  return p;
}

inline picture street() {
  return side_by_side(
      {town({{-1, -0.5}}, false), town({{-3, -1}, {-1, -0.5}, {1, 0}}, false), town({{-3, -1}, {1, 0}}, true)});
}

// A plan, its guards, and the parts in the colour of the guard who is said to see them.
inline panel guarded(const std::vector<ring>& rings) {
  panel p;
  const auto cover = irg::cover_by_guards(std::span<const ring>(rings));
  constexpr irg::rgba8 tints[] = {
      {255, 232, 158, 255}, {206, 222, 240, 255}, {240, 210, 200, 255}, {208, 230, 206, 255}};
  std::vector<point2> corners;
  for (const ring& r : rings) corners.insert(corners.end(), r.begin(), r.end());
  const auto place_of = [&](std::size_t guard) {
    return static_cast<std::size_t>(std::find(cover.guards.begin(), cover.guards.end(), guard) - cover.guards.begin());
  };
  for (const auto& part : cover.parts) p.fill(part.ring, tints[place_of(part.guard) % 4]);
  for (const auto& part : cover.parts)
    for (std::size_t i = 0; i < part.ring.size(); ++i)
      p.line(part.ring[i], part.ring[(i + 1) % part.ring.size()], 0.7, grey);
  for (const ring& r : rings)
    for (std::size_t i = 0; i < r.size(); ++i) p.line(r[i], r[(i + 1) % r.size()], 2.5, ink);
  for (const std::size_t g : cover.guards) mark(p.image, panel::at(corners[g]), 6, red);
  return p;
}

inline picture galleries() {
  const ring comb{{-5, -4}, {5, -4}, {5, -2}, {4, -2},  {4, 4},   {2, 4},  {3, -2},
                  {1, -2},  {0, 4},  {-2, 4}, {-1, -2}, {-3, -2}, {-4, 4}, {-5, 4}};
  const ring rooms{{-5, -5}, {-0.5, -5}, {-0.5, -1}, {0.5, -1}, {0.5, -5}, {5, -5}, {5, 0},  {1, 0},
                   {1, 1},   {5, 1},     {5, 5},     {0, 5},    {0, 1},    {-1, 1}, {-1, 5}, {-5, 5}};
  const ring yard{{-5, -5}, {5, -4}, {4, 5}, {-5, 4}}, pillar{{-1, -1}, {1, -2}, {2, 1}, {-1, 2}};
  return side_by_side({guarded({rooms}), guarded({comb}), guarded({yard, pillar})});
}

}  // namespace plane_sight
