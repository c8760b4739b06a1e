// SPDX-License-Identifier: MIT
// A raster becomes a picture file, whose format follows from the file's name.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <irg/io/detail/text_cursor.hpp>
#include <irg/io/file.hpp>
#include <irg/io/png.hpp>
#include <irg/io/ppm.hpp>
#include <irg/io/svg.hpp>

namespace irg {

/// The picture files that irg writes.
enum class picture_format { png, ppm, svg };

/// The endings of their names, for messages.
inline constexpr const char* picture_endings = ".png, .ppm or .svg";

inline namespace IRG_ABI {

/// The format that a file's name asks for by its ending, in either case; absent when it is none of picture_endings.
[[nodiscard]] constexpr std::optional<picture_format> picture_format_of(std::string_view path) noexcept {
  if (detail::has_ending(path, ".png")) return picture_format::png;
  if (detail::has_ending(path, ".ppm")) return picture_format::ppm;
  if (detail::has_ending(path, ".svg")) return picture_format::svg;
  return std::nullopt;
}

/// The bytes of a file that shows the raster in the given format.
/// gives   an error when the raster has no pixel or more than max_picture_pixels
template <EncodableRaster R>
constexpr result<std::vector<std::uint8_t>, encode_error> encode_picture(const R& raster, picture_format format,
                                                                         const png_options& options = {}) {
  if (format == picture_format::png) return encode_png(raster, options);
  return format == picture_format::ppm ? encode_ppm(raster) : encode_svg(raster);
}

/// Writes a picture file; absent when that succeeded, else the reason, and then the path is as it was before.
/// gives   a reason when the ending is none of picture_endings, when the picture cannot be encoded (encode_png), and
///         when the file cannot be written (write_file_atomically); no file is left half-written
template <EncodableRaster R>
[[nodiscard]] std::optional<parse_error> write_image(const std::string& path, const R& raster,
                                                     const png_options& options = {}) {
  const std::optional<picture_format> format = picture_format_of(path);
  if (!format) return parse_error{0, 0, "picture's file name must end in .png, .ppm or .svg"};
  const auto bytes = encode_picture(raster, *format, options);
  if (!bytes) return parse_error{0, 0, bytes.error().message};
  return write_file_atomically(path, std::span<const std::uint8_t>(*bytes));
}

}  // namespace IRG_ABI
}  // namespace irg
