// SPDX-License-Identifier: MIT
// The error bounds of functions of several numbers where these are of all sizes: each a random number times 2^k, k from
// the whole range of exponents, or one number far below or above the others.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>

#include <irg/math/compensated.hpp>
#include <irg/math/exact_matrix.hpp>
#include <irg/math/double_double.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/expansion.hpp>
#include <irg/math/homogeneous.hpp>
#include <irg/math/interval.hpp>
#include <irg/math/angle_between.hpp>
#include <irg/math/length.hpp>
#include <irg/math/polynomial.hpp>
#include <irg/math/roots.hpp>
#include <irg/math/solve_exact.hpp>
#include <irg/math/vec.hpp>
#include <irg/math/vector_projection.hpp>

#include "support/mixed_magnitudes.hpp"

#ifdef IRG_HAVE_MPFR

namespace {

using irg::vec;
using test::big_rational;

using test::mixed::all_sizes;
using test::mixed::number;
using test::mixed::rational;
using test::mixed::sizes;
using test::mixed::sweep;
using test::mixed::vector;

template <class T, int N>
void sweep_vectors(const std::string& type, double length_bound, double unit_bound) {
  test::real length_of_v, square, quotient;
  const auto measure = [&](const vec<T, N>& v) {
    mpfr_set_zero(length_of_v, 1);
    for (int i = 0; i < N; ++i) {
      mpfr_set_d(square, static_cast<double>(v[i]), MPFR_RNDN);
      mpfr_sqr(square, square, MPFR_RNDN);
      mpfr_add(length_of_v, length_of_v, square, MPFR_RNDN);
    }
    mpfr_sqrt(length_of_v, length_of_v, MPFR_RNDN);
  };
  sweep("length, " + type, length_bound, [&](test::random& r, sizes which) {
    const auto v = vector<T, N>(r, which);
    measure(v);
    return test::ulp_error(length(v), length_of_v);
  });
  sweep("try_normalized, " + type, unit_bound, [&](test::random& r, sizes which) {
    const auto v = vector<T, N>(r, which);
    const auto unit = try_normalized(v);
    measure(v);
    double worst = 0;
    for (int i = 0; unit && i < N; ++i) {
      mpfr_d_div(quotient, static_cast<double>(v[i]), length_of_v, MPFR_RNDN);
      worst = std::fmax(worst, test::ulp_error((*unit)[i], quotient));
    }
    return worst;
  });
}

// The T nearest to x, ties to even.
template <class T>
T nearest_to(mpfr_ptr x) {
  return sizeof(T) == 4 ? static_cast<T>(mpfr_get_flt(x, MPFR_RNDN)) : static_cast<T>(mpfr_get_d(x, MPFR_RNDN));
}
template <class T>
double missed(T got, mpfr_ptr want) {
  return got == nearest_to<T>(want) ? 0 : 1;
}

int sign_of(mpfr_ptr x) { return (mpfr_sgn(x) > 0) - (mpfr_sgn(x) < 0); }

// Wide enough for sums of products of two numbers, exactly.
template <class T>
struct wide : test::real {
  wide() { mpfr_set_prec(*this, sizeof(T) == 8 ? 4400 : 800); }
};

// The product of numbers added to a sum.
template <class... T>
void add_product(mpfr_ptr sum, double first, T... others) {
  static test::real product;
  mpfr_set_d(product, first, MPFR_RNDN);
  (mpfr_mul_d(product, product, static_cast<double>(others), MPFR_RNDN), ...);
  mpfr_add(sum, sum, product, MPFR_RNDN);
}
template <class T, int N>
void set_dot(mpfr_ptr out, const vec<T, N>& a, const vec<T, N>& b) {
  static wide<T> sum;
  mpfr_set_zero(sum, 1);
  for (int i = 0; i < N; ++i) add_product(sum, static_cast<double>(a[i]), b[i]);
  mpfr_set(out, sum, MPFR_RNDN);
}
template <class T, int N>
void set_length(mpfr_ptr out, const vec<T, N>& v) {
  set_dot(out, v, v);
  mpfr_sqrt(out, out, MPFR_RNDN);
}
template <class T>
void set_cross_length(mpfr_ptr out, const vec<T, 3>& a, const vec<T, 3>& b) {
  static wide<T> minor;
  static test::real square;
  mpfr_set_zero(out, 1);
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    mpfr_set_zero(minor, 1);
    add_product(minor, static_cast<double>(a[i]), b[j]);
    add_product(minor, -static_cast<double>(a[j]), b[i]);
    mpfr_set(square, minor, MPFR_RNDN);
    mpfr_fma(out, square, square, out, MPFR_RNDN);
  }
  mpfr_sqrt(out, out, MPFR_RNDN);
}

