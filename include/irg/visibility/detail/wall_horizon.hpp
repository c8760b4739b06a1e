// SPDX-License-Identifier: MIT
// Walls that may be seen from a source: tiles around it are looked at ring by ring, in those directions only that no
// wall within the rings before covers. Too many walls, never too few: directions are rounded, and what they cover is
// drawn in by more than that, but where two walls meet in one point.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

#include <irg/core/contraction.hpp>
#include <irg/core/conversion.hpp>
#include <irg/geometry/segment.hpp>
#include <irg/visibility/detail/wall_tiles.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

template <Floating T>
class wall_horizon {
public:
  constexpr wall_horizon(const wall_tiles<T>& tiles, std::span<const segment<T, 2>> walls, const point<T, 2>& source)
      : tiles_(tiles), walls_(walls), source_(source), state_(walls.size(), unknown) {
    for (int axis = 0; axis < 2; ++axis) {
      const double from = tiles.place_in_tiles(axis, source[axis]);
      is_near_ = is_near_ && -most_tiles < from && from < most_tiles;
      if (!is_near_) return;
      const int last = tiles.size(axis) - 1;
      cell_[axis] = from == last + 1 ? last : whole(from);
      within_[axis] = from - cell_[axis];
    }
    open_.push_back({0, 8});
  }

  // The numbers of the walls; false when they are more than so many, or the source is too far away.
  constexpr bool find(std::size_t most, std::vector<std::uint32_t>& out) {
    if (!is_near_) return false;
    int ring = 0, last = 0;
    for (int axis = 0; axis < 2; ++axis) {
      const int beyond = cell_[axis] - tiles_.size(axis) + 1;
      ring = greater(ring, greater(-cell_[axis], beyond));
      last = greater(last, greater(cell_[axis], -beyond));
    }
    for (; ring <= last && !open_.empty(); ++ring) {
      for (const arc& a : open_) look_along(ring, a);
      if (found_.size() > most) return false;
      cover(ring);
    }
    out.swap(found_);
    return true;
  }

private:
  static constexpr double most_tiles = 0x1p20;
  static constexpr double rounding = 0x1p-40;      // of directions, and more
  static constexpr double cut_rounding = 0x1p-20;  // of directions to where a wall leaves a ring
  static constexpr double border = 1.0 / 16;       // of tiles
  static constexpr std::uint8_t unknown = 0, found = 1, covers = 2;

  struct arc {
    double from = 0, to = 0;  // from 0 to 8 along a square round the source, and on
  };
  struct place {
    double u = 0, v = 0;
  };

  const wall_tiles<T>& tiles_;
  std::span<const segment<T, 2>> walls_;
  point<T, 2> source_;
  std::vector<std::uint8_t> state_;
  double within_[2]{};  // its tile
  int cell_[2]{};
  bool is_near_ = true, is_narrow_ = false;
  place right_{}, left_{};  // limits of the directions that are looked in
  std::vector<arc> open_{}, covered_{}, left_open_{};
  std::vector<std::uint32_t> found_{}, pending_{};

  static constexpr int whole(double x) noexcept { return static_cast<int>(x + 0x1p24) - (1 << 24); }
  constexpr place place_of(const point<T, 2>& p) const noexcept {
    return {tiles_.distance_in_tiles(0, source_.x, p.x), tiles_.distance_in_tiles(1, source_.y, p.y)};
  }
  static constexpr double size_of(const place& p) noexcept {
    return greater(p.u < 0 ? -p.u : p.u, p.v < 0 ? -p.v : p.v);
  }

  static constexpr double direction_of(const place& p) noexcept {
    const double u = p.u, v = p.v;
    if (u > 0 && -u <= v && v <= u) return 1 + v / u;
    if (v > 0 && -v <= u && u <= v) return 3 - u / v;
    if (u < 0 && u <= v && v <= -u) return 5 + v / u;
    return 7 - u / v;
  }

