// SPDX-License-Identifier: MIT
// Scenes by rays.
#pragma once

#include <irg/render/render_traced.hpp>

#include "../../examples/support/ray_scenes.hpp"
#include "sketch.hpp"

namespace ray_pictures {

using sketching::picture;

inline picture drawn(const program::ray_scene& s, int width, int height) {
  picture p(width, height);
  irg::traced_options<double> options;
  options.samples = 3;
  irg::render_traced<double>(s.world, s.optics, p, options);
  return p;
}

inline picture shadow() { return drawn(program::shadow_scene(), 400, 250); }
inline picture glass() { return drawn(program::glass_scene(), 400, 250); }

}  // namespace ray_pictures
