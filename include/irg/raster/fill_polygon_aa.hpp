// SPDX-License-Identifier: MIT
// Polygons of any shape with smooth edges: rings with holes, rings that cross themselves and each other, under either
// fill rule. The coverage of a pixel is the area of the inside within it, also where edges cross in the pixel.
//
// Edges that two polygons share stay visible as seams; see fill_convex_aa.hpp.
#pragma once

#include <irg/raster/detail/polygon_area_kernel.hpp>
#include <irg/raster/detail/polygon_bands.hpp>
#include <irg/raster/detail/polygon_fill_kernel.hpp>
#include <irg/raster/fill_convex_aa.hpp>
#include <irg/raster/triangle_coverage.hpp>

namespace irg {

/// Memory that the areas of polygons need, to be used again by the next one.
struct coverage_workspace {
  detail::area_memory memory;
};

inline namespace IRG_ABI {

/// Calls sink(span) for runs of pixels of the window that the polygon's inside covers, whole or in part, row by row
/// from top to bottom, left to right, no pixel twice. How a row is cut into runs is not promised; a coverage may be 0.
/// shape   one ring, or a container of rings; holes are rings
/// units   floating vertices in pixels, snapped to 1/256 as by snap(); subpixel vertices as they are
/// gives   false and no span when a vertex is NaN, infinite or more than snap_limit pixels from the origin; else true.
///         Rings of less than 3 vertices count for nothing
/// exact   coverage is the area of the inside within the pixel in 255ths, rounded to the nearest: within 0.00198 (1/256
///         is 0.0039) of the exact area of the snapped polygon, whatever crosses in the pixel. No window changes a
///         pixel within it
/// cost    per row, sorting its edges (they are nearly in order); per pixel that an edge crosses, one closed form; per
///         crossing of edges, a few more. The workspace keeps memory for the edges, what crosses in a row, and one row.
///         A single convex ring goes the way of convex_coverage
/// source  Bentley and Ottmann 1979 (sweep and crossings), a pixel row at a time
template <FillablePolygon P, CoverageSink Sink, class Workspace = coverage_workspace>
  requires std::same_as<Workspace&, coverage_workspace&>
constexpr bool polygon_coverage(const P& polygon, fill_rule rule, const cell_window& window, Sink&& sink,
                                Workspace&& workspace = Workspace{});

/// Paints a polygon, each pixel as far as it is covered.
/// gives   false, and nothing painted, when a vertex is NaN, infinite or more than snap_limit pixels from the origin
/// exact   the pixels that polygon_coverage and blend_span make
template <WritableRaster R, FillablePolygon P, CoveragePaintFor<R> Paint = pixel_of<R>,
          class Workspace = coverage_workspace>
  requires std::same_as<Workspace&, coverage_workspace&>
constexpr bool fill_polygon_aa(R& raster, const P& polygon, fill_rule rule, const Paint& paint,
                               Workspace&& workspace = Workspace{});

}  // namespace IRG_ABI

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

inline namespace IRG_ABI {

template <FillablePolygon P, CoverageSink Sink, class Workspace>
  requires std::same_as<Workspace&, coverage_workspace&>
constexpr bool polygon_coverage(const P& polygon, fill_rule rule, const cell_window& window, Sink&& sink,
                                Workspace&& workspace) {
  detail::area_memory& m = workspace.memory;
  if (detail::reach_of_polygon(polygon) != detail::ring_reach::within_snap_limit) return false;
  if constexpr (FillableRing<P>)
    if (detail::is_convex_ring(polygon)) return convex_coverage(polygon, window, sink);
  m.lines.clear();
  detail::ring_extent<std::int32_t> extent;
  detail::for_each_ring(polygon, [&](const auto& ring) { detail::add_area_lines(m.lines, ring, extent); });
  if (m.lines.empty()) return true;
  const cell_window w = intersect(window, detail::cells_of_extent(extent));
  if (!w.empty()) detail::polygon_sweep(m, rule, w, sink).all_rows();
  return true;
}

template <WritableRaster R, FillablePolygon P, CoveragePaintFor<R> Paint, class Workspace>
  requires std::same_as<Workspace&, coverage_workspace&>
constexpr bool fill_polygon_aa(R& raster, const P& polygon, fill_rule rule, const Paint& paint, Workspace&& workspace) {
  if constexpr (FillableRing<P>)
    if (detail::reach_of(polygon) == detail::ring_reach::within_snap_limit && detail::is_convex_ring(polygon))
      return fill_convex_aa(raster, polygon, paint);
  const auto blend = [&](const coverage_span& span) { blend_span(raster, span, paint); };
  return polygon_coverage(polygon, rule, window_of(raster), blend, workspace);
}

}  // namespace IRG_ABI
}  // namespace irg
