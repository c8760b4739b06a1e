// SPDX-License-Identifier: MIT
// convert_pixel<To>(pixel): a pixel of one type as one of another. Every type goes through rgba8: into it by to_rgba8
// (colour/encode_pixel.hpp), out of it by pixel_decoding, the customisation point of this header.
#pragma once

#include <concepts>
#include <cstdint>

#include <irg/colour/encode_pixel.hpp>
#include <irg/colour/pixel.hpp>
#include <irg/colour/srgb.hpp>

namespace irg {
/// How a P is made of an rgba8. Member: `static P from(const rgba8&)`. Specialise it for pixel types of your own.
template <class P>
struct pixel_decoding {};

template <>
struct pixel_decoding<rgba8> {
  IRG_INLINE static constexpr rgba8 from(const rgba8& p) noexcept { return p; }
};
template <>
struct pixel_decoding<bgra8> {
  IRG_INLINE static constexpr bgra8 from(const rgba8& p) noexcept { return {p.b, p.g, p.r, p.a}; }
};
template <>
struct pixel_decoding<rgb8> {
  IRG_INLINE static constexpr rgb8 from(const rgba8& p) noexcept { return {p.r, p.g, p.b}; }
};
template <>
struct pixel_decoding<bgr8> {
  IRG_INLINE static constexpr bgr8 from(const rgba8& p) noexcept { return {p.b, p.g, p.r}; }
};
template <>
struct pixel_decoding<std::uint8_t> {
  IRG_INLINE static constexpr std::uint8_t from(const rgba8& p) noexcept { return grey_level(p); }
};
template <>
struct pixel_decoding<rgb<float>> {
  IRG_INLINE static constexpr rgb<float> from(const rgba8& p) noexcept { return decode(p); }
};

/// A pixel that can be made of an rgba8. Models: rgba8, bgra8, rgb8, bgr8, std::uint8_t (a gray level), rgb<float>
/// (light), and every type with a pixel_decoding.
template <class P>
concept DecodablePixel = requires(const rgba8& p) {
  { pixel_decoding<P>::from(p) } -> std::same_as<P>;
};

/// A pixel that can become one of another type: what pictures can be written of, and light, by the curve of sRGB.
template <class P>
concept ConvertiblePixel = EncodablePixel<P> || std::same_as<P, rgb<float>>;

inline namespace IRG_ABI {

/// The pixel as one of type To.
/// gives   opacity 255 where the pixel has none; it is dropped, not multiplied in, where To has none. The same type is
///         kept as it is
/// exact   channels of 8 bits are kept; coloured pixels become gray by grey_level; light and codes by encode and decode
template <DecodablePixel To, ConvertiblePixel From>
[[nodiscard]] IRG_INLINE constexpr To convert_pixel(const From& p) {
  if constexpr (std::same_as<To, From>)
    return p;
  else if constexpr (std::same_as<From, rgb<float>>)
    return pixel_decoding<To>::from(encode(p));
  else
    return pixel_decoding<To>::from(to_rgba8(p));
}

}  // namespace IRG_ABI
}  // namespace irg
