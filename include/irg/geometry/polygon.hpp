// SPDX-License-Identifier: MIT
// What a polygon of the plane is: a ring of points, or any number of rings. y points up; where it points down,
// clockwise and counter-clockwise change places.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <irg/core/conversion.hpp>
#include <irg/core/is_finite.hpp>
#include <irg/core/ring.hpp>

namespace irg {

/// Any number of rings of the plane.
template <class R>
concept PlaneRings = RingSequence<R> && PlaneRing<ring_in<R>>;

/// One ring, or any number of them.
template <class P>
concept PlanePolygon = PlaneRing<P> || PlaneRings<P>;

/// The coordinates of which polygons' intersections, unions and differences keep every bit: doubles hold them all.
template <class T>
concept OverlayScalar = Floating<T> || (std::integral<T> && sizeof(T) <= 4);

namespace detail {
template <class P>
struct polygon_point_of;
template <PlaneRing R>
struct polygon_point_of<R> {
  using type = ring_point<R>;
};
template <PlaneRings R>
  requires(!PlaneRing<R>)
struct polygon_point_of<R> {
  using type = ring_point<ring_in<R>>;
};
}  // namespace detail

/// The type of a polygon's vertices.
template <PlanePolygon P>
using polygon_point = typename detail::polygon_point_of<P>::type;

namespace detail::inline IRG_ABI {

// Whether p, which is on the line through a and b, is between them or on one of them.
template <Point P>
constexpr bool is_between(const P& a, const P& b, const P& p) noexcept {
  const auto within = [](const auto& from, const auto& to, const auto& v) {
    return from < to ? !(v < from) && !(to < v) : !(v < to) && !(from < v);
  };
  return within(coordinate(a, 0), coordinate(b, 0), coordinate(p, 0)) &&
         within(coordinate(a, 1), coordinate(b, 1), coordinate(p, 1));
}

template <PlanePolygon P>
constexpr std::size_t ring_count(const P& polygon) noexcept {
  if constexpr (PlaneRing<P>)
    return 1;
  else if constexpr (std::is_array_v<P>)
    return std::extent_v<P>;
  else
    return static_cast<std::size_t>(polygon.size());
}

template <PlanePolygon P>
constexpr decltype(auto) ring_of(const P& polygon, [[maybe_unused]] std::size_t i) noexcept {
  if constexpr (PlaneRing<P>)
    return (polygon);
  else
    return polygon[i];
}

// Calls f(ring) for each ring, until it returns false; whether it never did.
template <PlanePolygon P, class F>
constexpr bool each_ring(const P& polygon, F&& f) noexcept {
  for (std::size_t i = 0; i < ring_count(polygon); ++i)
    if (!f(ring_of(polygon, i))) return false;
  return true;
}

// Calls f(from, to) for each edge of each ring.
template <PlanePolygon P, class F>
constexpr void each_edge(const P& polygon, F&& f) noexcept {
  each_ring(polygon, [&](const auto& ring) {
    for (std::size_t i = 0; i < ring_size(ring); ++i) f(ring_vertex(ring, i), ring_vertex(ring, i + 1));
    return true;
  });
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// Whether no coordinate of any ring is NaN or infinite.
template <PlanePolygon P>
  requires(!PlaneRing<P>)
[[nodiscard]] constexpr bool is_finite(const P& polygon) noexcept {
  return detail::each_ring(polygon, [](const auto& ring) { return is_finite(ring); });
}

}  // namespace IRG_ABI
}  // namespace irg
