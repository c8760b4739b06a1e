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
#include <irg/io/detail/text_place.hpp>
#include <irg/io/detail/text_writer.hpp>
#include <irg/math/decimal.hpp>
#include <irg/spatial/walled_grid.hpp>

namespace irg {

/// A map with the units on it.
struct grid_text {
  walled_grid grid;
  std::vector<cell3> units;
  bool operator==(const grid_text&) const = default;
};

inline namespace IRG_ABI {

/// A map and its units from text.
/// gives   an error with line and column for numbers that are none or too great, rows of another length than the header
///         says, other letters in them, units outside of the map or in a full cell, unknown walls
/// cost    memory bounded by the text's size
template <class Map = grid_text>
[[nodiscard]] constexpr result<Map> read_grid(std::string_view text, const wall_options& rules = {});

/// The text of a map and its units, which read_grid reads back.
/// needs   a map with cells
template <class Text = std::string>
[[nodiscard]] constexpr Text encode_grid(const walled_grid& grid, const std::vector<cell3>& units = {});

}  // namespace IRG_ABI
}  // namespace irg

namespace irg::detail::inline IRG_ABI {

inline constexpr std::string_view wall_names[] = {"none", "wall", "half", "open-door", "closed-door", "laser"};
inline constexpr std::string_view side_names[] = {"x+", "y+", "z+"};

template <class Map>
class grid_reader {
public:
  constexpr grid_reader(std::string_view text, const wall_options& rules) : text_(text), rules_(rules) {}

  constexpr result<Map> read() {
    Map out;
    if (!header() || !rows(out.grid)) return error_;
    for (skip_blank(true); at_ < text_.size(); skip_blank(true))
      if (!(starts_wall() ? wall(out.grid) : unit(out))) return error_;
    return out;
  }

private:
  static constexpr bool is_space(char c) noexcept { return c == ' ' || (c >= '\t' && c <= '\r'); }

  constexpr bool fail(const char* message) { return fail_at(at_, message); }
  constexpr bool fail_at(std::size_t place, const char* message) {
    error_ = {1, 1, message};
    for (std::size_t i = 0; i < place; ++i) {
      ++error_.column;
      if (text_[i] == '\n') {
        ++error_.line;
        error_.column = 1;
      }
    }
    return false;
  }
  // Skips blanks and comments, over line ends where it may.
  constexpr void skip_blank(bool lines) {
    for (; at_ < text_.size() && (lines || text_[at_] != '\n'); ++at_) {
      if (text_[at_] == '#')
        while (at_ + 1 < text_.size() && text_[at_ + 1] != '\n') ++at_;
      else if (!is_space(text_[at_]))
        return;
    }
  }
  constexpr bool line_ends() {
    skip_blank(false);
    return at_ == text_.size() || text_[at_] == '\n' || fail("nothing more is expected on this line");
  }
  constexpr std::string_view word() const {
    std::size_t last = at_;
    while (last < text_.size() && !is_space(text_[last]) && text_[last] != '#') ++last;
    return text_.substr(at_, last - at_);
  }
  constexpr bool number(int& out, int low, int high, bool lines, const char* message) {
    skip_blank(lines);
    const std::string_view w = word();
    const auto n = parse_integer<std::int64_t>(w.data(), w.data() + w.size());
    if (n.status != decimal_status::ok || n.end != w.data() + w.size() || n.value < low || n.value > high)
      return fail(message);
    out = static_cast<int>(n.value);
    at_ += w.size();
    return true;
  }

