// SPDX-License-Identifier: MIT
#include "memory_in_use.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

namespace test {
std::size_t bytes_now = 0, bytes_most = 0;
long allocations_left = -1;
}  // namespace test

namespace {
constexpr std::size_t header = alignof(std::max_align_t);
}  // namespace

// Not inlined: compilers that see through one of the two warn that it does not fit the other.
[[gnu::noinline]] void* operator new(std::size_t size) {
#ifdef __cpp_exceptions
  if (test::allocations_left == 0) throw std::bad_alloc();
  if (test::allocations_left > 0) --test::allocations_left;
#endif
  void* const block = std::malloc(size + header);
  if (block == nullptr) std::abort();
  *static_cast<std::size_t*>(block) = size;
  const std::size_t now = std::atomic_ref(test::bytes_now).fetch_add(size) + size;
  const std::atomic_ref most(test::bytes_most);
  for (std::size_t old = most; old < now && !most.compare_exchange_weak(old, now);) {
  }
  return static_cast<char*>(block) + header;
}
[[gnu::noinline]] void operator delete(void* p) noexcept {
  if (p == nullptr) return;
  void* const block = static_cast<char*>(p) - header;
  std::atomic_ref(test::bytes_now).fetch_sub(*static_cast<std::size_t*>(block));
  std::free(block);
}
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { operator delete(p); }
