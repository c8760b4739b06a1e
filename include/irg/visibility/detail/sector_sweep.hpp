// SPDX-License-Identifier: MIT
// The cells that are seen from one in space, found sector by sector.
//
// Directions with a longest axis are pairs of slopes from -1 to 1; a sector is a square of them, whose sides are
// fractions over a power of two. It is followed from slab to slab along the longest axis. Where no cell that it
// touches has anything in it, all centres in it are seen; where all of them are full, nothing is seen behind them.
// Otherwise it is cut into four, and when there are hardly more centres than sectors, see() is asked. Touching counts,
// so corners cannot matter.
//
// Looks is told which cells of a slab are looked at, and how many sight lines see() follows.
#pragma once

#include <concepts>
#include <cstdint>

#include <irg/core/scalar.hpp>
#include <irg/spatial/walled_grid.hpp>
#include <irg/visibility/see.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

struct no_looks {
  IRG_INLINE constexpr void cells(const cell3&, const cell3&) const noexcept {}
  IRG_INLINE constexpr void line() const noexcept {}
};

template <std::same_as<walled_grid> Map, class Looks = no_looks>
class sector_sweep {
public:
  struct task {
    const Map* map;
    cell3 viewer;
    corner_rule corners;
    std::int64_t radius;
  };

  sector_sweep() = delete;
  constexpr sector_sweep(const task& t, cell_grid& seen, Looks looks = {})
      : map_(*t.map), viewer_(t.viewer), rules_{t.corners, end_cells::untested}, radius_(t.radius), seen_(seen),
        looks_(looks) {
    const Map& map = map_;
    if (!map.walled()) return;
    in_the_way_ = map.cells();
    for (int axis = 0; axis < 3; ++axis)
      map.blocking(axis).for_each([&](cell3 c) {
        in_the_way_.set(c);
        (axis == 0 ? c.x : axis == 1 ? c.y : c.z) += 1;
        if (map.extent().holds(c)) in_the_way_.set(c);
      });
  }

  constexpr void run() {
    seen_.set(viewer_);
    const grid_extent e = map_.extent();
    const int size[] = {e.width, e.height, e.depth};
    for (axis_ = 0; axis_ < 3; ++axis_)
      for (sign_ = -1; sign_ <= 1; sign_ += 2) {
        u_axis_ = axis_ == 0 ? 1 : 0;
        v_axis_ = axis_ == 2 ? 1 : 2;
        const int at = viewer_[axis_];
        slabs_ = lesser<std::int64_t>(sign_ > 0 ? size[axis_] - 1 - at : at, radius_);
        u_range_ = {-viewer_[u_axis_], size[u_axis_] - 1 - viewer_[u_axis_]};
        v_range_ = {-viewer_[v_axis_], size[v_axis_] - 1 - viewer_[v_axis_]};
        for (std::int64_t u = -1; u <= 0; ++u)
          for (std::int64_t v = -1; v <= 0; ++v) follow({u, v, 0}, 1);
      }
  }

private:
  // The slopes from u to u + 1 and from v to v + 1, over 2^level.
  struct sector {
    std::int64_t u, v;
    int level;
  };
  struct range {
    std::int64_t first, last;
    constexpr bool empty() const noexcept { return first > last; }
  };
  static constexpr range both(const range& a, const range& b) noexcept {
    return {greater(a.first, b.first), lesser(a.last, b.last)};
  }

  // Cells that slopes from s to s + 1 touch between two distances from the viewer, in halves of a slab.
  static constexpr range touched(std::int64_t s, int level, std::int64_t first, std::int64_t last) noexcept {
    const std::int64_t half = std::int64_t{1} << level;
    const std::int64_t low = s * (s >= 0 ? first : last), high = (s + 1) * (s + 1 >= 0 ? last : first);
    return {-((half - low) >> (level + 1)), (high + half) >> (level + 1)};
  }
  // Cells whose centres they hold; centres between sectors belong to the second where each is wanted once.
  static constexpr range centres(std::int64_t s, int level, std::int64_t slab, bool once) noexcept {
    const std::int64_t whole = std::int64_t{1} << level;
    const bool last = once && s + 1 < whole;
    return {-((-s * slab) >> level), last ? -((-(s + 1) * slab) >> level) - 1 : ((s + 1) * slab) >> level};
  }

  constexpr cell3 cell_at(std::int64_t slab, std::int64_t u, std::int64_t v) const noexcept {
    cell3 c = viewer_;
    int* const to[] = {&c.x, &c.y, &c.z};
    *to[axis_] += static_cast<int>(sign_ * slab);
    *to[u_axis_] += static_cast<int>(u);
    *to[v_axis_] += static_cast<int>(v);
    return c;
  }
  constexpr bool is_near(const cell3& c) const noexcept {
    const std::int64_t x = c.x - viewer_.x, y = c.y - viewer_.y, z = c.z - viewer_.z;
    return x * x + y * y + z * z <= radius_ * radius_;
  }

