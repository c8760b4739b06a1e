// SPDX-License-Identifier: MIT
// Planes through three points with coefficients right to the last bit, through homogeneous points, and through a point
// at right angles to a vector. plane_through and newell_plane (plane.hpp) are the plain formulas.
#pragma once

#include <array>
#include <optional>

#include <irg/geometry/detail/exact_forms.hpp>
#include <irg/geometry/plane.hpp>
#include <irg/math/exact/values_of.hpp>

namespace irg {
namespace detail::inline IRG_ABI {

/// The minors of the rows p, q, r that are the plane's coefficients.
template <class N>
constexpr std::array<N, 4> plane_minors(const hpoint<N, 3>& p, const hpoint<N, 3>& q, const hpoint<N, 3>& r) noexcept {
  const auto det = [&](int i, int j, int k) {
    return p[i] * (q[j] * r[k] - q[k] * r[j]) - p[j] * (q[i] * r[k] - q[k] * r[i]) + p[k] * (q[i] * r[j] - q[j] * r[i]);
  };
  return {det(1, 2, 3), -det(0, 2, 3), det(0, 1, 3), -det(0, 1, 2)};
}

/// The four coefficients of the plane through three homogeneous points.
template <HomogeneousPoint P>
constexpr auto homogeneous_plane(const P& p, const P& q, const P& r) noexcept {
  const auto own = [](const P& x) {
    return generate_coordinates<hpoint<scalar_of<P>, 3>>([&](int i) { return coordinate(x, i); });
  };
  return values_of<3>([](const auto& a, const auto& b, const auto& c) { return plane_minors(a, b, c); }, own(p), own(q),
                      own(r));
}

template <class T, class V>
constexpr std::optional<plane<T>> plane_of_values(const std::optional<std::array<V, 4>>& v) noexcept {
  if (!v || is_zero(vec<V, 3>{(*v)[0], (*v)[1], (*v)[2]})) return std::nullopt;
  const auto c = rounded_together<T, 3>(*v);
  return plane<T>{c[0], c[1], c[2], c[3]};
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The plane through three points, from whose upper side they are seen counter-clockwise; its normal is as long as
/// twice the triangle's area.
/// gives   nothing when the points lie exactly on a line, or a coordinate is NaN or infinite; every other triangle has
///         its plane, however slender
/// exact   each coefficient within 0.501 ulp; all four are multiplied by one
///         power of two where they are beyond the range or too small for it
/// cost    some 200 ns; about 4 us near a degenerate case. plane_through takes 5 ns
/// source  Mihajlovic 2016, formulas 4.1 and 4.4
template <Point P = point<double, 3>>
  requires(size_of<P> == 3)
[[nodiscard]] constexpr std::optional<plane<scalar_of<P>>> plane_through_accurate(const P& p1, const P& p2,
                                                                                  const P& p3) noexcept {
  using T = scalar_of<P>;
  return detail::plane_of_values<T>(values_of<3>(
      [](const auto& p, const auto& q, const auto& r) {
        const auto n = cross(q - p, r - p);
        using N = decltype(n.x);
        return std::array<N, 4>{n.x, n.y, n.z, static_cast<N>(-dot(n, to_vec(p)))};
      },
      p1, p2, p3));
}

/// The plane through three homogeneous points: the minors of the matrix of their coordinates. Points of weight 1 give
/// plane_through's; a negative weight turns the sides round.
/// gives   nothing when the points do not span a plane (equal, proportional or collinear), when all three are at
///         infinity, and when a coordinate is NaN or infinite
/// exact   as plane_through_accurate
/// source  Mihajlovic 2016, the general case of formula 4.3, planes through the origin included
template <HomogeneousPoint P>
  requires(size_of<P> == 4)
[[nodiscard]] constexpr std::optional<plane<scalar_of<P>>> plane_through(const P& p1, const P& p2,
                                                                         const P& p3) noexcept {
  return detail::plane_of_values<scalar_of<P>>(detail::homogeneous_plane(p1, p2, p3));
}

/// The plane through p at right angles to `normal`, which becomes its vector (a, b, c).
/// gives   nothing when the normal is zero, or a number is NaN or infinite
/// exact   d within 0.501 ulp
template <Point P, Vector V>
  requires(size_of<P> == 3 && size_of<V> == 3 && std::same_as<scalar_of<P>, scalar_of<V>>)
[[nodiscard]] constexpr std::optional<plane<scalar_of<P>>> plane_at(const P& p, const V& normal) noexcept {
  using T = scalar_of<P>;
  const vec<T, 3> n{coordinate(normal, 0), coordinate(normal, 1), coordinate(normal, 2)};
  if (detail::is_zero(n)) return std::nullopt;
  const auto d = values_of<2>([](const auto& at, const auto& v) { return -dot(to_vec(at), v); }, p, n);
  if (!d) return std::nullopt;
  return plane<T>{n.x, n.y, n.z, rounded_to<T>(*d)};
}

IRG_REFUSES_VECTORS(plane_through_accurate);

}  // namespace IRG_ABI
}  // namespace irg
