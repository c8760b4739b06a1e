// SPDX-License-Identifier: MIT
// The elementary functions beside the C library's: run time against error, in double and in float.
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <irg/math/exponential.hpp>
#include <irg/math/hypot.hpp>
#include <irg/math/sqrt.hpp>
#include <irg/math/trigonometry.hpp>

#include "accuracy/real.hpp"
#include "accuracy/sets.hpp"

#ifdef BENCH_HAS_MPFR

namespace {

using unary = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
using binary = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);

struct arguments {
  std::string name;
  std::vector<double> x, y{};
};

std::size_t count() { return bench::smoke() ? 32 : 4096; }

arguments made(const std::string& name, const std::function<double(bench::random_numbers&)>& next) {
  bench::random_numbers r(5);
  arguments a{name, {}, {}};
  for (std::size_t i = 0; i < count(); ++i) a.x.push_back(next(r));
  return a;
}
arguments uniform(double low, double high, const std::string& name) {
  return made(name, [=](bench::random_numbers& r) { return r.between(low, high); });
}
arguments of_exponents(double low, double high, const std::string& name) {
  return made(name, [=](bench::random_numbers& r) { return r.of_exponent(low, high); });
}
arguments positive(arguments a) {
  for (double& x : a.x) x = std::fabs(x);
  return a;
}
arguments near_quadrants() {
  return made("beside multiples of a quarter turn", [](bench::random_numbers& r) {
    const double x = r.integer(1, 1000000) * 1.5707963267948966;
    return std::nextafter(x, r.unit() < 0.5 ? 0 : 1e9);
  });
}
arguments pairs(const std::string& name, arguments x, const arguments& y) {
  x.name = name;
  x.y = y.x;
  for (std::size_t i = 0; i < x.y.size(); ++i)  // the generators are alike: not in the same order
    x.y[i] = y.x[(i * 7 + 3) % x.y.size()];
  return x;
}

template <class F>
struct named {
  const char* name;
  F f;
};

template <class T, class Exact, class... Fs>
void compare_in(const bench::study& s, arguments made, Exact exact, const named<Fs>&... who) {
  constexpr bool in_float = sizeof(T) == 4;
  if (in_float && made.name.find("double") != std::string::npos) return;
  arguments& a = bench::keep(std::move(made));
  for (double& v : a.x) v = static_cast<double>(static_cast<T>(v));
  for (double& v : a.y) v = static_cast<double>(static_cast<T>(v));
  const auto& x = bench::keep(std::vector<T>(a.x.begin(), a.x.end()));
  auto& y = bench::keep(std::vector<T>(a.y.begin(), a.y.end()));
  y.resize(x.size());
  const auto find_exact = [&x, &y, exact](bench::exact_results& out) {
    for (std::size_t i = 0; i < x.size(); ++i)
      out.push_back(exact(static_cast<double>(x[i]), static_cast<double>(y[i])).result());
  };
  const bench::distribution d{a.name + (in_float ? " (float)" : ""), x.size(), 1, find_exact, in_float};
  const auto over = [&](const auto& one) {
    return bench::implementation{one.name, [&x, &y, f = one.f](double* out) {
                                   for (std::size_t i = 0; i < x.size(); ++i)
                                     out[i] = static_cast<double>(f(x[i], y[i]));
                                 }};
  };
  s.panel(d, {over(who)...},
          [&a](std::size_t i) { return bench::text_of(a.x[i]) + (a.y.empty() ? "" : " " + bench::text_of(a.y[i])); });
}

// A study of one function in both precisions.
template <class Exact, class... Fs>
void compare(const char* name, const std::vector<arguments>& sets, Exact exact, const named<Fs>&... who) {
  const bench::study s(name, "call", bench::error_unit::ulp);
  for (const arguments& a : sets) {
    compare_in<double>(s, a, exact, who...);
    compare_in<float>(s, a, exact, who...);
  }
}

#define COMPARE(function, mpfr_function, ...)                                                              \
  compare(                                                                                                 \
      #function, {__VA_ARGS__}, [](double x, double) { return bench::real::of<unary>(mpfr_function, x); }, \
      named{"irg", [](auto x, auto) { return irg::function(x); }},                                         \
      named{"libm", [](auto x, auto) { return std::function(x); }})
