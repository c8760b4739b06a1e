// SPDX-License-Identifier: MIT
#include <irg/render/prepared_scene.hpp>

#include <vector>

#include <irg/core/threads.hpp>
#include <irg/mesh/shapes.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rendered.hpp"
#include "support/scenes.hpp"

namespace {

using irg::picture_style;

bool same(const test::rendered& a, const test::rendered& b) { return a.picture == b.picture && a.stats == b.stats; }

irg::render_options random_options(test::random& r) {
  irg::render_options o;
  o.style = static_cast<picture_style>(r.integer(0, 3));
  o.hidden = r.integer(0, 3) == 0 ? irg::hidden_surface_method::none : irg::hidden_surface_method::zbuffer;
  o.culling = r.integer(0, 1) == 0 ? irg::face_culling::none : irg::face_culling::back;
  o.intensities = r.integer(0, 3) == 0 ? irg::intensity_range::rescale : irg::intensity_range::clamp;
  if (r.integer(0, 3) == 0) o.skip = irg::skip_nothing;
  return o;
}

// One of the things that may change from one picture to the next, in the scene and in what was prepared of it.
void change(irg::scene<double>& world, irg::prepared_scene<double>& ready, test::random& r) {
  const std::size_t k = static_cast<std::size_t>(r.integer(0, 1)) % world.objects.size();
  switch (r.integer(0, 9)) {
    case 0: world.view.eye.x += 0.25; break;
    case 1: world.lights[0].position.y -= 0.5; break;
    case 2: world.lights[0].intensity.r *= 0.75; break;
    case 3: world.lights.push_back({{1, 0, 2, 0}, {0.2, 0.1, 0.3}}); break;
    case 4: world.ambient.g += 0.05; break;
    case 5: world.objects[k].surface.diffuse.b *= 0.5; break;
    case 6: world.objects[k].surface.shininess += 1; break;
    case 7:
      world.distance =
          world.distance == irg::distance_term::none ? irg::distance_term::viewer : irg::distance_term::none;
      break;
    case 8: world.k *= 1.5; break;
    default:
      world.objects[k].placement = irg::translation(irg::vec<double, 3>{0.1, -0.2, 0.3}) * world.objects[k].placement;
      ready.objects[k] = irg::prepare_object(world.objects[k]);
  }
  ready.view = world.view;
  ready.lights = world.lights;
  ready.ambient = world.ambient;
  ready.distance = world.distance;
  ready.k = world.k;
  for (std::size_t i = 0; i < world.objects.size(); ++i) ready.objects[i].surface = world.objects[i].surface;
}

TEST_CASE("prepared_scene: picture after picture the bytes and counts of the scene itself") {
  test::random r(41);
  for (int s = 0; s < 30; ++s) {
    irg::scene<double> world = test::random_scene<double>(r, 12, test::positions::ordinary);
    irg::prepared_scene<double> ready = irg::prepare_scene(world);
    irg::render_options options = random_options(r);
    for (int picture = 0; picture < 12; ++picture) {
      const int width = static_cast<int>(r.integer(1, 90)), height = static_cast<int>(r.integer(1, 70));
      REQUIRE(same(test::render(ready, width, height, options), test::render(world, width, height, options)));
      if (r.integer(0, 2) == 0)
        options = random_options(r);
      else
        change(world, ready, r);
    }
  }
}

TEST_CASE("prepared_scene: three threads, and no pixels") {
  test::random r(7);
  const irg::scene<double> world = test::random_scene<double>(r, 40, test::positions::ordinary);
  irg::prepared_scene<double> ready = irg::prepare_scene(world);
  const auto one = test::render(ready, 200, 130);
  CHECK(same(test::render(ready, 200, 130, {}, irg::parallel{3}), one));
  CHECK(test::render(ready, 0, 130).stats == irg::render_counts{});
  CHECK(same(test::render(ready, 200, 130), one));
}

// What the two stages before drawing cost is told by whether colours are where they were.
TEST_CASE("prepared_scene: colours stay as long as light and eye do") {
  irg::scene<double> world;
  world.objects.push_back({irg::shape_cube<double>()});
  world.lights = {{{1, 2, 3, 0}, {1, 1, 1}}};
  world.view.eye = {2, 3, 5};
  auto ready = irg::prepare_scene(world);
  test::render(ready, 32, 32);
  irg::detail::kept_of(ready.objects[0]).vertex_colours[0][0] = {9, 9, 9};  // seen to survive
  test::render(ready, 64, 32);
  CHECK(irg::detail::kept_of(ready.objects[0]).vertex_colours[0][0][0] == 9);
  ready.view.eye.x = 2.5;
  test::render(ready, 64, 32);
  CHECK(irg::detail::kept_of(ready.objects[0]).vertex_colours[0][0][0] < 9);
}

// Memory that gives out does the same.
TEST_CASE("prepared_scene: an executor that throws leaves no colours that seem ready") {
  irg::scene<double> world;
  world.objects.push_back({irg::shape_cube<double>()});
  world.lights = {{{1, 2, 3, 0}, {1, 1, 1}}};
  world.view.eye = {2, 3, 5};
  for (const picture_style style : {picture_style::flat, picture_style::gouraud}) {
    irg::render_options options;
    options.style = style;
    options.culling = irg::face_culling::none;
    for (int calls = 0, ended = 0; ended < 2; ++calls) {
      // The light goes on, or back to where it was.
      ended = 0;
      for (const double next : {-4.0, 1.0}) {
        auto ready = irg::prepare_scene(world);
        test::render(ready, 32, 32, options);
        ready.lights[0].position.x = -4;
        int left = calls;
        const test::any_executor throwing([&](std::size_t count, const auto& task) {
          if (left-- == 0) throw 1;
          for (std::size_t i = 0; i < count; ++i) task(i);
        });
        try {
          test::render(ready, 32, 32, options, throwing);
          ++ended;
        } catch (int) {
        }
        ready.lights[0].position.x = next;
        auto fresh = irg::prepare_scene(world);
        fresh.lights = ready.lights;
        REQUIRE(same(test::render(ready, 32, 32, options), test::render(fresh, 32, 32, options)));
      }
    }
  }
}

TEST_CASE("extent_of: a box around the placed positions, and the triangles of all faces") {
  constexpr auto placed = [] {
    irg::object<double> o{irg::shape_cube<double>()};
    o.placement = irg::translation(irg::vec<double, 3>{10, 0, 0});
    return irg::extent_of(o);
  };
  CHECK_BOTH(placed().triangles == 12);
  constexpr auto low = [] { return irg::extent_of(irg::object<double>{irg::shape_cube<double>()}).bounds.low.x; };
  CHECK_BOTH(placed().bounds.low.x == low() + 10);
  CHECK_BOTH(placed().bounds.high.x > placed().bounds.low.x);
  CHECK_BOTH(irg::extent_of(irg::object<double>{}).triangles == 0);
}

constexpr bool prepared_equals_scene() {
  irg::scene<double> world;
  world.objects.push_back({irg::shape_tetrahedron<double>()});
  world.lights = {{{1, 2, 3, 0}, {1, 1, 1}}};
  world.view.eye = {0, 0, 5};
  auto ready = irg::prepare_scene(world);
  irg::image<irg::rgba8> a(8, 8), b(8, 8);
  irg::image<float> da(8, 8), db(8, 8);
  irg::render(world, {a, da});
  const auto first = irg::render(ready, {b, db});
  return a == b && da == db && first == irg::render(ready, {b, db}) && a == b;
}

TEST_CASE("prepared_scene: in a constant expression") { CHECK_BOTH(prepared_equals_scene()); }

}  // namespace
