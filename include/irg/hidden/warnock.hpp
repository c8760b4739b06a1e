// SPDX-License-Identifier: MIT
// Warnock's subdivision of windows: look at a window of the picture; if it is easy to draw, draw it; if not, cut it
// into four and look at each. A window is easy when no face touches it, when a single one does, when a face that
// surrounds it lies in front of all others, and when it is one pixel. There is no depth buffer.
//
// A window's list holds the faces that touch it, those that surround it apart: children take their lists from their
// parent's, and what surrounds a window surrounds its parts. What a surrounding face hides in all of the window is left
// off the list, so that work follows what is seen.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/hidden/detail/crowded_window.hpp>
#include <irg/hidden/order_in_window.hpp>
#include <irg/hidden/ray_casting.hpp>
#include <irg/raster/draw_counts.hpp>

namespace irg {

/// How a window of Warnock's ends.
enum class warnock_case { empty, one_face, surrounded, single_pixel, divided };

/// How many windows ended how, and the work that was done.
struct warnock_counts {
  std::int64_t windows[5] = {};  // by warnock_case
  std::int64_t classified = 0;  // faces held against windows
  std::int64_t hidden = 0;  // faces left off lists, a surrounding one being in front

  IRG_INLINE constexpr std::int64_t operator[](warnock_case c) const noexcept { return windows[static_cast<int>(c)]; }
  constexpr bool operator==(const warnock_counts&) const = default;
};

/// Sees no windows.
struct no_window_observer {
  IRG_INLINE constexpr void operator()(const cell_window&, warnock_case) const noexcept {}
};

namespace detail {

// A face on a window's list. `covered` has, in blocks, a bit for each pixel of the block that the face covers, and all
// bits where it surrounds the window.
struct warnock_face {
  const screen_face* face;
  std::uint64_t covered;
  cell_window bounds;  // of the face's pixels

  static constexpr std::uint64_t all = ~std::uint64_t{0};
  IRG_INLINE constexpr bool surrounds() const noexcept { return covered == all; }
};

// A window of at most 8 x 8 pixels, whose parts hold faces against windows by their bits.
struct warnock_block {
  static constexpr int side = 8;
  int x = 0, y = 0;

  static constexpr bool holds(const cell_window& w) noexcept {
    return w.x_last - w.x_first <= side && w.y_last - w.y_first <= side;
  }
  constexpr std::uint64_t bit(int px, int py) const noexcept {
    return std::uint64_t{1} << ((py - y) * side + (px - x));
  }
  constexpr std::uint64_t bits_of(const cell_window& w) const noexcept {
    const std::uint64_t row = ((std::uint64_t{1} << (w.x_last - w.x_first)) - 1) << (w.x_first - x);
    std::uint64_t bits = 0;
    for (int py = w.y_first; py < w.y_last; ++py) bits |= row << ((py - y) * side);
    return bits;
  }
  constexpr std::uint64_t covered_by(const triangle_coverage& t, const cell_window& w) const noexcept {
    std::uint64_t bits = 0;
    const cell_window both = intersect(t.bounds, w);
    if (t.double_area == 0) return 0;
    for (int py = both.y_first; py < both.y_last; ++py) {
      std::int64_t e[3];
      for (int i = 0; i < 3; ++i) e[i] = t.edge[i](both.x_first, py);
      for (int px = both.x_first; px < both.x_last; ++px) {
        if ((e[0] | e[1] | e[2]) >= 0) bits |= bit(px, py);
        for (int i = 0; i < 3; ++i) e[i] += t.edge[i].right;
      }
    }
    return bits;
  }
};

template <DepthOrder Order, class Observer>
class warnock_division {
public:
  constexpr warnock_division(image<std::uint32_t>& ids, Observer& observer) : ids_(ids), observer_(observer) {}

