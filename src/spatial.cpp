// SPDX-License-Identifier: MIT
// What irg::compiled has of spatial, for float and double, bvh with rays of either, counted and not.
#include <irg/spatial/bsp_tree_2d.hpp>
#include <irg/spatial/bsp_tree_3d.hpp>
#include <irg/spatial/cross_triangle.hpp>
#include <irg/spatial/triangle_bvh.hpp>

namespace irg {

using found = std::optional<triangle_hit>;

#define IRG_FOR_RAYS(T, U, C)                                                                           \
  template found closest_hit(const triangle_bvh<T>&, const ray<U, 3>&, C&) noexcept;                    \
  template void closest_hits(const triangle_bvh<T>&, std::span<const ray<U, 3>>, std::span<found>, C&); \
  template bool any_hit(const triangle_bvh<T>&, const ray<U, 3>&, C&) noexcept;                         \
  template bool detail::is_admitted_hit(const triangle_bvh<T>&, const ray<U, 3>&,                       \
                                        const function_ref<bool(std::uint32_t)>&, C&);                  \
  template void detail::each_hit(const triangle_bvh<T>&, const ray<U, 3>&,                              \
                                 const function_ref<void(const triangle_hit&)>&, C&);
#define IRG_FOR_NUMBERS(T)                                                                                          \
  template std::optional<ray_crossing> intersect_triangle(const ray<T, 3>&, const point<T, 3>&, const point<T, 3>&, \
                                                          const point<T, 3>&) noexcept;                             \
  template void refit<T>(bvh&, std::span<const box<T, 3>>);                                                         \
  template bvh detail::build_box_tree(std::span<const box<T, 3>>, const bvh_options&, const executor_ref&);         \
  template bvh detail::build_triangle_tree(std::span<const box<T, 3>>, const bvh_options&, const executor_ref&,     \
                                           const function_ref<std::array<point<T, 3>, 3>(std::size_t)>&);           \
  IRG_FOR_RAYS(T, float, ray_counts)                                                                                \
  IRG_FOR_RAYS(T, double, ray_counts)                                                                               \
  IRG_FOR_RAYS(T, float, const uncounted_rays)                                                                      \
  IRG_FOR_RAYS(T, double, const uncounted_rays)
IRG_FOR_NUMBERS(float)
IRG_FOR_NUMBERS(double)
#undef IRG_FOR_NUMBERS
#undef IRG_FOR_RAYS

#define IRG_FOR_NUMBERS(T)                                                                                  \
  template bsp_fault find_bsp_fault(const bsp_data_3d<T>&);                                                 \
  template void detail::grow_bsp_2d(growing_bsp_2d<T>&, const bsp_options&);                                \
  template segment<T, 2> detail::rounded_piece(const growing_bsp_2d<T>&, const bsp_piece_2d&) noexcept;     \
  template void detail::add_triangles(growing_bsp_3d<T>&, std::span<const point<T, 3>>,                     \
                                      std::span<const triangle_indices>, const bsp_options&);               \
  template void detail::shrink_to(growing_bsp_3d<T>&, const bsp_sizes&);                                    \
  template void detail::make_walkable(growing_bsp_3d<T>&);                                                  \
  template std::vector<point<T, 3>> detail::rounded_ring(const growing_bsp_3d<T>&, const bsp_piece_3d&);    \
  template int detail::exact_side(const bsp_data_3d<T>&, const bsp_plane_3d&, const point<T, 3>&) noexcept; \
  template int detail::side_of_direction(const bsp_data_3d<T>&, const bsp_plane_3d&, const vec<T, 3>&) noexcept;
IRG_FOR_NUMBERS(float)
IRG_FOR_NUMBERS(double)
#undef IRG_FOR_NUMBERS

}  // namespace irg
