// SPDX-License-Identifier: MIT
#include <irg/math/inverse.hpp>
#include <irg/math/transform_points.hpp>
#include <irg/math/vec.hpp>
#include <irg/math/vector_batch.hpp>

#include "hashes.hpp"

namespace {

/// Coordinates between -1 and 1 of very different sizes, so that rounding errors and fused products show.
template <class T>
constexpr irg::vec<T, 3> random_vec(test::random& r) {
  const auto coordinate = [&] {
    const double scale = 1.0 / static_cast<double>(std::int64_t{1} << r.integer(0, 20));
    return static_cast<T>((2 * r.unit() - 1) * scale);
  };
  const T x = coordinate(), y = coordinate(), z = coordinate();
  return {x, y, z};
}

template <class T>
constexpr std::uint64_t products(int rounds) {
  test::random r(2026);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    const auto a = random_vec<T>(r), b = random_vec<T>(r);
    const auto c = irg::cross(a, b) * irg::dot(a, b) + a / T(3) - b;
    for (int k = 0; k < 3; ++k) h.add(c[k]);
  }
  return h.value();
}

constexpr std::uint64_t math_vec_float(int rounds) { return products<float>(rounds); }
constexpr std::uint64_t math_vec_double(int rounds) { return products<double>(rounds); }
HASHED(math_vec_float, 20, 100'000);
HASHED(math_vec_double, 20, 100'000);

}  // namespace

namespace {

/// Plain loops over arrays, which compilers like to vectorise and fuse.
template <class T>
constexpr std::uint64_t loops(int rounds) {
  constexpr std::size_t n = 64;
  T a[n]{}, b[n]{}, c[n]{};
  test::random r(11);
  determinism::hasher h;
  for (int k = 0; k < rounds; ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      a[i] = static_cast<T>(r.unit());
      b[i] = static_cast<T>(r.unit());
      c[i] = static_cast<T>(r.unit());
    }
    for (std::size_t i = 0; i < n; ++i) a[i] = irg::product(a[i], b[i]) + irg::product(c[i], b[i]);
    for (std::size_t i = 0; i < n; ++i) b[i] = irg::product(a[i], c[i]) - b[i];
    for (std::size_t i = 0; i < n; ++i) h.add(a[i] + b[i]);
  }
  return h.value();
}

constexpr std::uint64_t math_product_in_loops_float(int rounds) { return loops<float>(rounds); }
constexpr std::uint64_t math_product_in_loops_double(int rounds) { return loops<double>(rounds); }
HASHED(math_product_in_loops_float, 1, 1000);
HASHED(math_product_in_loops_double, 1, 1000);

}  // namespace

namespace {

/// Chains of products, quick inverses and arrays of points: lanes where there are some.
template <class T>
constexpr std::uint64_t matrices(int rounds) {
  test::random r(5);
  determinism::hasher h;
  const auto number = [&] { return static_cast<T>(2 * r.unit() - 1); };
  irg::mat<T, 4, 4> chain = irg::identity_matrix<T, 4>();
  for (int i = 0; i < rounds; ++i) {
    irg::mat<T, 4, 4> a;
    for (auto& row : a.m)
      for (T& entry : row) entry = number() / 2;
    chain = i % 8 == 0 ? a : chain * a;
    const auto undo = irg::inverse_fast(a);
    irg::point<T, 3> points[19]{};
    irg::vec<T, 3> units[19]{};
    for (auto& p : points) p = {number(), number(), number()};
    irg::transform_points(a, points, points);
    for (int k = 0; k < 19; ++k) units[k] = to_vec(points[k]);
    irg::normalize_vectors(units, units);
    irg::vec<T, 3> turned[19]{};
    for (int k = 0; k < 19; ++k) turned[k] = units[18 - k];
    irg::cross_products(units, turned, units);
    const auto image = chain * irg::vec<T, 4>{number(), number(), number(), 1};
    for (int k = 0; k < 16; ++k) {
      h.add(chain(k / 4, k % 4));
      h.add(undo(k / 4, k % 4));
      h.add(points[k + 3].y);
      h.add(units[k].z);
    }
    h.add(image.w);
  }
  return h.value();
}

constexpr std::uint64_t math_matrices_float(int rounds) { return matrices<float>(rounds); }
constexpr std::uint64_t math_matrices_double(int rounds) { return matrices<double>(rounds); }
HASHED(math_matrices_float, 2, 10'000);
HASHED(math_matrices_double, 2, 10'000);

}  // namespace
