// SPDX-License-Identifier: MIT
// Sums, dot products and cross products that cancellation does not spoil. `_accurate` computes in twice the precision,
// which leaves the last rounding and n^2 2^-106 of the sizes of the n terms: less than 1 ulp of up to nine of them to
// condition 10^14 (twice the sum of the terms' sizes over the size of the result). `_exact` gives the number nearest to
// the exact result, whatever the condition. Both cover the whole range of float and double.
#pragma once

#include <span>

#include <irg/core/conversion.hpp>
#include <irg/core/coordinates.hpp>
#include <irg/math/detail/compensated_terms.hpp>
#include <irg/math/detail/unrounded.hpp>
#include <irg/math/exact_sum.hpp>

namespace irg::inline IRG_ABI {

/// The sum of numbers, computed in twice the precision.
/// gives   0 for no numbers; with a NaN or an infinity among them what adding them gives
/// exact   within u of the sum, its last rounding, and n^2 2^-106 of the sum of the sizes of the n numbers (u = 2^-53,
///         float 2^-24): within 1 ulp while n^2 times the latter is below 2^52 times the size of the sum, in doubles.
///         Infinity only when the sum itself overflows
/// cost    8 operations a number; where one is beyond 2^960, an exact sum in integers
/// source  Ogita, Rump and Oishi 2005
template <Floating T>
[[nodiscard]] constexpr T sum_accurate(std::span<const T> numbers) noexcept;

/// The number nearest to the sum.
/// gives   as sum_accurate
/// exact   correctly rounded for all finite numbers, in any order, up to 2^31 of them
/// cost    as sum_accurate, and an exact sum in integers where that leaves the rounding open
template <Floating T>
[[nodiscard]] constexpr T sum_exact(std::span<const T> numbers) noexcept;

/// The sum of the products of the coordinates, computed in twice the precision.
/// gives   for finite coordinates never NaN, infinity only when the result itself overflows
/// exact   within u of the result, its last rounding, and N^2 2^-106 of the sum of the sizes of the N products
///         (u = 2^-53, float 2^-24): within 1 ulp while N^2 times the condition (2 * sum of |a_i*b_i| / |dot|) is
///         below 2^53, so to 10^14 for nine coordinates and less
/// cost    some 7 times that of dot; with a coordinate that is not 0 beyond 2^480 or below 2^-480, that of dot_exact
/// source  Ogita, Rump and Oishi 2005
template <Vector A, Vector B>
  requires(size_of<A> == size_of<B> && std::same_as<scalar_of<A>, scalar_of<B>> && Floating<scalar_of<A>>)
[[nodiscard]] constexpr scalar_of<A> dot_accurate(const A& a, const B& b) noexcept;

/// The number nearest to the sum of the products of the coordinates.
/// gives   as dot_accurate; 0 exactly when the vectors are at right angles or the result underflows
/// exact   correctly rounded for all finite coordinates
/// cost    as dot_accurate, and an exact sum in integers where that leaves the rounding open
template <Vector A, Vector B>
  requires(size_of<A> == size_of<B> && std::same_as<scalar_of<A>, scalar_of<B>> && Floating<scalar_of<A>>)
[[nodiscard]] constexpr scalar_of<A> dot_exact(const A& a, const B& b) noexcept;

/// The cross product without cancellation.
/// gives   for finite coordinates never NaN, infinity only where a component itself overflows
/// exact   each component within 1 ulp; cross_accurate(a, a) is exactly zero
/// cost    three difference_of_products; with a coordinate that is not 0 beyond 2^480 or below 2^-480, three exact sums
template <Vector A, Vector B>
  requires(size_of<A> == 3 && size_of<B> == 3 && std::same_as<scalar_of<A>, scalar_of<B>> && Floating<scalar_of<A>>)
[[nodiscard]] constexpr A cross_accurate(const A& a, const B& b) noexcept;

IRG_REFUSES_POINTS(cross_accurate);
IRG_REFUSES_POINTS(dot_accurate);
IRG_REFUSES_POINTS(dot_exact);

}  // namespace irg::inline IRG_ABI

