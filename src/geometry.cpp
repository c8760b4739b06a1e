// SPDX-License-Identifier: MIT
// What irg::compiled has of geometry, for float and double: predicates and polygons.
#include <irg/geometry/clip_sutherland_hodgman.hpp>
#include <irg/geometry/in_circle.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/orient3d.hpp>
#include <irg/geometry/polygon_overlay.hpp>
#include <irg/geometry/split_polygon.hpp>
#include <irg/geometry/triangulate_ear_clipping.hpp>
#include <irg/geometry/triangulate_monotone.hpp>

namespace irg::detail {

template <class T>
using opt = std::optional<T>;
using triangle_sink = function_ref<void(std::uint32_t, std::uint32_t, std::uint32_t)>;

template double axis_crossing_in_doubt(double, double, double, double, double) noexcept;

#define IRG_FOR_DIMENSIONS(T, D)                                                                                \
  template half_space_meeting<T, point<T, D>> meeting_with_half_space(const point<T, D>&, const point<T, D>&,   \
                                                                      const half_space<T, D>&) noexcept;        \
  template int order_of_crossings(const point<T, D>&, const point<T, D>&, const half_space<T, D>&,              \
                                  const half_space<T, D>&) noexcept;                                            \
  template int side_of_line_meeting(const half_space<T, D>&, const half_space<T, D>&, const point<T, D>&,       \
                                    const point<T, D>&) noexcept;                                               \
  template opt<point<T, D>> rounded_line_meeting(const half_space<T, D>&, const point<T, D>&,                   \
                                                 const point<T, D>&) noexcept;                                  \
  template int sign_of_sum_of_values(const half_space<T, D>&, const point<T, D>&, const point<T, D>&) noexcept; \
  template split_plan<T, D> plan_of_split(const std::vector<point<T, D>>&, const std::vector<int>&,             \
                                          const half_space<T, D>&);
#define IRG_FOR_NUMBERS(T)                                                                                      \
  template int exact_predicate<3, 2>(T, T, T, T, T, T) noexcept;                                                \
  template int exact_predicate<4, 2>(T, T, T, T, T, T, T, T) noexcept;                                          \
  template int exact_predicate<4, 3>(T, T, T, T, T, T, T, T, T, T, T, T) noexcept;                              \
  template int exact_predicate<5, 3>(T, T, T, T, T, T, T, T, T, T, T, T, T, T, T) noexcept;                     \
  template clipped_rings<T> combine_pieces(std::vector<boundary_piece<T>>&, boolean_operation, fill_rule);      \
  template triangulation triangulate_rings(std::vector<point<T, 2>>&&, std::span<const std::uint32_t>);         \
  template bool clip_ears(ear_clipping_memory<T>&, std::size_t, const triangle_sink&);                          \
  template T axis_crossing_exact(T, T, T, T, T) noexcept;                                                       \
  template int side_of_plane_meeting(const half_space<T, 3>&, const half_space<T, 3>&, const half_space<T, 3>&, \
                                     const point<T, 3>&, const point<T, 3>&, const point<T, 3>&) noexcept;      \
  template opt<point<T, 3>> rounded_planes_meeting(const half_space<T, 3>&, const half_space<T, 3>&,            \
                                                   const point<T, 3>&, const point<T, 3>&,                      \
                                                   const point<T, 3>&) noexcept;                                \
  IRG_FOR_DIMENSIONS(T, 2)                                                                                      \
  IRG_FOR_DIMENSIONS(T, 3)
IRG_FOR_NUMBERS(float)
IRG_FOR_NUMBERS(double)
#undef IRG_FOR_NUMBERS
#undef IRG_FOR_DIMENSIONS

}  // namespace irg::detail
