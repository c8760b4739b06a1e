// SPDX-License-Identifier: MIT
// A plot of a surface as SVG: lines, facets and strokes of text as vectors.
#pragma once

#include <irg/hidden/plot_surface.hpp>
#include <irg/io/svg_drawing.hpp>

namespace irg::inline IRG_ABI {

/// Writes a plot as SVG text to sink(std::string_view), piece by piece.
/// shape   units are pixels; texts are strokes of irg's own font, so that they look alike everywhere
/// cost    some 60 bytes a line
template <class Sink>
constexpr void write_svg_plot(Sink& sink, const surface_plot& plot, const plot_colours& colours = {}) {
  svg_drawing drawing(sink, {plot.width, plot.height}, colours.paper);
  const auto lines = [&](const auto& all, double width) {
    const rgba8* last = nullptr;
    for (const plot_line& l : all) {
      if (last == nullptr || !(*last == l.colour)) drawing.begin_lines({l.colour, width, 0});
      last = &l.colour;
      drawing.add_line(l.from, l.to);
    }
  };
  lines(plot.axes, 1);
  for (const plot_facet& f : plot.facets) {
    drawing.add_region(std::array<std::array<point<double, 2>, 4>, 1>{f.corners}, f.colour);
    drawing.begin_lines({colours.edge, 0.8, 0});
    for (std::size_t k = 0; k < 4; ++k) drawing.add_line(f.corners[k], f.corners[(k + 1) % 4]);
  }
  lines(plot.lines, 1);
  for (const plot_label& l : plot.labels) {
    drawing.begin_lines({colours.ink, l.style.size / 12, 0});
    text_segments(l.text, l.at, l.style, [&](const auto& a, const auto& b) { drawing.add_line(a, b); });
  }
  drawing.finish();
}

}  // namespace irg::inline IRG_ABI
