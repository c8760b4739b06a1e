// SPDX-License-Identifier: MIT
// is_finite: whether everything in numbers, points, vectors, planes and rings is a number one can compute with.
#pragma once

#include <cstddef>
#include <limits>

#include <irg/core/coordinates.hpp>
#include <irg/core/instructions.hpp>
#include <irg/core/plane_concept.hpp>
#include <irg/core/ring.hpp>

namespace irg {
inline namespace IRG_ABI {

/// Whether x is neither NaN nor infinite; numbers that are no floats always are finite.
template <Scalar T>
IRG_INLINE constexpr bool is_finite(const T& x) noexcept {
  if constexpr (Floating<T>)
    return magnitude(x) <= (std::numeric_limits<T>::max)();
  else
    return true;
}

/// Whether all coordinates are.
template <Coordinates P>
IRG_INLINE constexpr bool is_finite(const P& p) noexcept {
  for (int i = 0; i < size_of<P>; ++i)
    if (!is_finite(coordinate(p, i))) return false;
  return true;
}

/// Whether all coefficients are.
template <Plane P>
  requires(!Coordinates<P>)
IRG_INLINE constexpr bool is_finite(const P& p) noexcept {
  for (int i = 0; i < 4; ++i)
    if (!is_finite(plane_coefficient(p, i))) return false;
  return true;
}

/// Whether all vertices are.
template <PolygonRing R>
  requires(!Coordinates<R>)
constexpr bool is_finite(const R& ring) noexcept {
  for (std::size_t i = 0; i < ring_size(ring); ++i)
    if (!is_finite(ring_vertex(ring, i))) return false;
  return true;
}

/// Whether all of them are.
template <class A, class B, class... More>
IRG_INLINE constexpr bool is_finite(const A& a, const B& b, const More&... more) noexcept {
  return is_finite(a) && is_finite(b) && (is_finite(more) && ...);
}

}  // namespace IRG_ABI
}  // namespace irg
