// SPDX-License-Identifier: MIT
// How many bytes this program has from operator new, and how many it had at most: for readers that promise a bound. And
// memory that gives out when a test says so: for functions that then leave their arguments as they were.
#pragma once

#include <cstddef>

namespace test {
extern std::size_t bytes_now, bytes_most;
extern long allocations_left;  // how often operator new succeeds from now on; less than 0: always
}  // namespace test
