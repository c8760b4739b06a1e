// SPDX-License-Identifier: MIT
// Corners of a polygon that is cut by the boundaries of a convex region, each known by what it is: a given vertex, or
// where a boundary meets a given edge or another boundary. Its side of a boundary is decided exactly, from given
// numbers alone; its position is rounded once, correctly, and nothing is cut between rounded positions.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <irg/core/conversion.hpp>
#include <irg/geometry/attributed_point.hpp>
#include <irg/geometry/detail/axis_crossing.hpp>
#include <irg/geometry/detail/half_space.hpp>
#include <irg/geometry/parametric_plane.hpp>
#include <irg/math/exact/filtered_number.hpp>
#include <irg/math/exact/nearest_float.hpp>
#include <irg/math/exact/quotients_of.hpp>
#include <irg/math/exact/sign_of.hpp>

namespace irg::detail {

// Lines have numbers: first the given edges, then the stretches along boundaries. `onward` leads to the next corner.
// `line` and `boundary` meet here, or `boundary` is none: a given vertex. `side` is that of the boundary in turn. No
// coordinate is further than `error` from `about`.
template <class V>
struct clipped_corner {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  V vertex{};
  std::size_t onward = 0, line = none, boundary = none;
  std::array<double, static_cast<std::size_t>(size_of<vertex_position<V>>)> about{};
  double error = 0;
  int side = 0;
};

inline namespace IRG_COMPILED_ABI {

// On which side of a boundary another one meets the line through two points, and two others the plane through three.
template <Floating T, int D>
IRG_API int side_of_line_meeting(const half_space<T, D>& boundary, const half_space<T, D>& h, const point<T, D>& from,
                                 const point<T, D>& to) noexcept;
template <Floating T>
IRG_API int side_of_plane_meeting(const half_space<T, 3>& boundary, const half_space<T, 3>& g,
                                  const half_space<T, 3>& h, const point<T, 3>& p, const point<T, 3>& q,
                                  const point<T, 3>& r) noexcept;
// Where these meet, rounded.
template <Floating T, int D>
IRG_API std::optional<point<T, D>> rounded_line_meeting(const half_space<T, D>& h, const point<T, D>& from,
                                                        const point<T, D>& to) noexcept;
template <Floating T>
IRG_API std::optional<point<T, 3>> rounded_planes_meeting(const half_space<T, 3>& g, const half_space<T, 3>& h,
                                                          const point<T, 3>& p, const point<T, 3>& q,
                                                          const point<T, 3>& r) noexcept;
// The sign of the sum of a boundary's values at two points.
template <Floating T, int D>
IRG_API int sign_of_sum_of_values(const half_space<T, D>& boundary, const point<T, D>& p,
                                  const point<T, D>& q) noexcept;

}  // namespace IRG_COMPILED_ABI

inline namespace IRG_ABI {

// Where boundaries of regions meet lines and planes through given points: about, with a bound of the error; on which
// side of another boundary, exactly; and correctly rounded.

// A boundary and two points: from the first point on, where their line meets it: the divisor, and the way times it.
struct line_meeting {
  template <class H, class P>
  constexpr auto operator()(const H& h, const P& from, const P& to) const noexcept {
    const auto at_from = half_space_value(h, from);
    return std::tuple{at_from - half_space_value(h, to), (to - from) * at_from};
  }
  template <class H, class P>
  static constexpr const P& first(const H&, const P& from, const P&) noexcept {
    return from;  // NOLINT(bugprone-return-const-ref-from-parameter)
  }
};
// Two planes and three points: the same for the point that they and the plane through the points share.
struct plane_meeting {
  template <class H, class P>
  constexpr auto operator()(const H& g, const H& h, const P& from, const P& second, const P& third) const noexcept {
    const auto n = cross(second - from, third - from);
    using N = std::remove_cvref_t<decltype(n.x)>;
    const auto normal = [](const H& of) { return vec<N, 3>{of.numbers[0], of.numbers[1], of.numbers[2]}; };
    const auto a = normal(g), b = normal(h);
    return std::tuple{dot(n, cross(a, b)),
                      cross(n, b) * half_space_value(g, from) + cross(a, n) * half_space_value(h, from)};
  }
  template <class H, class P>
  static constexpr const P& first(const H&, const H&, const P& from, const P&, const P&) noexcept {
    return from;  // NOLINT(bugprone-return-const-ref-from-parameter)
  }
};

// Where these meet, about.
template <class Meeting, class Corner, class... In>
constexpr void place_about(Corner& c, const Meeting& meeting, const In&... in) noexcept {
  c.error = std::numeric_limits<double>::infinity();
  const auto found = filtered_value_of<5>(meeting, in...);
  if (!found) return;
  const auto& [divisor, way] = *found;
  constexpr double relative = 0x1p-48;  // of at most 16 roundings
  const double size = magnitude(divisor.value), off = product(relative, divisor.size);
  if (!(off + off < size)) return;
  double error = 0;
  for (int i = 0; i < static_cast<int>(c.about.size()); ++i) {
    const double from = widened(coordinate(meeting.first(in...), i)), part = way[i].value / divisor.value;
    c.about[static_cast<std::size_t>(i)] = from + part;
    const double way_off = (product(relative, way[i].size) + product(magnitude(part), off)) / size;
    error = maximum(error, product(3.0, way_off) + product(0x1p-52, magnitude(from) + magnitude(part)));
  }
  c.error = error;
}
// On which side of a boundary a corner is for all that is known about its place; 0 where that does not tell.
template <class Corner, Floating T, int D>
constexpr int side_about(const Corner& c, const half_space<T, D>& boundary) noexcept {
  std::array<double, 4> h{};
  bool suits = c.error < infinity<double>;
  for (std::size_t i = 0; i < 4; ++i) {
    suits = suits && suits_filter<5>(widened(boundary.numbers[i]));
    h[i] = widened(boundary.numbers[i]);
  }
  if (!suits) return 0;
  double value = 0, size = 0, reach = 0;
  const auto add = [&](double factor, double x, double from) {
    value += product(factor, x - from);
    size += product(magnitude(factor), magnitude(x) + magnitude(from));
    reach += magnitude(factor);
  };
  if constexpr (D == 2) {
    add(h[2] - h[0], c.about[1], h[1]), add(h[1] - h[3], c.about[0], h[0]);
  } else {
    for (std::size_t i = 0; i < 3; ++i) add(h[i], c.about[i], 0);
    value += h[3], size += magnitude(h[3]);
  }
  const double bound = product(size, 0x1p-50) + product(reach, 1.5 * c.error);
  return value > bound ? 1 : -value > bound ? -1 : 0;
}
// As irg::compiled takes it.
template <class T, int D>
IRG_INLINE constexpr const half_space<T, D>& at_library(const half_space<T, D>& h) noexcept {
  return h;  // NOLINT(bugprone-return-const-ref-from-parameter)
}
template <Point P>
IRG_INLINE constexpr auto at_library(const P& p) noexcept {
  return as_point<scalar_of<P>>(p);
}

// The same exactly: the sign of the boundary's value where these meet.
template <class Meeting, Floating T, int D, class... In>
constexpr int exact_side(const Meeting&, const half_space<T, D>& boundary, const In&... in) noexcept {
  if constexpr (std::is_same_v<Meeting, line_meeting>)
    return side_of_line_meeting(boundary, at_library(in)...);
  else
    return side_of_plane_meeting(boundary, at_library(in)...);
}
// The same place, rounded.
template <Point P, class Meeting, class... In>
constexpr std::optional<P> rounded_place(const Meeting&, const In&... in) noexcept {
  const auto own = [](const auto& at) { return at ? std::optional(own_point<P>(*at)) : std::nullopt; };
  if constexpr (std::is_same_v<Meeting, line_meeting>)
    return own(rounded_line_meeting(at_library(in)...));
  else
    return own(rounded_planes_meeting(at_library(in)...));
}

// Whether points of the half-space round to p. The corner of those that do is midway to the neighbour further inside.
template <Floating T, int D, Point P>
constexpr bool reaches(const half_space<T, D>& boundary, const P& p) noexcept {
  const auto& h = boundary.numbers;
  const auto neighbour = generate_coordinates<P>([&](int i) {
    const int inwards = D == 3   ? compare_numbers(h[static_cast<std::size_t>(i)], T(0))
                        : i == 0 ? compare_numbers(h[1], h[3])
                                 : compare_numbers(h[2], h[0]);
    const T x = coordinate(p, i), next = float_at<T>(ordinal_of(x) + static_cast<float_ordinal<T>>(inwards));
    return is_finite(next) ? next : x;
  });
  return sign_of_sum_of_values(boundary, as_point<T>(p), as_point<T>(neighbour)) >= 0;
}

// boundary(k) is the region's half_space<T, D> with number k.
template <int D, PolygonVertex V, class Boundary, class F>
class convex_clipper {
public:
  using T = vertex_scalar<V>;
  using P = vertex_position<V>;
  using corner = clipped_corner<V>;

  constexpr convex_clipper(std::span<const V> polygon, const Boundary& boundary, const F& interpolate) noexcept
      : polygon_(polygon), boundary_(boundary), interpolate_(interpolate) {}

  constexpr std::size_t along(std::size_t k) const noexcept { return polygon_.size() + k; }
  constexpr corner given(std::size_t i) const noexcept {
    corner c{polygon_[i], i};
    if constexpr (Floating<T>)
      for (int k = 0; k < D; ++k) c.about[static_cast<std::size_t>(k)] = widened(coordinate(position_of(c.vertex), k));
    return c;
  }

  // 1 inside boundary k, 0 on it, -1 outside.
  constexpr int side(const corner& c, std::size_t k) const noexcept {
    const auto h = boundary_(k);
    if constexpr (Floating<T>)
      if (c.boundary != corner::none) {
        if (c.line == along(k)) return 0;
        if (const int s = side_about(c, h); s != 0) return s;
        return as_meeting(c, [&](const auto& meeting, const auto&... in) { return exact_side(meeting, h, in...); });
      }
    return half_space_side(h, position_of(c.vertex));
  }

  // Where the line from one corner to the next passes boundary k.
  constexpr corner cut(const corner& from, const corner& to, std::size_t k) {
    corner c{from.vertex, from.onward, from.onward, k};
    if constexpr (Floating<T>) {
      if (D == 3 && is_stretch(c) && flat_[0] == flat_[1]) find_plane();
      if (Point<V> || is_stretch(c))
        as_meeting(c, [&](const auto& meeting, const auto&... in) { place_about(c, meeting, in...); });
      if constexpr (D == 3)
        if (is_stretch(c) && polygon_.size() > 3 && !fits(c, from, to)) stand_upright(c, from, to);
    }
    if constexpr (!Floating<T> || !Point<V>) interpolate(c, from, to);
    return c;
  }

  // The corner as it comes out.
  constexpr V vertex_of(const corner& c) const noexcept {
    if constexpr (Point<V>)
      return place(c);
    else
      return c.vertex;
  }

  // Whether the vertices are points of the region, rounded: of each half-space, of which number k is the first that
  // some are not in; what is not in the region itself must be `near`, too.
  template <class Near>
  constexpr bool keeps_all(const std::vector<corner>& vertices, std::size_t k, std::size_t boundaries,
                           const Near& is_near) const noexcept {
    for (const corner& c : vertices)
      if (c.side < 0 && !(touches(k, position_of(c.vertex)) && is_near(position_of(c.vertex)))) return false;
    for (const corner& c : vertices)
      for (std::size_t i = k + 1; i < boundaries; ++i)
        if (const P& p = position_of(c.vertex); side(c, i) < 0 && !(touches(i, p) && is_near(p))) return false;
    return true;
  }

private:
  constexpr bool is_stretch(const corner& c) const noexcept { return c.line >= polygon_.size(); }
  constexpr bool touches(std::size_t k, const P& p) const noexcept {
    if constexpr (Floating<T>)
      return reaches(boundary_(k), p);
    else
      return half_space_side(boundary_(k), p) >= 0;
  }

  // use(meeting, what meets...): what the corner is.
  template <class Use>
  constexpr auto as_meeting(const corner& c, const Use& use) const noexcept {
    if constexpr (D == 3)
      if (is_stretch(c)) {
        const auto at = [&](std::size_t i) -> const P& { return position_of(polygon_[flat_[i]]); };
        return use(plane_meeting{}, boundary_(c.line - polygon_.size()), boundary_(c.boundary), at(0), at(1), at(2));
      }
    const auto [a, b] = ends_of(c.line);
    return use(line_meeting{}, boundary_(c.boundary), a, b);
  }
  // A vertex that carries more than its place, or that is as exact as its numbers, is made at once.
  constexpr void interpolate(corner& c, const corner& from, const corner& to) const {
    const V *a = &from.vertex, *b = &to.vertex;
    if (!is_stretch(c)) {
      a = &polygon_[c.line];
      b = &polygon_[c.line + 1 < polygon_.size() ? c.line + 1 : 0];
    }
    if (comes_before(position_of(*b), position_of(*a))) std::swap(a, b);
    const P &p = position_of(*a), &q = position_of(*b);
    half_space_meeting<T, P> m;
    if (!Floating<T> || !is_stretch(c))
      m = meet_half_space(p, q, boundary_(c.boundary));
    else {
      m.at = place(c);
      m.t = part_of_way(p, q, m.at);
    }
    if constexpr (Point<V>)
      c.vertex = m.at;
    else
      c.vertex = placed_at(V(interpolate_(*a, *b, m.t)), m.at);
    if constexpr (Floating<T>)
      stay_about(c, m.at);
    else
      c.boundary = corner::none;
  }
  static constexpr void stay_about(corner& c, const P& at) noexcept {
    double most = 0;
    for (std::size_t i = 0; i < c.about.size(); ++i) {
      c.about[i] = widened(coordinate(at, static_cast<int>(i)));
      most = maximum(most, magnitude(c.about[i]));
    }
    const auto wide = [](T x) { return widened(x); };
    c.error = most < 0x1p80 ? most * wide(std::numeric_limits<T>::epsilon()) + wide((std::numeric_limits<T>::min)())
                            : infinity<double>;
  }
  // Two points of an edge, or of a boundary in the plane.
  constexpr std::pair<P, P> ends_of(std::size_t line) const noexcept {
    const std::size_t n = polygon_.size();
    if (line < n) return {position_of(polygon_[line]), position_of(polygon_[line + 1 < n ? line + 1 : 0])};
    const auto h = boundary_(line - n).numbers;
    const auto from = [&](std::size_t k) {
      return generate_coordinates<P>([&](int i) { return h[k + static_cast<std::size_t>(i)]; });
    };
    return {from(0), from(2)};
  }

  // A given vertex, a common corner of two boundaries, or rounded.
  constexpr P place(const corner& c) const noexcept {
    if constexpr (Floating<T>) {
      if (c.boundary == corner::none) return position_of(c.vertex);
      if constexpr (D == 2)
        if (is_stretch(c)) {
          const auto first = ends_of(c.line), second = ends_of(along(c.boundary));
          if (same_place(first.second, second.first)) return first.second;
          if (same_place(first.first, second.second)) return first.first;
        }
      const auto found = rounded(c);
      IRG_EXPECTS(found.has_value());
      return *found;
    } else {
      return position_of(c.vertex);
    }
  }
  constexpr std::optional<P> rounded(const corner& c) const noexcept {
    return as_meeting(c, [](const auto& meeting, const auto&... in) { return rounded_place<P>(meeting, in...); });
  }

  // The polygon's plane: that through three vertices, a third of the way round apart or next to each other.
  constexpr void find_plane() noexcept {
    const std::size_t n = polygon_.size();
    const auto at = [&](std::size_t i) { return position_of(polygon_[flat_[i]]); };
    for (const std::size_t step : {n / 3, std::size_t{1}})
      for (std::size_t i = 0; i < n; ++i) {
        flat_ = {i, (i + step) % n, (i + 2 * step) % n};
        if (spans_plane(at(0), at(1), at(2))) return;
      }
  }
  // Whether a corner in the plane of a polygon that need not be flat is between two others and in the region so far.
  constexpr bool fits(const corner& c, const corner& from, const corner& to) const noexcept {
    const double error = (c.error + from.error + to.error) * 2;
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = from.about[i], y = to.about[i], z = c.about[i];
      if (z + error < minimum(x, y) || maximum(x, y) < z - error) return false;
    }
    for (std::size_t k = 0; k < c.boundary; ++k)
      if (side(c, k) < 0) return false;
    return c.error < infinity<double> || rounded(c);
  }
  // It is not: as if the polygon stood upright on the stretch, along the normal's longest axis.
  constexpr void stand_upright(corner& c, const corner& from, const corner& to) const noexcept {
    const P p = place(from), q = place(to);
    const auto first = boundary_(c.line - polygon_.size()), second = boundary_(c.boundary);
    const std::size_t k = std::exchange(c.boundary, corner::none);
    const auto steep = [&](std::size_t i) { return maximum(first.numbers[i], -first.numbers[i]); };
    const std::size_t lower = steep(0) < steep(1) ? 1 : 0, up = steep(lower) < steep(2) ? 2 : lower;
    const P over = generate_coordinates<P>([&](int i) {
      const T x = coordinate(p, i);
      return static_cast<std::size_t>(i) != up ? x : x == T(0) ? T(1) : T(0);
    });
    const auto found = rounded_place<P>(plane_meeting{}, first, second, p, q, over);
    P at = found ? *found : p;
    for (std::size_t i = 0; i <= k; ++i)
      if (!touches(i, at)) at = from.side < 0 ? q : p;
    c.vertex = placed_at(c.vertex, at);
    stay_about(c, at);
  }
  // How far from a to b a place between them is, on the axis where they are farthest apart.
  static constexpr T part_of_way(const P& a, const P& b, const P& at) noexcept {
    const auto extent = [&](int i) {
      const T x = coordinate(a, i), y = coordinate(b, i);
      return maximum(x, y) / T(2) - minimum(x, y) / T(2);
    };
    int axis = 0;
    for (int i = 1; i < D; ++i) axis = extent(axis) < extent(i) ? i : axis;
    return extent(axis) == T(0) ? T(0) : parameter_of(coordinate(a, axis), coordinate(b, axis), coordinate(at, axis));
  }

  std::span<const V> polygon_;
  const Boundary& boundary_;
  const F& interpolate_;
  std::array<std::size_t, 3> flat_{};
};

}  // namespace IRG_ABI
}  // namespace irg::detail

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// The same exactly: the sign of the boundary's value where these meet.
template <int Degree, class H, class Meeting, class... In>
constexpr int find_exact_side(const Meeting& meeting, const H& boundary, const In&... in) noexcept {
  const auto [turn, side] = sign_of<Degree>(
      [&](const auto& h, const auto&... x) {
        const auto [divisor, way] = meeting(x...);
        return std::array{divisor, divisor * half_space_value(h, meeting.first(x...)) + half_space_growth(h, way)};
      },
      boundary, in...);
  return turn * side;
}
// The same place, rounded.
template <int Degree, Point P, class Meeting, class... In>
constexpr std::optional<P> find_rounded_place(const Meeting& meeting, const In&... in) noexcept {
  const auto found = quotients_of<Degree>(
      [&](const auto&... x) {
        const auto [divisor, way] = meeting(x...);
        const auto at = way + to_vec(meeting.first(x...)) * divisor;
        if constexpr (size_of<P> == 2)
          return std::array{divisor, at.x, at.y};
        else
          return std::array{divisor, at.x, at.y, at.z};
      },
      in...);
  if (!found) return std::nullopt;
  return generate_coordinates<P>([&](int i) { return (*found)[static_cast<std::size_t>(i)]; });
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T, int D>
IRG_API int side_of_line_meeting(const half_space<T, D>& boundary, const half_space<T, D>& h, const point<T, D>& from,
                                 const point<T, D>& to) noexcept {
  return find_exact_side<4>(line_meeting{}, boundary, h, from, to);
}
template <Floating T>
IRG_API int side_of_plane_meeting(const half_space<T, 3>& boundary, const half_space<T, 3>& g,
                                  const half_space<T, 3>& h, const point<T, 3>& p, const point<T, 3>& q,
                                  const point<T, 3>& r) noexcept {
  return find_exact_side<6>(plane_meeting{}, boundary, g, h, p, q, r);
}
template <Floating T, int D>
IRG_API std::optional<point<T, D>> rounded_line_meeting(const half_space<T, D>& h, const point<T, D>& from,
                                                        const point<T, D>& to) noexcept {
  return find_rounded_place<3, point<T, D>>(line_meeting{}, h, from, to);
}
template <Floating T>
IRG_API std::optional<point<T, 3>> rounded_planes_meeting(const half_space<T, 3>& g, const half_space<T, 3>& h,
                                                          const point<T, 3>& p, const point<T, 3>& q,
                                                          const point<T, 3>& r) noexcept {
  return find_rounded_place<5, point<T, 3>>(plane_meeting{}, g, h, p, q, r);
}
template <Floating T, int D>
IRG_API int sign_of_sum_of_values(const half_space<T, D>& boundary, const point<T, D>& p,
                                  const point<T, D>& q) noexcept {
  return sign_of<2>([](const auto& half, const auto& at,
                       const auto& next) { return half_space_value(half, at) + half_space_value(half, next); },
                    boundary, p, q);
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
