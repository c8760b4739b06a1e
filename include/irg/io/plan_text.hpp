// SPDX-License-Identifier: MIT
// Plans of cells and portals as text, a line for each: `cell NAME x y x y x y ...`, the corners counter-clockwise;
// `heights NAME floor ceiling`; `portal NAME NAME x y x y`. `#` begins a comment. A cell is named before it is used.
// The sets of visible cells as bytes: the line `visible cells N unfinished U`, then N rows of N bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include <irg/core/result.hpp>
#include <irg/io/detail/plan_reader.hpp>
#include <irg/io/detail/text_cursor.hpp>
#include <irg/io/detail/text_writer.hpp>
#include <irg/visibility/potentially_visible.hpp>

namespace irg {
inline namespace IRG_ABI {

/// The plan that a text describes.
/// gives   the first error with line and column: words that are none of the format's, numbers that are none or not
///         finite, corners and portals that lack a coordinate, names given twice or not at all; then what validate()
///         finds, at the line of the cell or portal
/// exact   numbers are correctly rounded to T
/// cost    linear, and validate(); memory at most 64 times the text
template <Floating T = double>
[[nodiscard]] constexpr result<named_plan<cell_plan<T>>> read_plan(std::string_view text) {
  text = detail::without_byte_order_mark(text);
  detail::plan_reader<T> reader(text);
  if (reader.read()) return named_plan<cell_plan<T>>{std::move(reader.plan), std::move(reader.names)};
  return detail::error_at(text, reader.cursor.place, reader.cursor.message);
}

/// The bytes of a plan as text, which read_plan reads back.
/// needs   a name for each cell, all different, of letters without blanks and #; a plan without defects
/// exact   every number with the fewest digits that lead back to it
template <Floating T>
[[nodiscard]] constexpr std::vector<std::uint8_t> encode_plan(const named_plan<cell_plan<T>>& named) {
  std::vector<std::uint8_t> out;
  const cell_plan<T>& plan = named.plan;
  for (std::size_t c = 0; c < plan.cells.size(); ++c) {
    detail::append_text(out, "cell ");
    detail::append_text(out, named.names[c]);
    for (const point<T, 2>& p : plan.cells[c].corners) detail::append_numbers(out, p, 2);
    detail::append_text(out, "\nheights ");
    detail::append_text(out, named.names[c]);
    const T heights[] = {plan.cells[c].floor, plan.cells[c].ceiling};
    detail::append_numbers(out, heights, 2);
    detail::append_text(out, "\n");
  }
  for (const plan_portal<T>& p : plan.portals) {
    detail::append_text(out, "portal ");
    detail::append_text(out, named.names[p.first]);
    detail::append_text(out, " ");
    detail::append_text(out, named.names[p.second]);
    for (const point<T, 2>& end : {p.a, p.b}) detail::append_numbers(out, end, 2);
    detail::append_text(out, "\n");
  }
  return out;
}

/// The bytes of visible sets, eight cells in each, the first cell in the lowest bit; a row begins with a byte.
/// cost    linear
template <class Bytes = std::vector<std::uint8_t>>
[[nodiscard]] constexpr Bytes encode_visible_sets(const visible_sets& sets) {
  Bytes out;
  const int cells = sets.seen.extent().width;
  detail::append_text(out, "visible cells ");
  detail::append_number(out, cells);
  detail::append_text(out, " unfinished ");
  detail::append_number(out, sets.unfinished);
  detail::append_text(out, "\n");
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; x += 8)
      out.push_back(static_cast<std::uint8_t>(sets.seen.row(y, 0)[x >> 6] >> (x & 63) & 255));
  return out;
}

/// Visible sets from their bytes.
/// gives   an error for another first line, for more or fewer bytes than it promises (line 0 and the byte), and for
///         bits past the last cell
/// cost    linear; memory at most 16 times the bytes
template <class Sets = visible_sets>
[[nodiscard]] constexpr result<Sets> read_visible_sets(std::string_view bytes) {
  const std::size_t end = bytes.find('\n');
  detail::text_cursor cursor(bytes.substr(0, end == bytes.npos ? bytes.size() : end), '\0');
  std::int64_t cells = 0, unfinished = 0;
  if (!detail::visible_sets_header(cursor, cells, unfinished))
    return detail::error_at(bytes, cursor.place, cursor.message);
  const std::size_t head = end == bytes.npos ? bytes.size() : end + 1, held = bytes.size() - head;
  const std::size_t width = static_cast<std::size_t>(cells + 7) / 8;
  if (cells != 0 && held / width < static_cast<std::size_t>(cells))
    return detail::error_at_byte(bytes, bytes.data() + bytes.size(), "the rows of visible cells are cut off");
  if (held != width * static_cast<std::size_t>(cells))
    return detail::error_at_byte(bytes, bytes.data() + head + width * static_cast<std::size_t>(cells),
                                 "nothing is expected after the rows of visible cells");
  const int n = static_cast<int>(cells);
  Sets out{cell_grid(grid_extent{n, n, 1}), unfinished};
  const char* at = bytes.data() + head;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; x += 8, ++at) {
      const auto bits = static_cast<std::uint64_t>(static_cast<std::uint8_t>(*at));
      if (n - x < 8 && bits >> (n - x) != 0)
        return detail::error_at_byte(bytes, at, "a row of visible cells has bits past the last cell");
      out.seen.row(y, 0)[x >> 6] |= bits << (x & 63);
    }
  return out;
}

}  // namespace IRG_ABI
}  // namespace irg
