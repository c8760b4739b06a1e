// SPDX-License-Identifier: MIT
// What programs that write a picture share: its size, the guard against writing over what was read, and the end.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>

#include <irg/math/decimal.hpp>

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

/// Ends standard output. Where it cannot be written the program ends, and the picture, written by then, is removed.
inline void finish_output(const command_line& line, const std::string& picture) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
  if (!picture.empty()) std::remove(picture.c_str());
  line.fail("standard output cannot be written");
}

}  // namespace program
