// SPDX-License-Identifier: MIT
#include <irg/shade/light_placement.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <irg/shade/phong_model.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::hpoint;
using irg::light_around;
using irg::light_at;
using irg::light_from;
using irg::polar_axis;
using irg::polar_of;

namespace {

using P = irg::point<double, 3>;
using V = irg::vec<double, 3>;
using H = hpoint<double, 3>;
using light = irg::light<double, double>;
using polar = irg::polar_coordinates<double>;
constexpr double pi = irg::pi<double>, not_a_number = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();

// What a white matt surface at p, turned to `normal`, receives.
double received(const light& source, const P& p, const V& normal) {
  const irg::material<double, double> matt{0, 1, 0, 1};
  const light lights[] = {source};
  return irg::phong_model(matt, irg::lighting<double, double>{0, lights}, p + normal, {p, normal});
}

}  // namespace

TEST_CASE("light_placement: by coordinates, in a direction, about a target") {
  CHECK_BOTH(light_at(P{3, 2, 4}, 200.0) == light{{3, 2, 4, 1}, 200});
  CHECK_BOTH(light_from(V{0, 0, 5}, 1.0) == light{{0, 0, 5, 0}, 1});
  CHECK_BOTH(light_around(P{1, 2, 3}, polar{5, 0, 0}, 1.0) == light{{1, 2, 8, 1}, 1});
  CHECK_BOTH(light_around(P{1, 2, 3}, polar{5, 0, 0}, 1.0, polar_axis::z_up) == light{{6, 2, 3, 1}, 1});
  CHECK_BOTH(light_around(P{1, 2, 3}, polar{inf, 0, 0}, 1.0) == light{{0, 0, 1, 0}, 1});
  CHECK_BOTH(light_around(P{1, 2, 3}, polar{0, 1, 1}, 1.0) == light{{1, 2, 3, 1}, 1});
  static_assert(std::is_same_v<decltype(light_at(irg::point<float, 3>{}, irg::rgb<float>{})), irg::light<float>>);
  // Hank's numbers: alpha = 30, beta = 45, R = 10
  const H s3 = light_around(P{0, 0, 0}, polar{10, irg::radians(30.0), irg::radians(45.0)}, 1.0).position;
  CHECK(std::abs(s3.x - 3.53553390593274) + std::abs(s3.y - 7.07106781186548) + std::abs(s3.z - 6.12372435695795) <=
        3e-14);
}

TEST_CASE("light_placement: numbers that place no light shine on nothing") {
  const auto nowhere = [](const P& target, const polar& p) {
    return light_around(target, p, 1.0) == light{{0, 0, 0, 0}, 1};
  };
  for (const double bad : {not_a_number, -inf, 1e308}) CHECK(nowhere({0, 0, 0}, {bad, 0, 0}));
  for (const double bad : {not_a_number, -inf, inf}) {
    CHECK(nowhere({0, 0, 0}, {1, bad, 0}));
    CHECK(nowhere({0, 0, 0}, {inf, 0, bad}));
    CHECK(nowhere({bad, 0, 0}, {1, 0, 0}));
  }
  CHECK(received(light_around(P{0, 0, 0}, {not_a_number, 0, 0}, 1.0), {0, 0, 0}, {0, 1, 0}) == 0);
  CHECK_BOTH(!polar_of(light{{0, 0, 0, 0}, 1}, P{1, 2, 3}));
}

TEST_CASE("light_placement: where a light stands, there and back") {
  CHECK_BOTH(polar_of(light{{1, 2, 8, 1}, 1}, P{1, 2, 3}) == polar{5, 0, 0});
  CHECK_BOTH(polar_of(light{{2, 4, 16, 2}, 1}, P{1, 2, 3}) == polar{5, 0, 0});
  CHECK_BOTH(polar_of(light{{1, 2, 3, 1}, 1}, P{1, 2, 3}) == polar{0, 0, 0});
  CHECK_BOTH(polar_of(light{{0, 7, 0, 0}, 1}, P{1, 2, 3}) == polar{inf, 0, pi / 2});
  CHECK_BOTH(polar_of(light{{1, 2, 8, 1}, 1}, P{1, 2, 3}, polar_axis::z_up) == polar{5, 0, pi / 2});
  test::random r(1);
  double worst = 0;
  for (int i = 0; i < 5000; ++i) {
    const auto axis = i % 2 ? polar_axis::y_up : polar_axis::z_up;
    const P target{r.unit(), r.unit(), r.unit()};
    const polar p{i % 5 ? 1 + r.unit() : inf, (2 * r.unit() - 1) * pi, (r.unit() - 0.5) * 0.9 * pi};
    const light source = light_around(target, p, 1.0, axis);
    if (i % 5)
      CHECK(to_cartesian(source.position) ==
            irg::frame_of(irg::polar_camera<double>{target, p.distance, p.azimuth, p.elevation}, axis).position);
    const auto back = polar_of(source, target, axis);
    REQUIRE(back.has_value());
    CHECK((back->distance == p.distance || std::abs(back->distance / p.distance - 1) <= 1e-15));
    worst = std::max({worst, std::abs(back->azimuth - p.azimuth), std::abs(back->elevation - p.elevation)});
  }
  CHECK(worst <= 4e-15);
}

TEST_CASE("light_placement: a light radiates equally in all directions") {
  test::random r(2);
  for (int i = 0; i < 5000; ++i) {
    const P target{r.unit(), r.unit(), r.unit()};
    const light source = light_around(target, {2 * r.unit(), (2 * r.unit() - 1) * pi, (r.unit() - 0.5) * pi}, 200.0);
    // surfaces all round the light, near and far: facing it, at 60 degrees, edge-on, turned away
    const V away = polar_to_cartesian(polar{1, (2 * r.unit() - 1) * pi, (r.unit() - 0.5) * pi});
    const double factor = 1 + r.unit();
    const P p = to_cartesian(source.position) + away * std::ldexp(factor, static_cast<int>(r.integer(-3, 6)));
    const V side = normalized(cross(away, V{0.3, -0.5, 0.7}));
    CHECK(received(source, p, -away) == doctest::Approx(200).epsilon(1e-13));
    CHECK(received(source, p, -away * 0.5 + side * std::sqrt(0.75)) == doctest::Approx(100).epsilon(1e-12));
    CHECK(received(source, p, side) == doctest::Approx(0).epsilon(1e-10));
    CHECK(received(source, p, away) == 0);
  }
}
