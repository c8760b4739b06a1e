// SPDX-License-Identifier: MIT
// PNG: a picture as the bytes of a compressed file without loss.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <irg/core/result.hpp>
#include <irg/io/detail/checksum.hpp>
#include <irg/io/picture_limits.hpp>
#if IRG_BODIES
#include <irg/io/detail/deflate.hpp>
#include <irg/io/detail/png_filter.hpp>
#endif

namespace irg {

/// How a PNG file is made.
struct png_options {
  enum class compression { stored, fast, good };  // not at all, in little time, to few bytes
  enum class channels { needed, rgba };           // no opacity or colour where no pixel has any, or always all four
  compression effort = compression::fast;
  channels kept = channels::needed;
  bool operator==(const png_options&) const = default;
};

inline namespace IRG_ABI {

/// The bytes of a PNG file that shows the raster: 8 bits per channel, marked as sRGB.
/// shape   gray, gray with opacity, RGB or RGBA: the fewest channels that keep every pixel, unless options say rgba
/// gives   an error when the raster has no pixel or more than max_picture_pixels
/// exact   every pixel as to_rgba8 gives it; the same file from every compiler, flag set and constant evaluation
/// cost    each pixel is read once; memory for about 9 bytes per pixel besides the file
/// source  PNG; RFC 1950; RFC 1951
template <EncodableRaster R>
constexpr result<std::vector<std::uint8_t>, encode_error> encode_png(const R& raster, const png_options& options = {});

}  // namespace IRG_ABI
}  // namespace irg

namespace irg::detail {

/// The pixels of a raster, each read once, and which channels they need.
template <class Bytes = std::vector<std::uint8_t>>
struct png_pixels {
  Bytes rgba;
  std::size_t width = 0, height = 0;
  bool has_colour = true, has_opacity = true;

  IRG_INLINE constexpr std::size_t channels() const noexcept {
    return (has_colour ? 3u : 1u) + (has_opacity ? 1u : 0u);
  }
};

}  // namespace irg::detail

namespace irg::detail::inline IRG_ABI {

template <EncodableRaster R>
constexpr png_pixels<> read_pixels(const R& raster, int width, int height, png_options::channels kept) {
  png_pixels<> p{{}, static_cast<std::size_t>(width), static_cast<std::size_t>(height)};
  p.rgba = std::vector<std::uint8_t>(4 * p.width * p.height, std::uint8_t{0});
  int colour = 0, transparency = 0;
  std::uint8_t* out = p.rgba.data();
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x, out += 4) {
      const rgba8 c = to_rgba8(get_pixel(raster, x, y));
      out[0] = c.r;
      out[1] = c.g;
      out[2] = c.b;
      out[3] = c.a;
      colour |= (c.r ^ c.g) | (c.g ^ c.b);
      transparency |= c.a ^ 255;
    }
  }
  if (kept == png_options::channels::needed) {
    p.has_colour = colour != 0;
    p.has_opacity = transparency != 0;
  }
  return p;
}

template <class Bytes>
constexpr void append_big_endian(Bytes& file, std::size_t n) {
  for (int shift = 24; shift >= 0; shift -= 8) file.push_back(static_cast<std::uint8_t>(n >> shift));
}

/// Appends a chunk: length, name, data, checksum over name and data.
/// needs   less than 2^31 bytes of data
template <class Bytes>
constexpr void append_chunk(Bytes& file, const char (&name)[5], std::span<const std::uint8_t> data) {
  append_big_endian(file, data.size());
  const std::size_t checked = file.size();
  for (int i = 0; i < 4; ++i) file.push_back(static_cast<std::uint8_t>(name[i]));
  file.insert(file.end(), data.begin(), data.end());
  append_big_endian(file, crc32(std::span<const std::uint8_t>(file).subspan(checked)));
}

template <class Bytes>
constexpr void append_header(Bytes& file, const png_pixels<Bytes>& p) {
  Bytes header;
  append_big_endian(header, p.width);
  append_big_endian(header, p.height);
  const int colour_type = (p.has_colour ? 2 : 0) + (p.has_opacity ? 4 : 0);
  for (const int byte : {8, colour_type, 0, 0, 0}) header.push_back(static_cast<std::uint8_t>(byte));
  append_chunk(file, "IHDR", header);
}

