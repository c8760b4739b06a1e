// SPDX-License-Identifier: MIT
// Pictures of predicates next to zero: what plain doubles say, and beside it what is so.
#pragma once

#include <irg/geometry/in_circle.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/orient3d.hpp>
#include <irg/math/exact/sign_of.hpp>
#include <irg/math/vec.hpp>

#include "enlarged.hpp"

namespace predicate_pictures {

using namespace enlarging;
using irg::product;
using P = irg::point<double, 2>;
using Q = irg::point<double, 3>;

// The signs over the grid of doubles from 0.5 + first * 2^-53 on, y up, in 256 / zoom steps: those of `rounded`, then
// those of `exact`.
template <class Rounded, class Exact>
picture side_by_side(int first, int zoom, const Rounded& rounded, const Exact& exact) {
  constexpr int size = 256, gap = 16;
  constexpr irg::rgba8 negative{204, 96, 72, 255}, zero{250, 214, 90, 255}, positive{92, 142, 196, 255};
  picture p(2 * size + gap, size, {255, 255, 255, 255});
  const auto colour = [&](double sign) { return sign < 0 ? negative : sign > 0 ? positive : zero; };
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const double px = 0.5 + (first + x / zoom) * 0x1p-53, py = 0.5 + (first + y / zoom) * 0x1p-53;
      p(x, size - 1 - y) = colour(rounded(px, py));
      p(size + gap + x, size - 1 - y) = colour(exact(px, py));
    }
  return p;
}

inline picture turns() {
  return side_by_side(
      0, 1, [](double x, double y) { return product(12 - x, 24 - y) - product(12 - y, 24 - x); },
      [](double x, double y) { return static_cast<double>(irg::orient2d(P{x, y}, P{12, 12}, P{24, 24})); });
}

inline picture planes() {
  constexpr Q b{12, 12, 12}, c{24, 24, 24}, d{12, 24, 18};
  constexpr double z = 0.5 + 100 * 0x1p-53;
  return side_by_side(
      0, 1,
      [&](double x, double y) {
        const double ax = x - d.x, ay = y - d.y, az = z - d.z, bx = b.x - d.x, by = b.y - d.y, bz = b.z - d.z;
        const double cx = c.x - d.x, cy = c.y - d.y, cz = c.z - d.z;
        return -(product(az, product(bx, cy) - product(by, cx)) + product(bz, product(cx, ay) - product(cy, ax)) +
                 product(cz, product(ax, by) - product(ay, bx)));
      },
      [&](double x, double y) { return static_cast<double>(irg::orient3d(Q{x, y, z}, b, c, d)); });
}

inline picture circles() {
  constexpr P a{24, 0.5}, b{24, 12}, c{0.5, 12};
  return side_by_side(
      -32, 4,
      [&](double x, double y) {
        const double ax = a.x - x, ay = a.y - y, bx = b.x - x, by = b.y - y, cx = c.x - x, cy = c.y - y;
        const double as = product(ax, ax) + product(ay, ay), bs = product(bx, bx) + product(by, by);
        const double cs = product(cx, cx) + product(cy, cy);
        return product(as, product(bx, cy) - product(by, cx)) + product(bs, product(cx, ay) - product(cy, ax)) +
               product(cs, product(ax, by) - product(ay, bx));
      },
      [&](double x, double y) { return static_cast<double>(irg::in_circle(a, b, c, P{x, y})); });
}

// Inside or outside of a circle by its centre and the square of its radius, near the point (0.5, 0.5) on it.
inline picture discs() {
  const auto power = [](const auto& p, const auto& centre, const auto& square) {
    return dot(p - centre, p - centre) - square;
  };
  return side_by_side(
      -128, 1, [](double x, double y) { return product(x - 12, x - 12) + product(y - 12, y - 12) - 264.5; },
      [&](double x, double y) { return static_cast<double>(irg::sign_of<2>(power, P{x, y}, P{12, 12}, 264.5)); });
}

}  // namespace predicate_pictures
