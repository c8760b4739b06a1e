// SPDX-License-Identifier: MIT
#include <irg/view/polar_camera.hpp>
#include <irg/view/textbook/polar_camera.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/check_both.hpp"
#include "support/orthonormal.hpp"
#include "support/random.hpp"

using irg::cartesian_to_polar;
using irg::frame_of;
using irg::handedness;
using irg::orbited;
using irg::polar_axis;
using irg::polar_frame;
using irg::polar_of;
using irg::polar_to_cartesian;
using irg::sin_cos_degrees;
using irg::try_frame_of;
using irg::view_matrix;
using test::from_orthonormal;

namespace {

using P = irg::point<double, 3>;
using V = irg::vec<double, 3>;
using frame = irg::camera_frame<double>;
using polar = irg::polar_coordinates<double>;
using camera = irg::polar_camera<double>;
constexpr double pi = irg::pi<double>, not_a_number = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::max();

constexpr frame in_degrees(double azimuth, double elevation, double distance, polar_axis axis = polar_axis::y_up) {
  return polar_frame(P{0, 0, 0}, distance, {sin_cos_degrees(azimuth), sin_cos_degrees(elevation)}, axis);
}

template <class A>
double apart(const A& a, const A& b) {
  return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

double axes_apart(const frame& a, const frame& b) {
  return std::max({apart(a.right, b.right), apart(a.up, b.up), apart(a.forward, b.forward)});
}

double next_to_pole(test::random& r) {
  const double off = r.unit() - 0.5;
  return std::ldexp(off, -static_cast<int>(r.integer(0, 60)));
}

}  // namespace

TEST_CASE("polar_camera: Hank's positions and axes") {
  const struct {
    double alpha, beta, distance;
    P c;
    V x, y, z;
  } rows[] = {
      {0, 0, 5, {0, 0, 5}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}},
      {90, 0, 5, {5, 0, 0}, {0, 0, -1}, {0, 1, 0}, {-1, 0, 0}},
      {180, 0, 5, {0, 0, -5}, {-1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
      {0, 90, 5, {0, 5, 0}, {1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
      {30,
       45,
       10,
       {3.53553390593274, 7.07106781186548, 6.12372435695795},
       {0.866025403784439, 0, -0.5},
       {-0.353553390593274, 0.707106781186548, -0.612372435695795},
       {-0.353553390593274, -0.707106781186548, -0.612372435695795}},
      {45,
       30,
       2,
       {1.22474487139159, 1, 1.22474487139159},
       {0.707106781186548, 0, -0.707106781186548},
       {-0.353553390593274, 0.866025403784439, -0.353553390593274},
       {-0.612372435695795, -0.5, -0.612372435695795}},
      {-60,
       -30,
       8,
       {-6, -4, 3.46410161513775},
       {0.5, 0, 0.866025403784439},
       {-0.433012701892219, 0.866025403784439, 0.25},
       {0.75, 0.5, -0.433012701892219}},
  };
  for (const auto& row : rows) {
    const double a = irg::radians(row.alpha), b = irg::radians(row.beta);
    const frame golden{row.c, row.x, row.y, row.z};
    for (const frame& f : {in_degrees(row.alpha, row.beta, row.distance), frame_of(camera{{}, row.distance, a, b}),
                           irg::textbook::polar_frame(row.distance, a, b)}) {
      CHECK(apart(f.position, golden.position) <= 1e-14);
      CHECK(axes_apart(f, golden) <= 1e-15);
      CHECK(apart(transform_point(view_matrix(f, handedness::left), P{0, 0, 0}), P{0, 0, row.distance}) <= 2e-15);
      // X.(Y x Z) = -1: the camera system of right, up, forward is left-handed
      CHECK(dot(f.right, cross(f.up, f.forward)) == doctest::Approx(-1));
    }
  }
  const P q = transform_point(view_matrix(in_degrees(30, 45, 10), handedness::left), P{1, 2, 3});
  CHECK(apart(q, P{-0.633974596215561, -0.776457135307562, 6.39511573994625}) <= 1e-14);
}

TEST_CASE("polar_camera: right angles are exact in degrees, at the poles and beyond") {
  CHECK_BOTH(in_degrees(0, 90, 5) == frame{{0, 5, 0}, {1, 0, 0}, {0, 0, -1}, {0, -1, 0}});
  CHECK_BOTH(in_degrees(90, 90, 5) == frame{{0, 5, 0}, {0, 0, -1}, {-1, 0, 0}, {0, -1, 0}});
  CHECK_BOTH(in_degrees(0, -90, 5) == frame{{0, -5, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 0}});
  CHECK_BOTH(in_degrees(0, 180, 5) == frame{{0, 0, -5}, {1, 0, 0}, {0, -1, 0}, {0, 0, 1}});  // upside down
  // z up: azimuth from x towards y
  CHECK_BOTH(in_degrees(0, 0, 5, polar_axis::z_up) == frame{{5, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}});
  CHECK_BOTH(in_degrees(90, 0, 5, polar_axis::z_up) == frame{{0, 5, 0}, {-1, 0, 0}, {0, 0, 1}, {0, -1, 0}});
  CHECK_BOTH(in_degrees(0, 90, 5, polar_axis::z_up) == frame{{0, 0, 5}, {0, 1, 0}, {-1, 0, 0}, {0, 0, -1}});
  // roll: up leans to the left
  constexpr frame rolled =
      polar_frame(P{1, 2, 3}, 5.0, {sin_cos_degrees(0.0), sin_cos_degrees(0.0), sin_cos_degrees(90.0)});
  CHECK_BOTH(rolled == frame{{1, 2, 8}, {0, 1, 0}, {-1, 0, 0}, {0, 0, -1}});
  volatile double thirty = 30;
  constexpr frame at = in_degrees(30, 45, 10);
  CHECK(in_degrees(thirty, 45, 10) == at);
}

TEST_CASE("polar_camera: coordinates there and back") {
  CHECK_BOTH(polar_to_cartesian(polar{5, 0, 0}) == V{0, 0, 5});
  CHECK_BOTH(polar_to_cartesian(polar{5, 0, 0}, polar_axis::z_up) == V{5, 0, 0});
  CHECK_BOTH(cartesian_to_polar(V{0, 0, 5}) == polar{5, 0, 0});
  CHECK_BOTH(cartesian_to_polar(V{5, 0, 0}) == polar{5, pi / 2, 0});
  CHECK_BOTH(cartesian_to_polar(V{5, 0, 0}, polar_axis::z_up) == polar{5, 0, 0});
  CHECK_BOTH(cartesian_to_polar(V{0, -3, 0}) == polar{3, 0, -pi / 2});
  CHECK_BOTH(cartesian_to_polar(V{-0.0, 3, -0.0}) == polar{3, 0, pi / 2});
  CHECK_BOTH(cartesian_to_polar(V{-0.0, 0, -3}) == polar{3, pi, 0});
  CHECK_BOTH(cartesian_to_polar(V{}) == polar{0, 0, 0});
  CHECK_BOTH(cartesian_to_polar(V{-0.0, -0.0, -0.0}) == polar{0, 0, 0});
  CHECK_BOTH(cartesian_to_polar(V{1e300, 0, 1e300}).azimuth == pi / 4);
  CHECK_BOTH(cartesian_to_polar(V{1.5e308, 1.5e308, 1.5e308}) ==
             polar{std::numeric_limits<double>::infinity(), pi / 4, cartesian_to_polar(V{1, 1, 1}).elevation});
  // One level coordinate beyond a quarter of the range is enough to halve for: an eighth of the vector has its angles.
  for (const double a : {most, -most, most / 2, most / 4, most / 8})
    for (const double b : {most, most / 3, -most / 8, most * 0x1p-20, 1.0})
      for (const double c : {most, -most / 5, 1.0})
        for (const V& v : {V{a, c, b}, V{b, c, a}}) {
          const polar p = cartesian_to_polar(v), eighth = cartesian_to_polar(v / 8.);
          CHECK(p.azimuth == eighth.azimuth);
          CHECK(p.elevation == eighth.elevation);
        }
  test::random r(1);
  double back = 0, forth = 0;
  for (int i = 0; i < 20000; ++i) {
    const double size = std::ldexp(1.0, static_cast<int>(r.integer(-900, 900)));
    const V v = V{r.unit() - 0.5, r.unit() - 0.5, r.unit() - 0.5} * size;
    const auto axis = i % 2 ? polar_axis::y_up : polar_axis::z_up;
    const polar p = cartesian_to_polar(v, axis);
    CHECK((p.distance > 0 && std::abs(p.azimuth) <= pi && std::abs(p.elevation) <= pi / 2));
    back = std::max(back, apart(polar_to_cartesian(p, axis) / p.distance, v / p.distance));
    const polar q{size, (2 * r.unit() - 1) * pi, (r.unit() - 0.5) * pi};
    const polar again = cartesian_to_polar(polar_to_cartesian(q, axis), axis);
    CHECK(std::abs(again.distance / size - 1) <= 4 * 0x1p-53);
    forth = std::max(
        {forth, std::abs(again.elevation - q.elevation), std::abs(again.azimuth - q.azimuth) * std::cos(q.elevation)});
  }
  INFO("back within ", back * 0x1p53, "u, forth within ", forth * 0x1p53, "u");
  CHECK(back <= 8 * 0x1p-53);
  CHECK(forth <= 16 * 0x1p-53);
}

TEST_CASE("polar_camera: axes at every elevation, the same as look_at's between the poles") {
  test::random r(2);
  double worst = 0, single = 0, from_look_at = 0, textbook = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto axis = i % 2 ? polar_axis::y_up : polar_axis::z_up;
    camera c{{r.unit(), r.unit(), r.unit()},
             1 + r.unit(),
             (r.unit() - 0.5) * 20,
             (r.unit() - 0.5) * pi,
             i % 3 ? 0 : (r.unit() - 0.5) * 6};
    if (i % 5 == 0) c.elevation = (r.unit() - 0.5) * 20;
    if (i % 7 == 0) c.elevation = pi / 2 + next_to_pole(r);
    const frame f = frame_of(c, axis);
    worst = std::max(worst, from_orthonormal(f));
    single = std::max(
        single,
        from_orthonormal(frame_of(irg::polar_camera<float>{
            {}, 1, static_cast<float>(c.azimuth), static_cast<float>(c.elevation), static_cast<float>(c.roll)})));
    CHECK(apart(f.position + f.forward * c.distance, c.target) <= 1e-15);
    CHECK(f.position == c.target + polar_to_cartesian(polar{c.distance, c.azimuth, c.elevation}, axis));
    if (axis == polar_axis::y_up && c.roll == 0 && std::abs(c.elevation) <= pi)
      textbook = std::max(textbook, axes_apart(irg::textbook::polar_frame(1.0, c.azimuth, c.elevation), f));
    if (c.roll != 0 || !(std::abs(c.elevation) < 1.5)) continue;
    const V up = axis == polar_axis::y_up ? V{0, 1, 0} : V{0, 0, 1};
    from_look_at = std::max(from_look_at, axes_apart(f, irg::look_at_frame(f.position, c.target, up)));
  }
  INFO("orthonormal within ", worst * 0x1p53, "u, float ", single * 0x1p24, "u, from look_at ", from_look_at * 0x1p53,
       "u, from the textbook's ", textbook * 0x1p53, "u");
  CHECK(worst <= 8 * 0x1p-53);
  CHECK(single <= 8 * 0x1p-24);
  CHECK(from_look_at <= 1e-13);
  CHECK(textbook <= 6 * 0x1p-53);
}

TEST_CASE("polar_camera: a frame's angles, there and back, with and without roll") {
  CHECK_BOTH(polar_of(frame{}, 1) == camera{{0, 0, -1}, 1, 0, 0, 0});
  CHECK_BOTH(polar_of(in_degrees(0, 90, 5), 5) == camera{{0, 0, 0}, 5, 0, pi / 2, 0});
  CHECK_BOTH(polar_of(in_degrees(90, 90, 5), 5) == camera{{0, 0, 0}, 5, pi / 2, pi / 2, 0});  // no loss at the pole
  CHECK_BOTH(polar_of(in_degrees(90, -90, 5), 5) == camera{{0, 0, 0}, 5, pi / 2, -pi / 2, 0});
  CHECK_BOTH(polar_of(in_degrees(0, 180, 5), 5) == camera{{0, 0, 0}, 5, 0, pi, 0});  // upside down
  CHECK_BOTH(polar_of(frame{{}, {0, 1, 0}, {-1, 0, 0}, {0, 0, -1}}, 1) == camera{{0, 0, -1}, 1, 0, 0, pi / 2});
  CHECK_BOTH(polar_of(in_degrees(30, 60, 2, polar_axis::z_up), 2, polar_axis::z_up).roll == 0.0);
  test::random r(3);
  double worst = 0, angle = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto axis = i % 2 ? polar_axis::y_up : polar_axis::z_up;
    camera c{{r.unit(), r.unit(), r.unit()}, 1 + r.unit(), (2 * r.unit() - 1) * pi, (2 * r.unit() - 1) * pi, 0};
    if (i % 3 == 0) c.elevation = pi / 2 + next_to_pole(r);
    if (i % 4 == 0) c.roll = (2 * r.unit() - 1) * pi;
    const frame f = frame_of(c, axis);
    const camera again = polar_of(f, c.distance, axis);
    worst = std::max({worst, axes_apart(frame_of(again, axis), f), apart(again.target, c.target)});
    if (c.roll == 0) {
      CHECK(again.roll == 0);
      angle = std::max({angle, std::abs(again.azimuth - c.azimuth), std::abs(again.elevation - c.elevation)});
    }
    // any frame at all
    const frame g = irg::look_at_frame(P{r.unit(), r.unit(), r.unit()}, P{0.5, 0.5, 0.5},
                                       V{r.unit() - 0.5, r.unit() - 0.5, r.unit() - 0.5});
    worst = std::max(worst, axes_apart(frame_of(polar_of(g, 3, axis), axis), g));
  }
  INFO("axes within ", worst * 0x1p53, "u, angles without roll ", angle * 0x1p53, "u");
  CHECK(worst <= 16 * 0x1p-53);
  CHECK(angle <= 16 * 0x1p-53);
}

TEST_CASE("polar_camera: numbers that place no camera, and distances that are not positive") {
  CHECK_BOTH(!try_frame_of(camera{{0, 0, 0}, not_a_number}));
  CHECK_BOTH(!try_frame_of(camera{{0, 0, 0}, inf}));
  CHECK_BOTH(!try_frame_of(camera{{0, 0, 0}, most}));
  CHECK_BOTH(!try_frame_of(camera{{0, not_a_number, 0}, 1}));
  CHECK_BOTH(!try_frame_of(camera{{0, inf, 0}, 1}));
  CHECK_BOTH(!try_frame_of(camera{{0, 0, 0}, 1, inf}));
  CHECK_BOTH(!try_frame_of(camera{{0, 0, 0}, 1, 0, not_a_number}));
  CHECK_BOTH(!try_frame_of(camera{{0, 0, 0}, 1, 0, 0, inf}));
  CHECK_BOTH(frame_of(camera{{0, 0, 0}, 1, not_a_number}) == frame{});
  CHECK(try_frame_of(camera{{most / 4, -most / 4, 0}, most / 4, most, -most, most}).has_value());
  CHECK_BOTH(frame_of(camera{{1, 2, 3}, 0}).position == P{1, 2, 3});
  CHECK_BOTH(frame_of(camera{{1, 2, 3}, -2}) == frame{{1, 2, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}});
}

TEST_CASE("polar_camera: orbits stop at their limits and go round and round") {
  constexpr camera start{{1, 2, 3}, 5, 0.5, 1, 0};
  CHECK_BOTH(orbited(start, 0.25, -0.5) == camera{{1, 2, 3}, 5, 0.75, 0.5, 0});
  CHECK_BOTH(orbited(start, 0, 100).elevation == pi / 2);
  CHECK_BOTH(orbited(start, 0, -100).elevation == -pi / 2);
  CHECK_BOTH(orbited(start, 0, 100, {-0.1, 1.2}).elevation == 1.2);
  CHECK_BOTH(orbited(start, not_a_number, inf) == start);
  CHECK_BOTH(orbited(start, 3, 0).azimuth < 0);
  camera c = start;
  for (int i = 0; i < 1000; ++i) {
    c = orbited(c, 0.1, 0.01);
    CHECK(std::abs(c.azimuth) <= pi);
    CHECK(from_orthonormal(frame_of(c)) <= 8 * 0x1p-53);
  }
  CHECK(std::abs(c.azimuth - std::remainder(100.5, 2 * pi)) <= 1e-12);
  CHECK(c.elevation == pi / 2);
  // Going over the top without a limit does not turn the camera about.
  const frame before = frame_of(orbited(start, 0, pi / 2 - 1 - 1e-9, {-4, 4})),
              after = frame_of(orbited(start, 0, pi / 2 - 1 + 1e-9, {-4, 4}));
  CHECK(axes_apart(before, after) <= 3e-9);
}
