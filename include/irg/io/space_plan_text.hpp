// SPDX-License-Identifier: MIT
// Plans of convex cells of space as text, a line for each thing: `point x y z`, numbered from 1 as they come;
// `cell NAME`, and its faces after it, `face n n n ...`, the numbers of their corners counter-clockwise as seen from
// outside; `portal NAME NAME n n n ...`, an opening in a face of both cells, either way round. `#` begins a comment.
// What is named or numbered stands before.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include <irg/core/result.hpp>
#include <irg/io/detail/plan_lines.hpp>
#include <irg/io/detail/text_writer.hpp>
#include <irg/visibility/space_plan.hpp>

namespace irg::inline IRG_ABI {

/// Whether a text describes a plan in space rather than one in the plane: its first word is `point`.
[[nodiscard]] constexpr bool is_space_plan(std::string_view text) noexcept;

/// The plan in space that a text describes; the corners of each cell in the order in which its faces name them.
/// gives   the first error with line and column: words that are none of the format's, numbers that are none or not
///         finite, points that lack a coordinate, names and numbers of nothing that stands before; then what validate()
///         finds, at the line of the cell, face or portal
/// exact   numbers are correctly rounded to T. Faces and portals of more than three corners must be flat as they are
///         then: triangles always are
/// cost    linear, the corners of each cell for each of its faces' corners, and validate(); memory at most 64 times the
///         text
template <Floating T = double>
[[nodiscard]] constexpr result<named_plan<space_plan<T>>> read_space_plan(std::string_view text);

/// The bytes of a plan in space as text, which read_space_plan reads back.
/// needs   a name for each cell, all different, of letters without blanks and #; a plan without defects and with faces,
///         which name each cell's corners in their order first
/// exact   every number with the fewest digits that lead back to it
/// cost    sorts the corners
template <Floating T>
[[nodiscard]] constexpr std::vector<std::uint8_t> encode_plan(const named_plan<space_plan<T>>& named);

}  // namespace irg::inline IRG_ABI

namespace irg::detail::inline IRG_ABI {

// The reader of plans in space, line by line.

constexpr const char* message_of(space_plan_defect d) noexcept {
  using enum space_plan_defect;
  switch (d) {
    case corner_not_finite: return "a corner of the cell is not finite";
    case face_without_area: return "the face has fewer than three corners, or the first three are on a line";
    case face_not_flat: return "the face is not flat";
    case face_not_convex: return "the face is not convex";
    case cell_not_convex: return "the cell is not convex: a corner of it is before this face";
    case cell_without_volume: return "the cell has no volume";
    case cell_not_closed: return "the cell's faces do not close it: each edge belongs to two of them, once each way";
    case portal_to_no_cell: return "the portal leads to a cell that the plan does not have";
    case portal_to_itself: return "the portal leads back to its own cell: mirrors are not supported";
    case portal_without_area: return "the portal has no area: fewer than three corners, or the first three on a line";
    case portal_not_flat: return "the portal is not flat";
    case portal_not_convex: return "the portal is not convex";
    case cell_on_both_sides: return "the portal's cells do not lie on both sides of it";
    case portal_off_the_wall: return "the portal does not lie in a face of both of its cells";
    default: return "";
  }
}

template <class T>
struct space_plan_reader : plan_lines<> {
  space_plan<T> plan;

  using plan_lines<>::plan_lines;

  constexpr bool read() {
    while (cursor.skip_space())
      if (!line()) return false;
    for (std::size_t c = 0; c < plan.cells.size(); ++c)
      if (plan.faces[c].size() < 4) return cursor.fail(cells_[c], "the cell has fewer than four faces");
    for (auto& p : plan.portals)
      if (p.ring.size() > 2 && !are_on_side<T>(p.ring, plan.cells[p.first], 1))
        std::reverse(p.ring.begin(), p.ring.end());
    const space_plan_finding f = validate(plan);
    if (f.defect == space_plan_defect::none) return true;
    const bool in_portal = f.defect >= space_plan_defect::portal_to_no_cell;
    const bool in_cell = f.defect == space_plan_defect::cell_not_closed;
    return cursor.fail(in_portal ? portals_[f.portal]
                       : in_cell ? cells_[f.cell]
                                 : faces_[f.cell][f.face],
                       message_of(f.defect));
  }

private:
  // A point as a corner of the last cell that has it, counted from 1.
  struct corner_of_cell {
    std::size_t cell = 0;
    std::uint32_t at = 0;
  };

