// SPDX-License-Identifier: MIT
// Products of small matrices with each other, with vectors and with positions. Each entry is a sum of products from
// left to right, every product and every sum rounded once: in the plain body, which constant evaluation and all number
// types take, and in lanes alike, which take matrices of four rows of four floats or doubles. Bit for bit equal.
#pragma once

#include <cstddef>

#include <irg/core/lanes.hpp>
#include <irg/math/vec.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

// The sum of a(k) * b(k) for k = 0 .. N - 1, from left to right.
template <int N, class A, class B>
IRG_INLINE constexpr auto sum_of_products(const A& a, const B& b) noexcept {
  auto sum = product(a(0), b(0));
  for (int k = 1; k < N; ++k) sum = sum + product(a(k), b(k));
  return sum;
}

// Whether a row of four T fits into a register, and how many such rows do. Arrays would be slower than the plain body.
template <class T>
inline constexpr bool has_row_lanes = false;
template <Floating T>
inline constexpr bool has_row_lanes<T> = has_lanes && 4 * static_cast<int>(sizeof(T)) <= widest_bytes;
template <class T>
inline constexpr int rows_per_register = widest_bytes / (4 * static_cast<int>(sizeof(T)));

// Lane K of every four lanes, in all four of them.
template <int K, class T, int N>
IRG_INLINE pack<T, N> spread(const pack<T, N>& a) noexcept {
  return shuffled_by<N>(a, [](int i) { return i / 4 * 4 + K; });
}

// A row of four in every four lanes.
template <int N, class T>
IRG_INLINE pack<T, N> repeat_row(const T* row) noexcept {
  return repeated<N>(lanes<pack<T, 4>>::load(row));
}

// As many rows of a product as a register holds: rows of a times the four rows at b.
template <class T>
IRG_INLINE void multiply_rows(const T* a, const T* b, T* out) noexcept {
  constexpr int count = 4 * rows_per_register<T>;
  using F = lanes<pack<T, count>>;
  const auto rows = F::load(a);
  F::store(out, ((spread<0>(rows) * repeat_row<count>(b) + spread<1>(rows) * repeat_row<count>(b + 4)) +
                 spread<2>(rows) * repeat_row<count>(b + 8)) +
                    spread<3>(rows) * repeat_row<count>(b + 12));
}

// The columns of a matrix of four rows of four.
template <class T>
struct four_columns {
  pack<T, 4> column[4];
};
template <class T>
IRG_INLINE four_columns<T> columns_of(const T* rows) noexcept {
  using F = lanes<pack<T, 4>>;
  const auto a = F::load(rows), b = F::load(rows + 4), c = F::load(rows + 8), d = F::load(rows + 12);
  const auto ab01 = shuffled<0, 4, 1, 5>(a, b), ab23 = shuffled<2, 6, 3, 7>(a, b), cd01 = shuffled<0, 4, 1, 5>(c, d),
             cd23 = shuffled<2, 6, 3, 7>(c, d);
  return {{shuffled<0, 1, 4, 5>(ab01, cd01), shuffled<2, 3, 6, 7>(ab01, cd01), shuffled<0, 1, 4, 5>(ab23, cd23),
           shuffled<2, 3, 6, 7>(ab23, cd23)}};
}

// The sum of the first N columns, each times x(k). Columns that stay the same are made once in a loop.
template <int N, class T, class X>
IRG_INLINE pack<T, 4> sum_of_columns(const four_columns<T>& a, const X& x) noexcept {
  using F = lanes<pack<T, 4>>;
  auto sum = a.column[0] * F::broadcast(x(0));
  for (int k = 1; k < N; ++k) sum = sum + a.column[k] * F::broadcast(x(k));
  return sum;
}

template <class V, class T>
IRG_INLINE V from_lanes(const pack<T, 4>& f) noexcept {
  if constexpr (is_own<V> && sizeof(V) == sizeof f) {
    V v;
    lanes<pack<T, 4>>::store_bytes(&v, f);
    return v;
  } else {
    return generate_coordinates<V>([&](int i) { return f[i]; });
  }
}

// out = a * b; `out` is neither of the two.
template <class T, std::size_t R, std::size_t K, std::size_t C>
IRG_INLINE constexpr void multiply(const T (&a)[R][K], const T (&b)[K][C], T (&out)[R][C]) noexcept {
  if constexpr (has_row_lanes<T> && R == 4 && K == 4 && C == 4) {
    if (!std::is_constant_evaluated()) {
      for (int r = 0; r < 4; r += rows_per_register<T>) multiply_rows(a[r], b[0], out[r]);
      return;
    }
  }
  for (std::size_t r = 0; r < R; ++r)
    for (std::size_t c = 0; c < C; ++c)
      out[r][c] = sum_of_products<static_cast<int>(K)>([&](int k) { return a[r][k]; }, [&](int k) { return b[k][c]; });
}

// The image of the column x(0) ... x(N - 1) under the first N columns of a, as a V.
template <class V, int N, class T, std::size_t R, std::size_t C, class X>
IRG_INLINE constexpr V image_of_column(const T (&a)[R][C], const X& x) noexcept {
  if constexpr (has_row_lanes<T> && R == 4 && C == 4)
    if (!std::is_constant_evaluated()) return from_lanes<V>(sum_of_columns<N>(columns_of(a[0]), x));
  return generate_coordinates<V>([&](int r) { return sum_of_products<N>([&](int k) { return a[r][k]; }, x); });
}

// The same with the last column added as it is.
template <class V, int N, class T, std::size_t R, std::size_t C, class X>
IRG_INLINE constexpr V image_of_position(const T (&a)[R][C], const X& x) noexcept {
  if constexpr (has_row_lanes<T> && R == 4 && C == 4) {
    if (!std::is_constant_evaluated()) {
      const auto columns = columns_of(a[0]);
      return from_lanes<V>(sum_of_columns<N>(columns, x) + columns.column[N]);
    }
  }
  return generate_coordinates<V>(
      [&](int r) { return sum_of_products<N>([&](int k) { return a[r][k]; }, x) + a[r][N]; });
}

}  // namespace IRG_ABI
}  // namespace irg::detail
