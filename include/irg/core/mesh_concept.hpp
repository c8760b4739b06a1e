// SPDX-License-Identifier: MIT
// Indexed meshes of any type. The one customisation point is mesh_traits<T>; specialise it to hand your own mesh to
// irg's algorithms. irg's model is mesh<T> (mesh/mesh.hpp).
#pragma once

#include <cstddef>
#include <cstdint>

#include <irg/core/coordinates.hpp>

namespace irg {

/// How irg reads a mesh. Members: point, vertex_count(m), position(m, v), face_count(m), face_size(m, f),
/// face_vertex(m, f, k) with k counter-clockwise as seen from outside.
template <class T>
struct mesh_traits {};

/// Faces of three or more vertices that share their positions through indices.
template <class T>
concept Mesh = requires(const T m, std::size_t i) {
  requires Point<typename mesh_traits<T>::point>;
  { mesh_traits<T>::vertex_count(m) } -> std::convertible_to<std::size_t>;
  { mesh_traits<T>::position(m, i) } -> std::convertible_to<typename mesh_traits<T>::point>;
  { mesh_traits<T>::face_count(m) } -> std::convertible_to<std::size_t>;
  { mesh_traits<T>::face_size(m, i) } -> std::convertible_to<std::size_t>;
  { mesh_traits<T>::face_vertex(m, i, i) } -> std::convertible_to<std::size_t>;
};

}  // namespace irg