  constexpr warnock_counts operator()(const std::vector<screen_face>& faces, const cell_window& window) {
    for (const screen_face& f : faces) lists_.push_back({&f, 0, f.coverage.bounds});
    look_at(window, 0, lists_.size(), false);
    return counts_;
  }

private:
  // Draws a window, whose parent's list is [first, last). Its own list goes behind all others, and away at the end.
  constexpr void look_at(const cell_window& w, std::size_t first, std::size_t last, bool in_block) {
    const std::size_t own = lists_.size();
    if (warnock_block::holds(w))
      take_in_block(w, first, last, in_block);
    else
      take(w, first, last);
    leave_out_hidden(w, own);
    const warnock_case ending = draw_if_easy(w, own);
    ++counts_.windows[static_cast<int>(ending)];
    observer_(w, ending);
    if (ending == warnock_case::divided) {
      const std::size_t end = lists_.size();
      const bool to_pixels = w.x_last - w.x_first <= 2 && w.y_last - w.y_first <= 2;
      for (const cell_window& part : quarters(w))
        if (part.empty())
          continue;
        else if (to_pixels)
          look_at_pixel(part, own);
        else
          look_at(part, own, end, warnock_block::holds(w));
    }
    lists_.resize(own, warnock_face{});
  }
  // The same for a pixel, whose parent's list is the last one: all that cover it but the nearest are hidden.
  constexpr void look_at_pixel(const cell_window& w, std::size_t own) {
    const std::uint64_t bit = block_.bit(w.x_first, w.y_first);
    const screen_face* seen = nullptr;
    for (std::size_t i = own; i < lists_.size(); ++i) {
      const warnock_face& f = lists_[i];
      counts_.classified += f.surrounds() ? 0 : 1;
      if ((f.covered & bit) == 0) continue;
      counts_.hidden += seen != nullptr ? 1 : 0;
      if (seen == nullptr || is_nearer<Order>(*f.face, *seen, w.x_first, w.y_first)) seen = f.face;
    }
    if (seen != nullptr) ids_(w.x_first, w.y_first) = seen->number;
    const warnock_case ending = seen != nullptr ? warnock_case::single_pixel : warnock_case::empty;
    ++counts_.windows[static_cast<int>(ending)];
    observer_(w, ending);
  }
  constexpr void take(const cell_window& w, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      bool surrounds = lists_[i].surrounds();
      if (!surrounds) {
        ++counts_.classified;
        const cell_window& b = lists_[i].bounds;
        if (b.x_last <= w.x_first || w.x_last <= b.x_first || b.y_last <= w.y_first || w.y_last <= b.y_first) continue;
        const bool within =
            w.x_first < b.x_first && b.x_last < w.x_last && w.y_first < b.y_first && b.y_last < w.y_last;
        if (!within) {
          const containment where = classify(lists_[i].face->coverage, w);
          if (where == containment::outside) continue;
          surrounds = where == containment::inside;
        }
      }
      lists_.push_back({lists_[i].face, surrounds ? warnock_face::all : 0, lists_[i].bounds});
    }
  }
  constexpr void take_in_block(const cell_window& w, std::size_t first, std::size_t last, bool in_block) {
    if (!in_block) block_ = {w.x_first, w.y_first};
    const std::uint64_t all = block_.bits_of(w);
    for (std::size_t i = first; i < last; ++i) {
      const warnock_face& f = lists_[i];
      std::uint64_t covered = warnock_face::all;
      if (!f.surrounds()) {
        ++counts_.classified;
        if (in_block)
          covered = f.covered;
        else
          covered = intersect(f.bounds, w).empty() ? 0 : block_.covered_by(f.face->coverage, w);
        if ((covered & all) == 0) continue;
        if ((covered & all) == all) covered = warnock_face::all;
      }
      lists_.push_back({f.face, covered, f.bounds});
    }
  }

  // Of the surrounding faces the one that is seen in the window's first pixel hides most: what lies behind it in all of
  // the window cannot be seen.
  constexpr void leave_out_hidden(const cell_window& w, std::size_t own) {
    const screen_face* front = nullptr;
    for (std::size_t i = own; i < lists_.size(); ++i)
      if (const warnock_face& f = lists_[i];
          f.surrounds() && (front == nullptr || is_nearer<Order>(*f.face, *front, w.x_first, w.y_first)))
        front = f.face;
    if (front == nullptr) return;
    std::size_t kept = own;
    for (std::size_t i = own; i < lists_.size(); ++i) {
      const screen_face* f = lists_[i].face;
      if (f == front || !hides_in_window<Order>(*front, *f, w))
        lists_[kept++] = lists_[i];
      else
        ++counts_.hidden;
    }
    lists_.resize(kept, warnock_face{});
  }

