// SPDX-License-Identifier: MIT
// What irg::compiled has of curve: surfaces of points of space, for float and double.
#include <irg/curve/surface_tessellation.hpp>
#include <irg/curve/surface_trimming.hpp>

namespace irg::detail {

#define IRG_FOR_POINTS(P, T)                                                                                       \
  template surface_tessellation send_surface(const control_net<P>&, T, const triangle_sink<P>&);                   \
  template std::optional<surface_tessellation> send_trimmed_surface(                                               \
      const control_net<P>&, const std::vector<point<T, 2>>&, const std::vector<std::array<std::uint32_t, 3>>&, T, \
      const triangle_sink<P>&);
#define IRG_FOR_NUMBERS(T)         \
  using T##_point = point<T, 3>;   \
  using T##_hpoint = hpoint<T, 3>; \
  IRG_FOR_POINTS(T##_point, T)     \
  IRG_FOR_POINTS(T##_hpoint, T)
IRG_FOR_NUMBERS(float)
IRG_FOR_NUMBERS(double)
#undef IRG_FOR_NUMBERS
#undef IRG_FOR_POINTS

}  // namespace irg::detail
