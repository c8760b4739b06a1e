// SPDX-License-Identifier: MIT
// Packs from and to memory that is not simply a row of their size: from anywhere, and rows that end earlier.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

#include <irg/core/lane_integers.hpp>
#include <irg/core/lane_shuffles.hpp>
#include <irg/core/pack.hpp>

namespace irg::inline IRG_ABI {

/// The T that stands index[i] * 4 bytes behind base, in lane i.
/// needs   a T of four bytes
template <class T, int N>
[[nodiscard]] IRG_INLINE pack<T, N> gather(const void* base, const pack<std::int32_t, N>& index) noexcept {
  static_assert(sizeof(T) == 4);
#if defined(IRG_LANES_VECTOR) && defined(__AVX2__)
  if constexpr (N == 8) {
    typedef int ints __attribute__((vector_size(32)));
#ifdef __clang__
    const ints words = __builtin_ia32_gatherd_d256(ints{}, static_cast<const int*>(base), index.v, ints{} - 1, 4);
#else
    const ints words = __builtin_ia32_gathersiv8si(ints{}, static_cast<const int*>(base), index.v, ints{} - 1, 4);
#endif
    return {reinterpret_cast<typename pack<T, N>::storage>(words)};
  }
#endif
  const auto at = [&](int i) {
    T value;
    std::memcpy(&value, static_cast<const char*>(base) + std::int64_t{index[i]} * 4, 4);
    return value;
  };
  if constexpr (N == 4) return pack_of(at(0), at(1), at(2), at(3));  // no way through memory
  return lanes<pack<T, N>>::generate(at);
}

/// N bytes: those of a value again and again.
/// needs   a trivially copyable V; sizeof(V) a power of two, at most N
template <int N, class V>
[[nodiscard]] IRG_INLINE pack<std::uint8_t, N> repeated_bytes(const V& value) noexcept {
  constexpr int size = static_cast<int>(sizeof(V));
  if constexpr (size > 8) {
    return repeated<N>(lanes<pack<std::uint8_t, size>>::load_bytes(&value));
  } else {
    using number = lanes_detail::signed_integer<size>;
    return bits_as<std::uint8_t>(lanes<pack<number, N / size>>::broadcast(lanes<number>::load_bytes(&value)));
  }
}

/// Writes the first `Bytes` bytes of a pack to p.
template <int Bytes, class T, int N>
IRG_INLINE void store_first_bytes(void* p, const pack<T, N>& f) noexcept {
  static_assert(Bytes <= static_cast<int>(sizeof f));
  std::memcpy(p, &f.v, static_cast<std::size_t>(Bytes));
}

/// Whether load_some and store_some leave out what is beyond by instructions of their own.
#if defined(IRG_LANES_VECTOR) && defined(__AVX2__)
inline constexpr bool has_masked_stores = true;
#else
inline constexpr bool has_masked_stores = false;
#endif

#if defined(IRG_LANES_VECTOR) && defined(__AVX2__)
namespace lanes_detail {

// All bits set in the first `count` lanes.
alignas(64) inline constexpr std::int32_t in_or_out[16] = {-1, -1, -1, -1, -1, -1, -1, -1};
template <int N>
[[nodiscard]] IRG_INLINE pack<std::int32_t, N> first_lanes(int count) noexcept {
  return lanes<pack<std::int32_t, N>>::load(in_or_out + 8 - count);
}

}  // namespace lanes_detail
#endif

/// i, but no more than last: without a branch, which a comparison might become.
[[nodiscard]] IRG_INLINE int no_further_than(int last, int i) noexcept {
  const int rest = last - i;
  return i + (rest & (rest >> 31));
}

/// The first `count` numbers from p on, in as many lanes; what is in the others is not said. Nothing beyond is read,
/// and there is no branch.
/// needs   a T of four bytes; 1 <= count <= N
template <class T, int N>
[[nodiscard]] IRG_INLINE pack<T, N> load_some(const void* p, int count) noexcept {
  static_assert(sizeof(T) == 4);
#if defined(IRG_LANES_VECTOR) && defined(__AVX2__)
  using ints = pack<std::int32_t, N>;
  using storage = typename pack<T, N>::storage;
  [[maybe_unused]] const auto* const at = static_cast<const typename ints::storage*>(p);
  if constexpr (N == 8)
    return {reinterpret_cast<storage>(__builtin_ia32_maskloadd256(at, lanes_detail::first_lanes<N>(count).v))};
  if constexpr (N == 4)
    return {reinterpret_cast<storage>(__builtin_ia32_maskloadd(at, lanes_detail::first_lanes<N>(count).v))};
#endif
  // Lanes past the last number read it once more.
  const auto one = [&](int i) {
    T value;
    std::memcpy(&value, static_cast<const char*>(p) + std::ptrdiff_t{4} * no_further_than(count - 1, i), 4);
    return value;
  };
  if constexpr (N == 4) return pack_of(one(0), one(1), one(2), one(3));
  return lanes<pack<T, N>>::generate(one);
}

/// Writes the first `count` lanes to p. Nothing beyond is written, and there is no branch.
/// needs   as load_some; count may be 0 where has_masked_stores
template <class T, int N>
IRG_INLINE void store_some(void* p, const pack<T, N>& f, int count) noexcept {
  static_assert(sizeof(T) == 4);
#if defined(IRG_LANES_VECTOR) && defined(__AVX2__)
  using ints = typename pack<std::int32_t, N>::storage;
  [[maybe_unused]] auto* const at = static_cast<ints*>(p);
  if constexpr (N == 8)
    return __builtin_ia32_maskstored256(at, lanes_detail::first_lanes<N>(count).v, reinterpret_cast<ints>(f.v));
  if constexpr (N == 4)
    return __builtin_ia32_maskstored(at, lanes_detail::first_lanes<N>(count).v, reinterpret_cast<ints>(f.v));
#endif
  // Lanes past the last number are stored where it belongs; from the last lane down, so that its own value comes last.
  for (int i = N - 1; i >= 0; --i) {
    const T value = f[i];
    std::memcpy(static_cast<char*>(p) + std::ptrdiff_t{4} * no_further_than(count - 1, i), &value, 4);
  }
}

#if defined(IRG_LANES_VECTOR) && defined(__AVX2__) && !defined(__AVX512VL__)
namespace lanes_detail {

struct set_bits_table {
  std::uint32_t places[256];
  IRG_INLINE constexpr std::uint32_t operator[](unsigned bits) const noexcept { return places[bits & 255]; }
};
// The places of the bits that are set in each byte, four bits a place, the first lowest.
inline constexpr set_bits_table places_of_set_bits = [] {
  set_bits_table table{};
  for (unsigned bits = 0; bits < 256; ++bits) {
    unsigned at = 0;
    for (unsigned k = 0; k < 8; ++k)
      if ((bits >> k & 1) != 0) {
        table.places[bits] |= k << at;
        at += 4;
      }
  }
  return table;
}();

}  // namespace lanes_detail
#endif

/// The lanes whose bits are set, one behind the other from `to` on, where there must be room for all lanes.
/// gives   how many they are
template <class T, int N>
IRG_INLINE int store_compressed(T* to, const pack<T, N>& from, unsigned bits) noexcept {
  static_assert(sizeof(T) == 4);
#if defined(IRG_LANES_VECTOR) && defined(__AVX512VL__)
  if constexpr (N == 8) {
    typedef int ints __attribute__((vector_size(32)));
    const ints packed =
        __builtin_ia32_compresssi256_mask(reinterpret_cast<ints>(from.v), ints{}, static_cast<unsigned char>(bits));
    std::memcpy(to, &packed, sizeof packed);
    return std::popcount(bits);
  }
#elif defined(IRG_LANES_VECTOR) && defined(__AVX2__)
  if constexpr (N == 8) {
    typedef int ints __attribute__((vector_size(32)));
    typedef unsigned places __attribute__((vector_size(32)));
    constexpr places shifts = {0, 4, 8, 12, 16, 20, 24, 28};
    const places place = (lanes_detail::places_of_set_bits[bits] - places{}) >> shifts;
    const ints packed = __builtin_ia32_permvarsi256(reinterpret_cast<ints>(from.v), reinterpret_cast<ints>(place));
    std::memcpy(to, &packed, sizeof packed);
    return std::popcount(bits);
  }
#endif
  T all[static_cast<unsigned>(N)];
  lanes<pack<T, N>>::store(all, from);
  int n = 0;
  for (unsigned k = 0; k < static_cast<unsigned>(N); ++k) {
    to[n] = all[k];
    n += static_cast<int>(bits >> k & 1);
  }
  return n;
}

}  // namespace irg::inline IRG_ABI
