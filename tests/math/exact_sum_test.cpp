// SPDX-License-Identifier: MIT
#include <irg/math/exact_sum.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <utility>
#include <vector>

#ifdef IRG_HAVE_MPFR
#include <gmp.h>
#endif

#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::exact_accumulator;

namespace {

constexpr double huge = std::numeric_limits<double>::max(), tiny = 0x1p-1074;
constexpr double infinite = std::numeric_limits<double>::infinity();

constexpr bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

// The sum of products of pairs: the first list is added, the second subtracted.
struct pair {
  double x, y;
};
template <int K>
constexpr exact_accumulator<K> sum_of(std::initializer_list<pair> add, std::initializer_list<pair> subtract) {
  exact_accumulator<K> s;
  for (const auto& [x, y] : add) s.add(x, y);
  for (const auto& [x, y] : subtract) s.subtract(x, y);
  return s;
}
constexpr int sign(std::initializer_list<pair> add, std::initializer_list<pair> subtract) {
  const auto s = sum_of<2>(add, subtract), copied = s;
  const auto wide = sum_of<5>(add, subtract);
  return s.sign() == wide.sign() && copied.sign() == s.sign() && same_bits(wide.rounded(), s.rounded()) ? s.sign() : 99;
}
template <class... X>
constexpr double rounded_sum(X... x) {
  exact_accumulator<1> s;
  (s.add(x), ...);
  return s.rounded();
}
template <class... X>
constexpr double rounded_product(X... x) {
  exact_accumulator<5> s;
  s.add(x...);
  return s.rounded();
}

}  // namespace

TEST_CASE("exact_accumulator: signs of sums of products") {
  CHECK_BOTH(sign({}, {}) == 0);
  CHECK_BOTH(sign({{0, huge}, {-0.0, 1}}, {}) == 0);
  CHECK_BOTH(sign({{huge, huge}, {tiny, tiny}}, {{huge, huge}}) == 1);
  CHECK_BOTH(sign({{huge, huge}}, {{huge, huge}, {tiny, tiny}}) == -1);
  CHECK_BOTH(sign({{huge, -huge}, {huge, huge}}, {}) == 0);
  CHECK_BOTH(sign({{tiny, -tiny}}, {}) == -1);
  CHECK_BOTH(sign({{0x1p53 - 1, 0x1p53 + 2}}, {{0x1p53, 0x1p53}, {0x1p53, 1}}) == -1);
  CHECK_BOTH(sign({{3, 5}}, {{15, 1}}) == 0);
  CHECK_BOTH(sign({{huge, huge}, {huge, huge}, {huge, huge}, {huge, huge}}, {{tiny, 1}}) == 1);
  CHECK_BOTH(sign({{tiny, 1}}, {{huge, huge}, {huge, huge}, {huge, huge}}) == -1);
}

TEST_CASE("exact_accumulator: rounded to nearest, ties to even") {
  CHECK_BOTH(same_bits(rounded_sum(0.0), 0.0));
  CHECK_BOTH(same_bits(rounded_sum(-0.0, -0.0), 0.0));
  CHECK_BOTH(rounded_sum(1.0, 0x1p-53) == 1.0);
  CHECK_BOTH(rounded_sum(1.0, 0x1p-53, tiny) == 1 + 0x1p-52);
  CHECK_BOTH(rounded_sum(1 + 0x1p-52, 0x1p-53) == 1 + 0x1p-51);
  CHECK_BOTH(rounded_sum(1 + 0x1p-52, 0x1p-53, -tiny) == 1 + 0x1p-52);
  CHECK_BOTH(rounded_sum(-1.0, 0x1p-54, tiny) == -1 + 0x1p-53);
  CHECK_BOTH(rounded_sum(huge, -huge, tiny) == tiny);
  CHECK_BOTH(rounded_sum(huge, 0x1p970) == infinite);  // half of the last place beyond the largest double
  CHECK_BOTH(rounded_sum(huge, 0x1p970, -tiny) == huge);
  CHECK_BOTH(rounded_sum(-huge, -huge) == -infinite);
  CHECK_BOTH(rounded_sum(huge, huge, -huge) == huge);
  CHECK_BOTH(rounded_product(tiny, 0.5) == 0.0);  // a tie, to the even zero
  CHECK_BOTH(rounded_product(tiny, 0.75) == tiny);
  CHECK_BOTH(rounded_product(3 * tiny, 0.5) == 2 * tiny);
  CHECK_BOTH(rounded_product(0x1.fffffffffffffp-1022, 0.5) == 0x1p-1022);  // from the subnormals to the normals
  CHECK_BOTH(rounded_product(huge, huge, tiny, tiny) == 0x1.ffffffffffffep-101);
  CHECK_BOTH(rounded_product(huge, huge, huge, huge, huge) == infinite);
  CHECK_BOTH(same_bits(rounded_product(-tiny, tiny, tiny, tiny, tiny), -0.0));
}

