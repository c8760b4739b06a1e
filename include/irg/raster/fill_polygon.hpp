// SPDX-License-Identifier: MIT
// The pixels of any polygon: rings with holes, rings that cross themselves and each other, under either fill rule.
// Pixels whose centre is on an edge are decided as in triangle_coverage.hpp, exactly, so polygons that tile a region
// have each of its pixels exactly once.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <irg/core/function_ref.hpp>
#include <irg/raster/detail/compiled_rasters.hpp>
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

namespace detail::inline IRG_COMPILED_ABI {

// Walks all edges down the window.
template <class J>
IRG_API void send_edge_scan(std::vector<polygon_edge<J>>& edges, std::vector<int>& turns, fill_rule rule,
                            const cell_window& w, const function_ref<void(int, int, int)>& sink);
template <class J, CompiledPixel P>
IRG_API void paint_edge_scan(std::vector<polygon_edge<J>>& edges, std::vector<int>& turns, fill_rule rule,
                             const cell_window& w, const image_view<P>& raster, const P& value);

}  // namespace detail::inline IRG_COMPILED_ABI

namespace detail::inline IRG_ABI {

// What scans of irg::compiled go to: a sink, or the pixels themselves.
template <class Sink>
struct scan_to_sink {
  Sink& sink;
  IRG_INLINE constexpr void operator()(int y, int first, int last) const { sink(y, first, last); }
  template <class J>
  constexpr void scan(std::vector<polygon_edge<J>>& edges, std::vector<int>& turns, fill_rule rule,
                      const cell_window& w) const {
    send_edge_scan(edges, turns, rule, w, as_function<void(int, int, int)>(sink));
  }
  template <CompiledRing R>
  constexpr bool ring(const R& r, const cell_window& w) const {
    return send_ring_runs(std::span<const ring_point<R>>(r), w, as_function<void(int, int, int)>(sink));
  }
};
template <class Sink, class P>
struct scan_to_pixels {
  Sink& sink;
  image_view<P> raster;
  P value;
  IRG_INLINE constexpr void operator()(int y, int first, int last) const { sink(y, first, last); }
  template <class J>
  constexpr void scan(std::vector<polygon_edge<J>>& edges, std::vector<int>& turns, fill_rule rule,
                      const cell_window& w) const {
    paint_edge_scan(edges, turns, rule, w, raster, value);
  }
  template <CompiledRing R>
  constexpr bool ring(const R& r, const cell_window& w) const {
    return paint_ring_runs(raster, std::span<const ring_point<R>>(r), value, w);
  }
};

template <FillableRing R, class Emit>
constexpr bool walk_single_ring(const R& ring, const cell_window& w, Emit& sink) {
  if constexpr (requires { sink.ring(ring, w); })
    return sink.ring(ring, w);
  else
    return walk_ring(ring, w, sink);
}

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
  if constexpr (requires { sink.scan(edges, turns, rule, w); })
    sink.scan(edges, turns, rule, w);
  else
    scan_edges(edges, turns, rule, w, sink);
}

// Calls sink(y, x_first, x_last) for the runs of covered pixels; false, and no call, when a vertex is refused.
template <FillablePolygon P, class Emit>
constexpr bool walk_polygon(const P& polygon, fill_rule rule, const cell_window& w, fill_workspace& workspace,
                            Emit&& sink) {
  if constexpr (FillableRing<P>)
    if (ring_size(polygon) <= 3) return walk_single_ring(polygon, w, sink);
  const ring_reach reach = reach_of_polygon(polygon);
  if (reach == ring_reach::refused) return false;
  if (w.empty()) return true;
  if constexpr (FillableRing<P>)
    if (reach == ring_reach::within_snap_limit && goes_down_and_up_once(polygon))
      return walk_single_ring(polygon, w, sink);
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
  const auto send = [&](int y, int first, int last) { sink(span_of_cells{y, first, last}); };
  if constexpr (detail::draws_in_library)
    return detail::walk_polygon(polygon, rule, window, workspace, detail::scan_to_sink<decltype(send)>{send});
  else
    return detail::walk_polygon(polygon, rule, window, workspace, send);
}

/// Paints the pixels of a polygon, each once.
/// gives   false, and nothing painted, when a vertex is NaN, infinite or more than far_limit pixels from the origin
template <WritableRaster R, FillablePolygon P, PaintFor<R> Paint = pixel_of<R>, class Workspace = fill_workspace>
  requires std::same_as<Workspace&, fill_workspace&>
constexpr bool fill_polygon(R& raster, const P& polygon, fill_rule rule, const Paint& paint,
                            Workspace&& workspace = Workspace{}) {
  decltype(auto) prepared = detail::prepared_paint<R>(paint);
  const std::ptrdiff_t ahead = detail::bytes_to_row_below(raster);
  const cell_window w = window_of(raster);
  const auto send = [&](int y, int first, int last) { detail::paint_run(raster, y, first, last, prepared, ahead); };
  if constexpr (detail::draws_in_library && detail::CompiledRaster<R> && !BlendFunction<Paint, R>)
    return detail::walk_polygon(
        polygon, rule, w, workspace,
        detail::scan_to_pixels<decltype(send), pixel_of<R>>{send, view_of(raster), static_cast<pixel_of<R>>(prepared)});
  else if constexpr (detail::draws_in_library)
    return detail::walk_polygon(polygon, rule, w, workspace, detail::scan_to_sink<decltype(send)>{send});
  else
    return detail::walk_polygon(polygon, rule, w, workspace, send);
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

#if IRG_BODIES
namespace irg::detail::inline IRG_COMPILED_ABI {

template <class J>
IRG_API void send_edge_scan(std::vector<polygon_edge<J>>& edges, std::vector<int>& turns, fill_rule rule,
                            const cell_window& w, const function_ref<void(int, int, int)>& sink) {
  scan_edges(edges, turns, rule, w, sink);
}

template <class J, CompiledPixel P>
IRG_API void paint_edge_scan(std::vector<polygon_edge<J>>& edges, std::vector<int>& turns, fill_rule rule,
                             const cell_window& w, const image_view<P>& raster, const P& value) {
  image_view<P> target = raster;
  const std::ptrdiff_t ahead = bytes_to_row_below(target);
  const auto paint = [&](int y, int first, int last) { paint_run(target, y, first, last, value, ahead); };
  scan_edges(edges, turns, rule, w, paint);
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
