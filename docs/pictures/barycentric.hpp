// SPDX-License-Identifier: MIT
// Barycentric coordinates as colours: red, green and blue are the weights of the three corners. Included by
// pictures.cpp.
#pragma once

#include <algorithm>
#include <cmath>

#include <irg/geometry/barycentric.hpp>
#include <irg/raster/draw_line.hpp>

#include "enlarged.hpp"

namespace barycentric_pictures {

using namespace enlarging;
using place = irg::point<double, 2>;

// Inside, the weights are mixed; outside, bands show how they go on: one band for each tenth of the lowest weight.
inline picture weights() {
  constexpr int width = 480, height = 360;
  constexpr place a{60, 310}, b{430, 260}, c{200, 40};
  picture p(width, height, paper);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto t = *irg::barycentric(a, b, c, place{x + 0.5, y + 0.5});
      const auto share = [&](int i) { return static_cast<std::uint8_t>(std::clamp(t[i], 0.0, 1.0) * 235 + 10); };
      const double lowest = std::min({t.x, t.y, t.z});
      if (lowest >= 0) {
        const bool on_line = std::fmod(t.x * 10 + 0.04, 1.0) < 0.08;
        p(x, y) = on_line ? irg::rgba8{255, 255, 255, 255} : irg::rgba8{share(0), share(1), share(2), 255};
      } else {
        const auto band = static_cast<int>(std::ceil(-lowest * 10));
        const auto grey = static_cast<std::uint8_t>(band % 2 == 0 ? 236 : 246);
        p(x, y) = {grey, grey, grey, 255};
      }
    }
  const auto cell = [](const place& q) { return irg::cell{static_cast<int>(q.x), static_cast<int>(q.y)}; };
  irg::draw_line(p, cell(a), cell(b), ink);
  irg::draw_line(p, cell(b), cell(c), ink);
  irg::draw_line(p, cell(c), cell(a), ink);
  return p;
}

}  // namespace barycentric_pictures
