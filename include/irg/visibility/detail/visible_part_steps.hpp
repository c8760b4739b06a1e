// SPDX-License-Identifier: MIT
// Light on the cells of a quadrant, for visible_percentages.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/math/trigonometry.hpp>
#include <irg/visibility/field_of_view.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// The angle from one direction x/y to another.
constexpr double angle_between(const sweep_slope& a, const sweep_slope& b) noexcept {
  return irg::atan2(static_cast<double>(b.num * a.den - a.num * b.den),
                    static_cast<double>(a.num * b.num + a.den * b.den));
}

// Between which slopes a cell of a quadrant lies.
struct cell_slopes {
  sweep_slope low, high;
};
IRG_INLINE constexpr cell_slopes slopes_of(std::int64_t x, std::int64_t y) noexcept {
  return {x > 0 ? sweep_slope{2 * x - 1, 2 * y + 1} : sweep_slope{},
          y > 0 ? sweep_slope{2 * x + 1, 2 * y - 1} : sweep_slope{1, 0}};
}

// Sums up how much of each cell of a quadrant is lit.
struct light_sums {
  struct sum {
    double lit = 0;
    int wholes = 0;  // of the quadrants that have a part of the cell, those that see all of it
  };
  std::vector<sum>* sums;
  int width;
  cell viewer;
  int sign_x, sign_y;

  constexpr void light(std::int64_t y, std::int64_t first, std::int64_t last, const sweep_slope& low,
                       const sweep_slope& high) const {
    for (std::int64_t x = first; x <= last; ++x) {
      const cell_slopes s = slopes_of(x, y);
      if (compare(s.low, high) >= 0) return;
      if (compare(s.high, low) <= 0) continue;
      const bool cut_low = compare(s.low, low) < 0, cut_high = compare(high, s.high) < 0;
      const sweep_slope a = cut_low ? low : s.low, b = cut_high ? high : s.high;
      if (compare(a, b) >= 0) continue;
      sum& to = (*sums)[static_cast<std::size_t>((viewer.y + sign_y * y) * width + viewer.x + sign_x * x)];
      to.lit += angle_between(a, b);
      to.wholes += cut_low || cut_high ? 0 : 1;
    }
  }
};

}  // namespace IRG_ABI
}  // namespace detail

}  // namespace irg
