// SPDX-License-Identifier: MIT
// The promise on which every other one stands: a product that meets a sum is rounded by itself, under every flag.
// tests/contraction/run builds this file with all contraction settings of all compilers present.
#include <irg/core/contraction.hpp>

#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "support/archetypes.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

// A number from [1, 2) with all its mantissa bits random, scaled by 2^exponent.
template <class T>
T mantissa(test::random& random, int exponent = 0) {
  T x = static_cast<T>(1 + random.unit());
  for (; exponent > 0; --exponent) x *= T(2);
  for (; exponent < 0; ++exponent) x /= T(2);
  return x;
}

// The determinant of two equal rows is 0. The control stays a function of its own: inlined, it may be vectorised before
// it is fused, and right by accident.
template <class T>
IRG_NOINLINE T naive(T a, T b, T c, T d) {
  return a * d - b * c;
}
template <class T>
T guarded(T a, T b, T c, T d) {
  return irg::product(a, d) - irg::product(b, c);
}

template <class T, class F>
int wrong_determinants(F determinant, int cases, int exponent) {
  test::random random(42);
  int wrong = 0;
  for (int i = 0; i < cases; ++i) {
    const T a = mantissa<T>(random, exponent), b = mantissa<T>(random, exponent);
    volatile T second_row[2] = {a, b};  // read back, so that the compiler cannot know the rows to be equal
    volatile T value = determinant(a, b, second_row[0], second_row[1]);  // the difference itself, not x != y
    wrong += value != T(0);
  }
  return wrong;
}

// The sum of products as an array loop, which compilers vectorise, against one step at a time through memory.
template <class T>
int wrong_sums(int cases) {
  constexpr int size = 64;
  test::random random(43);
  int wrong = 0;
  for (int i = 0; i < cases; i += size) {
    T x[size], y[size], z[size], sum[size], difference[size], negated[size];
    for (int k = 0; k < size; ++k) {
      x[k] = mantissa<T>(random);
      y[k] = mantissa<T>(random);
      z[k] = -x[k] * y[k] * mantissa<T>(random);
    }
    for (int k = 0; k < size; ++k) sum[k] = irg::product(x[k], y[k]) + z[k];
    for (int k = 0; k < size; ++k) difference[k] = z[k] - irg::product(x[k], y[k]);
    for (int k = 0; k < size; ++k) negated[k] = -irg::product(x[k], y[k]) - z[k];
    for (int k = 0; k < size; ++k) {
      volatile T a = x[k], b = y[k], c = z[k];
      volatile T p = a * b;
      volatile T s = p + c, d = c - p, n = -p - c;
      wrong += sum[k] != s || difference[k] != d || negated[k] != n;
    }
  }
  return wrong;
}

// Products must not be regrouped with each other either: (x*y)*z is not x*(y*z).
template <class T>
int wrong_chains(int cases) {
  test::random random(44);
  int wrong = 0;
  for (int i = 0; i < cases; ++i) {
    const T x = mantissa<T>(random), y = mantissa<T>(random), z = mantissa<T>(random);
    volatile T vx = x, vy = y, vz = z;
    volatile T p = vx * vy;
    volatile T q = p * vz;
    volatile T r = q + vx;
    wrong += irg::product(irg::product(x, y), z) + x != r;
  }
  return wrong;
}

constexpr double a0 = 1.0000000000000002, b0 = 1.1, c0 = 0.30000000000000004;
constexpr double constant_value = irg::product(a0, b0) - irg::product(c0, a0);
static_assert(irg::product(0.1, 0.1) - irg::product(0.1, 0.1) == 0.0);

}  // namespace

TEST_CASE("contraction: the determinant of two equal rows is exactly 0") {
  const int cases = std::getenv("IRG_RELEASE_TIER") ? 10'000'000 : 1'000'000;
  CHECK(wrong_determinants<double>(guarded<double>, cases, 0) == 0);
  CHECK(wrong_determinants<float>(guarded<float>, cases, 0) == 0);
  CHECK(wrong_determinants<double>(guarded<double>, cases / 10, 500) == 0);
  CHECK(wrong_determinants<double>(guarded<double>, cases / 10, -500) == 0);
  // The control, for tests/contraction/run: what the same flags do to the expression without the guard.
  std::printf("naive: double %d float %d of %d\n", wrong_determinants<double>(naive<double>, cases, 0),
              wrong_determinants<float>(naive<float>, cases, 0), cases);
}

TEST_CASE("contraction: loops over arrays round each product") {
  CHECK(wrong_sums<double>(200'000) == 0);
  CHECK(wrong_sums<float>(200'000) == 0);
}

TEST_CASE("contraction: products keep their order") {
  CHECK(wrong_chains<double>(200'000) == 0);
  CHECK(wrong_chains<float>(200'000) == 0);
}

TEST_CASE("contraction: constant evaluation and run time agree") {
  volatile double a = a0, b = b0, c = c0;
  CHECK(irg::product<double>(a, b) - irg::product<double>(c, a) == constant_value);
}

TEST_CASE("contraction: other numbers pass through") {
  CHECK_BOTH(irg::product(6, 7) == 42);
  CHECK_BOTH(irg::product(std::int64_t{1} << 31, std::int64_t{1} << 31) == std::int64_t{1} << 62);
  CHECK_BOTH(irg::product(archetype::scalar(6), archetype::scalar(7)) == archetype::scalar(42));
  CHECK_BOTH(irg::opaque(2.5) == 2.5);
  CHECK_BOTH(irg::opaque(2.5f) == 2.5f);
}
