// SPDX-License-Identifier: MIT
// Determinants of up to seven rows of doubles, exactly, and their quotients: what decides whether a system is singular.
#pragma once

#include <cstddef>
#include <utility>

#include <irg/core/conversion.hpp>
#include <irg/math/compensated.hpp>
#include <irg/math/detail/refinement.hpp>
#include <irg/math/exact_sum.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

// The determinant of the K x K numbers entry(i, j): the sum over all orders of the columns, each from the one before by
// an exchange of two, which changes the sign (Heap 1963).
template <int K, class E>
constexpr exact_accumulator<K> exact_determinant(const E& entry) noexcept {
  exact_accumulator<K> sum;
  int order[static_cast<std::size_t>(K)]{}, turn[static_cast<std::size_t>(K)]{};
  for (int i = 0; i < K; ++i) order[i] = i;
  bool is_odd = false;
  const auto add_term = [&]<std::size_t... I>(std::index_sequence<I...>) {
    if (is_odd)
      sum.subtract(entry(static_cast<int>(I), order[I])...);
    else
      sum.add(entry(static_cast<int>(I), order[I])...);
  };
  constexpr std::make_index_sequence<static_cast<std::size_t>(K)> all{};
  add_term(all);
  for (int i = 1; i < K;) {
    if (turn[i] < i) {
      const int other = i % 2 == 0 ? 0 : turn[i], kept = order[other];
      order[other] = order[i];
      order[i] = kept;
      is_odd = !is_odd;
      add_term(all);
      ++turn[i];
      i = 1;
    } else {
      turn[i++] = 0;
    }
  }
  return sum;
}

// Takes x * 2^e from the sum.
// needs   1 <= |x| <= 2, e the exponent of the sum or one less
template <int K>
constexpr void subtract_scaled(exact_accumulator<K>& sum, double x, int e) noexcept {
  double factor[static_cast<std::size_t>(K)]{};
  for (int i = 1; i < K; ++i) {
    const int step = clamp(e, -1074, 1023);
    factor[i] = power_of_two(step);
    e -= step;
  }
  // A sum of products of the largest doubles may be beyond K such factors: it is taken in parts.
  int parts = 1;
  for (; e > 1022; --e) parts *= 2;
  factor[0] = times_power_of_two(x, e);
  for (int i = 0; i < parts; ++i)
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      sum.subtract(factor[I]...);
    }(std::make_index_sequence<static_cast<std::size_t>(K)>{});
}

// A sum as (value + rest) * 2^exponent, 1 <= |value| <= 2, value being rounded to nearest and so is the rest.
struct scaled_sum {
  double value, rest;
  int exponent;
};
template <int K>
constexpr scaled_sum scaled_parts(exact_accumulator<K> sum) noexcept {
  const int e = sum.exponent();
  const double value = sum.rounded(-e);
  subtract_scaled(sum, value, e);
  return {value, sum.rounded(-e), e};
}

// above / below, correctly rounded, but either neighbour where the quotient is within 2^-100 of itself of the middle
// between two Ts; subnormal quotients are rounded twice.
template <Floating T>
constexpr T quotient_of_sums(const scaled_sum& above, const scaled_sum& below) noexcept {
  const double head = above.value / below.value;
  const auto p = two_product(head, below.value);
  const double rest = (((above.value - p.value) - p.error) + (above.rest - product(head, below.rest))) / below.value;
  const auto q = two_sum(head, rest);
  const int exponent = above.exponent - below.exponent;
  if constexpr (std::same_as<T, float>)
    if (exponent > -120 && exponent < 120) return rounded_once<float>(times_power_of_two(q.value, exponent), q.error);
  return converted<T>(times_power_of_two(q.value, exponent));
}

// Calls visit(chosen) for every choice of k of the numbers 0 to n - 1, until it says true; whether it did.
template <class V>
constexpr bool any_choice(int k, int n, const V& visit) noexcept {
  int chosen[8]{};
  for (int i = 0; i < k; ++i) chosen[i] = i;
  for (;;) {
    if (visit(chosen)) return true;
    int i = k - 1;
    while (i >= 0 && chosen[i] == n - k + i) --i;
    if (i < 0) return false;
    ++chosen[i];
    for (int j = i + 1; j < k; ++j) chosen[j] = chosen[j - 1] + 1;
  }
}

// The number of independent rows among `rows` rows of `columns` numbers entry(i, j), at most K: the size of the largest
// minor that is not zero.
template <int K, class E>
constexpr int exact_rank(int rows, int columns, const E& entry) noexcept {
  if constexpr (K == 0) {
    return 0;
  } else {
    const bool is_full = any_choice(K, rows, [&](const int* r) {
      return any_choice(K, columns, [&](const int* c) {
        return exact_determinant<K>([&](int i, int j) { return entry(r[i], c[j]); }).sign() != 0;
      });
    });
    return is_full ? K : exact_rank<K - 1>(rows, columns, entry);
  }
}

}  // namespace IRG_ABI
}  // namespace irg::detail
