// SPDX-License-Identifier: MIT
// Private to the chapter: Horner's scheme for Bezier curves whose control points are multiplied by their binomials, for
// one point with its coordinates side by side in a register, and for many points.
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>

#include <irg/core/interleaved_lanes.hpp>
#include <irg/core/lane_masks.hpp>
#include <irg/core/lanes.hpp>
#include <irg/curve/bezier.hpp>
#include <irg/math/error_free.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

// The product of numbers or packs; these guard their own operator *.
template <class F>
IRG_INLINE constexpr F times(const F& a, const F& b) noexcept {
  if constexpr (std::is_floating_point_v<F>)
    return product(a, b);
  else
    return a * b;
}

// What rounding took from p, the product of a and b: of numbers or packs, by Dekker's splitting where nothing is fused.
template <class F>
IRG_INLINE constexpr F rest_of_product(const F& a, const F& b, const F& p) noexcept {
  using T = std::remove_cvref_t<decltype(lane(a, 0))>;
  if constexpr (has_fused_multiply_add && std::is_same_v<T, double>)
    if (!std::is_constant_evaluated()) return fused_multiply_add(a, b, -p);
  const F factor = lanes<F>::broadcast(std::is_same_v<T, double> ? T(134217729) : T(4097));  // 2^27 + 1, 2^12 + 1
  const F scaled_a = times(factor, a), scaled_b = times(factor, b);
  const F high_a = scaled_a - (scaled_a - a), high_b = scaled_b - (scaled_b - b);
  const F low_a = a - high_a, low_b = b - high_b;
  return (((times(high_a, high_b) - p) + times(high_a, low_b)) + times(low_a, high_b)) + times(low_a, low_b);
}

// (x + rest)^n by squares, as if in twice the precision.
template <class F>
IRG_INLINE constexpr F to_the_power(const F& base, const F& rest_of_base, std::size_t n) noexcept {
  F x = base, rest = rest_of_base;
  const auto square = [&] {
    const F x2 = times(x, x), across = times(x, rest);
    rest = rest_of_product(x, x, x2) + (across + across);
    x = x2;
  };
  if (n == 0) return lanes<F>::broadcast(1);
  for (; n % 2 == 0; n /= 2) square();
  F power = x, off = rest;
  for (n /= 2; n > 0; n /= 2) {
    square();
    if (n % 2 == 0) continue;
    const F next = times(power, x);
    off = rest_of_product(power, x, next) + (times(power, rest) + times(off, x));
    power = next;
  }
  return power + off;
}

// What side lacks of 1 / (1 + ratio), so that ratio and side belong to one place of the curve, next to the one asked
// for: otherwise what rounding took from the ratio would count as often as the degree says.
template <class F>
IRG_INLINE constexpr F rest_for_ratio(const F& side, const F& rest, const F& other, const F& ratio) noexcept {
  const F back = times(ratio, side);
  const F off = ((other - back) - rest_of_product(ratio, side, back)) - times(ratio, rest);
  return rest + times(side, off);
}

// t and 1 - t: the greater one with what rounding took from it, and the other.
template <class T>
struct curve_side {
  T side, rest, other;
  bool distant;
};
template <Floating T>
IRG_INLINE constexpr curve_side<T> side_of(T t) noexcept {
  const exact_sum<T> back = two_sum(T(1), -t);
  const bool distant = back.value < t;
  return {distant ? t : back.value, distant ? T(0) : back.error, distant ? back.value : t, distant};
}

// (a_0 + a_1 r + ... + a_n r^n) * side^n for r = other / side.
template <class F, class Coefficient>
IRG_INLINE constexpr F horner_of_side(std::size_t n, const F& ratio, const F& power,
                                      const Coefficient& coefficient) noexcept {
  F sum = coefficient(n);
  for (std::size_t i = n; i-- > 0;) sum = times(sum, ratio) + coefficient(i);
  return times(sum, power);
}

template <Coordinates P, class Curve>
constexpr P prepared_point_plain(const Curve& curve, scalar_of<P> t) noexcept {
  using T = scalar_of<P>;
  const std::size_t n = curve.degree();
  const auto [side, rest, other, is_far] = side_of(t);
  const T ratio = other / side, power = to_the_power(side, rest_for_ratio(side, rest, other, ratio), n);
  const bool distant = is_far;
  return generate_coordinates<P>([&](int axis) {
    return horner_of_side(n, ratio, power, [&](std::size_t i) {
      return curve.rows[(distant ? n - i : i) * Curve::width + static_cast<std::size_t>(axis)];
    });
  });
}

// The coordinates of one point side by side.
template <Coordinates P, class Curve>
IRG_INLINE P prepared_point_in_lanes(const Curve& curve, scalar_of<P> t) noexcept {
  using T = scalar_of<P>;
  constexpr int width = static_cast<int>(Curve::width);
  using F = pack<T, width>;
  const std::size_t n = curve.degree();
  const auto at = side_of(t);
  const auto distant = static_cast<std::ptrdiff_t>(at.distant);  // no jump: places at random are near and far by turns
  const T* row = curve.rows.data() + (1 - distant) * static_cast<std::ptrdiff_t>(n) * width;
  const std::ptrdiff_t step = (2 * distant - 1) * width;
  const T ratio = at.other / at.side;
  const F r = lanes<F>::broadcast(ratio);
  F sum = lanes<F>::load(row);
  for (std::size_t i = 0; i < n; ++i) {
    row += step;
    sum = times(sum, r) + lanes<F>::load(row);
  }
  sum = times(sum, lanes<F>::broadcast(to_the_power(at.side, rest_for_ratio(at.side, at.rest, at.other, ratio), n)));
  return generate_coordinates<P>([&](int axis) { return lane(sum, axis); });
}

