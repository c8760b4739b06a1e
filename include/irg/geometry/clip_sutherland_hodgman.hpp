// SPDX-License-Identifier: MIT
// Sutherland and Hodgman's polygon clipping, in the plane against windows and convex polygons, in space against convex
// regions given by planes, such as a view pyramid's. Edges of the result that run along a boundary are the price of its
// simplicity where the polygon is not convex; polygon_boolean gives the pieces apart.
#pragma once

#include <concepts>
#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <irg/geometry/attributed_point.hpp>
#include <irg/geometry/box.hpp>
#include <irg/geometry/detail/axis_crossing.hpp>
#include <irg/geometry/detail/convex_clipper.hpp>
#include <irg/geometry/detail/window_walk_kernel.hpp>
#include <irg/geometry/orient2d.hpp>

namespace irg {

/// Polygon vertices one after the other in memory. Models: std::vector<point<double, 2>>, a plain array, std::span.
template <class R>
concept VertexRange = requires(const R& r) {
  std::data(r);
  { std::size(r) } -> std::convertible_to<std::size_t>;
  requires PolygonVertex<std::remove_cvref_t<decltype(*std::data(r))>>;
};

/// The vertex type of a VertexRange.
template <VertexRange R>
using range_vertex = std::remove_cvref_t<decltype(*std::data(std::declval<const R&>()))>;

namespace detail {

template <class Region, class V>
inline constexpr bool is_window_for = std::same_as<Region, box<vertex_scalar<V>, 2>>;
template <class Region, class V>
concept convex_ring_for = PolygonRing<Region> && requires {
  requires Real<vertex_scalar<V>>;
  requires size_of<vertex_position<V>> == 2;
  requires size_of<ring_point<Region>> == 2;
  requires std::same_as<ring_scalar<Region>, vertex_scalar<V>>;
};
template <class Region, class V>
concept planes_for = requires {
  requires Real<vertex_scalar<V>>;
  requires size_of<vertex_position<V>> == 3;
  requires std::convertible_to<const Region&, std::span<const plane<vertex_scalar<V>>>>;
};

}  // namespace detail

/// What a polygon with vertices of type V can be clipped to: a window or a convex polygon in the plane, planes in
/// space.
template <class Region, class V>
concept ClipRegion = (size_of<vertex_position<V>> == 2 && detail::is_window_for<Region, V>) ||
                     detail::convex_ring_for<Region, V> || detail::planes_for<Region, V>;

/// What interpolates vertices of type V.
template <class F, class V>
concept VertexInterpolation = requires(const F& f, const V& v, const vertex_scalar<V>& t) {
  { f(v, v, t) } -> std::convertible_to<V>;
};

inline namespace IRG_ABI {

/// The part of a polygon that lies in a window (box<T, 2>), in a convex polygon of either orientation, or, in space, on
/// or above all planes, into the caller's memory; the number of its vertices.
/// shape   the winding is kept, as is the first vertex when it is inside; points on a boundary are inside, and cuts are
///         not doubled, nor is a last vertex at the place of the first. `interpolate(a, b, t)` makes what a vertex
///         carries along, lerp_vertex as default; it is called with the ends of the given edge, or of the stretch along
///         a boundary, in an order that does not depend on the direction
/// gives   0 when nothing or no area is left, when the region is empty, and when a coordinate is NaN or infinite; a
///         number beyond out.size() when that is too small, and what fits is written. A polygon that is not convex
///         comes out as one ring whatever falls apart: pieces are joined by edges along the boundary, there and back
/// exact   every corner is a given vertex or a corner of the region, bit for bit, or where a given edge meets a
///         boundary, each coordinate correctly rounded; which of them there are is decided exactly, for all finite
///         floats and doubles. Polygons that share an edge cut it at the same points. Clipping again changes nothing,
///         bit for bit: a polygon whose vertices are all points of the region, rounded, comes back as it is; against
///         planes, one whose vertices are points of each half-space, rounded. In space two planes meet in the
///         polygon's plane, correctly rounded, too. If more than three vertices are not flat, that is the plane through
///         three of them, a third of the way round apart, where this leads into the region; else the place where the
///         line between the two cuts, rounded, seen along an axis, meets both planes, or the cut that is inside
/// cost    windows: for up to 64 plain points 2 to 3 ns per vertex and some 25 per edge that passes a boundary; else,
///         and in delicate cases, about twice as much or more; nothing allocates. Other regions: 3 ns per vertex and
///         boundary, 0.1 us per cut, 0.2 us per cut that is left in the end (where two planes meet 0.4), and two
///         allocations. Numbers beyond 2^+-80 some 5 us per cut and boundary
/// source  Sutherland and Hodgman 1974
template <VertexRange R, class Region, class F = lerp_vertex>
  requires ClipRegion<Region, range_vertex<R>> && VertexInterpolation<F, range_vertex<R>>
constexpr std::size_t clip_sutherland_hodgman(const R& polygon, const Region& region,
                                              std::type_identity_t<std::span<range_vertex<R>>> out,
                                              const F& interpolate = {});

/// As above, into memory of its own.
template <VertexRange R, class Region, class F = lerp_vertex>
  requires ClipRegion<Region, range_vertex<R>> && VertexInterpolation<F, range_vertex<R>>
[[nodiscard]] constexpr std::vector<range_vertex<R>> clip_sutherland_hodgman(const R& polygon, const Region& region,
                                                                             const F& interpolate = {});

}  // namespace IRG_ABI
}  // namespace irg

