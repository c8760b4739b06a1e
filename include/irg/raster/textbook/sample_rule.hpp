// SPDX-License-Identifier: MIT
// What a lecture's fill leaves open: which cells, points of the integer grid, a row from L to D has. fill_convex.hpp
// asks it for every row of a polygon.
#pragma once

#include <cstdint>

#include <irg/math/floor_division.hpp>
#include <irg/math/int128.hpp>
#include <irg/raster/subpixel.hpp>

namespace irg::textbook {

/// Which cells a row from L to D has; L and D are rarely integers.
enum class sample_rule {
  course,  // the rule of lectures: ceil(L) to floor(D), drawn if L < D: a row that is one point is left out
  closed,  // ceil(L) to floor(D), drawn if L <= D: all cells inside and on the boundary
  rounded,  // both ends rounded to the nearest integer, halves up, drawn if L < D
  half_open,  // L <= x < D in the rows y_min <= y < y_max: polygons side by side share no cell and leave none out
};

/// Where a row crosses an edge: n / d in 1/256, d > 0.
/// needs   n of at most 82 bits, d of at most 41
struct row_crossing {
  int128 n;
  std::int64_t d;
  friend constexpr bool operator<(const row_crossing& p, const row_crossing& q) noexcept {
    return p.n * q.d < q.n * p.d;
  }
};

/// The cells [first, last) of a row.
struct row_cells {
  std::int64_t first = 0, last = 0;
  friend constexpr bool operator==(const row_cells&, const row_cells&) = default;
};

inline namespace IRG_ABI {

/// The cells of a row from l to d.
/// exact   ends are compared and rounded as fractions
[[nodiscard]] constexpr row_cells cells_of_row(const row_crossing& l, const row_crossing& d,
                                               sample_rule rule) noexcept {
  const int128 l_unit = int128{l.d} * one_pixel, d_unit = int128{d.d} * one_pixel;
  const bool rounded = rule == sample_rule::rounded;
  if (rule == sample_rule::closed ? d < l : !(l < d)) return {};
  const int128 first = rounded ? floor_div(2 * l.n + l_unit, 2 * l_unit) : ceil_div(l.n, l_unit);
  const int128 last = rounded                          ? floor_div(2 * d.n + d_unit, 2 * d_unit) + 1
                      : rule == sample_rule::half_open ? ceil_div(d.n, d_unit)
                                                       : floor_div(d.n, d_unit) + 1;
  return {static_cast<std::int64_t>(first), static_cast<std::int64_t>(last)};
}

}  // namespace IRG_ABI
}  // namespace irg::textbook
