// SPDX-License-Identifier: MIT
// PNG: the picture in the bytes of a file, of every colour type, depth and interlacing. Works on memory only.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <irg/colour/pixel.hpp>
#include <irg/core/result.hpp>
#include <irg/io/picture_limits.hpp>
#include <irg/raster/image.hpp>
#if IRG_BODIES
#include <irg/io/detail/inflate.hpp>
#include <irg/io/detail/png_filter.hpp>
#endif

namespace irg {

/// What a PNG file may ask of memory: a small one can hold a very large picture.
struct png_read_options {
  std::uint64_t most_pixels = max_picture_pixels;
  bool operator==(const png_read_options&) const = default;
};

inline namespace IRG_ABI {

/// The picture in the bytes of a PNG file, with its opacity.
/// shape   gray becomes r = g = b, a palette's numbers its colours; pixels without opacity are opaque, those of the
///         transparent colour have a = 0
/// gives   an error with line 0 and the byte for anything but one whole picture: a wrong checksum, chunk, filter or
///         code, data that are too short or too long, more pixels than the options allow. Bytes behind the last chunk
///         are passed over, and so are chunks about gamma, profile and text: samples are taken as sRGB
/// exact   samples of up to 8 bits are kept, as v * 255 / (2^depth - 1), which is whole; 16 bits are rounded to nearest
/// cost    linear in the pixels; memory for them, their data and the file, and only as far as the file is long enough
///         for the picture that its head promises
/// source  PNG; RFC 1950; RFC 1951
template <std::convertible_to<std::span<const std::uint8_t>> Bytes>
[[nodiscard]] constexpr result<image<rgba8>> read_png(const Bytes& bytes, const png_read_options& options = {});
/// The same from bytes as load_file gives them, which are copied.
template <std::convertible_to<std::string_view> Bytes>
[[nodiscard]] constexpr result<image<rgba8>> read_png(const Bytes& bytes, const png_read_options& options = {});

}  // namespace IRG_ABI
}  // namespace irg

namespace irg::detail::inline IRG_COMPILED_ABI {

/// The picture of a file; Bytes is what the compressed data are gathered in.
template <class Bytes>
IRG_API result<image<rgba8>> read_png_file(std::span<const std::uint8_t> file, const png_read_options& options);

}  // namespace irg::detail::inline IRG_COMPILED_ABI

#if IRG_BODIES
namespace irg::detail {

// The rows of a PNG file as its decompressed data hold them, filtered and perhaps interlaced, made into pixels.

/// What a PNG file says of its pixels before the first of them.
struct png_header {
  std::uint32_t width = 0, height = 0;
  int depth = 8;  // bits per sample
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

/// A chunk of a PNG file; its data begin at `first`.
struct png_chunk {
  std::uint32_t name = 0;
  std::size_t first = 0;
  std::span<const std::uint8_t> data;
};

constexpr std::uint32_t chunk_name(const char (&name)[5]) noexcept {
  std::uint32_t n = 0;
  for (int i = 0; i < 4; ++i) n = n << 8 | static_cast<std::uint8_t>(name[i]);
  return n;
}

/// Reads a file. Bytes is what the compressed data are gathered in: as a template, nothing of this costs those who only
/// include it.
template <class Bytes>
class png_reader {
public:
  constexpr png_reader(std::span<const std::uint8_t> file, const png_read_options& options) noexcept
      : file_(file), options_(options) {}

