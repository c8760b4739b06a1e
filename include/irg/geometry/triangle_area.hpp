// SPDX-License-Identifier: MIT
// The area of a triangle from its vertices or from its sides, with almost all digits however thin the triangle is and
// however far from the origin it lies.
#pragma once

#include <optional>

#include <irg/core/conversion.hpp>
#include <irg/core/coordinates.hpp>
#include <irg/math/compensated.hpp>
#include <irg/math/float_bits.hpp>
#include <irg/math/hypot.hpp>
#include <irg/math/sqrt.hpp>

namespace irg::inline IRG_ABI {

/// The area of the triangle a, b, c, positive when it turns counter-clockwise (y up), negative when it turns clockwise.
/// needs   finite coordinates
/// gives   infinity when the area is beyond the range of numbers; never NaN
/// exact   within 1.1 ulp (1.6 where subnormal); the sign is that of orient2d, and zero exactly for points on a line or
///         where the area underflows
/// cost    some 6 times that of the plain formula; where a triangle is so thin, so far away or of such a size that this
///         does not suffice, an exact sum in integers
/// source  Shewchuk 1997
template <Point P>
  requires(size_of<P> == 2 && Floating<scalar_of<P>>)
[[nodiscard]] constexpr scalar_of<P> signed_triangle_area(const P& a, const P& b, const P& c) noexcept;

/// The area of the triangle a, b, c in the plane or in space.
/// needs   finite coordinates
/// gives   as signed_triangle_area
/// exact   within 1.1 ulp in the plane, 2 ulp in space; zero exactly for points on a line or where the area underflows
/// cost    in space three times that in the plane, and a hypot
template <Point P>
  requires((size_of<P> == 2 || size_of<P> == 3) && Floating<scalar_of<P>>)
[[nodiscard]] constexpr scalar_of<P> triangle_area(const P& a, const P& b, const P& c) noexcept;

/// The signed area in the plane by the plain formula, half of (b - a) x (c - a).
/// exact   the error is at most some 4u times the sizes of the two products: thin triangles lose all digits and the
///         sign
/// needs   coordinates below 2^510 (float: 2^62)
template <Point P>
  requires(size_of<P> == 2)
[[nodiscard]] IRG_INLINE constexpr scalar_of<P> signed_triangle_area_fast(const P& a, const P& b, const P& c) noexcept;

/// The area of the triangle with sides of these lengths.
/// gives   nothing when a side is negative, NaN or infinite, or longer than the other two together; 0 when it is as
///         long
/// exact   within 6 ulp, for needles too, over the whole range
/// source  Kahan 1986a
template <Floating T>
[[nodiscard]] constexpr std::optional<T> triangle_area_from_sides(T a, T b, T c) noexcept;

IRG_REFUSES_VECTORS(signed_triangle_area);
IRG_REFUSES_VECTORS(triangle_area);
IRG_REFUSES_VECTORS(signed_triangle_area_fast);

}  // namespace irg::inline IRG_ABI

