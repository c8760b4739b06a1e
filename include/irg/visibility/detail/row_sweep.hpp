// SPDX-License-Identifier: MIT
// The cells that are seen from one, found row by row in one quadrant.
//
// Seen from the viewer, column x and row y of a quadrant are both >= 0. The directions x/y that are not blocked yet
// are kept as open sectors between two slopes each, in order. A full cell at the row y blocks the slopes between those
// of its corners, (2x-1)/(2y+1) and (2x+1)/(2y-1); a wall those between its ends. Whether a slope that is an end of
// what is blocked is blocked itself is for the corner that it runs through to say. All of it is in whole numbers:
// slopes are fractions, and the column that each sector's end has reached is counted on from row to row.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include <irg/core/scalar.hpp>
#include <irg/spatial/walled_grid.hpp>
#include <irg/visibility/detail/open_sectors.hpp>
#include <irg/visibility/see.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

IRG_INLINE constexpr std::int64_t compare(const sweep_slope& a, const sweep_slope& b) noexcept {
  return a.num * b.den - b.num * a.den;
}
constexpr sweep_end end_at(const sweep_slope& s, std::int64_t y) noexcept {
  const std::int64_t x = s.num * y / s.den, dx = s.num / s.den;
  return {s, x, s.num * y - x * s.den, dx, s.num - dx * s.den};
}
IRG_INLINE constexpr void step_row(sweep_end& e) noexcept {
  e.x += e.dx;
  e.rest += e.drest;
  if (e.rest >= e.slope.den) {
    e.rest -= e.slope.den;
    ++e.x;
  }
}
// The first and the last column of the row whose cells' centres are in the sector.
IRG_INLINE constexpr std::int64_t first_column(const sweep_end& low) noexcept {
  return low.x + (low.rest > 0 || !low.slope.closed ? 1 : 0);
}
IRG_INLINE constexpr std::int64_t last_column(const sweep_end& high) noexcept {
  return high.x - (high.rest == 0 && !high.slope.closed ? 1 : 0);
}

constexpr std::uint64_t reversed(std::uint64_t v) noexcept {
  v = (v >> 1 & 0x5555555555555555u) | (v & 0x5555555555555555u) << 1;
  v = (v >> 2 & 0x3333333333333333u) | (v & 0x3333333333333333u) << 2;
  v = (v >> 4 & 0x0f0f0f0f0f0f0f0fu) | (v & 0x0f0f0f0f0f0f0f0fu) << 4;
  v = (v >> 8 & 0x00ff00ff00ff00ffu) | (v & 0x00ff00ff00ff00ffu) << 8;
  v = (v >> 16 & 0x0000ffff0000ffffu) | (v & 0x0000ffff0000ffffu) << 16;
  return v >> 32 | v << 32;
}
// The 64 bits of a row from a column on; 0 where there is none.
IRG_INLINE constexpr std::uint64_t bits_from(const std::uint64_t* row, int words, std::int64_t column) noexcept {
  const std::int64_t i = column >> 6;
  const int shift = static_cast<int>(column & 63);
  const std::uint64_t low = i >= 0 && i < words ? row[i] >> shift : 0;
  const std::uint64_t high = shift != 0 && i + 1 >= 0 && i + 1 < words ? row[i + 1] << (64 - shift) : 0;
  return low | high;
}

// One quadrant of a flat map, seen from a cell of it. Emit is told what is seen: centres(y, first, last), or where it
// has the member light(y, first, last, low, high), which cells are reached by light between two slopes. Where it has
// the member looked(y, first, last), it is told which cells were looked at for what blocks.
template <class Emit>
class row_sweep {
public:
  struct task {
    const walled_grid* map;
    cell viewer;
    int sign_x, sign_y;
    corner_rule corners;
    std::int64_t radius;
  };

  constexpr row_sweep(const task& t, std::vector<open_sector>& now, std::vector<open_sector>& next, Emit& sink)
      : task_(t), walled_(t.map->walled()), now_(now), next_(next), emit_(sink) {
    const grid_extent e = t.map->extent();
    right_ = t.sign_x > 0 ? e.width - 1 - t.viewer.x : t.viewer.x;
    rows_ = t.sign_y > 0 ? e.height - 1 - t.viewer.y : t.viewer.y;
    right_ = minimum(right_, t.radius);
    rows_ = minimum(rows_, t.radius);
  }

