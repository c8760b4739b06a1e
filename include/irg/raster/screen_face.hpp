// SPDX-License-Identifier: MIT
// A face on the screen: a source triangle, or a piece of one, after its corners were rounded once. Every hidden-surface
// method draws from these, and the picture is defined by them: a pixel shows the face that covers its centre and is
// nearest there, of equally near ones that of the lowest number (face_order.hpp says what is nearer, exactly).
#pragma once

#include <cstdint>

#include <irg/core/contract.hpp>
#include <irg/core/vocabulary.hpp>
#include <irg/raster/triangle_setup.hpp>

namespace irg {

/// The old name of no_index, which pixels hold that show no face.
[[deprecated("irg: no_index")]] inline constexpr std::uint32_t no_face = no_index;

/// A face on the screen, made by make_screen_face.
/// shape   v in the order of the source, which coverage.edge is not where it is `flipped`; coverage.bounds is the box
///         of pixels; pieces of one source triangle share its number
struct screen_face {
  screen_vertex v[3];
  triangle_coverage coverage;
  float depth_low = 0.0f, depth_high = 0.0f;  // no depth of the face lies outside
  std::uint32_t number = no_index;
  bool operator==(const screen_face&) const = default;
};

inline namespace IRG_ABI {

/// The face with these corners and this number.
/// needs   positions within snap_limit pixels of the origin, finite depths
/// gives   a face that covers nothing where the corners lie on a line: seen edge on, it is hidden
/// exact   nothing is rounded
[[nodiscard]] constexpr screen_face make_screen_face(const screen_vertex& v0, const screen_vertex& v1,
                                                     const screen_vertex& v2, std::uint32_t number) noexcept {
  screen_face f{{v0, v1, v2}, cover_triangle(v0.position, v1.position, v2.position), v0.depth, v0.depth, number};
  for (const screen_vertex& v : f.v) {
    constexpr std::int32_t limit = snap_limit * one_pixel;
    IRG_EXPECTS(v.position.x >= -limit && v.position.x <= limit && v.position.y >= -limit && v.position.y <= limit);
    IRG_EXPECTS(v.depth - v.depth == 0.0f);
    f.depth_low = minimum(f.depth_low, v.depth);
    f.depth_high = maximum(f.depth_high, v.depth);
  }
  return f;
}

/// Whether the face covers pixel (x, y).
/// exact   as covers of its coverage: centres on a top or left edge belong to it
[[nodiscard]] IRG_INLINE constexpr bool covers(const screen_face& f, int x, int y) noexcept {
  return covers(f.coverage, x, y);
}

/// What the face's pixels share: from it depth_at and weights_at give what shade_triangle has at a pixel.
/// gives   zeros for a face without area
[[nodiscard]] IRG_INLINE constexpr triangle_setup set_up_face(const screen_face& f) noexcept {
  if (f.coverage.double_area == 0) return {};
  return set_up_triangle(f.coverage, f.v[0], f.v[1], f.v[2]);
}

/// Which way the face shows itself: front where its corners run counter-clockwise as one sees them, y being up.
/// gives   back for a face without area
[[nodiscard]] IRG_INLINE constexpr facing facing_of(const screen_face& f) noexcept {
  return f.coverage.flipped ? facing::front : facing::back;
}

}  // namespace IRG_ABI
}  // namespace irg