TEST_CASE("exact_accumulator: many terms") {
  // Each of them reaches far into a word of which it is the top.
  constexpr double v = 0x1.fffffffffffffp-959;
  exact_accumulator<1> plus, minus;
  for (int i = 0; i < 5000; ++i) plus.add(v), minus.subtract(v);
  CHECK(plus.sign() == 1);
  CHECK(minus.sign() == -1);
  CHECK(plus.rounded() == 5000 * v);
  CHECK(minus.rounded() == -5000 * v);
}

TEST_CASE("exact_accumulator: a sum times a number is the sum of the products with it") {
  test::random r(31);
  const auto any = [&] {
    for (;;) {
      const auto bits = r.integer(0, 3) == 0 ? r.next() & 0x800fffffffffffffu : r.next();
      if (const auto x = std::bit_cast<double>(bits); x - x == 0) return r.integer(0, 9) == 0 ? 0 : x;
    }
  };
  for (int i = 0; i < 20000; ++i) {
    const double x = i == 0 ? std::numeric_limits<double>::max() : any();
    irg::exact_accumulator<2> sum;
    irg::exact_accumulator<3> all;
    for (int k = 0; k < 1 + i % 5; ++k) {
      const double a = i == 0 ? x : any(), b = i == 0 ? x : i % 3 == 0 ? 1 : any();
      sum.add(a, b);
      all.add(a, b, x);
    }
    irg::exact_accumulator<3> product;
    product.add(1.0);
    product.add(sum, x);
    all.add(1.0);
    REQUIRE((same_bits(product.rounded(), all.rounded()) && product.sign() == all.sign()));
    product.add(sum, -x);
    product.subtract(1.0);
    REQUIRE(product.sign() == 0);
  }
  constexpr auto negative = [] {
    irg::exact_accumulator<1> sum;
    sum.add(1.0), sum.subtract(0x1p64);
    irg::exact_accumulator<2> product;
    product.add(sum, -3.0);
    return product.rounded();
  };
  CHECK_BOTH(negative() == 0x1p64 * 3);
}

TEST_CASE("exact_accumulator: against 128-bit integers") {
  test::random random(8);
  for (int i = 0; i < 100'000; ++i) {
    __extension__ typedef __int128 wide;
    exact_accumulator<2> s;
    wide expected = 0;
    const double scale = std::ldexp(1.0, static_cast<int>(random.integer(-1000, 900)));
    for (int k = 0; k < 4; ++k) {
      const std::int64_t x = random.integer(-5, 5) * (std::int64_t{1} << random.integer(0, 50)) + random.integer(-1, 1);
      const std::int64_t y =
          k % 2 == 0 ? random.integer(-9, 9) : random.integer(-(std::int64_t{1} << 52), std::int64_t{1} << 52);
      s.add(static_cast<double>(x) * scale, static_cast<double>(y));
      expected += wide{x} * y;
    }
    REQUIRE(s.sign() == (expected < 0 ? -1 : expected > 0 ? 1 : 0));
  }
}

#ifdef IRG_HAVE_MPFR

namespace {

// A sum of products as a GMP integer, in units of 2^(-1074 K).
template <int K>
class oracle {
public:
  oracle() { mpz_inits(sum_, term_, factor_, nullptr); }
  ~oracle() { mpz_clears(sum_, term_, factor_, nullptr); }
  oracle(const oracle&) = delete;
  oracle& operator=(const oracle&) = delete;

  void add(const std::vector<double>& x, int sign) {
    mpz_set_si(term_, sign);
    unsigned long place = static_cast<unsigned long>(1074 * (K - static_cast<int>(x.size())));
    for (const double v : x) {
      int exponent = 0;
      const double significand = std::frexp(v, &exponent);
      if (v == 0) return;
      const int least = exponent - 53 < -1074 ? -1074 : exponent - 53;
      mpz_set_d(factor_, std::ldexp(significand, exponent - least));
      mpz_mul(term_, term_, factor_);
      place += static_cast<unsigned long>(least + 1074);
    }
    mpz_mul_2exp(term_, term_, place);
    mpz_add(sum_, sum_, term_);
  }
  int sign() const { return mpz_sgn(sum_); }

