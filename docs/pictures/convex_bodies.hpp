// SPDX-License-Identifier: MIT
// Bodies drawn from their front faces alone, the last of the mesh first: right for a convex one, wrong for
// a torus. Included by pictures.cpp.
#pragma once

#include <irg/mesh/convex_body.hpp>
#include <irg/mesh/shapes.hpp>

#include "meshes.hpp"

namespace convex_body_pictures {

using namespace mesh_pictures;

inline void front_faces(picture& p, const body& m, const space& s, const vec3& to_viewer) {
  for (std::size_t f = m.face_count(); f-- > 0;) {
    const auto n = irg::face_normal(m, f);
    if (!n || irg::dot(*n, to_viewer) <= 0) continue;
    const double light = irg::dot(*n, irg::normalized(vec3{-0.3, 0.8, 0.6}));
    const auto grade = static_cast<std::uint8_t>(150 + 90 * (light > 0 ? light : 0));
    const auto paler = static_cast<std::uint8_t>(grade - 20);
    area(p, s.at(face_of(m, f)),
         irg::is_convex_body(m) ? irg::rgba8{paler, grade, paler, 255} : irg::rgba8{grade, paler, paler, 255});
    outline(p, s.at(face_of(m, f)), 1.0, ink);
  }
}

inline picture bodies() {
  constexpr int panel = 320, height = 280;
  picture p(2 * panel, height, paper);
  const vec3 to_viewer{0.2, 0.34, 1};
  front_faces(p, irg::shape_icosahedron<double>(), seen_from(to_viewer, {panel * 0.5, height * 0.5}, 116), to_viewer);
  const body torus = irg::shape_torus<double>({.minor_radius = 0.4, .major_segments = 13, .minor_segments = 7});
  front_faces(p, torus, seen_from(to_viewer, {panel * 1.5, height * 0.5}, 104), to_viewer);
  return p;
}

}  // namespace convex_body_pictures
