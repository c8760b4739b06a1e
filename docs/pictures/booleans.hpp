// SPDX-License-Identifier: MIT
// What two bodies have in common, and the first without the second, coloured by the body that a face comes from; a tree
// seen without a mesh; half-edges round a vertex and in a face. Included by pictures.cpp.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <irg/mesh/shapes.hpp>
#include <irg/mesh/to_half_edges.hpp>
#include <irg/solid/boolean.hpp>
#include <irg/solid/csg_spans.hpp>

#include "meshes.hpp"

namespace boolean_pictures {

using namespace mesh_pictures;

// Faces from the farthest to the nearest, which is right for bodies like these.
template <class Colour>
void draw_body(picture& p, const body& m, const space& s, const vec3& to_viewer, const Colour& colour) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    const auto n = irg::face_normal(m, f);
    if (!n || irg::dot(*n, to_viewer) <= 0) continue;
    double depth = 0;
    for (const point3& q : face_of(m, f)) depth += irg::dot(irg::to_vec(q), to_viewer);
    order.push_back({depth, f});
  }
  std::sort(order.begin(), order.end());
  for (const auto& [depth, f] : order) {
    const double light = irg::dot(*irg::face_normal(m, f), irg::normalized(vec3{-0.3, 0.8, 0.6}));
    area(p, s.at(face_of(m, f)), colour(f, 0.62 + 0.38 * (light > 0 ? light : 0)));
    outline(p, s.at(face_of(m, f)), 0.7, grey);
  }
}

inline irg::rgba8 shaded(double red, double green, double blue, double light) {
  const auto byte = [light](double v) { return static_cast<std::uint8_t>(v * light); };
  return {byte(red), byte(green), byte(blue), 255};
}

inline picture operations() {
  constexpr int panel = 190, height = 180;
  picture p(3 * panel, height, paper);
  const vec3 to_viewer{0.55, 0.5, 1};
  body cube = irg::shape_cube<double>();
  for (point3& q : cube.positions) q = {q.x * 1.5 - 0.75, q.y * 1.5 - 0.75, q.z * 1.5 - 0.75};
  const body ball = irg::shape_sphere<double>({.slices = 20, .stacks = 11});
  const irg::boolean_operation each[] = {irg::boolean_operation::union_, irg::boolean_operation::intersection,
                                         irg::boolean_operation::difference};
  for (int i = 0; i < 3; ++i) {
    const auto r = irg::solid_boolean(cube, ball, each[i]);
    draw_body(p, r.value, seen_from(to_viewer, {panel * (i + 0.5), height * 0.5}, 66), to_viewer,
              [&](std::size_t f, double light) {
                return r.faces[f].body == 0 ? shaded(150, 185, 235, light) : shaded(240, 178, 120, light);
              });
  }
  return p;
}

// A cube in common with a ball, less three rods: by the face at which a ray comes in, and by how far it runs inside.
inline picture spans() {
  constexpr int panel = 200, height = 200;
  picture p(2 * panel, height, paper);
  using tree = irg::csg_tree<double>;
  body cube = irg::shape_cube<double>();
  for (point3& q : cube.positions) q = {q.x * 1.5 - 0.75, q.y * 1.5 - 0.75, q.z * 1.5 - 0.75};
  tree all = irg::csg_boolean(tree(cube), tree(irg::shape_sphere<double>({.slices = 24, .stacks = 13})),
                              irg::boolean_operation::intersection);
  for (int axis = 0; axis < 3; ++axis) {
    body rod = irg::shape_cylinder<double>(16);
    for (point3& q : rod.positions) {
      const point3 thin{q.x * 0.42, q.y * 1.5, q.z * 0.42};
      for (int i = 0; i < 3; ++i) q[(i + axis) % 3] = thin[i];
    }
    all = irg::csg_boolean(std::move(all), tree(rod), irg::boolean_operation::difference);
  }
  const irg::csg_spans<double> through(all);
  const vec3 back = irg::normalized(vec3{0.55, 0.5, 1}), right = irg::normalized(irg::cross(vec3{0, 1, 0}, back)),
             up = irg::cross(back, right);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < panel; ++x) {
      const double u = (x + 0.5 - panel * 0.5) / 95, v = (height * 0.5 - y - 0.5) / 95;
      const auto met = through.along({point3{} + right * u + up * v + back * 4.0, -back});
      if (met.empty()) continue;
      const auto& face = met[0].entered;
      vec3 n = *irg::face_normal(all.bodies[face.body], face.face);
      if (face.turned) n = -n;
      const double light = irg::dot(n, irg::normalized(vec3{-0.3, 0.8, 0.6}));
      p(x, y) = (face.body == 0   ? shaded(150, 185, 235, 0.5 + 0.5 * (light > 0 ? light : 0))
                 : face.body == 1 ? shaded(240, 178, 120, 0.5 + 0.5 * (light > 0 ? light : 0))
                                  : shaded(150, 205, 150, 0.5 + 0.5 * (light > 0 ? light : 0)));
      double length = 0;
      for (const auto& span : met) length += span.to - span.from;
      p(panel + x, y) = shaded(235, 235, 230, 1 - 0.4 * length);
    }
  return p;
}

// The half-edges of an octahedron's edges: those that leave one vertex blue, those of one face red.
inline picture half_edges() {
  constexpr int width = 420, height = 330;
  picture p(width, height, paper);
  const vec3 to_viewer{0.45, 0.5, 1};
  const body m = irg::shape_octahedron<double>();
  const auto b = irg::to_half_edges(m).value;
  const space s = seen_from(to_viewer, {width * 0.5, height * 0.5}, 140);
  draw_body(p, m, s, to_viewer, [](std::size_t, double light) { return shaded(225, 232, 240, light); });
  std::uint32_t top = 0, front = 0;
  double most = -9;
  for (std::uint32_t v = 0; v < b.positions.size(); ++v)
    if (b.positions[v].y > b.positions[top].y) top = v;
  for (std::uint32_t f = 0; f < b.faces.size(); ++f)
    if (const double facing = irg::dot(*irg::face_normal(m, f), to_viewer); facing > most) most = facing, front = f;
  const auto half_edge_arrow = [&](std::uint32_t h, const irg::rgba8& colour) {
    const point3 from = b.positions[b.origin(h)], to = b.positions[b.target(h)];
    const point3 beside = b.positions[b.target(b.next(h))];
    const vec3 inward = (beside - from) * 0.08;
    arrow(p, s.at(from + (to - from) * 0.12 + inward), s.at(from + (to - from) * 0.82 + inward), 2.6, colour);
  };
  irg::each_half_edge_of(b, b.faces[front], [&](std::uint32_t h) { half_edge_arrow(h, red); });
  irg::each_half_edge_at(b, top, [&](std::uint32_t h) {
    const auto n = irg::face_normal(m, b.face(h));
    if (irg::dot(*n, to_viewer) > 0 && b.face(h) != front) half_edge_arrow(h, blue);
  });
  for (std::uint32_t v = 0; v < b.positions.size(); ++v) {
    bool is_seen = false;
    irg::each_half_edge_at(
        b, v, [&](std::uint32_t h) { is_seen = is_seen || irg::dot(*irg::face_normal(m, b.face(h)), to_viewer) > 0; });
    if (is_seen) mark(p, s.at(b.positions[v]), 4, ink);
  }
  return p;
}

}  // namespace boolean_pictures
