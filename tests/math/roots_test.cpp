// SPDX-License-Identifier: MIT
#include <irg/math/roots.hpp>

#include "math/mixed_cases.hpp"
#include "support/check_both.hpp"
#include "support/ulp.hpp"

using namespace irg;

namespace {

using two_roots = real_roots<double, 2>;
using three_roots = real_roots<double, 3>;
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = 0x1p-1074;

constexpr two_roots none{};
constexpr two_roots one(double x) { return {roots_kind::one, 1, {x}, {2}}; }
constexpr two_roots two(double x, double y) { return {roots_kind::two, 2, {x, y}, {1, 1}}; }
constexpr two_roots only(roots_kind kind) { return {kind, 0, {}, {}}; }
constexpr two_roots linear(double x) { return {roots_kind::linear, 1, {x}, {1}}; }
constexpr three_roots one_of_three(double x, int multiplicity = 1) { return {roots_kind::one, 1, {x}, {multiplicity}}; }
constexpr three_roots double_and(double x, int m, double y, int n) { return {roots_kind::two, 2, {x, y}, {m, n}}; }
constexpr three_roots three(double x, double y, double z) { return {roots_kind::three, 3, {x, y, z}, {1, 1, 1}}; }

}  // namespace

static_assert(noexcept(quadratic_roots(1.0, 2.0, 3.0)) && noexcept(cubic_roots(1.0f, 2.0f, 3.0f, 4.0f)));

// Coefficients of different types, and integers; the roots as a range.
static_assert(irg::quadratic_roots(1.0, -3, 2).size() == 2 && irg::quadratic_roots(1, -3, 2.0f).root[1] == 2);
static_assert([] {
  double sum = 0;
  for (const double root : irg::cubic_roots(1, -6, 11.0, -6)) sum += root;
  return sum;
}() == 6);

TEST_CASE("roots: quadratic by hand") {
  CHECK_BOTH(quadratic_roots(1.0, -3.0, 2.0) == two(1, 2));
  CHECK_BOTH(quadratic_roots(-2.0, 6.0, -4.0) == two(1, 2));
  CHECK_BOTH(quadratic_roots(1.0, 2.0, 1.0) == one(-1));
  CHECK_BOTH(quadratic_roots(1.0, 0.0, 1.0) == none);
  CHECK_BOTH(quadratic_roots(1.0, 0.0, -4.0) == two(-2, 2));
  CHECK_BOTH(quadratic_roots(2.0f, -6.0f, 4.0f).root[1] == 2.0f);
  CHECK_BOTH(quadratic_roots_fast(1.0, -3.0, 2.0) == two(1, 2));
  CHECK_BOTH(quadratic_roots_fast(1.0, 2.0, 1.0) == one(-1));
  CHECK_BOTH(quadratic_roots_fast(1.0, 0.0, 0.0) == one(0));
  // Floats whose discriminant is beyond their range, at both ends.
  CHECK_BOTH(quadratic_roots_fast(0x1p127f, 0.0f, -0x1p127f).root[1] == 1);
  CHECK_BOTH(quadratic_roots_fast(0x1p-80f, 0.0f, -0x1p-80f).count == 2);
}

TEST_CASE("roots: where the textbook's formula is wrong") {
  CHECK_BOTH(quadratic_roots_fast(1.0, -1e9, 1.0).root[0] == 1e-9);
  CHECK_BOTH(quadratic_roots(1.0, -1e9, 1.0).root[0] == 1e-9);
  // The discriminant is 2^-56 below, at, and above zero.
  CHECK_BOTH(quadratic_roots(1 + 0x1p-28, 2.0, 1 - 0x1p-28).count == 2);
  CHECK_BOTH(quadratic_roots_fast(1 + 0x1p-28, 2.0, 1 - 0x1p-28).count == 2);
  CHECK_BOTH(quadratic_roots(1 + 0x1p-52, 2.0, 1.0) == none);
  CHECK_BOTH(quadratic_roots(1 - 0x1p-53, 2.0, 1.0).count == 2);
  CHECK_BOTH(quadratic_roots(1e200, 2e200, 1e200) == one(-1));
}

