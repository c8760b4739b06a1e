// SPDX-License-Identifier: MIT
#include <irg/math/decimal.hpp>

#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <locale.h>
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

using irg::decimal_status;

template <class T>
constexpr irg::decimal_result<T> parse(std::string_view s) {
  return irg::parse_decimal<T>(s.data(), s.data() + s.size());
}

template <class T>
using bits_of = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
template <class T>
constexpr bits_of<T> bits(T x) {
  return std::bit_cast<bits_of<T>>(x);
}

/// Read to the end, with this status and exactly these bits.
template <class T>
constexpr bool reads(std::string_view s, T value, decimal_status status = decimal_status::ok) {
  const auto r = parse<T>(s);
  return r.end == s.data() + s.size() && r.status == status && bits(r.value) == bits(value);
}

/// The first `length` bytes are the number.
constexpr bool reads_part(std::string_view s, std::size_t length, double value) {
  const auto r = parse<double>(s);
  return r.end == s.data() + length && r.status == decimal_status::ok && bits(r.value) == bits(value);
}

constexpr bool reads_nothing(std::string_view s) {
  const auto r = parse<double>(s);
  return r.end == s.data() && r.status == decimal_status::none && r.value == 0;
}

float from_libc(const char* s, float) { return std::strtof(s, nullptr); }
double from_libc(const char* s, double) { return std::strtod(s, nullptr); }

template <class T>
long wrong_against_libc(const char* s) {
  const auto r = irg::parse_decimal<T>(s, s + std::strlen(s));
  return bits(r.value) != bits(from_libc(s, T{})) || *r.end != 0;
}

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

static_assert(irg::parse_decimal<double>("0.5x") && !irg::parse_decimal<double>("x"));
static_assert(irg::parse_decimal<double>("0.5x").value == 0.5 && *irg::parse_decimal<float>("0.5x").end == 'x');

TEST_CASE("decimal: plain numbers") {
  CHECK_BOTH(reads("0", 0.0));
  CHECK_BOTH(reads("-0", -0.0));
  CHECK_BOTH(reads("-0.0e5", -0.0f));
  CHECK_BOTH(reads("1", 1.0));
  CHECK_BOTH(reads("+1.5", 1.5));
  CHECK_BOTH(reads("-12.75", -12.75));
  CHECK_BOTH(reads(".5", 0.5));
  CHECK_BOTH(reads("5.", 5.0));
  CHECK_BOTH(reads("0000000000000000000000000000000001", 1.0));
  CHECK_BOTH(reads("0.1", 0.1));
  CHECK_BOTH(reads("0.1", 0.1f));
  CHECK_BOTH(reads("1e22", 1e22));
  CHECK_BOTH(reads("1e23", 1e23));
  CHECK_BOTH(reads("1E+2", 100.0));
  CHECK_BOTH(reads("-0.334989", -0.334989f));
  CHECK_BOTH(reads("123456789012345678", 123456789012345678.0));
}

TEST_CASE_TEMPLATE("decimal: digits and a point whose places are known", T, float, double) {
  CHECK_BOTH(irg::value_of_digits("12345678", 8) == 12345678);
  CHECK_BOTH(irg::value_of_digits("987-0.5e", 3) == 987);
  CHECK_BOTH(irg::value_of_digits("98765432", 0, 17) == 17);
  CHECK_BOTH(irg::value_of_digits("98765432", 3, 17) == 17987);
  CHECK_BOTH(irg::digit_bits("0:/9-.5\xb7 "
                             "11234567890abcdefghijklmnopqrstuvwxyz012345678901234567890") == 0xffffc000000ffe49u);
  CHECK_BOTH(irg::decimal_fraction<T>(1250, 2) == T(12.5));
  CHECK_BOTH(irg::decimal_fraction<T>(0, 19) == 0);
  test::random r(15 + sizeof(T));
  for (int trial = 0; trial < 200000; ++trial) {
    const auto digits = [&](std::int64_t count) {
      std::string s;
      for (; count > 0; --count) s += static_cast<char>('0' + r.integer(0, 9));
      return s;
    };
    const std::string whole = digits(r.integer(1, 8)), rest = digits(r.integer(0, 11));
    CHECK(irg::value_of_digits((whole + rest.substr(0, 3) + "-.x\n\xff/: ").data(), static_cast<int>(whole.size())) ==
          irg::parse_integer<std::uint64_t>(whole.data(), whole.data() + whole.size()).value);
    const std::string all = whole + rest;
    const auto mantissa = irg::parse_integer<std::uint64_t>(all.data(), all.data() + all.size()).value;
    CHECK(irg::decimal_fraction<T>(mantissa, static_cast<int>(rest.size())) ==
          irg::parse_decimal<T>(whole + "." + rest).value);
  }
}

