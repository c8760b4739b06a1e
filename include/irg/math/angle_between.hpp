// SPDX-License-Identifier: MIT
// The angle between two vectors, right for every angle and over the whole range of float and double: from the cross and
// the dot product, both in twice the precision, of coordinates that were brought near 1 where they are not moderate.
#pragma once

#include <concepts>

#include <irg/core/conversion.hpp>
#include <irg/math/detail/compensated_terms.hpp>
#include <irg/math/detail/tangent_kernels.hpp>
#include <irg/math/hypot.hpp>
#include <irg/math/length.hpp>

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
[[nodiscard]] constexpr scalar_of<A> angle_between(const A& a, const B& b) noexcept;

IRG_REFUSES_POINTS(angle_between);

}  // namespace irg::inline IRG_ABI

namespace irg::detail::inline IRG_ABI {

// The angle between two vectors of moderate coordinates: the length of the cross product over the dot product, whose
// products are all taken with their rounding errors, and one arctangent of the unrounded quotient.

/// a*b of coordinates that were of type T, unrounded. Those of floats are exact in double.
template <Floating T>
IRG_INLINE constexpr unrounded coordinate_product(double a, double b) noexcept {
  if constexpr (std::is_same_v<T, float>)
    return {a * b, 0.0};
  else
    return fast_two_product(a, b);
}

/// x + y, the value rounded, for unrounded numbers of any sizes.
IRG_INLINE constexpr unrounded sum_of_any(const unrounded& x, const unrounded& y) noexcept {
  const unrounded heads = two_sum(x.value, y.value);
  return two_sum(heads.value, heads.error + (x.error + y.error));
}

/// a*b - c*d: zero if and only if the products are equal.
template <Floating T>
IRG_INLINE constexpr unrounded minor_of(double a, double b, double c, double d) noexcept {
  return sum_of_any(coordinate_product<T>(a, b), negated(coordinate_product<T>(c, d)));
}

/// The square root of x*x + y*y + z*z, unrounded after the sum.
/// needs   squares that neither overflow nor underflow
IRG_INLINE constexpr unrounded plain_length(double x, double y, double z) noexcept {
  const double square = (product(x, x) + product(y, y)) + product(z, z);
  const double root = sqrt(square);
  if (root == 0) return {};
  return {root, product(residual(square, root, root), 0.5 / root)};
}

/// The length of a's cross product with b.
template <Floating T>
IRG_INLINE constexpr unrounded crossed_length(const double (&a)[2], const double (&b)[2]) noexcept {
  const unrounded area = minor_of<T>(a[0], b[1], a[1], b[0]);
  return {times_sign(area.value, area.value), times_sign(area.error, area.value)};
}
template <Floating T>
IRG_INLINE constexpr unrounded crossed_length(const double (&a)[3], const double (&b)[3]) noexcept {
  const auto det = [&](int i, int j) { return minor_of<T>(a[i], b[j], a[j], b[i]).value; };
  return plain_length(det(1, 2), det(2, 0), det(0, 1));
}

template <Floating T>
IRG_INLINE constexpr unrounded unrounded_dot(const double (&a)[2], const double (&b)[2]) noexcept {
  return sum_of_any(coordinate_product<T>(a[0], b[0]), coordinate_product<T>(a[1], b[1]));
}
template <Floating T>
IRG_INLINE constexpr unrounded unrounded_dot(const double (&a)[3], const double (&b)[3]) noexcept {
  const unrounded x = coordinate_product<T>(a[0], b[0]), y = coordinate_product<T>(a[1], b[1]);
  const unrounded z = coordinate_product<T>(a[2], b[2]);
  const unrounded heads = two_sum(x.value, y.value);
  return sum_of_any({heads.value, heads.error + (x.error + y.error)}, z);
}

/// Whether the coordinates are zero or of such sizes that the products of any two, unless zero, are above 2^-360, their
/// differences above 2^-466 and the squares of these above 2^-932: all rounding errors can be numbers.
template <std::size_t N>
IRG_INLINE constexpr bool has_moderate_coordinates(const double (&a)[N]) noexcept {
  bool all = true;
  for (const double c : a) all = all && is_zero_or_within<-180, 180>(c);
  return all;
}

/// The angle between a and b, 0 to pi; 0 when one of them is zero.
/// needs   moderate coordinates
/// exact   the minors, rounded, have an error of 1u (u = 2^-53), the sum of their squares 3u more, so the angle one of
///         2.5u and the 0.52 ulp of the arctangent
template <Floating T, std::size_t N>
IRG_INLINE constexpr double angle_between_moderate(const double (&a)[N], const double (&b)[N]) noexcept {
  const unrounded across = crossed_length<T>(a, b);
  const unrounded dot = unrounded_dot<T>(a, b);
  const bool is_backward = dot.value < 0;
  const unrounded along = is_backward ? negated(dot) : dot;
  const bool is_steep = along.value < across.value;
  const unrounded lesser_one = is_steep ? along : across;
  const unrounded large = is_steep ? across : along;
  if (large.value == 0) return 0;
  const double inverse = 1 / large.value;
  const double quotient = product(lesser_one.value, inverse);
  const double rest = product(residual(lesser_one, quotient, large), inverse);
  return angle_of_quotient(quotient, rest, is_steep, is_backward);
}

/// angle_between_moderate for coordinates from the smallest number up to 2^52, by operations that look at their
/// arguments' exponents one by one.
constexpr double angle_between_extreme(const double (&a)[2], const double (&b)[2]) noexcept {
  const double across = irg::difference_of_products(a[0], b[1], a[1], b[0]);
  return angle_of(magnitude(across), irg::sum_of_products(a[0], b[0], a[1], b[1]));
}
constexpr double angle_between_extreme(const double (&a)[3], const double (&b)[3]) noexcept {
  const double x = irg::difference_of_products(a[1], b[2], a[2], b[1]);
  const double y = irg::difference_of_products(a[2], b[0], a[0], b[2]);
  const double z = irg::difference_of_products(a[0], b[1], a[1], b[0]);
  const compensated_sum dot =
      compensated_dot(3, [&](std::size_t i) { return a[i]; }, [&](std::size_t i) { return b[i]; });
  return angle_of(hypotenuse(x, y, z), dot.value + dot.error);
}

/// The coordinates brought near 1 where `scaled` could not: 2^1023, the largest power, leaves subnormal ones below.
template <int N>
constexpr void enlarge_subnormal(scaled_coordinates<N>& s) noexcept {
  if (s.scale == 0x1p1023)
    for (double& c : s.c) c = c * 0x1p51;
}

/// angle_between of vectors with very large, very small or infinite coordinates or NaN among them.
template <Vector A, Vector B>
constexpr double angle_between_any(const A& a, const B& b) noexcept {
  auto s = scaled_near_one(a);
  auto t = scaled_near_one(b);
  if (s.scale != s.scale || t.scale != t.scale) return not_a_number<double>;
  if (s.scale == 0 || t.scale == 0) return 0;
  enlarge_subnormal(s);
  enlarge_subnormal(t);
  if (has_moderate_coordinates(s.c) && has_moderate_coordinates(t.c)) return angle_between_moderate<double>(s.c, t.c);
  return angle_between_extreme(s.c, t.c);
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

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

}  // namespace irg::inline IRG_ABI
