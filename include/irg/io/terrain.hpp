// SPDX-License-Identifier: MIT
// Terrain files: Esri's ASCII grid, text with a head of names and numbers and the heights row by row from the north.
// Works on memory only.
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>

#include <irg/core/result.hpp>
#include <irg/hidden/height_grid.hpp>
#include <irg/io/detail/text_cursor.hpp>

namespace irg::inline IRG_ABI {

/// The heights of an Esri ASCII grid.
/// shape   x to the east, z to the north: places are those of the samples, half a cell inside of a corner that the head
///         gives as a border. A height that is the file's nodata_value (-9999 unless it says otherwise) is NaN: a gap
/// needs   the bytes in memory; they are not kept
/// gives   the first error with line and column in place of half a grid: a name it does not know, a number that is
///         none, too few heights, something behind the last one
/// exact   numbers are correctly rounded; a place is (k * cell) + first, each operation rounded
/// cost    linear; memory at most eight times the file and 1 MiB, whatever its counts claim
/// source  Esri
template <class Grid = height_grid>
[[nodiscard]] constexpr result<Grid> read_terrain(std::string_view text);

}  // namespace irg::inline IRG_ABI

namespace irg::detail {

// What the head says.
struct terrain_head {
  std::int64_t columns = 0, rows = 0;
  double left = 0, bottom = 0, cell = 0, no_data = -9999;
  bool left_is_border = false, bottom_is_border = false;
};

inline namespace IRG_ABI {

// Reads the lines of the head: a name and a number each, in any order.
constexpr bool read_terrain_head(text_cursor& cursor, terrain_head& head) {
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
    else if (is_word(name, "xllcorner") || is_word(name, "xllcenter")) {
      head.left = number;
      head.left_is_border = is_word(name, "xllcorner");
    } else if (is_word(name, "yllcorner") || is_word(name, "yllcenter")) {
      head.bottom = number;
      head.bottom_is_border = is_word(name, "yllcorner");
    } else if (is_word(name, "cellsize")) {
      head.cell = number;
      good = number > 0;
    } else if (is_word(name, "nodata_value")) {
      head.no_data = number;
    } else {
      return cursor.fail(start, "expected ncols, nrows, xllcorner, yllcorner, cellsize or nodata_value");
    }
    if (!good) return cursor.fail(place, "number is out of range");
  }
  if (head.columns < 1 || head.rows < 1 || !(head.cell > 0))
    return cursor.fail(cursor.at, "the head lacks ncols, nrows or cellsize");
  if (head.columns * head.rows > std::int64_t{1} << 30) return cursor.fail(cursor.at, "the grid is too large");
  return true;
}

}  // namespace IRG_ABI
}  // namespace irg::detail

namespace irg::inline IRG_ABI {

template <class Grid>
[[nodiscard]] constexpr result<Grid> read_terrain(std::string_view text) {
  text = detail::without_byte_order_mark(text);
  detail::text_cursor cursor(text, '\0');
  const auto failed = [&] { return detail::error_at(text, cursor.place, cursor.message); };
  detail::terrain_head head;
  if (!detail::read_terrain_head(cursor, head)) return failed();
  const auto columns = static_cast<std::size_t>(head.columns), rows = static_cast<std::size_t>(head.rows);
  Grid g;
  if (columns * rows > text.size() / 2) {  // each height takes a digit and a blank, the head more than the last blank
    cursor.fail(cursor.at, "the file is too short for so many heights");
    return failed();
  }
  const auto place = [&](double first, bool is_border, std::size_t k) {
    return product(static_cast<double>(k) + (is_border ? 0.5 : 0), head.cell) + first;
  };
  g.x.reserve(columns);
  g.z.reserve(rows);
  for (std::size_t i = 0; i < columns; ++i) g.x.push_back(place(head.left, head.left_is_border, i));
  for (std::size_t j = 0; j < rows; ++j) g.z.push_back(place(head.bottom, head.bottom_is_border, j));
  g.heights.resize(columns * rows, 0.0);
  for (std::size_t j = rows; j-- > 0;)
    for (std::size_t i = 0; i < columns; ++i) {
      double height = 0;
      if (!cursor.number(height)) return failed();
      g.heights[i * rows + j] = height == head.no_data ? std::numeric_limits<double>::quiet_NaN() : height;
    }
  if (cursor.skip_space()) {
    cursor.fail(cursor.at, "something follows the last height");
    return failed();
  }
  return g;
}

}  // namespace irg::inline IRG_ABI
