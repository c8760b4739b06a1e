// SPDX-License-Identifier: MIT
// What irg::compiled has of hidden.
#include <irg/hidden/back_faces.hpp>
#include <irg/hidden/bsp_faces.hpp>
#include <irg/hidden/bsp_scene.hpp>
#include <irg/hidden/faces_around.hpp>
#include <irg/hidden/grid_surface.hpp>
#include <irg/hidden/hidden_lines.hpp>
#include <irg/hidden/horizon_lines.hpp>
#include <irg/hidden/line_drawing.hpp>
#include <irg/hidden/painter.hpp>
#include <irg/hidden/painter_newell.hpp>
#include <irg/hidden/painter_once.hpp>
#include <irg/hidden/plot_surface.hpp>
#include <irg/hidden/ray_casting.hpp>
#include <irg/hidden/textbook/depth_sort.hpp>
#include <irg/hidden/visible_polygons.hpp>
#include <irg/hidden/warnock.hpp>

namespace irg::detail {

template checked<grid_surface_counts, grid_surface_status> send_grid_edges(const grid_surface&, const point<double, 3>&,
                                                                           const function_ref<void(grid_edge_part)>&);
template horizon_line_counts send_curves(std::span<const point<double, 2>>, const function_ref<void(edge_part)>&,
                                         drawn_parts);
template checked<surface_plot, grid_surface_status> plot_of(const grid_surface&, const surface_plot_options&);

template void leave_out_beside_edges(line_drawing&);

using faces = std::span<const screen_face>;

#define IRG_FOR_SENSES(Sense)                                                                                \
  template hidden_line_counts send_edge_parts<hidden_line_counts, Sense>(                                    \
      const faces&, const std::span<const screen_edge>&, const function_ref<void(edge_part)>&, face_search); \
  template visible_polygon_map map_of_window<visible_polygon_map, Sense>(const faces&, const cell_window&);
IRG_FOR_SENSES(1)
IRG_FOR_SENSES(-1)
#undef IRG_FOR_SENSES

using pixels = image<std::uint32_t>;
using face_list = std::vector<screen_face>;
using told_windows = function_ref<void(const cell_window&, warnock_case)>;
using told_steps = function_ref<void(newell_step, std::uint32_t, std::uint32_t)>;

#define IRG_FOR_ORDERS(Order)                                                                            \
  template void cast_rays<Order>(pixels&, face_list&, const cell_window&, draw_counts&);                 \
  template void paint_by_centroid<Order>(pixels&, face_list&, const cell_window&, draw_counts&);         \
  template void paint_each_once<Order>(pixels&, face_list&, const cell_window&, draw_counts&);           \
  template void paint_by_trees<Order>(pixels&, face_list&, const cell_window&, draw_counts&);            \
  template bsp_of_faces tree_of_faces<Order>(face_list&, const cell_window&);                            \
  template void draw_tree<Order>(pixels&, const bsp_of_faces&);                                          \
  template warnock_counts divide_windows<warnock_counts, Order>(pixels&, face_list&, const cell_window&, \
                                                                const no_window_observer&);              \
  template warnock_counts divide_windows<warnock_counts, Order>(pixels&, face_list&, const cell_window&, \
                                                                const told_windows&);
#define IRG_FOR_DEPTHS(Order)                                                                        \
  template newell_counts paint_sorted<newell_counts, Order>(pixels&, face_list&, const cell_window&, \
                                                            const no_newell_observer&);              \
  template newell_counts paint_sorted<newell_counts, Order>(pixels&, face_list&, const cell_window&, const told_steps&);
IRG_FOR_ORDERS(nearer_is_greater)
IRG_FOR_ORDERS(nearer_is_less)
IRG_FOR_ORDERS(drawing_order)
IRG_FOR_DEPTHS(nearer_is_greater)
IRG_FOR_DEPTHS(nearer_is_less)
#undef IRG_FOR_ORDERS
#undef IRG_FOR_DEPTHS

}  // namespace irg::detail

namespace irg {

#define IRG_FOR_NUMBERS(T)                                                                                             \
  template detail::pieces_on_screen detail::place_pieces<T>(const bsp_tree_3d<T>&, const point<T, 3>&,                 \
                                                            const mat<T, 4, 4>&, const screen_mapping<T>&);            \
  template detail::pieces_on_screen detail::place_pieces<T>(const bsp_tree_3d<T>&, const vec<T, 3>&,                   \
                                                            const mat<T, 4, 4>&, const screen_mapping<T>&);            \
  template void detail::paint_pieces(const bsp_data_3d<T>&, const detail::pieces_on_screen&, const detail::faces&,     \
                                     const cell_window&, detail::pixels&, draw_counts&);                               \
  template void add_mesh(line_drawing&, const mesh<T>&, const mat<T, 4, 4>&, const screen_mapping<T>&,                 \
                         const line_drawing_options<T>&);                                                              \
  template void detail::send_sides(const point<T, 3>&, const mesh<T>&,                                                 \
                                   const function_ref<void(std::size_t, const std::vector<screen_face>&)>&,            \
                                   const cube_options<T>&);                                                            \
  template facing detail::facing_in_mesh(const mesh<T>&, std::size_t, const hpoint<T, 3>&) noexcept;                   \
  template std::vector<std::uint32_t> detail::front_faces_of_mesh(const mesh<T>&, const hpoint<T, 3>&, edge_on_faces); \
  template std::vector<textbook::depth_sorted_polygon<T>> detail::sorted_by_tests(                                     \
      const std::vector<std::vector<point<T, 3>>>&, const detail::told_steps&);
IRG_FOR_NUMBERS(float)
IRG_FOR_NUMBERS(double)
#undef IRG_FOR_NUMBERS

}  // namespace irg
