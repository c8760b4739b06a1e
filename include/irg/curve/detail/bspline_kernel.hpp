// SPDX-License-Identifier: MIT
// Private to the chapter: the sums and shares that B-splines are made of, in registers where points fill one.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <optional>
#include <type_traits>

#include <irg/core/lanes.hpp>
#include <irg/core/ring.hpp>
#include <irg/curve/bezier.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/homogeneous.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

// Adds to the largest value what the sum of all lacks of 1.
template <class V>
constexpr void make_sum_one(V& value) noexcept {
  using T = std::remove_cvref_t<decltype(value[0])>;
  T sum = value[0], error = sum - sum, most = value[0];
  std::size_t largest = 0;
  for (std::size_t i = 1; i < value.size(); ++i) {
    const auto s = two_sum(sum, value[i]);
    sum = s.value;
    error = error + s.error;
    const bool is_more = most < value[i];  // no jumps: which one it is changes from place to place
    most = greater(most, value[i]);
    largest = is_more ? i : largest;
  }
  const T lacking = (T(1) - sum) - error;
  for (std::size_t i = 0; i < value.size(); ++i) value[i] = value[i] + (i == largest ? lacking : T(0));
}

// How t divides the stretch between two knots: what is right of it and what is left, of 1. The greater part is what the
// lesser one leaves.
template <Floating T>
IRG_INLINE constexpr curve_parameter<T> share_of_stretch(const T& from, const T& to, const T& t) noexcept {
  const T right = to - t, left = t - from;
  const bool distant = right < left;  // no jumps here either
  const T less = (distant ? right : left) / (to - from), more = T(1) - less;
  return {distant ? less : more, distant ? more : less};
}

// The greatest `low` of [low, high) with u(low) <= t.
// needs   u(low) <= t < u(high)
template <class Knots, Floating T>
constexpr std::size_t stretch_between(const Knots& u, std::size_t low, std::size_t high, T t) noexcept {
  // Evenly spaced knots are found at once.
  const auto guess = low + static_cast<std::size_t>((t - u[low]) / (u[high] - u[low]) *
                                                    static_cast<T>(static_cast<std::ptrdiff_t>(high - low)));
  if (guess < high && u[guess] <= t && t < u[guess + 1]) return guess;
  for (std::size_t n = high - low; n > 1;) {
    const std::size_t half = n / 2;
    low = u[low + half] <= t ? low + half : low;
    n -= half;
  }
  return low;
}

// Cox's and de Boor's recursion in the stretch from knot(low) on, each level at a place of its own: at one t the basis
// functions, at successive knots of a refined list the coefficients of a refined control point.
template <class V, class Knot, class Place>
constexpr void fill_bspline_values(V& value, const Knot& knot, std::size_t low, const Place& place) noexcept {
  using T = std::remove_cvref_t<decltype(value[0])>;
  value[0] = T(1);
  for (std::size_t k = 1; k < value.size(); ++k) {
    T carried = 0;
    for (std::size_t r = 0; r < k; ++r) {
      if (value[r] == T(0)) {  // its share may be any number then
        value[r] = carried;
        carried = 0;
        continue;
      }
      const auto share = share_of_stretch<T>(knot(low + r + 1 - k), knot(low + r + 1), place(k));
      const T before = value[r];
      value[r] = carried + product(before, share.rest);
      carried = product(before, share.t);
    }
    value[k] = carried;
  }
  make_sum_one(value);
}

// Points that fill a register.
template <class P>
inline constexpr bool fills_lanes = has_lanes && std::is_trivially_copyable_v<P> && size_of<P> == 4 &&
                                    sizeof(P) == 4 * sizeof(scalar_of<P>) && Floating<scalar_of<P>>;

// The sum of at(i), each times its value. Those of value 0 do not count, whatever they are: an end point is the control
// point itself.
template <class V, class At>
IRG_INLINE constexpr auto sum_of_multiples(const V& value, const At& at) noexcept {
  using P = std::remove_cvref_t<decltype(at(std::size_t{}))>;
  using T = scalar_of<P>;
  if constexpr (fills_lanes<P>) {
    if (!std::is_constant_evaluated()) {
      using F = pack<T, 4>;
      F sum = lanes<F>::broadcast(0);
      for (std::size_t i = 0; i < value.size(); ++i) {
        if (value[i] == T(0)) continue;
        const auto coordinates = std::bit_cast<std::array<T, 4>>(at(i));
        sum = sum + lanes<F>::broadcast(value[i]) * lanes<F>::load(coordinates.data());
      }
      std::array<T, 4> result;
      lanes<F>::store(result.data(), sum);
      return std::bit_cast<P>(result);
    }
  }
  return generate_coordinates<P>([&](int axis) {
    T sum = 0;
    for (std::size_t i = 0; i < value.size(); ++i)
      if (value[i] != T(0)) sum = sum + product(value[i], coordinate(at(i), axis));
    return sum;
  });
}

template <class V, PolygonRing R>
constexpr ring_point<R> blend_points(const V& value, std::size_t first, const R& points) noexcept {
  return sum_of_multiples(value, [&](std::size_t i) { return ring_vertex(points, first + i); });
}

// try_to_cartesian, whose exceptions are looked for only where a quotient is not finite.
template <Floating T, int N>
IRG_INLINE constexpr std::optional<point<T, N>> cartesian_of(const hpoint<T, N>& p) noexcept {
  if (std::is_constant_evaluated()) return try_to_cartesian(p);
  const point<T, N> q = generate_coordinates<point<T, N>>([&](int i) { return p[i] / p[N]; });
  T none = p[N] - p[N];
  for (int i = 0; i < N; ++i) none = none + (q[i] - q[i]);
  return none == T(0) ? std::optional(q) : try_to_cartesian(p);
}

}  // namespace IRG_ABI
}  // namespace irg::detail
