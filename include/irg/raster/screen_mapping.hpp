// SPDX-License-Identifier: MIT
// From clip space to the screen: the division by w, the picture's place, and snapping to 1/256 pixel, once per vertex.
#pragma once

#include <cstdint>
#include <limits>

#include <irg/core/conversion.hpp>
#include <irg/core/vocabulary.hpp>
#include <irg/geometry/clip_homogeneous.hpp>
#include <irg/math/mat.hpp>
#include <irg/raster/subpixel.hpp>
#include <irg/view/viewport.hpp>

namespace irg {

/// From clip space to the screen: the picture's place and how far beyond it the rasterizer's numbers reach.
template <Floating T>
struct screen_mapping {
  T half_width, half_height, centre_x, centre_y;
  clip_volume<T> picture, guard;
  bool operator==(const screen_mapping&) const = default;
};

/// The planes that a vertex is beyond: the picture's borders with the depth planes, and the same with the sides widened
/// to the guard band. A triangle is cut when one of its vertices is beyond a plane of the second kind.
struct clip_code_pair {
  std::uint8_t outside = 0, cut = 0;

  [[nodiscard]] IRG_INLINE constexpr clip_planes outside_planes() const noexcept {
    return static_cast<clip_planes>(outside);
  }
  [[nodiscard]] IRG_INLINE constexpr clip_planes cut_planes() const noexcept { return static_cast<clip_planes>(cut); }
  bool operator==(const clip_code_pair&) const = default;
};

inline namespace IRG_ABI {

/// The planes that one of two vertices is beyond; the planes that both are.
[[nodiscard]] IRG_INLINE constexpr clip_code_pair operator|(clip_code_pair a, clip_code_pair b) noexcept {
  return {static_cast<std::uint8_t>(a.outside | b.outside), static_cast<std::uint8_t>(a.cut | b.cut)};
}
[[nodiscard]] IRG_INLINE constexpr clip_code_pair operator&(clip_code_pair a, clip_code_pair b) noexcept {
  return {static_cast<std::uint8_t>(a.outside & b.outside), static_cast<std::uint8_t>(a.cut & b.cut)};
}

/// The mapping of clip space onto a picture of this size whose first pixel is (0, 0).
/// needs   1 <= width, height <= 65536
template <Floating T>
[[nodiscard]] constexpr screen_mapping<T> map_to_screen(const extent2& size) noexcept {
  // Up to 2^15 pixels from the picture's centre: coverage of small triangles then fits in 32 bits, and all in 64.
  const T half_width = static_cast<T>(size.width) / T(2), half_height = static_cast<T>(size.height) / T(2);
  const T reach = T(1 << 15);
  return {half_width,  half_height, half_width,
          half_height, {},          {clip_planes::all, reach / half_width, reach / half_height}};
}
template <Floating T>
[[nodiscard, deprecated("irg: map_to_screen({width, height})")]] constexpr screen_mapping<T> map_to_screen(
    int width, int height) noexcept {
  return map_to_screen<T>({width, height});
}

/// Where a clip-space position stands on the screen.
/// needs   a position inside the guard band, w > 0
/// gives   at most 2^126 and at least 2^-126 for 1/w
/// exact   each product, sum and quotient rounded once in T, then snapped; depth and 1/w rounded to float
template <Floating T>
[[nodiscard]] IRG_INLINE constexpr screen_vertex to_screen(const hpoint<T, 3>& p, const screen_mapping<T>& m) noexcept {
  // 1/w overflows for most subnormal w; a power of two brings all coordinates out of there.
  const T up = p.w < (std::numeric_limits<T>::min)() ? T(std::int64_t{1} << 60) : T(1);
  const T inverse = T(1) / (p.w * up);
  const T x = product(product(p.x * up, inverse), m.half_width) + m.centre_x;
  const T y = m.centre_y - product(product(p.y * up, inverse), m.half_height);
  const T most = T(0x1p126) / up;
  return {{snap(x), snap(y)},
          converted<float>(product(p.z * up, inverse)),
          converted<float>(maximum(minimum(inverse, most) * up, T(0x1p-126)))};
}

/// The planes that a clip-space position is beyond; 0, 0, 0, 0, which is no position, counts as cut by the near one.
template <Floating T>
[[nodiscard]] IRG_INLINE constexpr clip_code_pair clip_code(const hpoint<T, 3>& p,
                                                            const screen_mapping<T>& m) noexcept {
  const clip_planes beyond = clip_code(p, m.guard);
  const bool is_no_position = beyond == clip_planes::none && !(T(0) < p.w);
  return {static_cast<std::uint8_t>(clip_code(p, m.picture)),
          static_cast<std::uint8_t>(is_no_position ? clip_planes::z_near : beyond)};
}

/// The old name of clip_code for what a picture shows.
template <class T>
[[nodiscard, deprecated("irg: now clip_code")]] constexpr clip_code_pair classify(const hpoint<T, 3>& p,
                                                                                  const screen_mapping<T>& m) noexcept {
  return clip_code(p, m);
}

}  // namespace IRG_ABI
}  // namespace irg
