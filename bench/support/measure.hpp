// SPDX-License-Identifier: MIT
// Measuring: contenders run in turn, again and again, so that a machine that changes its speed changes it for all of
// them; the median counts. Processor time, not wall time. Rows go to the file that IRG_BENCH_CSV names.
#pragma once

#ifdef __linux__
#include <sched.h>
#endif

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

/// Whether only to see that everything runs: little work, one round.
inline bool smoke() { return std::getenv("IRG_BENCH_SMOKE") != nullptr; }

/// Keeps a program of one thread on the processor it runs on, so that it keeps its caches.
inline void stay_on_this_processor() {
#ifdef __linux__
  const int processor = sched_getcpu();
  if (processor < 0) return;
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(static_cast<std::size_t>(processor), &set);
  sched_setaffinity(0, sizeof set, &set);
#endif
}

/// One implementation of the same work.
struct contender {
  std::string name;
  std::function<void()> run;
  std::vector<double> seconds{};  // per run
  int runs_per_turn = 1;

  double median() const { return percentile(0.5); }
  double percentile(double p) const {
    std::vector<double> sorted = seconds;
    std::sort(sorted.begin(), sorted.end());
    return sorted[static_cast<std::size_t>(p * static_cast<double>(sorted.size() - 1))];
  }
};

/// What stands before the measured runs of a turn: nothing, or one run that is not measured, so that nobody pays for
/// what the one before left in the caches.
enum class warming { none, one_run };

/// Runs all contenders in turn: first unmeasured rounds, then `rounds` measured ones; a single one when smoke(). A turn is
/// as many runs as last `least_seconds`, so that a short run is not lost in the clock's and the interrupts' noise.
inline void race(std::vector<contender>& contenders, int rounds, double least_seconds = 0,
                 warming warm = warming::none) {
  for (int round = smoke() ? 0 : -2; round < (smoke() ? 1 : rounds); ++round)
    for (contender& c : contenders) {
      if (warm == warming::one_run && round >= 0 && !smoke()) c.run();
      const double start = processor_seconds();
      for (int i = 0; i < c.runs_per_turn; ++i) c.run();
      const double taken = (processor_seconds() - start) / c.runs_per_turn;
      if (round >= 0)
        c.seconds.push_back(taken);
      else if (taken < least_seconds)
        c.runs_per_turn = static_cast<int>(std::min(1000.0, least_seconds / std::max(taken, 1e-7))) + 1;
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
