// SPDX-License-Identifier: MIT
// A face of the picture: a source triangle, or a piece that clipping left of one, on the screen.
#pragma once

#include <cstdint>

#include <irg/raster/triangle_setup.hpp>

namespace irg {

/// The number of pixels that show no face.
inline constexpr std::uint32_t no_face = 0xffffffff;

/// A face on the screen.
/// shape   `number` is that of its source triangle in the picture: pieces of one triangle share it
struct screen_face {
  screen_vertex v[3];
  std::uint32_t number = 0;
  covered_triangle on_screen;
};

inline namespace IRG_ABI {

/// The face of three vertices, in either winding.
/// needs   positions within snap_limit
IRG_INLINE constexpr screen_face make_screen_face(const screen_vertex& v0, const screen_vertex& v1,
                                                  const screen_vertex& v2, std::uint32_t number) noexcept {
  return {{v0, v1, v2}, number, cover_and_set_up(v0, v1, v2)};
}

}  // namespace IRG_ABI
}  // namespace irg
