// SPDX-License-Identifier: MIT
// Whether rings cross themselves or each other at a point, and the order of sweeps: what triangulate_monotone looks at
// where rings turn back on themselves.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/geometry/detail/sweep_order.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/math/vec.hpp>

namespace irg::detail::inline IRG_ABI {

// The order of the sweeps: upwards, to the right along a level.
template <Scalar T>
constexpr bool is_lower(const point<T, 2>& a, const point<T, 2>& b) noexcept {
  return a.y < b.y || (a.y == b.y && a.x < b.x);
}

// Whether rings cross themselves or each other at a point, whatever touches or coincides: a sweep from the lowest
// vertex up that keeps the edges in their order (Shamos and Hoey 1976) and, at each vertex, sees whether two ways
// lead through each other.
template <Scalar T>
class crossing_search {
public:
  using place = point<T, 2>;

  // Adds points[first] to points[first + n - 1] as a ring; where it stands still counts for nothing.
  constexpr void add_ring(const std::vector<place>& points, std::size_t first, std::size_t n) {
    const std::size_t begin = vertices_.size();
    for (std::size_t i = first; i < first + n; ++i)
      if (vertices_.size() == begin || !same_place(points[i], vertices_.back().at))
        vertices_.push_back({points[i], 0, 0});
    while (vertices_.size() > begin + 1 && same_place(vertices_[begin].at, vertices_.back().at)) vertices_.pop_back();
    const auto low = static_cast<std::uint32_t>(begin), high = static_cast<std::uint32_t>(vertices_.size());
    if (high - low < 2) {
      vertices_.resize(begin);
      return;
    }
    for (std::uint32_t i = low; i < high; ++i) {
      vertices_[i].previous = i > low ? i - 1 : high - 1;
      vertices_[i].next = i + 1 < high ? i + 1 : low;
    }
  }

  // Whether two edges cross within both, or a way through a vertex crosses an edge or another way there. Ways that
  // have a stretch in common only touch.
  constexpr bool run() {
    std::vector<std::uint32_t> events;
    for (std::uint32_t i = 0; i < vertices_.size(); ++i) events.push_back(i);
    std::sort(events.begin(), events.end(), [&](std::uint32_t i, std::uint32_t j) { return is_lower(at(i), at(j)); });
    for (std::size_t begin = 0, end = 0; begin < events.size(); begin = end) {
      while (end < events.size() && !is_lower(at(events[begin]), at(events[end]))) ++end;
      if (crosses_at(events.data() + begin, end - begin)) return true;
    }
    return false;
  }

private:
  static constexpr std::uint32_t none = sweep_order<std::uint32_t>::none;
  struct vertex {
    place at;
    std::uint32_t previous, next;
  };
  struct way {
    std::uint32_t from, to;  // vertices, then directions by their number around the place
  };

  std::vector<vertex> vertices_;  // edge i leads from vertex i to the next
  sweep_order<std::uint32_t> order_;
  std::vector<std::uint32_t> through_, rising_, around_;
  std::vector<way> ways_;

  constexpr const place& at(std::uint32_t i) const noexcept { return vertices_[i].at; }
  constexpr bool rises(std::uint32_t e) const noexcept { return is_lower(at(e), at(vertices_[e].next)); }
  constexpr std::uint32_t low(std::uint32_t e) const noexcept { return rises(e) ? e : vertices_[e].next; }
  constexpr std::uint32_t high(std::uint32_t e) const noexcept { return rises(e) ? vertices_[e].next : e; }
  // 1 where p is left of edge e, -1 where it is right of it.
  constexpr int side(std::uint32_t e, const place& p) const noexcept { return orient2d(at(low(e)), at(high(e)), p); }
  constexpr bool cross_within(std::uint32_t e, std::uint32_t f) const noexcept {
    return side(e, at(low(f))) * side(e, at(high(f))) < 0 && side(f, at(low(e))) * side(f, at(high(e))) < 0;
  }

