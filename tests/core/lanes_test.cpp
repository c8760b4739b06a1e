// SPDX-License-Identifier: MIT
#include <irg/core/lanes.hpp>

#include <bit>
#include <cmath>
#include <limits>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

// A float with any bit pattern but NaN: NaN payloads are no part of the promise.
float any_float(test::random& r) {
  for (;;) {
    const float f = std::bit_cast<float>(static_cast<std::uint32_t>(r.next()));
    if (f == f) return f;
  }
}

bool same(float a, float b) {
  return a != a ? b != b : std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

template <int N>
void lanes_equal_scalars() {
  using floats = irg::pack<float, N>;
  using ints = irg::pack<std::int32_t, N>;
  constexpr unsigned width = N;
  test::random random(width);
  for (int round = 0; round < 2000; ++round) {
    float a[width], b[width];
    std::int32_t k[width];
    for (int i = 0; i < N; ++i) {
      a[i] = any_float(random);
      b[i] = round % 4 == 0 ? a[i] : any_float(random);
      k[i] = static_cast<std::int32_t>(random.next());
    }
    const floats x = irg::lanes<floats>::load(a), y = irg::lanes<floats>::load(b);
    const ints n = irg::lanes<ints>::load(k);
    const floats sum = x + y, difference = x - y, times = irg::product(x, y), quotient = x / y;
    const floats chosen = irg::select(x < y, x, y), converted = irg::to_float(n);
    unsigned less = 0, equal = 0, at_least = 0;
    for (int i = 0; i < N; ++i) {
      REQUIRE(same(sum[i], a[i] + b[i]));
      REQUIRE(same(difference[i], a[i] - b[i]));
      REQUIRE(same(times[i], a[i] * b[i]));
      REQUIRE(same(quotient[i], a[i] / b[i]));
      REQUIRE(same(chosen[i], a[i] < b[i] ? a[i] : b[i]));
      REQUIRE(same(converted[i], static_cast<float>(k[i])));
      less |= a[i] < b[i] ? 1u << i : 0;
      equal |= a[i] == b[i] ? 1u << i : 0;
      at_least |= k[i] >= 0 ? 1u << i : 0;
    }
    REQUIRE(irg::mask_bits(x < y) == less);
    REQUIRE(irg::mask_bits(x == y) == equal);
    REQUIRE(irg::mask_bits(n >= irg::lanes<ints>::broadcast(0)) == at_least);
    REQUIRE(irg::mask_bits(irg::both(x < y, n >= irg::lanes<ints>::broadcast(0))) == (less & at_least));
    float back[width];
    irg::lanes<floats>::store(back, x);
    for (int i = 0; i < N; ++i) REQUIRE(same(back[i], a[i]));
  }
  for (int i = 0; i < N; ++i) {
    CHECK(irg::lanes<ints>::ramp()[i] == i);
    CHECK(irg::lanes<floats>::broadcast(-0.0f)[i] == 0.0f);
    CHECK(std::signbit(irg::lanes<floats>::broadcast(-0.0f)[i]));
  }
}

TEST_CASE("pack: every operation has the bits of the scalar one, for 4 and the native number of lanes") {
  lanes_equal_scalars<4>();
  lanes_equal_scalars<irg::native_lanes<float>>();
}

#ifdef IRG_LANES_VECTOR
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
      REQUIRE(same(as_float[i], static_cast<float>(at(0))));  // rounded once
      REQUIRE((inside >> i & 1) == (at(0) >= 0 && at(1) >= 0 && at(2) >= 0 ? 1u : 0u));
    }
    REQUIRE((inside >> N) == 0);
  }
}

template <int N>
void none_negative_of_integers() {
  using ints = irg::pack<std::int32_t, N>;
  test::random random(N + 100);
  for (int round = 0; round < 2000; ++round) {
    ints v[3];
    for (ints& p : v)
      for (int i = 0; i < N; ++i) {
        const std::int32_t odd[] = {0, -1, 1, INT32_MIN, INT32_MAX};
        p.v[i] = random.integer(0, 1) == 0 ? odd[random.integer(0, 4)] : static_cast<std::int32_t>(random.next());
      }
    const unsigned bits = irg::mask_bits(irg::none_negative(v[0], v[1], v[2]));
    for (int i = 0; i < N; ++i) REQUIRE((bits >> i & 1) == (v[0][i] >= 0 && v[1][i] >= 0 && v[2][i] >= 0 ? 1u : 0u));
  }
}

template <int N>
void gather_takes_words() {
  std::int32_t table[300];
  float numbers[300];
  test::random random(N + 200);
  for (int i = 0; i < 300; ++i) {
    table[i] = static_cast<std::int32_t>(random.next());
    numbers[i] = any_float(random);
  }
  for (int round = 0; round < 500; ++round) {
    irg::pack<std::int32_t, N> index;
    for (int i = 0; i < N; ++i) index.v[i] = static_cast<std::int32_t>(random.integer(-150, 149));
    const auto words = irg::gather<std::int32_t>(table + 150, index);
    const auto floats = irg::gather<float>(numbers + 150, index);
    for (int i = 0; i < N; ++i) {
      REQUIRE(words[i] == table[150 + index[i]]);
      REQUIRE(same(floats[i], numbers[150 + index[i]]));
    }
  }
}

TEST_CASE("gather: words before and behind the base") {
  gather_takes_words<4>();
  gather_takes_words<irg::native_lanes<float>>();
}

TEST_CASE("wide_pack: integers below 2^53, exactly, and rounded once to floats") {
  wide_equals_integers<4>();
  wide_equals_integers<irg::native_lanes<float>>();
}

TEST_CASE("none_negative: where three numbers are zero or more") {
  none_negative_of_integers<4>();
  none_negative_of_integers<irg::native_lanes<float>>();
}
#endif

TEST_CASE("pack: a product that meets a sum is not fused") {
  // 1 + 2^-12 squared needs 25 bits: the fused form keeps the last one, the product rounded on its own does not.
  using floats = irg::pack<float, irg::native_lanes<float>>;
  const float x = 1.0f + 0x1p-12f;
  const floats p = irg::lanes<floats>::broadcast(x);
  const floats rest = irg::product(p, p) - irg::lanes<floats>::broadcast(1.0f + 0x1p-11f);
  for (int i = 0; i < irg::lanes<floats>::count; ++i) CHECK(rest[i] == 0.0f);
  CHECK_BOTH(irg::product(1.0f + 0x1p-12f, 1.0f + 0x1p-12f) - (1.0f + 0x1p-11f) == 0.0f);
}

TEST_CASE("lanes: the scalar forms") {
  CHECK_BOTH(irg::lanes<float>::count == 1);
  CHECK_BOTH(irg::select(true, 1, 2) == 1);
  CHECK_BOTH(irg::mask_bits(true) == 1u);
  CHECK_BOTH(irg::to_float(std::int64_t{1} << 40) == 0x1p40f);
  CHECK_BOTH(irg::lane(5, 0) == 5);
}

}  // namespace
