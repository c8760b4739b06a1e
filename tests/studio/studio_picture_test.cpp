// SPDX-License-Identifier: MIT
#include <studio/studio_picture.hpp>

#include <algorithm>
#include <string>
#include <vector>

#include <irg/mesh/shapes.hpp>
#include <irg/mesh/teapot.hpp>
#include <irg/render/render.hpp>

#include "support/check_both.hpp"

namespace {

using studio = irg::studio<double>;
using memory = irg::studio_memory<double>;
using event = irg::studio_event<double>;
using pixels = irg::image<irg::rgba8>;
using irg::apply_event;
using irg::display;
using irg::studio_part;
using irg::studio_view;

constexpr irg::studio_colours colours;

event load(const char* name, const irg::mesh<double>& m) { return irg::load_body<double>{irg::store_body(name, m)}; }

event moved(const char* name, double x, double y, double z) {
  return irg::add_transformation<double>{name, irg::studio_stage::before, {irg::studio_map::translate, {x, y, z}}};
}

studio studio_of(const std::vector<event>& events) {
  studio s;
  for (const event& e : events) CHECK(apply_event(s, e) == irg::studio_status::done);
  return s;
}

pixels picture_of(const studio& s, int width = 160, int height = 60, const char* sentence = "") {
  pixels p(width, height);
  memory m;
  irg::draw_studio(p.view(), s, m, sentence);
  return p;
}
pixels view_of(const studio& s, studio_view v = studio_view::main, int width = 96, int height = 72) {
  pixels p(width, height);
  memory m;
  irg::draw_studio_view(p.view(), s, v, m);
  return p;
}

bool same(const pixels& a, const pixels& b) {
  bool equal = a.width() == b.width() && a.height() == b.height();
  for (int y = 0; equal && y < a.height(); ++y) equal = std::equal(a.row(y), a.row(y) + a.width(), b.row(y));
  return equal;
}
int count(const pixels& p, const irg::rgba8& colour) {
  int n = 0;
  for (int y = 0; y < p.height(); ++y) n += static_cast<int>(std::count(p.row(y), p.row(y) + p.width(), colour));
  return n;
}

std::vector<event> four_bodies() {
  return {load("teapot", irg::shape_teapot<double>({3})),
          load("cube", irg::shape_cube<double>()),
          load("cube", irg::shape_cube<double>()),
          load("torus", irg::shape_torus<double>()),
          moved("cube", -3, 0, 0),
          moved("cube(2)", 2.5, 0, 1.5),
          moved("torus", 0, 0, 2.5)};
}

}  // namespace

TEST_CASE("studio picture: a body of many surfaces is kept in parts of its size") {
  irg::mesh<double> m = irg::shape_sphere<double>({.slices = 24, .stacks = 24});
  irg::stored_body<double> b = irg::store_body("ball", m);
  b.surfaces.assign(m.face_count(), b.surfaces[0]);
  for (std::uint32_t f = 0; f < m.face_count(); f += 2)
    b.surface_of_face[f] = static_cast<std::uint32_t>(m.face_count()) - f - 1;
  const studio s = studio_of({irg::load_body<double>{b}});
  memory kept;
  pixels many(96, 72);
  irg::draw_studio_view(many.view(), s, studio_view::main, kept);
  CHECK(same(many, view_of(studio_of({load("ball", m)}))));
  std::size_t positions = 0;
  for (const auto& part : kept.views[0].bodies[0].parts) positions += part.shape.positions.size();
  CHECK(positions <= m.corners.size());
}

