// SPDX-License-Identifier: MIT
#include <irg/hidden/painter.hpp>

#include "method_scenes.hpp"
#include "support/check_both.hpp"

TEST_CASE("painter_by_centroid: right where depths do not overlap, wrong where they do") {
  constexpr auto face = [](int x, int size, float at_a, float at_b, std::uint32_t number) {
    return irg::make_screen_face({{x * 256, 0}, at_a}, {{(x + size) * 256, 0}, at_b}, {{x * 256, size * 256}, at_a},
                                 number);
  };
  constexpr auto drawn = [](const std::vector<irg::screen_face>& faces, int x) {
    irg::image<std::uint32_t> ids(16, 16, irg::no_index);
    irg::draw_counts counts;
    irg::painter_by_centroid_rounded<>{}(faces, irg::cell_window{0, 0, 16, 16}, ids, counts);
    return ids(x, 0);
  };
  CHECK_BOTH(drawn({face(0, 8, 0.5f, 0.5f, 1), face(0, 16, 0.25f, 0.25f, 0)}, 0) == 1);
  CHECK_BOTH(drawn({face(0, 8, 0.5f, 0.5f, 1), face(0, 8, 0.5f, 0.5f, 0)}, 0) == 0);
  // A long face before a short one: its centroid is far away, so it is drawn too early.
  const std::vector<irg::screen_face> wrong{face(0, 16, 0.9f, 0.1f, 0), face(0, 2, 0.7f, 0.7f, 1)};
  CHECK(drawn(wrong, 0) == 1);
  CHECK(test::exact_ids(wrong, 16, 16)(0, 0) == 0);
}

TEST_CASE("painter_by_centroid: in drawing order the last number is seen, whatever the depths") {
  test::face_list faces;
  for (std::uint32_t i = 0; i < 100; ++i) {
    const float depth = static_cast<float>(i * 37 % 100) * 0x1p-7f;
    faces.push_back(irg::make_screen_face({{0, 0}, depth}, {{2048, 0}, depth}, {{0, 2048}, depth}, i * 71 % 100));
  }
  const test::id_image ids = test::ids_of(irg::painter_by_centroid_rounded<irg::drawing_order>{}, faces, 4, 4);
  CHECK(ids == test::id_image(4, 4, 99u));
}

TEST_CASE("painter_by_centroid: how often it is wrong") {
  CHECK(test::differing_pixels(irg::painter_by_centroid_rounded<>{}, 1604, 18) > 1000);
}
