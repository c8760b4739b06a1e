// SPDX-License-Identifier: MIT
#include <irg/hidden/order_in_window.hpp>

#include "method_scenes.hpp"
#include "support/check_both.hpp"

TEST_CASE("order_in_window: in front, behind, through; equal planes by number") {
  constexpr auto level = [](float depth, std::uint32_t number) {
    return irg::make_screen_face({{0, 0}, depth}, {{4096, 0}, depth}, {{0, 4096}, depth}, number);
  };
  constexpr auto tilted = irg::make_screen_face({{0, 0}, 0.25f}, {{4096, 0}, 0.75f}, {{0, 4096}, 0.25f}, 3);
  constexpr irg::cell_window all{0, 0, 16, 16};
  using irg::window_order;
  CHECK_BOTH(irg::order_in_window(level(0.5f, 1), level(0.25f, 2), all) == window_order::nearer);
  CHECK_BOTH(irg::order_in_window(level(0.25f, 1), level(0.5f, 2), all) == window_order::farther);
  CHECK_BOTH(irg::order_in_window(level(0.5f, 1), level(0.5f, 2), all) == window_order::nearer);
  CHECK_BOTH(irg::order_in_window(level(0.5f, 2), level(0.5f, 1), all) == window_order::farther);
  CHECK_BOTH(irg::order_in_window(level(0.5f, 1), tilted, all) == window_order::crossing);
  CHECK_BOTH(irg::order_in_window(level(0.5f, 1), tilted, irg::cell_window{0, 0, 8, 16}) == window_order::nearer);
  CHECK_BOTH(irg::order_in_window(level(0.5f, 1), tilted, irg::cell_window{8, 0, 9, 1}) == window_order::farther);
  CHECK_BOTH(irg::order_in_window<irg::nearer_is_less>(level(0.5f, 1), level(0.25f, 2), all) == window_order::farther);
}

TEST_CASE("order_in_window: what every pixel says") {
  test::random r(1602);
  const int trials = std::getenv("IRG_RELEASE_TIER") ? 200000 : 3000;
  int seen[3] = {};
  for (int trial = 0; trial < trials; ++trial) {
    test::face_scene_maker make(r.next(), 16);
    const auto faces = make(static_cast<test::face_scene>(trial % test::face_scenes), 2);
    if (faces[0].coverage.double_area == 0 || faces[1].coverage.double_area == 0) continue;
    const int x = static_cast<int>(r.integer(-20, 20)), y = static_cast<int>(r.integer(-20, 20));
    const irg::cell_window w{x, y, x + static_cast<int>(r.integer(1, 9)), y + static_cast<int>(r.integer(1, 9))};
    int nearer = 0, all = 0;
    for (int py = w.y_first; py < w.y_last; ++py)
      for (int px = w.x_first; px < w.x_last; ++px, ++all) nearer += irg::is_nearer(faces[0], faces[1], px, py);
    const auto order = irg::order_in_window(faces[0], faces[1], w);
    CHECK(order == (nearer == all ? irg::window_order::nearer
                    : nearer == 0 ? irg::window_order::farther
                                  : irg::window_order::crossing));
    ++seen[static_cast<int>(order)];
  }
  for (const int n : seen) CHECK(n > trials / 20);
}
