// SPDX-License-Identifier: MIT
#include <irg/shade/phong_model.hpp>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "support/check_both.hpp"
#include "support/rational.hpp"
#include "support/random.hpp"

namespace {

using test::rational;
template <class T>
using vec3 = irg::vec<T, 3>;
template <class T>
using point3 = irg::point<T, 3>;

constexpr rational f(std::int64_t n, std::int64_t d = 1) { return rational(n, d); }

// The textbook's example: Ia = 100, ka = 1/5, Ii = 200, kd = ks = 1/2, n = 2, and r = 3, k = 1 where distance counts.
constexpr irg::material<rational, rational> example{f(1, 5), f(1, 2), f(1, 2), f(2)};
constexpr vec3<rational> up{f(0), f(0), f(1)};

constexpr rational formula_9(const vec3<rational>& l, const vec3<rational>& v) {
  return irg::ambient_term(f(100), example.ambient) + irg::reflected_light(example, f(200), l, up, v);
}
constexpr rational formula_10(const vec3<rational>& l, const vec3<rational>& v) {
  return irg::ambient_term(f(100), example.ambient) +
         irg::reflected_light(example, irg::weakened_by_distance(f(200), f(3), f(1)), l, up, v);
}
constexpr rational formula_7(const vec3<rational>& l) {
  return irg::ambient_term(f(100), example.ambient) + irg::diffuse_term(f(200), example.diffuse, l, up);
}

}  // namespace

TEST_CASE("phong_model: types") {
  static_assert(std::is_same_v<decltype(formula_9(up, up)), rational>);
  static_assert(
      std::is_same_v<decltype(irg::diffuse_term(irg::rgb<float>{}, irg::rgb<float>{}, vec3<float>{}, vec3<float>{})),
                     irg::rgb<float>>);
  static_assert(noexcept(irg::phong_model(irg::material<float>{}, irg::lighting<float>{}, point3<float>{},
                                          {point3<float>{}, vec3<float>{}})));
}

TEST_CASE("phong_model: the course's values, exactly") {
  constexpr vec3<rational> low{f(3, 5), f(0), f(4, 5)}, mirror{f(-3, 5), f(0), f(4, 5)};
  CHECK_BOTH(irg::reflected_direction(up, up) == up);
  CHECK_BOTH(irg::reflected_direction(low, up) == mirror);
  CHECK_BOTH(irg::reflected_direction(vec3<rational>{f(0), f(3, 5), f(-4, 5)}, up) ==
             vec3<rational>{f(0), f(-3, 5), f(-4, 5)});
  struct row {
    vec3<rational> l, v;
    rational by_9, by_10, by_7;
  };
  constexpr std::array<row, 6> rows{{
      {up, up, f(220), f(70), f(120)},
      {low, mirror, f(200), f(65), f(100)},
      {low, up, f(164), f(56), f(100)},
      {{f(12, 13), f(0), f(5, 13)}, {f(3, 5), f(0), f(4, 5)}, f(760, 13), f(385, 13), f(760, 13)},  // R.V < 0
      {{f(0), f(3, 5), f(-4, 5)}, up, f(20), f(20), f(20)},                                          // light behind
      {{f(1), f(0), f(0)}, up, f(20), f(20), f(20)},                                                 // light grazing
  }};
  constexpr auto all_right = [](const std::array<row, 6>& table) {
    for (const row& r : table)
      if (!(formula_9(r.l, r.v) == r.by_9 && formula_10(r.l, r.v) == r.by_10 && formula_7(r.l) == r.by_7)) return false;
    return true;
  };
  CHECK_BOTH(all_right(rows));
  for (const row& r : rows) {
    CHECK(formula_9(r.l, r.v) == r.by_9);
    CHECK(formula_10(r.l, r.v) == r.by_10);
    CHECK(formula_7(r.l) == r.by_7);
  }
}

TEST_CASE("phong_model: light from behind makes no highlight, even where R.V > 0") {
  constexpr vec3<rational> behind{f(3, 5), f(0), f(-4, 5)}, viewer{f(-3, 5), f(0), f(-4, 5)};
  static_assert(irg::dot(irg::reflected_direction(behind, up), viewer) == f(1));
  CHECK_BOTH(irg::specular_factor(behind, up, viewer, f(2)) == f(0));
}

TEST_CASE("phong_model: integer powers") {
  CHECK_BOTH(irg::integer_power(f(2, 3), 0) == f(1));
  CHECK_BOTH(irg::integer_power(f(2, 3), 1) == f(2, 3));
  CHECK_BOTH(irg::integer_power(f(-2, 3), 7) == f(-128, 2187));
  CHECK_BOTH(irg::integer_power(0.5, 1024) == 0x1p-1024);
  CHECK_BOTH(irg::integer_power(2.0, 1023) == 0x1p1023);  // no square too many: 2^1024 would be infinite
  test::random random(1);
  const int trials = std::getenv("IRG_RELEASE_TIER") ? 10000000 : 100000;
  for (int i = 0; i < trials; ++i) {
    const double x = 0.5 + random.unit() / 2;
    const int n = static_cast<int>(random.integer(1, 600));
    const long double exact = std::pow(static_cast<long double>(x), static_cast<long double>(n));
    REQUIRE(std::abs(static_cast<long double>(irg::integer_power(x, n)) - exact) <= (n - 1 + 1e-3L) * 0x1p-53L * exact);
  }
}