TEST_CASE("studio picture: of faces alone it is the renderer's, in every shading and projection, by three lamps") {
  studio s = studio_of({load("teapot", irg::shape_teapot<double>({4})), irg::colour_body{"teapot", {250, 20, 90, 255}},
                        irg::set_lamp<double>{1, {{3, -2, 0.5, 0}, {0.5, 0.25, 1}}},
                        irg::set_lamp<double>{2, {{0.5, 8, -1, 1}, {0.125, 1, 0}}}});
  CHECK(apply_event(s, moved("teapot", 0.5, -1, 0)) == irg::studio_status::done);
  const irg::rgb<float> decoded = irg::decode({250, 20, 90, 255});
  const irg::rgb<double> light{irg::widened(decoded.r), irg::widened(decoded.g), irg::widened(decoded.b)};
  irg::object<double> o{irg::shape_teapot<double>({4}), irg::translation(irg::vec<double, 3>{0.5, -1, 0})};
  o.shape.normals.clear();
  for (auto& c : o.shape.corners) c.normal = irg::no_index;
  o.surface = {light, light, {}, 1};
  for (const auto kind :
       {irg::projection_kind::perspective, irg::projection_kind::orthographic, irg::projection_kind::oblique}) {
    CHECK(apply_event(s, irg::set_projection<double>{studio_view::main, kind}) == irg::studio_status::done);
    irg::scene<double> world{{o}, irg::camera_of(s.of(studio_view::main)), s.lamps};
    for (auto& [position, part] : world.lights)  // what the light from everywhere leaves
      part = {0.75 * part.r, 0.75 * part.g, 0.75 * part.b};
    world.ambient = {0.25, 0.25, 0.25};
    for (const auto& [shading, style] : {std::pair{irg::studio_shading::flat, irg::picture_style::flat},
                                         std::pair{irg::studio_shading::gouraud, irg::picture_style::gouraud},
                                         std::pair{irg::studio_shading::phong, irg::picture_style::phong}})
      for (const display backs : {display::hidden, display::shown}) {
        CHECK(apply_event(s, irg::shade_body{{}, shading}) == irg::studio_status::done);
        CHECK(apply_event(s, irg::show_part{{}, studio_part::backs, backs}) == irg::studio_status::done);
        pixels expected(96, 72);
        irg::image<float> depth(96, 72);
        irg::render(world, {expected, depth},
                    {.style = style,
                     .culling = backs == display::shown ? irg::face_culling::none : irg::face_culling::back,
                     .colours = {.background = colours.background}});
        const pixels seen = view_of(s);
        CHECK(same(seen, expected));
        CHECK(count(seen, colours.background) < 96 * 72 - 500);
      }
  }
  // Without shading a body has its colour.
  CHECK(apply_event(s, irg::shade_body{{}, irg::studio_shading::none}) == irg::studio_status::done);
  const pixels plain = view_of(s);
  CHECK(count(plain, {250, 20, 90, 255}) + count(plain, colours.background) == 96 * 72);
}

TEST_CASE("studio picture: bodies with Phong shading, whose shaders move as they become more, are the renderer's") {
  studio s = studio_of({});
  irg::scene<double> world;
  world.ambient = {0.25, 0.25, 0.25};
  const irg::rgb<float> decoded = irg::decode({250, 20, 90, 255});
  const irg::rgb<double> light{irg::widened(decoded.r), irg::widened(decoded.g), irg::widened(decoded.b)};
  const char* const names[] = {"cube", "cube(2)", "cube(3)", "cube(4)", "cube(5)"};
  for (int i = 0; i < 5; ++i) {
    const irg::vec<double, 3> to{1.5 * i - 3, 0.5 * i, -0.25 * i};
    CHECK(apply_event(s, load("cube", irg::shape_cube<double>())) == irg::studio_status::done);
    CHECK(apply_event(s, irg::colour_body{names[i], {250, 20, 90, 255}}) == irg::studio_status::done);
    CHECK(apply_event(s, moved(names[i], to.x, to.y, to.z)) == irg::studio_status::done);
    irg::object<double> o{irg::shape_cube<double>(), irg::translation(to)};
    o.shape.normals.clear();
    for (auto& c : o.shape.corners) c.normal = irg::no_index;
    o.surface = {light, light, {}, 1};
    world.objects.push_back(o);
  }
  CHECK(apply_event(s, irg::shade_body{{}, irg::studio_shading::phong}) == irg::studio_status::done);
  world.view = irg::camera_of(s.of(studio_view::main));
  world.lights = {{s.lamps[0].position, {0.75, 0.75, 0.75}}};
  pixels expected(96, 72);
  irg::image<float> depth(96, 72);
  irg::render(world, {expected, depth},
              {.style = irg::picture_style::phong,
               .culling = irg::face_culling::back,
               .colours = {.background = colours.background}});
  CHECK(same(view_of(s), expected));
  CHECK(count(expected, colours.background) < 96 * 72 - 500);
}

