// SPDX-License-Identifier: MIT
#include <irg/core/executor.hpp>

#include "support/check_both.hpp"

namespace {

struct backwards {  // a user's executor: any order is allowed
  template <class Task>
  constexpr void operator()(std::size_t count, Task&& task) const {
    while (count > 0) task(--count);
  }
};

static_assert(irg::Executor<irg::sequential> && irg::Executor<backwards> && !irg::Executor<int>);

template <irg::Executor E>
constexpr std::size_t digits(E executor, std::size_t count) {
  std::size_t seen[10]{}, number = 0;
  executor(count, [&](std::size_t i) { seen[i] += i + 1; });
  for (const std::size_t s : seen) number = 10 * number + s;
  return number;
}

TEST_CASE("sequential: every task once, in order; no task for a count of 0") {
  CHECK_BOTH(digits(irg::sequential{}, 9) == 1234567890u);
  CHECK_BOTH(digits(backwards{}, 9) == 1234567890u);
  CHECK_BOTH(digits(irg::sequential{}, 0) == 0);
}

// Compiled once for all executors.
constexpr std::size_t digits_by_reference(const irg::executor_ref& executor, std::size_t count) {
  std::size_t seen[10]{}, number = 0;
  executor(count, [&](std::size_t i) { seen[i] += i + 1; });
  for (const std::size_t s : seen) number = 10 * number + s;
  return number;
}
static_assert(irg::Executor<irg::executor_ref>);

TEST_CASE("executor_ref: whatever executor it refers to runs the tasks") {
  CHECK_BOTH(digits_by_reference(irg::as_executor(irg::sequential{}), 9) == 1234567890u);
  CHECK_BOTH(digits_by_reference(irg::as_executor(backwards{}), 9) == 1234567890u);
  CHECK_BOTH(digits_by_reference(irg::as_executor(backwards{}), 0) == 0);
  const auto twofold = [] {  // an executor_ref is an executor itself
    const auto inner = irg::as_executor(backwards{});
    const irg::executor_ref& any = inner;
    return digits_by_reference(irg::as_executor(any), 9);
  };
  CHECK(twofold() == 1234567890u);
}

}  // namespace
