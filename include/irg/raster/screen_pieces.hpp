// SPDX-License-Identifier: MIT
// From clip space to faces on the screen: a triangle behind the eye or beyond the rasterizer's numbers in part is cut,
// in the one way that all who draw it share, and each corner of what is left is projected and rounded once.
#pragma once

#include <cstdint>

#include <irg/geometry/clip_homogeneous.hpp>
#include <irg/raster/piece_weights.hpp>
#include <irg/raster/screen_face.hpp>
#include <irg/raster/screen_mapping.hpp>

namespace irg {

/// A part of a source triangle, on the screen under the triangle's number.
struct screen_piece {
  screen_face face;
  piece_weights weights;
  bool operator==(const screen_piece&) const = default;
};

/// What clipping leaves of a triangle on the screen.
/// shape   size() pieces, a fan about its first corner, all with the winding of `double_area`, which is that of the
///         whole: positive where corners run clockwise as seen with y down. A piece may have no area. Those of a
///         triangle thinner than 1/256 pixel may lie on each other in part, where snapping turned one round
struct screen_pieces {
  screen_piece piece[7]{};
  int count = 0;
  std::int64_t double_area = 0;
  bool outside = false;  // nothing is left: not even a part without area

  [[nodiscard]] IRG_INLINE constexpr std::size_t size() const noexcept { return static_cast<std::size_t>(count); }
  IRG_INLINE constexpr const screen_piece& operator[](std::size_t i) const noexcept { return piece[i]; }
  [[nodiscard]] IRG_INLINE constexpr const screen_piece* begin() const noexcept { return piece; }
  [[nodiscard]] IRG_INLINE constexpr const screen_piece* end() const noexcept { return piece + count; }
  IRG_APART constexpr bool operator==(const screen_pieces& o) const noexcept {
    for (int i = 0; i < count && count == o.count; ++i)
      if (!(piece[i] == o.piece[i])) return false;
    return count == o.count && double_area == o.double_area && outside == o.outside;
  }
};

inline namespace IRG_ABI {

/// The faces that a triangle in clip space comes to on the screen, all under its number: itself where no corner is
/// beyond the depth planes or the guard band, else the pieces that are left of it.
/// shape   corners as a projection matrix gives them, in either winding, which is kept; 0 <= z <= w is in front
/// gives   nothing where nothing is left, where the whole has no area once it is snapped, and where a corner is not
///         finite, larger than clip_homogeneous takes, or 0, 0, 0, 0
/// exact   coordinates as clip_homogeneous and to_screen round them: the faces that render draws, bit for bit.
///         Triangles that share an edge get the same corners on it
/// cost    that of clip_homogeneous, and a division for each corner left
template <Floating T>
[[nodiscard]] constexpr screen_pieces clip_to_screen(const hpoint<T, 3> (&corner)[3], const screen_mapping<T>& mapping,
                                                     std::uint32_t number) noexcept {
  screen_pieces pieces;
  const clip_vertex<T, 2> polygon[3] = {
      {corner[0], {T(0), T(0)}}, {corner[1], {T(1), T(0)}}, {corner[2], {T(0), T(1)}}};
  const auto left = clip_homogeneous(polygon, mapping.guard);
  pieces.outside = left.empty();

  screen_vertex on_screen[9]{};
  source_weights share[9]{};
  for (std::size_t k = 0; k < left.size(); ++k) {
    on_screen[k] = to_screen(left[k].position, mapping);
    share[k] = {converted<float>(left[k].attributes[0]), converted<float>(left[k].attributes[1])};
  }
  const auto area_of = [&](std::size_t k) {
    return twice_signed_area(on_screen[0].position, on_screen[k].position, on_screen[k + 1].position);
  };
  for (std::size_t k = 1; k + 1 < left.size(); ++k) pieces.double_area += area_of(k);
  for (std::size_t k = 1; k + 1 < left.size() && pieces.double_area != 0; ++k) {
    // Snapping may turn round a piece thinner than 1/256 pixel; the pieces beside it cover its place.
    if (area_of(k) != 0 && (area_of(k) > 0) != (pieces.double_area > 0)) continue;
    pieces.piece[pieces.count++] = {make_screen_face(on_screen[0], on_screen[k], on_screen[k + 1], number),
                                    {{share[0], share[k], share[k + 1]}}};
  }
  return pieces;
}

}  // namespace IRG_ABI
}  // namespace irg
