// SPDX-License-Identifier: MIT
// Line of sight in space, as a thesis builds it: a line of cells whose third coordinate advances with the other two, a
// rule for steps along one, two and three axes, and the more exact test in the plane where both ends have z = 0.
#pragma once

#include <concepts>
#include <cstdint>
#include <vector>

#include <irg/math/sqrt.hpp>
#include <irg/visibility/textbook/sight_2d.hpp>

namespace irg::textbook {

/// Which sets of cells round it block a step along three axes.
enum class three_axis_rule {
  thesis,    // the two that are printed
  face_path  // all five: no way leads from face to face
};

inline namespace IRG_ABI {

/// Calls sink(cell3) for the cells of a line in space from a to b, all coordinates advanced in one pass.
/// shape   as many steps as along the longest axis; the same cells both ways
/// exact   for int coordinates
/// source  Fabris 2012, 5.1.1, with z advanced by |dz| over the number of steps
template <Cell3Sink Sink>
constexpr void sight_cells_one_pass(const cell3& a, const cell3& b, Sink&& sink) {
  std::int64_t d[3], error[3];
  bool falling[3];
  for (int k = 0; k < 3; ++k) {
    d[k] = std::int64_t{b[k]} - a[k];
    falling[k] = d[k] < 0;
    if (falling[k]) d[k] = -d[k];
  }
  const int main = d[2] > d[0] && d[2] > d[1] ? 2 : d[0] > d[1] ? 0 : 1;
  // Ties are those of the canonical direction: the start's side there is the end's side of a line that is walked back.
  const int tie = falling[main] ? 1 : 0;
  const std::int64_t n = d[main];
  for (int k = 0; k < 3; ++k) error[k] = 2 * d[k] - n + tie;
  cell3 c = a;
  int* const at[] = {&c.x, &c.y, &c.z};
  sink(static_cast<const cell3&>(c));
  for (std::int64_t i = 0; i < n; ++i) {
    for (int k = 0; k < 3; ++k) {
      if (k == main || error[k] > 0) {
        *at[k] += falling[k] ? -1 : 1;
        error[k] -= 2 * n;
      }
      error[k] += 2 * d[k];
    }
    sink(static_cast<const cell3&>(c));
  }
}

/// The cells of a line in space from a to b by two lines in the plane: p' of x and y, then of the steps of p' and z.
/// shape   as sight_cells_one_pass, and the same cells unless |dz| is the greatest: then p' is rounded twice
/// source  Fabris 2012, 5
template <std::same_as<cell3> Cell = cell3>
[[nodiscard]] constexpr std::vector<Cell> sight_cells_nested(const Cell& a, const Cell& b) {
  std::vector<cell3> projected;
  sight_cells_one_pass({a.x, a.y, 0}, {b.x, b.y, 0}, [&](const cell3& c) { projected.push_back(c); });
  const bool flat = (a.x < b.x ? std::int64_t{b.x} - a.x : std::int64_t{a.x} - b.x) >
                    (a.y < b.y ? std::int64_t{b.y} - a.y : std::int64_t{a.y} - b.y);
  const std::int64_t n = static_cast<std::int64_t>(projected.size()) - 1;
  const bool reverse = n > 0 ? (flat ? b.x < a.x : b.y < a.y) : b.z < a.z;
  const std::int64_t rise = std::int64_t{b.z} - a.z, m = rise < 0 ? -rise : rise, tie = reverse ? 1 : 0;
  // The whole number nearest to i * part / whole, ties downwards seen in canonical direction.
  const auto nearest = [&](std::int64_t i, std::int64_t part, std::int64_t whole) {
    return whole == 0 ? 0 : (2 * i * part + whole - 1 + tie) / (2 * whole);
  };
  std::vector<cell3> out;
  for (std::int64_t i = 0; i <= (n >= m ? n : m); ++i) {
    const std::int64_t along = n >= m ? i : nearest(i, n, m), up = n >= m ? nearest(i, m, n) : i;
    cell3 c = projected[static_cast<std::size_t>(along)];
    c.z = static_cast<int>(a.z + (rise < 0 ? -up : up));
    out.push_back(c);
  }
  return out;
}

/// Calls sink(z) for the heights that the printed procedure reaches after each of its steps, which is not always b's.
/// exact   to the roundings of T: the slope is |dz| over the distance of the projections
/// source  Fabris 2012, 5.3 as printed
template <class T = double, class Emit>
constexpr void sight_heights_as_printed(const cell3& a, const cell3& b, Emit&& sink) {
  const T dx = T(b.x) - T(a.x), dy = T(b.y) - T(a.y), rise = T(b.z) - T(a.z);
  const T width = dx < 0 ? -dx : dx, height = dy < 0 ? -dy : dy, up = rise < 0 ? -rise : rise;
  const T distance = irg::sqrt(T(width * width) + T(height * height)), sign = rise < 0 ? T(-1) : T(1);
  if (!(distance > 0)) {  // the printed slope is 0/0 or x/0
    sink(T(a.z));
    return;
  }
  const T slope = up / distance;
  T z = T(a.z), d = slope - T(0.5);
  sink(z);
  for (T i = 0; i < (width > height ? width : height); i += 1) {
    if (distance > up) {
      if (d > 0) z += sign, d -= 1;
      d += slope;
    } else {
      z += sign * slope;
    }
    sink(z);
  }
}

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
