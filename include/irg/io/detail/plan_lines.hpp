// SPDX-License-Identifier: MIT
// What readers of plans share: lines of words and numbers, and cells' names by a table of their hashes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include <irg/io/detail/text_cursor.hpp>
#include <irg/mesh/part_name.hpp>

namespace irg {

/// A cell_plan or a space_plan whose cells have names.
template <class Plan>
struct named_plan {
  Plan plan;
  std::vector<part_name> names;  // one for each cell
  constexpr bool operator==(const named_plan&) const = default;
};

}  // namespace irg

namespace irg::detail {
inline namespace IRG_ABI {

template <class Name = part_name>
struct plan_lines {
  std::vector<Name> names{};  // of cells
  text_cursor cursor;

  constexpr explicit plan_lines(std::string_view text) : cursor(without_byte_order_mark(text), '#') {}

  template <class T>
  constexpr bool number(T& into) {
    if (!cursor.skip_blanks()) return cursor.fail(cursor.at, "the line ends where a number is expected");
    return cursor.number_here(into);
  }
  template <class P>
  constexpr bool place(P& p, int size) {
    for (int i = 0; i < size; ++i)
      if (!number(p[i])) return false;
    return true;
  }

  // The name of a cell that is new.
  constexpr bool new_cell() {
    if (!cursor.skip_blanks()) return cursor.fail(cursor.at, "the line ends where a cell's name is expected");
    const char* const at = cursor.at;
    const std::string_view name = cursor.word();
    if (names.size() * 2 >= table_.size()) grow();
    std::uint32_t& slot = slot_of(name);
    if (slot != 0) return cursor.fail(at, "the cell's name is taken");
    names.push_back(Name(name));
    slot = static_cast<std::uint32_t>(names.size());
    return true;
  }
  constexpr bool known_cell(std::uint32_t& cell) {
    if (!cursor.skip_blanks()) return cursor.fail(cursor.at, "the line ends where a cell's name is expected");
    const char* const at = cursor.at;
    const std::string_view name = cursor.word();
    cell = table_.empty() ? 0 : slot_of(name);
    if (cell == 0) return cursor.fail(at, "no cell of this name stands before");
    --cell;
    return true;
  }
  constexpr bool line_ends() {
    return !cursor.skip_blanks() || cursor.fail(cursor.at, "nothing more is expected on this line");
  }

private:
  std::vector<std::uint32_t> table_{};

  // Where the number of a name stands, counted from 1, or would.
  constexpr std::uint32_t& slot_of(std::string_view name) {
    std::uint64_t hash = 14695981039346656037u;  // FNV-1a
    for (const char c : name) hash = (hash ^ static_cast<std::uint8_t>(c)) * 1099511628211u;
    std::size_t i = static_cast<std::size_t>(hash ^ hash >> 32) & (table_.size() - 1);
    while (table_[i] != 0 && std::string_view(names[table_[i] - 1]) != name) i = (i + 1) & (table_.size() - 1);
    return table_[i];
  }
  constexpr void grow() {
    table_.assign(table_.empty() ? 16 : 2 * table_.size(), 0);
    for (std::size_t i = 0; i < names.size(); ++i)
      slot_of(std::string_view(names[i])) = static_cast<std::uint32_t>(i + 1);
  }
};

}  // namespace IRG_ABI
}  // namespace irg::detail
