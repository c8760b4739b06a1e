// SPDX-License-Identifier: MIT
#include <irg/geometry/barycentric.hpp>

#include <irg/geometry/textbook/barycentric.hpp>

#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include "geometry/mixed_cases.hpp"
#include "support/archetypes.hpp"
#include "support/big_rational.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

namespace {

using irg::barycentric;
using irg::triangle_part;
using test::rational;
using P2 = irg::point<double, 2>;
using P3 = irg::point<double, 3>;
using Q3 = irg::point<rational, 3>;
using V3 = irg::vec<double, 3>;
using W3 = irg::vec<rational, 3>;

constexpr rational half{1, 2}, quarter{1, 4};

// A triangle of the course, a point, and its coordinates when seen along the widest axis.
struct known {
  Q3 a, b, c, t;
  W3 weights;
  bool in_plane;
  triangle_part where;
};
constexpr rational r(int n, int d = 1) { return {n, d}; }
constexpr known golden[] = {
    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {half, quarter, quarter}, {half, quarter, quarter}, true, triangle_part::inside},
    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, r(-1, 2), r(-1, 2)}, {2, r(-1, 2), r(-1, 2)}, true, triangle_part::outside},
    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {-1, 1, 1}, false, triangle_part::outside},
    {{1, 2, 3}, {4, 0, 1}, {2, 5, -1}, {2, r(9, 4), r(3, 2)}, {half, quarter, quarter}, true, triangle_part::inside},
    {{1, 2, 3}, {4, 0, 1}, {2, 5, -1}, {2, 2, r(3, 2)}, {r(13, 28), r(9, 28), r(3, 14)}, false, triangle_part::inside},
    {{1, 2, 3},
     {4, 0, 1},
     {0, 0, 0},
     {r(5, 3), r(2, 3), r(4, 3)},
     {r(1, 3), r(1, 3), r(1, 3)},
     true,
     triangle_part::inside},
    {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}, {half, quarter, quarter}, true, triangle_part::inside},
    {{1, 1, 0}, {5, 1, 0}, {1, 4, 0}, {2, 2, 0}, {r(5, 12), quarter, r(1, 3)}, true, triangle_part::inside},
    {{1, 0, 1},
     {0, 1, 1},
     {1, 1, 2},
     {r(2, 3), r(2, 3), r(4, 3)},
     {r(1, 3), r(1, 3), r(1, 3)},
     true,
     triangle_part::inside},
};

constexpr bool all_golden() {
  for (const known& k : golden)
    if (barycentric(k.a, k.b, k.c, k.t) != std::optional(k.weights) ||
        irg::locate_in_triangle(k.a, k.b, k.c, k.t) != std::optional(irg::triangle_location{k.in_plane, k.where}))
      return false;
  return !barycentric(Q3{0, 0, 1}, Q3{1, 1, 1}, Q3{2, 2, 1}, Q3{1, 1, 1});
}

constexpr double as_double(const rational& q) { return static_cast<double>(q); }
constexpr P3 as_double(const Q3& p) { return {as_double(p.x), as_double(p.y), as_double(p.z)}; }

TEST_CASE("barycentric: the course's triangles, in rationals and in doubles") {
  CHECK_BOTH(all_golden());
  for (const known& k : golden) {
    const auto t = barycentric(as_double(k.a), as_double(k.b), as_double(k.c), as_double(k.t));
    REQUIRE(t);
    for (int i = 0; i < 3; ++i) CHECK((*t)[i] == doctest::Approx(as_double(k.weights[i])).epsilon(1e-15));
  }
}

