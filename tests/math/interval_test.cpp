// SPDX-License-Identifier: MIT
#include <irg/math/interval.hpp>

#include <irg/math/mat.hpp>

#include "math/mixed_cases.hpp"
#include "support/check_both.hpp"
#include "support/ulp.hpp"

using namespace irg;

namespace {

using ival = interval<double>;
using fval = interval<float>;
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = 0x1p-1074;

}  // namespace

static_assert(Scalar<ival> && Real<ival> && Scalar<fval>);
static_assert(noexcept(ival(1) / ival(2)));

TEST_CASE("interval: by hand") {
  CHECK_BOTH(ival(1) + ival(2) == ival(3));
  CHECK_BOTH(ival(1) + ival(0x1p-80) == ival(1, 1 + 0x1p-52));
  CHECK_BOTH(ival(1) - ival(0x1p-80) == ival(1 - 0x1p-53, 1));
  CHECK_BOTH(ival(-1, 2) * ival(-3, 4) == ival(-6, 8));
  CHECK_BOTH(ival(1, 2) / ival(4, 8) == ival(0.125, 0.5));
  CHECK_BOTH(ival(1) / ival(3) == ival(0x1.5555555555555p-2, 0x1.5555555555556p-2));
  CHECK_BOTH(fval(1) / fval(3) == fval(0x1.555554p-2f, 0x1.555556p-2f));
  CHECK_BOTH(ival(-1, 2) * ival(-1, 2) == ival(-2, 4));
  CHECK_BOTH(square(ival(-1, 2)) == ival(0, 4));
  CHECK_BOTH(square(ival(-3, -2)) == ival(4, 9));
  CHECK_BOTH(sqrt(ival(4, 9)) == ival(2, 3));
  CHECK_BOTH(sqrt(ival(2)) == ival(0x1.6a09e667f3bccp+0, 0x1.6a09e667f3bcdp+0));
  CHECK_BOTH(abs(ival(-3, 2)) == ival(0, 3));
  CHECK_BOTH(hull(ival(1), ival(3)) == ival(1, 3));
  CHECK_BOTH(intersect(ival(1, 3), ival(2, 5)) == ival(2, 3));
  CHECK_BOTH(width(ival(1, 3)) == 2);
  CHECK_BOTH(middle(ival(1, 3)) == 2);
  CHECK_BOTH(contains(ival(1, 3), 3));
  CHECK_BOTH(!contains(ival(1, 3), 3.5));
  CHECK_BOTH(contains(ival(1, 3), ival(2, 3)));
  CHECK_BOTH(contains(fval(16777217), fval(16777216.0f, 16777218.0f)));
}

TEST_CASE("interval: quotients of very small numbers have the nearest ends") {
  CHECK_BOTH(ival(0x1p-1000) / ival(0x1p-500) == ival(0x1p-500));
  CHECK_BOTH(ival(0x1p-1074) / ival(0x3p-1074) == ival(0x1.5555555555555p-2, 0x1.5555555555556p-2));
  CHECK_BOTH(ival(-0x7p-1074) / ival(0x1p-1074) == ival(-7));
}

TEST_CASE("interval: beyond the range, in constant evaluation, too") {
  CHECK_BOTH(ival(largest) + ival(largest) == ival(largest, inf));
  CHECK_BOTH(ival(-largest) - ival(largest) == ival(-inf, -largest));
  CHECK_BOTH(ival(largest) * ival(-2, 3) == ival(-inf, inf));
  CHECK_BOTH(ival(1) / ival(smallest) == ival(largest, inf));
  CHECK_BOTH(ival(-1, 1) / ival(smallest, 1) == ival(-inf, inf));
  constexpr float most = std::numeric_limits<float>::max();
  CHECK_BOTH(fval(most) + fval(most) == fval(most, std::numeric_limits<float>::infinity()));
}

TEST_CASE("interval: comparisons are certain or possible") {
  CHECK_BOTH(ival(1, 2) < ival(3, 4));
  CHECK_BOTH(!(ival(1, 3) < ival(3, 4)));
  CHECK_BOTH(!(ival(1, 3) > ival(2, 4)));
  CHECK_BOTH(possibly_less(ival(1, 3), ival(2, 4)));
  CHECK_BOTH(possibly_less(ival(2, 4), ival(1, 3)));
  CHECK_BOTH(!possibly_less(ival(3, 4), ival(1, 3)));
  CHECK_BOTH(possibly_equal(ival(1, 3), ival(3, 4)));
  CHECK_BOTH(!certainly_equal(ival(1, 3), ival(1, 3)));
  CHECK_BOTH(certainly_equal(ival(2), ival(2)));
  CHECK_BOTH(certain_sign(ival(1, 2)) == 1);
  CHECK_BOTH(certain_sign(ival(-2, -1)) == -1);
  CHECK_BOTH(certain_sign(ival(0)) == 0);
  CHECK_BOTH(!certain_sign(ival(0, 1)));
}

