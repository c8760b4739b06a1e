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

// Coordinate C out of three registers in a row; in two steps, since a shuffle takes two registers.
template <int C, class T, int N>
IRG_INLINE pack<T, N> every_third(const pack<T, N>& r0, const pack<T, N>& r1, const pack<T, N>& r2) noexcept {
  const auto first = shuffled_by<N>(r0, r1, [](int i) { return 3 * i + C < 2 * N ? 3 * i + C : 0; });
  return shuffled_by<N>(first, r2, [](int i) { return 3 * i + C < 2 * N ? i : 3 * i + C - N; });
}

// Register G of three in a row that hold x y z x y z ...
template <int G, class T, int N>
IRG_INLINE pack<T, N> interleaved(const triple_lanes<T, N>& t) noexcept {
  const auto first = shuffled_by<N>(t.x, t.y, [](int i) { return (G * N + i) / 3 + ((G * N + i) % 3 == 1 ? N : 0); });
  return shuffled_by<N>(first, t.z, [](int i) { return (G * N + i) % 3 == 2 ? (G * N + i) / 3 + N : i; });
}

// Eight floats, in the two halves of a register: no lane has to cross from one into the other. Of registers h0, h1, h2
// of two halves each, the lower halves are the first twelve floats.
struct half_registers {
  pack<float, 8> h0, h1, h2;
};
IRG_INLINE half_registers load_halves(const float* p) noexcept {
  const auto halves = [&](int i) {
    using F = lanes<pack<float, 4>>;
    const auto low = F::load(p + 4 * i), high = F::load(p + 4 * i + 12);
    return shuffled<0, 1, 2, 3, 4, 5, 6, 7>(low, high);
  };
  return {halves(0), halves(1), halves(2)};
}
template <class Store>
IRG_INLINE void store_halves(float* p, const half_registers& h, const Store& store) noexcept {
  const auto halves = [&](int i, const pack<float, 8>& v) {
    store(p + 4 * i, low_half(v));
    store(p + 4 * i + 12, high_half(v));
  };
  halves(0, h.h0);
  halves(1, h.h1);
  halves(2, h.h2);
}

}  // namespace lanes_detail

/// N triples from p on.
template <int N, class T>
IRG_INLINE triple_lanes<T, N> load_triples(const T* p) noexcept {
  using F = lanes<pack<T, N>>;
  if constexpr (std::is_same_v<T, float> && N == 4) {
    const auto a = F::load(p), b = F::load(p + 4), c = F::load(p + 8);  // x y z x, y z x y, z x y z
    const auto xb = shuffled<2, 2, 5, 5>(b, c), ya = shuffled<1, 1, 4, 4>(a, b), yb = shuffled<3, 3, 6, 6>(b, c),
               za = shuffled<2, 2, 5, 5>(a, b);
    return {shuffled<0, 3, 4, 6>(a, xb), shuffled<0, 2, 4, 6>(ya, yb), shuffled<0, 2, 4, 7>(za, c)};
  } else if constexpr (std::is_same_v<T, float> && N == 8) {
    const auto [a, b, c] = lanes_detail::load_halves(p);
    const auto xb = shuffled<2, 2, 9, 9, 6, 6, 13, 13>(b, c), ya = shuffled<1, 1, 8, 8, 5, 5, 12, 12>(a, b),
               yb = shuffled<3, 3, 10, 10, 7, 7, 14, 14>(b, c), za = shuffled<2, 2, 9, 9, 6, 6, 13, 13>(a, b);
    return {shuffled<0, 3, 8, 10, 4, 7, 12, 14>(a, xb), shuffled<0, 2, 8, 10, 4, 6, 12, 14>(ya, yb),
            shuffled<0, 2, 8, 11, 4, 6, 12, 15>(za, c)};
  } else {
    const auto r0 = F::load(p), r1 = F::load(p + N), r2 = F::load(p + 2 * N);
    return {lanes_detail::every_third<0>(r0, r1, r2), lanes_detail::every_third<1>(r0, r1, r2),
            lanes_detail::every_third<2>(r0, r1, r2)};
  }
}

