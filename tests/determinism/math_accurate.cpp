// SPDX-License-Identifier: MIT
// Sums and products in twice the precision, double-double, expansions, intervals, polynomials and roots.
#include <irg/geometry/triangle_area.hpp>
#include <irg/math/compensated.hpp>
#include <irg/math/double_double.hpp>
#include <irg/math/expansion.hpp>
#include <irg/math/interval.hpp>
#include <irg/math/polynomial.hpp>
#include <irg/math/roots.hpp>
#include <irg/math/vec.hpp>

#include "hashes.hpp"

namespace {

using determinism::hasher;

/// By turns any finite double, one of a size from 2^-19 to 2^20, a small integer.
constexpr double number(test::random& r) {
  switch (r.integer(0, 2)) {
    case 0: {
      const std::uint64_t bits = r.next();
      // Not so large that the plain operations of double-double and intervals overflow: that is no constant.
      return std::bit_cast<double>((bits & 0x800fffffffffffffu) | (bits % 1500) << 52);
    }
    case 1: {
      const double scale = static_cast<double>(std::int64_t{1} << r.integer(0, 39)) * 0x1p-19;
      return (r.unit() - 0.5) * scale;
    }
    default: return static_cast<double>(r.integer(-9, 9));
  }
}

constexpr irg::vec<double, 3> vector(test::random& r) {
  const double x = number(r), y = number(r), z = number(r);
  return {x, y, z};
}

template <class Roots>
constexpr void add(hasher& h, const Roots& roots) {
  h.add(roots.count);
  for (int i = 0; i < roots.count; ++i) h.add(roots.root[i]);
}

constexpr std::uint64_t math_compensated(int rounds) {
  test::random r(31);
  hasher h;
  for (int i = 0; i < rounds; ++i) {
    const irg::vec<double, 3> a = vector(r), b = vector(r);
    h.add(irg::dot_accurate(a, b));
    h.add(irg::dot_exact(a, b));
    for (int k = 0; k < 3; ++k) {
      h.add(irg::cross_accurate(a, b)[k]);
      h.add(irg::detail::nearest_cross(a, b)[k]);
    }
    const double terms[]{a.x, b.y, -a.x, b.z, a.z, -b.y};
    h.add(irg::sum_accurate(std::span<const double>(terms)));
    h.add(irg::sum_exact(std::span<const double>(terms)));
    const irg::point<double, 3> p{a.x, a.y, a.z}, q{b.x, b.y, b.z}, s{b.y, a.z, a.x};
    h.add(irg::triangle_area(p, q, s));
    h.add(irg::signed_triangle_area(irg::point<double, 2>{p.x, p.y}, irg::point<double, 2>{q.x, q.y},
                                    irg::point<double, 2>{s.x, s.y}));
    const double first = 1 + r.unit(), second = 1 + r.unit() * 0x1p-30;
    h.add(irg::triangle_area_from_sides(first, second, 2.0).value_or(-1));
  }
  return h.value();
}
HASHED(math_compensated, 2, 5000);

constexpr std::uint64_t math_double_double(int rounds) {
  test::random r(32);
  hasher h;
  const auto add_words = [&](const auto& x) {
    h.add(x.high);
    h.add(x.low);
  };
  for (int i = 0; i < rounds; ++i) {
    const double first = number(r), rest = r.unit(), second = number(r);
    const irg::double_double x = irg::double_double(first) + rest * 0x1p-60, y = second + irg::double_double(1) / 3;
    add_words(x + y);
    add_words(x * y * 0x1p-500);
    add_words(x / (y + 0x1p-300));
    add_words(sqrt(abs(x)));
    const irg::double_word<float> u = irg::double_word<float>(static_cast<float>(r.unit())) + 0x1p-30f;
    add_words(u * u / (u + 1));
    const irg::interval<double> a(number(r)), b(number(r));
    for (const irg::interval<double>& c : {a + b, a * b * 0x1p-500, a / (b + 0.3), sqrt(a), square(b * 0x1p-300)}) {
      h.add(c.lower());
      h.add(c.upper());
    }
    const double p = r.unit() - 0.5, q = r.unit() * 0x1p-40, s = r.unit();
    const auto e = irg::exact_sum_of(p, q) * irg::exact_difference_of(s, q) - irg::exact_product_of(p, s);
    h.add(irg::sign(e));
    h.add(irg::estimate(irg::compress(e)));
  }
  return h.value();
}
HASHED(math_double_double, 2, 5000);

constexpr std::uint64_t math_roots(int rounds) {
  test::random r(33);
  hasher h;
  for (int i = 0; i < rounds; ++i) {
    const double a = number(r), b = number(r), c = number(r), d = number(r);
    const double x = r.unit(), y = x + r.unit() * 0x1p-30, z = r.unit();
    add(h, irg::quadratic_roots(a, b, c));
    add(h, irg::quadratic_roots(1.0, -(x + y), irg::product(x, y)));
    add(h, irg::cubic_roots(a, b, c, d));
    add(h, irg::cubic_roots(1.0, -(x + y + z), irg::product(x, y) + irg::product(y, z) + irg::product(z, x),
                            -irg::product(irg::product(x, y), z)));
    add(h, irg::cubic_roots(x, y, z, -x - z));
    const std::array<double, 4> p{d, c, b, a};
    h.add(irg::evaluate_polynomial_accurate(p, x));
    h.add(irg::evaluate_polynomial_exact(p, z));
    h.add(irg::polynomial_sign(p, y));
  }
  return h.value();
}
HASHED(math_roots, 1, 3000);

}  // namespace
