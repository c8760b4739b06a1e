// SPDX-License-Identifier: MIT
// sight_tracker: what several units see, kept up to date while they move and the map changes.
//
// Of each unit it keeps what it sees and which cells its light touches at all. A change of a cell or wall matters only
// to units whose light touches one of the cells around it: the others' fields are left as they are.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <irg/spatial/walled_grid.hpp>
#include <irg/visibility/field_of_view.hpp>
#if IRG_BODIES
#include <irg/visibility/detail/row_sweep.hpp>
#include <irg/visibility/visible_part.hpp>
#endif

namespace irg {

namespace detail::inline IRG_COMPILED_ABI {

// Marks the cells of a flat map that light from a cell touches.
template <class Memory>
IRG_API void mark_light(const walled_grid& map, const cell3& at, const view_options& o, Memory& memory,
                        cell_grid& touched);

}  // namespace detail::inline IRG_COMPILED_ABI

/// What units on a map see. (A template, so that whoever does not use it does not compile it.)
template <std::same_as<walled_grid> Map = walled_grid>
class sight_tracker {
public:
  IRG_INLINE constexpr explicit sight_tracker(Map map, const view_options& options = {})
      : map_(std::move(map)), options_(options) {}

  [[nodiscard]] IRG_INLINE constexpr const Map& map() const noexcept { return map_; }
  [[nodiscard]] IRG_INLINE constexpr std::size_t size() const noexcept { return units_.size(); }
  /// needs   a unit's number, here and below
  [[nodiscard]] IRG_INLINE constexpr const cell3& unit(std::size_t i) const noexcept { return units_[i].at; }
  [[nodiscard]] IRG_INLINE constexpr const cell_grid& seen_by(std::size_t i) const noexcept { return units_[i].seen; }
  /// The cells that any unit sees.
  [[nodiscard]] IRG_INLINE constexpr cell_grid seen() const {
    cell_grid all(map_.extent());
    for (const state& u : units_) all |= u.seen;
    return all;
  }

  /// Adds a unit and returns its number.
  IRG_INLINE constexpr std::size_t add(const cell3& at) {
    units_.push_back({at, cell_grid(map_.extent()), cell_grid(map_.extent())});
    look(units_.back());
    return units_.size() - 1;
  }
  /// Moves a unit; the others' fields stay.
  IRG_INLINE constexpr void move(std::size_t i, const cell3& to) {
    units_[i].at = to;
    look(units_[i]);
  }
  /// Fills or empties a cell and returns how many units had to look again.
  /// needs   a cell of the map, here and below
  IRG_INLINE constexpr int set(const cell3& c, bool full) {
    if (map_.is_full(c) == full) return 0;
    map_.set(c, full);
    return look_at(c);
  }
  /// Puts a wall, opens or shuts a door, and returns how many units had to look again.
  template <std::same_as<wall_kind> Kind = wall_kind>
  IRG_INLINE constexpr int set_wall(const cell3& c, int axis, Kind kind) {
    const bool before = map_.has_wall(c, axis);
    map_.set_wall(c, axis, kind);
    return map_.has_wall(c, axis) == before ? 0 : look_at(c);
  }

private:
  struct state {
    cell3 at;
    cell_grid seen, touched;
  };

  IRG_INLINE constexpr void look(state& u) {
    u.seen.clear();
    add_field_of_view(map_, u.at, u.seen, memory_, options_);
    u.touched.clear();
    detail::mark_light(map_, u.at, options_, memory_, u.touched);
  }
  // In space every unit whose radius reaches the cell looks again.
  [[nodiscard]] IRG_INLINE constexpr bool matters(const state& u, const cell3& c) const noexcept {
    for (int y = c.y - 1; y <= c.y + 1; ++y)
      for (int x = c.x - 1; x <= c.x + 1; ++x)
        if (map_.extent().holds({x, y, 0}) && u.touched.is_full({x, y, 0})) return true;
    return false;
  }
  IRG_INLINE constexpr int look_at(const cell3& c) {
    int n = 0;
    for (state& u : units_)
      if (map_.extent().depth != 1 || matters(u, c)) {
        look(u);
        ++n;
      }
    return n;
  }

  Map map_;
  view_options options_;
  std::vector<state> units_;
  view_memory memory_;
};

}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// Marks the cells of a quadrant that light touches, if only with a corner.
struct light_marks {
  cell_grid* touched;
  cell viewer;
  int sign_x, sign_y;

  constexpr void light(std::int64_t y, std::int64_t first, std::int64_t last, const sweep_slope& low,
                       const sweep_slope& high) const {
    for (std::int64_t x = first; x <= last; ++x) {
      const cell_slopes s = slopes_of(x, y);
      if (compare(s.low, high) > 0) return;
      if (compare(s.high, low) < 0) continue;
      touched->set(cell{static_cast<int>(viewer.x + sign_x * x), static_cast<int>(viewer.y + sign_y * y)});
    }
  }
};

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <class Memory>
IRG_API void mark_light(const walled_grid& map, const cell3& at, const view_options& o, Memory& memory,
                        cell_grid& touched) {
  if (map.extent().depth != 1 || !map.extent().holds(at)) return;
  const cell viewer{at.x, at.y};
  for (int sign_y = -1; sign_y <= 1; sign_y += 2)
    for (int sign_x = -1; sign_x <= 1; sign_x += 2) {
      light_marks marks{&touched, viewer, sign_x, sign_y};
      row_sweep<light_marks>({&map, viewer, sign_x, sign_y, o.rules.corners, o.radius}, memory.now, memory.next, marks)
          .run();
    }
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
