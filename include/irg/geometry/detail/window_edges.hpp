// SPDX-License-Identifier: MIT
// What to do with an edge of a polygon at a window: two tables that stand for the decisions of window_pipe's two
// stages, so that a walk along the polygon needs no branch that could not be foretold.
//
// The first stage, x, leaves the edge's part between the window's left and right boundary, and joins where the polygon
// went out to where it comes in again; the second stage, y, cuts what the first one leaves. An edge is cut at one
// boundary of each axis at a time: one that passes both boundaries of an axis is taken twice. One that is cut three
// times or more is left to the pipe.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <irg/geometry/detail/window_codes_kernel.hpp>

namespace irg::detail {

// Where a vertex of the first stage lies in y: a bit for each boundary that it is beyond. The bit after_corner is added
// where the result ends at a corner of the window.
enum class y_place : std::uint8_t { within = 0, below = 1, above = 2, unknown = 3 };
inline constexpr unsigned after_corner = 4;

// What an edge does in x, and where its end that is within in x lies in y.
enum class edge_role : std::uint8_t {
  stays,  // within in x: only y is cut
  stays_first,  // passes both boundaries of y: where it passes the first one; then it stays
  leaves,  // goes out from a vertex within,
  leaves_below,
  leaves_above,
  enters,  // comes in to a vertex within,
  enters_below,
  enters_above,
  passes_in,  // passes both boundaries of x: where it comes in,
  passes_out,  // and where it goes out
  closes,  // no edge: joins the last vertex of the first stage to its first
  left_to_pipe  // passes both boundaries of either axis, or is no edge between numbers
};

// By the codes of the edge's ends. `bounds` is where the corner of the boundaries that it is cut at stands among the
// window's {low, low}, {high, low}, {low, high}, {high, high}, counted in numbers; `needed` has bit 0 set for a cut in
// x, bit 1 for one in y; `row` is the role's first entry in the table of outputs; `starts_within` is -1 where the first
// end is in the window, else 0.
struct alignas(8) edge_kind {
  std::uint8_t bounds, needed;
  std::uint16_t row;
  std::int8_t starts_within;
};

// By role, place of the stage's last vertex and place of the cut in x. Places behind the result are counted in numbers;
// what is not to be written goes behind what is.
struct IRG_APART alignas(8) edge_output {
  std::uint8_t corner, second_corner;  // where their y stands among the corners' numbers
  std::uint8_t cut_x, cut_y;  // where the cuts go
  std::uint8_t advance;  // the numbers that were written
  std::uint8_t place;  // four times that of the last vertex, from now on
  std::uint8_t rare;  // what seldom has to be done
};
inline constexpr unsigned takes_again = 1, has_two_corners = 2, gives_up = 4, outputs_per_role = 32;

IRG_APART constexpr std::uint16_t row_of(edge_role role) noexcept {
  return static_cast<std::uint16_t>(outputs_per_role * static_cast<unsigned>(role));
}

IRG_APART constexpr edge_kind kind_of_edge(unsigned from, unsigned to, bool second) noexcept {
  using enum edge_role;
  const unsigned xa = from & 5, xb = to & 5, ya = from >> 1 & 5, yb = to >> 1 & 5;
  edge_kind kind{0, 0, row_of(left_to_pipe), static_cast<std::int8_t>(from == 0 ? -1 : 0)};
  const bool are_numbers = xa != 5 && xb != 5 && ya != 5 && yb != 5;
  const bool passes_x = xa != xb && xa != 0 && xb != 0, passes_y = ya != yb && ya != 0 && yb != 0;
  if (!are_numbers || (passes_x && passes_y)) return kind;
  const bool leaves_x = xa == 0 && xb != 0;
  const unsigned x = !passes_x ? xa | xb : second ? xb : xa, from_y = leaves_x ? ya : yb;
  // Where both boundaries of y are passed, the one next to the end that is within in x is cut at first.
  const unsigned y = !passes_y ? ya | yb : xa != xb ? from_y : second ? yb : ya;
  kind.bounds = static_cast<std::uint8_t>((x == 4 ? 2 : 0) + (y == 4 ? 4 : 0));
  kind.needed = static_cast<std::uint8_t>((xa != xb ? 1 : 0) + (ya != yb ? 2 : 0));
  if (xa == xb)
    kind.row = row_of(passes_y && !second ? stays_first : stays);
  else if (passes_x)
    kind.row = row_of(second ? passes_out : passes_in);
  else if (leaves_x)
    kind.row = row_of(from_y == 0 ? leaves : from_y == 1 ? leaves_below : leaves_above);
  else
    kind.row = row_of(from_y == 0 ? enters : from_y == 1 ? enters_below : enters_above);
  return kind;
}

IRG_APART constexpr edge_output output_of_edge(edge_role role, y_place last, bool at_corner, y_place cut) noexcept {
  using enum edge_role;
  const auto y_of = [](y_place at) { return static_cast<std::uint8_t>(at == y_place::above ? 5 : 1); };
  constexpr std::uint8_t behind = 6;
  const auto place = [](y_place at) { return static_cast<std::uint8_t>(4 * static_cast<unsigned>(at)); };
  edge_output to{1, 1, behind, behind, 0, place(cut), 0};
  const auto next = [&] {
    return static_cast<std::uint8_t>((to.advance = static_cast<std::uint8_t>(to.advance + 2)) - 2);
  };
  if (role == left_to_pipe) to.rare = gives_up;
  if (role == stays_first) to.rare = takes_again;
  if (role == stays || role == stays_first) to.cut_y = next(), to.place = place(last);
  if (role == left_to_pipe || role == stays || role == stays_first || cut == y_place::unknown) return to;
  const bool leaves_x = role == leaves || role == leaves_below || role == leaves_above || role == passes_out;
  if (!leaves_x && last != y_place::unknown && last != cut) {  // along the boundary, around the window's corners
    if (last != y_place::within) to.corner = y_of(last), next();
    if (cut != y_place::within) {
      if (to.advance != 0) to.rare = has_two_corners;
      (to.advance != 0 ? to.second_corner : to.corner) = y_of(cut), next();
    }
    if (at_corner) to.rare |= gives_up;  // perhaps the same corner
    at_corner = true;
  }
  const std::uint8_t at_corners = to.advance;
  if (role == passes_in) to.rare |= takes_again;
  const y_place other = role == leaves || role == enters               ? y_place::within
                        : role == leaves_below || role == enters_below ? y_place::below
                        : role == leaves_above || role == enters_above ? y_place::above
                        : role == passes_out                           ? last
                                                                       : cut;
  const bool within = cut == y_place::within, cuts_y = other != cut;
  if (cuts_y && !within && other != y_place::within) to.rare |= gives_up;  // cut twice in y
  if (cuts_y && leaves_x) to.cut_y = next();
  if (within && role != closes) to.cut_x = next();
  if (cuts_y && !leaves_x) to.cut_y = next();
  if (at_corner && to.advance == at_corners) to.place |= 4 * after_corner;
  return to;
}

// By the code of the edge's first end, and 16 times that of its second one; 256 on for an edge that is taken again.
inline constexpr auto edge_kinds = [] {
  std::array<edge_kind, 512> all{};
  for (unsigned key = 0; key < 512; ++key) all[key] = kind_of_edge(key & 15, key >> 4 & 15, key >= 256);
  return all;
}();

// By role, four times the last place, after_corner among it, and the cut's.
inline constexpr auto edge_outputs = [] {
  std::array<edge_output, outputs_per_role*(static_cast<unsigned>(edge_role::left_to_pipe) + 1)> all{};
  for (unsigned i = 0; i < all.size(); ++i)
    all[i] = output_of_edge(static_cast<edge_role>(i / outputs_per_role), static_cast<y_place>(i / 4 % 4),
                            (i / 4 & after_corner) != 0, static_cast<y_place>(i % 4));
  return all;
}();

}  // namespace irg::detail
