// SPDX-License-Identifier: MIT
// How work is spread. An algorithm that can be cut into independent tasks takes an executor as its last parameter and
// calls executor(count, task): task(i) must have run for every i in [0, count) when the call returns, in any order, on
// any thread. Results never depend on the choice.
#pragma once

#include <cstddef>

#include <irg/core/config.hpp>

namespace irg {

namespace detail {
struct any_task {
  constexpr void operator()(std::size_t) const noexcept {}
};
}  // namespace detail

/// Runs task(0) to task(count - 1), each once. Models: sequential, parallel (core/threads.hpp), a user's thread pool.
template <class E>
concept Executor = requires(const E executor, std::size_t count, detail::any_task task) { executor(count, task); };

/// Runs the tasks one after the other on the calling thread.
struct sequential {
  template <class Task>
  IRG_INLINE constexpr void operator()(std::size_t count, Task&& task) const {
    for (std::size_t i = 0; i < count; ++i) task(i);
  }
};

}  // namespace irg
