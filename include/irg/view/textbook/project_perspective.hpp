// SPDX-License-Identifier: MIT
// The lecture's projections, from the eye's system, z the distance along the view, to the picture plane: P as a matrix
// for row vectors, and the division by z without loss.
#pragma once

#include <limits>
#include <optional>

#include <irg/core/conversion.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/mat.hpp>
#include <irg/view/look_at.hpp>

namespace irg::detail::inline IRG_ABI {

// x * h / z, the rounding of the product made up for.
// needs   |x|, h and z between 2^-300 and 2^300
constexpr double corrected_proportion(double x, double h, double z) noexcept {
  const exact_sum<double> p = fast_two_product(x, h);
  const double q = p.value / z;
  const exact_sum<double> b = fast_two_product(q, z);
  return q + ((p.value - b.value) - b.error + p.error) / z;
}

// x * h / z without overflow or underflow on the way; nothing when the result is too large.
// needs   x finite, h and z finite and positive
template <class T>
constexpr std::optional<T> textbook_proportion(T x, T h, T z) noexcept {
  constexpr T most = (std::numeric_limits<T>::max)();
  if constexpr (std::same_as<T, float>) {
    const double q = widened(x) * widened(h) / widened(z);  // exact but the division
    if (!(magnitude(q) <= static_cast<double>(most))) return std::nullopt;
    return converted<float>(q);
  } else {
    const auto moderate = [](T v) { return T(0x1p-300) <= v && v <= T(0x1p300); };
    if (x == T(0)) return T(0);
    if (moderate(magnitude(x)) && moderate(h) && moderate(z)) return corrected_proportion(x, h, z);
    const scaled_number a = decompose(x), b = decompose(h), c = decompose(z);
    const T q = corrected_proportion(a.significand, b.significand, c.significand);  // from 1/2 to 4
    const int e = a.exponent + b.exponent - c.exponent;
    if (e < -1100) return T(0);
    if (e < 0) return q * T(0x1p-200) * power_of_two(e + 200);
    if (e > 1025) return std::nullopt;
    const T sixteenth = q * power_of_two(e - 4);
    if (most / 16 < magnitude(sixteenth)) return std::nullopt;
    return sixteenth * 16;
  }
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::textbook::inline IRG_ABI {

/// P (5.10): the perspective projection onto the plane at the distance h in front of the eye, for row vectors; it gives
/// [x y 0 z/h], and the division by z/h leads to (5.9).
/// gives   nothing when h is not positive or not finite, or so small that 1/h is infinite
template <Floating T>
[[nodiscard]] constexpr std::optional<mat<T, 4, 4>> perspective_matrix(T h) noexcept {
  using limits = std::numeric_limits<T>;
  if (!(T(1) / (limits::max)() < h) || !(h <= (limits::max)())) return std::nullopt;
  return mat<T, 4, 4>{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, T(1) / h}, {0, 0, 0, 0}}};
}

/// Where a position of the eye's system is seen in the plane at distance h: x h / z and y h / z (5.9).
/// gives   nothing at and behind the eye (z <= 0), for NaN and infinity, for h <= 0, and where a coordinate would be
///         beyond the largest number
/// exact   within 0.51 ulp over the whole range (1 ulp where the result is subnormal), so that a position in the plane
///         itself, z = h, is seen where it is
template <Floating T>
[[nodiscard]] constexpr std::optional<point<T, 2>> project_perspective(const point<T, 3>& p,
                                                                       std::type_identity_t<T> h) noexcept {
  constexpr T most = (std::numeric_limits<T>::max)();
  if (!(T(0) < p.z) || !(T(0) < h) || !(h <= most) || !detail::within(p, most)) return std::nullopt;
  const auto x = detail::textbook_proportion(p.x, h, p.z), y = detail::textbook_proportion(p.y, h, p.z);
  if (!x || !y) return std::nullopt;
  return point<T, 2>{*x, *y};
}

/// The parallel projection that the lecture names beside P: drops z.
template <Floating T>
[[nodiscard]] constexpr mat<T, 4, 4> parallel_matrix() noexcept {
  return {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 1}}};
}

/// Where a position of the eye's system is seen in parallel projection: (x, y), at any depth, behind the eye too.
template <class T>
[[nodiscard]] constexpr point<T, 2> project_parallel(const point<T, 3>& p) noexcept {
  return {p.x, p.y};
}

}  // namespace irg::textbook::inline IRG_ABI
