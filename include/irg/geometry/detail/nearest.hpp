// SPDX-License-Identifier: MIT
// Squared distances and nearest points as exact quotients: what closest_point.hpp and distance.hpp are made of.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include <irg/geometry/detail/formula.hpp>

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
  constexpr std::size_t D = static_cast<std::size_t>(size_of<P>);
  return evaluate<2>(
      [](const auto& x) {
        const auto d = difference_of(part_of<D>(x, D), part_of<D>(x, 0));
        return std::array{dot_of(d, d)};
      },
      gathered<scalar_of<P>>(p, q));
}

/// |(b - a) x (p - a)|^2 and |b - a|^2, whose quotient is the squared distance from the line.
template <Point P>
constexpr auto squared_from_line(const P& a, const P& b, const P& p) noexcept {
  constexpr std::size_t D = static_cast<std::size_t>(size_of<P>);
  return evaluate<4>(
      [](const auto& x) {
        const auto from = part_of<D>(x, 0), u = difference_of(part_of<D>(x, D), from);
        const auto across = cross_of(u, difference_of(part_of<D>(x, 2 * D), from));
        return std::array{dot_of(across, across), dot_of(u, u)};
      },
      gathered<scalar_of<P>>(a, b, p));
}

template <Point P>
constexpr auto foot_on_line(const P& a, const P& b, const P& p) noexcept {
  constexpr std::size_t D = static_cast<std::size_t>(size_of<P>);
  const auto v = evaluate<2>(
      [](const auto& x) {
        const auto from = part_of<D>(x, 0), u = difference_of(part_of<D>(x, D), from);
        const auto t = dot_of(u, difference_of(part_of<D>(x, 2 * D), from));
        const auto divisor = dot_of(u, u);
        return std::array{divisor, t, divisor - t};
      },
      gathered<scalar_of<P>>(a, b, p));
  using V = std::remove_cvref_t<decltype((*v)[0])>;
  if (!v) return std::optional<line_foot<V>>();
  return std::optional(line_foot<V>{(*v)[0], (*v)[1], (*v)[2]});
}

/// The point a + t (b - a), t being the foot's.
template <Point P>
constexpr P point_of_foot(const P& a, const P& b, const P& p) noexcept {
  constexpr std::size_t D = static_cast<std::size_t>(size_of<P>);
  const auto v = evaluate<3>(
      [](const auto& x) {
        using N = std::remove_cvref_t<decltype(x[0])>;
        const auto from = part_of<D>(x, 0), u = difference_of(part_of<D>(x, D), from);
        const auto t = dot_of(u, difference_of(part_of<D>(x, 2 * D), from)), divisor = dot_of(u, u);
        return joined(std::array<N, 1>{divisor}, sum_of(multiple_of(from, divisor), multiple_of(u, t)));
      },
      gathered<scalar_of<P>>(a, b, p));
  return coordinates_over<P>(*v, 1, (*v)[0]);
}

/// The squared distance from the segment ab.
/// needs   finite points
template <Point P>
constexpr auto squared_from_segment(const P& a, const P& b, const P& p) noexcept {
  const auto foot = foot_on_line(a, b, p);
  if (known_sign(foot->t) <= 0) return (*squared_distance(a, p))[0];
  if (known_sign(foot->rest) <= 0) return (*squared_distance(b, p))[0];
  const auto v = *squared_from_line(a, b, p);
  return v[0] / v[1];
}

