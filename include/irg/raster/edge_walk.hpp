// SPDX-License-Identifier: MIT
// One edge of a polygon, walked row by row. In each row whose centre line it crosses it names the first column whose
// centre is on or right of it. A span that begins at one edge's column and ends before another's then has the centres
// on its left edge and not those on its right one: the top-left rule.
//
// With the edge from (ax, ay) down to (bx, by), dx = bx - ax, dy = by - ay, in 1/256 pixel, that column is
//     ceil((ax - 128 + (256*row + 128 - ay) * dx / dy) / 256)
// Whole columns are stepped with their exact remainder, as in Bresenham's line; so an edge may be entered in any row.
#pragma once

#include <bit>
#include <cstdint>

#include <irg/raster/detail/line_frame.hpp>
#include <irg/raster/subpixel.hpp>

namespace irg {

/// Polygons reach this many pixels from the origin at most.
inline constexpr std::int64_t far_limit = std::int64_t{1} << 31;

/// A position in 1/256 pixel that may lie beyond the reach of `subpixel`: up to far_limit pixels from the origin.
struct far_subpixel {
  std::int64_t x = 0, y = 0;
  bool operator==(const far_subpixel&) const = default;
};

/// An edge in one row; next() leads to the row below. J is std::int32_t for subpixel, std::int64_t for far_subpixel.
template <class J>
struct edge_walk {
  J column = 0;  // the first column whose centre is on or right of the edge
  J rest = -1;  // -height <= rest < 0
  J step = 0, rest_step = 0, height = 1;

  /// needs   no more than one call beyond the edge's last row
  IRG_INLINE constexpr void next() noexcept {
    column += step;
    rest += rest_step;
    const bool carry = rest >= 0;
    column += carry ? 1 : 0;
    rest -= carry ? height : 0;
  }
};

/// The rows first to last - 1.
struct row_range {
  std::int64_t first = 0, last = 0;
  bool operator==(const row_range&) const = default;
};

inline namespace IRG_ABI {

/// The rows whose centre line the edge crosses; none for a level one.
/// needs   upper.y <= lower.y
template <class V>
[[nodiscard]] IRG_INLINE constexpr row_range rows_of_edge(const V& upper, const V& lower) noexcept;

/// The edge as it stands in a row.
/// needs   a row of rows_of_edge(upper, lower); coordinates within snap_limit pixels of the origin
/// exact   every column
/// cost    one division
[[nodiscard]] IRG_INLINE constexpr edge_walk<std::int32_t> walk_edge(const subpixel& upper, const subpixel& lower,
                                                                     std::int64_t row) noexcept;

/// The same for an edge that may reach far.
/// needs   a row of rows_of_edge(upper, lower); coordinates within far_limit pixels of the origin
/// cost    two divisions of 128 bits
[[nodiscard]] constexpr edge_walk<std::int64_t> walk_edge(const far_subpixel& upper, const far_subpixel& lower,
                                                          std::int64_t row) noexcept;

}  // namespace IRG_ABI

namespace detail::inline IRG_ABI {

// The first row whose centre line is at or below y: an edge crosses the rows from the one of its upper end up to,
// without it, the one of its lower end.
IRG_INLINE constexpr std::int64_t row_from(std::int64_t y) noexcept { return (y + half_pixel - 1) >> subpixel_bits; }

struct quotient_and_rest {
  std::int64_t quotient, rest;
};

// n / d rounded down, by way of 1/d in double. Exact for |n| < 2^53, 0 < d < 2^31 and |n / d| < 2^50: the estimate is
// off by less than 1/2, so the integer nearest to it is the quotient or the next one; the rest says which.
IRG_INLINE constexpr quotient_and_rest divide_down(std::int64_t n, std::int64_t d, double reciprocal) noexcept {
  constexpr double to_integer = 0x1.8p52;  // the sum's low bits are the nearest integer
  std::int64_t q = std::bit_cast<std::int64_t>(static_cast<double>(n) * reciprocal + to_integer) -
                   std::bit_cast<std::int64_t>(to_integer);
  std::int64_t r = n - q * d;
  const bool too_great = r < 0;
  q -= too_great ? 1 : 0;
  r += too_great ? d : 0;
  return {q, r};
}

// n / d rounded down; d > 0, and the quotient fits.
constexpr quotient_and_rest divide_down(int128 n, std::int64_t d) noexcept {
  std::int64_t q = static_cast<std::int64_t>(n / d), r = static_cast<std::int64_t>(n % d);
  if (r < 0) {
    --q;
    r += d;
  }
  return {q, r};
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

template <class V>
[[nodiscard]] IRG_INLINE constexpr row_range rows_of_edge(const V& upper, const V& lower) noexcept {
  return {detail::row_from(upper.y), detail::row_from(lower.y)};
}

[[nodiscard]] IRG_INLINE constexpr edge_walk<std::int32_t> walk_edge(const subpixel& upper, const subpixel& lower,
                                                                     std::int64_t row) noexcept {
  const std::int64_t dx = std::int64_t{lower.x} - upper.x, dy = std::int64_t{lower.y} - upper.y;
  const std::int64_t below = row * one_pixel + half_pixel - upper.y;
  // ceil(n / (256 * dy)) = floor(floor((n - 1) / 256) / dy) + 1
  const std::int64_t n = ((std::int64_t{upper.x} - half_pixel) * dy + below * dx - 1) >> subpixel_bits;
  const double reciprocal = 1.0 / static_cast<double>(dy);
  const detail::quotient_and_rest start = detail::divide_down(n, dy, reciprocal),
                                  slope = detail::divide_down(dx, dy, reciprocal);
  return {static_cast<std::int32_t>(start.quotient + 1), static_cast<std::int32_t>(start.rest - dy),
          static_cast<std::int32_t>(slope.quotient), static_cast<std::int32_t>(slope.rest),
          static_cast<std::int32_t>(dy)};
}

[[nodiscard]] constexpr edge_walk<std::int64_t> walk_edge(const far_subpixel& upper, const far_subpixel& lower,
                                                          std::int64_t row) noexcept {
  const std::int64_t dx = lower.x - upper.x, dy = lower.y - upper.y;
  const std::int64_t below = row * one_pixel + half_pixel - upper.y;
  const int128 n = (int128{upper.x - half_pixel} * dy + int128{below} * dx - 1) >> subpixel_bits;
  const detail::quotient_and_rest start = detail::divide_down(n, dy), slope = detail::divide_down(int128{dx}, dy);
  return {start.quotient + 1, start.rest - dy, slope.quotient, slope.rest, dy};
}

}  // namespace IRG_ABI
}  // namespace irg
