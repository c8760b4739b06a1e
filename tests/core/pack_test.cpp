// SPDX-License-Identifier: MIT
#include <irg/core/pack.hpp>

#include "core/lane_numbers.hpp"
#include "support/check_both.hpp"

namespace {

// Sums of signed integers that may overflow are computed on bits without sign.
template <class T>
T halved(T x) {
  if constexpr (std::is_signed_v<T> && std::integral<T>)
    return static_cast<T>(x / 4);
  else
    return x;
}

struct moves {
  template <class T, int N>
  void operator()() const {
    using P = irg::pack<T, N>;
    using L = irg::lanes<P>;
    test::random r(N);
    static_assert(L::count == N && sizeof(P) == std::size_t{N} * sizeof(T) && std::is_same_v<typename L::scalar, T>);
    for (int round = 0; round < 50; ++round) {
      T from[std::size_t{N} + 1], to[std::size_t{N} + 2] = {};
      for (T& x : from) x = test::any_lane_number<T>(r);
      const P p = L::load(from + 1);  // at an address that is no multiple of the register
      REQUIRE(test::lanes_are(p, [&](int i) { return from[i + 1]; }));
      REQUIRE(test::lanes_are(L::load_bytes(from), [&](int i) { return from[i]; }));
      L::store(to + 1, p);
      for (int i = 0; i < N; ++i) REQUIRE(test::same_lane(to[i + 1], from[i + 1]));
      REQUIRE((to[0] == T(0) && to[N + 1] == T(0)));
      L::store_bytes(to, p);
      for (int i = 0; i < N; ++i) REQUIRE(test::same_lane(to[i], from[i + 1]));
      REQUIRE(test::lanes_are(L::broadcast(from[0]), [&](int) { return from[0]; }));
      P changed = p;
      const int k = static_cast<int>(r.integer(0, N - 1));
      irg::set_lane(changed, k, from[0]);
      REQUIRE(test::lanes_are(changed, [&](int i) { return i == k ? from[0] : from[i + 1]; }));
      REQUIRE(test::same_lane(irg::lane(p, k), from[k + 1]));
      if constexpr (std::floating_point<T>)
        REQUIRE(test::lanes_are(irg::opaque(p), [&](int i) { return from[i + 1]; }));
    }
    REQUIRE(test::lanes_are(L::ramp(), [](int i) { return static_cast<T>(i); }));
  }
};

struct arithmetic {
  template <class T, int N>
  void operator()() const {
    using P = irg::pack<T, N>;
    using wide = std::conditional_t<std::is_unsigned_v<T>, std::uint64_t, T>;
    test::random r(N + 1);
    for (int round = 0; round < 200; ++round) {
      const P a = irg::lanes<P>::generate([&](int) { return halved(test::any_lane_number<T>(r)); });
      const P b = irg::lanes<P>::generate([&](int) { return halved(test::any_lane_number<T>(r)); });
      const auto is = [&](const P& result, auto op) {
        return test::lanes_are(result, [&](int i) { return static_cast<T>(op(wide(a[i]), wide(b[i]))); });
      };
      const auto is_by_one = [&](const P& result, auto op) {
        return test::lanes_are(result, [&](int i) { return static_cast<T>(op(wide(a[i]), wide(b[0]))); });
      };
      REQUIRE(is(a + b, [](wide x, wide y) { return x + y; }));
      REQUIRE(is(a - b, [](wide x, wide y) { return x - y; }));
      REQUIRE(is_by_one(a + b[0], [](wide x, wide y) { return x + y; }));
      REQUIRE(is_by_one(a - b[0], [](wide x, wide y) { return x - y; }));
      REQUIRE(is(-a, [](wide x, wide) { return -x; }));
      const P small = irg::lanes<P>::generate([&](int) { return static_cast<T>(r.integer(0, 2)); });
      if constexpr (std::is_signed_v<T> && std::integral<T>) {
        REQUIRE(test::lanes_are(a * small, [&](int i) { return static_cast<T>(a[i] * small[i]); }));
        REQUIRE(test::lanes_are(a * T(2), [&](int i) { return static_cast<T>(a[i] * 2); }));
      } else {
        REQUIRE(is(a * b, [](wide x, wide y) { return x * y; }));
        REQUIRE(is_by_one(a * b[0], [](wide x, wide y) { return x * y; }));
      }
      if constexpr (std::floating_point<T>) {
        REQUIRE(is(a / b, [](T x, T y) { return x / y; }));
        REQUIRE(is(irg::product(a, b), [](T x, T y) { return x * y; }));
      } else {
        REQUIRE(test::lanes_are(a / (small + T(1)), [&](int i) { return static_cast<T>(a[i] / (small[i] + 1)); }));
      }
    }
  }
};

TEST_CASE("pack: numbers come in and out as they are") { test::for_all_lanes(moves{}); }

TEST_CASE("pack: arithmetic has the bits of the scalar one in every lane") { test::for_all_lanes(arithmetic{}); }

TEST_CASE("pack_of: the numbers in their order") {
  CHECK(test::lanes_are(irg::pack_of(1.5f, -2.0f), [](int i) { return i == 0 ? 1.5f : -2.0f; }));
  const auto p = irg::pack_of(7, 6, 5, 4, 3, 2, 1, 0);
  CHECK(test::lanes_are(p, [](int i) { return 7 - i; }));
}

TEST_CASE("pack: zeros keep their sign, negation turns it") {
  using P = irg::pack<double, 4>;
  const P zero = irg::lanes<P>::broadcast(-0.0);
  for (int i = 0; i < 4; ++i) {
    CHECK(std::signbit(zero[i]));
    CHECK(!std::signbit((-zero)[i]));
  }
}

TEST_CASE("lanes: the scalar forms") {
  CHECK_BOTH(irg::lanes<float>::count == 1);
  CHECK_BOTH(irg::lanes<float>::broadcast(3.5f) == 3.5f);
  CHECK_BOTH(irg::lanes<int>::ramp() == 0);
  CHECK_BOTH(irg::lane(5, 0) == 5);
  CHECK_BOTH([] {
    double x = 0;
    irg::set_lane(x, 0, 2.5);
    return x == 2.5 && irg::lanes<double>::generate([](int i) { return i + 1.0; }) == 1.0;
  }());
}

}  // namespace
