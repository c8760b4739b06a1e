// SPDX-License-Identifier: MIT
#include "large_blocks.hpp"

#include <cstdlib>
#include <new>

namespace test {
std::size_t large_block = ~std::size_t{0}, large_blocks = 0, bytes_asked_for = 0;
}  // namespace test

// Not inlined: compilers that see through one of the two warn that it does not fit the other.
[[gnu::noinline]] void* operator new(std::size_t size) {
  void* const block = std::malloc(size == 0 ? 1 : size);
  if (block == nullptr) std::abort();
  test::large_blocks += size >= test::large_block ? 1 : 0;
  test::bytes_asked_for += size;
  return block;
}
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }
// Images are aligned.
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t to) {
  const std::size_t step = static_cast<std::size_t>(to);
  void* const block = std::aligned_alloc(step, (size + step) / step * step);
  if (block == nullptr) std::abort();
  test::large_blocks += size >= test::large_block ? 1 : 0;
  test::bytes_asked_for += size;
  return block;
}
[[gnu::noinline]] void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }
