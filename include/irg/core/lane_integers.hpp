// SPDX-License-Identifier: MIT
// Packs bit by bit, and conversions of their lanes.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include <irg/core/conversion.hpp>
#include <irg/core/pack.hpp>

namespace irg::inline IRG_ABI {

template <std::integral T, int N>
[[nodiscard]] IRG_INLINE pack<T, N> operator&(const pack<T, N>& a, const pack<T, N>& b) noexcept {
  return lanes_detail::lanewise<T, N>([](auto& r, const auto& x, const auto& y) { r = x & y; }, a, b);
}
template <std::integral T, int N>
[[nodiscard]] IRG_INLINE pack<T, N> operator|(const pack<T, N>& a, const pack<T, N>& b) noexcept {
  return lanes_detail::lanewise<T, N>([](auto& r, const auto& x, const auto& y) { r = x | y; }, a, b);
}
template <std::integral T, int N>
[[nodiscard]] IRG_INLINE pack<T, N> operator^(const pack<T, N>& a, const pack<T, N>& b) noexcept {
  return lanes_detail::lanewise<T, N>([](auto& r, const auto& x, const auto& y) { r = x ^ y; }, a, b);
}
template <std::integral T, int N>
[[nodiscard]] IRG_INLINE pack<T, N> operator&(const pack<T, N>& a, std::type_identity_t<T> b) noexcept {
  return a & lanes<pack<T, N>>::broadcast(b);
}
template <std::integral T, int N>
[[nodiscard]] IRG_INLINE pack<T, N> operator|(const pack<T, N>& a, std::type_identity_t<T> b) noexcept {
  return a | lanes<pack<T, N>>::broadcast(b);
}
template <std::integral T, int N>
[[nodiscard]] IRG_INLINE pack<T, N> operator^(const pack<T, N>& a, std::type_identity_t<T> b) noexcept {
  return a ^ lanes<pack<T, N>>::broadcast(b);
}
template <std::integral T, int N>
[[nodiscard]] IRG_INLINE pack<T, N> operator~(const pack<T, N>& a) noexcept {
  return lanes_detail::lanewise<T, N>([](auto& r, const auto& x) { r = ~x; }, a);
}

/// Each lane moved by so many bits: to the right, signs are carried along.
/// needs   0 <= bits, less than T has
template <std::integral T, int N>
[[nodiscard]] IRG_INLINE pack<T, N> operator<<(const pack<T, N>& a, int bits) noexcept {
  return lanes_detail::lanewise<T, N>([bits](auto& r, const auto& x) { r = x << static_cast<T>(bits); }, a);
}
template <std::integral T, int N>
[[nodiscard]] IRG_INLINE pack<T, N> operator>>(const pack<T, N>& a, int bits) noexcept {
  return lanes_detail::lanewise<T, N>([bits](auto& r, const auto& x) { r = x >> static_cast<T>(bits); }, a);
}

/// How far to the left, in an integer of `Size` bytes, the byte lies that stands `place` bytes behind its address.
template <int Size>
[[nodiscard]] constexpr int byte_shift(int place) noexcept {
  return 8 * (std::endian::native == std::endian::little ? place : Size - 1 - place);
}

/// Four numbers of 16 bits that follow each other in memory, read as one word and turned so that the first has the
/// lowest bits.
[[nodiscard]] constexpr std::uint64_t first_lowest(std::uint64_t word) noexcept {
  if constexpr (std::endian::native == std::endian::little) return word;
  word = word << 32 | word >> 32;
  return (word & 0x0000ffff0000ffff) << 16 | (word >> 16 & 0x0000ffff0000ffff);
}

/// The bits of a pack, read as numbers of another type: as many as its bytes hold.
template <class T, class U, int N>
[[nodiscard]] IRG_INLINE auto bits_as(const pack<U, N>& x) noexcept {
  constexpr int count = N * static_cast<int>(sizeof(U)) / static_cast<int>(sizeof(T));
#ifdef IRG_LANES_VECTOR
  return pack<T, count>{reinterpret_cast<typename pack<T, count>::storage>(x.v)};
#else
  return lanes<pack<T, count>>::load_bytes(&x);
#endif
}

namespace lanes_detail {

template <class To, class T, int N>
[[nodiscard]] IRG_INLINE pack<To, N> static_cast_lanes(const pack<T, N>& x) noexcept {
#if defined(IRG_LANES_VECTOR) && defined(__AVX__) && !defined(__clang__)
  // g++ 12 would convert halves and put them together.
  if constexpr (std::is_same_v<T, float> && std::is_same_v<To, double> && N == 4)
    return {__builtin_ia32_cvtps2pd256(x.v)};
#endif
#ifdef IRG_LANES_VECTOR
  return {__builtin_convertvector(x.v, typename pack<To, N>::storage)};
#else
  return lanes<pack<To, N>>::generate([&](int i) { return static_cast<To>(x[i]); });
#endif
}

}  // namespace lanes_detail

/// Each lane as a number of type To, as converted() of a number: floating numbers towards zero when To is an integer,
/// the lowest bits of integers that To cannot hold.
/// needs   floating numbers within To's range
template <class To, class T, int N>
[[nodiscard]] IRG_INLINE pack<To, N> converted(const pack<T, N>& x) noexcept {
  if constexpr (std::is_same_v<T, To>)
    return x;
  else if constexpr (std::is_same_v<T, float> && std::is_same_v<To, double>)
    return lanes_detail::static_cast_lanes<To>(opaque(x));
  else if constexpr (std::is_same_v<T, double> && std::is_same_v<To, float>)
    return opaque(lanes_detail::static_cast_lanes<To>(x));
  else
    return lanes_detail::static_cast_lanes<To>(x);
}

/// The integer, rounded to the nearest float, ties to even.
template <class J>
[[nodiscard]] IRG_INLINE constexpr float to_float(J i) noexcept {
  return static_cast<float>(i);
}
template <int N>
[[nodiscard]] IRG_INLINE pack<float, N> to_float(const pack<std::int32_t, N>& i) noexcept {
  return converted<float>(i);
}

/// Whether upper_product is one instruction.
#if defined(IRG_LANES_VECTOR) && defined(__SSE2__)
template <int N>
inline constexpr bool has_upper_product = N == 8 || 2 * N == native_bytes;
#else
template <int N>
inline constexpr bool has_upper_product = false;
#endif

/// The upper halves of the products of 16-bit numbers.
template <int N>
[[nodiscard]] IRG_INLINE pack<std::uint16_t, N> upper_product(const pack<std::uint16_t, N>& a,
                                                              const pack<std::uint16_t, N>& b) noexcept {
#if defined(IRG_LANES_VECTOR) && defined(__SSE2__)
  using shorts = typename pack<std::int16_t, N>::storage;
  using result = typename pack<std::uint16_t, N>::storage;
  if constexpr (N == 8)
    return {reinterpret_cast<result>(
        __builtin_ia32_pmulhuw128(reinterpret_cast<shorts>(a.v), reinterpret_cast<shorts>(b.v)))};
#ifdef __AVX2__
  if constexpr (N == 16)
    return {reinterpret_cast<result>(
        __builtin_ia32_pmulhuw256(reinterpret_cast<shorts>(a.v), reinterpret_cast<shorts>(b.v)))};
#endif
#endif
  return converted<std::uint16_t>((converted<std::uint32_t>(a) * converted<std::uint32_t>(b)) >> 16);
}

/// Four numbers of 0 to 255 as the bytes of a word, lane 0 the lowest.
[[nodiscard]] IRG_INLINE std::uint32_t packed_bytes(const pack<std::int32_t, 4>& p) noexcept {
#if defined(IRG_LANES_VECTOR) && defined(__SSE2__)
  const auto halves = __builtin_ia32_packssdw128(p.v, p.v);
  const auto bytes = __builtin_ia32_packuswb128(halves, halves);
  return static_cast<std::uint32_t>(reinterpret_cast<pack<std::int32_t, 4>::storage>(bytes)[0]);
#else
  return static_cast<std::uint32_t>(p[0] | p[1] << 8 | p[2] << 16 | p[3] << 24);
#endif
}

}  // namespace irg::inline IRG_ABI
