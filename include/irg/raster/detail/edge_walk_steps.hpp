// SPDX-License-Identifier: MIT
// The steps of edge_walk.hpp.
#pragma once

#include <bit>
#include <cstdint>

#include <irg/raster/detail/line_frame.hpp>
#include <irg/raster/subpixel.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

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

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
