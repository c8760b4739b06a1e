// SPDX-License-Identifier: MIT
// A double that is rounded to a float and widened again has lost its low bits, whatever the optimiser makes of the two.
#include <irg/core/conversion.hpp>

#include <cstdint>
#include <cstdio>
#include <type_traits>

#include <doctest/doctest.h>

#include "support/random.hpp"

namespace {

using irg::converted;
using irg::widened;

static_assert(widened(0.1f) == static_cast<double>(0.1f));
static_assert(widened(0.1) == 0.1);
static_assert(widened(-7) == -7.0);
static_assert(converted<float>(0x1.000001p0) == 1.0f);  // a tie, to even
static_assert(converted<float>(0x1.000003p0) == 0x1.000004p0f);
static_assert(converted<float>(0x1.8p-149) == 0x1p-148f);  // subnormal, a tie
static_assert(converted<float>(0x1p-160) == 0.0f);
static_assert(converted<double>(0x1p-149f) == 0x1p-149);
static_assert(converted<int>(2.75) == 2);
static_assert(std::is_same_v<decltype(converted<float>(1.0)), float>);
static_assert(noexcept(widened(1.0f)) && noexcept(converted<float>(1.0)));

// Straight-line code with a pair of each operation, which is what the vectorizer looks for: products are rounded to
// floats that are widened at once.
struct pair {
  double x, y;
};
[[gnu::noinline]] pair by_casts(const double* a) {
  const float x = static_cast<float>(a[0] * 3), y = static_cast<float>(a[1] * 3);
  return {static_cast<double>(x) + 1, static_cast<double>(y) + 1};
}
[[gnu::noinline]] pair caller_rounds(const double* a) {
  const float x = static_cast<float>(a[0] * 3), y = static_cast<float>(a[1] * 3);
  return {widened(x) + 1, widened(y) + 1};
}
[[gnu::noinline]] pair caller_widens(const double* a) {
  const float x = converted<float>(a[0] * 3), y = converted<float>(a[1] * 3);
  return {static_cast<double>(x) + 1, static_cast<double>(y) + 1};
}
// With nothing around the conversions, four together.
[[gnu::noinline]] void four_rounded(const double* a, double* b) {
  const float w = static_cast<float>(a[0]), x = static_cast<float>(a[1]), y = static_cast<float>(a[2]),
              z = static_cast<float>(a[3]);
  b[0] = widened(w), b[1] = widened(x), b[2] = widened(y), b[3] = widened(z);
}

TEST_CASE("conversions: the rounding between two doubles happens, on either side of the call") {
  test::random r(1);
  int wrong = 0, wrong_casts = 0;
  for (int i = 0; i < 100000; ++i) {
    double a[4], b[4];
    for (double& x : a) x = 2 * r.unit() - 1;
    double rounded[4], tripled[2];
    for (int k = 0; k < 4; ++k) {
      const volatile float f = static_cast<float>(a[k]);  // through the memory
      rounded[k] = static_cast<double>(f);
    }
    for (int k = 0; k < 2; ++k) {
      const volatile float f = static_cast<float>(a[k] * 3);
      tripled[k] = static_cast<double>(f) + 1;
    }
    const pair p = caller_rounds(a), q = caller_widens(a), casts = by_casts(a);
    four_rounded(a, b);
    wrong += p.x != tripled[0] || p.y != tripled[1] || q.x != tripled[0] || q.y != tripled[1];
    for (int k = 0; k < 4; ++k) wrong += b[k] != rounded[k];
    wrong_casts += casts.x != tripled[0] || casts.y != tripled[1];
  }
  CHECK(wrong == 0);
  std::printf("plain casts: %d of 100000 pairs unrounded\n", wrong_casts);
}

}  // namespace
