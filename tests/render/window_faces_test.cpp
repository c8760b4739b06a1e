// SPDX-License-Identifier: MIT
#include <irg/render/window_faces.hpp>

#include <irg/core/threads.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/render/render.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rendered.hpp"
#include "support/scenes.hpp"

namespace {

// The picture's rule pixel by pixel: of the faces that cover a centre the nearest, of equally near ones the first.
struct nearest_of_all {
  template <class Faces>
  constexpr void operator()(const Faces& faces, const irg::cell_window& w, irg::image<std::uint32_t>& ids,
                            irg::draw_counts& counts) const {
    irg::image<float> nearest(w.x_last, w.y_last, 0.0f);  // the far plane: what lies there is not drawn
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const irg::screen_face f = faces[i];
      const irg::triangle_setup setup = irg::set_up_face(f);
      irg::covered_spans(f.coverage, w, [&](const irg::span_of_cells& s) {
        for (int x = s.x_first; x < s.x_last; ++x) {
          ++counts.tested;
          const float depth = irg::depth_at(setup, x, s.y);
          if (!(nearest(x, s.y) < depth)) continue;
          nearest(x, s.y) = depth;
          ids(x, s.y) = f.number;
        }
      });
    }
  }
};

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
    const auto stats = irg::render(nearest_of_all{}, world, drawn.colour, drawn.depth, options, irg::parallel{2});
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
  irg::render(nothing_at_all{}, world, nothing.colour, nothing.depth);
  CHECK(nothing.colour(40, 30) == irg::picture_colours{}.background);
  CHECK(irg::render(everywhere{12345}, world, unknown.colour, unknown.depth).drawn == 0);
  CHECK(unknown == nothing);
  // One triangle of the cube, where it is.
  const auto one = irg::render(everywhere{2}, world, beside.colour, beside.depth, {.culling = irg::face_culling::none});
  CHECK(one.drawn > 0);
  CHECK(one.drawn < 1000);
  CHECK(irg::render(nothing_at_all{}, irg::scene<double>{}, nothing.colour, nothing.depth) == irg::render_stats{});
}

constexpr bool same_in_constant_evaluation() {
  irg::scene<double> world;
  world.objects.push_back({irg::shape_tetrahedron<double>()});
  world.lights = {{{1, 2, 3, 0}, {1, 1, 1}}};
  world.view.eye = {0, 0, 5};
  irg::image<irg::rgba8> a(8, 8), b(8, 8);
  irg::image<float> da(8, 8), db(8, 8);
  irg::render(world, a, da);
  irg::render(nearest_of_all{}, world, b, db);
  return a == b && da == db;
}

TEST_CASE("hidden-surface methods: in a constant expression") { CHECK_BOTH(same_in_constant_evaluation()); }

}  // namespace
