// SPDX-License-Identifier: MIT
// Trimmed rows.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <irg/core/is_finite.hpp>
#include <irg/curve/surface_tessellation.hpp>
#include <irg/geometry/polygon.hpp>
#include <irg/geometry/triangulate_monotone.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

// Where the edge from a to b meets the line on which the coordinate `axis` is `at`; from b to a the same bits.
template <Floating T>
constexpr point<T, 2> edge_at(const point<T, 2>& a, const point<T, 2>& b, int axis, T at) noexcept {
  const T scale = is_finite(b[axis] - a[axis]) ? T(1) : T(0.5);
  const T length = b[axis] * scale - a[axis] * scale;  // exact products
  const curve_parameter<T> share{(b[axis] - at) * scale / length, (at - a[axis]) * scale / length};
  point<T, 2> p = blend(a, b, share);
  p[axis] = at;
  return p;
}

// Cuts a convex polygon by such a line: what is below goes to `below`, what is above stays.
template <Floating T>
constexpr void cut_off_below(std::vector<point<T, 2>>& polygon, int axis, T at, std::vector<point<T, 2>>& below,
                             std::vector<point<T, 2>>& above) {
  below.clear();
  above.clear();
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const point<T, 2>&p = polygon[k], &q = polygon[k + 1 < polygon.size() ? k + 1 : 0];
    if (p[axis] <= at) below.push_back(p);
    if (p[axis] >= at) above.push_back(p);
    if ((p[axis] < at && at < q[axis]) || (q[axis] < at && at < p[axis])) {
      const point<T, 2> crossing = edge_at(p, q, axis, at);
      below.push_back(crossing);
      above.push_back(crossing);
    }
  }
  polygon.swap(above);
}

// Hands the parts of a convex polygon between successive lines to each(part); what is outside of all is left out.
template <Floating T, class Each>
constexpr void each_part(std::vector<point<T, 2>> polygon, int axis, const patch_cuts& cuts, const Each& each) {
  std::vector<point<T, 2>> below, above;
  for (std::size_t k = 0; k < cuts.places.size() && polygon.size() > 2; ++k) {
    cut_off_below(polygon, axis, static_cast<T>(cuts[k]) / static_cast<T>(patch_steps), below, above);
    if (k > 0 && below.size() > 2) each(below);
  }
}

}  // namespace IRG_ABI
}  // namespace irg::detail
