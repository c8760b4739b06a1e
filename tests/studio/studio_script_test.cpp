// SPDX-License-Identifier: MIT
#include <studio/studio_script.hpp>

#include <string>
#include <string_view>

#include <doctest/doctest.h>

namespace {

using command = irg::studio_command<double>;
using irg::studio_action;

std::string error_of(std::string_view text) {
  const auto r = irg::read_studio_script<double>(text);
  if (r) return "none";
  return std::to_string(r.error().line) + ":" + std::to_string(r.error().column) + " " + r.error().message;
}
command only(std::string_view text) {
  const auto r = irg::read_studio_script<double>(text);
  CAPTURE(text);
  REQUIRE(r.has_value());
  REQUIRE(r->size() == 1);
  return (*r)[0];
}
template <class E>
E event_of(std::string_view text) {
  const command c = only(text);
  REQUIRE(c.action == studio_action::event);
  REQUIRE(std::holds_alternative<E>(c.event));
  return std::get<E>(c.event);
}

}  // namespace

TEST_CASE("studio script: each event by its word") {
  CHECK(event_of<irg::drop_body>("drop kocka").name == irg::part_name("kocka"));
  CHECK(event_of<irg::drop_body>("  drop \"a b(2)\"  # gone").name == irg::part_name("a b(2)"));
  CHECK(event_of<irg::shade_body>("shade * phong").name.empty());
  CHECK(event_of<irg::shade_body>("shade \"*\" phong").name == irg::part_name("*"));
  CHECK(event_of<irg::shade_body>("shade *a phong").name == irg::part_name("*a"));
  const auto show = event_of<irg::show_part>("show kocka backs off");
  CHECK(show.part == irg::studio_part::backs);
  CHECK(show.how == irg::display::hidden);
  CHECK(event_of<irg::set_opacity<double>>("opacity * 0.1").opacity == 0.1);
  CHECK(event_of<irg::colour_body>("colour * 1 20 255").colour == irg::rgba8{1, 20, 255, 255});
  const auto add = event_of<irg::add_transformation<double>>("add kocka after rotate 1 0 0 -22.5");
  CHECK(add.stage == irg::studio_stage::after);
  CHECK(add.transformation == irg::studio_transformation<double>{irg::studio_map::rotate, {1, 0, 0, -22.5}});
  for (const irg::studio_map_form& form : irg::studio_maps) {
    std::string line = "add * before " + std::string(form.name);
    for (std::size_t i = 1; i <= form.numbers; ++i) line += " " + std::to_string(i);
    const auto t = event_of<irg::add_transformation<double>>(line).transformation;
    CHECK(irg::studio_maps[static_cast<std::size_t>(t.kind)].name == form.name);
    for (std::size_t i = 0; i < 16; ++i) CHECK(t.numbers[i] == (i < form.numbers ? static_cast<double>(i) + 1 : 0));
  }
  const auto move = event_of<irg::move_transformation>("move kocka before 3 1");
  CHECK(move.from == 2);
  CHECK(move.to == 0);
  CHECK(event_of<irg::remove_transformation>("remove kocka after 1").which == 0);
  const auto change = event_of<irg::change_transformation<double>>("change kocka after 3 rotate-x 7");
  CHECK(change.stage == irg::studio_stage::after);
  CHECK(change.which == 2);
  CHECK(change.transformation == irg::studio_transformation<double>{irg::studio_map::rotate_x, {7}});
  CHECK(event_of<irg::set_ambient<double>>("ambient 0.5").ambient == 0.5);
  CHECK(event_of<irg::drop_lamp>("drop-lamp 2").which == 1);
  const auto lamp = event_of<irg::set_lamp<double>>("lamp 2 1 2 3 0 0.5 0.25 1");
  CHECK(lamp.which == 1);
  CHECK(lamp.lamp == irg::light<double>{{1, 2, 3, 0}, {0.5, 0.25, 1}});
  CHECK(event_of<irg::set_lamp<double>>("lamp 1 1 2 3 1").lamp == irg::light<double>{{1, 2, 3, 1}, {1, 1, 1}});
  CHECK(error_of("lamp 0 1 2 3 1") == "1:6 lamps are counted from 1");
  CHECK(error_of("lamp 1 1 2 3") == "1:13 line ends where a number is expected");
  CHECK(error_of("lamp 1 1 2 3 1 0.5") == "1:19 line ends where a number is expected");
  CHECK(error_of("change kocka before 1 mirror 0 0 0 1") == "1:23 transformation has no matrix");
  const auto aim = event_of<irg::aim_camera<double>>("aim outer 1 2 3 4 5 6");
  CHECK(aim.view == irg::studio_view::outer);
  CHECK(aim.target == irg::point<double, 3>{4, 5, 6});
  CHECK(aim.up == irg::vec<double, 3>{0, 1, 0});
  CHECK(event_of<irg::aim_camera<double>>("aim main 1 2 3 4 5 6 0 0 1").up == irg::vec<double, 3>{0, 0, 1});
  CHECK(event_of<irg::orbit_camera<double>>("orbit main 10 20").factor == 1);
  CHECK(event_of<irg::orbit_camera<double>>("orbit main 10 20 0.5").factor == 0.5);
  CHECK(event_of<irg::set_pyramid<double>>("pyramid main 1 2 3 4 5").pyramid ==
        irg::view_pyramid<double>{1, 2, 3, 4, 5});
  CHECK(event_of<irg::show_helper>("helper outer camera-axes on").helper == irg::studio_helper::camera_axes);
  CHECK(event_of<irg::set_light<double>>("light 1 2 3 0 0.5").lamp == irg::hpoint<double, 3>{1, 2, 3, 0});
}

