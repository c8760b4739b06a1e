// SPDX-License-Identifier: MIT
// The runs of equal pixels that an SVG file shows, and its text.
#pragma once

#include <cstdint>
#include <string_view>

#include <irg/core/result.hpp>
#include <irg/io/detail/text_writer.hpp>
#include <irg/io/picture_limits.hpp>

namespace irg::detail::inline IRG_ABI {

// fill="#rrggbb" or stroke="#rrggbb", and the opacity where it is not full.
template <class Bytes>
constexpr void append_paint(Bytes& out, std::string_view what, const rgba8& p) {
  constexpr std::string_view hex = "0123456789abcdef";
  append_all(out, what, "=\"#");
  for (const std::uint8_t channel : {p.r, p.g, p.b})
    for (const int digit : {channel >> 4, channel & 15})
      out.push_back(static_cast<std::uint8_t>(hex[static_cast<std::size_t>(digit)]));
  append_text(out, "\"");
  if (p.a == 255) return;
  append_all(out, " ", what);
  append_text(out, "-opacity=\"0.");  // rounded down to a thousandth; no opacity below 255 comes to 1
  const int thousandths = p.a * 1000 / 255;
  for (const int digit : {thousandths / 100, thousandths / 10 % 10, thousandths % 10})
    out.push_back(static_cast<std::uint8_t>('0' + digit));
  append_text(out, "\"");
}

template <class Bytes>
constexpr void append_run(Bytes& out, int x, int y, int width, int height, const rgba8& p) {
  append_all(out, "<rect x=\"", x, "\" y=\"", y, "\" width=\"", width, "\" height=\"", height, "\" ");
  append_paint(out, "fill", p);
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

}  // namespace irg::detail::inline IRG_ABI
