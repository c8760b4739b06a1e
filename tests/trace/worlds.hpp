// SPDX-License-Identifier: MIT
// Bodies for rays, kept with their world.
#pragma once

#include <array>
#include <vector>

#include <irg/mesh/mesh.hpp>
#include <irg/mesh/triangulate.hpp>
#include <irg/trace/ray_world.hpp>

namespace test {

/// A body made of a mesh's triangles, moved.
struct kept_body {
  std::vector<irg::point<double, 3>> positions{};
  std::vector<irg::vec<double, 3>> normals{};
  std::vector<irg::triangle_indices> triangles{};

  constexpr kept_body(const irg::mesh<double>& m, const irg::vec<double, 3>& move, double size = 1) {
    const irg::mesh<double> t = irg::triangulated(m);
    for (const auto& p : t.positions)
      positions.push_back(irg::point<double, 3>{p.x * size, p.y * size, p.z * size} + move);
    for (std::size_t f = 0; f < t.face_count(); ++f)
      triangles.push_back({{t.corner(f, 0).position, t.corner(f, 1).position, t.corner(f, 2).position}});
  }
  constexpr irg::traced_body<double> body(const irg::material<double>& surface,
                                          const irg::optics<double>& optic = {}) const {
    return {positions, normals, triangles, surface, optic};
  }
};

/// A rectangle with two sides from a corner; its front is where their cross product points to.
inline constexpr irg::mesh<double> rectangle(const irg::point<double, 3>& corner, const irg::vec<double, 3>& u,
                                             const irg::vec<double, 3>& v) {
  irg::mesh<double> m;
  m.positions = {corner, corner + u, corner + u + v, corner + v};
  irg::add_face(m, std::array{0, 1, 2, 3});
  return m;
}

}  // namespace test
