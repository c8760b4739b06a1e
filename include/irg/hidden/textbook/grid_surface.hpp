// SPDX-License-Identifier: MIT
// The steps of the perimeter method as the source has them, in the plane of the picture and in the numbers that come:
// which edges of a facet can leave a perimeter, and how an edge crosses one. facet_angles.hpp has the order of corners,
// transformed_facets.hpp the facets. `visible_grid_edges` decides the same exactly.
#pragma once

#include <array>

#include <irg/math/vec.hpp>

namespace irg::textbook {

/// Corners of a new facet that an edge can join beyond each perimeter, as numbers in the source's order: 134 is F1, F3,
/// F4; 0 is none.
struct leaving_corners {
  int outer = 0, inner = 0;
  friend constexpr bool operator==(const leaving_corners&, const leaving_corners&) = default;
};

/// How an edge of a facet meets one of a perimeter that runs counter-clockwise, y up.
enum class perimeter_crossing { none, outwards, inwards };

inline namespace IRG_ABI {

/// (b - a) x (c - a): positive where a, b, c turn left.
[[nodiscard]] constexpr double turn_rounded(const point<double, 2>& a, const point<double, 2>& b,
                                            const point<double, 2>& c) noexcept {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Of a facet beside the eye in one coordinate, F1 to F4 by rising angle, F1F4 drawn: the corners whose edges can leave
/// a perimeter.
/// source  Special-cases chapter, 3 (tables I and II)
[[nodiscard]] constexpr leaving_corners leaving_side_corners(const std::array<point<double, 2>, 4>& f) noexcept {
  const bool second = 0 < turn_rounded(f[0], f[3], f[1]);
  const bool third = 0 < turn_rounded(f[0], f[3], f[2]);
  if (second == third) return second ? leaving_corners{0, 1234} : leaving_corners{1234, 0};
  return second ? leaving_corners{234, 123} : leaving_corners{123, 234};
}

/// Of a facet beside the eye in both coordinates, F2 its near corner, F3 its far one, F1F2 and F2F4 drawn: likewise.
/// source  Special-cases chapter, 3 (tables III and IV; ten arrangements, eight of which the signs tell apart)
[[nodiscard]] constexpr leaving_corners leaving_corner_corners(const std::array<point<double, 2>, 4>& f) noexcept {
  const bool second = 0 < turn_rounded(f[0], f[3], f[1]);
  const bool third = 0 < turn_rounded(f[0], f[1], f[2]);
  const bool fourth = 0 < turn_rounded(f[1], f[3], f[2]);
  if (third && fourth) return {0, 134};
  if (!third && !fourth) return {134, 0};
  if (second) return third ? leaving_corners{34, 134} : leaving_corners{13, 134};
  return third ? leaving_corners{134, 13} : leaving_corners{134, 34};
}

/// Whether the edge from f1 to f2 crosses the perimeter's edge from p1 to p2, by half-open tests, so that a crossing at
/// a vertex counts once.
/// source  Special-cases chapter, 3 (the four cross products; its two labels are exchanged)
[[nodiscard]] constexpr perimeter_crossing crossing_of_perimeter(const point<double, 2>& p1, const point<double, 2>& p2,
                                                                 const point<double, 2>& f1,
                                                                 const point<double, 2>& f2) noexcept {
  const bool c1 = !(0 < turn_rounded(p1, p2, f1)), c2 = !(0 < turn_rounded(p1, p2, f2));
  const bool c3 = !(turn_rounded(f1, f2, p1) < 0), c4 = !(turn_rounded(f1, f2, p2) < 0);
  if (c1 && !c2 && c3 && !c4) return perimeter_crossing::inwards;
  if (!c1 && c2 && !c3 && c4) return perimeter_crossing::outwards;
  return perimeter_crossing::none;
}

/// Where the lines of the two edges meet.
/// needs   edges that cross
/// source  Special-cases chapter, 3 (procedure intersect)
[[nodiscard]] constexpr point<double, 2> meeting_with_perimeter(const point<double, 2>& p1, const point<double, 2>& p2,
                                                                const point<double, 2>& f1,
                                                                const point<double, 2>& f2) noexcept {
  const double px = p2.x - p1.x, py = p2.y - p1.y, fx = f2.x - f1.x, fy = f2.y - f1.y;
  const double s = (-(p1.x - f1.x) * py + (p1.y - f1.y) * px) / (-fx * py + fy * px);
  return {f1.x + s * fx, f1.y + s * fy};
}

}  // namespace IRG_ABI
}  // namespace irg::textbook
