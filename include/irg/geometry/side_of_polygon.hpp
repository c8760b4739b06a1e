// SPDX-License-Identifier: MIT
// Which side of a polygon of space is seen from a point: the sign of Newell's normal times the way from the first
// vertex to the point, exactly, in doubles with a bound where that tells. A polynomial of degree 4 in the coordinates.
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include <irg/core/ring.hpp>
#include <irg/geometry/detail/exact_sign.hpp>
#include <irg/geometry/detail/formula.hpp>
#include <irg/geometry/orient3d.hpp>
#include <irg/geometry/plane.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// (sum of the cross products of the edges, fanned from the first vertex) . (eye - weight * first vertex).
template <class N, class Position>
constexpr N face_volume(std::size_t count, const Position& position, const std::array<N, 4>& eye) noexcept {
  const std::array<N, 3> first = position(0);
  std::array<N, 3> normal{}, before = difference_of(position(1), first);
  for (std::size_t k = 2; k < count; ++k) {
    const std::array<N, 3> after = difference_of(position(k), first);
    normal = sum_of(normal, cross_of(before, after));
    before = after;
  }
  const std::array<N, 3> towards{eye[0] - eye[3] * first[0], eye[1] - eye[3] * first[1], eye[2] - eye[3] * first[2]};
  return dot_of(normal, towards);
}

template <Floating T, class Position>
IRG_NOINLINE constexpr int exact_face_volume_sign(std::size_t count, const Position& position,
                                                  const std::array<T, 4>& eye) noexcept {
  for (std::size_t k = 0; k < count; ++k)
    for (const T& x : position(k))
      if (!is_finite(x)) return 0;
  for (const T& x : eye)
    if (!is_finite(x)) return 0;
  if (count == 3 && eye[3] == T(1))
    return orient3d(position(0), position(1), position(2), std::array<T, 3>{eye[0], eye[1], eye[2]});
  using number = dyadic<words_for_degree(4)>;
  const auto exact = [](const T& x) { return exact_number<number>(x); };
  const auto exact_position = [&](std::size_t k) {
    const auto p = position(k);
    return std::array{exact(p[0]), exact(p[1]), exact(p[2])};
  };
  return face_volume<number>(count, exact_position,
                             std::array{exact(eye[0]), exact(eye[1]), exact(eye[2]), exact(eye[3])})
      .sign();
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
                                             const std::array<double, 4>& eye) noexcept {
  constexpr double undecided = std::numeric_limits<double>::infinity();
  const std::array<double, 3> first = position(0);
  double widest = 0, farthest = 0;
  std::array<double, 3> normal{}, before{}, towards{};
  for (std::size_t k = 1; k < count; ++k) {
    const std::array<double, 3> at = position(k), after{at[0] - first[0], at[1] - first[1], at[2] - first[2]};
    widest = greater(widest, greater(magnitude(after[0]), greater(magnitude(after[1]), magnitude(after[2]))));
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = i == 2 ? 0 : i + 1, l = i == 0 ? 2 : i - 1;
      normal[i] += product(before[j], after[l]) - product(before[l], after[j]);
    }
    before = after;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const double moved = product(eye[3], first[i]);
    towards[i] = eye[i] - moved;
    farthest = greater(farthest, magnitude(eye[i]) + magnitude(moved));
  }
  constexpr double least = 0x1p-200, most = 0x1p200;
  if (!(widest >= least && widest <= most && farthest >= least && farthest <= most)) return {0, undecided};
  const double n = static_cast<double>(count);
  return {product(normal[0], towards[0]) + product(normal[1], towards[1]) + product(normal[2], towards[2]),
          (n + 16) * 0x1p-52 * (6 * n) * widest * widest * farthest};
}

// position(k) is an array of the coordinates of vertex k, eye one of x, y, z and weight.
// gives   0 when something is NaN or infinite, or with fewer than three vertices
template <Floating T, class Position>
constexpr int face_volume_sign(std::size_t count, const Position& position, const std::array<T, 4>& eye) noexcept {
  if (count < 3) return 0;
  bool suits = true;  // what takes subnormal floats for zero while widening them is not asked
  const auto number = [&](const T& x) {
    if constexpr (sizeof(T) < sizeof(double)) suits = suits && suits_filter(x);
    return widened(x);
  };
  const auto numbers = [&](const std::array<T, 3>& p) { return std::array{number(p[0]), number(p[1]), number(p[2])}; };
  const rounded_volume v = rounded_face_volume(
      count, [&](std::size_t k) { return numbers(position(k)); },
      std::array{number(eye[0]), number(eye[1]), number(eye[2]), number(eye[3])});
  if (suits && v.value > v.bound) return 1;
  if (suits && -v.value > v.bound) return -1;
  return exact_face_volume_sign(count, position, eye);
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// On which side of a polygon q lies, of the plane through its first vertex with Newell's normal: above where the
/// vertices run counter-clockwise, seen from q.
/// shape   the polygon need not be plane nor convex. q is homogeneous, its weight not negative: 0 for the direction
///         towards a point infinitely far away
/// gives   `on` for polygons without area or with fewer than three vertices, and when something is NaN or infinite
/// exact   for every finite float and double
/// cost    a few operations per vertex; where roundings do not tell, as for a point in the plane, some microseconds,
///         less for triangles
/// source  Sutherland, Sproull and Schumacker 1974 (Newell's normal)
template <PolygonRing R, HomogeneousPoint Q>
  requires(size_of<ring_point<R>> == 3 && size_of<Q> == 4 && Floating<scalar_of<Q>> &&
           std::same_as<scalar_of<ring_point<R>>, scalar_of<Q>>)
constexpr plane_side side_of_polygon(const R& polygon, const Q& q) noexcept {
  using T = scalar_of<Q>;
  const auto position = [&](std::size_t k) {
    const auto p = ring_vertex(polygon, k);
    return std::array<T, 3>{coordinate(p, 0), coordinate(p, 1), coordinate(p, 2)};
  };
  return static_cast<plane_side>(detail::face_volume_sign(
      ring_size(polygon), position,
      std::array<T, 4>{coordinate(q, 0), coordinate(q, 1), coordinate(q, 2), coordinate(q, 3)}));
}

}  // namespace IRG_ABI
}  // namespace irg
