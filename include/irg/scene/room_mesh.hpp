// SPDX-License-Identifier: MIT
// room_mesh: a cell of a plan as one sees it from within: floor, ceiling, and walls with openings where portals are.
//
// Walls are cut where portals end and where their sills and lintels are, on both sides of an opening alike, so that
// neighbouring faces share whole edges and a picture shows no cracks between them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <irg/mesh/mesh.hpp>
#include <irg/scene/detail/room_mesh_steps.hpp>
#include <irg/visibility/view_through_portals.hpp>

namespace irg {

inline namespace IRG_ABI {

/// The inside of a cell of a plan: its floor, its ceiling, and its walls, open where its portals are.
/// shape   z is up; faces counter-clockwise as seen from within, floor first, then the ceiling; straight corners where
///         portals end, so that neighbours share whole edges
/// needs   a plan without defects, its graph, and one of its cells
/// exact   coordinates are those of the plan
/// cost    the corners times the portals of the cell; allocates the result
template <Floating T>
[[nodiscard]] constexpr mesh<T> room_mesh(const cell_plan<T>& plan, const portal_graph<T>& graph, std::uint32_t cell) {
  return detail::room_builder<T>(plan, graph, cell).build();
}

}  // namespace IRG_ABI
}  // namespace irg