TEST_CASE("roots: quadratic, degenerate gallery") {
  CHECK_BOTH(quadratic_roots(0.0, 0.0, 0.0) == only(roots_kind::all));
  CHECK_BOTH(quadratic_roots(0.0, 0.0, 1.0) == none);
  CHECK_BOTH(quadratic_roots(0.0, 2.0, -6.0) == linear(3));
  CHECK_BOTH(quadratic_roots(0.0, 2.0, 0.0) == linear(0));
  CHECK_BOTH(quadratic_roots(1.0, 0.0, 0.0) == one(0));
  CHECK_BOTH(quadratic_roots(1.0, -5.0, 0.0) == two(0, 5));
  CHECK_BOTH(quadratic_roots(1.0, 5.0, 0.0) == two(-5, 0));
  CHECK_BOTH(quadratic_roots(largest, largest, 0.0) == two(-1, 0));
  CHECK_BOTH(quadratic_roots(largest, 0.0, -largest) == two(-1, 1));
  CHECK_BOTH(quadratic_roots(smallest, 0.0, -smallest) == two(-1, 1));
  CHECK_BOTH(quadratic_roots(smallest, -3 * smallest, 2 * smallest) == two(1, 2));
  CHECK_BOTH(quadratic_roots(smallest, 2 * smallest, smallest) == one(-1));
  CHECK_BOTH(quadratic_roots(0x1p1022, 0x1p1023, 0x1p1022) == one(-1));
  CHECK_BOTH(quadratic_roots(smallest, 0.0, -largest) == two(-inf, inf));
  CHECK_BOTH(quadratic_roots(0.0, smallest, -largest) == linear(inf));
  CHECK_BOTH(quadratic_roots(smallest, largest, -smallest) == two(-inf, 0));
  CHECK_BOTH(quadratic_roots(1.0, 0x1p1000, -1.0) == two(-0x1p1000, 0x1p-1000));
  CHECK_BOTH(quadratic_roots(1.0f, 0x1p100f, -1.0f).root[1] == 0x1p-100f);
  CHECK_BOTH(quadratic_roots(0x1p-149f, 1.0f, -1.0f).root[0] == -std::numeric_limits<float>::infinity());
  CHECK_BOTH(quadratic_roots(inf, 1.0, 1.0) == only(roots_kind::undefined));
  CHECK(quadratic_roots(1.0, test::at_run_time(std::nan("")), 1.0) == only(roots_kind::undefined));
}

TEST_CASE("roots: cubic by hand") {
  CHECK_BOTH(cubic_roots(1.0, -6.0, 11.0, -6.0) == three(1, 2, 3));
  CHECK_BOTH(cubic_roots(-1.0, 6.0, -11.0, 6.0) == three(1, 2, 3));
  CHECK_BOTH(cubic_roots(1.0, -4.0, 5.0, -2.0) == double_and(1, 2, 2, 1));
  CHECK_BOTH(cubic_roots(1.0, -5.0, 8.0, -4.0) == double_and(1, 1, 2, 2));
  CHECK_BOTH(cubic_roots(1.0, -3.0, 3.0, -1.0) == one_of_three(1, 3));
  CHECK_BOTH(cubic_roots(8.0, 0.0, 0.0, 27.0) == one_of_three(-1.5));
  CHECK_BOTH(cubic_roots(1.0, 0.0, 1.0, -2.0) == one_of_three(1));
  CHECK_BOTH(cubic_roots(1.0, 0.0, -1.0, 0.0) == three(-1, 0, 1));
  // A double root and what one bit of the last coefficient makes of it.
  CHECK_BOTH(cubic_roots(1.0, -4.0, 5.0, -2 + 0x1p-52).count == 3);
  CHECK_BOTH(cubic_roots(1.0, -4.0, 5.0, -2 + 0x1p-52).root[0] == 1 - 0x1p-26 + 0x1p-53);
  CHECK_BOTH(cubic_roots(1.0, -4.0, 5.0, -2 - 0x1p-51).count == 1);
  CHECK_BOTH(cubic_roots(1.0f, -6.0f, 11.0f, -6.0f).root[2] == 3.0f);
}

