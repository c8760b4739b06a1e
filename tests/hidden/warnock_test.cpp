// SPDX-License-Identifier: MIT
#include <irg/hidden/warnock.hpp>

#include "method_scenes.hpp"
#include "support/check_both.hpp"

using irg::cell_window;
using irg::warnock_case;

namespace {

// A square of two triangles that covers a picture of 16 x 16.
constexpr std::vector<irg::screen_face> square(float depth, std::uint32_t number) {
  constexpr int far_out = 256 * 40;
  return {irg::make_screen_face({{-256, -256}, depth}, {{far_out, -256}, depth}, {{-256, far_out}, depth}, number)};
}

}  // namespace

TEST_CASE("warnock: an empty scene and a face that surrounds the window end at once") {
  constexpr auto windows = [](const std::vector<irg::screen_face>& faces) {
    irg::image<std::uint32_t> ids(16, 16, irg::no_index);
    const auto counts = irg::draw_warnock(ids, faces, cell_window{0, 0, 16, 16});
    std::int64_t n = 0;
    for (const std::int64_t w : counts.windows) n += w;
    return std::pair{n, ids(15, 15)};
  };
  CHECK_BOTH(windows({}) == std::pair{std::int64_t{1}, irg::no_index});
  CHECK_BOTH(windows(square(0.5f, 7)) == std::pair{std::int64_t{1}, 7u});
  // A thousand faces behind it change nothing.
  std::vector<irg::screen_face> faces = square(0.75f, 7);
  test::face_scene_maker make(11, 16);
  for (const auto& f : make(test::face_scene::any, 1000))
    faces.push_back(irg::make_screen_face({f.v[0].position, f.v[0].depth / 2}, {f.v[1].position, f.v[1].depth / 2},
                                          {f.v[2].position, f.v[2].depth / 2}, f.number + 10));
  CHECK(windows(faces) == std::pair{std::int64_t{1}, 7u});
}

TEST_CASE("warnock: windows partition the picture, and end in the classical cases alone") {
  test::face_scene_maker make(12, 64);
  const auto faces = make(test::face_scene::any, 90);
  irg::image<std::uint32_t> ids(61, 47, irg::no_index), times(61, 47, 0u);
  int largest_pixel = 0;
  const auto counts =
      irg::draw_warnock(ids, faces, cell_window{0, 0, 61, 47}, [&](const cell_window& w, warnock_case c) {
        if (c == warnock_case::divided) return;
        if (c == warnock_case::single_pixel)
          largest_pixel = std::max(largest_pixel, w.x_last - w.x_first + w.y_last - w.y_first);
        for (int y = w.y_first; y < w.y_last; ++y)
          for (int x = w.x_first; x < w.x_last; ++x) ++times(x, y);
      });
  for (int y = 0; y < 47; ++y)
    for (int x = 0; x < 61; ++x) CHECK(times(x, y) == 1);
  CHECK(largest_pixel == 2);
  CHECK(counts[warnock_case::single_pixel] > 0);
  CHECK(counts[warnock_case::one_face] + counts[warnock_case::surrounded] > 0);
}

TEST_CASE("warnock: windows of one row, one column, one pixel and none; an edge on the line between quarters") {
  test::face_scene_maker make(13, 16);
  const auto faces = make(test::face_scene::repeated, 60);
  const auto want = test::exact_ids(faces, 16, 16);
  for (const cell_window w :
       {cell_window{0, 3, 16, 4}, cell_window{5, 0, 6, 16}, cell_window{7, 7, 8, 8}, cell_window{4, 4, 4, 9}}) {
    test::id_image ids(16, 16, irg::no_index);
    irg::draw_warnock(ids, faces, w);
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) {
        const bool within = x >= w.x_first && x < w.x_last && y >= w.y_first && y < w.y_last;
        CHECK(ids(x, y) == (within ? want(x, y) : irg::no_index));
      }
  }
  const std::vector<irg::screen_face> halves{
      irg::make_screen_face({{0, 0}, 0.5f}, {{2048, 0}, 0.5f}, {{2048, 4096}, 0.5f}, 1),
      irg::make_screen_face({{2048, 0}, 0.5f}, {{4096, 0}, 0.5f}, {{2048, 4096}, 0.5f}, 2)};
  CHECK(test::differing(test::ids_of(irg::warnock<>{}, halves, 16, 16), test::exact_ids(halves, 16, 16)) == 0);
}

TEST_CASE("warnock: beyond the pixel, the parts of a pixel are its shares") {
  const std::vector<irg::screen_face> faces{
      irg::make_screen_face({{0, 0}, 0.5f}, {{1024, 0}, 0.5f}, {{0, 1024}, 0.5f}, 3)};
  std::vector<irg::screen_face> parts;
  for (const auto& f : faces) parts.push_back(irg::subdivided_face(f, 8));
  const auto ids = test::ids_of(irg::warnock<>{}, parts, 32, 32);
  int inside = 0, cut = 0;
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) inside += ids(x, y) == 3, cut += ids(x + 24, y) == 3;
  CHECK(inside == 64);
  CHECK((cut == 28 || cut == 36));  // half the pixel, the diagonal's centres to one side
}

TEST_CASE("warnock: the exact picture") { CHECK(test::differing_pixels(irg::warnock<>{}, 1603, 18) == 0); }
