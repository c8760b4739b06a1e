// SPDX-License-Identifier: MIT
#include <irg/core/lane_masks.hpp>

#include "core/lane_numbers.hpp"
#include "support/check_both.hpp"

namespace {

template <class T>
T number_or_nan(test::random& r) {
  if constexpr (std::floating_point<T>)
    if (r.integer(0, 9) == 0) return std::numeric_limits<T>::quiet_NaN();
  return test::any_lane_number<T>(r);
}

struct comparisons {
  template <class T, int N>
  void operator()() const {
    using P = irg::pack<T, N>;
    using mask = typename irg::lanes<P>::mask;
    using M = typename irg::lanes<mask>::scalar;
    static_assert(sizeof(M) == sizeof(T) && sizeof(mask) == sizeof(P));
    test::random r(N + 5);
    for (int round = 0; round < 300; ++round) {
      const P a = irg::lanes<P>::generate([&](int) { return number_or_nan<T>(r); });
      const P b = irg::lanes<P>::generate([&](int i) { return r.integer(0, 2) == 0 ? a[i] : number_or_nan<T>(r); });
      const auto is = [&](const mask& m, auto holds) {
        unsigned bits = 0;
        for (int i = 0; i < N; ++i) bits |= holds(i) ? 1u << i : 0u;
        const bool all = bits == (1u << N) - 1;
        return test::lanes_are(m, [&](int i) { return holds(i) ? M(-1) : M(0); }) && irg::mask_bits(m) == bits &&
               irg::any_lane(m) == (bits != 0) && irg::no_lane(m) == (bits == 0) && irg::all_lanes(m) == all;
      };
      REQUIRE(is(a < b, [&](int i) { return a[i] < b[i]; }));
      REQUIRE(is(a <= b, [&](int i) { return a[i] <= b[i]; }));
      REQUIRE(is(a > b, [&](int i) { return a[i] > b[i]; }));
      REQUIRE(is(a >= b, [&](int i) { return a[i] >= b[i]; }));
      REQUIRE(is(a == b, [&](int i) { return a[i] == b[i]; }));
      REQUIRE(is(irg::not_at_most(a, b), [&](int i) { return !(a[i] <= b[i]); }));
      REQUIRE(is(a < b[0], [&](int i) { return a[i] < b[0]; }));
      REQUIRE(is(a <= b[0], [&](int i) { return a[i] <= b[0]; }));
      REQUIRE(is(a > b[0], [&](int i) { return a[i] > b[0]; }));
      REQUIRE(is(a >= b[0], [&](int i) { return a[i] >= b[0]; }));
      REQUIRE(is(irg::both(a < b, a >= b[0]), [&](int i) { return a[i] < b[i] && a[i] >= b[0]; }));
      REQUIRE(test::lanes_are(irg::select(a < b, a, b), [&](int i) { return a[i] < b[i] ? a[i] : b[i]; }));
      REQUIRE(test::lanes_are(irg::select(irg::both(a < b, a >= b[0]), a, b),
                              [&](int i) { return a[i] < b[i] && a[i] >= b[0] ? a[i] : b[i]; }));
      REQUIRE(test::lanes_are(irg::minimum(a, b), [&](int i) { return a[i] < b[i] ? a[i] : b[i]; }));
      REQUIRE(test::lanes_are(irg::maximum(a, b), [&](int i) { return b[i] < a[i] ? a[i] : b[i]; }));
      if constexpr (std::floating_point<T>) {
        unsigned signs = 0;
        for (int i = 0; i < N; ++i) signs |= std::signbit(a[i]) ? 1u << i : 0u;
        REQUIRE(irg::sign_bits(a) == signs);
      }
    }
  }
};

struct reductions {
  template <class T, int N>
  void operator()() const {
    test::random r(N + 6);
    for (int round = 0; round < 100; ++round) {
      const auto a = test::any_pack<T, N>(r);
      if (a[0] != a[0]) continue;
      T least = a[0], greatest = a[0];
      bool is_number = true;
      for (int i = 1; i < N; ++i) {
        is_number = is_number && a[i] == a[i];
        least = a[i] < least ? a[i] : least;
        greatest = greatest < a[i] ? a[i] : greatest;
      }
      if (!is_number) continue;
      REQUIRE(irg::reduce_min(a) == least);
      REQUIRE(irg::reduce_max(a) == greatest);
      const auto small = irg::lanes<irg::pack<T, N>>::generate([&](int) { return static_cast<T>(r.integer(0, 7)); });
      T sum = 0;
      for (int i = 0; i < N; ++i) sum = static_cast<T>(sum + small[i]);
      REQUIRE(irg::reduce_add(small) == sum);
    }
  }
};

TEST_CASE("masks: what comparisons of scalars say, in every lane") { test::for_all_lanes(comparisons{}); }

TEST_CASE("reduce_min, reduce_max, reduce_add: of all lanes") { test::for_all_lanes(reductions{}); }

TEST_CASE("reduce_add: the order of the sum is the one that is said") {
  test::random r(1);
  for (int round = 0; round < 1000; ++round) {
    const auto p =
        irg::lanes<irg::pack<float, 4>>::generate([&](int) { return static_cast<float>(r.unit() - 0.5) * 0x1p20f; });
    CHECK(irg::reduce_add(p) == (p[0] + p[2]) + (p[1] + p[3]));
  }
}

TEST_CASE("mask_bits: of 32 lanes, and of 64") {
  for (int k = 0; k < 64; ++k) {
    const auto has = [&](int i) { return i == k || i == 13; };
    const auto m =
        irg::lanes<irg::pack<std::int8_t, 64>>::generate([&](int i) { return std::int8_t(has(i) ? -1 : 0); });
    CHECK(irg::mask_bits(m) == (std::uint64_t{1} << k | std::uint64_t{1} << 13));
    CHECK(irg::mask_bits(irg::low_half(m)) == ((k < 32 ? 1u << k : 0u) | 1u << 13));
    CHECK(!irg::all_lanes(m));
    CHECK(irg::all_lanes(m | std::int8_t(-1)));
  }
}

template <int N>
void none_negative_of_integers() {
  using ints = irg::pack<std::int32_t, N>;
  test::random random(N + 100);
  for (int round = 0; round < 500; ++round) {
    const ints a = test::any_pack<std::int32_t, N>(random), b = test::any_pack<std::int32_t, N>(random),
               c = test::any_pack<std::int32_t, N>(random);
    const unsigned bits = irg::mask_bits(irg::none_negative(a, b, c));
    for (int i = 0; i < N; ++i) REQUIRE((bits >> i & 1) == (a[i] >= 0 && b[i] >= 0 && c[i] >= 0 ? 1u : 0u));
  }
}

TEST_CASE("none_negative: where three numbers are zero or more") {
  none_negative_of_integers<4>();
  none_negative_of_integers<irg::native_lanes<float>>();
}

TEST_CASE("masks: the scalar forms") {
  CHECK_BOTH(irg::select(true, 1, 2) == 1);
  CHECK_BOTH(irg::mask_bits(true) == 1u);
  CHECK_BOTH((irg::any_lane(true) && irg::all_lanes(true) && irg::no_lane(false)));
  CHECK_BOTH((!irg::any_lane(false) && !irg::all_lanes(false) && !irg::no_lane(true)));
  CHECK_BOTH((irg::minimum(1.0, 2.0) == 1.0 && irg::maximum(1.0f, 2.0f) == 2.0f));
  CHECK_BOTH((irg::reduce_min(3) == 3 && irg::reduce_max(3.5) == 3.5 && irg::reduce_add(2) == 2));
}

}  // namespace
