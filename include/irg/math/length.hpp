// SPDX-License-Identifier: MIT
// Length, direction and angle of vectors, right over the whole range of float and double: nothing overflows or
// underflows on the way, because coordinates are first brought near 1 by a power of two, and squares and products are
// summed in twice the precision.
#pragma once

#include <limits>
#include <optional>

#include <irg/core/scalar.hpp>
#include <irg/math/detail/compensated_terms.hpp>
#include <irg/math/detail/float_bits.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/hypot.hpp>
#include <irg/math/sqrt.hpp>
#include <irg/math/trigonometry.hpp>
#include <irg/math/vec.hpp>

namespace irg::detail {

/// The coordinates of a vector times `scale`, a power of two that brings the largest near 1.
/// shape   scale is 0 for a vector of zeros, NaN when a coordinate is NaN or infinite
template <int N>
struct scaled_coordinates {
  double c[static_cast<std::size_t>(N)]{};
  double scale = 0;
};

inline namespace IRG_ABI {

/// A power of two p with 1 <= x*p < 4, or p = 2^1023 for subnormal x.
/// needs   0 < x < infinity
IRG_INLINE constexpr double power_of_two_for(double x) noexcept {
  const std::uint64_t exponent = bits_of(x) >> 52;
  return from_bits((exponent < 2045 ? 2046 - exponent : std::uint64_t{1}) << 52);
}

template <Vector V>
constexpr scaled_coordinates<size_of<V>> scaled(const V& v) noexcept {
  scaled_coordinates<size_of<V>> s;
  double largest = 0;
  bool finite = true;
  for (int i = 0; i < size_of<V>; ++i) {
    s.c[i] = static_cast<double>(coordinate(v, i));
    finite = finite && is_finite(s.c[i]);
    largest = greater(largest, magnitude(s.c[i]));
  }
  if (!finite) s.scale = std::numeric_limits<double>::quiet_NaN();
  if (!finite || largest == 0) return s;
  s.scale = power_of_two_for(largest);
  for (double& c : s.c) c = c * s.scale;
  return s;
}

/// The length of the vector of N coordinates c(i).
template <class T, int N, class C>
constexpr T folded_length(const C& c) noexcept {
  if constexpr (N == 1) return magnitude(c(0));
  if constexpr (N == 2) return hypot(c(0), c(1), T(0));
  if constexpr (N >= 3) {
    T length = hypot(c(0), c(1), c(2));
    for (int i = 3; i < N; ++i) length = hypot(length, c(i));
    return length;
  }
}

/// The length of scaled coordinates: float's in double, where their squares are exact.
template <class T, int N>
constexpr double scaled_length(const scaled_coordinates<N>& s) noexcept {
  if constexpr (std::same_as<T, double>) return folded_length<double, N>([&](int i) { return s.c[i]; });
  double sum = 0;
  for (const double c : s.c) sum = sum + product(c, c);
  return sqrt(sum);
}

}  // namespace IRG_ABI
}  // namespace irg::detail

