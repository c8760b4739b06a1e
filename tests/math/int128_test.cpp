// SPDX-License-Identifier: MIT
#include <irg/math/detail/two_word_integer.hpp>
#include <irg/math/int128.hpp>

#include <cstdint>
#include <limits>

#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::int128;
using irg::uint128;

static_assert(sizeof(int128) == 16 && sizeof(uint128) == 16 && int128(-1) < 0 && uint128(0) - 1 > 0);

TEST_CASE("int128: the largest products, either sign") {
  constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min();
  constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  CHECK_BOTH(int128{least} * least == (int128{1} << 126));
  CHECK_BOTH(static_cast<std::uint64_t>((uint128{most} * most) >> 64) == most - 1);
  CHECK_BOTH(static_cast<std::uint64_t>(uint128{most} * most) == 1);
  CHECK_BOTH(-7 / int128{2} == -3);
  CHECK_BOTH((int128{-7} >> 1) == -4);
}

TEST_CASE("int128: products against the school's method of four halves") {
  test::random random(128);
  for (int trial = 0; trial < 10000; ++trial) {
    const std::uint64_t a = random.next() >> (random.next() % 64), b = random.next() >> (random.next() % 64);
    const std::uint64_t low = std::uint64_t{0xffffffff};
    const std::uint64_t ll = (a & low) * (b & low), lh = (a & low) * (b >> 32), hl = (a >> 32) * (b & low),
                        hh = (a >> 32) * (b >> 32);
    const std::uint64_t middle = (ll >> 32) + (lh & low) + (hl & low);
    const uint128 product = uint128{a} * b;
    CHECK(static_cast<std::uint64_t>(product) == a * b);
    CHECK(static_cast<std::uint64_t>(product >> 64) == hh + (lh >> 32) + (hl >> 32) + (middle >> 32));
  }
}

// What stands in for a compiler's own integers of 128 bits is held against them.
namespace {

using irg::detail::number_sign;
using signed_words = irg::detail::two_word_integer<number_sign::twos_complement>;
using unsigned_words = irg::detail::two_word_integer<number_sign::none>;

template <class Words, class Own>
constexpr bool equal(const Words& words, Own own) {
  return words.low() == static_cast<std::uint64_t>(own) && words.high() == static_cast<std::uint64_t>(own >> 64);
}

// Numbers of all widths, many of them next to a power of two.
template <class Words, class Own>
constexpr void any_number(test::random& random, Words& words, Own& own) {
  const std::uint64_t low = random.next(), high = random.next();
  const int shift = static_cast<int>(random.next() % 128), kind = static_cast<int>(random.next() % 3);
  uint128 bits = (uint128{high} << 64 | low) >> shift;
  if (kind == 1) bits = (uint128{1} << shift) - low % 2;
  if (kind == 2) bits = 0 - bits;
  own = static_cast<Own>(bits);
  words = Words(unsigned_words(static_cast<std::uint64_t>(bits >> 64))) << 64 |
          Words(unsigned_words(static_cast<std::uint64_t>(bits)));
}
template <>
constexpr void any_number(test::random& random, unsigned_words& words, uint128& own) {
  signed_words s = 0;
  int128 o = 0;
  any_number(random, s, o);
  words = unsigned_words(s);
  own = static_cast<uint128>(o);
}

template <class Words, class Own>
constexpr int mismatches(int trials, bool is_signed) {
  test::random random(12864);
  int wrong = 0;
  for (int i = 0; i < trials; ++i) {
    Words a = 0, b = 0;
    Own x = 0, y = 0;
    any_number(random, a, x);
    any_number(random, b, y);
    const int shift = static_cast<int>(random.next() % 128);
    const uint128 ux = static_cast<uint128>(x), uy = static_cast<uint128>(y);  // overflow wraps here
    wrong += !equal(a, x) + !equal(a + b, ux + uy) + !equal(a - b, ux - uy) + !equal(a * b, ux * uy) +
             !equal(-a, 0 - ux) + !equal(~a, ~ux) + !equal(a & b, ux & uy) + !equal(a | b, ux | uy) +
             !equal(a ^ b, ux ^ uy) + !equal(a << shift, ux << shift) + !equal(a >> shift, x >> shift);
    wrong += (a < b) != (x < y) || (a == b) != (x == y) || (a >= b) != (x >= y);
    const bool least_by_minus_one = is_signed && ux == uint128{1} << 127 && uy + 1 == 0;  // overflows
    if (y != 0 && !least_by_minus_one) wrong += !equal(a / b, x / y) + !equal(a % b, x % y);
    wrong += static_cast<double>(a) != static_cast<double>(x);
    wrong += is_signed && static_cast<float>(a) != static_cast<float>(x);  // others may be beyond a float
    const double rounded = static_cast<double>(x) / 4;  // within the range
    wrong += !equal(Words(rounded), static_cast<Own>(rounded));
  }
  return wrong;
}

static_assert(mismatches<signed_words, int128>(20, true) == 0 && mismatches<unsigned_words, uint128>(20, false) == 0);

}  // namespace

TEST_CASE("int128: two words do what the compiler's integer does") {
  CHECK(mismatches<signed_words, int128>(100'000, true) == 0);
  CHECK(mismatches<unsigned_words, uint128>(100'000, false) == 0);
}
