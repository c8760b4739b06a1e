// SPDX-License-Identifier: MIT
// The angle between two vectors, right for every angle and over the whole range of float and double: from the cross and
// the dot product, both in twice the precision, of coordinates that were brought near 1 where they are not moderate.
#pragma once

#include <concepts>

#include <irg/core/conversion.hpp>
#include <irg/math/detail/vector_angle.hpp>
#include <irg/math/length.hpp>

namespace irg::detail::inline IRG_ABI {

/// The coordinates brought near 1 where `scaled` could not: 2^1023, the largest power, leaves subnormal ones below.
template <int N>
constexpr void enlarge_subnormal(scaled_coordinates<N>& s) noexcept {
  if (s.scale == 0x1p1023)
    for (double& c : s.c) c = c * 0x1p51;
}

/// angle_between of vectors with very large, very small or infinite coordinates or NaN among them.
template <Vector A, Vector B>
constexpr double angle_between_any(const A& a, const B& b) noexcept {
  auto s = scaled(a);
  auto t = scaled(b);
  if (s.scale != s.scale || t.scale != t.scale) return not_a_number<double>;
  if (s.scale == 0 || t.scale == 0) return 0;
  enlarge_subnormal(s), enlarge_subnormal(t);
  if (has_moderate_coordinates(s.c) && has_moderate_coordinates(t.c)) return angle_between_moderate<double>(s.c, t.c);
  return angle_between_extreme(s.c, t.c);
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

/// The angle between two vectors, 0 to pi.
/// units   radians
/// gives   0 when either is zero; NaN when a coordinate is NaN or infinite
/// exact   error below 4 ulp for every angle, however small; exactly 0 for a and a, pi rounded for a and -a
/// cost    eleven exact products, a square root, two divisions, a table lookup (in the plane five, no root and one
///         division): 1.3 to 4 times the plain formula, which takes less for small angles. Up to three times that where
///         a coordinate other than 0 is outside 2^-180 to 2^180
/// source  Kahan 2006; here atan2 of the cross product's length and the dot product, both in twice the precision
template <Vector A, Vector B>
  requires((size_of<A> == 2 || size_of<A> == 3) && size_of<A> == size_of<B> &&
           std::same_as<scalar_of<A>, scalar_of<B>> && Floating<scalar_of<A>>)
[[nodiscard]] constexpr scalar_of<A> angle_between(const A& a, const B& b) noexcept {
  using T = scalar_of<A>;
  double c[static_cast<std::size_t>(size_of<A>)]{}, d[static_cast<std::size_t>(size_of<A>)]{};
  for (int i = 0; i < size_of<A>; ++i) {
    c[i] = widened(coordinate(a, i));
    d[i] = widened(coordinate(b, i));
  }
  const bool is_moderate = detail::has_moderate_coordinates(c) && detail::has_moderate_coordinates(d);
  return converted<T>(is_moderate ? detail::angle_between_moderate<T>(c, d) : detail::angle_between_any(a, b));
}

IRG_REFUSES_POINTS(angle_between);

}  // namespace irg::inline IRG_ABI