// A vector, and another that is at right angles to it, parallel to it, both nearly, or neither.
template <class T, int N>
vec<T, N> beside(test::random& r, const vec<T, N>& a, sizes which) {
  const auto other = vector<T, N>(r, which);
  const std::int64_t how = r.integer(0, 4);
  if (how > 1) return other;
  vec<T, N> b{};
  const T factor = static_cast<T>(r.unit() + 0.5);
  if (how == 0) {
    for (int i = 0; i < N; ++i) b[i] = a[i] * factor;
  } else {
    b[0] = -a[1] * factor, b[1] = a[0] * factor;
  }
  if (r.integer(0, 1) == 0) b[N - 1] = other[N - 1];
  return b == vec<T, N>{} ? other : b;
}

template <class T, int N>
void sweep_projections(const std::string& type) {
  test::real dot, a_length, b_length, exact, off;
  const auto judge = [&](T got, mpfr_ptr size) {
    mpfr_sub_d(off, exact, static_cast<double>(got), MPFR_RNDN);
    mpfr_mul_2si(off, off, 100, MPFR_RNDN);
    return mpfr_cmpabs(off, size) <= 0 ? 0 : test::ulp_error(got, exact);
  };
  const auto measure = [&](const vec<T, N>& a, const vec<T, N>& b) {
    set_dot(dot, a, b), set_length(a_length, a), set_length(b_length, b);
  };
  sweep("scalar_projection, " + type, 1.01, [&](test::random& r, sizes which) {
    const auto b = vector<T, N>(r, which), a = beside<T, N>(r, b, all_sizes[r.integer(0, 3)]);
    const auto got = scalar_projection(a, b);
    if (b == vec<T, N>{} || !got) return b == vec<T, N>{} && !got ? 0 : 1e9;
    measure(a, b);
    mpfr_div(exact, dot, b_length, MPFR_RNDN);
    return judge(*got, a_length);
  });
  sweep("vector_projection, " + type, 1.01, [&](test::random& r, sizes which) {
    const auto b = vector<T, N>(r, which), a = beside<T, N>(r, b, all_sizes[r.integer(0, 3)]);
    const auto got = vector_projection(a, b);
    if (b == vec<T, N>{} || !got) return b == vec<T, N>{} && !got ? 0 : 1e9;
    measure(a, b);
    double worst = 0;
    for (int i = 0; i < N; ++i) {
      mpfr_sqr(exact, b_length, MPFR_RNDN);
      mpfr_div(exact, dot, exact, MPFR_RNDN);
      mpfr_mul_d(exact, exact, static_cast<double>(b[i]), MPFR_RNDN);
      worst = std::fmax(worst, judge((*got)[i], a_length));
    }
    return worst;
  });
  test::real one(1);
  sweep("cosine_between, " + type, 0.51, [&](test::random& r, sizes which) {
    const auto b = vector<T, N>(r, which), a = beside<T, N>(r, b, all_sizes[r.integer(0, 3)]);
    const auto got = cosine_between(a, b);
    const bool none = a == vec<T, N>{} || b == vec<T, N>{};
    if (none || !got) return none && !got ? 0 : 1e9;
    measure(a, b);
    mpfr_div(exact, dot, a_length, MPFR_RNDN);
    mpfr_div(exact, exact, b_length, MPFR_RNDN);
    return *got >= -1 && *got <= 1 ? judge(*got, one) : 1e9;
  });
  sweep("dot_sign, " + type, 0, [&](test::random& r, sizes which) {
    const auto b = vector<T, N>(r, which), a = beside<T, N>(r, b, all_sizes[r.integer(0, 3)]);
    set_dot(dot, a, b);
    return dot_sign(a, b) == sign_of(dot) ? 0 : 1;
  });
}

template <class T, int N>
void sweep_angles(const std::string& type) {
  test::real across, along, exact;
  sweep("angle_between, " + type, 4, [&](test::random& r, sizes which) {
    const auto b = vector<T, N>(r, which), a = beside<T, N>(r, b, all_sizes[r.integer(0, 3)]);
    const auto in_space = [](const vec<T, N>& v) { return vec<T, 3>{v[0], v[1], N == 3 ? v[N - 1] : T(0)}; };
    set_cross_length(across, in_space(a), in_space(b));
    set_dot(along, a, b);
    mpfr_atan2(exact, across, along, MPFR_RNDN);
    if (a == vec<T, N>{} || b == vec<T, N>{}) mpfr_set_zero(exact, 1);
    return test::ulp_error(irg::angle_between(a, b), exact);
  });
}

