// SPDX-License-Identifier: MIT
// What cover_by_guards gives.
#pragma once

#include <cstddef>
#include <vector>

#include <irg/math/vec.hpp>

namespace irg {

/// Whether guards could be chosen: not where rings cross or run along each other or themselves, or something is NaN or
/// infinite.
enum class [[nodiscard]] guard_status { done, rings_cross, not_finite };

/// A part of a plan, counter-clockwise, and a guard who sees all of it: a corner's number.
/// shape   a part with holes is listed once for its outer ring, and once for each hole, clockwise
template <Floating T>
struct guarded_part {
  std::vector<point<T, 2>> ring{};
  std::size_t guard = 0;
  constexpr bool operator==(const guarded_part&) const = default;
};

/// Guards of a plan, as numbers of its corners; the least number that could do; the parts of the plan.
template <Floating T>
struct guard_cover {
  guard_status status = guard_status::done;
  std::vector<std::size_t> guards{};
  std::size_t at_least = 0;
  std::vector<guarded_part<T>> parts{};
  constexpr bool operator==(const guard_cover&) const = default;
};

}  // namespace irg
