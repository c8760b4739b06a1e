// SPDX-License-Identifier: MIT
// print_decimal and print_integer of irg/math/decimal.hpp.
#include <irg/math/decimal.hpp>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

#ifdef IRG_HAVE_MPFR
#include <gmp.h>
#include <mpfr.h>
#endif

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/ulp.hpp"

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

template <class T>
using bits_of = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;

/// Printed so, and not where there is no room for it.
template <class T>
constexpr bool prints(T value, std::string_view expected) {
  for (int room = 0; room < 30; ++room) {
    char text[30];
    for (char& c : text) c = '#';
    const std::optional<char*> end = irg::print_decimal(text, text + room, value);
    if (end.has_value() != (static_cast<std::size_t>(room) >= expected.size())) return false;
    const auto n = static_cast<std::size_t>(end.value_or(text) - text);
    if (n != (end ? expected.size() : 0)) return false;
    if (std::string_view(text, n) != expected.substr(0, n)) return false;
    for (const char& c : text)
      if (&c >= text + room && c != '#') return false;
  }
  return true;
}

template <class I>
constexpr bool prints_integer(I value, std::string_view expected) {
  char text[24] = {};
  const auto room = static_cast<std::ptrdiff_t>(expected.size());
  if (irg::print_integer(text, text + room - 1, value)) return false;
  return irg::print_integer(text, text + room, value) == text + room &&
         std::string_view(text, expected.size()) == expected;
}

/// Printed and read, constant evaluation included.
template <class T>
constexpr bool comes_back(T value) {
  char text[irg::longest_decimal<T>] = {};
  char* const end = *irg::print_decimal(text, text + irg::longest_decimal<T>, value);
  const auto r = irg::parse_decimal<T>(text, end);
  return r.end == end && r.status == irg::decimal_status::ok &&
         std::bit_cast<bits_of<T>>(r.value) == std::bit_cast<bits_of<T>>(value);
}

/// Leads back, and has std::to_chars' text where the standard library has that.
template <class T>
long wrong(T v) {
  if (!std::isfinite(v)) return 0;
  char text[irg::longest_decimal<T>];
  char* const end = *irg::print_decimal(text, text + irg::longest_decimal<T>, v);
  const auto r = irg::parse_decimal<T>(text, end);
  long bad = r.end != end || std::bit_cast<bits_of<T>>(r.value) != std::bit_cast<bits_of<T>>(v);
#ifdef __cpp_lib_to_chars
  char other[64];
  const auto length = static_cast<std::size_t>(std::to_chars(other, other + sizeof other, v).ptr - other);
  bad += std::string_view(text, static_cast<std::size_t>(end - text)) != std::string_view(other, length);
  T read{};
  std::from_chars(text, end, read);
  bad += std::bit_cast<bits_of<T>>(read) != std::bit_cast<bits_of<T>>(v);
#endif
  return bad;
}

/// A number and its neighbours.
template <class T>
long wrong_around(T v) {
  return wrong(v) + wrong(std::nextafter(v, T{0})) + wrong(std::nextafter(v, std::numeric_limits<T>::infinity()));
}

template <class T>
long wrong_of_random(int count) {
  constexpr int fraction_bits = std::numeric_limits<T>::digits - 1;
  test::random random(sizeof(T));
  long bad = 0;
  for (int i = 0; i < count; ++i) {
    const auto bits = static_cast<bits_of<T>>(random.next());
    const auto fraction = static_cast<bits_of<T>>((bits_of<T>{1} << fraction_bits) - 1);
    bad += wrong(std::bit_cast<T>(bits));
    bad +=
        i % 4 != 0 ? 0 : wrong(std::bit_cast<T>(bits & (fraction >> random.integer(0, fraction_bits))));  // subnormal
    bad += i % 4 != 1 ? 0 : wrong(static_cast<T>(std::ldexp(random.unit(), static_cast<int>(random.integer(-20, 90)))));
    bad += i % 4 != 2 ? 0 : wrong(static_cast<T>(random.integer(-99999, 99999)) / static_cast<T>(1000));
  }
  return bad;
}

}  // namespace

