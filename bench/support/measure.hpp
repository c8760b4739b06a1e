// SPDX-License-Identifier: MIT
// Measuring: contenders run in turn, again and again, so that a machine that changes its speed changes it for all of
// them; the median counts. Processor time, not wall time. Rows go to the file that IRG_BENCH_CSV names.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

namespace bench {

/// Seconds of processor time this process has used, all threads together.
inline double processor_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec) * 1e-9;
}

/// One implementation of the same work.
struct contender {
  std::string name;
  std::function<void()> run;
  std::vector<double> seconds{};

  double median() const { return percentile(0.5); }
  double percentile(double p) const {
    std::vector<double> sorted = seconds;
    std::sort(sorted.begin(), sorted.end());
    return sorted[static_cast<std::size_t>(p * static_cast<double>(sorted.size() - 1))];
  }
};

/// Runs all contenders in turn: two rounds unmeasured, then `rounds` measured ones; a single one where
/// IRG_BENCH_SMOKE is set, to see only that everything runs.
inline void race(std::vector<contender>& contenders, int rounds) {
  const bool smoke = std::getenv("IRG_BENCH_SMOKE") != nullptr;
  for (int round = smoke ? 0 : -2; round < (smoke ? 1 : rounds); ++round)
    for (contender& c : contenders) {
      const double start = processor_seconds();
      c.run();
      const double taken = processor_seconds() - start;
      if (round >= 0) c.seconds.push_back(taken);
    }
}

/// A row of results.csv. Empty fields stay empty.
struct row {
  std::string kernel{}, test_case{}, implementation{}, same_work = "yes";
  double ns_per_item = 0;
  std::int64_t items = 0;
  std::string item{}, limit_fraction{}, max_error{}, mean_error{}, error_unit{}, wrong{}, note{};
};

inline void report(const row& r) {
  const char* path = std::getenv("IRG_BENCH_CSV");
  std::FILE* file = path ? std::fopen(path, "a") : nullptr;
  if (!file) return;
  std::fprintf(file, "%s,%s,%s,%s,%.6g,%lld,%s,%s,%s,%s,%s,%s,%s\n", r.kernel.c_str(), r.test_case.c_str(),
               r.implementation.c_str(), r.same_work.c_str(), r.ns_per_item, static_cast<long long>(r.items),
               r.item.c_str(), r.limit_fraction.c_str(), r.max_error.c_str(), r.mean_error.c_str(),
               r.error_unit.c_str(), r.wrong.c_str(), r.note.c_str());
  std::fclose(file);
}

inline std::string number(double v) {
  char text[40];
  std::snprintf(text, sizeof text, "%.4g", v);
  return text;
}

}  // namespace bench
