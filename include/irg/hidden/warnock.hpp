// SPDX-License-Identifier: MIT
// Warnock's subdivision of windows: look at a window of the picture; if it is easy to draw, draw it; if not, cut it
// into four and look at each. A window is easy when no face touches it, when a single one does, when a face that
// surrounds it lies in front of all others, and when it is one pixel. There is no depth buffer.
//
// A window's list holds the faces that touch it, those that surround it apart: children take their lists from their
// parent's, and what surrounds a window surrounds its parts. What a surrounding face hides in all of the window is left
// off the list, so that work follows what is seen.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include <irg/core/function_ref.hpp>
#include <irg/hidden/ray_casting.hpp>
#include <irg/raster/draw_counts.hpp>
#if IRG_BODIES
#include <irg/hidden/detail/crowded_window.hpp>
#include <irg/hidden/order_in_window.hpp>
#include <irg/raster/triangle_coverage.hpp>
#endif

namespace irg {

/// How a window of Warnock's ends.
enum class warnock_case { empty, one_face, surrounded, single_pixel, divided };

/// How many windows ended how, and the work that was done.
struct warnock_counts {
  std::int64_t windows[5] = {};  // by warnock_case
  std::int64_t classified = 0;  // faces held against windows
  std::int64_t hidden = 0;  // faces left off lists, a surrounding one being in front