// A number in two words; the second is of any size that goes with the first one.
template <class T>
irg::double_word<T> two_words(test::random& r, sizes which) {
  const T high = number<T>(r, which);
  const T half_place = (std::nextafter(std::fabs(high), T(HUGE_VAL)) - std::fabs(high)) / 2;
  const int down = r.integer(0, 1) == 0 ? 0 : static_cast<int>(r.integer(0, 60));
  const auto words = irg::two_sum(high, static_cast<T>(std::ldexp(half_place, -down) * static_cast<T>(r.unit() - 0.5)));
  return {words.value, words.error};
}
template <class T>
big_rational rational(const irg::double_word<T>& x) {
  return rational(x.high) + rational(x.low);
}
// The relative error in units of u^2; 0 where the absolute one is at most twice the smallest number.
template <class T>
double error_in_words(const irg::double_word<T>& got, const big_rational& want) {
  if (!std::isfinite(got.high)) return test::error_in_ulp(got.high, want);
  if (got.high != got.high + got.low) return 1e9;
  const big_rational off = abs(rational(got) - want);
  if (!(rational(2 * std::numeric_limits<T>::denorm_min()) < off)) return 0;
  if (want.sign() == 0) return 1e9;
  return (off / abs(want)).times_power_of_two(2 * std::numeric_limits<T>::digits).rounded();
}

template <class T>
void sweep_double_words() {
  using words = irg::double_word<T>;
  const auto binary = [](const char* what, double bound, auto f) {
    sweep(what, bound, [&](test::random& r, sizes which) {
      const words x = two_words<T>(r, which), y = two_words<T>(r, r.integer(0, 1) == 0 ? which : sizes::one_apart);
      return f(x, y);
    });
  };
  const auto error = [](const words& got, const big_rational& want) { return error_in_words(got, want); };
  binary("double_word, sum", 3.001, [&](words x, words y) { return error(x + y, rational(x) + rational(y)); });
  binary("double_word, difference", 3.001, [&](words x, words y) { return error(x - y, rational(x) - rational(y)); });
  binary("double_word, product", 5, [&](words x, words y) { return error(x * y, rational(x) * rational(y)); });
  binary("double_word, sum with one word", 2,
         [&](words x, words y) { return error(x + y.high, rational(x) + rational(y.high)); });
  binary("double_word, product with one word", 3,
         [&](words x, words y) { return error(x * y.high, rational(x) * rational(y.high)); });
  binary("double_word, quotient", 15.001, [&](words x, words y) {
    if (y.high == 0) return 0.0;
    return error(x / y, rational(x) / rational(y));
  });
  test::real exact, off;
  sweep("double_word, root", 25.0 / 8, [&](test::random& r, sizes which) {
    const words x = abs(two_words<T>(r, which)), got = sqrt(x);
    mpfr_set_d(exact, static_cast<double>(x.high), MPFR_RNDN);
    mpfr_add_d(exact, exact, static_cast<double>(x.low), MPFR_RNDN);
    mpfr_sqrt(exact, exact, MPFR_RNDN);
    mpfr_sub_d(off, exact, static_cast<double>(got.high), MPFR_RNDN);
    mpfr_sub_d(off, off, static_cast<double>(got.low), MPFR_RNDN);
    if (x.high == 0) return got.high == 0 ? 0 : 1e9;
    mpfr_div(off, off, exact, MPFR_RNDN);
    return std::fabs(std::ldexp(mpfr_get_d(off, MPFR_RNDN), 2 * std::numeric_limits<T>::digits));
  });
}

template <class T, int N>
big_rational rational(const irg::expansion<T, N>& e) {
  big_rational sum = 0;
  for (int i = 0; i < e.size; ++i) sum = sum + rational(e.parts[i]);
  return sum;
}
// A number of such a size that products of n of them are exact in expansions.
template <class T>
T number_for_products(test::random& r, sizes which, int n) {
  constexpr int low = std::numeric_limits<T>::min_exponent - std::numeric_limits<T>::digits;
  constexpr int high = sizeof(T) == 8 ? 1000 : 120;
  for (;;) {
    const T x = number<T>(r, which == sizes::subnormal ? sizes::all : which);
    if (x == 0 || (std::fabs(x) <= std::ldexp(T(1), high / n) &&
                   std::fabs(x) >= std::ldexp(T(1), std::numeric_limits<T>::digits + low / n)))
      return x;
    if (which == sizes::roots_of_largest) return std::ldexp(x, -std::ilogb(x));
  }
}

