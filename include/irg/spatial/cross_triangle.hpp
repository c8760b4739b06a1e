// SPDX-License-Identifier: MIT
// Where a ray crosses a triangle. Whether it does is decided exactly, and so that triangles which share a side or a
// corner share out the rays through it: of a closed surface none gets through, and none is stopped twice.
//
// The origin stands as if it had been moved by an infinitely small e along x, e^2 along y and e^3 along z. The moved
// ray meets no side and no corner, so each side turns round it one way or the other: where d . (A x B), with A and B
// the side's ends seen from the origin, is zero, the sign of the first coordinate of d x (b - a) that is not zero
// decides. A side along the ray is a point as seen along it: its triangle has no area there, and is not crossed.
// Crossings at exactly t = low or t = high are decided by the moved origin, too, so that of two rays which share an end
// on a surface exactly one crosses it.
#pragma once

#include <array>
#include <concepts>
#include <optional>

#include <irg/geometry/ray.hpp>
#include <irg/spatial/bvh_node.hpp>
#if IRG_BODIES
#include <irg/core/lanes.hpp>
#include <irg/core/vocabulary.hpp>
#include <irg/math/exact/quotients_of.hpp>
#include <irg/math/exact/sign_of.hpp>
#include <irg/spatial/detail/ray_shear.hpp>
#endif

namespace irg::inline IRG_COMPILED_ABI {

/// Where the ray crosses the triangle abc.
/// needs   finite corners
/// gives   nothing where it passes by, for an empty ray and for a triangle without area as seen along the ray; of the
///         triangles of a surface that share a side or a corner on the ray, as many as if ray and surface were in
///         general position
/// exact   whether there is a crossing, on which side, and whether before low or after high, for all finite floats and
///         doubles. With m the largest coordinate of a corner seen from the origin, t is off by less than 2^-33 m over
///         the largest coordinate of the direction, and correctly rounded where the triangle is seen at less than
///         2^-16; weights are off by 2^-45 m^2 over the area seen, and correctly rounded where that is below 2^-40 m^2
/// cost    some 80 operations on doubles; microseconds where the ray passes within rounding errors of a side, and where
///         numbers are beyond 2^250
/// source  Woop, Benthin and Wald 2013 (the shear); Edelsbrunner and Muecke 1990 (the moved origin)
template <Floating T>
[[nodiscard]] IRG_API std::optional<ray_crossing> intersect_triangle(const ray<T, 3>& r, const point<T, 3>& a,
                                                                     const point<T, 3>& b,
                                                                     const point<T, 3>& c) noexcept;

}  // namespace irg::inline IRG_COMPILED_ABI

namespace irg::inline IRG_ABI {

IRG_RENAMED(cross_triangle, intersect_triangle)

}  // namespace irg::inline IRG_ABI

