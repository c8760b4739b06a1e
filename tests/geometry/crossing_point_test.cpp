// SPDX-License-Identifier: MIT
#include <irg/geometry/crossing_point.hpp>

#include <limits>

#include "support/check_both.hpp"
#include "support/mixed_magnitudes.hpp"

namespace {

using place = irg::point<double, 2>;
using line = irg::segment<double, 2>;

TEST_CASE("crossing_point: ordinary, degenerate and hostile lines") {
  constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  CHECK_BOTH(irg::crossing_point(line{{0, 0}, {3, 3}}, line{{0, 2}, {2, 0}}) == place{1, 1});
  CHECK_BOTH(irg::crossing_point(line{{0, 0}, {1, 1}}, line{{5, 0}, {5, 1}}) == place{5, 5});
  CHECK_BOTH(!irg::crossing_point(line{{0, 0}, {1, 1}}, line{{1, 0}, {2, 1}}));
  CHECK_BOTH(!irg::crossing_point(line{{0, 0}, {0, 0}}, line{{1, 0}, {2, 1}}));
  CHECK_BOTH(irg::crossing_point(line{{-most, -most}, {most, most}}, line{{least, most}, {least, -most}}) ==
             place{least, least});
}

#ifdef IRG_HAVE_MPFR
template <class T>
int wrong_crossings(test::random& r, test::mixed::sizes sizes, int times) {
  using number = test::big_rational;
  int wrong = 0;
  for (int i = 0; i < times; ++i) {
    T c[8];
    for (T& x : c) x = i % 5 == 0 ? static_cast<T>(r.integer(-3, 3)) : test::mixed::number<T>(r, sizes);
    const auto at = irg::crossing_point(irg::segment<T, 2>{{c[0], c[1]}, {c[2], c[3]}},
                                        irg::segment<T, 2>{{c[4], c[5]}, {c[6], c[7]}});
    number x[8];
    for (int k = 0; k < 8; ++k) x[k] = number(static_cast<double>(c[k]));
    const number ux = x[2] - x[0], uy = x[3] - x[1], vx = x[6] - x[4], vy = x[7] - x[5], across = ux * vy - uy * vx;
    if (across.sign() == 0) {
      wrong += at.has_value();
      continue;
    }
    const number t = ((x[4] - x[0]) * vy - (x[5] - x[1]) * vx) / across, want[2] = {x[0] + t * ux, x[1] + t * uy};
    constexpr T most = std::numeric_limits<T>::max();
    for (int k = 0; k < 2 && at; ++k) {
      const T near_by = test::nearest<T>(want[k]);
      wrong += !((*at)[k] == (near_by > most ? most : near_by < -most ? -most : near_by));
    }
    wrong += !at;
  }
  return wrong;
}

TEST_CASE("crossing_point: the nearest number to the exact one, for coordinates of all sizes") {
  test::random r(5);
  for (const auto sizes : test::mixed::all_sizes) {
    CHECK(wrong_crossings<double>(r, sizes, 300) == 0);
    CHECK(wrong_crossings<float>(r, sizes, 300) == 0);
  }
}
#endif

}  // namespace