// What difference_of_products gives: 1e9 where it is no number, else its error in ulp, less what underflow may add.
template <class T>
double error_of_difference(T a, T b, T c, T d) {
  const big_rational left = rational(a) * rational(b), right = rational(c) * rational(d), want = left - right;
  const T got = irg::difference_of_products(a, b, c, d);
  if (want.sign() == 0) return got == 0 ? 0 : 1e9;
  const big_rational least(0x1p-900);
  const bool is_small = sizeof(T) == 8 && abs(left) < least && abs(right) < least;
  if (is_small && std::isfinite(got) && !(big_rational(0x1p-1073) < abs(rational(got) - want))) return 0;
  return test::error_in_ulp(got, want);
}

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

// Whether x is 0 or neither near the smallest nor near the largest numbers.
template <class T>
bool is_inside(const big_rational& x) {
  constexpr T least = std::numeric_limits<T>::min() * T(0x1p60f), most = std::numeric_limits<T>::max() * T(0x1p-4f);
  return x.sign() == 0 || (rational(least) < abs(x) && abs(x) < rational(most));
}

template <class T>
void sweep_polynomials() {
  sweep("evaluate_polynomial, values and derivatives", 1, [](test::random& r, sizes which) {
    std::array<T, 4> c{};
    for (T& v : c) v = number<T>(r, which);
    const T x = number<T>(r, sizes::one_apart);
    const auto got = irg::evaluate_polynomial_with_derivative(c, x);
    big_rational value = 0, slope = 0, size = 0, slope_size = 0;
    bool is_usual = got.value == irg::evaluate_polynomial(c, x);
    if (!is_usual) return 1e9;
    for (std::size_t i = 4; i-- > 0;) {
      is_usual = is_usual && is_inside<T>(slope * rational(x)) && is_inside<T>(value * rational(x));
      slope = slope * rational(x) + value, slope_size = slope_size * abs(rational(x)) + size;
      value = value * rational(x) + rational(c[i]), size = size * abs(rational(x)) + abs(rational(c[i]));
      is_usual = is_usual && is_inside<T>(slope) && is_inside<T>(value);
    }
    if (!is_usual || size.sign() == 0 || slope_size.sign() == 0) return 0.0;
    const big_rational bound = rational(std::numeric_limits<T>::epsilon()) * 3;  // 2n u
    return std::fmax((abs(rational(got.value) - value) / (size * bound)).rounded(),
                     (abs(rational(got.derivative) - slope) / (slope_size * bound)).rounded());
  });
  sweep("evaluate_polynomial_accurate", 1, [](test::random& r, sizes which) {
    std::array<T, 4> c{};
    for (T& v : c) v = number<T>(r, which);
    const T x = number<T>(r, sizes::one_apart);
    big_rational value = 0, size = 0;
    for (std::size_t i = 4; i-- > 0;) {
      value = value * rational(x) + rational(c[i]);
      size = size * abs(rational(x)) + abs(rational(c[i]));
    }
    const T got = irg::evaluate_polynomial_accurate(c, x);
    const double ulp = test::error_in_ulp(got, value);
    if (ulp <= 1 || size < abs(value) * big_rational(1e14)) return ulp;
    const big_rational bound = abs(value) * rational(std::numeric_limits<T>::epsilon()) + size * big_rational(0x9p-104);
    return abs(rational(got) - value) < bound ? 1 : ulp;
  });
  sweep("polynomial_sign", 0, [](test::random& r, sizes which) {
    std::array<T, 3> c{};
    for (T& v : c) v = number<T>(r, which);
    const T x = number<T>(r, sizes::one_apart);
    if (r.integer(0, 1) == 0) c[0] = static_cast<T>(-(c[1] + c[2] * x) * x);
    if (!std::isfinite(c[0])) return 0;
    const big_rational value = (rational(c[2]) * rational(x) + rational(c[1])) * rational(x) + rational(c[0]);
    return irg::polynomial_sign(c, x) == value.sign() ? 0 : 1;
  });
}