  // Whether the cells of a run along x are all as asked for.
  static constexpr bool all_are(const cell_grid& g, const cell3& c, std::int64_t count, bool full) noexcept {
    const std::uint64_t* const row = g.row(c.y, c.z);
    const std::int64_t last = c.x + count - 1;
    const std::uint64_t flip = full ? ~std::uint64_t{0} : 0;
    for (std::int64_t i = c.x >> 6; i <= last >> 6; ++i) {
      std::uint64_t wrong = row[i] ^ flip;
      if (i == c.x >> 6) wrong &= ~std::uint64_t{0} << (c.x & 63);
      if (i == last >> 6) wrong &= ~std::uint64_t{0} >> (63 - (last & 63));
      if (wrong != 0) return false;
    }
    return true;
  }
  constexpr bool all_are(const cell_grid& g, std::int64_t slab, const range& u, const range& v,
                         bool full) const noexcept {
    for (std::int64_t j = v.first; j <= v.last; ++j) {
      const cell3 c = cell_at(slab, u.first, j);
      if (axis_ != 0) {
        if (!all_are(g, c, u.last - u.first + 1, full)) return false;
        continue;
      }
      const std::uint64_t* word = g.row(c.y, c.z) + (c.x >> 6);
      for (std::int64_t i = u.first; i <= u.last; ++i, word += g.words_per_row())
        if ((*word >> (c.x & 63) & 1) != (full ? 1u : 0u)) return false;
    }
    return true;
  }

  constexpr void mark(std::int64_t slab, const range& u, const range& v) noexcept {
    for (std::int64_t j = v.first; j <= v.last && !u.empty(); ++j) {
      const cell3 c = cell_at(slab, u.first, j);
      if (radius_ <= far_corner(slab)) {
        for (std::int64_t i = u.first; i <= u.last; ++i)
          if (const cell3 one = cell_at(slab, i, j); is_near(one)) seen_.set(one);
      } else if (axis_ != 0) {
        seen_.set_run(c.x, static_cast<int>(c.x + u.last - u.first + 1), c.y, c.z);
      } else {
        std::uint64_t* word = seen_.row(c.y, c.z) + (c.x >> 6);
        const std::uint64_t bit = std::uint64_t{1} << (c.x & 63);
        for (std::int64_t i = u.first; i <= u.last; ++i, word += seen_.words_per_row()) *word |= bit;
      }
    }
  }
  static constexpr std::int64_t far_corner(std::int64_t slab) noexcept { return 2 * slab; }  // above sqrt(3) * slab

  // Asks for each centre of a slab.
  constexpr void test(const sector& s, std::int64_t slab) {
    const range u = both(centres(s.u, s.level, slab, true), u_range_),
                v = both(centres(s.v, s.level, slab, true), v_range_);
    for (std::int64_t j = v.first; j <= v.last; ++j)
      for (std::int64_t i = u.first; i <= u.last; ++i)
        if (const cell3 c = cell_at(slab, i, j); !seen_.is_full(c) && is_near(c)) {
          looks_.line();
          if (see(map_, viewer_, c, rules_)) seen_.set(c);
        }
  }

  // Whether full cells of a slab are all that the sector touches at a distance, so that nothing is seen behind them.
  constexpr bool blocked_at(const sector& s, std::int64_t slab, std::int64_t distance) const noexcept {
    return all_are(map_.cells(), slab, both(touched(s.u, s.level, distance, distance), u_range_),
                   both(touched(s.v, s.level, distance, distance), v_range_), true);
  }

  constexpr void follow(const sector& s, std::int64_t slab) {
    const cell_grid& things = map_.walled() ? in_the_way_ : map_.cells();
    bool open = true;
    for (; slab <= slabs_; ++slab) {
      const range u = both(touched(s.u, s.level, 2 * slab - 1, 2 * slab + 1), u_range_),
                  v = both(touched(s.v, s.level, 2 * slab - 1, 2 * slab + 1), v_range_);
      if (u.empty() || v.empty()) return;  // the sector has left the map
      looks_.cells(cell_at(slab, u.first, v.first), cell_at(slab, u.last, v.last));
      if (open && all_are(things, slab, u, v, false)) {
        // Slopes of 1 leave the viewer's own cell through its edges, which the closed rule asks about: see() tells.
        const bool edges = rules_.corners == corner_rule::closed;
        const range within{edges ? 1 - slab : -slab, edges ? slab - 1 : slab};
        mark(slab, both(both(centres(s.u, s.level, slab, false), u_range_), within),
             both(both(centres(s.v, s.level, slab, false), v_range_), within));
        if (edges) test(s, slab);
        continue;
      }
      open = false;
      const bool ends = blocked_at(s, slab, 2 * slab - 1) || blocked_at(s, slab, 2 * slab);
      if (!ends && std::int64_t{1} << s.level < slabs_) {
        for (std::int64_t i = 0; i < 4; ++i) follow({2 * s.u + (i & 1), 2 * s.v + (i >> 1), s.level + 1}, slab);
        return;
      }
      test(s, slab);
      if (ends) return;
    }
  }

  const Map& map_;
  cell3 viewer_;
  sight_rules rules_;
  std::int64_t radius_;
  cell_grid& seen_;
  [[no_unique_address]] Looks looks_;
  cell_grid in_the_way_;  // full cells and those with walls, where there are walls
  int axis_ = 0, sign_ = 1, u_axis_ = 0, v_axis_ = 0;
  std::int64_t slabs_ = 0;
  range u_range_{}, v_range_{};
};

}  // namespace IRG_ABI
}  // namespace irg::detail