#if IRG_BODIES
namespace irg {

namespace detail {

// A ray made ready for triangles, in doubles. Functions of it are templates, so that including them instantiates
// nothing.
struct triangle_ray {
  ray<double, 3> r;
  ray_shear shear;
  double reach;  // the largest coordinate of the direction
};

inline namespace IRG_ABI {

/// needs   a ray that is not empty
template <Floating T>
IRG_INLINE constexpr void set_triangle_ray(triangle_ray& q, const ray<T, 3>& r) noexcept {
  for (int i = 0; i < 3; ++i) {
    q.r.origin[i] = exactly_widened(r.origin[i]);
    q.r.direction[i] = exactly_widened(r.direction[i]);
  }
  q.r.low = r.low < T(0) ? 0.0 : exactly_widened(r.low);
  q.r.high = exactly_widened(r.high);
  set_shear(q.shear, q.r);
  q.reach = magnitude(q.r.direction[q.shear.z]);
}

// The same, of a type that depends on T: what a template does with it is not instantiated before the template is.
template <Floating T>
IRG_INLINE constexpr triangle_ray made_ready(const ray<T, 3>& r) noexcept {
  triangle_ray q;
  set_triangle_ray(q, r);
  return q;
}

IRG_INLINE constexpr std::array<double, 15> gathered_doubles(const ray<double, 3>& r, const space_point& a,
                                                             const space_point& b, const space_point& c) noexcept {
  const vec<double, 3>& d = r.direction;
  return {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, r.origin.x, r.origin.y, r.origin.z, d.x, d.y, d.z};
}

// The polynomials. x holds a, b, c, the origin and the direction.
template <class X>
constexpr auto coordinate_of_cross(const X& x, std::size_t i) noexcept {  // of (b - a) x (c - a)
  const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
  return (x[3 + j] - x[j]) * (x[6 + k] - x[k]) - (x[3 + k] - x[k]) * (x[6 + j] - x[j]);
}
template <class X>
constexpr auto height_along(const X& x) noexcept {  // of a over the origin, along the normal
  return coordinate_of_cross(x, 0) * (x[0] - x[9]) + coordinate_of_cross(x, 1) * (x[1] - x[10]) +
         coordinate_of_cross(x, 2) * (x[2] - x[11]);
}
template <class X>
constexpr auto advance_along(const X& x) noexcept {  // of the ray while t grows by 1
  return coordinate_of_cross(x, 0) * x[12] + coordinate_of_cross(x, 1) * x[13] + coordinate_of_cross(x, 2) * x[14];
}
template <class X>
constexpr auto side_round_ray(const X& x, std::size_t from, std::size_t to) noexcept {
  const auto term = [&](std::size_t i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    return ((x[from + j] - x[9 + j]) * (x[to + k] - x[9 + k]) - (x[from + k] - x[9 + k]) * (x[to + j] - x[9 + j])) *
           x[12 + i];
  };
  return term(0) + term(1) + term(2);
}

// How the side from a to b turns round the moved ray; 0 where it is along the ray.
IRG_NOINLINE constexpr int exact_side(const std::same_as<ray<double, 3>> auto& r, const space_point& a,
                                      const space_point& b) noexcept {
  const std::array<double, 15> in = gathered_doubles(r, a, b, b);
  int sign = irg::sign_of<3>([](const auto& x) { return side_round_ray(x, 0, 3); }, in);
  for (std::size_t i = 0; sign == 0 && i < 3; ++i)
    sign = irg::sign_of<2>(
        [i](const auto& x) {
          const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
          return x[12 + j] * (x[3 + k] - x[k]) - x[12 + k] * (x[3 + j] - x[j]);
        },
        in);
  return sign;
}

// The sign of t - limit for a crossing from the front or the back, of the moved ray.
IRG_NOINLINE constexpr int exact_order(const std::same_as<ray<double, 3>> auto& r, const space_point& a,
                                       const space_point& b, const space_point& c, int along, double limit) noexcept {
  const std::array<double, 15> in = gathered_doubles(r, a, b, c);
  std::array<double, 16> with_limit{};
  for (std::size_t i = 0; i < 15; ++i) with_limit[i] = in[i];
  with_limit[15] = limit;
  if (const int sign =
          irg::sign_of<4>([](const auto& x) { return height_along(x) - advance_along(x) * x[15]; }, with_limit);
      sign != 0)
    return along * sign;
  for (std::size_t i = 0; i < 3; ++i)
    if (const int sign = irg::sign_of<2>([i](const auto& x) { return coordinate_of_cross(x, i); }, in); sign != 0)
      return -along * sign;
  return 0;
}

// t and what it may be off by. Where the triangle is seen at more than 2^-16, doubles do: a coordinate of the normal is
// off by 3u times its two products, so height and advance are off by 8u and 6u times the sum of all six products, times
// m and `reach`, the largest coordinates from origin to corners and of the direction. With the advance at least 2^-16
// of the latter t is off by less than 2^-33 m / reach.
struct crossing_time {
  double t, error;
};

IRG_INLINE constexpr double sum_of_sizes(double a, double b) noexcept { return magnitude(a) + magnitude(b); }

IRG_INLINE constexpr crossing_time time_of_crossing(const std::same_as<triangle_ray> auto& q, const space_point& a,
                                                    const space_point& b, const space_point& c, double m) noexcept {
  constexpr double largest = 0x1p250, least = 0x1p-700, grazing = 0x1p-16, error = 0x1p-28;
  const double off = error * m / q.reach;
  if (m < largest && q.reach < largest) {
    const vec<double, 3> u = b - a, v = c - a, h = a - q.r.origin, &d = q.r.direction;
    const double x0 = product(u.y, v.z), x1 = product(u.z, v.y), y0 = product(u.z, v.x), y1 = product(u.x, v.z);
    const double z0 = product(u.x, v.y), z1 = product(u.y, v.x);
    const double x = x0 - x1, y = y0 - y1, z = z0 - z1;
    const double advance = (product(x, d.x) + product(y, d.y)) + product(z, d.z);
    const double size = (sum_of_sizes(x0, x1) + sum_of_sizes(y0, y1) + sum_of_sizes(z0, z1)) * q.reach;
    if (size > least && magnitude(advance) >= size * grazing)
      return {((product(x, h.x) + product(y, h.y)) + product(z, h.z)) / advance, off};
  }
  const auto t = quotient_of<3>([](const auto& in) { return std::array{advance_along(in), height_along(in)}; },
                                gathered_doubles(q.r, a, b, c));
  return {t ? *t : 0.0, off};
}

// The largest coordinate of the corners as seen from the origin.
IRG_INLINE constexpr double largest_from(const space_point& o, const space_point& a, const space_point& b,
                                         const space_point& c) noexcept {
  double m = 0;
  for (const space_point* p : {&a, &b, &c})
    for (int i = 0; i < 3; ++i) m = maximum(m, magnitude((*p)[i] - o[i]));
  return m;
}

IRG_INLINE constexpr sheared_sides<double> sides_round(const triangle_ray& q, const space_point& a,
                                                       const space_point& b, const space_point& c) noexcept {
  const ray_shear& s = q.shear;
  const double corners[3][3] = {{a[s.x], a[s.y], a[s.z]}, {b[s.x], b[s.y], b[s.z]}, {c[s.x], c[s.y], c[s.z]}};
  return sides_of(corners_along<double>(s.origin, s.slope_x, s.slope_y, corners));
}

// 1 where all sides turn counter-clockwise round the moved ray, as seen along it: it comes from the back. -1 where all
// turn clockwise, 0 where the ray passes by.
constexpr int turn_of_sides(const std::same_as<triangle_ray> auto& q, const space_point& a, const space_point& b,
                            const space_point& c, const sheared_sides<double>& sides, double bound) noexcept {
  const auto sure = [bound](double side) { return side > bound ? 1 : -side > bound ? -1 : 0; };
  int ab = sure(sides.ab), bc = sure(sides.bc), ca = sure(sides.ca);
  const bool left = ab > 0 || bc > 0 || ca > 0, right = ab < 0 || bc < 0 || ca < 0;
  if (left && right) return 0;
  if (ab == 0) ab = exact_side(q.r, a, b);
  if (bc == 0) bc = exact_side(q.r, b, c);
  if (ca == 0) ca = exact_side(q.r, c, a);
  return ab == bc && bc == ca ? ab : 0;
}

// The weights of b and c. Sides are off by 65u m^2: where their sum is at least 2^-40 of m^2 they are good for that.
constexpr void set_weights(ray_crossing& x, const std::same_as<triangle_ray> auto& q, const space_point& a,
                           const space_point& b, const space_point& c, const sheared_sides<double>& sides,
                           double m) noexcept {
  constexpr double largest = 0x1p250, least = 0x1p-250, share = 0x1p-40;
  const double whole = (sides.ab + sides.bc) + sides.ca;
  if (least < m && m < largest && magnitude(whole) >= m * m * share) {
    x.weight_b = clamped(sides.ca / whole, 0.0, 1.0);
    x.weight_c = clamped(sides.ab / whole, 0.0, 1.0 - x.weight_b);
    return;
  }
  const std::array<double, 15> in = gathered_doubles(q.r, a, b, c);
  const auto weight = [&](std::size_t from, std::size_t to) {
    const auto w =
        quotient_of<3>([=](const auto& v) { return std::array{advance_along(v), side_round_ray(v, from, to)}; }, in);
    return w ? *w : 0.0;
  };
  x.weight_b = weight(6, 0);
  x.weight_c = clamped(weight(0, 3), 0.0, 1.0 - x.weight_b);
}

struct timed_crossing {
  bool hit = false;
  int turn = 0;
  crossing_time time{};
};

// Whether the moved ray crosses the triangle between low and high, and where.
IRG_INLINE constexpr timed_crossing cross_in_time(const std::same_as<triangle_ray> auto& q, const space_point& a,
                                                  const space_point& b, const space_point& c,
                                                  const sheared_sides<double>& sides, double m) noexcept {
  constexpr double largest = 0x1p250;
  const double bound = m < largest ? side_bound(m) : std::numeric_limits<double>::infinity();
  const int turn = turn_of_sides(q, a, b, c, sides, bound);
  if (turn == 0) return {};
  const crossing_time time = time_of_crossing(q, a, b, c, m);
  // 1 and -1 where t is after and before a limit, beyond its error.
  const auto sure = [&time](double limit) {
    const double after = time.t - limit;
    return after > time.error ? 1 : -after > time.error ? -1 : 0;
  };
  int order = sure(q.r.low);
  if (order == 0) order = exact_order(q.r, a, b, c, turn, q.r.low);
  if (order < 0) return {};
  if (q.r.high <= (std::numeric_limits<double>::max)()) {
    order = sure(q.r.high);
    if (order == 0) order = exact_order(q.r, a, b, c, turn, q.r.high);
    if (order > 0) return {};
  }
  return {true, turn, time};
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API std::optional<ray_crossing> intersect_triangle(const ray<T, 3>& r, const point<T, 3>& a,
                                                                     const point<T, 3>& b,
                                                                     const point<T, 3>& c) noexcept {
  if (r.empty()) return std::nullopt;
  const auto q = detail::made_ready(r);
  const detail::space_point p[3] = {detail::exactly_widened(a), detail::exactly_widened(b), detail::exactly_widened(c)};
  const double m = detail::largest_from(q.r.origin, p[0], p[1], p[2]);
  const auto sides = detail::sides_round(q, p[0], p[1], p[2]);
  const detail::timed_crossing found = detail::cross_in_time(q, p[0], p[1], p[2], sides, m);
  if (!found.hit) return std::nullopt;
  ray_crossing x{found.turn < 0 ? facing::front : facing::back, found.time.t, 0, 0};
  detail::set_weights(x, q, p[0], p[1], p[2], sides, m);
  return x;
}

}  // namespace IRG_COMPILED_ABI
}  // namespace irg
#endif
