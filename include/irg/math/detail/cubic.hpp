// SPDX-License-Identifier: MIT
// The real roots of a cubic equation. How many there are is decided by the exact sign of the discriminant; each root is
// found by Newton's iteration and then enclosed between two neighbouring numbers by exact signs of the polynomial.
#pragma once

#include <concepts>

#include <irg/math/detail/quadratic.hpp>
#include <irg/math/double_double.hpp>
#include <irg/math/polynomial.hpp>

namespace irg::detail {

inline constexpr double last_double = (std::numeric_limits<double>::max)();

using cubic_coefficients = std::array<double, 4>;  // ascending: d, c, b, a

/// An interval in which the polynomial changes its sign once, from `left_sign` to its opposite.
struct sign_change {
  double low, high;
  int left_sign;
};

inline namespace IRG_ABI {

/// The sign of b^2 c^2 - 4 a c^3 - 4 b^3 d + 18 a b c d - 27 a^2 d^2: 1 for three real roots, -1 for one, 0 for a
/// multiple one.
template <std::same_as<cubic_coefficients> C = cubic_coefficients>
constexpr int cubic_discriminant_sign(const C& p) noexcept {
  const auto [d, c, b, a] = p;
  if (is_within(a, 150) && is_within(b, 150) && is_within(c, 150) && is_within(d, 150)) {
    using dd = double_double;
    const auto [bb, bb_error] = two_product(b, b);
    const auto [ac, ac_error] = two_product(a, c);
    const auto [bd, bd_error] = two_product(b, d);
    const auto [cc, cc_error] = two_product(c, c);
    const auto [ad, ad_error] = two_product(a, d);
    const dd left = dd(bb, bb_error) * (dd(cc, cc_error) - dd(bd, bd_error) * 4.0);
    const dd right = dd(ac, ac_error) * (dd(bd, bd_error) * 18.0 - dd(cc, cc_error) * 4.0);
    const dd last = dd(ad, ad_error) * dd(ad, ad_error) * 27.0;
    const dd sum = (left + right) - last;
    const double size = magnitude(bb) * (magnitude(cc) + 4 * magnitude(bd)) +
                        magnitude(ac) * (18 * magnitude(bd) + 4 * magnitude(cc)) + 27 * ad * ad;
    if (magnitude(sum.high) > product(size, 0x1p-98)) return sum.high < 0 ? -1 : 1;
  }
  exact_accumulator<5> sum;
  sum.add(b, b, c, c);
  sum.subtract(4.0, a, c, c, c);
  sum.subtract(4.0, b, b, b, d);
  sum.add(18.0, a, b, c, d);
  sum.subtract(27.0, a, a, d, d);
  return sum.sign();
}

/// The sign of the polynomial at -b/3a, the middle of its roots.
constexpr int sign_at_inflection(const std::same_as<cubic_coefficients> auto& p) noexcept {
  const auto [d, c, b, a] = p;
  exact_accumulator<4> sum;
  sum.add(2.0, b, b, b);
  sum.subtract(9.0, a, b, c);
  sum.add(27.0, a, a, d);
  return sum.sign();
}

/// Doubles in order as integers in order.
constexpr std::int64_t order_of(double x) noexcept {
  const auto bits = static_cast<std::int64_t>(bits_of(magnitude(x)));
  return is_negative(x) ? -bits : bits;
}
constexpr double at_order(std::int64_t place) noexcept {
  const double x = from_bits(static_cast<std::uint64_t>(place < 0 ? -place : place));
  return place < 0 ? -x : x;
}

/// Which of two neighbours is nearer to the root between them.
constexpr double nearer_root(const std::same_as<cubic_coefficients> auto& p, double x, double y) noexcept {
  return magnitude(evaluate_polynomial_accurate(p, y)) < magnitude(evaluate_polynomial_accurate(p, x)) ? y : x;
}

/// The root in the interval by halving it, in the order of doubles: 64 steps at most, whatever the polynomial.
/// gives   an infinity when the sign does not change before the end of the range
constexpr double root_by_halving(const std::same_as<cubic_coefficients> auto& p, const sign_change& in) noexcept {
  if (in.high == last_double && polynomial_sign(p, in.high) == in.left_sign) return infinity<double>;
  if (in.low == -last_double && polynomial_sign(p, in.low) == -in.left_sign) return -infinity<double>;
  std::int64_t low = order_of(in.low), high = order_of(in.high);
  while (low + 1 < high) {
    const std::int64_t middle = (low & high) + ((low ^ high) >> 1);  // half of the sum, which does not fit
    const int sign = polynomial_sign(p, at_order(middle));
    if (sign == 0) return at_order(middle);
    (sign == in.left_sign ? low : high) = middle;
  }
  return nearer_root(p, at_order(low), at_order(high));
}

/// A value of the polynomial, accurate, and its exact sign.
struct signed_value {
  double value;
  int sign;
};
constexpr signed_value signed_value_at(const std::same_as<cubic_coefficients> auto& p, double x) noexcept {
  const auto at = [&](std::size_t i) { return p[i]; };
  if (can_be_bounded(4, at, x)) {
    const compensated_sum sum = bounded_horner(4, at, x);
    const double value = sum.value + sum.error;
    if (magnitude(value) > 2 * sum.bound) return {value, value < 0 ? -1 : 1};
  }
  const auto sum = exact_horner(p, x);
  return {sum.rounded(), sum.sign()};
}

/// The root in the interval, from a guess that is near it: the neighbours on both sides of it are found by exact signs.
constexpr double root_near(const std::same_as<cubic_coefficients> auto& p, const sign_change& in,
                           double guess) noexcept {
  if (!(guess > in.low && guess < in.high)) return root_by_halving(p, in);
  double x = guess;
  signed_value here = signed_value_at(p, x);
  const bool upwards = here.sign == in.left_sign;
  for (int step = 0; step < 4; ++step) {
    if (here.sign == 0) return x;
    const double y = at_order(order_of(x) + (upwards ? 1 : -1));
    if (y > in.high || y < in.low) return x;
    const signed_value next = signed_value_at(p, y);
    if (next.sign == -here.sign) return magnitude(next.value) < magnitude(here.value) ? y : x;
    x = y;
    here = next;
  }
  return root_by_halving(p, upwards ? sign_change{x, in.high, in.left_sign} : sign_change{in.low, x, in.left_sign});
}

/// Newton's iteration from a place that is less than `last_step` from the root, with accurate values once it is near;
/// left when it does not converge.
constexpr double polished(const std::same_as<cubic_coefficients> auto& p, double x, double last_step) noexcept {
  for (int i = 0; i < 12; ++i) {
    const auto [plain, slope] = evaluate_polynomial_with_derivative(p, x);
    if (slope == 0) return x;
    const bool is_near = last_step < magnitude(x) * 0x1p-12;
    const double step = (is_near ? evaluate_polynomial_accurate(p, x) : plain) / slope;
    if (!(magnitude(step) < 0.75 * last_step)) return x;
    x = x - step;
    last_step = magnitude(step);
    if (is_near && last_step < magnitude(x) * 0x1p-40) return x;
  }
  return x;
}

/// Near the only real root: Newton's iteration from a place beyond it, from where it cannot turn back.
/// source  Kahan 1986b (QBC), with a coarse cube root
constexpr double only_root_guess(const std::same_as<cubic_coefficients> auto& p) noexcept {
  const double middle = -p[2] / (3 * p[3]);
  const auto [value, slope] = evaluate_polynomial_with_derivative(p, middle);
  const double level = value / p[3], fall = -slope / p[3];
  if (level == 0) return middle;
  // A third of the exponent: at most 6 % from the cube root.
  double radius = from_bits(bits_of(magnitude(level)) / 3 + 0x2a9f7893782da1ceu) * 1.07;
  if (fall > 0) radius = 1.324718 * greater(radius, sqrt(fall));
  double x = level < 0 ? middle + radius : middle - radius;
  for (int i = 0; i < 60; ++i) {
    const auto [height, rise] = evaluate_polynomial_with_derivative(p, x);
    const double next = rise == 0 ? x : x - height / rise;
    if (!(level < 0 ? next < x && next > middle : next > x && next < middle)) return x;
    if (magnitude(next - x) < magnitude(x) * 0x1p-8) return next;
    x = next;
  }
  return x;
}

/// The extrema of the polynomial and the sizes of coefficients that decide how roots are looked for.
struct cubic_shape {
  double low, high;  // where the derivative is zero
  bool is_moderate;
};

constexpr bool is_moderate_cubic(const std::same_as<cubic_coefficients> auto& p) noexcept {
  return is_within(p[0], 60) && is_within(p[1], 60) && is_within(p[2], 60) && is_within(p[3], 60);
}

/// needs   a polynomial with two extrema
constexpr cubic_shape cubic_shape_of(const std::same_as<cubic_coefficients> auto& p) noexcept {
  const auto [d, c, b, a] = p;
  cubic_shape shape{0, 0, is_moderate_cubic(p)};
  const bool is_large = magnitude(a) > 0x1p1000 || magnitude(b) > 0x1p1000;
  const unrounded_roots at = shape.is_moderate ? solve_half<2>(two_sum(2 * a, a), b, c)
                             : is_large        ? solve_quadratic(0.75 * a, 0.5 * b, 0.25 * c)
                                               : solve_quadratic(3 * a, 2 * b, c);
  const double x = rounded_root(at, 0), y = at.count == 2 ? rounded_root(at, 1) : x;
  shape.low = clamp(lesser(x, y), -last_double, last_double);
  shape.high = clamp(greater(x, y), -last_double, last_double);
  return shape;
}

/// The root in the interval that ends at the extremum `at`, `outwards` (1 or -1) of which it lies.
constexpr double root_beside(const std::same_as<cubic_coefficients> auto& p, const cubic_shape& shape,
                             const sign_change& in, double at, double outwards) noexcept {
  if (!shape.is_moderate) return root_by_halving(p, in);
  // Around the extremum the polynomial is height + bend * s^2 + a * s^3.
  const double height = evaluate_polynomial_accurate(p, at);
  const double bend = product(3 * p[3], at) + p[2];
  const double square = bend == 0 ? 0 : -height / bend, distance = sqrt(square > 0 ? square : 0);
  return root_near(p, in, polished(p, at + outwards * distance, distance));
}

}  // namespace IRG_ABI
}  // namespace irg::detail