TEST_CASE("decimal: where the text of a number ends") {
  CHECK_BOTH(reads_part("1e", 1, 1));
  CHECK_BOTH(reads_part("1e+", 1, 1));
  CHECK_BOTH(reads_part("1,5", 1, 1));
  CHECK_BOTH(reads_part("0x10", 1, 0));
  CHECK_BOTH(reads_part("1.2.3", 3, 1.2));
  CHECK_BOTH(reads_part("7 8", 1, 7));
  CHECK_BOTH(reads_part("1e5.", 3, 1e5));
  for (const char* s : {"", "-", "+", ".", "-.", "e5", " 1", "nan", "inf", "--1", "+-1", ".e1"})
    CHECK(reads_nothing(s));
  static_assert(reads_nothing("") && reads_nothing("nan") && reads_nothing(".") && reads_nothing("-"));
}

TEST_CASE("decimal: no byte but digits is taken for one") {
  long wrong = 0;
  for (int byte = 0; byte < 256; ++byte)
    for (std::size_t place = 2; place < 22; ++place) {
      std::string text = "0.12345678901234567890";
      text[place] = static_cast<char>(byte);
      if (byte >= '0' && byte <= '9') continue;
      const auto r = irg::parse_decimal<double>(text.data(), text.data() + text.size());
      const std::string number = text.substr(0, place);
      const bool exponent = (byte == 'e' || byte == 'E') && place < 21;
      if (!exponent) wrong += r.end != text.data() + place || r.value != std::strtod(number.c_str(), nullptr);
    }
  CHECK(wrong == 0);
}

TEST_CASE("decimal: overflow and underflow are classified") {
  constexpr float float_infinity = std::numeric_limits<float>::infinity();
  CHECK_BOTH(reads("1e999", infinity, decimal_status::overflow));
  CHECK_BOTH(reads("-1e999", -infinity, decimal_status::overflow));
  CHECK_BOTH(reads("3E4570711268", infinity, decimal_status::overflow));
  CHECK_BOTH(reads("1e99999999999999999999999999", infinity, decimal_status::overflow));
  CHECK_BOTH(reads("1e-999", 0.0, decimal_status::underflow));
  CHECK_BOTH(reads("-1e-99999999999999999999999999", -0.0, decimal_status::underflow));
  CHECK_BOTH(reads("0e999", 0.0));
  CHECK_BOTH(reads("1e39", float_infinity, decimal_status::overflow));
  CHECK_BOTH(reads("1e-46", 0.0f, decimal_status::underflow));
  // The last that rounds down and the first that does not.
  CHECK_BOTH(reads("1.7976931348623158079e308", 0x1.fffffffffffffp1023));
  CHECK_BOTH(reads("1.7976931348623158080e308", infinity, decimal_status::overflow));
  CHECK_BOTH(reads("3.4028235677973366163e38", 0x1.fffffep127f));
  CHECK_BOTH(reads("3.4028235677973366164e38", float_infinity, decimal_status::overflow));
  CHECK_BOTH(reads("2.4703282292062327208e-324", 0.0, decimal_status::underflow));
  CHECK_BOTH(reads("2.4703282292062327209e-324", 0x1p-1074));
  CHECK_BOTH(reads("7.0064923216240853546e-46", 0.0f, decimal_status::underflow));
  CHECK_BOTH(reads("7.0064923216240853547e-46", 0x1p-149f));
}

