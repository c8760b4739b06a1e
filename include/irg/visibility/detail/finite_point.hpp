// SPDX-License-Identifier: MIT
// Whether one can compute with a point of the plane.
#pragma once

#include <limits>

#include <irg/core/scalar.hpp>
#include <irg/math/vec.hpp>

namespace irg::detail::inline IRG_ABI {

// Whether no coordinate is NaN or infinite.
template <Floating T>
constexpr bool is_finite_sight_point(const point<T, 2>& p) noexcept {
  constexpr T most = (std::numeric_limits<T>::max)();
  return -most <= p.x && p.x <= most && -most <= p.y && p.y <= most;
}

}  // namespace irg::detail::inline IRG_ABI