TEST_CASE("barycentric: corners, edges and points beside them") {
  constexpr P2 a{0, 0}, b{4, 0}, c{0, 2};
  CHECK_BOTH(barycentric(a, b, c, a) == std::optional(V3{1, 0, 0}));
  CHECK_BOTH(barycentric(a, b, c, P2{1, 0.5}) == std::optional(V3{0.5, 0.25, 0.25}));
  CHECK_BOTH(barycentric(a, b, c, P2{4, 2}) == std::optional(V3{-1, 1, 1}));
  CHECK_BOTH(barycentric(a, c, b, P2{1, 0.5}) == std::optional(V3{0.5, 0.25, 0.25}));
  CHECK_BOTH(irg::locate_in_triangle(a, b, c, P2{1, 0.5}) == triangle_part::inside);
  CHECK_BOTH(irg::locate_in_triangle(a, b, c, P2{2, 1}) == triangle_part::edge);
  CHECK_BOTH(irg::locate_in_triangle(c, b, a, P2{0, 2}) == triangle_part::vertex);
  CHECK_BOTH(irg::locate_in_triangle(a, b, c, P2{2, 1.0000000000000002}) == triangle_part::outside);
  CHECK_BOTH(irg::locate_in_triangle(a, a, c, a) == triangle_part::outside);
}

TEST_CASE("barycentric: triangles without area, and as thin as doubles go") {
  CHECK_BOTH(!barycentric(P2{1, 1}, P2{1, 1}, P2{5, 2}, P2{0, 0}));
  CHECK_BOTH(!barycentric(P2{0.5, 0.5}, P2{12, 12}, P2{24, 24}, P2{0, 0}));
  CHECK_BOTH(!barycentric(P3{1, 1, 1}, P3{2, 2, 2}, P3{-5, -5, -5}, P3{0, 0, 0}));
  CHECK_BOTH(!irg::locate_in_triangle(P3{1, 1, 1}, P3{1, 1, 1}, P3{0, 0, 5}, P3{0, 0, 0}));
  // One corner is an ulp off the line of the others: its weight is still right to the last place.
  constexpr P2 a{0.5, 0.5 + 0x1p-53}, b{12, 12}, c{24, 24};
  CHECK_BOTH(barycentric(a, b, c, a) == std::optional(V3{1, 0, 0}));
  CHECK_BOTH(barycentric(a, b, c, P2{0.5, 0.5}) == std::optional(V3{0, 47.0 / 24, -23.0 / 24}));
  CHECK_BOTH(barycentric(P2{0, 0}, P2{0x1p-1074, 0}, P2{0, 0x1p1000}, P2{0x1p-1074, 0x1p999}) ==
             std::optional(V3{-0.5, 1, 0.5}));
  constexpr double most = 0x1.fffffffffffffp1023;
  CHECK_BOTH(barycentric(P2{-most, -most}, P2{most, -most}, P2{0, most}, P2{0, 0}) ==
             std::optional(V3{0.25, 0.25, 0.5}));
}

TEST_CASE("dropped_axis: the largest component of the normal, the lowest axis on ties") {
  CHECK_BOTH(irg::dropped_axis(P3{0, 0, 0}, P3{1, 0, 0}, P3{0, 1, 0}) == std::optional(2));
  CHECK_BOTH(irg::dropped_axis(P3{0, 0, 0}, P3{0, 0, 1}, P3{1, 0, 0}) == std::optional(1));
  CHECK_BOTH(irg::dropped_axis(P3{1, 0, 0}, P3{0, 1, 0}, P3{0, 0, 1}) == std::optional(0));
  CHECK_BOTH(irg::dropped_axis(P3{1, 0, 0}, P3{0, 1, 0}, P3{0, 0, 1.0000000000000002}) == std::optional(0));
  CHECK_BOTH(irg::dropped_axis(P3{1.0000000000000002, 0, 0}, P3{0, 1, 0}, P3{0, 0, 1}) == std::optional(1));
  CHECK_BOTH(irg::dropped_axis(P3{-1, 0, 0}, P3{0, 1, 0}, P3{0, 0, 1}) == std::optional(0));
  CHECK_BOTH(irg::dropped_axis(P3{0x1p-1060, 0, 0}, P3{0, 0x1p-1060, 0}, P3{0, 0, 0x1.000001p-1060}) ==
             std::optional(0));
  // The areas along x and y are (2^52 + 1) (2^52 + 3) and one more: only the last of 105 bits differs.
  CHECK_BOTH(irg::dropped_axis(P3{0, 0, 0}, P3{0, 0x1p52 + 1, 0x1p52 + 2}, P3{0x1p52 + 2, 0, 0x1p52 + 3}) ==
             std::optional(1));
  CHECK_BOTH(irg::dropped_axis(P3{0x1p1000, 0, 0}, P3{0, 0x1p1000, 0}, P3{0, 0, 0x1p999}) == std::optional(2));
}

