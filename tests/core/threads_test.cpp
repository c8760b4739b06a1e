// SPDX-License-Identifier: MIT
#include <irg/core/threads.hpp>

#include <new>

#include "support/check_both.hpp"

namespace {

static_assert(irg::Executor<irg::parallel>);

TEST_CASE("parallel: every task exactly once, for any number of threads and tasks") {
  for (const int threads : {-1, 0, 1, 2, 3, 16})
    for (const std::size_t count : {0u, 1u, 2u, 7u, 1000u}) {
      std::vector<std::atomic<int>> seen(count);
      irg::parallel{threads}(count, [&](std::size_t i) { seen[i].fetch_add(1); });
      for (const auto& s : seen) REQUIRE(s.load() == 1);
    }
}

#ifdef __cpp_exceptions
TEST_CASE("parallel: what a task throws comes out, when no other runs") {
  for (const int threads : {1, 2, 16})
    for (const std::size_t bad : {0u, 5u, 99u}) {
      std::atomic<int> running{0};
      CHECK_THROWS_AS(irg::parallel{threads}(100,
                                             [&](std::size_t i) {
                                               if (i >= bad) throw std::bad_alloc();
                                               running.fetch_add(1);
                                               std::this_thread::yield();
                                               running.fetch_sub(1);
                                             }),
                      std::bad_alloc);
      CHECK(running.load() == 0);
    }
}
#endif

}  // namespace