/// What every file begins with.
template <class Bytes>
constexpr Bytes begin_png(const png_pixels<Bytes>& p) {
  Bytes file = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  append_header(file, p);
  const std::uint8_t perceptual[] = {0};
  append_chunk(file, "sRGB", perceptual);
  return file;
}

/// Calls append(part) for the parts of a stream, one for each chunk.
template <class Bytes, class Append>
constexpr void append_in_chunks(const Bytes& stream, const Append& append) {
  constexpr std::size_t chunk_size = 1u << 20;  // far below the format's limit, and testable
  for (std::size_t first = 0; first < stream.size(); first += chunk_size) {
    const std::size_t rest = stream.size() - first;
    append(std::span<const std::uint8_t>(stream).subspan(first, rest < chunk_size ? rest : chunk_size));
  }
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

/// The rows of a picture as its chunks hold them.
template <class Bytes>
IRG_API Bytes compress_rows(const png_pixels<Bytes>& p, png_options::compression effort);

/// The file of a picture.
template <class Bytes>
IRG_API Bytes encode_png_pixels(const png_pixels<Bytes>& p, png_options::compression effort);

}  // namespace irg::detail::inline IRG_COMPILED_ABI

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

/// Copies the needed channels of row y.
template <class Bytes>
constexpr void copy_row(const png_pixels<Bytes>& p, std::size_t y, std::uint8_t* out) noexcept {
  const std::uint8_t* in = p.rgba.data() + 4 * p.width * y;
  for (std::size_t x = 0; x < p.width; ++x, in += 4) {
    *out++ = in[0];
    if (p.has_colour) {
      *out++ = in[1];
      *out++ = in[2];
    }
    if (p.has_opacity) *out++ = in[3];
  }
}

enum class filtering { none, adaptive };

/// The rows as PNG compresses them: each its filter's number and its differences.
template <class Bytes>
constexpr Bytes filter_rows(const png_pixels<Bytes>& p, filtering mode) {
  const std::size_t pixel = p.channels(), count = pixel * p.width;
  Bytes filtered(p.height * (count + 1), std::uint8_t{0});
  Bytes above(pixel + count, std::uint8_t{0}), row(pixel + count, std::uint8_t{0});
  for (std::size_t y = 0; y < p.height; ++y, row.swap(above)) {
    copy_row(p, y, row.data() + pixel);
    const png_row r{row.data() + pixel, above.data() + pixel, pixel, count};
    write_filtered(r, mode == filtering::none ? png_filter::none : best_filter(r), filtered.data() + y * (count + 1));
  }
  return filtered;
}

constexpr deflate_effort effort_of(png_options::compression c) noexcept {
  switch (c) {
    case png_options::compression::stored: return {0, 0, 0};
    case png_options::compression::fast: return {8, 8, 64};
    case png_options::compression::good: break;
  }
  return {64, 64, 258};
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <class Bytes>
IRG_API Bytes compress_rows(const png_pixels<Bytes>& p, png_options::compression effort) {
  const bool stored = effort == png_options::compression::stored;
  return zlib_compress(filter_rows(p, stored ? filtering::none : filtering::adaptive), effort_of(effort));
}

template <class Bytes>
IRG_API Bytes encode_png_pixels(const png_pixels<Bytes>& p, png_options::compression effort) {
  Bytes file = begin_png(p);
  append_in_chunks(compress_rows(p, effort), [&](auto part) { append_chunk(file, "IDAT", part); });
  append_chunk(file, "IEND", {});
  return file;
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif

namespace irg::inline IRG_ABI {

template <EncodableRaster R>
constexpr result<std::vector<std::uint8_t>, encode_error> encode_png(const R& raster, const png_options& options) {
  const int width = width_of(raster), height = height_of(raster);
  if (const auto refused = detail::refuse_picture_size(width, height)) return *refused;

  return detail::encode_png_pixels(detail::read_pixels(raster, width, height, options.kept), options.effort);
}

}  // namespace irg::inline IRG_ABI
