// SPDX-License-Identifier: MIT
// Sight by another way than irg's: every full cell and wall near the segment is clipped against it in exact fractions,
// and around a corner the ways from cell to cell are tried one by one.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <irg/spatial/walled_grid.hpp>
#include <irg/visibility/see.hpp>

#include "support/random.hpp"

namespace test {

// A fraction with a positive denominator; small numbers only.
struct part {
  std::int64_t n, d;
  friend constexpr bool operator<(const part& a, const part& b) { return a.n * b.d < b.n * a.d; }
  friend constexpr bool operator==(const part& a, const part& b) { return a.n * b.d == b.n * a.d; }
};

// Where the segment from a to b is within the box with corners low/2 and high/2: from first to last of the way. Boxes
// are closed and may be flat.
struct stretch {
  part first{0, 1}, last{1, 1};
  bool empty() const { return last < first; }
};
inline stretch within_box(const irg::cell3& a, const irg::cell3& b, const int (&low)[3], const int (&high)[3]) {
  stretch s;
  for (int k = 0; k < 3; ++k) {
    const std::int64_t d = 2 * (b[k] - a[k]), p = 2 * a[k];
    if (d == 0) {
      if (p < low[k] || p > high[k]) return {{1, 1}, {0, 1}};
      continue;
    }
    part enter{low[k] - p, d}, leave{high[k] - p, d};
    if (d < 0) {
      enter = {p - low[k], -d}, leave = {p - high[k], -d};
      std::swap(enter, leave);
    }
    s.first = std::max(s.first, enter), s.last = std::min(s.last, leave);
  }
  return s;
}

// Whether a way without repetition leads from the cell of subset s to that of `goal`.
template <class G>
bool way_exists(const G& g, const irg::cell3& origin, const int (&sign)[3], unsigned goal, unsigned s,
                unsigned visited) {
  const auto at = [&](unsigned t) {
    return irg::cell3{origin.x + ((t & 1) ? sign[0] : 0), origin.y + ((t & 2) ? sign[1] : 0),
                      origin.z + ((t & 4) ? sign[2] : 0)};
  };
  if (s == goal) return true;
  for (int axis = 0; axis < 3; ++axis) {
    const unsigned t = s ^ (1u << axis);
    if ((goal >> axis & 1) == 0 || (visited >> t & 1) != 0 || t == 0) continue;
    const irg::cell3 p = at(s), q = at(t), lower = p[axis] < q[axis] ? p : q;
    if (irg::has_wall(g, lower, axis) || (t != goal && irg::is_full(g, q))) continue;
    if (way_exists(g, origin, sign, goal, t, visited | 1u << t)) return true;
  }
  return false;
}

template <class G>
bool sees(const G& g, const irg::cell3& a, const irg::cell3& b, const irg::line_of_sight_options& rules = {}) {
  const irg::grid_extent e = irg::extent_of(g);
  if (!e.holds(a) || !e.holds(b)) return false;
  if (rules.ends == irg::end_cells::tested && (irg::is_full(g, a) || irg::is_full(g, b))) return false;
  int least[3], most[3], sign[3];
  for (int k = 0; k < 3; ++k) {
    least[k] = std::max(0, std::min(a[k], b[k]) - 1);
    most[k] = std::min((k == 0 ? e.width : k == 1 ? e.height : e.depth) - 1, std::max(a[k], b[k]) + 1);
    sign[k] = b[k] < a[k] ? -1 : 1;
  }
  std::vector<part> touched;  // the corners that full cells and walls touch
  for (int z = least[2]; z <= most[2]; ++z)
    for (int y = least[1]; y <= most[1]; ++y)
      for (int x = least[0]; x <= most[0]; ++x) {
        const irg::cell3 c{x, y, z};
        if (irg::is_full(g, c) && !(c == a) && !(c == b)) {
          const stretch s = within_box(a, b, {2 * x - 1, 2 * y - 1, 2 * z - 1}, {2 * x + 1, 2 * y + 1, 2 * z + 1});
          if (s.first < s.last) return false;
          if (s.first == s.last) touched.push_back(s.first);
        }
        for (int axis = 0; axis < 3; ++axis) {
          if (!irg::has_wall(g, c, axis)) continue;
          int low[3]{2 * x - 1, 2 * y - 1, 2 * z - 1}, high[3]{2 * x + 1, 2 * y + 1, 2 * z + 1};
          low[axis] = high[axis];
          const stretch s = within_box(a, b, low, high);
          if (s.empty()) continue;
          bool inside = true;  // or on the wall's rim
          for (int k = 0; k < 3; ++k) {
            const std::int64_t p = 2 * a[k] * s.first.d + 2 * (b[k] - a[k]) * s.first.n;
            if (k != axis && (p == low[k] * s.first.d || p == high[k] * s.first.d)) inside = false;
          }
          if (inside) return false;
          touched.push_back(s.first);
        }
      }
  if (rules.corners == irg::corner_rule::open) return true;
  if (rules.corners == irg::corner_rule::closed) {  // an end cell that is full has no corners of its own
    return touched.empty();
  }
  for (const part& t : touched) {
    irg::cell3 origin;
    unsigned goal = 0;
    int* const to[] = {&origin.x, &origin.y, &origin.z};
    for (int k = 0; k < 3; ++k) {
      // Twice the coordinate, over t.d; odd whole numbers are planes.
      const std::int64_t p = 2 * a[k] * t.d + 2 * (b[k] - a[k]) * t.n;
      const bool plane = p % t.d == 0 && (p / t.d) % 2 != 0;
      const std::int64_t whole = p / t.d;
      if (plane) {
        goal |= 1u << k;
        *to[k] = static_cast<int>(sign[k] > 0 ? (whole - 1) / 2 : (whole + 1) / 2);
      } else {
        std::int64_t c = a[k];
        while (2 * c * t.d + t.d < p) ++c;
        while (2 * c * t.d - t.d > p) --c;
        *to[k] = static_cast<int>(c);
      }
    }
    if (!way_exists(g, origin, sign, goal, 0, 1)) return false;
  }
  return true;
}

inline irg::walled_grid random_map(random& r, const irg::grid_extent& e, int full_percent, int wall_percent) {
  irg::walled_grid g(e);
  for (int z = 0; z < e.depth; ++z)
    for (int y = 0; y < e.height; ++y)
      for (int x = 0; x < e.width; ++x) {
        if (r.integer(0, 99) < full_percent) g.set({x, y, z});
        for (int axis = 0; axis < 3; ++axis)
          if (r.integer(0, 99) < wall_percent)
            g.set_wall({x, y, z}, axis, static_cast<irg::wall_kind>(r.integer(0, 5)));
      }
  return g;
}

}  // namespace test
