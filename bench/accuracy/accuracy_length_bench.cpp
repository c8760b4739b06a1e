// SPDX-License-Identifier: MIT
// Lengths and unit vectors over the whole range of doubles: run time against error.
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <irg/math/double_double.hpp>
#include <irg/math/length.hpp>
#include <irg/math/vec.hpp>

#include "accuracy/matrix_peers.hpp"
#include "accuracy/vector_sets.hpp"

#ifdef BENCH_HAS_MPFR

namespace {

using bench::real;
using vec3 = irg::vec<double, 3>;

struct set {
  std::string name;
  std::vector<vec3> vectors;
};

std::vector<set> sets() {
  const std::size_t n = bench::smoke() ? 16 : 4096;
  std::vector<set> all;
  const auto add = [&](const std::string& name, auto next) {
    bench::random_numbers r(9);
    set s{name, {}};
    for (std::size_t i = 0; i < n; ++i) s.vectors.push_back(next(r));
    all.push_back(s);
  };
  const auto of_size = [](int exponent) {
    return [exponent](bench::random_numbers& r) {
      const auto c = [&] { return std::ldexp(r.between(-1, 1), exponent); };
      return vec3{c(), c(), c()};
    };
  };
  add("sizes of about 1", of_size(0));
  add("one coordinate rules",
      [](bench::random_numbers& r) { return vec3{r.between(0.5, 1), r.of_exponent(-40, -1), r.of_exponent(-40, -1)}; });
  add("equal coordinates", [](bench::random_numbers& r) {
    const double c = r.of_exponent(-3, 3);
    return vec3{c, c, -c};
  });
  add("one or two are 0", [](bench::random_numbers& r) {
    vec3 v{};
    const int axis = r.integer(0, 2);
    v[axis] = r.between(-1, 1);
    if (r.integer(0, 1) == 0) v[(axis + 1) % 3] = r.between(-1, 1);
    return v;
  });
  add("2^1020", of_size(1020));
  add("2^-500", of_size(-500));
  add("2^-1050 (subnormal)", of_size(-1050));
  return all;
}

real true_length(const vec3& v) { return sqrt(real(v.x) * v.x + real(v.y) * v.y + real(v.z) * v.z); }

[[maybe_unused]] auto eigen_of(const vec3& v) {
#ifdef IRG_HAVE_EIGEN
  return Eigen::Vector3d(v.x, v.y, v.z);
#else
  return v;
#endif
}

double by_largest(const vec3& v) {
  const double largest = std::fmax(std::fmax(std::fabs(v.x), std::fabs(v.y)), std::fabs(v.z));
  if (largest == 0) return 0;
  const double x = v.x / largest, y = v.y / largest, z = v.z / largest;
  return largest * std::sqrt(x * x + y * y + z * z);
}

// From the single-precision root of the squares' reciprocal, by two of Newton's steps.
double by_newton(const vec3& v) {
  const double squares = v.x * v.x + v.y * v.y + v.z * v.z;
  double root = static_cast<double>(1 / std::sqrt(static_cast<float>(squares)));
  for (int step = 0; step < 2; ++step) root *= 1.5 - 0.5 * squares * root * root;
  return squares * root;
}

double in_double_double(const vec3& v) {
  using irg::double_double;
  double_double squares = double_double(v.x) * double_double(v.x);
  squares = squares + double_double(v.y) * double_double(v.y);
  squares = squares + double_double(v.z) * double_double(v.z);
  return sqrt(squares).high;
}

void lengths(const std::vector<set>& all) {
  bench::study s("length", "length", bench::error_unit::ulp);
  for (const set& one : all) {
    const auto& v = one.vectors;
    const auto exact = [](const vec3& x, bench::exact_results& out) { out.push_back(true_length(x).result()); };
    const bench::distribution d{one.name, v.size(), 1, bench::exact_for(v, exact)};
    std::vector<bench::implementation> who{
        bench::for_each_item("irg", v, [](const vec3& x) { return irg::length(x); }),
        bench::for_each_item("irg: length_fast", v, [](const vec3& x) { return irg::length_fast(x); }),
        bench::for_each_item("std::hypot", v, [](const vec3& x) { return std::hypot(x.x, x.y, x.z); }),
        bench::for_each_item("divided by the largest", v, by_largest),
        bench::for_each_item("float and Newton", v, by_newton),
        bench::for_each_item("in double_double", v, in_double_double)};
#ifdef IRG_HAVE_GLM
    who.push_back(bench::for_each_item("GLM", v, [](const vec3& x) { return glm::length(glm::dvec3(x.x, x.y, x.z)); }));
#endif
#ifdef IRG_HAVE_EIGEN
    who.push_back(bench::for_each_item("Eigen norm", v, [](const vec3& x) { return eigen_of(x).norm(); }));
    who.push_back(bench::for_each_item("Eigen stableNorm", v, [](const vec3& x) { return eigen_of(x).stableNorm(); }));
    who.push_back(bench::for_each_item("Eigen blueNorm", v, [](const vec3& x) { return eigen_of(x).blueNorm(); }));
#endif
    s.panel(d, who, bench::text_of_items(v));
  }
}

void unit_vectors(const std::vector<set>& all) {
  bench::study s("normalise", "unit vector", bench::error_unit::ulp);
  for (const set& one : all) {
    const auto& v = one.vectors;
    const auto exact = [](const vec3& x, bench::exact_results& out) {
      const real length = true_length(x);
      for (int k = 0; k < 3; ++k) out.push_back((real(x[k]) / length).result());
    };
    const bench::distribution d{one.name, v.size(), 3, bench::exact_for(v, exact)};
    std::vector<bench::implementation> who{
        bench::for_each_vector<3>("irg", v, [](const vec3& x) { return irg::normalized(x); }),
        bench::for_each_vector<3>("irg: normalized_fast", v, [](const vec3& x) { return irg::normalized_fast(x); })};
#ifdef IRG_HAVE_GLM
    who.push_back(
        bench::for_each_vector<3>("GLM", v, [](const vec3& x) { return glm::normalize(glm::dvec3(x.x, x.y, x.z)); }));
#endif
#ifdef IRG_HAVE_EIGEN
    const auto plain = [](const auto& e) { return std::array<double, 3>{e[0], e[1], e[2]}; };
    who.push_back(bench::for_each_vector<3>("Eigen normalized", v,
                                            [=](const vec3& x) { return plain(eigen_of(x).normalized()); }));
    who.push_back(bench::for_each_vector<3>("Eigen stableNormalized", v,
                                            [=](const vec3& x) { return plain(eigen_of(x).stableNormalized()); }));
#endif
    s.panel(d, who, bench::text_of_items(v));
  }
}

}  // namespace

int main(int argc, char** argv) {
  const auto& all = bench::keep(sets());
  lengths(all);
  unit_vectors(all);
  return bench::run_benchmarks(argc, argv);
}

#else
#include <cstdio>
int main() { std::puts("accuracy_length: skipped, MPFR was not found"); }
#endif
