// SPDX-License-Identifier: MIT
// Where a point lies against a convex polygon: edge by edge where there are few, beyond in logarithmic time.
#pragma once

#include <cstddef>

#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/point_in_polygon.hpp>
#include <irg/geometry/polygon.hpp>

namespace irg {
namespace detail::inline IRG_ABI {

// Edge by edge; ends at the first two edges that see p on different sides.
template <PlaneRing R>
constexpr location locate_by_edges(const R& ring, const ring_point<R>& p) noexcept {
  int side = 0;
  for (std::size_t i = 0; i < ring_size(ring); ++i) {
    const auto a = ring_vertex(ring, i), b = ring_vertex(ring, i + 1);
    const int turn = orient2d(a, b, p);
    if (turn == 0 && is_between(a, b, p)) return location::boundary;
    if (turn != 0 && turn == -side) return location::outside;
    if (turn != 0) side = turn;
  }
  return side == 0 ? location::outside : location::inside;
}

// The vertices of a convex ring as seen from the first: those that stand there, too, are passed over.
template <PlaneRing R>
class convex_fan {
public:
  constexpr explicit convex_fan(const R& ring) noexcept : ring_(ring), first_(1), last_(ring_size(ring) - 1) {
    while (first_ <= last_ && same_place(vertex(0), vertex(first_))) ++first_;
    while (last_ > first_ && same_place(vertex(0), vertex(last_))) --last_;
  }

  constexpr location locate(const ring_point<R>& p) const noexcept {
    if (same_place(vertex(0), p)) return location::boundary;
    if (first_ > last_) return location::outside;
    const int side = direction();
    if (side == 0) return locate_by_edges(ring_, p);
    const int at_first = side * from_start(first_, p), at_last = side * from_start(last_, p);
    if (at_first < 0 || at_last > 0) return location::outside;
    if (at_first == 0 && same_way(first_, p)) return on_first_side(side, p);
    if (at_last == 0 && same_way(last_, p)) return on_last_side(side, p);
    if (at_first == 0 || at_last == 0) return location::outside;
    std::size_t low = first_, high = last_;
    while (high - low > 1) {
      const std::size_t middle = low + (high - low) / 2;
      (side * from_start(middle, p) >= 0 ? low : high) = middle;
    }
    return static_cast<location>(side * orient2d(vertex(low), vertex(high), p));
  }

private:
  const R& ring_;
  std::size_t first_, last_;  // the ends of the fan

  constexpr ring_point<R> vertex(std::size_t i) const noexcept { return ring_vertex(ring_, i); }
  constexpr int from_start(std::size_t i, const ring_point<R>& p) const noexcept {
    return orient2d(vertex(0), vertex(i), p);
  }
  // Whether p, on the line through vertices 0 and i, lies in the direction of vertex i.
  constexpr bool same_way(std::size_t i, const ring_point<R>& p) const noexcept {
    return comes_before(vertex(0), vertex(i)) == comes_before(vertex(0), p);
  }

  // 1 for counter-clockwise, -1 for clockwise, 0 for a polygon without area.
  constexpr int direction() const noexcept {
    if (const int turn = from_start(first_, vertex(last_)); turn != 0) return turn;
    if (same_way(first_, vertex(last_))) return 0;
    std::size_t low = first_, high = last_;  // vertex 0 is within a side: ahead of it and behind it the others begin
    while (high - low > 1) {
      const std::size_t middle = low + (high - low) / 2;
      if (const int turn = from_start(first_, vertex(middle)); turn != 0) return turn;
      (same_way(first_, vertex(middle)) ? low : high) = middle;
    }
    return 0;
  }

  // p is on the ray from vertex 0 along its first side: is it before the end of that side?
  constexpr location on_first_side(int side, const ring_point<R>& p) const noexcept {
    std::size_t low = first_, high = last_ + 1;
    while (high - low > 1) {
      const std::size_t middle = low + (high - low) / 2;
      const bool straight = side * from_start(first_, vertex(middle)) == 0 && same_way(first_, vertex(middle));
      (straight ? low : high) = middle;
    }
    return is_between(vertex(0), vertex(low), p) ? location::boundary : location::outside;
  }
  constexpr location on_last_side(int side, const ring_point<R>& p) const noexcept {
    std::size_t low = first_ - 1, high = last_;
    while (high - low > 1) {
      const std::size_t middle = low + (high - low) / 2;
      const bool straight = side * from_start(last_, vertex(middle)) == 0 && same_way(last_, vertex(middle));
      (straight ? high : low) = middle;
    }
    return is_between(vertex(0), vertex(high), p) ? location::boundary : location::outside;
  }
};

// By a binary search among the triangles from the first vertex.
template <PlaneRing R>
constexpr location locate_by_fan(const R& ring, const ring_point<R>& p) noexcept {
  return ring_size(ring) == 0 ? location::outside : convex_fan<R>(ring).locate(p);
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// Where p lies against a convex polygon, which may run either way round and have collinear and repeated vertices.
/// needs   is_convex(ring)
/// gives   the boundary for all points of a polygon without area (a point, a segment); `outside` for an empty ring and
///         when a coordinate of p is NaN or infinite
/// exact   for all finite floats and all integers; other scalars: as exact as their own + - * are
/// cost    up to 16 vertices at most one turn for each edge; beyond, a search of about 2 + log2(n) turns, and a
///         comparison for each vertex that stands where the first does. A polygon without area is looked at edge by
///         edge
/// source  Mihajlovic 2016, rules 3.3 and 3.4; Preparata and Shamos 1985 (the search)
template <PlaneRing R>
[[nodiscard]] constexpr location point_in_convex_polygon(const R& ring, const ring_point<R>& p) noexcept {
  if (!is_finite(p)) return location::outside;
  return ring_size(ring) <= 16 ? detail::locate_by_edges(ring, p) : detail::locate_by_fan(ring, p);
}

IRG_RENAMED(point_in_convex_polygon_log, point_in_convex_polygon)

}  // namespace IRG_ABI
}  // namespace irg
