// SPDX-License-Identifier: MIT
// The Mandelbrot set and a Julia set by their counts. Included by pictures.cpp.
#pragma once

#include <array>

#include <irg/colour/mix.hpp>
#include <irg/fractal/escape_picture.hpp>

#include "enlarged.hpp"

namespace escape_pictures {

using enlarging::picture;

// Sixteen counts from one colour to the next, round and round; what stays is black.
inline irg::rgba8 colour_of(int count, int most) {
  constexpr std::array<irg::rgba8, 5> stops{
      {{18, 32, 74, 255}, {62, 130, 180, 255}, {238, 240, 230, 255}, {226, 160, 62, 255}, {120, 36, 52, 255}}};
  if (count >= most) return {0, 0, 0, 255};
  const auto stop = static_cast<std::size_t>(count) / 16;
  return irg::mix(stops[stop % stops.size()], stops[(stop + 1) % stops.size()],
                  static_cast<std::uint8_t>(count % 16 * 16));
}

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
      p(x, y) = colour_of(set(x, y), most);
      p(width + x, y) = colour_of(julia(x, y), most);
    }
  return p;
}

}  // namespace escape_pictures
