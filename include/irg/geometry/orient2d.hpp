// SPDX-License-Identifier: MIT
// On which side of the line through two points a third one lies, decided exactly.
#pragma once

#include <cstdint>
#include <type_traits>

#include <irg/core/coordinates.hpp>
#include <irg/geometry/detail/predicate_kernel.hpp>
#include <irg/math/error_free.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// a x b, twice the area of the triangle that a and b span.
template <class T>
IRG_INLINE constexpr auto spanned_area(const T& ax, const T& ay, const T& bx, const T& by) noexcept {
  return ax * by - ay * bx;
}

// The sign of (a - c) x (b - c), or 0 where rounded arithmetic cannot tell.
//
// Why it can tell: with X and Y the sizes of the largest differences along x and y, both products are at most X*Y. Each
// passes 4 roundings: two of differences, one of its own, which a compiler may leave out by fusing, and one of the
// sum; so the result is off by at most 2*((1 + u)^4 - 1)*X*Y < 8.001u*X*Y, u = 2^-53. The factor below is 8u(1 + 2^-9),
// and the rest of it exceeds the 5 roundings of the bound. t stands for what is lost where numbers are subnormal or
// taken for zero: less than 2^-1020 in a difference and in a product, hence at most 2^-1019*(X + Y + 1) in the result,
// less than the bound's share 2^-62*max(X, t)*max(Y, t), t = 2^-480. Where a product could overflow the bound is
// infinite or NaN; the difference of two finite ones has the right sign even where it overflows.
IRG_INLINE constexpr int orient2d_filtered(double ax, double ay, double bx, double by, double cx, double cy) noexcept {
  constexpr double factor = 0x1.008p-50, t = 0x1p-480;
  const double acx = ax - cx, acy = ay - cy, bcx = bx - cx, bcy = by - cy;
  const double area = spanned_area(acx, acy, bcx, bcy);
  const double x = greater(magnitude(acx), magnitude(bcx)) + t, y = greater(magnitude(acy), magnitude(bcy)) + t;
  return magnitude(area) > x * y * factor ? sign_of_nonzero(area) : 0;
}

// The same with the rounding errors of the differences and of their products in the sum.
//
// What is left out: products of two errors, 2u^2*X*Y in all; roundings of the sums of errors, 7u^2*X*Y for each product
// and 6u^2*X*Y for their difference; and the roundings of the last two sums, u each of a number that differs from the
// result by 6u*X*Y at most. Together less than 3u times the result and 29u^2*X*Y; the bound is 32u^2*X*Y. Subnormals
// and overflow are met as above, with t = 2^-400; sums that overflow on the way make the result NaN.
IRG_INLINE constexpr int orient2d_compensated(double ax, double ay, double bx, double by, double cx,
                                              double cy) noexcept {
  constexpr double factor = 0x1p-101, t = 0x1p-400;
  const auto acx = two_sum(ax, -cx), acy = two_sum(ay, -cy), bcx = two_sum(bx, -cx), bcy = two_sum(by, -cy);
  const auto left = fast_two_product(acx.value, bcy.value), right = fast_two_product(acy.value, bcx.value);
  const double left_error = left.error + (acx.value * bcy.error + acx.error * bcy.value);
  const double right_error = right.error + (acy.value * bcx.error + acy.error * bcx.value);
  const double area = (left.value - right.value) + (left_error - right_error);
  const double x = greater(magnitude(acx.value), magnitude(bcx.value)) + t;
  const double y = greater(magnitude(acy.value), magnitude(bcy.value)) + t;
  return magnitude(area) > x * y * factor ? sign_of_nonzero(area) : 0;
}

// The sign, for exact numbers: T holds the differences of coordinates, their products what they are made of.
template <class T>
IRG_INLINE constexpr int orient2d_of(const point_table<T, 3, 2>& t) {
  const auto d = relative_to_last(t);
  return coordinate_sign(spanned_area(d.v[0], d.v[1], d.v[2], d.v[3]));
}

