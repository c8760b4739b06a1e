// SPDX-License-Identifier: MIT
#include <irg/render/shade_visible.hpp>

#include <irg/colour/srgb.hpp>
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

TEST_CASE("shade_visible: the ids of draw_visibility become the picture of draw_batches") {
  test::random r(5);
  for (int i = 0; i < 150; ++i) {
    const int width = static_cast<int>(r.integer(1, 140)), height = static_cast<int>(r.integer(1, 90));
    const auto to_clip = irg::perspective(1.2, static_cast<double>(width) / height, 0.3, 50.0) *
                         irg::translation(irg::vec<double, 3>{0, 0, -1.5});
    const auto mapping = irg::map_to_screen<double>(width, height);
    const auto first = irg::make_drawable(test::random_mesh<double>(r, 12, test::positions::ordinary));
    const auto second = irg::make_drawable(test::random_mesh<double>(r, 5, test::positions::ordinary));
    const auto a = irg::project_vertices<double>(first.positions, to_clip, mapping),
               b = irg::project_vertices<double>(second.positions, to_clip, mapping);
    const irg::triangle_batch<double> batches[] = {
        {&a, first.triangles, 0, 0}, {&b, second.triangles, static_cast<std::uint32_t>(first.triangles.size()), 1}};
    const auto culling = r.integer(0, 1) == 0 ? irg::face_culling::none : irg::face_culling::back;
    const irg::draw_settings<irg::rgba8> settings{culling, {}, irg::clearing::before_drawing, {9, 8, 7, 6}};
    irg::image<irg::rgba8> expected(width, height), colour(width, height);
    irg::image<float> expected_depth(width, height), id_depth(width, height), depth(width, height);
    irg::image<std::uint32_t> ids(width, height);
    irg::draw_batches(irg::render_target{expected, expected_depth}, {batches, mapping}, telling_shaders{}, settings);
    irg::draw_visibility({ids, id_depth}, {batches, mapping}, {culling, {}, irg::clearing::before_drawing});
    irg::shade_visible(irg::render_target{colour, depth}, {ids, {batches, mapping}}, telling_shaders{}, settings);
    REQUIRE(colour == expected);
    REQUIRE(depth == expected_depth);
    REQUIRE(depth == id_depth);
  }
}

}  // namespace
