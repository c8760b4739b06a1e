// SPDX-License-Identifier: MIT
// Animated PNG: pictures shown one after another, as one file that readers of PNG show the first picture of.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <irg/io/png.hpp>

namespace irg {

/// How an animation is shown and made.
struct animation_options {
  int milliseconds = 40;  // that each picture is shown: 0 to 65535
  int repeats = 0;        // 0: without end
  png_options::compression effort = png_options::compression::fast;
  bool operator==(const animation_options&) const = default;
};

inline namespace IRG_ABI {

/// Writes an animated PNG picture by picture: what add() returns, appended, is the file.
/// shape   RGBA, 8 bits per channel, marked as sRGB; every picture replaces the one before
/// cost    holds no picture: memory for about 9 bytes per pixel while one is added
/// source  PNG
template <EncodableRaster R>
class png_animation {
public:
  /// An animation of so many pictures.
  constexpr explicit png_animation(int pictures, const animation_options& options = {}) noexcept
      : pictures_(pictures), options_(options) {}

  /// The bytes that the next picture adds to the file; with the last one the file is whole.
  /// gives   an error, and is as before, when the number of pictures is not positive or used up, when the time or the
  ///         repeats are out of range, when the picture has another size than the first or encode_png refuses its size
  /// exact   every pixel as to_rgba8 gives it
  constexpr result<std::vector<std::uint8_t>, encode_error> add(const R& picture) {
    const int width = width_of(picture), height = height_of(picture);
    if (const auto refused = refuse(width, height)) return *refused;
    const auto pixels = detail::read_pixels(picture, width, height, png_options::channels::rgba);
    const auto stream = detail::compress_rows(pixels, options_.effort);
    std::vector<std::uint8_t> bytes;
    std::uint32_t number = sequence_;  // kept when all is made: where memory gives out, nothing has changed
    if (added_ == 0) {
      bytes = detail::begin_png(pixels);
      append_animation_control(bytes);
    }
    append_frame_control(bytes, number++, width, height);
    detail::append_in_chunks(stream, [&](std::span<const std::uint8_t> part) {
      if (added_ == 0) return detail::append_chunk(bytes, "IDAT", part);
      std::vector<std::uint8_t> numbered;
      detail::append_big_endian(numbered, number++);
      numbered.insert(numbered.end(), part.begin(), part.end());
      detail::append_chunk(bytes, "fdAT", numbered);
    });
    if (added_ + 1 == pictures_) detail::append_chunk(bytes, "IEND", {});
    ++added_;
    width_ = width;
    height_ = height;
    sequence_ = number;
    return bytes;
  }

private:
  [[nodiscard]] constexpr std::optional<encode_error> refuse(int width, int height) const noexcept {
    if (pictures_ < 1) return encode_error{"animation needs at least one picture"};
    if (added_ == pictures_) return encode_error{"animation has all its pictures"};
    if (options_.milliseconds < 0 || options_.milliseconds > 65535)
      return encode_error{"animation's time is from 0 to 65535 milliseconds"};
    if (options_.repeats < 0) return encode_error{"animation cannot be repeated a negative number of times"};
    if (added_ > 0 && (width != width_ || height != height_))
      return encode_error{"pictures of an animation have one size"};
    return detail::refuse_picture_size(width, height);
  }
  constexpr void append_animation_control(std::vector<std::uint8_t>& bytes) const {
    std::vector<std::uint8_t> control;
    detail::append_big_endian(control, static_cast<std::size_t>(pictures_));
    detail::append_big_endian(control, static_cast<std::size_t>(options_.repeats));
    detail::append_chunk(bytes, "acTL", control);
  }
  // Number, size, place, time as a fraction of a second; what is done with the picture after and before: nothing.
  constexpr void append_frame_control(std::vector<std::uint8_t>& bytes, std::uint32_t number, int width,
                                      int height) const {
    std::vector<std::uint8_t> control;
    detail::append_big_endian(control, number);
    for (const int n : {width, height, 0, 0}) detail::append_big_endian(control, static_cast<std::size_t>(n));
    detail::append_big_endian(control, static_cast<std::size_t>(options_.milliseconds) << 16 | 1000u);
    control.insert(control.end(), 2, std::uint8_t{0});
    detail::append_chunk(bytes, "fcTL", control);
  }

  int pictures_, added_ = 0, width_ = 0, height_ = 0;
  std::uint32_t sequence_ = 0;
  animation_options options_;
};

/// The bytes of an animated PNG file that shows the pictures in order.
/// gives   an error as png_animation::add
/// exact   the same file from every compiler, flag set and constant evaluation
template <EncodableRaster R>
[[nodiscard]] constexpr result<std::vector<std::uint8_t>, encode_error> encode_animation(
    std::span<const R> pictures, const animation_options& options = {}) {
  constexpr std::size_t most = 0x7fffffff;
  png_animation<R> animation(static_cast<int>(pictures.size() < most ? pictures.size() : most), options);
  if (pictures.empty()) return encode_error{"animation needs at least one picture"};
  std::vector<std::uint8_t> file;
  for (const R& picture : pictures) {
    const auto bytes = animation.add(picture);
    if (!bytes) return bytes.error();
    file.insert(file.end(), bytes->begin(), bytes->end());
  }
  return file;
}

}  // namespace IRG_ABI
}  // namespace irg
