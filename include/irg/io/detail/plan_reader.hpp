// SPDX-License-Identifier: MIT
// The reader of plans in the plane, line by line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include <irg/io/detail/plan_lines.hpp>
#include <irg/mesh/part_name.hpp>
#include <irg/visibility/cell_plan.hpp>

namespace irg {

namespace detail {
inline namespace IRG_ABI {

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

template <class Cursor>
constexpr bool visible_sets_header(Cursor& cursor, std::int64_t& cells, std::int64_t& unfinished) {
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

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
