// SPDX-License-Identifier: MIT
// Indexed meshes of any type. The one customisation point is mesh_traits<T>; specialise it to hand your own mesh to
// irg's algorithms. irg's model is mesh<T> (mesh/mesh.hpp).
#pragma once

#include <cstddef>

#include <irg/core/coordinates.hpp>

namespace irg {

/// How irg reads a mesh. Members: point, vertex_count(m), position(m, v), face_count(m), face_size(m, f),
/// face_vertex(m, f, k) with k counter-clockwise as seen from outside.
template <class T>
struct mesh_traits {};

/// Faces of three or more vertices that share their positions through indices.
template <class T>
concept Mesh = requires(const T& m, std::size_t i) {
  requires Point<typename mesh_traits<T>::point>;
  { mesh_traits<T>::vertex_count(m) } -> std::convertible_to<std::size_t>;
  { mesh_traits<T>::position(m, i) } -> std::convertible_to<typename mesh_traits<T>::point>;
  { mesh_traits<T>::face_count(m) } -> std::convertible_to<std::size_t>;
  { mesh_traits<T>::face_size(m, i) } -> std::convertible_to<std::size_t>;
  { mesh_traits<T>::face_vertex(m, i, i) } -> std::convertible_to<std::size_t>;
};

/// The type of a mesh's positions.
template <Mesh T>
using mesh_point = typename mesh_traits<T>::point;

/// A mesh whose positions are points of space, of floats or doubles.
template <class T>
concept SpaceMesh =
    Mesh<T> && size_of<typename mesh_traits<T>::point> == 3 && Floating<scalar_of<typename mesh_traits<T>::point>>;

inline namespace IRG_ABI {

/// The number of positions of a mesh.
template <Mesh M>
[[nodiscard]] IRG_INLINE constexpr std::size_t mesh_vertex_count(const M& m) {
  return static_cast<std::size_t>(mesh_traits<M>::vertex_count(m));
}

/// Position v of a mesh.
/// needs   v < mesh_vertex_count(m)
template <Mesh M>
[[nodiscard]] IRG_INLINE constexpr mesh_point<M> mesh_position(const M& m, std::size_t v) {
  return mesh_traits<M>::position(m, v);
}

/// The number of faces of a mesh.
template <Mesh M>
[[nodiscard]] IRG_INLINE constexpr std::size_t mesh_face_count(const M& m) {
  return static_cast<std::size_t>(mesh_traits<M>::face_count(m));
}

/// The number of corners of face f.
/// needs   f < mesh_face_count(m)
template <Mesh M>
[[nodiscard]] IRG_INLINE constexpr std::size_t mesh_face_size(const M& m, std::size_t f) {
  return static_cast<std::size_t>(mesh_traits<M>::face_size(m, f));
}

/// The position that corner k of face f names.
/// needs   f < mesh_face_count(m), k < mesh_face_size(m, f)
template <Mesh M>
[[nodiscard]] IRG_INLINE constexpr std::size_t mesh_face_vertex(const M& m, std::size_t f, std::size_t k) {
  return static_cast<std::size_t>(mesh_traits<M>::face_vertex(m, f, k));
}

}  // namespace IRG_ABI
}  // namespace irg
