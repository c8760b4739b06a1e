// SPDX-License-Identifier: MIT
#include <irg/geometry/point_on_triangle.hpp>

#include <array>
#include <cmath>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using corner = irg::point<double, 3>;

TEST_CASE("are_collinear, is_on_segment, is_on_triangle: by hand") {
  CHECK_BOTH(irg::are_collinear(corner{0, 0, 0}, corner{1, 2, 3}, corner{-2, -4, -6}));
  CHECK_BOTH(irg::are_collinear(corner{1, 1, 1}, corner{1, 1, 1}, corner{5, 0, 2}));
  CHECK_BOTH(!irg::are_collinear(corner{0, 0, 0}, corner{1, 1, 1}, corner{2, 2, 2.0000000000000004}));
  CHECK_BOTH(irg::is_on_segment(corner{0, 0, 0}, corner{2, 4, 6}, corner{1, 2, 3}));
  CHECK_BOTH(irg::is_on_segment(corner{0, 0, 0}, corner{2, 4, 6}, corner{2, 4, 6}));
  CHECK_BOTH(!irg::is_on_segment(corner{0, 0, 0}, corner{2, 4, 6}, corner{3, 6, 9}));
  CHECK_BOTH(!irg::is_on_segment(corner{0, 0, 0}, corner{2, 4, 6}, corner{1, 2, 4}));
  CHECK_BOTH(irg::is_on_triangle(corner{0, 0, 5}, corner{4, 0, 5}, corner{0, 4, 5}, corner{2, 2, 5}));
  CHECK_BOTH(irg::is_on_triangle(corner{5, 0, 0}, corner{5, 4, 0}, corner{5, 0, 4}, corner{5, 1, 1}));
  CHECK_BOTH(!irg::is_on_triangle(corner{5, 0, 0}, corner{5, 4, 0}, corner{5, 0, 4}, corner{5, 3, 2}));
  CHECK_BOTH(irg::is_on_triangle(corner{0, 0, 0}, corner{1, 1, 1}, corner{4, 4, 4}, corner{3, 3, 3}));
  CHECK_BOTH(!irg::is_on_triangle(corner{0, 0, 0}, corner{1, 1, 1}, corner{4, 4, 4}, corner{5, 5, 5}));
}

TEST_CASE("is_on_triangle: lattice points of a plane, by weights in integers (oracle), at sizes to the ends") {
  test::random random(77);
  int on = 0;
  for (int i = 0; i < 4000; ++i) {
    // Corners and the point are o + i u + j v, so that the plane is theirs whatever the rest.
    std::array<std::array<std::int64_t, 2>, 4> w{};
    std::array<std::array<std::int64_t, 3>, 3> frame{};
    for (auto& pair : w)
      for (auto& x : pair) x = random.integer(-3, 3);
    for (auto& axis : frame)
      for (auto& x : axis) x = random.integer(-9, 9);
    const double size = std::ldexp(1.0, static_cast<int>(random.integer(-1060, 1000)));
    std::array<corner, 4> p{};
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t c = 0; c < 3; ++c)
        p[k][static_cast<int>(c)] =
            static_cast<double>(frame[0][c] + w[k][0] * frame[1][c] + w[k][1] * frame[2][c]) * size;
    const bool spans = frame[1][0] * frame[2][1] != frame[1][1] * frame[2][0] ||
                       frame[1][1] * frame[2][2] != frame[1][2] * frame[2][1] ||
                       frame[1][0] * frame[2][2] != frame[1][2] * frame[2][0];
    if (!spans) continue;
    const auto turn = [&](std::size_t a, std::size_t b, std::size_t c) {
      return (w[b][0] - w[a][0]) * (w[c][1] - w[a][1]) - (w[b][1] - w[a][1]) * (w[c][0] - w[a][0]);
    };
    const std::int64_t area = turn(0, 1, 2), ab = turn(0, 1, 3), bc = turn(1, 2, 3), ca = turn(2, 0, 3);
    if (area == 0) continue;
    const bool expected = area > 0 ? ab >= 0 && bc >= 0 && ca >= 0 : ab <= 0 && bc <= 0 && ca <= 0;
    on += expected;
    CHECK(irg::is_on_triangle(p[0], p[1], p[2], p[3]) == expected);
    CHECK(!irg::are_collinear(p[0], p[1], p[2]));
    CHECK(irg::is_on_segment(p[0], p[1], p[3]) == (ab == 0 && (w[3][0] - w[0][0]) * (w[3][0] - w[1][0]) <= 0 &&
                                                   (w[3][1] - w[0][1]) * (w[3][1] - w[1][1]) <= 0));
  }
  CHECK(on > 300);
}

TEST_CASE("seen_along, orientation_along: two coordinates in their order, and their turn") {
  CHECK_BOTH(irg::seen_along(0, corner{1, 2, 3}) == irg::point<double, 2>{2, 3});
  CHECK_BOTH(irg::seen_along(1, corner{1, 2, 3}) == irg::point<double, 2>{1, 3});
  CHECK_BOTH(irg::seen_along(2, std::array<int, 3>{1, 2, 3}) == irg::point<int, 2>{1, 2});
  CHECK_BOTH(irg::orientation_along(2, corner{0, 0, 9}, corner{1, 0, -9}, corner{0, 1, 0}) == 1);
  CHECK_BOTH(irg::orientation_along(0, corner{9, 0, 0}, corner{0, 0, 1}, corner{-9, 1, 0}) == -1);
  CHECK_BOTH(irg::orientation_along(1, corner{0, 5, 0}, corner{1, 6, 1}, corner{2, -7, 2}) == 0);
}

}  // namespace
