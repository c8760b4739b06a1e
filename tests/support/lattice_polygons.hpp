// SPDX-License-Identifier: MIT
// Polygons on lattices, and what can be said of them in plain integers: oracles for algorithms on polygons.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/math/vec.hpp>

#include "support/random.hpp"

namespace test {

using lattice_point = irg::point<int, 2>;
using lattice_ring = std::vector<lattice_point>;

inline std::int64_t cross(const lattice_point& a, const lattice_point& b, const lattice_point& c) {
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) - (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
}
inline int turn(const lattice_point& a, const lattice_point& b, const lattice_point& c) {
  const std::int64_t v = cross(a, b, c);
  return v < 0 ? -1 : v > 0 ? 1 : 0;
}
inline std::int64_t twice_area(const lattice_ring& r) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < r.size(); ++i) sum += cross({0, 0}, r[i], r[(i + 1) % r.size()]);
  return sum;
}

/// Whether two closed segments have a point in common.
inline bool meet(const lattice_point& a, const lattice_point& b, const lattice_point& c, const lattice_point& d) {
  const int s1 = turn(a, b, c), s2 = turn(a, b, d), s3 = turn(c, d, a), s4 = turn(c, d, b);
  if (s1 * s2 > 0 || s3 * s4 > 0) return false;
  const auto overlap = [](int p, int q, int s, int t) {
    return std::max(std::min(p, q), std::min(s, t)) <= std::min(std::max(p, q), std::max(s, t));
  };
  return overlap(a.x, b.x, c.x, d.x) && overlap(a.y, b.y, c.y, d.y);
}
/// Whether each passes from one side of the other to the other side.
inline bool cross_properly(const lattice_point& a, const lattice_point& b, const lattice_point& c,
                           const lattice_point& d) {
  return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

/// Whether no two edges meet but neighbours at their common vertex.
inline bool is_simple(const lattice_ring& r) {
  const std::size_t n = r.size();
  if (n < 3) return false;
  for (std::size_t i = 0; i < n; ++i) {
    const auto &a = r[i], &b = r[(i + 1) % n], &c = r[(i + 2) % n];
    if (a == b) return false;
    if (cross(a, b, c) == 0 && (std::int64_t{b.x} - a.x) * (c.x - b.x) + (std::int64_t{b.y} - a.y) * (c.y - b.y) < 0)
      return false;
    for (std::size_t j = i + 2; j < n; ++j)
      if (!(i == 0 && j == n - 1) && meet(a, b, r[j], r[(j + 1) % n])) return false;
  }
  return true;
}

/// A ring without the places where it stands still.
inline lattice_ring without_pauses(const lattice_ring& r) {
  lattice_ring out;
  for (const lattice_point& p : r)
    if (out.empty() || !(out.back() == p)) out.push_back(p);
  while (out.size() > 1 && out.front() == out.back()) out.pop_back();
  return out;
}

/// Whether two edges cross within both, or a way through a vertex leads from one side of an edge, or of another way
/// through that place, to the other side. Ways that share a direction only touch. By looking at all pairs.
inline bool ways_cross(const std::vector<lattice_ring>& polygon) {
  struct way {
    lattice_point from, at, to;
  };
  std::vector<way> ways;
  for (const lattice_ring& whole : polygon) {
    const lattice_ring r = without_pauses(whole);
    const std::size_t n = r.size();
    for (std::size_t i = 0; n > 1 && i < n; ++i) ways.push_back({r[i], r[(i + 1) % n], r[(i + 2) % n]});
  }
  const auto same_direction = [](const lattice_point& a, const lattice_point& b, const lattice_point& c) {
    const std::int64_t along =
        (std::int64_t{b.x} - a.x) * (std::int64_t{c.x} - a.x) + (std::int64_t{b.y} - a.y) * (std::int64_t{c.y} - a.y);
    return cross(a, b, c) == 0 && along > 0;
  };
  // whether p is met on the way round `at`, counter-clockwise, from `from` to `to`
  const auto between = [](const way& w, const lattice_point& p) {
    const int to = turn(w.at, w.from, w.to), left = turn(w.at, w.from, p), right = turn(w.at, p, w.to);
    return to > 0 ? left > 0 && right > 0 : to < 0 ? left > 0 || right > 0 : left > 0;
  };
  for (const way& v : ways)
    for (const way& w : ways) {
      if (cross_properly(v.from, v.at, w.from, w.at)) return true;
      const bool inside_edge =
          cross(w.from, w.at, v.at) == 0 && !(v.at == w.at) && !(v.at == w.from) && meet(v.at, v.at, w.from, w.at);
      if (inside_edge && turn(w.from, w.at, v.from) * turn(w.from, w.at, v.to) < 0) return true;
      if (!(v.at == w.at)) continue;
      bool share = same_direction(v.at, v.from, v.to) || same_direction(v.at, w.from, w.to);
      for (const lattice_point& p : {v.from, v.to})
        for (const lattice_point& q : {w.from, w.to}) share = share || same_direction(v.at, p, q);
      if (!share && between(v, w.from) != between(v, w.to)) return true;
    }
  return false;
}

/// Random vertices, untangled by reversing the run between two edges that meet; empty when that does not end.
inline lattice_ring random_simple(random& numbers, int n, int extent) {
  lattice_ring r;
  while (static_cast<int>(r.size()) < n) {
    const int x = static_cast<int>(numbers.integer(0, extent));
    const lattice_point p{x, static_cast<int>(numbers.integer(0, extent))};
    if (std::find(r.begin(), r.end(), p) == r.end()) r.push_back(p);
  }
  for (int pass = 0; pass < 200; ++pass) {
    bool changed = false;
    for (std::size_t i = 0; i < r.size(); ++i)
      for (std::size_t j = i + 2; j < r.size(); ++j)
        if (!(i == 0 && j == r.size() - 1) && meet(r[i], r[i + 1], r[j], r[(j + 1) % r.size()])) {
          std::reverse(r.begin() + static_cast<std::ptrdiff_t>(i) + 1, r.begin() + static_cast<std::ptrdiff_t>(j) + 1);
          changed = true;
        }
    if (!changed) return is_simple(r) ? r : lattice_ring{};
  }
  return {};
}

/// Whether a ring holds (x + 1/3, y + 1/7) for a lattice point (x, y), by counting crossings; no such point is on an
/// edge between lattice points closer than 21.
inline int windings(const lattice_ring& r, const lattice_point& p) {
  const lattice_point q{21 * p.x + 7, 21 * p.y + 3};
  int count = 0;
  for (std::size_t i = 0; i < r.size(); ++i) {
    lattice_point a{21 * r[i].x, 21 * r[i].y}, b{21 * r[(i + 1) % r.size()].x, 21 * r[(i + 1) % r.size()].y};
    if ((a.y > q.y) == (b.y > q.y)) continue;
    const int direction = a.y < b.y ? 1 : -1;
    if (direction < 0) std::swap(a, b);
    if (cross(a, b, q) > 0) count += direction;
  }
  return count;
}

/// The outlines of a random set of cells of a w x h lattice: rings that run counter-clockwise round the cells, and
/// clockwise round holes; where cells touch at a corner only, rings touch (or a ring touches itself).
inline std::vector<lattice_ring> outlines(random& numbers, int w, int h, int percent) {
  std::vector<char> cells(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), char{0});
  for (char& c : cells) c = numbers.integer(0, 99) < percent;
  const auto filled = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < w && y < h && cells[static_cast<std::size_t>(y * w + x)] != 0;
  };
  struct side {
    lattice_point from, to;
    bool used;
  };
  std::vector<side> sides;
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) {
      if (!filled(x, y)) continue;
      if (!filled(x, y - 1)) sides.push_back({{x, y}, {x + 1, y}, false});
      if (!filled(x + 1, y)) sides.push_back({{x + 1, y}, {x + 1, y + 1}, false});
      if (!filled(x, y + 1)) sides.push_back({{x + 1, y + 1}, {x, y + 1}, false});
      if (!filled(x - 1, y)) sides.push_back({{x, y + 1}, {x, y}, false});
    }
  std::vector<lattice_ring> rings;
  const bool prefer_left = numbers.integer(0, 1) == 0;  // where two ways lead on
  for (side& start : sides) {
    if (start.used) continue;
    lattice_ring ring;
    side* s = &start;
    while (!s->used) {
      s->used = true;
      ring.push_back(s->from);
      side* on = nullptr;
      for (side& t : sides) {
        if (t.used || !(t.from == s->to)) continue;
        if (on == nullptr || (turn(s->from, s->to, t.to) > 0) == prefer_left) on = &t;
      }
      if (on == nullptr) break;
      s = on;
    }
    rings.push_back(ring);
  }
  return rings;
}

}  // namespace test
