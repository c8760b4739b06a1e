// SPDX-License-Identifier: MIT
#include <irg/mesh/fit.hpp>

#include <array>
#include <cmath>
#include <limits>

#include <irg/mesh/shapes.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

using namespace irg;

namespace {

using P3 = point<double, 3>;
constexpr double largest = std::numeric_limits<double>::max();
constexpr double nan_ = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

constexpr mesh<double> points(std::initializer_list<P3> positions) {
  mesh<double> m;
  m.positions = positions;
  return m;
}

constexpr mesh<double> fitted_points(std::initializer_list<P3> positions) {
  mesh<double> m = points(positions);
  static_cast<void>(fit_mesh(m));
  return m;
}

constexpr fit_status status(std::initializer_list<P3> positions) { return fit_of(points(positions)).status; }

}  // namespace

TEST_CASE("fit: type facts") {
  static_assert(std::is_same_v<decltype(fit_of(mesh<float>{})), fit<float>>);
  static_assert(noexcept(fit_of(std::declval<const mesh<float>&>())));
}

TEST_CASE("fit: the body of the course, golden") {
  CHECK_BOTH(fit_of(points({{2, 0, 0}, {6, 2, 0}, {2, 8, 3}, {4, 1, -1}})) ==
             fit<double>{{4, 4, 1}, 0.25, fit_status::ok});
  CHECK_BOTH(fitted_points({{2, 0, 0}, {6, 2, 0}, {2, 8, 3}, {4, 1, -1}}) ==
             points({{-0.5, -1, -0.25}, {0.5, -0.5, -0.25}, {-0.5, 1, 0.5}, {0, -0.75, -0.5}}));
  CHECK_BOTH(fit_of(shape_cube<double>()) == fit<double>{{0.5, 0.5, 0.5}, 2, fit_status::ok});
}

TEST_CASE("fit: random bodies fill the cube along their longest side") {
  test::random r(1);
  for (int k = 0; k < 2000; ++k) {
    mesh<double> m;
    const double sx = 1e-9 + r.unit(), sy = r.unit() * 1e6, sz = r.unit(), away = r.unit() * 1e7;
    for (int i = 0; i < 20; ++i) {
      const double x = r.unit() * sx, y = r.unit() * sy - away, z = r.unit() * sz;
      m.positions.push_back({x, y, z});
    }
    CHECK(fit_mesh(m) == fit_status::ok);
    const auto b = bounding_box(m);
    const auto s = extent(b);
    const double longest = maximum(s.x, maximum(s.y, s.z));
    CHECK(longest == doctest::Approx(2).epsilon(1e-8));
    for (int i = 0; i < 3; ++i) {
      CHECK(b.low[i] >= -1 - 1e-8);
      CHECK(b.high[i] <= 1 + 1e-8);
      CHECK(b.low[i] + b.high[i] == doctest::Approx(0).epsilon(1e-6));
    }
  }
}

TEST_CASE("fit: classified") {
  CHECK_BOTH(status({}) == fit_status::empty);
  CHECK_BOTH(status({{3, 4, 5}}) == fit_status::all_sizes_zero);
  CHECK_BOTH(fitted_points({{3, 4, 5}, {3, 4, 5}}) == points({{0, 0, 0}, {0, 0, 0}}));
  CHECK_BOTH(status({{3, 4, 5}, {3, nan_, 5}}) == fit_status::not_finite);
  CHECK_BOTH(status({{nan_, nan_, nan_}}) == fit_status::not_finite);
  CHECK_BOTH(status({{3, 4, 5}, {3, -inf, 5}}) == fit_status::not_finite);
  CHECK_BOTH(fitted_points({{3, 4, inf}, {1, 1, 1}}) == points({{3, 4, inf}, {1, 1, 1}}));
  CHECK_BOTH(fit_of(box<float, 3>{}) == fit<float>{});
  CHECK_BOTH(fit_of(box<double, 3>{{1, 2, -inf}, {1, 2, 3}}) == fit<double>{{}, 1, fit_status::not_finite});
  CHECK_BOTH(fit_of(box<double, 3>{{1, 2, 3}, {1, inf, 3}}) == fit<double>{{}, 1, fit_status::not_finite});
}

TEST_CASE("fit: ends of the range") {
  CHECK_BOTH(fitted_points({{-0x1p1023, 0, 0}, {0x1p1023, 0, 0}}) == points({{-1, 0, 0}, {1, 0, 0}}));
  CHECK_BOTH(fitted_points({{0x1p53, 0, 0}, {0x1p53 + 2, 0, 0}}) == points({{0, 0, 0}, {2, 0, 0}}));  // no middle
  CHECK_BOTH(fitted_points({{0, 0, 0}, {0x1p-1021, 0, 0}}) == points({{-1, 0, 0}, {1, 0, 0}}));
  CHECK_BOTH(status({{-largest, 0, 0}, {largest, largest, 0}}) == fit_status::ok);
  CHECK_BOTH(status({{0, 0, 0}, {5e-324, 0, 0}}) == fit_status::all_sizes_zero);
}

// Next to the smallest normal number the middle and the scale have fewer digits: 8u here, where others keep to 5u.
TEST_CASE("fit: boxes of subnormal numbers, within 16u and what the middle adds") {
  const box<float, 3> small{{-0x1.092fap-128f, 0, 0}, {0x1.f9559p-129f, 0, 0}};
  CHECK(fitted(small.high, fit_of(small)).x == 1 + 0x8p-24f);
  test::random r(6);
  for (int k = 0; k < 20000; ++k) {
    const auto number = [&] {
      return std::ldexp(static_cast<float>(r.integer(-(1 << 23), 1 << 23)), static_cast<int>(r.integer(-149, -136)));
    };
    const float a = number(), b = number();
    const box<float, 3> extents{{minimum(a, b), 0, 0}, {maximum(a, b), 0, 0}};
    const auto f = fit_of(extents);
    if (f.status != fit_status::ok) continue;
    const double low = static_cast<double>(extents.low.x), high = static_cast<double>(extents.high.x),
                 half = high / 2 - low / 2;
    const double middle = maximum(-low, high) / half;
    CHECK(static_cast<double>(fitted(extents.high, f).x) <= 1 + (16 + middle) * 0x1p-24);
    CHECK(static_cast<double>(fitted(extents.low, f).x) >= -1 - (16 + middle) * 0x1p-24);
    CHECK(std::fabs(static_cast<double>(f.scale) * half - 1) <= 9 * 0x1p-24);
  }
}

TEST_CASE("fit: several bodies, each fitted, then scaled and placed") {
  std::array<mesh<double>, 3> bodies{shape_cube<double>(), points({{0, 0, 0}, {8, 2, 2}}), points({{nan_, 0, 0}})};
  const std::array<placement<double>, 3> places{placement<double>{0.5, {10, 0, 0}}, {2, {0, 1, 0}}, {1, {5, 5, 5}}};
  const auto statuses = fit_each<double>(bodies, places);
  CHECK(statuses == std::vector<fit_status>{fit_status::ok, fit_status::ok, fit_status::not_finite});
  CHECK(bounding_box(bodies[0]) == box<double, 3>{{9.5, -0.5, -0.5}, {10.5, 0.5, 0.5}});
  CHECK(bodies[1].positions == std::vector<P3>{{-2, 0.5, -0.5}, {2, 1.5, 0.5}});
  CHECK(bodies[2].positions[0].y == 0);
}
