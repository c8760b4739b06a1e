// SPDX-License-Identifier: MIT
// to_rgba8(pixel): what a pixel of any type looks like in a picture file. The one customisation point of the picture
// writers: for a pixel type of your own, write `irg::rgba8 to_rgba8(const my::pixel&)` in the type's own namespace.
//
// Numbers that are light (rgb<T>, depths, intensities) are no colours yet and are refused by the compiler: encode them
// first, the palette or the sRGB curve is a decision.
#pragma once

#include <concepts>
#include <cstdint>

#include <irg/colour/pixel.hpp>

namespace irg {
inline namespace IRG_ABI {

/// The pixel itself.
[[nodiscard]] IRG_INLINE constexpr rgba8 to_rgba8(const rgba8& p) noexcept { return p; }

/// The same colour and opacity, in irg's channel order.
[[nodiscard]] IRG_INLINE constexpr rgba8 to_rgba8(const bgra8& p) noexcept { return {p.r, p.g, p.b, p.a}; }
[[nodiscard]] IRG_INLINE constexpr rgba8 to_rgba8(const bgr8& p) noexcept { return {p.r, p.g, p.b, 255}; }

/// The same colour, opaque.
[[nodiscard]] IRG_INLINE constexpr rgba8 to_rgba8(const rgb8& p) noexcept { return {p.r, p.g, p.b, 255}; }

/// The gray of that level, opaque: 0 is black, 255 is white. A template, so that no other number turns into a byte
/// unseen.
template <std::same_as<std::uint8_t> Gray>
[[nodiscard]] IRG_INLINE constexpr rgba8 to_rgba8(Gray level) noexcept {
  return {level, level, level, 255};
}

/// The gray level of a colour, its opacity left aside: what is gray keeps its level.
/// exact   (299 r + 587 g + 114 b) / 1000, rounded to nearest, half up
/// source  BT.601
[[nodiscard]] IRG_INLINE constexpr std::uint8_t grey_level(const rgba8& p) noexcept {
  return static_cast<std::uint8_t>((299 * p.r + 587 * p.g + 114 * p.b + 500) / 1000);
}

IRG_RENAMED(gray_level, grey_level)

}  // namespace IRG_ABI

/// A pixel that picture writers understand. Models: rgba8, bgra8, rgb8, std::uint8_t (a gray level), and every type
/// with a to_rgba8 in its own namespace.
template <class P>
concept EncodablePixel = requires(const P& p) {
  { to_rgba8(p) } -> std::same_as<rgba8>;
};

}  // namespace irg
