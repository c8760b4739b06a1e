// SPDX-License-Identifier: MIT
#include <irg/hidden/painter_once.hpp>

#include "method_scenes.hpp"
#include "support/check_both.hpp"

namespace {

// A square face in two parts that share a number, and another one before or behind it.
constexpr std::pair<std::uint32_t, std::int64_t> seen_in_parts(float depth) {
  const irg::screen_vertex a{{0, 0}, 0.5f}, b{{2048, 0}, 0.5f}, c{{2048, 2048}, 0.5f}, d{{0, 2048}, 0.5f};
  const std::vector<irg::screen_face> faces{
      irg::make_screen_face(a, b, c, 4), irg::make_screen_face(a, c, d, 4),
      irg::make_screen_face({{0, 0}, depth}, {{5000, 0}, depth}, {{0, 5000}, depth}, 7)};
  irg::image<std::uint32_t> ids(8, 8, irg::no_index);
  irg::draw_counts counts;
  irg::painter_once<>{}(faces, irg::cell_window{0, 0, 8, 8}, ids, counts);
  return {ids(1, 6), counts.tested};
}

}  // namespace

TEST_CASE("painter_once: parts of a face, and depths compared only where something is met again") {
  CHECK_BOTH(seen_in_parts(0.75f) == std::pair{7u, std::int64_t{64}});
  CHECK_BOTH(seen_in_parts(0.25f) == std::pair{4u, std::int64_t{64}});
  CHECK_BOTH(seen_in_parts(0.5f) == std::pair{4u, std::int64_t{64}});  // equally near: the lower number
}

TEST_CASE("painter_once: of parts that lie on each other the nearest counts") {
  const auto sheet = [](float depth, std::uint32_t number) {
    return irg::make_screen_face({{0, 0}, depth}, {{5000, 0}, depth}, {{0, 5000}, depth}, number);
  };
  for (const auto& [first, second] : {std::pair{0.5f, 0.9f}, std::pair{0.9f, 0.5f}}) {
    const std::vector<irg::screen_face> faces{sheet(first, 4), sheet(second, 4), sheet(0.75f, 7)};
    irg::image<std::uint32_t> ids(8, 8, irg::no_index);
    irg::draw_counts counts;
    irg::painter_once<>{}(faces, irg::cell_window{0, 0, 8, 8}, ids, counts);
    CHECK(ids(1, 6) == 4);
  }
}

TEST_CASE("painter_once: ids that were there before count for nothing") {
  const std::vector<irg::screen_face> faces{
      irg::make_screen_face({{0, 0}, 0.5f}, {{1024, 0}, 0.5f}, {{0, 1024}, 0.5f}, 3),
      irg::make_screen_face({{2048, 2048}, 0.9f}, {{1024, 2048}, 0.9f}, {{2048, 1024}, 0.9f}, 8)};
  for (const std::uint32_t before : {0u, 3u, 8u, 9u}) {
    irg::image<std::uint32_t> ids(8, 8, before);
    irg::draw_counts counts;
    irg::painter_once<>{}(faces, irg::cell_window{0, 0, 8, 8}, ids, counts);
    CHECK(ids(0, 0) == 3);
    CHECK(ids(7, 7) == 8);
    CHECK(ids(7, 0) == before);
  }
}

TEST_CASE("painter_once: the exact picture") { CHECK(test::differing_pixels(irg::painter_once<>{}, 1611, 18) == 0); }
