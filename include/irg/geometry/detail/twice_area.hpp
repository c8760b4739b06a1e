// SPDX-License-Identifier: MIT
// Twice the signed area of a triangle in the plane, so accurate that quotients of such areas can be rounded well.
#pragma once

#include <bit>
#include <cstdint>

#include <irg/math/error_free.hpp>
#include <irg/math/exact/scaled_double_double.hpp>
#include <irg/math/exact_sum.hpp>

namespace irg::detail {

// The corners of a triangle in the plane.
struct plane_corners {
  double ax, ay, bx, by, cx, cy;
};

inline namespace IRG_ABI {

// (b - a) x (c - a) = a x b + b x c + c x a without a difference that could be rounded.
constexpr exact_accumulator<2> exact_twice_area(const plane_corners& t) noexcept {
  exact_accumulator<2> sum;
  sum.add(t.ax, t.by), sum.subtract(t.ay, t.bx);
  sum.add(t.bx, t.cy), sum.subtract(t.by, t.cx);
  sum.add(t.cx, t.ay), sum.subtract(t.cy, t.ax);
  return sum;
}

// Whether every coordinate is 0 or of a size from 2^-400 to 2^400: nothing below over- or underflows.
IRG_INLINE constexpr bool is_moderate(const plane_corners& t) noexcept {
  const auto in_range = [](double x) { return is_zero_or_within<-400, 400>(x); };
  return in_range(t.ax) && in_range(t.ay) && in_range(t.bx) && in_range(t.by) && in_range(t.cx) && in_range(t.cy);
}

// Twice the area in two parts with a relative error below 2^-60.
// needs   is_moderate(t)
constexpr exact_sum<double> twice_area_of_moderate(const plane_corners& t) noexcept {
  const exact_sum<double> ux = two_sum(t.bx, -t.ax), uy = two_sum(t.by, -t.ay);
  const exact_sum<double> vx = two_sum(t.cx, -t.ax), vy = two_sum(t.cy, -t.ay);
  const exact_sum<double> left = fast_two_product(ux.value, vy.value), right = fast_two_product(uy.value, vx.value);
  const exact_sum<double> heads = two_sum(left.value, -right.value);
  const double left_rest = left.error + (product(ux.value, vy.error) + product(ux.error, vy.value));
  const double right_rest = right.error + (product(uy.value, vx.error) + product(uy.error, vx.value));
  const exact_sum<double> area = two_sum(heads.value, heads.error + (left_rest - right_rest));
  // What was dropped and rounded is below 2^-101 of the products' sizes.
  const double size = magnitude(left.value) + magnitude(right.value);
  if (magnitude(area.value) >= size * 0x1p-40) return area;
  return exact_twice_area(t).rounded_parts();
}

// n / d within 0.51 ulp.
// needs   d != 0, neither value beyond 2^+-960
IRG_INLINE constexpr double ratio(const exact_sum<double>& n, const exact_sum<double>& d) noexcept {
  const double q = n.value / d.value;
  const exact_sum<double> back = two_product(q, d.value);
  const double rest = ((n.value - back.value) - back.error) + (n.error - product(q, d.error));
  return q + rest / d.value;
}

// n / d within 0.51 ulp, whatever their exponents and the quotient's; infinity where that is beyond the range.
// needs   d != 0
template <int K>
constexpr double ratio(const exact_accumulator<K>& n, const exact_accumulator<K>& d) noexcept {
  const int shift = -d.exponent();
  const exact_sum<double> parts = n.rounded_parts(shift), one_to_two = d.rounded_parts(shift);
  const double size = magnitude(parts.value);
  if ((size > 0x1p-960 && size < 0x1p960) || n.sign() == 0) return ratio(parts, one_to_two);
  // The quotient, or the product that tells what it lacks, may leave the range of a double: exponents stand apart.
  const int up = -n.exponent();
  const exact_sum<double> scaled = n.rounded_parts(up);
  return rounded_to<double>(scaled_double_double(scaled, shift - up) / scaled_double_double(one_to_two, 0));
}

}  // namespace IRG_ABI
}  // namespace irg::detail
