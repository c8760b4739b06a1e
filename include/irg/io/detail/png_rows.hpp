// SPDX-License-Identifier: MIT
// The rows of a PNG file as its decompressed data hold them, filtered and perhaps interlaced, made into pixels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <irg/colour/pixel.hpp>
#include <irg/io/detail/png_filter.hpp>
#include <irg/raster/image.hpp>

namespace irg::detail {

/// What a PNG file says of its pixels before the first of them.
struct png_header {
  std::uint32_t width = 0, height = 0;
  int depth = 8;        // bits per sample
  int colour_type = 6;  // 0 gray, 2 RGB, 3 palette, 4 gray with opacity, 6 RGB with opacity
  bool interlaced = false;

  IRG_INLINE constexpr int channels() const noexcept {
    constexpr int of[] = {1, 0, 3, 1, 2, 0, 4};
    return of[colour_type];
  }
  IRG_INLINE constexpr bool has_opacity() const noexcept { return colour_type >= 4; }
  IRG_INLINE constexpr std::uint64_t bytes_of_row(std::uint64_t pixels) const noexcept {
    return (pixels * static_cast<std::uint64_t>(channels() * depth) + 7) / 8;
  }
  /// From a byte to the same one of the pixel before it, as filters count it.
  IRG_INLINE constexpr std::size_t filter_step() const noexcept {
    return static_cast<std::size_t>(channels() * depth < 8 ? 1 : channels() * depth / 8);
  }
};

/// Colours by number, and the one sample or triple that means transparent.
struct png_colours {
  std::array<rgba8, 256> palette{};
  int palette_size = 0;
  bool has_key = false;
  std::array<std::uint32_t, 3> key{};
};

/// Every step-th pixel of every row_step-th row: one of the pictures that an interlaced one is made of.
struct png_pass {
  std::uint32_t x, y, step, row_step;
  IRG_INLINE constexpr std::uint32_t columns(std::uint32_t width) const noexcept {
    return width <= x ? 0 : (width - x + step - 1) / step;
  }
  IRG_INLINE constexpr std::uint32_t rows(std::uint32_t height) const noexcept {
    return height <= y ? 0 : (height - y + row_step - 1) / row_step;
  }
};

inline namespace IRG_ABI {

inline constexpr png_pass adam7[7] = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
                                      {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
inline constexpr png_pass whole_picture[1] = {{0, 0, 1, 1}};

constexpr std::span<const png_pass> passes_of(const png_header& h) noexcept {
  if (h.interlaced) return adam7;
  return whole_picture;
}

/// The bytes of all rows with their filters' numbers.
constexpr std::uint64_t bytes_of_rows(const png_header& h) noexcept {
  std::uint64_t sum = 0;
  for (const png_pass& p : passes_of(h))
    if (const std::uint32_t columns = p.columns(h.width); columns != 0)
      sum += std::uint64_t{p.rows(h.height)} * (1 + h.bytes_of_row(columns));
  return sum;
}

template <png_filter F>
constexpr void undo_filter(std::uint8_t* row, const std::uint8_t* above, std::size_t step, std::size_t count) noexcept {
  const std::size_t first = step < count ? step : count;
  for (std::size_t i = 0; i < first; ++i) row[i] = static_cast<std::uint8_t>(row[i] + predict<F>(0, above[i], 0));
  const std::uint8_t *left = row, *corner = above;
  for (std::size_t i = first; i < count; ++i)
    row[i] = static_cast<std::uint8_t>(row[i] + predict<F>(*left++, above[i], *corner++));
}

/// Turns the differences of a row into its bytes; false when there is no such filter.
/// needs   above: the bytes of the row before it, zeros for the first
constexpr bool unfilter_row(std::uint8_t filter, std::uint8_t* row, const std::uint8_t* above, std::size_t step,
                            std::size_t count) noexcept {
  switch (filter) {
    case 0: return true;
    case 1: return undo_filter<png_filter::sub>(row, above, step, count), true;
    case 2: return undo_filter<png_filter::up>(row, above, step, count), true;
    case 3: return undo_filter<png_filter::average>(row, above, step, count), true;
    case 4: return undo_filter<png_filter::paeth>(row, above, step, count), true;
    default: return false;
  }
}

/// Sample i of a row.
constexpr std::uint32_t sample_at(const std::uint8_t* row, std::size_t i, int depth) noexcept {
  if (depth == 8) return row[i];
  if (depth == 16) return std::uint32_t{row[2 * i]} << 8 | row[2 * i + 1];
  const std::size_t bit = i * static_cast<std::size_t>(depth);
  return std::uint32_t{row[bit / 8]} >> (8 - depth - static_cast<int>(bit % 8)) & ((1u << depth) - 1);
}

/// The sample as 8 bits, rounded to nearest; exact for up to 8.
constexpr std::uint8_t sample_to_byte(std::uint32_t sample, int depth) noexcept {
  const std::uint32_t largest = (1u << depth) - 1;
  return static_cast<std::uint8_t>((sample * 255 + largest / 2) / largest);
}

/// Pixel x of a row; false when it names no colour of the palette.
constexpr bool decode_pixel(const png_header& h, const png_colours& colours, const std::uint8_t* row, std::size_t x,
                            rgba8& into) noexcept {
  const auto channels = static_cast<std::size_t>(h.channels());
  std::uint32_t s[4] = {};
  for (std::size_t c = 0; c < channels; ++c) s[c] = sample_at(row, channels * x + c, h.depth);
  if (h.colour_type == 3) {
    if (s[0] >= static_cast<std::uint32_t>(colours.palette_size)) return false;
    into = colours.palette[s[0]];
    return true;
  }
  const auto byte = [&](std::size_t c) { return sample_to_byte(s[c], h.depth); };
  const bool gray = channels < 3;
  into = {byte(0), byte(gray ? 0 : 1), byte(gray ? 0 : 2), h.has_opacity() ? byte(channels - 1) : std::uint8_t{255}};
  if (colours.has_key && s[0] == colours.key[0] && (gray || (s[1] == colours.key[1] && s[2] == colours.key[2])))
    into.a = 0;
  return true;
}

/// Every step-th pixel from a place on.
struct spaced_pixels {
  rgba8* first;
  std::uint32_t step;
};

/// The same as decode_pixel, for rows of bytes that are the pixels' own.
constexpr void copy_bytes(int channels, const std::uint8_t* row, std::uint32_t columns, spaced_pixels to) noexcept {
  const auto copy = [&]<int Channels>() {
    for (std::uint32_t i = 0; i < columns; ++i, row += Channels)
      to.first[i * to.step] = {row[0], row[Channels < 3 ? 0 : 1], row[Channels < 3 ? 0 : 2],
                               Channels % 2 == 0 ? row[Channels - 1] : std::uint8_t{255}};
  };
  switch (channels) {
    case 1: return copy.template operator()<1>();
    case 2: return copy.template operator()<2>();
    case 3: return copy.template operator()<3>();
    default: return copy.template operator()<4>();
  }
}

/// Fills the picture from the rows; returns why not, or null.
/// needs   bytes_of_rows(h) bytes
template <class Bytes>
constexpr const char* decode_rows(const png_header& h, const png_colours& colours, Bytes& rows, image<rgba8>& picture) {
  const Bytes zeros(static_cast<std::size_t>(h.bytes_of_row(h.width)), std::uint8_t{0});
  std::uint8_t* at = rows.data();
  for (const png_pass& p : passes_of(h)) {
    const std::uint32_t columns = p.columns(h.width);
    if (columns == 0) continue;
    const std::size_t count = static_cast<std::size_t>(h.bytes_of_row(columns));
    const std::uint8_t* above = zeros.data();
    for (std::uint32_t y = p.y; y < h.height; y += p.row_step, at += count) {
      const std::uint8_t filter = *at++;
      if (!unfilter_row(filter, at, above, h.filter_step(), count)) return "row has a filter that there is not";
      above = at;
      rgba8* const to = picture.row(static_cast<int>(y));
      if (h.depth == 8 && !colours.has_key && h.colour_type != 3) {
        copy_bytes(h.channels(), at, columns, {to + p.x, p.step});
        continue;
      }
      for (std::uint32_t i = 0; i < columns; ++i)
        if (!decode_pixel(h, colours, at, i, to[p.x + i * p.step])) return "pixel has a number beyond the palette";
    }
  }
  return nullptr;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
