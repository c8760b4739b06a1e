// SPDX-License-Identifier: MIT
// The steps of fill_polygon_aa.hpp.
#pragma once

#include <irg/raster/detail/polygon_area_kernel.hpp>
#include <irg/raster/detail/polygon_bands.hpp>
#include <irg/raster/detail/polygon_fill_kernel.hpp>
#include <irg/raster/fill_convex_aa.hpp>
#include <irg/raster/triangle_coverage.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// Whether a ring that can be snapped turns one way only and goes round once.
template <FillableRing R>
constexpr bool is_convex_ring(const R& ring) {
  const std::size_t n = ring_size(ring);
  if (n <= 3) return true;
  if (!goes_down_and_up_once(ring)) return false;
  int sense = 0;
  std::size_t before = n - 2;
  subpixel a = near_vertex(ring, before), b = near_vertex(ring, n - 1);
  while (before > 0 && a == b) a = near_vertex(ring, --before);  // the turn at the last vertex counts, too
  for (std::size_t i = 0; i < n; ++i) {
    const subpixel c = near_vertex(ring, i);
    if (c == b) continue;
    const std::int64_t turn = signed_double_area(a, b, c);
    const int way = turn > 0 ? 1 : turn < 0 ? -1 : 0;
    if (way == 0 && (std::int64_t{b.x} - a.x) * (std::int64_t{c.x} - b.x) < 0) return false;  // a spike
    if (way != 0 && sense != 0 && way != sense) return false;
    if (way != 0) sense = way;
    a = b;
    b = c;
  }
  return true;
}

// Collects the edges of a ring, and what they span.
template <FillableRing R>
constexpr void add_area_lines(std::vector<area_line>& lines, const R& ring, ring_extent<std::int32_t>& extent) {
  const std::size_t n = ring_size(ring);
  if (n < 3) return;
  subpixel a = near_vertex(ring, n - 1);
  for (std::size_t i = 0; i < n; ++i) {
    const subpixel b = near_vertex(ring, i);
    extent.add(b, i);
    if (!(a == b)) {
      area_line l;
      l.direction = a.y < b.y ? 1 : a.y > b.y ? -1 : 0;
      l.upper = l.direction < 0 ? b : a;
      l.lower = l.direction < 0 ? a : b;
      if (l.direction != 0)
        l.slope = static_cast<double>(l.lower.x - l.upper.x) / static_cast<double>(l.lower.y - l.upper.y);
      lines.push_back(l);
    }
    a = b;
  }
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