  // The directions in which a segment lies; none where it lies in nearly one, or through the source, or goes too far.
  static constexpr bool has_arc(const place& a, const place& b, arc& out) noexcept {
    for (const place& p : {a, b})
      if (!(0x1p-200 < size_of(p) && size_of(p) < 0x1p24)) return false;
    const double from = direction_of(a), to = direction_of(b), turn = to < from ? to - from + 8 : to - from;
    if (turn < 4)
      out = {from, from + turn};
    else
      out = {to, to + (8 - turn)};
    const double width = out.to - out.from;
    return 4 * cut_rounding < width && width < 4 - cut_rounding;
  }

  static constexpr bool overlap(const arc& a, const arc& b) noexcept {  // a within 0 and 8
    const auto meets = [&](double off) { return a.from <= b.to + off + rounding && b.from + off - rounding <= a.to; };
    return meets(0) || meets(-8) || meets(8);
  }

  static constexpr place towards(double direction) noexcept {
    if (direction <= 2) return {1, direction - 1};
    if (direction <= 4) return {3 - direction, 1};
    if (direction <= 6) return {-1, 5 - direction};
    return {direction - 7, -1};
  }
  // Whether both ends are on the outer side of the line to one of the directions that are open, less than half a turn.
  constexpr bool lies_beside(const place& a, const place& b) const noexcept {
    if (!is_narrow_) return false;
    const double most = rounding * (size_of(a) + size_of(b));
    const auto side = [](const place& to, const place& p) { return product(to.u, p.v) - product(to.v, p.u); };
    return (side(right_, a) < -most && side(right_, b) < -most) || (side(left_, a) > most && side(left_, b) > most);
  }

  // Looks at the tiles of a ring in some directions. On each side of it a tile is as far from the middle as its
  // direction says; near corners tiles reach beyond the diagonals.
  constexpr void look_along(int ring, const arc& open) {
    is_narrow_ = open.to - open.from < 3;
    right_ = towards(open.from);
    left_ = towards(open.to);
    if (ring == 0) return look_at(cell_[0], cell_[1], open);
    const double reach = 2.0 / ring;
    for (int side = 0; side < 4; ++side)
      for (const double off : {0.0, side == 0 ? -8.0 : 8.0}) {
        if (off != 0 && side != 0 && side != 3) continue;
        const double middle = 2 * side + 1, from = greater(open.from + off - middle, -1 - reach);
        const double to = lesser(open.to + off - middle, 1 + reach);
        if (from > to) continue;
        const bool is_turned = side == 1 || side == 2;
        look_at_side(ring, side, open, {is_turned ? -to : from, is_turned ? -from : to});
      }
  }
  constexpr void look_at_side(int ring, int side, const arc& open, const arc& slope) {
    const int across = side % 2, along = 1 - across, sign = side < 2 ? 1 : -1;
    const int fixed = cell_[across] + sign * ring, middle = cell_[along];
    if (fixed < 0 || fixed >= tiles_.size(across)) return;
    const double nearest = side < 2 ? ring - within_[across] : ring - 1 + within_[across], farthest = nearest + 1;
    const double low = within_[along] + slope.from * (slope.from < 0 ? farthest : nearest) - border;
    const double high = within_[along] + slope.to * (slope.to > 0 ? farthest : nearest) + border;
    int first = slope.from < -1 ? -ring : slope.from > 1 ? ring - 1 : greater(whole(low), -ring);
    int last = slope.to > 1 ? ring : slope.to < -1 ? 1 - ring : lesser(whole(high), ring);
    first = greater(first + middle, 0);
    last = lesser(last + middle, tiles_.size(along) - 1);
    for (int i = first; i <= last; ++i) across == 0 ? look_at(fixed, i, open) : look_at(i, fixed, open);
  }
  constexpr void look_at(int x, int y, const arc& open) {
    if (x < 0 || y < 0 || x >= tiles_.size(0) || y >= tiles_.size(1)) return;
    for (const std::uint32_t w : tiles_.walls_in(x, y)) {
      if (state_[w] != unknown || lies_beside(place_of(walls_[w].a), place_of(walls_[w].b))) continue;
      arc a;
      const bool may_cover = has_arc(place_of(walls_[w].a), place_of(walls_[w].b), a);
      if (may_cover && !overlap(open, a)) continue;
      state_[w] = found;
      found_.push_back(w);
      if (may_cover) pending_.push_back(w);
    }
  }

