// SPDX-License-Identifier: MIT
// Real roots of quadratic and cubic equations, far from each other, nearly equal and equal: run time against error. A
// root that is missing, or that is none, is a failure.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <irg/math/textbook/roots.hpp>
#include <irg/math/roots.hpp>

#include "accuracy/vector_sets.hpp"

#ifdef IRG_HAVE_OPENCV_IMGPROC
#include <opencv2/core.hpp>
#endif

#ifdef BENCH_HAS_MPFR

namespace {

using bench::real;
template <std::size_t N>
using roots_of = std::array<double, N>;  // by size, each as often as it counts; the others NaN
template <std::size_t N>
struct set {
  std::string name;
  std::vector<std::array<double, N + 1>> equations;  // the coefficient of the highest power first
};
constexpr double none = std::numeric_limits<double>::quiet_NaN();

template <int N>
roots_of<std::size_t{N}> with_multiplicity(const irg::real_roots<double, N>& r) {
  roots_of<std::size_t{N}> all;
  all.fill(none);
  std::size_t at = 0;
  for (int i = 0; i < r.count; ++i)
    for (int k = 0; k < r.multiplicity[i]; ++k) all[at++] = r.root[i];
  return all;
}

template <std::size_t N, class F>
set<N> set_of(const std::string& name, F next) {
  bench::random_numbers r(5);
  set<N> s{name, {}};
  for (int i = 0; i < (bench::smoke() ? 16 : 2048); ++i) s.equations.push_back(next(r));
  return s;
}

// ---- quadratic equations

std::array<double, 3> with_roots(bench::random_numbers& r, double x, double y) {
  const double a = r.of_exponent(-3, 3);
  return {a, -(a * (x + y)), a * x * y};
}

std::vector<set<2>> quadratic_sets() {
  std::vector<set<2>> all;
  for (const int power : {0, 4, 8, 16})
    all.push_back(set_of<2>("roots 1 to 10^" + std::to_string(power), [power](bench::random_numbers& r) {
      const double x = r.of_exponent(-3, 3);
      return with_roots(r, x, x * (1 + r.unit()) * std::pow(10.0, power));
    }));
  for (const int power : {4, 8, 12})
    all.push_back(set_of<2>("roots 1 to 1 + 10^-" + std::to_string(power), [power](bench::random_numbers& r) {
      const double x = r.of_exponent(-3, 3);
      return with_roots(r, x, x * (1 + (1 + r.unit()) * std::pow(10.0, -power)));
    }));
  all.push_back(set_of<2>("discriminant 0", [](bench::random_numbers& r) {
    const double m = r.integer(1, 1 << 25), n = r.integer(1, 1 << 25), s = std::ldexp(1.0, r.integer(-9, 9));
    return std::array<double, 3>{s * m * m, 2 * s * m * n, s * n * n};
  }));
  all.push_back(set_of<2>("coefficients 2^-900 to 2^900", [](bench::random_numbers& r) {
    return std::array<double, 3>{r.of_exponent(-900, 900), r.of_exponent(-100, 100), r.of_exponent(-900, 900)};
  }));
  return all;
}

std::array<real, 2> true_roots(const std::array<double, 3>& p, std::size_t& count) {
  const real a = p[0], b = p[1], c = p[2], discriminant = b * b - real(4) * a * c;
  count = discriminant < real(0) ? 0 : 2;
  if (count == 0) return {};
  const real root = sqrt(discriminant), sum = (b < real(0) ? root - b : -(root + b)) / real(2);
  const real x = sum / a, y = c / sum;
  return y < x ? std::array{y, x} : std::array{x, y};
}

roots_of<2> pbrt_quadratic(const std::array<double, 3>& p) {
  const auto [a, b, c] = p;
  const double half = b / (2 * a), discriminant = 4 * a * std::fma(-half, b / 2, c);
  if (!(discriminant <= 0)) return {none, none};
  const double root = std::sqrt(-discriminant), q = -0.5 * (b + std::copysign(root, b));
  const double x = q / a, y = c / q;
  return {std::min(x, y), std::max(x, y)};
}

#ifdef IRG_HAVE_OPENCV_IMGPROC
// The complex roots that iteration finds; those whose imaginary part is below the rounding of the real one are real.
template <std::size_t N>
roots_of<N> opencv_roots(const std::array<double, N + 1>& p) {
  std::array<double, N + 1> lowest_first;
  std::reverse_copy(p.begin(), p.end(), lowest_first.begin());
  std::array<cv::Vec2d, N> found;
  cv::solvePoly(lowest_first, found, 100);
  roots_of<N> all;
  all.fill(none);
  std::size_t count = 0;
  for (const cv::Vec2d& root : found) {
    if (std::fabs(root[1]) > 1e-7 * std::fabs(root[0])) continue;
    std::size_t at = count++;
    for (; at > 0 && root[0] < all[at - 1]; --at) all[at] = all[at - 1];
    all[at] = root[0];
  }
  return all;
}
#endif

void quadratic() {
  bench::study s("quadratic equation", "equation", bench::error_unit::ulp);
  for (const set<2>& one : bench::keep(quadratic_sets())) {
    const auto& items = one.equations;
    const auto exact = [](const std::array<double, 3>& p, bench::exact_results& out) {
      std::size_t count = 0;
      const auto roots = true_roots(p, count);
      for (std::size_t k = 0; k < 2; ++k) out.push_back(k < count ? roots[k].result() : bench::exact_result{none});
    };
    const bench::distribution d{one.name, items.size(), 2, bench::exact_for(items, exact)};
    const auto entry = [&](const char* name, auto solve) {
      return bench::for_each_vector<2>(name, items,
                                       [solve](const auto& p) { return with_multiplicity(solve(p[0], p[1], p[2])); });
    };
    std::vector<bench::implementation> who{
        entry("irg", [](double a, double b, double c) { return irg::quadratic_roots(a, b, c); }),
        entry("irg: quadratic_roots_fast",
              [](double a, double b, double c) { return irg::quadratic_roots_fast(a, b, c); }),
        entry("textbook", [](double a, double b, double c) { return irg::textbook::quadratic_roots(a, b, c); }),
        bench::for_each_vector<2>("pbrt form", items, pbrt_quadratic)};
#ifdef IRG_HAVE_OPENCV_IMGPROC
    who.push_back(bench::for_each_vector<2>("OpenCV solvePoly", items, opencv_roots<2>));
#endif
    s.panel(d, who, bench::text_of_items(items));
  }
}

// ---- cubic equations

std::array<double, 4> with_roots(bench::random_numbers& r, double x, double y, double z) {
  const double a = r.of_exponent(-3, 3);
  return {a, -(a * (x + y + z)), a * (x * y + y * z + z * x), -(a * x * y * z)};
}

std::vector<set<3>> cubic_sets() {
  std::vector<set<3>> all;
  for (const int power : {0, 3, 6})
    all.push_back(set_of<3>("roots 1 to 10^" + std::to_string(power), [power](bench::random_numbers& r) {
      const double step = std::pow(10.0, power / 2.0), x = r.of_exponent(-1, 1);
      return with_roots(r, x, r.of_exponent(-1, 1) * step, r.of_exponent(-1, 1) * step * step);
    }));
  for (const int power : {3, 6})
    all.push_back(set_of<3>("two roots equal to 10^-" + std::to_string(power), [power](bench::random_numbers& r) {
      const double x = r.of_exponent(-3, 3);
      return with_roots(r, x, x * (1 + (1 + r.unit()) * std::pow(10.0, -power)), r.of_exponent(-3, 3));
    }));
  all.push_back(set_of<3>("three roots equal to 10^-4", [](bench::random_numbers& r) {
    const double x = r.of_exponent(-3, 3);
    return with_roots(r, x, x * (1 + 1e-4 * r.unit()), x * (1 - 1e-4 * r.unit()));
  }));
  all.push_back(set_of<3>("a double root", [](bench::random_numbers& r) {
    const double x = r.integer(1, 1 << 16), y = r.integer(-(1 << 16), 0), s = std::ldexp(1.0, r.integer(-9, 9));
    return std::array<double, 4>{s, -s * (2 * x + y), s * (x * x + 2 * x * y), -s * x * x * y};
  }));
  all.push_back(set_of<3>("any coefficients", [](bench::random_numbers& r) {
    return std::array<double, 4>{r.of_exponent(-8, 8), r.of_exponent(-8, 8), r.of_exponent(-8, 8),
                                 r.of_exponent(-8, 8)};
  }));
  return all;
}

template <class R>
void sort_first(std::array<R, 3>& t, int n) {
  for (const auto& [i, j] : {std::array<std::size_t, 2>{0, 1}, {1, 2}, {0, 1}})
    if (static_cast<int>(j) < n && t[j] < t[i]) std::swap(t[i], t[j]);
}

// By Viete's cosines and Cardano's formula, in numbers of type R. Gives 0 for each root, NaN for what is none.
template <class R, class Cbrt, class Cosine>
roots_of<3> by_formulas(const R& a, const R& b, const R& c, const R& d, const R& discriminant, Cbrt cbrt, Cosine cosine,
                        std::array<R, 3>& t) {
  const R p = (R(3) * a * c - b * b) / (R(3) * a * a);
  const R q = (R(2) * b * b * b - R(9) * a * b * c + R(27) * a * a * d) / (R(27) * a * a * a), shift = b / (R(3) * a);
  using std::sqrt;
  if (discriminant < R(0)) {
    const R root = sqrt(q * q / R(4) + p * p * p / R(27)), half = q / R(2);
    const R u = cbrt(q < R(0) ? root - half : R(0) - half - root);
    t = {u - p / (R(3) * u) - shift, R(0), R(0)};
    return {0, none, none};
  }
  if (R(0) < discriminant) {
    const R size = sqrt(p / R(-3));
    for (int k = 0; k < 3; ++k)
      t[static_cast<std::size_t>(k)] = R(2) * size * cosine(R(-1) * q / (R(2) * size * size * size), k) - shift;
  } else if (b * b == R(3) * a * c) {
    t = {R(0) - shift, R(0) - shift, R(0) - shift};
  } else {
    t = {R(3) * q / p - shift, R(-3) * q / (R(2) * p) - shift, R(-3) * q / (R(2) * p) - shift};
  }
  sort_first(t, 3);
  return {0, 0, 0};
}

template <class R>
R discriminant_of(const R& a, const R& b, const R& c, const R& d) {
  return R(18) * a * b * c * d - R(4) * b * b * b * d + b * b * c * c - R(4) * a * c * c * c - R(27) * a * a * d * d;
}

void add_true_roots(const std::array<double, 4>& p, bench::exact_results& exact) {
  const real a = p[0], b = p[1], c = p[2], d = p[3];
  std::array<real, 3> t;
  const auto is_root = by_formulas(
      a, b, c, d, discriminant_of(a, b, c, d), [](const real& x) { return real::of(mpfr_cbrt, x); },
      [](const real& x, int k) {
        const real turn = real(2 * k) * real::of(mpfr_acos, real(-1));
        return real::of(mpfr_cos, (real::of(mpfr_acos, x) + turn) / real(3));
      },
      t);
  for (std::size_t k = 0; k < 3; ++k)
    exact.push_back(std::isnan(is_root[k]) ? bench::exact_result{none} : t[k].result());
}

roots_of<3> textbook_cubic(const std::array<double, 4>& p) {
  std::array<double, 3> t;
  const auto is_root = by_formulas(
      p[0], p[1], p[2], p[3], discriminant_of(p[0], p[1], p[2], p[3]), [](double x) { return std::cbrt(x); },
      [](double x, int k) {
        return std::cos((std::acos(std::clamp(x, -1.0, 1.0)) + 2 * k * 3.14159265358979323846) / 3);
      },
      t);
  return {t[0], is_root[1] + t[1], is_root[2] + t[2]};
}

#ifdef IRG_HAVE_OPENCV_IMGPROC
roots_of<3> opencv_cubic(const std::array<double, 4>& p) {
  const cv::Matx41d equation(p.data());
  cv::Matx31d found;
  const int count = cv::solveCubic(equation, found);
  roots_of<3> all;
  for (int k = 0; k < 3; ++k) all[static_cast<std::size_t>(k)] = k < count ? found(k) : none;
  sort_first(all, count);
  return all;
}
#endif

void cubic() {
  bench::study s("cubic equation", "equation", bench::error_unit::ulp);
  for (const set<3>& one : bench::keep(cubic_sets())) {
    const auto& items = one.equations;
    const bench::distribution d{one.name, items.size(), 3, bench::exact_for(items, add_true_roots)};
    std::vector<bench::implementation> all{
        bench::for_each_vector<3>(
            "irg", items, [](const auto& p) { return with_multiplicity(irg::cubic_roots(p[0], p[1], p[2], p[3])); }),
        bench::for_each_vector<3>("Cardano and Viete", items, textbook_cubic)};
#ifdef IRG_HAVE_OPENCV_IMGPROC
    all.push_back(bench::for_each_vector<3>("OpenCV solveCubic", items, opencv_cubic));
    all.push_back(bench::for_each_vector<3>("OpenCV solvePoly", items, opencv_roots<3>));
#endif
    s.panel(d, all, bench::text_of_items(items));
  }
}

}  // namespace

int main(int argc, char** argv) {
  quadratic();
  cubic();
  return bench::run_benchmarks(argc, argv);
}

#else
#include <cstdio>
int main() { std::puts("accuracy_roots: skipped, MPFR was not found"); }
#endif
