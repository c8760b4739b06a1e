// SPDX-License-Identifier: MIT
// The angles of the perimeter method about the vanishing point of upright lines, as the source has them: numbers that
// grow with an angle, and the order of a facet's corners by it. grid_surface.hpp has what crosses a perimeter.
#pragma once

#include <array>

#include <irg/core/config.hpp>

namespace irg::textbook {

/// A corner of a facet: steps along x and z from its least one.
struct facet_corner {
  int di = 0, dj = 0;
  friend constexpr bool operator==(const facet_corner&, const facet_corner&) = default;
};

inline namespace IRG_ABI {

/// A number that grows with the angle of (x, y) from -45 degrees (-1) to 315 (7): 0 at 0, 2 at 90, 4 at 180, 6 at 270.
/// gives   NaN for (0, 0)
/// source  Special-cases chapter, 3 (pseudo-angles)
[[nodiscard]] constexpr double pseudo_angle(double x, double y) noexcept {
  const double wide = x < 0 ? -x : x, tall = y < 0 ? -y : y;
  if (wide >= tall) return x > 0 ? y / x : 4 + y / x;
  return y > 0 ? 2 - x / y : 6 - x / y;
}

/// Whether pseudo-angle a comes before b by less than half a turn.
/// exact   0 < (b - a mod 8) < 4, where the source's own test holds both ways round for 0 and 6
/// source  Special-cases chapter, 3 (pseudo-angles)
[[nodiscard]] constexpr bool angle_precedes(double a, double b) noexcept {
  const double apart = b - a, turned = apart < 0 ? apart + 8 : apart;
  return 0 < turned && turned < 4;
}

/// Whether the walk along a perimeter and a facet at once goes on along the perimeter: where its next vertex comes
/// before the facet's; at equal angles the facet goes on.
/// source  Special-cases chapter, 3 (simultaneous traversal)
[[nodiscard]] constexpr bool advances_perimeter(double next_on_perimeter, double next_on_facet) noexcept {
  return angle_precedes(next_on_perimeter, next_on_facet);
}

/// The corners of facet (i, j) by turning angle about the facet (k, l), which holds the vanishing point: F1 has the
/// least angle. Beside it in one coordinate F1 to F4 run round the facet; in both, F2 is the near corner, F3 the far
/// one.
/// gives   the corners counter-clockwise from (0, 0) for the facet (k, l) itself
/// source  Special-cases chapter, 3 (figure 3.37), and the four positions that its code leaves out
[[nodiscard]] constexpr std::array<facet_corner, 4> facet_corner_order(int i, int j, int k, int l) noexcept {
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

}  // namespace IRG_ABI
}  // namespace irg::textbook
