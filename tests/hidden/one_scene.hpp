// SPDX-License-Identifier: MIT
// The scene of the page "one scene, every method", for its test, its picture and its benchmark: a ball through a ring, a
// cube with sheets in its sides, and three rods that lie over each other in turn.
#pragma once

#include <cstdint>
#include <vector>

#include <irg/core/vocabulary.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/mesh/triangulate.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/screen_pieces.hpp>
#include <irg/view/affine.hpp>
#include <irg/view/look_at.hpp>
#include <irg/view/projection.hpp>

namespace one_scene {

using point3 = irg::point<double, 3>;
using matrix = irg::mat<double, 4, 4>;

struct bodies {
  std::vector<point3> corners{};
  std::vector<irg::triangle_indices> triangles{};
  std::vector<int> body{};  // of each triangle: 0 ball, 1 ring, 2 cube, 3 sheets, 4 rods

  void add(const irg::mesh<double>& shape, const matrix& place, int number) {
    const auto first = static_cast<std::uint32_t>(corners.size());
    for (const point3& p : shape.positions) {
      const auto q = place * p;
      corners.push_back({q.x, q.y, q.z});
    }
    const irg::mesh<double> cut = irg::triangulated(shape);
    for (std::size_t f = 0; f < cut.face_count(); ++f) {
      triangles.push_back(
          {{first + cut.corner(f, 0).position, first + cut.corner(f, 1).position, first + cut.corner(f, 2).position}});
      body.push_back(number);
    }
  }
  void add_sheet(const point3 (&q)[4], int number) {
    const auto first = static_cast<std::uint32_t>(corners.size());
    corners.insert(corners.end(), q, q + 4);
    triangles.push_back({{first, first + 1, first + 2}});
    triangles.push_back({{first, first + 2, first + 3}});
    body.insert(body.end(), 2, number);
  }
};

inline bodies make() {
  bodies s;
  const auto at = [](double x, double y, double z) { return irg::translation(irg::vec<double, 3>{x, y, z}); };
  s.add(irg::shape_sphere<double>({.slices = 32, .stacks = 16}), at(-1.5, 0.2, 0), 0);
  s.add(irg::shape_torus<double>({.major_segments = 40, .minor_segments = 20}), at(-1.5, 0.2, 0) * irg::rotation_x(1.1),
        1);
  s.add(irg::shape_cube<double>(), at(1.5, 0, 0), 2);
  // In the planes of the cube's front and upper side, over their corners.
  s.add_sheet({{0.75, 0.5, 1}, {1.75, 0.5, 1}, {1.75, 1.5, 1}, {0.75, 1.5, 1}}, 3);
  s.add_sheet({{1, 1, 0.5}, {2, 1, 0.5}, {2, 1, -1.5}, {1, 1, -1.5}}, 3);
  for (int i = 0; i < 3; ++i) {
    const double x[] = {0, 2, -2}, y[] = {2.6, -1.6, -1.6};
    const int k = (i + 1) % 3;
    const double dx = (x[k] - x[i]) / 5, dy = (y[k] - y[i]) / 5, nx = -dy / 4, ny = dx / 4;
    s.add_sheet({{x[i] - dx - nx, y[i] - dy - ny, 1.6},
                 {x[k] + dx - nx, y[k] + dy - ny, 2.4},
                 {x[k] + dx + nx, y[k] + dy + ny, 2.4},
                 {x[i] - dx + nx, y[i] - dy + ny, 1.6}},
                4);
  }
  return s;
}

inline constexpr int width = 640, height = 480;
inline constexpr point3 eye{1.5, 2.5, 9};

inline matrix to_clip() {
  return irg::perspective(0.62, double{width} / height, 0.1, 100.0) *
         irg::look_at(eye, point3{0, 0.2, 0}, irg::vec<double, 3>{0, 1, 0});
}
inline irg::screen_mapping<double> mapping() { return irg::map_to_screen<double>({width, height}); }

/// Its faces on the screen, both sides of them.
inline std::vector<irg::screen_face> faces_of(const bodies& s) {
  std::vector<irg::screen_face> faces;
  const matrix m = to_clip();
  for (std::uint32_t i = 0; i < s.triangles.size(); ++i) {
    const auto& [v] = s.triangles[i];
    const irg::hpoint<double, 3> c[3] = {m * s.corners[v[0]], m * s.corners[v[1]], m * s.corners[v[2]]};
    for (const irg::screen_piece& p : clip_to_screen(c, mapping(), i)) faces.push_back(p.face);
  }
  return faces;
}

}  // namespace one_scene
