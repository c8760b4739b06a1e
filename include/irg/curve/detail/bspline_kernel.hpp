// SPDX-License-Identifier: MIT
// Private to the chapter: the sums and shares that B-splines are made of, in registers where points fill one.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <optional>
#include <span>
#include <type_traits>

#include <irg/core/lane_masks.hpp>
#include <irg/core/lanes.hpp>
#include <irg/core/ring.hpp>
#include <irg/curve/bezier.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/homogeneous.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

// Adds to the largest value what the sum of all lacks of 1. Of numbers, or of packs lane by lane.
template <class V>
constexpr void make_sum_one(V& value) noexcept {
  using F = std::remove_cvref_t<decltype(value[0])>;
  const auto index = [](std::size_t i) {
    if constexpr (std::is_arithmetic_v<F>)
      return i;
    else
      return lanes<F>::broadcast(static_cast<typename lanes<F>::scalar>(static_cast<std::ptrdiff_t>(i)));
  };
  const F zero = lanes<F>::broadcast(0);
  F sum = value[0], error = zero, most = value[0];
  auto largest = index(0);
  for (std::size_t i = 1; i < value.size(); ++i) {
    const F next = value[i], s = sum + next, part = s - sum;  // two_sum
    error = error + ((sum - (s - part)) + (next - part));
    sum = s;
    largest = select(most < next, index(i), largest);  // no jumps: which one it is changes from place to place
    most = high_of(most, next);
  }
  const F lacking = (lanes<F>::broadcast(1) - sum) - error;
  for (std::size_t i = 0; i < value.size(); ++i) value[i] = value[i] + select(largest == index(i), lacking, zero);
}

// How t divides the stretch between two knots: what is right of it and what is left, of 1. The greater part is what the
// lesser one leaves.
template <class F>
struct stretch_shares {
  F rest, t;
};
template <class F>
IRG_INLINE constexpr stretch_shares<F> shares_of_stretch(const F& from, const F& to, const F& t) noexcept {
  const F right = to - t, left = t - from;
  const auto distant = right < left;  // no jumps here either
  const F less = select(distant, right, left) / (to - from), more = lanes<F>::broadcast(1) - less;
  return {select(distant, less, more), select(distant, more, less)};
}
template <Floating T>
IRG_INLINE constexpr curve_parameter<T> share_of_stretch(const T& from, const T& to, const T& t) noexcept {
  const auto shares = shares_of_stretch(from, to, t);
  return {shares.rest, shares.t};
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
// functions, at successive knots of a refined list the coefficients of a refined control point. Of numbers, or of packs
// lane by lane.
template <class V, class Knot, class Place>
constexpr void fill_bspline_values(V& value, const Knot& knot, std::size_t low, const Place& place) noexcept {
  using F = std::remove_cvref_t<decltype(value[0])>;
  const F zero = lanes<F>::broadcast(0);
  value[0] = lanes<F>::broadcast(1);
  for (std::size_t k = 1; k < value.size(); ++k) {
    F carried = zero;
    for (std::size_t r = 0; r < k; ++r) {
      const F before = value[r];
      const auto none = before == zero;  // its share may be any number then
      if constexpr (std::is_same_v<decltype(none), const bool>)
        if (none) {
          value[r] = carried;
          carried = zero;
          continue;
        }
      const auto share = shares_of_stretch<F>(knot(low + r + 1 - k), knot(low + r + 1), place(k));
      value[r] = carried + select(none, zero, product(before, share.rest));
      carried = select(none, zero, product(before, share.t));
    }
    value[k] = carried;
  }
  make_sum_one(value);
}

// Two bases at a place each, `u` and `v` beginning with the first knot that counts; of one degree side by side.
template <Floating T, std::size_t U, std::size_t V>
constexpr void fill_two_bases(std::array<T, U>& value_u, std::span<const T> u, T at_u, std::array<T, V>& value_v,
                              std::span<const T> v, T at_v) noexcept {
  if constexpr (U == V && has_lanes && std::is_same_v<T, double>)
    if (!std::is_constant_evaluated()) {
      using F = pack<T, 2>;
      const F at = pack_of(at_u, at_v);
      std::array<F, U> value;
      fill_bspline_values(
          value, [&](std::size_t i) { return pack_of(u[i], v[i]); }, U - 1, [&](std::size_t) { return at; });
      for (std::size_t i = 0; i < U; ++i) {
        value_u[i] = lane(value[i], 0);
        value_v[i] = lane(value[i], 1);
      }
      return;
    }
  fill_bspline_values(value_u, [&](std::size_t i) { return u[i]; }, U - 1, [&](std::size_t) { return at_u; });
  fill_bspline_values(value_v, [&](std::size_t i) { return v[i]; }, V - 1, [&](std::size_t) { return at_v; });
}

// Points that fill a register.
template <class P>
inline constexpr bool fills_lanes = has_lanes && std::is_trivially_copyable_v<P> && size_of<P> == 4 &&
                                    sizeof(P) == 4 * sizeof(scalar_of<P>) && Floating<scalar_of<P>>;

// The sum of at(i), each times its value, in registers.
template <class V, class At>
IRG_INLINE auto lanes_of_multiples(const V& value, const At& at) noexcept {
  using F = std::remove_cvref_t<decltype(at(std::size_t{}))>;
  F sum = lanes<F>::broadcast(0);
  for (std::size_t i = 0; i < value.size(); ++i) sum = sum + lanes<F>::broadcast(value[i]) * at(i);
  return sum;
}
template <class P>
IRG_INLINE pack<scalar_of<P>, 4> lanes_of(const P& p) noexcept {
  return lanes<pack<scalar_of<P>, 4>>::load_bytes(&p);
}
template <class P>
IRG_INLINE P point_of(const pack<scalar_of<P>, 4>& sum) noexcept {
  std::array<scalar_of<P>, 4> result;
  lanes<pack<scalar_of<P>, 4>>::store(result.data(), sum);
  return std::bit_cast<P>(result);
}

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
      return point_of<P>(sum);
    }
  }
  return generate_coordinates<P>([&](int axis) {
    T sum = 0;
    for (std::size_t i = 0; i < value.size(); ++i)
      if (value[i] != T(0)) sum = sum + product(value[i], coordinate(at(i), axis));
    return sum;
  });
}

// The sum of row(i)[j], each times its two values; in registers all of them, as long as none is infinite.
template <class U, class V, class Row>
IRG_INLINE constexpr auto sum_of_rows(const U& u, const V& v, const Row& row) noexcept {
  using P = std::remove_cvref_t<decltype(row(0)[0])>;
  if constexpr (fills_lanes<P>)
    if (!std::is_constant_evaluated()) {
      const auto sum = lanes_of_multiples(u, [&](std::size_t i) {
        return lanes_of_multiples(v, [at = row(i)](std::size_t j) { return lanes_of(at[j]); });
      });
      if (all_lanes(sum - sum == lanes<pack<scalar_of<P>, 4>>::broadcast(0))) return point_of<P>(sum);
    }
  return sum_of_multiples(
      u, [&](std::size_t i) { return sum_of_multiples(v, [at = row(i)](std::size_t j) { return at[j]; }); });
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
