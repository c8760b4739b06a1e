// SPDX-License-Identifier: MIT
// A raster becomes an SVG picture: one rectangle for each run of equal pixels in a row, or in several equal rows, so
// pixels keep sharp edges at any size. Good for small pictures of cells; shaded ones belong into PNG.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <irg/core/result.hpp>
#include <irg/io/picture_limits.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

constexpr void append_text(std::vector<std::uint8_t>& out, std::string_view text) {
  for (const char c : text) out.push_back(static_cast<std::uint8_t>(c));
}

// The number in decimal digits.
constexpr void append_number(std::vector<std::uint8_t>& out, int n) {
  char digits[10] = {};
  int count = 0;
  do {
    digits[count++] = static_cast<char>('0' + n % 10);
    n /= 10;
  } while (n > 0);
  while (count > 0) out.push_back(static_cast<std::uint8_t>(digits[--count]));
}

// fill="#rrggbb", and the opacity where it is not full.
constexpr void append_fill(std::vector<std::uint8_t>& out, const rgba8& p) {
  constexpr std::string_view hex = "0123456789abcdef";
  append_text(out, "fill=\"#");
  for (const std::uint8_t channel : {p.r, p.g, p.b})
    for (const int digit : {channel >> 4, channel & 15})
      out.push_back(static_cast<std::uint8_t>(hex[static_cast<std::size_t>(digit)]));
  append_text(out, "\"");
  if (p.a == 255) return;
  append_text(out, " fill-opacity=\"0.");  // rounded down to a thousandth; no opacity below 255 comes to 1
  const int thousandths = p.a * 1000 / 255;
  for (const int digit : {thousandths / 100, thousandths / 10 % 10, thousandths % 10})
    out.push_back(static_cast<std::uint8_t>('0' + digit));
  append_text(out, "\"");
}

constexpr void append_run(std::vector<std::uint8_t>& out, int x, int y, int width, int height, const rgba8& p) {
  append_text(out, "<rect x=\"");
  append_number(out, x);
  append_text(out, "\" y=\"");
  append_number(out, y);
  append_text(out, "\" width=\"");
  append_number(out, width);
  append_text(out, "\" height=\"");
  append_number(out, height);
  append_text(out, "\" ");
  append_fill(out, p);
  append_text(out, "/>\n");
}

// One past the last row that looks like row y.
template <class R>
constexpr int end_of_equal_rows(const R& raster, int y) {
  const int width = width_of(raster), height = height_of(raster);
  int end = y + 1;
  for (; end < height; ++end)
    for (int x = 0; x < width; ++x)
      if (to_rgba8(get_pixel(raster, x, end)) != to_rgba8(get_pixel(raster, x, y))) return end;
  return end;
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// The bytes of an SVG file that shows the raster, one unit a pixel.
/// shape   a <rect> for each run of equal pixels in a row and the rows below that are equal as a whole, from the top;
///         nothing for runs of opacity 0
/// gives   an error when the raster has no pixel or more than max_picture_pixels
/// exact   the colours as they are; opacity in thousandths
/// cost    about 60 bytes a run
template <EncodableRaster R>
constexpr result<std::vector<std::uint8_t>, encode_error> encode_svg(const R& raster) {
  const int width = width_of(raster), height = height_of(raster);
  if (const auto refusal = detail::refuse_picture_size(width, height)) return *refusal;
  std::vector<std::uint8_t> out;
  detail::append_text(out, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"");
  detail::append_number(out, width);
  detail::append_text(out, "\" height=\"");
  detail::append_number(out, height);
  detail::append_text(out, "\" viewBox=\"0 0 ");  // so that it scales with a width and height that its page gives it
  detail::append_number(out, width);
  detail::append_text(out, " ");
  detail::append_number(out, height);
  detail::append_text(out, "\" shape-rendering=\"crispEdges\">\n");
  for (int y = 0, y_end = 0; y < height; y = y_end) {
    y_end = detail::end_of_equal_rows(raster, y);
    for (int x = 0, x_end = 0; x < width; x = x_end) {
      const rgba8 p = to_rgba8(get_pixel(raster, x, y));
      x_end = x + 1;
      while (x_end < width && to_rgba8(get_pixel(raster, x_end, y)) == p) ++x_end;
      if (p.a != 0) detail::append_run(out, x, y, x_end - x, y_end - y, p);
    }
  }
  detail::append_text(out, "</svg>\n");
  return out;
}

}  // namespace IRG_ABI
}  // namespace irg
