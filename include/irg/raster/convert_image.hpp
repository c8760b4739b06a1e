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
template <ReadableRaster From, class To>
  requires(WritableRaster<std::remove_reference_t<To>> && ConvertiblePixel<pixel_of<From>> &&
           DecodablePixel<pixel_of<std::remove_reference_t<To>>>)
constexpr void convert_pixels(const From& source, To&& target) {
  using pixel = pixel_of<std::remove_reference_t<To>>;
  const int width = width_of(source), height = height_of(source);
  IRG_EXPECTS(width == width_of(target) && height == height_of(target));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) set_pixel(target, x, y, convert_pixel<pixel>(get_pixel(source, x, y)));
}

/// The picture of a raster in pixels of another type.
/// shape   an image of the raster's size
/// exact   as convert_pixel
/// cost    each pixel is read once
template <DecodablePixel P, ReadableRaster From>
  requires ConvertiblePixel<pixel_of<From>>
[[nodiscard]] constexpr image<P> convert_image(const From& source) {
  image<P> converted(width_of(source), height_of(source));
  convert_pixels(source, converted);
  return converted;
}

}  // namespace irg::inline IRG_ABI
