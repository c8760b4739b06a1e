// SPDX-License-Identifier: MIT
// Sums of products in twice the precision: the loops behind math/compensated.hpp and the angles of math/length.hpp.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include <irg/math/error_free.hpp>

namespace irg::detail {

/// A sum in two parts that need not be apart, and how much the second one can be wrong.
struct compensated_sum {
  double value = 0, error = 0, bound = 0;
};

inline namespace IRG_ABI {

/// Whether x is 0 or 2^-480 <= |x| <= 2^480, so that products of two such numbers are exact as two doubles, and a
/// million of them can be added. Told from the bits, so that it holds in any mode and in constant evaluation.
IRG_INLINE constexpr bool is_compensable(double x) noexcept {
  const auto bits = std::bit_cast<std::uint64_t>(x) << 1;
  return (bits >> 53) - (1023 - 480) <= 2 * 480 || bits == 0;
}

/// The sum of the n products a(i)*b(i) as if computed in twice the precision: value + error, yet to be rounded.
/// needs   products and sums that do not overflow
/// source  Ogita, Rump and Oishi 2005 (Dot2)
template <class A, class B>
IRG_INLINE constexpr compensated_sum compensated_dot(std::size_t n, const A& a, const B& b) noexcept {
  compensated_sum sum;
  for (std::size_t i = 0; i < n; ++i) {
    const auto [term, term_error] = two_product(a(i), b(i));
    const auto [next, next_error] = two_sum(sum.value, term);
    sum.error += next_error + term_error;
    sum.value = next;
  }
  return sum;
}

/// compensated_dot for numbers that are compensable, with a bound of the error: value + error is within it of the sum.
/// The bound is 0 when nothing was rounded.
template <class A, class B>
IRG_INLINE constexpr compensated_sum bounded_dot(std::size_t n, const A& a, const B& b) noexcept {
  compensated_sum sum;
  double sizes = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto [term, term_error] = fast_two_product(a(i), b(i));
    const auto [next, next_error] = two_sum(sum.value, term);
    sum.error += next_error + term_error;
    sizes += (next_error < 0 ? -next_error : next_error) + (term_error < 0 ? -term_error : term_error);
    sum.value = next;
  }
  // Each of the 2n errors meets at most n + 1 roundings of u = 2^-53; twice as much covers those of `sizes`.
  sum.bound = product(sizes, static_cast<double>(n + 1) * 0x1p-52);
  return sum;
}

/// The sum of n numbers a(i) in twice the precision, with a bound as bounded_dot gives it.
/// source  Ogita, Rump and Oishi 2005 (Sum2)
template <class A>
IRG_INLINE constexpr compensated_sum bounded_sum(std::size_t n, const A& a) noexcept {
  compensated_sum sum;
  double sizes = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto [next, next_error] = two_sum(sum.value, a(i));
    sum.error += next_error;
    sizes += next_error < 0 ? -next_error : next_error;
    sum.value = next;
  }
  sum.bound = product(sizes, static_cast<double>(n + 1) * 0x1p-52);
  return sum;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
