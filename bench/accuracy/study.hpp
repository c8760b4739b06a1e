// SPDX-License-Identifier: MIT
// Run time against error: implementations of one kernel compute the same items, of one distribution after the other;
// each is timed in turn with the others and compared with an oracle. What comes out goes to the table on standard
// output, to results.csv (IRG_BENCH_CSV) and, in more detail and with the worst inputs, to accuracy.csv
// (IRG_ACCURACY_CSV).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "support/measure.hpp"

#ifndef IRG_BENCH_BUILD
#define IRG_BENCH_BUILD "unknown flags"  // the compiler and its flags
#endif

namespace bench {

/// A result of the oracle: value + rest, good to twice double's digits.
struct exact_result {
  double value = 0, rest = 0;
};

/// What errors are counted in.
enum class error_unit {
  ulp,        // of the exact result, in the distribution's type
  sign,       // 0 or 1: whether the sign is wrong
  relative_u  // of the largest result of its item, in 2^-53: for vectors and matrices
};

/// One implementation: writes `results` numbers for each item.
struct implementation {
  std::string name;
  std::function<void(double*)> run;
  std::string same_work = "yes";
};

/// The items of one distribution.
struct distribution {
  std::string name;
  std::size_t items = 0;
  int results = 1;                  // numbers an item has
  std::vector<exact_result> exact;  // items * results of them
  bool in_float = false;            // the type of the results; they are doubles otherwise
};

struct score {
  double worst = 0, mean = 0, centile_99 = 0, exact_share = 0, failed_share = 0;
  std::size_t worst_item = 0;  // the first that failed, if any did
};

/// The unit in the last place of the exact result; of subnormal ones the least number.
inline double last_place(const exact_result& e, bool in_float) {
  int exponent = 0;
  std::frexp(e.value, &exponent);
  if (in_float) return std::ldexp(1.0, std::max(exponent - 24, -149));
  return std::ldexp(1.0, std::max(exponent - 53, -1074));
}

inline int sign(double x) { return x < 0 ? -1 : x > 0 ? 1 : 0; }

/// The errors of the results; those that are NaN or infinite where the exact ones are not count as failures only.
inline score judge(const distribution& d, const std::vector<double>& got, error_unit unit) {
  score s;
  std::vector<double> errors;
  std::size_t exact = 0, failed = 0;
  const auto fail = [&](std::size_t item) {
    if (failed++ == 0) s.worst_item = item;
  };
  const auto per_item = static_cast<std::size_t>(d.results);
  for (std::size_t i = 0; i < d.items; ++i) {
    double largest = 0;
    for (std::size_t k = 0; k < per_item; ++k) largest = std::max(largest, std::fabs(d.exact[i * per_item + k].value));
    for (std::size_t k = 0; k < per_item; ++k) {
      const exact_result& e = d.exact[i * per_item + k];
      const double g = got[i * per_item + k];
      double error = 0, half_a_place = 0;
      if (unit == error_unit::sign) {
        error = sign(g) == sign(e.value) && g == g ? 0 : 1;
        if (error > 0) fail(i);
      } else if (!std::isfinite(e.value)) {
        const bool same = g == e.value || (g != g && e.value != e.value);
        exact += same ? 1 : 0;
        if (!same) fail(i);
        continue;
      } else if (!std::isfinite(g)) {
        fail(i);
        continue;
      } else {
        const double place = last_place(e, d.in_float);
        const double u = unit == error_unit::relative_u ? largest * 0x1p-53 : place;
        if (u > 0) half_a_place = place / u / 2;
        error = u > 0 ? std::fabs(((g - e.value) - e.rest) / u) : g == 0 ? 0 : HUGE_VAL;
      }
      if (error <= half_a_place) ++exact;
      if (error > s.worst && failed == 0) s.worst_item = i;
      s.worst = std::max(s.worst, error);
      errors.push_back(error);
    }
  }
  const double all = static_cast<double>(d.items * per_item);
  if (!errors.empty()) {
    for (const double error : errors) s.mean += error / static_cast<double>(errors.size());
    const auto at = errors.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(errors.size() - 1));
    std::nth_element(errors.begin(), at, errors.end());
    s.centile_99 = *at;
  }
  s.exact_share = static_cast<double>(exact) / all;
  s.failed_share = static_cast<double>(failed) / all;
  return s;
}

