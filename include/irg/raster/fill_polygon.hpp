// SPDX-License-Identifier: MIT
// The pixels of any polygon: rings with holes, rings that cross themselves and each other, under either fill rule.
// Pixels whose centre is on an edge are decided as in triangle_coverage.hpp, exactly, so polygons that tile a region
// have each of its pixels exactly once.
#pragma once

#include <cstddef>

#include <irg/raster/detail/polygon_bands.hpp>
#include <irg/raster/fill_span.hpp>

namespace irg {

/// Memory that filling polygons needs, to be used again by the next one.
struct fill_workspace {
  std::vector<detail::polygon_edge<std::int32_t>> edges;
  std::vector<detail::polygon_edge<std::int64_t>> far_edges;
  std::vector<int> turns;
  detail::polygon_bands bands;
};

namespace detail::inline IRG_ABI {

template <class J, FillablePolygon P, class Emit>
constexpr void scan_polygon(const P& polygon, fill_rule rule, const cell_window& w, std::vector<polygon_edge<J>>& edges,
                            std::vector<int>& turns, Emit& sink) {
  const auto vertex = [](const auto& ring, std::size_t i) {
    if constexpr (sizeof(J) == 4)
      return near_vertex(ring, i);
    else
      return far_vertex(ring, i);
  };
  edges.clear();
  for_each_ring(polygon, [&](const auto& ring) {
    const std::size_t n = ring_size(ring);
    if (n < 3) return;
    auto a = vertex(ring, n - 1);
    for (std::size_t i = 0; i < n; ++i) {
      const auto b = vertex(ring, i);
      add_edge<J>(edges, a, b, w);
      a = b;
    }
  });
  scan_edges(edges, turns, rule, w, sink);
}

// Calls sink(y, x_first, x_last) for the runs of covered pixels; false, and no call, when a vertex is refused.
template <FillablePolygon P, class Emit>
constexpr bool walk_polygon(const P& polygon, fill_rule rule, const cell_window& w, fill_workspace& workspace,
                            Emit&& sink) {
  if constexpr (FillableRing<P>)
    if (ring_size(polygon) <= 3) return walk_ring(polygon, w, sink);
  const ring_reach reach = reach_of_polygon(polygon);
  if (reach == ring_reach::refused) return false;
  if (w.empty()) return true;
  if constexpr (FillableRing<P>)
    if (reach == ring_reach::within_snap_limit && goes_down_and_up_once(polygon)) return walk_ring(polygon, w, sink);
  if (reach == ring_reach::within_snap_limit)
    scan_polygon<std::int32_t>(polygon, rule, w, workspace.edges, workspace.turns, sink);
  else
    scan_polygon<std::int64_t>(polygon, rule, w, workspace.far_edges, workspace.turns, sink);
  return true;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// Calls sink(span) for the covered pixels in the window, ordered by y, then by x.
/// shape   one ring, or a container of rings; holes are rings
/// units   floating vertices in pixels, snapped to 1/256 as by snap(); subpixel vertices as they are
/// gives   spans that neither overlap nor touch. False and no span when a vertex is NaN, infinite or more than
///         far_limit pixels from the origin; else true. Rings of less than 3 vertices count for nothing
/// exact   coverage is decided without rounding after the vertices are snapped
/// cost    per row of the window, one step and at best one comparison per edge that crosses it, after sorting the
///         edges; rows whose edges are much out of order are counted by column, or sorted. The workspace keeps memory
///         for the edges; a single ring that no level line crosses more than twice needs none
template <FillablePolygon P, SpanSink Sink, class Workspace = fill_workspace>
  requires std::same_as<Workspace&, fill_workspace&>
constexpr bool polygon_spans(const P& polygon, fill_rule rule, const cell_window& window, Sink&& sink,
                             Workspace&& workspace = Workspace{}) {
  return detail::walk_polygon(polygon, rule, window, workspace,
                              [&](int y, int first, int last) { sink(span_of_cells{y, first, last}); });
}

/// Paints the pixels of a polygon, each once.
/// gives   false, and nothing painted, when a vertex is NaN, infinite or more than far_limit pixels from the origin
template <WritableRaster R, FillablePolygon P, PaintFor<R> Paint = pixel_of<R>, class Workspace = fill_workspace>
  requires std::same_as<Workspace&, fill_workspace&>
constexpr bool fill_polygon(R& raster, const P& polygon, fill_rule rule, const Paint& paint,
                            Workspace&& workspace = Workspace{}) {
  decltype(auto) prepared = detail::prepared_paint<R>(paint);
  const std::ptrdiff_t ahead = detail::bytes_to_row_below(raster);
  return detail::walk_polygon(polygon, rule, window_of(raster), workspace, [&](int y, int first, int last) {
    detail::paint_run(raster, y, first, last, prepared, ahead);
  });
}
/// The same of one ring in braces: fill_polygon(picture, {{2, 3}, {9, 3.5}, {4, 8}}, rule, paint).
template <WritableRaster R, std::size_t N, PaintFor<R> Paint = pixel_of<R>, class Workspace = fill_workspace>
  requires std::same_as<Workspace&, fill_workspace&>
constexpr bool fill_polygon(R& raster, const point<double, 2> (&ring)[N], fill_rule rule, const Paint& paint,
                            Workspace&& workspace = Workspace{}) {
  return fill_polygon<R, point<double, 2>[N]>(raster, ring, rule, paint, workspace);
}

}  // namespace IRG_ABI
}  // namespace irg
