// SPDX-License-Identifier: MIT
#include <studio/studio_file.hpp>

#include <algorithm>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <irg/mesh/shapes.hpp>

#include <doctest/doctest.h>

namespace {

using studio = irg::studio<double>;
using irg::apply_event;

std::string text_of(const studio& s) {
  const auto bytes = irg::encode_studio(s);
  REQUIRE(bytes.has_value());
  return {bytes->begin(), bytes->end()};
}
std::string error_of(std::string_view text) {
  const auto r = irg::read_studio<double>(text);
  if (r) return "none";
  return std::to_string(r.error().line) + ":" + std::to_string(r.error().column) + " " + r.error().message;
}

// Whatever events come, possible ones or not.
irg::studio_event<double> any_event(std::mt19937_64& random) {
  const auto upto = [&](int n) { return std::uniform_int_distribution<int>(0, n)(random); };
  const auto number = [&]() -> double {
    switch (upto(9)) {
      case 0: return 0;
      case 1: return std::uniform_real_distribution<double>(-1e300, 1e300)(random);
      case 2: return 5e-324;
      case 3: return 1.0 / 0.0 - (upto(1) == 0 ? 1.0 / 0.0 : 0.0);
      default: return std::uniform_real_distribution<double>(-10, 10)(random);
    }
  };
  constexpr const char* names[] = {"", "kocka", "kocka(2)", "a & b", "<\"q\">", "nobody", "k\xC3\xBA"};
  const irg::part_name name = names[upto(6)];
  const auto view = static_cast<irg::studio_view>(upto(1));
  const auto stage = static_cast<irg::studio_stage>(upto(1));
  const auto how = static_cast<irg::display>(upto(1));
  switch (upto(15)) {
    case 0: {
      auto b = irg::store_body(name, upto(1) == 0 ? irg::shape_cube<double>() : irg::shape_tetrahedron<double>());
      b.shape.positions[0].x = number();
      return irg::load_body<double>{b};
    }
    case 1: return upto(5) == 0 ? irg::drop_body{name} : irg::drop_body{"nobody"};
    case 2: return irg::show_part{name, static_cast<irg::studio_part>(upto(3)), how};
    case 3: return irg::shade_body{name, static_cast<irg::studio_shading>(upto(3))};
    case 4: return irg::set_opacity<double>{name, upto(1) == 0 ? number() : 0.1 * upto(10)};
    case 5: return irg::colour_body{name, {static_cast<std::uint8_t>(upto(255)), 7, 9, 255}};
    case 6:
    case 7: {
      irg::studio_transformation<double> t{static_cast<irg::studio_map>(upto(10)), {}};
      for (std::size_t i = 0; i < irg::studio_maps[static_cast<std::size_t>(t.kind)].numbers; ++i)
        t.numbers[i] = number();
      if (upto(4) == 0) return irg::change_transformation<double>{name, stage, static_cast<std::size_t>(upto(2)), t};
      return irg::add_transformation<double>{name, stage, t};
    }
    case 8:
      return irg::move_transformation{name, stage, static_cast<std::size_t>(upto(3)),
                                      static_cast<std::size_t>(upto(3))};
    case 9: return irg::remove_transformation{name, stage, static_cast<std::size_t>(upto(5))};
    case 10:
      return irg::aim_camera<double>{
          view, {number(), number(), number()}, {number(), number(), number()}, {number(), number(), number()}};
    case 11: return irg::orbit_camera<double>{view, number(), number(), number()};
    case 12: return irg::set_projection<double>{view, static_cast<irg::projection_kind>(upto(2)), number(), number()};
    case 13: return irg::see_along<double>{view, {number(), number(), number()}};
    case 14: return irg::set_pyramid<double>{view, {number(), number(), number(), number(), number()}};
    default:
      if (upto(1) == 0) return irg::show_helper{view, static_cast<irg::studio_helper>(upto(3)), how};
      if (upto(2) == 0)
        return irg::set_lamp<double>{static_cast<std::size_t>(upto(3)),
                                     {{number(), number(), number(), number()}, {0.1 * upto(10), 0.3, 0.1 * upto(11)}}};
      if (upto(3) == 0) return irg::drop_lamp{static_cast<std::size_t>(upto(2))};
      if (upto(3) == 0) return irg::set_ambient<double>{number()};
      return irg::set_light<double>{{number(), number(), number(), number()}, 0.1 * upto(12)};
  }
}

}  // namespace

