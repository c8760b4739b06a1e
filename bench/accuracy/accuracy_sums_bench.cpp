// SPDX-License-Identifier: MIT
// Sums of many numbers and values of polynomials, from easy ones to those that cancel: run time against error.
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <irg/math/compensated.hpp>
#include <irg/math/polynomial.hpp>

#include "accuracy/matrix_peers.hpp"
#include "accuracy/vector_sets.hpp"

#ifdef BENCH_HAS_MPFR

namespace {

using bench::real;
std::size_t count() { return bench::smoke() ? 8 : 512; }

// ---- sums

using numbers = std::array<double, 64>;

struct number_set {
  std::string name;
  std::vector<numbers> items;
};

// All but the last two numbers take each other away; what is left is about 2^-bits of them.
std::vector<number_set> number_sets() {
  std::vector<number_set> all;
  for (const int bits : {0, 30, 60, 100}) {
    bench::random_numbers r(18);
    number_set s{bits == 0 ? "any numbers" : "cancels to 2^-" + std::to_string(bits), {}};
    for (std::size_t i = 0; i < count(); ++i) {
      numbers n;
      for (double& x : n) x = r.of_exponent(-20, 20);
      for (std::size_t k = 0; bits > 0 && k < 31; ++k) n[31 + k] = -n[(k * 7) % 31];
      if (bits > 0) n[62] = std::ldexp(r.between(0.5, 1), 20 - bits), n[63] = n[62] * 0x1p-52;
      s.items.push_back(n);
    }
    all.push_back(s);
  }
  return all;
}

double plain_sum(const numbers& n) {
  double sum = 0;
  for (const double x : n) sum += x;
  return sum;
}

double kahan_sum(const numbers& n) {
  double sum = 0, lost = 0;
  for (const double x : n) {
    const double y = x - lost, next = sum + y;
    lost = (next - sum) - y;
    sum = next;
  }
  return sum;
}

void sums() {
  bench::study s("sum of 64 numbers", "sum", bench::error_unit::ulp);
  for (const auto& [name, items] : bench::keep(number_sets())) {
    const auto exact = [](const numbers& n, bench::exact_results& out) {
      real sum = 0;
      for (const double x : n) sum = sum + real(x);
      out.push_back(sum.result());
    };
    const bench::distribution d{name, items.size(), 1, bench::exact_for(items, exact)};
    std::vector<bench::implementation> who{
        bench::for_each_item("irg: sum_accurate", items,
                             [](const numbers& n) { return irg::sum_accurate(std::span<const double>(n)); }),
        bench::for_each_item("irg: sum_exact", items,
                             [](const numbers& n) { return irg::sum_exact(std::span<const double>(n)); }),
        bench::for_each_item("one after the other", items, plain_sum),
        bench::for_each_item("Kahan's compensated sum", items, kahan_sum)};
#ifdef IRG_HAVE_EIGEN
    who.push_back(bench::for_each_item("Eigen sum", items, [](const numbers& n) {
      return Eigen::Map<const Eigen::Matrix<double, 64, 1>>(n.data()).sum();
    }));
#endif
    s.panel(d, who, bench::text_of_items(items));
  }
}

// ---- polynomials of degree 6, the coefficient of x^0 first

struct polynomial {
  std::array<double, 7> c;
  double x;
};

struct polynomial_set {
  std::string name;
  std::vector<polynomial> items;
};

// (x - 1)^6 has whole coefficients; 10^-power from its root.
std::vector<polynomial_set> polynomial_sets() {
  std::vector<polynomial_set> all{{"any coefficients", {}}};
  bench::random_numbers r(19);
  for (std::size_t i = 0; i < count(); ++i) {
    polynomial p{{}, r.between(-1, 1)};
    for (double& c : p.c) c = r.between(-1, 1);
    all[0].items.push_back(p);
  }
  for (const int power : {1, 2, 3}) {
    all.push_back({"(x - 1)^6 at 1 + 10^-" + std::to_string(power), {}});
    for (std::size_t i = 0; i < count(); ++i) {
      polynomial p{{}, 1 + (1 + r.unit()) * std::pow(10.0, -power)};
      double binomial = 1;
      for (int k = 0; k <= 6; ++k) {
        p.c[static_cast<std::size_t>(k)] = k % 2 == 0 ? binomial : -binomial;
        binomial = binomial * (6 - k) / (k + 1);
      }
      all.back().items.push_back(p);
    }
  }
  return all;
}

double by_powers(const polynomial& p) {
  double sum = 0, power = 1;
  for (const double c : p.c) {
    sum += c * power;
    power *= p.x;
  }
  return sum;
}

double fused_horner(const polynomial& p) {
  double value = 0;
  for (std::size_t k = p.c.size(); k-- > 0;) value = std::fma(value, p.x, p.c[k]);
  return value;
}

void polynomials() {
  bench::study s("polynomial of degree 6", "value", bench::error_unit::ulp);
  for (const auto& [name, items] : bench::keep(polynomial_sets())) {
    const auto exact = [](const polynomial& p, bench::exact_results& out) {
      real value = 0;
      for (std::size_t k = p.c.size(); k-- > 0;) value = value * real(p.x) + real(p.c[k]);
      out.push_back(value.result());
    };
    const bench::distribution d{name, items.size(), 1, bench::exact_for(items, exact)};
    s.panel(d,
            {bench::for_each_item("irg", items, [](const polynomial& p) { return irg::evaluate_polynomial(p.c, p.x); }),
             bench::for_each_item("irg: evaluate_polynomial_accurate", items,
                                  [](const polynomial& p) { return irg::evaluate_polynomial_accurate(p.c, p.x); }),
             bench::for_each_item("irg: evaluate_polynomial_exact", items,
                                  [](const polynomial& p) { return irg::evaluate_polynomial_exact(p.c, p.x); }),
             bench::for_each_item("sum of powers", items, by_powers),
             bench::for_each_item("Horner with FMA", items, fused_horner)},
            bench::text_of_items(items));
  }
}

}  // namespace

int main(int argc, char** argv) {
  sums();
  polynomials();
  return bench::run_benchmarks(argc, argv);
}

#else
#include <cstdio>
int main() { std::puts("accuracy_sums: skipped, MPFR was not found"); }
#endif
