// SPDX-License-Identifier: MIT
#include <studio/studio_events.hpp>

#include <limits>
#include <new>
#include <string>

#include <irg/mesh/shapes.hpp>

#include "mesh/short_memory.hpp"
#include "support/check_both.hpp"

namespace {

using studio = irg::studio<double>;
using irg::apply_event;
using enum irg::studio_status;

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();

irg::load_body<double> cube(const char* name = "kocka") { return {irg::store_body(name, irg::shape_cube<double>())}; }

std::string names(const studio& s) {
  std::string all;
  for (const auto& b : s.bodies) all += std::string(b.body.name) + ' ';
  return all;
}

// An event is refused for this reason, and nothing has changed.
template <class E>
void refused(studio& s, const E& e, irg::studio_status why) {
  const studio before = s;
  const irg::studio_status status = apply_event(s, e);
  CAPTURE(irg::sentence_of(status));
  CHECK(status == why);
  CHECK(s == before);
}

}  // namespace

TEST_CASE("studio events: equal names are numbered; what is dropped makes room") {
  studio s;
  for (int i = 0; i < 3; ++i) CHECK(apply_event(s, cube()) == done);
  CHECK(names(s) == "kocka kocka(2) kocka(3) ");
  CHECK(apply_event(s, irg::drop_body{"kocka(2)"}) == done);
  CHECK(names(s) == "kocka kocka(3) ");
  CHECK(apply_event(s, irg::studio_event<double>(cube())) == done);
  CHECK(apply_event(s, cube("gomb")) == done);
  CHECK(names(s) == "kocka kocka(3) kocka(2) gomb ");
  CHECK(apply_event(s, cube("a\"b\n")) == done);
  CHECK(names(s) == "kocka kocka(3) kocka(2) gomb a?b? ");
  refused(s, irg::drop_body{"kocka(4)"}, no_such_body);
  refused(s, irg::drop_body{}, no_such_body);
  for (int i = 0; i < 20; ++i) CHECK(apply_event(s, cube()) == done);
  CHECK(names(s).ends_with("kocka(22) kocka(23) "));
}

TEST_CASE("studio events: the first free number, whatever names there are, many of one name too") {
  const std::string_view wanted[] = {"a",    "a(2)",    "a(02)", "a(1)", "a(3)", "a()",
                                     "a(9)", "a(2)(2)", "a(2",   "b",    "a(x)"};
  studio s;
  irg::stored_body<double> small;
  for (int i = 0; i < 300; ++i) {
    small.name = wanted[(i * i + i / 7) % 11];
    std::string free(small.name);
    for (int n = 2; irg::find_body(s, free); ++n) free = std::string(small.name) + '(' + std::to_string(n) + ')';
    CHECK(apply_event(s, irg::load_body<double>{small}) == done);
    CHECK(s.bodies.back().body.name == irg::part_name(free));
    if (s.bodies.size() > 40) CHECK(apply_event(s, irg::drop_body{s.bodies[9].body.name}) == done);
  }
  s = {};
  small.name = "a";
  for (int i = 0; i < 1500; ++i) CHECK(apply_event(s, irg::load_body<double>{small}) == done);
  CHECK(s.bodies.back().body.name == irg::part_name("a(1500)"));
}

TEST_CASE("studio events: at compile time") {
  CHECK_BOTH([] {
    irg::studio<double> s;
    irg::mesh<double> m;
    m.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    irg::add_face(m, std::initializer_list<int>{0, 1, 2});
    for (int i = 0; i < 2; ++i)
      if (apply_event(s, irg::load_body<double>{irg::store_body("a", m)}) != done) return false;
    m.positions[0].x = std::numeric_limits<double>::infinity();
    return apply_event(s, irg::load_body<double>{irg::store_body("a", m)}) == not_finite && s.bodies.size() == 2 &&
           s.bodies[1].body.name == irg::part_name("a(2)") &&
           apply_event(s, irg::set_opacity<double>{"a(2)", 0.25}) == done && s.bodies[1].opacity == 0.25 &&
           apply_event(s, irg::drop_body{"a"}) == done && s.bodies.size() == 1;
  }());
}