TEST_CASE("studio file: after any events the state reads back the same, refused ones having changed nothing") {
  int done = 0, refused = 0, bodies = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    std::mt19937_64 random(seed);
    studio s;
    for (int i = 0; i < 60; ++i) {
      const studio before = s;
      if (apply_event(s, any_event(random)) == irg::studio_status::done) {
        ++done;
      } else {
        ++refused;
        CHECK(s == before);
      }
    }
    bodies += static_cast<int>(s.bodies.size());
    const std::string text = text_of(s);
    const auto back = irg::read_studio<double>(text);
    CAPTURE(seed);
    if (!back) {
      CAPTURE(error_of(text));
      FAIL_CHECK("not read");
      continue;
    }
    CHECK(*back == s);
    CHECK(text_of(*back) == text);
  }
  CHECK(done > 1000);
  CHECK(refused > 500);
  CHECK(bodies > 60);
}

TEST_CASE("studio file: no lamp, one and several; a white one alone is the line that older readers know") {
  studio s;
  CHECK(text_of(s).find("<studio:event line=\"light -5 10 8 1 0.25\"/>") != std::string::npos);
  const auto comes_back = [&] {
    const auto back = irg::read_studio<double>(text_of(s));
    return back.has_value() && *back == s;
  };
  CHECK(apply_event(s, irg::drop_lamp{0}) == irg::studio_status::done);
  CHECK(comes_back());
  for (std::size_t i = 0; i < 12; ++i) {
    CHECK(apply_event(s, irg::set_lamp<double>{i, {{0.1 * static_cast<double>(i), 1, 2, 0}, {1, 0.5, 0.1}}}) ==
          irg::studio_status::done);
    CHECK(comes_back());
  }
  CHECK(text_of(s).find("line=\"lamp 12 1.1 1 2 0 1 0.5 0.1\"") != std::string::npos);
}

TEST_CASE("studio file: cameras that no other projection or distance has read back, too") {
  const auto main = irg::studio_view::main;
  const auto same = [](const studio& s) { return irg::read_studio<double>(text_of(s)); };
  const auto parallel = [&](double away, const irg::view_pyramid<double>& p) {
    studio s;
    const irg::aim_camera<double> aim{main, {0, 0, away}, {0, 0, 0}};
    CHECK(apply_event(s, irg::set_projection<double>{main, irg::projection_kind::orthographic}) ==
          irg::studio_status::done);
    if (away < 1) CHECK(apply_event(s, aim) == irg::studio_status::done);
    CHECK(apply_event(s, irg::set_pyramid<double>{main, p}) == irg::studio_status::done);
    CHECK(apply_event(s, aim) == irg::studio_status::done);
    return s;
  };
  // Screens that perspective has no angle for: too near, too low and far away.
  for (const studio& s : {parallel(1, {1e-300, 1, 1, 1, 2}), parallel(1e-300, {1e-300, 1, 1, 1, 2}),
                          parallel(1e300, {1, 1e-310, 1e-310, 1, 2})})
    CHECK((same(s).has_value() && *same(s) == s));
  studio s = parallel(0.5, {1, 8, 8, 1, 2});  // a factor that greater distances have no room for
  CHECK(apply_event(s, irg::set_projection<double>{main, irg::projection_kind::oblique, 30, 1.5e308}) ==
        irg::studio_status::done);
  CHECK((same(s).has_value() && *same(s) == s));
  CHECK(apply_event(s, irg::set_projection<double>{main}) == irg::studio_status::done);
  CHECK((same(s).has_value() && *same(s) == s));
  // So small a screen that its perspective from other eyes has no matrix.
  studio small;
  CHECK(apply_event(small, irg::set_pyramid<double>{main, {1.7e308, 14.78, 7.39, 0.36, 20}}) ==
        irg::studio_status::done);
  CHECK(apply_event(small, irg::aim_camera<double>{main, {0, 0, 1}, {0, 0, 0}}) == irg::studio_status::no_projection);
  CHECK((same(small).has_value() && *same(small) == small));
}

