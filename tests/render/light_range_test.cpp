// SPDX-License-Identifier: MIT
// render_options::intensities: light over the display's range, cut off or scaled down.
#include <irg/render/render.hpp>

#include <algorithm>
#include <vector>
#include <limits>

#include <irg/core/threads.hpp>
#include <irg/mesh/mesh.hpp>

#include "support/check_both.hpp"
#include "support/rendered.hpp"
#include "support/scenes.hpp"
#include "support/ulp.hpp"

namespace {

using irg::intensity_range;
using irg::picture_style;
constexpr picture_style styles[] = {picture_style::flat, picture_style::gouraud, picture_style::phong};

template <class T>
void brighten(irg::scene<T>& s, T factor) {
  for (auto& l : s.lights) l.intensity = {l.intensity.r * factor, l.intensity.g * factor, l.intensity.b * factor};
  s.ambient = {s.ambient.r * factor, s.ambient.g * factor, s.ambient.b * factor};
}

irg::render_options options_of(picture_style style, intensity_range range) {
  irg::render_options o{style, irg::hidden_surface_method::zbuffer, irg::face_culling::none};
  o.intensities = range;
  return o;
}

int brightest(const irg::image<irg::rgba8>& p, irg::rgba8 background) {
  int most = -1;
  for (int y = 0; y < p.height(); ++y)
    for (int x = 0; x < p.width(); ++x)
      if (p(x, y) != background) most = std::max({most, int{p(x, y).r}, int{p(x, y).g}, int{p(x, y).b}});
  return most;
}

constexpr irg::rgba8 background = irg::picture_colours{}.background;

TEST_CASE("render, light range: clamping is what happens unless told otherwise") {
  CHECK_BOTH(irg::render_options{}.intensities == intensity_range::clamp);
}

TEST_CASE("render, light range: nothing over the range, and both ways give the same bytes") {
  test::random r(41);
  for (int i = 0; i < 60; ++i) {
    irg::scene<double> s = test::random_scene<double>(r, 12, static_cast<test::positions>(i % 3));
    brighten(s, 0.125);
    for (const picture_style style : styles)
      REQUIRE(test::render(s, 40, 30, options_of(style, intensity_range::rescale)).picture ==
              test::render(s, 40, 30, options_of(style, intensity_range::clamp)).picture);
  }
}

TEST_CASE("render, light range: scaled pictures reach the white of one channel, however bright the lights") {
  test::random r(42);
  int seen = 0;
  for (int i = 0; i < 40; ++i) {
    irg::scene<double> s = test::random_scene<double>(r, 12, test::positions::ordinary);
    brighten(s, 4096.0);
    for (const picture_style style : styles) {
      const auto one = test::render(s, 40, 30, options_of(style, intensity_range::rescale));
      if (one.stats.drawn == 0) continue;
      REQUIRE(brightest(one.picture.colour, background) == 255);
      irg::scene<double> brighter = s;
      brighten(brighter, 1024.0);
      REQUIRE(test::render(brighter, 40, 30, options_of(style, intensity_range::rescale)).picture == one.picture);
      ++seen;
    }
  }
  CHECK(seen > 60);
}

// A wall that fills the picture, one that is hidden by it, and one beside the picture.
irg::scene<double> walls(double hidden_ambient) {
  const auto wall = [](double x, double z, double size) {
    irg::mesh<double> m;
    m.positions = {{x - size, -size, z}, {x + 3 * size, -size, z}, {x - size, 3 * size, z}};
    irg::add_face(m, std::vector<int>{0, 1, 2});
    return m;
  };
  irg::scene<double> s;
  s.objects.push_back({wall(0, 0, 9)});
  s.objects.push_back({wall(0, -1, 3)});
  s.objects.push_back({wall(500, 0, 3)});
  s.objects[0].surface.ambient = {0.5, 1, 2};
  s.objects[1].surface.ambient = s.objects[2].surface.ambient = {hidden_ambient, 1, 1};
  s.ambient = {1, 1, 1};
  s.view.eye = {0, 0, 3};
  s.view.target = {0, 0, 0};
  return s;
}

TEST_CASE("render, light range: only what is seen counts, and hues stay") {
  for (const picture_style style : styles)
    for (const double hidden : {0.25, 1000.0})
      for (const irg::skip_options& skip : {irg::skip_options{}, irg::skip_nothing}) {
        irg::render_options o = options_of(style, intensity_range::rescale);
        o.skip = skip;
        const auto scaled = test::render(walls(hidden), 32, 20, o);
        CHECK(scaled.picture.colour == irg::image<irg::rgba8>(32, 20, irg::encode({0.25f, 0.5f, 1.0f})));
        o.intensities = intensity_range::clamp;
        const auto cut = test::render(walls(hidden), 32, 20, o);
        CHECK(cut.picture.colour == irg::image<irg::rgba8>(32, 20, irg::encode({0.5f, 1.0f, 1.0f})));
        CHECK(cut.picture.depth == scaled.picture.depth);
        CHECK(cut.stats == scaled.stats);
      }
}

TEST_CASE("render, light range: the same bytes for every executor, skips on and off, in drawing order too") {
  test::random r(43);
  const int scenes = test::is_release_tier() ? 3000 : 90;
  for (int i = 0; i < scenes; ++i) {
    irg::scene<float> s = test::random_scene<float>(r, 12, static_cast<test::positions>(i % 3));
    brighten(s, 3.0f);
    irg::render_options o = options_of(styles[i % 3], intensity_range::rescale);
    if (i / 3 % 3 == 0) o.hidden = irg::hidden_surface_method::none;
    const int width = static_cast<int>(r.integer(1, 90)), height = static_cast<int>(r.integer(1, 150));
    const auto one = test::render(s, width, height, o);
    REQUIRE(test::render(s, width, height, o, irg::parallel{1 + i % 7}).picture == one.picture);
    REQUIRE(test::render(s, width, height, o, test::backwards{}).picture == one.picture);
    o.skip = irg::skip_nothing;
    REQUIRE(test::render(s, width, height, o).picture == one.picture);
    // What clamping draws where, scaling draws there; the rest is background.
    o.intensities = intensity_range::clamp;
    const auto cut = test::render(s, width, height, o);
    REQUIRE(cut.picture.depth == one.picture.depth);
    REQUIRE(cut.stats.drawn == one.stats.drawn);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        if (cut.picture.colour(x, y) == background && one.picture.colour(x, y) != background)
          REQUIRE(cut.picture.depth(x, y) != 0.0f);
  }
}

TEST_CASE("render, light range: in a constant expression") {
  constexpr auto bright_wall = [] {
    irg::scene<double> s;
    irg::mesh<double> m;
    m.positions = {{-9, -9, 0}, {27, -9, 0}, {-9, 27, 0}};
    m.corners = {{0}, {1}, {2}};
    m.face_starts = {0, 3};
    s.objects.push_back({m});
    s.objects[0].surface.ambient = {0.5, 1, 2};
    s.ambient = {1, 1, 1};
    s.view.eye = {0, 0, 3};
    return s;
  };
  constexpr auto options = [](intensity_range range) {
    irg::render_options o;
    o.style = picture_style::phong;
    o.intensities = range;
    return o;
  };
  constexpr irg::rgba8 scaled = irg::encode({0.25f, 0.5f, 1.0f}), cut = irg::encode({0.5f, 1.0f, 1.0f});
  static_assert(test::render_constant(bright_wall(), 2, 2, options(intensity_range::rescale)).picture.colour(1, 1) ==
                scaled);
  static_assert(test::render_constant(bright_wall(), 2, 2, options(intensity_range::clamp)).picture.colour(1, 1) ==
                cut);
  CHECK(test::render(bright_wall(), 2, 2, options(intensity_range::rescale)).picture.colour(1, 1) == scaled);
  CHECK(test::render(bright_wall(), 2, 2, options(intensity_range::clamp)).picture.colour(1, 1) == cut);
}

}  // namespace
