// SPDX-License-Identifier: MIT
#include <irg/math/vector_batch.hpp>

#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/same_bits.hpp"

using irg::vec;
using test::same_bits;

namespace {

// Ordinary numbers, numbers of all sizes, and what has no direction.
template <class T>
T number(test::random& r) {
  using limits = std::numeric_limits<T>;
  constexpr T special[] = {
      T(0),          -T(0),        limits::infinity(), -limits::infinity(), limits::quiet_NaN(), limits::denorm_min(),
      limits::min(), limits::max()};
  switch (r.integer(0, 7)) {
    case 0: return special[r.integer(0, 7)];
    case 1: return static_cast<T>(std::ldexp(2 * r.unit() - 1, static_cast<int>(r.integer(-140, 127))));
    default: return static_cast<T>(2 * r.unit() - 1);
  }
}
template <class T>
std::vector<vec<T, 3>> many(test::random& r, std::size_t n) {
  std::vector<vec<T, 3>> all(n, vec<T, 3>{});
  for (auto& v : all)
    if (r.integer(0, 30) != 0) v = {number<T>(r), number<T>(r), number<T>(r)};
  return all;
}

// All four functions on n vectors, the results between guards, then in place.
template <class T>
int wrong_results(std::size_t n, test::random& r) {
  using v3 = vec<T, 3>;
  const auto a = many<T>(r, n), b = many<T>(r, n);
  int wrong = 0;
  std::vector<T> dots(n + 2, T(7));
  dot_products(a, b, std::span<T>(dots).subspan(1, n));
  wrong += dots.front() != T(7) || dots.back() != T(7);
  for (std::size_t i = 0; i < n; ++i) wrong += !same_bits(dots[i + 1], dot(a[i], b[i]));
  const auto judge = [&](auto batch, auto one) {
    std::vector<v3> out(n + 2, v3{7, 8, 9});
    batch(std::span<v3>(out).subspan(1, n));
    wrong += out.front() != v3{7, 8, 9} || out.back() != v3{7, 8, 9};
    for (std::size_t i = 0; i < n; ++i) wrong += !same_bits(out[i + 1], one(i));
  };
  judge([&](auto out) { cross_products(a, b, out); }, [&](std::size_t i) { return cross(a[i], b[i]); });
  judge([&](auto out) { normalize_vectors(a, out); }, [&](std::size_t i) { return normalized(a[i]); });
  judge([&](auto out) { normalize_vectors_fast(a, out); }, [&](std::size_t i) { return normalized_fast(a[i]); });
  auto c = a;
  cross_products(c, b, c);
  auto d = a;
  normalize_vectors(d, d);
  for (std::size_t i = 0; i < n; ++i) wrong += !same_bits(c[i], cross(a[i], b[i])) + !same_bits(d[i], normalized(a[i]));
  return wrong;
}

template <class T>
constexpr bool in_constant_evaluation() {
  std::array<vec<T, 3>, 5> a{}, b{}, c{}, d{};
  std::array<T, 5> dots{};
  for (std::size_t i = 0; i < 5; ++i) {
    a[i] = {T(i) / 3, T(1) / T(i + 1), T(-2)};
    b[i] = {T(i) / 7, T(3), T(i) / 11};
  }
  dot_products(a, b, dots);
  cross_products(a, b, c);
  normalize_vectors(a, d);
  normalize_vectors_fast(b, b);
  return dots[4] == dot(a[4], vec<T, 3>{T(4) / 7, T(3), T(4) / 11}) && d[3] == normalized(a[3]) &&
         c[0] == cross(a[0], vec<T, 3>{0, 3, 0}) && b[0] == vec<T, 3>{0, 1, 0};
}

}  // namespace

TEST_CASE("vector batches: the bits of one by one, for every size") {
  test::random r(1);
  for (std::size_t n = 0; n <= 70; ++n) {
    CHECK(wrong_results<float>(n, r) == 0);
    CHECK(wrong_results<double>(n, r) == 0);
  }
  const std::size_t many_of_them = std::getenv("IRG_RELEASE_TIER") ? 10'000'000 : 50'003;
  CHECK(wrong_results<float>(many_of_them, r) == 0);
  CHECK(wrong_results<double>(many_of_them, r) == 0);
}

TEST_CASE("vector batches: constant evaluation") {
  CHECK_BOTH(in_constant_evaluation<float>());
  CHECK_BOTH(in_constant_evaluation<double>());
}

TEST_CASE("vector batches: arrays of any kind") {
  const vec<float, 3> a[] = {{1, 2, 3}, {4, 5, 6}};
  const std::array<vec<float, 3>, 2> b{{{1, 1, 1}, {1, 0, 0}}};
  std::vector<float> out(2, 0.f);
  dot_products(a, b, out);
  CHECK(out == std::vector<float>{6, 4});
  static_assert(!irg::VectorArray<std::vector<float>> && !irg::VectorArray<std::vector<vec<int, 3>>>);
  static_assert(irg::VectorArray<std::vector<vec<float, 3>>> && irg::VectorArray<std::span<const vec<double, 3>>>);
}