TEST_CASE("decimal: hard cases known from other readers") {
  CHECK_BOTH(reads("2.2250738585072011e-308", 0x0.fffffffffffffp-1022));  // endless loop in old PHP and Java
  CHECK_BOTH(reads("2.2250738585072014e-308", 0x1p-1022));
  CHECK_BOTH(reads("9007199254740993", 0x1p53));  // halfway, to even
  CHECK_BOTH(reads("9007199254740993.00000000000000000000000000001", 0x1.0000000000001p53));
  CHECK_BOTH(reads("9007199254740995", 0x1.0000000000002p53));
  CHECK_BOTH(reads("8.10109172351e-10", 8.10109172351e-10));
  CHECK_BOTH(reads("6929495644600919.5e0", 6929495644600920.0));
  CHECK_BOTH(reads("16777217", 0x1p24f));
  CHECK_BOTH(reads("16777217.0000000000000000000001", 0x1.000002p24f));
  CHECK_BOTH(reads("1.00000017881393432617187499", 0x1.000002p0f));  // by way of double it would be one too many
  CHECK_BOTH(reads("1.00000017881393432617187500", 0x1.000004p0f));
  CHECK_BOTH(reads("1.00000017881393432617187501", 0x1.000004p0f));
  CHECK_BOTH(reads("1090544144181609348671888949248", 0x1.b877a0p99f));
}

TEST_CASE("decimal: 800 digits and more") {
  // Half of the smallest subnormal has 751 significant digits; one more digit anywhere behind them decides.
  char half[1200];
  const int length = std::snprintf(half, sizeof half, "%.1075f", 0x1p-1074);
  REQUIRE(length == 1077);
  std::string text = half;
  // 2^-1075 = 5 * 10^-1 * 2^-1074: halve the digits by hand, in decimal.
  int rest = 0;
  for (char& c : text)
    if (c != '.') {
      const int digit = rest * 10 + (c - '0');
      c = static_cast<char>('0' + digit / 2);
      rest = digit % 2;
    }
  text += rest != 0 ? "5" : "";
  CHECK(reads(text, 0.0, decimal_status::underflow));
  CHECK(reads(text + std::string(1000, '0') + "1", 0x1p-1074));
  CHECK(reads("-" + text + "0001e0", -0x1p-1074));
  CHECK(reads("0." + std::string(1'000'000, '0') + "1e1000001", 1.0));
  CHECK(reads(std::string(1'000'000, '1') + "e-999999", 0x1.1c71c71c71c72p0));
  CHECK(reads(std::string(400, '9'), infinity, decimal_status::overflow));
  CHECK(reads("1" + std::string(700, '0') + "e-700", 1.0));
  CHECK(reads("1" + std::string(900, '0') + "1e-901", 1.0));
}

TEST_CASE("decimal: powers of five to 128 bits") {
  using irg::detail::natural;
  for (int n = irg::detail::lowest_power_of_five; n <= irg::detail::highest_power_of_five; ++n) {
    // low <= 5^n / 2^shift < low + 1, where both sides have 128 bits.
    const auto power = irg::detail::power_of_five_to_128_bits(n);
    const int shift = irg::detail::floor_log2_of_power_of_five(n) - 127;
    REQUIRE((power.high >> 63) == 1);
    natural low = natural::from(power.high), above = natural::from(power.high), five = natural::from(1), one = five;
    low.shift_left(64);
    low.words[0] = power.low;
    above = low;
    for (int i = 0; ++above.words[i] == 0;) ++i;
    if (above.words[2] != 0) above.size = 3;
    if (n >= 0) {
      five.multiply_power_of_five(n);
      natural copy = five;
      REQUIRE(irg::detail::compare_shifted(low, shift, five) == (irg::detail::is_exact_to_128_bits(n) ? 0 : -1));
      REQUIRE(irg::detail::compare_shifted(above, shift, copy) == 1);
    } else {
      natural another = one;
      low.multiply_power_of_five(-n);
      above.multiply_power_of_five(-n);
      REQUIRE(irg::detail::compare_shifted(low, shift, one) == -1);
      REQUIRE(irg::detail::compare_shifted(above, shift, another) == 1);
    }
  }
}

