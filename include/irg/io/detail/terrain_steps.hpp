// SPDX-License-Identifier: MIT
// Reading terrain.
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>
#include <utility>

#include <irg/core/result.hpp>
#include <irg/hidden/height_grid.hpp>
#include <irg/io/detail/text_cursor.hpp>

namespace irg {
namespace detail {

// What the head says.
struct terrain_head {
  std::int64_t columns = 0, rows = 0;
  double left = 0, bottom = 0, cell = 0, no_data = -9999;
  bool left_is_border = false, bottom_is_border = false;
};

inline namespace IRG_ABI {

// Reads the lines of the head: a name and a number each, in any order.
template <class Cursor, class Head>
constexpr bool read_terrain_head(Cursor& cursor, Head& head) {
  while (cursor.skip_space() &&
         ((*cursor.at >= 'a' && *cursor.at <= 'z') || (*cursor.at >= 'A' && *cursor.at <= 'Z'))) {
    const char* const start = cursor.at;
    const std::string_view name = cursor.word();
    cursor.skip_space();
    const char* const place = cursor.at;
    double number = 0;
    if (!cursor.number(number)) return false;
    const auto count = [&](std::int64_t& into) {
      into = number >= 1 && number <= 0x1p30 ? static_cast<std::int64_t>(number) : 0;
      return into > 0 && static_cast<double>(into) == number;
    };
    bool good = true;
    if (is_word(name, "ncols"))
      good = count(head.columns);
    else if (is_word(name, "nrows"))
      good = count(head.rows);
    else if (is_word(name, "xllcorner") || is_word(name, "xllcenter"))
      head.left = number, head.left_is_border = is_word(name, "xllcorner");
    else if (is_word(name, "yllcorner") || is_word(name, "yllcenter"))
      head.bottom = number, head.bottom_is_border = is_word(name, "yllcorner");
    else if (is_word(name, "cellsize"))
      head.cell = number, good = number > 0;
    else if (is_word(name, "nodata_value"))
      head.no_data = number;
    else
      return cursor.fail(start, "expected ncols, nrows, xllcorner, yllcorner, cellsize or nodata_value");
    if (!good) return cursor.fail(place, "number is out of range");
  }
  if (head.columns < 1 || head.rows < 1 || !(head.cell > 0))
    return cursor.fail(cursor.at, "the head lacks ncols, nrows or cellsize");
  if (head.columns * head.rows > std::int64_t{1} << 30) return cursor.fail(cursor.at, "the grid is too large");
  return true;
}

}  // namespace IRG_ABI
}  // namespace detail

}  // namespace irg