/// The reverse: N triples to p, a register at a time by store(address, pack).
/// shape   eight floats are stored in halves of registers; there, `store` gets packs of four
template <class T, int N, class Store>
IRG_INLINE void store_triples(T* p, const triple_lanes<T, N>& t, const Store& store) noexcept {
  const auto& [x, y, z] = t;
  if constexpr (std::is_same_v<T, float> && N == 4) {
    const auto xy01 = shuffled<0, 4, 1, 5>(x, y), xy23 = shuffled<2, 6, 3, 7>(x, y);
    const auto zx01 = shuffled<0, 0, 5, 5>(z, x), yz1 = shuffled<1, 1, 5, 5>(y, z), zx23 = shuffled<2, 2, 7, 7>(z, x),
               yz3 = shuffled<3, 3, 7, 7>(y, z);
    store(p, shuffled<0, 1, 4, 6>(xy01, zx01));
    store(p + 4, shuffled<0, 2, 4, 5>(yz1, xy23));
    store(p + 8, shuffled<0, 2, 4, 6>(zx23, yz3));
  } else if constexpr (std::is_same_v<T, float> && N == 8) {
    const auto xy01 = shuffled<0, 8, 1, 9, 4, 12, 5, 13>(x, y), xy23 = shuffled<2, 10, 3, 11, 6, 14, 7, 15>(x, y);
    const auto zx01 = shuffled<0, 0, 9, 9, 4, 4, 13, 13>(z, x), yz1 = shuffled<1, 1, 9, 9, 5, 5, 13, 13>(y, z),
               zx23 = shuffled<2, 2, 11, 11, 6, 6, 15, 15>(z, x), yz3 = shuffled<3, 3, 11, 11, 7, 7, 15, 15>(y, z);
    lanes_detail::store_halves(
        p,
        {shuffled<0, 1, 8, 10, 4, 5, 12, 14>(xy01, zx01), shuffled<0, 2, 8, 9, 4, 6, 12, 13>(yz1, xy23),
         shuffled<0, 2, 8, 10, 4, 6, 12, 14>(zx23, yz3)},
        store);
  } else {
    store(p, lanes_detail::interleaved<0>(t));
    store(p + N, lanes_detail::interleaved<1>(t));
    store(p + 2 * N, lanes_detail::interleaved<2>(t));
  }
}
template <class T, int N>
IRG_INLINE void store_triples(T* p, const triple_lanes<T, N>& t) noexcept {
  store_triples(p, t, [](T* to, const auto& f) { lanes<std::remove_cvref_t<decltype(f)>>::store(to, f); });
}