TEST_CASE("roots: cubic, degenerate gallery") {
  CHECK_BOTH(cubic_roots(1.0, 0.0, 0.0, 0.0) == one_of_three(0, 3));
  CHECK_BOTH(cubic_roots(1.0, -2.0, 0.0, 0.0) == double_and(0, 2, 2, 1));
  CHECK_BOTH(cubic_roots(1.0, 2.0, 0.0, 0.0) == double_and(-2, 1, 0, 2));
  CHECK_BOTH(cubic_roots(1.0, -2.0, 1.0, 0.0) == double_and(0, 1, 1, 2));
  CHECK_BOTH(cubic_roots(1.0, 2.0, 1.0, 0.0) == double_and(-1, 2, 0, 1));
  CHECK_BOTH(cubic_roots(1.0, 0.0, 1.0, 0.0) == one_of_three(0));
  CHECK_BOTH(cubic_roots(0.0, 1.0, -3.0, 2.0) == double_and(1, 1, 2, 1));
  CHECK_BOTH(cubic_roots(0.0, 0.0, 1.0, 2.0).kind == roots_kind::linear);
  CHECK_BOTH(cubic_roots(0.0, 0.0, 0.0, 2.0).kind == roots_kind::none);
  CHECK_BOTH(cubic_roots(0.0, 0.0, 0.0, 0.0).kind == roots_kind::all);
  CHECK_BOTH(cubic_roots(1.0, inf, 0.0, 0.0).kind == roots_kind::undefined);
  CHECK_BOTH(cubic_roots(0x1p1000, -0x1.8p1001, 0x1.8p1001, -0x1p1000).kind == roots_kind::one);
}

TEST_CASE("roots: cubic equations beyond the usual range") {
  for (const double scale : {0x1p1018, 0x1p500, 0x1p-500, 0x1p-1070}) {
    CHECK(cubic_roots(scale, -6 * scale, 11 * scale, -6 * scale) == three(1, 2, 3));
    CHECK(cubic_roots(scale, -4 * scale, 5 * scale, -2 * scale) == double_and(1, 2, 2, 1));
    CHECK(cubic_roots(scale, -3 * scale, 3 * scale, -scale) == one_of_three(1, 3));
  }
  // Roots 2^-300, 1 and 2^300; the last one beyond the range.
  const double far = 0x1p300;
  CHECK(cubic_roots(1.0, -(far + 1), far, -1.0).count == 3);
  CHECK(cubic_roots(1.0, -(far + 1), far, -1.0).root[0] == 1 / far);
  CHECK(cubic_roots(smallest, 1.0, 0.0, -1.0) == three(-inf, -1, 1));
  CHECK(cubic_roots(smallest, 0.0, 0.0, largest).root[0] == -0x1.428a2f98d728bp+699);
  CHECK(cubic_roots(largest, largest, largest, largest) == one_of_three(-1));
}

TEST_CASE("roots: integer roots come back exactly, with their multiplicity") {
  test::random r(1);
  for (int i = 0; i < 20000; ++i) {
    const auto any = [&] { return static_cast<double>(r.integer(-1000, 1000)); };
    double x = any(), y = r.next() % 4 == 0 ? x : any(), z = r.next() % 8 == 0 ? y : any();
    double a = any();
    if (a == 0) a = 1;
    if (y < x) std::swap(x, y);
    const two_roots quadratic = quadratic_roots(a, -a * (x + y), a * x * y);
    CHECK(quadratic == (x == y ? one(x) : two(x, y)));
    const three_roots cubic = cubic_roots(a, -a * (x + y + z), a * (x * y + y * z + z * x), -a * x * y * z);
    int total = 0;
    for (int k = 0; k < cubic.count; ++k) {
      const double root = cubic.root[k];
      CHECK((root == x || root == y || root == z));
      CHECK(cubic.multiplicity[k] == (root == x) + (root == y) + (root == z));
      total += cubic.multiplicity[k];
    }
    CHECK(total == 3);
  }
}