namespace irg::detail::inline IRG_ABI {

template <Floating T, int K>
constexpr T round_exact_sum(exact_accumulator<K> sum) noexcept {
  const double nearest = sum.rounded();
  if constexpr (std::is_same_v<T, double>) return nearest;
  sum.subtract(nearest);
  return rounded_once<T>(nearest, sum.sign());
}

/// The T nearest to the sum, or nothing where the bound leaves that open.
template <Floating T>
constexpr bool round_safely(const compensated_sum& sum, T& rounded) noexcept {
  const auto [head, rest] = two_sum(sum.value, sum.error);
  rounded = rounded_once<T>(head, rest);
  if (sum.bound == 0) return true;
  const double bound = sum.bound + magnitude(rest) * 0x1p-51;
  if constexpr (std::is_same_v<T, double>)
    return head + (rest + bound) == head && head + (rest - bound) == head;
  else
    return magnitude(rest) > bound;
}

/// The sum of a(i)*b(i) exactly.
template <class A, class B>
IRG_NOINLINE constexpr exact_accumulator<2> exact_dot(std::size_t n, const A& a, const B& b) noexcept {
  exact_accumulator<2> sum;
  for (std::size_t i = 0; i < n; ++i) sum.add(a(i), b(i));
  return sum;
}

/// What a(i) and b(i) allow: bounded_dot, only exact_dot, or neither because a number is NaN or infinite.
enum class dot_range { compensable, finite, none };

template <class A, class B>
IRG_INLINE constexpr dot_range dot_range_of(std::size_t n, const A& a, const B& b) noexcept {
  bool compensable = true;
  for (std::size_t i = 0; i < n; ++i) {
    compensable &= is_compensable(a(i));
    compensable &= is_compensable(b(i));
  }
  if (compensable) return dot_range::compensable;
  for (std::size_t i = 0; i < n; ++i)
    if (!is_finite(a(i)) || !is_finite(b(i))) return dot_range::none;
  return dot_range::finite;
}

template <Floating T, class A, class B>
constexpr T plain_dot(std::size_t n, const A& a, const B& b) noexcept {
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum = sum + product(a(i), b(i));
  return narrowed<T>(sum);
}

template <Floating T, class A, class B>
IRG_INLINE constexpr T accurate_dot(std::size_t n, const A& a, const B& b) noexcept {
  const dot_range range = dot_range_of(n, a, b);
  if (range == dot_range::compensable) {
    const compensated_sum sum = bounded_dot(n, a, b);
    return narrowed<T>(sum.value + sum.error);
  }
  return range == dot_range::none ? plain_dot<T>(n, a, b) : round_exact_sum<T>(exact_dot(n, a, b));
}

template <Floating T, class A, class B>
IRG_INLINE constexpr T nearest_dot(std::size_t n, const A& a, const B& b) noexcept {
  const dot_range range = dot_range_of(n, a, b);
  T rounded{};
  if (range == dot_range::compensable && round_safely(bounded_dot(n, a, b), rounded)) return rounded;
  return range == dot_range::none ? plain_dot<T>(n, a, b) : round_exact_sum<T>(exact_dot(n, a, b));
}

template <class T>
IRG_INLINE constexpr auto doubles_of(std::span<const T> x) noexcept {
  return [x](std::size_t i) { return widened(x[i]); };
}
template <Vector V>
IRG_INLINE constexpr auto doubles_of(const V& v) noexcept {
  return [&v](std::size_t i) { return widened(coordinate(v, static_cast<int>(i))); };
}

/// Whether the numbers are so small that bounded_sum does not overflow.
template <class A>
constexpr bool can_be_summed(std::size_t n, const A& a) noexcept {
  bool moderate = true;
  for (std::size_t i = 0; i < n; ++i) moderate &= magnitude(a(i)) <= 0x1p960;
  return moderate;
}

template <Floating T, class A>
constexpr T far_sum(std::size_t n, const A& a) noexcept {
  exact_accumulator<1> sum;
  double plain = 0;
  bool finite = true;
  for (std::size_t i = 0; i < n; ++i) finite = finite && is_finite(a(i));
  for (std::size_t i = 0; i < n; ++i) {
    if (finite)
      sum.add(a(i));
    else
      plain += a(i);
  }
  return finite ? round_exact_sum<T>(sum) : narrowed<T>(plain);
}

/// Each component of the cross product correctly rounded, for all finite coordinates.
template <Vector A, Vector B>
  requires(size_of<A> == 3 && size_of<B> == 3 && std::same_as<scalar_of<A>, scalar_of<B>> && Floating<scalar_of<A>>)
constexpr A nearest_cross(const A& a, const B& b) noexcept {
  const auto x = doubles_of(a), y = doubles_of(b);
  const auto det = [&](std::size_t i, std::size_t j) {
    return nearest_dot<scalar_of<A>>(
        2, [&](std::size_t k) { return k == 0 ? x(i) : -x(j); }, [&](std::size_t k) { return k == 0 ? y(j) : y(i); });
  };
  return from_coordinates<A>(det(1, 2), det(2, 0), det(0, 1));
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <Floating T>
[[nodiscard]] constexpr T sum_accurate(std::span<const T> numbers) noexcept {
  const auto x = detail::doubles_of(numbers);
  if (!detail::can_be_summed(numbers.size(), x)) return detail::far_sum<T>(numbers.size(), x);
  const detail::compensated_sum sum = detail::bounded_sum(numbers.size(), x);
  return narrowed<T>(sum.value + sum.error);
}

template <Floating T>
[[nodiscard]] constexpr T sum_exact(std::span<const T> numbers) noexcept {
  const auto x = detail::doubles_of(numbers);
  T rounded{};
  if (detail::can_be_summed(numbers.size(), x) && detail::round_safely(detail::bounded_sum(numbers.size(), x), rounded))
    return rounded;
  return detail::far_sum<T>(numbers.size(), x);
}

template <Vector A, Vector B>
  requires(size_of<A> == size_of<B> && std::same_as<scalar_of<A>, scalar_of<B>> && Floating<scalar_of<A>>)
[[nodiscard]] constexpr scalar_of<A> dot_accurate(const A& a, const B& b) noexcept {
  return detail::accurate_dot<scalar_of<A>>(size_of<A>, detail::doubles_of(a), detail::doubles_of(b));
}

template <Vector A, Vector B>
  requires(size_of<A> == size_of<B> && std::same_as<scalar_of<A>, scalar_of<B>> && Floating<scalar_of<A>>)
[[nodiscard]] constexpr scalar_of<A> dot_exact(const A& a, const B& b) noexcept {
  return detail::nearest_dot<scalar_of<A>>(size_of<A>, detail::doubles_of(a), detail::doubles_of(b));
}

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

}  // namespace irg::inline IRG_ABI
