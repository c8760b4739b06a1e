// SPDX-License-Identifier: MIT
#include <irg/geometry/textbook/barycentric.hpp>

#include <optional>

#include "geometry/mixed_cases.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

namespace {

using test::rational;
using P3 = irg::point<double, 3>;
using Q3 = irg::point<rational, 3>;
using V3 = irg::vec<double, 3>;
using W3 = irg::vec<rational, 3>;
constexpr rational r(int n, int d = 1) { return {n, d}; }
constexpr std::nullopt_t none = std::nullopt;

// The course's values: what the inverse gives, and what each replaced row gives.
struct known {
  Q3 a, b, c, t;
  std::optional<W3> direct, replaced[3];
};
constexpr W3 half_quarters{r(1, 2), r(1, 4), r(1, 4)}, thirds{r(1, 3), r(1, 3), r(1, 3)};
constexpr known golden[] = {
    {{1, 0, 0},
     {0, 1, 0},
     {0, 0, 1},
     {r(1, 2), r(1, 4), r(1, 4)},
     half_quarters,
     {half_quarters, half_quarters, half_quarters}},
    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, W3{1, 1, 1}, {W3{-1, 1, 1}, W3{1, -1, 1}, W3{1, 1, -1}}},
    {{1, 2, 3},
     {4, 0, 1},
     {2, 5, -1},
     {2, 2, r(3, 2)},
     W3{r(32, 67), r(37, 134), r(14, 67)},
     {W3{r(13, 28), r(9, 28), r(3, 14)}, half_quarters, W3{r(6, 11), r(3, 11), r(2, 11)}}},
    {{1, 2, 3}, {4, 0, 1}, {0, 0, 0}, {r(5, 3), r(2, 3), r(4, 3)}, none, {thirds, thirds, thirds}},
    {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}, none, {none, none, half_quarters}},
    {{1, 0, 1}, {0, 1, 1}, {1, 1, 2}, {r(2, 3), r(2, 3), r(4, 3)}, none, {thirds, thirds, thirds}},
    {{0, 0, 1}, {1, 1, 1}, {2, 2, 1}, {1, 1, 1}, none, {none, none, none}},
};

constexpr bool all_golden() {
  for (const known& k : golden) {
    if (irg::textbook::barycentric_direct(k.a, k.b, k.c, k.t) != k.direct) return false;
    for (int axis = 0; axis < 3; ++axis)
      if (irg::textbook::barycentric_replaced(k.a, k.b, k.c, k.t, axis) != k.replaced[axis]) return false;
  }
  return true;
}

TEST_CASE("textbook::barycentric_direct, textbook::barycentric_replaced: the course's triangles") {
  CHECK_BOTH(all_golden());
}

TEST_CASE("textbook::barycentric_direct: doubles, singular exactly when the plane contains the origin") {
  constexpr P3 a{1, 2, 3}, b{4, 0, 1}, c{2, 5, -1};
  CHECK_BOTH(irg::textbook::barycentric_direct(a, b, c, P3{2, 2, 1.5}) ==
             std::optional(V3{32.0 / 67, 37.0 / 134, 14.0 / 67}));
  CHECK_BOTH(!irg::textbook::barycentric_direct(P3{1, 0, 1}, P3{0, 1, 1}, P3{1, 1, 2}, a));
  CHECK_BOTH(irg::textbook::barycentric_direct(P3{1, 0, 1}, P3{0, 1, 1}, P3{1, 1, 2.0000000000000004}, P3{0, 0, 1})
                 .has_value());
  CHECK_BOTH(irg::textbook::barycentric_direct(P3{0x1p-1074, 0, 0}, P3{0, 0x1p-1074, 0}, P3{0, 0, 0x1p1000},
                                               P3{0x1p-1074, 0, 0x1p1000}) == std::optional(V3{1, 0, 1}));
}

TEST_CASE("textbook::barycentric_direct: equal to the robust form for points of the plane, in rationals (oracle)") {
  test::random rng(3);
  for (int i = 0; i < 400; ++i) {
    const auto p = [&] { return Q3{rng.integer(-9, 9), rng.integer(-9, 9), rng.integer(-9, 9)}; };
    const Q3 a = p(), b = p(), c = p();
    const W3 w{r(static_cast<int>(rng.integer(-5, 5)), 7), r(static_cast<int>(rng.integer(-5, 5)), 7), 0};
    const rational w3 = rational(1) - w.x - w.y;
    const Q3 t{a.x * w.x + b.x * w.y + c.x * w3, a.y * w.x + b.y * w.y + c.y * w3, a.z * w.x + b.z * w.y + c.z * w3};
    const auto direct = irg::textbook::barycentric_direct(a, b, c, t), robust = irg::barycentric(a, b, c, t);
    const P3 da{double(a.x), double(a.y), double(a.z)}, db{double(b.x), double(b.y), double(b.z)},
        dc{double(c.x), double(c.y), double(c.z)};
    REQUIRE(irg::textbook::barycentric_direct(da, db, dc, da).has_value() == direct.has_value());
    if (!direct) continue;
    REQUIRE(direct == robust);
    REQUIRE(*direct == W3{w.x, w.y, w3});
  }
}

}  // namespace

#ifdef IRG_HAVE_MPFR

TEST_CASE_TEMPLATE("textbook::barycentric_direct: numbers of all sizes", T, double, float) {
  using namespace test::mixed;
  sweep(
      named<T>("barycentric_direct"), 0.5,
      [](test::random& r, sizes which) {
        const auto p = points<T, 3, 4>(r, which);
        const auto got = irg::textbook::barycentric_direct(p[0], p[1], p[2], p[3]);
        const auto a = exactly(p[0]), b = exactly(p[1]), c = exactly(p[2]), t = exactly(p[3]);
        const E whole = determinant(a, b, c),
                over[3] = {determinant(t, b, c), determinant(a, t, c), determinant(a, b, t)};
        bool is_beyond = whole.sign() == 0;
        for (const E& v : over) is_beyond = is_beyond || abs(whole) * test::quotients::largest<T>() < abs(v);
        if (!got) return is_beyond ? 0.0 : wrong;
        double worst = is_beyond ? wrong : 0;
        for (int k = 0; k < 3; ++k) worst = std::fmax(worst, quotient_error((*got)[k], over[k], whole));
        return worst;
      },
      2000);
}

#endif
