// SPDX-License-Identifier: MIT
// Light to sRGB pixels, a register of them at a time: bit for bit what encode() gives one by one.
#pragma once

#include <cstdint>
#include <cstring>

#include <irg/colour/srgb.hpp>
#include <irg/core/lanes.hpp>

namespace irg {

#ifdef IRG_LANES_VECTOR

namespace detail {
inline namespace IRG_ABI {

// linear_to_srgb8 for each lane.
template <int N>
IRG_INLINE pack<std::int32_t, N> srgb_codes_of(const pack<float, N>& light) noexcept {
  using F = lanes<pack<float, N>>;
  const auto first = F::broadcast(srgb_first), last = F::broadcast(srgb_last);
  const auto not_below = select(first < light, light, first);  // the first for NaN, too
  const auto limited = select(not_below < last, not_below, last);
  pack<std::int32_t, N> bits;
  std::memcpy(&bits.v, &limited.v, sizeof bits.v);
  const auto entry = gather<std::int32_t>(
      srgb_code_table.entry, pack<std::int32_t, N>{(bits.v - static_cast<std::int32_t>(srgb_first_bits)) >> 16});
  return {(entry.v + (bits.v & 0xffff)) >> 16};
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// The opaque sRGB pixels of N lights, their bytes in the order of rgba8.
/// exact   encode() of each
/// cost    three loads from a table per pixel
template <int N>
IRG_INLINE pack<std::uint32_t, N> encode_lanes(const pack<float, N>& r, const pack<float, N>& g,
                                               const pack<float, N>& b) noexcept {
  static_assert(std::endian::native == std::endian::little);
  using words = typename pack<std::uint32_t, N>::storage;
  const auto word = [](const pack<float, N>& light) { return reinterpret_cast<words>(detail::srgb_codes_of(light).v); };
  return {word(r) | (word(g) << 8) | (word(b) << 16) | 0xff000000u};
}

}  // namespace IRG_ABI

#endif

}  // namespace irg
