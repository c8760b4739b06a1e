// SPDX-License-Identifier: MIT
// validate: whether a mesh keeps the promises that every algorithm on meshes relies on.
#pragma once

#include <cstddef>
#include <limits>

#include <irg/core/is_finite.hpp>
#include <irg/mesh/mesh.hpp>

namespace irg {

/// What is wrong with a mesh.
enum class mesh_defect {
  none,
  bad_face_start,  ///< face_starts is empty, does not begin with 0, falls, or does not end at corners.size()
  short_face,  ///< a face has fewer than three corners
  position_out_of_range,  ///< a corner names a position that the mesh does not have
  normal_out_of_range,  ///< likewise; no_index is no defect
  texcoord_out_of_range,  ///< likewise
  position_not_finite,  ///< a coordinate of a position is infinite or NaN
  normal_not_finite,  ///< likewise
  texcoord_not_finite,  ///< likewise
  parts_do_not_cover_faces,  ///< there are parts, but they are no partition of the faces into runs in order
};

/// The first defect of a mesh and its place.
/// shape   index counts entries of what the defect names: faces (bad_face_start, short_face, ..._out_of_range),
///         positions, normals, texcoords (..._not_finite) or parts; corner counts the corners of that face
struct mesh_finding {
  mesh_defect defect = mesh_defect::none;
  std::size_t index = 0;
  std::size_t corner = 0;
  bool operator==(const mesh_finding&) const = default;
};

namespace detail::inline IRG_ABI {

/// The first element with a coordinate that is not finite; size() when there is none.
template <int N, class Elements>
constexpr std::size_t first_not_finite(const Elements& elements) noexcept {
  for (std::size_t i = 0; i < elements.size(); ++i)
    for (int k = 0; k < N; ++k)
      if (!is_finite(elements[i][k])) return i;
  return elements.size();
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The first defect of the mesh's faces, or none: what validate asks first, and enough to walk over them.
/// exact   always
/// cost    linear in the corners
template <Scalar T>
[[nodiscard]] constexpr mesh_finding validate_faces(const mesh<T>& m) noexcept {
  if (m.face_starts.empty() || m.face_starts.front() != 0) return {mesh_defect::bad_face_start};
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    const std::size_t start = m.face_starts[f], end = m.face_starts[f + 1];
    if (end < start || end > m.corners.size()) return {mesh_defect::bad_face_start, f};
    if (end - start < 3) return {mesh_defect::short_face, f};
    for (std::size_t k = 0; k < end - start; ++k) {
      const mesh_corner& c = m.corners[start + k];
      if (c.position >= m.positions.size()) return {mesh_defect::position_out_of_range, f, k};
      if (c.normal != no_index && c.normal >= m.normals.size()) return {mesh_defect::normal_out_of_range, f, k};
      if (c.texcoord != no_index && c.texcoord >= m.texcoords.size()) return {mesh_defect::texcoord_out_of_range, f, k};
    }
  }
  if (m.face_starts.back() != m.corners.size()) return {mesh_defect::bad_face_start, m.face_count()};
  return {};
}

/// The first defect of the mesh, or none.
/// gives   in this order: faces, positions, normals, texcoords, parts. Geometry is not judged: a face without area, a
///         corner that is named twice or an edge of three faces is no defect here
/// exact   always
/// cost    linear
template <Scalar T>
[[nodiscard]] constexpr mesh_finding validate(const mesh<T>& m) noexcept {
  if (const mesh_finding found = validate_faces(m); found.defect != mesh_defect::none) return found;
  if (const std::size_t i = detail::first_not_finite<3>(m.positions); i < m.positions.size())
    return {mesh_defect::position_not_finite, i};
  if (const std::size_t i = detail::first_not_finite<3>(m.normals); i < m.normals.size())
    return {mesh_defect::normal_not_finite, i};
  if (const std::size_t i = detail::first_not_finite<2>(m.texcoords); i < m.texcoords.size())
    return {mesh_defect::texcoord_not_finite, i};
  std::size_t covered = 0;
  for (std::size_t i = 0; i < m.parts.size(); ++i) {
    const mesh_part& part = m.parts[i];
    if (part.first_face != covered || part.face_count > m.face_count() - covered)
      return {mesh_defect::parts_do_not_cover_faces, i};
    covered += part.face_count;
  }
  if (!m.parts.empty() && covered != m.face_count()) return {mesh_defect::parts_do_not_cover_faces, m.parts.size()};
  return {};
}

}  // namespace IRG_ABI
}  // namespace irg
