// SPDX-License-Identifier: MIT
#include <irg/geometry/textbook/triangle_area.hpp>
#include <irg/geometry/triangle_area.hpp>

#include <array>

#include <irg/math/vec.hpp>

#include "geometry/mixed_cases.hpp"
#include "support/check_both.hpp"
#include "support/ulp.hpp"

using namespace irg;

namespace {

using p2 = point<double, 2>;
using p3 = point<double, 3>;
using f2 = point<float, 2>;
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = 0x1p-1074;

}  // namespace

static_assert(noexcept(triangle_area(p3{}, p3{}, p3{})));
static_assert(std::is_same_v<decltype(signed_triangle_area(f2{}, f2{}, f2{})), float>);

TEST_CASE("triangle_area: by hand") {
  CHECK_BOTH(signed_triangle_area(p2{0, 0}, p2{4, 0}, p2{0, 3}) == 6);
  CHECK_BOTH(signed_triangle_area(p2{0, 0}, p2{0, 3}, p2{4, 0}) == -6);
  CHECK_BOTH(triangle_area(p2{0, 0}, p2{0, 3}, p2{4, 0}) == 6);
  CHECK_BOTH(triangle_area(p3{1, 1, 1}, p3{1, 5, 1}, p3{1, 1, 4}) == 6);
  CHECK_BOTH(triangle_area(p3{0, 0, 0}, p3{2, 3, 6}, p3{3, -6, 2}) == 24.5);
  CHECK_BOTH(signed_triangle_area(std::array<double, 2>{0, 0}, std::array<double, 2>{1, 0},
                                  std::array<double, 2>{0, 1}) == 0.5);
  CHECK_BOTH(signed_triangle_area_fast(f2{0, 0}, f2{4, 0}, f2{0, 3}) == 6);
  CHECK_BOTH(signed_triangle_area_fast(point<int, 2>{0, 0}, point<int, 2>{4, 0}, point<int, 2>{0, 3}) == 6);
  CHECK_BOTH(triangle_area_from_sides(3.0, 4.0, 5.0) == 6.0);
  CHECK_BOTH(triangle_area_from_sides(5.0f, 3.0f, 4.0f) == 6.0f);
}

TEST_CASE("triangle_area: thin and far away") {
  // One unit in the last place off the line through (12, 12) and (24, 24).
  CHECK_BOTH(signed_triangle_area(p2{0.5, 0.5 + 0x1p-53}, p2{12, 12}, p2{24, 24}) == 6 * 0x1p-53);
  CHECK_BOTH(signed_triangle_area(p2{0.5, 0.5}, p2{12, 12}, p2{24, 24}) == 0);
  CHECK_BOTH(signed_triangle_area(p2{0x1p60, 0x1p60}, p2{1, 0}, p2{0, 1}) == -0x1p60);
  CHECK_BOTH(signed_triangle_area(p2{0x1p60, 0x1p60}, p2{1, 1}, p2{0, 0}) == 0);
  CHECK_BOTH(signed_triangle_area(p2{largest, largest}, p2{1, 0}, p2{0, 1}) == -largest);
  CHECK_BOTH(signed_triangle_area(p2{-largest, 0}, p2{largest, 0}, p2{0, largest}) == inf);
  CHECK_BOTH(signed_triangle_area(p2{0, 0}, p2{largest, 0}, p2{largest, 1}) == largest / 2);
  CHECK_BOTH(signed_triangle_area(p2{0, 0}, p2{smallest, 0}, p2{0, 2}) == smallest);
  CHECK_BOTH(triangle_area(p3{1e200, 1e200, 1e200}, p3{1e200, 1e200, 1e200}, p3{0, 0, 5}) == 0);
  CHECK_BOTH(triangle_area(p3{1, 1, 1}, p3{2, 2, 2}, p3{3, 3, 3 + 0x1p-51}) == 0x1.6a09e667f3bcdp-52);
}

