// SPDX-License-Identifier: MIT
// How many bytes this program has from operator new, and how many it had at most: for readers that promise a bound.
#pragma once

#include <cstddef>

namespace test {
extern std::size_t bytes_now, bytes_most;
}  // namespace test
