// SPDX-License-Identifier: MIT
// Scenes by rays.
#pragma once

#include <irg/colour/srgb.hpp>
#include <irg/render/render_traced.hpp>
#include <irg/trace/path_tracer.hpp>
#include <irg/trace/soft_light.hpp>

#include "../../examples/support/ray_scenes.hpp"
#include "sketch.hpp"

namespace ray_pictures {

using sketching::picture;

inline picture drawn(const program::ray_scene& s, int width, int height) {
  picture p(width, height);
  irg::traced_options<double> options;
  options.samples = 3;
  options.optics = s.optics;
  irg::render_traced(s.world, p, options);
  return p;
}

// The room by paths: as many for each pixel.
inline void room(picture& p, int left, int size, int paths) {
  const program::cornell_box box;
  const irg::ray_world<double> world(box.bodies(), {});
  const irg::path_tracer<double> trace(world);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const auto light = trace(program::cornell_box::ray_at((x + 0.5) / size, (y + 0.5) / size), {paths, 4, 1},
                               static_cast<std::uint64_t>(y * size + x));
      p(left + x, y) =
          irg::encode({static_cast<float>(light.r), static_cast<float>(light.g), static_cast<float>(light.b)});
    }
}

inline picture rooms() {
  picture p(234, 112, sketching::white);
  room(p, 0, 112, 4);
  room(p, 122, 112, 24);
  return p;
}

// A block under a panel and under a rod: samples of the panel, and the rod's share in closed form.
inline picture soft_shadows() {
  picture p(420, 200, sketching::white);
  const std::vector<irg::point<double, 3>> corners{{-9, 0, 9},   {9, 0, 9},   {9, 0, -9},  {-9, 0, -9},
                                                   {-1, 0, 0.2}, {1, 0, 0.2}, {1, 2.2, 0}, {-1, 2.2, 0}};
  const std::vector<irg::triangle_indices> floor{{{0, 1, 2}}, {{0, 2, 3}}}, wall{{{4, 5, 6}}, {{4, 6, 7}}};
  const irg::material<double> dull{{0.1, 0.1, 0.1}, {0.85, 0.82, 0.76}, {}, 1};
  const irg::ray_world<double> world({{corners, {}, floor, dull, {}}, {corners, {}, wall, dull, {}}}, {});
  const std::array<std::vector<irg::area_light<double>>, 2> lamps{
      {{{{-1, 4, -5}, {2, 0, 0}, {0, 2, 0}, {1, 1, 1}}}, {{{-1, 5, -5}, {2, 0, 0}, {}, {1, 1, 1}}}}};
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 420; ++x) {
      const int side = x < 210 ? 0 : 1;
      const irg::ray<double, 3> r{{0, 6, 9}, {(x % 210 - 104.5) / 150, 0.12 - y / 160.0, -1}};
      const auto s = world.meet(r);
      const double light =
          s ? 0.08 +
                  irg::soft_light_of_surface<double>(world, *s, r.origin, lamps[static_cast<std::size_t>(side)], 14).r
            : 0.9;
      p(x, y) =
          irg::encode({static_cast<float>(light), static_cast<float>(light * 0.97), static_cast<float>(light * 0.9)});
    }
  return p;
}

inline picture shadow() { return drawn(program::shadow_scene(), 400, 250); }
inline picture glass() { return drawn(program::glass_scene(), 400, 250); }

}  // namespace ray_pictures
