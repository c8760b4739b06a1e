// SPDX-License-Identifier: MIT
// Hashes of the polygon algorithms: locations, areas, centres, hulls, triangles, cuts, overlaps.
#include <array>
#include <vector>

#include <irg/geometry/textbook/polygon.hpp>
#include <irg/geometry/convex_hull.hpp>
#include <irg/geometry/point_in_convex_polygon.hpp>
#include <irg/geometry/polygon_area.hpp>
#include <irg/geometry/polygon_centroid.hpp>
#include <irg/geometry/polygons_overlap.hpp>
#include <irg/geometry/split_polygon.hpp>
#include <irg/geometry/triangulate_ear_clipping.hpp>
#include <irg/geometry/triangulate_monotone.hpp>
#include <irg/math/vec.hpp>

#include "hashes.hpp"

namespace {

using P = irg::point<double, 2>;

// Nearly collinear points, so that roundings show.
constexpr std::vector<P> random_ring(test::random& r, int n) {
  std::vector<P> ring;
  for (int i = 0; i < n; ++i) {
    const double x = r.unit();
    ring.push_back({x, irg::product(x, 0.375) + irg::product(r.unit(), 0x1p-30)});
  }
  return ring;
}

constexpr std::uint64_t geometry_polygon_measures(int rounds) {
  test::random r(301);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    const auto ring = random_ring(r, 5);
    h.add(irg::polygon_area(ring));
    h.add(irg::polygon_area_exact(ring));
    h.add(irg::polygon_area_fast(ring));
    h.add(irg::textbook::polygon_area(ring));
    h.add(irg::polygon_perimeter(ring));
    const auto centre = irg::polygon_centroid(ring), fast = irg::polygon_centroid_fast(ring);
    h.add(centre ? centre->x : -1);
    h.add(fast ? fast->y : -1);
  }
  return h.value();
}
HASHED(geometry_polygon_measures, 3, 3000);

constexpr std::uint64_t geometry_polygon_shapes(int rounds) {
  test::random r(302);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    const auto ring = random_ring(r, 7), other = random_ring(r, 5);
    std::vector<P> convex;
    for (const auto k : irg::convex_hull(ring)) {
      h.add(k);
      convex.push_back(ring[k]);
    }
    h.add(static_cast<int>(irg::point_in_convex_polygon(convex, other[0])));
    h.add(static_cast<int>(irg::convex_polygons_overlap(convex, std::array{other[0], other[1], other[2]})));
    h.add(static_cast<int>(irg::polygons_overlap(convex, std::array{other[0], other[1], other[2]})));
    for (const auto& t : irg::triangulate_ear_clipping(ring)) h.add(t[0] + 10 * t[1] + 100 * t[2]);
    const auto sweep = irg::triangulate_monotone(ring);
    h.add(static_cast<int>(sweep.status));
    for (const auto& t : sweep.triangles) h.add(t[0] + 10 * t[1] + 100 * t[2]);
    const auto parts = irg::split_polygon(convex, other[0], other[1]);
    h.add(static_cast<int>(parts.side));
    for (const auto& part : parts.front)
      for (const P& p : part) h.add(p.x), h.add(p.y);
  }
  return h.value();
}
HASHED(geometry_polygon_shapes, 1, 2000);

}  // namespace
