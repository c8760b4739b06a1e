// SPDX-License-Identifier: MIT
// The steps of compensated.hpp.
#pragma once

#include <span>

#include <irg/core/conversion.hpp>
#include <irg/core/coordinates.hpp>
#include <irg/math/detail/compensated_terms.hpp>
#include <irg/math/detail/unrounded.hpp>
#include <irg/math/exact_sum.hpp>

namespace irg::detail::inline IRG_ABI {

template <Floating T, int K>
constexpr T rounded_once(exact_accumulator<K> sum) noexcept {
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
  return narrow<T>(sum);
}

template <Floating T, class A, class B>
IRG_INLINE constexpr T accurate_dot(std::size_t n, const A& a, const B& b) noexcept {
  const dot_range range = dot_range_of(n, a, b);
  if (range == dot_range::compensable) {
    const compensated_sum sum = bounded_dot(n, a, b);
    return narrow<T>(sum.value + sum.error);
  }
  return range == dot_range::none ? plain_dot<T>(n, a, b) : rounded_once<T>(exact_dot(n, a, b));
}

template <Floating T, class A, class B>
IRG_INLINE constexpr T nearest_dot(std::size_t n, const A& a, const B& b) noexcept {
  const dot_range range = dot_range_of(n, a, b);
  T rounded{};
  if (range == dot_range::compensable && round_safely(bounded_dot(n, a, b), rounded)) return rounded;
  return range == dot_range::none ? plain_dot<T>(n, a, b) : rounded_once<T>(exact_dot(n, a, b));
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
  return finite ? rounded_once<T>(sum) : narrow<T>(plain);
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
