// SPDX-License-Identifier: MIT
// Sums, dot products and cross products that cancellation does not spoil. `_accurate` computes in twice the precision,
// which leaves the last rounding and n^2 2^-106 of the sizes of the n terms: less than 1 ulp of up to nine of them to
// condition 10^14 (twice the sum of the terms' sizes over the size of the result). `_exact` gives the number nearest to
// the exact result, whatever the condition. Both cover the whole range of float and double.
#pragma once

#include <span>

#include <irg/core/conversion.hpp>
#include <irg/core/coordinates.hpp>
#include <irg/math/detail/compensated_steps.hpp>
#include <irg/math/detail/compensated_terms.hpp>
#include <irg/math/detail/unrounded.hpp>
#include <irg/math/exact_sum.hpp>

namespace irg {

inline namespace IRG_ABI {

/// The sum of numbers, computed in twice the precision.
/// gives   0 for no numbers; with a NaN or an infinity among them what adding them gives
/// exact   within u of the sum, its last rounding, and n^2 2^-106 of the sum of the sizes of the n numbers (u = 2^-53,
///         float 2^-24): within 1 ulp while n^2 times the latter is below 2^52 times the size of the sum, in doubles.
///         Infinity only when the sum itself overflows
/// cost    8 operations a number; where one is beyond 2^960, an exact sum in integers
/// source  Ogita, Rump and Oishi 2005
template <Floating T>
[[nodiscard]] constexpr T sum_accurate(std::span<const T> numbers) noexcept {
  const auto x = detail::doubles_of(numbers);
  if (!detail::can_be_summed(numbers.size(), x)) return detail::far_sum<T>(numbers.size(), x);
  const detail::compensated_sum sum = detail::bounded_sum(numbers.size(), x);
  return detail::narrow<T>(sum.value + sum.error);
}

/// The number nearest to the sum.
/// gives   as sum_accurate
/// exact   correctly rounded for all finite numbers, in any order, up to 2^31 of them
/// cost    as sum_accurate, and an exact sum in integers where that leaves the rounding open
template <Floating T>
[[nodiscard]] constexpr T sum_exact(std::span<const T> numbers) noexcept {
  const auto x = detail::doubles_of(numbers);
  T rounded{};
  if (detail::can_be_summed(numbers.size(), x) && detail::round_safely(detail::bounded_sum(numbers.size(), x), rounded))
    return rounded;
  return detail::far_sum<T>(numbers.size(), x);
}

/// The sum of the products of the coordinates, computed in twice the precision.
/// gives   for finite coordinates never NaN, infinity only when the result itself overflows
/// exact   within u of the result, its last rounding, and N^2 2^-106 of the sum of the sizes of the N products
///         (u = 2^-53, float 2^-24): within 1 ulp while N^2 times the condition (2 * sum of |a_i*b_i| / |dot|) is
///         below 2^53, so to 10^14 for nine coordinates and less
/// cost    some 7 times that of dot; with a coordinate that is not 0 beyond 2^480 or below 2^-480, that of dot_exact
/// source  Ogita, Rump and Oishi 2005
template <Vector A, Vector B>
  requires(size_of<A> == size_of<B> && std::same_as<scalar_of<A>, scalar_of<B>> && Floating<scalar_of<A>>)
[[nodiscard]] constexpr scalar_of<A> dot_accurate(const A& a, const B& b) noexcept {
  return detail::accurate_dot<scalar_of<A>>(size_of<A>, detail::doubles_of(a), detail::doubles_of(b));
}

/// The number nearest to the sum of the products of the coordinates.
/// gives   as dot_accurate; 0 exactly when the vectors are at right angles or the result underflows
/// exact   correctly rounded for all finite coordinates
/// cost    as dot_accurate, and an exact sum in integers where that leaves the rounding open
template <Vector A, Vector B>
  requires(size_of<A> == size_of<B> && std::same_as<scalar_of<A>, scalar_of<B>> && Floating<scalar_of<A>>)
[[nodiscard]] constexpr scalar_of<A> dot_exact(const A& a, const B& b) noexcept {
  return detail::nearest_dot<scalar_of<A>>(size_of<A>, detail::doubles_of(a), detail::doubles_of(b));
}

/// The cross product without cancellation.
/// gives   for finite coordinates never NaN, infinity only where a component itself overflows
/// exact   each component within 1 ulp; cross_accurate(a, a) is exactly zero
/// cost    three difference_of_products; with a coordinate that is not 0 beyond 2^480 or below 2^-480, three exact sums
template <Vector A, Vector B>
  requires(size_of<A> == 3 && size_of<B> == 3 && std::same_as<scalar_of<A>, scalar_of<B>> && Floating<scalar_of<A>>)
[[nodiscard]] constexpr A cross_accurate(const A& a, const B& b) noexcept {
  using T = scalar_of<A>;
  if (std::is_same_v<T, double> &&
      detail::dot_range_of(3, detail::doubles_of(a), detail::doubles_of(b)) == detail::dot_range::finite)
    return detail::nearest_cross(a, b);
  const auto det = [&](int i, int j) {
    return difference_of_products(coordinate(a, i), coordinate(b, j), coordinate(a, j), coordinate(b, i));
  };
  return from_coordinates<A>(det(1, 2), det(2, 0), det(0, 1));
}

IRG_REFUSES_POINTS(cross_accurate);
IRG_REFUSES_POINTS(dot_accurate);
IRG_REFUSES_POINTS(dot_exact);

}  // namespace IRG_ABI
}  // namespace irg
