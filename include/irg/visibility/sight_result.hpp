// SPDX-License-Identifier: MIT
// What the functions for sight in the plane take and give: how obstacles stop sight, and regions whose edges tell what
// is seen there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/core/ring.hpp>
#include <irg/math/vec.hpp>
#include <irg/visibility/corner_rule.hpp>

namespace irg {

/// Whether the ends of an obstacle belong to it.
enum class obstacle_ends {
  closed,  // sight does not pass through an end
  open,    // sight passes through ends, also where two obstacles touch with theirs; a point stops nothing
};

/// How sight in the plane is stopped, and what is inside of a domain of several rings.
struct sight_options {
  obstacle_ends ends = obstacle_ends::closed;
  fill_rule rule = fill_rule::even_odd;
  bool operator==(const sight_options&) const = default;
};

/// How a region came about: `source_on_obstacle` and `source_on_boundary` are answered, what follows them is not.
enum class [[nodiscard]] visibility_status {
  ok,
  source_on_obstacle,
  source_on_boundary,
  source_outside,
  source_not_simple,        // a ring that meets itself or another one, has no area, or no points at all
  window_not_simple,        // the same of the region that is asked about
  source_crosses_obstacle,  // an edge of the source and an obstacle go on both sides of each other
  not_finite,
  done [[deprecated("irg: done is now ok")]] = ok
};

/// What is seen at the end of sight: nothing where an edge of a region runs along a sight line.
enum class sight_stop { nothing, obstacle, boundary };

/// A vertex of a region, and what is seen along the edge from there to the next: obstacle number `index`, or edge
/// number `index` of the domain, the edges of its rings counted on from ring to ring.
template <Floating T>
struct sight_vertex {
  point<T, 2> at{};
  sight_stop stop = sight_stop::nothing;
  std::size_t index = 0;
  bool operator==(const sight_vertex&) const = default;
};

/// A region that is seen from a point. Its ring runs counter-clockwise (y up).
template <Floating T>
struct visible_region {
  visibility_status status = visibility_status::ok;
  std::vector<sight_vertex<T>> ring{};
  bool operator==(const visible_region&) const = default;

  /// Whether there is a region.
  IRG_INLINE constexpr explicit operator bool() const noexcept {
    return status <= visibility_status::source_on_boundary;
  }
};

/// What a visibility polygon took. Where ends lie in one direction `compared` and `crossings` may depend on the order
/// in which std::sort leaves them, and so may `passed_over`.
struct sight_counts {
  std::int64_t walls = 0;  // obstacles, and edges of the domain
  std::int64_t passed_over = 0;  // of these, never compared with another one
  std::int64_t directions = 0;  // of ends that were put in order; ends in one direction count once
  std::int64_t compared = 0;  // how often the nearer of two walls was looked for
  std::int64_t crossings = 0;  // of these, between walls that cross

  constexpr sight_counts& operator+=(const sight_counts& o) noexcept {
    walls += o.walls;
    passed_over += o.passed_over;
    directions += o.directions;
    compared += o.compared;
    crossings += o.crossings;
    return *this;
  }
  bool operator==(const sight_counts&) const = default;
};

/// How much is seen of a source from a place, or of each other from two regions: of these, whether no place in one sees
/// a place in the other, some do, or every one sees every other.
enum class seen_share { none, some, all };

/// The parts of a window by how much of a source is seen from there. Of each, outer rings run counter-clockwise (y up),
/// those round holes clockwise.
template <Floating T>
struct source_regions {
  visibility_status status = visibility_status::ok;
  std::vector<std::vector<point<T, 2>>> all{};  // light
  std::vector<std::vector<point<T, 2>>> some{};  // penumbra
  std::vector<std::vector<point<T, 2>>> none{};  // umbra
  std::size_t lines = 0;  // sight lines past two ends
  std::size_t skipped = 0;  // those of them at which nothing can change
  bool operator==(const source_regions&) const = default;

  /// Whether there are regions.
  IRG_INLINE constexpr explicit operator bool() const noexcept {
    return status <= visibility_status::source_on_boundary;
  }
};

}  // namespace irg
