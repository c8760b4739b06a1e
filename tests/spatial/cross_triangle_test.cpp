// SPDX-License-Identifier: MIT
#include <irg/spatial/cross_triangle.hpp>

#include <array>
#include <cstdlib>
#include <limits>
#include <vector>

#include "support/big_rational.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using P = irg::point<double, 3>;
using R = irg::ray<double, 3>;
constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();

int trials(int few, int many) {
  if (std::getenv("IRG_RELEASE_TIER") != nullptr) return many;
  return std::getenv("IRG_FEWER_TRIALS") != nullptr ? few / 4 : few;
}

constexpr P times(const P& p, double s) { return {p.x * s, p.y * s, p.z * s}; }

TEST_CASE("intersect_triangle: inside, beside, sides and corners, edge on, from the surface") {
  constexpr P a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
  constexpr auto down = [](double x, double y) { return R{{x, y, 2}, {0, 0, -4}}; };
  constexpr auto x = irg::intersect_triangle(down(0.25, 0.5), a, b, c);
  CHECK_BOTH(x.value_or(irg::ray_crossing{}) == irg::ray_crossing{irg::facing::front, 0.5, 0.25, 0.5});
  CHECK_BOTH(irg::intersect_triangle(down(0.25, 0.5), a, c, b)->side == irg::facing::back);
  CHECK_BOTH(!irg::intersect_triangle(down(0.75, 0.5), a, b, c));
  CHECK_BOTH(!irg::intersect_triangle(R{{0.25, 0.5, -1}, {0, 0, -1}}, a, b, c));
  // A square of two triangles: its corners and sides belong to those whom the moved origin meets.
  constexpr P d{1, 1, 0};
  const auto count = [=](double px, double py) {
    return irg::intersect_triangle(down(px, py), a, b, d).has_value() +
           irg::intersect_triangle(down(px, py), a, d, c).has_value();
  };
  CHECK(count(0.5, 0.5) == 1);
  CHECK(count(0, 0) == 1);
  CHECK(count(1, 1) == 0);
  CHECK(count(0.5, 0) == 1);
  CHECK(count(0.5, 1) == 0);
  CHECK_BOTH(!irg::intersect_triangle(R{{-1, 0.25, 0}, {1, 0, 0}}, a, b, c));
  CHECK_BOTH(!irg::intersect_triangle(R{{-1, 0, 0}, {1, 0, 0}}, a, b, c));
  // From the surface: the origin is moved upwards.
  CHECK_BOTH(irg::intersect_triangle(R{{0.25, 0.25, 0}, {0, 0, -1}}, a, b, c).has_value());
  CHECK_BOTH(!irg::intersect_triangle(R{{0.25, 0.25, 0}, {0, 0, 1}}, a, b, c));
  // To the surface: the end is moved, too.
  CHECK_BOTH(!irg::intersect_triangle(R{{0.25, 0.25, 1}, {0, 0, -1}, 0, 1}, a, b, c));
  CHECK_BOTH(irg::intersect_triangle(R{{0.25, 0.25, -1}, {0, 0, 1}, 0, 1}, a, b, c).has_value());
  CHECK_BOTH(!irg::intersect_triangle(R{{0.25, 0.25, 1}, {0, 0, 0}}, a, b, c));
  CHECK_BOTH(!irg::intersect_triangle(R{{0.25, 0.25, 1}, {0, 0, -1}}, a, a, a));
  using F = irg::point<float, 3>;
  CHECK_BOTH(irg::intersect_triangle(irg::ray<float, 3>{{0.25f, 0.25f, 1e-44f}, {0, 0, -1e-44f}}, F{0, 0, 0},
                                     F{1, 0, 0}, F{0, 1, 0})
                 ->t == 1);
}

TEST_CASE("intersect_triangle: extremes") {
  for (const double s : {1.0, 1e-300, 1e300, 1e-160, 1e160, 0x1p-1060, 0x1p-1074}) {
    const auto x =
        irg::intersect_triangle(R{{s, 2 * s, 4 * s}, {0, 0, -s}}, P{0, 0, 0}, P{4 * s, 0, 0}, P{0, 8 * s, 0});
    REQUIRE(x.has_value());
    CHECK(x->t == 4);
    CHECK(x->weight_b == 0.25);
    CHECK(x->weight_c == 0.25);
  }
  CHECK(irg::intersect_triangle(R{{0, 0, most}, {0, 0, -least}}, P{-most, -most, -most}, P{most, -most, -most},
                                P{0, most, -most}));
  CHECK(!irg::intersect_triangle(R{{0, 0, most}, {0, 0, least}}, P{-most, -most, -most}, P{most, -most, -most},
                                 P{0, most, -most}));
}

#ifdef IRG_HAVE_MPFR

using Q = test::big_rational;

int sign(const Q& x) { return x < Q(0) ? -1 : Q(0) < x ? 1 : 0; }

// The same decision from the rationals, the origin moved by e, e^2 and e^3.
struct oracle {
  std::array<Q, 3> o, d;
  Q low, high;
  bool bounded;

  static std::array<Q, 3> of(const P& p) { return {Q(p.x), Q(p.y), Q(p.z)}; }

  oracle(const R& r, double scale, double e)
      : o(of(r.origin)), d{Q(r.direction.x), Q(r.direction.y), Q(r.direction.z)}, low(r.low),
        high(r.high > most ? Q(0) : Q(r.high)), bounded(r.high <= most) {
    const Q q(e);
    Q moved(scale);
    for (Q& coordinate : o) {
      moved = moved * q;
      coordinate = coordinate + moved;
    }
  }

