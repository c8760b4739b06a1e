// SPDX-License-Identifier: MIT
// Errors of elementary functions in units in the last place, measured against MPFR; and runs over floats by their bits.
// Without MPFR (IRG_HAVE_MPFR undefined) the runs are skipped aloud.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>

#include <doctest/doctest.h>

#include "support/random.hpp"

#ifdef IRG_HAVE_MPFR
#include <mpfr.h>
#endif

namespace test {

/// Whether two numbers have the same bits, or are both NaN.
template <class T>
constexpr bool same(T a, T b) {
  if constexpr (sizeof(T) == 8)
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (a != a && b != b);
  else
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b) || (a != a && b != b);
}

/// x, hidden from the optimiser.
template <class T>
T at_run_time(T x) {
  volatile T hidden = x;
  return hidden;
}

inline bool is_release_tier() { return std::getenv("IRG_RELEASE_TIER") != nullptr; }

/// A finite double, every bit pattern equally likely.
inline double any_double(random& r) {
  for (;;) {
    const double x = std::bit_cast<double>(r.next());
    if (std::isfinite(x)) return x;
  }
}
inline double between(random& r, double low, double high) { return low + (high - low) * r.unit(); }
inline double either_sign(random& r, double x) { return (r.next() & 1) != 0 ? x : -x; }
/// A positive number whose logarithm to base 2 is uniform.
inline double of_exponent(random& r, double low, double high) { return std::exp2(between(r, low, high)); }

struct pair_of_doubles {
  double x = 0, y = 0;
};

/// The number of random arguments a run takes, from how many it takes per commit.
inline int count_of(int per_commit) { return is_release_tier() ? 100 * per_commit : per_commit; }

/// Bit patterns of floats, first to last without it, in steps.
struct float_range {
  std::uint64_t first, last, step;
};

/// All floats in the release tier, every `step`-th one else. IRG_SWEEP=3/16 in the environment names the fourth of
/// sixteen equal pieces (0/16 to 15/16), every float of it: a run over all of them can be cut.
inline float_range floats_to_test(std::uint64_t step) {
  constexpr std::uint64_t end = std::uint64_t{1} << 32;
  unsigned piece = 0, pieces = 0;
  const char* sweep = std::getenv("IRG_SWEEP");
  if (sweep != nullptr && std::sscanf(sweep, "%u/%u", &piece, &pieces) == 2 && piece < pieces)
    return {end / pieces * piece, piece + 1 == pieces ? end : end / pieces * (piece + 1), 1};
  return {0, end, is_release_tier() ? 1 : step};
}

#ifdef IRG_HAVE_MPFR

/// A number of 300 bits, and what it takes to compare with it.
class real {
public:
  real() { mpfr_init2(value_, 300); }
  explicit real(double x) : real() { mpfr_set_d(value_, x, MPFR_RNDN); }
  real(const real&) = delete;
  real& operator=(const real&) = delete;
  ~real() { mpfr_clear(value_); }
  operator mpfr_ptr() { return value_; }

private:
  mpfr_t value_;
};

/// |got - by_mpfr| in units in the last place of by_mpfr, rounded to T; 1e9 when one is finite and the other is not.
template <class T>
double ulp_error(T got, mpfr_ptr by_mpfr) {
  const T nearest = sizeof(T) == 4 ? static_cast<T>(mpfr_get_flt(by_mpfr, MPFR_RNDN))
                                   : static_cast<T>(mpfr_get_d(by_mpfr, MPFR_RNDN));
  if (!std::isfinite(nearest) || !std::isfinite(got)) return same(nearest, got) ? 0 : 1e9;
  int exponent = 0;
  std::frexp(nearest, &exponent);
  const int lowest = sizeof(T) == 4 ? -149 : -1074;
  const int last_place = exponent - std::numeric_limits<T>::digits;
  static real difference;
  mpfr_sub_d(difference, by_mpfr, static_cast<double>(got), MPFR_RNDN);
  mpfr_mul_2si(difference, difference, -(last_place < lowest ? lowest : last_place), MPFR_RNDN);
  return std::fabs(mpfr_get_d(difference, MPFR_RNDN));
}

/// The largest error of function(x, y) on `count` arguments of generate(random&), printed and compared with the bound.
template <class F, class Exact, class Generate>
void check_ulp(const char* what, double bound, F function, Exact by_mpfr, Generate generate, int count) {
  random r(0x5eed);
  double worst = 0;
  pair_of_doubles where;
  real x, y, result;
  for (int i = 0; i < count; ++i) {
    const pair_of_doubles p = generate(r);
    mpfr_set_d(x, p.x, MPFR_RNDN);
    mpfr_set_d(y, p.y, MPFR_RNDN);
    by_mpfr(result, x, y);
    const double error = ulp_error(function(p.x, p.y), result);
    if (error > worst) worst = error, where = p;
  }
  MESSAGE(std::string(what), ": ", worst, " ulp on ", count, " arguments");
  INFO(what, " of ", where.x, ", ", where.y);
  CHECK(worst <= bound);
}

