// SPDX-License-Identifier: MIT
// Cohen and Sutherland's line clipping: an end beyond a boundary is moved to that boundary, again and again, until the
// codes of the ends tell that what is left is inside or beyond one boundary.
#pragma once

#include <optional>

#include <irg/geometry/vocabulary.hpp>
#include <irg/geometry/detail/line_window.hpp>

namespace irg {

namespace detail::inline IRG_ABI {

// An end on its way: on which side of the window it is along each axis, and the boundary that it was moved to. There
// its other coordinate is rounded; its place is that of the exact one.
struct moving_end {
  int place[2];
  window_side cut{};
};

template <Point P>
constexpr moving_end moved_to(const P& a, const P& b, const box<scalar_of<P>, 2>& window, window_side at) noexcept {
  moving_end end{{0, 0}, at};
  const int other = 1 - at.axis;
  const auto y = coordinate(intersection_point(a, b, window, at), other);
  int place = place_of(y, window, other);
  for (const int side : {-1, 1})  // rounded to the corner: from within, or from beyond?
    if (const window_side edge{other, side}; place == 0 && y == bound_of(window, edge)) {
      const int beyond = compare_crossings(a, b, window, at, edge);
      const bool outwards = (coordinate(a, other) < coordinate(b, other)) == (side > 0);
      if (beyond != 0 && (beyond > 0) == outwards && coordinate(a, other) != coordinate(b, other)) place = side;
    }
  end.place[other] = place;
  return end;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The part of the segment from a to b that lies in the window.
/// gives   as clip_line_liang_barsky, bit for bit
/// exact   as clip_line_liang_barsky: an end is always moved along the line from a to b, never along what rounding has
///         made of it
/// cost    two codes when both ends are inside or beyond one boundary; else up to four divisions, where Liang and
///         Barsky's and Nicholl, Lee and Nicholl's need two: about twice their time for the same result. It is here
///         because it is taught, and for codes that are known already
/// source  Newman and Sproull 1973 (Cohen and Sutherland)
template <Point P>
  requires(size_of<P> == 2)
[[nodiscard]] constexpr std::optional<clipped_line<P>> clip_line_cohen_sutherland(
    const P& a, const P& b, const box<scalar_of<P>, 2>& window) noexcept {
  if (window.empty()) return std::nullopt;
  if (detail::is_within(a, window) && detail::is_within(b, window)) return clipped_line<P>{a, b};
  if (!is_finite(a, b)) return std::nullopt;
  const auto end_at = [&](const P& p) {
    return detail::moving_end{
        {detail::place_of(coordinate(p, 0), window, 0), detail::place_of(coordinate(p, 1), window, 1)}};
  };
  detail::moving_end ends[2] = {end_at(a), end_at(b)};
  for (;;) {
    for (int i = 0; i < 2; ++i)
      if (ends[0].place[i] != 0 && ends[0].place[i] == ends[1].place[i]) return std::nullopt;
    int outside = 0;
    while (outside < 2 && ends[outside].place[0] == 0 && ends[outside].place[1] == 0) ++outside;
    if (outside == 2) break;
    const int axis = ends[outside].place[0] != 0 ? 0 : 1;
    ends[outside] = detail::moved_to(a, b, window, {axis, ends[outside].place[axis]});
  }
  return detail::line_between(a, b, window, ends[0].cut, ends[1].cut);
}

IRG_REFUSES_VECTORS(clip_line_cohen_sutherland);

}  // namespace IRG_ABI
}  // namespace irg
