// SPDX-License-Identifier: MIT
// Takes corners out of a surface that are there only because a plane face was cut: where a diagonal met something, or a
// body that does not bound the result there. The triangles round such a corner, plane by plane, are cut anew without
// it, so that faces keep the corners that the bodies have, and nothing else is ever rounded.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

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
class seam_remover {
public:
  /// needs   is_seam for each vertex; are_level(s, t): whether two triangles of the bodies lie in one plane and look
  ///         the same way
  template <class Level>
  constexpr seam_remover(std::vector<kept_triangle>& surface, Vertices& vertices,
                         const std::vector<unsigned char>& is_seam, const Level& are_level)
      : surface_(surface), vertices_(vertices), around_(is_seam.size()), is_seam_(is_seam) {
    for (std::uint32_t t = 0; t < surface_.size(); ++t) note(t);
    for (std::uint32_t v = 0; v < is_seam_.size(); ++v)
      if (is_seam_[v] != 0 && !around_[v].empty()) remove(v, are_level);
  }

private:
  // A side seen from the corner that goes: from, to, of which triangle.
  struct spoke {
    std::uint32_t from, to, triangle;
  };
  // Triangles of one plane side by side: polygon runs round them, without the corner.
  struct sector {
    std::vector<std::uint32_t> polygon;
    std::vector<std::uint32_t> triangles;
    bool is_closed = false;
  };

  constexpr void note(std::uint32_t t) {
    for (const std::uint32_t v : surface_[t].v)
      if (is_seam_[v] != 0) around_[v].push_back(t);
  }

  template <class Level>
  constexpr void remove(std::uint32_t p, const Level& are_level) {
    spokes_.clear();
    for (const std::uint32_t t : around_[p]) {
      const kept_triangle& k = surface_[t];
      if (!k.is_there) continue;
      const std::size_t i = k.v[0] == p ? 0 : k.v[1] == p ? 1 : 2;
      spokes_.push_back({k.v[(i + 1) % 3], k.v[(i + 2) % 3], t});
    }
    sectors_.clear();
    while (!spokes_.empty()) take_sector(are_level);
    if (!is_straight(p)) return;
    cuts_.clear();
    for (const sector& s : sectors_)
      if (!cut_anew(s)) return;
    for (const sector& s : sectors_)
      for (const std::uint32_t t : s.triangles) surface_[t].is_there = false;
    for (const kept_triangle& k : cuts_) {
      surface_.push_back(k);
      note(static_cast<std::uint32_t>(surface_.size() - 1));
    }
  }

  // The triangles level with the first that is left and joined to it.
  template <class Level>
  constexpr void take_sector(const Level& are_level) {
    sector s;
    const spoke first = spokes_.back();
    spokes_.pop_back();
    s.polygon = {first.from, first.to};
    s.triangles = {first.triangle};
    const kept_triangle level = surface_[first.triangle];
    for (bool grows = true; grows && !s.is_closed;) {
      grows = false;
      for (std::size_t i = 0; i < spokes_.size() && !grows; ++i) {
        const spoke next = spokes_[i];
        const bool after = next.from == s.polygon.back(), before = next.to == s.polygon.front();
        const kept_triangle& k = surface_[next.triangle];
        if ((!after && !before) || k.turned != level.turned || !are_level(level.source, k.source)) continue;
        if (after && before)
          s.is_closed = true;
        else if (after)
          s.polygon.push_back(next.to);
        else
          s.polygon.insert(s.polygon.begin(), next.from);
        s.triangles.push_back(next.triangle);
        spokes_.erase(spokes_.begin() + static_cast<std::ptrdiff_t>(i));
        grows = true;
      }
    }
    sectors_.push_back(std::move(s));
  }

  // Whether the corner lies within a plane, or within one edge of all that meet there.
  constexpr bool is_straight(std::uint32_t p) {
    std::uint32_t low = no_index, high = no_index, triangle = no_index;
    for (const sector& s : sectors_) {
      if (s.is_closed) continue;
      const std::uint32_t a = lesser(s.polygon.front(), s.polygon.back());
      const std::uint32_t b = greater(s.polygon.front(), s.polygon.back());
      if (low == no_index) {
        low = a;
        high = b;
        triangle = surface_[s.triangles.front()].source;
      }
      if (low != a || high != b || a == b || s.polygon.size() < 3) return false;
    }
    if (low == no_index) return true;
    const seen_triangle seen = see_triangle(vertices_.at, (*vertices_.triangles)[triangle], triangle);
    return vertices_.turn(low, p, high, seen.axis) == 0;
  }

  // Ears come off until none are left.
  constexpr bool cut_anew(const sector& s) {
    const kept_triangle& level = surface_[s.triangles.front()];
    const triangle_indices& plane = (*vertices_.triangles)[level.source];
    const seen_triangle seen = see_triangle(vertices_.at, plane, level.source);
    const int direction = level.turned ? -seen.turn : seen.turn;
    const auto turn = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      return vertices_.turn(a, b, c, seen.axis) * direction;
    };
    std::vector<std::uint32_t> ring = s.polygon;
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
      cuts_.push_back({{ring[ear], ring[tip], ring[(ear + 2) % n]}, level.source, level.turned});
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(tip));
    }
    return true;
  }

  std::vector<kept_triangle>& surface_;
  Vertices& vertices_;
  std::vector<std::vector<std::uint32_t>> around_;
  const std::vector<unsigned char>& is_seam_;
  std::vector<spoke> spokes_;
  std::vector<sector> sectors_;
  std::vector<kept_triangle> cuts_;
};

}  // namespace IRG_ABI
}  // namespace irg::detail
