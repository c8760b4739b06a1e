// SPDX-License-Identifier: MIT
// Depths without colours, visibility buffers with weights, and occlusion masks with their answers, of random scenes.
#include <irg/render/occlusion_mask.hpp>
#include <irg/render/visibility_buffer.hpp>

#include "hashes.hpp"
#include "support/visible_scenes.hpp"

namespace {

// One scene after another, given to add(hasher, scene, vertices, mapping).
template <class T, class Add>
constexpr std::uint64_t over_scenes(int rounds, Add add) {
  determinism::hasher h;
  test::random r(73);
  for (int i = 0; i < rounds; ++i) {
    const bool small = rounds == 1;  // fits into constant evaluation
    const int width = small ? 5 : 40 + 7 * i, height = small ? 4 : 100 - i;
    test::scene_maker make(r, static_cast<test::scene_kind>(small ? 6 : i % (test::scene_kinds + 1)), width, height);
    const test::triangle_scene s = make(small ? 3 : 50);
    const auto mapping = irg::map_to_screen<T>({width, height});
    const auto positions = test::positions_in<T>(s);
    const auto vertices = irg::project_vertices<T>(positions, test::matrix_in<T>(s), mapping);
    add(h, s, vertices, mapping, r);
  }
  return h.value();
}

constexpr std::uint64_t visibility_weights(int rounds) {
  return over_scenes<double>(rounds, [](auto& h, const auto& s, const auto& vertices, const auto& mapping, auto&) {
    irg::image<std::uint32_t> ids(s.width, s.height);
    irg::image<float> depth(s.width, s.height), alone(s.width, s.height);
    const irg::draw_depth_options settings{irg::face_culling::none, {}, irg::clearing::before_drawing};
    irg::draw_visibility({ids, depth}, irg::projected_triangles{vertices, s.triangles, mapping}, settings);
    irg::draw_depth(alone, irg::projected_triangles{vertices, s.triangles, mapping}, settings);
    const irg::triangle_batch<double> batch{&vertices, s.triangles, 0};
    for (int y = 0; y < s.height; ++y)
      for (int x = 0; x < s.width; ++x) {
        h.add(ids(x, y));
        h.add(alone(x, y));
        const auto at = irg::barycentrics_at(batch, mapping, ids(x, y), x, y);
        h.add(at ? at->weight1 : -1.0f);
        h.add(at ? at->weight2 : -1.0f);
      }
  });
}

template <class T>
constexpr std::uint64_t masks(int rounds) {
  return over_scenes<T>(rounds, [](auto& h, const auto& s, const auto& vertices, const auto& mapping, auto& r) {
    irg::occlusion_mask<> mask(s.width, s.height);
    mask.template draw<T>(vertices, s.triangles, mapping, irg::face_culling::none);
    for (int y = 0; y < s.height; ++y)
      for (int x = 0; x < s.width; ++x) {
        h.add(mask.depth(x, y));
        h.add(mask.block_depth(x, y));
      }
    irg::occlusion_counts counts;
    for (int k = 0; k < 20; ++k) {
      const auto any = [&] { return static_cast<T>(r.integer(-4096, 4096)) / T(512); };
      const T x = any(), y = any(), z = any() - T(10), size = any() / T(16);
      const T half = size < T(0) ? -size : size;
      const irg::box<T, 3> box{{x - half, y - half, z - half}, {x + half, y + half, z + half}};
      h.add(static_cast<int>(mask.test(box, test::matrix_in<T>(s), &counts)));
    }
    h.add(counts.pixels);
  });
}
constexpr std::uint64_t occlusion_masks(int rounds) { return masks<double>(rounds); }
constexpr std::uint64_t occlusion_masks_of_floats(int rounds) { return masks<float>(rounds); }
HASHED(visibility_weights, 1, 27);
HASHED(occlusion_masks, 1, 27);
HASHED(occlusion_masks_of_floats, 1, 27);

}  // namespace