TEST_CASE("decimal: every way gives the same") {
  long wrong = 0;
  const auto check = [&wrong](auto type, irg::detail::decimal_text text) {
    using T = decltype(type);
    const T value = irg::detail::unsigned_value<T>(text);
    T other{};
    if (text.mantissa <= std::uint64_t{1} << 53 && text.exponent >= -22 && text.exponent <= 22 &&
        irg::detail::nearest_by_double(text.mantissa, static_cast<int>(text.exponent), other))
      wrong += other != value;
    // Between the neighbour below and this one it is nearer to this one, and between this one and the next, too.
    if (!std::isinf(value)) wrong += irg::detail::nearest_by_naturals(text, value) != value;
    if (value > 0) wrong += irg::detail::nearest_by_naturals(text, std::nextafter(value, T{0})) != value;
  };
  test::random random(7);
  for (int i = 0; i < 100'000; ++i) {
    irg::detail::decimal_text text{nullptr};
    text.mantissa = (random.next() >> random.integer(0, 63)) | 1;
    if (text.mantissa >= 10'000'000'000'000'000'000u) text.mantissa /= 10;
    text.exponent = i % 8 == 0 ? random.integer(-345, 310) : random.integer(-60, 60);
    check(double{}, text);
    check(float{}, text);
  }
  CHECK(wrong == 0);
}

TEST_CASE("decimal: agrees with libc on random text") {
  const int rounds = std::getenv("IRG_RELEASE_TIER") ? 5'000'000 : 150'000;
  test::random random(2024);
  char s[1600];
  long wrong = 0;
  for (int i = 0; i < rounds; ++i) {
    const double d = std::bit_cast<double>(random.next());
    const float f = std::bit_cast<float>(static_cast<std::uint32_t>(random.next()));
    if (!std::isfinite(d) || !std::isfinite(f)) continue;
    std::snprintf(s, sizeof s, "%.9g", static_cast<double>(f));
    const auto back = irg::parse_decimal<float>(s, s + std::strlen(s));
    wrong += bits(back.value) != bits(f);
    std::snprintf(s, sizeof s, "%.17g", d);
    wrong += bits(parse<double>(s).value) != bits(d);
    const int digits = static_cast<int>(i % 64 == 0 ? random.integer(20, 1000) : random.integer(0, 24));
    std::snprintf(s, sizeof s, i % 2 == 0 ? "%.*e" : "%.*g", digits, d);
    wrong += wrong_against_libc<double>(s) + wrong_against_libc<float>(s);
    std::snprintf(s, sizeof s, "%.*f", digits,
                  static_cast<double>(random.integer(-1'000'000'000, 1'000'000'000)) / 1e6);
    wrong += wrong_against_libc<double>(s) + wrong_against_libc<float>(s);
    // Decimal digits as they come, subnormal results among them.
    std::snprintf(s, sizeof s, "%llu.%llue%d", static_cast<unsigned long long>(random.next() >> random.integer(0, 63)),
                  static_cast<unsigned long long>(random.next()), static_cast<int>(random.integer(-345, 310)));
    wrong += wrong_against_libc<double>(s) + wrong_against_libc<float>(s);
  }
  CHECK(wrong == 0);
}