namespace irg::detail::inline IRG_ABI {

// Half of (b - a) x (c - a), exactly.
IRG_NOINLINE constexpr exact_accumulator<3> exact_area(double ax, double ay, double bx, double by, double cx,
                                                       double cy) noexcept {
  exact_accumulator<3> sum;
  sum.add(0.5, ax, by), sum.subtract(0.5, ay, bx);
  sum.add(0.5, bx, cy), sum.subtract(0.5, by, cx);
  sum.add(0.5, cx, ay), sum.subtract(0.5, cy, ax);
  return sum;
}

// Half of (b - a) x (c - a) with an error below 2^-52 of it, and with its sign.
// needs   finite numbers
// source  Shewchuk 1997 (the second stage of his filter)
constexpr double signed_area_of_doubles(double ax, double ay, double bx, double by, double cx, double cy) noexcept {
  const auto fits = [](double v) { return is_zero_or_within<-480, 481>(v); };  // products are exact as two doubles
  if (fits(ax) && fits(ay) && fits(bx) && fits(by) && fits(cx) && fits(cy)) {
    const auto [p, p_rest] = two_sum(bx, -ax);
    const auto [q, q_rest] = two_sum(by, -ay);
    const auto [r, r_rest] = two_sum(cx, -ax);
    const auto [s, s_rest] = two_sum(cy, -ay);
    const auto [left, left_rest] = two_product(p, s);
    const auto [right, right_rest] = two_product(q, r);
    const auto [heads, heads_rest] = two_sum(left, -right);
    if (p_rest == 0 && q_rest == 0 && r_rest == 0 && s_rest == 0)
      return 0.5 * (heads + (heads_rest + (left_rest - right_rest)));
    const double tails = (product(p, s_rest) + product(p_rest, s)) - (product(q, r_rest) + product(q_rest, r));
    const double area = heads + (heads_rest + ((left_rest - right_rest) + tails));
    // What is missing, products of two rests and roundings of the tails, is below 8u^2 of the products' sizes.
    if (magnitude(area) > product(magnitude(left) + magnitude(right), 0x1p-48)) return 0.5 * area;
  }
  return exact_area(ax, ay, bx, by, cx, cy).rounded();
}

template <class P>
IRG_INLINE constexpr double signed_area_in_plane(const P& a, const P& b, const P& c, int x, int y) noexcept {
  const auto at = [](const P& p, int i) { return widened(coordinate(p, i)); };
  return signed_area_of_doubles(at(a, x), at(a, y), at(b, x), at(b, y), at(c, x), at(c, y));
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <Point P>
  requires(size_of<P> == 2 && Floating<scalar_of<P>>)
[[nodiscard]] constexpr scalar_of<P> signed_triangle_area(const P& a, const P& b, const P& c) noexcept {
  return narrowed<scalar_of<P>>(detail::signed_area_in_plane(a, b, c, 0, 1));
}

template <Point P>
  requires((size_of<P> == 2 || size_of<P> == 3) && Floating<scalar_of<P>>)
[[nodiscard]] constexpr scalar_of<P> triangle_area(const P& a, const P& b, const P& c) noexcept {
  const double z = detail::signed_area_in_plane(a, b, c, 0, 1);
  if constexpr (size_of<P> == 2) {
    return narrowed<scalar_of<P>>(magnitude(z));
  } else {
    const double x = detail::signed_area_in_plane(a, b, c, 1, 2), y = detail::signed_area_in_plane(a, b, c, 2, 0);
    return narrowed<scalar_of<P>>(hypot(x, y, z));
  }
}

template <Point P>
  requires(size_of<P> == 2)
[[nodiscard]] constexpr scalar_of<P> signed_triangle_area_fast(const P& a, const P& b, const P& c) noexcept {
  using T = scalar_of<P>;
  const auto from_a = [&](const P& p, int i) { return coordinate(p, i) - coordinate(a, i); };
  return (product<T>(from_a(b, 0), from_a(c, 1)) - product<T>(from_a(b, 1), from_a(c, 0))) / T(2);
}

template <Floating T>
[[nodiscard]] constexpr std::optional<T> triangle_area_from_sides(T a, T b, T c) noexcept {
  double x = widened(maximum(a, maximum(b, c))), z = widened(minimum(a, minimum(b, c)));
  double y = widened(maximum(minimum(a, b), minimum(maximum(a, b), c)));
  if (!(a >= 0 && b >= 0 && c >= 0) || !is_finite(x)) return std::nullopt;
  const bool is_small = x < 0x1p-900;
  if (is_small) {
    x *= 0x1p100;
    y *= 0x1p100;
    z *= 0x1p100;
  }
  if (z < x - y) return std::nullopt;
  // The first and the last factor by quarters, so that they do not overflow.
  double factors = 1;
  int place = 0;
  for (const double factor :
       {0.25 * x + (0.25 * y + 0.25 * z), z - (x - y), z + (x - y), 0.25 * x + (0.25 * y - 0.25 * z)}) {
    if (factor == 0) return T(0);
    const scaled_number parts = decompose(factor);
    factors = product(factors, parts.significand);
    place += parts.exponent;
  }
  if ((place & 1) != 0) factors *= 2;
  return narrowed<T>(times_power_of_two(sqrt(factors), (place - (place & 1)) / 2 - (is_small ? 200 : 0)));
}

}  // namespace irg::inline IRG_ABI