TEST_CASE("roots: no quadratic root is lost or invented, seen in integers") {
  test::random r(4);
  __extension__ using wide = __int128;
  int wrong = 0, none_found = 0, doubles_found = 0;
  for (int i = 0, n = test::count_of(1000000); i < n; ++i) {
    const auto any = [&](int bits) { return static_cast<std::int64_t>(r.next() >> (64 - bits)) + 1; };
    // b*b is next to 4*a*c: the discriminant is some units of a product of 106 bits.
    std::int64_t a = any(51), b = 2, c = any(51);
    if (i % 4 == 0) a = any(25) * any(25), c = a;  // squares: exactly zero now and then
    if (i % 4 == 1) c = a + r.integer(-2, 2);
    b = static_cast<std::int64_t>(2 * std::sqrt(static_cast<double>(a)) * std::sqrt(static_cast<double>(c)));
    b += r.integer(-2, 2);
    const wide discriminant = wide{b} * b - wide{4} * a * c;
    const int want = discriminant < 0 ? 0 : discriminant == 0 ? 1 : 2;
    const double x = static_cast<double>(a), y = static_cast<double>(b), z = static_cast<double>(c);
    if (quadratic_roots(x, y, z).count != want) ++wrong;
    if (quadratic_roots_fast(x, y, z).count != want) ++wrong;
    none_found += want == 0 ? 1 : 0;
    doubles_found += want == 1 ? 1 : 0;
  }
  CHECK(wrong == 0);
  CHECK(none_found > 0);
  CHECK(doubles_found > 0);
  MESSAGE(none_found, " without a root, ", doubles_found, " with a double one, ", wrong, " wrong");
}

#ifdef IRG_HAVE_MPFR
namespace {

struct number {
  mpfr_t v;
  number() { mpfr_init2(v, 9000); }
  explicit number(double x) : number() { mpfr_set_d(v, x, MPFR_RNDN); }
  number(const number&) = delete;
  number& operator=(const number&) = delete;
  ~number() { mpfr_clear(v); }
};

/// The largest error of the roots in ulp; 1e9 when their number is wrong.
template <class T>
double quadratic_error(T a, T b, T c, const real_roots<T, 2>& got) {
  static number d, t, x;
  mpfr_set_d(d.v, static_cast<double>(b), MPFR_RNDN);
  mpfr_sqr(d.v, d.v, MPFR_RNDN);
  mpfr_set_d(t.v, static_cast<double>(a), MPFR_RNDN);
  mpfr_mul_d(t.v, t.v, static_cast<double>(c), MPFR_RNDN);
  mpfr_mul_ui(t.v, t.v, 4, MPFR_RNDN);
  mpfr_sub(d.v, d.v, t.v, MPFR_RNDN);
  const int count = mpfr_sgn(d.v) < 0 ? 0 : mpfr_zero_p(d.v) ? 1 : 2;
  if (got.count != count) return 1e9;
  if (count == 0) return 0;
  mpfr_sqrt(d.v, d.v, MPFR_RNDN);
  double worst = 0;
  for (int i = 0; i < count; ++i) {
    const bool minus = (i == 0) == (a > 0);
    if (minus)
      mpfr_neg(x.v, d.v, MPFR_RNDN);
    else
      mpfr_set(x.v, d.v, MPFR_RNDN);
    mpfr_sub_d(x.v, x.v, static_cast<double>(b), MPFR_RNDN);
    mpfr_div_d(x.v, x.v, static_cast<double>(a), MPFR_RNDN);
    mpfr_div_ui(x.v, x.v, 2, MPFR_RNDN);
    worst = std::max(worst, test::ulp_error(got.root[i], x.v));
  }
  return worst;
}

int sign_at(const three_roots&, double a, double b, double c, double d, double x) {
  static number sum;
  mpfr_set_d(sum.v, a, MPFR_RNDN);
  for (const double k : {b, c, d}) mpfr_mul_d(sum.v, sum.v, x, MPFR_RNDN), mpfr_add_d(sum.v, sum.v, k, MPFR_RNDN);
  return (mpfr_sgn(sum.v) > 0) - (mpfr_sgn(sum.v) < 0);
}

}  // namespace