TEST_CASE("decimal: halfway between neighbours, and beside it") {
  // %.1100f prints a double exactly, so the mean of two floats, a double, is printed exactly, too.
  test::random random(11);
  char s[1400];
  long wrong = 0;
  for (int i = 0; i < 20'000; ++i) {
    const auto b = static_cast<std::uint32_t>(random.next()) & 0x7fffffffu;
    const float low = std::bit_cast<float>(b), high = std::bit_cast<float>(b + 1);
    if (!std::isfinite(high)) continue;
    const float even = (b & 1) == 0 ? low : high;
    const double mean = (static_cast<double>(low) + static_cast<double>(high)) / 2;
    const int n = std::snprintf(s, sizeof s, "%.1100f", mean);
    wrong += bits(parse<float>(s).value) != bits(even);
    s[n - 1] = '1';  // the last digits are zeros: this is a little more
    wrong += bits(parse<float>(s).value) != bits(high);
    std::snprintf(s, sizeof s, "%.1100f", std::nextafter(mean, 0.0));
    wrong += bits(parse<float>(s).value) != bits(low);
  }
  CHECK(wrong == 0);
  // So near to halfway that the nearest double is halfway itself: rounding twice would go wrong.
  long near_halfway = 0;
  for (int i = 0; i < 50'000; ++i) {
    const auto b = static_cast<std::uint32_t>(random.integer(0x38000000, 0x60000000));  // 3e-5 to 4e19
    const double mean =
        (static_cast<double>(std::bit_cast<float>(b)) + static_cast<double>(std::bit_cast<float>(b + 1))) / 2;
    std::snprintf(s, sizeof s, "%.15e", mean);
    wrong += wrong_against_libc<float>(s) + wrong_against_libc<double>(s);
    near_halfway += std::strtod(s, nullptr) == mean;
  }
  CHECK(wrong == 0);
  CHECK(near_halfway > 1000);
}

#ifdef IRG_HAVE_MPFR
TEST_CASE("decimal: halfway between doubles, by rational arithmetic") {
  // (2m + 1) * 2^e is halfway; GMP writes it in decimal exactly, as an integer times a power of ten.
  test::random random(12);
  mpz_t n;
  mpz_init(n);
  long wrong = 0;
  for (int i = 0; i < 3000; ++i) {
    const std::uint64_t b = (random.next() & 0x7fffffffffffffffu) % 0x7feffffffffffffeu;
    const double low = std::bit_cast<double>(b), high = std::bit_cast<double>(b + 1);
    const int field = static_cast<int>(b >> 52);
    const std::uint64_t significand = (b & 0xfffffffffffffu) | (field == 0 ? 0 : 0x10000000000000u);
    const int exponent = (field == 0 ? 1 : field) - 1075 - 1;  // halfway is (2 significand + 1) * 2^exponent
    mpz_set_ui(n, 2 * significand + 1);
    const unsigned long power = static_cast<unsigned long>(exponent < 0 ? -exponent : exponent);
    mpz_t scaled;
    mpz_init(scaled);
    mpz_ui_pow_ui(scaled, exponent < 0 ? 5 : 2, power);
    mpz_mul(scaled, scaled, n);
    char* const digits = mpz_get_str(nullptr, 10, scaled);
    const std::string tail = exponent < 0 ? "e-" + std::to_string(power) : "";
    const std::string more = exponent < 0 ? ".0000000000000000000000000000000001" : ".5";
    wrong += bits(parse<double>(digits + tail).value) != bits((b & 1) == 0 ? low : high);
    wrong += bits(parse<double>(digits + more + tail).value) != bits(high);
    mpz_sub_ui(scaled, scaled, 1);
    char* const less = mpz_get_str(nullptr, 10, scaled);
    wrong += bits(parse<double>(less + (".99999999999999999999999" + tail)).value) != bits(low);
    // Cut off after some digits: as near to halfway as so many digits come.
    for (const std::size_t length : {17u, 18u, 19u, 20u, 25u, 40u}) {
      std::string part(digits);
      if (part.size() <= length) continue;
      const std::size_t dropped = part.size() - length;
      const std::string part_tail =
          "e" + std::to_string(static_cast<long>(dropped) - (exponent < 0 ? static_cast<long>(power) : 0));
      part.resize(length);
      const bool all_zero = std::string_view(digits + length).find_first_not_of('0') == std::string_view::npos;
      wrong += bits(parse<double>(part + part_tail).value) != bits(all_zero && (b & 1) != 0 ? high : low);
      const std::string next = part + "99999999999999999999999999999999999999999999999999" + part_tail.substr(0, 1) +
                               std::to_string(std::stol(part_tail.substr(1)) - 50);
      wrong += wrong_against_libc<double>(next.c_str());
    }
    std::free(digits);
    std::free(less);
    mpz_clear(scaled);
  }
  mpz_clear(n);
  CHECK(wrong == 0);
}
#endif

