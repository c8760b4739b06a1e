// SPDX-License-Identifier: MIT
// Line drawings with hidden lines: three bodies, and a drawing whose hidden lines are dashed; a cube's edges; the
// regions of what is seen. Included by pictures.cpp.
#pragma once

#include <vector>

#include <irg/hidden/line_drawing.hpp>
#include <irg/hidden/visible_polygons.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/mesh/teapot.hpp>
#include <irg/raster/fill_polygon_aa.hpp>
#include <irg/raster/line_aa.hpp>
#include <irg/view/affine.hpp>
#include <irg/view/projection.hpp>

#include "enlarged.hpp"

namespace line_drawings {

using namespace enlarging;
constexpr int width = 340, height = 250;

// A torus through a cube on a plate, with the edges that are named.
inline irg::line_drawing bodies(irg::drawn_edges edges) {
  using namespace irg;
  const auto to_clip = perspective(radians(30.0), double(width) / height, 1.0, 100.0) *
                       translation(vec<double, 3>{-0.1, 0.35, -9.6}) * rotation_x(0.45) * rotation_y(-0.55);
  line_drawing d;
  const auto add = [&](const mesh<double>& m, const mat<double, 4, 4>& place) {
    add_mesh(d, m, to_clip * place, map_to_screen<double>({width, height}), {.edges = edges});
  };
  add(shape_cube<double>(), translation(vec<double, 3>{0, -1.35, 0}) * scaling(vec<double, 3>{2.3, 0.12, 1.7}));
  add(shape_cube<double>(), translation(vec<double, 3>{0.75, -0.43, 0.1}) * scaling(vec<double, 3>{0.8, 0.8, 0.8}));
  add(shape_torus<double>({.minor_radius = 0.4, .major_segments = 32, .minor_segments = 16}),
      translation(vec<double, 3>{-0.45, -0.05, 0}) * rotation_z(0.5) * rotation_x(1.3));
  return d;
}

// A line, of dashes where it is hidden.
inline void draw_part(picture& p, const irg::screen_edge& e, const irg::edge_part& part, irg::rgba8 hidden) {
  const auto a = irg::point_on(e, part.from), b = irg::point_on(e, part.to);
  if (part.visibility == irg::line_visibility::visible) {
    irg::draw_line_aa(p, a, b, irg::rgba8{32, 44, 66, 255}, {.width = 320});
    return;
  }
  if (hidden.a == 0) return;
  const double dash = 3, length = irg::length(b - a);
  for (double s = 0; s < length; s += 2 * dash)
    irg::draw_line_aa(p, a + (b - a) * (s / length), a + (b - a) * (irg::minimum(s + dash, length) / length), hidden,
                      {.width = 230});
}

// Left all edges, right the visible parts of the features with their hidden parts dashed.
inline picture hidden_lines() {
  picture all(2 * width, height, paper), half(width, height, paper);
  for (const auto edges : {irg::drawn_edges::every, irg::drawn_edges::features}) {
    half = picture(width, height, paper);
    const bool features = edges == irg::drawn_edges::features;
    const irg::line_drawing d = bodies(edges);
    for (const auto first : {irg::line_visibility::hidden, irg::line_visibility::visible})
      irg::hidden_lines(d.faces, d.edges, [&](const irg::edge_part& part) {
        if (part.visibility == first)
          draw_part(half, d.edges[part.edge], part, features ? irg::rgba8{150, 160, 176, 255} : irg::rgba8{0, 0, 0, 0});
      });
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) all(x + (features ? width : 0), y) = half(x, y);
  }
  return all;
}

// A cube of triangles: left its twelve edges, right the nine of them that are seen.
inline picture cube_edges() {
  using namespace irg;
  constexpr int side = 220;
  const auto to_clip = perspective(radians(30.0), 1.0, 1.0, 100.0) * translation(vec<double, 3>{0, 0, -5.4}) *
                       rotation_x(0.5) * rotation_y(-0.55);
  line_drawing d;
  add_mesh(d, shape_cube<double>(), to_clip, map_to_screen<double>({side, side}));
  const std::vector<screen_face> nothing;
  picture all(2 * side, side, paper);
  for (const bool hides : {false, true}) {
    picture half(side, side, paper);
    hidden_lines(hides ? d.faces : nothing, d.edges, [&](const edge_part& part) {
      if (part.visibility == line_visibility::visible) draw_part(half, d.edges[part.edge], part, {});
    });
    paste(all, half, hides ? side : 0, 0);
  }
  return all;
}

// The regions in which faces of the three bodies are seen, enlarged: each filled on its own, its rings drawn over it.
inline picture visible_polygons() {
  picture p(2 * width, 2 * height, paper);
  const irg::line_drawing d = bodies(irg::drawn_edges::every);
  const irg::visible_polygon_map map = irg::visible_polygons(d.faces, {0, 0, width, height});
  for (std::size_t i = 0, end = 0; i < map.rings.size(); i = end) {
    std::vector<std::vector<irg::point<double, 2>>> rings;
    for (; end < map.rings.size() && map.rings[end].number == map.rings[i].number; ++end) {
      std::vector<irg::point<double, 2>> ring;
      for (std::size_t k = 0; k < map.rings[end].count; ++k) {
        const auto c = corner_of(map, map.rings[end], k);
        ring.push_back({2 * c.x, 2 * c.y});
      }
      rings.push_back(std::move(ring));
    }
    const std::uint32_t n = map.rings[i].number, mixed = n * 2654435761u;
    const auto tint = [mixed](unsigned shift) { return static_cast<std::uint8_t>(176 + (mixed >> shift) % 72); };
    const irg::rgba8 colour = n == irg::no_index ? paper : irg::rgba8{tint(8), tint(15), tint(22), 255};
    irg::fill_polygon_aa(p, rings, irg::fill_rule::non_zero, colour);
  }
  for (const irg::visible_ring& ring : map.rings)
    for (std::size_t k = 0; k < ring.count; ++k) {
      const auto a = corner_of(map, ring, k), b = corner_of(map, ring, k + 1 == ring.count ? 0 : k + 1);
      irg::draw_line_aa(p, irg::point<double, 2>{2 * a.x, 2 * a.y}, irg::point<double, 2>{2 * b.x, 2 * b.y},
                        irg::rgba8{32, 44, 66, 255}, {.width = 200});
    }
  return p;
}

}  // namespace line_drawings
