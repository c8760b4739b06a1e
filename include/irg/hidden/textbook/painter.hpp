// SPDX-License-Identifier: MIT
// The naive painter: objects sorted by the distance of their centres from the camera and drawn from far to near. Wrong
// where objects are long, lie within each other or hide each other in turn; depth_sort.hpp has the order of polygons.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/core/is_finite.hpp>
#include <irg/geometry/compare.hpp>

namespace irg::textbook::inline IRG_ABI {

/// The numbers of objects in the order in which the naive painter draws them: the one whose centre is farthest from the
/// camera first, of equally far ones the lower number first.
/// shape   a container of the objects' centres, counted from 0
/// gives   objects with a centre that is not finite are left out
/// exact   as compare_distance: for every finite float, double and integer
/// cost    a sort; allocates the result
/// source  Fabris 2012, 2.3
template <PolygonRing Centres, Point P>
  requires(std::same_as<ring_point<Centres>, P> && (size_of<P> == 2 || size_of<P> == 3))
[[nodiscard]] constexpr std::vector<std::uint32_t> painter_order(const Centres& centres, const P& camera) {
  std::vector<std::uint32_t> order;
  for (std::size_t i = 0; i < ring_size(centres); ++i)
    if (is_finite(ring_vertex(centres, i))) order.push_back(static_cast<std::uint32_t>(i));
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const int nearer = compare_distance(camera, ring_vertex(centres, a), ring_vertex(centres, b));
    return nearer != 0 ? nearer > 0 : a < b;
  });
  return order;
}

}  // namespace irg::textbook::inline IRG_ABI
