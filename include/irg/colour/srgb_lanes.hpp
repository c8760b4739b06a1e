// SPDX-License-Identifier: MIT
// Light to sRGB pixels, a register of them at a time: bit for bit what encode() gives one by one.
#pragma once

#include <cstdint>

#include <irg/colour/srgb.hpp>
#include <irg/core/lanes.hpp>

namespace irg {

namespace detail::inline IRG_ABI {

// linear_to_srgb8 for each lane, in bits 16 to 23; those above are zero, those below anything.
template <int N>
IRG_INLINE pack<std::int32_t, N> srgb_codes_of(const pack<float, N>& light) noexcept {
  using F = lanes<pack<float, N>>;
  const auto limited = minimum(maximum(light, F::broadcast(srgb_first)), F::broadcast(srgb_last));  // NaN: the first
  const auto bits = bits_as<std::int32_t>(limited);
  const auto entry =
      gather<std::int32_t>(srgb_code_table.entry, (bits - static_cast<std::int32_t>(srgb_first_bits)) >> 16);
  return entry + (bits & 0xffff);
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The opaque sRGB pixels of N lights, their bytes in the order of rgba8.
/// exact   encode() of each
/// cost    three loads from a table per pixel
template <int N>
[[nodiscard]] IRG_INLINE pack<std::uint32_t, N> encode_lanes(const pack<float, N>& r, const pack<float, N>& g,
                                                             const pack<float, N>& b) noexcept {
  const auto word = [](const pack<float, N>& light, int to) {
    const auto code = detail::srgb_codes_of(light);
    return bits_as<std::uint32_t>(to == 16 ? code & 0xff0000 : code >> 16 << to);
  };
  return word(r, byte_shift<4>(0)) | word(g, byte_shift<4>(1)) | word(b, byte_shift<4>(2)) | 0xffu << byte_shift<4>(3);
}

/// The light of N pixels, whose bits the words are.
/// exact   decode() of each
/// cost    three loads from a table per pixel
template <int N>
[[nodiscard]] IRG_INLINE rgb<pack<float, N>> decode_lanes(const pack<std::int32_t, N>& words) noexcept {
  const auto light = [&](int shift) { return gather<float>(detail::srgb_light, (words >> shift) & 255); };
  return {light(byte_shift<4>(0)), light(byte_shift<4>(1)), light(byte_shift<4>(2))};
}

}  // namespace IRG_ABI

}  // namespace irg
