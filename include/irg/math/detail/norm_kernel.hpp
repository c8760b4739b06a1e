// SPDX-License-Identifier: MIT
// norm_1 of matrices of four rows of four, in lanes. Bit for bit the plain one.
#pragma once

#include <irg/math/detail/mat_kernel.hpp>
#include <irg/math/lu.hpp>
#include <irg/math/mat.hpp>

namespace irg::detail::inline IRG_ABI {

// norm_1 of a matrix of four rows of four less `Diagonal` in its diagonal, as many columns at once as a register holds.
template <int Diagonal, class T>
IRG_INLINE T norm_1_in_lanes(const T (&a)[4][4]) noexcept {
  constexpr int count = has_row_lanes<T> ? 4 : 2;
  using F = lanes<pack<T, count>>;
  const auto sums_from = [&](int column) IRG_INLINE_LAMBDA {
    const auto row = [&](int r) IRG_INLINE_LAMBDA {
      const auto entries = F::load(a[r] + column);
      if constexpr (Diagonal == 0)
        return magnitude(entries);
      else
        return magnitude(entries - F::generate([&](int i) { return column + i == r ? T(Diagonal) : T(0); }));
    };
    return ((row(0) + row(1)) + row(2)) + row(3);
  };
  if constexpr (count == 4) {
    const auto sums = sums_from(0), pairs = high_of(shuffled<2, 3, 2, 3>(sums), sums);
    return greater(pairs[0], pairs[1]);
  } else {
    const auto pairs = high_of(sums_from(0), sums_from(2));
    return greater(pairs[0], pairs[1]);
  }
}
template <int Diagonal, class T, int N>
IRG_INLINE constexpr T norm_1_less(mat<T, N, N> a) noexcept {
  if constexpr (has_lanes && Floating<T> && N == 4)
    if (!std::is_constant_evaluated()) return norm_1_in_lanes<Diagonal>(a.m);
  if constexpr (Diagonal != 0)
    for (int i = 0; i < N; ++i) a(i, i) = a(i, i) - T(Diagonal);
  return norm_1(a);
}

// Whether the norm of a may be compared with a bound: constant evaluation refuses sums that overflow or are NaN, and so
// must see first that no entry is beyond the bound.
template <Floating T, int N>
IRG_INLINE constexpr bool norm_may_be_taken(const mat<T, N, N>& a, T bound) noexcept {
  if (!std::is_constant_evaluated()) return true;
  for (const auto& row : a.m)
    for (const T& entry : row)
      if (!(magnitude(entry) <= bound)) return false;
  return true;
}

}  // namespace irg::detail::inline IRG_ABI
