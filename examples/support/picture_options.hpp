// SPDX-License-Identifier: MIT
// What programs that write a picture share: its name and size, the guard against writing over what was read, writing
// it, and the end.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>

#include <irg/io/image_file.hpp>
#include <irg/math/decimal.hpp>
#include <irg/raster/image.hpp>

#include "command_line.hpp"

namespace program {

/// Pixels of a picture.
struct picture_size {
  int width = 640, height = 480;
};

/// The value of --size: WxH.
inline picture_size read_size(command_line& line) {
  const std::string_view text = line.value_of("--size");
  const char* const end = text.data() + text.size();
  const auto width = irg::parse_integer<int>(text.data(), end);
  const bool cross = width.end != end && *width.end == 'x';
  const auto height = irg::parse_integer<int>(cross ? width.end + 1 : end, end);
  const auto side = [](int v) { return v >= 1 && v <= 65535; };
  if (text.find_first_not_of("0123456789x") != text.npos || !cross || height.end != end || !side(width.value) ||
      !side(height.value) || std::int64_t{width.value} * height.value > std::int64_t{1} << 27)
    line.fail("option --size needs WxH with sides from 1 to 65535 and at most 134217728 pixels, not '" +
              std::string(text) + "'");
  return {width.value, height.value};
}

/// Whether two paths lead to the same file, whatever they look like.
inline bool one_file(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return false;
  std::error_code failed;
  const auto resolved = [&](const std::string& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, failed), failed);
  };
  return a == b || (resolved(a) == resolved(b) && !failed);
}

/// Refuses a picture's name whose ending names no kind of picture that can be written.
inline void expect_picture_name(const command_line& line, const std::string& path) {
  if (!irg::image_format_of_name(path)) line.fail("the picture's name must end in .png, .ppm or .svg, not: " + path);
}

/// Writes a picture, or ends the program.
inline void write_picture(const command_line& line, const std::string& path, const irg::image<irg::rgba8>& picture) {
  if (const auto saved = irg::save_image(path, picture); !saved)
    line.fail(std::string(saved.error().message) + ": " + path);
}

/// The options of programs that read numbers, print what they compute and draw it.
struct drawing_options {
  std::string input, out;
  bool list = false;
  picture_size size;

  /// Reads the value of the option `word`, which has to be one of these.
  void read(command_line& line, std::string_view word) {
    if (word == "--input") {
      input = line.file_of(word);
    } else if (word == "-o") {
      out = line.value_of(word);
      expect_picture_name(line, out);
    } else if (word == "--list") {
      list = true;
    } else if (word == "--size") {
      size = read_size(line);
    } else {
      line.refuse(word);
    }
  }

  /// What can be judged only when all options are read.
  void finish(const command_line& line) const {
    if (one_file(out, input)) line.fail("the input would be overwritten: " + input);
  }
};

/// The answer to --window; ends the program where it was built without windows.
inline bool can_show([[maybe_unused]] const command_line& line) {
#ifdef IRG_HAVE_SDL2
  return true;
#else
  line.fail("this program was built without SDL2, which --window needs");
#endif
}

/// Removes a file that was written, but no device or pipe that stands for one.
inline void remove_written(const std::string& path) {
  std::error_code failed;
  if (std::filesystem::is_regular_file(path, failed)) std::remove(path.c_str());
}

/// Ends standard output. Where it cannot be written the program ends, and the files written by then are removed.
inline void finish_output(const command_line& line, const std::string& picture, const std::string& other = {}) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
  remove_written(picture);
  remove_written(other);
  line.fail("standard output cannot be written");
}

}  // namespace program