namespace irg::detail {

// Sutherland and Hodgman's reentrant polygon clipper, for windows: each axis, with its two boundaries, is a stage that
// takes vertices one by one, keeps what is inside and hands it to the next. It needs no room for anything but two
// vertices per stage.
//
// A vertex arrives with the number of the polygon's edge that leads to it, or along_boundary. Cuts are made on the
// whole edge as it was given, whatever the stages before have left of it: they are as exact as the edge, and the same
// for both polygons that share it.

inline constexpr std::ptrdiff_t along_boundary = -1;

// Where a vertex lies for a stage: -1 or 1 beyond a boundary, 0 elsewhere; `rounded` where a cut was rounded to a
// boundary's coordinate that it does not have exactly.
struct stage_place {
  int beyond = 0;
  bool rounded = false;
};
template <class V>
struct pipe_stage {
  V first{}, last{};
  stage_place first_place, last_place;
  bool started = false;
};

// edge(i) is the first end of the polygon's edge i. Sink: put(v), and enter(v) where the polygon was outside before.
template <class V, class F, class Edge, class Sink>
class IRG_APART window_pipe {
public:
  using T = vertex_scalar<V>;
  using P = vertex_position<V>;
  template <int Axis>
  using stage_of = std::integral_constant<int, Axis>;

  IRG_INLINE constexpr window_pipe(const box<T, 2>& window, const F& interpolate, const Edge& edge, Sink& sink) noexcept
      : window_(window), interpolate_(interpolate), edge_(edge), sink_(sink) {}

  // One more vertex; the edge with the number `by` leads to it. A cut lies on the edge `on`.
  template <int Axis>
  constexpr void take(stage_of<Axis> s, const V& v, std::ptrdiff_t by, bool enters,
                      std::ptrdiff_t on = along_boundary) {
    if constexpr (Axis == 2) {
      enters ? sink_.enter(v) : sink_.put(v);
    } else {
      pipe_stage<V>& stage = stages_[Axis];
      stage_place place{beyond<Axis>(position_of(v))};
      if constexpr (Axis == 1)
        if (on != along_boundary && (is_on<1>(-1, v) || is_on<1>(1, v))) place = settled(v, on);
      if (!stage.started) {
        stage.started = true;
        stage.first = v, stage.first_place = place;
        if (place.beyond == 0) take(after(s), v, by, enters, on);
      } else {
        const bool was_beyond = stage.last_place.beyond != 0;
        const std::ptrdiff_t arrives_by = step(s, v, place, by);
        if (place.beyond == 0) take(after(s), v, arrives_by, enters || was_beyond, on);
      }
      stage.last = v, stage.last_place = place;
    }
  }

