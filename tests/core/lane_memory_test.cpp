// SPDX-License-Identifier: MIT
#include <irg/core/lane_memory.hpp>

#include <memory>
#include <vector>

#include "core/lane_numbers.hpp"

#include <doctest/doctest.h>

namespace {

template <int N>
void gather_takes_words() {
  std::int32_t table[300];
  float numbers[300];
  test::random random(N + 200);
  for (int i = 0; i < 300; ++i) {
    table[i] = static_cast<std::int32_t>(random.next());
    numbers[i] = test::any_lane_number<float>(random);
  }
  for (int round = 0; round < 500; ++round) {
    const auto index = irg::lanes<irg::pack<std::int32_t, N>>::generate(
        [&](int) { return static_cast<std::int32_t>(random.integer(-150, 149)); });
    REQUIRE(
        test::lanes_are(irg::gather<std::int32_t>(table + 150, index), [&](int i) { return table[150 + index[i]]; }));
    REQUIRE(test::lanes_are(irg::gather<float>(numbers + 150, index), [&](int i) { return numbers[150 + index[i]]; }));
  }
}

TEST_CASE("gather: words before and behind the base") {
  gather_takes_words<2>();
  gather_takes_words<4>();
  gather_takes_words<8>();
  gather_takes_words<16>();
}

// Memory ends where the row does, so that a sanitizer sees what is read or written beyond; a guard sees the writing.
template <int N>
void rows_that_end_earlier() {
  test::random r(N);
  for (int round = 0; round < 200; ++round) {
    const int count = 1 + round % N;
    const auto length = static_cast<std::size_t>(count);
    std::vector<std::uint32_t> from(length), to(length), guarded(length + 16, 7u);
    for (std::uint32_t& x : from) x = test::any_lane_number<std::uint32_t>(r);
    const auto p = irg::load_some<std::uint32_t, N>(from.data(), count);
    for (int i = 0; i < count; ++i) REQUIRE(p[i] == from[static_cast<std::size_t>(i)]);
    const auto q = test::any_pack<std::uint32_t, N>(r);
    irg::store_some(to.data(), q, count);
    irg::store_some(guarded.data(), q, count);
    for (int i = 0; i < count; ++i) REQUIRE(to[static_cast<std::size_t>(i)] == q[i]);
    for (std::size_t i = 0; i < guarded.size(); ++i) REQUIRE(guarded[i] == (i < length ? to[i] : 7u));
    if constexpr (irg::has_masked_stores) {
      irg::store_some(guarded.data() + length, q, 0);
      REQUIRE(guarded[length] == 7u);
    }
  }
}

TEST_CASE("load_some, store_some: rows that end earlier") {
  rows_that_end_earlier<4>();
  if constexpr (irg::native_lanes<int> == 8 || !irg::has_lanes) rows_that_end_earlier<8>();
}

template <int N>
void chosen_lanes() {
  test::random r(N + 8);
  for (unsigned bits = 0; bits < 1u << N; ++bits) {
    const auto p = test::any_pack<std::int32_t, N>(r);
    std::int32_t to[std::size_t{N}] = {};
    int expected = 0;
    const int got = irg::store_compressed(to, p, bits);
    for (int i = 0; i < N; ++i)
      if ((bits >> i & 1) != 0) REQUIRE(to[expected++] == p[i]);
    REQUIRE(got == expected);
  }
}

TEST_CASE("store_compressed: the lanes whose bits are set") {
  chosen_lanes<4>();
  chosen_lanes<8>();
}

struct four_words {
  std::uint32_t word[4];
};
template <int N, class V>
bool repeats(const V& value) {
  unsigned char bytes[sizeof(V)];
  std::memcpy(bytes, &value, sizeof value);
  return test::lanes_are(irg::repeated_bytes<N>(value),
                         [&](int i) { return bytes[static_cast<std::size_t>(i) % sizeof(V)]; });
}

TEST_CASE("repeated_bytes, store_first_bytes: of every size") {
  CHECK(repeats<16>(std::uint8_t{201}));
  CHECK(repeats<16>(std::uint16_t{0x8123}));
  CHECK(repeats<16>(0x89abcdefu));
  CHECK(repeats<32>(-1.25));
  CHECK(repeats<16>(four_words{{1, 0x80000000u, 3, 0xff00ff00u}}));
  CHECK(repeats<32>(four_words{{1, 0x80000000u, 3, 0xff00ff00u}}));
  unsigned char to[9] = {};
  const auto p = irg::repeated_bytes<16>(std::uint64_t{0x0807060504030201u});
  irg::store_first_bytes<2>(to, p);
  CHECK((to[0] != 0 && to[1] != 0 && to[2] == 0));
  irg::store_first_bytes<8>(to, p);
  for (int i = 0; i < 8; ++i) CHECK(to[i] == p[i]);
  CHECK(to[8] == 0);
}

TEST_CASE("no_further_than: the lesser") {
  for (int last = 0; last < 9; ++last)
    for (int i = 0; i < 20; ++i) CHECK(irg::no_further_than(last, i) == (i < last ? i : last));
}

}  // namespace
