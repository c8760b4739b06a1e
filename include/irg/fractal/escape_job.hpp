// SPDX-License-Identifier: MIT
// What a picture of escape counts is made of, what may be skipped, and what was.
#pragma once

#include <cstdint>

#include <irg/fractal/complex_plane.hpp>
#include <irg/fractal/escape_time.hpp>
#include <irg/raster/draw_counts.hpp>

namespace irg {

/// What may be left out because its count is known. Counts do not change.
struct escape_skips {
  skipping interior = skipping::on;  // points of the cardioid and the disc of period 2
  skipping cycles = skipping::on;    // orbits that come back to a point where they were before
  skipping squares = skipping::on;   // squares of pixels that one orbit of discs shows to have one count
  constexpr bool operator==(const escape_skips&) const = default;
};

/// What was left out. Independent of the executor; cycles depend on the lanes that compute side by side.
struct escape_stats {
  std::int64_t pixels = 0;    // all
  std::int64_t interior = 0;  // without an orbit
  std::int64_t cycles = 0;    // whose orbit was cut short
  std::int64_t squares = 0;   // in squares of one count, without orbits of their own

  IRG_INLINE constexpr escape_stats& operator+=(const escape_stats& o) noexcept {
    pixels += o.pixels;
    interior += o.interior;
    cycles += o.cycles;
    squares += o.squares;
    return *this;
  }
  constexpr bool operator==(const escape_stats&) const = default;
};

/// The counts of a picture: how its orbits begin and end.
template <Floating T>
struct escape_job {
  complex_plane<T> plane{};
  escape_limit<T> limit{};
  escape_skips skip{};
};

}  // namespace irg