  // The vertices since the last one that was taken lie where it lies, v being the last of them.
  template <int Axis>
  constexpr void pass_over(stage_of<Axis> s, const V& v) {
    if constexpr (Axis < 2) {
      stages_[Axis].last = v;
      if (stages_[Axis].last_place.beyond == 0) pass_over(after(s), v);
    }
  }

  // The end: the last vertex is joined to the first, by the edge with this number.
  template <int Axis>
  constexpr void close(stage_of<Axis> s, std::ptrdiff_t by) {
    if constexpr (Axis < 2) {
      const pipe_stage<V>& stage = stages_[Axis];
      if (!stage.started) return;
      const std::ptrdiff_t arrives_by = step(s, stage.first, stage.first_place, by);
      close(after(s), stage.first_place.beyond == 0 ? arrives_by : along_boundary);
    }
  }

private:
  template <int Axis>
  IRG_INLINE static constexpr auto after(stage_of<Axis>) noexcept {
    return stage_of<Axis + 1>{};
  }
  template <int Axis>
  IRG_INLINE constexpr const T& bound(int place) const noexcept {
    return place < 0 ? window_.low[Axis] : window_.high[Axis];
  }
  template <int Axis>
  IRG_INLINE constexpr int beyond(const P& p) const noexcept {
    const T x = coordinate(p, Axis);
    return static_cast<int>(window_.high[Axis] < x) - static_cast<int>(x < window_.low[Axis]);
  }
  template <int Axis>
  IRG_INLINE constexpr bool is_on(int place, const V& v) const noexcept {
    return coordinate(position_of(v), Axis) == bound<Axis>(place);
  }
  // A cut of the first axis that was rounded to a boundary of the second: the edge passes over or under that place.
  IRG_NOINLINE constexpr stage_place settled(const V& cut, std::ptrdiff_t on) const noexcept {
    const P &a = position_of(edge_(on)), &b = position_of(edge_(on + 1));
    const int turn = orient2d(a, b, position_of(cut)), off = coordinate(a, 0) < coordinate(b, 0) ? -turn : turn;
    return {off != 0 && is_on<1>(off, cut) ? off : 0, off != 0};
  }

  // The cuts between the last vertex and v; what leads to v in the next stage.
  template <int Axis>
  constexpr std::ptrdiff_t step(stage_of<Axis> s, const V& v, const stage_place& place, std::ptrdiff_t by) {
    const pipe_stage<V>& stage = stages_[Axis];
    const int was = stage.last_place.beyond, is = place.beyond;
    if (was == is) return by;
    if (was != 0) {
      if (is == 0 && !place.rounded && is_on<Axis>(was, v)) return along_boundary;
      take(after(s), cut<Axis>(was, v, by), along_boundary, true, by);
    }
    if (is != 0 && (was != 0 || stage.last_place.rounded || !is_on<Axis>(is, stage.last)))
      take(after(s), cut<Axis>(is, v, by), by, true, by);
    return by;
  }
  template <int Axis>
  constexpr V cut(int place, const V& to, std::ptrdiff_t by) const {
    const V *a = &stages_[Axis].last, *b = &to;
    if (by != along_boundary) {
      a = &edge_(by);
      b = &edge_(by + 1);
    }
    if (comes_before(position_of(*b), position_of(*a))) std::swap(a, b);
    const P &p = position_of(*a), &q = position_of(*b);
    const T x = bound<Axis>(place), low = coordinate(p, Axis), high = coordinate(q, Axis);
    const T y = axis_crossing_of(low, coordinate(p, 1 - Axis), high, coordinate(q, 1 - Axis), x);
    const P at = generate_coordinates<P>([&](int i) { return i == Axis ? x : y; });
    if constexpr (Point<V>)
      return at;
    else
      return placed_at(V(interpolate_(*a, *b, parameter_of(low, high, x))), at);
  }