/// Counts results that are not the nearest float. `want` is double's function, good enough but near the middle of two
/// floats, where MPFR decides: by_mpfr(out).
class float_results {
public:
  template <class Exact>
  void judge(float got, double want, Exact by_mpfr) {
    ++tested_;
    const float low = static_cast<float>(want - std::fabs(want) * 0x1p-40);
    const float high = static_cast<float>(want + std::fabs(want) * 0x1p-40);
    if (same(low, high) && same(got, low)) return;
    if (want != want || std::isinf(want)) {
      wrong_kind_ += same(got, static_cast<float>(want)) ? 0u : 1u;
      return;
    }
    by_mpfr(result_);
    const double error = ulp_error(got, result_);
    if (error > 0.5) ++misrounded_;
    if (error > worst_) worst_ = error;
  }
  void check(const char* what, double bound) const {
    MESSAGE(std::string(what), ", float: ", misrounded_, " of ", tested_, " not the nearest, worst ", worst_, " ulp");
    CHECK(worst_ <= bound);
    CHECK(wrong_kind_ == 0);
  }

private:
  real result_;
  std::uint64_t misrounded_ = 0, tested_ = 0, wrong_kind_ = 0;
  double worst_ = 0.5;
};

/// Runs over the floats that floats_to_test names.
template <class F, class Reference, class Exact>
void check_floats(const char* what, double bound, F function, Reference reference, Exact by_mpfr) {
  const float_range range = floats_to_test(99991);
  float_results results;
  real x;
  for (std::uint64_t bits = range.first; bits < range.last; bits += range.step) {
    const float argument = std::bit_cast<float>(static_cast<std::uint32_t>(bits));
    results.judge(function(argument), reference(static_cast<double>(argument)), [&](mpfr_ptr out) {
      mpfr_set_flt(x, argument, MPFR_RNDN);
      by_mpfr(out, x);
    });
  }
  results.check(what, bound);
}

/// Runs over 10^9 pairs of floats in the release tier, 20,000 else, a piece of them where IRG_SWEEP names one: pairs of
/// any bits, and pairs of positive and negative numbers within a factor of 2^span of 1.
template <class F, class Reference, class Exact>
void check_float_pairs(const char* what, double bound, F function, Reference reference, Exact by_mpfr, int span_x,
                       int span_y) {
  const float_range all = floats_to_test(1);
  const bool sweep = all.first != 0 || all.last != std::uint64_t{1} << 32;
  const double part = static_cast<double>(all.last - all.first) / 0x1p32;
  const std::uint64_t pairs = sweep || is_release_tier() ? static_cast<std::uint64_t>(part * 1e9) : 20'000;
  random r(0x5eed + all.first);
  const auto any = [](std::uint64_t bits) { return std::bit_cast<float>(static_cast<std::uint32_t>(bits)); };
  const auto within = [](std::uint64_t bits, int span) {
    const auto exponent = 127 - span + static_cast<int>((bits >> 33) % (2 * static_cast<unsigned>(span) + 1));
    return std::bit_cast<float>(static_cast<std::uint32_t>(bits & 0x807f'ffff) | static_cast<std::uint32_t>(exponent)
                                                                                     << 23);
  };
  float_results results;
  real a, b;
  for (std::uint64_t i = 0; i < pairs; ++i) {
    const std::uint64_t bits = r.next(), more = r.next();
    const float x = i % 4 == 0 ? any(bits) : within(bits, span_x), y = i % 4 == 0 ? any(more) : within(more, span_y);
    results.judge(function(x, y), reference(static_cast<double>(x), static_cast<double>(y)), [&](mpfr_ptr out) {
      mpfr_set_flt(a, x, MPFR_RNDN);
      mpfr_set_flt(b, y, MPFR_RNDN);
      by_mpfr(out, a, b);
    });
  }
  results.check(what, bound);
}

#endif

}  // namespace test

/// The function's result in constant evaluation has the bits of its result at run time.
#define CHECK_SAME_LIVES_1(function, x)                                        \
  do {                                                                         \
    constexpr auto in_constant_evaluation = function(x);                       \
    CHECK(test::same(in_constant_evaluation, function(test::at_run_time(x)))); \
  } while (false)
#define CHECK_SAME_LIVES_2(function, x, y)                                                           \
  do {                                                                                               \
    constexpr auto in_constant_evaluation = function(x, y);                                          \
    CHECK(test::same(in_constant_evaluation, function(test::at_run_time(x), test::at_run_time(y)))); \
  } while (false)
