// SPDX-License-Identifier: MIT
// Line of sight in space along the cells of sight_cells.hpp, as a thesis builds it: a rule for steps along one, two and
// three axes, and the more exact test in the plane where both ends have z = 0.
#pragma once

#include <irg/visibility/textbook/sight_2d.hpp>
#include <irg/visibility/textbook/sight_cells.hpp>

namespace irg::textbook {

/// Which sets of cells round it block a step along three axes.
enum class three_axis_rule {
  thesis,  // the two that are printed
  face_path  // all five: no way leads from face to face
};

inline namespace IRG_ABI {

/// Whether a step along three axes is blocked: bit s of `blocked` says that of the cell ahead along the axes of s (bits
/// 1, 2 and 4 for x, y and z).
/// source  Fabris 2012, 5.1.1; the other three sets by enumeration
[[nodiscard]] constexpr bool three_axis_blocked(unsigned blocked, three_axis_rule rule) noexcept {
  constexpr auto set = [](unsigned p, unsigned q, unsigned r, unsigned s) {
    return 1u << p | 1u << q | 1u << r | 1u << s;
  };
  constexpr unsigned sets[] = {set(1, 2, 5, 6), set(1, 2, 4, 4), set(3, 5, 6, 6), set(1, 4, 3, 6), set(2, 4, 3, 5)};
  for (int i = 0; i < (rule == three_axis_rule::thesis ? 2 : 5); ++i)
    if ((blocked & sets[i]) == sets[i]) return true;
  return false;
}

/// Whether b is seen from a, the end cells not tested.
/// gives   false when a or b is no cell of the grid. Where both have z = 0: what sight_2d says
/// exact   always; the same from b to a
/// source  Fabris 2012, 5.1 and 5.3; walls as in 5.1.2 at z = 0 only
template <CellGrid G>
[[nodiscard]] constexpr bool sight_3d(const G& g, const cell3& a, const cell3& b,
                                      three_axis_rule rule = three_axis_rule::thesis) {
  const grid_extent e = extent_of(g);
  if (!e.holds(a) || !e.holds(b)) return false;
  if (a.z == 0 && b.z == 0) return sight_2d(g, {a.x, a.y}, {b.x, b.y}) != sight::blocked;
  std::int64_t d[3];
  for (int k = 0; k < 3; ++k) d[k] = b[k] < a[k] ? std::int64_t{a[k]} - b[k] : std::int64_t{b[k]} - a[k];
  const int main = d[2] > d[0] && d[2] > d[1] ? 2 : d[0] > d[1] ? 0 : 1;
  const bool reverse = b[main] < a[main];
  const cell3 &first = reverse ? b : a, &last = reverse ? a : b;
  cell3 u = first;
  bool clear = true;
  const auto wall = [&](const cell3& p, const cell3& q) {
    return p.z == 0 && q.z == 0 && detail::wall_between(g, p, q);
  };
  sight_cells_one_pass(first, last, [&](const cell3& v) {
    if (!clear || v == u) return;
    if (!(v == last) && is_full(g, v)) clear = false;
    const unsigned moved = (v.x != u.x ? 1u : 0u) | (v.y != u.y ? 2u : 0u) | (v.z != u.z ? 4u : 0u);
    unsigned blocked = 0;
    for (unsigned s = 1; s < moved; ++s) {
      if ((s & ~moved) != 0) continue;
      const cell3 side{(s & 1) != 0 ? v.x : u.x, (s & 2) != 0 ? v.y : u.y, (s & 4) != 0 ? v.z : u.z};
      const unsigned rest = moved & ~s;  // walls count for the cells next to one of the two
      const bool walled = ((s & (s - 1)) == 0 && wall(u, side)) || ((rest & (rest - 1)) == 0 && wall(side, v));
      if (is_full(g, side) || walled) blocked |= 1u << s;
    }
    if ((moved & (moved - 1)) == 0)
      clear = clear && !wall(u, v);
    else if (moved != 7)
      clear = clear && blocked != ((1u << (moved & (0u - moved))) | (1u << (moved & (moved - 1))));
    else
      clear = clear && !three_axis_blocked(blocked, rule);
    u = v;
  });
  return clear;
}

}  // namespace IRG_ABI
}  // namespace irg::textbook
