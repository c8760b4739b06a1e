// SPDX-License-Identifier: MIT
// prepared_walls: visibility polygons from many points among the same walls, of those only that stand in tiles which
// what is nearer leaves open.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <type_traits>
#include <vector>

#include <irg/geometry/box.hpp>
#include <irg/geometry/vocabulary.hpp>
#include <irg/visibility/visibility_polygon.hpp>
#if IRG_BODIES
#include <irg/core/contraction.hpp>
#include <irg/core/conversion.hpp>
#include <irg/core/is_finite.hpp>
#include <irg/core/vocabulary.hpp>
#endif

namespace irg {
namespace detail {

// Which walls are in which tiles, and where the tiles are.
struct wall_tile_lists {
  double low[2]{}, width[2]{}, per_unit[2]{};
  int size[2]{1, 1};
  std::vector<std::size_t> begin{};
  std::vector<std::uint32_t> list{};
};

template <Floating T>
struct walls_in_tiles {
  std::vector<segment<T, 2>> walls{};
  std::vector<segment<T, 2>> tiled{};    // the same in the order of tiles
  std::vector<std::uint32_t> numbers{};  // which they are of the walls
  box<T, 2> domain{};
  wall_tile_lists tiles{};
  bool all_finite = true;
};

inline namespace IRG_COMPILED_ABI {

template <Floating T>
IRG_API walls_in_tiles<T> put_in_tiles(std::span<const segment<T, 2>> walls, const box<T, 2>& domain);
template <Floating T>
IRG_API visible_region<T> region_among(const walls_in_tiles<T>& prepared, const point<T, 2>& source);
template <Floating T>
IRG_API visible_region<T> counted_region_among(const walls_in_tiles<T>& prepared, const point<T, 2>& source,
                                               sight_counts& counts);

}  // namespace IRG_COMPILED_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// Closed obstacles in a box, made ready.
template <Floating T>
class prepared_walls {
public:
  /// cost    sorts the walls into about as many tiles; allocates
  constexpr prepared_walls(std::span<const std::type_identity_t<segment<T, 2>>> walls, const box<T, 2>& domain)
      : prepared_(detail::put_in_tiles<T>(walls, domain)) {}

  /// What is seen from a point.
  /// gives   the same as visibility_polygon(source, domain, walls); the ring may begin at another of its corners
  /// exact   as visibility_polygon
  /// cost    the tiles that are seen, and a visibility polygon of the walls in them that no nearer tiles hide; where
  ///         these are more than a sixteenth of all, visibility_polygon and as much again at most
  [[nodiscard]] constexpr visible_region<T> seen_from(const point<T, 2>& source) const {
    return detail::region_among(prepared_, source);
  }

  /// The same, and adds to the counts what it took: walls in tiles that nearer ones hide are passed over.
  [[nodiscard]] constexpr visible_region<T> seen_from(const point<T, 2>& source, sight_counts& counts) const {
    return detail::counted_region_among(prepared_, source, counts);
  }

private:
  detail::walls_in_tiles<T> prepared_;
};

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// Walls sorted into the tiles that they may meet: too many of them, never too few. The tile of a point is a rounded
// number that never falls as a coordinate rises.
template <Floating T, class Lists>
class wall_tiles {
public:
  constexpr explicit wall_tiles(Lists& lists) noexcept : lists_(&lists) {}

  constexpr void fill(std::span<const segment<T, 2>> walls, const box<T, 2>& domain) {
    box<T, 2> around{};
    for (const auto& w : walls) around = bounding_box(bounding_box(around, w.a), w.b);
    double most = 0, farthest = 0;
    for (int i = 0; i < 2; ++i) {
      lists_->low[i] = widened(maximum(around.low[i], domain.low[i]));
      const double high = widened(minimum(around.high[i], domain.high[i]));
      lists_->width[i] = high - lists_->low[i];
      for (const double v : {widened(around.low[i]), widened(around.high[i])})
        farthest = maximum(farthest, v < 0 ? -v : v);
      most = maximum(most, maximum(lists_->low[i] < 0 ? -lists_->low[i] : lists_->low[i], high < 0 ? -high : high));
    }
    // Else all walls are in one tile: where coordinates have few digits that tell tiles apart, or may overflow.
    const double least = minimum(lists_->width[0], lists_->width[1]);
    if (walls.size() > 8 && farthest < 0x1p500 && most < 0x1p500 && least > 0x1p-500 && least > most * 0x1p-20)
      choose_size(walls);
    for (int i = 0; i < 2 && count() > 1; ++i) lists_->per_unit[i] = lists_->size[i] / lists_->width[i];
    sort_in(walls);
  }

