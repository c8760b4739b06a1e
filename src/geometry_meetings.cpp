// SPDX-License-Identifier: MIT
// What irg::compiled has of geometry, for float and double: where lines and planes meet, and spheres.
#include <irg/geometry/intersect_lines.hpp>
#include <irg/geometry/intersect_plane_line.hpp>
#include <irg/geometry/intersect_planes.hpp>
#include <irg/geometry/intersect_segments.hpp>
#include <irg/geometry/side_of_meeting.hpp>
#include <irg/geometry/smallest_sphere.hpp>
#include <irg/geometry/sphere.hpp>

namespace irg::detail {

template <class T>
using opt = std::optional<T>;

#define IRG_FOR_DIMENSIONS(T, N)                                                                                      \
  template lines_meeting<point<T, N>> meeting_of_lines(const point<T, N>&, const point<T, N>&, const point<T, N>&,    \
                                                       const point<T, N>&) noexcept;                                  \
  template lines_meeting<point<T, N>> meeting_of_lines(const parametric_line<T, N>&,                                  \
                                                       const parametric_line<T, N>&) noexcept;                        \
  template segments_meeting<point<T, N>> meeting_of_segments(const point<T, N>&, const point<T, N>&,                  \
                                                             const point<T, N>&, const point<T, N>&) noexcept;        \
  template opt<bounding_sphere<T, N>> sphere_on(const point<T, N>&, const point<T, N>&) noexcept;                     \
  template opt<bounding_sphere<T, N>> sphere_on(const point<T, N>&, const point<T, N>&, const point<T, N>&) noexcept; \
  template void grow_ball(ball_points<T, N>&, const point<T, N>&) noexcept;                                           \
  template bool is_outside_ball(const ball_points<T, N>&, const point<T, N>&) noexcept;                               \
  template close_ball<N> close_ball_of(const ball_points<T, N>&) noexcept;                                            \
  template bounding_sphere<T, N> rounded_ball_of(const ball_points<T, N>&) noexcept;
#define IRG_FOR_NUMBERS(T)                                                                                          \
  template opt<bounding_sphere<T, 3>> sphere_on(const point<T, 3>&, const point<T, 3>&, const point<T, 3>&,         \
                                                const point<T, 3>&) noexcept;                                       \
  template planes_meeting<T> meeting_of_planes(const plane<T>&, const plane<T>&) noexcept;                          \
  template three_planes_meeting<T> meeting_of_planes(const plane<T>&, const plane<T>&, const plane<T>&) noexcept;   \
  template plane_line_meeting<point<T, 3>> meeting_of_plane_line(const plane<T>&, const point<T, 3>&,               \
                                                                 const point<T, 3>&) noexcept;                      \
  template plane_line_meeting<point<T, 3>> meeting_of_plane_line(const plane<T>&,                                   \
                                                                 const parametric_line<T, 3>&) noexcept;            \
  template plane_line_meeting<point<T, 3>> meeting_of_plane_line(                                                   \
      const point<T, 3>&, const point<T, 3>&, const point<T, 3>&, const point<T, 3>&, const point<T, 3>&) noexcept; \
  template parametric_meeting<T> meeting_of_plane_line(const parametric_plane<T>&,                                  \
                                                       const parametric_line<T, 3>&) noexcept;                      \
  IRG_FOR_DIMENSIONS(T, 2)                                                                                          \
  IRG_FOR_DIMENSIONS(T, 3)
IRG_FOR_NUMBERS(float)
IRG_FOR_NUMBERS(double)
#undef IRG_FOR_NUMBERS
#undef IRG_FOR_DIMENSIONS

}  // namespace irg::detail

namespace irg {

#define IRG_FOR_NUMBERS(T)                                                                                             \
  template std::optional<side> side_of_meeting(const plane_points<T>&, const plane_points<T>&, const plane_points<T>&, \
                                               const plane_points<T>&) noexcept;
IRG_FOR_NUMBERS(float)
IRG_FOR_NUMBERS(double)
#undef IRG_FOR_NUMBERS

}  // namespace irg
