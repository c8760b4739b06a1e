// SPDX-License-Identifier: MIT
#include <irg/raster/screen_face.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::make_screen_face;
using irg::screen_face;
using irg::subpixel;

constexpr screen_face face(subpixel a, subpixel b, subpixel c) {
  return make_screen_face({a, 0.5f}, {b, -0.25f}, {c, 0.75f}, 6);
}

TEST_CASE("make_screen_face: corners, number, range of depths and box") {
  constexpr screen_face f = face({0, 0}, {0, 1024}, {1024, 0});
  CHECK_BOTH(f.number == 6);
  CHECK_BOTH(f.v[1].position == subpixel{0, 1024});  // in the order they came, though the coverage turns them round
  CHECK_BOTH(f.depth_low == -0.25f);
  CHECK_BOTH(f.depth_high == 0.75f);
  CHECK_BOTH(f.coverage.bounds == irg::cell_window{0, 0, 4, 4});
  CHECK_BOTH(f.coverage.double_area == 1024 * 1024);
  CHECK_BOTH(screen_face{}.number == irg::no_index);
  CHECK_BOTH(!covers(screen_face{}, 0, 0));
}

TEST_CASE("facing_of: counter-clockwise with y up is the front") {
  // On the screen y runs down: (0, 0), (0, 4), (4, 0) runs down first, then up to the right.
  CHECK_BOTH(facing_of(face({0, 0}, {0, 1024}, {1024, 0})) == irg::facing::front);
  CHECK_BOTH(facing_of(face({0, 0}, {1024, 0}, {0, 1024})) == irg::facing::back);
  CHECK_BOTH(facing_of(face({0, 0}, {512, 512}, {1024, 1024})) == irg::facing::back);
}

TEST_CASE("covers: edge-on faces cover nothing, faces at the limit what they should") {
  constexpr screen_face line = face({128, 128}, {640, 640}, {1152, 1152});
  CHECK_BOTH(line.coverage.double_area == 0);
  CHECK_BOTH(line.coverage.bounds.empty());
  CHECK_BOTH((!covers(line, 0, 0) && !covers(line, 2, 2)));
  constexpr int far = irg::snap_limit * irg::one_pixel;
  constexpr screen_face half = face({-far, -far}, {-far, far}, {far, -far});
  CHECK_BOTH(facing_of(half) == irg::facing::front);
  CHECK_BOTH((covers(half, 0, -2) && !covers(half, 0, 1)));
  CHECK_BOTH(covers(half, -irg::snap_limit, -irg::snap_limit));
  CHECK_BOTH(!covers(half, irg::snap_limit - 1, irg::snap_limit - 1));
}

TEST_CASE("screen_face: the same pixels in every order of the corners, front in one half of them") {
  test::random r(411);
  for (int i = 0; i < 300; ++i) {
    irg::screen_vertex v[3];
    for (auto& c : v)
      c = {{static_cast<std::int32_t>(r.integer(-600, 3000)), static_cast<std::int32_t>(r.integer(-600, 3000))},
           static_cast<float>(r.unit())};
    const screen_face f = make_screen_face(v[0], v[1], v[2], 1), turned = make_screen_face(v[1], v[2], v[0], 1),
                      back = make_screen_face(v[0], v[2], v[1], 1);
    const bool has_area = f.coverage.double_area != 0;
    // The shoelace formula with y up, in doubles, exact for these numbers.
    double twice = 0;
    for (int k = 0; k < 3; ++k) {
      const auto &p = v[k].position, &q = v[(k + 1) % 3].position;
      twice +=
          static_cast<double>(p.x) * -static_cast<double>(q.y) + static_cast<double>(q.x) * static_cast<double>(p.y);
    }
    REQUIRE((facing_of(f) == irg::facing::front) == (twice > 0));
    REQUIRE(facing_of(turned) == facing_of(f));
    REQUIRE((has_area ? facing_of(back) != facing_of(f) : facing_of(back) == irg::facing::back));
    for (int y = -3; y < 13; ++y)
      for (int x = -3; x < 13; ++x) {
        const bool in = covers(f, x, y);
        REQUIRE((in == covers(turned, x, y) && in == covers(back, x, y)));
        const irg::cell_window& box = f.coverage.bounds;
        if (in) REQUIRE((box.x_first <= x && x < box.x_last && box.y_first <= y && y < box.y_last));
      }
  }
}

}  // namespace