TEST_CASE("interval: degenerate gallery") {
  constexpr ival none = ival::empty(), all = ival::whole();
  CHECK_BOTH(ival(2, 1) == none);
  CHECK_BOTH(ival(std::numeric_limits<double>::quiet_NaN()) == all);
  CHECK_BOTH(ival(inf) == ival(largest, inf));
  CHECK_BOTH(ival(-inf, -inf) == ival(-inf, -largest));
  CHECK_BOTH(ival(1) / ival(0) == none);
  CHECK_BOTH(ival(1) / ival(-1, 2) == all);
  CHECK_BOTH(ival(0) / ival(-1, 2) == ival(0));
  CHECK_BOTH(ival(1, 2) / ival(0, 4) == ival(0.25, inf));
  CHECK_BOTH(ival(-2, -1) / ival(0, 4) == ival(-inf, -0.25));
  CHECK_BOTH(ival(1, 2) / ival(-4, 0) == ival(-inf, -0.25));
  CHECK_BOTH(ival(-1, 2) / ival(0, 4) == all);
  CHECK_BOTH(ival(1, inf) / ival(1, inf) == ival(0, inf));
  CHECK_BOTH(ival(0) * all == ival(0));
  CHECK_BOTH(all + all == all);
  CHECK_BOTH(all - all == all);
  CHECK_BOTH(none + ival(1) == none);
  CHECK_BOTH(none * all == none);
  CHECK_BOTH(-none == none);
  CHECK_BOTH(sqrt(ival(-2, -1)) == none);
  CHECK_BOTH(sqrt(ival(-1, 4)) == ival(0, 2));
  CHECK_BOTH(sqrt(all) == ival(0, inf));
  CHECK_BOTH(!(none < ival(1)));
  CHECK_BOTH(!possibly_equal(none, none));
  CHECK_BOTH(hull(none, ival(1)) == ival(1));
  CHECK_BOTH(intersect(ival(1), ival(2)) == none);
  CHECK_BOTH(width(none) == 0);
  CHECK_BOTH(middle(all) == 0);
  CHECK_BOTH(contains(all, none));
  CHECK_BOTH(!contains(all, inf));
  CHECK_BOTH(contains(ival(smallest) * ival(smallest), ival(0, smallest)));
  CHECK_BOTH((ival(-smallest) * ival(smallest)).upper() == 0);
  CHECK_BOTH(ival(0x1p-537) / ival(0x1p537) == ival(0, 2 * smallest));
  CHECK_BOTH(ival(std::int64_t{9007199254740993}) == ival(9007199254740991.0, 9007199254740994.0));
  CHECK_BOTH(ival(std::uint64_t{9007199254740992}) == ival(9007199254740992.0));
  const ival beyond = ival(test::at_run_time(largest)) + ival(largest);
  CHECK(beyond == ival(largest, inf));
  CHECK(ival(test::at_run_time(-largest)) * ival(2) == ival(-inf, -largest));
  CHECK(ival(test::at_run_time(1.0)) / ival(smallest) == ival(largest, inf));
}

TEST_CASE("interval: a determinant whose sign is certain, and one whose is not") {
  constexpr mat<ival, 2, 2> clear{{{ival(0.1), ival(0.3)}, {ival(0.2), ival(0.7)}}};
  CHECK_BOTH(certain_sign(determinant(clear)) == 1);
  constexpr mat<ival, 2, 2> open{{{ival(0.1), ival(0.3)}, {ival(0.3), ival(0.9)}}};
  CHECK_BOTH(!certain_sign(determinant(open)));
  CHECK_BOTH(contains(determinant(open), 0));
}

