// SPDX-License-Identifier: MIT
#include <irg/raster/depth_options.hpp>

#include <cstdint>
#include <limits>

#include "support/check_both.hpp"

namespace {

using irg::depth_test;
using irg::depth_write;
using irg::nearer_is_greater;
using irg::nearer_is_less;
using irg::passes;

constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
constexpr float values[] = {nan, -inf, -1.0f, -0.0f, 0.0f, 1e-45f, 0.5f, 1.0f, inf};

static_assert(irg::DepthPolicy<irg::depth_policy<>>);
static_assert(irg::DepthPolicy<irg::depth_policy<depth_test::equal, depth_write::off>>);
static_assert(!irg::DepthPolicy<nearer_is_less>);
static_assert(irg::depth_policy<>::test == depth_test::nearer && irg::depth_policy<>::write == depth_write::on);
static_assert(noexcept(passes<depth_test::nearer, nearer_is_less>(1.0f, 2.0f)));

// What each test says in words, written with the built-in comparisons.
constexpr bool expected(depth_test test, bool greater_wins, float a, float b) {
  if (a != a || test == depth_test::never) return false;
  if (test == depth_test::always) return true;
  const bool nearer = greater_wins ? a > b : a < b;
  return test == depth_test::nearer ? nearer : test == depth_test::equal ? a == b : nearer || a == b;
}

// Calls check.operator()<Test, Order>(greater_wins) for every pair of the two.
template <class Check>
constexpr bool for_all(const Check& check) {
  const auto with = [&]<class Order>(bool greater_wins) {
    return check.template operator()<depth_test::nearer, Order>(greater_wins) &&
           check.template operator()<depth_test::nearer_or_equal, Order>(greater_wins) &&
           check.template operator()<depth_test::equal, Order>(greater_wins) &&
           check.template operator()<depth_test::always, Order>(greater_wins) &&
           check.template operator()<depth_test::never, Order>(greater_wins);
  };
  return with.template operator()<nearer_is_greater>(true) && with.template operator()<nearer_is_less>(false);
}

constexpr auto numbers = []<depth_test Test, class Order>(bool greater_wins) {
  for (const float a : values)
    for (const float b : values)
      if (passes<Test, Order>(a, b) != expected(Test, greater_wins, a, b)) return false;
  return true;
};

TEST_CASE("depth tests: all tests, both orders, NaN, infinities and both zeros") { CHECK_BOTH(for_all(numbers)); }

TEST_CASE("depth tests: packs lane by lane as numbers") {
  constexpr int count = irg::native_lanes<float>;
  using pack = irg::pack<float, count>;
  const auto lanes = []<depth_test Test, class Order>(bool greater_wins) {
    for (const float b : values) {
      float a[count];
      for (int first = 0; first < 9; ++first) {
        for (int i = 0; i < count; ++i) a[i] = values[(first + i) % 9];
        const pack depth = irg::lanes<pack>::load(a), stored = irg::lanes<pack>::broadcast(b == b ? b : 0.25f);
        const auto mask = passes<Test, Order>(depth, stored);
        for (int i = 0; i < count; ++i) {
          const bool pass = expected(Test, greater_wins, a[i], stored[i]);
          if (((irg::mask_bits(mask) >> i) & 1u) != (pass ? 1u : 0u)) return false;
        }
      }
    }
    return true;
  };
  CHECK(for_all(lanes));
}

TEST_CASE("depth tests: a stored NaN lets nothing pass but always") {
  CHECK_BOTH(!passes<depth_test::nearer, nearer_is_greater>(1.0f, nan));
  CHECK_BOTH(!passes<depth_test::nearer_or_equal, nearer_is_less>(1.0f, nan));
  CHECK_BOTH(!passes<depth_test::equal, nearer_is_less>(nan, nan));
  CHECK_BOTH(passes<depth_test::always, nearer_is_less>(1.0f, nan));
}

TEST_CASE("depth tests: integers, as fixed formats keep them") {
  CHECK_BOTH(passes<depth_test::nearer, nearer_is_less>(std::uint16_t{3}, std::uint16_t{4}));
  CHECK_BOTH(!passes<depth_test::nearer, nearer_is_greater>(std::uint32_t{3}, std::uint32_t{4}));
  CHECK_BOTH(passes<depth_test::nearer_or_equal, nearer_is_greater>(std::uint32_t{4}, std::uint32_t{4}));
}

TEST_CASE("depth tests: drawing order passes everything but NaN, whatever the test compares") {
  CHECK_BOTH(passes<depth_test::nearer, irg::drawing_order>(0.0f, 1.0f));
  CHECK_BOTH(passes<depth_test::nearer_or_equal, irg::drawing_order>(1.0f, 0.0f));
  CHECK_BOTH(!passes<depth_test::nearer, irg::drawing_order>(nan, 1.0f));
}

TEST_CASE("depth tests: a background at the cleared depth passes where nearer_or_equal asks") {
  CHECK_BOTH(!passes<depth_test::nearer, nearer_is_greater>(0.0f, nearer_is_greater::farthest));
  CHECK_BOTH(passes<depth_test::nearer_or_equal, nearer_is_greater>(0.0f, nearer_is_greater::farthest));
  CHECK_BOTH(!passes<depth_test::nearer, nearer_is_less>(1.0f, nearer_is_less::farthest));
  CHECK_BOTH(passes<depth_test::nearer_or_equal, nearer_is_less>(1.0f, nearer_is_less::farthest));
}

}  // namespace