  const box<T, 2>& window_;
  const F& interpolate_;
  const Edge& edge_;
  Sink& sink_;
  pipe_stage<V> stages_[2];
};

inline namespace IRG_ABI {

// Sutherland and Hodgman's algorithm: one boundary after the other keeps those of a polygon's corners that are not
// outside, and adds a cut wherever the line between two of them passes from one side to the other; what leaves the
// region comes back along the boundary. Where nothing is inside, what is on the boundary has no area.
template <class Clipper, class Corners, class Near>
constexpr void clip_corners(Clipper& clipper, Corners& corners, std::size_t boundaries, const Near& is_near) {
  Corners kept;
  bool is_whole = true;
  for (std::size_t k = 0; k < boundaries; ++k) {
    bool any_inside = false, any_outside = false;
    for (auto& c : corners) {
      c.side = clipper.side(c, k);
      any_inside = any_inside || c.side > 0;
      any_outside = any_outside || c.side < 0;
    }
    if (!any_outside) continue;
    if (std::exchange(is_whole, false) && clipper.keeps_all(corners, k, boundaries, is_near)) return;
    kept.clear();
    kept.reserve(2 * corners.size() + 1);
    for (std::size_t i = 0; i < corners.size() && any_inside; ++i) {
      const auto &here = corners[i], &next = corners[i + 1 < corners.size() ? i + 1 : 0];
      if (here.side >= 0) kept.push_back(here);
      if (here.side * next.side < 0) kept.push_back(clipper.cut(here, next, k));
      if (here.side >= 0 && next.side < 0) kept.back().onward = clipper.along(k);
    }
    std::swap(corners, kept);
  }
}

// Writes what fits, and counts on. What the polygon comes in by is left out where the vertex before stands.
template <class V>
struct span_sink {
  V* out;
  std::size_t room, count = 0;
  bool after_cut = false;

  IRG_INLINE constexpr void put(const V& v) {
    if (count < room) out[count] = v;
    ++count;
  }
  IRG_INLINE constexpr void enter(const V& v) {
    if (count == 0 || count > room || !same_place(position_of(out[count - 1]), position_of(v))) put(v);
  }
  // A cut at the place of the corner before or after it is left out.
  constexpr void put(const V& v, bool is_cut) {
    if (0 < count && count <= room && (is_cut || after_cut) &&
        same_place(position_of(out[count - 1]), position_of(v))) {
      if (is_cut) return;
      --count;
    }
    put(v);
    after_cut = is_cut;
  }
  // The number of vertices; none where no area can be left.
  constexpr std::size_t finished() {
    while (count > 1 && count <= room && same_place(position_of(out[count - 1]), position_of(out[0]))) --count;
    return count < 3 ? 0 : count;
  }
};

template <class V, class F, class Sink>
constexpr void clip_by_window(std::span<const V> polygon, const box<vertex_scalar<V>, 2>& window, const F& interpolate,
                              Sink& sink) {
  const std::size_t n = polygon.size();
  const auto edge = [&](std::ptrdiff_t i) -> const V& {
    const auto k = static_cast<std::size_t>(i);
    return polygon[k < n ? k : 0];
  };
  window_pipe<V, F, decltype(edge), Sink> pipe(window, interpolate, edge, sink);
  constexpr std::integral_constant<int, 0> start;
  unsigned last = 16;  // no code
  bool passed_over = false;
  for (std::size_t i = 0; i < n; ++i) {
    const V& v = polygon[i];
    const unsigned code = window_code(v, window);
    if (code == last) {  // most vertices are where the one before is
      passed_over = true;
      if (code == 0) sink.put(v);
      continue;
    }
    if (passed_over) pipe.pass_over(start, polygon[i - 1]);
    passed_over = false;
    pipe.take(start, v, static_cast<std::ptrdiff_t>(i) - 1, false);
    last = code;
  }
  if (passed_over) pipe.pass_over(start, polygon[n - 1]);
  pipe.close(start, static_cast<std::ptrdiff_t>(n) - 1);
}

template <int D, class V, class Boundary, class F, class Sink, class Near>
constexpr void clip_by_half_spaces(std::span<const V> polygon, std::size_t boundaries, const Boundary& boundary,
                                   const F& interpolate, Sink& sink, const Near& is_near) {
  convex_clipper<D, V, Boundary, F> clipper(polygon, boundary, interpolate);
  std::vector<clipped_corner<V>> corners;
  corners.reserve(2 * polygon.size() + boundaries);
  for (std::size_t i = 0; i < polygon.size(); ++i) corners.push_back(clipper.given(i));
  clip_corners(clipper, corners, boundaries, is_near);
  for (const auto& c : corners) sink.put(clipper.vertex_of(c), c.line != c.none);
}

template <class V, class Region, class F, class Sink>
constexpr void clip_into(std::span<const V> polygon, const Region& region, const F& interpolate, Sink& sink) {
  using T = vertex_scalar<V>;
  if (polygon.size() < 3) return;
  for (const V& v : polygon)
    if (!is_finite(position_of(v))) return;
  if constexpr (is_window_for<Region, V>) {
    if (!region.empty()) clip_by_window(polygon, region, interpolate, sink);
  } else if constexpr (convex_ring_for<Region, V>) {
    for (std::size_t i = 0; i < ring_size(region); ++i)
      if (!is_finite(ring_vertex(region, i))) return;
    const int turn = turn_of_convex(region);
    if (turn == 0) return;
    const auto edge = [&](std::size_t i) { return half_space_at(region, i, turn); };
    // Where all half-spaces reach a place and it is in the region's box, too, nothing separates the two.
    const auto in_box = [&](const auto& p) {
      box<T, 2> extent;
      for (std::size_t i = 0; i < ring_size(region); ++i) {
        const auto q = ring_vertex(region, i);
        extent = bounding_box(extent, point<T, 2>{coordinate(q, 0), coordinate(q, 1)});
      }
      return contains(extent, point<T, 2>{coordinate(p, 0), coordinate(p, 1)});
    };
    clip_by_half_spaces<2>(polygon, ring_size(region), edge, interpolate, sink, in_box);
  } else {
    const std::span<const plane<T>> planes(region);
    for (const plane<T>& p : planes)
      if (!is_finite(p)) return;
    const auto boundary = [&](std::size_t i) {
      return half_space<T, 3>{{planes[i].a, planes[i].b, planes[i].c, planes[i].d}};
    };
    clip_by_half_spaces<3>(polygon, planes.size(), boundary, interpolate, sink, [](const auto&) { return true; });
  }
}

}  // namespace IRG_ABI
}  // namespace irg::detail