TEST_CASE(
    "studio picture: the same bytes whatever the order of events that do not meet, and whatever was drawn before") {
  std::vector<event> changes{irg::colour_body{"teapot", {200, 120, 60, 255}},
                             irg::shade_body{"teapot", irg::studio_shading::gouraud},
                             irg::show_part{"cube", studio_part::edges, display::shown},
                             irg::show_part{"cube(2)", studio_part::points, display::shown},
                             irg::set_opacity<double>{"torus", 0.5},
                             irg::orbit_camera<double>{studio_view::main, 20, 10, 1.5},
                             irg::show_helper{studio_view::main, irg::studio_helper::world_axes, display::shown},
                             irg::set_light<double>{{1, 2, 3, 0}, 0.5}};
  studio first = studio_of(four_bodies());
  for (const event& e : changes) CHECK(apply_event(first, e) == irg::studio_status::done);
  const pixels expected = picture_of(first);
  memory used;
  pixels p(160, 60);
  for (int turn = 0; turn < 8; ++turn) {
    std::rotate(changes.begin(), changes.begin() + 3, changes.end());
    if (turn % 2 != 0) std::reverse(changes.begin(), changes.end());
    studio s = studio_of(four_bodies());
    CHECK(irg::run_studio<double>(s, changes, p.view(), used) == irg::studio_status::done);
    CHECK(s == first);
    CHECK(same(p, expected));
    const event other[] = {irg::drop_body{"cube"}, moved("teapot", turn, 0, 0)};
    (void)irg::run_studio<double>(s, other, p.view(), used);
    CHECK_FALSE(same(p, expected));
  }
}

TEST_CASE("studio picture: an event that cannot be leaves all but its sentence") {
  studio s = studio_of(four_bodies());
  const pixels before = picture_of(s);
  auto broken = irg::store_body("b", irg::shape_cube<double>());
  broken.shape.positions[0].x = std::numeric_limits<double>::infinity();
  const event events[] = {irg::load_body<double>{broken}};
  memory m;
  pixels p(160, 60);
  CHECK(irg::run_studio<double>(s, events, p.view(), m) == irg::studio_status::not_finite);
  CHECK(same(p, picture_of(s, 160, 60, "a number is not finite")));
  CHECK_FALSE(same(p, before));
  CHECK(irg::run_studio<double>(s, {}, p.view(), m) == irg::studio_status::done);
  CHECK(same(p, before));
}

TEST_CASE("studio picture: points, edges, faces and backs of a cube seen from its front") {
  // From straight ahead: the back's edges lie within the front's square.
  studio s = studio_of({load("cube", irg::shape_cube<double>()), moved("cube", -0.5, -0.5, -0.5),
                        irg::aim_camera<double>{studio_view::main, {0, 0, 2.5}, {0, 0, 0}},
                        irg::show_part{"cube", studio_part::edges, display::shown}});
  const auto with = [&](studio_part part, display how) {
    CHECK(apply_event(s, irg::show_part{{}, part, how}) == irg::studio_status::done);
    return view_of(s);
  };
  const pixels solid = view_of(s);
  const int front = count(solid, colours.edge);
  CHECK(front > 100);
  // The front hides the back, but for the pixels beside its corners.
  CHECK(count(with(studio_part::backs, display::shown), colours.edge) <= front + 16);
  const pixels all_edges = with(studio_part::faces, display::hidden);
  CHECK(count(all_edges, colours.edge) > front + 80);
  CHECK(count(with(studio_part::backs, display::hidden), colours.edge) == front);  // left out
  CHECK(count(view_of(s), colours.background) + front == 96 * 72);
  CHECK(count(with(studio_part::points, display::shown), colours.dot) == 8 * 9);
  with(studio_part::faces, display::shown);
  const int dots = count(view_of(s), colours.dot);
  CHECK(dots == 4 * 9);
}