template <class T>
void sweep_sums() {
  const auto within = [](T got, const big_rational& want, const big_rational& size) {
    const double ulp = test::error_in_ulp(got, want);
    if (ulp <= 1 || size < abs(want) * big_rational(1e14)) return ulp;
    return abs(rational(got) - want) < size * big_rational(0x1p-100) ? 1 : ulp;
  };
  sweep("sum_accurate", 1, [](test::random& r, sizes which) {
    std::array<T, 6> x{};
    big_rational sum = 0, size = 0;
    for (std::size_t i = 0; i < 6; ++i) {
      x[i] = i > 3 && r.integer(0, 1) == 0 ? -x[i - 3] * static_cast<T>(1 + r.unit() * 0x1p-20) : number<T>(r, which);
      sum = sum + rational(x[i]), size = size + abs(rational(x[i]));
    }
    return size < abs(sum) * big_rational(1e14) ? test::error_in_ulp(irg::sum_accurate(std::span<const T>(x)), sum) : 0;
  });
  sweep("dot_accurate", 1, [&](test::random& r, sizes which) {
    const auto a = vector<T, 3>(r, which), b = beside<T, 3>(r, a, all_sizes[r.integer(0, 3)]);
    big_rational dot = 0, size = 0;
    for (int i = 0; i < 3; ++i) {
      dot = dot + rational(a[i]) * rational(b[i]);
      size = size + abs(rational(a[i]) * rational(b[i])) * 2;
    }
    return within(dot_accurate(a, b), dot, size);
  });
  // The plain ones: the error in the stated units, where no product underflows.
  sweep("dot_fast, cross_fast", 1, [](test::random& r, sizes which) {
    const auto a = vector<T, 3>(r, which), b = vector<T, 3>(r, which);
    big_rational dot = 0, size = 0, product[3][3];
    const big_rational u = rational(std::numeric_limits<T>::epsilon() / 2);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        product[i][j] = rational(a[i]) * rational(b[j]);
        if (!is_inside<T>(product[i][j])) return 0.0;
        if (i == j) dot = dot + product[i][j], size = size + abs(product[i][j]);
      }
    // Coordinates that are zero leave nothing to be off by.
    const auto share = [](const big_rational& off, const big_rational& bound) {
      return off.sign() == 0 ? 0.0 : bound.sign() == 0 ? 1e9 : (off / bound).rounded();
    };
    double worst = share(abs(rational(dot_fast(a, b)) - dot), size * u * 3);
    const auto cross = cross_fast(a, b);
    for (int k = 0; k < 3; ++k) {
      const big_rational& left = product[(k + 1) % 3][(k + 2) % 3];
      const big_rational& right = product[(k + 2) % 3][(k + 1) % 3];
      const big_rational off = abs(rational(cross[k]) - (left - right));
      worst = std::fmax(worst, share(off, (abs(left) + abs(right)) * u * 2));
    }
    return worst;
  });
}

// A vector whose largest coordinate is of the sizes that the fast functions are for.
template <class T, int N>
vec<T, N> vector_of_moderate_length(test::random& r, sizes which) {
  constexpr int reach = sizeof(T) == 8 ? 499 : 59;
  auto v = vector<T, N>(r, which);
  int largest = 0;
  for (int i = 1; i < N; ++i)
    if (std::fabs(v[i]) > std::fabs(v[largest])) largest = i;
  if (v[largest] == 0) return v;
  const int by = std::max(-reach, std::min(reach, std::ilogb(v[largest]))) - std::ilogb(v[largest]);
  for (int i = 0; i < N; ++i) v[i] = std::ldexp(v[i], by);
  return v;
}
template <class T>
void sweep_fast_lengths() {
  test::real exact, quotient;
  sweep("length_fast", 1.26, [&](test::random& r, sizes which) {
    const auto v = vector_of_moderate_length<T, 3>(r, which);
    set_length(exact, v);
    return test::ulp_error(length_fast(v), exact);
  });
  sweep("normalized_fast", 5, [&](test::random& r, sizes which) {
    const auto v = vector_of_moderate_length<T, 3>(r, which), unit = normalized_fast(v);
    if (v == vec<T, 3>{}) return unit == v ? 0.0 : 1e9;
    set_length(exact, v);
    double worst = 0;
    for (int i = 0; i < 3; ++i) {
      mpfr_d_div(quotient, static_cast<double>(v[i]), exact, MPFR_RNDN);
      worst = std::fmax(worst, test::ulp_error(unit[i], quotient));
    }
    return worst;
  });
}

