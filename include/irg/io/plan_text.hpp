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
#include <irg/io/detail/plan_lines.hpp>
#include <irg/io/detail/text_cursor.hpp>
#include <irg/io/detail/text_writer.hpp>
#include <irg/mesh/part_name.hpp>
#include <irg/visibility/cell_plan.hpp>
#include <irg/visibility/potentially_visible.hpp>

namespace irg::inline IRG_ABI {

/// The plan that a text describes.
/// gives   the first error with line and column: words that are none of the format's, numbers that are none or not
///         finite, corners and portals that lack a coordinate, names given twice or not at all; then what validate()
///         finds, at the line of the cell or portal
/// exact   numbers are correctly rounded to T
/// cost    linear, and validate(); memory at most 64 times the text
template <Floating T = double>
[[nodiscard]] constexpr result<named_plan<cell_plan<T>>> read_plan(std::string_view text);

/// The bytes of a plan as text, which read_plan reads back.
/// needs   a name for each cell, all different, of letters without blanks and #; a plan without defects
/// exact   every number with the fewest digits that lead back to it
template <Floating T>
[[nodiscard]] constexpr std::vector<std::uint8_t> encode_plan(const named_plan<cell_plan<T>>& named);

/// The bytes of visible sets, eight cells in each, the first cell in the lowest bit; a row begins with a byte.
/// cost    linear
template <class Bytes = std::vector<std::uint8_t>>
[[nodiscard]] constexpr Bytes encode_visible_sets(const visible_sets& sets);

/// Visible sets from their bytes.
/// gives   an error for another first line, for more or fewer bytes than it promises (line 0 and the byte), and for
///         bits past the last cell
/// cost    linear; memory at most 16 times the bytes
template <class Sets = visible_sets>
[[nodiscard]] constexpr result<Sets> read_visible_sets(std::string_view bytes);

}  // namespace irg::inline IRG_ABI

namespace irg::detail::inline IRG_ABI {

// The reader of plans in the plane, line by line.

constexpr const char* message_of(plan_defect d) noexcept {
  switch (d) {
    case plan_defect::too_many_cells: return "the plan has more cells than 2147483647";
    case plan_defect::short_cell: return "the cell has fewer than three corners";
    case plan_defect::corner_not_finite: return "a corner of the cell is not finite";
    case plan_defect::cell_not_convex: return "the cell is not convex";
    case plan_defect::cell_not_counter_clockwise: return "the cell does not run counter-clockwise around an area";
    case plan_defect::heights_not_in_order: return "the cell's floor is not below its ceiling";
    case plan_defect::portal_to_no_cell: return "the portal leads to a cell that the plan does not have";
    case plan_defect::portal_to_itself: return "the portal leads back to its own cell: mirrors are not supported";
    case plan_defect::portal_not_finite: return "an end of the portal is not finite";
    case plan_defect::portal_without_length: return "the portal's ends are one point";
    case plan_defect::portal_off_the_wall: return "the portal does not lie in a side of both of its cells";
    case plan_defect::portal_on_one_side: return "the portal's cells lie on the same side of it";
    case plan_defect::portals_overlap: return "the portal overlaps another one of the same cell";
    default: return "";
  }
}

template <class T>
struct plan_reader : plan_lines<> {
  cell_plan<T> plan;

  using plan_lines<>::plan_lines;

  constexpr bool read() {
    while (cursor.skip_space())
      if (!line()) return false;
    const plan_finding f = validate(plan);
    if (f.defect == plan_defect::none) return true;
    const bool in_portal = f.defect >= plan_defect::portal_to_no_cell;
    const bool in_heights = f.defect == plan_defect::heights_not_in_order && heights_[f.index] != nullptr;
    return cursor.fail(in_portal    ? portals_[f.index]
                       : in_heights ? heights_[f.index]
                                    : cells_[f.index],
                       message_of(f.defect));
  }

private:
  constexpr bool line() {
    const char* const start = cursor.at;
    const std::string_view word = cursor.word();
    bool read = false;
    if (word == "cell")
      read = cell(start);
    else if (word == "heights")
      read = heights(start);
    else if (word == "portal")
      read = portal(start);
    else
      return cursor.fail(start, "a line begins with none of cell, heights and portal");
    return read && line_ends();
  }

