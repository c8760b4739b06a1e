// SPDX-License-Identifier: MIT
// The steps of face_normal.hpp.
#pragma once

#include <cstddef>
#include <optional>

#include <irg/core/conversion.hpp>
#include <irg/core/ring.hpp>
#include <irg/math/length.hpp>
#include <irg/mesh/mesh.hpp>

namespace irg {
namespace detail {

template <class M>
concept mesh_in_space =
    Mesh<M> && size_of<typename mesh_traits<M>::point> == 3 && Floating<scalar_of<typename mesh_traits<M>::point>>;
template <mesh_in_space M>
using mesh_normal = vec<scalar_of<typename mesh_traits<M>::point>, 3>;

/// The differences between the vertices of a polygon, position(0) to position(count - 1), in double and times a power
/// of two that brings the largest near 1, so that products of them stay in range for any finite positions.
/// shape   after is 0 when all vertices coincide or one is not finite
template <class Position>
struct IRG_APART polygon_edges {
  std::size_t count;
  Position position;
  double before = 1, after = 0;  // the factors of a difference's terms and of the difference

  IRG_INLINE constexpr vec<double, 3> operator()(std::size_t from, std::size_t to) const noexcept {
    return generate_coordinates<vec<double, 3>>([&](int i) {
      const double a = widened(coordinate(position(from), i));
      const double b = widened(coordinate(position(to), i));
      return (product(b, before) - product(a, before)) * after;
    });
  }
};

inline namespace IRG_ABI {

template <class Position>
constexpr polygon_edges<Position> edges_of(std::size_t count, const Position& position) noexcept {
  polygon_edges<Position> edges{count, position, 1, 1};
  double reach = 0, largest = 0;
  for (std::size_t k = 0; k < count; ++k)
    for (int i = 0; i < 3; ++i) {
      const double size = magnitude(widened(coordinate(position(k), i)));
      if (!is_finite(size)) return {count, position, 1, 0};
      reach = greater(reach, size);
    }
  if (reach > 0x1p1022) edges.before = 0.25;  // else the difference of two finite numbers could be infinite
  for (std::size_t k = 1; k < count; ++k) {
    const vec<double, 3> v = edges(0, k);
    for (int i = 0; i < 3; ++i) largest = greater(largest, magnitude(v[i]));
  }
  edges.after = largest > 0 ? power_of_two_for(largest) : 0;
  return edges;
}

/// The sum of the triangles fanned from the first vertex, each as the cross product of its edges.
template <class Position>
constexpr vec<double, 3> newell_sum(const polygon_edges<Position>& edge) noexcept {
  vec<double, 3> sum{};
  if (edge.after == 0) return sum;
  for (std::size_t k = 2; k < edge.count; ++k) sum += cross(edge(0, k - 1), edge(0, k));
  return sum;
}

template <class M>
constexpr auto edges_of_face(const M& m, std::size_t f) noexcept {
  return edges_of(mesh_traits<M>::face_size(m, f),
                  [&m, f](std::size_t k) { return mesh_traits<M>::position(m, mesh_traits<M>::face_vertex(m, f, k)); });
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
