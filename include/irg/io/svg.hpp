// SPDX-License-Identifier: MIT
// A raster becomes an SVG picture: one rectangle for each run of equal pixels in a row, or in several equal rows, so
// pixels keep sharp edges at any size. Good for small pictures of cells; shaded ones belong into PNG.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <irg/core/result.hpp>
#include <irg/io/picture_limits.hpp>
#include <irg/raster/image.hpp>
#if IRG_BODIES
#include <irg/io/detail/svg_runs.hpp>
#endif

namespace irg::inline IRG_ABI {

/// The bytes of an SVG file that shows the raster, one unit a pixel.
/// shape   a <rect> for each run of equal pixels in a row and the rows below that are equal as a whole, from the top;
///         nothing for runs of opacity 0
/// gives   an error when the raster has no pixel or more than max_picture_pixels
/// exact   the colours as they are; opacity in thousandths
/// cost    about 60 bytes a run, and 4 a pixel while it is written
template <EncodableRaster R>
constexpr result<std::vector<std::uint8_t>, encode_error> encode_svg(const R& raster);

}  // namespace irg::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <class Bytes>
IRG_API Bytes encode_svg_runs(const image<rgba8>& picture);

}  // namespace irg::detail::inline IRG_COMPILED_ABI

namespace irg::inline IRG_ABI {

template <EncodableRaster R>
constexpr result<std::vector<std::uint8_t>, encode_error> encode_svg(const R& raster) {
  const int width = width_of(raster), height = height_of(raster);
  if (const auto refusal = detail::refuse_picture_size(width, height)) return *refusal;
  image<rgba8> picture(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) picture(x, y) = to_rgba8(get_pixel(raster, x, y));
  return detail::encode_svg_runs<std::vector<std::uint8_t>>(picture);
}

}  // namespace irg::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail::inline IRG_COMPILED_ABI {

template <class Bytes>
IRG_API Bytes encode_svg_runs(const image<rgba8>& picture) {
  const int width = width_of(picture), height = height_of(picture);
  Bytes out;
  append_all(out, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"", width, "\" height=\"", height);
  append_text(out, "\" viewBox=\"0 0 ");  // so that it scales with a width and height that its page gives it
  append_all(out, width, " ", height, "\" shape-rendering=\"crispEdges\">\n");
  for (int y = 0, y_end = 0; y < height; y = y_end) {
    y_end = end_of_equal_rows(picture, y);
    for (int x = 0, x_end = 0; x < width; x = x_end) {
      const rgba8 p = picture(x, y);
      x_end = x + 1;
      while (x_end < width && picture(x_end, y) == p) ++x_end;
      if (p.a != 0) append_run(out, x, y, x_end - x, y_end - y, p);
    }
  }
  append_text(out, "</svg>\n");
  return out;
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
