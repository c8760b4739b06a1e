// SPDX-License-Identifier: MIT
// Products of small matrices with each other, with vectors and with positions. Each entry is a sum of products from
// left to right, every product and every sum rounded once: in the plain body, which constant evaluation and all number
// types take, and in lanes alike, which take matrices of four rows of four floats or doubles. Bit for bit equal.
#pragma once

#include <cstddef>

#include <irg/core/lanes.hpp>
#include <irg/math/vec.hpp>

namespace irg::detail::inline IRG_ABI {

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
IRG_INLINE four_columns<T> columns_of(const pack<T, 4>& a, const pack<T, 4>& b, const pack<T, 4>& c,
                                      const pack<T, 4>& d) noexcept {
  const auto ab01 = shuffled<0, 4, 1, 5>(a, b), ab23 = shuffled<2, 6, 3, 7>(a, b), cd01 = shuffled<0, 4, 1, 5>(c, d),
             cd23 = shuffled<2, 6, 3, 7>(c, d);
  return {{shuffled<0, 1, 4, 5>(ab01, cd01), shuffled<2, 3, 6, 7>(ab01, cd01), shuffled<0, 1, 4, 5>(ab23, cd23),
           shuffled<2, 3, 6, 7>(ab23, cd23)}};
}
template <class T>
IRG_INLINE four_columns<T> columns_of(const T* rows) noexcept {
  using F = lanes<pack<T, 4>>;
  return columns_of(F::load(rows), F::load(rows + 4), F::load(rows + 8), F::load(rows + 12));
}

// The sum of the first N columns, each times x(k). Columns that stay the same are made once in a loop.
template <int N, class T, class X>
IRG_INLINE pack<T, 4> sum_of_columns(const four_columns<T>& a, const X& x) noexcept {
  using F = lanes<pack<T, 4>>;
  auto sum = a.column[0] * F::broadcast(x(0));
  for (int k = 1; k < N; ++k) sum = sum + a.column[k] * F::broadcast(x(k));
  return sum;
}

// The image of four numbers under four rows of four: all products of the rows as they lie in memory, sorted by columns
// and added from left to right. The widest registers hold two or four rows, one guard each.
template <class T>
IRG_INLINE pack<T, 4> image_by_rows(const T* rows, const pack<T, 4>& x) noexcept {
  using F = lanes<pack<T, 4>>;
  const auto terms =
      columns_of(F::load(rows) * x, F::load(rows + 4) * x, F::load(rows + 8) * x, F::load(rows + 12) * x);
  return ((terms.column[0] + terms.column[1]) + terms.column[2]) + terms.column[3];
}
template <std::same_as<float> T>
  requires(widest_bytes == 64)
IRG_INLINE pack<T, 4> image_by_rows(const T* rows, const pack<T, 4>& x) noexcept {
  const auto p = lanes<pack<T, 16>>::load(rows) * repeated<16>(x);
  const auto by_columns = shuffled_by<16>(p, [](int i) { return i % 4 * 4 + i / 4; });
  const auto low = low_half(by_columns), high = high_half(by_columns);
  return ((low_half(low) + high_half(low)) + low_half(high)) + high_half(high);
}
template <std::same_as<double> T>
  requires(widest_bytes == 64)
IRG_INLINE pack<T, 4> image_by_rows(const T* rows, const pack<T, 4>& x) noexcept {
  using F = lanes<pack<T, 8>>;
  const auto xs = repeated<8>(x), upper = F::load(rows) * xs, lower = F::load(rows + 8) * xs;
  const auto left = shuffled<0, 4, 8, 12, 1, 5, 9, 13>(upper, lower),
             right = shuffled<2, 6, 10, 14, 3, 7, 11, 15>(upper, lower);
  return ((low_half(left) + high_half(left)) + low_half(right)) + high_half(right);
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

// Two rows of that image, where a register holds but two numbers.
template <class T>
IRG_INLINE pack<T, 2> image_by_pairs(const T* rows, const pack<T, 2>& xy, const pack<T, 2>& zw) noexcept {
  using F = lanes<pack<T, 2>>;
  const auto a = F::load(rows) * xy, b = F::load(rows + 2) * zw, c = F::load(rows + 4) * xy, d = F::load(rows + 6) * zw;
  return ((shuffled<0, 2>(a, c) + shuffled<1, 3>(a, c)) + shuffled<0, 2>(b, d)) + shuffled<1, 3>(b, d);
}

// The same of a vector or homogeneous point of irg's, whose coordinates stand in a row.
template <class V, class T, std::size_t R, std::size_t C, class X>
IRG_INLINE constexpr V image_of_row(const T (&a)[R][C], const X& x) noexcept {
  if constexpr (has_lanes && Floating<T> && R == 4 && C == 4 && sizeof(X) == 4 * sizeof(T)) {
    if (!std::is_constant_evaluated()) {
      if constexpr (has_row_lanes<T>) {
        return from_lanes<V>(image_by_rows(a[0], lanes<pack<T, 4>>::load_bytes(&x)));
      } else {
        using F = lanes<pack<T, 2>>;
        const auto xy = F::load_bytes(&x), zw = F::load_bytes(&x[2]);
        V image;
        F::store_bytes(&image, image_by_pairs(a[0], xy, zw));
        F::store_bytes(&image[2], image_by_pairs(a[2], xy, zw));
        return image;
      }
    }
  }
  return image_of_column<V, static_cast<int>(C)>(a, [&](int k) IRG_INLINE_LAMBDA { return x[k]; });
}

// The image of a position or displacement of three floats in one register, for three rows: the sixfold shuffle that
// sorts them by columns is cheaper than what clang makes of the plain form.
template <class V, bool AddsLast, class X>
IRG_INLINE V affine_image_in_lanes(const float* rows, const X& x) noexcept {
  using F = lanes<pack<float, 4>>;
  const auto a = F::load(rows), b = F::load(rows + 4), c = F::load(rows + 8);
  const auto left = shuffled<0, 4, 1, 5>(a, b), right = shuffled<2, 6, 3, 7>(a, b);
  const auto sum =
      (shuffled<0, 1, 4, 5>(left, c) * F::broadcast(x(0)) + shuffled<2, 3, 5, 5>(left, c) * F::broadcast(x(1))) +
      shuffled<0, 1, 6, 6>(right, c) * F::broadcast(x(2));
  if constexpr (AddsLast)
    return from_lanes<V>(sum + shuffled<2, 3, 7, 7>(right, c));
  else
    return from_lanes<V>(sum);
}
#ifdef __clang__
inline constexpr bool triples_take_lanes = has_lanes;
#else
inline constexpr bool triples_take_lanes = false;
#endif

// The image of the position or displacement x(0) ... x(N - 1) under the affine matrix a, with or without its last
// column. Entry by entry, and by their names in the matrix: its type tells g++ that storing points does not change it,
// so loops over points keep it in registers and are vectorised.
template <class V, int N, bool AddsLast, class M, class X>
IRG_INLINE constexpr V affine_image(const M& a, const X& x) noexcept {
  if constexpr (triples_take_lanes && N == 3 && std::same_as<scalar_of<V>, float>)
    if (!std::is_constant_evaluated()) return affine_image_in_lanes<V, AddsLast>(a.m[0], x);
  return generate_coordinates<V>([&](int r) IRG_INLINE_LAMBDA {
    const auto sum = sum_of_products<N>([&](int k) IRG_INLINE_LAMBDA { return a.m[r][k]; }, x);
    if constexpr (AddsLast)
      return sum + a.m[r][N];
    else
      return sum;
  });
}

}  // namespace irg::detail::inline IRG_ABI
