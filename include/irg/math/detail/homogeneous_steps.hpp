// SPDX-License-Identifier: MIT
// The steps of homogeneous.hpp.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include <irg/core/conversion.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/vec.hpp>
#include <irg/math/wide_int.hpp>

namespace irg::detail::inline IRG_ABI {

// a*b as value + error times 2^exponent, which is one way to write it: 1 <= |value| < 2.
struct normalized_product {
  double value, error;
  int exponent;
  constexpr bool operator==(const normalized_product&) const = default;
};
constexpr normalized_product normalized_product_of(double a, double b) noexcept {
  const scaled_number x = decompose(a), y = decompose(b);
  const auto p = fast_two_product(x.significand, y.significand);
  const int up = magnitude(p.value) >= 2 ? (magnitude(p.value) >= 4 ? 2 : 1) : 0;
  const double back = power_of_two(-up);
  return {p.value * back, p.error * back, x.exponent + y.exponent + up};
}

// Whether a*b == c*d.
template <class T>
constexpr bool products_equal(const T& a, const T& b, const T& c, const T& d) noexcept {
  if constexpr (std::same_as<T, float>) {
    return widened(a) * widened(b) == widened(c) * widened(d);
  } else if constexpr (std::same_as<T, double>) {
    if (a == 0 || b == 0 || c == 0 || d == 0) return (a == 0 || b == 0) == (c == 0 || d == 0);
    return normalized_product_of(a, b) == normalized_product_of(c, d);
  } else if constexpr (std::integral<T> && sizeof(T) == 8) {
    return wide_int<2>(a) * wide_int<2>(b) == wide_int<2>(c) * wide_int<2>(d);
  } else if constexpr (std::integral<T>) {
    using W = std::conditional_t<std::is_signed_v<T>, std::int64_t, std::uint64_t>;
    return W{a} * W{b} == W{c} * W{d};
  } else {
    return a * b == c * d;
  }
}

}  // namespace irg::detail::inline IRG_ABI