TEST_CASE("studio events: a broken body leaves the studio as it was") {
  studio s;
  CHECK(apply_event(s, cube()) == done);
  auto broken = cube();
  broken.body.shape.positions[3].y = nan;
  refused(s, broken, not_finite);
  broken = cube();
  broken.body.shape.corners[5].position = 8;
  refused(s, broken, broken_faces);
  broken = cube();
  broken.body.shape.face_starts[1] = 0;
  refused(s, broken, broken_faces);
  broken = cube();
  broken.body.edges[0].to = 0xffffffff;
  refused(s, broken, edge_without_point);
  broken = cube();
  broken.body.surface_of_face.pop_back();
  refused(s, broken, broken_surface);
  broken = cube();
  broken.body.surface_of_face[2] = 1;
  refused(s, broken, broken_surface);
  broken = cube();
  broken.body.surfaces[0].reflection.shininess = 0;
  refused(s, broken, broken_surface);
  broken = cube();
  broken.body.surfaces[0].reflection.diffuse.g = -1;
  refused(s, broken, broken_surface);
  broken = cube("");
  refused(s, broken, no_name);
  CHECK(names(s) == "kocka ");
  // Normals, texture coordinates and parts are not the studio's.
  auto with_normals = cube();
  irg::mesh<double>& m = with_normals.body.shape;
  m.normals = {{0, 0, 1}};
  for (auto& c : m.corners) c.normal = 0;
  CHECK(apply_event(s, with_normals) == done);
  CHECK(s.bodies[1].body.shape == cube().body.shape);
  // A body of nothing is one.
  CHECK(apply_event(s, irg::load_body<double>{irg::store_body("none", irg::mesh<double>{})}) == done);
}

TEST_CASE("studio events: looks of one body and of all") {
  studio s;
  for (int i = 0; i < 3; ++i) CHECK(apply_event(s, cube()) == done);
  CHECK(apply_event(s, irg::show_part{"kocka(2)", irg::studio_part::edges, irg::display::shown}) == done);
  CHECK(apply_event(s, irg::show_part{{}, irg::studio_part::backs, irg::display::shown}) == done);
  CHECK(apply_event(s, irg::shade_body{{}, irg::studio_shading::phong}) == done);
  CHECK(apply_event(s, irg::set_opacity<double>{"kocka", 0.5}) == done);
  CHECK(apply_event(s, irg::colour_body{"kocka(3)", {1, 2, 3, 255}}) == done);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& b = s.bodies[i];
    CHECK(b.shows(irg::studio_part::edges) == (i == 1));
    CHECK(b.shows(irg::studio_part::backs));
    CHECK(b.shows(irg::studio_part::faces));
    CHECK(b.shading == irg::studio_shading::phong);
    CHECK(b.opacity == (i == 0 ? 0.5 : 1));
    CHECK((b.body.surfaces[0].colour == irg::rgba8{1, 2, 3, 255}) == (i == 2));
  }
  refused(s, irg::set_opacity<double>{"kocka", 1.5}, bad_opacity);
  refused(s, irg::set_opacity<double>{"kocka", nan}, bad_opacity);
  refused(s, irg::shade_body{"x", irg::studio_shading::flat}, no_such_body);
  auto bare = cube("bare");
  bare.body.surfaces.clear();
  bare.body.surface_of_face.assign(12, irg::no_index);
  CHECK(apply_event(s, bare) == done);
  CHECK(apply_event(s, irg::colour_body{"bare", {9, 9, 9, 255}}) == done);
  CHECK(s.bodies[3].body.surfaces.size() == 1);
  CHECK(s.bodies[3].body.surface_of_face[11] == 0);
}

