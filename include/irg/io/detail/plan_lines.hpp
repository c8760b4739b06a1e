// SPDX-License-Identifier: MIT
// What readers of plans share: lines of words and numbers, and cells' names by a tree of their bits, which no names
// make slow.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <vector>

#include <irg/io/detail/text_cursor.hpp>
#include <irg/mesh/part_name.hpp>

namespace irg {

/// A cell_plan or a space_plan whose cells have names.
template <class Plan>
struct named_plan {
  Plan plan;
  std::vector<part_name> names;  // one for each cell
  bool operator==(const named_plan&) const = default;
};

}  // namespace irg

namespace irg::detail::inline IRG_ABI {

// Where a part of a plan of T's stands in the text.
template <class T>
using text_place = std::conditional_t<true, const char*, T>;

template <class Name = part_name>
struct plan_lines {
  std::vector<Name> names{};  // of cells
  text_cursor cursor;

  constexpr explicit plan_lines(std::string_view text) : cursor(text, '#') {}

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
    if (names.empty()) return names.push_back(Name(name)), true;
    const std::string_view like = names[cell_like(name)];
    if (like == name) return cursor.fail(at, "the cell's name is taken");
    std::size_t bit = 0;
    while (bit / 9 < name.size() && bit / 9 < like.size() && name[bit / 9] == like[bit / 9]) bit += 9;
    while (bit_of(name, bit) == bit_of(like, bit)) ++bit;
    std::uint32_t* place = &root_;
    while (*place % 2 == 1 && forks_[*place / 2].bit < bit) {
      fork& f = forks_[*place / 2];
      place = &f.next[bit_of(name, f.bit)];
    }
    fork f{bit, {*place, *place}};
    f.next[bit_of(name, bit)] = static_cast<std::uint32_t>(2 * names.size());
    *place = static_cast<std::uint32_t>(2 * forks_.size() + 1);
    forks_.push_back(f);
    names.push_back(Name(name));
    return true;
  }
  constexpr bool known_cell(std::uint32_t& cell) {
    if (!cursor.skip_blanks()) return cursor.fail(cursor.at, "the line ends where a cell's name is expected");
    const char* const at = cursor.at;
    const std::string_view name = cursor.word();
    cell = cell_like(name);
    if (names.empty() || std::string_view(names[cell]) != name)
      return cursor.fail(at, "no cell of this name stands before");
    return true;
  }
  constexpr bool line_ends() {
    return !cursor.skip_blanks() || cursor.fail(cursor.at, "nothing more is expected on this line");
  }

private:
  // Where names part: at a bit of theirs. Next is twice a cell's number, or twice a fork's and 1.
  struct fork {
    std::size_t bit;
    std::uint32_t next[2];
  };
  std::vector<fork> forks_{};
  std::uint32_t root_ = 0;

  // Each byte has nine bits, the first of which says that it is there.
  static constexpr unsigned bit_of(std::string_view name, std::size_t bit) noexcept {
    if (bit / 9 >= name.size()) return 0;
    return bit % 9 == 0 ? 1 : static_cast<unsigned char>(name[bit / 9]) >> (8 - bit % 9) & 1u;
  }
  // The one cell that may have the name; 0 when there is none. No more steps than the name has bits.
  constexpr std::uint32_t cell_like(std::string_view name) const noexcept {
    std::uint32_t next = root_;
    while (next % 2 == 1) {
      const fork& f = forks_[next / 2];
      next = f.next[bit_of(name, f.bit)];
    }
    return next / 2;
  }
};

}  // namespace irg::detail::inline IRG_ABI
