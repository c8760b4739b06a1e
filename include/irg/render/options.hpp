// SPDX-License-Identifier: MIT
// What to draw and how.
#pragma once

#include <irg/colour/pixel.hpp>
#include <irg/core/vocabulary.hpp>
#include <irg/raster/draw_counts.hpp>
#include <irg/shade/intensity_range.hpp>

namespace irg {

/// What a surface looks like: its edges, one colour per face, colours between the vertices, or light at every pixel.
enum class picture_style { wire, flat, gouraud, phong };

/// How hidden surfaces are removed: by depth at every pixel, or not at all (drawing order).
enum class hidden_surface_method { zbuffer, none };

/// The colours of a picture that do not come from its scene.
struct picture_colours {
  rgba8 background{250, 249, 246, 255};
  rgba8 line{32, 44, 66, 255};
  bool operator==(const picture_colours&) const = default;
};

struct render_options {
  picture_style style = picture_style::gouraud;
  hidden_surface_method hidden = hidden_surface_method::zbuffer;
  face_culling culling = face_culling::back;
  skip_options skip{};
  intensity_range intensities = intensity_range::clamp;  // rescale: by the brightest channel of a pixel that is seen
  picture_colours colours{};
  bool operator==(const render_options&) const = default;
};

}  // namespace irg
