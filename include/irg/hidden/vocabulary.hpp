// SPDX-License-Identifier: MIT
// The words of hidden surfaces: parts of edges that are seen or hidden, and the steps of Newell's method.
#pragma once

#include <cstddef>
#include <cstdint>

#include <irg/core/config.hpp>

namespace irg {

/// Whether a part of an edge is seen.
enum class line_visibility { visible, hidden };

/// A part of an edge, the whole of it having one visibility.
/// shape   edge: the number of the edge in its range; from < to: of the way from its first end to the second. Parts
///         that meet share the place
struct edge_part {
  std::size_t edge;
  line_visibility visibility;
  double from, to;
  bool operator==(const edge_part&) const = default;
};

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
  bool operator==(const newell_counts&) const = default;
};

/// Sees no steps.
struct no_newell_observer {
  IRG_INLINE constexpr void operator()(newell_step, std::uint32_t, std::uint32_t) const noexcept {}
};

}  // namespace irg
