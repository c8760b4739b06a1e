// SPDX-License-Identifier: MIT
// The painter's algorithm of Newell, Newell and Sancha, complete. Faces are sorted by their farthest vertex and drawn
// from the far end. Before a face P is drawn, every face Q whose depths begin before P's end is asked whether P might
// hide it. Five tests, in order of cost, say no: the extents are apart in x; in y; P lies behind the plane of Q; Q lies
// in front of the plane of P; the projections are apart. Where all fail, Q is drawn first, unless that was done with Q
// already: then faces hide each other in turn, and Q is split.
//
// A part of a face is its face, limits (face_fragment) and a window: splitting makes no coordinate. Of planes equally
// deep the lower number is in front, so that coplanar faces have an order, too. A window whose list is long and
// overlaps in depth is cut into four first, and what a face hides in all of a window is left out there.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include <irg/core/function_ref.hpp>
#include <irg/hidden/ray_casting.hpp>
#include <irg/hidden/vocabulary.hpp>
#include <irg/raster/draw_counts.hpp>
#include <irg/raster/image.hpp>
#if IRG_BODIES
#include <irg/core/memory_access.hpp>
#include <irg/hidden/detail/crowded_window.hpp>
#include <irg/hidden/order_in_window.hpp>
#include <irg/raster/face_fragment.hpp>
#include <irg/raster/triangle_coverage.hpp>
#endif

