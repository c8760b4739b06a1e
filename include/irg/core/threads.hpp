// SPDX-License-Identifier: MIT
// parallel{n}: an executor with n threads. This header is not part of irg.hpp, because it includes <thread>.
#pragma once

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

#include <irg/core/executor.hpp>

namespace irg {

/// Runs the tasks on `threads` threads, the calling one among them; whoever is free takes the next task.
/// needs   tasks that do not throw
struct parallel {
  int threads = 1;

  template <class Task>
  void operator()(std::size_t count, Task&& task) const {
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
      for (std::size_t i = next.fetch_add(1); i < count; i = next.fetch_add(1)) task(i);
    };
    std::vector<std::jthread> helpers;
    for (std::size_t i = 1; i < static_cast<std::size_t>(threads < 1 ? 1 : threads) && i < count; ++i)
      helpers.emplace_back(work);
    work();
  }
};

}  // namespace irg
