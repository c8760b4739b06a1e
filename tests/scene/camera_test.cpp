// SPDX-License-Identifier: MIT
#include <irg/scene/camera.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <irg/view/polar_camera.hpp>

#include "support/check_both.hpp"
#include "support/orthonormal.hpp"
#include "support/random.hpp"

namespace {

using camera = irg::camera<double>;
using point = irg::point<double, 3>;
using vec = irg::vec<double, 3>;
constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr camera in_parallel(camera c) {
  c.projection = irg::projection_kind::orthographic;
  c.far_distance = 100;
  return c;
}

// Where a point lands, after the division; clip coordinates tell the rest.
constexpr point seen(const camera& c, double aspect, const point& p) {
  return irg::to_cartesian(irg::view_projection(c, aspect) * p);
}

constexpr bool near(double a, double b, double tolerance = 1e-12) { return a - b <= tolerance && b - a <= tolerance; }

TEST_CASE("camera: types") {
  static_assert(std::is_aggregate_v<camera>);
  static_assert(std::is_same_v<decltype(irg::view_projection(irg::camera<float>{}, 1)), irg::mat<float, 4, 4>>);
}

TEST_CASE("view_projection: by hand, from (0, 0, 2) at the origin, 90 degrees") {
  constexpr camera c{{0, 0, 2},           {0, 0, 0}, {0, 1, 0}, irg::projection_kind::perspective,
                     irg::pi<double> / 2, 1.0,       infinity};
  CHECK_BOTH((near(seen(c, 1, {0, 0, 0}).x, 0) && near(seen(c, 1, {0, 0, 0}).y, 0)));
  CHECK_BOTH(near(seen(c, 1, {2, 0, 0}).x, 1));         // the right border at the target's distance
  CHECK_BOTH(near(seen(c, 1, {0, -2, 0}).y, -1));       // y is up
  CHECK_BOTH(near(seen(c, 2, {4, 0, 0}).x, 1));         // a wider picture shows more to the sides, not up
  CHECK_BOTH(near(seen(c, 2, {0, 2, 0}).y, 1));
  CHECK_BOTH(near(seen(c, 1, {0, 0, 1}).z, 1));         // the near plane
  CHECK_BOTH(near(seen(c, 1, {0, 0, -8}).z, 0.1));      // ten times as far: reversed depth near / distance
  CHECK_BOTH((irg::view_projection(c, 1) * point{0, 0, 3}).w < 0);  // behind the eye
}

TEST_CASE("view_projection: in parallel projection as much is seen as at the target in perspective, at every depth") {
  constexpr camera c = in_parallel({{0, 0, 2}, {0, 0, 0}, {0, 1, 0}, {}, irg::pi<double> / 2, -10, 10});
  CHECK_BOTH(near(seen(c, 1, {2, 0, 0}).x, 1));
  CHECK_BOTH(near(seen(c, 1, {2, 0, -50}).x, 1));
  CHECK_BOTH(near(seen(c, 2, {4, 2, 5}).x, 1));
  CHECK_BOTH(near(seen(c, 2, {4, 2, 5}).y, 1));
  CHECK_BOTH((irg::view_projection(c, 2) * point{4, 2, 5}).w == 1);
}

TEST_CASE("view_projection: the target is in the middle of the picture, and up is up, for cameras of any kind") {
  test::random r(1);
  for (int i = 0; i < 2000; ++i) {
    const auto coordinate = [&] { return static_cast<double>(r.integer(-1000, 1000)) / 64; };
    camera c{{coordinate(), coordinate(), coordinate()},
             {coordinate(), coordinate(), coordinate()},
             {},
             {},
             0.7,
             0.001,
             infinity};
    c.up = {coordinate(), coordinate(), coordinate()};
    if (i % 2) c = in_parallel(c);
    if (c.eye == c.target || irg::length(irg::cross(c.up, c.target - c.eye)) < 1e-3) continue;
    const double aspect = std::ldexp(1 + r.unit(), static_cast<int>(r.integer(-3, 3)));
    const point middle = seen(c, aspect, c.target);
    REQUIRE(near(middle.x, 0, 1e-9));
    REQUIRE(near(middle.y, 0, 1e-9));
    const point above = seen(c, aspect, c.target + irg::normalized(c.up) * 0.01);
    REQUIRE(near(above.x, 0, 1e-9));
    REQUIRE(above.y > 0);
    REQUIRE(middle.z > 0);
    if (i % 2 == 0) REQUIRE(middle.z <= 1 + 1e-12);
  }
}

TEST_CASE("view_projection: w is 1 to 2 at the near plane, whatever the size of the world") {
  for (const double size : {1e-280, 1e-160, 1e-38, 1e-3, 1.0, 3.0, 1e38, 1e160, 1e280}) {
    const camera c{{0, 0, 0}, {0, 0, -size}, {0, 1, 0}, {}, 0.7, size, infinity};
    const irg::hpoint<double, 3> p = irg::view_projection(c, 1.5) * point{0, 0, -size};
    CHECK(p.w >= 1);
    CHECK(p.w < 2);
    CHECK(near(p.z / p.w, 1));
  }
}

TEST_CASE("view_projection: at the ends of the range w stays within 2^62 of that") {
  for (const double size : {2.3e-308, 1e-300, 1e300}) {
    const camera c{{0, 0, 0}, {0, 0, -size}, {0, 1, 0}, {}, 0.7, size, infinity};
    const double w = (irg::view_projection(c, 0.001) * point{0, 0, -size}).w;
    CHECK(w >= 0x1p-62);
    CHECK(w <= 0x1p62);
  }
  for (const float size : {1.2e-38f, 1e-20f, 1.0f, 1e37f}) {
    const irg::camera<float> c{
        {0, 0, 0}, {0, 0, -size}, {0, 1, 0}, {}, 0.7f, size, std::numeric_limits<float>::infinity()};
    const float w = (irg::view_projection(c, 1) * irg::point<float, 3>{0, 0, -size}).w;
    CHECK(w >= 0x1p-62f);
    CHECK(w <= 0x1p62f);
  }
}

TEST_CASE("view_projection: a world scaled by a power of two gives the same picture, bit for bit") {
  test::random r(2);
  for (int i = 0; i < 500; ++i) {
    const auto coordinate = [&] { return r.unit() * 4 - 2; };
    const point eye{coordinate(), coordinate(), 5}, p{coordinate(), coordinate(), coordinate()};
    const camera c{eye, {0, 0, 0}, {0, 1, 0}, {}, 0.7, 0.01, infinity};
    for (const int power : {-400, -30, 30, 400}) {
      const auto scaled = [&](const point& q) {
        return point{std::ldexp(q.x, power), std::ldexp(q.y, power), std::ldexp(q.z, power)};
      };
      camera s = c;
      s.eye = scaled(eye), s.near_distance = std::ldexp(c.near_distance, power);
      REQUIRE(irg::view_projection(c, 1.5) * p == irg::view_projection(s, 1.5) * scaled(p));
    }
  }
}

TEST_CASE("view_projection: degenerate cameras give a finite matrix") {
  // Eye at the target, up parallel to the view, up zero; in both projections.
  constexpr camera at_target{{1, 2, 3}, {1, 2, 3}, {0, 1, 0}};
  constexpr camera parallel_up{{0, 5, 0}, {0, 0, 0}, {0, 1, 0}};
  constexpr camera no_up{{0, 0, 5}, {0, 0, 0}, {0, 0, 0}};
  CHECK_BOTH(irg::is_finite(irg::view_projection(at_target, 1.5)));
  CHECK_BOTH(irg::is_finite(irg::view_projection(in_parallel(at_target), 1.5)));
  CHECK_BOTH(irg::is_finite(irg::view_projection(parallel_up, 1.5)));
  CHECK_BOTH(irg::is_finite(irg::view_projection(in_parallel(parallel_up), 1.5)));
  CHECK_BOTH(irg::is_finite(irg::view_projection(no_up, 1.5)));
  CHECK_BOTH(near(seen(at_target, 1, {1, 2, 0}).x, 0));  // it looks along -z
  CHECK_BOTH(near(seen(parallel_up, 1, {0, 0, 0}).x, 0));
  // At the target a parallel camera shows what it shows from distance 1: tan(20 degrees) up.
  constexpr double height = irg::tan(irg::pi<double> / 9);
  CHECK_BOTH(near(seen(in_parallel(at_target), 1, {1, 2 + height, 3}).y, 1));
  // So near that what is seen is no normal number.
  constexpr camera touching = in_parallel({{0, 0, 1e-320}, {0, 0, 0}, {0, 1, 0}});
  CHECK_BOTH(irg::is_finite(irg::view_projection(touching, 0.001)));
}

TEST_CASE("view_projection: where the view makes an entry overflow, there is none") {
  camera slender{{4, 3, 6}, {0, 0, 0}, {0, 1, 0}};
  slender.vertical_angle = 0x1p-900;
  slender.near_distance = 0x1p-1000;
  camera distant = in_parallel({{0x1p900, 0x1p900, 1}, {-0x1p900, 0x1p900, 0}, {0, 1, 0}});
  distant.vertical_angle = 0x1p-1070;
  for (const camera& c : {slender, distant}) {
    const auto p = irg::view_projection_checked(c, 1);
    CHECK(p.status == irg::projection_status::not_representable);
    CHECK(p.value == irg::identity_matrix<double, 4>());
  }
}

// How the clip coordinates of a sphere's points lie: the largest |x|/w and |y|/w, and whether all points are in the
// depth range. The points nearest to the border of the picture are among the samples: where the planes through the eye
// touch, and a grid of others.
struct sphere_extent {
  double x = 0, y = 0;
  bool in_depth = true;
};

sphere_extent extent_of(const camera& c, double aspect, const point& centre, double radius) {
  const auto m = irg::view_projection(c, aspect);
  sphere_extent e;
  const auto sample = [&](const vec& direction) {
    const auto p = m * (centre + direction * radius);
    e.x = std::fmax(e.x, std::fabs(p.x) / p.w);
    e.y = std::fmax(e.y, std::fabs(p.y) / p.w);
    e.in_depth = e.in_depth && p.w > 0 && p.z >= 0 && p.z <= p.w;
  };
  const vec back = irg::normalized(c.eye - centre);
  const vec right = irg::normalized(irg::cross(c.up, back)), up = irg::cross(back, right);
  const double sine = c.projection == irg::projection_kind::perspective ? radius / irg::length(c.eye - centre) : 0;
  const double cosine = std::sqrt(1 - sine * sine);
  for (const vec side : {right, -right, up, -up}) sample(side * cosine + back * sine);
  for (int i = 0; i < 60; ++i)
    for (int k = 0; k <= 30; ++k) {
      const double a = i * irg::pi<double> / 30, b = (k - 15) * irg::pi<double> / 30;
      sample(right * (std::cos(a) * std::cos(b)) + up * (std::sin(a) * std::cos(b)) + back * std::sin(b) * 0.999999);
    }
  return e;
}

TEST_CASE("camera_around: the sphere touches the border of the picture and is inside it, narrow, square or wide") {
  test::random r(3);
  for (const auto projection : {irg::projection_kind::perspective, irg::projection_kind::orthographic})
    for (const double aspect : {0.01, 0.25, 0.75, 1.0, 4.0 / 3, 16.0 / 9, 50.0})
      for (const double degrees : {1.0, 20.0, 40.0, 90.0, 150.0})
        for (const double radius : {1e-100, 0.001, 1.0, 700.0, 1e100}) {
          const point centre{radius * static_cast<double>(r.integer(-3, 3)), radius, radius * 2};
          const camera c =
              irg::camera_around(irg::camera<double>{.projection = projection, .vertical_angle = irg::radians(degrees)},
                                 centre, radius, vec{1, 0.8, 1.6}, aspect);
          const sphere_extent e = extent_of(c, aspect, centre, radius);
          CAPTURE(aspect);
          CAPTURE(degrees);
          CAPTURE(radius);
          REQUIRE(e.x <= 1 + 1e-9);
          REQUIRE(e.y <= 1 + 1e-9);
          REQUIRE((aspect < 1 ? e.x : e.y) >= 1 - 1e-6);
          REQUIRE(e.in_depth);
          REQUIRE(c.target == centre);
        }
}

TEST_CASE("camera_around: by hand, 60 degrees see a sphere from twice its radius") {
  constexpr camera c = irg::camera_around(point{1, 2, 3}, 5, vec{0, 0, 7}, irg::pi<double> / 3, 1.5);
  CHECK_BOTH((near(c.eye.z, 13) && c.eye.x == 1 && c.eye.y == 2));
  CHECK_BOTH(near(c.near_distance, 15.0 / 1000));
  CHECK_BOTH(c.far_distance == infinity);
  constexpr camera p = irg::camera_around(
      irg::camera<double>{.projection = irg::projection_kind::orthographic, .vertical_angle = irg::pi<double> / 2},
      point{0, 0, 0}, 5, vec{0, 0, 1}, 1.5);
  CHECK_BOTH(near(p.eye.z, 5));
  CHECK_BOTH((near(p.near_distance, -10) && near(p.far_distance, 10)));
  CHECK_BOTH(p.projection == irg::projection_kind::orthographic);
}

TEST_CASE("camera_around: a sphere of radius 0 is seen from distance 1") {
  constexpr camera c = irg::camera_around(point{1, 2, 3}, 0, vec{0, 0, 1}, 0.7, 1);
  CHECK_BOTH(c.eye == point{1, 2, 4});
  CHECK_BOTH((c.near_distance > 0 && c.near_distance < 1));
  CHECK_BOTH(near(seen(c, 1, {1, 2, 3}).x, 0));
}

TEST_CASE("with_depth_range: nothing of the sphere in front of the eye is cut off, but a thousandth") {
  constexpr camera c = irg::with_depth_range(camera{{0, 0, 10}, {0, 0, 0}, {0, 1, 0}}, {0, 0, 0}, 2);
  CHECK_BOTH(near(c.near_distance, 0.012));
  CHECK_BOTH(c.far_distance == infinity);
  constexpr camera within = irg::with_depth_range(camera{{0, 0, 1}, {0, 0, 0}, {0, 1, 0}}, {0, 0, 0}, 2);
  CHECK_BOTH(near(within.near_distance, 0.003));
  // A depth range of before does not stay.
  constexpr camera narrow{{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, irg::projection_kind::perspective, 0.7, 1, 2};
  CHECK_BOTH(irg::with_depth_range(narrow, {0, 0, 0}, 5).far_distance == infinity);
}

TEST_CASE("with_depth_range: parallel projection sees the whole sphere, behind the eye too") {
  constexpr camera c = irg::with_depth_range(in_parallel({{0, 0, 1}, {0, 0, 0}, {0, 1, 0}}), {0, 0, 0}, 5);
  CHECK_BOTH((seen(c, 1, {0, 0, 5}).z <= 1 && seen(c, 1, {0, 0, 5}).z > 0.5));   // 4 behind the eye
  CHECK_BOTH((seen(c, 1, {0, 0, -5}).z >= 0 && seen(c, 1, {0, 0, -5}).z < 0.5));
  CHECK_BOTH(seen(c, 1, {0, 0, 5}).z > seen(c, 1, {0, 0, -5}).z);
}

TEST_CASE("with_depth_range: a point at the eye still has a range") {
  constexpr camera c = irg::with_depth_range(camera{{1, 1, 1}, {0, 0, 0}, {0, 1, 0}}, {1, 1, 1}, 0);
  CHECK_BOTH((c.near_distance > 0 && c.near_distance < c.far_distance));
  constexpr camera p = irg::with_depth_range(in_parallel({{1, 1, 1}, {0, 0, 0}, {0, 1, 0}}), {1, 1, 1}, 0);
  CHECK_BOTH(p.near_distance < p.far_distance);
  CHECK_BOTH((irg::is_finite(irg::view_projection(c, 0.25)) && irg::is_finite(irg::view_projection(p, 0.25))));
}

TEST_CASE("camera_around: obliquely, the sphere's image touches the border too, and the target's depth stays") {
  test::random r(31);
  for (int i = 0; i < 200; ++i) {
    camera like;
    like.projection = irg::projection_kind::oblique;
    like.vertical_angle = irg::radians(1 + 150 * r.unit());
    like.receding = {6 * r.unit(), 2 * r.unit()};
    const double aspect = 0.2 + 4 * r.unit(), radius = std::pow(10.0, 6 * r.unit() - 3);
    const point centre{radius * r.unit(), 1, -radius};
    const camera c = irg::camera_around(like, centre, radius, vec{0.3, 0.2, 1}, aspect);
    const auto m = irg::view_projection(c, aspect);
    double x = 0, y = 0;
    bool in_depth = true;
    for (int a = 0; a < 180; ++a)
      for (int b = -90; b <= 90; ++b) {
        const double u = a * irg::pi<double> / 90, v = b * irg::pi<double> / 180;
        const auto p = m * (centre + vec{std::cos(u) * std::cos(v), std::sin(v), std::sin(u) * std::cos(v)} * radius);
        x = std::fmax(x, std::fabs(p.x)), y = std::fmax(y, std::fabs(p.y));
        in_depth = in_depth && p.w == 1 && p.z >= 0 && p.z <= 1;
      }
    CHECK((x <= 1 + 1e-9 && y <= 1 + 1e-9));
    CHECK(std::fmax(x, y) >= 1 - 1e-3);
    CHECK(in_depth);
    CHECK((near(seen(c, aspect, centre).x, 0) && near(seen(c, aspect, centre).y, 0)));
  }
}

TEST_CASE("view_projection: oblique by hand, depth to the right at half its length") {
  constexpr camera c{{0, 0, 2},           {0, 0, 0}, {0, 1, 0}, irg::projection_kind::oblique,
                     irg::pi<double> / 2, -10,       10,        {0.0, 0.5}};
  CHECK_BOTH((near(seen(c, 1, {0, 2, 0}).y, 1) && near(seen(c, 1, {2, 0, 0}).x, 1)));
  CHECK_BOTH((near(seen(c, 1, {0, 0, -2}).x, 0.5) && near(seen(c, 1, {0, 0, 2}).x, -0.5)));
  CHECK_BOTH(near(seen(c, 1, {0, 1, -2}).y, 0.5));
}

TEST_CASE("viewpoint: the eye in perspective; far out along the rays in parallel projection") {
  constexpr camera c{{1, 2, 3}, {0, 0, 0}, {0, 1, 0}};
  CHECK_BOTH(irg::viewpoint(c) == point{1, 2, 3});
  test::random r(32);
  for (int i = 0; i < 500; ++i) {
    camera o = in_parallel({{r.unit(), 2 * r.unit() + 1, 3}, {r.unit(), 0, 0}, {0, 1, 0}});
    if (i % 2) o.projection = irg::projection_kind::oblique, o.receding = {6 * r.unit(), r.unit()};
    o = irg::with_depth_range(o, {0, 0, 0}, 5);
    const point viewer = irg::viewpoint(o);
    // Positions on the way to the viewer have one picture, and come nearer.
    const auto m = irg::view_projection(o, 1.5);
    const point p{r.unit(), r.unit(), r.unit()}, q = p + irg::normalized(viewer - p) * 2.0;
    const auto first = m * p, second = m * q;
    CHECK((std::fabs(first.x - second.x) <= 1e-8 && std::fabs(first.y - second.y) <= 1e-8 && first.z < second.z));
    // From anywhere in the scene the direction is the same.
    const vec a = irg::normalized(viewer - point{-5, -5, -5}), b = irg::normalized(viewer - point{5, 5, 5});
    CHECK(irg::length(a - b) <= 0x1p-28);
  }
  const point far_out = irg::viewpoint(in_parallel({{1e308, 0, 0}, {0, 0, 0}, {0, 1, 0}, {}, 0.7, -1e308, 1e308}));
  CHECK((std::isfinite(far_out.x) && std::isfinite(far_out.y) && std::isfinite(far_out.z)));
  const auto small =
      irg::viewpoint(irg::camera<float>{{0, 0, 1e37f}, {0, 0, 0}, {0, 1, 0}, irg::projection_kind::oblique});
  CHECK((std::isfinite(small.x) && std::isfinite(small.z)));
}

TEST_CASE("camera: constant evaluation gives the bits of run time") {
  constexpr auto at_compile_time =
      irg::view_projection(irg::camera_around(point{0.1, 0.2, 0.3}, 1.7, vec{1, 0.8, 1.6}, 0.69, 16.0 / 9), 16.0 / 9);
  volatile double angle = 0.69;
  CHECK(
      at_compile_time ==
      irg::view_projection(irg::camera_around(point{0.1, 0.2, 0.3}, 1.7, vec{1, 0.8, 1.6}, angle, 16.0 / 9), 16.0 / 9));
}

TEST_CASE("camera_from: a frame's camera, exactly where the numbers are") {
  using frame = irg::camera_frame<double>;
  constexpr camera like{.vertical_angle = 0.5, .near_distance = 0.25, .far_distance = 64};
  constexpr frame from_x{{5, 1, 0}, {0, 0, -1}, {0, 1, 0}, {-1, 0, 0}};
  constexpr camera c = irg::camera_from(from_x, 5, like);
  CHECK_BOTH((c.eye == point{5, 1, 0} && c.target == point{0, 1, 0} && c.up == vec{0, 1, 0}));
  CHECK_BOTH((c.vertical_angle == 0.5 && c.near_distance == 0.25 && c.far_distance == 64));
  CHECK_BOTH(irg::frame_of(c) == from_x);
  CHECK_BOTH(irg::view_projection(c, 1.5) == irg::perspective(0.5, 1.5, 0.25, 64.0) * irg::view_matrix(from_x) * 4.0);
  // On its side, and upside down.
  constexpr frame rolled{{0, 0, 2}, {0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
      turned{{0, 0, 2}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  CHECK_BOTH(irg::frame_of(irg::camera_from(rolled, 2)) == rolled);
  CHECK_BOTH(irg::frame_of(irg::camera_from(turned, 0.5)) == turned);
  // Parallel: what is seen is as high as the angle at that distance.
  CHECK_BOTH(irg::view_projection(in_parallel(irg::camera_from(rolled, 4, like)), 1) ==
             irg::view_projection(in_parallel({{0, 0, 2}, {0, 0, -2}, {1, 0, 0}, {}, 0.5, 0.25}), 1));
}

TEST_CASE("camera_from: random frames, the view projected as by the frame's own matrix, through the poles too") {
  test::random r(6);
  double views = 0, far_out = 0;
  for (int i = 0; i < 3000; ++i) {
    irg::camera_frame<double> f;
    const auto any = [&] { return r.unit() - 0.5; };
    for (int k = 0; k < 3; ++k) f.forward[k] = any(), f.up[k] = any();
    f = irg::orthonormalized(f);
    for (int k = 0; k < 3; ++k) f.position[k] = any();
    const double distance = std::ldexp(1.0, static_cast<int>(r.integer(-1, 40)));
    views = std::max(views, test::worst_difference(irg::view_matrix(irg::frame_of(irg::camera_from(f, distance))),
                                                   irg::view_matrix(f)));
    // Far out, with the target as far away as that.
    for (int k = 0; k < 3; ++k) f.position[k] *= 0x1p40;
    const auto axes = irg::frame_of(irg::camera_from(f, 0x1p40));
    for (int k = 0; k < 3; ++k)
      far_out = std::max({far_out, std::fabs(axes.right[k] - f.right[k]), std::fabs(axes.up[k] - f.up[k]),
                          std::fabs(axes.forward[k] - f.forward[k])});
  }
  INFO("within ", views * 0x1p53, "u, far out ", far_out * 0x1p53, "u");
  CHECK(views <= 16 * 0x1p-53);
  CHECK(far_out <= 16 * 0x1p-53);
  // On an orbit over the pole the picture does not turn over; a fixed up would.
  for (const double degrees : {89.0, 90.0, 91.0}) {
    const irg::polar_camera<double> orbit{{0, 0, 0}, 5, 0, irg::radians(degrees)};
    const point p = seen(irg::camera_from(irg::frame_of(orbit), 5), 1, {0.5, 0, 0.2});
    CHECK(p.x > 0);
    CHECK(p.y < 0);
  }
}

}  // namespace
