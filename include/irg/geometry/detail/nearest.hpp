// SPDX-License-Identifier: MIT
// Squared distances and nearest points as exact quotients: what closest_point.hpp and distance.hpp are made of.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <tuple>

#include <irg/geometry/detail/exact_forms.hpp>
#include <irg/math/exact/values_of.hpp>

namespace irg::detail {

/// Where the foot of the perpendicular from p lies on the way from a to b: length^2, t times it, and what that lacks.
template <class V>
struct line_foot {
  V divisor{}, t{}, rest{};
};

/// The region of a triangle that a point is nearest to, and the weights of the three corners times the divisor.
template <class V>
struct triangle_foot {
  int region = 0;  // as in triangle_region
  std::array<V, 3> weight{};
  V divisor{};
};

inline namespace IRG_ABI {

template <Point P>
constexpr auto squared_distance(const P& p, const P& q) noexcept {
  return values_of<2>([](const auto& a, const auto& b) { return squared(b - a); }, p, q);
}

/// |(b - a) x (p - a)|^2 and |b - a|^2, whose quotient is the squared distance from the line.
template <Point P>
constexpr auto squared_from_line(const P& a, const P& b, const P& p) noexcept {
  return values_of<4>(
      [](const auto& from, const auto& to, const auto& at) {
        const auto u = to - from;
        return std::array{squared(cross(u, at - from)), dot(u, u)};
      },
      a, b, p);
}

template <Point P>
constexpr auto foot_on_line(const P& a, const P& b, const P& p) noexcept {
  const auto v = values_of<2>(
      [](const auto& from, const auto& to, const auto& at) {
        const auto u = to - from;
        const auto t = dot(u, at - from), divisor = dot(u, u);
        return std::array{divisor, t, divisor - t};
      },
      a, b, p);
  using foot = line_foot<known_value<scalar_of<P>>>;
  return v ? std::optional(foot{(*v)[0], (*v)[1], (*v)[2]}) : std::optional<foot>();
}

/// The point a + t (b - a), t being the foot's.
template <Point P>
constexpr P point_of_foot(const P& a, const P& b, const P& p) noexcept {
  const auto [divisor, foot] = *values_of<3>(
      [](const auto& from, const auto& to, const auto& at) {
        const auto u = to - from;
        const auto whole = dot(u, u);
        return std::tuple{whole, to_vec(from) * whole + u * dot(u, at - from)};
      },
      a, b, p);
  return rounded_coordinates<P>(foot / divisor);
}

/// The squared distance from the segment ab.
/// needs   finite points
template <Point P>
constexpr auto squared_from_segment(const P& a, const P& b, const P& p) noexcept {
  const auto foot = foot_on_line(a, b, p);
  if (sign_of(foot->t) <= 0) return *squared_distance(a, p);
  if (sign_of(foot->rest) <= 0) return *squared_distance(b, p);
  const auto v = *squared_from_line(a, b, p);
  return v[0] / v[1];
}

/// The region of the triangle nearest to p, by the signs that Ericson's algorithm decides it with.
/// source  Ericson 2004, 5.1.5; edges of no length are passed over
template <Point P>
constexpr auto foot_on_triangle(const P& a, const P& b, const P& c, const P& p) noexcept {
  const auto v = values_of<4>(
      [](const auto& from, const auto& second, const auto& third, const auto& at) {
        const auto ab = second - from, ac = third - from, ap = at - from, bp = ap - ab, cp = ap - ac;
        const auto d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp), d4 = dot(ac, bp);
        const auto d5 = dot(ab, cp), d6 = dot(ac, cp);
        const auto va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
        return std::array{d1,          d2, d3,      d4,      d5,      d6,      va,
                          vb,          vc, d4 - d3, d5 - d6, d1 - d3, d2 - d6, (d4 - d3) + (d5 - d6),
                          va + vb + vc};
      },
      a, b, c, p);
  using V = known_value<scalar_of<P>>;
  using foot_type = triangle_foot<V>;
  if (!v) return std::optional<foot_type>();
  const auto& x = *v;
  std::array<int, 15> s{};
  for (std::size_t i = 0; i < 15; ++i) s[i] = sign_of(x[i]);
  const V zero{};
  const auto along = [&](int region, std::size_t from, std::size_t to, const V& part, const V& rest, const V& whole) {
    foot_type foot{region, {zero, zero, zero}, whole};
    foot.weight[from] = rest, foot.weight[to] = part;
    return std::optional(foot);
  };
  if (s[0] <= 0 && s[1] <= 0) return std::optional(foot_type{1, {}, {}});
  if (s[2] >= 0 && s[9] <= 0) return std::optional(foot_type{2, {}, {}});
  if (s[5] >= 0 && s[10] <= 0) return std::optional(foot_type{3, {}, {}});
  if (s[8] <= 0 && s[0] >= 0 && s[2] <= 0 && s[11] > 0) return along(4, 0, 1, x[0], -x[2], x[11]);
  if (s[7] <= 0 && s[1] >= 0 && s[5] <= 0 && s[12] > 0) return along(6, 0, 2, x[1], -x[5], x[12]);
  if (s[6] <= 0 && s[9] >= 0 && s[10] >= 0 && s[13] > 0) return along(5, 1, 2, x[9], x[10], x[13]);
  return std::optional(foot_type{0, {x[6], x[7], x[8]}, x[14]});
}

/// The foot of the perpendicular from p on the plane abc.
/// needs   a triangle that is not degenerate
template <Point P>
constexpr P foot_on_face(const P& a, const P& b, const P& c, const P& p) noexcept {
  const auto [divisor, foot] = *values_of<5>(
      [](const auto& from, const auto& second, const auto& third, const auto& at) {
        const auto n = cross(second - from, third - from);
        const auto whole = dot(n, n);
        return std::tuple{whole, to_vec(at) * whole - n * dot(n, at - from)};
      },
      a, b, c, p);
  return rounded_coordinates<P>(foot / divisor);
}

/// Which end of two segments without common points is nearest to the other one: 0 to 3 for a, b, c, d.
/// needs   finite points
template <Point P>
constexpr int nearest_end(const P& a, const P& b, const P& c, const P& d) noexcept {
  const std::array squared{squared_from_segment(c, d, a), squared_from_segment(c, d, b), squared_from_segment(a, b, c),
                           squared_from_segment(a, b, d)};
  int nearest = 0;
  for (int i = 1; i < 4; ++i)
    if (sign_of(squared[static_cast<std::size_t>(i)] - squared[static_cast<std::size_t>(nearest)]) < 0) nearest = i;
  return nearest;
}

// With u and v the ways along two lines of space, w = c - a and the normal n = u x v: n.n, and n.n times the parameters
// of the points that are nearest to each other.
template <class N>
struct lines_feet {
  vec<N, 3> u, v, w, n = cross(u, v);
  N divisor = dot(n, n), t = dot(cross(w, v), n), s = dot(cross(w, u), n);
};
template <class N>
constexpr lines_feet<N> feet_on_lines(const vec<N, 3>& u, const vec<N, 3>& v, const vec<N, 3>& w) noexcept {
  return {u, v, w};
}

/// How two lines of space lie: n.n and n.w, and the parameters of the nearest points times n.n with what they lack of
/// it.
template <Point P>
constexpr auto nearest_on_lines(const P& a, const P& b, const P& c, const P& d) noexcept {
  return values_of<4>(
      [](const auto& from, const auto& to, const auto& other, const auto& end) {
        const auto f = feet_on_lines(to - from, end - other, other - from);
        return std::array{f.divisor, dot(f.n, f.w), f.t, f.divisor - f.t, f.s, f.divisor - f.s};
      },
      a, b, c, d);
}

/// The two nearest points on crossing or skew lines.
template <Point P>
constexpr std::array<P, 2> points_on_lines(const P& a, const P& b, const P& c, const P& d) noexcept {
  const auto [divisor, first, second] = *values_of<5>(
      [](const auto& from, const auto& to, const auto& other, const auto& end) {
        const auto f = feet_on_lines(to - from, end - other, other - from);
        return std::tuple{f.divisor, to_vec(from) * f.divisor + f.u * f.t, to_vec(other) * f.divisor + f.v * f.s};
      },
      a, b, c, d);
  return {rounded_coordinates<P>(first / divisor), rounded_coordinates<P>(second / divisor)};
}

}  // namespace IRG_ABI
}  // namespace irg::detail