  IRG_INLINE constexpr std::int64_t operator[](warnock_case c) const noexcept { return windows[static_cast<int>(c)]; }
  bool operator==(const warnock_counts&) const = default;
};

/// Sees no windows.
struct no_window_observer {
  IRG_INLINE constexpr void operator()(const cell_window&, warnock_case) const noexcept {}
};

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
constexpr warnock_counts draw_warnock(image<std::uint32_t>& ids, const Faces& faces, const cell_window& window,
                                      Observer&& observer = {});
template <DepthOrder Order = nearer_is_greater, class Faces, class Observer = no_window_observer>
[[deprecated("irg: draw_warnock(ids, faces, window, observer)")]] constexpr warnock_counts draw_warnock(
    const Faces& faces, const cell_window& window, image<std::uint32_t>& ids, Observer&& observer = {}) {
  return draw_warnock<Order>(ids, faces, window, observer);
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
struct warnock : exact_method {
  template <class Faces>
  IRG_APART constexpr void operator()(const Faces& faces, const cell_window& window, image<std::uint32_t>& ids,
                                      draw_counts& counts) const {
    counts.tested += draw_warnock<Order>(ids, faces, window).classified;
  }
};

namespace detail::inline IRG_COMPILED_ABI {

template <class Counts, DepthOrder Order, class Observer>
IRG_API Counts divide_windows(image<std::uint32_t>& ids, std::vector<screen_face>& list, const cell_window& window,
                              Observer& observer);

}  // namespace detail::inline IRG_COMPILED_ABI

inline namespace IRG_ABI {

template <DepthOrder Order, class Faces, class Observer>
constexpr warnock_counts draw_warnock(image<std::uint32_t>& ids, const Faces& faces, const cell_window& window,
                                      Observer&& observer) {
  if (window.empty()) return {};
  std::vector<screen_face> list = detail::copied_faces<Order>(faces, window);
  if constexpr (std::is_same_v<std::remove_cvref_t<Observer>, no_window_observer>) {
    constexpr no_window_observer nobody;
    return detail::divide_windows<warnock_counts, Order>(ids, list, window, nobody);
  } else if constexpr (IRG_BODIES != 0) {
    return detail::divide_windows<warnock_counts, Order>(ids, list, window, observer);
  } else {
    const function_ref<void(const cell_window&, warnock_case)>& all =
        as_function<void(const cell_window&, warnock_case)>(observer);
    return detail::divide_windows<warnock_counts, Order>(ids, list, window, all);
  }
}

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// For each pixel of a small window the set of the faces that cover it, as bits: what touches or surrounds a part of the
// window is then the union or the common part of a few numbers.

class face_sets {
public:
  static constexpr int side = 16;
  static constexpr std::size_t most = 64;  // faces

  static constexpr bool holds(const cell_window& w) noexcept {
    return w.x_last - w.x_first <= side && w.y_last - w.y_first <= side;
  }

  // Empty sets for the pixels of a window.
  constexpr void start(const cell_window& w) noexcept {
    window_ = w;
    for (int y = w.y_first; y < w.y_last; ++y)
      for (int x = w.x_first; x < w.x_last; ++x) place(x, y) = 0;
  }
  // Puts the face that has this bit into the sets of the pixels that it covers.
  constexpr void add(const triangle_coverage& t, std::uint64_t bit) noexcept {
    const cell_window both = intersect(t.bounds, window_);
    std::int64_t row[3];
    for (int i = 0; i < 3; ++i) row[i] = t.edge[i](both.x_first, both.y_first);
    for (int y = both.y_first; y < both.y_last; ++y) {
      std::int64_t e[3] = {row[0], row[1], row[2]};
      for (int x = both.x_first; x < both.x_last; ++x) {
        place(x, y) |= (e[0] | e[1] | e[2]) < 0 ? 0 : bit;  // no branch: nobody can foretell it
        for (int i = 0; i < 3; ++i) e[i] += t.edge[i].right;
      }
      for (int i = 0; i < 3; ++i) row[i] += t.edge[i].down;
    }
  }

  constexpr std::uint64_t operator()(int x, int y) const noexcept {
    return sets_[(y - window_.y_first) * side + (x - window_.x_first)];
  }

  // The faces that cover some pixel of a part of the window, and those that cover them all.
  struct touching_window {
    std::uint64_t somewhere, everywhere;
  };
  constexpr touching_window touching(const cell_window& w) const noexcept {
    touching_window t{0, ~std::uint64_t{0}};
    for (int y = w.y_first; y < w.y_last; ++y)
      for (int x = w.x_first; x < w.x_last; ++x) {
        t.somewhere |= (*this)(x, y);
        t.everywhere &= (*this)(x, y);
      }
    return t;
  }

private:
  constexpr std::uint64_t& place(int x, int y) noexcept {
    return sets_[(y - window_.y_first) * side + (x - window_.x_first)];
  }

  std::uint64_t sets_[side * side] = {};
  cell_window window_{};
};

// A face on a window's list.
struct warnock_face {
  const screen_face* face;
  cell_window bounds;  // of the face's pixels
  bool surrounds;
};

template <DepthOrder Order, class Observer>
struct warnock_division {
  image<std::uint32_t>& ids;
  Observer& observer;
  std::vector<warnock_face> lists{};
  face_sets sets{};  // of the small window that is looked into
  std::size_t small_first = 0;  // and where its list begins
  warnock_counts counts{};

  constexpr warnock_counts operator()(const std::vector<screen_face>& faces, const cell_window& window) {
    for (const screen_face& f : faces) lists.push_back({&f, f.coverage.bounds, false});
    look_at(window, 0, lists.size());
    return counts;
  }

  // Draws a window, whose parent's list is [first, last). Its own list goes behind all others, and away at the end.
  constexpr void look_at(const cell_window& w, std::size_t first, std::size_t last) {
    const std::size_t own = lists.size();
    take(w, first, last);
    if (const std::size_t n = lists.size() - own; n > 1 && n <= face_sets::most && face_sets::holds(w)) {
      look_into(w, own);
      lists.resize(own, warnock_face{});
      return;
    }
    leave_out_hidden(w, own);
    const warnock_case ending = draw_if_easy(w, own);
    note(w, ending);
    if (ending == warnock_case::divided) {
      const std::size_t end = lists.size();
      for (const cell_window& part : quarters(w))
        if (!part.empty()) look_at(part, own, end);
    }
    lists.resize(own, warnock_face{});
  }
  constexpr void note(const cell_window& w, warnock_case ending) {
    ++counts.windows[static_cast<int>(ending)];
    observer(w, ending);
  }

  constexpr void take(const cell_window& w, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      bool surrounds = lists[i].surrounds;
      if (!surrounds) {
        ++counts.classified;
        const containment where = classify_face(*lists[i].face, lists[i].bounds, w);
        if (where == containment::outside) continue;
        surrounds = where == containment::inside;
      }
      lists.push_back({lists[i].face, lists[i].bounds, surrounds});
    }
  }

  // Of the surrounding faces the one that is seen in the window's first pixel hides most: what lies behind it in all of
  // the window cannot be seen.
  constexpr void leave_out_hidden(const cell_window& w, std::size_t own) {
    const screen_face* front = nullptr;
    for (std::size_t i = own; i < lists.size(); ++i)
      if (const warnock_face& f = lists[i];
          f.surrounds && (front == nullptr || is_nearer<Order>(*f.face, *front, w.x_first, w.y_first)))
        front = f.face;
    if (front == nullptr) return;
    std::size_t kept = own;
    for (std::size_t i = own; i < lists.size(); ++i) {
      const screen_face* f = lists[i].face;
      if (f == front || !hides_in_window<Order>(*front, *f, w))
        lists[kept++] = lists[i];
      else
        ++counts.hidden;
    }
    lists.resize(kept, warnock_face{});
  }

  constexpr warnock_case draw_if_easy(const cell_window& w, std::size_t own) {
    if (lists.size() == own) return warnock_case::empty;
    const bool single = is_one_pixel(w);
    if (lists.size() > own + 1 && !single) return warnock_case::divided;
    const warnock_face* seen = &lists[own];  // the only one, or the nearest in a pixel, which all cover
    for (std::size_t i = own + 1; i < lists.size(); ++i)
      if (is_nearer<Order>(*lists[i].face, *seen->face, w.x_first, w.y_first)) seen = &lists[i];
    covered_spans(seen->face->coverage, w, [&](const span_of_cells& s) {
      for (int x = s.x_first; x < s.x_last; ++x) ids(x, s.y) = seen->face->number;
    });
    return single ? warnock_case::single_pixel : seen->surrounds ? warnock_case::surrounded : warnock_case::one_face;
  }

  // A small window with few faces: from here on lists are sets, in which face i of the list has bit i.
  constexpr void look_into(const cell_window& w, std::size_t own) {
    small_first = own;
    sets.start(w);
    std::uint64_t listed = 0;
    for (std::size_t i = own; i < lists.size(); ++i) {
      const std::uint64_t bit = std::uint64_t{1} << (i - own);
      sets.add(lists[i].face->coverage, bit);
      listed |= bit;
    }
    look_at_set(w, listed, 0);
  }
  constexpr const screen_face& first_of(std::uint64_t set) const noexcept {
    return *lists[small_first + static_cast<std::size_t>(std::countr_zero(set))].face;
  }
  static constexpr bool are_several(std::uint64_t set) noexcept { return (set & (set - 1)) != 0; }

  // The same as look_at: `listed` is the parent's list, of which `surrounding` surround the parent.
  constexpr void look_at_set(const cell_window& w, std::uint64_t listed, std::uint64_t surrounding) {
    counts.classified += std::popcount(listed & ~surrounding);
    const face_sets::touching_window of = sets.touching(w);
    const std::uint64_t inside = of.everywhere & listed;
    std::uint64_t touching = of.somewhere & listed;
    if (touching == 0) return note(w, warnock_case::empty);
    if (inside != 0 && are_several(touching)) touching = without_hidden(w, touching, inside);
    if (!are_several(touching)) {
      for (int y = w.y_first; y < w.y_last; ++y)
        for (int x = w.x_first; x < w.x_last; ++x)
          if ((sets(x, y) & touching) != 0) ids(x, y) = first_of(touching).number;
      return note(w, (touching & inside) != 0 ? warnock_case::surrounded : warnock_case::one_face);
    }
    note(w, warnock_case::divided);
    for (const cell_window& part : quarters(w))
      if (is_one_pixel(part))
        look_at_pixel(part, touching, touching & inside);
      else if (!part.empty())
        look_at_set(part, touching, touching & inside);
  }
  // The same for a pixel: all that cover it but the nearest are hidden.
  constexpr void look_at_pixel(const cell_window& w, std::uint64_t listed, std::uint64_t surrounding) {
    counts.classified += std::popcount(listed & ~surrounding);
    const int x = w.x_first, y = w.y_first;
    std::uint64_t covering = sets(x, y) & listed;
    if (covering == 0) return note(w, warnock_case::empty);
    const screen_face* seen = &first_of(covering);
    while ((covering &= covering - 1) != 0) {
      ++counts.hidden;
      if (is_nearer<Order>(first_of(covering), *seen, x, y)) seen = &first_of(covering);
    }
    ids(x, y) = seen->number;
    note(w, warnock_case::single_pixel);
  }
  constexpr std::uint64_t without_hidden(const cell_window& w, std::uint64_t touching, std::uint64_t inside) {
    const auto lowest_bit = [](std::uint64_t set) { return set & (~set + 1); };
    std::uint64_t front = lowest_bit(inside);
    for (std::uint64_t rest = inside ^ front; rest != 0; rest &= rest - 1)
      if (is_nearer<Order>(first_of(rest), first_of(front), w.x_first, w.y_first)) front = lowest_bit(rest);
    for (std::uint64_t rest = touching ^ front; rest != 0; rest &= rest - 1)
      if (hides_in_window<Order>(first_of(front), first_of(rest), w)) {
        touching ^= lowest_bit(rest);
        ++counts.hidden;
      }
    return touching;
  }
};

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <class Counts, DepthOrder Order, class Observer>
IRG_API Counts divide_windows(image<std::uint32_t>& ids, std::vector<screen_face>& list, const cell_window& window,
                              Observer& observer) {
  leave_out_repeated<Order>(list);
  return warnock_division<Order, Observer>{ids, observer}(list, window);
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
