// SPDX-License-Identifier: MIT
// The doors of geometry, for float and double: predicates and polygons.
#include <irg/geometry/in_circle.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/orient3d.hpp>
#include <irg/geometry/polygon_overlay.hpp>
#include <irg/geometry/triangulate_ear_clipping.hpp>
#include <irg/geometry/triangulate_monotone.hpp>

namespace irg::detail {

using triangle_sink = function_ref<void(std::uint32_t, std::uint32_t, std::uint32_t)>;

#define IRG_FOR_NUMBERS(T)                                                                                 \
  template int exact_predicate<3, 2>(T, T, T, T, T, T) noexcept;                                           \
  template int exact_predicate<4, 2>(T, T, T, T, T, T, T, T) noexcept;                                     \
  template int exact_predicate<4, 3>(T, T, T, T, T, T, T, T, T, T, T, T) noexcept;                         \
  template int exact_predicate<5, 3>(T, T, T, T, T, T, T, T, T, T, T, T, T, T, T) noexcept;                \
  template clipped_rings<T> combine_pieces(std::vector<boundary_piece<T>>&, boolean_operation, fill_rule); \
  template triangulation triangulate_rings(std::vector<point<T, 2>>&&, std::span<const std::uint32_t>);    \
  template bool clip_ears(ear_clipping_memory<T>&, std::size_t, const triangle_sink&);
IRG_FOR_NUMBERS(float)
IRG_FOR_NUMBERS(double)
#undef IRG_FOR_NUMBERS

}  // namespace irg::detail
