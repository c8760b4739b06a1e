// SPDX-License-Identifier: MIT
// Points in a plane through bodies: where they lie against a closed one, and the winding number round an open one.
// Included by pictures.cpp.
#pragma once

#include <irg/mesh/mesh.hpp>
#include <irg/mesh/teapot.hpp>
#include <irg/solid/solid_locator.hpp>
#include <irg/solid/winding_number_rounded.hpp>

#include "meshes.hpp"

namespace solid_pictures {

using namespace sketching;

// Dots over a panel of 320 by 280 pixels, coloured by what colour_of says of the places they stand for.
template <class Colour>
void dots(picture& p, double left, const point2& centre, double unit, const Colour& colour_of) {
  for (int j = -15; j <= 15; ++j)
    for (int i = -17; i <= 17; ++i) {
      const point2 at{left + 160 + 9.0 * i, 140 - 9.0 * j};
      disc(p, at, 3.4, colour_of(point2{centre.x + 9.0 * i / unit, centre.y + 9.0 * j / unit}));
    }
}

inline picture locations() {
  picture p(640, 280, paper);
  // A prism over an L; dots stand at eighths of a unit, so that some are on its sides.
  irg::mesh<double> prism;
  for (const double z : {0.0, 1.0})
    prism.positions.insert(prism.positions.end(), {{0, 0, z}, {3, 0, z}, {3, 1, z}, {1, 1, z}, {1, 3, z}, {0, 3, z}});
  irg::add_face(prism, std::array{5, 4, 3, 2, 1, 0});
  irg::add_face(prism, std::array{6, 7, 8, 9, 10, 11});
  for (int i = 0; i < 6; ++i) irg::add_face(prism, std::array{i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6});
  const irg::solid_locator where(prism);
  dots(p, 0, {1.5, 1.5}, 72, [&](const point2& q) {
    switch (where({q.x, q.y, 0.5})) {
      case irg::location::inside: return irg::rgba8{78, 148, 96, 255};
      case irg::location::boundary: return irg::rgba8{60, 116, 176, 255};
      default: return irg::rgba8{230, 206, 198, 255};
    }
  });
  const auto teapot = irg::shape_teapot<double>({.subdivisions = 4});
  dots(p, 320, {0.2, 1.5}, 44, [&](const point2& q) {
    const double winding = irg::winding_number_rounded(teapot, {q.x, q.y, 0.01});
    const double share = winding < 0 ? 0 : winding > 1 ? 1 : winding;
    const auto mixed = [&](double from, double to) { return static_cast<std::uint8_t>(from + (to - from) * share); };
    return irg::rgba8{mixed(236, 40), mixed(226, 92), mixed(214, 120), 255};
  });
  return p;
}

}  // namespace solid_pictures
