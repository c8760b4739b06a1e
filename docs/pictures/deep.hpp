// SPDX-License-Identifier: MIT
// Four steps of a deep zoom into the Mandelbrot set. Included by pictures.cpp.
#pragma once

#include <irg/fractal/deep_mandelbrot.hpp>
#include <irg/fractal/escape_colour.hpp>

#include "enlarged.hpp"

namespace deep_pictures {

using enlarging::picture;

inline picture four_widths() {
  constexpr int side = 92, most = 3000;
  irg::deep_escape_job<6> job{
      *irg::parse_fixed_point<6>("-0.796018035679333599770602762027128618680016120069383332358641"),
      *irg::parse_fixed_point<6>("0.152921489508950739029284976898362805189168098776991868427910"), 0,
      irg::make_escape_limit(16.0, most)};
  picture p(4 * side, side);
  int left = 0;
  for (const double width : {3.0, 1e-3, 1e-20, 1e-47}) {
    job.pixel = width / side;
    irg::image<int> counts(side, side);
    irg::draw_deep_mandelbrot(counts, job);
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) p(left + x, y) = irg::escape_colour(counts(x, y), most);
    left += side;
  }
  return p;
}

}  // namespace deep_pictures
