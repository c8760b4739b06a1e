// SPDX-License-Identifier: MIT
// Triangles of polygons with holes in O(n log n): a sweep that cuts the polygon into monotone parts and these into
// triangles in the same pass. Every decision is exact.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include <irg/geometry/detail/monotone_sweep.hpp>
#include <irg/geometry/detail/shoelace.hpp>
#include <irg/geometry/polygon.hpp>

namespace irg {

/// Whether a polygon could be cut into triangles.
enum class triangulation_state {
  complete,
  crossing,    // edges cross each other, or a ring crosses itself at a vertex
  not_finite,  // a coordinate is NaN or infinite
};

/// Triangles as indices of vertices; no triangle unless the state is `complete`.
struct triangulation {
  triangulation_state state = triangulation_state::complete;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

inline namespace IRG_ABI {

/// The triangles that make up a polygon: one ring, or any number of rings, of which those inside others are holes,
/// those inside holes islands, and so on, whichever way they run.
/// shape   vertices are numbered through all rings; triangles run as the first ring does. n - 2 for a ring of n
///         vertices, and 2 more for each hole than its number of vertices; each vertex of a ring with area is a corner.
///         In a polygon without repeated vertices whose edges meet at their ends only, every triangle has area
/// needs   fewer than 2^31 vertices
/// gives   `crossing` when edges cross, those of spikes too; what only touches does not: collinear and repeated
///         vertices, vertices on edges, edges that coincide in part (bridges to holes, holes at the rim), spikes that
///         end on an edge or before it, which go as triangles without area. Nothing for rings of fewer than three
///         vertices; triangles without area for rings without area
/// exact   for all finite floats and all integers: the triangles have the polygon's area to the last bit and cover it
///         once (even-odd)
/// cost    O(n log n); some 50 bytes for a vertex and 80 for each edge that one level line meets, beside the triangles;
///         about twice the time where rings turn back on themselves
/// source  Lee and Preparata 1977; Garey, Johnson, Preparata and Tarjan 1978; de Berg et al. 2008, chapter 3. Here both
///         passes are one, and ties are broken by the rings themselves
template <PlanePolygon P>
[[nodiscard]] constexpr triangulation triangulate_monotone(const P& polygon) {
  triangulation result;
  if (!irg::is_finite(polygon)) {
    result.state = triangulation_state::not_finite;
    return result;
  }
  detail::monotone_sweep<scalar_of<polygon_point<P>>> sweep(result.triangles);
  bool clockwise = false, first = true;
  detail::each_ring(polygon, [&](const auto& ring) {
    if (first) clockwise = detail::shoelace_sign(ring) < 0;
    first = false;
    sweep.add_ring(ring);
    return true;
  });
  if (!sweep.run()) {
    result.state = triangulation_state::crossing;
    result.triangles.clear();
  }
  if (clockwise)
    for (auto& t : result.triangles) std::swap(t[1], t[2]);
  return result;
}

}  // namespace IRG_ABI
}  // namespace irg