  constexpr bool line() {
    const char* const start = cursor.at;
    const std::string_view word = cursor.word();
    bool read = false;
    if (word == "point")
      read = corner();
    else if (word == "cell")
      read = cell(start);
    else if (word == "face")
      read = face(start);
    else if (word == "portal")
      read = portal(start);
    else
      return cursor.fail(start, "a line begins with none of point, cell, face and portal");
    return read && line_ends();
  }

  constexpr bool corner() {
    points_.emplace_back();
    corners_.emplace_back();
    return place(points_.back(), 3);
  }
  constexpr bool cell(const char* start) {
    if (!new_cell()) return false;
    plan.cells.emplace_back();
    plan.faces.emplace_back();
    faces_.emplace_back();
    cells_.push_back(start);
    return true;
  }
  constexpr bool face(const char* start) {
    if (plan.cells.empty()) return cursor.fail(start, "no cell stands before the face");
    space_face f;
    std::uint32_t number = 0;
    while (cursor.skip_blanks()) {
      if (!known_point(number)) return false;
      corner_of_cell& known = corners_[number];
      if (known.cell != plan.cells.size()) {
        known = {plan.cells.size(), static_cast<std::uint32_t>(plan.cells.back().size())};
        plan.cells.back().push_back(points_[number]);
      }
      f.push_back(known.at);
    }
    plan.faces.back().push_back(f);
    faces_.back().push_back(start);
    return true;
  }
  constexpr bool portal(const char* start) {
    space_portal<T> p;
    if (!known_cell(p.first) || !known_cell(p.second)) return false;
    for (std::uint32_t number = 0; cursor.skip_blanks(); p.ring.push_back(points_[number]))
      if (!known_point(number)) return false;
    plan.portals.push_back(p);
    portals_.push_back(start);
    return true;
  }
  constexpr bool known_point(std::uint32_t& number) {
    const char* const at = cursor.at;
    std::int64_t n = 0;
    if (!cursor.integer(n)) return false;
    if (n < 1 || static_cast<std::uint64_t>(n) > points_.size())
      return cursor.fail(at, "no point of this number stands before");
    number = static_cast<std::uint32_t>(n - 1);
    return true;
  }

  std::vector<point<T, 3>> points_;
  std::vector<corner_of_cell> corners_;  // what each point is
  std::vector<text_place<T>> cells_, portals_;  // where they stand
  std::vector<std::vector<text_place<T>>> faces_;
};

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

[[nodiscard]] constexpr bool is_space_plan(std::string_view text) noexcept {
  detail::text_cursor cursor(detail::without_byte_order_mark(text), '#');
  return cursor.skip_space() && cursor.word() == "point";
}

template <Floating T>
[[nodiscard]] constexpr result<named_plan<space_plan<T>>> read_space_plan(std::string_view text) {
  text = detail::without_byte_order_mark(text);
  detail::space_plan_reader<T> reader(text);
  if (reader.read()) return named_plan<space_plan<T>>{std::move(reader.plan), std::move(reader.names)};
  return detail::error_at(text, reader.cursor.place, reader.cursor.message);
}

template <Floating T>
[[nodiscard]] constexpr std::vector<std::uint8_t> encode_plan(const named_plan<space_plan<T>>& named) {
  const space_plan<T>& plan = named.plan;
  const auto before = [](const point<T, 3>& p, const point<T, 3>& q) {
    return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
  };
  std::vector<point<T, 3>> points;
  for (const auto& c : plan.cells) points.insert(points.end(), c.begin(), c.end());
  for (const auto& p : plan.portals) points.insert(points.end(), p.ring.begin(), p.ring.end());
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<std::uint8_t> out;
  const auto add_number_of = [&](const point<T, 3>& p) {
    detail::append_all(out, " ", std::lower_bound(points.begin(), points.end(), p, before) - points.begin() + 1);
  };
  for (const auto& p : points) {
    detail::append_text(out, "point");
    detail::append_numbers(out, p, 3);
    detail::append_text(out, "\n");
  }
  for (std::size_t c = 0; c < plan.cells.size(); ++c) {
    detail::append_all(out, "cell ", named.names[c]);
    for (const space_face& face : plan.faces[c]) {
      detail::append_text(out, "\nface");
      for (const std::uint32_t v : face) add_number_of(plan.cells[c][v]);
    }
    detail::append_text(out, "\n");
  }
  for (const auto& p : plan.portals) {
    detail::append_all(out, "portal ", named.names[p.first], " ", named.names[p.second]);
    for (const auto& v : p.ring) add_number_of(v);
    detail::append_text(out, "\n");
  }
  return out;
}

}  // namespace irg::inline IRG_ABI
