// SPDX-License-Identifier: MIT
// Real roots of quadratic and cubic equations: as many as there are, decided exactly, and each with almost all its
// digits, for coefficients of any size.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include <irg/core/conversion.hpp>
#include <irg/math/compensated.hpp>
#include <irg/math/detail/unrounded.hpp>
#include <irg/math/double_double.hpp>
#include <irg/math/polynomial.hpp>

namespace irg {

/// What the solutions of an equation are. `linear` is the one solution of an equation without a square or a cube; `all`
/// says that every number solves it (0 = 0), `undefined` that a coefficient is NaN or infinite.
enum class roots_kind { none, one, two, three, linear, all, undefined };

/// The distinct real roots of an equation of degree N or less.
/// shape   a range of numbers in ascending order, root[0] to root[count - 1]; multiplicity[i] is 1, 2 or 3. Roots that
///         differ by less than rounding does can be equal numbers. A root beyond the range of T is an infinity
template <Floating T, int N>
struct real_roots {
  roots_kind kind = roots_kind::none;
  int count = 0;
  T root[static_cast<std::size_t>(N)]{};
  int multiplicity[static_cast<std::size_t>(N)]{};
  [[nodiscard]] IRG_APART constexpr const T* begin() const noexcept { return root; }
  [[nodiscard]] IRG_APART constexpr const T* end() const noexcept { return root + count; }
  [[nodiscard]] IRG_APART constexpr std::size_t size() const noexcept { return static_cast<std::size_t>(count); }
  friend constexpr bool operator==(const real_roots&, const real_roots&) = default;
};

inline namespace IRG_ABI {

/// The real roots of a*x^2 + b*x + c = 0.
/// gives   `one`, of multiplicity 2, exactly when the discriminant is zero; `linear` when a = 0; `none` when there is
///         no real root, `all` when all three coefficients are 0, `undefined` when one is NaN or infinite
/// exact   the number of roots for all finite coefficients; each root within 0.51 ulp (float 0.501) over the whole
///         range, subnormals within 1
/// cost    a square root, three divisions and some 60 operations; coefficients beyond 2^-240 to 2^240 some more
/// source  Kahan 2004 (the discriminant in twice the precision), here with the root, sum and quotients in it, too
template <Floating T>
[[nodiscard]] constexpr real_roots<T, 2> quadratic_roots(T a, T b, T c) noexcept;

/// The same for coefficients of different types, and integers.
template <class A, class B, class C>
  requires MixedArguments<A, B, C>
[[nodiscard]] constexpr real_roots<double, 2> quadratic_roots(A a, B b, C c) noexcept {
  return quadratic_roots(static_cast<double>(a), static_cast<double>(b), static_cast<double>(c));
}

/// The real roots of a*x^2 + b*x + c = 0 by the stable formula in working precision.
/// needs   a not 0; a*c and b*b 0 or between 2^-900 and 2^1000 (float: no limit), quotients in the range
/// exact   within 3 ulp (measured: 2.0); the number of roots is right
/// cost    a square root, two divisions and a difference_of_products
/// source  Kahan 2004 (the discriminant); the root of larger size first, the other from the product of both
template <Floating T>
[[nodiscard]] constexpr real_roots<T, 2> quadratic_roots_fast(T a, T b, T c) noexcept;

/// The real roots of a*x^3 + b*x^2 + c*x + d = 0.
/// gives   as quadratic_roots; that of quadratic_roots when a = 0
/// exact   the number of distinct roots and their multiplicities for all finite coefficients; each root within 1 ulp,
///         two that are nearer to each other than 2 ulp within 3
/// cost    some 0.2 us for one root, 0.7 us for three; coefficients beyond 2^-60 to 2^60 some 20 us
/// source  Kahan 1986b and Blinn 2006 (starting places); the enclosure by exact signs is irg's own
template <Floating T>
[[nodiscard]] constexpr real_roots<T, 3> cubic_roots(T a, T b, T c, T d) noexcept;

/// The same for coefficients of different types, and integers.
template <class A, class B, class C, class D>
  requires MixedArguments<A, B, C, D>
[[nodiscard]] constexpr real_roots<double, 3> cubic_roots(A a, B b, C c, D d) noexcept {
  return cubic_roots(static_cast<double>(a), static_cast<double>(b), static_cast<double>(c), static_cast<double>(d));
}

}  // namespace IRG_ABI

namespace detail {

/// The real roots, yet to be rounded: value + error times 2^exponent each, in no order.
struct unrounded_roots {
  int count = 0;
  unrounded root[2]{};
  int exponent[2]{};
};

inline constexpr double last_double = (std::numeric_limits<double>::max)();

using cubic_coefficients = std::array<double, 4>;  // ascending: d, c, b, a

/// An interval in which the polynomial changes its sign once, from `left_sign` to its opposite.
struct sign_change {
  double low, high;
  int left_sign;
};

inline namespace IRG_ABI {

// The real roots of a quadratic equation in twice the precision, with the sign of the discriminant decided exactly.

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

// The real roots of a cubic equation. How many there are is decided by the exact sign of the discriminant; each root is
// found by Newton's iteration and then enclosed between two neighbouring numbers by exact signs of the polynomial.

/// The sign of b^2 c^2 - 4 a c^3 - 4 b^3 d + 18 a b c d - 27 a^2 d^2: 1 for three real roots, -1 for one, 0 for a
/// multiple one.
constexpr int cubic_discriminant_sign(const cubic_coefficients& p) noexcept {
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
constexpr int sign_at_inflection(const cubic_coefficients& p) noexcept {
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
constexpr double nearer_root(const cubic_coefficients& p, double x, double y) noexcept {
  return magnitude(evaluate_polynomial_accurate(p, y)) < magnitude(evaluate_polynomial_accurate(p, x)) ? y : x;
}

/// The root in the interval by halving it, in the order of doubles: 64 steps at most, whatever the polynomial.
/// gives   an infinity when the sign does not change before the end of the range
constexpr double root_by_halving(const cubic_coefficients& p, const sign_change& in) noexcept {
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
constexpr signed_value signed_value_at(const cubic_coefficients& p, double x) noexcept {
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
constexpr double root_near(const cubic_coefficients& p, const sign_change& in, double guess) noexcept {
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
constexpr double polished(const cubic_coefficients& p, double x, double last_step) noexcept {
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
constexpr double only_root_guess(const cubic_coefficients& p) noexcept {
  const double middle = -p[2] / (3 * p[3]);
  const auto [value, slope] = evaluate_polynomial_with_derivative(p, middle);
  const double level = value / p[3], fall = -slope / p[3];
  if (level == 0) return middle;
  // A third of the exponent: at most 6 % from the cube root.
  double radius = from_bits(bits_of(magnitude(level)) / 3 + 0x2a9f7893782da1ceu) * 1.07;
  if (fall > 0) radius = 1.324718 * maximum(radius, sqrt(fall));
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

constexpr bool is_moderate_cubic(const cubic_coefficients& p) noexcept {
  return is_within(p[0], 60) && is_within(p[1], 60) && is_within(p[2], 60) && is_within(p[3], 60);
}

/// needs   a polynomial with two extrema
constexpr cubic_shape cubic_shape_of(const cubic_coefficients& p) noexcept {
  const auto [d, c, b, a] = p;
  cubic_shape shape{0, 0, is_moderate_cubic(p)};
  const bool is_large = magnitude(a) > 0x1p1000 || magnitude(b) > 0x1p1000;
  const unrounded_roots at = shape.is_moderate ? solve_half<2>(two_sum(2 * a, a), b, c)
                             : is_large        ? solve_quadratic(0.75 * a, 0.5 * b, 0.25 * c)
                                               : solve_quadratic(3 * a, 2 * b, c);
  const double x = rounded_root(at, 0), y = at.count == 2 ? rounded_root(at, 1) : x;
  shape.low = clamped(minimum(x, y), -last_double, last_double);
  shape.high = clamped(maximum(x, y), -last_double, last_double);
  return shape;
}

/// The root in the interval that ends at the extremum `at`, `outwards` (1 or -1) of which it lies.
constexpr double root_beside(const cubic_coefficients& p, const cubic_shape& shape, const sign_change& in, double at,
                             double outwards) noexcept {
  if (!shape.is_moderate) return root_by_halving(p, in);
  // Around the extremum the polynomial is height + bend * s^2 + a * s^3.
  const double height = evaluate_polynomial_accurate(p, at);
  const double bend = product(3 * p[3], at) + p[2];
  const double square = bend == 0 ? 0 : -height / bend, distance = sqrt(square > 0 ? square : 0);
  return root_near(p, in, polished(p, at + outwards * distance, distance));
}

template <Floating T, int N>
constexpr void append_root(real_roots<T, N>& roots, double x, int multiplicity) noexcept {
  roots.root[roots.count] = narrowed<T>(x + 0.0);  // -0 becomes 0
  roots.multiplicity[roots.count++] = multiplicity;
  roots.kind = roots.count == 1 ? roots_kind::one : roots.count == 2 ? roots_kind::two : roots_kind::three;
}

template <Floating T>
IRG_INLINE constexpr real_roots<T, 2> two_real_roots(T x, T y, bool is_double) noexcept {
  if (is_double) return {roots_kind::one, 1, {x, T(0)}, {2, 0}};
  return {roots_kind::two, 2, {minimum(x, y), maximum(x, y)}, {1, 1}};
}

template <Floating T, int N>
constexpr real_roots<T, N> no_equation(roots_kind kind) noexcept {
  real_roots<T, N> roots;
  roots.kind = kind;
  return roots;
}

/// The root of b*x + c = 0.
template <Floating T, int N>
constexpr real_roots<T, N> linear_root(double b, double c) noexcept {
  if (b == 0) return no_equation<T, N>(c == 0 ? roots_kind::all : roots_kind::none);
  real_roots<T, N> roots;
  append_root(roots, far_quotient(-c, b), 1);
  roots.kind = roots_kind::linear;
  return roots;
}

template <Floating T, int N>
constexpr real_roots<T, N> roots_of_quadratic(double a, double b, double c) noexcept {
  if (a == 0) return linear_root<T, N>(b, c);
  real_roots<T, N> roots;
  const unrounded_roots found = solve_quadratic(a, b, c);
  if (found.count == 1) append_root(roots, rounded_root(found, 0), 2);
  if (found.count < 2) return roots;
  const double x = rounded_root(found, 0), y = rounded_root(found, 1);
  append_root(roots, minimum(x, y), 1);
  append_root(roots, maximum(x, y), 1);
  return roots;
}

/// The roots of x * (a*x^2 + b*x + c).
template <Floating T>
constexpr real_roots<T, 3> roots_with_zero(double a, double b, double c) noexcept {
  const auto others = roots_of_quadratic<double, 2>(a, b, c);
  real_roots<T, 3> roots;
  bool has_zero = false;
  for (int i = 0; i < others.count; ++i) {
    if (!has_zero && (c == 0 ? others.root[i] == 0 : others.root[i] > 0)) {
      has_zero = true;
      append_root(roots, 0, c == 0 ? others.multiplicity[i] + 1 : 1);
      if (c == 0) continue;
    }
    append_root(roots, others.root[i], others.multiplicity[i]);
  }
  if (!has_zero) append_root(roots, 0, 1);
  return roots;
}

/// needs   a and d not 0
template <Floating T>
constexpr real_roots<T, 3> roots_of_cubic(const cubic_coefficients& p) noexcept {
  real_roots<T, 3> roots;
  const int sign = p[3] < 0 ? -1 : 1, distinct = cubic_discriminant_sign(p);
  if (distinct < 0) {
    const sign_change everywhere{-last_double, last_double, -sign};
    append_root(roots,
                is_moderate_cubic(p) ? root_near(p, everywhere, polished(p, only_root_guess(p), infinity<double>))
                                     : root_by_halving(p, everywhere),
                1);
    return roots;
  }
  const int middle = distinct == 0 ? sign * sign_at_inflection(p) : 0;
  if (distinct == 0 && middle == 0) {
    // -b/3a, where 3a overflows or has a bit too many
    const scaled_number a = decompose(p[3]), b = decompose(p[2]);
    append_root(roots,
                placed(divide({-b.significand, 0}, two_sum(2 * a.significand, a.significand)), b.exponent - a.exponent),
                3);
    return roots;
  }
  const cubic_shape shape = cubic_shape_of(p);
  const sign_change left{-last_double, shape.low, -sign}, between{shape.low, shape.high, sign},
      right{shape.high, last_double, -sign};
  if (distinct == 0) {  // an extremum is the double root
    const double spread = shape.high * 0.5 - shape.low * 0.5;
    if (middle < 0) append_root(roots, shape.low, 2);
    append_root(roots,
                !shape.is_moderate ? root_by_halving(p, middle < 0 ? right : left)
                : middle < 0       ? root_near(p, right, polished(p, shape.high + spread, infinity<double>))
                                   : root_near(p, left, polished(p, shape.low - spread, infinity<double>)),
                1);
    if (middle > 0) append_root(roots, shape.high, 2);
    return roots;
  }
  // Two roots can be so near to each other that no number lies between them: then the extremum stands for both.
  const bool left_apart = polynomial_sign(p, shape.low) == sign, right_apart = polynomial_sign(p, shape.high) == -sign;
  append_root(roots, left_apart ? root_beside(p, shape, left, shape.low, -1) : shape.low, 1);
  if (!left_apart || !right_apart)
    append_root(roots, left_apart ? shape.high : shape.low, 1);
  else if (magnitude(evaluate_polynomial_accurate(p, shape.low)) <
           magnitude(evaluate_polynomial_accurate(p, shape.high)))
    append_root(roots, root_beside(p, shape, between, shape.low, 1), 1);
  else
    append_root(roots, root_beside(p, shape, between, shape.high, -1), 1);
  append_root(roots, right_apart ? root_beside(p, shape, right, shape.high, 1) : shape.high, 1);
  return roots;
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

template <Floating T>
[[nodiscard]] constexpr real_roots<T, 2> quadratic_roots(T a, T b, T c) noexcept {
  if (!is_finite(a) || !is_finite(b) || !is_finite(c)) return detail::no_equation<T, 2>(roots_kind::undefined);
  return detail::roots_of_quadratic<T, 2>(widened(a), widened(b), widened(c));
}

template <Floating T>
[[nodiscard]] constexpr real_roots<T, 2> quadratic_roots_fast(T a, T b, T c) noexcept {
  real_roots<T, 2> roots;
  // The products of floats are exact in double and within its range.
  const double p = widened(a), q = widened(b), r = widened(c);
  const double discriminant =
      std::is_same_v<T, float> ? product(q, q) - product(4 * p, r) : difference_of_products(q, q, 4 * p, r);
  if (!(discriminant >= 0)) return roots;
  const double root = sqrt(discriminant);
  const double sum = -0.5 * (q < 0 ? q - root : q + root);
  const double x = sum / p, y = sum == 0 ? 0 : r / sum;
  return detail::two_real_roots(narrowed<T>(x), narrowed<T>(y), discriminant == 0);
}

template <Floating T>
[[nodiscard]] constexpr real_roots<T, 3> cubic_roots(T a, T b, T c, T d) noexcept {
  const detail::cubic_coefficients p{widened(d), widened(c), widened(b), widened(a)};
  if (!detail::all_finite(4, [&](std::size_t i) { return p[i]; }))
    return detail::no_equation<T, 3>(roots_kind::undefined);
  if (a == 0) return detail::roots_of_quadratic<T, 3>(p[2], p[1], p[0]);
  return d == 0 ? detail::roots_with_zero<T>(p[3], p[2], p[1]) : detail::roots_of_cubic<T>(p);
}

}  // namespace IRG_ABI
}  // namespace irg
