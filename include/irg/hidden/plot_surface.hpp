// SPDX-License-Identifier: MIT
// plot_surface: a grid surface as a labelled picture, in one call: it chooses how hidden parts are found, and says why.
// The drawing is made of facets, lines and texts, for a raster (draw_plot.hpp) or a file (io/svg_plot.hpp).
#pragma once

#include <irg/core/checked.hpp>
#include <irg/hidden/detail/plot_maker.hpp>

namespace irg {
inline namespace IRG_ABI {

/// A grid surface as a labelled picture: what is seen of it, coloured by height, with axes, ticks and texts.
/// shape   heights that are NaN or infinite are gaps: their edges and facets are left out
/// needs   a width and height of 1 or more
/// gives   nothing but the status for what is no grid, has no height at all, has the eye on it or beyond the largest
///         number, and for options that are not finite, with a distance or tallness that is not positive
/// exact   with perimeter and lines what is seen is decided exactly, for the eye that the options give, rounded; places
///         are rounded
/// cost    that of the method: visible_grid_edges, visible_curves, or a list of all facets
/// source  Special-cases chapter, 3 for the view
template <class Options = surface_plot_options, class Plot = surface_plot>
[[nodiscard]] constexpr checked<Plot, grid_surface_status> plot_surface(const grid_surface& surface,
                                                                        const Options& options = {}) {
  checked<Plot, grid_surface_status> plot{{}, grid_surface_status::not_a_grid};
  const auto is_positive = [](double v) { return v > 0x1p-20 && v < 0x1p20; };
  const bool usable = options.width > 0 && options.height > 0 && is_positive(options.distance) &&
                      is_positive(options.tallness) && is_positive(options.text_size) &&
                      magnitude(options.azimuth) < 0x1p20 && magnitude(options.elevation) < 0x1p20;
  if (!usable || !detail::is_grid_with_gaps(surface)) return plot;
  plot.status = detail::plot_maker<Plot, Options>(surface, options).make(plot.value);
  return plot;
}

}  // namespace IRG_ABI
}  // namespace irg