/// The region of the triangle nearest to p, by the signs that Ericson's algorithm decides it with.
/// source  Ericson 2004, 5.1.5; edges of no length are passed over
template <Point P>
constexpr auto foot_on_triangle(const P& a, const P& b, const P& c, const P& p) noexcept {
  const auto v = evaluate<4>(
      [](const auto& x) {
        const auto from = part_of<3>(x, 0), ab = difference_of(part_of<3>(x, 3), from);
        const auto ac = difference_of(part_of<3>(x, 6), from);
        const auto ap = difference_of(part_of<3>(x, 9), from), bp = difference_of(ap, ab), cp = difference_of(ap, ac);
        const auto d1 = dot_of(ab, ap), d2 = dot_of(ac, ap), d3 = dot_of(ab, bp), d4 = dot_of(ac, bp);
        const auto d5 = dot_of(ab, cp), d6 = dot_of(ac, cp);
        const auto va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
        return std::array{d1,          d2, d3,      d4,      d5,      d6,      va,
                          vb,          vc, d4 - d3, d5 - d6, d1 - d3, d2 - d6, (d4 - d3) + (d5 - d6),
                          va + vb + vc};
      },
      gathered<scalar_of<P>>(a, b, c, p));
  using V = std::remove_cvref_t<decltype((*v)[0])>;
  using foot_type = triangle_foot<V>;
  if (!v) return std::optional<foot_type>();
  const auto& x = *v;
  std::array<int, 15> s{};
  for (std::size_t i = 0; i < 15; ++i) s[i] = known_sign(x[i]);
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
  const auto v = *evaluate<5>(
      [](const auto& x) {
        using N = std::remove_cvref_t<decltype(x[0])>;
        const auto from = part_of<3>(x, 0), at = part_of<3>(x, 9);
        const auto n = cross_of(difference_of(part_of<3>(x, 3), from), difference_of(part_of<3>(x, 6), from));
        const N divisor = dot_of(n, n), height = dot_of(n, difference_of(at, from));
        return joined(std::array<N, 1>{divisor}, difference_of(multiple_of(at, divisor), multiple_of(n, height)));
      },
      gathered<scalar_of<P>>(a, b, c, p));
  return coordinates_over<P>(v, 1, v[0]);
}

/// Which end of two segments without common points is nearest to the other one: 0 to 3 for a, b, c, d.
/// needs   finite points
template <Point P>
constexpr int nearest_end(const P& a, const P& b, const P& c, const P& d) noexcept {
  const std::array squared{squared_from_segment(c, d, a), squared_from_segment(c, d, b), squared_from_segment(a, b, c),
                           squared_from_segment(a, b, d)};
  int nearest = 0;
  for (int i = 1; i < 4; ++i)
    if (known_sign(squared[static_cast<std::size_t>(i)] - squared[static_cast<std::size_t>(nearest)]) < 0) nearest = i;
  return nearest;
}

/// How two lines of space lie: n.n and n.w of the normal n = u x v and w = c - a, and the parameters of the nearest
/// points times n.n with what they lack of it.
template <Point P>
constexpr auto nearest_on_lines(const P& a, const P& b, const P& c, const P& d) noexcept {
  return evaluate<4>(
      [](const auto& x) {
        const auto from = part_of<3>(x, 0), other = part_of<3>(x, 6), w = difference_of(other, from);
        const auto u = difference_of(part_of<3>(x, 3), from), v = difference_of(part_of<3>(x, 9), other);
        const auto n = cross_of(u, v);
        const auto divisor = dot_of(n, n), t = dot_of(cross_of(w, v), n), s = dot_of(cross_of(w, u), n);
        return std::array{divisor, dot_of(n, w), t, divisor - t, s, divisor - s};
      },
      gathered<scalar_of<P>>(a, b, c, d));
}

/// The two nearest points on crossing or skew lines.
template <Point P>
constexpr std::array<P, 2> points_on_lines(const P& a, const P& b, const P& c, const P& d) noexcept {
  const auto at = *evaluate<5>(
      [](const auto& x) {
        using N = std::remove_cvref_t<decltype(x[0])>;
        const auto from = part_of<3>(x, 0), other = part_of<3>(x, 6), w = difference_of(other, from);
        const auto u = difference_of(part_of<3>(x, 3), from), v = difference_of(part_of<3>(x, 9), other);
        const auto n = cross_of(u, v);
        const auto divisor = dot_of(n, n), t = dot_of(cross_of(w, v), n), s = dot_of(cross_of(w, u), n);
        return joined(joined(std::array<N, 1>{divisor}, sum_of(multiple_of(from, divisor), multiple_of(u, t))),
                      sum_of(multiple_of(other, divisor), multiple_of(v, s)));
      },
      gathered<scalar_of<P>>(a, b, c, d));
  return {coordinates_over<P>(at, 1, at[0]), coordinates_over<P>(at, 4, at[0])};
}

}  // namespace IRG_ABI
}  // namespace irg::detail