static_assert([] {
  char room[30] = {};
  return irg::print_decimal(room, 0.1) == "0.1" && irg::print_decimal(std::span(room, 1), 0.1).empty();
}());

TEST_CASE("decimal text: the shortest one") {
  CHECK_BOTH(prints(0.1, "0.1"));
  CHECK_BOTH(prints(0.1f, "0.1"));
  CHECK_BOTH(prints(1.0, "1"));
  CHECK_BOTH(prints(-2.5, "-2.5"));
  CHECK_BOTH(prints(0.1 + 0.2, "0.30000000000000004"));
  CHECK_BOTH(prints(1.0 / 3, "0.3333333333333333"));
  CHECK_BOTH(prints(1.0f / 3, "0.33333334"));
  CHECK_BOTH(prints(12345.678, "12345.678"));
  CHECK_BOTH(prints(1200.0, "1200"));
  CHECK_BOTH(prints(123456.0, "123456"));
  CHECK_BOTH(prints(1e5, "1e+05"));
  CHECK_BOTH(prints(1e22, "1e+22"));
  CHECK_BOTH(prints(1e23, "1e+23"));
  CHECK_BOTH(prints(0.001, "0.001"));
  CHECK_BOTH(prints(0.0001, "1e-04"));
  CHECK_BOTH(prints(0.00015, "0.00015"));
  CHECK_BOTH(prints(1.5e-5, "1.5e-05"));
  CHECK_BOTH(prints(-1.25e-100, "-1.25e-100"));
}

TEST_CASE("decimal text: zeros, infinities, NaN and the ends of the range") {
  CHECK_BOTH(prints(0.0, "0"));
  CHECK_BOTH(prints(-0.0, "-0"));
  CHECK_BOTH(prints(-0.0f, "-0"));
  CHECK_BOTH(prints(infinity, "inf"));
  CHECK_BOTH(prints(-infinity, "-inf"));
  CHECK_BOTH(prints(std::numeric_limits<double>::quiet_NaN(), "nan"));
  CHECK(prints(-std::numeric_limits<double>::quiet_NaN(), "nan"));
  CHECK_BOTH(prints(0x1p-1074, "5e-324"));
  CHECK_BOTH(prints(0x1p-1073, "1e-323"));
  CHECK_BOTH(prints(0x1p-149f, "1e-45"));
  CHECK_BOTH(prints(0x1p-1022, "2.2250738585072014e-308"));
  CHECK_BOTH(prints(0x0.fffffffffffffp-1022, "2.225073858507201e-308"));
  CHECK_BOTH(prints(-0x1.fffffffffffffp1023, "-1.7976931348623157e+308"));
  CHECK_BOTH(prints(-0x1.fffffep127f, "-3.4028235e+38"));
  CHECK_BOTH(prints(-0x1p-126f, "-1.1754944e-38"));
  CHECK_BOTH(prints(-1.00000015e-29f, "-1.00000015e-29"));  // as long as a float's text can be
}

TEST_CASE("decimal text: whole numbers to their last digit") {
  CHECK_BOTH(prints(0x1p53, "9007199254740992"));
  CHECK_BOTH(prints(0x1p64, "18446744073709551616"));
  CHECK_BOTH(prints(-0x1p60, "-1152921504606846976"));
  CHECK_BOTH(prints(0x1.fffffffffffffp69, "1180591620717411172352"));
  CHECK_BOTH(prints(0x1p30f, "1073741824"));
  CHECK_BOTH(prints(16777216.0f, "16777216"));
}

TEST_CASE("decimal text: a power of two is nearer to its lower neighbour") {
  // The nearest number of 16 digits reads as the neighbour below; the one above it is further but leads back.
  CHECK_BOTH(prints(0x1p-44, "5.684341886080802e-14"));
  CHECK_BOTH(prints(0x1p-1017, "7.120236347223045e-307"));
  CHECK_BOTH(prints(9007199254740996.0, "9007199254740996"));
  CHECK_BOTH(prints(9.5367431640625e-07f, "9.536743e-07"));
  CHECK_BOTH(prints(0x1p90f, "1.2379401e+27"));
}

