// SPDX-License-Identifier: MIT
// Which of two faces is nearer at a pixel, exactly, and the face that is seen there. The depth of a face at a pixel's
// centre is that of the plane through its three corners, which are exact numbers: nothing is rounded, so that every
// method that asks here gives the same picture.
#pragma once

#include <cstdint>
#include <span>

#include <irg/raster/depth.hpp>
#include <irg/raster/detail/depth_comparison.hpp>
#include <irg/raster/screen_face.hpp>

namespace irg {

/// A face that covers a pixel, and its depth there as draw_triangle rounds it.
struct face_sample {
  const screen_face& face;
  float depth;
};

namespace detail {

// 1 where the greater depth is the nearer one, -1 where the lesser is, 0 for orders that do not ask for depths.
template <DepthOrder Order>
inline constexpr int depth_sense = Order::nearer(0.0f, 0.0f)   ? 0
                                   : Order::nearer(1.0f, 0.0f) ? 1
                                                               : -1;

inline namespace IRG_ABI {

IRG_INLINE constexpr subpixel centre_of(int x, int y) noexcept {
  return {static_cast<std::int32_t>(std::int64_t{x} * one_pixel + half_pixel),
          static_cast<std::int32_t>(std::int64_t{y} * one_pixel + half_pixel)};
}

// Whether two depths that were rounded at a covered centre are in the order of the true ones.
//
// With u = 2^-24 and depths that are not negative, all terms of the rounded depth are positive and pass at most 8
// roundings (two of the scale, one of a rest or an edge function, two products, three sums), so both depths together
// are off by less than 16u(1 + 2^-16) of the greater one: 2^-20 of it, and the bound is a quarter more. That quarter
// is at least 2^-62 and covers what subnormal numbers lose, and processors that take them for zero: up to 2^-126 in
// each product of an edge function, below 2^53, and a gain, less than 2^-72 in all. A gain overflows only where twice
// the area is below 256: then edge functions are 0 in whole pixels, and the depth is NaN, which decides nothing.
IRG_INLINE constexpr bool rounded_depths_decide(const face_sample& a, const face_sample& b) noexcept {
  constexpr float factor = 0x1.4p-20f, least = 0x1p-40f;
  if (!(lesser(a.face.depth_low, b.face.depth_low) >= 0.0f)) return false;
  const float difference = a.depth - b.depth, largest = greater(a.depth, b.depth);
  return largest >= least && greater(difference, -difference) > largest * factor;
}

template <DepthOrder Order>
IRG_INLINE constexpr bool comes_first(int nearness, const screen_face& a, const screen_face& b) noexcept {
  if constexpr (depth_sense<Order> == 0)
    return b.number < a.number;
  else
    return nearness != 0 ? nearness > 0 : a.number < b.number;
}

// 1 where a is nearer at the centre of a pixel, -1 where b is, 0 where they are equally near.
template <DepthOrder Order>
IRG_INLINE constexpr int compare_planes(const screen_face& a, const screen_face& b, int x, int y) noexcept {
  if constexpr (depth_sense<Order> == 0) {
    return 0;
  } else {
    IRG_EXPECTS(-snap_limit <= x && x < snap_limit && -snap_limit <= y && y < snap_limit);
    if (a.coverage.double_area == 0 || b.coverage.double_area == 0) return 0;
    const subpixel centre = centre_of(x, y);
    return depth_sense<Order> * compare_depths_at(plane_at(a, centre), plane_at(b, centre));
  }
}
// The same, apart from code that seldom needs it.
template <DepthOrder Order>
IRG_NOINLINE constexpr int compare_close_planes(const screen_face& a, const screen_face& b, int x, int y) noexcept {
  return compare_planes<Order>(a, b, x, y);
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// 1 when face a is nearer than face b at the centre of pixel (x, y), -1 when b is, 0 where they are equally near.
/// shape   each is taken as its whole plane: neither needs to cover the pixel
/// needs   -snap_limit <= x, y < snap_limit
/// gives   0 where a face has no area, and for drawing_order, which knows no depths
/// exact   for all positions and finite depths, of any sign and size, subnormal ones included, under all floating-point
///         flags and with subnormals flushed to zero; depths that are not finite give some order
/// cost    about 40 operations on doubles where the planes are not nearly as deep as each other, else integers of 192
///         bits, and of 448 where depths differ by more than 2^37
template <DepthOrder Order = nearer_is_greater>
[[nodiscard]] IRG_INLINE constexpr int compare_depths(const screen_face& a, const screen_face& b, int x,
                                                      int y) noexcept {
  return detail::compare_planes<Order>(a, b, x, y);
}

/// The same of two faces that cover the pixel and whose rounded depths are at hand: these decide unless they are close.
/// needs   depths by draw_triangle, or any within 8 roundings of floats
/// exact   as above
/// cost    five comparisons of floats where depths are not negative and differ by more than 2^-20 of the greater one
template <DepthOrder Order = nearer_is_greater>
[[nodiscard]] IRG_INLINE constexpr int compare_depths(const face_sample& a, const face_sample& b, int x,
                                                      int y) noexcept {
  if (!detail::rounded_depths_decide(a, b)) return detail::compare_close_planes<Order>(a.face, b.face, x, y);
  return detail::depth_sense<Order> * (b.depth < a.depth ? 1 : -1);
}

/// Whether face a is seen before face b at pixel (x, y), where both cover it: it is nearer, or as near and of the lower
/// number. For drawing_order: it is drawn later, its number being higher.
/// shape   as compare_depths, whose cost and exactness it has; one of two faces with different numbers is always first
template <DepthOrder Order = nearer_is_greater>
[[nodiscard]] IRG_INLINE constexpr bool is_nearer(const screen_face& a, const screen_face& b, int x, int y) noexcept {
  return detail::comes_first<Order>(compare_depths<Order>(a, b, x, y), a, b);
}
template <DepthOrder Order = nearer_is_greater>
[[nodiscard]] IRG_INLINE constexpr bool is_nearer(const face_sample& a, const face_sample& b, int x, int y) noexcept {
  if (detail::depth_sense<Order> == 0 || !detail::rounded_depths_decide(a, b))
    return detail::comes_first<Order>(detail::compare_close_planes<Order>(a.face, b.face, x, y), a.face, b.face);
  return Order::nearer(a.depth, b.depth);
}

/// 1 when a corner lies in front of the plane of a face, nearer than it; -1 when behind, 0 in the plane.
/// needs   the corner's position within snap_limit pixels of the origin
/// gives   0 for a face without area, and for drawing_order
/// exact   as compare_depths; it is the sign of orient3d of the corners (x, y, depth)
template <DepthOrder Order = nearer_is_greater>
[[nodiscard]] IRG_INLINE constexpr int side_of_face(const screen_face& plane, const screen_vertex& corner) noexcept {
  if (plane.coverage.double_area == 0) return 0;
  const detail::plane_depth_at here{{1, 0, 0}, 1, {corner.depth, 0.0f, 0.0f}};
  return detail::depth_sense<Order> * detail::compare_depths_at(here, detail::plane_at(plane, corner.position));
}

/// The number of the face that is seen in pixel (x, y): of those that cover its centre the one that is_nearer.
/// gives   no_face where none covers it
/// exact   this is the definition of the picture that every hidden-surface method draws
/// cost    every face is asked: for tests of methods that ask fewer
template <DepthOrder Order = nearer_is_greater>
[[nodiscard]] constexpr std::uint32_t picture_face_at(std::span<const screen_face> faces, int x, int y) noexcept {
  const screen_face* first = nullptr;
  for (const screen_face& f : faces)
    if (covers(f, x, y) && (first == nullptr || is_nearer<Order>(f, *first, x, y))) first = &f;
  return first == nullptr ? no_face : first->number;
}

}  // namespace IRG_ABI
}  // namespace irg
