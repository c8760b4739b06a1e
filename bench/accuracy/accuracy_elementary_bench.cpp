// SPDX-License-Identifier: MIT
// The elementary functions beside the C library's: run time against error, in double and in float.
#include <cmath>
#include <cstddef>
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

arguments made(const std::string& name, const std::function<double(bench::numbers&)>& next) {
  bench::numbers r(5);
  arguments a{name, {}, {}};
  for (std::size_t i = 0; i < count(); ++i) a.x.push_back(next(r));
  return a;
}
arguments uniform(double low, double high, const std::string& name) {
  return made(name, [=](bench::numbers& r) { return r.between(low, high); });
}
arguments of_exponents(double low, double high, const std::string& name) {
  return made(name, [=](bench::numbers& r) { return r.of_exponent(low, high); });
}
arguments positive(arguments a) {
  for (double& x : a.x) x = std::fabs(x);
  return a;
}
arguments near_quadrants() {
  return made("beside multiples of pi/2", [](bench::numbers& r) {
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

// A study of one function in one precision: T's own function and the library's on the same arguments.
template <class T, class Own, class Peer, class Exact>
void compare(const std::string& name, Own own, Peer peer, Exact exact, std::vector<arguments> sets) {
  bench::study s(name + (sizeof(T) == 4 ? " (float)" : ""), "call",
                 sizeof(T) == 4 ? bench::error_unit::float_ulp : bench::error_unit::ulp);
  for (arguments& a : sets) {
    if (sizeof(T) == 4 && a.name.find("double") != std::string::npos) continue;
    for (double& v : a.x) v = static_cast<double>(static_cast<T>(v));
    for (double& v : a.y) v = static_cast<double>(static_cast<T>(v));
    std::vector<T> x(a.x.begin(), a.x.end()), y(a.y.begin(), a.y.end());
    if (y.empty()) y.resize(x.size());
    bench::distribution d{a.name, x.size(), 1, {}};
    for (std::size_t i = 0; i < x.size(); ++i)
      d.exact.push_back(exact(static_cast<double>(x[i]), static_cast<double>(y[i])).result());
    const auto over = [&](auto f) {
      return [&, f](double* out) {
        for (std::size_t i = 0; i < x.size(); ++i) out[i] = static_cast<double>(f(x[i], y[i]));
      };
    };
    s.panel(d, {{"irg", over(own)}, {"libm", over(peer)}},
            [&](std::size_t i) { return bench::text_of({a.x[i], a.y.empty() ? 0 : a.y[i]}); });
  }
}

#define COMPARE(function, mpfr_function, ...)                                                     \
  do {                                                                                            \
    const auto own = [](auto x, auto) { return irg::function(x); };                               \
    const auto peer = [](auto x, auto) { return std::function(x); };                              \
    const auto exact = [](double x, double) { return bench::real::of<unary>(mpfr_function, x); }; \
    compare<double>(#function, own, peer, exact, {__VA_ARGS__});                                  \
    compare<float>(#function, own, peer, exact, {__VA_ARGS__});                                   \
  } while (false)
#define COMPARE_2(function, mpfr_function, ...)                                                         \
  do {                                                                                                  \
    const auto own = [](auto x, auto y) { return irg::function(x, y); };                                \
    const auto peer = [](auto x, auto y) { return std::function(x, y); };                               \
    const auto exact = [](double x, double y) { return bench::real::of<binary>(mpfr_function, x, y); }; \
    compare<double>(#function, own, peer, exact, {__VA_ARGS__});                                        \
    compare<float>(#function, own, peer, exact, {__VA_ARGS__});                                         \
  } while (false)

}  // namespace

int main() {
  bench::stay_on_this_processor();
  const arguments turn = uniform(-3.1415926, 3.1415926, "-pi to pi"), million = uniform(-1e6, 1e6, "up to 1e6"),
                  huge = of_exponents(20, 1023, "up to 2^1023 (double)"),
                  tiny = of_exponents(-120, -10, "2^-120 to 2^-10"), unit = uniform(-1, 1, "-1 to 1"),
                  near_one =
                      made("beside 1",
                           [](bench::numbers& r) { return 1 - r.of_exponent(-50, -10) * (r.unit() < 0.5 ? 1 : 0); }),
                  all = of_exponents(-1022, 1023, "all exponents (double)"),
                  middle = of_exponents(-60, 60, "2^-60 to 2^60");
  COMPARE(sqrt, mpfr_sqrt, positive(middle), positive(all));
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
  COMPARE_2(pow, mpfr_pow, pairs("1/10 to 10 to the -20 to 20", positive(uniform(0.1, 10, "")), uniform(-20, 20, "")),
            pairs("beside 1 to large powers (double)", uniform(0.999, 1.001, ""), uniform(-1e5, 1e5, "")));
}

#else
#include <cstdio>
int main() { std::puts("accuracy_elementary: skipped, MPFR was not found"); }
#endif
