// SPDX-License-Identifier: MIT
// The sweep of triangulate_monotone: from the lowest vertex up, edges in their order from left to right. Only where a
// vertex begins two edges is a place looked for; all others stand where an edge ends. So an order in which edges that
// coincide and vertices that touch edges lie beside each other, once chosen, is kept, and it suffices to see that
// neighbours never change sides: then no edges cross.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/geometry/detail/crossing_search.hpp>
#include <irg/geometry/detail/fold.hpp>
#include <irg/geometry/detail/monotone_chains.hpp>
#include <irg/geometry/detail/sweep_order.hpp>
#include <irg/geometry/polygon.hpp>

namespace irg::detail::inline IRG_ABI {

template <Scalar T>
class monotone_sweep {
public:
  using triangle = std::array<std::uint32_t, 3>;

  constexpr explicit monotone_sweep(std::vector<triangle>& out) : chains_(points_, out), out_(&out) {}

  template <PlaneRing R>
  constexpr void add_ring(const R& ring) {
    const auto first = static_cast<std::uint32_t>(points_.size()), n = static_cast<std::uint32_t>(ring_size(ring));
    for (std::uint32_t i = 0; i < n; ++i) {
      const auto p = ring_vertex(ring, i);
      points_.push_back({coordinate(p, 0), coordinate(p, 1)});
      next_.push_back(first + (i + 1 < n ? i + 1 : 0));
      previous_.push_back(first + (i > 0 ? i - 1 : n - 1));
    }
    if (n < 3) {
      for (std::uint32_t i = 0; i < n; ++i) next_[first + i] = none;
      return;
    }
    rings_.push_back({first, n});
    remove_folds(first, n);
  }

  /// Whether no edges cross.
  constexpr bool run() {
    if (has_folds_ && whole_rings_cross()) return false;
    for (std::uint32_t i = 0; i < points_.size(); ++i)
      if (next_[i] != none) events_.push_back(i);
    std::sort(events_.begin(), events_.end(),
              [&](std::uint32_t i, std::uint32_t j) { return is_before(i, j) || (i < j && !is_before(j, i)); });
    arriving_.assign(2 * points_.size(), none);
    for (std::size_t begin = 0, end = 0; begin < events_.size(); begin = end) {
      while (end < events_.size() && !is_before(events_[begin], events_[end])) ++end;
      if (!pass(begin, end)) return false;
    }
    return true;
  }

private:
  static constexpr std::uint32_t none = sweep_order<std::uint32_t>::none;
  struct edge {
    std::uint32_t low = none, high = none;
    bool inside_on_right = false;
    open_gap gap;  // to the right, where that is inside
  };

  struct ring_range {
    std::uint32_t first, size;
  };

  std::vector<point<T, 2>> points_;
  std::vector<std::uint32_t> next_, previous_;  // next_ is none for a vertex that has been removed
  std::vector<ring_range> rings_;
  bool has_folds_ = false;
  monotone_chains<T> chains_;
  std::vector<triangle>* out_;
  std::vector<std::uint32_t> events_, arriving_;  // the edges that come to a vertex from its neighbours
  sweep_order<std::uint32_t> order_;
  std::vector<edge> edges_;
  std::vector<std::uint32_t> unused_, starts_, changed_;

  constexpr const point<T, 2>& at(std::uint32_t i) const noexcept { return points_[i]; }
  constexpr bool is_before(std::uint32_t i, std::uint32_t j) const noexcept {
    const point<T, 2>&a = points_[i], &b = points_[j];
    return a.y < b.y || (a.y == b.y && a.x < b.x);
  }
  constexpr int turn(std::uint32_t i, std::uint32_t j, std::uint32_t k) const noexcept {
    return orient2d(points_[i], points_[j], points_[k]);
  }

  // The sweep sees the rings without their folds, which may cross what is left.
  constexpr bool whole_rings_cross() const {
    crossing_search<T> search;
    for (const ring_range& r : rings_) search.add_ring(points_, r.first, r.size);
    return search.run();
  }

  // Vertices where the ring stands still or turns back go, as triangles without area.
  constexpr void remove_folds(std::uint32_t first, std::uint32_t n) {
    std::uint32_t left = n;
    for (std::uint32_t i = first, quiet = 0; quiet < left;) {
      const std::uint32_t before = previous_[i], after = next_[i];
      if (!is_fold(at(before), at(i), at(after))) {
        ++quiet;
        i = after;
        continue;
      }
      has_folds_ = true;
      out_->push_back({before, i, after});
      next_[before] = after;
      previous_[after] = before;
      next_[i] = none;
      quiet = 0;
      if (--left == 2) {
        next_[before] = next_[after] = none;
        return;
      }
      i = before;
    }
  }

  // All vertices at one place: first the ends of edges, then what goes on, then the beginnings.
  constexpr bool pass(std::size_t begin, std::size_t end) {
    starts_.clear();
    changed_.clear();
    for (std::size_t k = begin; k < end; ++k) {
      const std::uint32_t v = events_[k];
      const bool from_previous = is_before(previous_[v], v), from_next = is_before(next_[v], v);
      if (from_previous && from_next)
        end_edges(v);
      else if (!from_previous && !from_next)
        starts_.push_back(v);
    }
    for (std::size_t k = begin; k < end; ++k) {
      const std::uint32_t v = events_[k];
      const bool from_previous = is_before(previous_[v], v), from_next = is_before(next_[v], v);
      if (from_previous && from_next && arriving_[2 * v] != none) return false;  // others lie between its edges
      if (from_previous != from_next) go_on(v, from_previous);
    }
    if (starts_.size() > 1) sort_starts();
    for (const std::uint32_t v : starts_)
      if (!start_edges(v)) return false;
    for (const std::uint32_t e : changed_)
      if (!in_order(e)) return false;
    return true;
  }