#define COMPARE_2(function, mpfr_function, ...)                                                                  \
  compare(                                                                                                       \
      #function, {__VA_ARGS__}, [](double x, double y) { return bench::real::of<binary>(mpfr_function, x, y); }, \
      named{"irg", [](auto x, auto y) { return irg::function(x, y); }},                                          \
      named{"libm", [](auto x, auto y) { return std::function(x, y); }})

// The root by its reciprocal: half the exponent is taken from the bits of the float, Newton's steps do the rest.
template <int Steps>
auto by_newton(auto x) {
  using T = decltype(x);
  float guess = std::bit_cast<float>(0x5f375a86u - (std::bit_cast<std::uint32_t>(static_cast<float>(x)) >> 1));
  T root = static_cast<T>(guess);
  for (int i = 0; i < Steps; ++i) root *= T(1.5) - T(0.5) * x * root * root;
  return x * root;
}

void square_roots(const std::vector<arguments>& sets) {
  compare(
      "sqrt", sets, [](double x, double) { return bench::real::of<unary>(mpfr_sqrt, x); },
      named{"irg", [](auto x, auto) { return irg::sqrt(x); }}, named{"libm", [](auto x, auto) { return std::sqrt(x); }},
      named{"bit trick and 1 Newton step", [](auto x, auto) { return by_newton<1>(x); }},
      named{"bit trick and 2 Newton steps", [](auto x, auto) { return by_newton<2>(x); }},
      named{"bit trick and 4 Newton steps", [](auto x, auto) { return by_newton<4>(x); }});
}

}  // namespace

int main(int argc, char** argv) {
  const arguments turn = uniform(-3.1415926, 3.1415926, "-pi to pi"), million = uniform(-1e6, 1e6, "up to 1e6"),
                  huge = of_exponents(20, 1023, "up to 2^1023 (double)"),
                  tiny = of_exponents(-120, -10, "2^-120 to 2^-10"), unit = uniform(-1, 1, "-1 to 1"),
                  near_one = made(
                      "beside 1",
                      [](bench::random_numbers& r) { return 1 - r.of_exponent(-50, -10) * (r.unit() < 0.5 ? 1 : 0); }),
                  all = of_exponents(-1022, 1023, "all exponents (double)"),
                  middle = of_exponents(-60, 60, "2^-60 to 2^60");
  const arguments beside_squares = made("squares or an ulp off (double)", [](bench::random_numbers& r) {
    const double root = r.integer(1, 1 << 26), square = root * root;
    return r.integer(0, 2) == 0 ? square : std::nextafter(square, r.integer(0, 1) == 0 ? 0 : 1e300);
  });
  square_roots({positive(middle), positive(all), beside_squares});
  COMPARE(sin, mpfr_sin, turn, million, huge, near_quadrants(), tiny);
  COMPARE(cos, mpfr_cos, turn, million, huge, near_quadrants());
  COMPARE(tan, mpfr_tan, turn, million, near_quadrants());
  COMPARE(asin, mpfr_asin, unit, tiny);
  COMPARE(acos, mpfr_acos, unit, tiny);
  COMPARE(atan, mpfr_atan, middle, tiny);
  COMPARE(exp, mpfr_exp, uniform(-700, 700, "-700 to 700 (double)"), uniform(-80, 80, "-80 to 80"), tiny);
  COMPARE(exp2, mpfr_exp2, uniform(-100, 100, "-100 to 100"));
  COMPARE(log, mpfr_log, positive(middle), positive(near_one));
  COMPARE(log2, mpfr_log2, positive(middle), positive(near_one));
  COMPARE(log10, mpfr_log10, positive(middle), positive(near_one));
  COMPARE(cbrt, mpfr_cbrt, middle, all);
  COMPARE_2(atan2, mpfr_atan2, pairs("2^-60 to 2^60", middle, middle), pairs("all exponents (double)", all, all));
  COMPARE_2(hypot, mpfr_hypot, pairs("2^-60 to 2^60", middle, middle),
            pairs("like sizes", uniform(1, 2, ""), uniform(1, 2, "")));
  COMPARE_2(pow, mpfr_pow, pairs("0.1 to 10 to the -20 to 20", positive(uniform(0.1, 10, "")), uniform(-20, 20, "")),
            pairs("beside 1 to large powers (double)", uniform(0.999, 1.001, ""), uniform(-1e5, 1e5, "")));
  return bench::run_benchmarks(argc, argv);
}

#else
#include <cstdio>
int main() { std::puts("accuracy_elementary: skipped, MPFR was not found"); }
#endif