TEST_CASE("studio picture: transparent bodies let through what is behind them, opaque ones hide it") {
  std::vector<event> events{load("cube", irg::shape_cube<double>()),
                            load("cube", irg::shape_cube<double>()),
                            irg::aim_camera<double>{studio_view::main, {0, 0, 9}, {0, 0, 0}},
                            irg::shade_body{{}, irg::studio_shading::none},
                            irg::colour_body{"cube", {255, 0, 0, 255}},
                            irg::colour_body{"cube(2)", {0, 0, 255, 255}},
                            moved("cube(2)", 0, 0, 3)};
  studio s = studio_of(events);
  CHECK(count(view_of(s), {255, 0, 0, 255}) == 0);
  for (const auto shading : {irg::studio_shading::none, irg::studio_shading::gouraud, irg::studio_shading::phong}) {
    CHECK(apply_event(s, irg::shade_body{"cube(2)", shading}) == irg::studio_status::done);
    CHECK(apply_event(s, irg::set_opacity<double>{"cube(2)", 0}) == irg::studio_status::done);
    studio without = s;
    CHECK(apply_event(without, irg::drop_body{"cube(2)"}) == irg::studio_status::done);
    CHECK(same(view_of(s), view_of(without)));
    CHECK(apply_event(s, irg::set_opacity<double>{"cube(2)", 0.5}) == irg::studio_status::done);
    const pixels through = view_of(s);
    const irg::rgba8 middle = through(48, 36);
    CHECK(middle.r > 100);
    CHECK(middle.b > 40);
    CHECK(count(through, {255, 0, 0, 255}) == 0);  // smaller, and behind all of the glass
  }
  // An opacity of the surface counts as well.
  CHECK(apply_event(s, irg::set_opacity<double>{"cube(2)", 1}) == irg::studio_status::done);
  s.bodies[1].body.surfaces[0].colour.a = 0;
  CHECK(count(view_of(s), {255, 0, 0, 255}) > 100);
}

TEST_CASE("studio picture: faces have the colours of their surfaces") {
  auto b = irg::store_body("cube", irg::shape_cube<double>());
  b.surfaces = {{{255, 0, 0, 255}}, {{0, 255, 0, 255}}};
  for (std::size_t f = 0; f < b.surface_of_face.size(); ++f)
    b.surface_of_face[f] = f % 3 == 2 ? irg::no_index : static_cast<std::uint32_t>(f % 3);
  const studio s = studio_of({irg::load_body<double>{b}, irg::shade_body{{}, irg::studio_shading::none}});
  const pixels p = view_of(s);
  const int red = count(p, {255, 0, 0, 255}), green = count(p, {0, 255, 0, 255}),
            white = count(p, {255, 255, 255, 255});
  CHECK(red > 50);
  CHECK(green > 50);
  CHECK(white > 50);
  CHECK(red + green + white + count(p, colours.background) == 96 * 72);
}

TEST_CASE("studio picture: both cameras see what transformations behind the camera do") {
  studio s = studio_of({load("cube", irg::shape_cube<double>())});
  const pixels main = view_of(s), outer = view_of(s, studio_view::outer);
  CHECK(apply_event(s,
                    irg::add_transformation<double>{
                        "cube", irg::studio_stage::after, {irg::studio_map::translate, {0.8, 0, 0}}}) ==
        irg::studio_status::done);
  const auto centre = [&](const pixels& p) {
    int n = 0, sum = 0;
    for (int y = 0; y < p.height(); ++y)
      for (int x = 0; x < p.width(); ++x)
        if (p(x, y) != colours.background) sum += x, ++n;
    return sum / n;
  };
  CHECK(centre(view_of(s)) > centre(main) + 5);  // to the right, as the main camera sees it
  CHECK_FALSE(same(view_of(s, studio_view::outer), outer));
}

TEST_CASE("studio picture: helpers in either view, and none") {
  studio s;
  for (const studio_view v : {studio_view::main, studio_view::outer})
    for (const auto h : {irg::studio_helper::world_axes, irg::studio_helper::camera_axes, irg::studio_helper::camera,
                         irg::studio_helper::pyramid})
      CHECK(apply_event(s, irg::show_helper{v, h, display::hidden}) == irg::studio_status::done);
  CHECK(count(view_of(s, studio_view::outer), colours.background) == 96 * 72);
  CHECK(apply_event(s, irg::show_helper{studio_view::outer, irg::studio_helper::pyramid, display::shown}) ==
        irg::studio_status::done);
  CHECK(count(view_of(s, studio_view::outer), colours.pyramid) > 50);
  CHECK(apply_event(s, irg::show_helper{studio_view::outer, irg::studio_helper::camera, display::shown}) ==
        irg::studio_status::done);
  CHECK(count(view_of(s, studio_view::outer), colours.camera) > 10);
  for (const auto kind : {irg::projection_kind::orthographic, irg::projection_kind::oblique}) {
    CHECK(apply_event(s, irg::set_projection<double>{studio_view::main, kind}) == irg::studio_status::done);
    CHECK(count(view_of(s, studio_view::outer), colours.pyramid) > 50);
  }
  CHECK(apply_event(s, irg::show_helper{studio_view::main, irg::studio_helper::world_axes, display::shown}) ==
        irg::studio_status::done);
  for (const auto& axis : colours.axis) CHECK(count(view_of(s), axis) > 5);
}