  constexpr std::size_t count() const noexcept {
    return static_cast<std::size_t>(lists_->size[0]) * static_cast<std::size_t>(lists_->size[1]);
  }
  constexpr int size(int axis) const noexcept { return lists_->size[axis]; }
  constexpr std::span<const std::uint32_t> walls_in(int x, int y) const noexcept {
    const std::size_t tile = number_of(x, y);
    return {lists_->list.data() + lists_->begin[tile], lists_->begin[tile + 1] - lists_->begin[tile]};
  }
  // In the tile of a point, or what is nearest to it.
  constexpr std::span<const std::uint32_t> walls_at(const point<T, 2>& p) const noexcept {
    return walls_in(tile_of(0, widened(p.x)), tile_of(1, widened(p.y)));
  }
  // Coordinates counted in tiles, and how far two points are from one another.
  // needs   count() > 1
  constexpr double place_in_tiles(int axis, T v) const noexcept {
    return (widened(v) - lists_->low[axis]) * lists_->per_unit[axis];
  }
  constexpr double distance_in_tiles(int axis, T from, T to) const noexcept {
    return (widened(to) - widened(from)) * lists_->per_unit[axis];
  }

  // Numbers the walls anew, as tiles hold them first: what is near each other is so in memory, too. Gives the numbers
  // that they had.
  constexpr std::vector<std::uint32_t> renumber(std::size_t walls) {
    constexpr std::uint32_t none = no_index;
    std::vector<std::uint32_t> now(walls, none), before;
    before.reserve(walls);
    for (std::uint32_t& w : lists_->list) {
      if (now[w] == none) {
        now[w] = static_cast<std::uint32_t>(before.size());
        before.push_back(w);
      }
      w = now[w];
    }
    return before;
  }

private:
  Lists* lists_;

  constexpr std::size_t number_of(int x, int y) const noexcept {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(lists_->size[0]) + static_cast<std::size_t>(x);
  }
  constexpr int tile_of(int axis, double v) const noexcept {
    if (lists_->size[axis] == 1) return 0;
    const double at = (v - lists_->low[axis]) / lists_->width[axis] * lists_->size[axis];
    return at < 1 ? 0 : at < lists_->size[axis] - 1 ? static_cast<int>(at) : lists_->size[axis] - 1;
  }

  // As many tiles as walls, if walls are short: fewer, until each wall is in some six of them at most.
  constexpr void choose_size(std::span<const segment<T, 2>> walls) {
    double tiles = static_cast<double>(walls.size());
    for (std::size_t places = ~std::size_t{0}; places > 6 * walls.size() + 64 && tiles >= 1; tiles /= 4) {
      double across = 1;
      while (across * across * lists_->width[1] < tiles * lists_->width[0] && across < 4096) across *= 2;
      const double high = tiles / across;
      lists_->size[0] = static_cast<int>(across);
      lists_->size[1] = high < 1 ? 1 : high > 4096 ? 4096 : static_cast<int>(high);
      places = 0;
      for (const auto& w : walls)
        for_rows(w, [&](int, int first, int last) { places += static_cast<std::size_t>(last - first + 1); });
    }
  }

  constexpr void sort_in(std::span<const segment<T, 2>> walls) {
    lists_->begin.assign(count() + 1, std::size_t{0});
    for (const auto& w : walls)
      for_rows(w, [&](int row, int first, int last) {
        for (int i = first; i <= last; ++i) ++lists_->begin[number_of(i, row) + 1];
      });
    for (std::size_t i = 0; i + 1 < lists_->begin.size(); ++i) lists_->begin[i + 1] += lists_->begin[i];
    std::vector<std::size_t> next(lists_->begin.begin(), lists_->begin.end());
    lists_->list.assign(lists_->begin.back(), std::uint32_t{0});
    for (std::size_t k = 0; k < walls.size(); ++k)
      for_rows(walls[k], [&](int row, int first, int last) {
        for (int i = first; i <= last; ++i) lists_->list[next[number_of(i, row)]++] = static_cast<std::uint32_t>(k);
      });
  }

