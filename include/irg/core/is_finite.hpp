// SPDX-License-Identifier: MIT
// is_finite: whether everything in numbers, points, vectors, planes and rings is a number one can compute with.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <irg/core/conversion.hpp>
#include <irg/core/coordinates.hpp>
#include <irg/core/instructions.hpp>
#include <irg/core/plane_concept.hpp>
#include <irg/core/ring.hpp>

namespace irg::detail::inline IRG_ABI {

// The highest bit is set when x is NaN or infinite: its exponent, all ones, carries into the sign.
template <Floating T>
IRG_INLINE constexpr std::uint64_t not_finite_bit(const T& x) noexcept {
  constexpr std::uint64_t exponent = std::uint64_t{0x7ff} << 52, one = std::uint64_t{1} << 52;
  return (std::bit_cast<std::uint64_t>(widened(x)) & exponent) + one;
}
template <Coordinates P>
IRG_INLINE constexpr std::uint64_t not_finite_bit(const P& p) noexcept {
  std::uint64_t bits = 0;
  for (int i = 0; i < size_of<P>; ++i) bits |= not_finite_bit(coordinate(p, i));
  return bits;
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

/// Whether x is neither NaN nor infinite; numbers without infinities always are finite.
template <Scalar T>
[[nodiscard]] IRG_INLINE constexpr bool is_finite(const T& x) noexcept {
  if constexpr (Floating<T>)
    return magnitude(x) <= (std::numeric_limits<T>::max)();
  else if constexpr (std::numeric_limits<T>::has_infinity)
    return x >= std::numeric_limits<T>::lowest() && x <= (std::numeric_limits<T>::max)();
  else
    return true;
}

/// Whether all coordinates are.
template <Coordinates P>
[[nodiscard]] IRG_INLINE constexpr bool is_finite(const P& p) noexcept {
  if constexpr (Floating<scalar_of<P>>) return detail::not_finite_bit(p) >> 63 == 0;
  for (int i = 0; i < size_of<P>; ++i)
    if (!is_finite(coordinate(p, i))) return false;
  return true;
}

/// Whether all coefficients are.
template <Plane P>
  requires(!Coordinates<P>)
[[nodiscard]] IRG_INLINE constexpr bool is_finite(const P& p) noexcept {
  for (int i = 0; i < 4; ++i)
    if (!is_finite(plane_coefficient(p, i))) return false;
  return true;
}

/// Whether all vertices are.
template <PolygonRing R>
  requires(!Coordinates<R>)
[[nodiscard]] constexpr bool is_finite(const R& ring) noexcept {
  const std::size_t n = ring_size(ring);
  if constexpr (Floating<scalar_of<ring_point<R>>>) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < n; ++i) bits |= detail::not_finite_bit(ring_traits<R>::vertex(ring, i));
    return bits >> 63 == 0;
  } else {
    for (std::size_t i = 0; i < n; ++i)
      if (!is_finite(ring_traits<R>::vertex(ring, i))) return false;
    return true;
  }
}

/// Whether all of them are.
template <class A, class B, class... More>
[[nodiscard]] IRG_INLINE constexpr bool is_finite(const A& a, const B& b, const More&... more) noexcept {
  return is_finite(a) && is_finite(b) && (is_finite(more) && ...);
}

}  // namespace irg::inline IRG_ABI