TEST_CASE("studio events: lists of transformations, added to, reordered, taken from") {
  studio s;
  CHECK(apply_event(s, cube()) == done);
  const auto before = irg::studio_stage::before, after = irg::studio_stage::after;
  for (const double x : {1.0, 2.0, 3.0, 4.0})
    CHECK(apply_event(s, irg::add_transformation<double>{{}, before, {irg::studio_map::translate, {x}}}) == done);
  CHECK(apply_event(s, irg::add_transformation<double>{"kocka", after, {irg::studio_map::rotate_z, {30}}}) == done);
  const auto order = [&] {
    std::string all;
    for (const auto& t : s.bodies[0].transformations[0]) all += std::to_string(static_cast<int>(t.numbers[0]));
    return all;
  };
  CHECK(order() == "1234");
  CHECK(apply_event(s, irg::move_transformation{"kocka", before, 0, 2}) == done);
  CHECK(order() == "2314");
  CHECK(apply_event(s, irg::move_transformation{"kocka", before, 3, 0}) == done);
  CHECK(order() == "4231");
  CHECK(apply_event(s, irg::move_transformation{"kocka", before, 1, 1}) == done);
  CHECK(order() == "4231");
  CHECK(apply_event(s, irg::change_transformation<double>{"kocka", before, 1, {irg::studio_map::translate, {7}}}) ==
        done);
  CHECK(order() == "4731");
  refused(s, irg::change_transformation<double>{"kocka", before, 4, {}}, no_such_transformation);
  refused(s, irg::change_transformation<double>{"kocka", before, 0, {irg::studio_map::mirror, {}}}, no_matrix);
  refused(s, irg::change_transformation<double>{"gomb", before, 0, {}}, no_such_body);
  CHECK(apply_event(s, irg::change_transformation<double>{"kocka", before, 1, {irg::studio_map::translate, {2}}}) ==
        done);
  CHECK(apply_event(s, irg::remove_transformation{"kocka", before, 3}) == done);
  CHECK(order() == "423");
  CHECK(s.bodies[0].transformations[1].size() == 1);
  refused(s, irg::move_transformation{"kocka", before, 0, 3}, no_such_transformation);
  refused(s, irg::move_transformation{"kocka", before, std::size_t(-1), 0}, no_such_transformation);
  refused(s, irg::remove_transformation{"kocka", after, 1}, no_such_transformation);
  refused(s, irg::add_transformation<double>{"kocka", after, {irg::studio_map::mirror, {0, 0, 0, 1}}}, no_matrix);
  refused(s, irg::add_transformation<double>{"kocka", after, {irg::studio_map::scale, {1, inf, 1}}}, no_matrix);
  refused(s, irg::add_transformation<double>{"gomb", after, {irg::studio_map::scale, {1, 1, 1}}}, no_such_body);
}

TEST_CASE("studio events: cameras, and those that are none") {
  studio s;
  const auto main = irg::studio_view::main, outer = irg::studio_view::outer;
  CHECK(apply_event(s, irg::aim_camera<double>{main, {0, 0, 10}, {0, 0, 0}}) == done);
  CHECK(apply_event(s, irg::orbit_camera<double>{main, 90, 0}) == done);
  const auto& c = s.of(main);
  CHECK(c.eye.x == doctest::Approx(10));
  CHECK(c.eye.z == doctest::Approx(0).scale(10));
  CHECK(apply_event(s, irg::orbit_camera<double>{main, 0, 1000, 0.5}) == done);  // as far as the pole
  CHECK(c.eye.y == doctest::Approx(5));
  CHECK(irg::length(c.up) == doctest::Approx(1));
  CHECK(apply_event(s, irg::orbit_camera<double>{main, 0, -45}) == done);  // and away from it again
  CHECK(c.eye.y == doctest::Approx(5 * irg::sin(irg::radians(45.0))));
  CHECK(apply_event(s, irg::see_along<double>{outer, irg::isometric<double>().to_viewer}) == done);
  const auto& o = s.of(outer);
  CHECK(o.projection == irg::projection_kind::orthographic);
  CHECK(o.eye.x == doctest::Approx(o.eye.z));
  CHECK(o.eye.x == doctest::Approx(o.eye.y));
  CHECK(apply_event(s, irg::set_projection<double>{outer, irg::projection_kind::oblique, 30, 1}) == done);
  CHECK(apply_event(s, irg::set_projection<double>{outer, irg::projection_kind::perspective}) == done);
  CHECK(o.oblique_degrees == 30);  // kept
  CHECK(apply_event(s, irg::set_pyramid<double>{outer, {1, 2, 3, 4, 5}}) == done);
  CHECK(apply_event(s, irg::show_helper{main, irg::studio_helper::camera_axes, irg::display::shown}) == done);
  CHECK(c.shows(irg::studio_helper::camera_axes));
  CHECK(apply_event(s, irg::set_light<double>{{0, 1, 0, 0}, 0.5}) == done);

  refused(s, irg::aim_camera<double>{main, {1, 1, 1}, {1, 1, 1}}, eye_in_target);
  refused(s, irg::aim_camera<double>{main, {1, nan, 1}, {1, 1, 1}}, not_finite);
  refused(s, irg::aim_camera<double>{main, {1.5e308, 0, 0}, {-1.5e308, 0, 0}}, eye_in_target);
  refused(s, irg::orbit_camera<double>{main, 0, inf}, not_finite);
  refused(s, irg::orbit_camera<double>{main, 0, 0, 0}, eye_in_target);
  refused(s, irg::see_along<double>{main, {}}, eye_in_target);
  refused(s, irg::see_along<double>{main, {nan, 0, 1}}, not_finite);
  refused(s, irg::set_projection<double>{main, irg::projection_kind::oblique, nan, 1}, not_finite);
  for (const irg::view_pyramid<double>& p : {irg::view_pyramid<double>{0, 2, 2, 1, 2},
                                             {1, -2, 2, 1, 2},
                                             {1, 2, 0, 1, 2},
                                             {1, 2, 2, 0, 2},
                                             {1, 2, 2, 2, 2},
                                             {1, 2, 2, 1, inf},
                                             {1, 2, 2, nan, 2},
                                             {1, 5e-324, 1e308, 1, 2}})
    refused(s, irg::set_pyramid<double>{main, p}, no_projection);
  refused(s, irg::set_light<double>{{0, 1, 0, 0}, 2}, bad_light);
  refused(s, irg::set_light<double>{{0, inf, 0, 0}, 0}, not_finite);
}

