// SPDX-License-Identifier: MIT
// A vertex on the screen.
#pragma once

#include <irg/raster/subpixel.hpp>

namespace irg {

/// A vertex on the screen: where it was snapped to, its depth, and one over its weight (1 for an affine picture).
struct screen_vertex {
  subpixel position;
  float depth = 0.0f;
  float inverse_w = 1.0f;
};

}  // namespace irg
