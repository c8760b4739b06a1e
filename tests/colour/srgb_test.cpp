// SPDX-License-Identifier: MIT
#include <irg/colour/srgb.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

// The definition itself, in 64-bit significands: the oracle. Nothing here knows the tables.
long double encoded_of(long double light) {
  return light <= 0.0031308L ? 12.92L * light : 1.055L * std::pow(light, 1.0L / 2.4L) - 0.055L;
}
long double light_of(long double encoded) {
  return encoded <= 0.04045L ? encoded / 12.92L : std::pow((encoded + 0.055L) / 1.055L, 2.4L);
}
int code_of(float light) {
  if (!(light > 0)) return 0;
  return light >= 1 ? 255 : static_cast<int>(std::floor(encoded_of(static_cast<long double>(light)) * 255 + 0.5L));
}
// The smallest float whose code is k, by bisection of the definition.
std::uint32_t first_bits_of(int k) {
  std::uint32_t low = 0, high = 0x3f800000;
  while (low < high) {
    const std::uint32_t middle = (low + high) / 2;
    if (code_of(std::bit_cast<float>(middle)) >= k)
      high = middle;
    else
      low = middle + 1;
  }
  return low;
}

template <class T>
long double ulps(T value, long double truth) {
  const T rounded = static_cast<T>(truth);
  const T next = std::nextafter(rounded, std::numeric_limits<T>::infinity());
  return std::abs(static_cast<long double>(value) - truth) / static_cast<long double>(next - rounded);
}

}  // namespace

TEST_CASE("srgb: types and values by hand") {
  static_assert(std::is_same_v<decltype(irg::srgb_to_linear(std::uint8_t{})), float>);
  static_assert(std::is_same_v<decltype(irg::linear_to_srgb8(0.0f)), std::uint8_t>);
  static_assert(noexcept(irg::linear_to_srgb8(0.0f)) && noexcept(irg::encode({})) && noexcept(irg::decode({})));
  static_assert(sizeof(irg::detail::srgb_code_table) == 1664 * 4);
  CHECK_BOTH(irg::srgb_to_linear(std::uint8_t{0}) == 0.0f);
  CHECK_BOTH(irg::srgb_to_linear(std::uint8_t{255}) == 1.0f);
  CHECK_BOTH(irg::linear_to_srgb8(0.5f) == 188);  // half the light is no half of the code
  CHECK_BOTH(irg::linear_to_srgb8(0.0031308f) == 10);
  CHECK_BOTH(irg::encode({0.0f, 0.5f, 1.0f}) == irg::rgba8{0, 188, 255, 255});
  CHECK_BOTH(irg::encode({1.0f, 0.0f, 0.0f}, 7) == irg::rgba8{255, 0, 0, 7});
  CHECK_BOTH(irg::decode({255, 0, 255, 9}) == irg::rgb<float>{1.0f, 0.0f, 1.0f});
}

TEST_CASE("srgb: every code decodes to the nearest float") {
  for (int k = 0; k <= 255; ++k) {
    CAPTURE(k);
    const float light = irg::srgb_to_linear(static_cast<std::uint8_t>(k));
    CHECK(light == static_cast<float>(light_of(k / 255.0L)));
    CHECK(irg::linear_to_srgb8(light) == k);
  }
}

TEST_CASE("srgb: the code changes at exactly the floats where the definition's does") {
  for (int k = 1; k <= 255; ++k) {
    CAPTURE(k);
    const std::uint32_t first = first_bits_of(k);
    CHECK(irg::detail::srgb_threshold[k] == std::bit_cast<float>(first));
    CHECK(irg::linear_to_srgb8(std::bit_cast<float>(first)) == k);
    CHECK(irg::linear_to_srgb8(std::bit_cast<float>(first - 1)) == k - 1);
  }
}

TEST_CASE("srgb: floats that share a table entry") {
  // Between thresholds the code is constant, so an entry that is right at both its ends and at its threshold (above)
  // is right everywhere.
  for (std::uint32_t bits = 0x38000000; bits <= 0x3f800000; bits += 0x10000)
    for (const std::uint32_t b : {bits, bits + 0xffff})
      REQUIRE(irg::linear_to_srgb8(std::bit_cast<float>(b)) == code_of(std::bit_cast<float>(b)));
}