/// All distributions of one kernel.
class study {
public:
  study(std::string kernel, std::string item, error_unit unit)
      : kernel_(std::move(kernel)), item_(std::move(item)), unit_(unit) {
    std::printf("%s: ns a %s, errors in %s\n", kernel_.c_str(), item_.c_str(), unit_name());
  }
  study(const study&) = delete;
  study& operator=(const study&) = delete;

  /// Measures all implementations on one distribution. input(item) is the item as text without commas; with the exact
  /// results it is what a regression test needs.
  void panel(const distribution& d, const std::vector<implementation>& all,
             const std::function<std::string(std::size_t)>& input) const {
    std::vector<std::vector<double>> results(all.size(),
                                             std::vector<double>(d.items * static_cast<std::size_t>(d.results)));
    std::vector<contender> racers;
    for (std::size_t i = 0; i < all.size(); ++i)
      racers.push_back({all[i].name, [&results, &all, i] { all[i].run(results[i].data()); }});
    race(racers, 11, 0.002);
    std::printf("  %s\n    %-30s %10s %10s %12s %12s %9s %9s\n", d.name.c_str(), "", "ns", "least", "max error",
                "mean error", "exact %", "failed %");
    const double per = 1e9 / static_cast<double>(d.items);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const score s = judge(d, results[i], unit_);
      std::printf("    %-30s %10.4g %10.4g %12.4g %12.4g %9.4g %9.4g\n", all[i].name.c_str(), racers[i].median() * per,
                  racers[i].percentile(0) * per, s.worst, s.mean, 100 * s.exact_share, 100 * s.failed_share);
      write(d, all[i], racers[i], s, input(s.worst_item) + " gives" + exact_text(d, s.worst_item));
    }
  }

  ~study() { std::printf("\n"); }

private:
  const char* unit_name() const {
    switch (unit_) {
      case error_unit::ulp: return "ulp";
      case error_unit::sign: return "wrong signs";
      case error_unit::relative_u: return "2^-53 of the largest";
    }
    return "";
  }

  static std::string exact_text(const distribution& d, std::size_t item) {
    std::string text;
    char word[40];
    const auto results = static_cast<std::size_t>(d.results);
    for (std::size_t k = item * results; k < (item + 1) * results; ++k) {
      std::snprintf(word, sizeof word, " %a", d.exact[k].value);
      text += word;
    }
    return text;
  }

  void write(const distribution& d, const implementation& m, const contender& c, const score& s,
             const std::string& worst_input) const {
    const double per = 1e9 / static_cast<double>(d.items);
    report({.kernel = kernel_,
            .test_case = d.name,
            .implementation = m.name,
            .same_work = m.same_work,
            .ns_per_item = c.median() * per,
            .items = static_cast<std::int64_t>(d.items),
            .item = item_,
            .max_error = number(s.worst),
            .mean_error = number(s.mean),
            .error_unit = unit_name(),
            .wrong = number(s.failed_share * static_cast<double>(d.items) * d.results),
            .note = number(100 * s.exact_share) + " % exact"});
    const char* path = std::getenv("IRG_ACCURACY_CSV");
    std::FILE* file = path ? std::fopen(path, "a") : nullptr;
    if (!file) return;
    std::fprintf(file, "%s,%s,%s,%zu,%.6g,%.6g,%.6g,%.6g,%s,%.6g,%.6g,%.6g,%.6g,%.6g,%s,%s\n", kernel_.c_str(),
                 d.name.c_str(), m.name.c_str(), d.items, c.percentile(0) * per, c.median() * per,
                 c.percentile(0.025) * per, c.percentile(0.975) * per, unit_name(), s.worst, s.mean, s.centile_99,
                 100 * s.exact_share, 100 * s.failed_share, worst_input.c_str(), IRG_BENCH_BUILD);
    std::fclose(file);
  }

  std::string kernel_, item_;
  error_unit unit_;
};

}  // namespace bench
