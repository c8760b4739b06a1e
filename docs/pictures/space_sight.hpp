// SPDX-License-Identifier: MIT
// What is seen from a point of space, in the six sides of a cube that is folded out. Included by pictures.cpp.
#pragma once

#include <cstdint>
#include <vector>

#include <irg/hidden/visible_polygons.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/hidden/faces_around.hpp>

#include "sketch.hpp"

namespace space_sight {

using namespace sketching;

inline void add_box(irg::mesh<double>& m, const point3& low, const point3& high) {
  const irg::mesh<double> cube = irg::shape_cube<double>();
  const auto first = static_cast<std::uint32_t>(m.positions.size());
  for (const point3& p : cube.positions)
    m.positions.push_back(
        {low.x + p.x * (high.x - low.x), low.y + p.y * (high.y - low.y), low.z + p.z * (high.z - low.z)});
  for (std::size_t f = 0; f < cube.face_count(); ++f) {
    const std::uint32_t face[] = {first + cube.corner(f, 0).position, first + cube.corner(f, 1).position,
                                  first + cube.corner(f, 2).position};
    irg::add_face(m, face);
  }
}

// A court with a roof on one side: each box has a colour, lighter where it faces up.
inline picture folded_out() {
  irg::mesh<double> m;
  add_box(m, {-6, -6, -1.6}, {6, 6, -1.5});
  add_box(m, {2, -3, -1.5}, {4, 0, 1});
  add_box(m, {-4, 1, -1.5}, {-2, 4, 2});
  add_box(m, {-1, -4, -1.5}, {0, -3, 3});
  add_box(m, {0, 2, 1.5}, {5, 5, 1.7});
  add_box(m, {1, 3, -1.5}, {1.3, 3.3, 1.5});
  add_box(m, {3.5, 3, -1.5}, {3.8, 3.3, 1.5});
  constexpr irg::rgba8 colours[] = {{178, 176, 166, 255}, {204, 76, 58, 255},   {62, 112, 176, 255}, {66, 140, 84, 255},
                                    {214, 170, 70, 255},  {150, 104, 150, 255}, {150, 104, 150, 255}};
  constexpr int size = 150;
  picture p(4 * size + 20, 3 * size + 20, paper);
  constexpr int column[] = {3, 1, 2, 0, 0, 2}, row[] = {1, 1, 1, 1, 0, 2};
  const auto draw_side = [&](std::size_t i, const std::vector<irg::screen_face>& faces) {
    const auto map = irg::visible_polygons(faces, irg::cell_window{0, 0, size, size});
    const double left = 10 + size * column[i], top = 10 + size * row[i];
    for (const auto& r : map.rings) {
      if (r.number == irg::no_index) continue;
      ring outline;
      for (std::size_t k = 0; k < r.count; ++k) {
        const auto at = irg::corner_of(map, r, k);
        outline.push_back({left + at.x, top + at.y});
      }
      const std::uint32_t side = r.number % 12 / 2;
      const irg::rgba8 base = colours[r.number / 12];
      const irg::rgba8 shade{255, 255, 255, static_cast<std::uint8_t>(30 + 28 * side)};
      area(p, outline, irg::mix(base, irg::rgba8{shade.r, shade.g, shade.b, 255}, shade.a));
      for (std::size_t k = 0; k < outline.size(); ++k)
        stroke(p, {outline[k], outline[(k + 1) % outline.size()]}, 1.0, grey);
    }
    const ring frame{{left, top}, {left + size, top}, {left + size, top + size}, {left, top + size}, {left, top}};
    stroke(p, frame, 2.0, {40, 44, 56, 255});
  };
  irg::faces_around(point3{0, 0, 0}, m, draw_side, {size, 0.01});
  return p;
}

}  // namespace space_sight