  // Ends the two edges that meet at v if they are neighbours, and then those around them that meet at the same place.
  constexpr void end_edges(std::uint32_t v) {
    for (;;) {
      std::uint32_t l = arriving_[2 * v], r = arriving_[2 * v + 1];
      if (l == none) return;
      if (order_.next(l) != r) std::swap(l, r);
      if (order_.next(l) != r) return;
      const std::uint32_t before = order_.previous(l), after = order_.next(r);
      if (edges_[l].inside_on_right)
        chains_.finish(edges_[l].gap, v);
      else
        chains_.merge(edges_[before].gap, edges_[r].gap, v);
      for (const std::uint32_t e : {l, r}) {
        order_.erase(e);
        edges_[e].high = none;
        unused_.push_back(e);
      }
      arriving_[2 * v] = arriving_[2 * v + 1] = none;
      if (before == none || after == none) return;
      changed_.push_back(before);
      const std::uint32_t next = edges_[before].high;
      if (next != edges_[after].high || is_before(v, next)) return;
      v = next;
    }
  }

  constexpr void go_on(std::uint32_t v, bool from_previous) {
    const std::uint32_t e = arriving_[2 * v + (from_previous ? 0 : 1)];
    if (edges_[e].inside_on_right)
      chains_.add_left(edges_[e].gap, v);
    else
      chains_.add_right(edges_[order_.previous(e)].gap, v);
    lead(e, v, from_previous);
  }

  // Lets edge e run from v to its next or previous vertex.
  constexpr void lead(std::uint32_t e, std::uint32_t v, bool to_next) {
    edges_[e].low = v;
    edges_[e].high = to_next ? next_[v] : previous_[v];
    arriving_[2 * edges_[e].high + (to_next ? 0 : 1)] = e;
    changed_.push_back(e);
  }

  constexpr bool next_is_left(std::uint32_t v) const noexcept { return turn(v, previous_[v], next_[v]) > 0; }

  // From left to right by their left edges, the wider ones first: wedges within others come after them.
  constexpr void sort_starts() {
    const auto ends = [&](std::uint32_t v) {
      return next_is_left(v) ? std::array{next_[v], previous_[v]} : std::array{previous_[v], next_[v]};
    };
    std::sort(starts_.begin(), starts_.end(), [&](std::uint32_t u, std::uint32_t v) {
      const auto a = ends(u), b = ends(v);
      const int left = turn(u, a[0], b[0]), right = turn(u, a[1], b[1]);
      return left != 0 ? left < 0 : right != 0 ? right > 0 : u < v;
    });
  }

  constexpr bool start_edges(std::uint32_t v) {
    std::uint32_t before = none;
    for (std::uint32_t e = order_.root(); e != none;) {
      int side = turn(edges_[e].low, edges_[e].high, v);
      if (side == 0) {  // v is on it: where v's own edges lie decides
        const int a = turn(edges_[e].low, edges_[e].high, previous_[v]);
        const int b = turn(edges_[e].low, edges_[e].high, next_[v]);
        if (a * b < 0) return false;
        side = a + b;
      }
      if (side > 0) {
        e = order_.left(e);
      } else {
        before = e;
        e = order_.right(e);
      }
    }
    const std::uint32_t l = new_edge(), r = new_edge();
    const bool to_next = next_is_left(v);
    order_.insert_after(before, l);
    order_.insert_after(l, r);
    const bool inside = before != none && edges_[before].inside_on_right;
    edges_[l].inside_on_right = !inside;
    edges_[r].inside_on_right = inside;
    if (inside)
      edges_[r].gap = chains_.split(edges_[before].gap, v);
    else
      edges_[l].gap = chains_.begin(v);
    lead(l, v, to_next);
    lead(r, v, !to_next);
    return true;
  }

  constexpr std::uint32_t new_edge() {
    if (unused_.empty()) {
      edges_.push_back({});
      return static_cast<std::uint32_t>(edges_.size() - 1);
    }
    const std::uint32_t e = unused_.back();
    unused_.pop_back();
    edges_[e] = {};
    return e;
  }

  // Whether edge e, if it is still there, keeps to its side of its neighbours as far as they go beside each other.
  constexpr bool in_order(std::uint32_t e) const noexcept {
    if (edges_[e].high == none) return true;
    const std::uint32_t before = order_.previous(e), after = order_.next(e);
    return (before == none || in_order(edges_[before], edges_[e])) &&
           (after == none || in_order(edges_[e], edges_[after]));
  }
  constexpr bool in_order(const edge& l, const edge& r) const noexcept {
    return is_before(r.high, l.high) ? turn(l.low, l.high, r.high) <= 0 : turn(r.low, r.high, l.high) >= 0;
  }
};

}  // namespace irg::detail::inline IRG_ABI