TEST_CASE("decimal text: leads back, in constant evaluation, too") {
  constexpr bool all = [] {
    test::random random(5);
    bool good = true;
    for (int i = 0; i < 24; ++i) {
      const double d = std::bit_cast<double>(random.next());
      const float f = std::bit_cast<float>(static_cast<std::uint32_t>(random.next()));
      if (d - d == 0) good = good && comes_back(d);
      if (f - f == 0) good = good && comes_back(f);
    }
    return good;
  }();
  static_assert(all);
}

TEST_CASE("decimal text: random numbers of all kinds, beside std::to_chars") {
  CHECK(wrong_of_random<double>(test::count_of(250'000)) == 0);
  CHECK(wrong_of_random<float>(test::count_of(250'000)) == 0);
}

TEST_CASE("decimal text: powers of two and of ten, subnormals, extremes") {
  long bad = 0;
  for (int e = -1074; e < 1024; ++e) bad += wrong_around(std::ldexp(1.0, e)) + wrong_around(std::ldexp(3.0, e));
  for (int e = -149; e < 128; ++e) bad += wrong_around(std::ldexp(1.0f, e));
  for (int e = -323; e <= 308; ++e) {
    const std::string text = "e" + std::to_string(e);
    for (const char* digits : {"1", "2", "5", "9", "9.999999999999999", "1.7976931348623157", "4.5"})
      bad += wrong_around(std::strtod((digits + text).c_str(), nullptr)) +
             wrong_around(std::strtof((digits + text).c_str(), nullptr));
  }
  for (std::uint32_t b = 0; b < 3000; ++b)
    bad += wrong(std::bit_cast<float>(b)) + wrong(std::bit_cast<double>(std::uint64_t{b})) +
           wrong(std::bit_cast<float>(0x7f7fffffu - b)) +
           wrong(std::bit_cast<double>(std::uint64_t{0x7fefffffffffffffu} - b));
  for (int i = 0; i < 64; ++i) bad += wrong_around(std::ldexp(1.0, i) - 1);
  CHECK(bad == 0);
}

TEST_CASE("decimal text: all 2^32 floats") {
  const auto range = test::floats_to_test(32'771);
  long bad = 0;
  for (std::uint64_t b = range.first; b < range.last; b += range.step)
    bad += wrong(std::bit_cast<float>(static_cast<std::uint32_t>(b)));
  CHECK(bad == 0);
}

#ifdef IRG_HAVE_MPFR
namespace {

/// By the definition: the largest power of ten that has a multiple between the middles to the neighbours, and of those
/// multiples the nearest, with rationals.
class shortest_oracle {
public:
  shortest_oracle() {
    mpq_inits(value_, low_, high_, unit_, scaled_, nullptr);
    mpz_inits(least_, most_, nearest_, rest_, nullptr);
  }
  shortest_oracle(const shortest_oracle&) = delete;
  shortest_oracle& operator=(const shortest_oracle&) = delete;
  ~shortest_oracle() {
    mpq_clears(value_, low_, high_, unit_, scaled_, nullptr);
    mpz_clears(least_, most_, nearest_, rest_, nullptr);
  }

  /// needs   v > 0 and finite
  template <class T>
  irg::detail::short_decimal operator()(T v) {
    const double here = static_cast<double>(v);
    mpq_set_d(value_, here);
    middle(low_, static_cast<double>(std::nextafter(v, T{0})), false);
    const T above = std::nextafter(v, std::numeric_limits<T>::infinity());
    if (std::isinf(above))
      middle(high_, static_cast<double>(std::nextafter(v, T{0})), true);
    else
      middle(high_, static_cast<double>(above), false);
    const bool ends_belong = (std::bit_cast<bits_of<T>>(v) & 1) == 0;
    for (int e = static_cast<int>(std::floor(std::log10(here))) + 2;; --e) {
      mpz_ui_pow_ui(mpq_numref(unit_), 10, static_cast<unsigned long>(e < 0 ? -e : e));
      mpz_set_ui(mpq_denref(unit_), 1);
      if (e < 0) mpq_inv(unit_, unit_);
      mpq_div(scaled_, low_, unit_);
      mpz_cdiv_qr(least_, rest_, mpq_numref(scaled_), mpq_denref(scaled_));
      if (!ends_belong && mpz_sgn(rest_) == 0) mpz_add_ui(least_, least_, 1);
      mpq_div(scaled_, high_, unit_);
      mpz_fdiv_qr(most_, rest_, mpq_numref(scaled_), mpq_denref(scaled_));
      if (!ends_belong && mpz_sgn(rest_) == 0) mpz_sub_ui(most_, most_, 1);
      if (mpz_cmp(least_, most_) > 0) continue;
      mpq_div(scaled_, value_, unit_);
      mpz_fdiv_qr(nearest_, rest_, mpq_numref(scaled_), mpq_denref(scaled_));
      mpz_mul_2exp(rest_, rest_, 1);
      const int half = mpz_cmp(rest_, mpq_denref(scaled_));
      if (half > 0 || (half == 0 && mpz_odd_p(nearest_))) mpz_add_ui(nearest_, nearest_, 1);
      if (mpz_cmp(nearest_, least_) < 0) mpz_set(nearest_, least_);
      if (mpz_cmp(nearest_, most_) > 0) mpz_set(nearest_, most_);
      return {mpz_get_ui(nearest_), e};
    }
  }

private:
  /// (value + neighbour) / 2, or, reflected, (value + (2 value - neighbour)) / 2.
  void middle(mpq_ptr result, double neighbour, bool reflected) {
    mpq_set_d(result, neighbour);
    mpq_sub(result, result, value_);
    mpq_div_2exp(result, result, 1);
    if (reflected) mpq_neg(result, result);
    mpq_add(result, result, value_);
  }
  mpq_t value_, low_, high_, unit_, scaled_;
  mpz_t least_, most_, nearest_, rest_;
};

}  // namespace

TEST_CASE("decimal text: fewest digits, nearest of them, by rational arithmetic") {
  shortest_oracle oracle;
  long bad = 0;
  const auto check = [&](auto v) {
    if (v == 0 || !std::isfinite(v)) return;
    const auto d = irg::detail::shortest_digits(irg::detail::binary_parts_of(v)), right = oracle(std::fabs(v));
    bad += d.digits != right.digits || d.exponent != right.exponent;
  };
  for (int e = -1074; e < 1024; ++e) check(std::ldexp(1.0, e));
  for (int e = -149; e < 128; ++e) check(std::ldexp(1.0f, e));
  for (std::uint32_t b = 1; b < 200; ++b) {
    check(std::bit_cast<float>(b));
    check(std::bit_cast<double>(std::uint64_t{b}));
    check(std::bit_cast<double>(std::uint64_t{0x7ff0000000000000u} - b));
  }
  // Of all doubles the one that, times the power of ten it is printed with, comes nearest to an integer.
  check(std::ldexp(8887055249355788.0, 664));
  test::random random(77);
  for (int i = 0; i < test::count_of(3000); ++i) {
    const std::uint64_t bits = random.next();
    check(std::bit_cast<double>(bits));
    check(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    check(std::ldexp(random.unit(), 60));
  }
  CHECK(bad == 0);
}
#endif

TEST_CASE("decimal text: integers") {
  CHECK_BOTH(prints_integer(0, "0"));
  CHECK_BOTH(prints_integer(-7, "-7"));
  CHECK_BOTH(prints_integer(10u, "10"));
  CHECK_BOTH(prints_integer(INT64_MIN, "-9223372036854775808"));
  CHECK_BOTH(prints_integer(INT64_MAX, "9223372036854775807"));
  CHECK_BOTH(prints_integer(UINT64_MAX, "18446744073709551615"));
  CHECK_BOTH(prints_integer(static_cast<signed char>(-128), "-128"));
  long bad = 0;
  for (int n = -40000; n <= 40000; ++n) bad += !prints_integer(n, std::to_string(n));
  for (std::uint64_t p = 1; p < 10'000'000'000'000'000'000u; p *= 10)
    bad += !prints_integer(p, std::to_string(p)) + !prints_integer(p * 10 - 1, std::to_string(p * 10 - 1));
  CHECK(bad == 0);
}
