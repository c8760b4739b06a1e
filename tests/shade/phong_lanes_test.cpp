// SPDX-License-Identifier: MIT
#include <irg/shade/phong_lanes.hpp>

#include <array>
#include <cmath>
#include <limits>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::rgb;
constexpr int count = irg::native_lanes<double>;
using F = irg::pack<double, count>;
using triple = irg::triple_lanes<double, count>;

rgb<double> any_colour(test::random& r) { return {r.unit(), r.unit(), r.unit()}; }

// A shader with lights at infinity, in space, of negative weight; dull surfaces, whole and broken exponents.
struct any_shader {
  std::array<irg::light<double>, 3> lights{};
  irg::phong_shader<double> shader{};

  explicit any_shader(test::random& r) {
    for (auto& l : lights) {
      const double w[] = {0, 1, -0.5};
      l = {{2 * r.unit() - 1, 2 * r.unit() - 1, 2 * r.unit() - 1, w[r.integer(0, 2)]}, any_colour(r)};
    }
    const double exponent = r.integer(0, 1) != 0 ? static_cast<double>(r.integer(1, 60)) : 30 * r.unit() + 0.1;
    const auto used = std::span(lights).first(static_cast<std::size_t>(r.integer(0, 3)));
    shader.surface = {any_colour(r), any_colour(r), r.integer(0, 2) != 0 ? any_colour(r) : rgb<double>{}, exponent};
    shader.light = {any_colour(r), used, r.integer(0, 3) != 0 ? irg::distance_term::none : irg::distance_term::viewer,
                    0.5};
    shader.eye = {4 * r.unit(), r.unit(), 3};
  }
  any_shader(const any_shader&) = delete;
  any_shader& operator=(const any_shader&) = delete;
};

bool same(const rgb<double>& a, const rgb<F>& b, int i) {
  const auto equal = [](double x, double y) { return x == y || (x != x && y != y); };
  return equal(a.r, b.r[i]) && equal(a.g, b.g[i]) && equal(a.b, b.b[i]);
}

// How many of the lanes are not what the shader gives.
int wrong(const any_shader& s, const triple& p, const triple& n) {
  const irg::phong_lanes lanes(s.shader);
  const rgb<F> light = lanes(p, n);
  int bad = 0;
  for (int i = 0; i < count; ++i) bad += !same(s.shader({p.x[i], p.y[i], p.z[i]}, {n.x[i], n.y[i], n.z[i]}), light, i);
  return bad;
}

template <class Make>
triple generate(const Make& make) {
  using f = irg::lanes<F>;
  return {f::generate(make), f::generate(make), f::generate(make)};
}

}  // namespace

TEST_CASE("phong_lanes: the light of phong_shader, bit for bit") {
  test::random r(21);
  for (int k = 0; k < 2000; ++k) {
    const any_shader s(r);
    for (int i = 0; i < 5; ++i) {
      const auto moderate = [&](int) { return 2 * r.unit() - 1; };
      const triple p = generate(moderate);
      REQUIRE(wrong(s, p, generate(moderate)) == 0);
    }
  }
}

TEST_CASE("phong_lanes: sizes of all magnitudes, points in the light and in the eye, no normal, NaN") {
  test::random r(22);
  constexpr double hostile[] = {
      0, 1, -1, 1e-320, 1e308, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()};
  for (int k = 0; k < 2000; ++k) {
    const any_shader s(r);
    const int size = static_cast<int>(r.integer(-1060, 1000));
    const auto wide = [&](int) { return std::ldexp(2 * r.unit() - 1, size); };
    const auto mixed = [&](int) { return std::ldexp(2 * r.unit() - 1, static_cast<int>(r.integer(-150, 150))); };
    const auto odd = [&](int) { return hostile[r.integer(0, 6)]; };
    REQUIRE(wrong(s, generate(wide), generate(wide)) == 0);
    REQUIRE(wrong(s, generate(mixed), generate(mixed)) == 0);
    REQUIRE(wrong(s, generate(odd), generate(odd)) == 0);
    const irg::point<double, 3>& eye = s.shader.eye;
    using f = irg::lanes<F>;
    REQUIRE(wrong(s, {f::broadcast(eye.x), f::broadcast(eye.y), f::broadcast(eye.z)}, generate(mixed)) == 0);
  }
}

TEST_CASE("phong_lanes: light without bounds, of which nothing falls on what is turned away") {
  test::random r(8);
  for (const double most : {1e200, 1e308, std::numeric_limits<double>::infinity()})
    for (int k = 0; k < 100; ++k) {
      any_shader s(r);
      for (auto& l : s.lights) l.intensity.g *= most, l.intensity.b *= -most;
      s.shader.surface.diffuse.r *= most;
      const auto moderate = [&](int) { return 2 * r.unit() - 1; };
      const triple p = generate(moderate);
      REQUIRE(wrong(s, p, generate(moderate)) == 0);
    }
  constexpr static irg::light<double> behind[] = {{{0, 0, -1, 0}, {1e308, std::numeric_limits<double>::infinity(), 1}}};
  constexpr auto seen = [] {
    const irg::phong_shader<double> shader{{{1, 1, 1}, {1e308, 1, 1}, {1, 1, 1}, 3}, {{1, 1, 1}, behind}, {0, 0, 9}};
    return shader({0, 0, 0}, {0, 0, 1});
  };
  CHECK_BOTH(seen() == irg::rgb<double>{1, 1, 1});
}

TEST_CASE("phong_lanes: exponents of all sizes, seen along the mirrored ray") {
  test::random r(18);
  for (int k = 0; k < 2000; ++k) {
    any_shader s(r);
    s.shader.surface.shininess = std::ldexp(1 + r.unit(), static_cast<int>(r.integer(-10, 1000)));
    const irg::hpoint<double, 3>& l = s.lights[0].position;
    s.shader.eye = {3 * l.x, 3 * l.y, 3 * l.z};
    using f = irg::lanes<F>;
    const auto zero = [](int) { return 0.0; };
    REQUIRE(wrong(s, generate(zero), {f::broadcast(l.x), f::broadcast(l.y), f::broadcast(l.z)}) == 0);
  }
}

TEST_CASE("phong_lanes: what becomes of the shader later does not matter") {
  test::random r(73);
  any_shader s(r);
  const irg::phong_shader<double> kept = s.shader;
  const irg::phong_lanes made(s.shader);
  const irg::phong_lanes lanes = made;
  s.shader = {};
  const triple p = generate([&](int i) { return 0.25 * i; }), n = generate([](int i) { return i == 1 ? 1e200 : 1.0; });
  const rgb<F> light = lanes(p, n);
  for (int i = 0; i < count; ++i) CHECK(same(kept({p.x[i], p.y[i], p.z[i]}, {n.x[i], n.y[i], n.z[i]}), light, i));
}

TEST_CASE("phong_lanes: lanes that are not needed do not send the others the slow way, nor change them") {
  test::random r(23);
  const any_shader s(r);
  const irg::phong_lanes lanes(s.shader);
  triple p = generate([&](int) { return r.unit(); }), n = generate([&](int) { return r.unit(); });
  const rgb<F> all = lanes(p, n);
  irg::set_lane(p.x, 1, 0.0 * std::numeric_limits<double>::infinity());
  const rgb<F> but_one = lanes(p, n, ~2u);
  for (int i = 0; i < count; ++i)
    if (i != 1) CHECK(but_one.r[i] == all.r[i]);
}
