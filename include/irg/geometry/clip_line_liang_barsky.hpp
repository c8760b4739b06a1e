// SPDX-License-Identifier: MIT
// Liang and Barsky's line clipping against a window or a box: each pair of parallel boundaries leaves an interval of
// the line's parameter, and the visible part is what the intervals have in common. The parameters are compared exactly,
// without being computed.
#pragma once

#include <optional>

#include <irg/geometry/vocabulary.hpp>
#include <irg/geometry/detail/line_window.hpp>

namespace irg::inline IRG_ABI {

/// The part of the segment from a to b that lies in the window, in any number of dimensions; the window's boundary
/// belongs to it.
/// gives   nothing when no point is visible, when the window is empty, when an end is NaN or infinite; a segment that
///         touches a corner or an edge in one point gives this point twice
/// exact   the decision, for all finite floats and doubles and for integers. An end on a boundary has the boundary's
///         coordinate bit for bit; its others are those of the exact intersection, correctly rounded (integers: to
///         nearest, halves up), so that no end leaves the window, clipping again changes nothing and swapping a and b
///         swaps the ends. Parameters within 3u * t + 2^-1074 (u = 2^-53)
/// cost    comparisons when both ends are inside or beyond one boundary; one orientation test per corner in doubt, one
///         division per end that is cut; where rounding is in doubt (about 1 of 10^12, and near the ends of the
///         exponent range) some microseconds of integer arithmetic
/// source  Liang and Barsky 1984
template <Point P>
[[nodiscard]] constexpr std::optional<clipped_line<P>> clip_line_liang_barsky(
    const P& a, const P& b, const box<scalar_of<P>, size_of<P>>& window) noexcept {
  constexpr int axes = size_of<P>;
  if (!window.empty() && detail::is_within(a, window) && detail::is_within(b, window)) return clipped_line<P>{a, b};
  if (window.empty() || !is_finite(a, b)) return std::nullopt;
  detail::window_side entry, exit;
  for (int i = 0; i < axes; ++i) {
    const int from = detail::place_of(coordinate(a, i), window, i), to = detail::place_of(coordinate(b, i), window, i);
    if (from != 0 && from == to) return std::nullopt;
    const detail::window_side in{i, from}, out{i, to};
    if (from != 0 && (entry.side == 0 || detail::compare_crossings(a, b, window, entry, in) < 0)) entry = in;
    if (to != 0 && (exit.side == 0 || detail::compare_crossings(a, b, window, out, exit) < 0)) exit = out;
  }
  const bool meets = entry.side == 0 || exit.side == 0 || entry.axis == exit.axis ||
                     detail::compare_crossings(a, b, window, entry, exit) <= 0;
  if (!meets) return std::nullopt;
  return detail::line_between(a, b, window, entry, exit);
}

IRG_REFUSES_VECTORS(clip_line_liang_barsky);

}  // namespace irg::inline IRG_ABI