TEST_CASE("roots: quadratic against MPFR, six kinds of difficulty") {
  test::random r(2);
  double worst[6]{}, worst_float = 0, worst_fast = 0;
  for (int i = 0, n = test::count_of(6000); i < n; ++i) {
    const auto some = [&] { return test::either_sign(r, test::of_exponent(r, -3, 3)); };
    const double x = some(), ratio = test::of_exponent(r, -53, 0);
    const double near = 1 + std::ldexp(r.unit(), -static_cast<int>(r.integer(1, 60)));
    const double a = some(), b = some();
    const double cases[6][3] = {
        {a, b, some()},                                                     // anything moderate
        {a, -a * (x + x * ratio), a * x * x * ratio},                       // roots far apart
        {a, -2 * a * x, a * x * x * near},                                  // nearly double
        {a, b, b * b / (4 * a)},                                            // as double as it gets
        {test::any_double(r), test::any_double(r), test::any_double(r)},    // any doubles
        {std::ldexp(a, -1060), std::ldexp(b, -1050), std::ldexp(x, -1065)}  // subnormal
    };
    for (int k = 0; k < 6; ++k) {
      const auto [p, q, s] = cases[k];
      const double error = quadratic_error(p, q, s, quadratic_roots(p, q, s));
      worst[k] = std::max(worst[k], error);
      if (k >= 4) continue;
      worst_fast = std::max(worst_fast, quadratic_error(p, q, s, quadratic_roots_fast(p, q, s)));
      const float u = static_cast<float>(p), v = static_cast<float>(q), w = static_cast<float>(s);
      if (u != 0) worst_float = std::max(worst_float, quadratic_error(u, v, w, quadratic_roots(u, v, w)));
    }
  }
  for (int k = 0; k < 6; ++k) CHECK(worst[k] <= (k == 4 ? 1 : 0.51));
  CHECK(worst_float <= 0.501);
  CHECK(worst_fast <= 3);
  MESSAGE("quadratic_roots: ", worst[0], " ulp, far apart ", worst[1], ", near ", worst[2], ", double ", worst[3],
          ", any ", worst[4], ", subnormal ", worst[5], "; float ", worst_float, "; fast ", worst_fast);
}

TEST_CASE("roots: cubic roots are enclosed by their neighbours") {
  test::random r(3);
  int loose = 0, close = 0, all = 0, counts[4]{};
  for (int i = 0, n = test::count_of(8000); i < n; ++i) {
    const auto some = [&] { return test::either_sign(r, test::of_exponent(r, -3, 3)); };
    const auto near = [&](double x) { return x * (1 + std::ldexp(r.unit(), -static_cast<int>(r.integer(0, 55)))); };
    double a = some(), b = some(), c = some(), d = some();
    if (i % 4 != 0) {  // from roots that may be near to each other
      const double x = some(), y = i % 4 == 1 ? some() : near(x), z = i % 4 == 3 ? near(x) : some();
      b = -a * (x + y + z), c = a * (x * y + y * z + z * x), d = -a * x * y * z;
    }
    if (i % 50 == 0) a = test::any_double(r), b = test::any_double(r), c = test::any_double(r);
    const three_roots got = cubic_roots(a, b, c, d);
    const auto scaled = [&](double by) {  // beyond 2^150 the sign is found in integers, without a filter
      return detail::cubic_discriminant_sign({d * by, c * by, b * by, a * by});
    };
    if (i % 50 != 0) CHECK(scaled(1) == scaled(0x1p300));
    ++counts[got.count];
    CHECK(got.count >= 1);
    for (int k = 0; k < got.count; ++k) {
      const double x = got.root[k];
      if (k > 0) CHECK(got.root[k - 1] <= x);
      if (!std::isfinite(x) || got.multiplicity[k] == 2) continue;
      const auto sign = [&](double at) { return sign_at(got, a, b, c, d, at); };
      const int left = (a > 0 ? -1 : 1) * ((got.count - k) % 2 != 0 ? 1 : -1) * (got.count == 2 ? 0 : 1);
      const double low = std::nextafter(x, -inf), high = std::nextafter(x, inf);
      ++all;
      if (sign(x) == 0) continue;
      if (got.count != 2 && sign(low) == left && sign(high) == -left) continue;
      if (got.count == 2 && sign(low) * sign(high) < 0) continue;
      // Only a root with a neighbour nearer than 3 ulp may miss.
      const bool has_twin = (k > 0 && got.root[k - 1] >= x - 3 * (high - x)) ||
                            (k + 1 < got.count && got.root[k + 1] <= x + 3 * (high - x));
      ++(has_twin ? close : loose);
    }
  }
  CHECK(loose == 0);
  MESSAGE("of ", all, " roots ", close,
          " too near to each other to be told apart; equations with 1, 2, 3 roots: ", counts[1], ", ", counts[2], ", ",
          counts[3]);
}

