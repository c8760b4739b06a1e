// SPDX-License-Identifier: MIT
// Two clocks for one piece of work: processor time, which other programs do not change, and time on the wall, which
// alone shows what threads are good for.
#pragma once

#ifdef __linux__
#include <sched.h>
#endif

#include <ctime>

#include "support/measure.hpp"

namespace bench {

/// How long something took.
struct elapsed {
  double processor = 0, wall = 0;  // seconds
};

/// Seconds of processor time this process has used, all threads together.
inline double processor_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec) * 1e-9;
}

inline double wall_seconds() {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec) * 1e-9;
}

/// Starts both clocks when made.
class clocks {
public:
  elapsed since() const { return {processor_seconds() - processor_, wall_seconds() - wall_}; }

private:
  double processor_ = processor_seconds(), wall_ = wall_seconds();
};

/// Takes back stay_on_this_processor.
inline void use_all_processors() {
#ifdef __linux__
  cpu_set_t set;
  CPU_ZERO(&set);
  for (std::size_t i = 0; i < CPU_SETSIZE; ++i) CPU_SET(i, &set);
  sched_setaffinity(0, sizeof set, &set);
#endif
}

}  // namespace bench
