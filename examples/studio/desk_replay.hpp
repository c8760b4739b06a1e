// SPDX-License-Identifier: MIT
// Keys and the mouse from a text in place of a window's.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <irg/math/decimal.hpp>

#include "../support/command_line.hpp"
#include "studio_desk.hpp"

namespace program {

/// Does what each line says until a key ends it: `key NAME ...`, `type TEXT`, `press X Y`, `drag DX DY`, `slide DX DY`
/// (with the right button), `wheel X Y STEPS`, `drop FILE`. A line that is none ends the program.
/// needs   `file` names the text in messages
inline void replay(const command_line& line, studio_desk& desk, std::string_view text, const std::string& file) {
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view row = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(row.size() + 1, text.size()));
    std::vector<std::string> words;
    for (std::size_t i = 0; (i = row.find_first_not_of(" \t\r", i)) != row.npos;) {
      const std::size_t end = std::min(row.find_first_of(" \t\r", i), row.size());
      words.emplace_back(row.substr(i, end - i));
      i = end;
    }
    if (words.empty() || words[0].starts_with('#')) continue;
    std::array<int, 3> n{};
    std::size_t count = 0;
    for (bool whole = true; whole && count < 3 && count + 1 < words.size(); count += whole ? 1 : 0) {
      const char *const from = words[count + 1].data(), *const to = from + words[count + 1].size();
      const auto read = irg::parse_integer<int>(from, to);
      whole = read.status == irg::decimal_status::ok && read.end == to && read.value > -65536 && read.value < 65536;
      n[count] = read.value;
    }
    const std::string& what = words[0];
    const auto is = [&](std::string_view name, std::size_t numbers) {
      return what == name && words.size() == numbers + 1 && count == numbers;
    };
    const std::size_t rest = std::min(row.find(what) + what.size() + 1, row.size());
    if (what == "key" && words.size() > 1) {
      for (std::size_t i = 1; i < words.size(); ++i)
        if (!desk.key(words[i])) return;
    } else if (what == "type") {
      desk.type(row.substr(rest));
    } else if (is("press", 2)) {
      desk.press(n[0], n[1]);
    } else if (is("drag", 2) || is("slide", 2)) {
      desk.drag(n[0], n[1], what == "slide");
    } else if (is("wheel", 3) && n[2] != 0) {
      desk.wheel(n[0], n[1], n[2]);
    } else if (what == "drop" && words.size() == 2) {
      desk.drop_file(words[1]);
    } else {
      line.fail("no key and no move of the mouse: " + file + ":" + std::to_string(number) + ":1");
    }
  }
}

}  // namespace program