  /// needs   nothing in the way in the rows before the one it begins with
  constexpr void run(std::int64_t begin = 0) {
    if (begin == 0) {
      first_row();
      ++begin;
    } else {
      now_.clear();
      now_.push_back({end_at({0, 1, true}, begin - 1), end_at({2 * right_ + 2, 1, true}, begin - 1)});
    }
    for (std::int64_t y = begin; y <= rows_ && !now_.empty(); ++y) {
      while (task_.radius - right_ < y && right_ * right_ + y * y > task_.radius * task_.radius) --right_;
      next_.clear();
      for (open_sector& g : now_) {
        const std::int64_t first = g.low.x;  // of the row before: what the sector can touch in this one begins there
        if (first > right_) break;
        step_row(g.low);
        step_row(g.high);
        const std::int64_t last = minimum(right_, g.high.x + g.high.dx + 2), b = next_blocker(y, first, last);
        if (b <= last) {
          cross_row(g, y, first, last, b);
          continue;
        }
        emit_between(y, first, last, g.low, true, g.high);
        next_.push_back(g);
      }
      now_.swap(next_);
      if (walled_) cross_walls(y);
    }
  }

private:
  static constexpr bool has_light = requires(Emit& e, const sweep_slope& s) { e.light(1, 1, 1, s, s); };
  static constexpr bool has_looked = requires(Emit& e) { e.looked(1, 1, 1); };

  constexpr int column(std::int64_t x) const noexcept { return static_cast<int>(task_.viewer.x + task_.sign_x * x); }
  constexpr int line(std::int64_t y) const noexcept { return static_cast<int>(task_.viewer.y + task_.sign_y * y); }
  // 64 bits of a row of the quadrant. A wall belongs to the lesser of its two cells: going down, to the farther one.
  constexpr std::uint64_t bits(const cell_grid& g, std::int64_t y, std::int64_t x, int axis = -1) const noexcept {
    const int row = line(y) - (axis == 1 && task_.sign_y < 0 ? 1 : 0);
    if (row < 0) return 0;
    const std::uint64_t* const words = g.row(row, 0);
    if (task_.sign_x > 0) return bits_from(words, g.words_per_row(), task_.viewer.x + x);
    return reversed(bits_from(words, g.words_per_row(), task_.viewer.x - x - 63 - (axis == 0 ? 1 : 0)));
  }
  constexpr std::uint64_t full(std::int64_t y, std::int64_t x) const noexcept {
    const std::uint64_t b = bits(task_.map->cells(), y, x);
    return y == 0 && x == 0 ? b & ~std::uint64_t{1} : b;  // the viewer is not in its own way
  }
  constexpr bool is_full_at(std::int64_t y, std::int64_t x) const noexcept {
    return (y != 0 || x != 0) && task_.map->is_full({column(x), line(y), 0});
  }
  // The first column from x to last with a cell or a wall to its right that blocks; last + 1 when there is none.
  constexpr std::int64_t next_blocker(std::int64_t y, std::int64_t x, std::int64_t last) const noexcept {
    const std::int64_t b = find_blocker(y, x, last);
    if constexpr (has_looked) emit_.looked(y, x, minimum(b, last));
    return b;
  }
  constexpr std::int64_t find_blocker(std::int64_t y, std::int64_t x, std::int64_t last) const noexcept {
    for (; x <= last; x += 64) {
      std::uint64_t b = full(y, x);
      if (walled_) b |= bits(task_.map->blocking(0), y, x, 0);
      if (b != 0) return minimum(x + std::countr_zero(b), last + 1);
    }
    return last + 1;
  }
  // The last of the full cells from x on without a gap, last at most.
  constexpr std::int64_t run_end(std::int64_t y, std::int64_t x, std::int64_t last) const noexcept {
    for (; x <= last; x += 64)
      if (const std::uint64_t empty = ~full(y, x); empty != 0) return minimum(x + std::countr_zero(empty) - 1, last);
    return last;
  }
  // Whether light passes the corner between the cell (x, y) and (x + 1, y + 1).
  constexpr bool corner_lets(std::int64_t x, std::int64_t y) const {
    if (x < 0 || x >= right_ || y >= rows_) return true;  // no cell is behind it
    if constexpr (has_looked) {
      emit_.looked(y, x + 1, x + 1);
      emit_.looked(y + 1, x, x);
    }
    return !stops_at_corner(*task_.map, {{column(x), line(y), 0}, {task_.sign_x, task_.sign_y, 1}, 3}, task_.corners);
  }

  constexpr void emit_centres(std::int64_t y, std::int64_t first, std::int64_t last) {
    if (first <= last) emit_.centres(y, first, last);
  }
  constexpr void push_sector(const sweep_end& low, const sweep_end& high) {
    const std::int64_t c = compare(low.slope, high.slope);
    if (c < 0 || (c == 0 && low.slope.closed && high.slope.closed)) next_.push_back({low, high});
  }

  constexpr void first_row() {
    const std::int64_t b = next_blocker(0, 0, right_);
    sweep_slope high{2 * right_ + 2, 1, true};
    if constexpr (has_light)
      emit_.light(0, 0, minimum(b, right_), sweep_slope{}, sweep_slope{1, 0, true});
    else
      emit_centres(0, 0, minimum(b, right_));
    if (b <= right_) {
      const bool cell_blocks = is_full_at(0, b);
      high = {cell_blocks ? 2 * b - 1 : 2 * b + 1, 1, corner_lets(cell_blocks ? b - 1 : b, 0)};
    }
    now_.clear();
    now_.push_back({end_at({0, 1, true}, 0), end_at(high, 0)});
    if (walled_) cross_walls(0);
  }

