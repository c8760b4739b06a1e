// SPDX-License-Identifier: MIT
#include <irg/core/wide_lanes.hpp>

#include "core/lane_numbers.hpp"

#include <doctest/doctest.h>

namespace {

template <int N>
void wide_equals_integers() {
  using wide = irg::wide_pack<N>;
  using W = irg::lanes<wide>;
  test::random random(N);
  for (int i = 0; i < N; ++i) {
    CHECK(lane(W::ramp(), i) == i);
    CHECK(lane(W::broadcast(0x1p52), i) == 0x1p52);
    CHECK(std::signbit(lane(W::broadcast(-0.0), i)));
  }
  for (int round = 0; round < 2000; ++round) {
    // As edge functions have them: start + step * i below 2^53.
    std::int64_t start[3], step[3];
    wide row[3];
    for (int k = 0; k < 3; ++k) {
      start[k] = random.integer(-(std::int64_t{1} << (20 + round % 32)), std::int64_t{1} << (20 + round % 32));
      step[k] = random.integer(-(1 << 27), 1 << 27);
      if (round % 5 == 0) start[k] = -step[k] * random.integer(0, N - 1);  // zero in some lane
      row[k] = W::broadcast(static_cast<double>(start[k])) + W::broadcast(static_cast<double>(step[k])) * W::ramp();
    }
    const auto as_float = irg::to_float(row[0]);
    const unsigned inside = irg::mask_bits(irg::none_negative(row[0], row[1], row[2]));
    for (int i = 0; i < N; ++i) {
      const auto at = [&](int k) { return start[k] + step[k] * i; };
      for (int k = 0; k < 3; ++k) REQUIRE(static_cast<std::int64_t>(lane(row[k], i)) == at(k));
      REQUIRE(test::same_lane(as_float[i], static_cast<float>(at(0))));  // rounded once
      REQUIRE((inside >> i & 1) == (at(0) >= 0 && at(1) >= 0 && at(2) >= 0 ? 1u : 0u));
    }
    REQUIRE((inside >> N) == 0);
  }
}

TEST_CASE("wide_pack: integers below 2^53, exactly, and rounded once to floats") {
  wide_equals_integers<4>();
  wide_equals_integers<irg::native_lanes<float>>();
  wide_equals_integers<16>();
}

}  // namespace