TEST_CASE("studio events: lamps are added, changed and dropped; light puts one in place of all") {
  studio s;
  REQUIRE(s.lamps.size() == 1);
  const irg::light<double> red{{1, 2, 3, 1}, {1, 0, 0}}, sun{{0, 1, 0, 0}, {0.5, 0.5, 0.25}};
  refused(s, irg::set_lamp<double>{2, red}, no_such_lamp);
  CHECK(apply_event(s, irg::set_lamp<double>{1, red}) == done);
  CHECK(apply_event(s, irg::set_lamp<double>{0, sun}) == done);
  CHECK(s.lamps == std::vector{sun, red});
  refused(s, irg::set_lamp<double>{0, {{0, nan, 0, 1}, {1, 1, 1}}}, not_finite);
  for (const double part : {-0.1, 1.5, nan})
    for (int k = 0; k < 3; ++k) {
      irg::light<double> bad = red;
      (k == 0 ? bad.intensity.r : k == 1 ? bad.intensity.g : bad.intensity.b) = part;
      refused(s, irg::set_lamp<double>{1, bad}, bad_lamp);
    }
  refused(s, irg::drop_lamp{2}, no_such_lamp);
  CHECK(apply_event(s, irg::drop_lamp{0}) == done);
  CHECK(s.lamps == std::vector{red});
  CHECK(apply_event(s, irg::drop_lamp{0}) == done);
  refused(s, irg::drop_lamp{0}, no_such_lamp);
  CHECK(apply_event(s, irg::set_ambient<double>{0.75}) == done);
  refused(s, irg::set_ambient<double>{-1}, bad_light);
  refused(s, irg::set_ambient<double>{nan}, bad_light);
  CHECK((s.lamps.empty() && s.ambient == 0.75));
  for (std::size_t i = 0; i < 3; ++i) CHECK(apply_event(s, irg::set_lamp<double>{i, red}) == done);
  CHECK(apply_event(s, irg::set_light<double>{{0, 1, 0, 0}, 0.5}) == done);
  CHECK(s.lamps == std::vector{irg::light<double>{{0, 1, 0, 0}, {1, 1, 1}}});
  CHECK(s.ambient == 0.5);
}

TEST_CASE("studio events: a sentence for each status") {
  for (int i = 0; i <= static_cast<int>(no_such_lamp); ++i)
    CHECK(std::string(irg::sentence_of(static_cast<irg::studio_status>(i))).size() > 3);
}

#ifdef __cpp_exceptions
TEST_CASE("studio events: where memory gives out, all bodies change or none") {
  studio plain;
  for (int i = 0; i < 3; ++i) {
    auto e = cube();
    e.body.surfaces.clear();
    for (std::uint32_t& f : e.body.surface_of_face) f = irg::no_index;
    CHECK(apply_event(plain, e) == done);
  }
  const auto try_each = [&](const auto& event) {
    for (long left = 0;; ++left) {
      studio s = plain;
      test::allocations_left = left;
      bool failed = false;
      try {
        static_cast<void>(apply_event(s, event));
      } catch (const std::bad_alloc&) {
        failed = true;
      }
      test::allocations_left = -1;
      REQUIRE(left < 20);
      CHECK((s == plain) == failed);
      if (!failed) return;
    }
  };
  try_each(irg::add_transformation<double>{{}, irg::studio_stage::before, {irg::studio_map::translate, {1, 2, 3}}});
  try_each(irg::colour_body{{}, {1, 2, 3, 255}});
  try_each(irg::set_light<double>{{1, 2, 3, 1}, 0.5});
  try_each(irg::set_lamp<double>{1, {{1, 2, 3, 1}, {1, 1, 1}}});
}
#endif
