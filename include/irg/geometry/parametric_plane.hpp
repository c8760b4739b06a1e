// SPDX-License-Identifier: MIT
// parametric_plane<T>: the points origin + s1*first + s2*second, made as both texts make it, its matrices, and the
// ways to the implicit plane and back.
#pragma once

#include <array>
#include <optional>

#include <irg/geometry/plane_through_points.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/exact/values_of.hpp>
#include <irg/math/mat.hpp>

namespace irg {

/// The points origin + s1*first + s2*second.
template <Scalar T>
struct parametric_plane {
  vec<T, 3> first{}, second{};
  point<T, 3> origin{};
  bool operator==(const parametric_plane&) const = default;
};

/// The parameters of a point of a plane.
template <Scalar T>
struct plane_parameters {
  T s1{}, s2{};
  bool operator==(const plane_parameters&) const = default;
};

namespace detail::inline IRG_ABI {

/// The cross product of the two directions of a parametric plane, exactly zero or not.
template <class T>
constexpr auto directions_normal(const parametric_plane<T>& p) noexcept {
  return values_of<2>([](const auto& a, const auto& b) { return cross(a, b); }, p.first, p.second);
}

template <Point P>
constexpr bool spans_plane(const P& a, const P& b, const P& c) noexcept {
  const auto normal =
      values_of<2>([](const auto& p, const auto& q, const auto& r) { return cross(q - p, r - p); }, a, b, c);
  return normal && !is_zero(*normal);
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The plane with v1 at (0, 0), v2 at (1, 0) and v3 at (0, 1): directions v2 - v1 and v3 - v1.
/// gives   nothing when the points lie exactly on a line, or a coordinate is NaN or infinite
/// exact   each difference rounded once; whether the points are collinear, exactly
/// source  Mihajlovic 2016, 4.5 to 4.8
template <Point P>
  requires(size_of<P> == 3)
[[nodiscard]] constexpr std::optional<parametric_plane<scalar_of<P>>> parametric_plane_through(const P& v1, const P& v2,
                                                                                               const P& v3) noexcept {
  using T = scalar_of<P>;
  if (!detail::spans_plane(v1, v2, v3)) return std::nullopt;
  return parametric_plane<T>{detail::displacement<T>(v1, v2), detail::displacement<T>(v1, v3), detail::as_point<T>(v1)};
}

/// The matrix of the columns first, second and origin: the point at (s1, s2) is the matrix times (s1, s2, 1).
/// source  Hank n.d., 1.3.2
template <class T>
[[nodiscard]] constexpr mat<T, 3, 3> columns_of(const parametric_plane<T>& p) noexcept {
  mat<T, 3, 3> m;
  for (int i = 0; i < 3; ++i) m(i, 0) = p.first[i];
  for (int i = 0; i < 3; ++i) m(i, 1) = p.second[i];
  for (int i = 0; i < 3; ++i) m(i, 2) = p.origin[i];
  return m;
}

/// The characteristic matrix K with [x y z h] = [u w 1] K: its rows are the two directions, of weight 0, and the
/// origin, of weight 1.
/// source  Mihajlovic 2016, 4.5 to 4.8
template <class T>
[[nodiscard]] constexpr mat<T, 3, 4> characteristic_matrix(const parametric_plane<T>& p) noexcept {
  mat<T, 3, 4> k;
  for (int i = 0; i < 3; ++i) k(0, i) = p.first[i];
  for (int i = 0; i < 3; ++i) k(1, i) = p.second[i];
  for (int i = 0; i < 3; ++i) k(2, i) = p.origin[i];
  k(0, 3) = T(0), k(1, 3) = T(0), k(2, 3) = T(1);
  return k;
}

/// The point at (s1, s2).
/// exact   products and sums rounded once each, origin last
template <class T>
[[nodiscard]] constexpr point<T, 3> point_at(const parametric_plane<T>& p, std::type_identity_t<T> s1,
                                             std::type_identity_t<T> s2) noexcept {
  return p.origin + (p.first * s1 + p.second * s2);
}

/// The implicit form: normal first x second.
/// gives   nothing when the directions are dependent, or a number is NaN or infinite
/// exact   as plane_through_accurate, for the directions as they are
template <class T>
[[nodiscard]] constexpr std::optional<plane<T>> implicit_plane_of(const parametric_plane<T>& p) noexcept {
  return detail::plane_of_values<T>(values_of<3>(
      [](const auto& a, const auto& b, const auto& origin) {
        const auto n = cross(a, b);
        return std::array{n.x, n.y, n.z, -dot(n, to_vec(origin))};
      },
      p.first, p.second, p.origin));
}

/// A parametric form of a plane: the origin is where it meets the axis nearest to its normal, the directions are made
/// of the coefficients, so that only the origin is rounded.
/// shape   first x second points to the plane's upper side
/// gives   nothing when the normal is zero, or a coefficient is NaN or infinite
template <Plane P>
  requires Real<plane_scalar<P>>
[[nodiscard]] constexpr std::optional<parametric_plane<plane_scalar<P>>> parametric_plane_of(const P& p) noexcept {
  using T = plane_scalar<P>;
  const vec<T, 3> n = normal_of(p);
  const auto size = [&](int i) { return n[i] < T(0) ? -n[i] : n[i]; };
  const int k = size(0) < size(1) ? (size(1) < size(2) ? 2 : 1) : (size(0) < size(2) ? 2 : 0);
  if (detail::is_zero(n) || !is_finite(detail::as_plane(p))) return std::nullopt;
  const int i = (k + 1) % 3, j = (k + 2) % 3;
  parametric_plane<T> q{{T(0), T(0), T(0)}, {T(0), T(0), T(0)}, {T(0), T(0), T(0)}};
  q.first[i] = n[k], q.first[k] = -n[i];
  q.second[j] = n[k], q.second[k] = -n[j];
  if (n[k] < T(0)) {
    const vec<T, 3> swapped = q.first;
    q.first = q.second, q.second = swapped;
  }
  q.origin[k] = -plane_coefficient(p, 3) / n[k];
  return q;
}

/// The parameters of the point of the plane that is nearest to q: of q itself where it lies on the plane.
/// gives   nothing when the directions are dependent, or a number is NaN or infinite
/// exact   both within 0.501 ulp, for the directions as they are
template <Real T, Point P>
  requires(size_of<P> == 3 && std::same_as<scalar_of<P>, T>)
[[nodiscard]] constexpr std::optional<plane_parameters<T>> parameters_of(const parametric_plane<T>& p,
                                                                         const P& q) noexcept {
  const auto v = values_of<4>(
      [](const auto& a, const auto& b, const auto& origin, const auto& at) {
        const auto n = cross(a, b), w = at - origin;
        return vec{dot(n, n), dot(cross(w, b), n), dot(cross(a, w), n)};
      },
      p.first, p.second, p.origin, q);
  if (!v || detail::is_zero(v->x)) return std::nullopt;
  return plane_parameters<T>{rounded_to<T>(v->y / v->x), rounded_to<T>(v->z / v->x)};
}

/// Whether the point at these parameters lies in the triangle of the origin and the ends of both directions: none is
/// negative and their sum is at most 1, decided exactly.
/// gives   false when one is NaN
template <Real T>
[[nodiscard]] constexpr bool in_triangle(const plane_parameters<T>& s) noexcept {
  if (!(s.s1 == s.s1 && s.s2 == s.s2) || s.s1 < T(0) || s.s2 < T(0) || T(1) < s.s1 || T(1) < s.s2) return false;
  if constexpr (Floating<T>) {
    const auto sum = two_sum(s.s1, s.s2);
    return sum.value < 1 || (sum.value == 1 && sum.error <= 0);
  } else {
    return !(T(1) < s.s1 + s.s2);
  }
}

IRG_REFUSES_VECTORS(parametric_plane_through);

}  // namespace IRG_ABI
}  // namespace irg
