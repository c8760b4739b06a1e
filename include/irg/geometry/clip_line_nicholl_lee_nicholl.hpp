// SPDX-License-Identifier: MIT
// Nicholl, Lee and Nicholl's line clipping: where the first end lies decides which of the window's corners matter, and
// on which sides of these the line passes decides which boundaries it crosses. Only then is anything divided.
#pragma once

#include <optional>

#include <irg/geometry/vocabulary.hpp>
#include <irg/geometry/detail/line_window.hpp>

namespace irg::inline IRG_ABI {

/// The part of the segment from a to b that lies in the window.
/// gives   as clip_line_liang_barsky, bit for bit
/// exact   as clip_line_liang_barsky
/// cost    as few tests and divisions as there can be: one division per end that is cut
/// source  Nicholl, Lee and Nicholl 1987
template <Point P>
  requires(size_of<P> == 2)
[[nodiscard]] constexpr std::optional<clipped_line<P>> clip_line_nicholl_lee_nicholl(
    const P& a, const P& b, const box<scalar_of<P>, 2>& window) noexcept {
  using side = detail::window_side;
  if (window.empty()) return std::nullopt;
  if (detail::is_within(a, window) && detail::is_within(b, window)) return clipped_line<P>{a, b};
  if (!is_finite(a, b)) return std::nullopt;
  const int ax = detail::place_of(coordinate(a, 0), window, 0), ay = detail::place_of(coordinate(a, 1), window, 1);
  const int bx = detail::place_of(coordinate(b, 0), window, 0), by = detail::place_of(coordinate(b, 1), window, 1);
  if ((ax != 0 && ax == bx) || (ay != 0 && ay == by)) return std::nullopt;
  const auto order = [&](side p, side q) { return detail::compare_crossings(a, b, window, p, q); };

  // The second end, beyond one boundary or in the corner beyond two: which one is crossed first.
  side exit = bx != 0 ? side{0, bx} : side{1, by};
  if (bx != 0 && by != 0 && order(side{1, by}, exit) < 0) exit = side{1, by};
  side entry;
  if (ax != 0 && ay != 0) {
    // From a corner region: the corner of the window next to a parts the lines that enter through its two sides.
    entry = order(side{0, ax}, side{1, ay}) < 0 ? side{1, ay} : side{0, ax};
  } else if (ax != 0 || ay != 0) {
    // From beside the window: through the side next to a, or past its two corners.
    entry = ax != 0 ? side{0, ax} : side{1, ay};
  }
  // Past a corner: the line has left the other pair of boundaries before it enters, or has not come between them yet.
  if (entry.side != 0 && exit.side != 0 && entry.axis != exit.axis && order(entry, exit) > 0) return std::nullopt;
  return detail::line_between(a, b, window, entry, exit);
}

IRG_REFUSES_VECTORS(clip_line_nicholl_lee_nicholl);

}  // namespace irg::inline IRG_ABI