  static std::array<Q, 3> cross(const std::array<Q, 3>& a, const std::array<Q, 3>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  static Q dot(const std::array<Q, 3>& a, const std::array<Q, 3>& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static std::array<Q, 3> minus(const std::array<Q, 3>& a, const std::array<Q, 3>& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }

  // The number of crossings, 1 or 0, and their time.
  int operator()(const P& pa, const P& pb, const P& pc, Q& t) const {
    const auto a = minus(of(pa), o), b = minus(of(pb), o), c = minus(of(pc), o);
    const int ab = sign(dot(d, cross(a, b))), bc = sign(dot(d, cross(b, c))), ca = sign(dot(d, cross(c, a)));
    if (ab != bc || bc != ca || ab == 0) return 0;
    const auto n = cross(minus(b, a), minus(c, a));
    t = dot(n, a) / dot(n, d);
    return !(t < low) && (!bounded || !(high < t)) ? ab : 0;
  }
};

TEST_CASE(
    "intersect_triangle: against rationals, on a lattice where most rays meet sides, corners and their own ends") {
  test::random random(19);
  int crossed = 0;
  for (int i = 0; i < trials(3000, 300000); ++i) {
    const int scale_of = static_cast<int>(random.integer(0, 4));
    const double s = scale_of == 0   ? 1
                     : scale_of == 1 ? 0x1p-1000
                     : scale_of == 2 ? 0x1p900
                     : scale_of == 3 ? 0x1p-120
                                     : 3;
    const auto coordinate = [&] { return static_cast<double>(random.integer(-3, 3)) * s; };
    const P a{coordinate(), coordinate(), coordinate()}, b{coordinate(), coordinate(), coordinate()},
        c{coordinate(), coordinate(), coordinate()};
    R r{{coordinate(), coordinate(), coordinate()}, {coordinate(), coordinate(), coordinate()}};
    if (i % 3 == 1) r.high = 1;
    if (i % 3 == 2) r.low = 0.5;
    if (i % 7 == 0) r.direction = (a - r.origin) + (b - r.origin);
    const auto x = irg::intersect_triangle(r, a, b, c);
    if (r.empty()) {
      CHECK(!x);
      continue;
    }
    Q t(0);
    const int expected = oracle(r, s, 0x1p-70)(a, b, c, t);
    REQUIRE(x.has_value() == (expected != 0));
    if (!x) continue;
    ++crossed;
    CHECK((x->side == irg::facing::back) == (expected > 0));
    CHECK(std::abs(x->t - static_cast<double>(t)) <= 0x1p-30 * 8);
  }
  CHECK(crossed > 20);
}

TEST_CASE("intersect_triangle: against rationals, with corners a few steps beside the ray and mixed magnitudes") {
  test::random random(20);
  int crossed = 0;
  for (int i = 0; i < trials(3000, 300000); ++i) {
    const auto size = [&] { return i % 2 == 0 ? 1.0 : irg::power_of_two(static_cast<int>(random.integer(-60, 60))); };
    const auto coordinate = [&] { return (random.unit() - 0.5) * size(); };
    const P o{coordinate(), coordinate(), coordinate()};
    const irg::vec<double, 3> d{coordinate(), coordinate(), coordinate()};
    const R r{o, d};
    const auto near = [&] {  // a point of the ray, its coordinates rounded and moved by some steps
      P p = irg::point_at(r, random.unit() * 4);
      for (int k = 0; k < 3; ++k) p[k] += p[k] * 0x1p-52 * static_cast<double>(random.integer(-2, 2));
      return p;
    };
    const P a = near(), b = i % 3 == 0 ? near() : P{coordinate(), coordinate(), coordinate()},
            c{coordinate(), coordinate(), coordinate()};
    const auto x = irg::intersect_triangle(r, a, b, c);
    Q t(0);
    const int expected = oracle(r, 1, 0x1p-800)(a, b, c, t);
    REQUIRE(x.has_value() == (expected != 0));
    crossed += x.has_value();
  }
  CHECK(crossed > 20);
}

#endif

TEST_CASE("intersect_triangle: through corners and sides of a closed surface, at every scale") {
  const std::array<P, 6> corner{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
  const std::array<std::array<std::size_t, 3>, 8> face{
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  test::random random(21);
  int wrong = 0;
  for (const double s : {1.0, 1e-30, 1e30, 1e-300, 1e300})
    for (int i = 0; i < trials(400, 20000); ++i) {
      const auto coordinate = [&] { return static_cast<double>(random.integer(-2, 2)) * 0.125 * s; };
      const P o{coordinate(), coordinate(), coordinate()};
      const auto any = [&] { return times(corner[static_cast<std::size_t>(random.integer(0, 5))], s * 0.5); };
      const P p = any(), q = any();
      const R r{o, {p.x + q.x - o.x, p.y + q.y - o.y, p.z + q.z - o.z}};
      int around = 0;
      for (const auto& f : face)
        if (const auto x =
                irg::intersect_triangle(r, times(corner[f[0]], s), times(corner[f[1]], s), times(corner[f[2]], s)))
          around += x->side == irg::facing::back ? 1 : -1;
      if (around != (r.empty() ? 0 : 1)) ++wrong;
    }
  CHECK(wrong == 0);
}

}  // namespace
