// SPDX-License-Identifier: MIT
// Determinants of up to seven rows of doubles, exactly, and their quotients: what decides whether a system is singular.
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

#include <irg/core/conversion.hpp>
#include <irg/math/compensated.hpp>
#include <irg/math/detail/refinement.hpp>
#include <irg/math/exact_sum.hpp>

namespace irg::detail::inline IRG_ABI {

// The determinant of the K x K numbers entry(i, j): the sum over all orders of the columns, each from the one before by
// an exchange of two, which changes the sign (Heap 1963).
template <int K, class E>
constexpr exact_accumulator<K> exact_determinant(const E& entry) noexcept {
  exact_accumulator<K> sum;
  int order[static_cast<std::size_t>(K)]{}, turn[static_cast<std::size_t>(K)]{};
  for (int i = 0; i < K; ++i) order[i] = i;
  bool is_odd = false;
  const auto add_term = [&]<std::size_t... J>(std::index_sequence<J...>) {
    if (is_odd)
      sum.subtract(entry(static_cast<int>(J), order[J])...);
    else
      sum.add(entry(static_cast<int>(J), order[J])...);
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

// A sum that is not zero, and the same as parts * 2^exponent, 1 <= |parts.value| <= 2.
template <int K>
struct scaled_sum {
  const exact_accumulator<K>* sum = nullptr;
  unrounded parts{};
  int exponent = 0;
};
template <int K>
constexpr scaled_sum<K> scaled_parts(const exact_accumulator<K>& sum) noexcept {
  const int e = sum.exponent();
  return {&sum, sum.rounded_parts(-e), e};
}

// The sign of above / below - (t + step / 2).
template <int K, int L>
IRG_NOINLINE constexpr int compare_quotient(const exact_accumulator<K>& above, const exact_accumulator<L>& below,
                                            double t, double step) noexcept {
  exact_accumulator<maximum(K, L) + 1> difference;
  difference.add(above, 2.0);
  difference.add(below, -t);
  difference.add(below, -t);
  difference.add(below, -step);
  return difference.sign() * below.sign();
}

// above / below, correctly rounded, ties to even.
template <Floating T, int K, int L>
constexpr T quotient_of_sums(const scaled_sum<K>& above, const scaled_sum<L>& below) noexcept {
  const unrounded quotient = renormalised(divide(above.parts, below.parts));  // within 2^-100 of itself
  return nearest_scaled<T>(quotient, above.exponent - below.exponent, [&](double t, double step) {
    const int sign = compare_quotient(*above.sum, *below.sum, t, step);
    return step < 0 ? -sign : sign;
  });
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

// The size of the largest minor of `rows` rows of `columns` numbers entry(i, j), at most K, of which is_regular says
// yes: with is_nonzero_minor the number of independent rows. is_regular takes the minor's numbers, and its size as a
// constant.
template <int K, class E, class P>
constexpr int rank_by_minors(int rows, int columns, const E& entry, const P& is_regular) noexcept {
  if constexpr (K == 0) {
    return 0;
  } else {
    const bool is_full = any_choice(K, rows, [&](const int* r) {
      return any_choice(K, columns, [&](const int* c) {
        return is_regular([&](int i, int j) { return entry(r[i], c[j]); }, std::integral_constant<int, K>{});
      });
    });
    return is_full ? K : rank_by_minors<K - 1>(rows, columns, entry, is_regular);
  }
}

inline constexpr auto is_nonzero_minor = []<class E, int K>(const E& minor, std::integral_constant<int, K>) {
  return exact_determinant<K>(minor).sign() != 0;
};

}  // namespace irg::detail::inline IRG_ABI
