// SPDX-License-Identifier: MIT
// Weiler and Atherton's clipping, as they tell it: both polygons are lists of vertices, into which the points are put
// where the boundaries cross. Those where the subject enters the clip polygon make one list, those where it leaves
// another. From an entering point the walk follows the subject, from a leaving point the clip polygon, until it is back
// at its start. It takes polygons in general position only; polygon_boolean (geometry/polygon_overlay.hpp) takes all.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <irg/geometry/intersect_lines.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/point_in_polygon.hpp>
#include <irg/geometry/polygon.hpp>

namespace irg::textbook {

/// How Weiler and Atherton's clipping ended. `touching`: a vertex lies on the other polygon's boundary, or
/// entering and leaving points do not take turns: two crossings are too near to each other to be told apart, or rings
/// are not as they should be.
enum class [[nodiscard]] weiler_atherton_status {
  ok,
  touching,
  not_finite,
  done [[deprecated("irg: done is now ok")]] = ok
};

/// The common part of two polygons, and the two lists of the method.
/// shape   rings directed as the polygons'; entering and leaving have a meaning where the status is `ok`
template <Floating T>
struct weiler_atherton_clip {
  weiler_atherton_status status = weiler_atherton_status::ok;
  std::vector<std::vector<point<T, 2>>> rings{};
  std::vector<point<T, 2>> entering{}, leaving{};
};

}  // namespace irg::textbook

namespace irg::detail {

inline constexpr std::size_t no_crossing = static_cast<std::size_t>(-1);

// An entry in a polygon's list: a vertex, or a crossing with its place in the list of crossings.
template <class T>
struct listed_vertex {
  point<T, 2> at;
  T along;  // from the edge's start, 0 to 1
  std::size_t edge, crossing;
  std::size_t next = 0;
};

template <class T>
struct listed_crossing {
  point<T, 2> at;
  bool enters;
  std::size_t in_list[2] = {};
};

inline namespace IRG_ABI {

// The lists of the subject (0) and the clip polygon (1).
template <class T>
struct weiler_atherton_lists {
  std::vector<listed_vertex<T>> list[2];
  std::vector<listed_crossing<T>> crossings;
  std::vector<std::size_t> next_edge[2], first_edge[2];  // of an edge's ring; of each ring, and one past the last
  bool touching = false;

  template <class Polygon>
  constexpr void add_vertices(int which, const Polygon& polygon) {
    for (std::size_t r = 0; r < ring_count(polygon); ++r) {
      const auto& ring = ring_of(polygon, r);
      const std::size_t first = next_edge[which].size(), n = ring_size(ring);
      first_edge[which].push_back(first);
      for (std::size_t i = 0; i < n; ++i) {
        const auto v = ring_vertex(ring, i);
        const point<T, 2> at{static_cast<T>(coordinate(v, 0)), static_cast<T>(coordinate(v, 1))};
        list[which].push_back({at, T(0), first + i, no_crossing});
        next_edge[which].push_back(i + 1 < n ? first + i + 1 : first);
      }
    }
    first_edge[which].push_back(next_edge[which].size());
  }

  // Every edge of the subject against every edge of the clip polygon, then the crossings into both lists.
  constexpr void add_crossings() {
    const std::vector<listed_vertex<T>> subject = list[0], clip = list[1];
    for (const auto& a : subject)
      for (const auto& c : clip) cross(a, subject[next_edge[0][a.edge]], c, clip[next_edge[1][c.edge]]);
    for (int which = 0; which < 2; ++which) {
      link(which);
      for (const auto& c : crossings) {
        const std::size_t next = list[which][next_crossing(which, c.in_list[which])].crossing;
        touching = touching || crossings[next].enters == c.enters;  // entering and leaving take turns
      }
    }
  }

  constexpr void cross(const listed_vertex<T>& a, const listed_vertex<T>& b, const listed_vertex<T>& c,
                       const listed_vertex<T>& d) {
    const int at_a = orient2d(c.at, d.at, a.at), at_b = orient2d(c.at, d.at, b.at);
    const int at_c = orient2d(a.at, b.at, c.at), at_d = orient2d(a.at, b.at, d.at);
    if (at_a * at_b > 0 || at_c * at_d > 0) return;
    if (at_a * at_b == 0 || at_c * at_d == 0) {
      const auto lies_on = [](const point<T, 2>& p, const point<T, 2>& q, const point<T, 2>& v, int side) {
        return side == 0 && is_between(p, q, v);
      };
      touching = touching || lies_on(c.at, d.at, a.at, at_a) || lies_on(c.at, d.at, b.at, at_b) ||
                 lies_on(a.at, b.at, c.at, at_c) || lies_on(a.at, b.at, d.at, at_d);
      return;
    }
    const auto m = intersect_lines(a.at, b.at, c.at, d.at);
    list[0].push_back({m.at, m.t, a.edge, crossings.size()});
    list[1].push_back({m.at, m.s, c.edge, crossings.size()});
    crossings.push_back({m.at, at_a < 0});
  }

  // Sorts the crossings in between the vertices, and says for each entry which is next.
  constexpr void link(int which) {
    auto& entries = list[which];
    const auto& next_of = next_edge[which];
    std::sort(entries.begin(), entries.end(), [](const auto& p, const auto& q) {
      if (p.edge != q.edge) return p.edge < q.edge;
      return p.along != q.along ? p.along < q.along : p.crossing == no_crossing && q.crossing != no_crossing;
    });
    std::vector<std::size_t> first(next_of.size(), std::size_t{0});
    for (std::size_t i = 0; i < entries.size(); ++i)
      (entries[i].crossing == no_crossing ? first[entries[i].edge] : crossings[entries[i].crossing].in_list[which]) = i;
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const bool more = i + 1 < entries.size() && entries[i + 1].edge == entries[i].edge;
      touching = touching || (more && !(entries[i].along < entries[i + 1].along));
      entries[i].next = more ? i + 1 : first[next_of[entries[i].edge]];
    }
  }

  constexpr std::size_t next_crossing(int which, std::size_t i) const noexcept {
    do i = list[which][i].next;
    while (list[which][i].crossing == no_crossing);
    return i;
  }

  // From an entering point along the subject, from a leaving one along the clip polygon, back to the start.
  constexpr std::vector<point<T, 2>> walk(std::size_t start, std::vector<char>& walked) const {
    std::vector<point<T, 2>> ring;
    std::size_t at = start;
    do {
      walked[at] = 1;
      const int which = crossings[at].enters ? 0 : 1;
      const std::size_t first = crossings[at].in_list[which], last = next_crossing(which, first);
      for (std::size_t i = first; i != last; i = list[which][i].next) ring.push_back(list[which][i].at);
      at = list[which][last].crossing;
    } while (at != start);
    return ring;
  }

  // The r-th ring, or nothing where it is crossed.
  constexpr std::vector<point<T, 2>> uncrossed_ring(int which, std::size_t r) const {
    std::vector<point<T, 2>> ring;
    for (const auto& v : list[which]) {
      if (v.edge < first_edge[which][r] || v.edge >= first_edge[which][r + 1]) continue;
      if (v.crossing != no_crossing) return {};
      ring.push_back(v.at);
    }
    return ring;
  }
};

}  // namespace IRG_ABI
}  // namespace irg::detail

