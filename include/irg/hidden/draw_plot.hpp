// SPDX-License-Identifier: MIT
// A plot of a surface in a raster, with smooth edges.
#pragma once

#include <irg/hidden/plot_surface.hpp>
#include <irg/raster/draw_text.hpp>
#include <irg/raster/fill_convex_aa.hpp>
#include <irg/raster/fill_polygon_aa.hpp>
#include <irg/raster/line_aa.hpp>

namespace irg {
inline namespace IRG_ABI {

/// Draws a plot: axes, facets with their edges, lines, texts. The paper is the raster's.
/// cost    that of the lines and texts
template <WritableRaster R>
  requires CoveragePaintFor<rgba8, R>
constexpr void draw_plot(R& raster, const surface_plot& plot, const plot_colours& colours = {}) {
  for (const plot_line& l : plot.axes) draw_line_aa(raster, l.from, l.to, l.colour);
  for (const plot_facet& f : plot.facets) {
    const std::array<std::array<point<double, 2>, 4>, 1> rings{f.corners};
    static_cast<void>(fill_polygon_aa(raster, rings, fill_rule::non_zero, f.colour));
    for (std::size_t k = 0; k < 4; ++k) draw_line_aa(raster, f.corners[k], f.corners[(k + 1) % 4], colours.edge);
  }
  for (const plot_line& l : plot.lines) draw_line_aa(raster, l.from, l.to, l.colour);
  for (const plot_label& l : plot.labels) draw_text(raster, l.text, l.at, l.style, colours.ink);
}

}  // namespace IRG_ABI
}  // namespace irg
