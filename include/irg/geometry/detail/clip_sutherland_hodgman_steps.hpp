// SPDX-License-Identifier: MIT
// The steps of clip_sutherland_hodgman.hpp.
#pragma once

#include <span>
#include <vector>

#include <irg/geometry/clipped_line.hpp>
#include <irg/geometry/detail/convex_clipper.hpp>
#include <irg/geometry/detail/window_pipe.hpp>
#include <irg/geometry/detail/window_walk_kernel.hpp>

namespace irg {
namespace detail::inline IRG_ABI {

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

}  // namespace detail::inline IRG_ABI

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

namespace detail::inline IRG_ABI {

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
    if (count == 0 || count > room || !at_one_place(position_of(out[count - 1]), position_of(v))) put(v);
  }
  // A cut at the place of the corner before or after it is left out.
  constexpr void put(const V& v, bool is_cut) {
    if (0 < count && count <= room && (is_cut || after_cut) &&
        at_one_place(position_of(out[count - 1]), position_of(v))) {
      if (is_cut) return;
      --count;
    }
    put(v);
    after_cut = is_cut;
  }
  // The number of vertices; none where no area can be left.
  constexpr std::size_t finished() {
    while (count > 1 && count <= room && at_one_place(position_of(out[count - 1]), position_of(out[0]))) --count;
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
    if (!is_empty(region)) clip_by_window(polygon, region, interpolate, sink);
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
        extent = enclosing_box(extent, point<T, 2>{coordinate(q, 0), coordinate(q, 1)});
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

}  // namespace detail::inline IRG_ABI
}  // namespace irg
