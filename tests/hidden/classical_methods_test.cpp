// SPDX-License-Identifier: MIT
#include <irg/hidden/classical_methods.hpp>

#include <vector>

#include "support/check_both.hpp"

TEST_CASE("classical_methods: each name is its method") {
  // Three slanted faces: by their centroids they come in another order than by what hides what.
  constexpr auto face = [](int x, int size, float at_a, float at_b, std::uint32_t number) {
    return irg::make_screen_face({{x * 256, 0}, at_a}, {{(x + size) * 256, 0}, at_b}, {{x * 256, size * 256}, at_a},
                                 number);
  };
  constexpr auto shown = [face](irg::classical_method method) {
    const std::vector<irg::screen_face> faces{face(0, 16, 0.9f, 0.1f, 0), face(0, 2, 0.7f, 0.7f, 1)};
    irg::image<std::uint32_t> ids(16, 16, irg::no_index);
    irg::draw_counts counts;
    irg::hidden_surfaces_by{method}(faces, irg::cell_window{0, 0, 16, 16}, ids, counts);
    return counts.tested > 0 ? ids(0, 0) : irg::no_index;
  };
  using enum irg::classical_method;
  CHECK_BOTH(shown(ray_casting) == 0);
  CHECK_BOTH(shown(warnock) == 0);
  CHECK_BOTH(shown(painter_newell) == 0);
  CHECK_BOTH(shown(bsp) == 0);
  CHECK_BOTH(shown(painter_by_centroid) == 1);
}

#pragma GCC diagnostic ignored "-Wdeprecated-declarations"  // the old order goes on compiling
TEST_CASE("draw_bsp, draw_warnock, draw_painter_newell: ids first, and the old order") {
  using ids_of_picture = irg::image<std::uint32_t>;
  const std::vector<irg::screen_face> faces{
      irg::make_screen_face({{0, 0}, 0.5f}, {{4096, 0}, 0.5f}, {{0, 4096}, 0.5f}, 7)};
  const irg::cell_window window{0, 0, 16, 16};
  const auto tree = irg::build_bsp(faces, window);
  ids_of_picture now(16, 16, irg::no_index), before = now;
  irg::draw_bsp(now, tree);
  irg::draw_bsp(tree, before);
  CHECK(now(3, 3) == 7);
  CHECK(now == before);
  CHECK(irg::draw_warnock(now, faces, window) == irg::draw_warnock(faces, window, before));
  CHECK(irg::draw_painter_newell(now, faces, window) == irg::draw_painter_newell(faces, window, before));
  CHECK(now == before);
}
