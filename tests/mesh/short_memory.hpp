// SPDX-License-Identifier: MIT
// Memory that gives out when a test says so: for functions that then leave their arguments as they were.
#pragma once

namespace test {
/// How often operator new succeeds from now on; less than 0: always.
extern long allocations_left;
}  // namespace test