TEST_CASE("barycentric_orthogonal: the foot of the perpendicular") {
  CHECK_BOTH(irg::barycentric_orthogonal(Q3{1, 0, 0}, Q3{0, 1, 0}, Q3{0, 0, 1}, Q3{1, 1, 1}) ==
             std::optional(W3{r(1, 3), r(1, 3), r(1, 3)}));
  CHECK_BOTH(irg::barycentric_orthogonal(P3{0, 0, 0}, P3{4, 0, 0}, P3{0, 4, 0}, P3{1, 1, 77}) ==
             std::optional(V3{0.5, 0.25, 0.25}));
  CHECK_BOTH(!irg::barycentric_orthogonal(P3{0, 0, 0}, P3{1, 1, 1}, P3{2, 2, 2}, P3{1, 1, 77}));
  CHECK_BOTH(irg::barycentric_orthogonal(P3{0x1p600, 0, 0}, P3{0, 0x1p600, 0}, P3{0, 0, 0}, P3{0x1p599, 0, 0x1p700}) ==
             std::optional(V3{0.5, 0, 0.5}));
  CHECK_BOTH(irg::barycentric_orthogonal(P3{0x1p-1070, 0, 0}, P3{0, 0x1p-1070, 0}, P3{0, 0, 0}, P3{0x1p-1071, 0, 0}) ==
             std::optional(V3{0.5, 0, 0.5}));
  CHECK_BOTH(!irg::barycentric_orthogonal(P3{0x1p-1070, 0, 0}, P3{0, 0x1p-1070, 0}, P3{0, 0, 0}, P3{0x1p1000, 0, 0}));
}

TEST_CASE("interpolate: never outside of the corners' values") {
  CHECK_BOTH(irg::interpolate(V3{0.5, 0.25, 0.25}, 2, 4, 8) == 4);
  CHECK_BOTH(irg::interpolate(V3{-1, 1, 1}, 2, 4, 8) == 10);
  test::random rng(11);
  for (int i = 0; i < 3000; ++i) {
    const double u = rng.unit(), v = rng.unit() * (1 - u), x = rng.unit() * 3;
    const V3 t{u, v, 1 - u - v};
    REQUIRE(irg::interpolate(t, x, x, x) == x);
    const double y = irg::interpolate(t, x, 1, 1.0000000000000002);
    REQUIRE((y >= (x < 1 ? x : 1) && y <= (x > 1.0000000000000002 ? x : 1.0000000000000002)));
  }
}

double random_coordinate(test::random& rng, int kind) {
  const double x = rng.unit() * 2 - 1;
  switch (kind) {
    case 0: return x;
    case 1: return 0.5 + static_cast<double>(rng.integer(0, 255)) * 0x1p-53;           // a grid of ulps
    case 2: return std::ldexp(x, static_cast<int>(rng.integer(-1070, 1020)));         // any exponents
    case 3: return static_cast<double>(rng.integer(-8, 8));                           // a small lattice
    case 4: return static_cast<double>(rng.integer(-8, 8)) * 0x1p-1074;               // of subnormals
    default: return static_cast<double>(static_cast<float>(1000 + x * 0x1p-8));       // far from the origin
  }
}

TEST_CASE("barycentric_fast: as good as its formula") {
  test::random rng(12);
  for (int i = 0; i < 1000; ++i) {
    const auto p = [&] { return P2{random_coordinate(rng, 0), random_coordinate(rng, 0)}; };
    const P2 a = p(), b = p(), c = p(), t = p();
    const auto exact = barycentric(a, b, c, t);
    const V3 fast = irg::barycentric_fast(a, b, c, t);
    const double area = std::fabs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
    REQUIRE(exact);
    for (int k = 0; k < 3; ++k) REQUIRE(std::fabs(fast[k] - (*exact)[k]) <= 0x1p-53 * 64 / area * (1 + 8 / area));
  }
}

#ifdef IRG_HAVE_MPFR

using test::big_rational;

big_rational area(const P2& a, const P2& b, const P2& c) {
  const auto between = [](double from, double to) { return big_rational(to) - big_rational(from); };
  return between(a.x, b.x) * between(a.y, c.y) - between(a.y, b.y) * between(a.x, c.x);
}