TEST_CASE("decimal: all 2^32 floats, printed and read") {
  const auto range = test::floats_to_test(32'771);
  char s[32];
  long wrong = 0;
  for (std::uint64_t b = range.first; b < range.last; b += range.step) {
    const float f = std::bit_cast<float>(static_cast<std::uint32_t>(b));
    if (!std::isfinite(f)) continue;
    std::snprintf(s, sizeof s, "%.9g", static_cast<double>(f));
    wrong += bits(parse<float>(s).value) != bits(f);
  }
  CHECK(wrong == 0);
}

TEST_CASE("decimal: a locale with a decimal comma changes nothing") {
  for (const char* name : {"de_DE.UTF-8", "de_DE", "fr_FR.UTF-8"})
    if (setlocale(LC_NUMERIC, name) == nullptr) MESSAGE("skipped, not installed: locale ", std::string(name));
  CHECK(reads("1.5", 1.5));
  CHECK(reads_part("1,5", 1, 1.0));
  setlocale(LC_NUMERIC, "C");
}

TEST_CASE("decimal: integers") {
  const auto integer = [](std::string_view s) {
    return irg::parse_integer<std::int64_t>(s.data(), s.data() + s.size());
  };
  CHECK_BOTH([](std::string_view s) {
    const auto r = irg::parse_integer<int>(s.data(), s.data() + s.size());
    return r.value == -42 && r.end == s.data() + 3 && r.status == decimal_status::ok;
  }("-42/7"));
  CHECK(integer("9223372036854775807").value == INT64_MAX);
  CHECK(integer("9223372036854775807").status == decimal_status::ok);
  CHECK(integer("9223372036854775808").value == INT64_MAX);
  CHECK(integer("9223372036854775808").status == decimal_status::overflow);
  CHECK(integer("-9223372036854775808").value == INT64_MIN);
  CHECK(integer("-9223372036854775808").status == decimal_status::ok);
  CHECK(integer("-9223372036854775809").status == decimal_status::overflow);
  CHECK(integer("-99999999999999999999999").value == INT64_MIN);
  CHECK(integer("+7").value == 7);
  CHECK(integer("007").value == 7);
  for (const char* s : {"", "-", "+", "x", " 1", "--1", ".5"}) CHECK(integer(s).status == decimal_status::none);
  const std::string_view minus = "-1", large = "256";
  CHECK(irg::parse_integer<unsigned>(minus.data(), minus.data() + 2).status == decimal_status::none);
  CHECK(irg::parse_integer<std::uint8_t>(large.data(), large.data() + 3).status == decimal_status::overflow);
  CHECK(irg::parse_integer<std::uint8_t>(large.data(), large.data() + 3).value == 255);
  for (int n = -40000; n <= 40000; ++n) {
    const std::string s = std::to_string(n);
    const auto r = irg::parse_integer<std::int16_t>(s.data(), s.data() + s.size());
    const bool fits = n >= INT16_MIN && n <= INT16_MAX;
    REQUIRE(r.value == (fits ? n : n < 0 ? INT16_MIN : INT16_MAX));
    REQUIRE(r.status == (fits ? decimal_status::ok : decimal_status::overflow));
  }
}
