// SPDX-License-Identifier: MIT
// Arrays of vectors of three coordinates, a register of them at a time. Bit for bit what dot, cross, normalized and
// normalized_fast give one by one.
#pragma once

#include <cstddef>
#include <limits>

#include <irg/core/interleaved_lanes.hpp>
#include <irg/math/detail/mat_kernel.hpp>
#include <irg/math/length.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

#ifdef IRG_LANES_VECTOR

// Where each register of N triples is worth it: as wide as the target's for floats and doubles.
template <class T>
inline constexpr int triple_count = widest_bytes / static_cast<int>(sizeof(T));

// The square root in every lane.
template <class T, int N>
IRG_INLINE pack<T, N> sqrt_lanes(const pack<T, N>& a) noexcept {
#if defined(__clang__) && __has_builtin(__builtin_elementwise_sqrt)
  return {__builtin_elementwise_sqrt(a.v)};
#else
  constexpr bool is_float = std::is_same_v<T, float>;
#if defined(__SSE2__)
  if constexpr (is_float && N == 4) return {__builtin_ia32_sqrtps(a.v)};
  if constexpr (!is_float && N == 2) return {__builtin_ia32_sqrtpd(a.v)};
#endif
#if defined(__AVX__)
  if constexpr (is_float && N == 8) return {__builtin_ia32_sqrtps256(a.v)};
  if constexpr (!is_float && N == 4) return {__builtin_ia32_sqrtpd256(a.v)};
#endif
#if defined(__AVX512F__)  // 4: rounding as the environment says
  if constexpr (is_float && N == 16) return {__builtin_ia32_sqrtps512_mask(a.v, a.v, -1, 4)};
  if constexpr (!is_float && N == 8) return {__builtin_ia32_sqrtpd512_mask(a.v, a.v, -1, 4)};
#endif
  pack<T, N> r{};
  for (int i = 0; i < N; ++i) r.v[i] = sqrt(a[i]);
  return r;
#endif
}

template <class T, int N>
IRG_INLINE pack<T, N> dot_lanes(const triple_lanes<T, N>& a, const triple_lanes<T, N>& b) noexcept {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

template <class T, int N>
IRG_INLINE triple_lanes<T, N> cross_lanes(const triple_lanes<T, N>& a, const triple_lanes<T, N>& b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class T, int N>
IRG_INLINE triple_lanes<T, N> normalize_fast_lanes(const triple_lanes<T, N>& a) noexcept {
  using F = lanes<pack<T, N>>;
  const auto one = F::broadcast(1), square = dot_lanes(a, a);
  const auto factor = one / sqrt_lanes(pack<T, N>{square.v > 0 ? square.v : one.v});
  return {a.x * factor, a.y * factor, a.z * factor};
}

// Floats: their squares are exact in double and stay far inside its range, so nothing need be scaled.
template <int N>
IRG_INLINE triple_lanes<float, N> normalize_lanes(const triple_lanes<float, N>& a) noexcept {
  using wide = typename pack<double, N>::storage;
  using narrow = typename pack<float, N>::storage;
  const auto in_double = [](const pack<float, N>& c) -> pack<double, N> {
    return {__builtin_convertvector(opaque(c.v), wide)};
  };
  const pack<double, N> x = in_double(a.x), y = in_double(a.y), z = in_double(a.z);
  const pack<double, N> square = (x * x + y * y) + z * z;
  const pack<double, N> length = sqrt_lanes(square);
  const auto unit = [&](const pack<double, N>& c) -> pack<float, N> {
    // A square of 0, infinity or NaN: no direction.
    const wide quotient =
        ((square.v > 0) & (square.v < std::numeric_limits<double>::infinity())) ? (c / length).v : wide{};
    return {opaque(__builtin_convertvector(quotient, narrow))};
  };
  return {unit(x), unit(y), unit(z)};
}

// all(i) for `Count` vectors from i on as long as there are so many, one(i) for the rest.
template <int Count, class One, class All>
IRG_INLINE void by_registers(std::size_t n, const One& one, const All& all) noexcept {
  constexpr std::size_t count = static_cast<std::size_t>(Count);
  std::size_t i = 0;
  for (; i + count <= n; i += count) all(i);
  for (std::size_t rest = (n - i) % count; rest != 0; --rest, ++i) one(i);
}

template <class T, class One>
void dots_in_lanes(const T* a, const T* b, T* out, std::size_t n, const One& one) noexcept {
  constexpr int count = triple_count<T>;
  by_registers<count>(n, one, [&](std::size_t i) {
    lanes<pack<T, count>>::store(out + i, dot_lanes(load_triples<count>(a + 3 * i), load_triples<count>(b + 3 * i)));
  });
}
template <class T, class One>
void crosses_in_lanes(const T* a, const T* b, T* out, std::size_t n, const One& one) noexcept {
  constexpr int count = triple_count<T>;
  by_registers<count>(n, one, [&](std::size_t i) {
    store_triples(out + 3 * i, cross_lanes(load_triples<count>(a + 3 * i), load_triples<count>(b + 3 * i)));
  });
}
template <class T, class One>
void normalize_fast_in_lanes(const T* v, T* out, std::size_t n, const One& one) noexcept {
  constexpr int count = triple_count<T>;
  by_registers<count>(
      n, one, [&](std::size_t i) { store_triples(out + 3 * i, normalize_fast_lanes(load_triples<count>(v + 3 * i))); });
}
template <class One>
void normalize_in_lanes(const float* v, float* out, std::size_t n, const One& one) noexcept {
  constexpr int count = triple_count<double>;
  by_registers<count>(n, one, [&](std::size_t i) {
    store_triples(out + 3 * i, normalize_lanes<count>(load_triples<count>(v + 3 * i)));
  });
}

#endif

// What constant evaluation and machines without lanes do: one(i) for each of n.
template <class T, class One>
constexpr void dots([[maybe_unused]] const T* a, [[maybe_unused]] const T* b, [[maybe_unused]] T* out, std::size_t n,
                    const One& one) noexcept {
#ifdef IRG_LANES_VECTOR
  if (!std::is_constant_evaluated()) return dots_in_lanes(a, b, out, n, one);
#endif
  for (std::size_t i = 0; i < n; ++i) one(i);
}
template <class T, class One>
constexpr void crosses([[maybe_unused]] const T* a, [[maybe_unused]] const T* b, [[maybe_unused]] T* out, std::size_t n,
                       const One& one) noexcept {
#ifdef IRG_LANES_VECTOR
  if (!std::is_constant_evaluated()) return crosses_in_lanes(a, b, out, n, one);
#endif
  for (std::size_t i = 0; i < n; ++i) one(i);
}
template <class T, class One>
constexpr void normalize_fast([[maybe_unused]] const T* v, [[maybe_unused]] T* out, std::size_t n,
                              const One& one) noexcept {
#ifdef IRG_LANES_VECTOR
  if (!std::is_constant_evaluated()) return normalize_fast_in_lanes(v, out, n, one);
#endif
  for (std::size_t i = 0; i < n; ++i) one(i);
}
template <class T, class One>
constexpr void normalize([[maybe_unused]] const T* v, [[maybe_unused]] T* out, std::size_t n, const One& one) noexcept {
#ifdef IRG_LANES_VECTOR
  if constexpr (std::is_same_v<T, float> && native_bytes >= 32)  // a double's needs more than its range
    if (!std::is_constant_evaluated()) return normalize_in_lanes(v, out, n, one);
#endif
  for (std::size_t i = 0; i < n; ++i) one(i);
}

}  // namespace IRG_ABI
}  // namespace irg::detail
