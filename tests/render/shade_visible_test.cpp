// SPDX-License-Identifier: MIT
#include <irg/render/shade_visible.hpp>

#include <vector>

#include <irg/colour/srgb.hpp>
#include <irg/raster/screen_pieces.hpp>
#include <irg/render/drawable.hpp>
#include <irg/render/visibility_buffer.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/scenes.hpp"

namespace {

// A colour that tells the triangle, the side and the weights.
struct telling_shaders {
  auto operator()(const irg::triangle_batch<double>& batch, std::uint32_t triangle, irg::facing side) const {
    const auto number = static_cast<std::uint8_t>(batch.first_number + triangle);
    return [=](const irg::pixel_weights<float>& at) {
      return irg::rgba8{number, static_cast<std::uint8_t>(at.weight1 * 200),
                        static_cast<std::uint8_t>(at.weight2 * 200),
                        static_cast<std::uint8_t>(side == irg::facing::front ? 1 : 2)};
    };
  }
};

TEST_CASE("shade_visible: the ids of draw_visibility become the picture of shade_batches") {
  test::random r(5);
  for (int i = 0; i < 150; ++i) {
    const int width = static_cast<int>(r.integer(1, 140)), height = static_cast<int>(r.integer(1, 90));
    const auto to_clip = irg::perspective(1.2, static_cast<double>(width) / height, 0.3, 50.0) *
                         irg::translation(irg::vec<double, 3>{0, 0, -1.5});
    const auto mapping = irg::map_to_screen<double>({width, height});
    const auto first = irg::make_drawable(test::random_mesh<double>(r, 12, test::positions::ordinary));
    const auto second = irg::make_drawable(test::random_mesh<double>(r, 5, test::positions::ordinary));
    const auto a = irg::project_vertices<double>(first.positions, to_clip, mapping),
               b = irg::project_vertices<double>(second.positions, to_clip, mapping);
    const irg::triangle_batch<double> batches[] = {
        {&a, first.triangles, 0, 0}, {&b, second.triangles, static_cast<std::uint32_t>(first.triangles.size()), 1}};
    const auto culling = r.integer(0, 1) == 0 ? irg::face_culling::none : irg::face_culling::back;
    const irg::draw_options<irg::rgba8> settings{culling, {}, irg::clearing::before_drawing, {9, 8, 7, 6}};
    irg::image<irg::rgba8> expected(width, height), colour(width, height);
    irg::image<float> expected_depth(width, height), id_depth(width, height), depth(width, height);
    irg::image<std::uint32_t> ids(width, height);
    irg::shade_batches(irg::render_target{expected, expected_depth}, {batches, mapping}, telling_shaders{}, settings);
    irg::draw_visibility({ids, id_depth}, {batches, mapping}, {culling, {}, irg::clearing::before_drawing});
    irg::shade_visible(irg::render_target{colour, depth}, {ids, {batches, mapping}}, telling_shaders{}, settings);
    REQUIRE(colour == expected);
    REQUIRE(depth == expected_depth);
    REQUIRE(depth == id_depth);
  }
}

// In clip space, seen nearly from the edge and cut by the near plane: snapping turns one of the pieces round, and two
// others cover a centre, at different depths.
TEST_CASE("shade_visible: where two pieces of a triangle cover a pixel, the nearer one is shaded") {
  const irg::hpoint<double, 3> corner[3] = {
      {-0x1.c39b7d11fd578p+2, 0x1.48ebb7e4b83e8p+1, 0x1.f8dac1babcbe1p-1, 0x1.786328396305cp-1},
      {0x1.071e609ef85c8p+3, -0x1.790924337c468p+1, 0x1.8353407a2bf37p-9, 0x1.5e0f6d32187dbp+1},
      {0x1.67225638ad958p+4, -0x1.032436efccfcap+3, -0x1.29c856144ef76p+0, 0x1.a0db6687da553p+1}};
  irg::mat<double, 4, 4> to_clip{};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 4; ++k) to_clip(k, i) = corner[i][k];
  const std::vector<irg::point<double, 3>> units{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<irg::triangle_indices> triangle{{{0, 1, 2}}};
  const auto mapping = irg::map_to_screen<double>({74, 1});
  const auto vertices = irg::project_vertices<double>(units, to_clip, mapping);
  const auto pieces = irg::clip_to_screen(corner, mapping, 0);
  int most = 0;
  for (int x = 0; x < 74; ++x) {
    int covering = 0;
    for (const auto& p : pieces) covering += irg::covers(p.face, x, 0) ? 1 : 0;
    most = covering > most ? covering : most;
  }
  CHECK(most == 2);
  const irg::triangle_batch<double> batches[] = {{&vertices, triangle, 0, 0}};
  const irg::draw_options<irg::rgb<float>> settings{irg::face_culling::none, {}, irg::clearing::before_drawing};
  irg::image<irg::rgb<float>> expected(74, 1), colour(74, 1);
  irg::image<float> expected_depth(74, 1), depth(74, 1);
  irg::image<std::uint32_t> ids(74, 1);
  const auto weights = [](const auto&, std::uint32_t, irg::facing) {
    return [](const irg::pixel_weights<float>& at) { return irg::rgb<float>{at.weight1, at.weight2, at.depth}; };
  };
  irg::shade_batches(irg::render_target{expected, expected_depth}, {batches, mapping}, weights, settings);
  irg::draw_visibility({ids, depth}, {batches, mapping}, {irg::face_culling::none, {}, irg::clearing::before_drawing});
  irg::shade_visible(irg::render_target{colour, depth}, {ids, {batches, mapping}}, weights, settings);
  CHECK(colour == expected);
  CHECK(depth == expected_depth);
}

}  // namespace
