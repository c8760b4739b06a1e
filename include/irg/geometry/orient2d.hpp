// SPDX-License-Identifier: MIT
// On which side of the line through two points a third one lies, decided exactly.
#pragma once

#include <type_traits>

#include <irg/core/coordinates.hpp>
#include <irg/geometry/detail/predicate_kernel.hpp>
#include <irg/math/error_free.hpp>

namespace irg::inline IRG_ABI {

/// 1 when the way from a over b to c turns left (counter-clockwise, y up), -1 when it turns right, 0 when the three
/// points lie on a line.
/// needs   finite coordinates
/// exact   for every float, double and integer, subnormals and extremes included, under all floating-point flags and
///         with subnormals flushed to zero; other scalars: as exact as their own + - * are
/// cost    about 10 operations on floats where the points are not nearly collinear, else 50; integers of 128 bits where
///         that leaves it open, of 256 where exponents differ by more than 8; beyond 72 another 150 operations on
///         floats, and an exact sum of 6 products for points that are nearly collinear even so
/// source  Shewchuk 1997; Devillers and Pion 2003 (the filter)
template <Point P>
  requires(size_of<P> == 2)
[[nodiscard]] IRG_INLINE constexpr int orient2d(const P& a, const P& b,
                                                const P& c) noexcept(std::is_arithmetic_v<scalar_of<P>>);

IRG_REFUSES_VECTORS(orient2d);

}  // namespace irg::inline IRG_ABI

namespace irg::detail::inline IRG_ABI {

// a x b, twice the area of the triangle that a and b span.
template <class T>
IRG_INLINE constexpr auto spanned_area(const T& ax, const T& ay, const T& bx, const T& by) {
  return ax * by - ay * bx;
}
template <class T>
IRG_INLINE constexpr auto difference_determinant(const point_table<T, 2, 2>& d) {
  return spanned_area(d.v[0], d.v[1], d.v[2], d.v[3]);
}

// The sign of (a - c) x (b - c), or 0 where rounded arithmetic cannot tell.
//
// Why it can tell: with X and Y the sizes of the largest differences along x and y, both products are at most X*Y. Each
// passes 4 roundings: two of differences, one of its own, which a compiler may leave out by fusing, and one of the
// sum; so the result is off by at most 2*((1 + u)^4 - 1)*X*Y < 8.001u*X*Y, u = 2^-53. The factor below is 8u(1 + 2^-9),
// and the rest of it exceeds the 5 roundings of the bound. t stands for what is lost where numbers are subnormal or
// taken for zero: less than 2^-1020 in a difference and in a product, hence at most 2^-1019*(X + Y + 1) in the result,
// less than the bound's share 2^-62*max(X, t)*max(Y, t), t >= 2^-480. Where a product could overflow the bound is
// infinite or NaN; the difference of two finite ones has the right sign even where it overflows.
IRG_INLINE constexpr int filtered_sign(const point_table<double, 3, 2>& p, double t) noexcept {
  constexpr double factor = 0x1.008p-50;
  const auto [acx, acy, bcx, bcy] = relative_to_last(p).v;
  const double area = spanned_area(acx, acy, bcx, bcy);
  const double x = maximum(magnitude(acx), magnitude(bcx)) + t, y = maximum(magnitude(acy), magnitude(bcy)) + t;
  return magnitude(area) > x * y * factor ? sign_of_nonzero(area) : 0;
}

#if IRG_BODIES
// The same with the rounding errors of the differences and of their products in the sum.
//
// What is left out: products of two errors, 2u^2*X*Y in all; roundings of the sums of errors, 7u^2*X*Y for each product
// and 6u^2*X*Y for their difference; and the roundings of the last two sums, u each of a number that differs from the
// result by 6u*X*Y at most. Together less than 3u times the result and 29u^2*X*Y; the bound is 32u^2*X*Y. Subnormals
// and overflow are met as above, with t = 2^-400; sums that overflow on the way make the result NaN.
IRG_INLINE constexpr int compensated_sign(const point_table<double, 3, 2>& p) noexcept {
  constexpr double factor = 0x1p-101, t = 0x1p-400;
  const auto [ax, ay, bx, by, cx, cy] = p.v;
  const auto acx = two_sum(ax, -cx), acy = two_sum(ay, -cy), bcx = two_sum(bx, -cx), bcy = two_sum(by, -cy);
  const auto left = fast_two_product(acx.value, bcy.value), right = fast_two_product(acy.value, bcx.value);
  const double left_error = left.error + (acx.value * bcy.error + acx.error * bcy.value);
  const double right_error = right.error + (acy.value * bcx.error + acy.error * bcx.value);
  const double area = (left.value - right.value) + (left_error - right_error);
  const double x = maximum(magnitude(acx.value), magnitude(bcx.value)) + t;
  const double y = maximum(magnitude(acy.value), magnitude(bcy.value)) + t;
  return magnitude(area) > x * y * factor ? sign_of_nonzero(area) : 0;
}
#endif

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <Point P>
  requires(size_of<P> == 2)
[[nodiscard]] constexpr int orient2d(const P& a, const P& b, const P& c) noexcept(std::is_arithmetic_v<scalar_of<P>>) {
  return detail::predicate(a, b, c);
}

}  // namespace irg::inline IRG_ABI
