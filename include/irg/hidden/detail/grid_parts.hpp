// SPDX-License-Identifier: MIT
// The parts of an edge that one perimeter or two leave to be seen.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/hidden/detail/grid_sight.hpp>

namespace irg::detail {

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
class IRG_APART grid_perimeter {
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

inline namespace IRG_ABI {

// Sends the parts of an edge that its runs leave, over one perimeter or two.
template <class Sight>
class grid_parts {
public:
  constexpr explicit grid_parts(const Sight& sight) : sight_(&sight) {}

  constexpr void add(grid_edge g, const std::vector<grid_run>& runs) {
    const bool reversed = sight_->turning(g).from != sight_->low(g);
    const std::size_t count = runs.size();
    added_.clear();
    for (std::size_t k = 0; k < count; ++k) {
      const grid_run& r = runs[reversed ? count - 1 - k : k];
      const grid_edge first = reversed ? r.to : r.from, last = reversed ? r.from : r.to;
      added_.push_back({first, last, first == no_grid_edge ? 0.0 : sight_->place(g, first),
                        last == no_grid_edge ? 1.0 : sight_->place(g, last)});
    }
    merge(g);
  }

  // Calls sink(from, to) for each part of the edge.
  // gives   how many they are
  template <class Emit>
  constexpr std::int64_t send(const Emit& sink) {
    for (const run& r : runs_) sink(r.from, r.to);
    const auto count = static_cast<std::int64_t>(runs_.size());
    runs_.clear();
    return count;
  }

private:
  struct run {
    grid_edge first, last;
    double from, to;
  };
  // Whether a run begins at a place that another has not passed.
  constexpr bool begins_within(grid_edge g, const run& next, const run& before) const noexcept {
    if (next.from != before.to) return next.from < before.to;
    if (next.first == no_grid_edge || before.last == no_grid_edge || next.first == before.last) return true;
    return sight_->compare_places(g, next.first, before.last) <= 0;
  }
  constexpr bool ends_behind(grid_edge g, const run& a, const run& b) const noexcept {
    if (a.to != b.to || a.last == b.last) return a.to > b.to;
    if (a.last == no_grid_edge || b.last == no_grid_edge) return a.last == no_grid_edge;
    return sight_->compare_places(g, a.last, b.last) > 0;
  }
  constexpr bool begins_before(grid_edge g, const run& a, const run& b) const noexcept {
    if (a.from != b.from || a.first == b.first) return a.from < b.from;
    if (a.first == no_grid_edge || b.first == no_grid_edge) return a.first == no_grid_edge;
    return sight_->compare_places(g, a.first, b.first) < 0;
  }
  constexpr void merge(grid_edge g) {
    if (runs_.empty()) {
      runs_.swap(added_);
      return;
    }
    merged_.clear();
    for (std::size_t i = 0, k = 0; i < runs_.size() || k < added_.size();) {
      const bool old = k == added_.size() || (i < runs_.size() && !begins_before(g, added_[k], runs_[i]));
      const run& next = old ? runs_[i++] : added_[k++];
      if (merged_.empty() || !begins_within(g, next, merged_.back()))
        merged_.push_back(next);
      else if (ends_behind(g, next, merged_.back())) {
        merged_.back().last = next.last;
        merged_.back().to = next.to;
      }
    }
    runs_.swap(merged_);
  }

  const Sight* sight_;
  std::vector<run> runs_{}, added_{}, merged_{};
};

}  // namespace IRG_ABI
}  // namespace irg::detail
