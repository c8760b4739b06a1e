// SPDX-License-Identifier: MIT
// The real roots of a quadratic equation in twice the precision, with the sign of the discriminant decided exactly.
#pragma once

#include <irg/math/compensated.hpp>
#include <irg/math/detail/unrounded.hpp>

namespace irg::detail {

/// The real roots, yet to be rounded: value + error times 2^exponent each, in no order.
struct unrounded_roots {
  int count = 0;
  unrounded root[2]{};
  int exponent[2]{};
};

inline namespace IRG_ABI {

/// x * 2^k, rounded once.
/// needs   |x| is 0 or between 2^-900 and 2^900
constexpr double placed(const unrounded& x, int k) noexcept {
  if (x.value == 0) return 0;
  const int exponent = decompose(x.value).exponent;
  const double near_one = power_of_two(-exponent);
  return scale({x.value * near_one, x.error * near_one}, exponent + k);
}

/// a/b, rounded once, without an overflow that constant evaluation refuses.
/// needs   finite numbers, b not 0
constexpr double far_quotient(double a, double b) noexcept {
  if (a == 0) return 0;
  const scaled_number x = decompose(a), y = decompose(b);
  return placed(divide({x.significand, 0}, {y.significand, 0}), x.exponent - y.exponent);
}

/// h*h - a*c as if it were exact: its sign is, and it is precise enough for roots. The coefficient a has `Words` words.
/// needs   numbers whose products are far from the ends of the range
template <int Words>
IRG_INLINE constexpr unrounded half_discriminant(const unrounded& a, double h, double c) noexcept {
  const auto left = [&](std::size_t i) { return i == 0 ? h : i == 1 ? -a.value : -a.error; };
  const auto right = [&](std::size_t i) { return i == 0 ? h : c; };
  const compensated_sum sum = bounded_dot(Words + 1, left, right);
  const unrounded d = two_sum(sum.value, sum.error);
  if (magnitude(d.value) > 2 * sum.bound || sum.bound == 0) return d;
  return {exact_dot(Words + 1, left, right).rounded(), 0};
}

/// The real roots of a*x^2 + 2*h*x + c = 0; one stands for a double one.
/// needs   a not 0; numbers that are 0 or between 2^-240 and 2^240
template <int Words>
constexpr unrounded_roots solve_half(const unrounded& a, double h, double c) noexcept {
  unrounded_roots roots;
  const unrounded d = half_discriminant<Words>(a, h, c);
  if (d.value < 0) return roots;
  roots.count = d.value == 0 ? 1 : 2;
  if (roots.count == 1) {
    roots.root[0] = divide({-h, 0}, a);
    return roots;
  }
  // The root of larger size first: h and the square root do not cancel in it. The other one is the quotient of c.
  const unrounded root = unrounded_sqrt(d);
  const unrounded away = h < 0 ? root : negated(root);
  const unrounded sum = renormalised(add({-h, 0}, away));
  roots.root[0] = divide(sum, a);
  roots.root[1] = divide({c, 0}, sum);
  return roots;
}

IRG_INLINE constexpr bool is_moderate_coefficient(double x) noexcept {
  return x == 0 || (magnitude(x) >= 0x1p-240 && magnitude(x) <= 0x1p240);
}

/// The real roots of a*x^2 + b*x + c = 0 for coefficients of any size.
/// needs   finite numbers, none of them 0
constexpr unrounded_roots solve_far(double a, double b, double c) noexcept {
  const scaled_number x = decompose(a), y = decompose(b), z = decompose(c);
  // With x = 2^s * y the outer coefficients are between 1 and 4, and that of y is y.significand * 2^place.
  const int apart = z.exponent - x.exponent, s = (apart - (apart & 1)) / 2, place = y.exponent - x.exponent - s;
  unrounded_roots roots;
  if (place > 110) {  // the roots are so far apart that neither is seen by the other
    roots.count = 2;
    roots.root[0] = divide({-y.significand, 0}, {x.significand, 0});
    roots.exponent[0] = y.exponent - x.exponent;
    roots.root[1] = divide({-z.significand, 0}, {y.significand, 0});
    roots.exponent[1] = z.exponent - y.exponent;
    return roots;
  }
  const double middle = place < -110 ? 0.0 : y.significand * power_of_two(place) * 0.5;
  roots = solve_half<1>({x.significand, 0}, middle, z.significand * ((apart & 1) != 0 ? 2 : 1));
  roots.exponent[0] = roots.exponent[1] = s;
  return roots;
}

/// The real roots of a*x^2 + b*x + c = 0.
/// needs   finite numbers, a not 0
constexpr unrounded_roots solve_quadratic(double a, double b, double c) noexcept {
  if (is_moderate_coefficient(a) && is_moderate_coefficient(b) && is_moderate_coefficient(c))
    return solve_half<1>({a, 0}, b * 0.5, c);
  unrounded_roots roots;
  if (b != 0 && c != 0) return solve_far(a, b, c);
  const scaled_number x = decompose(a);
  if (c == 0) {  // 0 and -b/a
    roots.count = b == 0 ? 1 : 2;
    if (b == 0) return roots;
    const scaled_number y = decompose(b);
    roots.root[1] = divide({-y.significand, 0}, {x.significand, 0});
    roots.exponent[1] = y.exponent - x.exponent;
    return roots;
  }
  const scaled_number z = decompose(c);
  const int apart = z.exponent - x.exponent;
  roots = solve_half<1>({x.significand, 0}, 0, z.significand * ((apart & 1) != 0 ? 2 : 1));
  roots.exponent[0] = roots.exponent[1] = (apart - (apart & 1)) / 2;
  return roots;
}

/// Root i, rounded once; without scaling where there is none, so that 2^-480 to 2^480 need no decomposition.
constexpr double rounded_root(const unrounded_roots& roots, int i) noexcept {
  return roots.exponent[i] == 0 ? round(roots.root[i]) : placed(roots.root[i], roots.exponent[i]);
}

}  // namespace IRG_ABI
}  // namespace irg::detail
