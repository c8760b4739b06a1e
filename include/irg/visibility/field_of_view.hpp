// SPDX-License-Identifier: MIT
// field_of_view: all cells that are seen from one or from several, in the plane by a sweep over the rows, in space by a
// sweep over sectors.
#pragma once

#include <concepts>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include <irg/core/scalar.hpp>
#include <irg/spatial/walled_grid.hpp>
#include <irg/visibility/detail/open_sectors.hpp>
#include <irg/visibility/see.hpp>
#if IRG_BODIES
#include <irg/core/contract.hpp>
#include <irg/math/wide_int.hpp>
#include <irg/visibility/detail/row_sweep.hpp>
#endif

namespace irg {

/// The directions from one to another, turning from x to y; both belong to them.
/// shape   at most half a turn; all directions when one of them is (0, 0)
struct sight_cone {
  cell from, to;
  bool operator==(const sight_cone&) const = default;
};

/// What is looked for.
struct view_options {
  line_of_sight_options rules;
  /// Only cells whose centres are so near. Negative: none.
  int radius = (std::numeric_limits<int>::max)();
  /// Only cells in these directions, seen along z.
  sight_cone cone;
  bool operator==(const view_options&) const = default;
};

/// What the sweeps need while they run; kept from call to call, it spares allocations.
struct view_memory {
  std::vector<detail::open_sector> now, next;
};

/// What fields of view took. Summed over viewers.
/// gives   in_reach - looked_at cells that nobody looked at, since they lie behind what was found before
struct view_counts {
  std::int64_t in_reach = 0;  // cells of the map within the radius, whatever the cone
  std::int64_t looked_at = 0;  // of these, looked at for what blocks, singly or 64 at a time, with the viewer's own
  std::int64_t in_open_rows = 0;  // of these, in rows that were taken whole, there being nothing in the way
  std::int64_t sight_lines = 0;  // in space: cells of which has_line_of_sight() was asked