  constexpr result<image<rgba8>> read() {
    if (!chunks()) return error_;
    const std::uint64_t needed = bytes_of_rows(header_);
    // No byte of the format becomes more than 1032; so a head that promises more than follows costs nothing.
    if (needed > 1032 * static_cast<std::uint64_t>(stream_.size()))
      return fail(first_data_, "file is too short for the picture that its head promises"), error_;
    inflater<Bytes> rows(stream_, static_cast<std::size_t>(needed));
    if (!rows.zlib()) return fail(first_data_, rows.message), error_;
    if (rows.out.size() != needed) return fail(first_data_, "compressed data are shorter than the picture"), error_;
    image<rgba8> picture(static_cast<int>(header_.width), static_cast<int>(header_.height));
    if (const char* const wrong = decode_rows(header_, colours_, rows.out, picture))
      return fail(first_data_, wrong), error_;
    return picture;
  }

private:
  constexpr bool fail(std::size_t place, const char* message) noexcept {
    error_ = {0, place + 1, message};
    return false;
  }
  constexpr std::uint32_t big_endian(std::size_t i) const noexcept {
    return std::uint32_t{file_[i]} << 24 | std::uint32_t{file_[i + 1]} << 16 | std::uint32_t{file_[i + 2]} << 8 |
           file_[i + 3];
  }

  constexpr bool next(png_chunk& c) noexcept {
    if (file_.size() - at_ < 12) return fail(file_.size(), "file ends before its last chunk");
    const std::size_t length = big_endian(at_);
    if (length > 0x7fffffff || file_.size() - at_ - 12 < length) return fail(at_, "chunk is longer than the file");
    c = {big_endian(at_ + 4), at_ + 8, file_.subspan(at_ + 8, length)};
    if (crc32(file_.subspan(at_ + 4, length + 4)) != big_endian(at_ + 8 + length))
      return fail(at_ + 8 + length, "checksum of a chunk is wrong");
    for (std::size_t i = at_ + 4; i < at_ + 8; ++i)
      if (((file_[i] | 32u) - 'a') > 25u) return fail(i, "chunk has a name that is not of letters");
    at_ += length + 12;
    return true;
  }

  constexpr bool chunks() {
    constexpr std::uint8_t signature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    for (std::size_t i = 0; i < 8; ++i)
      if (i == file_.size() || file_[i] != signature[i]) return fail(i, "file is no PNG: it begins otherwise");
    at_ = 8;
    png_chunk c;
    if (!next(c)) return false;
    if (c.name != chunk_name("IHDR")) return fail(8, "first chunk is not the header");
    if (!head(c)) return false;
    for (;;) {
      if (!next(c)) return false;
      if (c.name == chunk_name("IEND")) break;
      if (!chunk(c)) return false;
      last_was_data_ = c.name == chunk_name("IDAT");
    }
    return has_data_ || fail(file_.size(), "file has no pixels");
  }

  constexpr bool head(const png_chunk& c) noexcept {
    if (c.data.size() != 13) return fail(c.first, "header has not 13 bytes");
    header_ = {big_endian(c.first), big_endian(c.first + 4), c.data[8], c.data[9], c.data[12] == 1};
    if (header_.width > 0x7fffffff || header_.height > 0x7fffffff) return fail(c.first, "picture is too large");
    const auto refused = refuse_picture_size(static_cast<int>(header_.width), static_cast<int>(header_.height));
    if (refused) return fail(c.first, refused->message);
    if (std::uint64_t{header_.width} * header_.height > options_.most_pixels)
      return fail(c.first, "picture has more pixels than the options allow");
    const int d = header_.depth, t = header_.colour_type;
    const bool has_depth = t == 0   ? d == 1 || d == 2 || d == 4 || d == 8 || d == 16
                           : t == 3 ? d == 1 || d == 2 || d == 4 || d == 8
                                    : (t == 2 || t == 4 || t == 6) && (d == 8 || d == 16);
    if (!has_depth) return fail(c.first + 8, "colour type and depth do not fit each other");
    if (c.data[10] != 0 || c.data[11] != 0 || c.data[12] > 1)
      return fail(c.first + 10, "compression, filter or interlacing is none of the format's");
    return true;
  }

