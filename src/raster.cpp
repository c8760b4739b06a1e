// SPDX-License-Identifier: MIT
// What irg::compiled has of raster: into pixels of four 8-bit channels, or a sink.
#include <irg/raster/draw_lines.hpp>
#include <irg/raster/draw_text.hpp>
#include <irg/raster/fill_convex_aa.hpp>
#include <irg/raster/fill_polygon.hpp>
#include <irg/raster/fill_polygon_aa.hpp>
#include <irg/raster/line_aa.hpp>
#include <irg/raster/stroke.hpp>

namespace irg::detail {

using coverage_sink = function_ref<void(const coverage_span&)>;
using float_point = point<float, 2>;
using double_point = point<double, 2>;
using polyline_sink = function_ref<void(std::span<const double_point>)>;
using run_sink = function_ref<void(int, int, int)>;
template <class J>
using edges_of = std::vector<polygon_edge<J>>;

template bool outline_of_stroke(std::span<const double_point>, const stroke_style&, const polyline_sink&);
template bool strokes_of_text(std::string_view, const double_point&, const text_style&, const polyline_sink&);
template void send_area_sweep(area_memory&, fill_rule, const cell_window&, const coverage_sink&);
template void send_line_areas(const subpixel&, const subpixel&, const line_aa_options&, const cell_window&,
                              const coverage_sink&);

#define IRG_FOR_VERTICES(V)                                                                                      \
  template bool send_ring_runs(std::span<const V>, const cell_window&, const run_sink&);                         \
  template bool paint_ring_runs(const image_view<rgba8>&, std::span<const V>, const rgba8&, const cell_window&); \
  template bool paint_ring_runs(const image_view<bgra8>&, std::span<const V>, const bgra8&, const cell_window&); \
  template bool send_convex_ring(std::span<const V>, const cell_window&, const coverage_sink&);                  \
  template bool mix_convex_ring(const image_view<rgba8>&, std::span<const V>, const rgba8&, const cell_window&); \
  template bool mix_convex_ring(const image_view<bgra8>&, std::span<const V>, const bgra8&, const cell_window&);
IRG_FOR_VERTICES(subpixel)
IRG_FOR_VERTICES(float_point)
IRG_FOR_VERTICES(double_point)
#undef IRG_FOR_VERTICES

#define IRG_FOR_PIXELS(P)                                                                                       \
  template void draw_line_batch(const image_view<P>&, const cell_window&, std::span<const cell_line>, const P&, \
                                const line_options&, line_batch&);                                              \
  template void draw_painted_batch(const image_view<P>&, const cell_window&, std::span<const painted_line<P>>,  \
                                   const line_options&, line_batch&);                                           \
  template void mix_area_sweep(const image_view<P>&, area_memory&, fill_rule, const cell_window&, const P&);    \
  template void mix_line_areas(const image_view<P>&, const subpixel&, const subpixel&, const P&,                \
                               const line_aa_options&, const cell_window&);                                     \
  template void paint_edge_scan(edges_of<std::int32_t>&, std::vector<int>&, fill_rule, const cell_window&,      \
                                const image_view<P>&, const P&);                                                \
  template void paint_edge_scan(edges_of<std::int64_t>&, std::vector<int>&, fill_rule, const cell_window&,      \
                                const image_view<P>&, const P&);
IRG_FOR_PIXELS(rgba8)
IRG_FOR_PIXELS(bgra8)
#undef IRG_FOR_PIXELS

template void send_edge_scan(edges_of<std::int32_t>&, std::vector<int>&, fill_rule, const cell_window&,
                             const run_sink&);
template void send_edge_scan(edges_of<std::int64_t>&, std::vector<int>&, fill_rule, const cell_window&,
                             const run_sink&);

}  // namespace irg::detail
