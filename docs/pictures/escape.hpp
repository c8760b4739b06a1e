// SPDX-License-Identifier: MIT
// The Mandelbrot set and a Julia set by their counts. Included by pictures.cpp.
#pragma once

#include <string>

#include <irg/fractal/distance_estimate.hpp>
#include <irg/fractal/escape_colour.hpp>
#include <irg/fractal/escape_picture.hpp>
#include <irg/fractal/settle_time.hpp>
#include <irg/raster/draw_text.hpp>

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

using number = irg::point<double, 2>;

// Darker the nearer to the set, by the lower bound of the distance.
inline picture distances() {
  constexpr int side = 250;
  constexpr auto limit = irg::make_escape_limit(1000.0, 600);
  constexpr number rabbit{-0.123, 0.745};
  const irg::complex_plane<double> set{{-2.1, 0.7, -1.4, 1.4}, side, side}, julia{{-1.6, 1.6, -1.6, 1.6}, side, side};
  const auto shade = [](const irg::escape_distance<double>& d, int most) {
    if (d.count == most) return irg::rgba8{62, 130, 180, 255};
    const double pixels = d.at_least / (2.8 / side), lit = pixels / (pixels + 0.6);
    const auto v = static_cast<std::uint8_t>(20 + 230 * lit);
    return irg::rgba8{v, v, v, 255};
  };
  picture p(2 * side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      p(x, y) = shade(irg::mandelbrot_distance(set.at(x, y), limit), limit.most);
      p(side + x, y) = shade(irg::julia_distance(julia.at(x, y), rabbit, limit), limit.most);
    }
  return p;
}

// Newton's basins of z^3 = 1, lighter the faster; the burning ship.
inline picture other_maps() {
  constexpr int side = 288, most = 120;
  const irg::complex_plane<double> basins{{-1.6, 1.6, -1.6, 1.6}, side, side};
  const irg::complex_plane<double> ship{{-2.2, 1.4, -1.9, 1.7}, side, side};
  const auto newton = [](const number& z) {
    const number square{z.x * z.x - z.y * z.y, 2 * z.x * z.y};
    const number cube{z.x * square.x - z.y * square.y, z.x * square.y + z.y * square.x};
    const double size = 3 * (square.x * square.x + square.y * square.y);
    const number over{2 * cube.x + 1, 2 * cube.y};
    return number{(over.x * square.x + over.y * square.y) / size, (over.y * square.x - over.x * square.y) / size};
  };
  picture p(2 * side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const auto end = irg::settle_orbit(newton, basins.at(x, y), 1e-9, 60);
      const int light = 255 - 9 * (end.count < 20 ? end.count : 20);
      const irg::rgba8 zero = end.z.x > 0   ? irg::rgba8{226, 160, 62, 255}
                              : end.z.y > 0 ? irg::rgba8{62, 130, 180, 255}
                                            : irg::rgba8{120, 36, 52, 255};
      p(x, y) = irg::mix(irg::rgba8{10, 14, 26, 255}, zero, static_cast<std::uint8_t>(light));
      const number c = ship.at(x, side - 1 - y);  // as it is usually shown, downwards
      const auto fold = [&](const number& z) {
        const double re = z.x < 0 ? -z.x : z.x, im = z.y < 0 ? -z.y : z.y;
        return number{re * re - im * im + c.x, 2 * re * im + c.y};
      };
      p(side + x, y) =
          irg::escape_colour(irg::escape_count(fold, number{0, 0}, irg::make_escape_limit(2.0, most)), most);
    }
  return p;
}

// Julia sets of c inside, on and outside the border of the Mandelbrot set, with what julia_is_connected says.
inline picture convergence() {
  constexpr int side = 118, most = 300, line = 20;
  constexpr number cs[] = {{0, 0},         {-1, 0},      {-0.123, 0.745}, {0.25, 0},    {0, 1},
                           {-0.75, 0.015}, {0.26, 0.01}, {0.3, 0.6},      {-0.8, 0.176}};
  constexpr const char* names[] = {"0",          "-1",       "-0.123+0.745i", "0.25", "i", "-0.75+0.015i",
                                   "0.26+0.01i", "0.3+0.6i", "-0.8+0.176i"};
  picture p(5 * side, 2 * (side + line), enlarging::paper);
  for (int k = 0; k < 9; ++k) {
    const int left = k % 5 * side, top = k / 5 * (side + line);
    irg::escape_job<double> job{{{-1.6, 1.6, -1.6, 1.6}, side, side}, irg::make_escape_limit(10.0, most), {}};
    irg::image<int> counts(side, side);
    irg::draw_julia(counts, job, cs[k]);
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) p(left + x, top + y) = irg::escape_colour(counts(x, y), most);
    const auto whole = irg::julia_is_connected(cs[k], 1000);
    const std::string text = std::string(names[k]) + (whole == irg::connectedness::yes  ? "  one piece"
                                                      : whole == irg::connectedness::no ? "  dust"
                                                                                        : "  undecided");
    irg::draw_text(p, text, irg::point<double, 2>{left + side / 2.0, top + side + line / 2.0},
                   {.size = 10.5, .along = irg::text_along::centre, .across = irg::text_across::middle}, enlarging::ink);
  }
  return p;
}

}  // namespace escape_pictures
