// SPDX-License-Identifier: MIT
// What drawing puts into pixels: a value, or a function from the pixel that is there to the one that shall be there.
// Functions that draw take either as one argument, `paint`; so blending, counting, and marking cost no second function.
#pragma once

#include <concepts>
#include <cstdint>
#include <type_traits>

#include <irg/colour/mix.hpp>
#include <irg/core/raster_concept.hpp>

namespace irg {

/// f(there) is the pixel to write.
template <class F, class R>
concept BlendFunction = WritableRaster<R> && requires(const F& f, const pixel_of<R>& there) {
  { f(there) } -> std::convertible_to<pixel_of<R>>;
};

/// A pixel value, or a function of the pixel that is there.
template <class T, class R>
concept PaintFor = BlendFunction<T, R> || (WritableRaster<R> && std::convertible_to<const T&, pixel_of<R>>);

/// f(there, coverage) is the pixel to write; coverage is 1 to 255, 255 being the whole pixel.
template <class F, class R>
concept CoverageBlendFunction =
    WritableRaster<R> && requires(const F& f, const pixel_of<R>& there, std::uint8_t coverage) {
      { f(there, coverage) } -> std::convertible_to<pixel_of<R>>;
    };

/// A pixel value that can be mixed, or a function of the pixel that is there and the coverage.
template <class T, class R>
concept CoveragePaintFor = CoverageBlendFunction<T, R> ||
                           (WritableRaster<R> && Mixable<pixel_of<R>> && std::convertible_to<const T&, pixel_of<R>>);

inline namespace IRG_ABI {

/// Paints the pixel in column x of row y.
/// needs   0 <= x < width, 0 <= y < height
template <WritableRaster R, PaintFor<R> Paint = pixel_of<R>>
IRG_INLINE constexpr void paint_pixel(R& raster, int x, int y, const Paint& paint) {
  if constexpr (BlendFunction<Paint, R>)
    set_pixel(raster, x, y, static_cast<pixel_of<R>>(paint(get_pixel(raster, x, y))));
  else
    set_pixel(raster, x, y, static_cast<pixel_of<R>>(paint));
}

/// Paints the pixel in column x of row y, covered in part.
/// needs   0 <= x < width, 0 <= y < height
/// gives   the pixel untouched when coverage is 0
template <WritableRaster R, CoveragePaintFor<R> Paint = pixel_of<R>>
IRG_INLINE constexpr void paint_pixel(R& raster, int x, int y, const Paint& paint, std::uint8_t coverage) {
  if (coverage == 0) return;
  if constexpr (CoverageBlendFunction<Paint, R>)
    set_pixel(raster, x, y, static_cast<pixel_of<R>>(paint(get_pixel(raster, x, y), coverage)));
  else
    set_pixel(raster, x, y, mix(get_pixel(raster, x, y), static_cast<pixel_of<R>>(paint), coverage));
}

}  // namespace IRG_ABI
}  // namespace irg