TEST_CASE("srgb: random floats, and all of them in the release tier") {
  test::random random(1);
  for (int i = 0; i < 1000000; ++i) {  // every exponent is as likely as the other: half of them below 1
    const float light = std::bit_cast<float>(static_cast<std::uint32_t>(random.next()));
    if (light == light) REQUIRE(irg::linear_to_srgb8(light) == code_of(light));
  }
  for (int i = 0; i < 200000; ++i) {
    const float light = static_cast<float>(random.unit());
    REQUIRE(irg::linear_to_srgb8(light) == code_of(light));
  }
  if (!std::getenv("IRG_RELEASE_TIER")) return;
  std::uint32_t next = first_bits_of(1);
  int code = 0;
  std::uint64_t wrong = 0;
  for (std::uint64_t b = 0; b < 0x100000000u; ++b) {
    const std::uint32_t bits = static_cast<std::uint32_t>(b);
    if (bits == next && code < 255) next = ++code < 255 ? first_bits_of(code + 1) : next;
    const bool is_number = bits <= 0x7f800000;  // positive; what is negative or NaN gives 0
    wrong += irg::linear_to_srgb8(std::bit_cast<float>(bits)) != (is_number ? code : 0);
  }
  CHECK(code == 255);
  CHECK(wrong == 0);
}

TEST_CASE("srgb: every float is accepted") {
  CHECK_BOTH(irg::linear_to_srgb8(not_a_number) == 0);
  CHECK_BOTH(irg::linear_to_srgb8(-not_a_number) == 0);
  CHECK_BOTH(irg::linear_to_srgb8(inf) == 255);
  CHECK_BOTH(irg::linear_to_srgb8(-inf) == 0);
  CHECK_BOTH(irg::linear_to_srgb8(-0.0f) == 0);
  CHECK_BOTH(irg::linear_to_srgb8(-1.0f) == 0);
  CHECK_BOTH(irg::linear_to_srgb8(0x1p-149f) == 0);
  CHECK_BOTH(irg::linear_to_srgb8(1.0f) == 255);
  CHECK_BOTH(irg::linear_to_srgb8(3e38f) == 255);
  CHECK_BOTH(irg::encode({not_a_number, inf, -inf}) == irg::rgba8{0, 255, 0, 255});
}

TEST_CASE_TEMPLATE("srgb: the continuous curve", T, float, double) {
  CHECK_BOTH(irg::linear_to_srgb(T(0)) == T(0));
  CHECK_BOTH(irg::srgb_to_linear(T(0)) == T(0));
  CHECK_BOTH(irg::linear_to_srgb(-T(0.5)) == -irg::linear_to_srgb(T(0.5)));
  CHECK_BOTH(irg::srgb_to_linear(-T(0.5)) == -irg::srgb_to_linear(T(0.5)));
  long double worst_encoded = 0, worst_light = 0;
  for (int i = 1; i <= 20000; ++i) {
    const T x = static_cast<T>(i) / T(16384);  // a little beyond 1
    const long double exact = static_cast<long double>(x);
    worst_encoded = std::max(worst_encoded, ulps(irg::linear_to_srgb(x), encoded_of(exact)));
    worst_light = std::max(worst_light, ulps(irg::srgb_to_linear(x), light_of(exact)));
  }
  MESSAGE("linear_to_srgb ", static_cast<double>(worst_encoded), " ulp, srgb_to_linear ",
          static_cast<double>(worst_light));
  CHECK(worst_encoded < 8.0L);
  CHECK(worst_light < 8.0L);
  constexpr T nan = std::numeric_limits<T>::quiet_NaN(), infinite = std::numeric_limits<T>::infinity();
  CHECK_BOTH(irg::linear_to_srgb(nan) != irg::linear_to_srgb(nan));
  CHECK_BOTH(irg::srgb_to_linear(nan) != irg::srgb_to_linear(nan));
  CHECK_BOTH(irg::linear_to_srgb(infinite) == infinite);
  CHECK_BOTH(irg::srgb_to_linear(-infinite) == -infinite);
  CHECK_BOTH(irg::srgb_to_linear(std::numeric_limits<T>::max()) == infinite);
}
