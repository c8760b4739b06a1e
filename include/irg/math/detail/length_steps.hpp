// SPDX-License-Identifier: MIT
// Scaled lengths and directions, for length and normalized.
#pragma once

#include <limits>
#include <optional>
#include <utility>

#include <irg/core/conversion.hpp>
#include <irg/core/scalar.hpp>
#include <irg/math/detail/float_bits.hpp>
#include <irg/math/detail/length_kernel.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/hypot.hpp>
#include <irg/math/sqrt.hpp>
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
  std::uint64_t largest = 0;  // sizes are ordered as their bits are, with infinity and NaN at the end
  for (int i = 0; i < size_of<V>; ++i) {
    s.c[i] = widened(coordinate(v, i));
    const std::uint64_t size = bits_of(magnitude(s.c[i]));
    largest = size > largest ? size : largest;
  }
  if (largest >= bits_of(infinity<double>)) s.scale = not_a_number<double>;
  if (largest >= bits_of(infinity<double>) || largest == 0) return s;
  s.scale = power_of_two_for(from_bits(largest));
  for (double& c : s.c) c = c * s.scale;
  return s;
}

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
  const auto s = scaled(v);
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
