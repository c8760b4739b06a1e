// SPDX-License-Identifier: MIT
// The Mandelbrot set and a Julia set by their counts. Included by pictures.cpp.
#pragma once

#include <irg/fractal/escape_colour.hpp>
#include <irg/fractal/escape_picture.hpp>

#include "enlarged.hpp"

namespace escape_pictures {

using enlarging::picture;

inline picture both() {
  constexpr int width = 360, height = 288, most = 200;
  irg::escape_job<double> job{{{-2.2, 0.8, -1.2, 1.2}, width, height}, irg::make_escape_limit(2.0, most), {}};
  irg::image<int> set(width, height), julia(width, height);
  irg::draw_mandelbrot(set, job);
  job.plane.window = {-1.6, 1.6, -1.28, 1.28};
  irg::draw_julia(julia, job, {-0.8, 0.156});
  picture p(2 * width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      p(x, y) = irg::escape_colour(set(x, y), most);
      p(width + x, y) = irg::escape_colour(julia(x, y), most);
    }
  return p;
}

}  // namespace escape_pictures
