// SPDX-License-Identifier: MIT
// PPM and PGM (netpbm): the simplest picture files, uncompressed, 8 bits per channel, without opacity.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <irg/colour/encode_pixel.hpp>
#include <irg/core/result.hpp>
#include <irg/io/picture_limits.hpp>
#include <irg/raster/image.hpp>

namespace irg::inline IRG_ABI {

/// The bytes of a binary PPM file (P6) that shows the raster; opacity is dropped.
/// gives   an error when the raster has no pixel or more than max_picture_pixels
/// exact   red, green and blue as to_rgba8 gives them
/// cost    each pixel is read once; three bytes per pixel
/// source  Netpbm, ppm(5)
template <EncodableRaster R>
constexpr result<std::vector<std::uint8_t>, encode_error> encode_ppm(const R& raster);

/// The bytes of a binary PGM file (P5) that shows the raster in gray; opacity is dropped.
/// gives   an error when the raster has no pixel or more than max_picture_pixels
/// exact   gray pixels are kept; coloured ones become (299 r + 587 g + 114 b) / 1000, rounded to nearest, half up
/// cost    each pixel is read once; one byte per pixel
/// source  Netpbm, pgm(5); BT.601 for the weights
template <EncodableRaster R>
constexpr result<std::vector<std::uint8_t>, encode_error> encode_pgm(const R& raster);

/// The picture in the bytes of a PPM or PGM file, binary (P6, P5) or plain (P3, P2); gray becomes r = g = b.
/// gives   an error with line and column for anything but exactly one whole picture: a bad header, no pixels, more than
///         max_picture_pixels, a largest value outside 1 to 65535, missing or left-over data, samples out of range
/// exact   samples are scaled to 255 with rounding to nearest, half up; files with the largest value 255 are kept
/// cost    nothing is allocated before the size was checked against the file's length
/// source  Netpbm, ppm(5) and pgm(5)
template <std::convertible_to<std::span<const std::uint8_t>> Bytes>
[[nodiscard]] constexpr result<image<rgb8>> read_ppm(const Bytes& bytes);
/// The same from bytes as load_file gives them.
template <std::convertible_to<std::string_view> Bytes>
[[nodiscard]] constexpr result<image<rgb8>> read_ppm(const Bytes& bytes);

}  // namespace irg::inline IRG_ABI

namespace irg::detail::inline IRG_ABI {

// Reading and writing netpbm files, whatever their samples mean.

template <class Bytes>
constexpr void append_decimal(Bytes& file, int n) {
  if (n >= 10) append_decimal(file, n / 10);
  file.push_back(static_cast<std::uint8_t>('0' + n % 10));
}

/// The file "P<kind> width height 255" with the samples that write(pixel, out) puts there, `channels` per pixel.
template <EncodableRaster R, class Write>
constexpr result<std::vector<std::uint8_t>, encode_error> encode_netpbm(char kind, std::size_t channels,
                                                                        const R& raster, Write write) {
  const int width = width_of(raster), height = height_of(raster);
  if (const auto refused = refuse_picture_size(width, height)) return *refused;
  std::vector<std::uint8_t> file = {'P', static_cast<std::uint8_t>(kind), '\n'};
  append_decimal(file, width);
  file.push_back(' ');
  append_decimal(file, height);
  for (const char c : {'\n', '2', '5', '5', '\n'}) file.push_back(static_cast<std::uint8_t>(c));
  const std::size_t header = file.size();
  file.resize(header + static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * channels, std::uint8_t{0});
  std::uint8_t* out = file.data() + header;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x, out += channels) write(to_rgba8(get_pixel(raster, x, y)), out);
  return file;
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

/// The picture of a netpbm file from bytes of either type: char (what load_file gives) or std::uint8_t.
template <class Byte>
IRG_API result<image<rgb8>> read_netpbm(std::span<const Byte> bytes);

}  // namespace irg::detail::inline IRG_COMPILED_ABI

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

template <class Byte>
class netpbm_reader {
public:
  constexpr explicit netpbm_reader(std::span<const Byte> bytes) noexcept : bytes_(bytes) {}

  constexpr result<image<rgb8>> read() {
    const Byte kind = bytes_.size() < 2 || bytes_[0] != 'P' ? Byte{} : bytes_[1];
    if (kind != '2' && kind != '3' && kind != '5' && kind != '6')
      return fail("file is no PPM or PGM: it does not begin with P2, P3, P5 or P6");
    channels_ = kind == '2' || kind == '5' ? 1 : 3;
    at_ = 2;
    int width = 0, height = 0;
    if (!number(width, 0x7fffffff) || !number(height, 0x7fffffff)) return failure_;
    if (const auto refused = refuse_picture_size(width, height)) return fail(refused->message);
    if (!number(largest_, 65535)) return failure_;
    if (largest_ == 0) return fail("largest sample value must be from 1 to 65535");
    const bool text = kind < '5';
    if (!(text ? enough_text(width, height) : enough_bytes(width, height))) return failure_;
    image<rgb8> picture(width, height);
    if (!(text ? read_text(picture) : read_bytes(picture))) return failure_;
    return picture;
  }

private:
  // Line and column are counted only now: files that can be read do not pay for them. Lines end with LF, CR or CR LF.
  constexpr parse_error fail(const char* message) noexcept {
    failure_ = {1, 1, message};
    for (std::size_t i = 0; i < at_; ++i) {
      ++failure_.column;
      const bool is_lone_return = bytes_[i] == '\r' && (i + 1 == at_ || bytes_[i + 1] != '\n');
      if (bytes_[i] == '\n' || is_lone_return) failure_ = {failure_.line + 1, 1, message};
    }
    return failure_;
  }