template <class T, int N>
void sweep_homogeneous() {
  using H = irg::hpoint<T, N>;
  const auto any = [](test::random& r, sizes which) {
    H p{};
    for (int i = 0; i <= N; ++i) p[i] = r.integer(0, 9) == 0 ? T(0) : number<T>(r, which);
    return p;
  };
  sweep("try_to_cartesian", 0, [&](test::random& r, sizes which) {
    const H p = any(r, which);
    const auto got = try_to_cartesian(p);
    bool fits = p[N] != 0, right = true;
    for (int i = 0; fits && i < N; ++i) {
      const T want = test::nearest<T>(rational(p[i]) / rational(p[N]));
      fits = std::isfinite(want);
      right = right && (!got || (*got)[i] == want);
    }
    return fits == got.has_value() && (!fits || right) ? 0 : 1;
  });
  sweep("to_homogeneous", 0, [&](test::random& r, sizes which) {
    const auto v = vector<T, N>(r, which);
    const T h = number<T>(r, all_sizes[r.integer(0, 3)]);
    if (h == 0) return 0;
    const H p = to_homogeneous(irg::to_point(v), h);
    bool right = p[N] == h;
    for (int i = 0; i < N; ++i) right = right && p[i] == test::nearest<T>(rational(v[i]) * rational(h));
    return right ? 0 : 1;
  });
  sweep("same_position", 0, [&](test::random& r, sizes which) {
    const H p = any(r, which);
    H q = any(r, which);
    if (r.integer(0, 2) > 0) {  // p times a number, each coordinate rounded
      const T factor = r.integer(0, 1) == 0 ? T(3) : std::ldexp(T(1), static_cast<int>(r.integer(-100, 100)));
      for (int i = 0; i <= N; ++i) q[i] = p[i] * factor;
    }
    bool finite = true, p_is_zero = true, q_is_zero = true, same = true;
    for (int i = 0; i <= N; ++i) {
      finite = finite && std::isfinite(q[i]);
      p_is_zero = p_is_zero && p[i] == 0;
      q_is_zero = q_is_zero && q[i] == 0;
    }
    for (int i = 0; finite && i <= N; ++i)
      for (int j = 0; j < i; ++j) same = same && rational(p[i]) * rational(q[j]) == rational(p[j]) * rational(q[i]);
    return same_position(p, q) == (finite && same && !p_is_zero && !q_is_zero) ? 0 : 1;
  });
}

// Exactly, where the sum is wide enough: by Leibniz' formula.
template <int N, class Entry>
void set_determinant(mpfr_ptr out, Entry entry) {
  static test::real product;
  int order[static_cast<std::size_t>(N)];
  for (int i = 0; i < N; ++i) order[i] = i;
  mpfr_set_zero(out, 1);
  do {
    double sign = 1;
    for (int i = 0; i < N; ++i)
      for (int j = 0; j < i; ++j) sign = order[j] > order[i] ? -sign : sign;
    mpfr_set_d(product, sign, MPFR_RNDN);
    for (int i = 0; i < N; ++i) mpfr_mul_d(product, product, static_cast<double>(entry(i, order[i])), MPFR_RNDN);
    mpfr_add(out, out, product, MPFR_RNDN);
  } while (std::next_permutation(order, order + N));
}

