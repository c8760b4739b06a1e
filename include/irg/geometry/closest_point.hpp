// SPDX-License-Identifier: MIT
// The nearest point of a line, segment, plane, triangle or box, and the nearest points of two lines or segments. Which
// part is nearest is decided exactly; points and parameters are right to the last bit or nearly so.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <tuple>

#include <irg/geometry/box.hpp>
#include <irg/geometry/detail/nearest.hpp>
#include <irg/geometry/intersect_segments.hpp>
#include <irg/geometry/plane.hpp>
#include <irg/math/exact/values_of.hpp>

namespace irg {

/// A point of a line or segment and its parameter.
template <Point P>
struct point_on_line {
  P at = zero_coordinates<P>();
  scalar_of<P> t{};
  IRG_APART constexpr bool operator==(const point_on_line& o) const { return same_place(at, o.at) && t == o.t; }
};

/// The part of a triangle abc that a point is nearest to.
enum class triangle_region { face, corner_a, corner_b, corner_c, edge_ab, edge_bc, edge_ca };

/// A point of a triangle abc, the part it lies on, and its barycentric coordinates.
template <Point P>
struct point_on_triangle {
  P at = zero_coordinates<P>();
  triangle_region region = triangle_region::face;
  std::array<scalar_of<P>, 3> weights{};
  IRG_APART constexpr bool operator==(const point_on_triangle& o) const {
    return same_place(at, o.at) && region == o.region && weights == o.weights;
  }
};

/// Points on two lines or segments, and their parameters there.
template <Point P>
struct point_pair {
  P first = zero_coordinates<P>(), second = zero_coordinates<P>();
  scalar_of<P> t{}, s{};
  IRG_APART constexpr bool operator==(const point_pair& o) const {
    return same_place(first, o.first) && same_place(second, o.second) && t == o.t && s == o.s;
  }
};

}  // namespace irg

namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T, int N>
IRG_API std::optional<point_on_line<point<T, N>>> nearest_on_line(const point<T, N>& a, const point<T, N>& b,
                                                                  const point<T, N>& p) noexcept;
template <Floating T, int N>
IRG_API std::optional<point_on_line<point<T, N>>> nearest_on_segment(const point<T, N>& a, const point<T, N>& b,
                                                                     const point<T, N>& p) noexcept;
template <Floating T>
IRG_API std::optional<point<T, 3>> nearest_on_plane(const plane<T>& l, const point<T, 3>& p) noexcept;
template <Floating T>
IRG_API std::optional<point_on_triangle<point<T, 3>>> nearest_on_triangle(const point<T, 3>& a, const point<T, 3>& b,
                                                                          const point<T, 3>& c,
                                                                          const point<T, 3>& p) noexcept;
template <Floating T>
IRG_API std::optional<point_pair<point<T, 3>>> nearest_of_lines(const point<T, 3>& a, const point<T, 3>& b,
                                                                const point<T, 3>& c, const point<T, 3>& d) noexcept;
template <Floating T, int N>
IRG_API std::optional<point_pair<point<T, N>>> nearest_of_segments(const point<T, N>& a, const point<T, N>& b,
                                                                   const point<T, N>& c, const point<T, N>& d) noexcept;

}  // namespace irg::detail::inline IRG_COMPILED_ABI