TEST_CASE("phong_model: which shininess is a small integer") {
  const auto small = [](auto x) { return irg::detail::small_integer(x); };
  for (int n = 0; n <= 1024; ++n) {
    CHECK(small(static_cast<float>(n)) == n);
    CHECK(small(static_cast<double>(n)) == n);
    CHECK(small(f(n)) == n);
  }
  CHECK_BOTH(small(f(1024)) == 1024);
  CHECK_BOTH(small(f(1025)) == -1);
  CHECK_BOTH(small(f(5000)) == -1);
  CHECK_BOTH(small(f(-1)) == -1);
  CHECK_BOTH(small(f(7, 2)) == -1);
  CHECK_BOTH(small(1024.5) == -1);
  CHECK_BOTH(small(1025.0) == -1);
  CHECK_BOTH(small(-1.0f) == -1);
  CHECK_BOTH(small(2.5f) == -1);
  CHECK_BOTH(small(1e300) == -1);
  CHECK_BOTH(small(std::numeric_limits<float>::quiet_NaN()) == -1);
  CHECK_BOTH(small(std::numeric_limits<double>::infinity()) == -1);
}

TEST_CASE("phong_model: a shininess that is no integer") {
  constexpr vec3<double> l{0.6, 0, 0.8}, n{0, 0, 1}, v{0, 0, 1};
  constexpr double in_constant_evaluation = irg::specular_factor(l, n, v, 2.5);
  const volatile double at_run_time = 2.5;
  CHECK(irg::specular_factor(l, n, v, static_cast<double>(at_run_time)) == in_constant_evaluation);
  CHECK(irg::specular_factor(l, n, v, 2.5) == doctest::Approx(std::pow(0.8, 2.5)).epsilon(1e-14));
  CHECK(irg::specular_factor(l, n, v, 5000.0) == doctest::Approx(std::pow(0.8, 5000.0)).epsilon(1e-10));
  CHECK(irg::specular_factor(l, n, v, 2.0) == doctest::Approx(0.64).epsilon(1e-14));
}

TEST_CASE("phong_model: a highlight of whatever shininess is no brighter than its light, and none on a dull surface") {
  test::random r(17);
  const auto any = [&] { return vec3<double>{2 * r.unit() - 1, 2 * r.unit() - 1, 2 * r.unit() - 1}; };
  int above = 0;
  for (int i = 0; i < 2000; ++i) {
    const vec3<double> n = irg::normalized(any()), l = i % 2 == 0 ? n : irg::normalized(any() + n * 2.0),
                       v = irg::normalized(irg::reflected_direction(l, n));
    above += 1 < irg::dot(irg::reflected_direction(l, n), v) ? 1 : 0;
    for (const double shininess : {1024.5, 1e15, 1e25, 1e300}) {
      REQUIRE(irg::specular_factor(l, n, v, shininess) <= 1);
      const irg::material<double, double> matt{0, 1, 0, shininess};
      const double light = irg::reflected_light(matt, 1.0, l, n, v);
      REQUIRE(light == irg::diffuse_term(1.0, 1.0, l, n));
    }
  }
  CHECK(above > 200);
  static_assert(irg::specular_factor(vec3<double>{0, 0, 1 + 0x1p-52}, {0, 0, 1}, {0, 0, 1}, 1e300) == 1);
}

namespace {

constexpr irg::material<double, double> dull{0.2, 0.6, 0.0, 1.0};
constexpr irg::material<double, double> shiny{0.2, 0.5, 0.5, 2.0};
using lights = std::array<irg::light<double, double>, 2>;
constexpr static lights sun_and_lamp{{{{0, 0, 7, 0}, 200.0}, {{3, 0, 4, 1}, 100.0}}};

constexpr double seen(const irg::material<double, double>& m, irg::lighting<double, double> light, point3<double> eye,
                      vec3<double> normal = {0, 0, 1}) {
  return irg::phong_model(m, light, eye, {{0, 0, 0}, normal});
}

}  // namespace

TEST_CASE("phong_model: in a scene") {
  constexpr std::span<const irg::light<double, double>> both(sun_and_lamp), sun(both.first<1>());
  CHECK_BOTH(seen(shiny, {100.0, {}}, {0, 0, 3}) == 20.0);             // no lights
  CHECK_BOTH(seen(shiny, {100.0, sun}, {0, 0, 3}) == 220.0);           // head-on, a light at infinity
  CHECK_BOTH(seen(shiny, {100.0, sun, irg::distance_term::viewer, 1.0}, {0, 0, 3}) == 70.0);  // (7.10), r = 3, k = 1
  CHECK_BOTH(seen(dull, {100.0, sun}, {0, 0, 3}) == 20.0 + 120.0);
  // Sources add up: the lamp stands at L = (3/5, 0, 4/5), R.V = 4/5.
  CHECK_BOTH(seen(dull, {100.0, both}, {0, 0, 3}) == 20.0 + 120.0 + 100 * 0.6 * 0.8);
  CHECK(seen(shiny, {100.0, both}, {0, 0, 3}) ==
        doctest::Approx(220.0 + 100 * (0.5 * 0.8 + 0.5 * 0.64)).epsilon(1e-14));
}