  // Calls f(row, first, last) for the rows of tiles, and the tiles in each, that a wall may meet: it is cut at the
  // rows' borders, a sixteenth of a tile further out, which is more than rounding moves it.
  template <class F>
  constexpr void for_rows(const segment<T, 2>& w, const F& f) const {
    const double x[2]{widened(w.a.x), widened(w.b.x)}, y[2]{widened(w.a.y), widened(w.b.y)};
    const double low = minimum(y[0], y[1]), high = maximum(y[0], y[1]);
    const int first_row = tile_of(1, low), last_row = tile_of(1, high);
    const int first = tile_of(0, minimum(x[0], x[1])), last = tile_of(0, maximum(x[0], x[1]));
    const double tall = lists_->width[1] / lists_->size[1], wide = lists_->width[0] / lists_->size[0];
    for (int row = first_row; row <= last_row; ++row) {
      if (first_row == last_row || first == last) {
        f(row, first, last);
        continue;
      }
      const double below = row == 0 ? low : lists_->low[1] + row * tall - tall / 16;
      const double above = row + 1 == lists_->size[1] ? high : lists_->low[1] + (row + 1) * tall + tall / 16;
      const auto at = [&](int i) {  // where the wall enters the row, or ends in it
        const double inner = y[i] < below ? below : above < y[i] ? above : y[i];
        if (inner == y[i]) return x[i];
        const double v = x[i] + (x[1 - i] - x[i]) * ((inner - y[i]) / (y[1 - i] - y[i]));
        return maximum(minimum(x[0], x[1]), minimum(maximum(x[0], x[1]), v));
      };
      if (high < below || above < low) continue;
      const double from = at(0), to = at(1);
      f(row, tile_of(0, minimum(from, to) - wide / 16), tile_of(0, maximum(from, to) + wide / 16));
    }
  }
};

// Walls that may be seen from a source: tiles around it are looked at ring by ring, in those directions only that no
// wall within the rings before covers. Too many walls, never too few: directions are rounded, and what they cover is
// drawn in by more than that, but where two walls meet in one point.
template <Floating T>
class occlusion_horizon {
public:
  using tiles = wall_tiles<T, const wall_tile_lists>;

  constexpr occlusion_horizon(const tiles& in, std::span<const segment<T, 2>> walls, const point<T, 2>& source)
      : tiles_(in), walls_(walls), source_(source), state_(walls.size(), unknown) {}

  // The numbers of the walls; false when they are more than so many, or the source is too far away.
  constexpr bool find(std::size_t most, std::vector<std::uint32_t>& out) {
    if (!find_own_tile()) return false;
    int ring = 0, last = 0;
    for (int axis = 0; axis < 2; ++axis) {
      const int beyond = cell_[axis] - tiles_.size(axis) + 1;
      ring = maximum(ring, maximum(-cell_[axis], beyond));
      last = maximum(last, maximum(cell_[axis], -beyond));
    }
    for (open_.push_back({0, 8}); ring <= last && !open_.empty(); ++ring) {
      for (const arc& a : open_) look_along(ring, a);
      if (found_.size() > most) return false;
      cover(ring);
    }
    out.swap(found_);
    return true;
  }

private:
  static constexpr double most_tiles = 0x1p20;
  static constexpr double rounding = 0x1p-40;  // of directions, and more
  static constexpr double cut_rounding = 0x1p-20;  // of directions to where a wall leaves a ring
  static constexpr double border = 1.0 / 16;  // of tiles
  static constexpr std::uint8_t unknown = 0, found = 1, covers = 2;

  struct arc {
    double from = 0, to = 0;  // from 0 to 8 along a square round the source, and on
  };
  struct place {
    double u = 0, v = 0;
  };

  tiles tiles_;
  std::span<const segment<T, 2>> walls_;
  point<T, 2> source_;
  std::vector<std::uint8_t> state_;
  double within_[2]{};  // its tile
  int cell_[2]{};
  bool is_narrow_ = false;
  place right_{}, left_{};  // limits of the directions that are looked in
  std::vector<arc> open_{}, covered_{}, left_open_{};
  std::vector<std::uint32_t> found_{}, pending_{};

  static constexpr int whole(double x) noexcept { return static_cast<int>(x + 0x1p24) - (1 << 24); }

  // The tile of the source; false where that is too far away.
  constexpr bool find_own_tile() noexcept {
    for (int axis = 0; axis < 2; ++axis) {
      const double from = tiles_.place_in_tiles(axis, source_[axis]);
      if (!(-most_tiles < from && from < most_tiles)) return false;
      const int last = tiles_.size(axis) - 1;
      cell_[axis] = from == last + 1 ? last : whole(from);
      within_[axis] = from - cell_[axis];
    }
    return true;
  }

