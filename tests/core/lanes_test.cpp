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

TEST_CASE("pack: a product that meets a sum is not fused") {
  // 1 + 2^-12 squared needs 25 bits: the fused form keeps the last one, the product rounded on its own does not.
  using floats = irg::pack<float, irg::native_lanes<float>>;
  const float x = 1.0f + 0x1p-12f;
  const floats p = irg::lanes<floats>::broadcast(x);
  const floats rest = irg::product(p, p) - irg::lanes<floats>::broadcast(1.0f + 0x1p-11f);
  for (int i = 0; i < irg::lanes<floats>::count; ++i) CHECK(rest[i] == 0.0f);
  CHECK_BOTH(irg::product(1.0f + 0x1p-12f, 1.0f + 0x1p-12f) - (1.0f + 0x1p-11f) == 0.0f);
}

// The kernel of docs/core/lanes.md.
template <class F>
constexpr F ramp_up(const F& a, const F& x, const F& y) {
  const F r = irg::product(a, x) + y, zero = irg::lanes<F>::broadcast(0);
  return irg::select(r < zero, zero, r);
}

TEST_CASE("lanes: one kernel for scalars and packs") {
  using f = irg::lanes<irg::pack<float, irg::native_lanes<float>>>;
  test::random random(4);
  for (int round = 0; round < 1000; ++round) {
    constexpr std::size_t count = f::count;
    float x[count], y[count], to[count];
    for (int i = 0; i < f::count; ++i) x[i] = any_float(random), y[i] = any_float(random);
    const float a = any_float(random);
    f::store(to, ramp_up(f::broadcast(a), f::load(x), f::load(y)));
    for (int i = 0; i < f::count; ++i) REQUIRE(same(to[i], ramp_up(a, x[i], y[i])));
  }
  CHECK_BOTH(ramp_up(2.0f, 3.0f, -7.0f) == 0.0f);
  CHECK_BOTH(ramp_up(2.0f, 3.0f, -5.0f) == 1.0f);
}

}  // namespace
