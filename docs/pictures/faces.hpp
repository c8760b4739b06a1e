// SPDX-License-Identifier: MIT
// Faces that have no order as wholes, pixel by pixel: three that overlap in a ring, and two that pass through each
// other, one of them split. Included by pictures.cpp.
#pragma once

#include <array>
#include <span>

#include <irg/raster/draw_line.hpp>
#include <irg/raster/face_fragment.hpp>

#include "enlarged.hpp"

namespace face_pictures {

using namespace enlarging;
constexpr int width = 36, height = 31, size = 10;
constexpr irg::rgba8 blue{92, 142, 196, 255}, red{204, 96, 72, 255}, amber{230, 180, 84, 255},
    pale_red{236, 190, 176, 255};

inline irg::screen_vertex corner(double x, double y, float depth) {
  return {irg::snap(irg::point<double, 2>{x, y}), depth};
}

// Pixels as squares, their centres as dots, the outlines of the faces.
template <class ColourAt>
picture panel(std::span<const irg::screen_face> faces, ColourAt colour_at) {
  picture small(width, height, paper);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) small(x, y) = colour_at(x, y);
  picture big = enlarged(small, size);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) dot(big, {x * size + size / 2, y * size + size / 2}, 0, ink);
  const auto place = [](const irg::screen_vertex& v) {
    return irg::cell{v.position.x * size / irg::one_pixel, v.position.y * size / irg::one_pixel};
  };
  for (const irg::screen_face& f : faces)
    for (int i = 0; i < 3; ++i) irg::draw_line(big, place(f.v[i]), place(f.v[(i + 1) % 3]), ink);
  return big;
}

// Left: each face is nearer than one of its neighbours and farther than the other. Right: the red face split by the blue
// one's plane, its farther part pale.
inline picture order() {
  const std::array ring{
      irg::make_screen_face(corner(1.2, 21.3, 0.9f), corner(8.1, 30.2, 0.9f), corner(29.4, 2.3, 0.1f), 0),
      irg::make_screen_face(corner(22.1, 0.7, 0.9f), corner(11.3, 2.6, 0.9f), corner(32.2, 30.4, 0.1f), 1),
      irg::make_screen_face(corner(35.6, 13.2, 0.9f), corner(34.1, 24.1, 0.9f), corner(0.8, 26.4, 0.1f), 2)};
  const irg::rgba8 colours[] = {red, blue, amber};
  const picture overlapping = panel(ring, [&](int x, int y) {
    const std::optional<std::uint32_t> seen = irg::picture_face_at(ring, x, y);
    return seen ? colours[*seen] : paper;
  });
  const std::array crossing{
      irg::make_screen_face(corner(1.4, 4.2, 0.8f), corner(34.7, 8.3, 0.3f), corner(9.2, 28.6, 0.7f), 0),
      irg::make_screen_face(corner(2.3, 24.5, 0.2f), corner(20.4, 1.6, 0.5f), corner(34.1, 27.2, 0.9f), 1)};
  const irg::fragment_parts parts = irg::split_fragment({&crossing[0]}, crossing[1]);
  const picture split = panel(crossing, [&](int x, int y) {
    irg::rgba8 colour = paper;  // painted from back to front
    if (covers(parts.farther, x, y)) colour = pale_red;
    if (covers(crossing[1], x, y)) colour = blue;
    if (covers(parts.nearer, x, y)) colour = red;
    return colour;
  });
  constexpr int gap = 20;
  picture both(overlapping.width() + gap + split.width(), overlapping.height(), {255, 255, 255, 255});
  paste(both, overlapping, 0, 0);
  paste(both, split, overlapping.width() + gap, 0);
  return both;
}

}  // namespace face_pictures
