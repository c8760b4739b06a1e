// SPDX-License-Identifier: MIT
// The steps of box.hpp.
#pragma once

#include <cstddef>
#include <limits>
#include <type_traits>

#include <irg/core/contract.hpp>
#include <irg/core/mesh_concept.hpp>
#include <irg/core/ring.hpp>
#include <irg/math/length.hpp>
#include <irg/math/vec.hpp>

namespace irg {
namespace detail {

/// What an empty box starts from: every number is below `low` or equal to it, and above `high` or equal to it. Numbers
/// without limits (rationals) have no such bounds; there 1 and 0 merely say "empty".
template <class T>
struct IRG_APART empty_extent {
  using limits = std::numeric_limits<T>;
  IRG_INLINE static constexpr T low() noexcept {
    if constexpr (!limits::is_specialized)
      return T(1);
    else if constexpr (limits::has_infinity)
      return limits::infinity();
    else
      return (limits::max)();
  }
  IRG_INLINE static constexpr T high() noexcept {
    if constexpr (!limits::is_specialized)
      return T(0);
    else if constexpr (limits::has_infinity)
      return -limits::infinity();
    else
      return limits::lowest();
  }
};

template <class T, int N>
IRG_INLINE constexpr point<T, N> diagonal_point(T x) noexcept {
  return generate_coordinates<point<T, N>>([&](int) IRG_INLINE_LAMBDA { return x; });
}

}  // namespace detail
}  // namespace irg
