// SPDX-License-Identifier: MIT
// Differences of products, dot and cross products under growing cancellation: run time against error.
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <irg/math/compensated.hpp>
#include <irg/math/double_double.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/vec.hpp>

#include "accuracy/matrix_peers.hpp"
#include "accuracy/vector_sets.hpp"

#ifdef IRG_HAVE_CGAL
#include <CGAL/Simple_cartesian.h>
#endif

#ifdef BENCH_HAS_MPFR

namespace {

using bench::real;
using vec3 = irg::vec<double, 3>;
using vec4 = irg::vec<double, 4>;
std::size_t count() { return bench::smoke() ? 16 : 4096; }

struct products {
  double a, b, c, d;
};
template <class V>
struct pair_of {
  V a, b;
};

struct product_set {
  std::string name;
  std::vector<products> items;
};

// a*b and c*d are equal but for 1 in 2^bits or so.
std::vector<products> nearly_equal(int bits) {
  bench::random_numbers r(3);
  std::vector<products> all;
  for (std::size_t i = 0; i < count(); ++i) {
    const double a = r.of_exponent(-10, 10), b = r.of_exponent(-10, 10), c = r.of_exponent(-10, 10);
    all.push_back({a, b, c, a * b / c * (1 + std::ldexp(r.between(-1, 1), -bits))});
  }
  return all;
}

template <class F>
std::vector<products> made(F next) {
  bench::random_numbers r(7);
  std::vector<products> all;
  for (std::size_t i = 0; i < count(); ++i) all.push_back(next(r));
  return all;
}

std::vector<product_set> product_sets() {
  std::vector<product_set> all;
  for (const int bits : {0, 20, 45, 60})
    all.push_back({bits == 0 ? "unlike" : "equal to 2^-" + std::to_string(bits), nearly_equal(bits)});
  all.push_back({"exactly equal", made([](bench::random_numbers& r) {
                   const double a = r.between(1, 2), b = r.between(1, 2);
                   return products{a, b, b, a};
                 })});
  all.push_back({"a product overflows or nearly", made([](bench::random_numbers& r) {
                   return products{r.of_exponent(511, 512), r.of_exponent(510, 512), r.of_exponent(511, 512),
                                   r.of_exponent(510, 512)};
                 })});
  return all;
}

double in_double_double(const products& p) {
  using irg::double_double;
  return (double_double(p.a) * double_double(p.b) - double_double(p.c) * double_double(p.d)).high;
}

void difference_of_products() {
  bench::study s("difference of products", "a*b - c*d", bench::error_unit::ulp);
  for (const auto& [name, items] : bench::keep(product_sets())) {
    const auto exact = [](const products& p, bench::exact_results& out) {
      out.push_back((real(p.a) * p.b - real(p.c) * p.d).result());
    };
    const bench::distribution d{name, items.size(), 1, bench::exact_for(items, exact)};
    s.panel(d,
            {bench::for_each_item("irg", items,
                                  [](const products& p) { return irg::difference_of_products(p.a, p.b, p.c, p.d); }),
             bench::for_each_item("plain", items, [](const products& p) { return p.a * p.b - p.c * p.d; }),
             bench::for_each_item("Kahan with FMA", items,
                                  [](const products& p) {
                                    const double right = p.c * p.d, error = std::fma(-p.c, p.d, right);
                                    return std::fma(p.a, p.b, -right) + error;
                                  }),
             bench::for_each_item("in double_double", items, in_double_double)},
            bench::text_of_items(items));
  }
}

// Vectors whose dot product is about 2^-bits of the sum of the sizes of its terms.
std::vector<pair_of<vec4>> cancelling(int bits) {
  bench::random_numbers r(4);
  std::vector<pair_of<vec4>> all;
  for (std::size_t i = 0; i < count(); ++i) {
    vec4 a, b;
    for (int k = 0; k < 4; ++k) a[k] = r.of_exponent(-3, 3), b[k] = r.of_exponent(-3, 3);
    if (bits > 0) {  // the last two terms take away what the first two have, in two steps
      const real head = real(a.x) * b.x + real(a.y) * b.y;
      b.z = (-head / real(a.z)).nearest();
      const real rest = head + real(a.z) * b.z;
      const double left = std::ldexp(r.between(0.5, 1), -bits);
      b.w = ((real(left) - rest) / real(a.w)).nearest();
    }
    all.push_back({a, b});
  }
  return all;
}

void dot_product() {
  bench::study s("dot product", "dot of 4 coordinates", bench::error_unit::ulp);
  for (const int bits : {0, 20, 40, 90, 1000}) {
    auto& items = bench::keep(cancelling(bits < 1000 ? bits : 0));
    if (bits == 1000)
      for (auto& [a, b] : items) b = {a.y, -a.x, a.w, -a.z};
    const auto exact = [](const pair_of<vec4>& p, bench::exact_results& out) {
      const auto& [a, b] = p;
      out.push_back((real(a.x) * b.x + real(a.y) * b.y + real(a.z) * b.z + real(a.w) * b.w).result());
    };
    const bench::distribution d{bits == 0      ? "any vectors"
                                : bits == 1000 ? "exactly 0"
                                               : "cancels to 2^-" + std::to_string(bits),
                                items.size(), 1, bench::exact_for(items, exact)};
    std::vector<bench::implementation> all{
        bench::for_each_item("irg", items, [](const auto& p) { return irg::dot(p.a, p.b); }),
        bench::for_each_item("irg: dot_fast", items, [](const auto& p) { return irg::dot_fast(p.a, p.b); }),
        bench::for_each_item("irg: dot_accurate", items, [](const auto& p) { return irg::dot_accurate(p.a, p.b); }),
        bench::for_each_item("irg: dot_exact", items, [](const auto& p) { return irg::dot_exact(p.a, p.b); })};
#ifdef IRG_HAVE_GLM
    all.push_back(bench::for_each_item("GLM", items, [](const auto& p) {
      return glm::dot(glm::dvec4(p.a.x, p.a.y, p.a.z, p.a.w), glm::dvec4(p.b.x, p.b.y, p.b.z, p.b.w));
    }));
#endif
#ifdef IRG_HAVE_EIGEN
    all.push_back(bench::for_each_item("Eigen", items, [](const auto& p) {
      return Eigen::Vector4d(p.a.x, p.a.y, p.a.z, p.a.w).dot(Eigen::Vector4d(p.b.x, p.b.y, p.b.z, p.b.w));
    }));
#endif
    s.panel(d, all, bench::text_of_items(items));
  }
}

// Vectors that are parallel but for 1 in 2^bits.
std::vector<pair_of<vec3>> nearly_parallel(int bits) {
  bench::random_numbers r(6);
  std::vector<pair_of<vec3>> all;
  for (std::size_t i = 0; i < count(); ++i) {
    vec3 a, b;
    const double scale = r.of_exponent(-4, 4);
    for (int k = 0; k < 3; ++k) {
      a[k] = r.of_exponent(-2, 2);
      b[k] = bits == 0 ? r.of_exponent(-2, 2) : a[k] * scale * (1 + std::ldexp(r.between(-1, 1), -bits));
    }
    all.push_back({a, b});
  }
  return all;
}

void cross_product() {
  bench::study s("cross product", "cross", bench::error_unit::ulp);
  for (const int bits : {0, 20, 45, 1000}) {
    auto& items = bench::keep(nearly_parallel(bits < 1000 ? bits : 0));
    if (bits == 1000)
      for (auto& [a, b] : items) b = a;
    const auto exact = [](const pair_of<vec3>& p, bench::exact_results& out) {
      for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        out.push_back((real(p.a[j]) * p.b[k] - real(p.a[k]) * p.b[j]).result());
      }
    };
    const bench::distribution d{bits == 0      ? "any vectors"
                                : bits == 1000 ? "a vector and itself"
                                               : "parallel to 2^-" + std::to_string(bits),
                                items.size(), 3, bench::exact_for(items, exact)};
    std::vector<bench::implementation> all{
        bench::for_each_vector<3>("irg", items, [](const auto& p) { return irg::cross(p.a, p.b); }),
        bench::for_each_vector<3>("irg: cross_fast", items, [](const auto& p) { return irg::cross_fast(p.a, p.b); }),
        bench::for_each_vector<3>("irg: cross_accurate", items,
                                  [](const auto& p) { return irg::cross_accurate(p.a, p.b); })};
#ifdef IRG_HAVE_CGAL
    all.push_back(bench::for_each_vector<3>("CGAL", items, [](const auto& p) {
      using vector = CGAL::Simple_cartesian<double>::Vector_3;
      const vector c = CGAL::cross_product(vector(p.a.x, p.a.y, p.a.z), vector(p.b.x, p.b.y, p.b.z));
      return std::array<double, 3>{c.x(), c.y(), c.z()};
    }));
#endif
#ifdef IRG_HAVE_GLM
    all.push_back(bench::for_each_vector<3>("GLM", items, [](const auto& p) {
      return glm::cross(glm::dvec3(p.a.x, p.a.y, p.a.z), glm::dvec3(p.b.x, p.b.y, p.b.z));
    }));
#endif
#ifdef IRG_HAVE_EIGEN
    all.push_back(bench::for_each_vector<3>("Eigen", items, [](const auto& p) {
      const Eigen::Vector3d a(p.a.x, p.a.y, p.a.z), b(p.b.x, p.b.y, p.b.z);
      const Eigen::Vector3d c = a.cross(b);
      return std::array<double, 3>{c[0], c[1], c[2]};
    }));
#endif
    s.panel(d, all, bench::text_of_items(items));
  }
}

}  // namespace

int main(int argc, char** argv) {
  difference_of_products();
  dot_product();
  cross_product();
  return bench::run_benchmarks(argc, argv);
}

#else
#include <cstdio>
int main() { std::puts("accuracy_products: skipped, MPFR was not found"); }
#endif