  constexpr bool chunk(const png_chunk& c) {
    if (c.name == chunk_name("IDAT")) {
      if (has_data_ && !last_was_data_) return fail(c.first, "data of the picture are interrupted");
      if (header_.colour_type == 3 && colours_.palette_size == 0) return fail(c.first, "there is no palette");
      if (!has_data_) first_data_ = c.first;
      has_data_ = true;
      stream_.insert(stream_.end(), c.data.begin(), c.data.end());
      return true;
    }
    if (c.name == chunk_name("PLTE")) return palette(c);
    if (c.name == chunk_name("tRNS")) return transparency(c);
    const bool may_be_skipped = (c.name >> 29 & 1) != 0;  // a small first letter
    return may_be_skipped || fail(c.first - 4, "chunk is needed for the picture, but not known");
  }

  constexpr bool palette(const png_chunk& c) noexcept {
    const std::size_t size = c.data.size();
    const bool is_gray = header_.colour_type == 0 || header_.colour_type == 4;
    if (is_gray || has_data_ || has_transparency_ || colours_.palette_size != 0)
      return fail(c.first, "palette stands where none may stand");
    if (size == 0 || size % 3 != 0 || size > 768) return fail(c.first, "palette is not of 1 to 256 colours");
    colours_.palette_size = static_cast<int>(size / 3);
    for (std::size_t i = 0; i < size / 3; ++i)
      colours_.palette[i] = {c.data[3 * i], c.data[3 * i + 1], c.data[3 * i + 2], 255};
    return true;
  }

  constexpr bool transparency(const png_chunk& c) noexcept {
    if (has_data_ || has_transparency_ || header_.has_opacity())
      return fail(c.first, "transparency stands where none may stand");
    has_transparency_ = true;
    if (header_.colour_type == 3) {
      if (colours_.palette_size == 0) return fail(c.first, "transparency stands before the palette");
      if (c.data.size() > static_cast<std::size_t>(colours_.palette_size))
        return fail(c.first, "transparency has more entries than the palette");
      for (std::size_t i = 0; i < c.data.size(); ++i) colours_.palette[i].a = c.data[i];
      return true;
    }
    const std::size_t channels = static_cast<std::size_t>(header_.channels());
    if (c.data.size() != 2 * channels) return fail(c.first, "transparency is not one colour");
    colours_.has_key = true;
    for (std::size_t i = 0; i < channels; ++i)
      colours_.key[i] = (std::uint32_t{c.data[2 * i]} << 8 | c.data[2 * i + 1]) & ((1u << header_.depth) - 1);
    return true;
  }

  std::span<const std::uint8_t> file_;
  png_read_options options_;
  std::size_t at_ = 0, first_data_ = 0;
  bool has_data_ = false, last_was_data_ = false, has_transparency_ = false;
  png_header header_;
  png_colours colours_;
  Bytes stream_;
  parse_error error_;
};

}  // namespace IRG_ABI

inline namespace IRG_COMPILED_ABI {

template <class Bytes>
IRG_API result<image<rgba8>> read_png_file(std::span<const std::uint8_t> file, const png_read_options& options) {
  return png_reader<Bytes>(file, options).read();
}

}  // namespace IRG_COMPILED_ABI
}  // namespace irg::detail
#endif

namespace irg::inline IRG_ABI {

template <std::convertible_to<std::span<const std::uint8_t>> Bytes>
[[nodiscard]] constexpr result<image<rgba8>> read_png(const Bytes& bytes, const png_read_options& options) {
  return detail::read_png_file<std::vector<std::uint8_t>>(bytes, options);
}

template <std::convertible_to<std::string_view> Bytes>
[[nodiscard]] constexpr result<image<rgba8>> read_png(const Bytes& bytes, const png_read_options& options) {
  const std::string_view text = bytes;
  const std::vector<std::uint8_t> copy(text.begin(), text.end());
  return detail::read_png_file<std::vector<std::uint8_t>>(copy, options);
}

}  // namespace irg::inline IRG_ABI
