// SPDX-License-Identifier: MIT
// What the algorithm of Newell, Newell and Sancha does, step by step: for counts and for those who look on.
#pragma once

#include <cstdint>

#include <irg/core/config.hpp>

namespace irg {

/// The tests of Newell, Newell and Sancha by which P does not hide Q, the last of them where the extents of P and Q
/// meet; and what is done.
enum class newell_step {
  x_apart,
  y_apart,
  behind_plane,  // P lies behind the plane of Q
  in_front_of_plane,  // Q lies in front of the plane of P
  projections_apart,
  behind_where_they_meet,
  moved,  // Q is drawn before P
  split_by_plane,  // Q by the plane of P
  split_by_extent,  // Q by the extent of P: they hide others in turn, but their planes do not cross there
  drawn  // P
};

/// How often each test told, and what had to be done.
struct newell_counts {
  std::int64_t steps[10] = {};  // by newell_step
  std::int64_t hidden = 0;  // faces left out in windows where another hides them
  IRG_INLINE constexpr std::int64_t operator[](newell_step s) const noexcept { return steps[static_cast<int>(s)]; }
  constexpr bool operator==(const newell_counts&) const = default;
};

/// Sees no steps.
struct no_newell_observer {
  IRG_INLINE constexpr void operator()(newell_step, std::uint32_t, std::uint32_t) const noexcept {}
};

}  // namespace irg
