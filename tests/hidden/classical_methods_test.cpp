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