/// N quadruples of 32-bit words, lane i those from address_of(i) on.
template <int N, class AddressOf>
IRG_INLINE quadruple_lanes<N> load_quadruples(const AddressOf& address_of) noexcept {
  const auto row = [&](int i) { return lanes<pack<float, 4>>::load_bytes(address_of(i)); };
  if constexpr (N == 4) {
    const auto r0 = row(0), r1 = row(1), r2 = row(2), r3 = row(3);
    const auto xy01 = shuffled<0, 4, 1, 5>(r0, r1), xy23 = shuffled<0, 4, 1, 5>(r2, r3),
               zw01 = shuffled<2, 6, 3, 7>(r0, r1), zw23 = shuffled<2, 6, 3, 7>(r2, r3);
    return {shuffled<0, 1, 4, 5>(xy01, xy23), shuffled<2, 3, 6, 7>(xy01, xy23), shuffled<0, 1, 4, 5>(zw01, zw23),
            shuffled<2, 3, 6, 7>(zw01, zw23)};
  }
  if constexpr (N == 8) {
    // Lanes i and i + 4 in the two halves of a register, so that no word has to cross over later.
    const auto rows = [&](int i) { return shuffled<0, 1, 2, 3, 4, 5, 6, 7>(row(i), row(i + 4)); };
    const auto r0 = rows(0), r1 = rows(1), r2 = rows(2), r3 = rows(3);
    const auto xy01 = shuffled<0, 8, 1, 9, 4, 12, 5, 13>(r0, r1), xy23 = shuffled<0, 8, 1, 9, 4, 12, 5, 13>(r2, r3),
               zw01 = shuffled<2, 10, 3, 11, 6, 14, 7, 15>(r0, r1), zw23 = shuffled<2, 10, 3, 11, 6, 14, 7, 15>(r2, r3);
    return {shuffled<0, 1, 8, 9, 4, 5, 12, 13>(xy01, xy23), shuffled<2, 3, 10, 11, 6, 7, 14, 15>(xy01, xy23),
            shuffled<0, 1, 8, 9, 4, 5, 12, 13>(zw01, zw23), shuffled<2, 3, 10, 11, 6, 7, 14, 15>(zw01, zw23)};
  }
  quadruple_lanes<N> q{};
  for (int i = 0; i < N; ++i) {
    float words[4];
    std::memcpy(words, address_of(i), sizeof words);
    set_lane(q.x, i, words[0]);
    set_lane(q.y, i, words[1]);
    set_lane(q.z, i, words[2]);
    set_lane(q.w, i, words[3]);
  }
  return q;
}

/// The reverse, one behind the other: 16 * N bytes from `to` on.
template <int N>
IRG_INLINE void store_quadruples(void* to, const quadruple_lanes<N>& q) noexcept {
  const auto& [x, y, z, w] = q;
  if constexpr (N == 4) {
    const auto xy01 = shuffled<0, 4, 1, 5>(x, y), xy23 = shuffled<2, 6, 3, 7>(x, y), zw01 = shuffled<0, 4, 1, 5>(z, w),
               zw23 = shuffled<2, 6, 3, 7>(z, w);
    const pack<float, N> rows[4] = {shuffled<0, 1, 4, 5>(xy01, zw01), shuffled<2, 3, 6, 7>(xy01, zw01),
                                    shuffled<0, 1, 4, 5>(xy23, zw23), shuffled<2, 3, 6, 7>(xy23, zw23)};
    std::memcpy(to, rows, sizeof rows);
    return;
  }
  if constexpr (N == 8) {
    const auto xy01 = shuffled<0, 8, 1, 9, 4, 12, 5, 13>(x, y), xy23 = shuffled<2, 10, 3, 11, 6, 14, 7, 15>(x, y),
               zw01 = shuffled<0, 8, 1, 9, 4, 12, 5, 13>(z, w), zw23 = shuffled<2, 10, 3, 11, 6, 14, 7, 15>(z, w);
    const auto store = [&](int i, const auto& rows) {  // quadruples i and i + 4
      char* const at = static_cast<char*>(to) + 16 * i;
      std::memcpy(at, &rows, 16);
      std::memcpy(at + 64, reinterpret_cast<const char*>(&rows) + 16, 16);
    };
    store(0, shuffled<0, 1, 8, 9, 4, 5, 12, 13>(xy01, zw01));
    store(1, shuffled<2, 3, 10, 11, 6, 7, 14, 15>(xy01, zw01));
    store(2, shuffled<0, 1, 8, 9, 4, 5, 12, 13>(xy23, zw23));
    store(3, shuffled<2, 3, 10, 11, 6, 7, 14, 15>(xy23, zw23));
    return;
  }
  for (int i = 0; i < N; ++i) {
    const float words[4] = {x[i], y[i], z[i], w[i]};
    std::memcpy(static_cast<char*>(to) + 16 * i, words, sizeof words);
  }
}

}  // namespace IRG_ABI
}  // namespace irg