  constexpr bool header() {
    constexpr int most = (std::numeric_limits<int>::max)();
    constexpr const char* message = "width, height and depth must be whole numbers from 1 to 2147483647";
    if (!number(extent_.width, 1, most, true, message) || !number(extent_.height, 1, most, true, message) ||
        !number(extent_.depth, 1, most, true, message) || !line_ends())
      return false;
    const std::int64_t cells_left = static_cast<std::int64_t>(text_.size() - at_),
                       rows_left = cells_left / extent_.width;
    if (rows_left / extent_.height < extent_.depth) return fail_at(text_.size(), "rows of the map are missing");
    return true;
  }
  constexpr std::string_view line() const {
    std::size_t last = text_.find('\n', at_);
    if (last == text_.npos) last = text_.size();
    while (last > at_ && is_space(text_[last - 1])) --last;
    return text_.substr(at_, last - at_);
  }
  constexpr void next_line() {
    at_ = text_.find('\n', at_);
    at_ = at_ == text_.npos ? text_.size() : at_ + 1;
  }
  // A line that stands between the header and a layer, or between layers.
  constexpr bool is_between(std::string_view row) const {
    if (row.empty()) return true;
    std::size_t i = 0;
    while (i < row.size() && is_space(row[i])) ++i;
    if (i == row.size()) return true;
    if (row[i] != '#' || row.find_first_not_of(".#") == row.npos) return false;
    return i > 0 || row.size() != static_cast<std::size_t>(extent_.width) || row.find(' ') != row.npos;
  }
  template <class Grid>
  constexpr bool rows(Grid& grid) {
    cell_grid cells(extent_);
    next_line();
    for (int z = 0; z < extent_.depth; ++z) {
      while (at_ < text_.size() && is_between(line())) next_line();
      for (int y = 0; y < extent_.height; ++y) {
        if (at_ >= text_.size()) return fail("rows of the map are missing");
        const std::string_view row = line();
        for (std::size_t x = 0; x < row.size() && x < static_cast<std::size_t>(extent_.width); ++x) {
          if (row[x] != '.' && row[x] != '#') return fail_at(at_ + x, "a cell of the map is neither . nor #");
          if (row[x] == '#') cells.set({static_cast<int>(x), y, z});
        }
        if (row.size() != static_cast<std::size_t>(extent_.width))
          return fail_at(
              at_ + (row.size() < static_cast<std::size_t>(extent_.width) ? row.size()
                                                                          : static_cast<std::size_t>(extent_.width)),
              "a row of the map has not as many cells as its width says");
        next_line();
      }
    }
    grid = Grid(std::move(cells), rules_);
    return true;
  }

  constexpr bool starts_wall() const { return word() == "wall"; }
  constexpr bool cell_of(cell3& c, bool needs_z) {
    constexpr int most = (std::numeric_limits<int>::max)(), least = (std::numeric_limits<int>::min)();
    constexpr const char* message = "a coordinate is not a whole number of 32 bits";
    const std::size_t start = at_;
    if (!number(c.x, least, most, false, message) || !number(c.y, least, most, false, message)) return false;
    skip_blank(false);
    const bool more = at_ < text_.size() && text_[at_] != '\n';
    if ((more || needs_z) && !number(c.z, least, most, false, message)) return false;
    return extent_.holds(c) ||
           fail_at(start, needs_z ? "the wall is outside of the map" : "the unit is outside of the map");
  }
  constexpr bool unit(Map& out) {
    const std::size_t start = at_;
    cell3 c;
    if (!cell_of(c, false) || !line_ends()) return false;
    if (out.grid.is_full(c)) return fail_at(start, "the unit is in a full cell");
    out.units.push_back(c);
    return true;
  }
  template <std::size_t N>
  constexpr bool name(const std::string_view (&names)[N], std::size_t first, std::size_t& which, const char* message) {
    skip_blank(false);
    for (which = first; which < N; ++which)
      if (names[which] == word()) return at_ += word().size(), true;
    return fail(message);
  }
  template <class Grid>
  constexpr bool wall(Grid& grid) {
    at_ += 4;
    cell3 c;
    std::size_t axis = 0, kind = 0;
    skip_blank(false);
    if (!cell_of(c, true) || !name(side_names, 0, axis, "the side of a wall is none of x+, y+ and z+") ||
        !name(wall_names, 1, kind, "the kind of a wall is none of wall, half, open-door, closed-door and laser") ||
        !line_ends())
      return false;
    grid.set_wall(c, static_cast<int>(axis), static_cast<wall_kind>(kind));
    return true;
  }

  std::string_view text_;
  wall_options rules_;
  std::size_t at_ = 0;
  grid_extent extent_;
  parse_error error_;
};

template <class Text>
constexpr void append_cell(Text& out, const cell3& c) {
  append_number(out, c.x);
  out += ' ';
  append_number(out, c.y);
  out += ' ';
  append_number(out, c.z);
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <class Map>
[[nodiscard]] constexpr result<Map> read_grid(std::string_view text, const wall_options& rules) {
  return detail::grid_reader<Map>(detail::without_byte_order_mark(text), rules).read();
}

template <class Text>
[[nodiscard]] constexpr Text encode_grid(const walled_grid& grid, const std::vector<cell3>& units) {
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

IRG_RENAMED(write_grid, encode_grid)

}  // namespace irg::inline IRG_ABI
