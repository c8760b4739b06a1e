// SPDX-License-Identifier: MIT
// Shells that look the wrong way are turned: outer ones come to look outward, cavities into themselves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <irg/mesh/convex_body.hpp>
#include <irg/mesh/from_half_edges.hpp>
#include <irg/mesh/orient_faces.hpp>
#include <irg/mesh/to_half_edges.hpp>
#include <irg/solid/detail/orient_outward_steps.hpp>

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
/// needs   a mesh in which validate() finds no defect, with finite positions; shells that do not cut each other, but
///         may touch
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
  const std::vector<mesh<T>> each = detail::meshes_of_shells(turned, shells);
  std::vector<detail::space_box> boxes;
  boxes.reserve(each.size());
  for (const mesh<T>& shell : each) boxes.push_back(detail::box_round(shell));
  std::vector<unsigned char> turn(shells.count, 0);
  for (std::uint32_t s = 0; s < shells.count; ++s) {
    bool is_cavity = false;
    for (std::uint32_t t = 0; t < shells.count; ++t)
      if (t != s && detail::is_within(boxes[s], boxes[t]) && detail::lies_within(each[s], each[t]))
        is_cavity = !is_cavity;
    turn[s] = (detail::sign_of_volume(each[s]) < 0) != is_cavity ? 1 : 0;
  }
  for (std::size_t f = 0; f < turned.face_count(); ++f)
    if (turn[shells.of_face[f]] != 0) turn_face(turned, f);
  m = std::move(turned);
  return outward_status::done;
}

}  // namespace IRG_ABI
}  // namespace irg