namespace irg {
inline namespace IRG_ABI {

/// The square of the length: the sum of the squares of the coordinates.
/// exact   each product and each sum rounded once, never fused; overflows and underflows as the squares do
template <Vector V>
IRG_INLINE constexpr scalar_of<V> length_squared(const V& v) noexcept {
  return dot(v, v);
}

/// The length of v over the whole range of its numbers, subnormal to largest.
/// gives   infinity when a coordinate is infinite or the length is beyond the range, else NaN when one is NaN
/// exact   within 0.501 ulp for up to three coordinates, half an ulp more for each further one, and within 1 ulp where
///         the result is subnormal; a vector along an axis has its exact length
/// cost    that of hypot
template <Vector V>
  requires Floating<scalar_of<V>>
constexpr scalar_of<V> length(const V& v) noexcept {
  return detail::folded_length<scalar_of<V>, size_of<V>>([&](int i) { return coordinate(v, i); });
}

/// The vector of length 1 in the direction of v.
/// gives   nothing when v is zero or has a coordinate that is NaN or infinite
/// exact   each coordinate within 1.51 ulp (float 0.51): the length is rounded, then the quotient. The result's length
///         is 1 within 2u (u = 2^-53, float 2^-24), over the whole range
template <Vector V>
  requires Floating<scalar_of<V>>
constexpr std::optional<V> try_normalize(const V& v) noexcept {
  const auto s = detail::scaled(v);
  if (!(s.scale > 0)) return std::nullopt;
  const double length = detail::scaled_length<scalar_of<V>>(s);
  return generate_coordinates<V>([&](int i) { return static_cast<scalar_of<V>>(s.c[i] / length); });
}

/// The vector of length 1 in the direction of v; the zero vector where there is none.
/// gives   the zero vector when v is zero or has a coordinate that is NaN or infinite; never NaN
/// exact   as try_normalize
template <Vector V>
  requires Floating<scalar_of<V>>
constexpr V normalized(const V& v) noexcept {
  const std::optional<V> unit = try_normalize(v);
  return unit ? *unit : generate_coordinates<V>([](int) { return scalar_of<V>(0); });
}

/// The length of v by the plain formula, for inner loops.
/// needs   coordinates whose squares neither overflow nor vanish: the largest between 2^-500 and 2^500 (float: 2^-60
///         and 2^60)
/// exact   error below 2 ulp
template <Vector V>
  requires Floating<scalar_of<V>>
IRG_INLINE constexpr scalar_of<V> length_fast(const V& v) noexcept {
  return sqrt(dot(v, v));
}

/// The vector of length 1 in the direction of v by the plain formula, for inner loops: v times 1 over its length.
/// needs   as length_fast
/// gives   the zero vector when the sum of the squares is zero
/// exact   each coordinate below 5 ulp for up to three of them; never fused
template <Vector V>
  requires Floating<scalar_of<V>>
IRG_INLINE constexpr V normalized_fast(const V& v) noexcept {
  using T = scalar_of<V>;
  const T square = dot(v, v);
  const T factor = T(1) / sqrt(square > 0 ? square : T(1));
  return generate_coordinates<V>([&](int i) { return product(coordinate(v, i), factor); });
}

/// The angle between two vectors, 0 to pi.
/// units   radians
/// gives   0 when either is zero; NaN when a coordinate is NaN or infinite
/// exact   error below 4 ulp for every angle, however small; exactly 0 for a and a, pi rounded for a and -a
/// source  atan2 of the cross product's length and the dot product, both in twice the precision (after Kahan 2006)
template <Vector A, Vector B>
  requires((size_of<A> == 2 || size_of<A> == 3) && size_of<A> == size_of<B> &&
           std::same_as<scalar_of<A>, scalar_of<B>> && Floating<scalar_of<A>>)
constexpr scalar_of<A> angle_between(const A& a, const B& b) noexcept {
  using T = scalar_of<A>;
  const auto s = detail::scaled(a);
  const auto t = detail::scaled(b);
  if (s.scale != s.scale || t.scale != t.scale) return std::numeric_limits<T>::quiet_NaN();
  if (s.scale == 0 || t.scale == 0) return T(0);
  const detail::compensated_sum dot =
      detail::compensated_dot(size_of<A>, [&](std::size_t i) { return s.c[i]; }, [&](std::size_t i) { return t.c[i]; });
  const double along = dot.value + dot.error;
  const auto minor = [&](int i, int j) { return difference_of_products(s.c[i], t.c[j], s.c[j], t.c[i]); };
  if constexpr (size_of<A> == 2)
    return static_cast<T>(atan2(detail::magnitude(minor(0, 1)), along));
  else
    return static_cast<T>(atan2(length(vec<double, 3>{minor(1, 2), minor(2, 0), minor(0, 1)}), along));
}

}  // namespace IRG_ABI
}  // namespace irg
