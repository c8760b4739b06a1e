// SPDX-License-Identifier: MIT
// The list of Newell, Newell and Sancha: faces and parts of faces, the farthest last, and the tests by which one may be
// drawn before the others.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/core/memory_access.hpp>
#include <irg/hidden/detail/crowded_window.hpp>
#include <irg/hidden/detail/part_box.hpp>
#include <irg/hidden/newell_step.hpp>
#include <irg/hidden/order_in_window.hpp>
#include <irg/raster/face_fragment.hpp>
#include <irg/raster/image.hpp>

namespace irg {

namespace detail {

// A face, or a part of one, on the way to the picture; `box` holds all pixels that it may have.
struct painted_part {
  face_fragment part;
  cell_window box;
  bool moved = false;
};

inline namespace IRG_ABI {

constexpr cell_window halved(cell_window w) noexcept {
  if (w.x_last - w.x_first > 1)
    w.x_last = w.x_first + (w.x_last - w.x_first) / 2;
  else
    w.y_last = w.y_first + (w.y_last - w.y_first) / 2;
  return w;
}

// What of a window lies around a part of it.
constexpr std::array<cell_window, 4> around(const cell_window& part, const cell_window& w) noexcept {
  return {{{w.x_first, w.y_first, w.x_last, part.y_first},
           {w.x_first, part.y_last, w.x_last, w.y_last},
           {w.x_first, part.y_first, part.x_first, part.y_last},
           {part.x_last, part.y_first, w.x_last, part.y_last}}};
}

// Whether an edge of a has all of b on its outer side, as corners: then no pixel is covered by both.
constexpr bool edge_parts(const screen_face& a, const screen_face& b) noexcept {
  for (int i = 0; i < 3; ++i) {
    const subpixel &p = a.v[i].position, &q = a.v[(i + 1) % 3].position;
    bool outside = true;
    for (const screen_vertex& v : b.v) {
      const std::int64_t side = signed_double_area(p, q, v.position);
      outside = outside && (a.coverage.flipped ? side >= 0 : side <= 0);
    }
    if (outside) return true;
  }
  return false;
}

template <DepthOrder Order>
constexpr bool share_no_pixel(const face_fragment& a, const face_fragment& b, const cell_window& w) noexcept {
  for (int y = w.y_first; y < w.y_last; ++y) {
    const span_of_cells one = covered_span(a.face->coverage, y, w.x_first, w.x_last);
    const span_of_cells both = covered_span(b.face->coverage, y, one.x_first, one.x_last);
    for (int x = both.x_first; x < both.x_last; ++x)
      if (covers<Order>(a, x, y) && covers<Order>(b, x, y)) return false;
  }
  return true;
}

// What a limit of `part` by the plane of `other` says: 1 where the part is nearer, -1 where it is farther, 0 no limit.
template <class Part>
constexpr int limited(const Part& part, const screen_face* other) noexcept {
  for (const face_limit& l : part.part.limits)
    if (l.plane == other) return l.part == face_part::nearer ? 1 : -1;
  return 0;
}

template <DepthOrder Order, class Observer>
class newell_painter {
  static_assert(depth_sense<Order> != 0, "the painter needs depths");

public:
  constexpr newell_painter(image<std::uint32_t>& ids, Observer& observer) : ids_(ids), observer_(observer) {}

  constexpr const newell_counts& counts() const noexcept { return counts_; }

  // Paints faces that are sorted from near to far. A face that covers a whole window hides what is behind it there; a
  // list in which most overlap in depth is cut with its window.
  constexpr void paint(const std::vector<window_face>& sorted, const cell_window& w) {
    if (w.empty()) return;
    const std::vector<window_face> faces = faces_of_window<Order>(sorted, w, counts_.hidden);
    if (is_one_pixel(w)) {
      if (const screen_face* seen = seen_in_pixel<Order>(faces, w)) draw(*seen, w);
      return;
    }
    if (overlaps_much(faces)) {
      for (const cell_window& part : quarters(w)) paint(faces, part);
      return;
    }
    for (std::size_t end = faces.size(); end != 0;) {
      if (end >= faces_ahead) ask_for(*faces[end - faces_ahead].face);
      const std::size_t first = first_overlapping(faces, end);
      if (end - first == 1)
        draw(*faces[first].face, intersect(faces[first].bounds, w));
      else
        paint_overlapping(faces, {first, end}, w);
      end = first;
    }
  }

private:
  // Sorted faces lie anywhere in memory: some are asked for before they are drawn.
  static constexpr std::size_t faces_ahead = 16;
  static constexpr void ask_for(const screen_face& f) noexcept {
    constexpr std::ptrdiff_t line = 64;
    for (std::ptrdiff_t at = 0; at < static_cast<std::ptrdiff_t>(sizeof f); at += line) prefetch(&f, at);
  }

  // Whether there are more than four tests for each face.
  static constexpr bool overlaps_much(const std::vector<window_face>& faces) noexcept {
    constexpr std::ptrdiff_t few = 4;
    std::ptrdiff_t pairs = 0;
    for (auto i = faces.begin(); i != faces.end(); ++i) {
      const auto is_apart = [&](const window_face& f) { return Order::nearer(f.farthest, i->nearest); };
      if (i != faces.begin() && !is_apart(i[-1])) pairs += i - std::partition_point(faces.begin(), i, is_apart);
    }
    return pairs > few * static_cast<std::ptrdiff_t>(faces.size());
  }

  // Where the last faces before `end` begin that no depth parts: all before lie in front of all of them.
  static constexpr std::size_t first_overlapping(const std::vector<window_face>& faces, std::size_t end) noexcept {
    std::size_t first = end - 1;
    for (float nearest = faces[first].nearest; first != 0 && !Order::nearer(faces[first - 1].farthest, nearest);) {
      --first;
      if (Order::nearer(faces[first].nearest, nearest)) nearest = faces[first].nearest;
    }
    return first;
  }

  struct list_range {
    std::size_t first, end;
  };
  constexpr void paint_overlapping(const std::vector<window_face>& faces, const list_range& range,
                                   const cell_window& w) {
    list_.clear();
    for (std::size_t i = range.first; i < range.end; ++i)
      list_.push_back({{faces[i].face, {}}, intersect(faces[i].bounds, w)});
    sorted_ = list_.size();
    while (!list_.empty()) {
      if (!may_be_drawn()) continue;
      draw(list_.back());
      list_.pop_back();
      sorted_ = lesser(sorted_, list_.size());
    }
  }

  constexpr void note(newell_step step, const screen_face& p, const screen_face& q) {
    ++counts_.steps[static_cast<int>(step)];
    observer_(step, p.number, q.number);
  }

  // Whether the last of the list hides none of the others; if not, the list is changed.
  constexpr bool may_be_drawn() {
    const painted_part& p = list_.back();
    for (std::size_t i = list_.size() - 1; i-- > 0;) {
      const painted_part& q = list_[i];
      // The list is sorted but for what was moved, which stands behind.
      if (i < sorted_ && Order::nearer(farthest_depth<Order>(*q.part.face), nearest_depth<Order>(*p.part.face))) break;
      if (does_not_hide(p, q)) continue;
      draw_first(i);
      return false;
    }
    return true;
  }

  constexpr bool does_not_hide(const painted_part& p, const painted_part& q) {
    const auto told = [&](newell_step step) { return note(step, *p.part.face, *q.part.face), true; };
    const screen_face &fp = *p.part.face, &fq = *q.part.face;
    if (&fp == &fq) return true;  // parts of a face have no pixel in common
    const cell_window both = intersect(p.box, q.box);
    if (both.x_first >= both.x_last) return told(newell_step::x_apart);
    if (both.y_first >= both.y_last) return told(newell_step::y_apart);
    const int known = limited(q, &fp) - limited(p, &fq);
    if (known > 0) return true;
    if (known == 0) {
      if (order_in_window<Order>(fp, fq, p.box) == window_order::farther) return told(newell_step::behind_plane);
      if (order_in_window<Order>(fq, fp, q.box) == window_order::nearer) return told(newell_step::in_front_of_plane);
      if (edge_parts(fp, fq) || edge_parts(fq, fp)) return told(newell_step::projections_apart);
      if (order_in_window<Order>(fp, fq, both) == window_order::farther)
        return told(newell_step::behind_where_they_meet);
    }
    // The last resort before a part is split that was moved already: a look at the pixels.
    return q.moved && share_no_pixel<Order>(p.part, q.part, both) && told(newell_step::projections_apart);
  }

  // The last of the list, P, may hide part i, Q: Q, or a part of it, has to be drawn before.
  constexpr void draw_first(std::size_t i) {
    const painted_part p = list_.back(), q = list_[i];
    const cell_window both = intersect(p.box, q.box);
    const bool ordered = limited(q, p.part.face) != 0 || limited(p, q.part.face) != 0 ||
                         order_in_window<Order>(*p.part.face, *q.part.face, both) != window_order::crossing;
    const bool was_sorted = i < sorted_;
    list_.erase(list_.begin() + static_cast<std::ptrdiff_t>(i));
    sorted_ -= was_sorted ? 1 : 0;
    const auto put_back = [&](const face_fragment& part, const cell_window& box) {
      if (has_no_pixel<Order>(part, box)) return;
      list_.insert(list_.begin() + static_cast<std::ptrdiff_t>(i), painted_part{part, box});
      sorted_ += was_sorted ? 1 : 0;
    };
    if (ordered && (!q.moved || is_one_pixel(q.box))) {
      note(newell_step::moved, *p.part.face, *q.part.face);
      put_last(q.part, q.box, true);
    } else if (!ordered) {
      note(newell_step::split_by_plane, *p.part.face, *q.part.face);
      const fragment_parts parts = split_fragment(q.part, *p.part.face);
      put_back(parts.nearer, trimmed_box<Order>(parts.nearer, q.box));
      put_last(parts.farther, trimmed_box<Order>(parts.farther, q.box));
    } else {
      note(newell_step::split_by_extent, *p.part.face, *q.part.face);
      const cell_window inside = both == q.box ? halved(both) : both;
      for (const cell_window& rest : around(inside, q.box)) put_back(q.part, rest);
      put_last(q.part, inside);
    }
  }

  constexpr void put_last(const face_fragment& part, const cell_window& box, bool moved = false) {
    if (!has_no_pixel<Order>(part, box)) list_.push_back({part, box, moved});
  }

  constexpr void draw(const screen_face& f, const cell_window& w) {
    note(newell_step::drawn, f, f);
    covered_spans(f.coverage, w, [&ids = ids_, number = f.number](const span_of_cells& s) {
      std::uint32_t* row = ids.row(s.y);
      for (int x = s.x_first; x < s.x_last; ++x) row[x] = number;
    });
  }
  constexpr void draw(const painted_part& p) {
    const screen_face& f = *p.part.face;
    if (p.part.limits.empty()) return draw(f, p.box);
    note(newell_step::drawn, f, f);
    covered_spans(f.coverage, p.box, [&](const span_of_cells& s) {
      for (int x = s.x_first; x < s.x_last; ++x)
        if (covers<Order>(p.part, x, s.y)) ids_(x, s.y) = f.number;
    });
  }

  image<std::uint32_t>& ids_;
  Observer& observer_;
  std::vector<painted_part> list_{};
  std::size_t sorted_ = 0;
  newell_counts counts_{};
};

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