TEST_CASE("triangle_area: sides that make no triangle, and flat ones") {
  CHECK_BOTH(!triangle_area_from_sides(1.0, 2.0, 4.0));
  CHECK_BOTH(!triangle_area_from_sides(1.0, -1.0, 1.0));
  CHECK_BOTH(!triangle_area_from_sides(inf, inf, 1.0));
  CHECK_BOTH(!triangle_area_from_sides(std::numeric_limits<double>::quiet_NaN(), 1.0, 1.0));
  CHECK_BOTH(!triangle_area_from_sides(1.0, 1.0, std::numeric_limits<double>::quiet_NaN()));
  CHECK_BOTH(triangle_area_from_sides(1.0, 2.0, 3.0) == 0.0);
  CHECK_BOTH(triangle_area_from_sides(0.0, 0.0, 0.0) == 0.0);
  CHECK_BOTH(triangle_area_from_sides(2.0, 2.0, 0.0) == 0.0);
  CHECK_BOTH(triangle_area_from_sides(largest, largest, largest) == inf);
  CHECK_BOTH(triangle_area_from_sides(0x1p1000, 0x1p1000, 0x1p-500) == 0x1p499);
  CHECK_BOTH(triangle_area_from_sides(3 * 0x1p-530, 4 * 0x1p-530, 5 * 0x1p-530) == 6 * 0x1p-1060);
  CHECK_BOTH(triangle_area_from_sides(3 * smallest, 4 * smallest, 5 * smallest) == 0.0);
}

#ifdef IRG_HAVE_MPFR
namespace {

struct number {
  mpfr_t v;
  number() { mpfr_init2(v, 9000); }
  number(const number&) = delete;
  number& operator=(const number&) = delete;
  ~number() { mpfr_clear(v); }
};

/// Twice the area of the projection on coordinates x and y.
template <class P>
void doubled(mpfr_ptr out, const P& a, const P& b, const P& c, int x, int y) {
  static number p, q;
  const auto from_a = [&](mpfr_ptr to, const P& from, int i) {
    mpfr_set_d(to, static_cast<double>(from[i]), MPFR_RNDN);
    mpfr_sub_d(to, to, static_cast<double>(a[i]), MPFR_RNDN);
  };
  from_a(out, b, x), from_a(p.v, c, y), mpfr_mul(out, out, p.v, MPFR_RNDN);
  from_a(p.v, b, y), from_a(q.v, c, x), mpfr_mul(p.v, p.v, q.v, MPFR_RNDN);
  mpfr_sub(out, out, p.v, MPFR_RNDN);
}

/// Heron's formula in 9000 bits.
void heron(mpfr_ptr out, double a, double b, double c) {
  static number s, t;
  mpfr_set_d(s.v, a, MPFR_RNDN), mpfr_add_d(s.v, s.v, b, MPFR_RNDN), mpfr_add_d(s.v, s.v, c, MPFR_RNDN);
  mpfr_div_ui(s.v, s.v, 2, MPFR_RNDN);
  mpfr_set(out, s.v, MPFR_RNDN);
  for (const double side : {a, b, c}) mpfr_sub_d(t.v, s.v, side, MPFR_RNDN), mpfr_mul(out, out, t.v, MPFR_RNDN);
  mpfr_sqrt(out, out, MPFR_RNDN);
}

}  // namespace

