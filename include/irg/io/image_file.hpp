// SPDX-License-Identifier: MIT
// A raster becomes an image file, whose format follows from its name, and an image file a raster.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <irg/io/detail/text_place.hpp>
#include <irg/io/file.hpp>
#include <irg/io/png.hpp>
#include <irg/io/png_read.hpp>
#include <irg/io/ppm.hpp>
#include <irg/io/svg.hpp>
#include <irg/raster/convert_image.hpp>

namespace irg {

/// The image files that irg writes.
enum class image_format { png, ppm, svg };

/// The endings of their names, for messages.
inline constexpr const char* picture_endings = ".png, .ppm or .svg";

inline namespace IRG_ABI {

/// The format that a file's name asks for by its ending, in either case; absent when it is none of picture_endings.
[[nodiscard]] constexpr std::optional<image_format> image_format_of_name(std::string_view path) noexcept {
  if (detail::has_ending(path, ".png")) return image_format::png;
  if (detail::has_ending(path, ".ppm")) return image_format::ppm;
  if (detail::has_ending(path, ".svg")) return image_format::svg;
  return std::nullopt;
}

/// The bytes of a file that shows the raster in the given format.
/// gives   an error when the raster has no pixel or more than max_picture_pixels
template <EncodableRaster R>
constexpr result<std::vector<std::uint8_t>, encode_error> encode_image(const R& raster, image_format format,
                                                                       const png_options& options = {}) {
  if (format == image_format::png) return encode_png(raster, options);
  return format == image_format::ppm ? encode_ppm(raster) : encode_svg(raster);
}

/// Writes an image file: true when that succeeded, else the reason, and then the path is as it was before.
/// gives   a reason when the ending is none of picture_endings, when the picture cannot be encoded (encode_png), and
///         when the file cannot be written (save_file); no file is left half-written
template <EncodableRaster R>
[[nodiscard]] result<void> save_image(const std::string& path, const R& raster, const png_options& options = {}) {
  const std::optional<image_format> format = image_format_of_name(path);
  if (!format) return parse_error{0, 0, "picture's file name must end in .png, .ppm or .svg"};
  const auto bytes = encode_image(raster, *format, options);
  if (!bytes) return parse_error{0, 0, bytes.error().message};
  return save_file(path, std::span<const std::uint8_t>(*bytes));
}

/// The picture in an image file, PNG or PPM by what its bytes say, in pixels of the type that you name.
/// gives   the error of load_file, of the format's reader, or one that says that it is neither
/// exact   as read_png, read_ppm and convert_pixel
/// cost    the file's size in memory beside what the reader takes
template <DecodablePixel P = rgba8>
[[nodiscard]] result<image<P>> load_image(const std::string& path) {
  const auto bytes = load_file(path);
  if (!bytes) return bytes.error();
  const auto as_asked = [](const auto& picture) { return convert_image<P>(picture); };
  const std::string_view text(*bytes);
  if (text.starts_with("\x89PNG")) return read_png(text).transform(as_asked);
  if (text.starts_with("P")) return read_ppm(text).transform(as_asked);
  return parse_error{0, 0, "file is neither PNG nor PPM"};
}

IRG_RENAMED(encode_picture, encode_image)
IRG_RENAMED(picture_format_of, image_format_of_name)

/// The old form of save_image: the reason of a failure, where save_image is true when the file was written.
template <EncodableRaster R>
[[nodiscard, deprecated("irg: use save_image, which is true when the file was written")]] std::optional<parse_error>
write_image(const std::string& path, const R& raster, const png_options& options = {}) {
  const result<void> saved = save_image(path, raster, options);
  return saved ? std::nullopt : std::optional(saved.error());
}

}  // namespace IRG_ABI
}  // namespace irg