  // Takes away the directions that walls found so far cover within a ring.
  constexpr void cover(int ring) {
    const place low{-(ring + within_[0]) + border, -(ring + within_[1]) + border};
    const place high{low.u + 2 * ring + 1 - 2 * border, low.v + 2 * ring + 1 - 2 * border};
    covered_.clear();
    std::size_t kept = 0;
    for (const std::uint32_t w : pending_) {
      place a = place_of(walls_[w].a), b = place_of(walls_[w].b);
      const int cut = cut_off(a, b, low, high);
      arc in;
      if (cut < 2 && has_arc(a, b, in)) {
        const double off = cut == 0 ? rounding : cut_rounding;
        add_cover({in.from + off, in.to - off});
      }
      if (cut != 0)
        pending_[kept++] = w;
      else
        cover_joints(w);
    }
    pending_.resize(kept);
    if (!covered_.empty()) close();
  }

  // Cuts a segment down to a box: 0 when it was within, 2 when nothing is left that tells a direction, else 1.
  static constexpr int cut_off(place& a, place& b, const place& low, const place& high) noexcept {
    double first = 0, last = 1;
    const double du = b.u - a.u, dv = b.v - a.v;
    const auto cut = [&](double from, double by) {  // from + t by >= 0
      if (by == 0) return void(last = from < 0 ? -1 : last);
      if (by > 0)
        first = greater(first, -from / by);
      else
        last = lesser(last, -from / by);
    };
    cut(a.u - low.u, du);
    cut(high.u - a.u, -du);
    cut(a.v - low.v, dv);
    cut(high.v - a.v, -dv);
    if (first >= last) return 2;
    if (first == 0 && last == 1) return 0;
    const place at{a.u, a.v};
    if (first > 0) a = {at.u + first * du, at.v + first * dv};
    if (last < 1) b = {at.u + last * du, at.v + last * dv};
    return size_of(a) < 0.125 || size_of(b) < 0.125 ? 2 : 1;
  }

  // Walls that begin where this one ends, and cover, leave nothing open between.
  constexpr void cover_joints(std::uint32_t w) {
    state_[w] = covers;
    arc own, next;
    has_arc(place_of(walls_[w].a), place_of(walls_[w].b), own);
    for (const auto& p : {walls_[w].a, walls_[w].b}) {
      for (const std::uint32_t other : tiles_.walls_at(p)) {
        const segment<T, 2>& o = walls_[other];
        if (other == w || state_[other] != covers || !(o.a == p || o.b == p)) continue;
        has_arc(place_of(o.a), place_of(o.b), next);
        const double at = direction_of(place_of(p)), end = own.to >= 8 ? own.to - 8 : own.to;
        const double next_end = next.to >= 8 ? next.to - 8 : next.to;
        if ((at == end && at == next.from) || (at == own.from && at == next_end))
          add_cover({at - 4 * rounding, at + 4 * rounding});
      }
    }
  }

  constexpr void add_cover(const arc& a) {
    if (a.from >= 8) return add_cover({a.from - 8, a.to - 8});
    if (a.from < 0) {
      covered_.push_back({a.from + 8, 8});
      covered_.push_back({0, a.to});
    } else if (a.to > 8) {
      covered_.push_back({a.from, 8});
      covered_.push_back({0, a.to - 8});
    } else {
      covered_.push_back(a);
    }
  }

  // Takes what is covered away from what is open.
  constexpr void close() {
    std::sort(covered_.begin(), covered_.end(), [](const arc& a, const arc& b) { return a.from < b.from; });
    left_open_.clear();
    std::size_t k = 0;
    double reached = 0;  // what is covered up to there, of the arcs before k
    for (const arc& o : open_) {
      double from = greater(o.from, reached);
      while (k < covered_.size() && covered_[k].from <= o.to) {
        if (from < covered_[k].from) left_open_.push_back({from, covered_[k].from});
        reached = greater(reached, covered_[k].to);
        from = greater(from, reached);
        ++k;
      }
      if (from < o.to) left_open_.push_back({from, o.to});
    }
    open_.swap(left_open_);
  }
};

}  // namespace IRG_ABI
}  // namespace irg::detail