  constexpr place place_of(const point<T, 2>& p) const noexcept {
    return {tiles_.distance_in_tiles(0, source_.x, p.x), tiles_.distance_in_tiles(1, source_.y, p.y)};
  }
  static constexpr double size_of(const place& p) noexcept {
    return maximum(p.u < 0 ? -p.u : p.u, p.v < 0 ? -p.v : p.v);
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
        const double middle = 2 * side + 1, from = maximum(open.from + off - middle, -1 - reach);
        const double to = minimum(open.to + off - middle, 1 + reach);
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
    int first = slope.from < -1 ? -ring : slope.from > 1 ? ring - 1 : maximum(whole(low), -ring);
    int last = slope.to > 1 ? ring : slope.to < -1 ? 1 - ring : minimum(whole(high), ring);
    first = maximum(first + middle, 0);
    last = minimum(last + middle, tiles_.size(along) - 1);
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
        first = maximum(first, -from / by);
      else
        last = minimum(last, -from / by);
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
      double from = maximum(o.from, reached);
      while (k < covered_.size() && covered_[k].from <= o.to) {
        if (from < covered_[k].from) left_open_.push_back({from, covered_[k].from});
        reached = maximum(reached, covered_[k].to);
        from = maximum(from, reached);
        ++k;
      }
      if (from < o.to) left_open_.push_back({from, o.to});
    }
    open_.swap(left_open_);
  }
};

// polygon(walls) gives the visibility polygon among walls; it is asked once at most.
template <Floating T, class Polygon>
constexpr visible_region<T> look_among(const walls_in_tiles<T>& p, const point<T, 2>& source, const Polygon& polygon) {
  if (!p.all_finite) return polygon(p.walls);  // says what comes first
  visible_region<T> seen = visibility_polygon(source, p.domain);
  if (seen.ring.empty()) return seen;
  std::vector<std::uint32_t> nearby;
  const wall_tiles<T, const wall_tile_lists> tiles(p.tiles);
  if (tiles.count() == 1 || !occlusion_horizon<T>(tiles, p.tiled, source).find(64 + p.walls.size() / 16, nearby))
    return polygon(p.walls);
  for (std::uint32_t& w : nearby) w = p.numbers[w];
  std::sort(nearby.begin(), nearby.end());
  std::vector<segment<T, 2>> walls;
  walls.reserve(nearby.size());
  for (const std::uint32_t w : nearby) walls.push_back(p.walls[w]);
  seen = polygon(walls);
  for (auto& v : seen.ring)
    if (v.stop == sight_stop::obstacle) v.index = nearby[v.index];
  return seen;
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API walls_in_tiles<T> put_in_tiles(std::span<const segment<T, 2>> walls, const box<T, 2>& domain) {
  walls_in_tiles<T> p;
  p.walls.assign(walls.begin(), walls.end());
  p.domain = domain;
  for (const auto& w : walls) p.all_finite = p.all_finite && is_finite(w.a, w.b);
  if (!p.all_finite) return p;
  wall_tiles<T, wall_tile_lists> tiles(p.tiles);
  tiles.fill(walls, domain);
  p.numbers = tiles.renumber(walls.size());
  p.tiled.reserve(walls.size());
  for (const std::uint32_t w : p.numbers) p.tiled.push_back(walls[w]);
  return p;
}

template <Floating T>
IRG_API visible_region<T> region_among(const walls_in_tiles<T>& prepared, const point<T, 2>& source) {
  return look_among(prepared, source, [&](std::span<const segment<T, 2>> walls) {
    return visibility_polygon(source, prepared.domain, walls);
  });
}

template <Floating T>
IRG_API visible_region<T> counted_region_among(const walls_in_tiles<T>& prepared, const point<T, 2>& source,
                                               sight_counts& counts) {
  sight_counts took;
  visible_region<T> seen = look_among(prepared, source, [&](std::span<const segment<T, 2>> walls) {
    return visibility_polygon(source, prepared.domain, walls, {}, took);
  });
  const std::int64_t all = static_cast<std::int64_t>(prepared.walls.size()) + (prepared.domain.empty() ? 0 : 4);
  took.passed_over += all - took.walls;
  took.walls = all;
  counts += took;
  return seen;
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
