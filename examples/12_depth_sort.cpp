// SPDX-License-Identifier: MIT
// 12_depth_sort - hidden surfaces without pixels: three beams that lie on each other in turn, as a drawing in vectors:
// depth_sort.svg, or the file that is named.
// previous: 11_own_method
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <irg/hidden/textbook/depth_sort.hpp>
#include <irg/io/file.hpp>
#include <irg/io/image_file.hpp>
#include <irg/io/svg_drawing.hpp>

#include "support/step.hpp"

namespace {

using polygon = std::vector<irg::point<double, 3>>;

// A beam beside the middle of the picture, turned about it; z, towards the viewer, grows along it.
polygon beam(double turn) {
  const double c = std::cos(turn), s = std::sin(turn);
  const auto at = [&](double along, double across) {
    return irg::point<double, 3>{160 + c * along - s * across, 130 + s * along + c * across, along};
  };
  return {at(-110, 30), at(110, 30), at(110, 62), at(-110, 62)};
}

}  // namespace

int main(int argc, char** argv) {
  const auto file =
      program::step(argc, argv, "12_depth_sort", "three beams that lie on each other in turn", "depth_sort.svg");
  if (irg::image_format_of_name(file) != irg::image_format::svg)
    program::fail("12_depth_sort", "the drawing's name must end in .svg, not: " + file);
  constexpr double third = 2.0943951023931953;
  const std::vector<polygon> beams{beam(0), beam(third), beam(2 * third)};
  const auto parts = irg::textbook::depth_sort(beams);  // the farthest first

  std::string text;
  auto sink = [&](std::string_view piece) { text.append(piece); };
  irg::svg_drawing drawing(sink, {320, 260}, {255, 255, 255, 255});
  constexpr irg::rgba8 colours[] = {{204, 96, 72, 255}, {236, 190, 96, 255}, {96, 160, 120, 255}};
  for (const auto& part : parts) {
    std::vector<std::vector<irg::point<double, 2>>> ring(1);
    for (const auto& corner : part.corners) ring[0].push_back({corner.x, corner.y});
    drawing.add_region(ring, colours[part.number]);
  }
  drawing.finish();
  if (const auto saved = irg::save_file(file, text); !saved)
    program::fail("12_depth_sort", saved.error().message + (": " + file));
  for (const auto& part : parts) std::printf("beam %u, %zu corners\n", part.number, part.corners.size());
  // No order of the three whole beams is right: at least one is in two parts.
  return parts.size() > beams.size() ? 0 : 1;
}
