// SPDX-License-Identifier: MIT
#include <irg/geometry/flat_ring.hpp>

#include <array>
#include <limits>
#include <vector>

#include <irg/geometry/polygon_orientation.hpp>
#include <irg/math/vec.hpp>

#include "support/check_both.hpp"

namespace {

using P = irg::point<double, 3>;
using I = irg::point<int, 3>;

TEST_CASE("flat_ring: counter-clockwise where the normal points forward along the axis") {
  static constexpr std::array<I, 3> tilted{I{7, 0, 0}, I{0, 7, 0}, I{0, 0, 7}};  // normal (1, 1, 1)
  for (int axis = 0; axis < 3; ++axis)
    CHECK(irg::orientation_of(irg::flat_ring(tilted, axis)) == irg::orientation::counter_clockwise);
  CHECK_BOTH(irg::flat_ring(tilted, 0)[1] == irg::point<int, 2>{7, 0});
  CHECK_BOTH(irg::flat_ring(tilted, 1)[2] == irg::point<int, 2>{7, 0});
  CHECK_BOTH(irg::flat_ring(tilted, 2)[0] == irg::point<int, 2>{7, 0});
  CHECK_BOTH(irg::flat_ring(tilted, 2).size() == 3);
}

TEST_CASE("dropped_axis: the largest view, at every size of numbers") {
  using V = std::vector<P>;
  CHECK_BOTH(irg::dropped_axis(std::array{I{0, 0, 0}, I{0, 5, 1}, I{1, 0, 5}}) == 0);
  CHECK_BOTH(irg::dropped_axis(std::array{I{0, 0, 0}, I{5, 0, 1}, I{0, 1, 5}}) == 1);
  CHECK_BOTH(irg::dropped_axis(std::array{I{0, 0, 0}, I{5, 1, 0}, I{0, 5, 1}}) == 2);
  CHECK_BOTH(irg::dropped_axis(std::array{I{7, 0, 0}, I{0, 7, 0}, I{0, 0, 7}}) == 0);  // all equal: the lowest
  CHECK_BOTH(irg::dropped_axis(std::array{I{0, 0, 0}, I{0, 5, 5}, I{-5, 0, 0}}) == 1);
  CHECK(!irg::dropped_axis(V{}));
  CHECK(!irg::dropped_axis(V{{1, 2, 3}, {1, 2, 3}, {4, 5, 6}}));
  for (const double scale : {0x1p-1070, 0x1p-500, 1.0, 0x1p500, 0x1p1020}) {
    CHECK(irg::dropped_axis(V{{0, 0, 0}, {0, 5 * scale, scale}, {scale, 0, 5 * scale}}) == 0);
    CHECK(irg::dropped_axis(V{{0, 0, 0}, {5 * scale, 0, scale}, {0, scale, 5 * scale}}) == 1);
    CHECK(irg::dropped_axis(V{{0, 0, 0}, {5 * scale, scale, 0}, {0, 5 * scale, scale}}) == 2);
  }
  using F = irg::point<float, 3>;
  for (const float scale : {0x1p-140f, 1.0f, 0x1p120f})
    CHECK(irg::dropped_axis(std::array{F{0, 0, 0}, F{0, 5 * scale, scale}, F{scale, 0, 5 * scale}}) == 0);
}

}  // namespace
