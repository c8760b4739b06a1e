// SPDX-License-Identifier: MIT
// Length and direction of vectors, right over the whole range of float and double: nothing overflows or underflows on
// the way, because coordinates that are not of moderate size are first brought near 1 by a power of two, and what the
// root lacks is taken from the squares once more.
#pragma once

#include <limits>
#include <optional>
#include <utility>

#include <irg/core/conversion.hpp>
#include <irg/core/scalar.hpp>
#include <irg/math/detail/float_bits.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/hypot.hpp>
#include <irg/math/sqrt.hpp>
#include <irg/math/vec.hpp>
#include <irg/math/detail/length_steps.hpp>

namespace irg {
inline namespace IRG_ABI {

/// The square of the length: the sum of the squares of the coordinates.
/// exact   each product and each sum rounded once, never fused; overflows and underflows as the squares do
template <Vector V>
[[nodiscard]] IRG_INLINE constexpr scalar_of<V> length_squared(const V& v) noexcept {
  return dot(v, v);
}

/// The length of v over the whole range of its numbers, subnormal to largest.
/// gives   infinity when a coordinate is infinite or the length is beyond the range, else NaN when one is NaN
/// exact   within 0.50001 ulp (more than 16 coordinates: 0.501), subnormal results too; a vector along an axis has its
///         exact length
/// cost    that of hypot
template <Vector V>
  requires Floating<scalar_of<V>>
[[nodiscard]] IRG_INLINE constexpr scalar_of<V> length(const V& v) noexcept {
  return detail::length_of<scalar_of<V>, size_of<V>>([&](int i) { return coordinate(v, i); });
}

/// The vector of length 1 in the direction of v.
/// gives   nothing when v is zero or has a coordinate that is NaN or infinite
/// exact   each coordinate within 1.51 ulp (float 0.51): the length is rounded, then the quotient; float: 1 over the
///         length in double, then the product. The result's length is 1 within 2u (u = 2^-53, float 2^-24), over the
///         whole range
template <Vector V>
  requires Floating<scalar_of<V>>
[[nodiscard]] constexpr std::optional<V> try_normalize(const V& v) noexcept {
  if constexpr (std::semiregular<V>) {
    V unit = v;
    if (!detail::put_direction(v, unit)) return std::nullopt;
    return unit;
  } else {
    const auto unit = try_normalize(as_assignable(v));
    return unit ? std::optional<V>(from_assignable<V>(*unit)) : std::nullopt;
  }
}

/// The vector of length 1 in the direction of v; the zero vector where there is none.
/// gives   the zero vector when v is zero or has a coordinate that is NaN or infinite; never NaN
/// exact   as try_normalize
template <Vector V>
  requires Floating<scalar_of<V>>
[[nodiscard]] IRG_INLINE constexpr V normalized(const V& v) noexcept {
  if constexpr (std::semiregular<V>) {
    V unit = v;
    const bool has_direction = detail::put_direction(v, unit);
    if constexpr (std::same_as<scalar_of<V>, float>) return unit;
    return has_direction ? unit : zero_coordinates<V>();
  } else {
    return from_assignable<V>(normalized(as_assignable(v)));
  }
}

/// The length of v without care for the ends of the exponents, for inner loops.
/// needs   coordinates whose squares neither overflow nor vanish: the largest between 2^-500 and 2^500 (float: 2^-60
///         and 2^60)
/// exact   error below 1.26 ulp: the squares are rounded, the sum of them is rounded once
template <Vector V>
  requires Floating<scalar_of<V>>
[[nodiscard]] IRG_INLINE constexpr scalar_of<V> length_fast(const V& v) noexcept {
  using T = scalar_of<V>;
  T sum = product(coordinate(v, 0), coordinate(v, 0)), error = 0;
  for (int i = 1; i < size_of<V>; ++i) {
    const auto next = two_sum(sum, product(coordinate(v, i), coordinate(v, i)));
    sum = next.value, error = error + next.error;
  }
  return sqrt(sum + error);
}

/// The vector of length 1 in the direction of v by the plain formula, for inner loops: v times 1 over its length.
/// needs   as length_fast
/// gives   the zero vector when the sum of the squares is zero
/// exact   each coordinate below 5 ulp for up to three of them; never fused
template <Vector V>
  requires Floating<scalar_of<V>>
[[nodiscard]] IRG_INLINE constexpr V normalized_fast(const V& v) noexcept {
  using T = scalar_of<V>;
  const T square = dot(v, v);
  const T factor = T(1) / sqrt(square > 0 ? square : T(1));
  return generate_coordinates<V>([&](int i) { return product(coordinate(v, i), factor); });
}

IRG_REFUSES_POINTS(length);
IRG_REFUSES_POINTS(length_fast);
IRG_REFUSES_POINTS(length_squared);
IRG_REFUSES_POINTS(normalized);
IRG_REFUSES_POINTS(normalized_fast);
IRG_REFUSES_POINTS(try_normalize);

}  // namespace IRG_ABI
}  // namespace irg
