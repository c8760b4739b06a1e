// SPDX-License-Identifier: MIT
// Arrays of vectors of three coordinates, a register of them at a time. Bit for bit what dot, cross, normalized and
// normalized_fast give one by one.
#pragma once

#include <cstddef>
#include <limits>

#include <irg/core/interleaved_lanes.hpp>
#include <irg/math/detail/mat_kernel.hpp>
#include <irg/math/length.hpp>

namespace irg::detail::inline IRG_ABI {

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
  const auto factor = one / square_root_instruction(select(square > 0, square, one));
  return {a.x * factor, a.y * factor, a.z * factor};
}

// Floats: their squares are exact in double and stay far inside its range, so nothing need be scaled.
template <int N>
IRG_INLINE triple_lanes<float, N> normalize_lanes(const triple_lanes<float, N>& a) noexcept {
  using F = pack<double, N>;
  const F x = converted<double>(a.x), y = converted<double>(a.y), z = converted<double>(a.z);
  const F square = (x * x + y * y) + z * z, one = lanes<F>::broadcast(1);
  // A square of 0, infinity or NaN: no direction.
  const auto has_direction = both(square > 0, square < std::numeric_limits<double>::infinity());
  const F factor = one / square_root_instruction(select(has_direction, square, one));
  const auto unit = [&](const F& c) {
    return converted<float>(select(has_direction, c * factor, lanes<F>::broadcast(0)));
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
  constexpr int count = widest_lanes<T>;
  by_registers<count>(n, one, [&](std::size_t i) IRG_INLINE_LAMBDA {
    lanes<pack<T, count>>::store(out + i, dot_lanes(load_triples<count>(a + 3 * i), load_triples<count>(b + 3 * i)));
  });
}
template <class T, class One>
void crosses_in_lanes(const T* a, const T* b, T* out, std::size_t n, const One& one) noexcept {
  constexpr int count = widest_lanes<T>;
  by_registers<count>(n, one, [&](std::size_t i) IRG_INLINE_LAMBDA {
    store_triples(out + 3 * i, cross_lanes(load_triples<count>(a + 3 * i), load_triples<count>(b + 3 * i)));
  });
}
template <class T, class One>
void normalize_fast_in_lanes(const T* v, T* out, std::size_t n, const One& one) noexcept {
  constexpr int count = widest_lanes<T>;
  by_registers<count>(n, one, [&](std::size_t i) IRG_INLINE_LAMBDA {
    store_triples(out + 3 * i, normalize_fast_lanes(load_triples<count>(v + 3 * i)));
  });
}
template <class One>
void normalize_in_lanes(const float* v, float* out, std::size_t n, const One& one) noexcept {
  constexpr int count = widest_lanes<double>;
  by_registers<count>(n, one, [&](std::size_t i) IRG_INLINE_LAMBDA {
    store_triples(out + 3 * i, normalize_lanes<count>(load_triples<count>(v + 3 * i)));
  });
}

// What constant evaluation and machines without lanes do: one(i) for each of n.
template <class T, class One>
constexpr void dots(const T* a, const T* b, T* out, std::size_t n, const One& one) noexcept {
  if (has_lanes && !std::is_constant_evaluated()) return dots_in_lanes(a, b, out, n, one);
  for (std::size_t i = 0; i < n; ++i) one(i);
}
template <class T, class One>
constexpr void crosses(const T* a, const T* b, T* out, std::size_t n, const One& one) noexcept {
  if (has_lanes && !std::is_constant_evaluated()) return crosses_in_lanes(a, b, out, n, one);
  for (std::size_t i = 0; i < n; ++i) one(i);
}
template <class T, class One>
constexpr void normalize_fast(const T* v, T* out, std::size_t n, const One& one) noexcept {
  if (has_lanes && !std::is_constant_evaluated()) return normalize_fast_in_lanes(v, out, n, one);
  for (std::size_t i = 0; i < n; ++i) one(i);
}
template <class T, class One>
constexpr void normalize(const T* v, T* out, std::size_t n, const One& one) noexcept {
  if constexpr (std::is_same_v<T, float> && has_lanes && native_bytes >= 32)  // a double's needs more than its range
    if (!std::is_constant_evaluated()) return normalize_in_lanes(v, out, n, one);
  for (std::size_t i = 0; i < n; ++i) one(i);
}

}  // namespace irg::detail::inline IRG_ABI
