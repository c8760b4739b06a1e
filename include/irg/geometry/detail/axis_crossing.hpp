// SPDX-License-Identifier: MIT
// Where the line through two points has a given first coordinate: the second coordinate, correctly rounded. The result
// is defined by the exact value alone, so it does not depend on which end comes first nor on the algorithm that asks,
// and it never leaves an interval that the exact value lies in.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <irg/core/conversion.hpp>
#include <irg/geometry/detail/crossing_kernel.hpp>
#include <irg/math/int128.hpp>
#if IRG_BODIES
#include <irg/math/exact/nearest_float.hpp>
#include <irg/math/exact_sum.hpp>
#endif

namespace irg::detail::inline IRG_COMPILED_ABI {

// By integers, for every finite input.
template <Floating T>
IRG_API T axis_crossing_exact(T ax, T ay, T bx, T by, T x) noexcept;
// Where axis_crossing_from does not tell.
template <Floating T>
  requires std::same_as<T, double>
IRG_API T axis_crossing_in_doubt(T ax, T ay, T bx, T by, T x) noexcept;

}  // namespace irg::detail::inline IRG_COMPILED_ABI

namespace irg::detail::inline IRG_ABI {

template <std::same_as<float> T>
IRG_INLINE constexpr T axis_crossing_of(T ax, T ay, T bx, T by, T x) noexcept {
  const auto wide = [](float v) { return widened(v); };
  const double part = (wide(x) - wide(ax)) / (wide(bx) - wide(ax));
  const double way = product(wide(by) - wide(ay), part), y = wide(ay) + way;
  const double bound = product(0x1p-50, magnitude(y) + magnitude(way));
  const float low = converted<float>(y - bound), high = converted<float>(y + bound);
  return low == high ? low : axis_crossing_exact(ax, ay, bx, by, x);
}

// One step of refinement from the textbook's formula gives some 98 bits; true where these decide how to round. Numbers
// are below 2^200 and the first product is above 2^-600, so that nothing overflows, and what underflows is too small to
// count.
IRG_INLINE constexpr bool axis_crossing_from(double ax, double ay, double bx, double by, double x, double& y) noexcept {
  const double largest =
      maximum(maximum(maximum(magnitude(ax), magnitude(bx)), magnitude(x)), maximum(magnitude(ay), magnitude(by)));
  if (!(largest < 0x1p200 && magnitude(bx - ax) > 0x1p-800)) return false;
  const auto found =
      refined_crossing(ay, parts_of_difference(bx, ax), parts_of_difference(by, ay), parts_of_difference(x, ax));
  const double bound = product(0x1p-51, magnitude(found.correction)) + product(0x1p-98, magnitude(found.way));
  const double low = found.guess + (found.correction - bound), high = found.guess + (found.correction + bound);
  y = low + 0.0;
  return low == high && (magnitude(found.first_product) > 0x1p-600 || ay == by);
}

template <std::same_as<double> T>
IRG_INLINE constexpr T axis_crossing_of(T ax, T ay, T bx, T by, T x) noexcept {
  double y = 0;
  return axis_crossing_from(ax, ay, bx, by, x, y) ? y : axis_crossing_in_doubt(ax, ay, bx, by, x);
}

// Rounded to the nearest integer, halves up.
template <class T>
  requires std::is_integral_v<T>
constexpr T axis_crossing_of(T ax, T ay, T bx, T by, T x) noexcept {
  using U = std::uint64_t;
  const auto distance = [](T p, T q) {
    return p < q ? static_cast<U>(q) - static_cast<U>(p) : static_cast<U>(p) - static_cast<U>(q);
  };
  const U width = distance(ax, bx);
  const uint128 way = uint128{distance(ay, by)} * distance(ax, x);
  const U whole = static_cast<U>(way / width), rest = static_cast<U>(way % width);
  const bool rises = ay<by, half_or_more = rest >= width - rest, more_than_half = rest> width - rest;
  const U steps = whole + static_cast<U>(rises ? half_or_more : more_than_half);
  return static_cast<T>(rises ? static_cast<U>(ay) + steps : static_cast<U>(ay) - steps);
}

// Numbers of the user's own are as exact as their arithmetic.
template <class T>
  requires(!std::is_integral_v<T> && !Floating<T>)
constexpr T axis_crossing_of(const T& ax, const T& ay, const T& bx, const T& by, const T& x) {
  return ay + (by - ay) * (x - ax) / (bx - ax);
}

// The parameter of a cut: a number of the coordinates' type, a double for integers.
template <class T>
using cut_parameter = std::conditional_t<std::is_integral_v<T>, double, T>;

// (x - a)/(b - a) for x between a and b: the differences and the quotient are rounded once each.
template <class T>
constexpr cut_parameter<T> parameter_of(const T& a, const T& b, const T& x) noexcept {
  if constexpr (std::is_integral_v<T>) {
    using U = std::uint64_t;
    const U part = a < b ? static_cast<U>(x) - static_cast<U>(a) : static_cast<U>(a) - static_cast<U>(x);
    const U all = a < b ? static_cast<U>(b) - static_cast<U>(a) : static_cast<U>(a) - static_cast<U>(b);
    return static_cast<double>(part) / static_cast<double>(all);
  } else {
    if constexpr (Floating<T>) {
      constexpr T large = (std::numeric_limits<T>::max)() / 2;
      if (magnitude(a) > large || magnitude(b) > large) return (x / 2 - a / 2) / (b / 2 - a / 2);
    }
    return (x - a) / (b - a);
  }
}

}  // namespace irg::detail::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_NOINLINE IRG_API T axis_crossing_exact(T ax, T ay, T bx, T by, T x) noexcept {
  if (ay == by) return ay + T(0);
  const auto wide = [](T v) { return widened(v); };
  const double x1 = wide(ax), y1 = wide(ay), x2 = wide(bx), y2 = wide(by), at = wide(x);
  exact_accumulator<2> above, below;  // y = (y1*(x2 - x) + y2*(x - x1))/(x2 - x1)
  above.add(y1, x2), above.subtract(y1, at), above.add(y2, at), above.subtract(y2, x1);
  below.add(x2), below.subtract(x1);
  if (above.sign() == 0) return T(0);
  const int up = above.exponent(), down = below.exponent();
  double guess = above.rounded(-up) / below.rounded(-down);
  for (int k = minimum(up - down, 1000); k != 0;) {
    const int part = maximum(k, -1000);
    guess *= power_of_two(part), k -= part;
  }
  const auto side = [&](T p, T q) {
    exact_accumulator<2> sum = above;
    sum.add(y1, x2), sum.subtract(y1, at), sum.add(y2, at), sum.subtract(y2, x1);
    sum.subtract(wide(p), x2), sum.add(wide(p), x1);
    sum.subtract(wide(q), x2), sum.add(wide(q), x1);
    return below.sign() * sum.sign();
  };
  return nearest_by_sign(minimum(ay, by), maximum(ay, by), converted<T>(guess), side);
}

// Where the first end is far away, its coordinate and the way from it nearly cancel: the other end may do. Numbers near
// the end of the range are made smaller, if none of them loses a bit.
template <Floating T>
  requires std::same_as<T, double>
IRG_NOINLINE IRG_API T axis_crossing_in_doubt(T ax, T ay, T bx, T by, T x) noexcept {
  double y = 0;
  if (axis_crossing_from(bx, by, ax, ay, x, y)) return y;
  const auto fits = [](double v) { return v == 0 || magnitude(v) > 0x1p-100; };
  if (fits(ax) && fits(ay) && fits(bx) && fits(by) && fits(x)) {
    constexpr double s = 0x1p-900;
    if (axis_crossing_from(ax * s, ay * s, bx * s, by * s, x * s, y) ||
        axis_crossing_from(bx * s, by * s, ax * s, ay * s, x * s, y))
      return y * 0x1p900;
  }
  return axis_crossing_exact(ax, ay, bx, by, x);
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
