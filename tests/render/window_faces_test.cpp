// SPDX-License-Identifier: MIT
#include <irg/render/window_faces.hpp>

#include <array>
#include <cmath>

#include <irg/core/threads.hpp>
#include <irg/hidden/bsp_faces.hpp>
#include <irg/hidden/painter_newell.hpp>
#include <irg/hidden/ray_casting.hpp>
#include <irg/hidden/warnock.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/render/render.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rendered.hpp"
#include "support/scenes.hpp"
#include "support/ulp.hpp"

namespace {

// The picture's rule pixel by pixel: of the faces that cover a centre the nearest, of equally near ones the first.
struct nearest_of_all {
  template <class Faces>
  constexpr void operator()(const Faces& faces, const irg::cell_window& w, irg::image<std::uint32_t>& ids,
                            irg::draw_counts& counts) const {
    std::vector<irg::screen_face> all;
    for (std::size_t i = 0; i < faces.size(); ++i) all.push_back(faces[i]);
    for (int y = w.y_first; y < w.y_last; ++y)
      for (int x = w.x_first; x < w.x_last; ++x) {
        const irg::screen_face* first = nullptr;
        for (const irg::screen_face& f : all) {
          if (!covers(f, x, y)) continue;
          ++counts.tested;
          if (first == nullptr || irg::is_nearer(f, *first, x, y)) first = &f;
        }
        if (first != nullptr) ids(x, y) = first->number;
      }
  }
};

// Triangles that lie nearly in one plane: all corners on it but for a part in 10^5 to 10^7 of the distance.
irg::scene<double> nearly_coplanar(test::random& r, int triangles) {
  irg::scene<double> world;
  world.view = {{0, 0, 0}, {0, 0, -1}};
  world.view.near_distance = 0.1;
  world.ambient = {1, 1, 1};
  const auto between = [&r](double low, double high) { return low + (high - low) * r.unit(); };
  const double right = between(-0.7, 0.7), up = between(-0.7, 0.7), away = between(2, 30),
               hair = std::pow(10.0, between(-8, -5));
  for (int i = 0; i < triangles; ++i) {
    irg::object<double> o;
    for (int k = 0; k < 3; ++k) {
      const double x = between(-1, 1), y = between(-1, 1), z = -1 / (1 + right * x + up * y);
      const double distance = away * (1 + hair * between(-1, 1));
      o.shape.positions.push_back({-x * z * distance, -y * z * distance, z * distance});
    }
    irg::add_face(o.shape, std::array{0, 1, 2});
    const double red = between(0, 1), green = between(0, 1);
    o.surface.ambient = {red, green, 0.5};
    world.objects.push_back(o);
  }
  return world;
}

// Pixels in which a picture or its depths differ from those of the z-buffer.
template <class Method>
int pixels_that_differ(const Method& method, const irg::scene<double>& world, const irg::render_options& options,
                       const test::canvas& expected) {
  const int width = expected.colour.width(), height = expected.colour.height();
  test::canvas drawn(width, height);
  irg::render_with(method, world, {drawn.colour, drawn.depth}, options);
  int n = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      n += drawn.colour(x, y) == expected.colour(x, y) && drawn.depth(x, y) == expected.depth(x, y) ? 0 : 1;
  return n;
}

TEST_CASE("hidden-surface methods: one picture with the z-buffer where triangles lie a hair apart") {
  test::random r(94);
  const int scenes = test::is_release_tier() ? 20000 : 300;
  int differing = 0;
  for (int i = 0; i < scenes; ++i) {
    const auto world = nearly_coplanar(r, i % 2 == 0 ? 2 : 6);
    irg::render_options options{.style = irg::picture_style::flat, .culling = irg::face_culling::none};
    if (i % 3 == 0) options.skip = irg::skip_nothing;
    const test::canvas expected = test::render(world, 100, 70, options).picture;
    differing += pixels_that_differ(irg::warnock<>{}, world, options, expected);
    differing += pixels_that_differ(irg::painter_newell<>{}, world, options, expected);
    differing += pixels_that_differ(irg::bsp_painter<>{}, world, options, expected);
    if (i % 8 == 0) differing += pixels_that_differ(irg::ray_casting<>{}, world, options, expected);
    // The order of objects changes numbers, and so ties, but no thread, pick or preparation changes anything.
    test::canvas again(100, 70);
    irg::prepared_scene<double> ready = irg::prepare_scene(world);
    irg::render(ready, {again.colour, again.depth}, options, irg::parallel{2});
    CHECK(again == expected);
  }
  CHECK(differing == 0);
}

// What a method that shows nothing gives, and one that shows faces where they are not.
struct nothing_at_all {
  template <class Faces>
  constexpr void operator()(const Faces&, const irg::cell_window&, irg::image<std::uint32_t>&,
                            irg::draw_counts&) const {}
};
struct everywhere {
  std::uint32_t number;
  template <class Faces>
  void operator()(const Faces&, const irg::cell_window& w, irg::image<std::uint32_t>& ids, irg::draw_counts&) const {
    for (int y = w.y_first; y < w.y_last; ++y)
      for (int x = w.x_first; x < w.x_last; ++x) ids(x, y) = number;
  }
};

TEST_CASE("hidden-surface methods: one that follows the picture's rule gives the z-buffer's bytes") {
  test::random r(12);
  for (int i = 0; i < 60; ++i) {
    const auto world = test::random_scene<double>(r, 10, test::positions::ordinary);
    irg::render_options options;
    options.style = static_cast<irg::picture_style>(r.integer(1, 3));
    options.culling = r.integer(0, 1) == 0 ? irg::face_culling::none : irg::face_culling::back;
    if (r.integer(0, 3) == 0) options.intensities = irg::intensity_range::rescale;
    if (r.integer(0, 3) == 0) options.skip = irg::skip_nothing;
    const int width = static_cast<int>(r.integer(1, 150)), height = static_cast<int>(r.integer(1, 100));
    const auto expected = test::render(world, width, height, options);
    test::canvas drawn(width, height);
    const auto stats =
        irg::render_with(nearest_of_all{}, world, {drawn.colour, drawn.depth}, options, irg::parallel{2});
    REQUIRE(drawn == expected.picture);
    CHECK(stats.pixels.shaded == expected.stats.pixels.shaded);
    CHECK(stats.drawn == expected.stats.drawn);
    CHECK(stats.triangles == expected.stats.triangles);
    CHECK(stats.skipped.frustum == expected.stats.skipped.frustum);
    CHECK(stats.clipped == expected.stats.clipped);
  }
}

TEST_CASE("hidden-surface methods: what covers nothing is not drawn, whatever a method says") {
  irg::scene<double> world;
  world.objects.push_back({irg::shape_cube<double>()});
  world.view.eye = {2, 3, 5};
  test::canvas nothing(80, 60), beside(80, 60), unknown(80, 60);
  irg::render_with(nothing_at_all{}, world, {nothing.colour, nothing.depth});
  CHECK(nothing.colour(40, 30) == irg::picture_colours{}.background);
  CHECK(irg::render_with(everywhere{12345}, world, {unknown.colour, unknown.depth}).drawn == 0);
  CHECK(unknown == nothing);
  // One triangle of the cube, where it is.
  const auto one =
      irg::render_with(everywhere{2}, world, {beside.colour, beside.depth}, {.culling = irg::face_culling::none});
  CHECK(one.drawn > 0);
  CHECK(one.drawn < 1000);
  CHECK(irg::render_with(nothing_at_all{}, irg::scene<double>{}, {nothing.colour, nothing.depth}) ==
        irg::render_counts{});
}

TEST_CASE("hidden-surface methods: what lies in the far plane is not drawn, as by the z-buffer") {
  irg::scene<double> world;
  world.view = {{0, 0, 0}, {0, 0, -1}};
  world.view.near_distance = 1;
  world.view.far_distance = 64;
  world.ambient = {1, 1, 1};
  irg::object<double> o;
  o.shape.positions = {{-40, -40, -64}, {40, -40, -64}, {0, 40, -64}, {0, 0, -32}};
  irg::add_face(o.shape, std::array{0, 1, 2});
  irg::add_face(o.shape, std::array{0, 1, 3});
  world.objects.push_back(o);
  const irg::render_options options{.style = irg::picture_style::flat};
  const auto expected = test::render(world, 40, 30, options);
  CHECK(expected.stats.drawn > 0);
  test::canvas drawn(40, 30);
  CHECK(irg::render_with(irg::ray_casting<>{}, world, {drawn.colour, drawn.depth}, options).drawn ==
        expected.stats.drawn);
  CHECK(drawn == expected.picture);
}

constexpr bool same_in_constant_evaluation() {
  irg::scene<double> world;
  world.objects.push_back({irg::shape_tetrahedron<double>()});
  world.lights = {{{1, 2, 3, 0}, {1, 1, 1}}};
  world.view.eye = {0, 0, 5};
  irg::image<irg::rgba8> a(8, 8), b(8, 8);
  irg::image<float> da(8, 8), db(8, 8);
  irg::render(world, {a, da});
  irg::render_with(nearest_of_all{}, world, {b, db});
  return a == b && da == db;
}

TEST_CASE("hidden-surface methods: in a constant expression") { CHECK_BOTH(same_in_constant_evaluation()); }

}  // namespace

