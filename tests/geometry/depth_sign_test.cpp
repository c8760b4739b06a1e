// SPDX-License-Identifier: MIT
#include <irg/geometry/depth_sign.hpp>

#include <array>
#include <limits>

#include <irg/math/vec.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::depth_sign;

namespace {
using P = irg::point<double, 3>;
constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
}  // namespace

TEST_CASE("depth_sign: ahead, level, behind") {
  constexpr P eye{1, 1, 3}, target{0, 0, 0};
  CHECK_BOTH(depth_sign(eye, target, target) == 1);
  CHECK_BOTH(depth_sign(eye, target, eye) == 0);
  CHECK_BOTH(depth_sign(eye, target, P{4, -2, 3}) == 0);
  CHECK_BOTH(depth_sign(eye, target, P{4, -2, 3.0000000000000004}) == -1);
  CHECK_BOTH(depth_sign(eye, target, P{4, -2.0000000000000004, 3}) == 1);
  CHECK_BOTH(depth_sign(eye, target, P{2, 2, 6}) == -1);
  CHECK_BOTH(depth_sign(eye, eye, target) == 0);
  CHECK_BOTH(depth_sign(P{0, 0, most}, P{0, 0, -most}, P{most, most, least}) == 1);
  CHECK_BOTH(depth_sign(P{0, 0, least}, P{0, 0, 0}, P{most, most, least}) == 0);
  CHECK_BOTH(depth_sign(P{0, 0, least}, P{0, 0, 0}, P{most, most, 2 * least}) == -1);
  CHECK_BOTH(depth_sign(std::array<float, 2>{0, 1}, std::array<float, 2>{0, 0}, std::array<float, 2>{5, 1}) == 0);
  volatile double three = 3;
  CHECK(depth_sign(eye, target, P{4, -2, three}) == 0);
}

TEST_CASE("depth_sign: by integers in 128 bits, on lattices moved away from the origin") {
  __extension__ typedef __int128 wide;
  test::random r(1);
  int level = 0;
  for (int i = 0; i < 20000; ++i) {
    const std::int64_t reach = r.integer(0, 1) ? 3 : std::int64_t{1} << 50;
    P p[3];
    wide v[3][3];
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j) {
        const std::int64_t c = r.integer(-reach, reach) + (reach == 3 ? std::int64_t{1} << 52 : 0);
        p[k][j] = static_cast<double>(c);
        v[k][j] = c;
      }
    wide dot = 0;
    for (int j = 0; j < 3; ++j) dot += (v[2][j] - v[0][j]) * (v[1][j] - v[0][j]);
    level += dot == 0;
    CHECK(depth_sign(p[0], p[1], p[2]) == (dot > 0 ? 1 : dot < 0 ? -1 : 0));
  }
  CHECK(level > 100);
}
