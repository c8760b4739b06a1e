// SPDX-License-Identifier: MIT
// The scan line with its active edges, for rings of any shape.
//
// A pixel's winding number is the sum of the directions of the edges that cross its row at or left of its centre; those
// are the edges whose column is not greater than the pixel's. So edges need to be in the order of their columns only,
// and edges of one column in no order at all: nothing is decided by comparing fractions.
#pragma once

#include <algorithm>
#include <vector>

#include <irg/core/sinks.hpp>
#include <irg/raster/detail/convex_fill_kernel.hpp>

namespace irg::detail {

template <class J>
struct polygon_edge {
  edge_walk<J> walk;
  int row_first = 0, row_last = 0;  // within the window
  int direction = 0;  // 1 downwards, -1 upwards

  /// The order in which the scan line meets edges.
  IRG_INLINE friend constexpr bool operator<(const polygon_edge& a, const polygon_edge& b) noexcept {
    return a.row_first != b.row_first ? a.row_first < b.row_first : a.walk.column < b.walk.column;
  }
};

template <class J>
using edge_vertex = std::conditional_t<sizeof(J) == 4, subpixel, far_subpixel>;

inline namespace IRG_ABI {

// Adds the edge from a to b to the list unless it crosses no row of the window or leaves its pixels alone.
template <class J>
constexpr void add_edge(std::vector<polygon_edge<J>>& edges, const edge_vertex<J>& a, const edge_vertex<J>& b,
                        const cell_window& w) {
  const bool down = a.y < b.y;
  const edge_vertex<J>&upper = down ? a : b, &lower = down ? b : a;
  const row_range rows = rows_of_edge(upper, lower);
  const std::int64_t first = maximum(rows.first, std::int64_t{w.y_first}),
                     last = minimum(rows.last, std::int64_t{w.y_last});
  if (first >= last) return;
  if (row_from(minimum(a.x, b.x)) >= w.x_last) return;
  polygon_edge<J> e;
  e.row_first = static_cast<int>(first);
  e.row_last = static_cast<int>(last);
  e.direction = down ? 1 : -1;
  if (row_from(maximum(a.x, b.x)) <= w.x_first)
    e.walk.column = w.x_first;  // on the left all the way: only its direction counts
  else
    e.walk = walk_edge(upper, lower, first);
  edges.push_back(e);
}

// Orders the edges by column; false when that takes more than a few moves per edge, with the edges in some order.
template <class J>
constexpr bool order_nearly_ordered(polygon_edge<J>* first, polygon_edge<J>* last) noexcept {
  std::ptrdiff_t moves_left = 8 * (last - first) + 64;
  for (polygon_edge<J>* next = first; next < last; ++next) {
    if (next == first || next[-1].walk.column <= next->walk.column) continue;
    const polygon_edge<J> e = *next;
    polygon_edge<J>* hole = next;
    do {
      *hole = hole[-1];
      --hole;
      --moves_left;
    } while (hole != first && e.walk.column < hole[-1].walk.column && moves_left > 0);
    *hole = e;
    if (moves_left <= 0) return false;
  }
  return true;
}

// Makes spans of a row's changes of the winding number, given from left to right.
template <class Emit>
class span_maker {
public:
  IRG_INLINE constexpr span_maker(fill_rule rule, const cell_window& w, Emit& sink) noexcept
      : inside_bits_(rule == fill_rule::even_odd ? 1 : -1), window_(w), emit_(sink) {}

  IRG_INLINE constexpr void start_row(int y) noexcept {
    y_ = y;
    winding_ = 0;
    first_ = last_ = window_.x_first;
  }
  // From this column on the winding number is greater by `change`. Columns left of the window count as its first.
  IRG_INLINE constexpr void at(std::int64_t column, int change) {
    const int x = static_cast<int>(clamped(column, std::int64_t{window_.x_first}, std::int64_t{window_.x_last}));
    const bool was_inside = (winding_ & inside_bits_) != 0;
    winding_ += change;
    const bool is_inside = (winding_ & inside_bits_) != 0;
    if (was_inside) last_ = x;
    if (is_inside && last_ != x) {  // a span begins; one that ended here goes on instead
      flush();
      first_ = x;
      last_ = x;
    }
  }
  IRG_INLINE constexpr void end_row() {
    if ((winding_ & inside_bits_) != 0) last_ = window_.x_last;  // edges right of the window are not in the list
    flush();
  }

private:
  IRG_INLINE constexpr void flush() {
    if (first_ < last_) emit_(y_, first_, last_);
  }

  int inside_bits_, y_ = 0, winding_ = 0;
  int first_ = 0, last_ = 0;  // the span that may yet grow; empty when they are equal
  cell_window window_;
  Emit& emit_;
};

// The row of edges that are in no order: their turns are added up column by column.
template <class J, class Emit>
constexpr void emit_unordered(const polygon_edge<J>* first, const polygon_edge<J>* last, const cell_window& w,
                              std::vector<int>& turns, span_maker<Emit>& spans) {
  const std::size_t width = static_cast<std::size_t>(std::int64_t{w.x_last} - w.x_first);
  turns.assign(width + 1, 0);
  for (; first < last; ++first) {
    const std::int64_t x = clamped(std::int64_t{first->walk.column}, std::int64_t{w.x_first}, std::int64_t{w.x_last});
    turns[static_cast<std::size_t>(x - w.x_first)] += first->direction;
  }
  for (std::size_t i = 0; i < width; ++i)
    if (turns[i] != 0) spans.at(w.x_first + static_cast<std::int64_t>(i), turns[i]);
}

// Walks all edges down the window. The active ones are [active, waiting): those that end are closed up towards the
// waiting ones, which stand in the order of their first rows.
template <class J, class Emit>
constexpr void scan_edges(std::vector<polygon_edge<J>>& edges, std::vector<int>& turns, fill_rule rule,
                          const cell_window& w, Emit& sink) {
  std::sort(edges.begin(), edges.end());
  using edge = polygon_edge<J>;
  edge *active = edges.data(), *waiting = active, *const end = active + edges.size();
  span_maker<Emit> spans(rule, w, sink);
  int y = w.y_first, change_at = w.y_first;  // the row of the next change of the list
  while (true) {
    if (active == waiting) {
      if (waiting == end) return;
      y = change_at = waiting->row_first;
    }
    if (y == change_at) {
      edge* kept = waiting;
      change_at = w.y_last;
      for (edge* e = waiting; e != active;) {
        --e;
        if (e->row_last <= y) continue;
        change_at = minimum(change_at, e->row_last);
        if (--kept != e) *kept = *e;
      }
      active = kept;
      for (; waiting != end && waiting->row_first <= y; ++waiting) change_at = minimum(change_at, waiting->row_last);
      if (waiting != end) change_at = minimum(change_at, waiting->row_first);
      if (active == waiting) continue;
    }
    spans.start_row(y);
    if (order_nearly_ordered(active, waiting)) {
      for (const edge* e = active; e != waiting; ++e) spans.at(e->walk.column, e->direction);
    } else if (std::int64_t{w.x_last} - w.x_first <= 16 * (waiting - active)) {
      emit_unordered(active, waiting, w, turns, spans);
    } else {
      std::sort(active, waiting, [](const edge& a, const edge& b) { return a.walk.column < b.walk.column; });
      for (const edge* e = active; e != waiting; ++e) spans.at(e->walk.column, e->direction);
    }
    spans.end_row();
    ++y;
    for (edge* e = active; e != waiting; ++e) e->walk.next();
  }
}

// Whether no level line crosses the ring more than twice, so that walk_ring() fills it under either rule: its vertices
// go down once and up once.
template <FillableRing R>
constexpr bool goes_down_and_up_once(const R& ring) {
  const std::size_t n = ring_size(ring);
  if (n < 4) return true;
  int turns = 0, last = 0, first = 0;
  auto y = near_vertex(ring, n - 1).y;
  for (std::size_t i = 0; i < n; ++i) {
    const auto next = near_vertex(ring, i).y;
    const int way = next > y ? 1 : next < y ? -1 : last;
    if (first == 0) first = way;
    turns += last != 0 && way != last ? 1 : 0;
    if (turns > 2) return false;
    last = way;
    y = next;
  }
  return turns + (first != last ? 1 : 0) <= 2;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
