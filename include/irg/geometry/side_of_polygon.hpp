// SPDX-License-Identifier: MIT
// Which side of a polygon of space is seen from a point: the sign of Newell's normal times the way from the first
// vertex to the point, exactly, in doubles with a bound where that tells. A polynomial of degree 4 in the coordinates.
#pragma once

#include <concepts>
#include <cstddef>
#include <limits>

#include <irg/core/ring.hpp>
#include <irg/geometry/detail/exact_forms.hpp>
#include <irg/geometry/detail/predicate_kernel.hpp>
#include <irg/geometry/orient3d.hpp>
#include <irg/geometry/plane.hpp>
#include <irg/math/exact/big_float.hpp>
#include <irg/math/exact/filtered_number.hpp>

namespace irg::inline IRG_ABI {

/// On which side of a polygon q lies, of the plane through its first vertex with Newell's normal: above where the
/// vertices run counter-clockwise, seen from q.
/// shape   the polygon need not be plane nor convex. q is homogeneous, its weight not negative: 0 for the direction
///         towards a point infinitely far away
/// gives   `on` for polygons without area or with fewer than three vertices, and when something is NaN or infinite
/// exact   for every finite float and double
/// cost    a few operations per vertex; where roundings do not tell, as for a point in the plane, some microseconds,
///         less for triangles
/// source  Sutherland, Sproull and Schumacker 1974 (Newell's normal)
template <SpaceRing R, HomogeneousPoint Q>
  requires(size_of<Q> == 4 && Floating<scalar_of<Q>> && std::same_as<ring_scalar<R>, scalar_of<Q>>)
[[nodiscard]] constexpr side side_of_polygon(const R& polygon, const Q& q) noexcept;

}  // namespace irg::inline IRG_ABI

namespace irg::detail::inline IRG_ABI {

// The sign of (sum of the cross products of the edges, fanned from the first vertex) . (eye - weight * first vertex).
template <Floating T, class Position>
IRG_NOINLINE constexpr int exact_face_volume_sign(std::size_t count, const Position& position,
                                                  const hpoint<T, 3>& eye) noexcept {
  using N = big_float<4>;
  for (std::size_t k = 0; k < count; ++k)
    if (!is_finite(position(k))) return 0;
  if (!is_finite(eye)) return 0;
  if (count == 3 && eye.w == T(1))
    return orient3d(position(0), position(1), position(2), point<T, 3>{eye.x, eye.y, eye.z});
  const auto exact = [](const auto& p) { return vec{exactly<N>(p[0]), exactly<N>(p[1]), exactly<N>(p[2])}; };
  const vec<N, 3> first = exact(position(0));
  vec<N, 3> normal, before = exact(position(1)) - first;
  for (std::size_t k = 2; k < count; ++k) {
    const vec<N, 3> after = exact(position(k)) - first;
    normal = normal + cross(before, after);
    before = after;
  }
  return dot(normal, exact(eye) - first * exactly<N>(eye.w)).sign();
}

// The same in doubles, and how far it may be off; the bound is NaN or infinite where it does not say.
struct rounded_volume {
  double value, bound;
};

// With E the greatest coordinate of an edge, rounded once, and W that of |eye| + |weight * first|, the value is a sum
// of 6 (n - 2) products below E E W, off by n + 6 roundings at most: twice that and some more. While E and W stay
// within 2^-200 and 2^200, nothing overflows, and what underflows is far below a rounding.
template <class Position>
constexpr rounded_volume rounded_face_volume(std::size_t count, const Position& position,
                                             const hpoint<double, 3>& eye) noexcept {
  constexpr double undecided = std::numeric_limits<double>::infinity();
  const point<double, 3> first = position(0);
  double widest = 0, farthest = 0;
  vec<double, 3> normal, before, towards;
  for (std::size_t k = 1; k < count; ++k) {
    const vec<double, 3> after = position(k) - first;
    widest = maximum(widest, maximum(magnitude(after.x), maximum(magnitude(after.y), magnitude(after.z))));
    normal += cross(before, after);
    before = after;
  }
  for (int i = 0; i < 3; ++i) {
    const double moved = product(eye.w, first[i]);
    towards[i] = eye[i] - moved;
    farthest = maximum(farthest, magnitude(eye[i]) + magnitude(moved));
  }
  constexpr double least = 0x1p-200, most = 0x1p200;
  if (!(widest >= least && widest <= most && farthest >= least && farthest <= most)) return {0, undecided};
  const double n = static_cast<double>(count);
  return {dot(normal, towards), (n + 16) * 0x1p-52 * (6 * n) * widest * widest * farthest};
}

// Whether nothing overflows in rounded_face_volume.
template <Floating T, class Position>
constexpr bool is_far_from_overflow(std::size_t count, const Position& position, const hpoint<T, 3>& eye) noexcept {
  const auto is_small = [](const T& x) { return magnitude(widened(x)) <= 0x1p199; };
  bool all = is_small(eye.w);
  for (int i = 0; i < 3; ++i) {
    all = all && is_small(eye[i]);
    for (std::size_t k = 0; k < count; ++k) all = all && is_small(position(k)[i]);
  }
  return all;
}

// position(k) is vertex k.
// gives   0 when something is NaN or infinite, or with fewer than three vertices
template <Floating T, class Position>
constexpr int face_volume_sign(std::size_t count, const Position& position, const hpoint<T, 3>& eye) noexcept {
  if (count < 3) return 0;
  if (in_constant_evaluation() && !is_far_from_overflow(count, position, eye))
    return exact_face_volume_sign(count, position, eye);
  bool suits = true;  // what takes subnormal floats for zero while widening them is not asked
  const auto number = [&](const T& x) {
    if constexpr (sizeof(T) < sizeof(double)) suits = suits && suits_filter<2>(x);
    return widened(x);
  };
  const auto wide = [&](const point<T, 3>& p) { return point<double, 3>{number(p.x), number(p.y), number(p.z)}; };
  const rounded_volume v = rounded_face_volume(
      count, [&](std::size_t k) { return wide(position(k)); },
      hpoint<double, 3>{number(eye.x), number(eye.y), number(eye.z), number(eye.w)});
  if (suits && v.value > v.bound) return 1;
  if (suits && -v.value > v.bound) return -1;
  return exact_face_volume_sign(count, position, eye);
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <SpaceRing R, HomogeneousPoint Q>
  requires(size_of<Q> == 4 && Floating<scalar_of<Q>> && std::same_as<ring_scalar<R>, scalar_of<Q>>)
[[nodiscard]] constexpr side side_of_polygon(const R& polygon, const Q& q) noexcept {
  using T = scalar_of<Q>;
  const auto position = [&](std::size_t k) { return detail::as_point<T>(ring_vertex(polygon, k)); };
  return static_cast<side>(
      detail::face_volume_sign(ring_size(polygon), position,
                               hpoint<T, 3>{coordinate(q, 0), coordinate(q, 1), coordinate(q, 2), coordinate(q, 3)}));
}

}  // namespace irg::inline IRG_ABI
