// SPDX-License-Identifier: MIT
// Floats that are rounded from doubles just before the call and widened just after it, several in straight-line code: as
// callers write it, without irg's own conversions.
#include <irg/geometry/barycentric.hpp>
#include <irg/geometry/intersect_lines.hpp>
#include <irg/geometry/triangle_area.hpp>
#include <irg/math/hypot.hpp>
#include <irg/math/length.hpp>
#include <irg/math/lu.hpp>
#include <irg/math/polynomial.hpp>
#include <irg/math/vec.hpp>

#include <array>

#include "hashes.hpp"

namespace {

struct numbers {
  test::random r{41};
  constexpr double operator()() { return 4 * r.unit() - 2; }
};

constexpr float rounded(double x) { return static_cast<float>(x); }
constexpr double widened_again(float x) { return static_cast<double>(x); }

constexpr std::uint64_t conversions(int rounds) {
  numbers next;
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    const double a[] = {next(), next(), next(), next(), next(), next(), next(), next(), next()};
    const irg::vec<float, 4> v{rounded(a[0]), rounded(a[1]), rounded(a[2]), rounded(a[3])};
    const irg::vec<float, 4> w{rounded(a[4] / 3), rounded(a[5] / 3), rounded(a[6] / 3), rounded(a[7] / 3)};
    h.add(widened_again(length(v)) + widened_again(length(w)));
    const auto n = try_normalized(v), m = try_normalized(w);
    if (n && m) {
      for (int k = 0; k < 4; ++k) h.add(widened_again((*n)[k]) * 3 + widened_again((*m)[k]));
    }
    h.add(widened_again(irg::hypot(rounded(a[0] * 5), rounded(a[1] * 5))) * 7);
    const irg::point<float, 2> p{rounded(a[0]), rounded(a[1])}, q{rounded(a[2]), rounded(a[3])},
        s{rounded(a[4]), rounded(a[5])}, t{rounded(a[6]), rounded(a[7])};
    h.add(widened_again(triangle_area(p, q, s)) + widened_again(triangle_area(p, q, t)));
    const std::array<float, 4> c{rounded(a[0]), rounded(a[1]), rounded(a[2]), rounded(a[3])};
    h.add(widened_again(irg::evaluate_polynomial_accurate(c, rounded(a[8]))) - 1);
    const irg::mat<float, 2, 2> e{{{rounded(a[0]), rounded(a[1])}, {rounded(a[2]), rounded(a[3])}}};
    const irg::vec<float, 2> b{rounded(a[4]), rounded(a[5])};
    if (const auto x = lu_solve_refined(e, b)) h.add(widened_again((*x)[0]) + widened_again((*x)[1]));
  }
  return h.value();
}
HASHED(conversions, 4, 3000);

}  // namespace