  // All vertices at one place.
  constexpr bool crosses_at(const std::uint32_t* found, std::size_t n) {
    const place p = at(found[0]);
    std::uint32_t before = none, first = none;  // the last edge left of p, the first that p is on
    for (std::uint32_t e = order_.root(); e != none;) {
      const int s = side(e, p);
      if (s < 0) before = e;
      if (s == 0) first = e;
      e = s < 0 ? order_.right(e) : order_.left(e);
    }
    through_.clear(), rising_.clear(), ways_.clear();
    std::uint32_t after = first;
    while (after != none && side(after, p) == 0) {
      const std::uint32_t e = after;
      after = order_.next(e);
      if (is_lower(p, at(high(e)))) {
        through_.push_back(e);
        ways_.push_back({low(e), high(e)});
      } else {
        order_.erase(e);
      }
    }
    for (std::size_t k = 0; k < n; ++k) {
      const vertex& v = vertices_[found[k]];
      ways_.push_back({v.previous, v.next});
      if (is_lower(p, at(v.next))) rising_.push_back(found[k]);
      if (is_lower(p, at(v.previous))) rising_.push_back(v.previous);
    }
    if (ways_.size() > 1 && ways_cross(p)) return true;
    insert_rising(p, before);
    std::uint32_t e = before != none ? before : !through_.empty() ? through_[0] : !rising_.empty() ? rising_[0] : after;
    for (; e != none && e != after; e = order_.next(e))
      if (const std::uint32_t f = order_.next(e); f != none && cross_within(e, f)) return true;
    return false;
  }

  // Counter-clockwise round p, from its right on.
  constexpr auto turns_before(const place& p) const noexcept {
    return [this, &p](std::uint32_t i, std::uint32_t j) {
      const bool i_below = is_lower(at(i), p), j_below = is_lower(at(j), p);
      return i_below != j_below ? j_below : orient2d(p, at(i), at(j)) > 0;
    };
  }

  // Whether the ends of two ways through p alternate round it. Ways that share a direction do not cross.
  constexpr bool ways_cross(const place& p) {
    around_.clear();
    for (const way& w : ways_) around_.insert(around_.end(), {w.from, w.to});
    std::sort(around_.begin(), around_.end(), turns_before(p));
    const auto number = [&](std::uint32_t i) {
      return static_cast<std::uint32_t>(std::lower_bound(around_.begin(), around_.end(), i, turns_before(p)) -
                                        around_.begin());
    };
    for (way& w : ways_) {
      const std::uint32_t i = number(w.from), j = number(w.to);
      w = i < j ? way{i, j} : way{j, i};
    }
    std::sort(ways_.begin(), ways_.end(),
              [](const way& v, const way& w) { return v.from != w.from ? v.from < w.from : v.to > w.to; });
    std::size_t open = 0;  // the ways that are open lie at the beginning, each within the one before
    for (const way& w : ways_) {
      const way now = w;
      while (open > 0 && ways_[open - 1].to <= now.from) --open;
      if (open > 0 && ways_[open - 1].from < now.from && ways_[open - 1].to < now.to) return true;
      ways_[open++] = now;
    }
    return false;
  }

  // Puts the edges that begin at p behind `before`, around those that pass through p.
  constexpr void insert_rising(const place& p, std::uint32_t before) {
    const auto top = [&](std::uint32_t e) { return at(high(e)); };
    std::sort(rising_.begin(), rising_.end(), [&](std::uint32_t e, std::uint32_t f) {
      const int t = orient2d(p, top(e), top(f));
      return t != 0 ? t < 0 : e < f;
    });
    std::uint32_t where = before;
    bool is_left = !through_.empty();
    for (const std::uint32_t e : rising_) {
      if (is_left && orient2d(p, top(through_[0]), top(e)) <= 0) {
        where = through_.back();
        is_left = false;
      }
      order_.insert_after(where, e);
      where = e;
    }
  }
};

}  // namespace irg::detail::inline IRG_ABI
