// SPDX-License-Identifier: MIT
// A whole text that a program reads from standard input or a file.
#pragma once

#include <cstdio>
#include <string>
#include <utility>

#include <irg/io/file.hpp>

#include "command_line.hpp"

namespace program {

/// The text behind a byte order mark.
inline std::string without_mark(std::string text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  return text;
}

/// The file, or standard input when the path is empty, without a byte order mark. or standard input when the path is empty. What cannot be read ends the program.
/// needs   `what` names the text in messages
inline std::string read_text(const command_line& line, const std::string& path, const char* what) {
  std::string text;
  if (!path.empty()) {
    const auto file = irg::load_file(path);
    if (!file) line.fail(with_place(file.error(), path));
    text.assign(file->data(), file->data() + file->size());
    return without_mark(std::move(text));
  }
  char part[65536];
  while (const std::size_t n = std::fread(part, 1, sizeof part, stdin)) {
    text.append(part, n);
    if (text.size() > (std::size_t{1} << 31))
      line.fail("the " + std::string(what) + " has more than 2147483648 bytes: stdin");
  }
  if (std::ferror(stdin) != 0) line.fail("input cannot be read: stdin");
  return without_mark(std::move(text));
}

}  // namespace program
