// SPDX-License-Identifier: MIT
// How work is spread. An algorithm that can be cut into independent tasks takes an executor and calls
// executor(count, task): task(i) must have run for every i in [0, count) when the call returns, in any order, on any
// thread. Results never depend on the choice. The executor follows the options; only an observer stands behind it.
#pragma once

#include <cstddef>

#include <irg/core/function_ref.hpp>

namespace irg {

namespace detail {
struct any_task {
  constexpr void operator()(std::size_t) const noexcept {}
};
}  // namespace detail

/// Runs task(0) to task(count - 1), each once. Models: sequential, parallel (core/threads.hpp), a user's thread pool.
template <class E>
concept Executor = requires(const E& executor, std::size_t count, detail::any_task task) { executor(count, task); };

/// Runs the tasks one after the other on the calling thread.
struct sequential {
  template <class Task>
  IRG_INLINE constexpr void operator()(std::size_t count, Task&& task) const {
    for (std::size_t i = 0; i < count; ++i) task(i);
  }
};

/// An executor of whatever type, by reference: as_executor(e) makes one of e. A function that takes a
/// `const executor_ref&` is compiled once for all executors.
/// cost    a virtual call, and another one for each task
struct executor_ref {
  template <class Task>
  IRG_INLINE constexpr void operator()(std::size_t count, Task&& task) const {
    run(count, as_function<void(std::size_t)>(task));
  }
  virtual constexpr void run(std::size_t count, const function_ref<void(std::size_t)>& task) const = 0;

protected:
  constexpr ~executor_ref() = default;
};

namespace detail::inline IRG_ABI {

template <class E>
struct executor_ref_to final : executor_ref {
  const E& executor;

  constexpr explicit executor_ref_to(const E& to) noexcept : executor(to) {}
  constexpr void run(std::size_t count, const function_ref<void(std::size_t)>& task) const override {
    // A type of this instruction set's own, and so is what the executor makes of it.
    executor(count, [&](std::size_t i) { task(i); });
  }
};

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// An executor_ref to e, which must live longer than it is called.
template <Executor E>
[[nodiscard]] IRG_INLINE constexpr detail::executor_ref_to<E> as_executor(const E& e) noexcept {
  return detail::executor_ref_to<E>(e);
}

}  // namespace IRG_ABI
}  // namespace irg
