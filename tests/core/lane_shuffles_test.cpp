// SPDX-License-Identifier: MIT
#include <irg/core/lane_shuffles.hpp>

#include "core/lane_numbers.hpp"

#include <doctest/doctest.h>

namespace {

struct shuffles {
  template <class T, int N>
  void operator()() const {
    test::random r(N + 7);
    const auto a = test::any_pack<T, N>(r), b = test::any_pack<T, N>(r);
    const auto at = [&](int i) { return i < N ? a[i] : b[i - N]; };
    REQUIRE(test::lanes_are(irg::shuffled_by<N>(a, b, [](int i) { return 2 * N - 1 - 2 * i; }),
                            [&](int i) { return at(2 * N - 1 - 2 * i); }));
    REQUIRE(test::lanes_are(irg::shuffled_by<2 * N>(a, [](int i) { return i / 2; }), [&](int i) { return a[i / 2]; }));
    REQUIRE(test::lanes_are(irg::shuffled<1, 0, N, 2 * N - 1>(a, b), [&](int i) {
      return i == 0 ? a[1] : i == 1 ? a[0] : i == 2 ? b[0] : b[N - 1];
    }));
    REQUIRE(test::lanes_are(irg::shuffled<N - 1, 0>(a), [&](int i) { return i == 0 ? a[N - 1] : a[0]; }));
    REQUIRE(test::lanes_are(irg::low_half(a), [&](int i) { return a[i]; }));
    REQUIRE(test::lanes_are(irg::high_half(a), [&](int i) { return a[i + N / 2]; }));
    REQUIRE(test::lanes_are(irg::join_halves<T, 2 * N>(a, b), at));
    REQUIRE(test::lanes_are(irg::repeated<4 * N>(a), [&](int i) { return a[i % N]; }));
  }
};

TEST_CASE("shuffles: the lanes that were asked for") { test::for_all_lanes(shuffles{}); }

}  // namespace
