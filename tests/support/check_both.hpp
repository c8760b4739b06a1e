// SPDX-License-Identifier: MIT
// CHECK_BOTH(expression): the fact holds in constant evaluation and at run time.
#pragma once

#include <doctest/doctest.h>

#define CHECK_BOTH(...)         \
  do {                          \
    static_assert(__VA_ARGS__); \
    CHECK(__VA_ARGS__);         \
  } while (false)
