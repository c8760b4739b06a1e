// SPDX-License-Identifier: MIT
// Points of Bezier curves of degrees 3, 10, 20 and 50: run time against error. Control points are random, or those of a
// coordinate that nearly vanishes with all its derivatives in the middle, (1 - 2 t)^n.
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <irg/curve/bezier.hpp>
#include <irg/curve/bezier_accurate.hpp>
#include <irg/curve/bspline.hpp>
#include <irg/curve/bspline_derivative.hpp>
#include <irg/math/vec.hpp>

#include "accuracy/matrix_peers.hpp"
#include "accuracy/vector_sets.hpp"

#ifdef BENCH_HAS_MPFR

namespace {

using bench::real;
using point3 = irg::point<double, 3>;

struct curve {
  std::string name;
  std::vector<point3> points;
  std::vector<double> knots;
  std::vector<irg::vec<double, 2>> places;  // t, and 0
};

std::vector<curve> curves() {
  std::vector<curve> all;
  for (const std::size_t degree : {std::size_t{3}, std::size_t{10}, std::size_t{20}, std::size_t{50}})
    for (const bool vanishing : {false, true}) {
      bench::random_numbers r(11);
      curve c{"degree " + std::to_string(degree) + (vanishing ? ", (1 - 2 t)^n" : ", random"), {}, {}, {}};
      for (std::size_t i = 0; i <= degree; ++i) {
        const double x = r.between(-1, 1), y = r.between(-1, 1), z = r.between(-1, 1), sign = i % 2 == 0 ? 1 : -1;
        c.points.push_back(vanishing ? point3{sign, sign, sign} : point3{x, y, z});
      }
      c.knots.assign(2 * (degree + 1), 0);
      for (std::size_t i = 0; i <= degree; ++i) c.knots[degree + 1 + i] = 1;
      for (std::size_t i = 0; i < (bench::smoke() ? 8 : 1024); ++i) c.places.push_back({r.between(0, 1), 0});
      all.push_back(c);
    }
  return all;
}

// By the definition: the sum of C(n, i) t^i (1 - t)^(n - i) b_i.
void by_definition(const curve& c, double t, bench::exact_results& out) {
  const std::size_t n = c.points.size() - 1;
  const real at(t), rest = real(1) - at;
  std::vector<real> power{real(1)};
  for (std::size_t i = 0; i < n; ++i) power.push_back(power.back() * rest);
  std::array<real, 3> sum;
  real weight(1);
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      sum[k] = sum[k] + weight * power[n - i] * real(c.points[i][static_cast<int>(k)]);
    weight = weight * at * real(static_cast<double>(n - i)) / real(static_cast<double>(i + 1));
  }
  for (const real& s : sum) out.push_back(s.result());
}

// Working space for all: implementations run one after the other.
std::array<point3, 64> room;
std::array<irg::exact_sum<double>, 64> sums;
std::array<double, 64> values;

void points(const std::vector<curve>& all) {
  bench::study s("point of a Bezier curve", "point of a curve", bench::error_unit::relative_u);
  for (const curve& c : all) {
    const auto exact = [&c](const irg::vec<double, 2>& t, bench::exact_results& out) { by_definition(c, t.x, out); };
    const bench::distribution d{c.name, c.places.size(), 3, bench::exact_for(c.places, exact)};
    const auto one = [&](const std::string& name, auto f) { return bench::for_each_vector<3>(name, c.places, f); };
    const auto knots =
        *irg::make_bspline_knots(std::span<const double>(c.knots), static_cast<int>(c.points.size()) - 1);
    s.panel(d,
            {one("irg", [&c](const auto& t) { return irg::bezier_point(c.points, t.x, std::span<point3>(room)); }),
             one("irg: bezier_point_wozny_chudy",
                 [&c](const auto& t) { return irg::bezier_point_wozny_chudy(c.points, t.x); }),
             one("irg: bezier_point_accurate",
                 [&c](const auto& t) {
                   return irg::bezier_point_accurate(c.points, t.x, std::span<irg::exact_sum<double>>(sums));
                 }),
             one("irg: bspline_point",
                 [&c, knots](const auto& t) {
                   return *irg::bspline_point(knots, c.points, t.x, std::span<double>(values));
                 }),
             one("irg: bspline_point_de_boor",
                 [&c, knots](const auto& t) {
                   return *irg::bspline_point_de_boor(knots, c.points, t.x, std::span<point3>(room));
                 })},
            bench::text_of_items(c.places));
  }
}

}  // namespace

int main(int argc, char** argv) {
  points(bench::keep(curves()));
  return bench::run_benchmarks(argc, argv);
}

#else
#include <cstdio>
int main() { std::puts("accuracy_bezier: skipped, MPFR was not found"); }
#endif