namespace {

// Pictures by a method, of front faces alone, with the skip and without; how many faces the method was not asked about.
template <class Method>
std::int64_t faces_not_asked_about(const irg::scene<double>& world, const Method& method,
                                   irg::face_culling culling = irg::face_culling::back) {
  irg::render_options options;
  options.style = irg::picture_style::flat;
  options.culling = culling;
  test::canvas skipped(150, 110), asked(150, 110);
  const auto with = irg::render_with(method, world, {skipped.colour, skipped.depth}, options, irg::parallel{2});
  options.skip.convex = irg::skipping::off;
  const auto without = irg::render_with(method, world, {asked.colour, asked.depth}, options);
  CHECK(skipped == asked);
  CHECK(with.drawn == without.drawn);
  CHECK(without.pixels.convex == 0);
  return with.pixels.convex;
}

irg::scene<double> bodies_seen_from(const std::vector<irg::mesh<double>>& shapes, const irg::vec<double, 3>& apart,
                                    const irg::point<double, 3>& eye) {
  irg::scene<double> world;
  for (std::size_t i = 0; i < shapes.size(); ++i)
    world.objects.push_back({shapes[i], irg::translation(apart * static_cast<double>(i))});
  world.view.eye = eye;
  return world;
}

}  // namespace

TEST_CASE("hidden-surface methods: a convex body alone in a window needs none, and the bytes are the same") {
  const irg::vec<double, 3> beside{0.7, 0.2, -0.4}, far_away{30, 0, 0};
  const std::vector<irg::mesh<double>> convex{irg::shape_cube<double>(), irg::shape_tetrahedron<double>(),
                                              irg::shape_octahedron<double>()};
  const auto cube_from = [&](double x, double y, double z) { return bodies_seen_from({convex[0]}, beside, {x, y, z}); };
  // Alone, from aside, from close by so that the near plane and the picture's borders cut it, and from within.
  CHECK(faces_not_asked_about(cube_from(2, 3, 5), irg::warnock<>{}) > 0);
  CHECK(faces_not_asked_about(cube_from(1.01, 0.3, 1.02), irg::painter_newell<>{}) > 0);
  CHECK(faces_not_asked_about(cube_from(0.1, 0.2, 0.3), irg::bsp_painter<>{}) == 0);
  // From far away many faces of a body lie in a pixel, and edge on.
  for (const auto& shape : convex)
    for (const double distance : {3.0, 20.0, 40.0})
      CHECK(faces_not_asked_about(bodies_seen_from({shape}, beside, {distance, distance / 7, distance / 3}),
                                  irg::warnock<>{}) > 0);
  // Each method is asked where two bodies meet, and where their backs are shown; always about what is not convex, and by
  // a caller who says nothing of nearest faces.
  const auto all = bodies_seen_from(convex, beside, {2, 3, 5}), apart = bodies_seen_from(convex, far_away, {2, 3, 60});
  CHECK(faces_not_asked_about(apart, irg::painter_newell<>{}) > 0);
  CHECK(faces_not_asked_about(all, irg::painter_newell<>{}) >= 0);
  CHECK(faces_not_asked_about(all, irg::warnock<>{}, irg::face_culling::none) == 0);
  CHECK(faces_not_asked_about(bodies_seen_from({irg::shape_torus<double>()}, beside, {2, 3, 5}), irg::warnock<>{}) ==
        0);
  CHECK(faces_not_asked_about(all, nearest_of_all{}) == 0);
  // At random: seen from everywhere, some within others.
  test::random r(1616);
  std::int64_t skipped = 0;
  for (int i = 0; i < 30; ++i) {
    const auto place = [&] { return 8 * r.unit() - 4; };
    const double x = place(), y = place(), z = place(), by = 2 * r.unit();
    skipped += faces_not_asked_about(bodies_seen_from(convex, {by, by / 2, -by}, {x, y, z}), irg::warnock<>{});
  }
  CHECK(skipped > 0);
}