TEST_CASE("studio file: it is a file of bodies, and a file of bodies is one") {
  studio s;
  CHECK(apply_event(s, irg::load_body<double>{irg::store_body("kocka", irg::shape_cube<double>())}) ==
        irg::studio_status::done);
  CHECK(apply_event(s, irg::set_opacity<double>{"kocka", 0.5}) == irg::studio_status::done);
  const std::string text = text_of(s);
  const auto bodies = irg::read_body_xml<double>(text);
  REQUIRE(bodies.has_value());
  CHECK(bodies->size() == 1);
  CHECK((*bodies)[0] == s.bodies[0].body);
  const auto bytes = irg::encode_body_xml(*bodies);
  const auto fresh = irg::read_studio<double>(std::string(bytes->begin(), bytes->end()));
  REQUIRE(fresh.has_value());
  CHECK(fresh->bodies[0].body == s.bodies[0].body);
  std::string annotated = text;  // text of other programs beside and within the events
  annotated.insert(annotated.find("<studio:event"), "notes <x:y>z</x:y><![CDATA[<studio:event/>]]>");
  annotated.insert(annotated.find("<points>"), "<x:author>somebody</x:author>");
  const auto same = irg::read_studio<double>(annotated);
  REQUIRE(same.has_value());
  CHECK(*same == s);
  CHECK(fresh->bodies[0].opacity == 1);
}

TEST_CASE("studio file: no part of a broken state comes out") {
  studio s;
  CHECK(apply_event(s, irg::load_body<double>{irg::store_body("kocka", irg::shape_tetrahedron<double>())}) ==
        irg::studio_status::done);
  const std::string text = text_of(s);
  for (std::size_t n = 0; n + 1 < text.size(); n += 7) CHECK(error_of(text.substr(0, n)) != "none");
  const auto with = [&](std::string_view line) {
    std::string changed = text;
    const std::size_t at = changed.find("light ");
    return changed.replace(at, changed.find('"', at) - at, line);
  };
  const std::string place = error_of(with("shw"));
  CHECK(place.ends_with("line begins with a word that is not known"));
  const auto lines = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find("light ")), '\n');
  CHECK(place.starts_with(std::to_string(lines + 1) + ":25 "));
  CHECK(error_of(with("drop nobody")).ends_with("no body has this name"));
  CHECK(error_of(with("load /etc/passwd")).ends_with("line is not one event"));
  CHECK(error_of(with("save x.xml")).ends_with("line is not one event"));
  CHECK(error_of(with("")).ends_with("line is not one event"));
  CHECK(error_of(with("&bomb;")) != "none");
  CHECK(error_of("<!DOCTYPE bodies [<!ENTITY a \"b\">]><bodies/>") != "none");
  CHECK(error_of("<bodies><studio:event/></bodies>") == "1:10 line is not one event");
  CHECK(error_of("<bodies/>") == "none");
  CHECK(error_of("<body><points/><faces/></body>") == "1:2 body has no name");
  CHECK(error_of("\xEF\xBB\xBF<bodies><x:y><body/></x:y>\n <body name='a'><points/><faces/></body>\n"
                 "<body><points/><faces/></body></bodies>") == "3:2 body has no name");
  CHECK(error_of("<bodies>\n<o:x>text<![CDATA[<body/>]]><body/></o:x><body><points/><faces/></body></bodies>") ==
        "2:43 body has no name");  // text of others does not stop the look for its place
  CHECK(error_of("<bodies>\n<body name='a'><surfaces><surface ambient='1.7e308 1.7e308 1'/></surfaces><points/><faces/>"
                 "</body></bodies>") == "2:2 body has a surface that is none");
}
