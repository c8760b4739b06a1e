// SPDX-License-Identifier: MIT
#include <irg/render/scene_bsp.hpp>

#include <irg/mesh/shapes.hpp>
#include <irg/view/affine.hpp>

#include "support/check_both.hpp"

namespace {

template <class T>
irg::scene<T> bodies() {
  irg::scene<T> s;
  s.objects.push_back({irg::shape_cube<T>()});
  s.objects.push_back(
      {irg::shape_sphere<T>({.slices = 24, .stacks = 12}), irg::translation(irg::vec<T, 3>{T(0.7), T(0.3), T(0.2)})});
  s.objects.push_back({irg::shape_torus<T>({.major_segments = 24, .minor_segments = 10}),
                       irg::translation(irg::vec<T, 3>{T(-0.4), T(0.2), T(0.4)})});
  s.lights.push_back({});
  s.ambient = {T(0.2), T(0.2), T(0.2)};
  return s;
}

template <class T>
void check_pictures() {
  irg::scene<T> world = bodies<T>();
  const irg::bsp_tree_3d<T> tree = irg::make_scene_bsp(world);
  CHECK(tree.splits() > 50);  // the bodies stand in each other
  constexpr int width = 160, height = 120;
  irg::image<irg::rgba8> colour(width, height), other(width, height);
  irg::image<float> depth(width, height), other_depth(width, height);
  int differing = 0, shown = 0;
  for (int view = 0; view < 8; ++view) {
    world.view.eye = {T(4 - view), T(2), T(view % 3 + 1)};
    if (view == 3) world.view.eye = {T(0.9), T(0.4), T(1.1)};  // with bodies beyond the picture
    if (view >= 6) world.view.projection = irg::projection_kind::orthographic;
    if (view == 7) world.view.projection = irg::projection_kind::oblique;
    if (view >= 6) world.view.near_distance = T(-20), world.view.far_distance = T(20);
    const irg::render_counts by_tree = irg::render_with(tree, world, {colour, depth});
    irg::render(world, {other, other_depth});
    CHECK(by_tree.drawn > 500);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        shown += depth(x, y) != irg::nearer_is_greater::farthest;
        differing += depth(x, y) != other_depth(x, y) || !(colour(x, y) == other(x, y));
      }
  }
  CHECK(shown > 20000);
  CHECK(differing * 2000 < shown);
}

TEST_CASE("render by a scene's tree: the z-buffer's picture from every eye, but for snapped ties") {
  check_pictures<double>();
  check_pictures<float>();
}

#pragma GCC diagnostic ignored "-Wdeprecated-declarations"  // the old order goes on compiling
TEST_CASE("render_with: trees and methods, once called render") {
  irg::scene<double> world = bodies<double>();
  world.view.eye = {4, 2, 1};
  const auto tree = irg::make_scene_bsp(world);
  irg::image<irg::rgba8> now(40, 30), before(40, 30);
  irg::image<float> depth(40, 30);
  CHECK(irg::render_with(tree, world, {now, depth}) == irg::render(tree, world, {before, depth}));
  CHECK(now == before);
  irg::render_with(irg::ray_casting<>{}, world, {now, depth}, {.style = irg::picture_style::flat});
  irg::render(irg::ray_casting<>{}, world, {before, depth}, {.style = irg::picture_style::flat});
  CHECK(now == before);
}

}  // namespace
