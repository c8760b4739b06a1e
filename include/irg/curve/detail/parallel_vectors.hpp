// SPDX-License-Identifier: MIT
// Private to the chapter: whether two vectors have one direction, or opposite ones. What is left of the cross product
// of their rounded directions does not tell.
#pragma once

#include <irg/math/error_free.hpp>
#include <irg/math/length.hpp>

namespace irg::detail::inline IRG_ABI {

// Whether two vectors are parallel: exactly, but for products of coordinates that vanish beside the largest ones.
// needs   finite vectors that are not zero
template <Vector V>
constexpr bool are_parallel(const V& a, const V& b) noexcept {
  const auto x = scaled_near_one(a), y = scaled_near_one(b);
  for (int i = 0; i < size_of<V>; ++i)
    for (int j = 0; j < i; ++j)
      if (difference_of_products(x.c[i], y.c[j], x.c[j], y.c[i]) != 0) return false;
  return true;
}

}  // namespace irg::detail::inline IRG_ABI