  double rounded() {
    if (mpz_sgn(sum_) == 0) return 0;
    mpz_abs(term_, sum_);
    const auto bits = static_cast<int>(mpz_sizeinbase(term_, 2));
    int last = bits - 53;
    if (last < 1074 * (K - 1)) last = 1074 * (K - 1);
    mpz_set_ui(factor_, 1);
    if (last > 0) mpz_mul_2exp(factor_, factor_, static_cast<unsigned long>(last - 1));
    if (last > 0) mpz_add(term_, term_, factor_);  // half up; then a tie that became odd goes down by one
    const bool tie = last > 0 && mpz_scan1(term_, 0) >= static_cast<mp_bitcnt_t>(last);
    mpz_fdiv_q_2exp(term_, term_, static_cast<mp_bitcnt_t>(last));
    if (tie && mpz_odd_p(term_)) mpz_sub_ui(term_, term_, 1);
    return std::ldexp(static_cast<double>(mpz_sgn(sum_)) * mpz_get_d(term_), last - 1074 * K);
  }

private:
  mpz_t sum_, term_, factor_;
};

enum class exponents { like, subnormal, any };

template <int K>
void compare(exponents which, int trials, std::uint64_t seed) {
  test::random random(seed);
  long zeros = 0;
  for (int i = 0; i < trials; ++i) {
    exact_accumulator<K> s;
    oracle<K> expected;
    std::vector<std::pair<std::vector<double>, int>> terms;
    const auto number = [&] {
      double v = static_cast<double>(random.integer(-(std::int64_t{1} << 53), std::int64_t{1} << 53));
      if (random.integer(0, 3) == 0) v = static_cast<double>(random.integer(-3, 3));
      return which == exponents::like        ? v
             : which == exponents::subnormal ? static_cast<double>(random.integer(-9, 9)) * tiny
                                             : std::ldexp(v, static_cast<int>(random.integer(-1120, 970)));
    };
    for (std::int64_t k = random.integer(1, 6); k > 0; --k) {
      std::vector<double> x(static_cast<std::size_t>(random.integer(1, K)), 0.0);
      for (double& v : x) v = number();
      const int sign = random.integer(0, 1) == 0 ? -1 : 1;
      terms.push_back({x, sign});
      if (random.integer(0, 1) == 0) terms.push_back({x, -sign});  // so that sums cancel
      if (random.integer(0, 2) == 0) terms.push_back({{which == exponents::any ? tiny : 1.0}, sign});
    }
    for (const auto& [x, sign] : terms) {
      expected.add(x, sign);
      const auto put = [&](auto... v) { sign > 0 ? s.add(v...) : s.subtract(v...); };
      if (x.size() == 1) put(x[0]);
      if constexpr (K >= 2)
        if (x.size() == 2) put(x[0], x[1]);
      if constexpr (K >= 3)
        if (x.size() == 3) put(x[0], x[1], x[2]);
      if constexpr (K >= 4)
        if (x.size() == 4) put(x[0], x[1], x[2], x[3]);
      if constexpr (K >= 5)
        if (x.size() == 5) put(x[0], x[1], x[2], x[3], x[4]);
    }
    zeros += expected.sign() == 0;
    REQUIRE(s.sign() == expected.sign());
    REQUIRE(same_bits(s.rounded() + 0.0, expected.rounded() + 0.0));
  }
  CHECK(zeros > 0);
}

}  // namespace

TEST_CASE("exact_accumulator: against GMP, signs and rounded values") {
  const int trials = std::getenv("IRG_RELEASE_TIER") ? 1'000'000 : 10'000;
  for (const exponents which : {exponents::like, exponents::subnormal, exponents::any}) {
    compare<1>(which, trials, 1);
    compare<2>(which, trials, 2);
    compare<3>(which, trials, 3);
    compare<4>(which, trials, 4);
    compare<5>(which, trials, 5);
  }
}

#endif

TEST_CASE("rounded_to_double: integers of many words, as the accumulator rounds them") {
  using irg::wide_int;
  CHECK_BOTH(irg::rounded_to_double(wide_int<4>(-3), -1) == -1.5);
  CHECK_BOTH(irg::rounded_to_double(wide_int<1>(0), 100) == 0);
  CHECK_BOTH(irg::rounded_to_double(wide_int<2>(1), 2000) == infinite);
  CHECK_BOTH(irg::rounded_to_double(wide_int<2>((std::int64_t{1} << 53) + 1)) == 0x1p53);      // ties to even
  CHECK_BOTH(irg::rounded_to_double(wide_int<1>(-((std::int64_t{1} << 53) + 3))) == -0x1p53 - 4);
  CHECK_BOTH(irg::rounded_to_double(wide_int<1>(3), -1075) == 0x1p-1073);
  test::random r(80);
  int differ = 0;
  for (int i = 0; i < 10'000; ++i) {
    const std::int64_t a = r.integer(-1'000'000'000'000, 1'000'000'000'000), b = r.integer(-(1 << 30), 1 << 30);
    exact_accumulator<3> sum;  // both fit a double
    sum.add(static_cast<double>(a), static_cast<double>(a), static_cast<double>(b));
    const wide_int<3> product = wide_int<1>(a) * wide_int<1>(a) * wide_int<1>(b);
    differ += !same_bits(irg::rounded_to_double(product, -7), sum.rounded(-7));
  }
  CHECK(differ == 0);
}
