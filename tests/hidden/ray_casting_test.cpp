// SPDX-License-Identifier: MIT
#include <irg/hidden/ray_casting.hpp>

#include "method_scenes.hpp"
#include "support/check_both.hpp"

namespace {

constexpr irg::screen_face face(int x, int y, int size, float depth, std::uint32_t number) {
  return irg::make_screen_face({{x * 256, y * 256}, depth}, {{(x + size) * 256, y * 256}, depth},
                               {{x * 256, (y + size) * 256}, depth}, number);
}

}  // namespace

TEST_CASE("ray_casting: the nearest, of equally near ones the lowest number, nothing else") {
  constexpr auto run = [] {
    const std::vector<irg::screen_face> faces{face(0, 0, 8, 0.25f, 5), face(0, 0, 4, 0.5f, 7), face(1, 0, 4, 0.5f, 6)};
    irg::image<std::uint32_t> ids(8, 8, irg::no_face);
    irg::draw_counts counts;
    irg::ray_casting<>{}(faces, irg::cell_window{0, 0, 8, 8}, ids, counts);
    irg::image<std::uint32_t> other(8, 8, irg::no_face);
    irg::draw_counts ignored;
    irg::ray_casting<irg::nearer_is_less>{}(faces, irg::cell_window{0, 0, 8, 8}, other, ignored);
    return ids(0, 0) == 7 && ids(1, 0) == 6 && ids(3, 0) == 6 && ids(4, 0) == 5 && ids(7, 7) == irg::no_face &&
           other(0, 0) == 5 && counts.ties > 0 && counts.tested > counts.ties;
  };
  CHECK_BOTH(run());
}

TEST_CASE("ray_casting: only the window's pixels, faces without area not at all") {
  const std::vector<irg::screen_face> faces{
      face(0, 0, 8, 0.5f, 1), irg::make_screen_face({{0, 0}, 0.9f}, {{512, 512}, 0.9f}, {{1024, 1024}, 0.9f}, 0)};
  irg::image<std::uint32_t> ids(8, 8, 99u);
  irg::draw_counts counts;
  irg::ray_casting<>{}(faces, irg::cell_window{2, 1, 4, 3}, ids, counts);
  CHECK(ids(2, 1) == 1);
  CHECK(ids(1, 1) == 99);
  CHECK(ids(4, 1) == 99);
  CHECK(counts.tested == 4);
}

TEST_CASE("ray_casting: the exact picture") { CHECK(test::differing_pixels(irg::ray_casting<>{}, 1601, 18) == 0); }
