// SPDX-License-Identifier: MIT
// What picture writers refuse, and how they say so.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include <irg/core/raster_concept.hpp>
#include <irg/colour/encode_pixel.hpp>

namespace irg {

/// Why a picture could not be encoded.
struct encode_error {
  const char* message = "";  // one sentence without a full stop, of static storage
};

/// Pictures of more pixels are neither written nor read: 32768 x 32768, less where addresses have 32 bits.
inline constexpr std::uint64_t max_picture_pixels = std::uint64_t{1} << (sizeof(std::size_t) > 4 ? 30 : 27);

/// A raster whose pixels picture writers understand.
template <class R>
concept EncodableRaster = ReadableRaster<R> && EncodablePixel<pixel_of<R>>;

namespace detail::inline IRG_ABI {

/// The reason why a picture of this size is refused, if it is.
/// exact   for all int sizes: the count of pixels is formed in 64 bits
constexpr std::optional<encode_error> refuse_picture_size(int width, int height) noexcept {
  if (width < 0 || height < 0) return encode_error{"picture cannot have a negative width or height"};
  if (width == 0 || height == 0) return encode_error{"picture needs at least one pixel"};
  const auto pixels = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
  if (pixels > max_picture_pixels)
    return encode_error{"picture is too large: it has more pixels than irg::max_picture_pixels"};
  return std::nullopt;
}

}  // namespace detail::inline IRG_ABI
}  // namespace irg
