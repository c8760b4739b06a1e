// SPDX-License-Identifier: MIT
#include <irg/math/coordinate_system.hpp>

#include "support/check_both.hpp"

using irg::axis_direction;
using irg::conversion;
using irg::convert;
using irg::coordinate_system;
using irg::handedness;
using irg::handedness_of;
using irg::hpoint;
using irg::mat;
using irg::point;
using irg::vec;

namespace {

// Calls f for each of the 48 coordinate systems there are.
template <class F>
constexpr bool all_systems(const F& f) {
  for (int x = 0; x < 6; ++x)
    for (int y = 0; y < 6; ++y)
      for (int z = 0; z < 6; ++z) {
        const coordinate_system s{axis_direction(x), axis_direction(y), axis_direction(z)};
        if (is_valid(s) && !f(s)) return false;
      }
  return true;
}

}  // namespace

TEST_CASE("coordinate_system: the named ones") {
  CHECK_BOTH(
      (handedness_of(irg::world_y_up) == handedness::right && handedness_of(irg::world_z_up) == handedness::right));
  CHECK_BOTH(handedness_of(irg::camera_left_handed) == handedness::left);
  CHECK_BOTH(handedness_of(irg::projection_plane) == handedness::left);
  CHECK_BOTH(handedness_of(irg::screen_y_down) == handedness::right);
  CHECK_BOTH(conversion<int>(irg::world_y_up, irg::camera_left_handed) ==
             mat<int, 3, 3>{{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}});
  CHECK_BOTH(conversion<int>(irg::world_z_up, irg::world_y_up) == mat<int, 3, 3>{{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}});
  // One up is one up in both worlds, and one down on the screen.
  CHECK_BOTH(convert(vec<double, 3>{0, 0, 1}, irg::world_z_up, irg::world_y_up) == vec<double, 3>{0, 1, 0});
  CHECK_BOTH(convert(point<float, 3>{1, 2, 3}, irg::projection_plane, irg::screen_y_down) == point<float, 3>{1, -2, 3});
  CHECK_BOTH(conversion<double, 4>(irg::world_y_up, irg::camera_left_handed) * hpoint<double, 3>{1, 2, 3, 4} ==
             hpoint<double, 3>{1, 2, -3, 4});
  CHECK_BOTH(!is_valid(coordinate_system{axis_direction::up, axis_direction::down, axis_direction::left}));
}

TEST_CASE("coordinate_system: all 48, from each to each") {
  constexpr vec<int, 3> v{1, 20, 300};
  int count = 0, left = 0;
  all_systems([&](const coordinate_system& from) {
    ++count;
    left += handedness_of(from) == handedness::left ? 1 : 0;
    return all_systems([&](const coordinate_system& to) {
      const mat<int, 3, 3> there = conversion<int>(from, to), back = conversion<int>(to, from);
      CHECK((back * there == irg::identity_matrix<int, 3>() && back == transpose(there)));
      CHECK((convert(v, from, to) == there * v && convert(convert(v, from, to), to, from) == v));
      CHECK(determinant(there) == (handedness_of(from) == handedness_of(to) ? 1 : -1));
      // By way of a third system is the same.
      CHECK(conversion<int>(irg::world_z_up, to) * conversion<int>(from, irg::world_z_up) == there);
      return true;
    });
  });
  CHECK((count == 48 && left == 24));
  static_assert(
      all_systems([](const coordinate_system& s) { return conversion<int>(s, s) == irg::identity_matrix<int, 3>(); }));
}
