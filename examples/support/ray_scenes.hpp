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

/// A room with a red and a green wall, two blocks and a panel that shines (after Goral et al.), for paths.
class cornell_box {
public:
  cornell_box() {
    const irg::rgb<double> white{0.73, 0.72, 0.68}, red{0.62, 0.06, 0.05}, green{0.12, 0.45, 0.09};
    using V = irg::vec<double, 3>;
    add(sheet({0, 0, 0}, V{0, 0, -10}, V{10, 0, 0}).positions, white);              // floor, seen from above
    add(sheet({0, 10, 0}, V{10, 0, 0}, V{0, 0, -10}).positions, white);
    add(sheet({0, 0, -10}, V{10, 0, 0}, V{0, 10, 0}).positions, white);
    add(sheet({0, 0, 0}, V{0, 10, 0}, V{0, 0, -10}).positions, red);
    add(sheet({10, 0, 0}, V{0, 0, -10}, V{0, 10, 0}).positions, green);
    add(sheet({3.6, 9.99, -6.4}, V{2.8, 0, 0}, V{0, 0, 2.4}).positions, {}, {17, 13, 7});
    add_block({2.3, 0, -4.4}, V{2.8, 0, -0.9}, V{-0.9, 0, -2.8}, 6, white);
    add_block({5, 0, -1.4}, V{2.8, 0, 0.85}, V{0.85, 0, -2.8}, 3, white);
  }

  /// The bodies refer to this scene, which has to stay.
  std::vector<irg::traced_body<double>> bodies() const {
    std::vector<irg::traced_body<double>> all;
    all.reserve(parts_.size());
    for (const part& p : parts_) all.push_back({p.corners, {}, p.triangles, {{}, p.diffuse, {}, 1}, {}, p.emitted});
    return all;
  }

  /// The ray through a place of the picture, 0 to 1 from the upper left corner.
  static irg::ray<double, 3> ray_at(double x, double y) {
    return {{5, 5, 24}, {(x - 0.5) * 10.6, (0.5 - y) * 10.6, -24}};
  }

private:
  struct part {
    std::vector<irg::point<double, 3>> corners;
    std::vector<irg::triangle_indices> triangles;
    irg::rgb<double> diffuse, emitted;
  };

  void add(const std::vector<irg::point<double, 3>>& corners, const irg::rgb<double>& diffuse,
           const irg::rgb<double>& emitted = {}) {
    parts_.push_back({corners, {{{0, 1, 2}}, {{0, 2, 3}}}, diffuse, emitted});
  }
  void add_block(const irg::point<double, 3>& at, const irg::vec<double, 3>& u, const irg::vec<double, 3>& v,
                 double height, const irg::rgb<double>& diffuse) {
    const irg::vec<double, 3> up{0, height, 0};
    add(sheet(at + up, u, v).positions, diffuse);
    add(sheet(at, u, up).positions, diffuse);
    add(sheet(at + u, v, up).positions, diffuse);
    add(sheet(at + u + v, -u, up).positions, diffuse);
    add(sheet(at + v, -v, up).positions, diffuse);
  }

  std::vector<part> parts_;
};

}  // namespace program
