// SPDX-License-Identifier: MIT
// parallel{n}: an executor with n threads. This header is not part of irg.hpp, because it includes <thread>.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

#include <irg/core/executor.hpp>

namespace irg {

/// Runs the tasks on `threads` threads, the calling one among them; whoever is free takes the next task. Where the
/// system grants fewer threads, fewer do the work.
/// gives   the first exception that a task throws, as soon as no other runs; tasks that nobody has begun are left then
struct parallel {
  int threads = 1;

  template <class Task>
  IRG_APART void operator()(std::size_t count, Task&& task) const {
    std::atomic<std::size_t> next{0};
    const auto take = [&] {
      for (std::size_t i = next.fetch_add(1); i < count; i = next.fetch_add(1)) task(i);
    };
#ifdef __cpp_exceptions
    std::atomic<bool> has_failed{false};
    std::exception_ptr thrown;
    const auto work = [&] {
      try {
        take();
      } catch (...) {
        if (!has_failed.exchange(true)) thrown = std::current_exception();
        next = count;
      }
    };
#else
    const auto& work = take;
#endif
    const std::size_t most = static_cast<std::size_t>(threads < 1 ? 1 : threads);
    std::vector<std::thread> helpers;
    helpers.reserve(most < count ? most : count);
    start(helpers, most < count ? most : count, work);
    work();
    for (std::thread& helper : helpers) helper.join();
#ifdef __cpp_exceptions
    if (thrown) std::rethrow_exception(thrown);
#endif
  }
  bool operator==(const parallel&) const = default;

private:
  // Starts count - 1 threads, or as many as the system grants: the calling thread does what nobody else does.
  template <class Work>
  IRG_APART static void start(std::vector<std::thread>& helpers, std::size_t count, const Work& work) {
#ifdef __cpp_exceptions
    try {
      for (std::size_t i = 1; i < count; ++i) helpers.emplace_back(work);
    } catch (...) {
      return;  // no thread or no memory to be had: fewer than asked for
    }
#else
    for (std::size_t i = 1; i < count; ++i) helpers.emplace_back(work);
#endif
  }
};

}  // namespace irg
