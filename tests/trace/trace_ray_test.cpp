// SPDX-License-Identifier: MIT
#include <irg/trace/trace_ray.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <doctest/doctest.h>
#include <irg/mesh/shapes.hpp>

#include "support/random.hpp"
#include "trace/worlds.hpp"

namespace {

using world = irg::ray_world<double>;
using R = irg::ray<double, 3>;
using light = irg::light<double>;
using V = irg::vec<double, 3>;
using P = irg::point<double, 3>;
constexpr irg::material<double> white{{1, 1, 1}, {1, 1, 1}, {}, 1};
constexpr irg::material<double> dark{};
constexpr irg::rgb<double> sky{0.25, 0.5, 1};

TEST_CASE("trace_ray: shadows of near lamps, of lamps at infinity, through glass, and none") {
  const test::kept_body floor(test::rectangle({-9, -9, 0}, {18, 0, 0}, {0, 18, 0}), {}),
      roof(test::rectangle({-1, -1, 2}, {2, 0, 0}, {0, 2, 0}), {});
  const std::vector<light> near{{{0, 0, 4, 1}, {1, 1, 1}}}, between{{{0, 0, 1, 1}, {1, 1, 1}}},
      far{{{0, 0, 1, 0}, {1, 1, 1}}}, doubled{{{0, 0, 8, 2}, {1, 1, 1}}}, below{{{0, 0, -1, 0}, {1, 1, 1}}};
  const auto at = [&](const std::vector<light>& lights, double x, const irg::optics<double>& optic = {},
                      irg::shadow_rays shadows = irg::shadow_rays::on) {
    const world w({floor.body(white), roof.body(dark, optic)}, {{}, lights}, sky);
    return irg::trace_ray(w, R{{x, 0.125, 1}, {0, 0, -1}}, {.shadows = shadows}).r;
  };
  CHECK(at(near, 0.25) == 0);
  CHECK(at(near, 1.9) == 0);  // the roof's shadow ends at 2
  CHECK(at(near, 2.1) > 0.5);
  CHECK(at(doubled, 1.9) == 0);
  CHECK(at(doubled, 2.1) == at(near, 2.1));
  CHECK(at(between, 0.25) > 0.9);  // the roof is behind the lamp
  CHECK(at(far, 0.9) == 0);
  CHECK(at(far, 1.1) == 1);
  CHECK(at(below, 3) == 0);
  CHECK(at(near, 0.25, {}, irg::shadow_rays::off) > 0.9);
  irg::optics<double> glass;
  glass.transmitted = {0.5, 0.5, 0.5};
  CHECK(at(far, 0.9, glass) == 0.5);
}

TEST_CASE("trace_ray: mirrors, and mirrors in mirrors up to the last bounce") {
  const test::kept_body floor(test::rectangle({-9, -9, 0}, {18, 0, 0}, {0, 18, 0}), {}),
      ceiling(test::rectangle({-9, 9, 1}, {18, 0, 0}, {0, -18, 0}), {});
  irg::optics<double> mirror;
  mirror.mirrored = {0.5, 0.5, 0.5};
  const world one({floor.body(dark, mirror)}, {}, sky);
  CHECK(irg::trace_ray(one, R{{0, 0, 1}, {1, 0, -1}}) == irg::rgb<double>{0.125, 0.25, 0.5});
  CHECK(irg::trace_ray(one, R{{0, 0, 1}, {1, 0, 1}}) == sky);
  CHECK(irg::trace_ray(one, R{{0, 0, 1}, {1, 0, -1}}, {.bounces = 0}) == irg::rgb<double>{});
  // Each of two mirrors glows: 1 + 1/2 + 1/4 + ...
  const world two({floor.body(white, mirror), ceiling.body(white, mirror)}, {{1, 1, 1}, {}}, sky);
  const R up{{0, 0, 0.5}, {0.001, 0, 1}};
  CHECK(irg::trace_ray(two, up, {.bounces = 3, .least_share = 0}).r == 1.875);
  CHECK(irg::trace_ray(two, up, {.bounces = 40, .least_share = 0}).r == doctest::Approx(2).epsilon(1e-9));
  CHECK(irg::trace_ray(two, up, {.bounces = 40, .least_share = 0.2}).r == 1.75);
}

TEST_CASE("trace_ray: where a smooth surface's normal would mirror a ray into the triangle, the triangle mirrors it") {
  test::kept_body floor(test::rectangle({-9, -9, 0}, {18, 0, 0}, {0, 18, 0}), {});
  const test::kept_body above(test::rectangle({-1, -1, 5}, {0, 2, 0}, {2, 0, 0}), {}),
      below(test::rectangle({-1, -1, -5}, {2, 0, 0}, {0, 2, 0}), {});
  irg::optics<double> mirror;
  mirror.mirrored = {0.5, 0.5, 0.5};
  const auto seen = [&](double degrees, double side) {
    const double turn = degrees * irg::pi<double> / 180;
    floor.normals.assign(4, V{std::sin(turn), 0, std::cos(turn)});
    const world w({floor.body(dark, mirror), above.body(white), below.body(white)}, {{1, 1, 1}, {}}, {});
    return irg::trace_ray(w, R{{0.125, 0.25, side}, {0, 0, -side}}, {.bounces = 1}).r;
  };
  // The normal turns the mirrored ray by twice its angle, beside the plates; from 45 degrees on it would go into the
  // floor, which then mirrors by its own normal, straight back to a plate.
  for (const double side : {1.0, -1.0}) {
    CHECK(seen(0, side) == 0.5);
    CHECK(seen(30, side) == 0);
    CHECK(seen(44, side) == 0);
    CHECK(seen(46, side) == 0.5);
    CHECK(seen(60, side) == 0.5);
  }
  // A ray that would be mirrored along the floor, to the last bit, is one of them.
  floor.normals.assign(4, V{1, 0, 2});
  const test::kept_body aside(test::rectangle({2.75, -1, 5}, {0, 2, 0}, {2, 0, 0}), {});
  const world w({floor.body(dark, mirror), aside.body(white)}, {{1, 1, 1}, {}}, {});
  const V along = V{0.6, 0, -0.8}, n = normalized(V{1, 0, 2});
  REQUIRE((along - n * (dot(along, n) * 2)).z == 0);
  CHECK(irg::trace_ray(w, R{{-0.75, 0.25, 1}, {3, 0, -4}}, {.bounces = 1}).r == 0.5);
}

TEST_CASE("refracted_direction: Snell's law, and whole reflection") {
  const double s = 0.6, c = 0.8;
  const auto in = irg::refracted_direction(V{s, 0, -c}, V{0, 0, 1}, 1 / 1.5);
  REQUIRE(in.has_value());
  CHECK(in->x == doctest::Approx(s / 1.5));
  CHECK(in->z == doctest::Approx(-std::sqrt(1 - s * s / 2.25)));
  CHECK(!irg::refracted_direction(V{c, 0, -s}, V{0, 0, 1}, 1.5));
  CHECK(*irg::refracted_direction(V{s, 0, -c}, V{0, 0, 1}, 1.0) == V{s, 0, -c});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(!irg::refracted_direction(V{nan, 0, -c}, V{0, 0, 1}, 1.0));
}

TEST_CASE("trace_ray: glass moves what is behind it as its thickness says; from within it, too") {
  // A slab of glass over a wall that is lit by place: ambient light on two halves.
  const test::kept_body slab(irg::shape_cube<double>(), {-30, -20, 0}, 40),
      wall(test::rectangle({-90, -90, -1}, {90, 0, 0}, {0, 180, 0}), {});
  const irg::material<double> glowing{{1, 1, 1}, {}, {}, 1};
  irg::optics<double> glass{{}, {1, 1, 1}, 1.5};
  const world w({slab.body(dark, glass), wall.body(glowing)}, {{1, 1, 1}, {}}, {});
  // At 45 degrees through 40 of glass and 1 of air: x moves by 40 tan(asin(sin 45 / 1.5)) and 1.
  const double moved = 40 * std::tan(std::asin(std::sqrt(0.5) / 1.5)) + 1;
  const auto lit = [&](double x) { return irg::trace_ray(w, R{{x - 1, 0.3, 41}, {1, 0, -1}}).r; };
  CHECK(lit(-moved - 0.01) == 1);
  CHECK(lit(-moved + 0.01) == 0);
  // An eye within the glass: 3 of it, and 1 of air.
  const double from_within = 3 * 0.5 + std::tan(std::asin(1.5 * std::sin(std::atan(0.5))));
  CHECK(irg::trace_ray(w, R{{-from_within - 0.01, 0.3, 3}, {0.5, 0, -1}}).r == 1);
  CHECK(irg::trace_ray(w, R{{-from_within + 0.01, 0.3, 3}, {0.5, 0, -1}}).r == 0);
  // What is flat enough never leaves: it is reflected, and time is bounded.
  CHECK(irg::trace_ray(w, R{{0.1, 0.2, 3}, {1, 0, -1}}, {.bounces = 32, .least_share = 0}).r >= 0);
}

TEST_CASE("trace_ray: rays that are none, worlds that are empty, scales") {
  CHECK(irg::trace_ray(world(), R{{0, 0, 0}, {0, 0, 1}}) == irg::rgb<double>{});
  const world empty({}, {}, sky);
  CHECK(irg::trace_ray(empty, R{{0, 0, 0}, {0, 0, 1}}) == sky);
  CHECK(irg::trace_ray(empty, R{{0, 0, 0}, {0, 0, 0}}) == sky);
  for (const double s : {1.0, 0x1p-40, 0x1p40, 0x1p-300, 0x1p300, 0x1p-700, 0x1p700}) {
    const test::kept_body ball(irg::shape_sphere<double>({.slices = 16, .stacks = 8}), {}, s);
    const std::vector<light> lights{{{0, 0, 1, 0}, {1, 1, 1}}};
    const world w({ball.body(white)}, {{}, lights}, sky);
    const double lit = irg::trace_ray(w, R{{0.1 * s, 0.1 * s, 9 * s}, {0, 0, -s}}).r;
    CHECK(lit > 0.9);
    CHECK(irg::trace_ray(w, R{{0.1 * s, 0.1 * s, -9 * s}, {0, 0, s}}).r == 0);
  }
}

TEST_CASE("trace_ray: never NaN where light does not overflow, whatever the shapes") {
  test::random r(77);
  const auto any = [&] { return std::ldexp(2 * r.unit() - 1, static_cast<int>(r.integer(-1070, 1022))); };
  const auto colour = [&] { return irg::rgb<double>{r.unit(), r.unit(), r.integer(0, 1) == 0 ? 0 : r.unit()}; };
  for (int i = 0; i < 40; ++i) {
    irg::mesh<double> m;
    for (std::uint32_t k = 0; k < 8; ++k) {
      for (int c = 0; c < 3; ++c) m.positions.push_back({any(), any(), any()});
      irg::add_face(m, std::array{3 * k, 3 * k + 1, 3 * k + 2});
    }
    const test::kept_body body(m, {});
    const std::vector<light> lights{{{any(), any(), any(), any()}, colour()},
                                    {{m.positions[0].x, m.positions[0].y, m.positions[0].z, 1}, colour()}};
    const world w({body.body({colour(), colour(), colour(), 7}, {colour(), colour(), r.unit()})}, {colour(), lights});
    for (int k = 0; k < 10; ++k) {
      const P from{any(), any(), any()};
      const irg::rgb<double> seen = irg::trace_ray(w, R{from, m.positions[static_cast<std::size_t>(k)] - from});
      REQUIRE(0 <= seen.r);
      REQUIRE(0 <= seen.g);
      REQUIRE(0 <= seen.b);
    }
  }
}

TEST_CASE("trace_ray: what overflows is NaN in a mirror without a channel") {
  const test::kept_body floor(test::rectangle({-9, -9, 0}, {18, 0, 0}, {0, 18, 0}), {}),
      mirror(test::rectangle({-9, 9, 5}, {18, 0, 0}, {0, -18, 0}), {});
  const std::vector<light> lamp{{{0, 0, 1, 1}, {1e200, 1e200, 1e200}}};
  const world w({floor.body({{}, {1e200, 1e200, 1e200}, {}, 1}), mirror.body(dark, {{1, 1, 0}, {}})}, {{}, lamp});
  const irg::rgb<double> seen = irg::trace_ray(w, R{{0, 0, 3}, {0.125, 0, 1}});
  CHECK(seen.r == HUGE_VAL);
  CHECK(std::isnan(seen.b));
}

TEST_CASE("trace_from: the light of phong_model, bit by bit, where nothing is in the way") {
  const test::kept_body ball(irg::shape_sphere<double>({.slices = 16, .stacks = 8}), {});
  const std::vector<light> lights{{{3, 4, 5, 1}, {0.5, 0.6, 0.7}}, {{1, 0, 1, 0}, {0.3, 0.2, 0.1}}};
  const irg::material<double> surface{{0.2, 0.3, 0.4}, {0.5, 0.6, 0.7}, {0.3, 0.3, 0.3}, 20};
  const world w({ball.body(surface)}, {{0.1, 0.2, 0.3}, lights, irg::distance_term::viewer, 2}, sky);
  for (int i = 0; i < 20; ++i) {
    const R r{{0.03 * i, 0.3, 4}, {0, 0, -1}};
    const auto s = w.meet(r);
    REQUIRE(s.has_value());
    const auto expected = irg::phong_model(surface, w.light(), r.origin, {s->at, s->normal});
    CHECK(irg::trace_ray(w, r, {.shadows = irg::shadow_rays::off}) == expected);
    CHECK(irg::trace_ray(w, r) == expected);  // a ball lights up wherever its triangles are turned to the lamps
  }
}

}  // namespace
