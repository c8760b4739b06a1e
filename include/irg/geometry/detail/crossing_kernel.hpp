// SPDX-License-Identifier: MIT
// Where a line has a given coordinate, to twice the precision: one step of refinement from the textbook's formula, for
// one line or for the lanes of a pack. Only the sum of `guess` and `correction` means anything, and that to within a
// bound: fused instructions may serve where there are some.
#pragma once

#include <type_traits>

#include <irg/core/lanes.hpp>
#include <irg/math/error_free.hpp>

namespace irg::detail {

// A number or pack in two parts, value + error.
template <class F>
struct two_parts {
  F value, error;
};

inline namespace IRG_ABI {

// a - b exactly, as two_sum.
template <class F>
IRG_INLINE constexpr two_parts<F> parts_of_difference(const F& a, const F& b) noexcept {
  const F value = a - b, b_part = a - value, a_part = value + b_part;
  return {value, (a - a_part) + (b_part - b)};
}

// a*b + c, rounded once or twice.
template <class F>
IRG_INLINE constexpr F product_plus(const F& a, const F& b, const F& c) noexcept {
  if constexpr (has_fused_multiply_add)
    if (!std::is_constant_evaluated()) return fused_multiply_add(a, b, c);
  return product(a, b) + c;
}

// What c lacks of a*b, or has too much, nearly: a*b - c where c is about a*b.
template <class F>
IRG_INLINE constexpr F product_minus(const F& a, const F& b, const F& c) noexcept {
  if constexpr (has_fused_multiply_add)
    if (!std::is_constant_evaluated()) return fused_multiply_add(a, b, -c);
  const auto halves = [](const F& x) {
    const F scaled = product(x, lanes<F>::broadcast(134217729.0)), high = scaled - (scaled - x);  // 2^27 + 1
    return two_parts<F>{high, x - high};
  };
  const auto [a_high, a_low] = halves(a);
  const auto [b_high, b_low] = halves(b);
  const F value = product(a, b);
  return (value - c) + ((((product(a_high, b_high) - value) + product(a_high, b_low)) + product(a_low, b_high)) +
                        product(a_low, b_low));
}

// guess + correction is the crossing to within 2^-98 of |way| and 2^-52 of |correction|; guess is within some ulp of
// way and of the crossing.
template <class F>
struct crossing_parts {
  F guess, correction, way, first_product;
};

// From the line's end with the other coordinate y: dx and dy lead to its other end, s to the crossing, along x. No step
// may overflow, and |dy*s| is above 2^-600 or dy is zero; else the result means nothing.
template <class F>
IRG_INLINE constexpr crossing_parts<F> refined_crossing(const F& y, const two_parts<F>& dx, const two_parts<F>& dy,
                                                        const two_parts<F>& s) noexcept {
  const F inverse = lanes<F>::broadcast(1) / dx.value;
  const F wanted = product(dy.value, s.value), way = product(wanted, inverse);
  const F guess = y + way, way_part = guess - y, y_part = guess - way_part;
  const F lost = (y - y_part) + (way - way_part);
  // dy*s - way*dx: the heads nearly cancel, the remainder is small.
  const F remainder =
      product_plus(dy.error, s.value, product_plus(dy.value, s.error, product_minus(dy.value, s.value, wanted)));
  const F rest = (remainder - product(way, dx.error)) - product_minus(way, dx.value, wanted);
  return {guess, product_plus(rest, inverse, lost), way, wanted};
}

}  // namespace IRG_ABI
}  // namespace irg::detail
