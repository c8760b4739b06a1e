// SPDX-License-Identifier: MIT
#include <irg/hidden/surface_camera.hpp>

#include <array>
#include <cmath>
#include <limits>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using P = irg::point<double, 3>;
struct numbers {
  std::array<double, 2> x{0, 4}, z{0, 2};
  std::array<double, 4> heights{0, 3, std::numeric_limits<double>::quiet_NaN(), 1};
};

}  // namespace

TEST_CASE("box_of_surface: extremes, without what is no number") {
  constexpr irg::surface_box b = irg::box_of_surface(numbers{});
  CHECK_BOTH(b.low.y == 0);
  CHECK_BOTH(b.high.y == 3);
  CHECK_BOTH(b.high.x == 4);
  CHECK_BOTH(b.high.z == 2);
}

TEST_CASE("camera_on: the middle in the middle, the plane half-way, upright lines upright") {
  test::random r(3);
  const irg::surface_box box{{-1, -2, -3}, {5, 4, 1}};
  for (int i = 0; i < 500; ++i) {
    const P eye{20 * r.unit() - 10, 20 * r.unit() - 10, 20 * r.unit() - 10}, middle{2, 1, -1};
    const irg::surface_camera c = irg::camera_on(box, eye);
    const double away = std::hypot(eye.x - 2, std::hypot(eye.y - 1, eye.z + 1));
    CHECK(c.distance == doctest::Approx(away / 2));
    const auto at = c(middle);
    REQUIRE(at);
    CHECK(std::hypot(at->x, at->y) < 1e-12);
    const auto above = c({2, 1.1, -1});
    REQUIRE(above);
    CHECK(std::fabs(above->x) < 1e-12);
    CHECK(above->y > 0);
    CHECK(!c({2 * eye.x - 2, 2 * eye.y - 1, 2 * eye.z + 1}));  // behind the eye
  }
}

TEST_CASE("camera_on: eyes over the middle and in it, far away") {
  constexpr irg::surface_box box{{0, 0, 0}, {2, 2, 2}};
  constexpr auto seen = [](const P& eye, const P& p) {
    return *irg::camera_on(irg::surface_box{{0, 0, 0}, {2, 2, 2}}, eye)(p);
  };
  CHECK_BOTH(seen({1, 9, 1}, {2, 1, 1}).x > 0);
  CHECK_BOTH(seen({1, -9, 1}, {2, 1, 1}).x > 0);
  CHECK_BOTH(seen({1, 1, -5}, {1, 1, 1}) == irg::point<double, 2>{0, 0});
  CHECK(irg::camera_on(box, {1, 1, 1})({1, 0, 1}));
  CHECK(irg::camera_on(box, {-1e300, 1e300, 1e300})({1, 0, 1}));
}
