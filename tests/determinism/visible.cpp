// SPDX-License-Identifier: MIT
// Visible triangles and depths of random scenes of every kind, culled and clipped, in both orders of depth.
#include "hashes.hpp"
#include "support/visible_scenes.hpp"

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
HASHED(visible_greater, 1, 54);
HASHED(visible_less, 1, 54);
HASHED(visible_floats, 1, 54);

}  // namespace
