// SPDX-License-Identifier: MIT
// Homogeneous coordinates (h x, h y, h), h not 0, of a position (x, y): what are multiples of each other is the same
// position. Weight 0 is a direction; all zero is nothing and is refused.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include <irg/core/conversion.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/exact/scaled_double_double.hpp>
#include <irg/math/vec.hpp>
#include <irg/math/wide_int.hpp>

namespace irg {

/// What homogeneous coordinates stand for: a position, a direction (the point at infinity of all lines along it), or
/// nothing, all of them being 0 or one being NaN or infinite.
enum class homogeneous_kind { position, direction, nothing };

inline namespace IRG_ABI {

/// What the coordinates stand for.
template <class T, int N>
[[nodiscard]] constexpr homogeneous_kind homogeneous_kind_of(const hpoint<T, N>& p) noexcept {
  bool all_zero = true;
  for (int i = 0; i <= N; ++i) {
    if constexpr (Floating<T>)
      if (!is_finite(p[i])) return homogeneous_kind::nothing;
    all_zero = all_zero && p[i] == T(0);
  }
  if (all_zero) return homogeneous_kind::nothing;
  return p[N] == T(0) ? homogeneous_kind::direction : homogeneous_kind::position;
}

/// Whether two homogeneous points are the same up to a factor: the same position, or directions along the same line,
/// be it opposite ones.
/// gives   false when one is nothing (all zero, NaN, infinite)
/// exact   for all finite floats, all integers and rationals: the products across are compared exactly
template <class T, int N>
[[nodiscard]] constexpr bool same_position(const hpoint<T, N>& p, const hpoint<T, N>& q) noexcept;

/// The homogeneous form of p of weight h: h times its coordinates, then h.
/// needs   h != 0
/// exact   each product rounded once; exact for powers of two
template <class T, int N>
[[nodiscard]] IRG_INLINE constexpr hpoint<T, N> to_homogeneous(const point<T, N>& p,
                                                               std::type_identity_t<T> h) noexcept {
  IRG_EXPECTS(h != T(0));
  return generate_coordinates<hpoint<T, N>>([&](int i) { return i < N ? product(p[i], h) : h; });
}

/// The direction of v as a point at infinity, of weight 0.
template <class T, int N>
[[nodiscard]] IRG_INLINE constexpr hpoint<T, N> to_homogeneous(const vec<T, N>& v) noexcept {
  return generate_coordinates<hpoint<T, N>>([&](int i) { return i < N ? v[i] : T(0); });
}

/// The position that p stands for: its coordinates over its weight.
/// gives   nothing for a direction, for all zero, for NaN and infinity, and when a coordinate is too large for T
/// exact   each quotient rounded once
template <Real T, int N>
[[nodiscard]] constexpr std::optional<point<T, N>> try_to_cartesian(const hpoint<T, N>& p) noexcept {
  if (homogeneous_kind_of(p) != homogeneous_kind::position) return std::nullopt;
  if constexpr (Floating<T>)
    for (int i = 0; i < N; ++i) {  // compared before it is divided: constants may not overflow
      const T weight = magnitude(p[N]);
      if (weight < T(1) && magnitude(p[i]) > product((std::numeric_limits<T>::max)(), weight)) return std::nullopt;
    }
  return to_cartesian(p);
}

}  // namespace IRG_ABI

namespace detail::inline IRG_ABI {

// a*b with 1 <= |high| < 2, which is one way to write it.
// needs   finite numbers that are not zero
constexpr scaled_double_double normalized_product_of(double a, double b) noexcept {
  const scaled_number x = decompose(a), y = decompose(b);
  return normalized_number({fast_two_product(x.significand, y.significand), x.exponent + y.exponent});
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

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

template <class T, int N>
[[nodiscard]] constexpr bool same_position(const hpoint<T, N>& p, const hpoint<T, N>& q) noexcept {
  if (homogeneous_kind_of(p) == homogeneous_kind::nothing || homogeneous_kind_of(q) == homogeneous_kind::nothing)
    return false;
  int k = N;
  while (p[k] == T(0)) --k;
  if (q[k] == T(0)) return false;
  for (int i = 0; i <= N; ++i)
    if (i != k && !detail::products_equal(p[k], q[i], p[i], q[k])) return false;
  return true;
}

}  // namespace IRG_ABI
}  // namespace irg
