// SPDX-License-Identifier: MIT
// Curves: the weights of both forms of a Bezier curve. Included by pictures.cpp.
#pragma once

#include <array>
#include <vector>

#include <irg/curve/bezier_edge_form.hpp>

#include "sketch.hpp"

namespace curve_pictures {

using namespace sketching;

constexpr irg::rgba8 families[] = {blue, red, green, {190, 140, 40, 255}, {150, 96, 160, 255}, {92, 142, 196, 255}};

// The cubic weights of both forms over t: left Bernstein's, right Bezier's.
inline picture weights() {
  picture p(1320, 560, paper);
  for (const bool by_edges : {false, true}) {
    const double left = by_edges ? 700 : 40, bottom = 520, size = 480;
    outline(p, {{left, bottom}, {left, bottom - size}, {left + 580, bottom - size}, {left + 580, bottom}}, 2, grey);
    for (std::size_t i = 0; i <= 3; ++i) {
      ring line;
      for (int k = 0; k <= 100; ++k) {
        std::array<double, 4> value{};
        const double t = k / 100.0;
        by_edges ? irg::bezier_weights<double>(t, value) : irg::bernstein_basis<double>(t, value);
        line.push_back({left + 580 * t, bottom - size * value[i]});
      }
      stroke(p, line, 5, families[i]);
    }
  }
  return halved(p);
}

}  // namespace curve_pictures