  // Emits what of the columns first to last is seen between the two ends.
  constexpr void emit_between(std::int64_t y, std::int64_t first, std::int64_t last, const sweep_end& low, bool counted,
                              const sweep_end& high) {
    if (first > last) return;
    if constexpr (has_light) {
      emit_.light(y, first, last, low.slope, high.slope);
    } else {
      last = minimum(last, last_column(high));
      if (first > last) return;
      if (counted) return emit_centres(y, maximum(first, first_column(low)), last);
      const sweep_slope centre{first, y, true};
      const std::int64_t c = compare(low.slope, centre);
      if (c > 0 || (c == 0 && !low.slope.closed)) {
        if (first == last) return;
        first = maximum(first, first_column(end_at(low.slope, y)));
      }
      emit_centres(y, first, last);
    }
  }

  // Takes what blocks in a row from a sector. Cells in the row that are seen have nothing that blocks on their left but
  // what the slope `low` passes.
  constexpr void cross_row(const open_sector& g, std::int64_t y, std::int64_t first, std::int64_t last,
                           std::int64_t b) {
    sweep_end low = g.low;
    bool counted = true;  // whether low knows its column
    for (std::int64_t x = first;; b = next_blocker(y, x, last)) {
      emit_between(y, x, minimum(b, last), low, counted, g.high);
      if (b > last) break;
      const bool cell_blocks = is_full_at(y, b);
      sweep_slope before{cell_blocks ? 2 * b - 1 : 2 * b + 1, 2 * y + 1, true};
      const std::int64_t beyond = compare(before, g.high.slope);
      if (beyond > 0) break;
      if (compare(low.slope, before) <= 0) {
        before.closed = corner_lets(cell_blocks ? b - 1 : b, y) && (beyond < 0 || g.high.slope.closed);
        push_sector(counted ? low : end_at(low.slope, y), end_at(before, y));
      }
      std::int64_t q = b;
      if (!has_light && cell_blocks) {  // of cells side by side, those that are reached from the row below are seen
        q = run_end(y, b, last);
        if constexpr (has_looked) emit_.looked(y, b, q);
        emit_between(y, b + 1, minimum(q, y - 1), low, counted, g.high);
        if (b < y && y <= q && corner_lets(y - 1, y - 1)) emit_between(y, y, y, low, counted, g.high);
      }
      sweep_slope after{2 * q + 1, 2 * y - 1, true};
      const std::int64_t ahead = compare(after, low.slope);
      if (ahead >= 0) {
        after.closed = corner_lets(q, y - 1) && (ahead > 0 || low.slope.closed);
        low.slope = after;
        counted = false;
        const std::int64_t c = compare(low.slope, g.high.slope);
        if (c > 0 || (c == 0 && !(low.slope.closed && g.high.slope.closed))) return;
      }
      x = q + 1;
    }
    push_sector(counted ? low : end_at(low.slope, y), g.high);
  }

  // Takes the walls between this row and the next from all sectors.
  constexpr void cross_walls(std::int64_t y) {
    next_.clear();
    for (const open_sector& g : now_) {
      sweep_end low = g.low;
      const std::int64_t last = minimum(right_, g.high.x + g.high.dx + 2);
      bool blocked = false;
      for (std::int64_t x = g.low.x; x <= last && !blocked; ++x) {
        if ((bits(task_.map->blocking(1), y, x, 1) & 1) == 0) continue;
        sweep_slope before{2 * x - 1, 2 * y + 1, true}, after{2 * x + 1, 2 * y + 1, true};
        const std::int64_t beyond = compare(before, g.high.slope);
        if (beyond > 0) break;
        if (before.num >= 0 && compare(low.slope, before) <= 0) {
          before.closed = corner_lets(x - 1, y) && (beyond < 0 || g.high.slope.closed);
          push_sector(low, end_at(before, y));
        }
        const std::int64_t ahead = compare(after, low.slope);
        if (ahead < 0) continue;
        after.closed = corner_lets(x, y) && (ahead > 0 || low.slope.closed);
        low = end_at(after, y);
        const std::int64_t c = compare(after, g.high.slope);
        blocked = c > 0 || (c == 0 && !(after.closed && g.high.slope.closed));
      }
      if (!blocked) push_sector(low, g.high);
    }
    now_.swap(next_);
  }

  task task_;
  bool walled_;
  std::int64_t right_ = 0, rows_ = 0;
  std::vector<open_sector>&now_, &next_;
  Emit& emit_;
};

}  // namespace IRG_ABI
}  // namespace irg::detail
