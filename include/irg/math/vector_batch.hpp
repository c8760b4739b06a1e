// SPDX-License-Identifier: MIT
// Arrays of vectors: the results of dot, cross, normalized and normalized_fast, bit for bit, where a loop over those
// would take several times as long, because the guard against fused products keeps compilers from vectorising it.
#pragma once

#include <concepts>
#include <cstddef>
#include <limits>
#include <span>

#include <irg/core/contract.hpp>
#include <irg/core/interleaved_lanes.hpp>
#include <irg/math/detail/coordinate_rows_kernel.hpp>
#include <irg/math/detail/mat_kernel.hpp>
#include <irg/math/length.hpp>
#include <irg/math/vec.hpp>

namespace irg {

/// Vectors in a row: a span, an array or a container of vec<float, 3> or vec<double, 3>, or of your own vectors of
/// three floats or doubles.
template <class R>
concept VectorArray = requires {
  requires Vector<detail::element_of<R>>;
  requires detail::Triple<detail::element_of<R>>;
};

inline namespace IRG_ABI {

/// out[i] = dot(a[i], b[i]).
/// needs   as many vectors in a, in b and numbers in `out`, which overlaps neither
/// exact   the bits of dot
template <VectorArray A, VectorArray B>
  requires std::same_as<detail::element_of<const A>, detail::element_of<const B>>
constexpr void dot_products(const A& a, const B& b, std::span<scalar_of<detail::element_of<const A>>> out) noexcept;

/// out[i] = cross(a[i], b[i]).
/// needs   as many vectors in a, b and `out`, which begins where one of them does or does not overlap it
/// exact   the bits of cross
template <VectorArray A, VectorArray B>
  requires std::same_as<detail::element_of<const A>, detail::element_of<const B>> &&
           std::copyable<detail::element_of<const A>>
constexpr void cross_products(const A& a, const B& b, std::span<detail::element_of<const A>> out) noexcept;

/// out[i] = normalized(v[i]): the vector of length 1, or zero where there is no direction.
/// needs   as many vectors in v and `out`, which begins where v does or does not overlap it
/// exact   the bits of normalized
/// cost    floats take a fraction of a loop over normalized where the target has AVX2; doubles, and floats without it,
///         take that loop
template <VectorArray V>
  requires std::copyable<detail::element_of<const V>>
constexpr void normalize_vectors(const V& v, std::span<detail::element_of<const V>> out) noexcept;

/// out[i] = normalized_fast(v[i]).
/// needs   as many vectors in v and `out`, which begins where v does or does not overlap it; vectors as for
///         normalized_fast
/// exact   the bits of normalized_fast
template <VectorArray V>
  requires std::copyable<detail::element_of<const V>>
constexpr void normalize_vectors_fast(const V& v, std::span<detail::element_of<const V>> out) noexcept;

}  // namespace IRG_ABI

namespace detail::inline IRG_ABI {

// Arrays of vectors of three coordinates, a register of them at a time. Bit for bit what dot, cross, normalized and
// normalized_fast give one by one.

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
void dots(const T* a, const T* b, T* out, std::size_t n, const One& one) noexcept {
  constexpr int count = widest_lanes<T>;
  by_registers<count>(n, one, [&](std::size_t i) IRG_INLINE_LAMBDA {
    lanes<pack<T, count>>::store(out + i, dot_lanes(load_triples<count>(a + 3 * i), load_triples<count>(b + 3 * i)));
  });
}
template <class T, class One>
void crosses(const T* a, const T* b, T* out, std::size_t n, const One& one) noexcept {
  constexpr int count = widest_lanes<T>;
  by_registers<count>(n, one, [&](std::size_t i) IRG_INLINE_LAMBDA {
    store_triples(out + 3 * i, cross_lanes(load_triples<count>(a + 3 * i), load_triples<count>(b + 3 * i)));
  });
}
template <class T, class One>
void normalize_fast(const T* v, T* out, std::size_t n, const One& one) noexcept {
  constexpr int count = widest_lanes<T>;
  by_registers<count>(n, one, [&](std::size_t i) IRG_INLINE_LAMBDA {
    store_triples(out + 3 * i, normalize_fast_lanes(load_triples<count>(v + 3 * i)));
  });
}
template <class T, class One>
void normalize(const T* v, T* out, std::size_t n, const One& one) noexcept {
  if constexpr (std::is_same_v<T, float> && native_bytes >= 32) {  // a double's needs more than its range
    constexpr int count = widest_lanes<double>;
    by_registers<count>(n, one, [&](std::size_t i) IRG_INLINE_LAMBDA {
      store_triples(out + 3 * i, normalize_lanes<count>(load_triples<count>(v + 3 * i)));
    });
  } else {
    for (std::size_t i = 0; i < n; ++i) one(i);
  }
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

template <VectorArray A, VectorArray B>
  requires std::same_as<detail::element_of<const A>, detail::element_of<const B>>
constexpr void dot_products(const A& a, const B& b, std::span<scalar_of<detail::element_of<const A>>> out) noexcept {
  const std::span from(a), with(b);
  IRG_EXPECTS(from.size() == with.size() && from.size() == out.size());
  if (from.empty()) return;
  const auto one = [&](std::size_t i) { out[i] = dot(from[i], with[i]); };
  detail::by_rows(
      from.size(), one, [&](auto* v, auto* w) { detail::dots(v, w, out.data(), from.size(), one); }, from[0], with[0]);
}

template <VectorArray A, VectorArray B>
  requires std::same_as<detail::element_of<const A>, detail::element_of<const B>> &&
           std::copyable<detail::element_of<const A>>
constexpr void cross_products(const A& a, const B& b, std::span<detail::element_of<const A>> out) noexcept {
  const std::span from(a), with(b);
  IRG_EXPECTS(from.size() == with.size() && from.size() == out.size());
  if (from.empty()) return;
  const auto one = [&](std::size_t i) { out[i] = cross(from[i], with[i]); };
  detail::by_rows(
      from.size(), one, [&](auto* v, auto* w, auto* to) { detail::crosses(v, w, to, from.size(), one); }, from[0],
      with[0], out[0]);
}

template <VectorArray V>
  requires std::copyable<detail::element_of<const V>>
constexpr void normalize_vectors(const V& v, std::span<detail::element_of<const V>> out) noexcept {
  const std::span from(v);
  IRG_EXPECTS(from.size() == out.size());
  if (from.empty()) return;
  const auto one = [&](std::size_t i) { out[i] = normalized(from[i]); };
  detail::by_rows(
      from.size(), one, [&](auto* w, auto* to) { detail::normalize(w, to, from.size(), one); }, from[0], out[0]);
}

template <VectorArray V>
  requires std::copyable<detail::element_of<const V>>
constexpr void normalize_vectors_fast(const V& v, std::span<detail::element_of<const V>> out) noexcept {
  const std::span from(v);
  IRG_EXPECTS(from.size() == out.size());
  if (from.empty()) return;
  const auto one = [&](std::size_t i) { out[i] = normalized_fast(from[i]); };
  detail::by_rows(
      from.size(), one, [&](auto* w, auto* to) { detail::normalize_fast(w, to, from.size(), one); }, from[0], out[0]);
}

}  // namespace IRG_ABI
}  // namespace irg
