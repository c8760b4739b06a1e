// SPDX-License-Identifier: MIT
// PNG: the picture in the bytes of a file, of every colour type, depth and interlacing. Works on memory only.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <irg/core/result.hpp>
#include <irg/io/detail/inflate.hpp>
#include <irg/io/detail/png_rows.hpp>
#include <irg/io/picture_limits.hpp>
#include <irg/raster/image.hpp>

namespace irg {

/// What a PNG file may ask of memory: a small one can hold a very large picture.
struct png_read_options {
  std::uint64_t most_pixels = max_picture_pixels;
};

namespace detail {
inline namespace IRG_ABI {

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
}  // namespace detail

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
[[nodiscard]] constexpr result<image<rgba8>> read_png(const Bytes& bytes, const png_read_options& options = {}) {
  return detail::png_reader<std::vector<std::uint8_t>>(bytes, options).read();
}
/// The same from bytes as read_file gives them, which are copied.
template <std::convertible_to<std::string_view> Bytes>
[[nodiscard]] constexpr result<image<rgba8>> read_png(const Bytes& bytes, const png_read_options& options = {}) {
  const std::string_view text = bytes;
  const std::vector<std::uint8_t> copy(text.begin(), text.end());
  return detail::png_reader<std::vector<std::uint8_t>>(copy, options).read();
}

}  // namespace IRG_ABI
}  // namespace irg
