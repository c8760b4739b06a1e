// SPDX-License-Identifier: MIT
// Pictures of planes in space, by rays through the pixels: what two and three planes have in common, the parameters of
// a plane through three points.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <irg/geometry/textbook/planes.hpp>
#include <irg/geometry/intersect_plane_line.hpp>
#include <irg/geometry/intersect_planes.hpp>
#include <irg/geometry/parametric_plane.hpp>
#include <irg/geometry/plane.hpp>

#include "sketch.hpp"

namespace plane_pictures {

using namespace sketching;
using plane = irg::plane<double>;

struct patch {
  plane whole;
  irg::rgba8 colour;
};

// What is seen of planes within a ball about the origin: of each a disc, the nearer before the farther.
inline void discs(picture& p, const oblique_view& view, const std::vector<patch>& patches, double radius) {
  const vec3 to_viewer = view.to_viewer();
  for (int y = 0; y < p.height(); ++y)
    for (int x = 0; x < p.width(); ++x) {
      std::vector<std::pair<double, irg::rgba8>> seen;
      for (const patch& f : patches) {
        const auto m = irg::intersect_plane_line(
            f.whole, irg::parametric_line<double, 3>{view.under({x + 0.5, y + 0.5}), to_viewer});
        if (m.relation != irg::flat_relation::crossing) continue;
        const double reach = irg::length(m.at - point3{});
        if (reach > radius) continue;
        const bool rim = reach > radius - 0.025;
        seen.push_back({m.t, rim ? irg::mix(f.colour, ink, 120) : with_opacity(f.colour, 195)});
      }
      std::sort(seen.begin(), seen.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
      for (const auto& [t, colour] : seen) p(x, y) = glaze(colour)(p(x, y), 255);
    }
}

inline void line_in_ball(picture& p, const oblique_view& view, const irg::parametric_line<double, 3>& line,
                         double radius, double width, irg::rgba8 colour) {
  const vec3 along = irg::normalized(line.direction);
  const double middle = -irg::dot(along, line.origin - point3{});
  const point3 centre = line.origin + along * middle;
  const double aside = irg::length(centre - point3{});
  if (aside >= radius) return;
  const double half = std::sqrt(radius * radius - aside * aside);
  stroke(p, {view.at(centre - along * half), view.at(centre + along * half)}, width, colour);
}

// Two planes and their line; three and their point; three that cross in parallel lines.
inline picture meetings() {
  constexpr int panel = 213, height = 220;
  picture p(3 * panel + 1, height, paper);
  const plane first{0.25, 1, 0.1, 0.05}, second{1, -0.45, 0.5, 0}, third{0.35, 0.3, -1, 0};
  const plane roof[] = {{0, 1, 0, 0.36}, {0.85, 0.5, 0, -0.2}, {-0.85, 0.5, 0, -0.2}};
  const irg::rgba8 colours[] = {{150, 186, 224, 255}, {232, 170, 150, 255}, {168, 206, 160, 255}};
  const std::vector<patch> all[] = {{{first, colours[0]}, {second, colours[1]}},
                                    {{first, colours[0]}, {second, colours[1]}, {third, colours[2]}},
                                    {{roof[0], colours[0]}, {roof[1], colours[1]}, {roof[2], colours[2]}}};
  for (int k = 0; k < 3; ++k) {
    picture big(2 * panel, 2 * height, paper);
    const oblique_view view({panel + 0.0, height + 0.0}, 172, k == 2 ? 27 : 50, k == 2 ? 0.7 : 0.45);
    const auto& patches = all[k];
    discs(big, view, patches, 1);
    for (std::size_t i = 0; i < patches.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        line_in_ball(big, view, irg::intersect_planes(patches[i].whole, patches[j].whole).line, 1, k == 1 ? 4 : 6,
                     k == 1 ? ink : red);
    if (patches.size() == 3) {
      const auto m = irg::intersect_planes(patches[0].whole, patches[1].whole, patches[2].whole);
      if (m.relation == irg::three_planes_relation::point) mark(big, view.at(m.at), 12, red);
    }
    paste(p, halved(big), k * panel, 0);
  }
  return p;
}

// The plane through A, B, C with its grid: B is the origin, A - B and C - B are the directions.
inline picture parameters() {
  constexpr int width = 640, height = 300;
  picture big(2 * width, 2 * height, paper);
  const oblique_view view({390, 400}, 170, 40, 0.5);
  const point3 a{2.35, 0.05, 0.9}, b{0.5, 0.35, 0.5}, c{0.95, 1.05, -1.25};
  const auto form = *irg::textbook::parametric_plane_at_middle(a, b, c);
  const irg::plane<double> whole = *irg::implicit_plane_of(form);
  const vec3 to_viewer = view.to_viewer();
  const auto at = [&](double s1, double s2) { return view.at(irg::point_at(form, s1, s2)); };
  for (const vec3& axis : {vec3{3.6, 0, 0}, vec3{0, 1.9, 0}, vec3{0, 0, 2.2}})
    arrow(big, view.at({}), view.at(point3{} + axis), 3, grey);
  for (int y = 0; y < big.height(); ++y)
    for (int x = 0; x < big.width(); ++x) {
      const auto m =
          irg::intersect_plane_line(whole, irg::parametric_line<double, 3>{view.under({x + 0.5, y + 0.5}), to_viewer});
      const auto s = *irg::parameters_of(form, m.at);
      if (s.s1 < -0.5 || s.s1 > 1.5 || s.s2 < -0.5 || s.s2 > 1.5) continue;
      big(x, y) =
          glaze(irg::in_triangle(s) ? irg::rgba8{250, 220, 130, 255} : with_opacity(light_blue, 215))(big(x, y), 255);
    }
  for (int k = -2; k <= 6; ++k) {
    const double t = k / 4.0, thick = k % 4 == 0 ? 4 : 2;
    stroke(big, {at(t, -0.5), at(t, 1.5)}, thick, blue);
    stroke(big, {at(-0.5, t), at(1.5, t)}, thick, blue);
  }
  arrow(big, view.at({}), at(0, 0), 5, ink);
  arrow(big, at(0, 0), at(1, 0), 7, red);
  arrow(big, at(0, 0), at(0, 1), 7, green);
  mark(big, view.at(a), 9, red);
  mark(big, view.at(b), 9, ink);
  mark(big, view.at(c), 9, green);
  return halved(big);
}

}  // namespace plane_pictures
