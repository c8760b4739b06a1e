// SPDX-License-Identifier: MIT
#include <irg/math/exact_matrix.hpp>
#include <irg/math/inverse.hpp>
#include <irg/math/solve_exact.hpp>

#include "hashes.hpp"

namespace {

/// Entries between -1 and 1; every third matrix is close to singular.
template <class T, int N>
constexpr irg::mat<T, N, N> random_mat(test::random& r, int i) {
  irg::mat<T, N, N> a{};
  for (auto& row : a.m)
    for (T& entry : row) entry = static_cast<T>(2 * r.unit() - 1);
  if (i % 3 == 0)
    for (int c = 0; c < N; ++c) a(0, c) = a(1, c) + irg::product(a(0, c), T(0.0001));
  return a;
}

template <class T>
constexpr std::uint64_t inverses(int rounds) {
  test::random r(5);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    const auto a = random_mat<T, 4>(r, i);
    const auto x = inverse(a), y = inverse_accurate(a), z = inverse_exact(a);
    const auto fast = inverse_fast(a);
    for (int k = 0; k < 16; ++k) {
      h.add(fast(k / 4, k % 4));
      h.add(x ? (*x)(k / 4, k % 4) : T(0));
      h.add(y ? (*y)(k / 4, k % 4) : T(0));
      h.add(z ? (*z)(k / 4, k % 4) : T(0));
    }
    h.add(reciprocal_condition(a));
    h.add(determinant_exact(a));
  }
  return h.value();
}

template <class T>
constexpr std::uint64_t systems(int rounds) {
  test::random r(6);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    const auto a = random_mat<T, 3>(r, i);
    const irg::vec<T, 3> b{static_cast<T>(r.unit()), static_cast<T>(r.unit()), 1};
    const auto x = solve_gauss(a, b), y = solve_exact(a, b);
    const auto z = lu_solve_refined(a, b);
    h.add(static_cast<int>(x.status) * 8 + static_cast<int>(y.status));
    for (int k = 0; k < 3; ++k) {
      h.add(x.x[k]);
      h.add(y.x[k]);
      h.add(z ? (*z)[k] : T(0));
    }
  }
  return h.value();
}

constexpr std::uint64_t math_inverse_float(int rounds) { return inverses<float>(rounds); }
constexpr std::uint64_t math_inverse_double(int rounds) { return inverses<double>(rounds); }
constexpr std::uint64_t math_solve_float(int rounds) { return systems<float>(rounds); }
constexpr std::uint64_t math_solve_double(int rounds) { return systems<double>(rounds); }
HASHED(math_inverse_float, 3, 1000);
HASHED(math_inverse_double, 3, 1000);
HASHED(math_solve_float, 4, 2000);
HASHED(math_solve_double, 4, 2000);

}  // namespace
