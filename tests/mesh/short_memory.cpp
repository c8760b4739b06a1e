// SPDX-License-Identifier: MIT
#include "short_memory.hpp"

#include <cstdlib>
#include <new>

namespace test {
long allocations_left = -1;
}  // namespace test

// Not inlined: compilers that see through one of the two warn that it does not fit the other.
[[gnu::noinline]] void* operator new(std::size_t size) {
  void* const block = test::allocations_left == 0 ? nullptr : std::malloc(size == 0 ? 1 : size);
#ifdef __cpp_exceptions
  if (block == nullptr) throw std::bad_alloc();
#else
  if (block == nullptr) std::abort();
#endif
  if (test::allocations_left > 0) --test::allocations_left;
  return block;
}
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }
