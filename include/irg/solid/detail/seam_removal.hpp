// SPDX-License-Identifier: MIT
// Takes corners out of a surface that are there only because a plane face was cut: where a diagonal met something, or a
// body that does not bound the result there. The triangles round such a corner, plane by plane, are cut anew without
// it, so that faces keep the corners that the bodies have, and nothing else is ever rounded.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/solid/detail/body_triangles.hpp>
#include <irg/solid/detail/exact_vertices.hpp>

namespace irg::detail {

/// A triangle of the result.
struct kept_triangle {
  std::uint32_t v[3];
  std::uint32_t source;
  bool turned, is_there = true;
};

inline namespace IRG_ABI {

template <class Vertices>
struct seam_removal {
  // A side seen from the corner that goes: from, to, of which triangle.
  struct spoke {
    std::uint32_t from, to, triangle;
  };
  // Triangles of one plane side by side: polygon runs round them, without the corner.
  struct sector {
    std::vector<std::uint32_t> polygon, triangles;
    bool is_closed = false;
  };

  const body_triangles& bodies;
  Vertices& vertices;
  const std::vector<unsigned char>& is_seam;  // of each vertex
  std::vector<kept_triangle>& surface;
  std::vector<std::vector<std::uint32_t>> around{};  // of each vertex that is_seam, the triangles, those that went too
  std::vector<spoke> spokes{};
  std::vector<sector> sectors{};
  std::vector<kept_triangle> cuts{};
};

template <class Seams>
constexpr void note_corners(Seams& s, std::uint32_t t) {
  for (const std::uint32_t v : s.surface[t].v)
    if (s.is_seam[v] != 0) s.around[v].push_back(t);
}

// The triangles level with the first that is left and joined to it.
template <class Seams>
constexpr void take_sector(Seams& s) {
  const auto first = s.spokes.back();
  s.spokes.pop_back();
  s.sectors.push_back({{first.from, first.to}, {first.triangle}});
  auto& [polygon, triangles, is_closed] = s.sectors.back();
  const kept_triangle level = s.surface[first.triangle];
  for (bool grows = true; grows && !is_closed;) {
    grows = false;
    for (std::size_t i = 0; i < s.spokes.size() && !grows; ++i) {
      const auto next = s.spokes[i];
      const bool after = next.from == polygon.back(), before = next.to == polygon.front();
      const kept_triangle& k = s.surface[next.triangle];
      if ((!after && !before) || k.turned != level.turned || !are_level(s.bodies, level.source, k.source)) continue;
      if (after && before)
        is_closed = true;
      else if (after)
        polygon.push_back(next.to);
      else
        polygon.insert(polygon.begin(), next.from);
      triangles.push_back(next.triangle);
      s.spokes.erase(s.spokes.begin() + static_cast<std::ptrdiff_t>(i));
      grows = true;
    }
  }
}

// Whether the corner lies within a plane, or within one edge of all that meet there.
template <class Seams>
constexpr bool is_straight(Seams& s, std::uint32_t p) {
  std::uint32_t low = no_index, high = no_index, triangle = no_index;
  for (const auto& [polygon, triangles, is_closed] : s.sectors) {
    if (is_closed) continue;
    const std::uint32_t a = lesser(polygon.front(), polygon.back()), b = greater(polygon.front(), polygon.back());
    if (low != no_index && (low != a || high != b)) return false;
    if (a == b || polygon.size() < 3) return false;
    if (low == no_index) triangle = s.surface[triangles.front()].source;
    low = a;
    high = b;
  }
  if (low == no_index) return true;
  const seen_triangle seen = see_triangle(s.bodies.positions, s.bodies.triangles[triangle], triangle);
  return s.vertices.turn(low, p, high, seen.axis) == 0;
}

// Ears come off until none are left.
template <class Seams>
constexpr bool cut_anew(Seams& s, const typename Seams::sector& of) {
  const kept_triangle level = s.surface[of.triangles.front()];
  const seen_triangle seen = see_triangle(s.bodies.positions, s.bodies.triangles[level.source], level.source);
  const int direction = level.turned ? -seen.turn : seen.turn;
  const auto turn = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return s.vertices.turn(a, b, c, seen.axis) * direction;
  };
  std::vector<std::uint32_t> ring = of.polygon;
  while (ring.size() > 2) {
    const std::size_t n = ring.size();
    std::size_t ear = n;
    for (std::size_t i = 0; i < n && ear == n; ++i) {
      const std::uint32_t a = ring[i], b = ring[(i + 1) % n], c = ring[(i + 2) % n];
      if (turn(a, b, c) <= 0) continue;
      bool is_free = true;
      for (std::size_t k = 3; k < n && is_free; ++k) {
        const std::uint32_t q = ring[(i + k) % n];
        if (q == a || q == b || q == c) return false;  // touches itself
        is_free = turn(a, b, q) < 0 || turn(b, c, q) < 0 || turn(c, a, q) < 0;
      }
      if (is_free) ear = i;
    }
    if (ear == n) return false;
    const std::size_t tip = (ear + 1) % n;
    s.cuts.push_back({{ring[ear], ring[tip], ring[(ear + 2) % n]}, level.source, level.turned});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(tip));
  }
  return true;
}

// Leaves a corner where it is unless all that is round it can be cut without it.
template <class Seams>
constexpr void remove_corner(Seams& s, std::uint32_t p) {
  s.spokes.clear();
  for (const std::uint32_t t : s.around[p]) {
    const kept_triangle& k = s.surface[t];
    if (!k.is_there) continue;
    const std::size_t i = k.v[0] == p ? 0 : k.v[1] == p ? 1 : 2;
    s.spokes.push_back({k.v[(i + 1) % 3], k.v[(i + 2) % 3], t});
  }
  s.sectors.clear();
  while (!s.spokes.empty()) take_sector(s);
  if (!is_straight(s, p)) return;
  s.cuts.clear();
  for (const auto& of : s.sectors)
    if (!cut_anew(s, of)) return;
  for (const auto& of : s.sectors)
    for (const std::uint32_t t : of.triangles) s.surface[t].is_there = false;
  for (const kept_triangle& k : s.cuts) {
    s.surface.push_back(k);
    note_corners(s, static_cast<std::uint32_t>(s.surface.size() - 1));
  }
}

template <class Seams>
constexpr void remove_seams(Seams& s) {
  s.around.resize(s.is_seam.size());
  for (std::uint32_t t = 0; t < s.surface.size(); ++t) note_corners(s, t);
  for (std::uint32_t v = 0; v < s.is_seam.size(); ++v)
    if (s.is_seam[v] != 0 && !s.around[v].empty()) remove_corner(s, v);
}

}  // namespace IRG_ABI
}  // namespace irg::detail