// The error of x in units of its last place; subnormal and overflowing results are left out.
double ulps(double x, const big_rational& exact) {
  const double near = abs(exact).rounded();
  if (near < 0x1p-1000 || near > 0x1p950) return 0;
  int e = 0;
  std::frexp(near, &e);
  return test::distance(x, exact) / std::ldexp(1.0, e - 53);
}

TEST_CASE("barycentric: against rationals (oracle), from classroom grids to the ends of the exponents") {
  const int rounds = std::getenv("IRG_RELEASE_TIER") != nullptr ? 300'000 : 1500;
  double worst[6] = {}, worst_sum = 0;
  for (int kind = 0; kind < 6; ++kind) {
    test::random rng(static_cast<std::uint64_t>(20 + kind));
    for (int i = 0; i < rounds; ++i) {
      const auto p = [&] { return P2{random_coordinate(rng, kind), random_coordinate(rng, kind)}; };
      const P2 a = p(), b = kind == 1 ? P2{12, 12} : p(), c = kind == 1 ? P2{24, 24} : p();
      const P2 t = i % 3 == 0 ? P2{a.x / 2 + b.x / 2, a.y / 2 + b.y / 2} : p();
      const big_rational whole = area(a, b, c);
      const auto got = barycentric(a, b, c, t);
      REQUIRE(got.has_value() == (whole.sign() != 0));
      if (!got) continue;
      const big_rational exact[] = {area(t, b, c) / whole, area(a, t, c) / whole, area(a, b, t) / whole};
      bool inside = true;
      for (int k = 0; k < 3; ++k) {
        inside = inside && exact[k].sign() >= 0;
        worst[kind] = std::fmax(worst[kind], ulps((*got)[k], exact[k]));
        if (exact[k].sign() == 0) REQUIRE((*got)[k] == 0);
        if (abs(exact[k]).rounded() > 0x1p-1000) REQUIRE(((*got)[k] > 0) == (exact[k].sign() > 0));
      }
      if (!inside) continue;
      REQUIRE(((*got)[0] <= 1 && (*got)[1] <= 1 && (*got)[2] <= 1));
      const big_rational sum = big_rational((*got)[0]) + big_rational((*got)[1]) + big_rational((*got)[2]);
      worst_sum = std::fmax(worst_sum, test::distance(1, sum));
    }
    MESSAGE("barycentric, kind ", kind, ": ", worst[kind], " ulp on ", rounds, " triangles");
    CHECK(worst[kind] <= 0.51);
  }
  CHECK(worst_sum <= 0x1p-52);
}

TEST_CASE("barycentric in space: against the rationals of the view that rationals choose (oracle)") {
  for (int kind = 0; kind < 6; ++kind) {
    test::random rng(static_cast<std::uint64_t>(40 + kind));
    for (int i = 0; i < 300; ++i) {
      const auto p = [&] {
        return P3{random_coordinate(rng, kind), random_coordinate(rng, kind), random_coordinate(rng, kind)};
      };
      const P3 a = p(), b = p(), c = p(), t = i % 2 == 0 ? p() : a;
      const P2 seen[3][4] = {{{a.y, a.z}, {b.y, b.z}, {c.y, c.z}, {t.y, t.z}},
                             {{a.z, a.x}, {b.z, b.x}, {c.z, c.x}, {t.z, t.x}},
                             {{a.x, a.y}, {b.x, b.y}, {c.x, c.y}, {t.x, t.y}}};
      int best = 0;
      for (int k = 1; k < 3; ++k)
        if (abs(area(seen[best][0], seen[best][1], seen[best][2])) < abs(area(seen[k][0], seen[k][1], seen[k][2])))
          best = k;
      const P2* s = seen[best];
      REQUIRE(irg::dropped_axis(a, b, c) == (area(s[0], s[1], s[2]).sign() == 0 ? std::nullopt : std::optional(best)));
      REQUIRE(barycentric(a, b, c, t) == barycentric(s[0], s[1], s[2], s[3]));
    }
  }
}