TEST_CASE("triangle_area: errors and signs against MPFR") {
  test::random r(1);
  double worst[3]{}, worst_space = 0, worst_float = 0;
  number exact, x, y;
  for (int i = 0, n = test::count_of(10000); i < n; ++i) {
    const auto unit = [&] { return test::between(r, -1, 1); };
    const double offset = test::of_exponent(r, 0, 50), shrink = std::ldexp(1.0, -static_cast<int>(r.integer(0, 60)));
    const double t = test::of_exponent(r, -20, 20);
    const p2 a{unit() + offset, unit() + offset}, b{unit() + offset, unit() + offset};
    const p2 anywhere{unit() + offset, unit() + offset};
    const p2 near{a.x + t * (b.x - a.x) + shrink * unit(), a.y + t * (b.y - a.y)};
    const p2 any[3] = {{test::any_double(r), test::any_double(r)},
                       {test::any_double(r), test::any_double(r)},
                       {test::any_double(r), test::any_double(r)}};
    const p2* cases[3][3] = {{&a, &b, &anywhere}, {&a, &b, &near}, {&any[0], &any[1], &any[2]}};
    for (int k = 0; k < 3; ++k) {
      const p2 &u = *cases[k][0], &v = *cases[k][1], &w = *cases[k][2];
      doubled(exact.v, u, v, w, 0, 1);
      mpfr_div_ui(exact.v, exact.v, 2, MPFR_RNDN);
      const double got = signed_triangle_area(u, v, w);
      worst[k] = std::max(worst[k], test::ulp_error(got, exact.v));
      const int sign = (got > 0) - (got < 0);
      CHECK((sign == (mpfr_sgn(exact.v) > 0) - (mpfr_sgn(exact.v) < 0) ||
             (sign == 0 && mpfr_get_d(exact.v, MPFR_RNDN) == 0)));
    }
    const auto single = [](const p2& p) { return f2{static_cast<float>(p.x), static_cast<float>(p.y)}; };
    doubled(exact.v, single(a), single(b), single(near), 0, 1);
    mpfr_div_ui(exact.v, exact.v, 2, MPFR_RNDN);
    worst_float =
        std::max(worst_float, test::ulp_error(signed_triangle_area(single(a), single(b), single(near)), exact.v));
    const p3 p{unit() + offset, unit(), unit() - offset}, q{unit() + offset, unit(), unit() - offset};
    const p3 s{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y) + shrink * unit(), p.z + t * (q.z - p.z)};
    doubled(exact.v, p, q, s, 0, 1), mpfr_sqr(exact.v, exact.v, MPFR_RNDN);
    doubled(x.v, p, q, s, 1, 2), mpfr_sqr(x.v, x.v, MPFR_RNDN), mpfr_add(exact.v, exact.v, x.v, MPFR_RNDN);
    doubled(x.v, p, q, s, 2, 0), mpfr_sqr(x.v, x.v, MPFR_RNDN), mpfr_add(exact.v, exact.v, x.v, MPFR_RNDN);
    mpfr_sqrt(exact.v, exact.v, MPFR_RNDN), mpfr_div_ui(exact.v, exact.v, 2, MPFR_RNDN);
    worst_space = std::max(worst_space, test::ulp_error(triangle_area(p, q, s), exact.v));
  }
  CHECK(worst[0] <= 1.1);
  CHECK(worst[1] <= 1.1);
  CHECK(worst[2] <= 1.1);
  CHECK(worst_space <= 2);
  CHECK(worst_float <= 0.51);
  MESSAGE("signed_triangle_area ", worst[0], " ulp, thin ", worst[1], ", any doubles ", worst[2], ", float ",
          worst_float, "; triangle_area in space ", worst_space);
}

TEST_CASE("triangle_area: Kahan's table of needles") {
  // Sides, the area he gives to ten digits, and how far off Heron's formula is in doubles.
  struct line {
    double a, b, c, area;
  };
  constexpr line table[] = {{10, 10, 10, 43.30127019},
                            {-3, 5, 2, -1},
                            {100000, 99999.99979, 0.00029, 9.999999990},
                            {100000, 100000, 1.00005, 50002.50003},
                            {99999.99996, 99999.99994, 0.00003, 1.118033988},
                            {99999.99996, 0.00003, 99999.99994, 1.118033988},
                            {10000, 5000.000001, 15000, 612.3724358},
                            {99999.99999, 99999.99999, 200000, -1},
                            {5278.64055, 94721.35941, 99999.99996, -1},
                            {100002, 100002, 200004, 0},
                            {31622.77662, 0.000023, 31622.77661, 0.3274904470},
                            {31622.77662, 0.0155555, 31622.77661, 245.9540000}};
  number exact;
  for (const auto& [a, b, c, area] : table) {
    const std::optional<double> got = triangle_area_from_sides(a, b, c);
    CAPTURE(a);
    CAPTURE(b);
    CAPTURE(c);
    if (!got) {
      // Negative sides, or sides that as doubles miss each other by a little.
      CHECK(area <= 0);
      continue;
    }
    heron(exact.v, a, b, c);
    CHECK(test::ulp_error(*got, exact.v) <= 6);
    // The doubles are not his decimals: that alone moves the area of a needle in the sixth digit.
    if (area > 0) CHECK(*got == doctest::Approx(area).epsilon(1e-4));
  }
}

TEST_CASE("triangle_area: from sides against MPFR") {
  test::random r(2);
  double worst = 0, worst_textbook = 0;
  number exact;
  for (int i = 0, n = test::count_of(10000); i < n; ++i) {
    const double a = test::of_exponent(r, -3, 3), z = std::ldexp(a, -static_cast<int>(r.integer(0, 50)));
    const double b = a + test::between(r, -1, 1) * z, c = z * test::between(r, 1, 2);
    const std::optional<double> got = triangle_area_from_sides(a, b, c);
    const auto [sum, rest] = two_sum(std::min(a, b), std::min(std::max(a, b), c));
    const bool is_triangle = (sum - std::max(a, std::max(b, c))) + rest >= 0;
    CHECK(got.has_value() == is_triangle);
    if (!got) continue;
    heron(exact.v, a, b, c);
    worst = std::max(worst, test::ulp_error(*got, exact.v));
    const std::optional<double> plain = irg::textbook::triangle_area_from_sides(a, b, c);
    if (plain) worst_textbook = std::max(worst_textbook, test::ulp_error(*plain, exact.v));
  }
  CHECK(worst <= 6);
  MESSAGE("triangle_area_from_sides ", worst, " ulp, Heron's formula ", worst_textbook);
}
#else
TEST_CASE("error bounds") { MESSAGE("skipped: MPFR was not found"); }
#endif

