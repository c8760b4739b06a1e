// SPDX-License-Identifier: MIT
// The steps of the perimeter method as the source has them, in the plane of the picture and in the numbers that come:
// angles about the vanishing point of upright lines, the order of a facet's corners, which of its edges can leave a
// perimeter, and how an edge crosses one; and the facets with their corners transformed, one row of which is kept.
// `visible_grid_edges` decides the same exactly, and transforms nothing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include <irg/core/scalar.hpp>
#include <irg/hidden/grid_covering_order.hpp>
#include <irg/math/vec.hpp>

namespace irg::textbook {

/// A corner of a facet: steps along x and z from its least one.
struct facet_corner {
  int di = 0, dj = 0;
  friend constexpr bool operator==(const facet_corner&, const facet_corner&) = default;
};

/// Corners of a new facet that an edge can join beyond each perimeter, as numbers in the source's order: 134 is F1, F3,
/// F4; 0 is none.
struct leaving_corners {
  int outer = 0, inner = 0;
  friend constexpr bool operator==(const leaving_corners&, const leaving_corners&) = default;
};

/// How an edge of a facet meets one of a perimeter that runs counter-clockwise, y up.
enum class perimeter_crossing { none, outwards, inwards };

/// What is remembered of the vertices that were transformed: nothing, so that each is transformed anew for every facet
/// at it, or the row on which the next facets stand.
enum class vertex_memory { none, row };

/// How much was done to transform the vertices of all facets.
struct transform_counts {
  std::int64_t facets = 0, transforms = 0;
};

inline namespace IRG_ABI {

/// A number that grows with the angle of (x, y) from -45 degrees (-1) to 315 (7): 0 at 0, 2 at 90, 4 at 180, 6 at 270.
/// gives   NaN for (0, 0)
/// source  Special-cases chapter, 3 (pseudo-angles)
template <Floating T>
[[nodiscard]] constexpr T pseudo_angle(T x, T y) noexcept {
  const T wide = x < 0 ? -x : x, tall = y < 0 ? -y : y;
  if (wide >= tall) return x > 0 ? y / x : 4 + y / x;
  return y > 0 ? 2 - x / y : 6 - x / y;
}

/// Whether pseudo-angle a comes before b by less than half a turn.
/// exact   0 < (b - a mod 8) < 4, where the source's own test holds both ways round for 0 and 6
/// source  Special-cases chapter, 3 (pseudo-angles)
template <Floating T>
[[nodiscard]] constexpr bool angle_precedes(T a, T b) noexcept {
  const T apart = b - a, turned = apart < 0 ? apart + 8 : apart;
  return 0 < turned && turned < 4;
}

/// The corners of facet (i, j) by turning angle about the facet (k, l), which holds the vanishing point: F1 has the
/// least angle. Beside it in one coordinate F1 to F4 run round the facet; in both, F2 is the near corner, F3 the far
/// one.
/// gives   the corners counter-clockwise from (0, 0) for the facet (k, l) itself
/// source  Special-cases chapter, 3 (figure 3.37), and the four positions that its code leaves out
template <class Int>
[[nodiscard]] constexpr std::array<facet_corner, 4> facet_corner_order(Int i, Int j, Int k, Int l) noexcept {
  if (i != k && j != l) {
    const int near_i = i > k ? 0 : 1, near_j = j > l ? 0 : 1;
    const facet_corner nearest{near_i, near_j}, farthest{1 - near_i, 1 - near_j};
    const facet_corner along_x{1 - near_i, near_j}, along_z{near_i, 1 - near_j};
    const bool x_first = (i > k) == (j > l);
    return {x_first ? along_x : along_z, nearest, farthest, x_first ? along_z : along_x};
  }
  facet_corner c{0, 0};
  if (i == k && j > l) c = {1, 0};
  if (i == k && j < l) c = {0, 1};
  if (i < k) c = {1, 1};
  std::array<facet_corner, 4> order{};
  for (facet_corner& next : order) {
    next = c;
    (c.di == c.dj ? c.di : c.dj) ^= 1;
  }
  return order;
}

/// (b - a) x (c - a): positive where a, b, c turn left.
template <Point P>
  requires(size_of<P> == 2)
[[nodiscard]] constexpr auto turn_rounded(const P& a, const P& b, const P& c) noexcept {
  const auto way = [&](const P& to, int i) { return coordinate(to, i) - coordinate(a, i); };
  return way(b, 0) * way(c, 1) - way(b, 1) * way(c, 0);
}

/// Of a facet beside the eye in one coordinate, F1 to F4 by rising angle, F1F4 drawn: the corners whose edges can leave
/// a perimeter.
/// source  Special-cases chapter, 3 (tables I and II)
template <Point P>
  requires(size_of<P> == 2)
[[nodiscard]] constexpr leaving_corners leaving_side_corners(const std::array<P, 4>& f) noexcept {
  const scalar_of<P> zero(0);
  const bool second = zero < turn_rounded(f[0], f[3], f[1]);
  const bool third = zero < turn_rounded(f[0], f[3], f[2]);
  if (second == third) return second ? leaving_corners{0, 1234} : leaving_corners{1234, 0};
  return second ? leaving_corners{234, 123} : leaving_corners{123, 234};
}

/// Of a facet beside the eye in both coordinates, F2 its near corner, F3 its far one, F1F2 and F2F4 drawn: likewise.
/// source  Special-cases chapter, 3 (tables III and IV; ten arrangements, eight of which the signs tell apart)
template <Point P>
  requires(size_of<P> == 2)
[[nodiscard]] constexpr leaving_corners leaving_corner_corners(const std::array<P, 4>& f) noexcept {
  const scalar_of<P> zero(0);
  const bool second = zero < turn_rounded(f[0], f[3], f[1]);
  const bool third = zero < turn_rounded(f[0], f[1], f[2]);
  const bool fourth = zero < turn_rounded(f[1], f[3], f[2]);
  if (third && fourth) return {0, 134};
  if (!third && !fourth) return {134, 0};
  if (second) return third ? leaving_corners{34, 134} : leaving_corners{13, 134};
  return third ? leaving_corners{134, 13} : leaving_corners{134, 34};
}

/// Whether the edge from f1 to f2 crosses the perimeter's edge from p1 to p2, by half-open tests, so that a crossing at
/// a vertex counts once.
/// source  Special-cases chapter, 3 (the four cross products; its two labels are exchanged)
template <Point P>
  requires(size_of<P> == 2)
[[nodiscard]] constexpr perimeter_crossing crossing_of_perimeter(const P& p1, const P& p2, const P& f1,
                                                                 const P& f2) noexcept {
  const scalar_of<P> zero(0);
  const bool c1 = !(zero < turn_rounded(p1, p2, f1)), c2 = !(zero < turn_rounded(p1, p2, f2));
  const bool c3 = !(turn_rounded(f1, f2, p1) < zero), c4 = !(turn_rounded(f1, f2, p2) < zero);
  if (c1 && !c2 && c3 && !c4) return perimeter_crossing::inwards;
  if (!c1 && c2 && !c3 && c4) return perimeter_crossing::outwards;
  return perimeter_crossing::none;
}

/// Where the lines of the two edges meet.
/// needs   edges that cross
/// source  Special-cases chapter, 3 (procedure intersect)
template <Point P>
  requires(size_of<P> == 2 && Real<scalar_of<P>>)
[[nodiscard]] constexpr P meeting_with_perimeter(const P& p1, const P& p2, const P& f1, const P& f2) noexcept {
  const auto way = [](const P& from, const P& to, int i) { return coordinate(to, i) - coordinate(from, i); };
  const auto px = way(p1, p2, 0), py = way(p1, p2, 1), fx = way(f1, f2, 0), fy = way(f1, f2, 1);
  const auto s = (-way(f1, p1, 0) * py + way(f1, p1, 1) * px) / (-fx * py + fy * px);
  return from_coordinates<P>(coordinate(f1, 0) + s * fx, coordinate(f1, 1) + s * fy);
}

/// Whether the walk along a perimeter and a facet at once goes on along the perimeter: where its next vertex comes
/// before the facet's; at equal angles the facet goes on.
/// source  Special-cases chapter, 3 (simultaneous traversal)
template <Floating T>
[[nodiscard]] constexpr bool advances_perimeter(T next_on_perimeter, T next_on_facet) noexcept {
  return angle_precedes(next_on_perimeter, next_on_facet);
}

/// Calls visit(facet, corners) for the facets in covering order, corners[2*di + dj] being what transform(i, j) gives
/// for the facet's corner (di, dj). Returns how often it was asked.
/// needs   loops of covering_loops; a transform whose results have a default, and are the same when asked again
/// gives   with a row kept, each vertex transformed once where one loop covers the surface (as from a corner), else at
///         most twice: on the lines where loops meet, but once where all four do. Without: once for each facet at it
/// cost    memory for one row of m + 1 vertices, where all vertices together take (n + 1) (m + 1)
/// source  Special-cases chapter, 3 (storage; described there, not coded)
template <class Transform, class Visit>
constexpr transform_counts visit_transformed_facets(const grid_covering& c, const Transform& transform, Visit&& visit,
                                                    vertex_memory memory = vertex_memory::row) {
  using vertex = std::remove_cvref_t<decltype(transform(0, 0))>;
  transform_counts counts;
  const auto ask = [&](int i, int j) {
    ++counts.transforms;
    return transform(i, j);
  };
  if (memory == vertex_memory::none) {
    visit_in_covering_order(c, [&](const grid_facet& f) {
      ++counts.facets;
      const std::array<vertex, 4> corners{ask(f.i - 1, f.j - 1), ask(f.i - 1, f.j), ask(f.i, f.j - 1), ask(f.i, f.j)};
      visit(f, corners);
    });
    return counts;
  }
  std::vector<vertex> row(static_cast<std::size_t>(c.m) + 1, vertex{});  // [j] is (i, j), for the line i that is behind
  const auto kept = [&](int j) -> vertex& { return row[static_cast<std::size_t>(j)]; };
  vertex start{};  // where the loops meet: each of them begins at it
  bool started = false;
  // From the lines `i` and `j` to n or 0 and m or 0.
  const auto loop = [&](int i, int last_i, int j_first, int last_j) {
    if (i == last_i || j_first == last_j) return;
    const int along_i = i < last_i ? 1 : -1, along_j = j_first < last_j ? 1 : -1;
    if (!started) start = ask(i, j_first);
    started = true;
    kept(j_first) = start;
    for (int j = j_first; j != last_j; j += along_j) kept(j + along_j) = ask(i, j + along_j);
    for (; i != last_i; i += along_i) {
      vertex behind = ask(i + along_i, j_first);
      for (int j = j_first; j != last_j; j += along_j) {
        vertex next = ask(i + along_i, j + along_j);
        std::array<vertex, 4> corners{};
        const std::size_t di = along_i > 0 ? 0 : 2, dj = along_j > 0 ? 0 : 1;  // of the corner that is reached first
        corners[di + dj] = kept(j), corners[di + (1 - dj)] = kept(j + along_j);
        corners[(2 - di) + dj] = behind, corners[(2 - di) + (1 - dj)] = next;
        ++counts.facets;
        visit(grid_facet{greater(i, i + along_i), greater(j, j + along_j)}, corners);
        kept(j) = behind;
        behind = next;
      }
      kept(last_j) = behind;
    }
  };
  for (const bool j_rises : {true, false}) {
    const int j = j_rises ? c.first_j - 1 : greater(0, c.last_j), last_j = j_rises ? c.m : 0;
    loop(c.first_i - 1, c.n, j, last_j);
    loop(greater(0, c.last_i), 0, j, last_j);
  }
  return counts;
}

}  // namespace IRG_ABI
}  // namespace irg::textbook
