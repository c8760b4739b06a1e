// SPDX-License-Identifier: MIT
// Triples x y z x y z ... in memory, such as arrays of points, as packs of x, of y and of z, and back: three registers
// are read or written whole and their lanes sorted, where one load a coordinate would take N times as many. And
// quadruples of 32-bit words from anywhere in memory: one load each, where gathering words takes four.
#pragma once

#include <cstring>
#include <utility>

#include <irg/core/lanes.hpp>

namespace irg::inline IRG_ABI {

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
[[nodiscard]] IRG_INLINE pack<T, N> every_third(const pack<T, N>& r0, const pack<T, N>& r1,
                                                const pack<T, N>& r2) noexcept {
  const auto first = shuffled_by<N>(r0, r1, [](int i) { return 3 * i + C < 2 * N ? 3 * i + C : 0; });
  return shuffled_by<N>(first, r2, [](int i) { return 3 * i + C < 2 * N ? i : 3 * i + C - N; });
}

// Register G of three in a row that hold x y z x y z ...
template <int G, class T, int N>
[[nodiscard]] IRG_INLINE pack<T, N> interleaved(const triple_lanes<T, N>& t) noexcept {
  const auto first = shuffled_by<N>(t.x, t.y, [](int i) { return (G * N + i) / 3 + ((G * N + i) % 3 == 1 ? N : 0); });
  return shuffled_by<N>(first, t.z, [](int i) { return (G * N + i) % 3 == 2 ? (G * N + i) / 3 + N : i; });
}

// The lanes J of a and b, 0 to 3 and 4 to 7, in each group of four lanes alike: none has to cross from one group into
// another.
template <int... J, class T, int N>
[[nodiscard]] IRG_INLINE pack<T, N> in_fours(const pack<T, N>& a, const pack<T, N>& b) noexcept {
  return shuffled_by<N>(a, b, [](int i) {
    constexpr int of[4] = {J...};
    return (of[i % 4] < 4 ? of[i % 4] : of[i % 4] - 4 + N) + i / 4 * 4;
  });
}

// Whether N words of type T are sorted in groups of four.
template <class T, int N>
inline constexpr bool sorted_in_fours = sizeof(T) == 4 && (N == 4 || N == 8);

// The groups of four lanes load(0) and, where there are eight lanes, load(1).
template <int N, class Load>
[[nodiscard]] IRG_INLINE auto load_fours(const Load& load) noexcept {
  if constexpr (N == 4)
    return load(0);
  else
    return shuffled<0, 1, 2, 3, 4, 5, 6, 7>(load(0), load(1));
}
}  // namespace lanes_detail

/// N triples from p on.
template <int N, class T>
[[nodiscard]] IRG_INLINE triple_lanes<T, N> load_triples(const T* p) noexcept {
  using F = lanes<pack<T, N>>;
  if constexpr (lanes_detail::sorted_in_fours<T, N>) {
    using namespace lanes_detail;
    const auto load = [&](int i) {
      return load_fours<N>([&](int group) { return lanes<pack<T, 4>>::load(p + 4 * i + 12 * group); });
    };
    const auto a = load(0), b = load(1), c = load(2);  // x y z x, y z x y, z x y z
    const auto xb = in_fours<2, 2, 5, 5>(b, c), ya = in_fours<1, 1, 4, 4>(a, b), yb = in_fours<3, 3, 6, 6>(b, c),
               za = in_fours<2, 2, 5, 5>(a, b);
    return {in_fours<0, 3, 4, 6>(a, xb), in_fours<0, 2, 4, 6>(ya, yb), in_fours<0, 2, 4, 7>(za, c)};
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
  if constexpr (lanes_detail::sorted_in_fours<T, N>) {
    using namespace lanes_detail;
    const auto store_all = [&](int i, const pack<T, N>& f) {
      store(p + 4 * i, shuffled<0, 1, 2, 3>(f));
      if constexpr (N == 8) store(p + 4 * i + 12, high_half(f));
    };
    const auto xy01 = in_fours<0, 4, 1, 5>(x, y), xy23 = in_fours<2, 6, 3, 7>(x, y), zx01 = in_fours<0, 0, 5, 5>(z, x),
               yz1 = in_fours<1, 1, 5, 5>(y, z), zx23 = in_fours<2, 2, 7, 7>(z, x), yz3 = in_fours<3, 3, 7, 7>(y, z);
    store_all(0, in_fours<0, 1, 4, 6>(xy01, zx01));
    store_all(1, in_fours<0, 2, 4, 5>(yz1, xy23));
    store_all(2, in_fours<0, 2, 4, 6>(zx23, yz3));
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
[[nodiscard]] IRG_INLINE quadruple_lanes<N> load_quadruples(const AddressOf& address_of) noexcept {
  if constexpr (lanes_detail::sorted_in_fours<float, N>) {
    using namespace lanes_detail;
    const auto row = [&](int i) {
      return load_fours<N>([&](int group) { return lanes<pack<float, 4>>::load_bytes(address_of(i + 4 * group)); });
    };
    const auto r0 = row(0), r1 = row(1), r2 = row(2), r3 = row(3);
    const auto xy01 = in_fours<0, 4, 1, 5>(r0, r1), xy23 = in_fours<0, 4, 1, 5>(r2, r3),
               zw01 = in_fours<2, 6, 3, 7>(r0, r1), zw23 = in_fours<2, 6, 3, 7>(r2, r3);
    return {in_fours<0, 1, 4, 5>(xy01, xy23), in_fours<2, 3, 6, 7>(xy01, xy23), in_fours<0, 1, 4, 5>(zw01, zw23),
            in_fours<2, 3, 6, 7>(zw01, zw23)};
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
  char* const first = static_cast<char*>(to);
  if constexpr (lanes_detail::sorted_in_fours<float, N>) {
    using namespace lanes_detail;
    const auto store = [&](int i, const pack<float, N>& f) {
      for (int group = 0; group < N / 4; ++group)  // not as halves of the pack, which g++ would take by way of memory
        std::memcpy(first + 16 * i + 64 * group, reinterpret_cast<const char*>(&f) + 16 * group, 16);
    };
    const auto xy01 = in_fours<0, 4, 1, 5>(x, y), xy23 = in_fours<2, 6, 3, 7>(x, y), zw01 = in_fours<0, 4, 1, 5>(z, w),
               zw23 = in_fours<2, 6, 3, 7>(z, w);
    store(0, in_fours<0, 1, 4, 5>(xy01, zw01));
    store(1, in_fours<2, 3, 6, 7>(xy01, zw01));
    store(2, in_fours<0, 1, 4, 5>(xy23, zw23));
    store(3, in_fours<2, 3, 6, 7>(xy23, zw23));
    return;
  }
  for (int i = 0; i < N; ++i) {
    const float words[4] = {x[i], y[i], z[i], w[i]};
    std::memcpy(first + 16 * i, words, sizeof words);
  }
}

}  // namespace irg::inline IRG_ABI