// The worst inputs that bench/accuracy found; the exact areas are those of MPFR, rounded to nearest.
TEST_CASE("worst inputs of the accuracy study") {
  using P = irg::point<double, 2>;
  constexpr double area = irg::signed_triangle_area(P{0x1.fef3fc11746c8p+4, 0x1.4ef3a1bf9d4a6p+5},
                                                    P{0x1.47dbfb306c8fp+3, -0x1.112d389f1f546p+5},
                                                    P{0x1.7d2dca442a87bp+3, -0x1.c4ea5717bfdcap+4});
  constexpr double exact_area = 0x1.3ffc2ffb06bf7p-37;
  CHECK_BOTH(area >= exact_area * (1 - 0x1p-52));
  CHECK_BOTH(area <= exact_area * (1 + 0x1p-52));
  constexpr auto needle =
      irg::triangle_area_from_sides(0x1.77d2719c70b9cp+0, 0x1.77d271a268d83p+0, 0x1.6708ccf385931p-29);
  constexpr double exact_needle = 0x1.be4bc2af16e09p-30;
  CHECK_BOTH(needle.has_value());
  CHECK_BOTH(*needle >= exact_needle * (1 - 0x1p-51));
  CHECK_BOTH(*needle <= exact_needle * (1 + 0x1p-51));
}

#ifdef IRG_HAVE_MPFR

TEST_CASE_TEMPLATE("triangle_area: numbers of all sizes", T, double, float) {
  using namespace test::mixed;
  using test::mixed::number;
  // 1.1 ulp, and 1.6 where subnormal, as a share of the bound.
  const auto share = [](T got, const E& twice) {
    const bool is_subnormal = std::fabs(got) < std::numeric_limits<T>::min();
    return off_from_area(got, twice) / (is_subnormal ? 1.6 : 1.1);
  };
  sweep(
      named<T>("signed_triangle_area, of its bound"), 1,
      [&](test::random& r, sizes which) {
        const auto p = points<T, 2, 3>(r, which);
        return share(signed_triangle_area(p[0], p[1], p[2]), twice_area(p[0], p[1], p[2]));
      },
      3000);
  sweep(
      named<T>("triangle_area in the plane, of its bound"), 1,
      [&](test::random& r, sizes which) {
        const auto p = points<T, 2, 3>(r, which);
        return share(triangle_area(p[0], p[1], p[2]), abs(twice_area(p[0], p[1], p[2])));
      },
      3000);
  sweep(
      named<T>("triangle_area in space"), 2,
      [&](test::random& r, sizes which) {
        const auto p = points<T, 3, 3>(r, which);
        const auto a = exactly(p[0]), b = exactly(p[1]), c = exactly(p[2]);
        return root_error(triangle_area(p[0], p[1], p[2]), gram(b - a, c - a), E(4));
      },
      3000);
  sweep(
      named<T>("triangle_area_from_sides"), 6,
      [&](test::random& r, sizes which) {
        T a = std::fabs(number<T>(r, which)), b = r.integer(0, 2) == 0 ? a : std::fabs(number<T>(r, which));
        T c = r.integer(0, 1) == 0 ? a + b : std::fabs(number<T>(r, which));
        if (r.integer(0, 1) == 0) c = std::nextafter(c, T(0));
        if (r.integer(0, 1) == 0) std::swap(a, c);
        if (!std::isfinite(a) || !std::isfinite(c)) return 0.0;
        const auto got = irg::triangle_area_from_sides(a, b, c);
        const E x = of(a), y = of(b), z = of(c);
        const bool exists = !(x + y < z || y + z < x || z + x < y);
        if (exists != got.has_value()) return wrong;
        if (!got) return 0.0;
        return root_error(*got, (x + y + z) * (x + y - z) * (x - y + z) * (y + z - x), E(16));
      },
      3000);
}

#endif
