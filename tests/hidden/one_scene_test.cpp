// SPDX-License-Identifier: MIT
// One scene by every method: the same picture, and none but the z-buffer has memory for depths.
#include <irg/hidden/classical_methods.hpp>

#include "large_blocks.hpp"
#include "method_scenes.hpp"
#include "one_scene.hpp"
#include "support/check_both.hpp"

#include <irg/hidden/bsp_scene.hpp>

namespace {

struct outcome {
  test::id_image ids;
  std::size_t depth_buffers;
};
// What a method finds, and how many blocks of memory it took that have room for a depth in every pixel.
template <class Method>
outcome by(const Method& method, const test::face_list& faces) {
  outcome o{test::id_image(one_scene::width, one_scene::height, irg::no_index), 0};
  irg::draw_counts counts;
  test::large_block = std::size_t{4} * one_scene::width * one_scene::height;
  test::large_blocks = 0;
  method(faces, irg::cell_window{0, 0, one_scene::width, one_scene::height}, o.ids, counts);
  o.depth_buffers = test::large_blocks;
  test::large_block = ~std::size_t{0};
  return o;
}

struct with_depths {
  void operator()(const test::face_list& faces, const irg::cell_window& w, test::id_image& ids,
                  irg::draw_counts&) const {
    irg::image<float> nearest(w.x_last, w.y_last, 0.0f);
    for (const irg::screen_face& f : faces)
      irg::covered_spans(f.coverage, w, [&](const irg::span_of_cells& s) {
        for (int x = s.x_first; x < s.x_last; ++x)
          if (const float z = depth_at(irg::set_up_face(f), x, s.y); nearest(x, s.y) < z)
            nearest(x, s.y) = z, ids(x, s.y) = f.number;
      });
  }
};

TEST_CASE("one scene, every method: one picture, and depths are kept by the z-buffer alone") {
  const one_scene::bodies s = one_scene::make();
  // So few that no list of them is as large as a depth buffer.
  const test::face_list faces = [&] {
    test::face_list all = one_scene::faces_of(s), some;
    for (const irg::screen_face& f : all)
      if (s.body[f.number] >= 2 || f.number % 4 == 0) some.push_back(f);
    return some;
  }();
  REQUIRE(faces.size() * sizeof(irg::screen_face) * 2 < std::size_t{4} * one_scene::width * one_scene::height);
  const test::id_image exact = test::exact_ids(faces, one_scene::width, one_scene::height);
  CHECK(by(with_depths{}, faces).depth_buffers == 1);
  using irg::classical_method;
  for (const classical_method m : {classical_method::ray_casting, classical_method::warnock,
                                   classical_method::painter_newell, classical_method::bsp}) {
    const outcome o = by(irg::hidden_surfaces_by{m}, faces);
    CHECK(test::differing(o.ids, exact) == 0);
    CHECK(o.depth_buffers == 0);
  }
  const outcome naive = by(irg::painter_by_centroid_rounded<>{}, faces);
  CHECK(naive.depth_buffers == 0);
  CHECK(test::differing(naive.ids, exact) > 100);  // sheets and rods are large
  // In space the sheets lie in the cube's sides, and the lower number is seen; snapped, they come out now and then.
  const irg::bsp_tree_3d<double> tree(s.corners, s.triangles);
  const outcome fixed =
      by(irg::bsp_scene_painter<double>(tree, one_scene::eye, one_scene::to_clip(), one_scene::mapping()), faces);
  CHECK(fixed.depth_buffers == 0);
  int elsewhere = 0;
  for (int y = 0; y < one_scene::height; ++y)
    for (int x = 0; x < one_scene::width; ++x) {
      const std::uint32_t a = fixed.ids(x, y), b = exact(x, y);
      if (a != b && (a == irg::no_index || b == irg::no_index || s.body[a] != 2 || s.body[b] != 3)) ++elsewhere;
    }
  CHECK(elsewhere <= 4);
}

}  // namespace
