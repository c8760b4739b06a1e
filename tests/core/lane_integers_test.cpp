// SPDX-License-Identifier: MIT
#include <irg/core/lane_integers.hpp>

#include "core/lane_numbers.hpp"
#include "support/check_both.hpp"

namespace {

struct bit_operations {
  template <class T, int N>
  void operator()() const {
    using P = irg::pack<T, N>;
    test::random r(N + 2);
    for (int round = 0; round < 200; ++round) {
      const P a = test::any_pack<T, N>(r), b = test::any_pack<T, N>(r);
      REQUIRE(test::lanes_are(a & b, [&](int i) { return static_cast<T>(a[i] & b[i]); }));
      REQUIRE(test::lanes_are(a | b, [&](int i) { return static_cast<T>(a[i] | b[i]); }));
      REQUIRE(test::lanes_are(a ^ b, [&](int i) { return static_cast<T>(a[i] ^ b[i]); }));
      REQUIRE(test::lanes_are(a & b[0], [&](int i) { return static_cast<T>(a[i] & b[0]); }));
      REQUIRE(test::lanes_are(a | b[0], [&](int i) { return static_cast<T>(a[i] | b[0]); }));
      REQUIRE(test::lanes_are(a ^ b[0], [&](int i) { return static_cast<T>(a[i] ^ b[0]); }));
      REQUIRE(test::lanes_are(~a, [&](int i) { return static_cast<T>(~a[i]); }));
      const int bits = static_cast<int>(r.integer(0, 8 * static_cast<int>(sizeof(T)) - 1));
      REQUIRE(test::lanes_are(a << bits, [&](int i) { return static_cast<T>(a[i] << bits); }));
      REQUIRE(test::lanes_are(a >> bits, [&](int i) { return static_cast<T>(a[i] >> bits); }));
    }
  }
};

// Integers to integers.
template <class To>
struct integer_conversions {
  template <class T, int N>
  void operator()() const {
    test::random r(N + 3);
    for (int round = 0; round < 50; ++round) {
      const auto a = test::any_pack<T, N>(r);
      REQUIRE(test::lanes_are(irg::converted<To>(a), [&](int i) { return static_cast<To>(a[i]); }));
    }
  }
};

struct floating_conversions {
  template <class T, int N>
  void operator()() const {
    test::random r(N + 4);
    using integers = irg::pack<std::int32_t, N>;
    for (int round = 0; round < 200; ++round) {
      const auto any = test::any_pack<T, N>(r);
      REQUIRE(test::lanes_are(irg::converted<double>(any), [&](int i) { return static_cast<double>(any[i]); }));
      const auto small = irg::lanes<irg::pack<T, N>>::generate(
          [&](int) { return static_cast<T>((r.unit() - 0.5) * (round % 2 == 0 ? 0x1p31 : 8.0)); });
      REQUIRE(test::lanes_are(irg::converted<float>(small), [&](int i) { return static_cast<float>(small[i]); }));
      REQUIRE(test::lanes_are(irg::converted<std::int32_t>(small),
                              [&](int i) { return static_cast<std::int32_t>(small[i]); }));
      const auto n = test::any_pack<std::int32_t, N>(r);
      REQUIRE(test::lanes_are(irg::converted<T>(n), [&](int i) { return static_cast<T>(n[i]); }));
      REQUIRE(test::lanes_are(irg::to_float(n), [&](int i) { return static_cast<float>(n[i]); }));
      const integers same = irg::converted<std::int32_t>(n);
      REQUIRE(test::lanes_are(same, [&](int i) { return n[i]; }));
    }
  }
};

TEST_CASE("packs of integers: bit by bit as scalars") { test::for_integer_lanes(bit_operations{}); }

TEST_CASE("converted: every lane as static_cast has it") {
  test::for_integer_lanes(integer_conversions<std::int8_t>{});
  test::for_integer_lanes(integer_conversions<std::uint8_t>{});
  test::for_integer_lanes(integer_conversions<std::uint16_t>{});
  test::for_integer_lanes(integer_conversions<std::int32_t>{});
  test::for_integer_lanes(integer_conversions<std::int64_t>{});
  test::for_floating_lanes(floating_conversions{});
}

TEST_CASE("bits_as: the bytes in their order") {
  test::random r(5);
  for (int round = 0; round < 200; ++round) {
    const auto p = test::any_pack<std::uint32_t, 4>(r);
    const auto floats = irg::bits_as<float>(p);
    const auto bytes = irg::bits_as<std::uint8_t>(p);
    const auto words = irg::bits_as<std::uint64_t>(p);
    unsigned char memory[16], again[16];
    irg::lanes<irg::pack<std::uint32_t, 4>>::store_bytes(memory, p);
    for (int i = 0; i < 16; ++i) REQUIRE(bytes[i] == memory[i]);
    irg::lanes<irg::pack<std::uint64_t, 2>>::store_bytes(again, words);
    REQUIRE(std::memcmp(memory, again, 16) == 0);
    REQUIRE(test::lanes_are(floats, [&](int i) { return std::bit_cast<float>(p[i]); }));
  }
}

template <int N>
void upper_products() {
  test::random r(N);
  for (int round = 0; round < 500; ++round) {
    const auto a = test::any_pack<std::uint16_t, N>(r), b = test::any_pack<std::uint16_t, N>(r);
    REQUIRE(test::lanes_are(irg::upper_product(a, b),
                            [&](int i) { return static_cast<std::uint16_t>(std::uint32_t{a[i]} * b[i] >> 16); }));
  }
}

TEST_CASE("upper_product: the upper halves of products") {
  upper_products<2>();
  upper_products<4>();
  upper_products<8>();
  upper_products<16>();
}

TEST_CASE("packed_bytes: lane 0 the lowest") {
  for (int k = 0; k < 256; ++k)
    CHECK(irg::packed_bytes(irg::pack_of(k, 255 - k, k ^ 85, 255)) ==
          (static_cast<std::uint32_t>(k) | static_cast<std::uint32_t>(255 - k) << 8 |
           static_cast<std::uint32_t>(k ^ 85) << 16 | 0xff000000u));
}

TEST_CASE("to_float: the scalar form") { CHECK_BOTH(irg::to_float(std::int64_t{1} << 40) == 0x1p40f); }

}  // namespace
