// SPDX-License-Identifier: MIT
#include <irg/core/threads.hpp>

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

}  // namespace
