// SPDX-License-Identifier: MIT
// The front faces of a convex body hide none of each other, so that nothing need be decided: each is drawn, in any
// order. On the screen, where corners were rounded, two of them may yet cover a pixel centre beside the outline; what
// is drawn twice is decided there, and only there.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <irg/hidden/ray_casting.hpp>

namespace irg {

/// A hidden-surface method for faces that hardly hide each other, as the front faces of one convex body do not: each
/// face is drawn once, and depths are compared in the pixels that are met again.
/// gives   the number of the nearest face into the pixels that some face covers; the others stay as they are;
///         counts.tested counts the comparisons
/// exact   as picture_face_at, in every pixel, whatever the faces are
/// cost    each pixel as often as it is covered; memory for a copy of the faces, none for depths
template <DepthOrder Order = nearer_is_greater>
struct painter_once : exact_method {
  template <class Faces>
  IRG_APART constexpr void operator()(const Faces& faces, const cell_window& window, image<std::uint32_t>& ids,
                                      draw_counts& counts) const;
};

namespace detail::inline IRG_COMPILED_ABI {

template <DepthOrder Order>
IRG_API void paint_each_once(image<std::uint32_t>& ids, std::vector<screen_face>& list, const cell_window& window,
                             draw_counts& counts);

}  // namespace detail::inline IRG_COMPILED_ABI

template <DepthOrder Order>
template <class Faces>
constexpr void painter_once<Order>::operator()(const Faces& faces, const cell_window& window, image<std::uint32_t>& ids,
                                               draw_counts& counts) const {
  std::vector<screen_face> list = detail::copied_faces<Order>(faces, window);
  detail::paint_each_once<Order>(ids, list, window, counts);
}

}  // namespace irg

#if IRG_BODIES
namespace irg::detail {
inline namespace IRG_ABI {

// Of a list sorted by numbers the face that has this one and covers a pixel: of its parts, which share the number and
// may lie on each other where they are thin, the nearest.
template <DepthOrder Order>
constexpr const screen_face* face_of_number(const std::vector<screen_face>& list, std::uint32_t number, int x, int y) {
  const auto is_before = [](const screen_face& f, std::uint32_t n) { return f.number < n; };
  const screen_face* nearest = nullptr;
  for (auto f = std::lower_bound(list.begin(), list.end(), number, is_before); f != list.end() && f->number == number;
       ++f)
    if (covers(*f, x, y) && (nearest == nullptr || is_nearer<Order>(*f, *nearest, x, y))) nearest = &*f;
  return nearest;
}

}  // namespace IRG_ABI

inline namespace IRG_COMPILED_ABI {

template <DepthOrder Order>
IRG_API void paint_each_once(image<std::uint32_t>& ids, std::vector<screen_face>& list, const cell_window& window,
                             draw_counts& counts) {
  leave_out_repeated<Order>(list);
  const auto by_number = [](const screen_face& a, const screen_face& b) { return a.number < b.number; };
  if (!std::is_sorted(list.begin(), list.end(), by_number)) std::sort(list.begin(), list.end(), by_number);
  for (const screen_face& f : list)
    covered_spans(f.coverage, window, [&](const span_of_cells& s) {
      for (int x = s.x_first; x < s.x_last; ++x) {
        std::uint32_t& id = ids(x, s.y);
        if (const screen_face* other = id == no_index ? nullptr : face_of_number<Order>(list, id, x, s.y)) {
          ++counts.tested;
          if (!is_nearer<Order>(f, *other, x, s.y)) continue;
        }
        id = f.number;
      }
    });
}

}  // namespace IRG_COMPILED_ABI
}  // namespace irg::detail
#endif
