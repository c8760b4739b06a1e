// SPDX-License-Identifier: MIT
#include <irg/hidden/plane_depth.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

namespace {

using irg::depth_steps;
using irg::depth_walk;
using irg::inverse_depth_steps;
using irg::picture_grid;
using irg::plane;
using irg::plane_depth;
using irg::plane_depth_perspective;
using irg::plane_depth_steps;
using irg::plane_walk;
using test::rational;

template <class T>
constexpr irg::point<T, 3> corner(int x, int y, int z) {
  return {T(x), T(y), T(z)};
}
template <class T>
constexpr plane<T> golden_plane() {
  return *irg::plane_through(corner<T>(0, 0, 10), corner<T>(8, 0, 6), corner<T>(0, 4, 2));
}
template <class T>
constexpr picture_grid<T> whole_numbers{T(0), T(0), T(1), T(1)};

TEST_CASE("plane_depth: the slides' values, the plane, its depth and its steps") {
  CHECK_BOTH(golden_plane<rational>() == plane<rational>{16, 64, 32, -320});
  CHECK_BOTH(plane_depth(golden_plane<rational>(), 0, 0) == rational(10));
  CHECK_BOTH(plane_depth_steps(golden_plane<rational>(), whole_numbers<rational>) ==
             depth_steps<rational>{10, rational(-1, 2), -2});
  constexpr rational row[] = {8, rational(15, 2), 7, rational(13, 2), 6, rational(11, 2), 5};
  depth_walk<rational> walk(*plane_depth_steps(golden_plane<rational>(), whole_numbers<rational>));
  walk.start(0, 1);
  for (int x = 0; x < 7; ++x, walk.next()) {
    CHECK(walk.value() == row[x]);
    CHECK(plane_depth(golden_plane<rational>(), x, 1) == row[x]);
    CHECK(plane_depth(golden_plane<double>(), x, 1) == static_cast<double>(row[x]));
  }
}

TEST_CASE("plane_depth_perspective: the slides' values, points, and the row y' = 0 with 1/(d - z) beside z") {
  constexpr auto p = golden_plane<rational>();
  constexpr int d = 20;
  const rational points[][3] = {{0, 0, 10}, {8, 0, 6}, {0, 4, 2}, {2, 1, 7}, {rational(8, 3), rational(4, 3), 6}};
  const rational projected[][2] = {{0, 0},
                                   {rational(80, 7), 0},
                                   {0, rational(40, 9)},
                                   {rational(40, 13), rational(20, 13)},
                                   {rational(80, 21), rational(40, 21)}};
  for (int i = 0; i < 5; ++i) {
    const rational scale = rational(d) / (rational(d) - points[i][2]);
    CHECK(points[i][0] * scale == projected[i][0]);
    CHECK(points[i][1] * scale == projected[i][1]);
    CHECK(plane_depth_perspective(p, d, projected[i][0], projected[i][1]) == points[i][2]);
  }
  constexpr rational z[] = {10, rational(180, 19), rational(80, 9), rational(140, 17), rational(15, 2)};
  constexpr rational inverse[] = {rational(1, 10), rational(19, 200), rational(9, 100), rational(17, 200),
                                  rational(2, 25)};
  depth_walk<rational> walk(*inverse_depth_steps(p, d, {0, 0, 2, 1}));
  walk.start(0, 0);
  for (int i = 0; i < 5; ++i, walk.next()) {
    CHECK(plane_depth_perspective(p, d, 2 * i, 0) == z[i]);
    CHECK(walk.value() == inverse[i]);
    CHECK(rational(d) - rational(1) / walk.value() == z[i]);
  }
  static_assert(plane_depth_perspective(p, d, 2, 0) == rational(180, 19));
}

TEST_CASE("plane_depth: what has no depth") {
  CHECK_BOTH(!plane_depth(plane<double>{1, 2, 0, 3}, 0, 0));  // edge on
  CHECK_BOTH(!plane_depth_steps(plane<double>{1, 2, 0, 3}));
  CHECK_BOTH(!plane_depth(plane<double>{}, 0, 0));
  CHECK_BOTH(!plane_depth(plane<double>{1, 2, std::numeric_limits<double>::quiet_NaN(), 3}, 0, 0));
  // Perspective from (0, 0, 20): a plane along the axis has depths; one that holds the eye has none.
  CHECK_BOTH(plane_depth_perspective(plane<double>{1, 0, 0, -5}, 20, 10, 0) == 10.0);
  CHECK_BOTH(!plane_depth_perspective(plane<double>{1, 0, 0, -5}, 20, 0, 0));   // the ray is parallel
  CHECK_BOTH(!plane_depth_perspective(plane<double>{1, 0, 0, -5}, 20, -1, 0));  // met behind the eye
  CHECK_BOTH(!plane_depth_perspective(plane<double>{0, 0, 1, -20}, 20, 1, 0));  // met at the eye's depth: parallel too
  CHECK_BOTH(!plane_depth_perspective(plane<double>{1, 0, 1, -20}, 20, 1, 0));  // met at the eye
  CHECK_BOTH(!inverse_depth_steps(plane<double>{1, 0, 1, -20}, 20));
  CHECK_BOTH(!plane_depth_perspective(plane<double>{1, 2, 3, 4}, 0, 1, 0));
  CHECK_BOTH(!inverse_depth_steps(plane<double>{1, 2, 3, 4}, 0));
}

TEST_CASE("plane_depth: z towards the viewer and away from him are mirror images") {
  test::random r(3);
  for (int i = 0; i < 2000; ++i) {
    const auto any = [&] { return static_cast<double>(r.integer(-50, 50)) / 4; };
    const plane<double> p{any(), any(), any(), any()}, mirrored{p.a, p.b, -p.c, p.d};
    const double d = 20 + any() / 4, x = any(), y = any();
    const auto one = plane_depth_perspective(p, d, x, y), other = plane_depth_perspective(mirrored, -d, x, y);
    REQUIRE(one.has_value() == other.has_value());
    if (one) REQUIRE(*one == -*other);
    const auto steps = inverse_depth_steps(p, d), opposite = inverse_depth_steps(mirrored, -d);
    REQUIRE(steps.has_value() == opposite.has_value());
    if (steps) REQUIRE(steps->origin == -opposite->origin);
  }
}

TEST_CASE("plane_depth: rational planes, both projections: the point of the ray that lies in the plane") {
  test::random r(4);
  int met = 0;
  for (int i = 0; i < 3000; ++i) {
    const auto any = [&] {
      const std::int64_t numerator = r.integer(-30, 30);
      return rational(numerator, r.integer(1, 4));
    };
    const plane<rational> p{any(), any(), any(), any()};
    const rational x = any(), y = any(), d = any();
    const auto on = [&](rational px, rational py, rational pz) {
      return p.a * px + p.b * py + p.c * pz + p.d == rational(0);
    };
    if (const auto z = plane_depth(p, x, y)) REQUIRE(on(x, y, *z));
    if (const auto z = plane_depth_perspective(p, d, x, y)) {
      const rational scale = (d - *z) / d;
      REQUIRE(on(x * scale, y * scale, *z));
      REQUIRE(rational(0) < scale);
      const auto steps = *inverse_depth_steps(p, d, {x, y, 1, 1});
      REQUIRE(steps.origin == rational(1) / (d - *z));
      ++met;
    }
  }
  CHECK(met > 1000);
}

struct drift {
  double plane = 0, steps = 0, worst_share = 0;
};

// Walks over a region of size x size pixels in T and compares with the plane in long double; errors in units of u M.
template <class T>
drift measure_drift(int size, int planes) {
  test::random r(5);
  constexpr double u = sizeof(T) == 4 ? 0x1p-24 : 0x1p-53;
  drift found;
  for (int i = 0; i < planes; ++i) {
    const auto any = [&](double scale) { return static_cast<T>((2 * r.unit() - 1) * scale); };
    const plane<T> p{any(1), any(1), static_cast<T>(0.05 + r.unit()), any(2000)};
    const picture_grid<T> grid{};
    const auto exact = [&](int x, int y) {
      return -(static_cast<long double>(p.d) + static_cast<long double>(p.a) * (x + 0.5L) +
               static_cast<long double>(p.b) * (y + 0.5L)) /
             static_cast<long double>(p.c);
    };
    const double m = (std::abs(static_cast<double>(p.d)) +
                      (std::abs(static_cast<double>(p.a)) + std::abs(static_cast<double>(p.b))) * size) /
                     static_cast<double>(p.c);
    depth_walk<T> steps(*plane_depth_steps(p, grid));
    plane_walk<T> anew(p, grid, T(0));
    for (int y = 0; y < size; ++y) {
      const int first = static_cast<int>(r.integer(0, size / 4));
      steps.start(first, y);
      anew.start(first, y);
      for (int x = first; x < size; ++x, steps.next(), anew.next()) {
        const auto error = [&](T z) {
          return static_cast<double>(std::abs(static_cast<long double>(z) - exact(x, y))) / (u * m);
        };
        const double e = error(steps.value());
        found.steps = std::max(found.steps, e);
        found.worst_share = std::max(found.worst_share, e / (x - first + 3 * y + 12));
        found.plane = std::max(found.plane, error(anew.value()));
      }
    }
  }
  return found;
}

// From one end of the ints to the other: the difference of two columns needs one bit more than they have.
template <class T>
constexpr T across_all_ints() {
  constexpr int low = std::numeric_limits<int>::min(), high = std::numeric_limits<int>::max();
  depth_walk<T> walk(depth_steps<T>{T(0), T(1), T(2)});
  walk.start(low, low);
  walk.start(high, high);
  return walk.value();
}

TEST_CASE("depth_walk: columns and rows at both ends of the ints") {
  CHECK_BOTH(across_all_ints<double>() == 3.0 * 0x7fffffff);
  CHECK_BOTH(across_all_ints<float>() == 3.0f * 0x80000000u);
  CHECK_BOTH(across_all_ints<rational>() == rational(3) * rational(0x7fffffff));
}

TEST_CASE("depth_walk: drift against the plane stays below its bound, and so does the plane's own error") {
  const bool release = std::getenv("IRG_RELEASE_TIER") != nullptr;
  for (const int size : {16, 128, 512}) {
    const drift f = measure_drift<float>(size, release ? 200 : size == 512 ? 2 : 10);
    MESSAGE("float, ", size, " x ", size, ": plane ", f.plane, " u M, steps ", f.steps, " u M, ", 100 * f.worst_share,
            " % of the bound");
    CHECK(f.plane <= 5);
    CHECK(f.worst_share <= 1);
    CHECK(f.steps > f.plane);
  }
  const drift d = measure_drift<double>(128, release ? 200 : 10);
  CHECK(d.plane <= 5);
  CHECK(d.worst_share <= 1);
}

}  // namespace