namespace irg::textbook::inline IRG_ABI {

/// The part of the subject within the clip polygon, by Weiler and Atherton's walk along entering and leaving points.
/// shape   rings or lists of rings: outer ones counter-clockwise, holes clockwise (y up), of floats, doubles or
///         integers of up to 32 bits, whose crossings are doubles
/// needs   rings that neither cross themselves nor another ring of the same polygon
/// gives   a ring per part; status `touching`, and no rings, outside of general position
/// exact   which edges cross, and what enters, is decided exactly; crossings within 0.501 ulp
/// cost    each edge against each edge of the other polygon; allocates
/// source  Weiler and Atherton 1977
template <PlanePolygon A, PlanePolygon B>
  requires OverlayScalar<scalar_of<polygon_point<A>>> &&
           std::same_as<scalar_of<polygon_point<A>>, scalar_of<polygon_point<B>>>
[[nodiscard]] constexpr auto clip_weiler_atherton(const A& subject, const B& clip) {
  using S = scalar_of<polygon_point<A>>;
  using T = std::conditional_t<Floating<S>, S, double>;
  weiler_atherton_clip<T> result;
  const auto ended = [&](weiler_atherton_status status) { return result.status = status, result; };
  if (!irg::is_finite(subject) || !irg::is_finite(clip)) return ended(weiler_atherton_status::not_finite);
  detail::weiler_atherton_lists<T> lists;
  lists.add_vertices(0, subject);
  lists.add_vertices(1, clip);
  lists.add_crossings();
  if (lists.touching) return ended(weiler_atherton_status::touching);
  for (const auto& c : lists.crossings) (c.enters ? result.entering : result.leaving).push_back(c.at);
  std::vector<char> walked(lists.crossings.size(), char{0});
  for (std::size_t k = 0; k < lists.crossings.size(); ++k)
    if (lists.crossings[k].enters && walked[k] == 0) result.rings.push_back(lists.walk(k, walked));
  // Rings that nothing crosses are within the other polygon, or they are not.
  const auto keep_uncrossed = [&]<class Q>(int which, const Q& other) {
    const auto is_inside = [&](const point<T, 2>& v) {  // of a vertex given, in the type given
      const auto p = generate_coordinates<polygon_point<Q>>([&](int i) { return static_cast<S>(v[i]); });
      return point_in_polygon(other, p) == location::inside;
    };
    for (std::size_t r = 0; r + 1 < lists.first_edge[which].size(); ++r)
      if (const auto ring = lists.uncrossed_ring(which, r); !ring.empty() && is_inside(ring[0]))
        result.rings.push_back(ring);
  };
  keep_uncrossed(0, clip), keep_uncrossed(1, subject);
  return ended(weiler_atherton_status::ok);
}

}  // namespace irg::textbook::inline IRG_ABI
