// SPDX-License-Identifier: MIT
// What polygon clippers work on: points, or vertices that carry numbers along, and how a vertex between two is made.
#pragma once

#include <concepts>

#include <irg/core/coordinates.hpp>
#include <irg/math/vec.hpp>

namespace irg {

/// A point with K numbers to be interpolated.
template <Scalar T, int N, int K>
struct attributed_point {
  point<T, N> position;
  T attributes[static_cast<std::size_t>(K)]{};
  bool operator==(const attributed_point&) const = default;
};

namespace detail {

template <class V>
concept has_point_position =
    std::default_initializable<V> && requires(const V v) { requires Point<std::remove_cvref_t<decltype(v.position)>>; };

template <class V>
struct position_type {
  using type = V;
};
template <has_point_position V>
struct position_type<V> {
  using type = std::remove_cvref_t<decltype(std::declval<const V&>().position)>;
};

}  // namespace detail

/// A corner of a polygon that is cut: a point, or a type with a member `position` that is one. Cutting keeps rows of
/// corners and moves them, so that they are made without a value and assigned.
template <class V>
concept PolygonVertex = std::semiregular<V> && (Point<V> || detail::has_point_position<V>);

/// The type of a polygon vertex's position, and of its coordinates.
template <PolygonVertex V>
using vertex_position = typename detail::position_type<V>::type;
template <PolygonVertex V>
using vertex_scalar = scalar_of<vertex_position<V>>;

/// Interpolates polygon vertices: everything at `t` of the way from a to b. Vertex types of your own bring a callable
/// of this shape along; a clipper then sets the position itself.
struct lerp_vertex {
  template <Point P>
  IRG_INLINE constexpr P operator()(const P& a, const P&, const scalar_of<P>&) const noexcept {
    return a;
  }
  template <class T, int N, int K>
  IRG_INLINE constexpr attributed_point<T, N, K> operator()(const attributed_point<T, N, K>& a,
                                                            const attributed_point<T, N, K>& b,
                                                            const T& t) const noexcept {
    attributed_point<T, N, K> between = a;
    for (int i = 0; i < K; ++i) between.attributes[i] = a.attributes[i] + product(t, b.attributes[i] - a.attributes[i]);
    return between;
  }
};

namespace detail::inline IRG_ABI {

template <PolygonVertex V>
IRG_INLINE constexpr const vertex_position<V>& position_of(const V& v) noexcept {
  if constexpr (has_point_position<V>)
    return v.position;
  else
    return v;  // NOLINT(bugprone-return-const-ref-from-parameter)
}

// The vertex with another position.
template <PolygonVertex V>
IRG_INLINE constexpr V placed_at(V v, const vertex_position<V>& p) {
  if constexpr (has_point_position<V>)
    v.position = p;
  else
    v = p;
  return v;
}

}  // namespace detail::inline IRG_ABI
}  // namespace irg
