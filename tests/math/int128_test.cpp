// SPDX-License-Identifier: MIT
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
