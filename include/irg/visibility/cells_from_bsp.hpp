// SPDX-License-Identifier: MIT
// cells_from_bsp: walls become a plan of convex cells by themselves. The leaves of a BSP tree of the walls are the
// cells, and where two of them meet without a wall between is a portal.
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>

#include <irg/core/contract.hpp>
#include <irg/geometry/box.hpp>
#include <irg/spatial/bsp_tree_2d.hpp>
#include <irg/visibility/cell_plan.hpp>
#include <irg/visibility/detail/bsp_cell_builder.hpp>

namespace irg {

/// A plan that was made of walls.
template <Floating T>
struct bsp_cells {
  cell_plan<T> plan;
  std::size_t cut = 0;  ///< leaves that became triangles, because rounded corners bent them
  std::size_t left_out = 0;  ///< leaves without area when their corners are rounded
};

inline namespace IRG_ABI {

/// The cells and portals of what is in a window, by a BSP tree of its walls. All cells have the heights 0 and 1.
/// needs   a tree of these walls; a window with finite corners that has an area, coordinates below 2^500
/// gives   a plan without defects, the insides of closed walls among its cells. Walls may cross, touch, overlap, and
///         reach out of the window
/// exact   which leaves there are and which meet; corners are correctly rounded, so that walls and cells may be bent by
///         half an ulp where lines cross. On lines along the axes nothing is rounded
/// cost    the sides of each leaf for each node above it; allocates the result
/// source  Airey 1990; Teller and Sequin 1991
template <Floating T>
[[nodiscard]] constexpr bsp_cells<T> cells_from_bsp(const bsp_tree_2d<T>& tree,
                                                    std::span<const std::type_identity_t<segment<T, 2>>> walls,
                                                    const box<T, 2>& window) {
  IRG_EXPECTS(window.low.x < window.high.x && window.low.y < window.high.y);
  bsp_cells<T> out;
  out.plan = detail::bsp_cell_builder<T>(tree, walls, window).run(out.cut, out.left_out);
  return out;
}

/// The same for walls whose tree is not wanted otherwise.
template <Floating T>
[[nodiscard]] constexpr bsp_cells<T> cells_from_bsp(std::span<const segment<T, 2>> walls, const box<T, 2>& window) {
  return cells_from_bsp(bsp_tree_2d<T>(walls), walls, window);
}

}  // namespace IRG_ABI
}  // namespace irg
