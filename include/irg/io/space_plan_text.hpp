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
#include <irg/io/detail/space_plan_reader.hpp>
#include <irg/io/detail/text_writer.hpp>

namespace irg {

inline namespace IRG_ABI {

/// Whether a text describes a plan in space rather than one in the plane: its first word is `point`.
[[nodiscard]] constexpr bool is_space_plan(std::string_view text) noexcept {
  detail::text_cursor cursor(detail::without_byte_order_mark(text), '#');
  return cursor.skip_space() && cursor.word() == "point";
}

/// The plan in space that a text describes; the corners of each cell in the order in which its faces name them.
/// gives   the first error with line and column: words that are none of the format's, numbers that are none or not
///         finite, points that lack a coordinate, names and numbers of nothing that stands before; then what validate()
///         finds, at the line of the cell, face or portal
/// exact   numbers are correctly rounded to T. Faces and portals of more than three corners must be flat as they are
///         then: triangles always are
/// cost    linear, the corners of each cell for each of its faces' corners, and validate(); memory at most 64 times the
///         text
template <Floating T = double>
[[nodiscard]] constexpr result<named_plan<space_plan<T>>> read_space_plan(std::string_view text) {
  text = detail::without_byte_order_mark(text);
  detail::space_plan_reader<T> reader(text);
  if (reader.read()) return named_plan<space_plan<T>>{std::move(reader.plan), std::move(reader.names)};
  return detail::error_at(text, reader.cursor.place, reader.cursor.message);
}

/// The bytes of a plan in space as text, which read_space_plan reads back.
/// needs   a name for each cell, all different, of letters without blanks and #; a plan without defects and with faces,
///         which name each cell's corners in their order first
/// exact   every number with the fewest digits that lead back to it
/// cost    sorts the corners
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
    detail::append_text(out, " ");
    detail::append_number(out, std::lower_bound(points.begin(), points.end(), p, before) - points.begin() + 1);
  };
  for (const auto& p : points) {
    detail::append_text(out, "point");
    detail::append_numbers(out, p, 3);
    detail::append_text(out, "\n");
  }
  for (std::size_t c = 0; c < plan.cells.size(); ++c) {
    detail::append_text(out, "cell ");
    detail::append_text(out, named.names[c]);
    for (const space_face& face : plan.faces[c]) {
      detail::append_text(out, "\nface");
      for (const std::uint32_t v : face) add_number_of(plan.cells[c][v]);
    }
    detail::append_text(out, "\n");
  }
  for (const auto& p : plan.portals) {
    detail::append_text(out, "portal ");
    detail::append_text(out, named.names[p.first]);
    detail::append_text(out, " ");
    detail::append_text(out, named.names[p.second]);
    for (const auto& v : p.ring) add_number_of(v);
    detail::append_text(out, "\n");
  }
  return out;
}

}  // namespace IRG_ABI
}  // namespace irg
