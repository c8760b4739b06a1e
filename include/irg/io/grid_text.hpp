// SPDX-License-Identifier: MIT
// Maps as text: `width height depth`, the rows of all layers with `.` for empty and `#` for full cells, then one line
// per unit, `x y [z]`, and per wall, `wall x y z side kind`. Row k is y = k, the first layer is z = 0. `#` begins a
// comment anywhere but in rows; between the header and a layer a comment is told from a row by a blank or another
// letter in it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <irg/core/result.hpp>
#include <irg/io/detail/grid_text_steps.hpp>
#include <irg/io/detail/text_place.hpp>
#include <irg/io/detail/text_writer.hpp>
#include <irg/math/decimal.hpp>
#include <irg/spatial/walled_grid.hpp>

namespace irg {

/// A map with the units on it.
struct grid_text {
  walled_grid grid;
  std::vector<cell3> units;
};

inline namespace IRG_ABI {

/// A map and its units from text.
/// gives   an error with line and column for numbers that are none or too great, rows of another length than the header
///         says, other letters in them, units outside of the map or in a full cell, unknown walls
/// cost    memory bounded by the text's size
template <class Map = grid_text>
[[nodiscard]] constexpr result<Map> read_grid(std::string_view text, const wall_rules& rules = {}) {
  return detail::grid_reader<Map>(detail::without_byte_order_mark(text), rules).read();
}

/// The text of a map and its units, which read_grid reads back.
/// needs   a map with cells
template <class Text = std::string>
[[nodiscard]] constexpr Text write_grid(const walled_grid& grid, const std::vector<cell3>& units = {}) {
  const grid_extent e = grid.extent();
  Text out;
  detail::append_cell(out, {e.width, e.height, e.depth});
  out += '\n';
  for (int z = 0; z < e.depth; ++z)
    for (int y = 0; y < e.height; ++y) {
      for (int x = 0; x < e.width; ++x) out += grid.is_full({x, y, z}) ? '#' : '.';
      out += '\n';
    }
  for (const cell3& u : units) {
    detail::append_cell(out, u);
    out += '\n';
  }
  for (int z = 0; z < e.depth && grid.walled(); ++z)
    for (int y = 0; y < e.height; ++y)
      for (int x = 0; x < e.width; ++x)
        for (int axis = 0; axis < 3; ++axis) {
          const wall_kind kind = grid.wall({x, y, z}, axis);
          if (kind == wall_kind::none) continue;
          out += "wall ";
          detail::append_cell(out, {x, y, z});
          out += ' ';
          out += detail::side_names[axis];
          out += ' ';
          out += detail::wall_names[static_cast<std::size_t>(kind)];
          out += '\n';
        }
  return out;
}

}  // namespace IRG_ABI
}  // namespace irg