#ifdef IRG_HAVE_MPFR
namespace {

template <class T>
T random_number(test::random& r, int kind) {
  if (kind == 0) return static_cast<T>(test::between(r, -2, 2));
  if (kind == 1) return static_cast<T>(static_cast<int>(r.integer(-40, 40)));
  if constexpr (sizeof(T) == 8) return test::any_double(r);
  for (;;)
    if (const float x = std::bit_cast<float>(static_cast<std::uint32_t>(r.next())); std::isfinite(x))
      return static_cast<T>(x);
}

/// The nearest T below the exact result of an operation.
template <class T>
T down(mpfr_ptr x) {
  return sizeof(T) == 8 ? static_cast<T>(mpfr_get_d(x, MPFR_RNDD)) : static_cast<T>(mpfr_get_flt(x, MPFR_RNDD));
}

struct tally {
  int wrong = 0, wider = 0, far = 0, all = 0;
};

/// Compares one end, rounded downwards, with the best there is.
template <class T>
void compare(tally& t, T got, T best) {
  ++t.all;
  if (!(got <= best)) ++t.wrong;
  if (got != best) ++t.wider;
  if (got != best && got != std::nextafter(best, static_cast<T>(-inf))) ++t.far;
}

template <class T>
void run(int kind, tally& t) {
  test::random r(static_cast<std::uint64_t>(kind) + 1);
  mpfr_t a, b, c;
  mpfr_inits2(4500, a, b, c, static_cast<mpfr_ptr>(nullptr));
  for (int i = 0, n = test::count_of(5000); i < n; ++i) {
    const T x = random_number<T>(r, kind), y = random_number<T>(r, kind);
    mpfr_set_d(a, static_cast<double>(x), MPFR_RNDN), mpfr_set_d(b, static_cast<double>(y), MPFR_RNDN);
    const auto check = [&](const interval<T>& got) {
      compare(t, got.lower(), down<T>(c));
      mpfr_neg(c, c, MPFR_RNDN);
      compare(t, -got.upper(), down<T>(c));
    };
    mpfr_add(c, a, b, MPFR_RNDN), check(interval<T>(x) + interval<T>(y));
    mpfr_mul(c, a, b, MPFR_RNDN), check(interval<T>(x) * interval<T>(y));
    mpfr_sqr(c, a, MPFR_RNDN), check(square(interval<T>(x)));
    mpfr_abs(c, a, MPFR_RNDN), mpfr_sqrt(c, c, MPFR_RNDN), check(sqrt(abs(interval<T>(x))));
    if (y == 0) continue;
    // A quotient of 4500 bits is on the right side of every double but exact ones, which it hits.
    mpfr_div(c, a, b, MPFR_RNDN), check(interval<T>(x) / interval<T>(y));
  }
  mpfr_clears(a, b, c, static_cast<mpfr_ptr>(nullptr));
}

}  // namespace

TEST_CASE("interval: ends against MPFR's directed rounding") {
  for (int kind = 0; kind < 3; ++kind) {
    tally of_doubles, of_floats;
    run<double>(kind, of_doubles), run<float>(kind, of_floats);
    CHECK(of_doubles.wrong == 0);
    CHECK(of_floats.wrong == 0);
    CHECK(of_floats.wider == 0);
    CHECK(of_doubles.far == 0);
    if (kind < 2) CHECK(of_doubles.wider == 0);
    MESSAGE("ends wider than need be: ", of_doubles.wider, " of ", of_doubles.all);
  }
}

