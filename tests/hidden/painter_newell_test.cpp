// SPDX-License-Identifier: MIT
#include <irg/hidden/painter_newell.hpp>

#include "method_scenes.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::newell_step;

TEST_CASE("painter_newell: three rods in turn are split, two through each other as well, coplanar ones never") {
  const auto steps = [](test::face_scene kind, int n) {
    test::face_scene_maker make(21, 64);
    const auto faces = make(kind, n);
    irg::image<std::uint32_t> ids(64, 64, irg::no_index);
    const auto counts = irg::draw_painter_newell(ids, faces, irg::cell_window{0, 0, 64, 64});
    CHECK(test::differing(ids, test::exact_ids(faces, 64, 64)) == 0);
    return counts;
  };
  const auto cycle = steps(test::face_scene::cycles, 6);
  CHECK(test::enough(cycle[newell_step::split_by_plane] + cycle[newell_step::split_by_extent] > 0));
  CHECK(test::enough(steps(test::face_scene::crossing, 4)[newell_step::split_by_plane] > 0));
  CHECK(steps(test::face_scene::coplanar, 12)[newell_step::split_by_plane] >= 0);
  const auto any = steps(test::face_scene::any, 60);
  for (const newell_step s : {newell_step::x_apart, newell_step::y_apart, newell_step::behind_plane,
                              newell_step::in_front_of_plane, newell_step::projections_apart, newell_step::moved})
    CHECK(any[s] > 0);
}

TEST_CASE("painter_newell: faces apart in depth are drawn as sorted, without a test") {
  constexpr auto counts = [] {
    std::vector<irg::screen_face> faces;
    for (int i = 0; i < 6; ++i) {
      const float depth = 0.1f + 0.1f * static_cast<float>(i * 5 % 6);
      faces.push_back(irg::make_screen_face({{0, 0}, depth}, {{2048, 0}, depth}, {{0, 2048}, depth},
                                            static_cast<std::uint32_t>(i)));
    }
    irg::image<std::uint32_t> ids(4, 4, irg::no_index);
    const auto c = irg::draw_painter_newell(ids, faces, irg::cell_window{0, 0, 4, 4});
    return std::pair{c, ids(1, 1)};
  };
  CHECK_BOTH(counts().second == 1);
  CHECK(counts().first[newell_step::moved] == 0);
}

TEST_CASE("painter_newell: the order of input is nothing to it; the observer sees every step") {
  test::face_scene_maker make(22, 48);
  auto faces = make(test::face_scene::cycles, 60);
  const auto first = test::ids_of(irg::painter_newell<>{}, faces, 48, 48);
  std::reverse(faces.begin(), faces.end());
  CHECK(test::differing(first, test::ids_of(irg::painter_newell<>{}, faces, 48, 48)) == 0);
  irg::newell_counts seen;
  test::id_image ids(48, 48, irg::no_index);
  const auto counts =
      irg::draw_painter_newell(ids, faces, irg::cell_window{0, 0, 48, 48},
                               [&](newell_step s, std::uint32_t, std::uint32_t) { ++seen.steps[static_cast<int>(s)]; });
  for (int i = 0; i < 10; ++i) CHECK(seen.steps[i] == counts.steps[i]);
}

TEST_CASE("painter_newell: the other order of depths") {
  test::face_scene_maker make(23, 32);
  const auto faces = make(test::face_scene::any, 40);
  CHECK(test::differing(test::ids_of(irg::painter_newell<irg::nearer_is_less>{}, faces, 32, 32),
                        test::ids_of(irg::ray_casting<irg::nearer_is_less>{}, faces, 32, 32)) == 0);
}

TEST_CASE("painter_newell: many equal faces, many through one line") {
  std::vector<irg::screen_face> same;
  for (std::uint32_t i = 0; i < 20000; ++i)
    same.push_back(irg::make_screen_face({{100, 200}, 0.5f}, {{7000, 900}, 0.25f}, {{1500, 8000}, 0.75f}, 20000 - i));
  CHECK(test::ids_of(irg::painter_newell<>{}, same, 16, 16)(6, 6) == 1);
  test::face_scene_maker make(24, 24);
  const auto pencil = make(test::face_scene::pencil, 1500);
  CHECK(test::differing(test::ids_of(irg::painter_newell<>{}, pencil, 24, 24),
                        test::ids_of(irg::ray_casting<>{}, pencil, 24, 24)) == 0);
}

TEST_CASE("painter_newell: the exact picture") {
  CHECK(test::differing_pixels(irg::painter_newell<>{}, 1605, 18) == 0);
}
