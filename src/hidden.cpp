// SPDX-License-Identifier: MIT
// The doors of hidden.
#include <irg/hidden/grid_surface.hpp>
#include <irg/hidden/horizon_lines.hpp>
#include <irg/hidden/plot_surface.hpp>

namespace irg::detail {

template checked<grid_surface_counts, grid_surface_status> send_grid_edges(const grid_surface&, const point<double, 3>&,
                                                                           const function_ref<void(grid_edge_part)>&);
template horizon_line_counts send_curves(std::span<const point<double, 2>>, const function_ref<void(edge_part)>&,
                                         drawn_parts);
template checked<surface_plot, grid_surface_status> plot_of(const grid_surface&, const surface_plot_options&);

}  // namespace irg::detail