namespace irg::detail::inline IRG_ABI {

// What is found for points of numbers of any type: floats and doubles go through irg::compiled.

template <Point P>
constexpr point_on_line<P> nearest_part_of_segment(const P& a, const P& b, const P& p) noexcept {
  using T = scalar_of<P>;
  const auto foot = foot_on_line(a, b, p);
  if (sign_of(foot->t) <= 0) return {a, T(0)};
  if (sign_of(foot->rest) <= 0) return {b, T(1)};
  return {point_of_foot(a, b, p), rounded_to<T>(foot->t / foot->divisor)};
}

template <Point P>
constexpr std::optional<point_on_line<P>> find_nearest_on_line(const P& a, const P& b, const P& p) noexcept {
  const auto foot = foot_on_line(a, b, p);
  if (!foot || same_place(a, b)) return std::nullopt;
  return point_on_line<P>{point_of_foot(a, b, p), rounded_to<scalar_of<P>>(foot->t / foot->divisor)};
}

template <Point P>
constexpr std::optional<point_on_line<P>> find_nearest_on_segment(const P& a, const P& b, const P& p) noexcept {
  if (!is_finite(a, b, p)) return std::nullopt;
  return nearest_part_of_segment(a, b, p);
}

template <Point P>
constexpr std::optional<P> find_nearest_on_plane(const plane<scalar_of<P>>& plane, const P& p) noexcept {
  if (is_zero(normal_of(plane))) return std::nullopt;
  const auto v = values_of<3>(
      [](const auto& l, const auto& at) {
        const auto n = normal_of(l);
        const auto divisor = dot(n, n);
        return std::tuple{divisor, to_vec(at) * divisor - n * (dot(n, to_vec(at)) + l.d)};
      },
      plane, p);
  if (!v) return std::nullopt;
  return rounded_coordinates<P>(std::get<1>(*v) / std::get<0>(*v));
}

template <Point P>
constexpr std::optional<point_on_triangle<P>> find_nearest_on_triangle(const P& a, const P& b, const P& c,
                                                                       const P& p) noexcept {
  using T = scalar_of<P>;
  const auto foot = foot_on_triangle(a, b, c, p);
  if (!foot) return std::nullopt;
  const auto region = static_cast<triangle_region>(foot->region);
  switch (region) {
    case triangle_region::corner_a: return point_on_triangle<P>{a, region, {T(1), T(0), T(0)}};
    case triangle_region::corner_b: return point_on_triangle<P>{b, region, {T(0), T(1), T(0)}};
    case triangle_region::corner_c: return point_on_triangle<P>{c, region, {T(0), T(0), T(1)}};
    default: break;
  }
  const auto weight = [&](std::size_t i) { return rounded_to<T>(foot->weight[i] / foot->divisor); };
  return point_on_triangle<P>{region == triangle_region::edge_ab   ? point_of_foot(a, b, p)
                              : region == triangle_region::edge_bc ? point_of_foot(b, c, p)
                              : region == triangle_region::edge_ca ? point_of_foot(a, c, p)
                                                                   : foot_on_face<P>(a, b, c, p),
                              region,
                              {weight(0), weight(1), weight(2)}};
}

template <Point P>
constexpr std::optional<point_pair<P>> find_nearest_of_lines(const P& a, const P& b, const P& c, const P& d) noexcept {
  using T = scalar_of<P>;
  if (same_place(a, b) || same_place(c, d)) return std::nullopt;
  const auto lines = nearest_on_lines(a, b, c, d);
  if (!lines) return std::nullopt;
  const auto& v = *lines;
  if (sign_of(v[0]) == 0) {
    const auto foot = find_nearest_on_line(c, d, a);
    return point_pair<P>{a, foot->at, T(0), foot->t};
  }
  const std::array<P, 2> at = points_on_lines(a, b, c, d);
  return point_pair<P>{at[0], at[1], rounded_to<T>(v[2] / v[0]), rounded_to<T>(v[4] / v[0])};
}

template <Point P>
constexpr std::optional<point_pair<P>> find_nearest_of_segments(const P& a, const P& b, const P& c,
                                                                const P& d) noexcept {
  using T = scalar_of<P>;
  if (!is_finite(a, b, c, d)) return std::nullopt;
  const auto common = intersect_segments(a, b, c, d);
  if (common.relation != segment_relation::none) {
    const auto on_first = nearest_part_of_segment(a, b, common.first);
    const auto on_second = nearest_part_of_segment(c, d, common.first);
    const bool crossing = !(common.t == T(0)) || !(common.s == T(0));
    return point_pair<P>{common.first, common.first, crossing ? common.t : on_first.t,
                         crossing ? common.s : on_second.t};
  }
  if constexpr (size_of<P> == 3) {
    const auto v = *nearest_on_lines(a, b, c, d);
    const auto sign = [&](std::size_t i) { return sign_of(v[i]); };
    if (sign(0) > 0 && sign(2) >= 0 && sign(3) >= 0 && sign(4) >= 0 && sign(5) >= 0)
      return find_nearest_of_lines(a, b, c, d);
  }
  const int end = nearest_end(a, b, c, d);
  if (end < 2) {
    const P& from = end == 0 ? a : b;
    const auto foot = nearest_part_of_segment(c, d, from);
    return point_pair<P>{from, foot.at, T(end), foot.t};
  }
  const P& from = end == 2 ? c : d;
  const auto foot = nearest_part_of_segment(a, b, from);
  return point_pair<P>{foot.at, from, foot.t, T(end - 2)};
}

// Results of irg::compiled, for points of the caller's type.
template <Point P, class T, int N>
constexpr std::optional<P> own_result(const std::optional<point<T, N>>& r) noexcept {
  return r ? std::optional(own_point<P>(*r)) : std::nullopt;
}
template <Point P, class Q>
constexpr std::optional<point_on_line<P>> own_result(const std::optional<point_on_line<Q>>& r) noexcept {
  if (!r) return std::nullopt;
  return point_on_line<P>{own_point<P>(r->at), r->t};
}
template <Point P, class Q>
constexpr std::optional<point_on_triangle<P>> own_result(const std::optional<point_on_triangle<Q>>& r) noexcept {
  if (!r) return std::nullopt;
  return point_on_triangle<P>{own_point<P>(r->at), r->region, r->weights};
}
template <Point P, class Q>
constexpr std::optional<point_pair<P>> own_result(const std::optional<point_pair<Q>>& r) noexcept {
  if (!r) return std::nullopt;
  return point_pair<P>{own_point<P>(r->first), own_point<P>(r->second), r->t, r->s};
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

/// The point of the line through a (t = 0) and b (t = 1) that is nearest to p.
/// gives   nothing when a == b, or a coordinate is NaN or infinite
/// exact   each coordinate and t within 0.501 ulp
/// cost    some 200 ns; about 4 us near a degenerate case or for coordinates beyond 2^+-80
template <Point P>
  requires(Real<scalar_of<P>> && (size_of<P> == 2 || size_of<P> == 3))
[[nodiscard]] constexpr std::optional<point_on_line<P>> closest_point_on_line(const P& a, const P& b,
                                                                              const P& p) noexcept {
  if constexpr (Floating<scalar_of<P>>)
    return detail::own_result<P>(detail::nearest_on_line(
        detail::as_point<scalar_of<P>>(a), detail::as_point<scalar_of<P>>(b), detail::as_point<scalar_of<P>>(p)));
  else
    return detail::find_nearest_on_line(a, b, p);
}

/// The point of the segment ab that is nearest to p; the segment may be a point.
/// gives   nothing when a coordinate is NaN or infinite
/// exact   whether it is an end, which comes back bit for bit; else as closest_point_on_line
template <Point P>
  requires(Real<scalar_of<P>> && (size_of<P> == 2 || size_of<P> == 3))
[[nodiscard]] constexpr std::optional<point_on_line<P>> closest_point_on_segment(const P& a, const P& b,
                                                                                 const P& p) noexcept {
  if constexpr (Floating<scalar_of<P>>)
    return detail::own_result<P>(detail::nearest_on_segment(
        detail::as_point<scalar_of<P>>(a), detail::as_point<scalar_of<P>>(b), detail::as_point<scalar_of<P>>(p)));
  else
    return detail::find_nearest_on_segment(a, b, p);
}

/// The point of the plane that is nearest to p.
/// gives   nothing when the plane's normal is zero, or a number is NaN or infinite
/// exact   each coordinate within 0.501 ulp, for the coefficients as they are
template <Plane L, Point P>
  requires(size_of<P> == 3 && Real<scalar_of<P>> && std::same_as<plane_scalar<L>, scalar_of<P>>)
[[nodiscard]] constexpr std::optional<P> closest_point_on_plane(const L& plane, const P& p) noexcept {
  if constexpr (Floating<scalar_of<P>>)
    return detail::own_result<P>(detail::nearest_on_plane(detail::as_plane(plane), detail::as_point<scalar_of<P>>(p)));
  else
    return detail::find_nearest_on_plane(detail::as_plane(plane), p);
}

/// The point of the triangle abc that is nearest to p, the part it lies on, and its barycentric coordinates. The
/// triangle may be a segment or a point: then an edge or corner.
/// gives   nothing when a coordinate is NaN or infinite
/// exact   the part; a corner comes back bit for bit, each other coordinate and weight is within 0.501 ulp
/// cost    some 500 ns; about 20 us near a degenerate case or for coordinates beyond 2^+-80
/// source  Ericson 2004, 5.1.5, with exact signs
template <Point P>
  requires(size_of<P> == 3 && Real<scalar_of<P>>)
[[nodiscard]] constexpr std::optional<point_on_triangle<P>> closest_point_on_triangle(const P& a, const P& b,
                                                                                      const P& c, const P& p) noexcept {
  if constexpr (Floating<scalar_of<P>>)
    return detail::own_result<P>(
        detail::nearest_on_triangle(detail::as_point<scalar_of<P>>(a), detail::as_point<scalar_of<P>>(b),
                                    detail::as_point<scalar_of<P>>(c), detail::as_point<scalar_of<P>>(p)));
  else
    return detail::find_nearest_on_triangle(a, b, c, p);
}

/// The point of the box that is nearest to p: p itself inside.
/// needs   a box that is not empty
/// gives   the box's low side for a coordinate that is NaN
/// exact   comparisons alone
template <class T, int N>
[[nodiscard]] constexpr point<T, N> closest_point_in_box(const box<T, N>& b, const point<T, N>& p) noexcept {
  IRG_EXPECTS(!b.empty());
  return generate_coordinates<point<T, N>>([&](int i) { return clamped(p[i], b.low[i], b.high[i]); });
}

/// The points of two lines in space that are nearest to each other, and their parameters: one point where the lines
/// cross. Of parallel lines it is a, and the point of cd that is nearest to it.
/// gives   nothing when a == b or c == d, or a coordinate is NaN or infinite
/// exact   each coordinate, t and s within 0.501 ulp
template <Point P>
  requires(size_of<P> == 3 && Real<scalar_of<P>>)
[[nodiscard]] constexpr std::optional<point_pair<P>> closest_points_of_lines(const P& a, const P& b, const P& c,
                                                                             const P& d) noexcept {
  if constexpr (Floating<scalar_of<P>>)
    return detail::own_result<P>(
        detail::nearest_of_lines(detail::as_point<scalar_of<P>>(a), detail::as_point<scalar_of<P>>(b),
                                 detail::as_point<scalar_of<P>>(c), detail::as_point<scalar_of<P>>(d)));
  else
    return detail::find_nearest_of_lines(a, b, c, d);
}

/// The points of the segments ab and cd that are nearest to each other, and their parameters; where the segments have
/// points in common, one of these. Segments may be points.
/// gives   nothing when a coordinate is NaN or infinite
/// exact   which parts are nearest, but for pairs whose distances agree to 2^-60; ends come back bit for bit,
///         coordinates and parameters are within 0.501 ulp
/// cost    some 1 us; about 30 us near a degenerate case or for coordinates beyond 2^+-80
template <Point P>
  requires(Real<scalar_of<P>> && (size_of<P> == 2 || size_of<P> == 3))
[[nodiscard]] constexpr std::optional<point_pair<P>> closest_points_of_segments(const P& a, const P& b, const P& c,
                                                                                const P& d) noexcept {
  if constexpr (Floating<scalar_of<P>>)
    return detail::own_result<P>(
        detail::nearest_of_segments(detail::as_point<scalar_of<P>>(a), detail::as_point<scalar_of<P>>(b),
                                    detail::as_point<scalar_of<P>>(c), detail::as_point<scalar_of<P>>(d)));
  else
    return detail::find_nearest_of_segments(a, b, c, d);
}

IRG_REFUSES_VECTORS(closest_point_on_line);
IRG_REFUSES_VECTORS(closest_point_on_plane);
IRG_REFUSES_VECTORS(closest_point_on_segment);
IRG_REFUSES_VECTORS(closest_point_on_triangle);
IRG_REFUSES_VECTORS(closest_points_of_lines);
IRG_REFUSES_VECTORS(closest_points_of_segments);

}  // namespace irg::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T, int N>
IRG_API std::optional<point_on_line<point<T, N>>> nearest_on_line(const point<T, N>& a, const point<T, N>& b,
                                                                  const point<T, N>& p) noexcept {
  return find_nearest_on_line(a, b, p);
}

template <Floating T, int N>
IRG_API std::optional<point_on_line<point<T, N>>> nearest_on_segment(const point<T, N>& a, const point<T, N>& b,
                                                                     const point<T, N>& p) noexcept {
  return find_nearest_on_segment(a, b, p);
}

template <Floating T>
IRG_API std::optional<point<T, 3>> nearest_on_plane(const plane<T>& l, const point<T, 3>& p) noexcept {
  return find_nearest_on_plane(l, p);
}

template <Floating T>
IRG_API std::optional<point_on_triangle<point<T, 3>>> nearest_on_triangle(const point<T, 3>& a, const point<T, 3>& b,
                                                                          const point<T, 3>& c,
                                                                          const point<T, 3>& p) noexcept {
  return find_nearest_on_triangle(a, b, c, p);
}

template <Floating T>
IRG_API std::optional<point_pair<point<T, 3>>> nearest_of_lines(const point<T, 3>& a, const point<T, 3>& b,
                                                                const point<T, 3>& c, const point<T, 3>& d) noexcept {
  return find_nearest_of_lines(a, b, c, d);
}

template <Floating T, int N>
IRG_API std::optional<point_pair<point<T, N>>> nearest_of_segments(const point<T, N>& a, const point<T, N>& b,
                                                                   const point<T, N>& c,
                                                                   const point<T, N>& d) noexcept {
  return find_nearest_of_segments(a, b, c, d);
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