namespace {
namespace sweeps {

using namespace test::mixed;

// Whether x is the nearest number not below `want`, or is one further out where `may_be_further` and so it may be.
template <class T>
double outward_error(T upper, const big_rational& want, bool may_be_further) {
  constexpr T largest = std::numeric_limits<T>::max();
  if (upper != upper || (std::isfinite(upper) && rational(upper) < want)) return 1e9;
  if (upper < -largest) return 1e9;
  const T below = std::nextafter(upper, T(-HUGE_VAL));
  if (!std::isfinite(below) || rational(below) < want) return 0;
  const T twice = std::nextafter(below, T(-HUGE_VAL));
  return may_be_further && (!std::isfinite(twice) || rational(twice) < want) ? 0 : 1;
}
template <class T>
double outward_error(const irg::interval<T>& got, const big_rational& low, const big_rational& high, bool further) {
  return std::fmax(outward_error(got.upper(), high, further), outward_error(-got.lower(), -low, further));
}
template <class T>
irg::interval<T> any_interval(test::random& r, sizes which) {
  const T a = number<T>(r, which), b = r.integer(0, 3) == 0 ? a : number<T>(r, which);
  return {std::fmin(a, b), std::fmax(a, b)};
}
// The least and the greatest of f at the ends of two intervals, and whether an operation may miss the nearest end.
struct ends {
  big_rational low, high;
  bool further = false;
};
template <class T, class F>
ends ends_of(const irg::interval<T>& a, const irg::interval<T>& b, F f) {
  ends e;
  bool first = true;
  for (const T x : {a.lower(), a.upper()})
    for (const T y : {b.lower(), b.upper()}) {
      const big_rational value = f(rational(x), rational(y)), size = abs(value);
      e.low = first || value < e.low ? value : e.low;
      e.high = first || e.high < value ? value : e.high;
      first = false;
      if (sizeof(T) == 8)
        e.further = e.further || size < big_rational(0x1p-900) || big_rational(0x1p1020) < size ||
                    std::fabs(static_cast<double>(x)) > 0x1p1020;
    }
  return e;
}

template <class T>
void sweep_intervals() {
  using interval = irg::interval<T>;
  const auto binary = [](const char* what, auto f) {
    sweep(what, 0, [&](test::random& r, sizes which) {
      return f(any_interval<T>(r, which), any_interval<T>(r, all_sizes[r.integer(0, 3)]));
    });
  };
  binary("interval, sum", [](const interval& a, const interval& b) {
    return outward_error(a + b, rational(a.lower()) + rational(b.lower()), rational(a.upper()) + rational(b.upper()),
                         false);
  });
  binary("interval, difference", [](const interval& a, const interval& b) {
    return outward_error(a - b, rational(a.lower()) - rational(b.upper()), rational(a.upper()) - rational(b.lower()),
                         false);
  });
  binary("interval, width", [](const interval& a, const interval&) {
    return outward_error(width(a), rational(a.upper()) - rational(a.lower()), false);
  });
  binary("interval, product", [](const interval& a, const interval& b) {
    const ends e = ends_of(a, b, [](const big_rational& x, const big_rational& y) { return x * y; });
    return outward_error(a * b, e.low, e.high, e.further);
  });
  binary("interval, quotient", [](const interval& a, const interval& b) {
    if (contains(b, T(0)))
      return b.lower() < 0 && b.upper() > 0 && a != interval() ? a / b == interval::whole() ? 0.0 : 1.0 : 0.0;
    const ends e = ends_of(a, b, [](const big_rational& x, const big_rational& y) { return x / y; });
    return outward_error(a / b, e.low, e.high, e.further);
  });
  binary("interval, square", [](const interval& a, const interval&) {
    const ends e = ends_of(a, a, [](const big_rational& x, const big_rational& y) { return x * y; });
    const T inner = contains(a, T(0)) ? T(0) : std::fmin(std::fabs(a.lower()), std::fabs(a.upper()));
    return outward_error(square(a), rational(inner) * rational(inner), e.high, e.further);
  });
  binary("interval, middle", [](const interval& a, const interval&) { return contains(a, middle(a)) ? 0.0 : 1.0; });
  test::real root;
  sweep("interval, root", 0, [&](test::random& r, sizes which) {
    const T x = std::fabs(number<T>(r, which));
    const interval got = sqrt(interval(x));
    mpfr_set_d(root, static_cast<double>(x), MPFR_RNDN);
    mpfr_sqrt(root, root, MPFR_RNDN);
    const auto rounded = [&](mpfr_rnd_t mode) {
      return sizeof(T) == 8 ? mpfr_get_d(root, mode) : static_cast<double>(mpfr_get_flt(root, mode));
    };
    return static_cast<double>(got.lower()) == rounded(MPFR_RNDD) &&
                   static_cast<double>(got.upper()) == rounded(MPFR_RNDU)
               ? 0.0
               : 1.0;
  });
}

TEST_CASE_TEMPLATE("interval: numbers of all sizes", T, double, float) { sweep_intervals<T>(); }

}  // namespace sweeps
}  // namespace

#else
TEST_CASE("error bounds") { MESSAGE("skipped: MPFR was not found"); }
#endif

TEST_CASE("interval: operations on intervals contain what they do to their numbers") {
  test::random r(7);
  for (int i = 0; i < 20000; ++i) {
    const auto end = [&] { return static_cast<double>(r.integer(-6, 6)); };
    const double p = end(), q = end(), s = end(), t = end();
    const ival a(std::min(p, q), std::max(p, q)), b(std::min(s, t), std::max(s, t));
    const double x = test::between(r, a.lower(), a.upper()), y = test::between(r, b.lower(), b.upper());
    CHECK(contains(a + b, x + y));
    CHECK(contains(a - b, x - y));
    CHECK(contains(a * b, x * y));
    CHECK(contains(square(a), x * x));
    if (y != 0) CHECK(contains(a / b, x / y));
    CHECK(contains(hull(a, b), y));
  }
}
