// SPDX-License-Identifier: MIT
// Positions on the screen as integers: 1/256 of a pixel. Snapping rounds a vertex once; from then on coverage is
// decided without any rounding.
#pragma once

#include <concepts>
#include <cstdint>

#include <irg/core/contract.hpp>
#include <irg/core/coordinates.hpp>
#include <irg/core/ring.hpp>
#include <irg/core/sinks.hpp>
#include <irg/math/vec.hpp>

namespace irg {

/// Bits behind the binary point of a snapped coordinate.
inline constexpr int subpixel_bits = 8;
/// One pixel in snapped units; pixel x spans [x * one_pixel, (x + 1) * one_pixel], its centre is half_pixel further.
inline constexpr std::int32_t one_pixel = 1 << subpixel_bits;
inline constexpr std::int32_t half_pixel = one_pixel / 2;
/// Snapped coordinates stay within this many pixels of the origin, so that edge functions fit in 64 bits.
inline constexpr std::int32_t snap_limit = 1 << 21;

/// A position on the screen in 1/256 pixel, x to the right, y down.
struct subpixel {
  std::int32_t x = 0, y = 0;
  bool operator==(const subpixel&) const = default;
};

/// A vertex on the screen: where it was snapped to, its depth, and one over its weight (1 for an affine picture).
struct screen_vertex {
  subpixel position;
  float depth = 0.0f;
  float inverse_w = 1.0f;
  bool operator==(const screen_vertex&) const = default;
};

/// Points of ints that name a cell without being one: glm::ivec2, cv::Point, std::array<int, 2>, structs of x and y.
template <class P>
concept CellPosition = Point<P> && size_of<P> == 2 && std::same_as<scalar_of<P>, int> && !std::same_as<P, cell> &&
                       !std::same_as<P, subpixel>;

/// A cell, or what names one.
template <class P>
concept CellOrPosition = std::same_as<P, cell> || CellPosition<P>;

// What can be filled. Which side is inside is said by fill_rule, of core/ring.hpp.

/// A ring that can be filled: of snapped positions, or of points of two float or double coordinates, in pixels.
template <class R>
concept FillableRing =
    PolygonRing<R> && (std::same_as<ring_point<R>, subpixel> || (PlaneRing<R> && Floating<ring_scalar<R>>));

/// One ring that can be filled, or any number of them.
template <class P>
concept FillablePolygon = FillableRing<P> || (RingSequence<P> && FillableRing<ring_in<P>>);

inline namespace IRG_ABI {

/// The cell that a point of ints names.
template <CellPosition P>
[[nodiscard]] IRG_INLINE constexpr cell as_cell(const P& p) noexcept {
  return {coordinate(p, 0), coordinate(p, 1)};
}
[[nodiscard]] IRG_INLINE constexpr cell as_cell(cell c) noexcept { return c; }

/// Whether v, in pixels, can be snapped: |v| <= snap_limit. False for NaN.
template <Floating T>
[[nodiscard]] IRG_INLINE constexpr bool can_snap(T v) noexcept {
  return v >= T(-snap_limit) && v <= T(snap_limit);
}

/// The multiple of 1/256 nearest to v, the greater one on a tie, in 1/256.
/// units   v in pixels
/// needs   can_snap(v)
/// exact   for every float and double
template <Floating T>
[[nodiscard]] IRG_INLINE constexpr std::int32_t snap(T v) noexcept {
  IRG_EXPECTS(can_snap(v));
  // Scaling by a power of two is exact, and so is the fraction; adding 1/2 before rounding down might not be.
  const T scaled = v * T(one_pixel);
  const auto toward_zero = static_cast<std::int32_t>(scaled);
  const T rest = scaled - static_cast<T>(toward_zero);  // in (-1, 1)
  return toward_zero + (rest >= T(0.5) ? 1 : rest < T(-0.5) ? -1 : 0);
}

/// Whether a position can be snapped: whether it, of a cell its centre, lies within snap_limit pixels of the origin on
/// both axes.
[[nodiscard]] IRG_INLINE constexpr bool can_snap(const subpixel& p) noexcept {
  constexpr std::int32_t limit = snap_limit * one_pixel;
  return p.x >= -limit && p.x <= limit && p.y >= -limit && p.y <= limit;
}
template <CellOrPosition P>
[[nodiscard]] IRG_INLINE constexpr bool can_snap(const P& p) noexcept {
  const cell c = as_cell(p);
  return c.x >= -snap_limit && c.x < snap_limit && c.y >= -snap_limit && c.y < snap_limit;
}
template <Point P>
  requires(size_of<P> == 2 && Floating<scalar_of<P>>)
[[nodiscard]] IRG_INLINE constexpr bool can_snap(const P& p) noexcept {
  return can_snap(coordinate(p, 0)) && can_snap(coordinate(p, 1));
}

/// The snapped position of a point given in pixels; of a cell its centre; a snapped position as it is.
/// needs   can_snap(p)
[[nodiscard]] IRG_INLINE constexpr subpixel snap(const subpixel& p) noexcept { return p; }
template <CellOrPosition P>
[[nodiscard]] IRG_INLINE constexpr subpixel snap(const P& p) noexcept {
  const cell c = as_cell(p);
  return {c.x * one_pixel + half_pixel, c.y * one_pixel + half_pixel};
}
template <Point P>
  requires(size_of<P> == 2 && Floating<scalar_of<P>>)
[[nodiscard]] IRG_INLINE constexpr subpixel snap(const P& p) noexcept {
  return {snap(coordinate(p, 0)), snap(coordinate(p, 1))};
}

}  // namespace IRG_ABI

/// Where a line may begin or end: at the centre of a cell, or of one that ints name, between pixels in 1/256 pixel, or
/// at a point in pixels.
template <class P>
concept ScreenPosition = requires(const P& p) {
  { can_snap(p) } -> std::same_as<bool>;
  { snap(p) } -> std::same_as<subpixel>;
};

}  // namespace irg
