// SPDX-License-Identifier: MIT
// Pictures of the mesh chapter: faces that share vertices and their triangles, normals of vertices, a body before and
// after fitting. Included by pictures.cpp.
#pragma once

#include <array>
#include <vector>

#include <irg/geometry/box.hpp>
#include <irg/mesh/fit.hpp>
#include <irg/mesh/mesh.hpp>
#include <irg/mesh/normals.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/mesh/triangulate.hpp>

#include "cameras.hpp"

namespace mesh_pictures {

using namespace camera_pictures;
using body = irg::mesh<double>;

inline shape face_of(const body& m, std::size_t f) {
  shape s;
  for (std::size_t k = 0; k < m.face_size(f); ++k) s.push_back(m.positions[m.corner(f, k).position]);
  return s;
}

// Three faces on eleven positions, two of them concave, and their triangles.
inline picture faces() {
  constexpr int panel = 360, height = 270;
  picture p(2 * panel, height, paper);
  body m;
  m.positions = {{0, 0, 0},     {2.2, 0, 0}, {4, 0, 0},   {4, 1.7, 0}, {3.1, 1.1, 0}, {2.2, 1.6, 0},
                 {1.3, 0.8, 0}, {0, 1.5, 0}, {0.6, 3, 0}, {2, 2.4, 0}, {3.6, 3, 0}};
  irg::add_face(m, std::array{0, 1, 5, 6, 7});
  irg::add_face(m, std::array{1, 2, 3, 4, 5});
  irg::add_face(m, std::array{7, 6, 5, 4, 3, 10, 9, 8});
  const irg::rgba8 colours[] = {{206, 222, 240, 255}, {240, 210, 200, 255}, {210, 228, 208, 255}};
  const body triangles = irg::triangulated(m);
  for (int i = 0; i < 2; ++i) {
    const board b{p, panel * i + 24.0, height - 20.0, 76};
    const auto flat = [](const shape& s) {
      ring r;
      for (const point3& q : s) r.push_back({q.x, q.y});
      return r;
    };
    for (std::size_t f = 0; f < m.face_count(); ++f) b.fill(flat(face_of(m, f)), colours[f]);
    const body& shown = i ? triangles : m;
    for (std::size_t f = 0; f < shown.face_count(); ++f) b.outline(flat(face_of(shown, f)), i ? 1.5 : 2.0, ink);
    if (!i)
      for (std::size_t f = 0; f < m.face_count(); ++f) {  // which way round: arrows beside the edges, inside the face
        const ring r = flat(face_of(m, f));
        for (std::size_t k = 0; k < r.size(); ++k) {
          const point2 a = r[k], c = r[(k + 1) % r.size()];
          const vec2 along = c - a, inward = irg::normalized(vec2{-along.y, along.x}) * 0.12;
          arrow(p, b.at(a + along * 0.3 + inward), b.at(a + along * 0.7 + inward), 1.6, grey);
        }
      }
    for (const point3& q : m.positions) mark(p, b.at({q.x, q.y}), 4, red);
  }
  return p;
}

// The course's cube of twelve triangles: the normals of its vertices as averages over faces, and weighted by angle.
inline picture normals() {
  constexpr int panel = 340, height = 330;
  picture p(2 * panel, height, paper);
  const body cube = irg::shape_cube<double>();
  const vec3 to_viewer{0.55, 0.45, 1};
  for (int i = 0; i < 2; ++i) {
    const space s = seen_from(to_viewer, {panel * i + 118.0, 218}, 118);
    const auto at_vertices = irg::vertex_normals(cube, i ? irg::normal_weight::angle : irg::normal_weight::average);
    const auto arrows = [&](bool front) {
      for (std::size_t v = 0; v < cube.positions.size(); ++v) {
        const point3& q = cube.positions[v];
        const bool seen = q.x > 0.5 || q.y > 0.5 || q.z > 0.5;
        if (seen == front) arrow(p, s.at(q), s.at(q + at_vertices[v] * 0.5), 2.6, i ? blue : red);
      }
    };
    arrows(false);
    for (std::size_t f = 0; f < cube.face_count(); ++f) {
      const auto n = irg::face_normal(cube, f);
      if (!n || irg::dot(*n, to_viewer) <= 0) continue;
      area(p, s.at(face_of(cube, f)), {226, 224, 216, 255});
      outline(p, s.at(face_of(cube, f)), 1.4, ink);
    }
    for (std::size_t f = 0; f < cube.face_count(); ++f) {
      const auto n = irg::face_normal(cube, f);
      if (!n || irg::dot(*n, to_viewer) <= 0) continue;
      const shape t = face_of(cube, f);
      const point3 middle = t[0] + ((t[1] - t[0]) + (t[2] - t[0])) / 3.0;
      arrow(p, s.at(middle), s.at(middle + *n * 0.22), 1.8, green);
    }
    arrows(true);
  }
  return p;
}

// A body and the box around it, before and after fitting; the cube from -1 to 1 is dashed.
inline picture fitting() {
  constexpr int panel = 340, height = 300;
  picture p(2 * panel, height, paper);
  body shape_of_it = irg::shape_torus<double>({.minor_radius = 0.4, .major_segments = 20, .minor_segments = 8});
  for (point3& q : shape_of_it.positions) q = {1.0 + 0.42 * q.x, 0.95 + 0.6 * q.y, 0.4 + 0.25 * q.z};
  const auto box_edges = [&](const space& s, const point3& low, const point3& high, bool dashed, irg::rgba8 colour) {
    for (int axis = 0; axis < 3; ++axis)
      for (int k = 0; k < 4; ++k) {
        point3 a = low;
        if (k % 2) a[(axis + 1) % 3] = high[(axis + 1) % 3];
        if (k / 2) a[(axis + 2) % 3] = high[(axis + 2) % 3];
        point3 b = a;
        b[axis] = high[axis];
        if (dashed)
          dashes(p, s.at(a), s.at(b), 1.3, colour);
        else
          stroke(p, {s.at(a), s.at(b)}, 1.6, colour);
      }
  };
  for (int i = 0; i < 2; ++i) {
    const space s = seen_from({0.4, 0.35, 1}, {panel * i + 165.0, 158}, 84);
    if (i) static_cast<void>(irg::fit_mesh(shape_of_it));
    box_edges(s, {-1, -1, -1}, {1, 1, 1}, true, grey);
    for (std::size_t f = 0; f < shape_of_it.face_count(); ++f)
      outline(p, s.at(face_of(shape_of_it, f)), 0.9, with_opacity(blue, 150));
    const auto b = irg::bounding_box(shape_of_it);
    box_edges(s, b.low, b.high, false, red);
    axes(p, s, 0.55);
  }
  return p;
}

}  // namespace mesh_pictures
