// SPDX-License-Identifier: MIT
// Length and direction of vectors, right over the whole range of float and double: nothing overflows or underflows on
// the way, because coordinates that are not of moderate size are first brought near 1 by a power of two, and what the
// root lacks is taken from the squares once more.
#pragma once

#include <optional>
#include <utility>

#include <irg/core/conversion.hpp>
#include <irg/core/scalar.hpp>
#include <irg/math/float_bits.hpp>
#include <irg/math/detail/length_kernel.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/hypot.hpp>
#include <irg/math/sqrt.hpp>
#include <irg/math/vec.hpp>

namespace irg {

/// The coordinates of a vector times `scale`, a power of two that brings the largest near 1.
/// shape   scale is 0 for a vector of zeros, NaN when a coordinate is NaN or infinite
template <int N>
struct scaled_coordinates {
  double c[static_cast<std::size_t>(N)]{};
  double scale = 0;
  bool operator==(const scaled_coordinates&) const = default;
};

}  // namespace irg

namespace irg::inline IRG_ABI {

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
[[nodiscard]] IRG_INLINE constexpr scalar_of<V> length(const V& v) noexcept;

/// The vector of length 1 in the direction of v.
/// gives   nothing when v is zero or has a coordinate that is NaN or infinite
/// exact   each coordinate within 1.51 ulp (float 0.51): the length is rounded, then the quotient; float: 1 over the
///         length in double, then the product. The result's length is 1 within 2u (u = 2^-53, float 2^-24), over the
///         whole range
template <Vector V>
  requires Floating<scalar_of<V>>
[[nodiscard]] constexpr std::optional<V> try_normalized(const V& v) noexcept;

/// The vector of length 1 in the direction of v; the zero vector where there is none.
/// gives   the zero vector when v is zero or has a coordinate that is NaN or infinite; never NaN
/// exact   as try_normalized
template <Vector V>
  requires Floating<scalar_of<V>>
[[nodiscard]] IRG_INLINE constexpr V normalized(const V& v) noexcept;

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
    sum = next.value;
    error = error + next.error;
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

/// The coordinates of v times the power of two that brings the largest of them to 1 or more, below 4.
/// gives   the coordinates as they are, and a scale that says so, where there is no such power
/// exact   but for coordinates that become subnormal beside the largest
template <Vector V>
  requires Floating<scalar_of<V>>
[[nodiscard]] constexpr scaled_coordinates<size_of<V>> scaled_near_one(const V& v) noexcept {
  scaled_coordinates<size_of<V>> s;
  std::uint64_t largest = 0;  // sizes are ordered as their bits are, with infinity and NaN at the end
  for (int i = 0; i < size_of<V>; ++i) {
    s.c[i] = widened(coordinate(v, i));
    const std::uint64_t size = bits_of(magnitude(s.c[i]));
    largest = size > largest ? size : largest;
  }
  if (largest >= bits_of(infinity<double>)) s.scale = not_a_number<double>;
  if (largest >= bits_of(infinity<double>) || largest == 0) return s;
  s.scale = normalizing_power_of_two(from_bits(largest));
  for (double& c : s.c) c = c * s.scale;
  return s;
}

IRG_REFUSES_POINTS(length);
IRG_REFUSES_POINTS(length_fast);
IRG_REFUSES_POINTS(length_squared);
IRG_REFUSES_POINTS(normalized);
IRG_REFUSES_POINTS(normalized_fast);
IRG_REFUSES_POINTS(scaled_near_one);
IRG_REFUSES_POINTS(try_normalized);

}  // namespace irg::inline IRG_ABI

namespace irg::detail {

// Scaled lengths and directions, for length and normalized.

inline namespace IRG_ABI {

/// The length of the vector of N coordinates c(i).
template <class T, int N, class C>
IRG_INLINE constexpr T length_of(const C& c) noexcept {
  if constexpr (N == 1)
    return magnitude(c(0));
  else
    return [&]<int... J>(std::integer_sequence<int, J...>)
               IRG_INLINE_LAMBDA { return hypot_of<T>(c(J)...); }(std::make_integer_sequence<int, N>{});
}

/// The same for coordinates of moderate size, the sum of whose squares is known.
template <int N, class C>
IRG_INLINE constexpr double moderate_length_of(double square, const C& c) noexcept {
  return [&]<int... J>(std::integer_sequence<int, J...>) IRG_INLINE_LAMBDA {
    return round(length_of_moderate(square, magnitude(c(J))...));
  }(std::make_integer_sequence<int, N>{});
}

/// The length of scaled coordinates.
template <class T, int N>
constexpr double scaled_length(const scaled_coordinates<N>& s) noexcept {
  return length_of<double, N>([&](int i) { return s.c[i]; });
}

template <Vector V>
IRG_NOINLINE constexpr bool put_direction_of_any_size(const V& v, V& unit) noexcept {
  const auto s = scaled_near_one(v);
  if (!(s.scale > 0)) return false;
  const double length = scaled_length<double>(s);
  unit = generate_coordinates<V>([&](int i) { return s.c[i] / length; });
  return true;
}

/// Puts a vector's direction into `unit` and says whether there is one. A float's stands there as zero where there is
/// none.
template <Vector V>
IRG_INLINE constexpr bool put_direction(const V& v, V& unit) noexcept
  requires std::same_as<scalar_of<V>, float>
{
  return put_float_direction(v, unit);
}
template <Vector V>
IRG_INLINE constexpr bool put_direction(const V& v, V& unit) noexcept
  requires std::same_as<scalar_of<V>, double>
{
  double square = 0;
  for (int i = 0; i < size_of<V>; ++i) {
    const double c = coordinate(v, i);
    if (!can_take_squares(c)) return put_direction_of_any_size(v, unit);
    square = i == 0 ? product(c, c) : square + product(c, c);
  }
  if (!is_moderate_square(square)) return put_direction_of_any_size(v, unit);
  const double length =
      moderate_length_of<size_of<V>>(square, [&](int i) IRG_INLINE_LAMBDA { return coordinate(v, i); });
  unit = generate_coordinates<V>([&](int i) IRG_INLINE_LAMBDA { return coordinate(v, i) / length; });
  return true;
}

}  // namespace IRG_ABI
}  // namespace irg::detail

namespace irg::inline IRG_ABI {

template <Vector V>
  requires Floating<scalar_of<V>>
[[nodiscard]] IRG_INLINE constexpr scalar_of<V> length(const V& v) noexcept {
  return detail::length_of<scalar_of<V>, size_of<V>>([&](int i) { return coordinate(v, i); });
}

template <Vector V>
  requires Floating<scalar_of<V>>
[[nodiscard]] constexpr std::optional<V> try_normalized(const V& v) noexcept {
  if constexpr (std::semiregular<V>) {
    V unit = v;
    if (!detail::put_direction(v, unit)) return std::nullopt;
    return unit;
  } else {
    const auto unit = try_normalized(as_assignable(v));
    return unit ? std::optional<V>(from_assignable<V>(*unit)) : std::nullopt;
  }
}

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

IRG_RENAMED(try_normalize, try_normalized)

}  // namespace irg::inline IRG_ABI
