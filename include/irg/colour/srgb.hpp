// SPDX-License-Identifier: MIT
// sRGB (IEC 61966-2-1) to light and back, correctly rounded. Light adds up and is what shading, blending and filtering
// compute with; the codes 0 to 255 of a picture are spaced for the eye.
#pragma once

#include <bit>
#include <cstdint>

#include <irg/colour/detail/srgb_tables.hpp>
#include <irg/colour/pixel.hpp>
#include <irg/math/exponential.hpp>

namespace irg {

namespace detail {

// The codes by the leading 16 bits of a float: sign, exponent and 7 bits of the fraction. Between srgb_first, where
// every code is still 0, and 1 the code changes at most once among the floats that share them, because the curve is
// never steeper than 12.92 * 255 codes per unit of light, and 168 codes per unit from 1/2 on. An entry holds the code
// at the first of these floats in its upper half, and in the lower half the number that carries into the code when the
// trailing 16 bits of the float are added, from the threshold on.
inline constexpr float srgb_first = 0x1p-13f, srgb_last = 0x1.fffffep-1f;
inline constexpr std::uint32_t srgb_first_bits = std::bit_cast<std::uint32_t>(srgb_first);

struct srgb_codes {
  std::uint32_t entry[(std::bit_cast<std::uint32_t>(srgb_last) - srgb_first_bits) / 0x10000 + 1];
};

inline constexpr srgb_codes srgb_code_table = [] {
  srgb_codes table{};
  std::uint32_t* entry = table.entry;
  for (std::uint32_t code = 0; code <= 255; ++code) {
    const std::uint32_t change = std::bit_cast<std::uint32_t>(srgb_threshold[code + 1]) - srgb_first_bits;
    std::uint32_t* const last = table.entry + (change >> 16);
    while (entry != last) *entry++ = code << 16;
    if (code < 255) *entry++ = ((code + 1) << 16) - (change & 0xffff);
  }
  return table;
}();

}  // namespace detail

inline namespace IRG_ABI {

/// The light that an 8-bit sRGB code stands for: 0 for 0, 1 for 255.
/// exact   the float nearest to the exact value
/// cost    one load
/// source  IEC 61966-2-1
[[nodiscard]] IRG_INLINE constexpr float srgb_to_linear(std::uint8_t code) noexcept { return detail::srgb_light[code]; }

/// The 8-bit sRGB code whose encoding of `light` is nearest: 0 for 0 and less, 255 for 1 and more.
/// gives   0 for NaN
/// exact   round(255 * encoded light) of the exact curve for every float; no float lies half-way
/// cost    two comparisons and one load from a table of 6.5 KiB
/// source  IEC 61966-2-1
[[nodiscard]] IRG_INLINE constexpr std::uint8_t linear_to_srgb8(float light) noexcept {
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(clamped(light, detail::srgb_first, detail::srgb_last));
  const std::uint32_t entry = detail::srgb_code_table.entry[(bits - detail::srgb_first_bits) >> 16];
  return static_cast<std::uint8_t>((entry + (bits & 0xffff)) >> 16);
}

/// The light that the sRGB value `encoded` stands for, both on the scale 0 to 1; a negative value mirrors its positive.
/// gives   NaN for NaN
/// exact   error below 8 ulp for |encoded| <= 1.2: the constants' own rounding, raised by the power
/// source  IEC 61966-2-1
template <Floating T>
[[nodiscard]] constexpr T srgb_to_linear(T encoded) noexcept {
  if (encoded != encoded) return encoded;  // before constant evaluation would have to compute with it
  if (encoded < T(0)) return -srgb_to_linear(-encoded);
  if (encoded <= T(0.04045)) return encoded / T(12.92);
  return pow((encoded + T(0.055)) / T(1.055), T(2.4));
}

/// The sRGB value of `light`, both on the scale 0 to 1; a negative value mirrors its positive.
/// gives   NaN for NaN
/// exact   error below 8 ulp for |light| <= 1.2
/// source  IEC 61966-2-1
template <Floating T>
[[nodiscard]] constexpr T linear_to_srgb(T light) noexcept {
  if (light != light) return light;
  if (light < T(0)) return -linear_to_srgb(-light);
  if (light <= T(0.0031308)) return product(T(12.92), light);
  return product(T(1.055), pow(light, T(1) / T(2.4))) - T(0.055);
}

/// The pixel of a colour: each channel by linear_to_srgb8. Opacity is a share, not light, and stays as it is.
/// exact   each channel correctly rounded
[[nodiscard]] IRG_INLINE constexpr rgba8 encode(const rgb<float>& light, std::uint8_t opacity = 255) noexcept {
  return {linear_to_srgb8(light.r), linear_to_srgb8(light.g), linear_to_srgb8(light.b), opacity};
}

/// The colour of a pixel, its opacity left aside.
/// exact   each channel correctly rounded; encode(decode(p), p.a) is p
[[nodiscard]] IRG_INLINE constexpr rgb<float> decode(const rgba8& pixel) noexcept {
  return {srgb_to_linear(pixel.r), srgb_to_linear(pixel.g), srgb_to_linear(pixel.b)};
}

}  // namespace IRG_ABI
}  // namespace irg