  constexpr bool cell(const char* start) {
    if (!new_cell()) return false;
    plan_cell<T> c;
    for (point<T, 2> p; cursor.skip_blanks(); c.corners.push_back(p))
      if (!place(p, 2)) return false;
    plan.cells.push_back(std::move(c));
    cells_.push_back(start);
    heights_.push_back(nullptr);
    return true;
  }
  constexpr bool heights(const char* start) {
    std::uint32_t c = 0;
    if (!known_cell(c)) return false;
    if (heights_[c] != nullptr) return cursor.fail(start, "the cell's heights are given twice");
    heights_[c] = start;
    return number(plan.cells[c].floor) && number(plan.cells[c].ceiling);
  }
  constexpr bool portal(const char* start) {
    plan_portal<T> p;
    if (!known_cell(p.first) || !known_cell(p.second) || !place(p.a, 2) || !place(p.b, 2)) return false;
    plan.portals.push_back(p);
    portals_.push_back(start);
    return true;
  }

  std::vector<text_place<T>> cells_, heights_, portals_;  // where they stand
};

// Reads the first line of visible sets.
constexpr bool visible_sets_header(text_cursor& cursor, std::int64_t& cells, std::int64_t& unfinished) {
  const char* const first = cursor.at;
  const auto word_is = [&](std::string_view expected) {
    const std::string_view word = cursor.word_in_line();
    return word == expected || cursor.fail(cursor.at - word.size(), "expected visible cells N unfinished U");
  };
  if (!word_is("visible") || !word_is("cells") || !cursor.integer(cells) || !word_is("unfinished") ||
      !cursor.integer(unfinished))
    return false;
  if (cursor.skip_space()) return cursor.fail(cursor.at, "nothing more is expected on this line");
  if (cells < 0 || cells > 0x7fffffff || unfinished < 0 || unfinished > cells)
    return cursor.fail(first, "the numbers of cells are not possible");
  return true;
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <Floating T>
[[nodiscard]] constexpr result<named_plan<cell_plan<T>>> read_plan(std::string_view text) {
  text = detail::without_byte_order_mark(text);
  detail::plan_reader<T> reader(text);
  if (reader.read()) return named_plan<cell_plan<T>>{std::move(reader.plan), std::move(reader.names)};
  return detail::error_at(text, reader.cursor.place, reader.cursor.message);
}

template <Floating T>
[[nodiscard]] constexpr std::vector<std::uint8_t> encode_plan(const named_plan<cell_plan<T>>& named) {
  std::vector<std::uint8_t> out;
  const cell_plan<T>& plan = named.plan;
  for (std::size_t c = 0; c < plan.cells.size(); ++c) {
    detail::append_all(out, "cell ", named.names[c]);
    for (const point<T, 2>& p : plan.cells[c].corners) detail::append_numbers(out, p, 2);
    detail::append_all(out, "\nheights ", named.names[c]);
    const T heights[] = {plan.cells[c].floor, plan.cells[c].ceiling};
    detail::append_numbers(out, heights, 2);
    detail::append_text(out, "\n");
  }
  for (const plan_portal<T>& p : plan.portals) {
    detail::append_all(out, "portal ", named.names[p.first], " ", named.names[p.second]);
    for (const point<T, 2>& end : {p.a, p.b}) detail::append_numbers(out, end, 2);
    detail::append_text(out, "\n");
  }
  return out;
}

template <class Bytes>
[[nodiscard]] constexpr Bytes encode_visible_sets(const visible_sets& sets) {
  Bytes out;
  const int cells = sets.seen.extent().width;
  detail::append_all(out, "visible cells ", cells, " unfinished ", sets.unfinished, "\n");
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; x += 8)
      out.push_back(static_cast<std::uint8_t>(sets.seen.row(y, 0)[x >> 6] >> (x & 63) & 255));
  return out;
}

template <class Sets>
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

}  // namespace irg::inline IRG_ABI