TEST_CASE("barycentric: attributes of float triangles, slivers of one ulp among them, within 4e-7 (oracle)") {
  using F2 = irg::point<float, 2>;
  test::random rng(60);
  const int rounds = std::getenv("IRG_RELEASE_TIER") != nullptr ? 1'000'000 : 6000;
  double worst = 0, worst_sum = 0;
  int tested = 0, thin = 0;
  for (int i = 0; i < rounds; ++i) {
    const auto p = [&] { return F2{static_cast<float>(rng.unit()), static_cast<float>(rng.unit())}; };
    const auto between = [&](const F2& q, const F2& s) {
      const float w = static_cast<float>(rng.unit());
      return F2{q.x + (s.x - q.x) * w, q.y + (s.y - q.y) * w};
    };
    F2 a = p(), b = p(), c = i % 2 == 0 ? p() : between(a, b);  // every other one has no area but for roundings
    if (i % 4 == 3) a.x += 1000, b.x += 1000, c.x += 1000;
    const F2 t = i % 3 == 0 ? between(a, b) : between(between(a, b), c);
    if (irg::locate_in_triangle(a, b, c, t) == triangle_part::outside) continue;
    const auto weights = barycentric(a, b, c, t);
    REQUIRE(weights.has_value());
    const auto wide = [](const F2& q) { return P2{static_cast<double>(q.x), static_cast<double>(q.y)}; };
    const big_rational whole = area(wide(a), wide(b), wide(c));
    const float x[] = {static_cast<float>(rng.unit()), static_cast<float>(rng.unit()), static_cast<float>(rng.unit())};
    const big_rational exact = (area(wide(t), wide(b), wide(c)) * big_rational(static_cast<double>(x[0])) +
                                area(wide(a), wide(t), wide(c)) * big_rational(static_cast<double>(x[1])) +
                                area(wide(a), wide(b), wide(t)) * big_rational(static_cast<double>(x[2]))) /
                               whole;
    const float got = irg::interpolate(*weights, x[0], x[1], x[2]);
    worst = std::fmax(worst, test::distance(static_cast<double>(got), exact));
    REQUIRE((got >= std::fmin(x[0], std::fmin(x[1], x[2])) && got <= std::fmax(x[0], std::fmax(x[1], x[2]))));
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
      REQUIRE(((*weights)[k] >= 0 && (*weights)[k] <= 1));
      sum += static_cast<double>((*weights)[k]);
    }
    worst_sum = std::fmax(worst_sum, std::fabs(sum - 1));
    ++tested;
    thin += abs(whole).rounded() < 1e-7 ? 1 : 0;
  }
  MESSAGE("interpolated attributes: error ", worst, " on ", tested, " triangles, ", thin, " of them slivers");
  CHECK(worst <= 4e-7);
  CHECK(worst_sum <= 2 * 0x1p-24);
  CHECK(thin > 30);
}

#endif

TEST_CASE("barycentric: float, rounded once") {
  using F2 = irg::point<float, 2>;
  test::random rng(13);
  for (int i = 0; i < 2000; ++i) {
    const auto p = [&] {
      return F2{static_cast<float>(rng.integer(0, 1 << 24)), static_cast<float>(rng.integer(0, 1 << 24))};
    };
    const auto wide = [](const F2& q) { return P2{static_cast<double>(q.x), static_cast<double>(q.y)}; };
    const F2 a = p(), b = p(), c = p(), t = p();
    const auto narrow = barycentric(a, b, c, t);
    const auto exact = barycentric(wide(a), wide(b), wide(c), wide(t));
    REQUIRE(narrow.has_value() == exact.has_value());
    for (int k = 0; narrow && k < 3; ++k) REQUIRE((*narrow)[k] == static_cast<float>((*exact)[k]));
  }
}

TEST_CASE("barycentric: a weight near the smallest normal number is rounded once") {
  constexpr auto t = barycentric(P2{0, 0}, P2{1, 0}, P2{0, 0x1.76076f46a54cap+501}, P2{0.5, 0x1.d4c31b03b5b33p-521});
  CHECK_BOTH(t.has_value());
  CHECK_BOTH(t->z == 0x1.40d6c905d9504p-1022);
}