// The exact stages: integers of one word, of two, or as long as doubles need. The first two leave open what does not
// fit them.
IRG_INLINE constexpr bool orient2d_by_words(const point_table<double, 3, 2>& t, int& sign) noexcept {
  point_table<std::int64_t, 3, 2> n{};
  if (!to_words(t, n)) return false;
  const auto d = relative_to_last(n);
  sign = spanned_area<wide_int<1>>(d.v[0], d.v[1], d.v[2], d.v[3]).sign();
  return true;
}
constexpr bool orient2d_by_double_words(const point_table<double, 3, 2>& t, int& sign) noexcept {
  point_table<wide_int<2>, 3, 2> n{};
  if (!to_double_words(t, n)) return false;
  sign = orient2d_of(n);
  return true;
}
constexpr int orient2d_by_sum(const point_table<double, 3, 2>& t) noexcept {  // a x b + b x c + c x a
  exact_accumulator<2> sum;
  for (int i = 0; i < 3; ++i) {
    const double *const p = t.v + 2 * i, *const q = t.v + 2 * ((i + 1) % 3);
    sum.add(p[0], q[1]);
    sum.subtract(p[1], q[0]);
  }
  return sum.sign();
}
// Arguments are passed in registers, so that nothing has to wait for the memory.
IRG_NOINLINE constexpr int orient2d_beyond_words(double ax, double ay, double bx, double by, double cx,
                                                 double cy) noexcept {
  const point_table<double, 3, 2> t{{ax, ay, bx, by, cx, cy}};
  int sign = 0;
  return orient2d_by_double_words(t, sign) ? sign : orient2d_by_sum(t);
}
IRG_NOINLINE constexpr int orient2d_exact(double ax, double ay, double bx, double by, double cx, double cy) noexcept {
  int sign = 0;
  if (!in_constant_evaluation()) sign = orient2d_compensated(ax, ay, bx, by, cx, cy);
  if (sign != 0 || orient2d_by_words({{ax, ay, bx, by, cx, cy}}, sign)) return sign;
  return orient2d_beyond_words(ax, ay, bx, by, cx, cy);
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// 1 when the way from a over b to c turns left (counter-clockwise, y up), -1 when it turns right, 0 when the three
/// points lie on a line.
/// needs   finite coordinates
/// exact   for every float, double and integer, subnormals and extremes included, under all floating-point flags and
///         with subnormals flushed to zero; other scalars: as exact as their own + - * are
/// cost    about 10 operations on floats where the points are not nearly collinear; else integers of 128 bits, of 256
///         where exponents differ by more than 8, and of 4300 where they differ by more than 72
/// source  Shewchuk 1997; Devillers and Pion 2003 (the filter)
template <Point P>
  requires(size_of<P> == 2)
IRG_INLINE constexpr int orient2d(const P& a, const P& b, const P& c) noexcept(std::is_arithmetic_v<scalar_of<P>>) {
  using T = scalar_of<P>;
  if constexpr (Floating<T>) {
    const auto [ax, ay, bx, by, cx, cy] = detail::table_of<double>(a, b, c).v;
    if (!detail::in_constant_evaluation())
      if (const int sign = detail::orient2d_filtered(ax, ay, bx, by, cx, cy); sign != 0) return sign;
    return detail::orient2d_exact(ax, ay, bx, by, cx, cy);
  } else if constexpr (std::is_integral_v<T>) {
    using wide = std::conditional_t<sizeof(T) <= 2, std::int64_t,
                                    std::conditional_t<sizeof(T) <= 4, detail::wide_signed, wide_int<2>>>;
    return detail::orient2d_of(detail::table_of<wide>(a, b, c));
  } else {
    return detail::orient2d_of(detail::table_of<T>(a, b, c));
  }
}

}  // namespace IRG_ABI
}  // namespace irg