  IRG_INLINE constexpr view_counts& operator+=(const view_counts& o) noexcept {
    in_reach += o.in_reach;
    looked_at += o.looked_at;
    in_open_rows += o.in_open_rows;
    sight_lines += o.sight_lines;
    return *this;
  }
  bool operator==(const view_counts&) const = default;
};

/// The same memory for who wants to know what was looked at: each field of view is added to the counts.
struct counted_view_memory : view_memory {
  view_counts counts;
  cell_grid looked_at;  // by the last viewer
};

inline namespace IRG_ABI {

/// Adds the cells that are seen from the viewer to `seen`: those that has_line_of_sight() tells, its own among them,
/// within the radius and the cone.
/// needs   `seen` of the map's extent
/// gives   nothing when the viewer is no cell of the map
/// exact   always
/// cost    in the plane: a few operations per row and open sector, and per word of 64 cells that are seen; in space: a
///         few per row of each sector that is wholly open, has_line_of_sight() for cells at borders of what is hidden.
///         With a counted_view_memory also a few per cell of the map
template <std::derived_from<view_memory> Memory>
constexpr void add_field_of_view(const walled_grid& map, const cell3& viewer, cell_grid& seen, Memory& memory,
                                 const view_options& o = {});

/// The cells that any of the viewers sees.
/// shape   map: any grid; one of another type than walled_grid is packed into bits first
template <CellGrid G>
[[nodiscard]] constexpr cell_grid field_of_view(const G& map, std::span<const cell3> viewers,
                                                const view_options& o = {}) {
  if constexpr (std::is_same_v<G, walled_grid>) {
    cell_grid seen(map.extent());
    view_memory memory;
    for (const cell3& viewer : viewers) add_field_of_view(map, viewer, seen, memory, o);
    return seen;
  } else {
    return field_of_view(with_walls(map), viewers, o);
  }
}

/// The cells that are seen from one.
template <CellGrid G>
[[nodiscard]] constexpr cell_grid field_of_view(const G& map, const cell3& viewer, const view_options& o = {}) {
  return field_of_view(map, std::span<const cell3>(&viewer, 1), o);
}

/// The same, and adds to the counts what was looked at. A viewer who sees nothing adds nothing.
template <CellGrid G>
[[nodiscard]] constexpr cell_grid field_of_view(const G& map, std::span<const cell3> viewers, const view_options& o,
                                                view_counts& counts) {
  if constexpr (std::is_same_v<G, walled_grid>) {
    cell_grid seen(map.extent());
    counted_view_memory memory;
    for (const cell3& viewer : viewers) add_field_of_view(map, viewer, seen, memory, o);
    counts += memory.counts;
    return seen;
  } else {
    return field_of_view(with_walls(map), viewers, o, counts);
  }
}
template <CellGrid G>
[[nodiscard]] constexpr cell_grid field_of_view(const G& map, const cell3& viewer, const view_options& o,
                                                view_counts& counts) {
  return field_of_view(map, std::span<const cell3>(&viewer, 1), o, counts);
}

}  // namespace IRG_ABI

namespace detail::inline IRG_COMPILED_ABI {

template <class Memory>
IRG_API void add_seen(const walled_grid& map, const cell3& viewer, cell_grid& seen, Memory& memory,
                      const view_options& o);

}  // namespace detail::inline IRG_COMPILED_ABI

inline namespace IRG_ABI {

template <std::derived_from<view_memory> Memory>
constexpr void add_field_of_view(const walled_grid& map, const cell3& viewer, cell_grid& seen, Memory& memory,
                                 const view_options& o) {
  using known = std::conditional_t<std::derived_from<Memory, counted_view_memory>, counted_view_memory, view_memory>;
  detail::add_seen<known>(map, viewer, seen, memory, o);
}

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// The cells that are seen from one in space, found sector by sector.
//
// Directions with a longest axis are pairs of slopes from -1 to 1; a sector is a square of them, whose sides are
// fractions over a power of two. It is followed from slab to slab along the longest axis. Where no cell that it
// touches has anything in it, all centres in it are seen; where all of them are full, nothing is seen behind them.
// Otherwise it is cut into four, and when there are hardly more centres than sectors, has_line_of_sight() is asked.
// Touching counts, so corners cannot matter.
//
// Looks is told which cells of a slab are looked at, and how many sight lines has_line_of_sight() follows.

struct no_looks {
  IRG_INLINE constexpr void cells(const cell3&, const cell3&) const noexcept {}
  IRG_INLINE constexpr void line() const noexcept {}
};

template <class Looks = no_looks>
class sector_sweep {
public:
  struct task {
    const walled_grid* map;
    cell3 viewer;
    corner_rule corners;
    std::int64_t radius;
  };

  sector_sweep() = delete;
  constexpr sector_sweep(const task& t, cell_grid& seen, Looks looks = {})
      : map_(*t.map), viewer_(t.viewer), rules_{t.corners, end_cells::untested}, radius_(t.radius), seen_(seen),
        looks_(looks) {
    const walled_grid& map = map_;
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
        slabs_ = minimum<std::int64_t>(sign_ > 0 ? size[axis_] - 1 - at : at, radius_);
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
    return {maximum(a.first, b.first), minimum(a.last, b.last)};
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
          if (has_line_of_sight(map_, viewer_, c, rules_)) seen_.set(c);
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
        // Slopes of 1 leave the viewer's own cell through its edges, which the closed rule asks about:
        // has_line_of_sight() tells.
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

  const walled_grid& map_;
  cell3 viewer_;
  line_of_sight_options rules_;
  std::int64_t radius_;
  cell_grid& seen_;
  [[no_unique_address]] Looks looks_;
  cell_grid in_the_way_;  // full cells and those with walls, where there are walls
  int axis_ = 0, sign_ = 1, u_axis_ = 0, v_axis_ = 0;
  std::int64_t slabs_ = 0;
  range u_range_{}, v_range_{};
};

// Writes runs of cells of a quadrant into a grid.
struct centre_marks {
  cell_grid* seen;
  cell viewer;
  int sign_x, sign_y;

  IRG_INLINE constexpr void centres(std::int64_t y, std::int64_t first, std::int64_t last) const noexcept {
    const std::int64_t a = viewer.x + sign_x * first, b = viewer.x + sign_x * last;
    seen->set_run(static_cast<int>(minimum(a, b)), static_cast<int>(maximum(a, b) + 1),
                  static_cast<int>(viewer.y + sign_y * y), 0);
  }
};

// The same, and marks what was looked at.
struct counted_marks : centre_marks {
  cell_grid* looked_at;

  constexpr void looked(std::int64_t y, std::int64_t first, std::int64_t last) const noexcept {
    if (first <= last) centre_marks{looked_at, viewer, sign_x, sign_y}.centres(y, first, last);
  }
};

// What is looked at in space.
struct counted_looks {
  counted_view_memory* memory;

  constexpr void cells(const cell3& a, const cell3& b) const noexcept {
    for (int z = minimum(a.z, b.z); z <= maximum(a.z, b.z); ++z)
      for (int y = minimum(a.y, b.y); y <= maximum(a.y, b.y); ++y)
        memory->looked_at.set_run(minimum(a.x, b.x), maximum(a.x, b.x) + 1, y, z);
  }
  constexpr void line() const noexcept { ++memory->counts.sight_lines; }
};

// Adds up the cells within the radius, and those of them that were looked at.
constexpr void count_looks(const cell3& viewer, std::int64_t radius, counted_view_memory& memory) {
  const grid_extent e = memory.looked_at.extent();
  for (int z = 0; z < e.depth; ++z)
    for (int y = 0; y < e.height; ++y)
      for (int x = 0; x < e.width; ++x) {
        const std::int64_t dx = x - viewer.x, dy = y - viewer.y, dz = z - viewer.z;
        if (dx * dx + dy * dy + dz * dz > radius * radius) continue;
        ++memory.counts.in_reach;
        if (memory.looked_at.is_full({x, y, z})) ++memory.counts.looked_at;
      }
}

constexpr bool in_cone(const sight_cone& cone, const cell3& viewer, const cell3& c) noexcept {
  struct direction {
    std::int64_t x, y;
    constexpr int turn_to(const direction& to) const noexcept {
      return (wide_int<1>(x) * wide_int<1>(to.y) - wide_int<1>(y) * wide_int<1>(to.x)).sign();
    }
    constexpr bool along(const direction& other) const noexcept {
      return turn_to(other) == 0 &&
             (wide_int<1>(x) * wide_int<1>(other.x) + wide_int<1>(y) * wide_int<1>(other.y)).sign() > 0;
    }
  };
  const direction from{cone.from.x, cone.from.y}, to{cone.to.x, cone.to.y};
  const direction d{std::int64_t{c.x} - viewer.x, std::int64_t{c.y} - viewer.y};
  if (cone.from == cell{} || cone.to == cell{} || (d.x == 0 && d.y == 0)) return true;
  return from.along(to) ? from.along(d) : from.turn_to(d) >= 0 && d.turn_to(to) >= 0;
}

// Marks the rows from the viewer's on while nothing stands in them, whole, and returns how many they are.
constexpr std::int64_t open_rows(const walled_grid& map, cell viewer, int sign_y, std::int64_t radius,
                                 cell_grid& seen) {
  const cell_grid& cells = map.cells();
  const grid_extent e = map.extent();
  if (map.walled() || map.is_full(viewer)) return 0;
  std::int64_t n = 0;
  for (int y = viewer.y; y >= 0 && y < e.height; y += sign_y, ++n) {
    const std::uint64_t* const row = cells.row(y, 0);
    std::uint64_t any = 0;
    for (int i = 0; i < cells.words_per_row(); ++i) any |= row[i];
    if (any != 0 || n * n + std::int64_t{e.width} * e.width > radius * radius) return n;
    seen.set_run(0, e.width, y, 0);
  }
  return n;
}

template <std::derived_from<view_memory> Memory>
constexpr void sweep(const walled_grid& map, const cell3& viewer, const view_options& o, Memory& memory,
                     cell_grid& seen) {
  constexpr bool counts = std::derived_from<Memory, counted_view_memory>;
  if constexpr (counts) {
    if (memory.looked_at.extent() == map.extent())
      memory.looked_at.clear();
    else
      memory.looked_at = cell_grid(map.extent());
  }
  if (map.extent().depth == 1) {
    const cell at{viewer.x, viewer.y};
    for (int sign_y = -1; sign_y <= 1; sign_y += 2) {
      const std::int64_t begin = o.radius > map.extent().width ? open_rows(map, at, sign_y, o.radius, seen) : 0;
      if constexpr (counts) {
        for (std::int64_t y = 0; y < begin; ++y)
          memory.looked_at.set_run(0, map.extent().width, static_cast<int>(at.y + sign_y * y), 0);
        // The viewer's row is taken from both sides.
        memory.counts.in_open_rows += map.extent().width * (sign_y < 0 || begin == 0 ? begin : begin - 1);
      }
      for (int sign_x = -1; sign_x <= 1; sign_x += 2) {
        const auto run = [&]<class Marks>(Marks marks) {
          row_sweep<Marks>({&map, at, sign_x, sign_y, o.rules.corners, o.radius}, memory.now, memory.next, marks)
              .run(begin);
        };
        const centre_marks marks{&seen, at, sign_x, sign_y};
        if constexpr (counts)
          run(counted_marks{marks, &memory.looked_at});
        else
          run(marks);
      }
    }
  } else if constexpr (counts) {
    memory.looked_at.set(viewer);
    sector_sweep<counted_looks>({&map, viewer, o.rules.corners, o.radius}, seen, {&memory}).run();
  } else {
    sector_sweep<>({&map, viewer, o.rules.corners, o.radius}, seen).run();
  }
  if constexpr (counts) count_looks(viewer, o.radius, memory);
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <class Memory>
IRG_API void add_seen(const walled_grid& map, const cell3& viewer, cell_grid& seen, Memory& memory,
                      const view_options& o) {
  IRG_EXPECTS(seen.extent() == map.extent());
  if (!map.extent().holds(viewer) || o.radius < 0) return;
  const bool tested = o.rules.ends == end_cells::tested;
  if (tested && map.is_full(viewer)) return;
  const bool all = o.cone.from == cell{} || o.cone.to == cell{};
  if (all && !tested) return sweep(map, viewer, o, memory, seen);
  cell_grid found(map.extent());
  sweep(map, viewer, o, memory, found);
  found.for_each([&](const cell3& c) {
    if (in_cone(o.cone, viewer, c) && !(tested && map.is_full(c))) seen.set(c);
  });
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
