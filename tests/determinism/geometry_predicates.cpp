// SPDX-License-Identifier: MIT
#include <irg/geometry/in_circle.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/orient3d.hpp>
#include <irg/math/exact_sum.hpp>
#include <irg/math/vec.hpp>

#include "hashes.hpp"
#include "support/predicate_points.hpp"

namespace {

/// The signs of a predicate on hard points of all distributions.
template <int M, int D, class Sign>
constexpr std::uint64_t signs(int rounds, test::figure shape, const Sign& sign) {
  test::random r(2026);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    const auto kind = static_cast<test::distribution>(i % test::distribution_count);
    const auto p = test::hard_points<M, D>(kind, shape, r);
    h.add(sign(p));
  }
  return h.value();
}

constexpr std::uint64_t geometry_orient2d(int rounds) {
  return signs<3, 2>(rounds, test::figure::flat, [](const auto& p) { return irg::orient2d(p[0], p[1], p[2]); });
}
constexpr std::uint64_t geometry_orient3d(int rounds) {
  return signs<4, 3>(rounds, test::figure::flat, [](const auto& p) { return irg::orient3d(p[0], p[1], p[2], p[3]); });
}
constexpr std::uint64_t geometry_in_circle(int rounds) {
  return signs<4, 2>(rounds, test::figure::round, [](const auto& p) { return irg::in_circle(p[0], p[1], p[2], p[3]); });
}
constexpr std::uint64_t geometry_in_sphere(int rounds) {
  return signs<5, 3>(rounds, test::figure::round,
                     [](const auto& p) { return irg::in_sphere(p[0], p[1], p[2], p[3], p[4]); });
}

/// Sums of products, rounded once.
constexpr std::uint64_t math_exact_sum(int rounds) {
  test::random r(2026);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    irg::exact_accumulator<3> sum;
    for (int k = 0; k < 4; ++k) {
      const auto number = [&] {
        const double significand = 1 + r.unit();
        return test::scaled(significand, static_cast<int>(r.integer(-1070, 900)) / (1 + k));
      };
      const double x = number(), y = number(), z = r.unit() - 0.5;
      sum.add(x, y, z);
      sum.subtract(x, z);
    }
    h.add(sum.rounded());
    h.add(sum.sign());
  }
  return h.value();
}

HASHED(geometry_orient2d, 33, 100'000);
HASHED(geometry_orient3d, 22, 100'000);
HASHED(geometry_in_circle, 22, 100'000);
HASHED(geometry_in_sphere, 9, 20'000);
HASHED(math_exact_sum, 20, 100'000);

}  // namespace