TEST_CASE("studio picture: bodies behind the eye of a projection, and what nobody would draw") {
  studio s = studio_of(four_bodies());
  studio without = s;
  CHECK(apply_event(without, irg::drop_body{"cube"}) == irg::studio_status::done);
  // The cube reaches from x = -3 to -2: an eye at -2.5 has parts of it on both sides of itself.
  CHECK(apply_event(s,
                    irg::add_transformation<double>{
                        "cube", irg::studio_stage::before, {irg::studio_map::central, {1, 0, 0, 5, -2.5, 0, 0}}}) ==
        irg::studio_status::done);
  CHECK(same(picture_of(s), picture_of(without)));
  // From farther off it has a shadow.
  CHECK(apply_event(s, irg::remove_transformation{"cube", irg::studio_stage::before, 1}) == irg::studio_status::done);
  CHECK(apply_event(s,
                    irg::add_transformation<double>{
                        "cube", irg::studio_stage::before, {irg::studio_map::central, {0, 1, 0, 2, 0, 8, 0}}}) ==
        irg::studio_status::done);
  CHECK_FALSE(same(picture_of(s), picture_of(without)));

  for (const auto& [width, height] :
       {std::pair{1, 1}, std::pair{2, 1}, std::pair{3, 50}, std::pair{90, 2}, std::pair{0, 0}})
    picture_of(s, width, height, "a sentence");
  for (const double size : {1e-300, 1e-150, 1e100, 1e150, 1e300}) {
    studio extreme = s;
    const auto camera = [&](double far_off) {
      return irg::aim_camera<double>{studio_view::main, {far_off, far_off, 2 * far_off}, {0, 0, 0}};
    };
    CHECK(apply_event(extreme, camera(size)) == irg::studio_status::done);
    CHECK(apply_event(extreme,
                      irg::add_transformation<double>{
                          {}, irg::studio_stage::before, {irg::studio_map::scale, {size, size, size}}}) ==
          irg::studio_status::done);
    CHECK(apply_event(extreme,
                      irg::add_transformation<double>{
                          {}, irg::studio_stage::after, {irg::studio_map::scale, {size, 1, size}}}) ==
          irg::studio_status::done);
    for (const auto kind :
         {irg::projection_kind::perspective, irg::projection_kind::orthographic, irg::projection_kind::oblique}) {
      if (apply_event(extreme, irg::set_projection<double>{studio_view::main, kind, 1e300, 1e300}) ==
          irg::studio_status::done)
        picture_of(extreme, 40, 20);
      if (apply_event(extreme, irg::set_projection<double>{studio_view::main, kind, 30, 100}) ==
          irg::studio_status::done)
        picture_of(extreme, 40, 20);
    }
    for (const irg::view_pyramid<double>& p :
         {irg::view_pyramid<double>{1, 1e-300, 1, 1, 2}, {1, 1, 1e-12, 1, 2}, {1e-300, 2, 2, 1e-300, 1e300}})
      if (apply_event(extreme, irg::set_pyramid<double>{studio_view::main, p}) == irg::studio_status::done)
        picture_of(extreme, 40, 20);
  }
}

TEST_CASE("studio picture: at compile time the bytes of run time") {
  constexpr auto hash = [] {
    irg::mesh<double> m;
    m.positions = {{-2, -2, 0}, {3, -1, 0}, {0, 3, 1}};
    irg::add_face(m, std::initializer_list<int>{0, 1, 2});
    studio s;
    (void)apply_event(s, irg::load_body<double>{irg::store_body("a", m)});
    (void)apply_event(s, irg::show_part{"a", studio_part::edges, display::shown});
    pixels p(8, 6);
    memory memory;
    irg::draw_studio_view(p.view(), s, studio_view::main, memory);
    std::uint32_t h = 17;
    for (int y = 0; y < 6; ++y)
      for (int x = 0; x < 8; ++x) h = h * 31 + p(x, y).r * 5u + p(x, y).g * 3u + p(x, y).b;
    return h;
  };
  constexpr std::uint32_t made = hash();
  CHECK(hash() == made);
}
