// SPDX-License-Identifier: MIT
// Triples x y z x y z ... in memory, such as arrays of points, as packs of x, of y and of z, and back: three registers
// are read or written whole and their lanes sorted, where one load a coordinate would take N times as many. And
// quadruples of 32-bit words from anywhere in memory: one load each, where gathering words takes four.
#pragma once

#include <cstring>
#include <utility>

#include <irg/core/lanes.hpp>

namespace irg {
inline namespace IRG_ABI {

/// The coordinates of N triples, a lane each.
template <class T, int N>
struct triple_lanes {
  pack<T, N> x, y, z;
};

/// The words of N quadruples, a lane each; `w` is the fourth.
template <int N>
struct quadruple_lanes {
  pack<float, N> x, y, z, w;
};

namespace lanes_detail {

#ifdef IRG_LANES_VECTOR

// Lane i of the result is lane index(i) of a and b, one behind the other.
template <class T, int N, class Index>
IRG_INLINE pack<T, N> shuffled(const pack<T, N>& a, const pack<T, N>& b, Index) noexcept {
  return [&]<int... I>(std::integer_sequence<int, I...>) -> pack<T, N> {
    return {__builtin_shufflevector(a.v, b.v, Index{}(I)...)};
  }(std::make_integer_sequence<int, N>{});
}

// Coordinate C out of three registers in a row; in two steps, since a shuffle takes two registers.
template <int C, class T, int N>
IRG_INLINE pack<T, N> every_third(const pack<T, N>& r0, const pack<T, N>& r1, const pack<T, N>& r2) noexcept {
  const auto first = shuffled(r0, r1, [](int i) { return 3 * i + C < 2 * N ? 3 * i + C : 0; });
  return shuffled(first, r2, [](int i) { return 3 * i + C < 2 * N ? i : 3 * i + C - N; });
}

// Register G of three in a row that hold x y z x y z ...
template <int G, class T, int N>
IRG_INLINE pack<T, N> interleaved(const triple_lanes<T, N>& t) noexcept {
  const auto first = shuffled(t.x, t.y, [](int i) { return (G * N + i) / 3 + ((G * N + i) % 3 == 1 ? N : 0); });
  return shuffled(first, t.z, [](int i) { return (G * N + i) % 3 == 2 ? (G * N + i) / 3 + N : i; });
}

// Eight floats, in the two halves of a register: no lane has to cross from one into the other. Of registers h0, h1, h2
// of two halves each, the lower halves are the first twelve floats.
struct half_registers {
  pack<float, 8> h0, h1, h2;
};
IRG_INLINE half_registers load_halves(const float* p) noexcept {
  const auto halves = [&](int i) -> pack<float, 8> {
    const auto low = lanes<pack<float, 4>>::load(p + 4 * i).v, high = lanes<pack<float, 4>>::load(p + 4 * i + 12).v;
    return {__builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7)};
  };
  return {halves(0), halves(1), halves(2)};
}
template <class Store>
IRG_INLINE void store_halves(float* p, const half_registers& h, const Store& store) noexcept {
  const auto halves = [&](int i, const pack<float, 8>& v) {
    store(p + 4 * i, pack<float, 4>{__builtin_shufflevector(v.v, v.v, 0, 1, 2, 3)});
    store(p + 4 * i + 12, pack<float, 4>{__builtin_shufflevector(v.v, v.v, 4, 5, 6, 7)});
  };
  halves(0, h.h0);
  halves(1, h.h1);
  halves(2, h.h2);
}

#endif

}  // namespace lanes_detail

/// N triples from p on.
template <int N, class T>
IRG_INLINE triple_lanes<T, N> load_triples(const T* p) noexcept {
#ifdef IRG_LANES_VECTOR
  using F = lanes<pack<T, N>>;
  if constexpr (std::is_same_v<T, float> && N == 4) {
    const auto a = F::load(p).v, b = F::load(p + 4).v, c = F::load(p + 8).v;  // x y z x, y z x y, z x y z
    const auto xb = __builtin_shufflevector(b, c, 2, 2, 5, 5), ya = __builtin_shufflevector(a, b, 1, 1, 4, 4),
               yb = __builtin_shufflevector(b, c, 3, 3, 6, 6), za = __builtin_shufflevector(a, b, 2, 2, 5, 5);
    return {{__builtin_shufflevector(a, xb, 0, 3, 4, 6)},
            {__builtin_shufflevector(ya, yb, 0, 2, 4, 6)},
            {__builtin_shufflevector(za, c, 0, 2, 4, 7)}};
  } else if constexpr (std::is_same_v<T, float> && N == 8) {
    const auto [ra, rb, rc] = lanes_detail::load_halves(p);
    const auto a = ra.v, b = rb.v, c = rc.v;
    const auto xb = __builtin_shufflevector(b, c, 2, 2, 9, 9, 6, 6, 13, 13),
               ya = __builtin_shufflevector(a, b, 1, 1, 8, 8, 5, 5, 12, 12),
               yb = __builtin_shufflevector(b, c, 3, 3, 10, 10, 7, 7, 14, 14),
               za = __builtin_shufflevector(a, b, 2, 2, 9, 9, 6, 6, 13, 13);
    return {{__builtin_shufflevector(a, xb, 0, 3, 8, 10, 4, 7, 12, 14)},
            {__builtin_shufflevector(ya, yb, 0, 2, 8, 10, 4, 6, 12, 14)},
            {__builtin_shufflevector(za, c, 0, 2, 8, 11, 4, 6, 12, 15)}};
  } else {
    const auto r0 = F::load(p), r1 = F::load(p + N), r2 = F::load(p + 2 * N);
    return {lanes_detail::every_third<0>(r0, r1, r2), lanes_detail::every_third<1>(r0, r1, r2),
            lanes_detail::every_third<2>(r0, r1, r2)};
  }
#else
  triple_lanes<T, N> t;
  for (int i = 0; i < N; ++i) {
    t.x.v[i] = p[3 * i];
    t.y.v[i] = p[3 * i + 1];
    t.z.v[i] = p[3 * i + 2];
  }
  return t;
#endif
}

/// The reverse: N triples to p, a register at a time by store(address, pack).
/// shape   eight floats are stored in halves of registers; there, `store` gets packs of four
template <class T, int N, class Store>
IRG_INLINE void store_triples(T* p, const triple_lanes<T, N>& t, const Store& store) noexcept {
#ifdef IRG_LANES_VECTOR
  const auto x = t.x.v, y = t.y.v, z = t.z.v;
  if constexpr (std::is_same_v<T, float> && N == 4) {
    const auto xy01 = __builtin_shufflevector(x, y, 0, 4, 1, 5), xy23 = __builtin_shufflevector(x, y, 2, 6, 3, 7);
    const auto zx01 = __builtin_shufflevector(z, x, 0, 0, 5, 5), yz1 = __builtin_shufflevector(y, z, 1, 1, 5, 5),
               zx23 = __builtin_shufflevector(z, x, 2, 2, 7, 7), yz3 = __builtin_shufflevector(y, z, 3, 3, 7, 7);
    store(p, pack<T, N>{__builtin_shufflevector(xy01, zx01, 0, 1, 4, 6)});
    store(p + 4, pack<T, N>{__builtin_shufflevector(yz1, xy23, 0, 2, 4, 5)});
    store(p + 8, pack<T, N>{__builtin_shufflevector(zx23, yz3, 0, 2, 4, 6)});
  } else if constexpr (std::is_same_v<T, float> && N == 8) {
    const auto xy01 = __builtin_shufflevector(x, y, 0, 8, 1, 9, 4, 12, 5, 13),
               xy23 = __builtin_shufflevector(x, y, 2, 10, 3, 11, 6, 14, 7, 15);
    const auto zx01 = __builtin_shufflevector(z, x, 0, 0, 9, 9, 4, 4, 13, 13),
               yz1 = __builtin_shufflevector(y, z, 1, 1, 9, 9, 5, 5, 13, 13),
               zx23 = __builtin_shufflevector(z, x, 2, 2, 11, 11, 6, 6, 15, 15),
               yz3 = __builtin_shufflevector(y, z, 3, 3, 11, 11, 7, 7, 15, 15);
    lanes_detail::store_halves(p,
                               {{__builtin_shufflevector(xy01, zx01, 0, 1, 8, 10, 4, 5, 12, 14)},
                                {__builtin_shufflevector(yz1, xy23, 0, 2, 8, 9, 4, 6, 12, 13)},
                                {__builtin_shufflevector(zx23, yz3, 0, 2, 8, 10, 4, 6, 12, 14)}},
                               store);
  } else {
    store(p, lanes_detail::interleaved<0>(t));
    store(p + N, lanes_detail::interleaved<1>(t));
    store(p + 2 * N, lanes_detail::interleaved<2>(t));
  }
#else
  T sorted[3u * static_cast<unsigned>(N)];
  for (int i = 0; i < N; ++i) {
    sorted[3 * i] = t.x[i];
    sorted[3 * i + 1] = t.y[i];
    sorted[3 * i + 2] = t.z[i];
  }
  for (int k = 0; k < 3; ++k) store(p + N * k, lanes<pack<T, N>>::load(sorted + N * k));
#endif
}
template <class T, int N>
IRG_INLINE void store_triples(T* p, const triple_lanes<T, N>& t) noexcept {
  store_triples(p, t, [](T* to, const auto& f) { lanes<std::remove_cvref_t<decltype(f)>>::store(to, f); });
}

/// N quadruples of 32-bit words, lane i those from address_of(i) on.
template <int N, class AddressOf>
IRG_INLINE quadruple_lanes<N> load_quadruples(const AddressOf& address_of) noexcept {
#if defined(IRG_LANES_VECTOR) && __has_builtin(__builtin_shufflevector)
  const auto row = [&](int i) {
    pack<float, 4> words;
    std::memcpy(&words.v, address_of(i), sizeof words.v);
    return words.v;
  };
  if constexpr (N == 4) {
    const auto r0 = row(0), r1 = row(1), r2 = row(2), r3 = row(3);
    const auto xy01 = __builtin_shufflevector(r0, r1, 0, 4, 1, 5), xy23 = __builtin_shufflevector(r2, r3, 0, 4, 1, 5),
               zw01 = __builtin_shufflevector(r0, r1, 2, 6, 3, 7), zw23 = __builtin_shufflevector(r2, r3, 2, 6, 3, 7);
    return {{__builtin_shufflevector(xy01, xy23, 0, 1, 4, 5)},
            {__builtin_shufflevector(xy01, xy23, 2, 3, 6, 7)},
            {__builtin_shufflevector(zw01, zw23, 0, 1, 4, 5)},
            {__builtin_shufflevector(zw01, zw23, 2, 3, 6, 7)}};
  }
  if constexpr (N == 8) {
    // Lanes i and i + 4 in the two halves of a register, so that no word has to cross over later.
    const auto rows = [&](int i) -> pack<float, 8> {
      return {__builtin_shufflevector(row(i), row(i + 4), 0, 1, 2, 3, 4, 5, 6, 7)};
    };
    const auto r0 = rows(0).v, r1 = rows(1).v, r2 = rows(2).v, r3 = rows(3).v;
    const auto xy01 = __builtin_shufflevector(r0, r1, 0, 8, 1, 9, 4, 12, 5, 13),
               xy23 = __builtin_shufflevector(r2, r3, 0, 8, 1, 9, 4, 12, 5, 13),
               zw01 = __builtin_shufflevector(r0, r1, 2, 10, 3, 11, 6, 14, 7, 15),
               zw23 = __builtin_shufflevector(r2, r3, 2, 10, 3, 11, 6, 14, 7, 15);
    return {{__builtin_shufflevector(xy01, xy23, 0, 1, 8, 9, 4, 5, 12, 13)},
            {__builtin_shufflevector(xy01, xy23, 2, 3, 10, 11, 6, 7, 14, 15)},
            {__builtin_shufflevector(zw01, zw23, 0, 1, 8, 9, 4, 5, 12, 13)},
            {__builtin_shufflevector(zw01, zw23, 2, 3, 10, 11, 6, 7, 14, 15)}};
  }
#endif
  quadruple_lanes<N> q;
  for (int i = 0; i < N; ++i) {
    float words[4];
    std::memcpy(words, address_of(i), sizeof words);
    q.x.v[i] = words[0];
    q.y.v[i] = words[1];
    q.z.v[i] = words[2];
    q.w.v[i] = words[3];
  }
  return q;
}

/// The reverse, one behind the other: 16 * N bytes from `to` on.
template <int N>
IRG_INLINE void store_quadruples(void* to, const quadruple_lanes<N>& q) noexcept {
#if defined(IRG_LANES_VECTOR) && __has_builtin(__builtin_shufflevector)
  const auto x = q.x.v, y = q.y.v, z = q.z.v, w = q.w.v;
  if constexpr (N == 4) {
    const auto xy01 = __builtin_shufflevector(x, y, 0, 4, 1, 5), xy23 = __builtin_shufflevector(x, y, 2, 6, 3, 7),
               zw01 = __builtin_shufflevector(z, w, 0, 4, 1, 5), zw23 = __builtin_shufflevector(z, w, 2, 6, 3, 7);
    const typename pack<float, N>::storage rows[4] = {
        __builtin_shufflevector(xy01, zw01, 0, 1, 4, 5), __builtin_shufflevector(xy01, zw01, 2, 3, 6, 7),
        __builtin_shufflevector(xy23, zw23, 0, 1, 4, 5), __builtin_shufflevector(xy23, zw23, 2, 3, 6, 7)};
    std::memcpy(to, rows, sizeof rows);
    return;
  }
  if constexpr (N == 8) {
    const auto xy01 = __builtin_shufflevector(x, y, 0, 8, 1, 9, 4, 12, 5, 13),
               xy23 = __builtin_shufflevector(x, y, 2, 10, 3, 11, 6, 14, 7, 15),
               zw01 = __builtin_shufflevector(z, w, 0, 8, 1, 9, 4, 12, 5, 13),
               zw23 = __builtin_shufflevector(z, w, 2, 10, 3, 11, 6, 14, 7, 15);
    const auto store = [&](int i, const auto& rows) {  // quadruples i and i + 4
      char* const at = static_cast<char*>(to) + 16 * i;
      std::memcpy(at, &rows, 16);
      std::memcpy(at + 64, reinterpret_cast<const char*>(&rows) + 16, 16);
    };
    store(0, __builtin_shufflevector(xy01, zw01, 0, 1, 8, 9, 4, 5, 12, 13));
    store(1, __builtin_shufflevector(xy01, zw01, 2, 3, 10, 11, 6, 7, 14, 15));
    store(2, __builtin_shufflevector(xy23, zw23, 0, 1, 8, 9, 4, 5, 12, 13));
    store(3, __builtin_shufflevector(xy23, zw23, 2, 3, 10, 11, 6, 7, 14, 15));
    return;
  }
#endif
  for (int i = 0; i < N; ++i) {
    const float words[4] = {q.x.v[i], q.y.v[i], q.z.v[i], q.w.v[i]};
    std::memcpy(static_cast<char*>(to) + 16 * i, words, sizeof words);
  }
}

}  // namespace IRG_ABI
}  // namespace irg
