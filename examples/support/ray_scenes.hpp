// SPDX-License-Identifier: MIT
// The scenes of the programs that draw by rays. The documentation's pictures are drawn of them, too.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include <irg/mesh/shapes.hpp>
#include <irg/mesh/teapot.hpp>
#include <irg/scene/scene.hpp>
#include <irg/trace/ray_world.hpp>

namespace program {

/// A scene, and what each of its objects does with rays.
struct ray_scene {
  irg::scene<double> world;
  std::vector<irg::optics<double>> optics;

  void add(irg::mesh<double> shape, const irg::material<double>& surface, const irg::optics<double>& optic = {}) {
    world.objects.push_back({std::move(shape)});
    world.objects.back().surface = surface;
    optics.push_back(optic);
  }
};

/// A rectangle with two sides from a corner, its front where their cross product points to.
inline irg::mesh<double> sheet(const irg::point<double, 3>& corner, const irg::vec<double, 3>& u,
                               const irg::vec<double, 3>& v) {
  irg::mesh<double> m;
  m.positions = {corner, corner + u, corner + u + v, corner + v};
  irg::add_face(m, std::array{0, 1, 2, 3});
  return m;
}

/// The teapot on a floor, with a lamp near by and a dim one at infinity.
inline ray_scene shadow_scene() {
  ray_scene s;
  s.add(irg::shape_teapot<double>({.subdivisions = 10}), {{0.75, 0.42, 0.20}, {0.75, 0.42, 0.20}, {0.3, 0.3, 0.3}, 40});
  s.add(sheet({-30, 0, 30}, {60, 0, 0}, {0, 0, -60}), {{0.8, 0.8, 0.82}, {0.8, 0.8, 0.82}, {}, 1});
  s.world.view = {.eye = {3, 5, 9}, .target = {0.4, 1, 0}};
  s.world.lights = {{{-5, 7, 5, 1}, {0.75, 0.75, 0.7}}, {{2, 3, -1, 0}, {0.25, 0.25, 0.3}}};
  s.world.ambient = {0.12, 0.12, 0.14};
  return s;
}

/// A ball of glass, one of silver and a red one over a chequered floor.
inline ray_scene glass_scene() {
  ray_scene s;
  const auto ball = [&](const irg::vec<double, 3>& at, const irg::material<double>& surface,
                        const irg::optics<double>& optic) {
    irg::mesh<double> m = irg::shape_sphere<double>({.slices = 128, .stacks = 64});
    for (auto& p : m.positions) p = p + at;
    s.add(std::move(m), surface, optic);
  };
  const irg::material<double> polished{{0.02, 0.02, 0.02}, {0.02, 0.02, 0.02}, {0.6, 0.6, 0.6}, 200};
  ball({0, 1, 1.2}, polished, {{0.08, 0.08, 0.08}, {0.9, 0.94, 0.92}, 1.5});
  ball({-2.2, 1, -1}, polished, {{0.75, 0.75, 0.78}, {}, 1});
  ball({2.1, 1, -1.4}, {{0.7, 0.12, 0.1}, {0.7, 0.12, 0.1}, {0.4, 0.4, 0.4}, 60}, {{0.06, 0.06, 0.06}, {}, 1});
  irg::mesh<double> tiles[2];
  for (int i = -8; i < 8; ++i)
    for (int k = -8; k < 8; ++k) {
      irg::mesh<double>& m = tiles[(i + k) & 1];
      const auto first = m.positions.size();
      const double x = i, z = k;
      m.positions.insert(m.positions.end(), {{x, 0, z}, {x, 0, z + 1}, {x + 1, 0, z + 1}, {x + 1, 0, z}});
      irg::add_face(m, std::array{first, first + 1, first + 2, first + 3});
    }
  s.add(tiles[0], {{0.85, 0.85, 0.8}, {0.85, 0.85, 0.8}, {}, 1});
  s.add(tiles[1], {{0.2, 0.28, 0.36}, {0.2, 0.28, 0.36}, {}, 1});
  s.world.view = {.eye = {0.6, 2.6, 7.5}, .target = {0, 0.8, 0}};
  s.world.lights = {{{-4, 8, 5, 1}, {0.8, 0.8, 0.8}}};
  s.world.ambient = {0.2, 0.2, 0.2};
  return s;
}

}  // namespace program
