// SPDX-License-Identifier: MIT
// What irg::compiled has of visibility, for float and double.
#include <irg/visibility/cell_plan.hpp>
#include <irg/visibility/cells_from_bsp.hpp>
#include <irg/visibility/cut_source.hpp>
#include <irg/visibility/field_of_view.hpp>
#include <irg/visibility/guard_cover.hpp>
#include <irg/visibility/potentially_visible.hpp>
#include <irg/visibility/prepared_walls.hpp>
#include <irg/visibility/sight_in_space.hpp>
#include <irg/visibility/sight_line.hpp>
#include <irg/visibility/sight_tracker.hpp>
#include <irg/visibility/space_plan.hpp>
#include <irg/visibility/space_portals.hpp>
#include <irg/visibility/view_through_portals.hpp>
#include <irg/visibility/visibility_polygon.hpp>
#include <irg/visibility/visible_part.hpp>
#include <irg/visibility/visible_points.hpp>
#include <irg/visibility/weak_visibility.hpp>

namespace irg {

#define IRG_FOR_NUMBERS(T)                                                                                       \
  template guard_cover<T> cover_by_guards(std::span<const std::vector<point<T, 2>>>);                            \
  template source_regions<T> weak_visibility<T>(std::span<const point<T, 2>>, std::span<const segment<T, 2>>,    \
                                                const box<T, 2>&);                                               \
  template source_regions<T> weak_visibility<T>(std::span<const std::vector<point<T, 2>>>,                       \
                                                std::span<const segment<T, 2>>, const box<T, 2>&);               \
  template checked<seen_share, visibility_status> sight_between<T>(                                              \
      std::span<const point<T, 2>>, std::span<const point<T, 2>>, std::span<const segment<T, 2>>);               \
  template visible_region<T> detail::region_within(const point<T, 2>&, std::span<const segment<T, 2>>,           \
                                                   std::span<const segment<T, 2>>, const sight_options&);        \
  template visible_region<T> detail::counted_region_within(const point<T, 2>&, std::span<const segment<T, 2>>,   \
                                                           std::span<const segment<T, 2>>, const sight_options&, \
                                                           sight_counts&);                                       \
  template detail::walls_in_tiles<T> detail::put_in_tiles(std::span<const segment<T, 2>>, const box<T, 2>&);     \
  template visible_region<T> detail::region_among(const detail::walls_in_tiles<T>&, const point<T, 2>&);         \
  template visible_region<T> detail::counted_region_among(const detail::walls_in_tiles<T>&, const point<T, 2>&,  \
                                                          sight_counts&);
IRG_FOR_NUMBERS(float)
IRG_FOR_NUMBERS(double)
#undef IRG_FOR_NUMBERS

// Single lines, cut sources, and space.
#define IRG_FOR_NUMBERS(T)                                                                                          \
  template std::optional<std::size_t> first_obstacle<T>(                                                            \
      const point<T, 2>&, const point<T, 2>&, std::span<const segment<T, 2>>, obstacle_ends, sight_reach) noexcept; \
  template bool has_line_of_sight<T>(const point<T, 2>&, const point<T, 2>&, std::span<const segment<T, 2>>,        \
                                     obstacle_ends) noexcept;                                                       \
  template cut_source<T> cut_source_rounded<T>(std::span<const point<T, 2>>, std::span<const segment<T, 2>>);       \
  template cut_segment<T> cut_segment_rounded<T>(const segment<T, 2>&, std::span<const segment<T, 2>>);             \
  template std::vector<std::uint8_t> visible_points<T>(std::span<const point<T, 2>>, const point<T, 2>&);           \
  template bool has_line_of_sight(const point<T, 3>&, const point<T, 3>&, const mesh<T>&) noexcept;                 \
  template std::optional<seen_share> sure_sight(const space_region<T>&, const space_region<T>&, const mesh<T>&);    \
  template sampled_sight sample_sight(const space_region<T>&, const space_region<T>&, const mesh<T>&,               \
                                      const sight_sampling_options&);                                               \
  template std::vector<std::optional<seen_share>> sure_sight_of_faces(const space_region<T>&, const mesh<T>&);
IRG_FOR_NUMBERS(float)
IRG_FOR_NUMBERS(double)
#undef IRG_FOR_NUMBERS

// Cells and portals.
#define IRG_FOR_NUMBERS(T)                                                                                          \
  template plan_finding validate(const cell_plan<T>&);                                                              \
  template space_plan_finding validate(const space_plan<T>&);                                                       \
  template bsp_cells<T> cells_from_bsp<T>(const bsp_tree_2d<T>&, std::span<const segment<T, 2>>, const box<T, 2>&); \
  template visible_sets potentially_visible(const space_plan<T>&, const visible_set_options&);                      \
  template detail::door_lists<T> detail::door_lists_of(const cell_plan<T>&);                                        \
  template visible_sets detail::sets_seen(const detail::door_lists<T>&, const visible_set_options&);                \
  template visible_sets detail::sets_connected(const detail::door_lists<T>&, std::uint32_t);                        \
  template void detail::send_views(const detail::door_lists<T>&, std::uint32_t, const view_wedge<T>&,               \
                                   const function_ref<void(std::uint32_t, const view_wedge<T>&)>&);                 \
  template void detail::send_views_in_space(const cell_plan<T>&, const detail::door_lists<T>&, std::uint32_t,       \
                                            const view_wedge<T>&, T,                                                \
                                            const function_ref<void(std::uint32_t, const view_wedge<T>&)>&);        \
  template void detail::send_cells_seen(const space_plan<T>&, std::uint32_t, const point<T, 3>&,                    \
                                        const function_ref<void(std::uint32_t)>&);
IRG_FOR_NUMBERS(float)
IRG_FOR_NUMBERS(double)
#undef IRG_FOR_NUMBERS

// Grids.
namespace detail {

template void add_seen(const walled_grid&, const cell3&, cell_grid&, view_memory&, const view_options&);
template void add_seen(const walled_grid&, const cell3&, cell_grid&, counted_view_memory&, const view_options&);
template void mark_light(const walled_grid&, const cell3&, const view_options&, view_memory&, cell_grid&);
template std::vector<double> percentages_lit(const walled_grid&, cell);

}  // namespace detail
}  // namespace irg
