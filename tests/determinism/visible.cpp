// SPDX-License-Identifier: MIT
// Visible triangles and depths of random scenes of every kind, culled and clipped, in both orders of depth.
#include "hashes.hpp"
#include "support/visible_scenes.hpp"

#include <irg/render/occlusion_culling.hpp>

namespace {

template <class Order, class T>
constexpr std::uint64_t visible_triangles(int rounds) {
  determinism::hasher h;
  test::random r(71);
  for (int i = 0; i < rounds; ++i) {
    const bool small = rounds == 1;  // fits into constant evaluation
    const int width = small ? 5 : 40 + 7 * i, height = small ? 4 : 100 - i;
    test::scene_maker make(r, static_cast<test::scene_kind>(small ? 6 : i % (test::scene_kinds + 1)), width, height);
    test::triangle_scene s = make(small ? 3 : 50);
    if (Order::nearer(0.0f, 1.0f)) s.to_clip = test::square_view<Order>(0.125, 64);
    const auto culling = i % 3 == 0 ? irg::face_culling::none : irg::face_culling::back;
    const test::id_picture p = test::visible_ids<Order, T>(s, culling);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        h.add(p.id(x, y));
        h.add(p.depth(x, y));
      }
    h.add(p.stats.skipped.backface);
  }
  return h.value();
}

constexpr std::uint64_t visible_greater(int rounds) {
  return visible_triangles<irg::nearer_is_greater, double>(rounds);
}
constexpr std::uint64_t visible_less(int rounds) { return visible_triangles<irg::nearer_is_less, double>(rounds); }
constexpr std::uint64_t visible_floats(int rounds) { return visible_triangles<irg::nearer_is_greater, float>(rounds); }

// Which boxes sheets in front of them hide.
constexpr std::uint64_t hidden_boxes(int rounds) {
  determinism::hasher h;
  test::random r(72);
  for (int i = 0; i < rounds; ++i) {
    const bool small = rounds == 1;
    const int width = small ? 9 : 40 + 7 * i, height = small ? 8 : 100 - i;
    test::scene_maker make(r, test::scene_kind::sheets, width, height);
    const test::triangle_scene s = make(small ? 2 : 50);
    irg::occlusion_culling<float> culling(test::matrix_in<float>(s), {width, height});
    const auto positions = test::positions_in<float>(s);
    culling.add_occluder(positions, s.triangles, irg::face_culling::none);
    for (int k = 0; k < (small ? 2 : 200); ++k) {
      const auto column = r.integer(0, width * 1024), row = r.integer(0, height * 1024), away = r.integer(900, 1 << 14);
      const auto middle = test::seen_at(column, row, away, width, height);
      const auto x = static_cast<float>(middle.x), y = static_cast<float>(middle.y), z = static_cast<float>(middle.z);
      const float half = -z / static_cast<float>(r.integer(8, 64));
      h.add(culling.hides({{x - half, y - half, z - half}, {x + half, y + half, z + half}}));
    }
  }
  return h.value();
}
HASHED(hidden_boxes, 1, 54);
HASHED(visible_greater, 1, 54);
HASHED(visible_less, 1, 54);
HASHED(visible_floats, 1, 54);

}  // namespace
