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

// A face on a window's list.
struct warnock_face {
  const screen_face* face;
  bool surrounds;
};

template <DepthOrder Order, class Observer>
class warnock_division {
public:
  constexpr warnock_division(image<std::uint32_t>& ids, Observer& observer) : ids_(ids), observer_(observer) {}

  constexpr warnock_counts operator()(const std::vector<screen_face>& faces, const cell_window& window) {
    for (const screen_face& f : faces) lists_.push_back({&f, false});
    look_at(window, 0, lists_.size());
    return counts_;
  }

private:
  // Draws a window, whose parent's list is [first, last). Its own list goes behind all others, and away at the end.
  constexpr void look_at(const cell_window& w, std::size_t first, std::size_t last) {
    const std::size_t own = lists_.size();
    for (std::size_t i = first; i < last; ++i) {
      const warnock_face f = lists_[i];
      if (f.surrounds) {
        lists_.push_back(f);
        continue;
      }
      ++counts_.classified;
      const containment where = classify(f.face->coverage, w);
      if (where != containment::outside) lists_.push_back({f.face, where == containment::inside});
    }
    leave_out_hidden(w, own);
    const warnock_case ending = draw_if_easy(w, own);
    ++counts_.windows[static_cast<int>(ending)];
    observer_(w, ending);
    if (ending == warnock_case::divided) {
      const std::size_t end = lists_.size();
      for (const cell_window& part : quarters(w))
        if (!part.empty()) look_at(part, own, end);
    }
    lists_.resize(own, warnock_face{});
  }

  // Of the surrounding faces the one that is seen in the window's first pixel hides most: what lies behind it in all of
  // the window cannot be seen.
  constexpr void leave_out_hidden(const cell_window& w, std::size_t own) {
    const screen_face* front = nullptr;
    for (std::size_t i = own; i < lists_.size(); ++i)
      if (const warnock_face& f = lists_[i];
          f.surrounds && (front == nullptr || is_nearer<Order>(*f.face, *front, w.x_first, w.y_first)))
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
    const screen_face* seen = nullptr;  // the only one, or the nearest in a pixel
    for (std::size_t i = own; i < lists_.size(); ++i)
      if (const screen_face* f = lists_[i].face;
          !single ||
          (covers(*f, w.x_first, w.y_first) && (seen == nullptr || is_nearer<Order>(*f, *seen, w.x_first, w.y_first))))
        seen = f;
    if (seen != nullptr)
      covered_spans(seen->coverage, w, [&](const span_of_cells& s) {
        for (int x = s.x_first; x < s.x_last; ++x) ids_(x, s.y) = seen->number;
      });
    return single                  ? warnock_case::single_pixel
           : lists_[own].surrounds ? warnock_case::surrounded
                                   : warnock_case::one_face;
  }

  image<std::uint32_t>& ids_;
  Observer& observer_;
  std::vector<warnock_face> lists_{};
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
constexpr screen_face subdivided_face(const screen_face& f, int k) noexcept {
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
