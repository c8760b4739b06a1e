// SPDX-License-Identifier: MIT
// The steps of point_in_polygon.hpp.
#pragma once

#include <cstddef>
#include <optional>

#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/polygon.hpp>

namespace irg::detail::inline IRG_ABI {

// Adds the crossings of a ring with the ray to the right from p: upward ones count 1, downward ones -1. False when a
// coordinate is NaN or infinite.
template <PlaneRing R>
constexpr bool count_crossings(const R& ring, const ring_point<R>& p, int& winding, bool& on_edge) noexcept {
  const auto height = coordinate(p, 1);
  const std::size_t n = ring_size(ring);
  if (n == 0) return true;
  const auto level = [&](const ring_point<R>& v) {  // 1 above p, -1 below, 0 beside it
    return static_cast<int>(height < coordinate(v, 1)) - static_cast<int>(coordinate(v, 1) < height);
  };
  int from = level(ring_vertex(ring, n - 1));
  for (std::size_t i = 0; i < n; ++i) {
    const auto b = ring_traits<R>::vertex(ring, i);
    const int to = level(b);
    if (from * to <= 0) {  // NaN is beside everything
      const auto a = ring_vertex(ring, i == 0 ? n - 1 : i - 1);
      if (!is_finite(a, b)) return false;
      const int turn = orient2d(a, b, p);
      if (turn == 0 && is_between(a, b, p))
        on_edge = true;
      else if ((from > 0) != (to > 0) && (turn > 0) == (to > 0))
        winding += to > 0 ? 1 : -1;
    }
    from = to;
  }
  return is_finite(ring);
}

enum class crossing_count { counted, on_edge, not_finite };

template <PlanePolygon P>
constexpr crossing_count count_crossings_of(const P& polygon, const polygon_point<P>& p, int& winding) noexcept {
  bool on_edge = false;
  if (!is_finite(p) ||
      !each_ring(polygon, [&](const auto& ring) { return count_crossings(ring, p, winding, on_edge); }))
    return crossing_count::not_finite;
  return on_edge ? crossing_count::on_edge : crossing_count::counted;
}

}  // namespace irg::detail::inline IRG_ABI