namespace {
namespace sweeps {

using namespace test::mixed;
using test::mixed::number;

// The roots of a quadratic equation by their sum of larger size, which does not cancel, and by Vieta's product.
template <class T>
double error_of_roots(T a, T b, T c, const irg::real_roots<T, 2>& got) {
  static wide<T> discriminant;
  static test::real root[2], sum;
  mpfr_set_zero(discriminant, 1);
  add_product(discriminant, static_cast<double>(b), b);
  add_product(discriminant, -4.0, a, c);
  const int sign = sign_of(discriminant), count = sign < 0 ? 0 : sign + 1;
  if (got.count != count || (count == 1 && got.multiplicity[0] != 2)) return 1e9;
  if (count == 0) return got.kind == irg::roots_kind::none ? 0 : 1e9;
  mpfr_sqrt(sum, discriminant, MPFR_RNDN);
  if (b > 0) mpfr_neg(sum, sum, MPFR_RNDN);
  mpfr_sub_d(sum, sum, static_cast<double>(b), MPFR_RNDN);
  mpfr_div_2ui(sum, sum, 1, MPFR_RNDN);
  mpfr_div_d(root[0], sum, static_cast<double>(a), MPFR_RNDN);
  if (count == 1 || c == 0)
    mpfr_set_zero(root[1], 1);
  else
    mpfr_d_div(root[1], static_cast<double>(c), sum, MPFR_RNDN);
  if (count == 1) return test::ulp_error(got.root[0], root[0]);
  const bool ascending = mpfr_cmp(root[0], root[1]) <= 0;
  const auto error = [](T x, mpfr_ptr want) {
    const double ulp = test::ulp_error(x, want);
    return std::fabs(x) < std::numeric_limits<T>::min() && ulp <= 1 ? 0 : ulp;  // subnormal ones within 1
  };
  return std::fmax(error(got.root[ascending ? 0 : 1], root[0]), error(got.root[ascending ? 1 : 0], root[1]));
}

template <class T>
void sweep_quadratics() {
  sweep("quadratic_roots", sizeof(T) == 8 ? 0.51 : 0.501, [](test::random& r, sizes which) {
    const T a = number<T>(r, which), b = number<T>(r, which);
    T c = number<T>(r, which);
    if (r.integer(0, 3) == 0) c = b / a * b / 4;  // nearly a double root
    if (!std::isfinite(c)) return 0.0;
    const auto got = irg::quadratic_roots(a, b, c);
    if (a == 0) return got.kind == irg::roots_kind::linear || b == 0 ? 0.0 : 1e9;
    return error_of_roots(a, b, c, got);
  });
  sweep("quadratic_roots_fast", 3, [](test::random& r, sizes which) {
    const T a = number<T>(r, which), b = number<T>(r, which), c = number<T>(r, which);
    const auto is_moderate = [](const big_rational& x) {
      return sizeof(T) == 4 || x.sign() == 0 || (big_rational(0x1p-900) < abs(x) && abs(x) < big_rational(0x1p1000));
    };
    if (a == 0 || !is_moderate(rational(a) * rational(c)) || !is_moderate(rational(b) * rational(b))) return 0.0;
    const auto got = irg::quadratic_roots_fast(a, b, c), full = irg::quadratic_roots(a, b, c);
    for (int i = 0; i < full.count; ++i)
      if (full.root[i] != 0 && !std::isnormal(full.root[i])) return 0.0;
    return error_of_roots(a, b, c, got);
  });
}

// How a cubic equation's simple roots lie: the polynomial changes its sign from below each to above it.
template <class T>
double error_of_cubic(const T (&p)[4], const irg::real_roots<T, 3>& got) {
  const big_rational a = rational(p[3]), b = rational(p[2]), c = rational(p[1]), d = rational(p[0]);
  const big_rational seven_and_twenty = 27, discriminant = a * b * c * d * 18 - b * b * b * d * 4 + b * b * c * c -
                                                           a * c * c * c * 4 - seven_and_twenty * a * a * d * d;
  const int sign = discriminant.sign();
  const int count = sign > 0 ? 3 : sign < 0 ? 1 : b * b == a * c * 3 ? 1 : 2;
  if (got.count != count) return 1e9;
  if (sign == 0) return 0;
  const auto sign_at = [&](T x) {
    if (!std::isfinite(x)) return x > 0 ? a.sign() : -a.sign();
    const big_rational at = rational(x);
    return (((a * at + b) * at + c) * at + d).sign();
  };
  for (int i = 0; i < count; ++i) {
    const T x = got.root[i];
    if (i > 0 && x < got.root[i - 1]) return 1e9;
    const int before = (count - i) % 2 != 0 ? -a.sign() : a.sign();
    const bool has_twin = (i > 0 && std::nextafter(std::nextafter(got.root[i - 1], x), x) == x) ||
                          (i + 1 < count && std::nextafter(std::nextafter(got.root[i + 1], x), x) == x);
    if (has_twin || sign_at(x) == 0) continue;
    const T low = std::nextafter(x, T(-HUGE_VAL)), high = std::nextafter(x, T(HUGE_VAL));
    const int left = sign_at(low), right = std::isinf(x) && x > 0 ? a.sign() : sign_at(high);
    const int first = std::isinf(x) && x < 0 ? -a.sign() : left;
    if ((first != before && first != 0) || (right != -before && right != 0)) return 2;
  }
  return 0;
}
template <class T>
void sweep_cubics() {
  sweep("cubic_roots", 1, [](test::random& r, sizes which) {
    T p[4];
    for (T& x : p) x = number<T>(r, which);
    if (p[3] == 0 || p[0] == 0) return 0.0;
    return error_of_cubic(p, irg::cubic_roots(p[3], p[2], p[1], p[0]));
  });
}

TEST_CASE_TEMPLATE("roots: numbers of all sizes", T, double, float) {
  sweep_quadratics<T>();
  sweep_cubics<T>();
}

}  // namespace sweeps
}  // namespace

