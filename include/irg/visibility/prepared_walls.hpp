// SPDX-License-Identifier: MIT
// prepared_walls: visibility polygons from many points among the same walls, of those only that stand in tiles which
// what is nearer leaves open.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include <irg/visibility/detail/finite_point.hpp>
#include <irg/visibility/detail/wall_horizon.hpp>
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
    if (!is_finite_) return;
    tiles_ = detail::wall_tiles<T>(walls_, domain);
    numbers_ = tiles_.renumber(walls_.size());
    tiled_.reserve(walls_.size());
    for (const std::uint32_t w : numbers_) tiled_.push_back(walls_[w]);
  }

  /// What is seen from a point.
  /// gives   the same as visibility_polygon(source, domain, walls); the ring may begin at another of its corners
  /// exact   as visibility_polygon
  /// cost    the tiles that are seen, and a visibility polygon of the walls in them that no nearer tiles hide; where
  ///         these are more than a sixteenth of all, visibility_polygon and as much again at most
  [[nodiscard]] constexpr visible_region<T> seen_from(const point<T, 2>& source) const {
    return look(source,
                [&](std::span<const segment<T, 2>> walls) { return visibility_polygon(source, domain_, walls); });
  }

  /// The same, and adds to the counts what it took: walls in tiles that nearer ones hide are passed over.
  [[nodiscard]] constexpr visible_region<T> seen_from(const point<T, 2>& source, sight_counts& counts) const {
    sight_counts took;
    visible_region<T> seen = look(source, [&](std::span<const segment<T, 2>> walls) {
      return visibility_polygon(source, domain_, walls, {}, took);
    });
    const std::int64_t all = static_cast<std::int64_t>(walls_.size()) + (is_empty(domain_) ? 0 : 4);
    took.passed_over += all - took.walls;
    took.walls = all;
    counts += took;
    return seen;
  }

private:
  // Polygon gives the visibility polygon among walls; it is asked once at most.
  template <class Polygon>
  [[nodiscard]] constexpr visible_region<T> look(const point<T, 2>& source, const Polygon& polygon) const {
    if (!is_finite_) return polygon(walls_);  // says what comes first
    visible_region<T> seen = visibility_polygon(source, domain_);
    if (seen.ring.empty()) return seen;
    std::vector<std::uint32_t> nearby;
    if (tiles_.count() == 1 || !detail::wall_horizon<T>(tiles_, tiled_, source).find(64 + walls_.size() / 16, nearby))
      return polygon(walls_);
    for (std::uint32_t& w : nearby) w = numbers_[w];
    std::sort(nearby.begin(), nearby.end());
    std::vector<segment<T, 2>> walls;
    walls.reserve(nearby.size());
    for (const std::uint32_t w : nearby) walls.push_back(walls_[w]);
    seen = polygon(walls);
    for (auto& v : seen.ring)
      if (v.stop == sight_stop::obstacle) v.index = nearby[v.index];
    return seen;
  }

  std::vector<segment<T, 2>> walls_;
  std::vector<segment<T, 2>> tiled_{};    // the same in the order of tiles
  std::vector<std::uint32_t> numbers_{};  // which they are of the walls
  box<T, 2> domain_;
  detail::wall_tiles<T> tiles_{};
  bool is_finite_ = true;
};

}  // namespace IRG_ABI
}  // namespace irg
