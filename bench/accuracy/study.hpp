// SPDX-License-Identifier: MIT
// Run time against error: implementations of one kernel compute the same items, of one distribution after the other;
// each is timed in turn with the others and compared with an oracle. From the counters and worst inputs scripts/bench
// makes accuracy.csv, besides the rows of results.csv.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "support/measure.hpp"

namespace bench {

/// A result of the oracle: value + rest, good to twice double's digits.
struct exact_result {
  double value = 0, rest = 0;
};
using exact_results = std::vector<exact_result>;

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
  bool same_work = true;
};

/// The items of one distribution.
struct distribution {
  std::string name;
  std::size_t items = 0;
  int results = 1;                                  // numbers an item has
  std::function<void(exact_results&)> find_exact;   // appends items * results of them
  bool in_float = false;                            // the type of the results; they are doubles otherwise
};

/// The oracle over all items: one(item, results) appends what an item has.
template <class Items, class F>
std::function<void(exact_results&)> exact_for(const Items& items, F one) {
  return [&items, one](exact_results& out) {
    for (const auto& item : items) one(item, out);
  };
}

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
inline score judge(const distribution& d, const exact_results& true_ones, const std::vector<double>& got,
                   error_unit unit) {
  score s;
  std::vector<double> errors;
  std::size_t exact = 0, failed = 0;
  const auto fail = [&](std::size_t item) {
    if (failed++ == 0) s.worst_item = item;
  };
  const auto per_item = static_cast<std::size_t>(d.results);
  for (std::size_t i = 0; i < d.items; ++i) {
    double largest = 0;
    for (std::size_t k = 0; k < per_item; ++k)
      largest = std::max(largest, std::fabs(true_ones[i * per_item + k].value));
    for (std::size_t k = 0; k < per_item; ++k) {
      const exact_result& e = true_ones[i * per_item + k];
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
      : kernel_(std::move(kernel)), item_(std::move(item)), unit_(unit) {}

  /// Enters all implementations on one distribution. input(item) is the item as text without commas; with the exact
  /// results it is what a regression test needs. What they refer to has to be kept.
  void panel(const distribution& d, const std::vector<implementation>& all,
             const std::function<std::string(std::size_t)>& input) const {
    auto& exact = keep_lazy([find = d.find_exact] {
      exact_results found;
      find(found);
      return found;
    });
    const contest c{kernel_, d.name, item_, static_cast<std::int64_t>(d.items), unit_name()};
    for (const implementation& one : all) {
      auto results = std::make_shared<std::vector<double>>(d.items * static_cast<std::size_t>(d.results));
      contender who{one.name, [results, run = one.run] { run(results->data()); }};
      who.same_work = one.same_work;
      who.judge = [d, &exact, results, input, unit = unit_] {
        const score s = judge(d, *exact, *results, unit);
        errors e{s.worst, s.mean, s.failed_share * static_cast<double>(results->size())};
        char percent[40];
        std::snprintf(percent, sizeof percent, "%.4g %% exact", 100 * s.exact_share);
        e.note = percent;
        e.worst_input = input(s.worst_item) + " gives" + exact_text(d, *exact, s.worst_item);
        e.more = {{"p99_error", s.centile_99},
                  {"exact_percent", 100 * s.exact_share},
                  {"failed_percent", 100 * s.failed_share}};
        return e;
      };
      enter(c, std::move(who));
    }
  }

private:
  const char* unit_name() const {
    switch (unit_) {
      case error_unit::ulp: return "ulp";
      case error_unit::sign: return "wrong signs";
      case error_unit::relative_u: return "2^-53 of the largest";
    }
    return "";
  }

  static std::string exact_text(const distribution& d, const exact_results& exact, std::size_t item) {
    std::string text;
    char word[40];
    const auto results = static_cast<std::size_t>(d.results);
    for (std::size_t k = item * results; k < (item + 1) * results; ++k) {
      std::snprintf(word, sizeof word, " %a", exact[k].value);
      text += word;
    }
    return text;
  }

  std::string kernel_, item_;
  error_unit unit_;
};

}  // namespace bench
