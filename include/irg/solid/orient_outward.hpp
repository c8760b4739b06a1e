// SPDX-License-Identifier: MIT
// Shells that look the wrong way are turned: outer ones come to look outward, cavities into themselves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <irg/mesh/convex_body.hpp>
#include <irg/mesh/from_half_edges.hpp>
#include <irg/mesh/orient_faces.hpp>
#include <irg/mesh/to_half_edges.hpp>
#include <irg/solid/measures.hpp>
#include <irg/solid/point_in_solid.hpp>

namespace irg {

/// What orient_outward made of a mesh.
enum class [[nodiscard]] outward_status {
  done,
  no_surface,  ///< faces cannot be made to run alike, or do not make a surface: to_half_edges() tells why
  open,  ///< an edge has one face: there is no inside. Faces run alike
};

inline namespace IRG_ABI {

/// Turns the faces of a closed surface so that they are counter-clockwise seen from outside, whichever way each of them
/// ran before: those of shells within others so that what lies between is inside.
/// shape   faces keep their numbers; normals of corners stay
/// needs   a mesh in which validate() finds no defect, with finite positions; shells that do not cut each other
/// gives   for `no_surface` the mesh as it was
/// exact   always, for the triangles that triangulate() makes of the faces
/// cost    O(n log n), and for each shell a pass over the others: exact volumes and one ray
template <Floating T>
constexpr outward_status orient_outward(mesh<T>& m) {
  mesh<T> turned = m;
  if (orient_faces(turned) != orient_status::done) return outward_status::no_surface;
  const auto half_edges = to_half_edges(turned);
  if (half_edges.status != half_edge_status::done) return outward_status::no_surface;
  if (counts_of(half_edges.value).borders > 0) {
    m = std::move(turned);
    return outward_status::open;
  }
  const half_edge_shells shells = shells_of(half_edges.value);
  std::vector<mesh<T>> each(shells.count, mesh<T>{});
  for (mesh<T>& shell : each) shell.positions = turned.positions;
  std::vector<std::uint32_t> corners;
  for (std::size_t f = 0; f < turned.face_count(); ++f) {
    corners.clear();
    for (std::size_t k = 0; k < turned.face_size(f); ++k) corners.push_back(turned.corner(f, k).position);
    add_face(each[shells.of_face[f]], corners);
  }
  std::vector<unsigned char> turn(shells.count, 0);
  for (std::uint32_t s = 0; s < shells.count; ++s) {
    bool is_cavity = false;
    const point<T, 3> p = turned.positions[each[s].corners[0].position];
    for (std::uint32_t t = 0; t < shells.count; ++t)
      if (t != s && point_in_solid(each[t], p) == location::inside) is_cavity = !is_cavity;
    turn[s] = (solid_volume(each[s]) < 0) != is_cavity ? 1 : 0;
  }
  for (std::size_t f = 0; f < turned.face_count(); ++f)
    if (turn[shells.of_face[f]] != 0) turn_face(turned, f);
  m = std::move(turned);
  return outward_status::done;
}

}  // namespace IRG_ABI
}  // namespace irg
