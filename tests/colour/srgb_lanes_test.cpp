// SPDX-License-Identifier: MIT
#include <irg/colour/srgb_lanes.hpp>

#include <bit>
#include <cstdint>
#include <limits>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/ulp.hpp"

namespace {

// Pixels of N lights, each channel with bits of its own.
template <int N>
void equals_encode(const std::uint32_t* bits) {
  using floats = irg::pack<float, N>;
  float r[static_cast<unsigned>(N)], g[static_cast<unsigned>(N)], b[static_cast<unsigned>(N)];
  for (int i = 0; i < N; ++i) {
    r[i] = std::bit_cast<float>(bits[i]);
    g[i] = std::bit_cast<float>(bits[(i + 1) % N] ^ 0x8000u);
    b[i] = std::bit_cast<float>(bits[(i + 2) % N] ^ 0x10000u);
  }
  using F = irg::lanes<floats>;
  const auto words = irg::encode_lanes(F::load(r), F::load(g), F::load(b));
  for (int i = 0; i < N; ++i) REQUIRE(std::bit_cast<irg::rgba8>(words[i]) == irg::encode({r[i], g[i], b[i]}));
}

template <int N>
void leading_patterns() {
  // Every sign, exponent and upper fraction, with the first, the last and some trailing bits.
  test::random random(71);
  std::uint32_t bits[static_cast<unsigned>(N)];
  for (std::uint32_t leading = 0; leading < 0x10000; ++leading) {
    for (int i = 0; i < N; ++i)
      bits[i] = leading << 16 | (i == 0 ? 0u : i == 1 ? 0xffffu : static_cast<std::uint32_t>(random.next() & 0xffff));
    equals_encode<N>(bits);
  }
}

TEST_CASE("encode_lanes: all leading halves of a float, in registers of 4 and of the native size") {
  leading_patterns<4>();
  leading_patterns<irg::native_lanes<float>>();
}

TEST_CASE("encode_lanes: random floats between 0 and 1, and both sides of every change of code") {
  test::random random(72);
  constexpr int N = irg::native_lanes<float>;
  std::uint32_t bits[static_cast<unsigned>(N)];
  const int rounds = test::is_release_tier() ? 10'000'000 : 40000;
  for (int k = 0; k < rounds; ++k) {
    for (std::uint32_t& b : bits) b = std::bit_cast<std::uint32_t>(static_cast<float>(random.unit()));
    equals_encode<N>(bits);
  }
  for (std::uint32_t code = 1; code < 256; ++code) {
    const std::uint32_t change = std::bit_cast<std::uint32_t>(irg::detail::srgb_threshold[code]);
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(N); ++i) bits[i] = change + i - 2;
    equals_encode<N>(bits);
    equals_encode<4>(bits);
  }
}

TEST_CASE("encode_lanes: NaN, infinities, zeros, and what is beside 0 and 1; always opaque") {
  constexpr float inf = std::numeric_limits<float>::infinity(), no_number = std::numeric_limits<float>::quiet_NaN();
  const float odd[] = {no_number, -no_number, inf, -inf, 0.0f, -0.0f, 1.0f, -1.0f, 1e-45f, 3e38f, 0x1.fffffep-1f, 1.5f};
  using floats = irg::pack<float, 4>;
  const auto all = [](float x) { return irg::lanes<floats>::broadcast(x); };
  for (const float r : odd)
    for (const float g : odd)
      for (const float b : odd) {
        const auto words = irg::encode_lanes(all(r), all(g), all(b));
        for (int i = 0; i < 4; ++i) REQUIRE(std::bit_cast<irg::rgba8>(words[i]) == irg::encode({r, g, b}));
      }
  CHECK(std::bit_cast<irg::rgba8>(irg::encode_lanes(all(no_number), all(-inf), all(inf))[3]) ==
        irg::rgba8{0, 0, 255, 255});
}

}  // namespace