namespace irg::inline IRG_ABI {

template <VertexRange R, class Region, class F>
  requires ClipRegion<Region, range_vertex<R>> && VertexInterpolation<F, range_vertex<R>>
constexpr std::size_t clip_sutherland_hodgman(const R& polygon, const Region& region,
                                              std::type_identity_t<std::span<range_vertex<R>>> out,
                                              const F& interpolate) {
  using V = range_vertex<R>;
  const std::span<const V> given(std::data(polygon), static_cast<std::size_t>(std::size(polygon)));
  if constexpr (Point<V> && Floating<vertex_scalar<V>> && detail::is_window_for<Region, V>)
    if (given.size() >= 3 && given.size() <= detail::few_vertices && region.low.x < region.high.x &&
        region.low.y < region.high.y)
      if (const auto count = detail::clip_few(given, region, out); count >= 0) return static_cast<std::size_t>(count);
  detail::span_sink<V> sink{out.data(), out.size()};
  detail::clip_into(given, region, interpolate, sink);
  return sink.finished();
}

template <VertexRange R, class Region, class F>
  requires ClipRegion<Region, range_vertex<R>> && VertexInterpolation<F, range_vertex<R>>
[[nodiscard]] constexpr std::vector<range_vertex<R>> clip_sutherland_hodgman(const R& polygon, const Region& region,
                                                                             const F& interpolate) {
  using V = range_vertex<R>;
  if (std::size(polygon) == 0) return {};
  const V& any = *std::data(polygon);  // V{} of a foreign type may leave its numbers as they are
  std::vector<V> kept(static_cast<std::size_t>(std::size(polygon)) * 2 + 8, any);
  std::size_t count = clip_sutherland_hodgman(polygon, region, std::span<V>(kept), interpolate);
  if (count > kept.size()) {
    kept.resize(count, any);
    count = clip_sutherland_hodgman(polygon, region, std::span<V>(kept), interpolate);
  }
  kept.resize(count, any);
  return kept;
}

}  // namespace irg::inline IRG_ABI