  constexpr warnock_case draw_if_easy(const cell_window& w, std::size_t own) {
    if (lists_.size() == own) return warnock_case::empty;
    const bool single = is_one_pixel(w);
    if (lists_.size() > own + 1 && !single) return warnock_case::divided;
    const warnock_face* seen = &lists_[own];  // the only one, or the nearest in a pixel, which all cover
    for (std::size_t i = own + 1; i < lists_.size(); ++i)
      if (is_nearer<Order>(*lists_[i].face, *seen->face, w.x_first, w.y_first)) seen = &lists_[i];
    if (warnock_block::holds(w)) {
      for (int y = w.y_first; y < w.y_last; ++y)
        for (int x = w.x_first; x < w.x_last; ++x)
          if ((seen->covered & block_.bit(x, y)) != 0) ids_(x, y) = seen->face->number;
    } else {
      covered_spans(seen->face->coverage, w, [&](const span_of_cells& s) {
        for (int x = s.x_first; x < s.x_last; ++x) ids_(x, s.y) = seen->face->number;
      });
    }
    return single ? warnock_case::single_pixel : seen->surrounds() ? warnock_case::surrounded : warnock_case::one_face;
  }

  image<std::uint32_t>& ids_;
  Observer& observer_;
  std::vector<warnock_face> lists_{};
  warnock_block block_{};  // of the window that is looked at
  warnock_counts counts_{};
};

}  // namespace detail

inline namespace IRG_ABI {

/// Writes the numbers of the faces that are seen in a window's pixels, by Warnock's subdivision.
/// shape   faces: a container of screen_face; ids holds the window; observer(window, how it ended) for each window
/// gives   the number of the nearest face into the pixels that some face covers; the others stay as they are. A window
///         of one row or column is halved
/// exact   as picture_face_at, in every pixel: coverage in integers, depths by is_nearer
/// cost    some 20 ns for each face on a window's list; memory for the lists on the way down to one pixel, none for
///         depths
/// source  Warnock 1969
template <DepthOrder Order = nearer_is_greater, class Faces, class Observer = no_window_observer>
constexpr warnock_counts draw_warnock(const Faces& faces, const cell_window& window, image<std::uint32_t>& ids,
                                      Observer&& observer = {}) {
  if (window.empty()) return {};
  const std::vector<screen_face> list = detail::copied_faces(faces, window);
  return detail::warnock_division<Order, std::remove_reference_t<Observer>>(ids, observer)(list, window);
}

/// The face in a picture whose pixels are cut into k x k, for subdivision beyond the pixel: drawn into k times as many
/// rows and columns, each pixel's share of every face is the share of its k*k parts.
/// needs   k > 0, positions that stay within snap_limit
/// exact   nothing is rounded
[[nodiscard]] constexpr screen_face subdivided_face(const screen_face& f, int k) noexcept {
  const auto corner = [&](int i) {
    return screen_vertex{{f.v[i].position.x * k, f.v[i].position.y * k}, f.v[i].depth, f.v[i].inverse_w};
  };
  return make_screen_face(corner(0), corner(1), corner(2), f.number);
}

}  // namespace IRG_ABI

/// Warnock's subdivision as a hidden-surface method for render.
/// gives   what draw_warnock gives; counts.tested counts the faces held against windows
template <DepthOrder Order = nearer_is_greater>
struct warnock {
  template <class Faces>
  constexpr void operator()(const Faces& faces, const cell_window& window, image<std::uint32_t>& ids,
                            draw_counts& counts) const {
    counts.tested += draw_warnock<Order>(faces, window, ids).classified;
  }
};

}  // namespace irg