TEST_CASE("studio script: every projection") {
  using projection = irg::set_projection<double>;
  CHECK(event_of<projection>("project main perspective").kind == irg::projection_kind::perspective);
  CHECK(event_of<projection>("project main orthographic").kind == irg::projection_kind::orthographic);
  const auto oblique = [](const char* line, double angle, double factor) {
    const auto e = event_of<projection>(line);
    CHECK(e.kind == irg::projection_kind::oblique);
    CHECK(e.oblique_degrees == angle);
    CHECK(e.oblique_factor == factor);
  };
  oblique("project outer cavalier", 45, 1);
  oblique("project outer cavalier 30", 30, 1);
  oblique("project outer cabinet 60", 60, 0.5);
  oblique("project outer oblique 10 0.75", 10, 0.75);
  CHECK(event_of<irg::see_along<double>>("project main isometric").to_viewer == irg::isometric<double>().to_viewer);
  CHECK(event_of<irg::see_along<double>>("project main dimetric").to_viewer == irg::dimetric<double>().to_viewer);
  CHECK(event_of<irg::see_along<double>>("project main trimetric").to_viewer == irg::trimetric<double>().to_viewer);
}

TEST_CASE("studio script: files are the caller's, lines and columns known") {
  const auto r = irg::read_studio_script<double>(
      "\n# a script\r\nload a.obj\r\n\r  load \"my bodies.xml\" kocka # twice\npicture p.png outer\npicture q.png\n"
      "save s.xml\nrestore s.xml");
  REQUIRE(r.has_value());
  REQUIRE(r->size() == 6);
  const studio_action actions[] = {studio_action::load,    studio_action::load, studio_action::picture,
                                   studio_action::picture, studio_action::save, studio_action::restore};
  const std::size_t lines[] = {3, 5, 6, 7, 8, 9}, columns[] = {1, 3, 1, 1, 1, 1};
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK((*r)[i].action == actions[i]);
    CHECK((*r)[i].line == lines[i]);
    CHECK((*r)[i].column == columns[i]);
  }
  CHECK((*r)[1].file == irg::part_name("my bodies.xml"));
  CHECK((*r)[1].name == irg::part_name("kocka"));
  CHECK((*r)[0].name.empty());
  CHECK((*r)[2].view == irg::studio_view::outer);
  CHECK_FALSE((*r)[3].view.has_value());
  CHECK(irg::read_studio_script<double>("")->empty());
  CHECK(irg::read_studio_script<double>(" \n# nothing")->empty());
}

TEST_CASE("studio script: what is wrong, and where") {
  CHECK(irg::read_studio_script<double>("\xEF\xBB\xBFsave s.xml")->size() == 1);  // a byte order mark
  CHECK(error_of("\xEF\xBB\xBF jump") == "1:2 line begins with a word that is not known");
  CHECK(error_of("shw kocka") == "1:1 line begins with a word that is not known");
  CHECK(error_of("drop a\n\n  drop") == "3:7 expected the name of a body, or * for all");
  CHECK(error_of("drop a b") == "1:8 line goes on behind its end");
  CHECK(error_of("drop \"a\nb\"") == "1:6 quotes do not end on their line");
  CHECK(error_of("drop \"a\"b") == "1:9 expected a blank behind quotes");
  CHECK(error_of("drop \"\"") == "1:6 expected the name of a body, or * for all");
  CHECK(error_of("show a face on") == "1:8 part is none of points, edges, faces, backs");
  CHECK(error_of("show a faces yes") == "1:14 expected on or off");
  CHECK(error_of("opacity a nan") == "1:11 number is not finite");
  CHECK(error_of("opacity a 1e999") == "1:11 number is too large");
  CHECK(error_of("opacity a 0.5x") == "1:11 expected a decimal number");
  CHECK(error_of("colour a 1 2 256") == "1:14 part of a colour is not from 0 to 255");
  CHECK(error_of("colour a 1 2") == "1:13 line ends where a number is expected");
  CHECK(error_of("aim main 1 2 3 4 5 6 7 8") == "1:25 line ends where a number is expected");
  CHECK(error_of("aim left 1 2 3 4 5 6") == "1:5 view is neither main nor outer");
  CHECK(error_of("add a before mirror 0 0 0 1") == "1:14 transformation has no matrix");
  CHECK(error_of("add a before bend 1") == "1:14 transformation is not known");
  CHECK(error_of("add a during scale 1 1 1") == "1:7 expected before or after");
  CHECK(error_of("move a before 0 1") == "1:15 transformations are counted from 1");
  CHECK(error_of("move a before 1 2.5") == "1:17 expected a whole number");
  CHECK(error_of("project main fisheye") == "1:14 projection is not known");
  CHECK(error_of("helper main lens on") == "1:13 helper is none of axes, camera-axes, camera, pyramid");
  CHECK(error_of("picture a.png left") == "1:15 view is neither main nor outer");
  CHECK(error_of("load") == "1:5 expected the name of a file");
  CHECK(error_of("load a \"\"") == "1:8 expected the name of a body");
  CHECK(error_of("drop a\n\x01\xff") == "2:1 line begins with a word that is not known");
}