// Writes a pack of points, given by coordinates.
template <class F, Coordinates P>
IRG_INLINE void put_points(const F (&sum)[static_cast<std::size_t>(size_of<P>)], P* points) noexcept {
  using T = scalar_of<P>;
  if constexpr (size_of<P> == 3 && sizeof(P) == 3 * sizeof(T) && std::is_trivially_copyable_v<P> &&
                std::is_standard_layout_v<P>)
    store_triples(reinterpret_cast<T*>(points), triple_lanes<T, lanes<F>::count>{sum[0], sum[1], sum[2]});
  else
    for (std::size_t i = 0; i < static_cast<std::size_t>(lanes<F>::count); ++i)
      points[i] = generate_coordinates<P>(
          [&](int axis) { return lane(sum[static_cast<std::size_t>(axis)], static_cast<int>(i)); });
}

// How many packs of points are under way at once: one waits for its own last product at each step.
inline constexpr std::size_t packs_together = 2;

// Points on the side of 0 or of 1, packs_together packs of them.
template <class F, Coordinates P, class Curve>
IRG_INLINE void prepared_points_in_lanes(const Curve& curve, const scalar_of<P>* t, bool distant, P* points) noexcept {
  using T = scalar_of<P>;
  constexpr std::size_t width = Curve::width, axes = static_cast<std::size_t>(size_of<P>);
  constexpr std::size_t count = static_cast<std::size_t>(lanes<F>::count);
  const std::size_t n = curve.degree();
  const F one = lanes<F>::broadcast(1);
  F ratio[packs_together], power[packs_together], sum[packs_together][axes];
  const T* row = curve.rows.data() + (distant ? 0 : n * width);
  for (std::size_t g = 0; g < packs_together; ++g) {
    const F at = lanes<F>::load(t + g * count), back = one - at;
    const F of_t = back - one, rest = (one - (back - of_t)) + ((-at) - of_t);  // two_sum of 1 and -t
    const F side = distant ? at : back, other = distant ? back : at, lost = distant ? lanes<F>::broadcast(0) : rest;
    ratio[g] = other / side;
    power[g] = to_the_power(side, rest_for_ratio(side, lost, other, ratio[g]), n);
    for (std::size_t axis = 0; axis < axes; ++axis) sum[g][axis] = lanes<F>::broadcast(row[axis]);
  }
  for (std::size_t i = 0; i < n; ++i) {
    row += distant ? static_cast<std::ptrdiff_t>(width) : -static_cast<std::ptrdiff_t>(width);
    for (std::size_t axis = 0; axis < axes; ++axis) {
      const F c = lanes<F>::broadcast(row[axis]);
      for (std::size_t g = 0; g < packs_together; ++g) sum[g][axis] = times(sum[g][axis], ratio[g]) + c;
    }
  }
  for (std::size_t g = 0; g < packs_together; ++g) {
    for (std::size_t axis = 0; axis < axes; ++axis) sum[g][axis] = times(sum[g][axis], power[g]);
    put_points<F>(sum[g], points + g * count);
  }
}

template <Coordinates P, class Curve>
IRG_INLINE constexpr P prepared_point(const Curve& curve, scalar_of<P> t) noexcept {
  if (!has_lanes || std::is_constant_evaluated()) return prepared_point_plain<P>(curve, t);
  return prepared_point_in_lanes<P>(curve, t);
}

template <Coordinates P, class Curve>
constexpr void prepared_points(const Curve& curve, std::span<const scalar_of<P>> t, std::span<P> points) noexcept {
  using T = scalar_of<P>;
  std::size_t k = 0;
  if (has_lanes && !std::is_constant_evaluated()) {
    using F = pack<T, widest_lanes<T>>;
    constexpr std::size_t count = packs_together * static_cast<std::size_t>(widest_lanes<T>);
    for (; k + count <= t.size(); k += count) {
      bool all_far = true, all_near = true;
      for (std::size_t g = 0; g < count; g += static_cast<std::size_t>(lanes<F>::count)) {
        const F at = lanes<F>::load(&t[k + g]);
        const auto is_far = lanes<F>::broadcast(1) - at < at;
        all_far = all_far && all_lanes(is_far);
        all_near = all_near && no_lane(is_far);
      }
      if (all_far || all_near)
        prepared_points_in_lanes<F, P>(curve, &t[k], all_far, &points[k]);
      else
        for (std::size_t i = k; i < k + count; ++i) points[i] = prepared_point_in_lanes<P>(curve, t[i]);
    }
  }
  for (; k < t.size(); ++k) points[k] = prepared_point<P>(curve, t[k]);
}

}  // namespace IRG_ABI
}  // namespace irg::detail
