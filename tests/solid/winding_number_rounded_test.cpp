// SPDX-License-Identifier: MIT
#include <irg/solid/winding_number_rounded.hpp>

#include <array>
#include <cmath>
#include <limits>

#include <doctest/doctest.h>
#include <irg/mesh/shapes.hpp>
#include <irg/solid/solid_locator.hpp>

#include "support/random.hpp"

namespace {

using solid_mesh = irg::mesh<double>;

TEST_CASE("winding_number_rounded: whole numbers for closed bodies, the share of the sphere for parts of them") {
  const solid_mesh torus = irg::shape_torus<double>();
  test::random random(44);
  const irg::solid_locator locate(torus);
  double worst = 0;
  for (int i = 0; i < 300; ++i) {
    const auto number = [&] { return random.unit() * 3 - 1.5; };
    const double x = number(), y = number() * 0.4, z = number();
    const auto exact = locate.winding_number({x, y, z});
    if (exact) worst = std::fmax(worst, std::fabs(irg::winding_number_rounded(torus, {x, y, z}) - *exact));
  }
  CHECK(worst < 1e-12);
  // One of six equal faces, seen from the middle, at sizes to the ends of the range.
  for (const double size : {1.0, 0x1p1000, 0x1p-1000, 0x1p1022, 0x1p-1074}) {
    solid_mesh face;
    face.positions = {{size, size, size}, {-size, size, size}, {-size, -size, size}, {size, -size, size}};
    irg::add_face(face, std::array<std::size_t, 4>{0, 1, 2, 3});
    CHECK(std::fabs(irg::winding_number_rounded(face, {0, 0, 0}) - 1.0 / 6) < 1e-15);
    CHECK(std::fabs(irg::winding_number_rounded(face, {0, 0, 2 * size}) + 1.0 / 6) < 1e-15);
    CHECK(irg::winding_number_rounded(face, {0, 0, size}) == 0);
    CHECK(irg::winding_number_rounded(face, {size / 2, size / 4, size}) == 0);  // in the face, which it cuts in halves
  }
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(irg::winding_number_rounded(torus, {0, nan, 0}) == 0);
  static_assert(irg::winding_number_rounded(irg::mesh<float>{}, {0, 0, 0}) == 0);
}

}  // namespace
