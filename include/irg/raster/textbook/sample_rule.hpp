// SPDX-License-Identifier: MIT
// What a lecture's fill leaves open: which cells, points of the integer grid, a row from L to D has. fill_convex.hpp
// asks it for every row of a polygon.
#pragma once

#include <cstdint>

#include <irg/core/sinks.hpp>
#include <irg/math/floor_division.hpp>
#include <irg/math/int128.hpp>
#include <irg/raster/subpixel.hpp>
#include <irg/raster/window.hpp>

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

inline namespace IRG_ABI {

/// The cells of row y from l to d that lie in the window; a row of none begins where it ends, or behind.
/// needs   l and d within int, in cells
/// exact   ends are compared and rounded as fractions
[[nodiscard]] IRG_INLINE constexpr span_of_cells cells_of_row(int y, const row_crossing& l, const row_crossing& d,
                                                              sample_rule rule, const cell_window& window) noexcept {
  if (rule == sample_rule::closed ? d < l : !(l < d)) return {};
  const int128 l_unit = int128{l.d} * one_pixel, d_unit = int128{d.d} * one_pixel;
  const bool rounded = rule == sample_rule::rounded;
  const int128 first = rounded ? floor_div(2 * l.n + l_unit, 2 * l_unit) : ceil_div(l.n, l_unit);
  const int128 last = rounded                          ? floor_div(2 * d.n + d_unit, 2 * d_unit) + 1
                      : rule == sample_rule::half_open ? ceil_div(d.n, d_unit)
                                                       : floor_div(d.n, d_unit) + 1;
  return {y, static_cast<int>(greater<std::int64_t>(static_cast<std::int64_t>(first), window.x_first)),
          static_cast<int>(lesser<std::int64_t>(static_cast<std::int64_t>(last), window.x_last))};
}

}  // namespace IRG_ABI
}  // namespace irg::textbook
