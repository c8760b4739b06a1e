// SPDX-License-Identifier: MIT
// What binary space partitions of the plane and of space share.
#pragma once

#include <cstddef>
#include <cstdint>

namespace irg {

/// No segment, no triangle, no node.
inline constexpr std::uint32_t bsp_none = 0xffffffff;

/// Where a point lies: on the line or plane of a node (side 0), or in the cell without a node at that side of it.
struct bsp_place {
  std::uint32_t node = bsp_none;
  int side = 0;
  friend constexpr bool operator==(const bsp_place&, const bsp_place&) = default;
};

/// Which end of a walk comes first.
enum class bsp_order { back_to_front, front_to_back };

/// How the line or plane is chosen that divides a cell: of some candidates, spread over what is left, the one that cuts
/// the fewest and leaves the sides most alike, judged by some of them.
/// shape   one candidate is the first one left, as in the textbook
struct bsp_choice {
  std::size_t candidates = 8, judges = 32;
  std::size_t cut_costs = 4;  // as much as so many more on one side than on the other
};

}  // namespace irg