// Cramer's rule for the unit vectors and for one more right side.
template <class T, int N>
void sweep_exact_systems(const std::string& type) {
  constexpr int bits = N * (sizeof(T) == 8 ? 2200 : 360) + 200;
  test::real determinant, numerator, quotient;
  for (mpfr_ptr x : {mpfr_ptr(determinant), mpfr_ptr(numerator), mpfr_ptr(quotient)}) mpfr_set_prec(x, bits);
  sweep("determinant_exact, inverse_exact, solve_exact, " + type, 0, [&](test::random& r, sizes which) {
    auto a = irg::generate_mat<T, N, N>([&](int, int) { return number<T>(r, which); });
    if (r.integer(0, 3) == 0)  // a row that is nearly, or exactly, another one times a number
      for (int c = 0; c < N; ++c) a(N - 1, c) = a(0, c) * T(0.75);
    const auto b = vector<T, N>(r, which);
    const auto with_b = irg::generate_mat<T, N, N + 1>([&](int i, int j) { return j == N ? b[i] : a(i, j); });
    set_determinant<N>(determinant, [&](int i, int j) { return a(i, j); });
    const auto undo = inverse_exact(a);
    const auto x = irg::solve_exact(with_b);
    const bool right = determinant_exact(a) == nearest_to<T>(determinant);
    if (!right || determinant_sign(a) != sign_of(determinant)) return 1;
    if (sign_of(determinant) == 0) return undo || x ? 1 : 0;
    bool fits[2]{true, true}, all_right[2]{true, true};
    for (int p = 0; p < N; ++p)
      for (int q = 0; q <= N; ++q) {
        set_determinant<N>(numerator, [&](int i, int j) {
          return j != p ? a(i, j) : q == N ? b[i] : i == q ? T(1) : T(0);
        });
        mpfr_div(quotient, numerator, determinant, MPFR_RNDN);
        const T want = nearest_to<T>(quotient);
        fits[q / N] = fits[q / N] && std::isfinite(want);
        all_right[q / N] = all_right[q / N] && (q == N ? x.x[p] == want : undo && (*undo)(p, q) == want);
      }
    const bool kinds = undo.has_value() == fits[0] && (x.kind == irg::solvability::unique) == fits[1];
    return kinds && (all_right[0] || !fits[0]) && (all_right[1] || !fits[1]) ? 0 : 1;
  });
}

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

}  // namespace

TEST_CASE("mixed magnitudes: lengths and directions") {
  sweep_vectors<double, 2>("2 doubles", 0.501, 1.51);
  sweep_vectors<double, 3>("3 doubles", 0.501, 1.51);
  sweep_vectors<double, 4>("4 doubles", 0.501, 1.51);
  sweep_vectors<double, 6>("6 doubles", 0.501, 1.51);
  sweep_vectors<float, 3>("3 floats", 0.501, 0.51);
  sweep_vectors<float, 4>("4 floats", 0.501, 0.51);
}

TEST_CASE_TEMPLATE("mixed magnitudes: sums, products, polynomials", T, double, float) {
  const auto missed = [](T got, const big_rational& want) { return got == test::nearest<T>(want) ? 0.0 : 1.0; };
  sweep("sum_exact", 0, [&](test::random& r, sizes which) {
    std::array<T, 5> x{};
    big_rational sum = 0;
    for (T& v : x) {
      v = number<T>(r, which);
      sum = sum + rational(v);
    }
    return missed(irg::sum_exact(std::span<const T>(x)), sum);
  });
  sweep("dot_exact", 0, [&](test::random& r, sizes which) {
    const auto a = vector<T, 3>(r, which), b = vector<T, 3>(r, all_sizes[r.integer(0, 3)]);
    big_rational sum = 0;
    for (int i = 0; i < 3; ++i) sum = sum + rational(a[i]) * rational(b[i]);
    return missed(dot_exact(a, b), sum);
  });
  sweep("cross_accurate", 1, [&](test::random& r, sizes which) {
    const auto a = vector<T, 3>(r, which), b = vector<T, 3>(r, which);
    const auto c = cross_accurate(a, b);
    return test::error_in_ulp(c[0], rational(a[1]) * rational(b[2]) - rational(a[2]) * rational(b[1]));
  });
  sweep("evaluate_polynomial_exact", 0, [&](test::random& r, sizes which) {
    std::array<T, 4> c{};
    for (T& v : c) v = number<T>(r, which);
    const T x = number<T>(r, sizes::one_apart);
    big_rational value = 0;
    for (std::size_t i = 4; i-- > 0;) value = value * rational(x) + rational(c[i]);
    return missed(irg::evaluate_polynomial_exact(c, x), value);
  });
}

TEST_CASE("mixed magnitudes: projections and angles") {
  sweep_projections<double, 3>("3 doubles");
  sweep_projections<float, 3>("3 floats");
  sweep_projections<float, 4>("4 floats");
  sweep_angles<double, 3>("3 doubles");
  sweep_angles<double, 2>("2 doubles");
  sweep_angles<float, 3>("3 floats");
  sweep_angles<float, 2>("2 floats");
}

