// SPDX-License-Identifier: MIT
// Run time against error: implementations of one kernel compute the same items, of one distribution after the other;
// each is timed in turn with the others and compared with an oracle. What comes out goes to the table on standard
// output, to results.csv (IRG_BENCH_CSV) and, in more detail, to accuracy.csv (IRG_ACCURACY_CSV).
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

namespace bench {

/// A result of the oracle: value + rest, good to twice double's digits. The unit of its error is the last place of
/// `digits` binary digits at the value, but never less than `least` (the smallest number of the format).
struct exact_result {
  double value = 0, rest = 0;
};

/// What errors are counted in.
enum class error_unit {
  ulp,        // of the exact result
  float_ulp,  // the same for single precision
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
};

struct score {
  double worst = 0, mean = 0, exact_share = 0, failed_share = 0;
  std::size_t worst_item = 0;
};

inline double unit_of(const exact_result& e, error_unit unit) {
  int exponent = 0;
  std::frexp(e.value, &exponent);
  if (unit == error_unit::float_ulp) return std::ldexp(1.0, std::max(exponent - 24, -149));
  return std::ldexp(1.0, std::max(exponent - 53, -1074));
}

inline int sign(double x) { return x < 0 ? -1 : x > 0 ? 1 : 0; }

/// The errors of the results; those that are NaN or infinite where the exact ones are not count as failures only.
inline score judge(const distribution& d, const std::vector<double>& got, error_unit unit) {
  score s;
  double sum = 0;
  std::size_t counted = 0, exact = 0, failed = 0;
  const auto per_item = static_cast<std::size_t>(d.results);
  for (std::size_t i = 0; i < d.items; ++i) {
    double largest = 0;
    for (std::size_t k = 0; k < per_item; ++k) largest = std::max(largest, std::fabs(d.exact[i * per_item + k].value));
    for (std::size_t k = 0; k < per_item; ++k) {
      const exact_result& e = d.exact[i * per_item + k];
      const double g = got[i * per_item + k];
      double error = 0, half_a_place = unit == error_unit::sign ? 0 : 0.5;
      if (unit == error_unit::sign) {
        error = sign(g) == sign(e.value) && g == g ? 0 : 1;
        failed += error > 0 ? 1 : 0;
      } else if (!std::isfinite(e.value)) {
        const bool same = g == e.value || (g != g && e.value != e.value);
        failed += same ? 0 : 1;
        exact += same ? 1 : 0;
        continue;
      } else if (!std::isfinite(g)) {
        ++failed;
        continue;
      } else {
        const double u = unit == error_unit::relative_u ? largest * 0x1p-53 : unit_of(e, unit);
        if (unit == error_unit::relative_u && u > 0) half_a_place = unit_of(e, error_unit::ulp) / u / 2;
        error = u > 0 ? std::fabs(((g - e.value) - e.rest) / u) : g == 0 ? 0 : HUGE_VAL;
      }
      if (error <= half_a_place) ++exact;
      if (error > s.worst || counted == 0) s.worst = error, s.worst_item = i;
      sum += error;
      ++counted;
    }
  }
  const double all = static_cast<double>(d.items * per_item);
  s.mean = counted > 0 ? sum / static_cast<double>(counted) : 0;
  s.exact_share = static_cast<double>(exact) / all;
  s.failed_share = static_cast<double>(failed) / all;
  return s;
}

/// All distributions of one kernel. At its end it says which variants of irg are dominated: as slow and as wrong as
/// another in every distribution.
class study {
public:
  study(std::string kernel, std::string item, error_unit unit)
      : kernel_(std::move(kernel)), item_(std::move(item)), unit_(unit) {
    std::printf("%s: ns a %s, errors in %s\n", kernel_.c_str(), item_.c_str(), unit_name());
  }
  study(const study&) = delete;
  study& operator=(const study&) = delete;

  /// Measures all implementations on one distribution. show(item) tells the worst input, for a regression test.
  void panel(const distribution& d, const std::vector<implementation>& all,
             const std::function<std::string(std::size_t)>& show = {}) {
    std::vector<std::vector<double>> results(all.size(),
                                             std::vector<double>(d.items * static_cast<std::size_t>(d.results)));
    std::vector<contender> racers;
    for (std::size_t i = 0; i < all.size(); ++i)
      racers.push_back({all[i].name, [&results, &all, i] { all[i].run(results[i].data()); }});
    race(racers, 11, 0.002);
    std::printf("  %s\n    %-26s %10s %10s %12s %12s %9s %9s\n", d.name.c_str(), "", "ns", "least", "max error",
                "mean error", "exact %", "failed %");
    for (std::size_t i = 0; i < all.size(); ++i) {
      const score s = judge(d, results[i], unit_);
      const double per = 1e9 / static_cast<double>(d.items);
      const double ns = racers[i].median() * per, least = racers[i].percentile(0) * per;
      std::printf("    %-26s %10.4g %10.4g %12.4g %12.4g %9.4g %9.4g\n", all[i].name.c_str(), ns, least, s.worst,
                  s.mean, 100 * s.exact_share, 100 * s.failed_share);
      if (show && all[i].name.rfind("irg", 0) == 0) std::printf("      worst at %s\n", show(s.worst_item).c_str());
      write(d, all[i], ns, racers[i], s);
      seen_.push_back({d.name, all[i].name, ns, s.worst, s.failed_share});
    }
  }

  ~study() {
    for (const auto& name : own_variants())
      for (const auto& other : own_variants())
        if (name != other && dominated_everywhere(name, other))
          std::printf("  %s is slower and no better than %s in every distribution\n", name.c_str(), other.c_str());
    std::printf("\n");
  }

private:
  struct point {
    std::string panel, name;
    double ns, worst, failed;
  };

  const char* unit_name() const {
    switch (unit_) {
      case error_unit::ulp: return "ulp";
      case error_unit::float_ulp: return "ulp of float";
      case error_unit::sign: return "wrong signs";
      case error_unit::relative_u: return "2^-53 of the largest";
    }
    return "";
  }

  std::vector<std::string> own_variants() const {
    std::vector<std::string> names;
    for (const point& p : seen_)
      if (p.name.rfind("irg", 0) == 0 && std::find(names.begin(), names.end(), p.name) == names.end())
        names.push_back(p.name);
    return names;
  }

  bool dominated_everywhere(const std::string& name, const std::string& other) const {
    int met = 0;
    for (const point& p : seen_)
      for (const point& q : seen_)
        if (p.panel == q.panel && p.name == name && q.name == other) {
          ++met;
          if (p.ns < q.ns || p.worst < q.worst || p.failed < q.failed) return false;
        }
    return met > 0;
  }

  void write(const distribution& d, const implementation& m, double ns, const contender& c, const score& s) const {
    report({.kernel = kernel_,
            .test_case = d.name,
            .implementation = m.name,
            .same_work = m.same_work,
            .ns_per_item = ns,
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
    const double per = 1e9 / static_cast<double>(d.items);
    std::fprintf(file, "%s,%s,%s,%.6g,%.6g,%.6g,%.6g,%s,%.6g,%.6g,%.6g,%.6g\n", kernel_.c_str(), d.name.c_str(),
                 m.name.c_str(), c.percentile(0) * per, ns, c.percentile(0.025) * per, c.percentile(0.975) * per,
                 unit_name(), s.worst, s.mean, 100 * s.exact_share, 100 * s.failed_share);
    std::fclose(file);
  }

  std::string kernel_, item_;
  error_unit unit_;
  std::vector<point> seen_;
};

}  // namespace bench
