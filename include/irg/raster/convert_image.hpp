// SPDX-License-Identifier: MIT
// Whole images from one pixel type to another.
#pragma once

#include <type_traits>

#include <irg/colour/convert_pixel.hpp>
#include <irg/core/contract.hpp>
#include <irg/core/raster_concept.hpp>
#include <irg/raster/image.hpp>

namespace irg::inline IRG_ABI {

/// Sets every pixel of the target to the source's pixel at the same place, as the target's type.
/// needs   two rasters of the same size, whose pixels are not the same memory unless their types are the same
/// exact   as convert_pixel
/// cost    each pixel is read once and written once
template <class To, ReadableRaster From>
  requires(WritableRaster<std::remove_reference_t<To>> && ConvertiblePixel<pixel_of<From>> &&
           DecodablePixel<pixel_of<std::remove_reference_t<To>>>)
constexpr void convert_into(To&& target, const From& source) {
  using pixel = pixel_of<std::remove_reference_t<To>>;
  const int width = width_of(source), height = height_of(source);
  IRG_EXPECTS(width == width_of(target) && height == height_of(target));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) set_pixel(target, x, y, convert_pixel<pixel>(get_pixel(source, x, y)));
}

/// The old form of convert_into, with the target last.
template <ReadableRaster From, class To>
  requires requires(const From& source, To&& target) { convert_into(static_cast<To&&>(target), source); }
[[deprecated("irg: use convert_into, which takes the target first")]] constexpr void convert_pixels(const From& source,
                                                                                                    To&& target) {
  convert_into(static_cast<To&&>(target), source);
}

/// The picture of a raster in pixels of another type.
/// shape   an image of the raster's size
/// exact   as convert_pixel
/// cost    each pixel is read once
template <DecodablePixel P, ReadableRaster From>
  requires ConvertiblePixel<pixel_of<From>>
[[nodiscard]] constexpr image<P> convert_image(const From& source) {
  image<P> converted(width_of(source), height_of(source));
  convert_into(converted, source);
  return converted;
}

}  // namespace irg::inline IRG_ABI