  static constexpr bool is_space(Byte c) noexcept { return c == ' ' || (c >= '\t' && c <= '\r'); }
  constexpr bool at_end() const noexcept { return at_ == bytes_.size(); }

  constexpr void skip_comment() noexcept {
    while (!at_end() && bytes_[at_] != '\n' && bytes_[at_] != '\r') ++at_;
  }
  constexpr void skip_blanks() noexcept {
    for (; !at_end() && (is_space(bytes_[at_]) || bytes_[at_] == '#'); ++at_) {
      if (bytes_[at_] != '#') continue;
      skip_comment();
      if (at_end()) return;
    }
  }

  // The next number, behind one blank or more; false, with a failure, when there is none in [0, most].
  constexpr bool number(int& n, int most) noexcept {
    const std::size_t before = at_;
    skip_blanks();
    if (at_end()) return failed("file ends where a number is expected", at_);
    if (at_ == before) return failed("white space is expected before a number", at_);
    const std::size_t first = at_;
    std::int64_t value = 0;
    for (; !at_end() && bytes_[at_] >= '0' && bytes_[at_] <= '9'; ++at_) {
      value = value * 10 + (bytes_[at_] - '0');
      if (value <= most) continue;
      return failed("number is too large", first);
    }
    n = static_cast<int>(value);
    return at_ != first || failed("number without a sign is expected", first);
  }

  constexpr std::uint8_t scaled(int sample) const noexcept {
    return static_cast<std::uint8_t>((sample * 255 + largest_ / 2) / largest_);
  }
  constexpr std::uint64_t samples(int width, int height) const noexcept {
    return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) *
           static_cast<std::uint64_t>(channels_);
  }

  // What follows says whether it went well; failure_ tells why when it did not.
  constexpr bool failed(const char* message, std::size_t place) noexcept {
    at_ = place;
    return fail(message), false;
  }

  constexpr bool enough_bytes(int width, int height) noexcept {
    if (!at_end() && bytes_[at_] == '#') skip_comment();
    if (at_end() || !is_space(bytes_[at_]))
      return failed("white space is expected between the header and the pixels", at_);
    ++at_;
    const std::uint64_t needed = samples(width, height) * (largest_ > 255 ? 2 : 1);
    if (bytes_.size() - at_ < needed) return failed("file is too short for the pixels that begin here", at_);
    if (bytes_.size() - at_ > needed)
      return failed("file is too long for the one picture whose pixels begin here", at_);
    return true;
  }
  constexpr bool enough_text(int width, int height) noexcept {
    // Each sample takes a digit and a blank before it.
    if ((bytes_.size() - at_) / 2 >= samples(width, height)) return true;
    return failed("file is too short for the pixels that begin here", at_);
  }

  // Fills the picture with what next(sample) reads, until that fails.
  template <class Next>
  constexpr bool fill(image<rgb8>& picture, Next next) noexcept {
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = 0; x < picture.width(); ++x) {
        std::uint8_t value[3] = {};
        for (int c = 0; c < channels_; ++c) {
          int sample = 0;
          if (!next(sample)) return false;
          value[c] = scaled(sample);
        }
        picture(x, y) = channels_ == 1 ? rgb8{value[0], value[0], value[0]} : rgb8{value[0], value[1], value[2]};
      }
    }
    return true;
  }
  constexpr bool read_bytes(image<rgb8>& picture) noexcept {
    return fill(picture, [&](int& sample) {
      const std::size_t first = at_;
      sample = static_cast<std::uint8_t>(bytes_[at_++]);
      if (largest_ > 255) sample = sample << 8 | static_cast<std::uint8_t>(bytes_[at_++]);
      return sample <= largest_ || failed("number is too large", first);
    });
  }
  constexpr bool read_text(image<rgb8>& picture) noexcept {
    if (!fill(picture, [&](int& sample) { return number(sample, largest_); })) return false;
    skip_blanks();
    return at_end() || failed("file goes on after the last pixel", at_);
  }

  std::span<const Byte> bytes_;
  std::size_t at_ = 0;
  int channels_ = 3, largest_ = 255;
  parse_error failure_;
};

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <class Byte>
IRG_API result<image<rgb8>> read_netpbm(std::span<const Byte> bytes) {
  return netpbm_reader<Byte>(bytes).read();
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif

namespace irg::inline IRG_ABI {

template <EncodableRaster R>
constexpr result<std::vector<std::uint8_t>, encode_error> encode_ppm(const R& raster) {
  return detail::encode_netpbm('6', 3, raster, [](const rgba8& p, std::uint8_t* out) {
    out[0] = p.r;
    out[1] = p.g;
    out[2] = p.b;
  });
}

template <EncodableRaster R>
constexpr result<std::vector<std::uint8_t>, encode_error> encode_pgm(const R& raster) {
  return detail::encode_netpbm('5', 1, raster, [](const rgba8& p, std::uint8_t* out) { *out = grey_level(p); });
}

template <std::convertible_to<std::span<const std::uint8_t>> Bytes>
[[nodiscard]] constexpr result<image<rgb8>> read_ppm(const Bytes& bytes) {
  return detail::read_netpbm<std::uint8_t>(bytes);
}

template <std::convertible_to<std::string_view> Bytes>
[[nodiscard]] constexpr result<image<rgb8>> read_ppm(const Bytes& bytes) {
  return detail::read_netpbm<char>(std::string_view(bytes));
}

}  // namespace irg::inline IRG_ABI