TEST_CASE("barycentric: the worst input of the accuracy study, a triangle 2^-45 wide") {
  constexpr auto t =
      barycentric(P2{-0x1.b3622be84627cp-2, -0x1.40850485d37ap-4}, P2{0x1.b9ac5b5a7abcp-3, -0x1.05dcc1e355508p-3},
                  P2{-0x1.8d974d06685fcp-2, -0x1.4c38eff2facd6p-4}, P2{0x1.346bb5d4fa499p-3, -0x1.f717dae80c2d7p-4});
  CHECK_BOTH(t.has_value());
  CHECK_BOTH(*t == irg::vec<double, 3>{0x1.5e8b53c00cc5ep-4, 0x1.cb8478223e476p-1, 0x1.1543acb803fd3p-6});
}

TEST_CASE("barycentric: numbers that can do no more than Scalar asks for") {
  using S = archetype::scalar;
  constexpr irg::point<S, 3> a{S(0), S(0), S(0)}, b{S(1), S(0), S(0)}, c{S(0), S(1), S(0)}, t{S(1), S(0), S(7)};
  CHECK_BOTH(barycentric_orthogonal(a, b, c, t) == irg::vec<S, 3>{S(0), S(1), S(0)});
  CHECK_BOTH(barycentric(a, b, c, t) == irg::vec<S, 3>{S(0), S(1), S(0)});
  CHECK_BOTH(!barycentric_orthogonal(a, b, b, t));
}

}  // namespace

#ifdef IRG_HAVE_MPFR

TEST_CASE_TEMPLATE("barycentric: numbers of all sizes", T, double, float) {
  using namespace test::mixed;
  using corner = point<T, 2>;
  // The share of the bound: 2 ulp for subnormal numbers and large ones.
  const auto share = [](T got, const E& area, const E& whole) {
    const double error = quotient_error(got, area, whole), size = std::fabs(static_cast<double>(got));
    const bool is_far = size < static_cast<double>(std::numeric_limits<T>::min()) || size > 0x1p960;
    const bool has_sign = !(abs(area) < abs(whole) * of(std::numeric_limits<T>::denorm_min()));
    if (has_sign && sign_of(got) != area.sign() * whole.sign()) return wrong;
    return error / (is_far ? 2 : sizeof(T) == 4 ? 0.501 : 0.51);
  };
  const auto compare = [&](const std::optional<vec<T, 3>>& got, const corner& a, const corner& b, const corner& c,
                           const corner& t) {
    const E whole = twice_area(a, b, c);
    if (got.has_value() != (whole.sign() != 0)) return wrong;
    if (!got) return 0.0;
    const double first = share(got->x, twice_area(t, b, c), whole), second = share(got->y, twice_area(a, t, c), whole);
    return std::fmax(first, std::fmax(second, share(got->z, twice_area(a, b, t), whole)));
  };
  sweep(
      named<T>("barycentric, of its bound"), 1,
      [&](test::random& r, sizes which) {
        const auto p = points<T, 2, 4>(r, which);
        return compare(barycentric(p[0], p[1], p[2], p[3]), p[0], p[1], p[2], p[3]);
      },
      2000);
  sweep(
      named<T>("barycentric in space, of its bound"), 1,
      [&](test::random& r, sizes which) {
        const auto p = points<T, 3, 4>(r, which);
        corner seen[3][4];
        E size[3];
        int best = 0;
        for (int k = 0; k < 3; ++k) {
          for (std::size_t i = 0; i < 4; ++i) seen[k][i] = {p[i][(k + 1) % 3], p[i][(k + 2) % 3]};
          size[k] = abs(twice_area(seen[k][0], seen[k][1], seen[k][2]));
          if (size[best] < size[k]) best = k;
        }
        if (dropped_axis(p[0], p[1], p[2]) != (size[best].sign() == 0 ? std::nullopt : std::optional(best)))
          return wrong;
        const corner* s = seen[best];
        if (irg::textbook::barycentric_replaced(p[0], p[1], p[2], p[3], best) != barycentric(p[0], p[1], p[2], p[3]))
          return wrong;
        return compare(barycentric(p[0], p[1], p[2], p[3]), s[0], s[1], s[2], s[3]);
      },
      2000);
}

#endif
