// SPDX-License-Identifier: MIT
// irg::render as the README calls it: a scene of doubles with a light and a camera becomes a Gouraud-shaded picture, from
// nothing, then prepared once, then with another light in each frame. Beside it what is left to do when vertices come
// as floats with their colours: irg's shade_batches, to sRGB as render does it and to linear bytes as the peer does, and
// llvmpipe, which gets the same colours.
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <irg/render/prepared_scene.hpp>
#include <irg/render/render.hpp>
#include <irg/shade/shading.hpp>

#include "render/frames.hpp"

namespace {

using namespace bench;

irg::point<double, 3> widened(const irg::point<float, 3>& p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
}

// As near to a body as lets the whole of it be seen; random triangles are made for an eye in the origin.
irg::camera<double> camera_for(const scene& s) {
  irg::camera<double> c;
  if (s.culling == irg::face_culling::none) {
    c.eye = {0, 0, 0};
    c.target = {0, 0, -1};
    c.vertical_angle = 2 * std::atan(0.5);
    c.near_distance = 1;
    return c;
  }
  const irg::box<double, 3> bounds{widened(s.objects[0].bounds.low), widened(s.objects[0].bounds.high)};
  const double aspect = static_cast<double>(aspect_of(s));
  c = irg::camera_around(irg::centre(bounds), irg::length(irg::extent(bounds)) / 2, irg::vec<double, 3>{0, 0.2, 1},
                         irg::radians(40.0), aspect);
  const irg::mat<double, 4, 4> to_clip = irg::view_projection(c, aspect);
  double reach = 0;  // of the body, in halves of the picture
  for (const auto& p : s.positions) {
    const irg::hpoint<double, 3> h = to_clip * widened(p);
    reach = std::max({reach, std::abs(h.x / h.w), std::abs(h.y / h.w)});
  }
  c.vertical_angle = 2 * std::atan(std::tan(c.vertical_angle / 2) * reach * 1.01);
  return c;
}

// The vertices and triangles of a scene as a user has them.
irg::scene<double> scene_from(const scene& s) {
  irg::scene<double> world;
  irg::object<double>& all = world.objects.emplace_back();
  for (const auto& p : s.positions) all.shape.positions.push_back(widened(p));
  for (const auto& n : s.normals)
    all.shape.normals.push_back({static_cast<double>(n.x), static_cast<double>(n.y), static_cast<double>(n.z)});
  for (const irg::triangle_indices& t : s.triangles) {
    for (const std::uint32_t v : t.v) all.shape.corners.push_back({v, v});
    all.shape.face_starts.push_back(static_cast<std::uint32_t>(all.shape.corners.size()));
  }
  all.surface = {{0.2, 0.2, 0.2}, {0.7, 0.5, 0.3}, {}, 1};
  world.ambient = {0.3, 0.3, 0.3};
  world.lights = {{{-0.5, 0.7, 1, 0}, {1, 1, 1}}};
  world.view = camera_for(s);
  return world;
}

// The same scene for those who want matrix and colours.
scene as_vertices(scene s, const irg::scene<double>& world) {
  const irg::mat<double, 4, 4> to_clip = irg::view_projection(world.view, static_cast<double>(aspect_of(s)));
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) s.to_clip(r, c) = static_cast<float>(to_clip(r, c));
  const irg::gouraud_shader<double> shader{
      world.objects[0].surface, {world.ambient, world.lights}, irg::viewpoint(world.view)};
  for (std::size_t i = 0; i < s.positions.size(); ++i) {
    const irg::rgb<double> light = shader(widened(s.positions[i]), world.objects[0].shape.normals[i]);
    s.colours[i] = {static_cast<float>(light.r), static_cast<float>(light.g), static_cast<float>(light.b)};
  }
  return s;
}

struct user_scene {
  irg::scene<double> world;
  irg::render_options options;
  irg::prepared_scene<double> ready;
  stage on;

  explicit user_scene(const scene& s)
      : world(scene_from(s)), options{.culling = s.culling}, ready(irg::prepare_scene(world)),
        on(as_vertices(s, world)) {}

  void draw() {
    ready.lights = world.lights;
    on.stats = irg::render(world, {on.to.picture, on.to.depth}, options);
  }
  void draw_prepared() { on.stats = irg::render(ready, {on.to.picture, on.to.depth}, options); }
  // The light comes from the other side in every frame.
  void draw_changed() {
    ready.lights[0].position.x = -ready.lights[0].position.x;  // which the plain call takes back
    draw_prepared();
  }
  // How many pixels of what stands in the picture are not those of the plain call.
  errors judge() {
    const std::vector<irg::rgba8> drawn(on.to.picture.data(), on.to.picture.data() + on.what.pixel_count());
    auto same_light = world;
    same_light.lights = ready.lights;
    on.stats = irg::render(same_light, {on.to.picture, on.to.depth}, options);
    errors e;
    e.wrong = 0;
    for (std::size_t i = 0; i < drawn.size(); ++i) e.wrong += !(drawn[i] == on.to.picture.data()[i]);
    e.note = own::skips_of(on.stats);
    if (e.wrong != 0) e.broken = "every way to render a scene leaves the same bytes";
    return e;
  }
};

void enter_scene(const scene_plan& plan) {
  const frame_contest c{"render_call", plan.name, "limit:depth tests", "1/255", 0.51};
  auto& user = keep_lazy([plan] { return std::make_unique<user_scene>(plan.make()); });
  const stage_access on = [&user]() -> stage& { return (*user)->on; };
  const auto enter_render = [&](const char* name, void (user_scene::*draw)(), const char* note) {
    contender who{name, {}};
    who.note = note;
    who.seconds = timed(1, [&user, draw] { ((**user).*draw)(); });
    who.judge = [&user] { return (*user)->judge(); };
    c.enter(1, who);
  };
  enter_render("irg", &user_scene::draw, "the README's call: a scene of doubles, prepared and lit in every frame");
  enter_render("irg:prepared", &user_scene::draw_prepared, "render of a prepared scene, nothing changed");
  enter_render("irg:prepared and lit anew", &user_scene::draw_changed, "render of a prepared scene, its light moved");
  enter_limit(
      c, "irg:shade_batches to sRGB", [on] { on().renderer.draw_encoded(on().to.picture, on().to.depth); },
      [] { return "what is left to do with vertices and colours in floats, the pixels encoded as render's are"; });
  enter_own(c, on, "irg:shade_batches", 1);
  enter_limit(
      c, "limit:depth tests", [on] { stream_depth_tests(on().to.picture, on().to.depth, on().exact->tested); },
      [on] { return on().statistics(); });
  enter_llvmpipe(c, on, 1, drawn::colours);
}

}  // namespace

int main(int argc, char** argv) {
  for (const scene_plan& plan : {scene_a(), scene_a0(), scene_a1(), scene_b(drawing::random_order), scene_c()})
    enter_scene(plan);
  return run_benchmarks(argc, argv);
}
