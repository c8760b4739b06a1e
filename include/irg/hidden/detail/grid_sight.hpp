// SPDX-License-Identifier: MIT
// A grid surface as an eye sees it, what is decided of it, exactly, and the parts of an edge that the perimeters of
// those drawn before leave to be seen. Upright half-planes of sight turn about the upright line through the eye; the
// direction of one is (u, w) = (x, z) less the eye's, turning from u to w. An edge that no such half-plane contains is
// met by some of them, at one slope each.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/orient3d.hpp>
#include <irg/math/exact/quotients_of.hpp>
#include <irg/math/exact/sign_of.hpp>
#include <irg/math/vec.hpp>

namespace irg::detail::inline IRG_ABI {

// Edges are twice the number of their lower vertex, and one more where they go along z. Vertex (i, j) is i*(m + 1) + j.
using grid_edge = std::uint32_t;
inline constexpr grid_edge no_grid_edge = ~grid_edge{0};

// The vertices of an edge in the sense in which directions turn.
struct turning_edge {
  std::uint32_t from, to;
};

// Twice the area of a triangle in the plane, positive where it runs counter-clockwise.
template <class P>
constexpr auto plane_turn(const P& a, const P& b, const P& c) noexcept {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// How far along pq it meets the line ab in the plane: the place times the divisor, which comes first.
struct meeting_in_plane {
  template <class P>
  constexpr auto operator()(const P& a, const P& b, const P& p, const P& q) const noexcept {
    const auto at_p = plane_turn(a, b, p), at_q = plane_turn(a, b, q);
    return std::array{at_p - at_q, at_p};
  }
};

template <class T>
struct grid_sight {
  std::span<const T> x, z, heights;
  point<T, 3> eye;

  constexpr std::uint32_t rows() const noexcept { return static_cast<std::uint32_t>(z.size()); }
  constexpr std::uint32_t vertex(int i, int j) const noexcept {
    return static_cast<std::uint32_t>(i) * rows() + static_cast<std::uint32_t>(j);
  }
  constexpr point<T, 3> at(std::uint32_t v) const noexcept { return {x[v / rows()], heights[v], z[v % rows()]}; }
  constexpr point<T, 2> below(std::uint32_t v) const noexcept { return {x[v / rows()], z[v % rows()]}; }
  constexpr std::uint32_t low(grid_edge e) const noexcept { return e / 2; }
  constexpr std::uint32_t high(grid_edge e) const noexcept { return e / 2 + (e % 2 != 0 ? 1 : rows()); }

  // Edges along z turn upwards where they are at u > 0, those along x where they are at w < 0.
  constexpr turning_edge turning(grid_edge e) const noexcept {
    const point<T, 2> p = below(low(e));
    const bool upwards = e % 2 != 0 ? p.x > eye.x : p.y < eye.z;
    return upwards ? turning_edge{low(e), high(e)} : turning_edge{high(e), low(e)};
  }

  // 1 where the direction of vertex c lies behind that of b by less than half a turn, -1 where it lies before.
  constexpr int turn(std::uint32_t b, std::uint32_t c) const noexcept {
    return b == c ? 0 : orient2d(point<T, 2>{eye.x, eye.z}, below(b), below(c));
  }

  // The border that turns to the eye comes first: what is drawn hangs together, and a perimeter has no jumps.
  static constexpr bool has_jumps = false;
  // The four axes of the plane divide the directions.
  static constexpr std::uint32_t axes = 4;
  // 1 where the direction of vertex c lies behind axis k, of which the first is that of x, by less than half a turn.
  constexpr int behind_axis(std::uint32_t k, std::uint32_t c) const noexcept {
    const point<T, 2> p = below(c);
    const T a = k % 2 == 0 ? p.y : p.x, b = k % 2 == 0 ? eye.z : eye.x;
    const int sign = a < b ? -1 : a > b ? 1 : 0;
    return k == 0 || k == 3 ? sign : -sign;
  }

  // 1 where edge e passes above vertex c, -1 where below.
  constexpr int above_vertex(grid_edge e, std::uint32_t c) const noexcept {
    const turning_edge t = turning(e);
    return c == t.from || c == t.to ? 0 : orient3d(eye, at(t.from), at(t.to), at(c));
  }

  // 1 where f passes above e in the direction of vertex c, -1 where below.
  constexpr int compare_at(grid_edge f, grid_edge e, std::uint32_t c) const noexcept {
    const turning_edge s = turning(e), t = turning(f);
    const auto formula = [](const auto& o, const auto& a, const auto& b, const auto& p, const auto& q, const auto& u) {
      const auto n = cross(a - o, b - o), m = cross(p - o, q - o), d = u - o;
      return (n.x * m.y - m.x * n.y) * d.x + (n.z * m.y - m.z * n.y) * d.z;
    };
    return irg::sign_of<5>(formula, eye, at(s.from), at(s.to), at(t.from), at(t.to), at(c));
  }

  // The sign of the triple product of the normals of three edges' planes.
  constexpr int planes_turn(grid_edge e, grid_edge f, grid_edge g) const noexcept {
    const turning_edge r = turning(e), s = turning(f), t = turning(g);
    const auto formula = [](const auto& o, const auto& a, const auto& b, const auto& p, const auto& q, const auto& u,
                            const auto& v) {
      return dot(cross(cross(a - o, b - o), cross(p - o, q - o)), cross(u - o, v - o));
    };
    return irg::sign_of<6>(formula, eye, at(r.from), at(r.to), at(s.from), at(s.to), at(t.from), at(t.to));
  }

  // How far along g, from its lower vertex, it meets the plane of e.
  constexpr T place(grid_edge g, grid_edge e) const noexcept {
    const auto formula = [](const auto& o, const auto& a, const auto& b, const auto& p, const auto& q) {
      const auto n = cross(a - o, b - o);
      const auto at_p = dot(n, p - o), at_q = dot(n, q - o);
      return std::array{at_p - at_q, at_p};
    };
    return irg::quotient_of<3>(formula, eye, at(low(e)), at(high(e)), at(low(g)), at(high(g))).value_or(T(0));
  }

  // -1, 0 or 1: where g meets the plane of e before that of f, at one place, or behind.
  constexpr int compare_places(grid_edge g, grid_edge e, grid_edge f) const noexcept {
    const auto falls = [&](grid_edge of) {  // the sign of the difference that `place` divides by
      const int a = orient3d(eye, at(low(of)), at(high(of)), at(low(g)));
      return a != 0 ? a : -orient3d(eye, at(low(of)), at(high(of)), at(high(g)));
    };
    const auto formula = [](const auto& o, const auto& a, const auto& b, const auto& p, const auto& q, const auto& u,
                            const auto& v) {
      const auto n = cross(a - o, b - o), m = cross(p - o, q - o);
      return dot(m, u - o) * dot(n, v - o) - dot(n, u - o) * dot(m, v - o);
    };
    return falls(e) * falls(f) *
           irg::sign_of<6>(formula, eye, at(low(e)), at(high(e)), at(low(f)), at(high(f)), at(low(g)), at(high(g)));
  }
};

// The perimeter of the facets drawn so far: of all edges met in one direction, the one that passes highest (the outer
// perimeter) or lowest (the inner one). A ring of pieces of edges, in the sense in which directions turn. Pieces begin
// at vertices or where edges cross; nothing of this is computed but the names of what meets there, and decisions are
// exact.

// Where a piece begins: on the sight's axis `first` of directions, where nothing is drawn yet; at vertex `first`; where
// edge `first` ends and edge `second` begins, which cross.
enum class grid_mark_kind : std::uint8_t { axis, vertex, crossing };
struct grid_mark {
  grid_mark_kind kind = grid_mark_kind::axis;
  std::uint32_t first = 0, second = 0;
};

// An end of a part of an edge that is seen: the edge whose plane it meets there, the direction of a vertex
// (Sight::stop_at), or no_grid_edge for its own end.
struct grid_run {
  grid_edge from = no_grid_edge, to = no_grid_edge;
};

// Which perimeter: edges are seen that pass above all others, or below.
enum class perimeter_side : std::int8_t { inner = -1, outer = 1 };

template <class Sight>
class grid_perimeter {
public:
  constexpr grid_perimeter(const Sight& sight, perimeter_side side) : sight_(&sight), side_(static_cast<int>(side)) {
    constexpr std::uint32_t n = Sight::axes;
    for (std::uint32_t k = 0; k < n; ++k)
      pieces_.push_back({no_grid_edge, {grid_mark_kind::axis, k, 0}, (k + n - 1) % n, (k + 1) % n});
  }

  // The runs of edge g that are not hidden by this perimeter, from its turning start on; then the perimeter has g, too.
  constexpr const std::vector<grid_run>& add(grid_edge g) {
    runs_.clear();
    items_.clear();
    const turning_edge ends = sight_->turning(g);
    find(ends.from);
    std::uint32_t n = here_;
    if (order(pieces_[n].start, ends.from) != 0) put(pieces_[n].edge, pieces_[n].start);
    grid_mark from{grid_mark_kind::vertex, ends.from, 0};
    int start = sign_at_start(n, ends.from), beyond = 0;
    walker w{};
    for (;;) {
      const std::uint32_t behind = pieces_[n].next;
      beyond = order(pieces_[behind].start, ends.to);
      const int finish = beyond > 0 ? sign_at_mark(n, g, pieces_[behind].start) : sign_at_start(n, ends.to);
      take({g, pieces_[n].edge, start, finish}, from, pieces_[n].start, w);
      if (beyond <= 0) break;
      from = pieces_[behind].start;
      const bool open = Sight::has_jumps || pieces_[n].edge == no_grid_edge || pieces_[behind].edge == no_grid_edge;
      start = open ? sign_at_mark(behind, g, from) : finish;
      n = behind;
    }
    if (w.open) runs_.push_back({w.since, no_grid_edge});
    if (beyond < 0) put(pieces_[n].edge, {grid_mark_kind::vertex, ends.to, 0});
    if (!runs_.empty()) {
      const std::uint32_t end = pieces_[n].next;
      replace(n);
      // Where g ends the perimeter may jump, even at what was a crossing.
      if constexpr (Sight::has_jumps)
        if (beyond == 0 && pieces_[end].start.kind == grid_mark_kind::crossing)
          pieces_[end].start = {grid_mark_kind::vertex, ends.to, 0};
    }
    return runs_;
  }

  // The edge that the perimeter has in the direction of vertex c, the one that reaches farther where two meet there.
  constexpr grid_edge edge_at(std::uint32_t c) {
    find(c);
    const grid_edge here = pieces_[here_].edge;
    if (order(pieces_[here_].start, c) != 0) return here;
    const grid_edge before = pieces_[pieces_[here_].previous].edge;
    if (here == no_grid_edge || before == no_grid_edge) return here == no_grid_edge ? before : here;
    return side_ * sight_->compare_at(before, here, c) > 0 ? before : here;
  }

  // How many pieces there are, those where nothing is drawn included.
  constexpr std::size_t size() const noexcept { return pieces_.size() - unused_.size(); }
  // Steps from piece to piece, of all edges so far.
  constexpr std::int64_t steps() const noexcept { return steps_; }

private:
  struct piece {
    grid_edge edge;
    grid_mark start;
    std::uint32_t previous, next;
  };
  struct item {
    grid_edge edge;
    grid_mark start;
  };
  // An edge over one piece of the perimeter, or a part of it: the signs at both ends are 1 where it is seen beyond the
  // perimeter, -1 where it is hidden.
  struct passage {
    grid_edge edge, over;
    int start, finish;
  };
  // The run that is open, and what hid the edge before.
  struct walker {
    bool open = false, first = true;
    grid_edge since = no_grid_edge, hidden_by = no_grid_edge;
  };

  // 1 where direction c lies behind the mark by less than half a turn, -1 where it lies before.
  constexpr int order(const grid_mark& m, std::uint32_t c) const noexcept {
    if (m.kind == grid_mark_kind::vertex) return sight_->turn(m.first, c);
    if (m.kind == grid_mark_kind::crossing) return side_ * sight_->compare_at(m.second, m.first, c);
    return sight_->behind_axis(m.first, c);
  }

  // Goes to the piece over direction c.
  constexpr void find(std::uint32_t c) noexcept {
    const bool forwards = order(pieces_[here_].start, c) >= 0;
    for (;;) {
      const piece& p = pieces_[here_];
      if (order(p.start, c) >= 0 && order(pieces_[p.next].start, c) < 0) return;
      here_ = forwards ? p.next : p.previous;
      ++steps_;
    }
  }

  constexpr int sign_at_start(std::uint32_t n, std::uint32_t c) const noexcept {
    return pieces_[n].edge == no_grid_edge ? 1 : -side_ * sight_->above_vertex(pieces_[n].edge, c);
  }
  constexpr int sign_at_mark(std::uint32_t n, grid_edge g, const grid_mark& m) const noexcept {
    if (pieces_[n].edge == no_grid_edge || m.kind == grid_mark_kind::axis) return 1;
    if (m.kind == grid_mark_kind::vertex) {
      if constexpr (Sight::has_jumps) {
        const grid_edge e = pieces_[n].edge;
        if (m.first != sight_->low(e) && m.first != sight_->high(e)) return side_ * sight_->compare_at(g, e, m.first);
      }
      return side_ * sight_->above_vertex(g, m.first);
    }
    return -sight_->planes_turn(m.first, m.second, g);
  }

  constexpr void put(grid_edge edge, const grid_mark& start) {
    if (items_.empty() || items_.back().edge != edge) items_.push_back({edge, start});
  }

  constexpr void take(const passage& p, const grid_mark& from, const grid_mark& over_from, walker& w) {
    const bool seen = p.start >= 0 && p.finish >= 0, appears = p.start < 0 && p.finish > 0;
    const bool vanishes = p.start > 0 && p.finish < 0;
    ++steps_;
    const auto stop_at_start = [&](grid_edge over) {
      if constexpr (Sight::has_jumps)
        if (from.kind == grid_mark_kind::vertex) return Sight::stop_at(from.first);
      return over;
    };
    if ((seen || vanishes) && !w.open) {
      w.open = true;
      w.since = w.first ? no_grid_edge : stop_at_start(w.hidden_by);
    }
    if (!seen && !vanishes && w.open) close(stop_at_start(p.over), w);
    // What stays keeps its own mark: a vertex in the same direction need not lie on it.
    if ((seen && (p.start != 0 || p.finish != 0)) || vanishes)
      put(p.edge, from);
    else
      put(p.over, over_from);
    if (vanishes) {
      close(p.over, w);
      put(p.over, {grid_mark_kind::crossing, p.edge, p.over});
    } else if (appears) {
      w.open = true;
      w.since = p.over;
      put(p.edge, {grid_mark_kind::crossing, p.over, p.edge});
    }
    w.first = false;
    w.hidden_by = p.over;
  }
  constexpr void close(grid_edge at, walker& w) {
    runs_.push_back({w.since, at});
    w.open = false;
  }

  // Puts the items in the place of the pieces from here_ to last.
  constexpr void replace(std::uint32_t last) {
    const std::uint32_t end = pieces_[last].next;
    std::uint32_t previous = pieces_[here_].previous;
    for (std::uint32_t n = here_;; n = pieces_[n].next) {
      unused_.push_back(n);
      if (n == last) break;
    }
    std::uint32_t before = previous, begin = end;
    for (std::size_t i = 0; i < items_.size(); ++i) {
      std::uint32_t n = static_cast<std::uint32_t>(pieces_.size());
      if (unused_.empty()) {
        pieces_.push_back({});
      } else {
        n = unused_.back();
        unused_.pop_back();
      }
      pieces_[n] = {items_[i].edge, items_[i].start, before, end};
      if (i > 0) pieces_[before].next = n;
      if (i == 0) begin = n;
      before = n;
    }
    pieces_[previous].next = begin;
    pieces_[end].previous = before;
    here_ = begin;
  }

  const Sight* sight_;
  int side_;
  std::uint32_t here_ = 0;
  std::int64_t steps_ = 0;
  std::vector<piece> pieces_{};
  std::vector<std::uint32_t> unused_{};
  std::vector<item> items_{};
  std::vector<grid_run> runs_{};
};

// Sends the parts of an edge that its runs leave, over one perimeter or two.
template <class Sight>
struct grid_parts {
  struct run {
    grid_edge first, last;
    double from, to;
  };
  const Sight& sight;
  std::vector<run> runs{}, added{}, merged{};

  constexpr void add(grid_edge g, const std::vector<grid_run>& left) {
    const bool reversed = sight.turning(g).from != sight.low(g);
    const std::size_t count = left.size();
    added.clear();
    for (std::size_t k = 0; k < count; ++k) {
      const grid_run& r = left[reversed ? count - 1 - k : k];
      const grid_edge first = reversed ? r.to : r.from, last = reversed ? r.from : r.to;
      added.push_back({first, last, first == no_grid_edge ? 0.0 : sight.place(g, first),
                       last == no_grid_edge ? 1.0 : sight.place(g, last)});
    }
    merge(g);
  }

  // Calls sink(from, to) for each part of the edge.
  // gives   how many they are
  template <class Emit>
  constexpr std::int64_t send(const Emit& sink) {
    for (const run& r : runs) sink(r.from, r.to);
    const auto count = static_cast<std::int64_t>(runs.size());
    runs.clear();
    return count;
  }

  // Whether a run begins at a place that another has not passed.
  constexpr bool begins_within(grid_edge g, const run& next, const run& before) const noexcept {
    if (next.from != before.to) return next.from < before.to;
    if (next.first == no_grid_edge || before.last == no_grid_edge || next.first == before.last) return true;
    return sight.compare_places(g, next.first, before.last) <= 0;
  }
  constexpr bool ends_behind(grid_edge g, const run& a, const run& b) const noexcept {
    if (a.to != b.to || a.last == b.last) return a.to > b.to;
    if (a.last == no_grid_edge || b.last == no_grid_edge) return a.last == no_grid_edge;
    return sight.compare_places(g, a.last, b.last) > 0;
  }
  constexpr bool begins_before(grid_edge g, const run& a, const run& b) const noexcept {
    if (a.from != b.from || a.first == b.first) return a.from < b.from;
    if (a.first == no_grid_edge || b.first == no_grid_edge) return a.first == no_grid_edge;
    return sight.compare_places(g, a.first, b.first) < 0;
  }
  constexpr void merge(grid_edge g) {
    if (runs.empty()) {
      runs.swap(added);
      return;
    }
    merged.clear();
    for (std::size_t i = 0, k = 0; i < runs.size() || k < added.size();) {
      const bool old = k == added.size() || (i < runs.size() && !begins_before(g, added[k], runs[i]));
      const run& next = old ? runs[i++] : added[k++];
      if (merged.empty() || !begins_within(g, next, merged.back()))
        merged.push_back(next);
      else if (ends_behind(g, next, merged.back()))
        merged.back().last = next.last, merged.back().to = next.to;
    }
    runs.swap(merged);
  }
};

}  // namespace irg::detail::inline IRG_ABI
