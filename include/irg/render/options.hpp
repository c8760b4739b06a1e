// SPDX-License-Identifier: MIT
// What to draw and how, and what drawing did.
#pragma once

#include <cstdint>

#include <irg/raster/draw_triangle.hpp>
#include <irg/shade/intensity_range.hpp>

namespace irg {

/// What a surface looks like: its edges, one colour per face, colours between the vertices, or light at every pixel.
enum class picture_style { wire, flat, gouraud, phong };

/// How hidden surfaces are removed: by depth at every pixel, or not at all (drawing order).
enum class hidden_surface_method { zbuffer, none };

/// Which faces are left out because of the way they face.
enum class face_culling { back, none };

/// Whether work that cannot change the picture is left out. `off` is for measuring and for tests: the bytes are equal.
enum class skipping { on, off };

/// The skips, each with a switch of its own.
struct skip_options {
  skipping frustum = skipping::on;   // triangles beyond a border of the picture or of the depth range
  skipping tiny = skipping::on;      // triangles that hold no pixel centre
  skipping occluded = skipping::on;  // triangles, and parts of them, behind what is drawn already
  constexpr bool operator==(const skip_options&) const = default;
};

/// Nothing is skipped but what face culling leaves out.
inline constexpr skip_options skip_nothing{skipping::off, skipping::off, skipping::off};

struct render_options {
  picture_style style = picture_style::gouraud;
  hidden_surface_method hidden = hidden_surface_method::zbuffer;
  face_culling culling = face_culling::back;
  skip_options skip{};
  intensity_range intensities = intensity_range::clamp;  // rescale: by the brightest channel of a pixel that is seen
};

/// Triangles that were not rasterized, by reason.
struct skip_counts {
  std::int64_t frustum = 0;   // wholly outside the picture or the depth range
  std::int64_t backface = 0;  // facing away from the eye
  std::int64_t tiny = 0;      // holding no pixel centre
  std::int64_t occluded = 0;  // wholly behind what was already drawn

  IRG_INLINE constexpr skip_counts& operator+=(const skip_counts& o) noexcept {
    frustum += o.frustum;
    backface += o.backface;
    tiny += o.tiny;
    occluded += o.occluded;
    return *this;
  }
  constexpr bool operator==(const skip_counts&) const = default;
};

/// What rendering did. Independent of the executor; pixels.shaded and `drawn` also of `skipping`. What is passed over
/// as occluded is neither tested nor found to tie.
struct render_stats {
  std::int64_t triangles = 0;  // after faces of more corners were cut
  skip_counts skipped;
  draw_counts pixels;
  std::int64_t drawn = 0;  // pixels that show a triangle, or a line of one

  IRG_INLINE constexpr render_stats& operator+=(const render_stats& o) noexcept {
    triangles += o.triangles;
    skipped += o.skipped;
    pixels += o.pixels;
    drawn += o.drawn;
    return *this;
  }
  constexpr bool operator==(const render_stats&) const = default;
};

}  // namespace irg
