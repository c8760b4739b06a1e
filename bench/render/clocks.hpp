// SPDX-License-Identifier: MIT
// Two clocks for one piece of work: processor time, which other programs do not change, and time on the wall, which
// alone shows what threads are good for.
#pragma once

#include "support/measure.hpp"

namespace bench {

/// How long something took.
struct elapsed {
  double processor = 0, wall = 0;  // seconds
};

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

/// Programs that want to run now, on average over the last minute; negative when unknown.
inline double load() {
  double average[1] = {-1};
  return getloadavg(average, 1) == 1 ? average[0] : -1;
}

}  // namespace bench