namespace irg {
inline namespace IRG_ABI {

/// Writes the numbers of the faces that are seen in a window's pixels, by drawing faces from far to near in the order
/// of Newell, Newell and Sancha.
/// shape   faces: a container of screen_face; ids holds the window; observer(step, number of P, number of Q) for each
///         test that tells, each reordering and each split
/// gives   the number of the nearest face into the pixels that some face covers; the others stay as they are. The
///         counts say how often each test told, what was moved, split and drawn
/// exact   as picture_face_at, in every pixel: every test is decided by is_nearer or in integers
/// cost    a sort, the tests of faces that overlap in depth, and each pixel as often as it is drawn; memory for the
///         list, none for depths
/// source  Newell, Newell and Sancha 1972
template <DepthOrder Order = nearer_is_greater, class Faces, class Observer = no_newell_observer>
constexpr newell_counts draw_painter_newell(image<std::uint32_t>& ids, const Faces& faces, const cell_window& window,
                                            Observer&& observer = {});
template <DepthOrder Order = nearer_is_greater, class Faces, class Observer = no_newell_observer>
[[deprecated("irg: draw_painter_newell(ids, faces, window, observer)")]] constexpr newell_counts draw_painter_newell(
    const Faces& faces, const cell_window& window, image<std::uint32_t>& ids, Observer&& observer = {}) {
  return draw_painter_newell<Order>(ids, faces, window, observer);
}

}  // namespace IRG_ABI

/// The painter's algorithm of Newell, Newell and Sancha as a hidden-surface method for render.
/// gives   what draw_painter_newell gives; counts.tested counts the faces and parts drawn
template <DepthOrder Order = nearer_is_greater>
struct painter_newell : exact_method {
  template <class Faces>
  IRG_APART constexpr void operator()(const Faces& faces, const cell_window& window, image<std::uint32_t>& ids,
                                      draw_counts& counts) const {
    counts.tested += draw_painter_newell<Order>(ids, faces, window)[newell_step::drawn];
  }
};

namespace detail::inline IRG_COMPILED_ABI {

template <class Counts, DepthOrder Order, class Observer>
IRG_API Counts paint_sorted(image<std::uint32_t>& ids, std::vector<screen_face>& list, const cell_window& window,
                            Observer& observer);

}  // namespace detail::inline IRG_COMPILED_ABI

inline namespace IRG_ABI {

template <DepthOrder Order, class Faces, class Observer>
constexpr newell_counts draw_painter_newell(image<std::uint32_t>& ids, const Faces& faces, const cell_window& window,
                                            Observer&& observer) {
  static_assert(depth_sense<Order> != 0, "the painter needs depths");
  std::vector<screen_face> list = detail::copied_faces<Order>(faces, window);
  if constexpr (std::is_same_v<std::remove_cvref_t<Observer>, no_newell_observer>) {
    constexpr no_newell_observer nobody;
    return detail::paint_sorted<newell_counts, Order>(ids, list, window, nobody);
  } else if constexpr (IRG_BODIES != 0) {
    return detail::paint_sorted<newell_counts, Order>(ids, list, window, observer);
  } else {
    const function_ref<void(newell_step, std::uint32_t, std::uint32_t)>& all =
        as_function<void(newell_step, std::uint32_t, std::uint32_t)>(observer);
    return detail::paint_sorted<newell_counts, Order>(ids, list, window, all);
  }
}

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// The pixels that a part of a face may have, as a window.

// The box without the halves at its four sides, and their halves in turn, that hold no pixel of the part, as far as its
// last limit tells.
template <DepthOrder Order>
constexpr cell_window trimmed_box(const face_fragment& part, cell_window box) noexcept {
  const face_limit& limit = part.limits.back();
  const window_order out = limit.part == face_part::nearer ? window_order::farther : window_order::nearer;
  for (int side = 0; side < 4; ++side)
    for (;;) {
      const int low = side < 2 ? box.x_first : box.y_first, high = side < 2 ? box.x_last : box.y_last;
      if (high - low < 2) break;
      cell_window cut = box, rest = box;
      const int middle = low + (high - low) / 2;
      (side == 0 ? cut.x_last : side == 1 ? cut.x_first : side == 2 ? cut.y_last : cut.y_first) = middle;
      (side == 0 ? rest.x_first : side == 1 ? rest.x_last : side == 2 ? rest.y_first : rest.y_last) = middle;
      if (classify(part.face->coverage, cut) != containment::outside &&
          order_in_window<Order>(*part.face, *limit.plane, cut) != out)
        break;
      box = rest;
    }
  return box;
}

// Whether a part surely has no pixel: small windows are searched.
template <DepthOrder Order>
constexpr bool has_no_pixel(const face_fragment& part, const cell_window& box) noexcept {
  constexpr std::int64_t searched = 64;
  if (box.empty()) return true;
  if (std::int64_t{box.x_last - box.x_first} * (box.y_last - box.y_first) > searched) return false;
  for (int y = box.y_first; y < box.y_last; ++y)
    for (int x = box.x_first; x < box.x_last; ++x)
      if (covers<Order>(part, x, y)) return false;
  return true;
}

// Faces sorted by their depths, by the bits of these: four looks at each face instead of one for each halving of the
// list.

struct keyed_place {
  std::uint32_t key, place;
};

// Sorts by keys; equal ones stay in their order.
template <class Keyed = keyed_place>
constexpr void sort_by_keys(std::vector<Keyed>& list) {
  constexpr int digits = 4, values = 256;
  std::uint32_t counts[digits][values] = {};
  const auto digit = [](const Keyed& k, int d) { return static_cast<std::size_t>((k.key >> (8 * d)) & (values - 1)); };
  for (const Keyed& k : list)
    for (int d = 0; d < digits; ++d) ++counts[d][digit(k, d)];
  std::vector<Keyed> sorted(list.size(), Keyed{});
  for (int d = 0; d < digits && !list.empty(); ++d) {
    std::uint32_t(&places)[values] = counts[d];
    if (places[digit(list[0], d)] == list.size()) continue;  // all have this digit
    std::uint32_t before = 0;
    for (int v = 0; v < values; ++v) {
      const std::uint32_t count = places[v];
      places[v] = before;
      before += count;
    }
    for (const Keyed& k : list) sorted[places[digit(k, d)]++] = k;
    list.swap(sorted);
  }
}

// A number that grows with a depth.
IRG_INLINE constexpr std::uint32_t key_of_depth(float depth) noexcept {
  constexpr std::uint32_t sign = 0x80000000;
  const auto bits = std::bit_cast<std::uint32_t>(depth == 0.0f ? 0.0f : depth);  // 0 and -0 are equal
  return (bits & sign) != 0 ? ~bits : bits | sign;
}

// The faces from near to far by their farthest depths, of equal ones those of lower numbers first.
template <DepthOrder Order>
constexpr std::vector<window_face> sorted_by_depth(const std::vector<screen_face>& faces) {
  std::vector<keyed_place> order;
  order.reserve(faces.size());
  bool by_number = true;
  for (const screen_face& f : faces) {
    by_number = by_number && (order.empty() || order.back().key <= f.number);
    order.push_back({f.number, static_cast<std::uint32_t>(order.size())});
  }
  if (!by_number) sort_by_keys(order);
  for (keyed_place& k : order) {
    const std::uint32_t key = key_of_depth(farthest_depth<Order>(faces[k.place]));
    k.key = depth_sense<Order> > 0 ? ~key : key;
  }
  sort_by_keys(order);
  std::vector<window_face> sorted;
  sorted.reserve(faces.size());
  for (const keyed_place& k : order) sorted.push_back(window_face_of<Order>(faces[k.place]));
  return sorted;
}

// The list of Newell, Newell and Sancha: faces and parts of faces, the farthest last, and the tests by which one may be
// drawn before the others.

// A face, or a part of one, on the way to the picture; `box` holds all pixels that it may have.
struct painted_part {
  face_fragment part;
  cell_window box;
  bool moved = false;
};

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
      const std::int64_t side = twice_signed_area(p, q, v.position);
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
constexpr int limited(const painted_part& part, const screen_face* other) noexcept {
  for (const face_limit& l : part.part.limits)
    if (l.plane == other) return l.part == face_part::nearer ? 1 : -1;
  return 0;
}

template <DepthOrder Order, class Observer>
struct newell_painter {
  image<std::uint32_t>& ids;
  Observer& observer;
  std::vector<painted_part> list{};
  std::size_t in_order = 0;  // of them, the first ones
  newell_counts counts{};

  // Paints faces that are sorted from near to far. A face that covers a whole window hides what is behind it there; a
  // list in which most overlap in depth is cut with its window.
  constexpr void paint(const std::vector<window_face>& sorted, const cell_window& w) {
    if (w.empty()) return;
    const std::vector<window_face> faces = faces_of_window<Order>(sorted, w, counts.hidden);
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
    list.clear();
    for (std::size_t i = range.first; i < range.end; ++i)
      list.push_back({{faces[i].face, {}}, intersect(faces[i].bounds, w)});
    in_order = list.size();
    while (!list.empty()) {
      if (!may_be_drawn()) continue;
      draw(list.back());
      list.pop_back();
      in_order = minimum(in_order, list.size());
    }
  }

  constexpr void note(newell_step step, const screen_face& p, const screen_face& q) {
    ++counts.steps[static_cast<int>(step)];
    observer(step, p.number, q.number);
  }

  // Whether the last of the list hides none of the others; if not, the list is changed.
  constexpr bool may_be_drawn() {
    const painted_part& p = list.back();
    for (std::size_t i = list.size() - 1; i-- > 0;) {
      const painted_part& q = list[i];
      // The list is sorted but for what was moved, which stands behind.
      if (i < in_order && Order::nearer(farthest_depth<Order>(*q.part.face), nearest_depth<Order>(*p.part.face))) break;
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
    const painted_part p = list.back(), q = list[i];
    const cell_window both = intersect(p.box, q.box);
    const bool ordered = limited(q, p.part.face) != 0 || limited(p, q.part.face) != 0 ||
                         order_in_window<Order>(*p.part.face, *q.part.face, both) != window_order::crossing;
    const bool was_sorted = i < in_order;
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(i));
    in_order -= was_sorted ? 1 : 0;
    const auto put_back = [&](const face_fragment& part, const cell_window& box) {
      if (has_no_pixel<Order>(part, box)) return;
      list.insert(list.begin() + static_cast<std::ptrdiff_t>(i), painted_part{part, box});
      in_order += was_sorted ? 1 : 0;
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
    if (!has_no_pixel<Order>(part, box)) list.push_back({part, box, moved});
  }

  constexpr void draw(const screen_face& f, const cell_window& w) {
    note(newell_step::drawn, f, f);
    covered_spans(f.coverage, w, [&ids = ids, number = f.number](const span_of_cells& s) {
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
        if (covers<Order>(p.part, x, s.y)) ids(x, s.y) = f.number;
    });
  }
};

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <class Counts, DepthOrder Order, class Observer>
IRG_API Counts paint_sorted(image<std::uint32_t>& ids, std::vector<screen_face>& list, const cell_window& window,
                            Observer& observer) {
  leave_out_repeated<Order>(list);
  newell_painter<Order, Observer> painter{ids, observer};
  painter.paint(sorted_by_depth<Order>(list), window);
  return painter.counts;
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
