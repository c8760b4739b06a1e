// SPDX-License-Identifier: MIT
// Reading and printing decimal numbers: run time against error, for what programs print and for what is hard to round.
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <irg/math/decimal.hpp>

#include "accuracy/vector_sets.hpp"

#ifdef BENCH_HAS_MPFR

namespace {

using texts = std::vector<std::string>;

struct set {
  std::string name;
  texts words;
};

std::string printed(const char* format, double x) {
  char text[500];
  std::snprintf(text, sizeof text, format, x);
  return text;
}

// The middle of two neighbouring doubles, to the last of its digits, and `tail` behind them.
std::string halfway(double x, const char* tail) {
  mpfr_t middle, next;
  mpfr_inits2(200, middle, next, static_cast<mpfr_ptr>(nullptr));
  mpfr_set_d(middle, x, MPFR_RNDN);
  mpfr_set_d(next, std::nextafter(x, 1e300), MPFR_RNDN);
  mpfr_add(middle, middle, next, MPFR_RNDN);
  mpfr_div_ui(middle, middle, 2, MPFR_RNDN);
  char text[500];
  mpfr_snprintf(text, sizeof text, "%.120Rf", middle);
  mpfr_clears(middle, next, static_cast<mpfr_ptr>(nullptr));
  return text + std::string(tail);
}

std::vector<set> sets() {
  const std::size_t n = bench::smoke() ? 16 : 4096;
  std::vector<set> all;
  const auto add = [&](const char* name, auto next) {
    bench::random_numbers r(8);
    set s{name, {}};
    for (std::size_t i = 0; i < n; ++i) s.words.push_back(next(r));
    all.push_back(s);
  };
  add("%.6f", [](bench::random_numbers& r) { return printed("%.6f", r.between(-100, 100)); });
  add("%.9g", [](bench::random_numbers& r) { return printed("%.9g", r.of_exponent(-20, 20)); });
  add("%.17g", [](bench::random_numbers& r) { return printed("%.17g", r.of_exponent(-20, 20)); });
  add("%.17g of all exponents", [](bench::random_numbers& r) { return printed("%.17g", r.of_exponent(-1020, 1020)); });
  add("subnormal", [](bench::random_numbers& r) { return printed("%.17g", r.of_exponent(-1074, -1023)); });
  add("half a unit and 10^-120", [](bench::random_numbers& r) { return halfway(r.between(0.5, 1), "1"); });
  add("800 digits",
      [](bench::random_numbers& r) { return halfway(r.between(1, 2), "") + std::string(680, '0') + "1"; });
  return all;
}

// Digits in double, times a rounded power of ten.
double naive(const std::string& w) {
  double digits = 0, exponent = 0;
  bool point = false;
  const char* p = w.c_str();
  const bool negative = *p == '-';
  for (p += negative ? 1 : 0; *p != 0 && *p != 'e'; ++p) {
    if (*p == '.') {
      point = true;
      continue;
    }
    digits = digits * 10 + (*p - '0');
    exponent -= point ? 1 : 0;
  }
  if (*p == 'e') exponent += std::atoi(p + 1);
  return (negative ? -1 : 1) * digits * std::pow(10.0, exponent);
}

void parse(const std::vector<set>& all) {
  bench::study s("parse double", "number", bench::error_unit::ulp);
  for (const set& one : all) {
    const auto exact = [](const std::string& w, bench::exact_results& out) {
      mpfr_t x;
      mpfr_init2(x, 3000);
      mpfr_set_str(x, w.c_str(), 10, MPFR_RNDN);
      bench::exact_result e{mpfr_get_d(x, MPFR_RNDN), 0};
      mpfr_sub_d(x, x, e.value, MPFR_RNDN);
      e.rest = mpfr_get_d(x, MPFR_RNDN);
      mpfr_clear(x);
      out.push_back(e);
    };
    const bench::distribution d{one.name, one.words.size(), 1, bench::exact_for(one.words, exact)};
    s.panel(d,
            {bench::for_each_item(
                 "irg", one.words,
                 [](const std::string& w) { return irg::parse_decimal<double>(w.data(), w.data() + w.size()).value; }),
             bench::for_each_item("strtod", one.words,
                                  [](const std::string& w) { return std::strtod(w.c_str(), nullptr); }),
             bench::for_each_item("std::from_chars", one.words,
                                  [](const std::string& w) {
                                    double v = 0;
                                    std::from_chars(w.data(), w.data() + w.size(), v);
                                    return v;
                                  }),
             bench::for_each_item("digits times a power of ten", one.words, naive)},
            bench::text_of_items(one.words));
  }
}

// How long the texts are, and whether they lead back.
struct printer {
  std::string name;
  std::size_t (*print)(char* text, double value);  // into 40 bytes; the length
};

const printer printers[] = {
    {"irg",
     [](char* text, double v) { return static_cast<std::size_t>(*irg::print_decimal(text, text + 40, v) - text); }},
    {"std::to_chars",
     [](char* text, double v) { return static_cast<std::size_t>(std::to_chars(text, text + 40, v).ptr - text); }},
    {"snprintf %.17g",
     [](char* text, double v) { return static_cast<std::size_t>(std::snprintf(text, 40, "%.17g", v)); }},
};

void print_numbers(const char* name, const std::vector<double>& made) {
  const auto& values = bench::keep(std::vector<double>(made));
  const bench::contest c{"print double", name, "number", static_cast<std::int64_t>(values.size()), "bytes"};
  for (const printer& one : printers) {
    auto& room = bench::keep(std::vector<char>(values.size() * 40));
    auto& lengths = bench::keep(std::vector<std::size_t>(values.size()));
    bench::contender who{one.name, [&] {
                           for (std::size_t i = 0; i < values.size(); ++i)
                             lengths[i] = one.print(room.data() + 40 * i, values[i]);
                         }};
    who.judge = [&] {
      bench::errors e;
      e.mean = e.wrong = 0;
      for (std::size_t i = 0; i < values.size(); ++i) {
        e.mean += static_cast<double>(lengths[i]) / static_cast<double>(values.size());
        e.wrong += std::strtod(std::string(room.data() + 40 * i, lengths[i]).c_str(), nullptr) == values[i] ? 0 : 1;
      }
      return e;
    };
    bench::enter(c, std::move(who));
  }
}

void print() {
  const auto make = [](auto next) {
    bench::random_numbers r(9);
    std::vector<double> values;
    for (int i = 0; i < (bench::smoke() ? 16 : 4096); ++i) values.push_back(next(r));
    return values;
  };
  print_numbers("whole below 10^6", make([](bench::random_numbers& r) { return std::floor(r.between(0, 1e6)); }));
  print_numbers("three places", make([](bench::random_numbers& r) { return std::round(r.between(-1e5, 1e5)) / 1000; }));
  print_numbers("in [0, 1]", make([](bench::random_numbers& r) { return r.between(0, 1); }));
  print_numbers("all exponents", make([](bench::random_numbers& r) { return r.of_exponent(-1020, 1020); }));
  print_numbers("subnormal", make([](bench::random_numbers& r) { return r.of_exponent(-1074, -1023); }));
}

}  // namespace

int main(int argc, char** argv) {
  parse(bench::keep(sets()));
  print();
  return bench::run_benchmarks(argc, argv);
}

#else
int main() { std::puts("accuracy_decimal: skipped, MPFR was not found"); }
#endif
