// SPDX-License-Identifier: MIT
// How many blocks of memory this program asked for that are as large as a depth buffer, and how much in all.
#pragma once

#include <cstddef>

namespace test {
extern std::size_t large_block;  // bytes that count as large
extern std::size_t large_blocks, bytes_asked_for;
}  // namespace test