TEST_CASE("phong_model: each channel of a colour is the one-channel model") {
  test::random random(7);
  const auto unit = [&] { return random.unit(); };
  const auto around = [&] { return random.unit() * 10 - 5; };
  for (int i = 0; i < 2000; ++i) {
    const irg::rgb<double> ka{unit(), unit(), unit()}, kd{unit(), unit(), unit()}, ks{unit(), unit(), unit()};
    const double n = static_cast<double>(random.integer(1, 60));
    const std::array<irg::light<double>, 2> colours{{{{around(), around(), around(), 1}, {unit(), unit(), unit()}},
                                                     {{around(), around(), around(), 0}, {unit(), unit(), unit()}}}};
    const point3<double> eye{around(), around(), around()}, p{around(), around(), around()};
    const vec3<double> normal = irg::normalized(vec3<double>{around(), around(), around()});
    const irg::rgb<double> ambient{unit(), unit(), unit()};
    const auto seen_colour = irg::phong_model(irg::material<double>{ka, kd, ks, n},
                                              irg::lighting<double>{ambient, colours}, eye, {p, normal});
    const auto channel = [&](double irg::rgb<double>::* c) {
      const lights one{
          {{colours[0].position, colours[0].intensity.*c}, {colours[1].position, colours[1].intensity.*c}}};
      return irg::phong_model(irg::material<double, double>{ka.*c, kd.*c, ks.*c, n},
                              irg::lighting<double, double>{ambient.*c, one}, eye, {p, normal});
    };
    REQUIRE(seen_colour.r == channel(&irg::rgb<double>::r));
    REQUIRE(seen_colour.g == channel(&irg::rgb<double>::g));
    REQUIRE(seen_colour.b == channel(&irg::rgb<double>::b));

    // The oracle: no reflected vector. L and V are split into parts across and along the surface.
    long double expected = static_cast<long double>(ambient.r) * static_cast<long double>(ka.r);
    for (const auto& source : colours) {
      using longs = std::array<long double, 3>;
      const longs m{static_cast<long double>(normal.x), static_cast<long double>(normal.y),
                    static_cast<long double>(normal.z)};
      const auto parts = [&](const vec3<double>& d) {  // of the unit vector: height over the surface, the part along it
        const longs c{static_cast<long double>(d.x), static_cast<long double>(d.y), static_cast<long double>(d.z)};
        const long double length = std::hypot(std::hypot(c[0], c[1]), c[2]);
        const long double h = (c[0] * m[0] + c[1] * m[1] + c[2] * m[2]) / length;
        return std::array<long double, 4>{h, c[0] / length - h * m[0], c[1] / length - h * m[1],
                                          c[2] / length - h * m[2]};
      };
      const auto& s = source.position;
      const auto l = parts(s.w == 1 ? vec3<double>{s.x - p.x, s.y - p.y, s.z - p.z} : vec3<double>{s.x, s.y, s.z});
      const auto v = parts(eye - p);
      if (l[0] <= 0) continue;
      // The mirror keeps the height and turns the rest round.
      const long double rv = l[0] * v[0] - (l[1] * v[1] + l[2] * v[2] + l[3] * v[3]);
      const long double highlight = rv > 0 ? std::pow(rv, static_cast<long double>(n)) : 0.0L;
      expected += static_cast<long double>(source.intensity.r) *
                  (static_cast<long double>(kd.r) * l[0] + static_cast<long double>(ks.r) * highlight);
    }
    REQUIRE(std::abs(static_cast<long double>(seen_colour.r) - expected) < 1e-13L);
  }
}

TEST_CASE("phong_model: degenerate scenes have no NaN") {
  constexpr std::span<const irg::light<double, double>> both(sun_and_lamp);
  constexpr static lights in_the_point{{{{0, 0, 0, 1}, 100.0}, {{0, 0, 0, 0}, 100.0}}};
  CHECK_BOTH(seen(shiny, {100.0, in_the_point}, {0, 0, 3}) == 20.0);
  CHECK_BOTH(seen(shiny, {100.0, both.first<1>()}, {0, 0, 0}) == 120.0);  // the eye in the point: no highlight
  CHECK_BOTH(seen(shiny, {100.0, both}, {0, 0, 3}, {0, 0, 0}) == 20.0);  // no normal
  CHECK_BOTH(seen(shiny, {100.0, both}, {0, 0, 3}, {0, 0, -1}) == 20.0);  // seen from behind
  CHECK_BOTH(seen(shiny, {100.0, both.first<1>()}, {0, 0, 1e300}) == 220.0);  // eye nearly at infinity
  CHECK_BOTH(seen(shiny, {100.0, both.first<1>()}, {0, 0, 1e-310}) == 220.0);  // and nearly in the point
}
