// SPDX-License-Identifier: MIT
// Memory for pixels that starts where a line of the cache does: rows of a picture can then be written line by line,
// without reading first what is overwritten.
#pragma once

#include <cstddef>
#include <new>
#include <type_traits>
#include <vector>  // brings std::allocator; <memory> costs more

#include <irg/core/config.hpp>

namespace irg {
namespace detail {

template <class P>
struct IRG_APART line_allocator {
  using value_type = P;
  static constexpr std::align_val_t alignment{alignof(P) > 64 ? alignof(P) : 64};

  line_allocator() = default;
  template <class Q>
  IRG_INLINE constexpr line_allocator(const line_allocator<Q>&) noexcept {}

  IRG_INLINE constexpr P* allocate(std::size_t count) {
    if (std::is_constant_evaluated()) return std::allocator<P>{}.allocate(count);
    return static_cast<P*>(::operator new(count * sizeof(P), alignment));
  }
  IRG_INLINE constexpr void deallocate(P* memory, std::size_t count) noexcept {
    if (std::is_constant_evaluated()) return std::allocator<P>{}.deallocate(memory, count);
    ::operator delete(memory, alignment);
  }

  friend constexpr bool operator==(const line_allocator&, const line_allocator&) noexcept { return true; }
};

}  // namespace detail
}  // namespace irg
