// SPDX-License-Identifier: MIT
// Ray casting: through the centre of every pixel a ray, and of all faces that it meets the nearest one. It is the
// definition of the picture, carried out; the other methods give the same and do less.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include <irg/raster/draw_counts.hpp>
#include <irg/raster/face_order.hpp>
#include <irg/raster/image.hpp>

namespace irg {

/// What hidden-surface methods have in common whose picture is the exact one.
struct exact_method {
  [[nodiscard]] IRG_APART static constexpr bool finds_nearest() noexcept { return true; }
};

/// A hidden-surface method: each pixel asks each face.
/// shape   ray_casting<>{}(faces, window, ids, counts): faces a container of screen_face, ids a raster that holds the
///         window; counts.tested counts the faces that rays meet, counts.ties the equal depths among them
/// gives   the number of the nearest face into the pixels that some face covers; the others stay as they are
/// exact   as picture_face_at, in every pixel
/// cost    pixels times faces; memory for a copy of the faces, none for depths
/// source  Appel 1968
template <DepthOrder Order = nearer_is_greater>
struct ray_casting : exact_method {
  template <class Faces>
  IRG_APART constexpr void operator()(const Faces& faces, const cell_window& window, image<std::uint32_t>& ids,
                                      draw_counts& counts) const;
};

namespace detail::inline IRG_ABI {

// Whether methods can be had for an order of depths: where they were compiled before, for irg's own.
template <class Order>
inline constexpr bool has_methods = IRG_BODIES != 0 || std::is_same_v<Order, nearer_is_greater> ||
                                    std::is_same_v<Order, nearer_is_less> || std::is_same_v<Order, drawing_order>;

// The faces with an area that touch a window, side by side.
template <DepthOrder Order, class Faces>
constexpr std::vector<screen_face> copied_faces(const Faces& faces, const cell_window& window) {
  static_assert(has_methods<Order>,
                "irg: define IRG_HEADER_ONLY before the first header of irg to draw faces in an order of your own");
  std::vector<screen_face> list;
  list.reserve(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const screen_face f = faces[i];
    if (f.coverage.double_area != 0 && !intersect(f.coverage.bounds, window).empty()) list.push_back(f);
  }
  return list;
}

}  // namespace detail::inline IRG_ABI

namespace detail::inline IRG_COMPILED_ABI {

// Methods take lists that copied_faces has made, from which they may leave out what is not seen.
template <DepthOrder Order>
IRG_API void cast_rays(image<std::uint32_t>& ids, std::vector<screen_face>& list, const cell_window& window,
                       draw_counts& counts);

}  // namespace detail::inline IRG_COMPILED_ABI

template <DepthOrder Order>
template <class Faces>
constexpr void ray_casting<Order>::operator()(const Faces& faces, const cell_window& window, image<std::uint32_t>& ids,
                                              draw_counts& counts) const {
  std::vector<screen_face> list = detail::copied_faces<Order>(faces, window);
  detail::cast_rays<Order>(ids, list, window, counts);
}

}  // namespace irg

#if IRG_BODIES
namespace irg::detail {
inline namespace IRG_ABI {

// Of equal faces, whose corners are the same bits in the same order, the one of the lowest number, or the highest in
// drawing order: the others are never seen.
template <DepthOrder Order, class Face>
constexpr void leave_out_equal_faces(std::vector<Face>& list) {
  const auto bits_of = [](float depth) { return std::bit_cast<std::uint32_t>(depth); };
  const auto is_same = [&](const Face& a, const Face& b) {
    for (int i = 0; i < 3; ++i)
      if (a.v[i].position != b.v[i].position || bits_of(a.v[i].depth) != bits_of(b.v[i].depth)) return false;
    return true;
  };
  const auto hash_of = [&](const Face& f) {
    std::uint64_t h = 0;
    for (const screen_vertex& v : f.v) {
      h = (h ^ static_cast<std::uint32_t>(v.position.x)) * 0x9e3779b97f4a7c15u;
      h = (h ^ (h >> 32) ^ static_cast<std::uint32_t>(v.position.y)) * 0xd1b54a32d192ed03u;
      h = (h ^ (h >> 29) ^ bits_of(v.depth)) * 0x9e3779b97f4a7c15u;
      h ^= h >> 32;
    }
    return h;
  };
  // The places in the list of those met before, open addressing.
  std::vector<std::uint32_t> met(std::bit_ceil(2 * list.size()), no_index);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    std::size_t at = hash_of(list[i]) & (met.size() - 1);
    while (met[at] != no_index && !is_same(list[met[at]], list[i])) at = (at + 1) & (met.size() - 1);
    if (met[at] != no_index) {
      Face& first = list[met[at]];
      if (wins_tie<Order>(list[i], first)) first.number = list[i].number;
      continue;
    }
    met[at] = static_cast<std::uint32_t>(kept);
    if (kept != i) list[kept] = list[i];
    ++kept;
  }
  list.resize(kept, Face{});
}

// Looks for equal faces where a list is so long that it takes little beside the rest.
template <DepthOrder Order>
constexpr void leave_out_repeated(std::vector<screen_face>& list) {
  constexpr std::size_t many = 10000;
  if (list.size() > many) leave_out_equal_faces<Order>(list);
}

}  // namespace IRG_ABI

inline namespace IRG_COMPILED_ABI {

template <DepthOrder Order>
IRG_API void cast_rays(image<std::uint32_t>& ids, std::vector<screen_face>& list, const cell_window& window,
                       draw_counts& counts) {
  leave_out_repeated<Order>(list);
  for (int y = window.y_first; y < window.y_last; ++y)
    for (int x = window.x_first; x < window.x_last; ++x) {
      const screen_face* nearest = nullptr;
      for (const screen_face& f : list) {
        if (!covers(f, x, y)) continue;
        ++counts.tested;
        if (nearest != nullptr && compare_depths<Order>(f, *nearest, x, y) == 0) ++counts.ties;
        if (nearest == nullptr || is_nearer<Order>(f, *nearest, x, y)) nearest = &f;
      }
      if (nearest != nullptr) ids(x, y) = nearest->number;
    }
}

}  // namespace IRG_COMPILED_ABI
}  // namespace irg::detail
#endif
