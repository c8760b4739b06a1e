// SPDX-License-Identifier: MIT
// PPM and PGM (netpbm): the simplest picture files, uncompressed, 8 bits per channel, without opacity.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <irg/colour/encode_pixel.hpp>
#include <irg/core/result.hpp>
#include <irg/io/detail/netpbm.hpp>
#include <irg/io/picture_limits.hpp>
#include <irg/raster/image.hpp>

namespace irg {
inline namespace IRG_ABI {

/// The bytes of a binary PPM file (P6) that shows the raster; opacity is dropped.
/// gives   an error when the raster has no pixel or more than max_picture_pixels
/// exact   red, green and blue as to_rgba8 gives them
/// cost    each pixel is read once; three bytes per pixel
/// source  Netpbm, ppm(5)
template <EncodableRaster R>
constexpr result<std::vector<std::uint8_t>, encode_error> encode_ppm(const R& raster) {
  return detail::encode_netpbm('6', 3, raster, [](const rgba8& p, std::uint8_t* out) {
    out[0] = p.r;
    out[1] = p.g;
    out[2] = p.b;
  });
}

/// The bytes of a binary PGM file (P5) that shows the raster in gray; opacity is dropped.
/// gives   an error when the raster has no pixel or more than max_picture_pixels
/// exact   gray pixels are kept; coloured ones become (299 r + 587 g + 114 b) / 1000, rounded to nearest, half up
/// cost    each pixel is read once; one byte per pixel
/// source  Netpbm, pgm(5); BT.601 for the weights
template <EncodableRaster R>
constexpr result<std::vector<std::uint8_t>, encode_error> encode_pgm(const R& raster) {
  return detail::encode_netpbm('5', 1, raster, [](const rgba8& p, std::uint8_t* out) { *out = gray_level(p); });
}

/// The picture in the bytes of a PPM or PGM file, binary (P6, P5) or plain (P3, P2); gray becomes r = g = b.
/// gives   an error with line and column for anything but exactly one whole picture: a bad header, no pixels, more than
///         max_picture_pixels, a largest value outside 1 to 65535, missing or left-over data, samples out of range
/// exact   samples are scaled to 255 with rounding to nearest, half up; files with the largest value 255 are kept
/// cost    nothing is allocated before the size was checked against the file's length
/// source  Netpbm, ppm(5) and pgm(5)
template <std::convertible_to<std::span<const std::uint8_t>> Bytes>
[[nodiscard]] constexpr result<image<rgb8>> read_ppm(const Bytes& bytes) {
  return detail::netpbm_reader<std::uint8_t>(bytes).read();
}
/// The same from bytes as read_file gives them.
template <std::convertible_to<std::string_view> Bytes>
[[nodiscard]] constexpr result<image<rgb8>> read_ppm(const Bytes& bytes) {
  return detail::netpbm_reader<char>(std::string_view(bytes)).read();
}

}  // namespace IRG_ABI
}  // namespace irg
