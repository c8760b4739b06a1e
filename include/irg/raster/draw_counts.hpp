// SPDX-License-Identifier: MIT
// What drawing did, and what it left out.
#pragma once

#include <cstdint>

#include <irg/core/config.hpp>

namespace irg {

/// What drawing did. Sums over triangles and windows; independent of lanes and threads.
struct draw_counts {
  std::int64_t tested = 0;  // covered pixels, each a depth test
  std::int64_t shaded = 0;  // of these, nearer than what was there: written
  std::int64_t ties = 0;    // of these, exactly as far as what was there: kept as it was
  std::int64_t convex = 0;  // faces that no method was asked about, a convex body being alone in a window

  IRG_INLINE constexpr draw_counts& operator+=(const draw_counts& o) noexcept {
    tested += o.tested;
    shaded += o.shaded;
    ties += o.ties;
    convex += o.convex;
    return *this;
  }
  bool operator==(const draw_counts&) const = default;
};

/// Whether work that cannot change the picture is left out. `off` is for measuring and for tests: the bytes are equal.
enum class skipping { on, off };

/// The skips, each with a switch of its own.
struct skip_options {
  skipping frustum = skipping::on;   // triangles beyond a border of the picture or of the depth range
  skipping tiny = skipping::on;      // triangles that hold no pixel centre
  skipping occluded = skipping::on;  // triangles, and parts of them, behind what is drawn already
  skipping rooms = skipping::on;     // rooms of a building that no portal shows
  skipping convex = skipping::on;    // hidden-surface methods where a convex body is alone
  bool operator==(const skip_options&) const = default;
};

/// Nothing is skipped but what face culling leaves out.
inline constexpr skip_options skip_nothing{skipping::off, skipping::off, skipping::off, skipping::off, skipping::off};

/// Triangles that were not rasterized, by reason.
struct skip_counts {
  std::int64_t frustum = 0;   // wholly outside the picture or the depth range
  std::int64_t backface = 0;  // facing away from the eye
  std::int64_t tiny = 0;      // holding no pixel centre
  std::int64_t occluded = 0;  // wholly behind what was already drawn
  std::int64_t rooms = 0;     // in rooms that no portal shows

  IRG_INLINE constexpr skip_counts& operator+=(const skip_counts& o) noexcept {
    frustum += o.frustum;
    backface += o.backface;
    tiny += o.tiny;
    occluded += o.occluded;
    rooms += o.rooms;
    return *this;
  }
  bool operator==(const skip_counts&) const = default;
};

/// What rendering did. Independent of the executor; pixels.shaded and `drawn` also of `skipping`. What is passed over
/// as occluded is neither tested nor found to tie.
struct render_counts {
  std::int64_t triangles = 0;  // after faces of more corners were cut
  skip_counts skipped;
  draw_counts pixels;
  std::int64_t drawn = 0;  // pixels that show a triangle, or a line of one
  std::int64_t clipped = 0;  // triangles cut at the depth planes or the guard band, whose rest holds pixel centres

  IRG_INLINE constexpr render_counts& operator+=(const render_counts& o) noexcept {
    triangles += o.triangles;
    skipped += o.skipped;
    pixels += o.pixels;
    drawn += o.drawn;
    clipped += o.clipped;
    return *this;
  }
  bool operator==(const render_counts&) const = default;
};

}  // namespace irg
