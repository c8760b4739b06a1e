// SPDX-License-Identifier: MIT
// What irg::compiled has of geometry, for float and double: distances and nearest points.
#include <irg/geometry/closest_point.hpp>
#include <irg/geometry/distance.hpp>

namespace irg::detail {

template <class T>
using opt = std::optional<T>;

#define IRG_FOR_DIMENSIONS(T, N)                                                                              \
  template opt<T> distance_of_points(const point<T, N>&, const point<T, N>&) noexcept;                        \
  template opt<T> distance_from_line(const point<T, N>&, const point<T, N>&, const point<T, N>&) noexcept;    \
  template opt<T> distance_from_segment(const point<T, N>&, const point<T, N>&, const point<T, N>&) noexcept; \
  template opt<T> distance_between_segments(const point<T, N>&, const point<T, N>&, const point<T, N>&,       \
                                            const point<T, N>&) noexcept;                                     \
  template opt<point_on_line<point<T, N>>> nearest_on_line(const point<T, N>&, const point<T, N>&,            \
                                                           const point<T, N>&) noexcept;                      \
  template opt<point_on_line<point<T, N>>> nearest_on_segment(const point<T, N>&, const point<T, N>&,         \
                                                              const point<T, N>&) noexcept;                   \
  template opt<point_pair<point<T, N>>> nearest_of_segments(const point<T, N>&, const point<T, N>&,           \
                                                            const point<T, N>&, const point<T, N>&) noexcept;
#define IRG_FOR_NUMBERS(T)                                                                                           \
  template opt<T> height_over_line(const line<T>&, const point<T, 2>&) noexcept;                                     \
  template opt<T> height_over_plane(const plane<T>&, const point<T, 3>&) noexcept;                                   \
  template opt<T> distance_from_triangle(const point<T, 3>&, const point<T, 3>&, const point<T, 3>&,                 \
                                         const point<T, 3>&) noexcept;                                               \
  template opt<T> distance_between_lines(const point<T, 3>&, const point<T, 3>&, const point<T, 3>&,                 \
                                         const point<T, 3>&) noexcept;                                               \
  template opt<point<T, 3>> nearest_on_plane(const plane<T>&, const point<T, 3>&) noexcept;                          \
  template opt<point_on_triangle<point<T, 3>>> nearest_on_triangle(const point<T, 3>&, const point<T, 3>&,           \
                                                                   const point<T, 3>&, const point<T, 3>&) noexcept; \
  template opt<point_pair<point<T, 3>>> nearest_of_lines(const point<T, 3>&, const point<T, 3>&, const point<T, 3>&, \
                                                         const point<T, 3>&) noexcept;                               \
  IRG_FOR_DIMENSIONS(T, 2)                                                                                           \
  IRG_FOR_DIMENSIONS(T, 3)
IRG_FOR_NUMBERS(float)
IRG_FOR_NUMBERS(double)
#undef IRG_FOR_NUMBERS
#undef IRG_FOR_DIMENSIONS

}  // namespace irg::detail