TEST_CASE_TEMPLATE("mixed magnitudes: errors of sums and products", T, double, float) {
  const auto missing = [](T value, T error, const big_rational& want) {
    return rational(value) + rational(error) == want && value == test::nearest<T>(want) ? 0.0 : 1.0;
  };
  sweep("two_sum", 0, [&](test::random& r, sizes which) {
    const T a = number<T>(r, which), b = number<T>(r, all_sizes[r.integer(0, 3)]);
    const auto sum = irg::two_sum(a, b),
               fast = std::fabs(a) < std::fabs(b) ? irg::fast_two_sum(b, a) : irg::fast_two_sum(a, b);
    const big_rational want = rational(a) + rational(b);
    return missing(sum.value, sum.error, want) + missing(fast.value, fast.error, want);
  });
  sweep("two_product", 0, [&](test::random& r, sizes which) {
    const T a = number<T>(r, which), b = number<T>(r, all_sizes[r.integer(0, 3)]);
    const auto got = irg::two_product(a, b);
    const big_rational want = rational(a) * rational(b);
    if (!std::isfinite(got.value)) return got.error == 0 && got.value == test::nearest<T>(want) ? 0.0 : 1.0;
    return got.value == test::nearest<T>(want) && got.error == test::nearest<T>(want - rational(got.value)) ? 0.0 : 1.0;
  });
  sweep("split", 0, [&](test::random& r, sizes which) {
    const T x = number<T>(r, which);
    if (std::fabs(x) > (sizeof(T) == 8 ? T(0x1p995) : T(0x1p114))) return 0.0;
    const auto [high, low] = irg::split(x);
    return missing(high, low, rational(x)) == 0 || rational(high) + rational(low) == rational(x) ? 0.0 : 1.0;
  });
  sweep("difference_of_products", 1, [&](test::random& r, sizes which) {
    const T a = number<T>(r, which), b = number<T>(r, all_sizes[r.integer(0, 3)]);
    if (r.integer(0, 2) > 0) return error_of_difference(a, b, number<T>(r, which), number<T>(r, which));
    const T factor = std::ldexp(T(1), static_cast<int>(r.integer(-20, 0)));  // nearly the same product
    return std::fabs(a) < 1 ? error_of_difference(a, b, std::nextafter(a, T(0)) / factor, b * factor)
                            : error_of_difference(a, b, std::nextafter(a, T(0)) * factor, b);
  });
}

TEST_CASE_TEMPLATE("mixed magnitudes: numbers in several parts", T, double, float) {
  sweep_double_words<T>();
  sweep("expansion, sums", 1, [](test::random& r, sizes which) {
    irg::expansion<T, 4> e{};
    big_rational want = 0;
    const T a = number<T>(r, which), b = number<T>(r, which), c = number<T>(r, which), d = number<T>(r, which);
    e = irg::exact_sum_of(a, b) + irg::exact_difference_of(c, d);
    want = rational(a) + rational(b) + rational(c) - rational(d);
    if (!(rational(e) == want) || sign(e) != want.sign() || !(rational(compress(e)) == want)) return 1e9;
    const auto small = compress(e);
    const T last = small.size == 0 ? T(0) : small.parts[small.size - 1];
    return std::fmax(test::error_in_ulp(estimate(e), want), test::error_in_ulp(last, want));
  });
  sweep("expansion, products", 1, [](test::random& r, sizes which) {
    const T a = number_for_products<T>(r, which, 4), b = number_for_products<T>(r, which, 4);
    const T c = number_for_products<T>(r, which, 4), d = number_for_products<T>(r, which, 4);
    const auto e = (irg::exact_product_of(a, b) + d * d) * (irg::exact_sum_of(c, d) * a);
    const big_rational want = (rational(a) * rational(b) + rational(d * d)) * (rational(c) + rational(d)) * rational(a);
    if (!(rational(e) == want) || sign(e) != want.sign()) return 1e9;
    return test::error_in_ulp(estimate(e), want);
  });
}

TEST_CASE_TEMPLATE("mixed magnitudes: intervals", T, double, float) { sweep_intervals<T>(); }

TEST_CASE_TEMPLATE("mixed magnitudes: sums and polynomials in twice the precision", T, double, float) {
  sweep_sums<T>();
  sweep_polynomials<T>();
  sweep_fast_lengths<T>();
}

TEST_CASE_TEMPLATE("mixed magnitudes: homogeneous coordinates", T, double, float) { sweep_homogeneous<T, 3>(); }

TEST_CASE("mixed magnitudes: exact systems") {
  sweep_exact_systems<double, 2>("2 doubles");
  sweep_exact_systems<float, 3>("3 floats");
}

TEST_CASE_TEMPLATE("mixed magnitudes: roots", T, double, float) {
  sweep_quadratics<T>();
  sweep_cubics<T>();
}

#endif
