// SPDX-License-Identifier: MIT
// prepared_walls: visibility polygons from many points among the same walls. What is near is looked at first, and walls
// are fetched only where the polygon of those at hand reaches.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include <irg/visibility/detail/finite_point.hpp>
#include <irg/visibility/detail/wall_tiles.hpp>
#include <irg/visibility/visibility_polygon.hpp>

namespace irg {
inline namespace IRG_ABI {

/// Closed obstacles in a box, made ready.
template <Floating T>
class prepared_walls {
public:
  /// cost    sorts the walls into about as many tiles; allocates
  constexpr prepared_walls(std::span<const std::type_identity_t<segment<T, 2>>> walls, const box<T, 2>& domain)
      : walls_(walls.begin(), walls.end()), domain_(domain) {
    for (const auto& w : walls_)
      is_finite_ = is_finite_ && detail::is_finite_sight_point(w.a) && detail::is_finite_sight_point(w.b);
    if (is_finite_) tiles_ = detail::wall_tiles<T>(walls_, domain);
  }

  /// What is seen from a point.
  /// gives   the same as visibility_polygon(source, domain, walls); the ring may begin at another of its corners
  /// exact   as visibility_polygon
  /// cost    for walls of like sizes some visibility polygons of as many walls as stand in the tiles that are seen;
  ///         where more than a sixteenth of them is seen, visibility_polygon and as much again at most
  [[nodiscard]] constexpr visible_region<T> seen_from(const point<T, 2>& source) const {
    if (!is_finite_) return {visibility_status::not_finite, {}};
    visible_region<T> seen = visibility_polygon(source, domain_);
    if (seen.ring.empty()) return seen;
    std::vector<std::uint8_t> fetched(walls_.size(), std::uint8_t{0});
    std::vector<std::uint32_t> kept;  // walls at hand, rising
    bool is_on_wall = false;
    auto looked_at = tiles_.around(source, -1);
    for (int reach = 2;; reach = reach < (1 << 28) ? 3 * reach : reach) {
      std::vector<std::uint32_t> fresh;
      bool is_whole = true;  // nothing more is seen beyond the reach
      const auto near = tiles_.around(source, reach);
      for (std::size_t i = 0; i < seen.ring.size(); ++i) {
        if (seen.ring[i].stop == sight_stop::nothing) continue;  // along a sight line
        const std::array<point<T, 2>, 3> part{source, seen.ring[i].at,
                                              seen.ring[i + 1 < seen.ring.size() ? i + 1 : 0].at};
        const auto look = [&](std::size_t tile) {
          for (const std::uint32_t w : tiles_.walls_in(tile)) {
            if (fetched[w] != 0 || !tiles_.may_meet(part, walls_[w])) continue;
            fetched[w] = 1;
            fresh.push_back(w);
          }
        };
        is_whole = tiles_.for_triangle(part, near, looked_at, look) && is_whole;
      }
      looked_at = near;

      if (fresh.empty() && is_whole) break;
      if (fresh.empty()) continue;
      kept.insert(kept.end(), fresh.begin(), fresh.end());
      if (kept.size() > 64 + walls_.size() / 2) return visibility_polygon(source, domain_, walls_);
      std::sort(kept.begin(), kept.end());
      std::vector<segment<T, 2>> nearby;
      nearby.reserve(kept.size());
      for (const std::uint32_t w : kept) nearby.push_back(walls_[w]);
      seen = visibility_polygon(source, domain_, nearby);
      is_on_wall = is_on_wall || seen.status == visibility_status::source_on_obstacle;
      keep_what_is_seen(seen, kept);
      if (kept.size() > 64 + walls_.size() / 16) return visibility_polygon(source, domain_, walls_);
    }
    if (is_on_wall && seen.status == visibility_status::done) seen.status = visibility_status::source_on_obstacle;
    return seen;
  }

private:
  std::vector<segment<T, 2>> walls_;
  box<T, 2> domain_;
  detail::wall_tiles<T> tiles_{};
  bool is_finite_ = true;

  // Gives the ring the numbers of walls, and keeps of these walls those that it shows: what is hidden stays so.
  static constexpr void keep_what_is_seen(visible_region<T>& seen, std::vector<std::uint32_t>& kept) {
    std::vector<std::uint32_t> shown;
    for (auto& v : seen.ring)
      if (v.stop == sight_stop::obstacle) {
        v.index = kept[v.index];
        shown.push_back(static_cast<std::uint32_t>(v.index));
      }
    std::sort(shown.begin(), shown.end());
    shown.erase(std::unique(shown.begin(), shown.end()), shown.end());
    kept.swap(shown);
  }
};

}  // namespace IRG_ABI
}  // namespace irg