#else
TEST_CASE("error bounds") { MESSAGE("skipped: MPFR was not found"); }
#endif

// The worst inputs that bench/accuracy found; the expected roots are those of MPFR, rounded to nearest.
TEST_CASE("worst inputs of the accuracy study") {
  using irg::cubic_roots, irg::quadratic_roots;
  using two = irg::real_roots<double, 2>;
  constexpr auto kind = irg::roots_kind::two;
  CHECK_BOTH(quadratic_roots(0x1.7368103973d1dp-3, 0x1.57fb8367dda64p-3, 0x1.28aca0aa84d0fp-5) ==
             two{kind, 2, {-0x1.2b4626545aaebp-1, -0x1.5dd76f07587b9p-2}, {1, 1}});
  CHECK_BOTH(quadratic_roots(-0x1.061a83626f803p+2, 0x1.f74b373f17b19p+2, -0x1.e336fef3910c1p+1) ==
             two{kind, 2, {0x1.eb8c286f8bbfbp-1, 0x1.eb99914d0469ap-1}, {1, 1}});
  CHECK_BOTH(quadratic_roots(0x1.b788b52fe4942p-2, -0x1.8cd0b63dcd58p+55, 0x1.5a47005dea241p+58) ==
             two{kind, 2, {0x1.becad2ab0ebfap+2, 0x1.ce3cfc75bb072p+56}, {1, 1}});
  CHECK_BOTH(quadratic_roots(0x1.fba5acabc22ap-287, -0x1.5c5e661527659p+68, 0x1.7bacf5c3073dp+377) ==
             two{kind, 2, {0x1.17018750aed6ep+309, 0x1.5f5b18787955bp+354}, {1, 1}});
  const auto near =
      cubic_roots(0x1.a7d885a624c6ep+2, -0x1.bcf1bf8d65d2fp+6, 0x1.37653a2e33033p+9, -0x1.22931268e7262p+10);
  CHECK(near ==
        irg::real_roots<double, 3>{
            irg::roots_kind::three, 3, {0x1.664c7cc951e56p+2, 0x1.66559783a2576p+2, 0x1.665723362510cp+2}, {1, 1, 1}});
  const auto far =
      cubic_roots(0x1.1810f5bda280dp+2, 0x1.d1e687b92c5f6p+22, 0x1.6987e144c0364p+32, -0x1.5e8f8af2e5b1ap+32);
  CHECK(far == irg::real_roots<double, 3>{irg::roots_kind::three,
                                          3,
                                          {-0x1.a9abdc736a967p+20, -0x1.8df80372860afp+9, 0x1.efdc1da1b447fp-1},
                                          {1, 1, 1}});
}
