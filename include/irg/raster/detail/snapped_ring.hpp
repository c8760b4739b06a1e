// SPDX-License-Identifier: MIT
// Rings as fills read them: every vertex snapped to 1/256 pixel once, near ones to 32 bits, far ones to 64.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include <irg/raster/edge_walk.hpp>
#include <irg/raster/subpixel.hpp>

namespace irg::detail::inline IRG_ABI {

// What must be known of a ring before it is walked. The extent is in 1/256 pixel.
template <class J>
struct ring_extent {
  J left = (std::numeric_limits<J>::max)(), top = (std::numeric_limits<J>::max)();
  J right = (std::numeric_limits<J>::min)(), bottom = (std::numeric_limits<J>::min)();
  std::size_t topmost = 0, lowest = 0;  // the first of the uppermost vertices, and of the lowest ones

  template <class V>
  IRG_INLINE constexpr void add(const V& v, std::size_t i) noexcept {
    left = minimum(left, v.x);
    right = maximum(right, v.x);
    topmost = v.y < top ? i : topmost;
    top = minimum(top, v.y);
    lowest = v.y > bottom ? i : lowest;
    bottom = maximum(bottom, v.y);
  }
};

// The vertex after vertex i of n, or before it.
IRG_INLINE constexpr std::size_t next_vertex(std::size_t i, std::size_t n, bool forward) noexcept {
  return forward ? (i + 1 == n ? 0 : i + 1) : (i == 0 ? n : i) - 1;
}

template <class R>
inline constexpr bool is_snapped_ring = std::same_as<ring_point<R>, subpixel>;

// As snap() does, without a branch: which way a coordinate is rounded cannot be predicted.
// needs   can_snap(v)
template <Floating T>
IRG_INLINE constexpr std::int32_t snap_evenly(T v) noexcept {
  const T scaled = v * T(one_pixel);
  const auto toward_zero = static_cast<std::int32_t>(scaled);
  const T rest = scaled - static_cast<T>(toward_zero);
  return toward_zero + static_cast<std::int32_t>(rest >= T(0.5)) - static_cast<std::int32_t>(rest < T(-0.5));
}

// Vertex i, snapped.
// needs   a coordinate that can be snapped
template <FillableRing R>
IRG_INLINE constexpr subpixel near_vertex(const R& ring, std::size_t i) {
  if constexpr (is_snapped_ring<R>)
    return ring_traits<R>::vertex(ring, i);
  else {
    const auto& p = ring_traits<R>::vertex(ring, i);
    return {snap_evenly(coordinate(p, 0)), snap_evenly(coordinate(p, 1))};
  }
}

template <Floating T>
IRG_INLINE constexpr bool can_far_snap(T v) noexcept {
  return v >= static_cast<T>(-far_limit) && v <= static_cast<T>(far_limit);
}

// As snap() does, within far_limit.
template <Floating T>
IRG_INLINE constexpr std::int64_t far_snap(T v) noexcept {
  const T scaled = v * T(one_pixel);
  const auto toward_zero = static_cast<std::int64_t>(scaled);
  const T rest = scaled - static_cast<T>(toward_zero);
  return toward_zero + (rest >= T(0.5) ? 1 : rest < T(-0.5) ? -1 : 0);
}

template <FillableRing R>
constexpr far_subpixel far_vertex(const R& ring, std::size_t i) {
  if constexpr (is_snapped_ring<R>) {
    const subpixel v = ring_traits<R>::vertex(ring, i);
    return {v.x, v.y};
  } else {
    const auto& p = ring_traits<R>::vertex(ring, i);
    return {far_snap(coordinate(p, 0)), far_snap(coordinate(p, 1))};
  }
}

// How far from the origin a ring's vertices are: the fast or the far walk_edge takes them;
// refused is a vertex that is NaN, infinite or beyond far_limit.
enum class ring_reach { within_snap_limit, within_far_limit, refused };

template <FillableRing R>
constexpr ring_reach reach_of_vertex(const R& ring, std::size_t i) {
  const auto& p = ring_traits<R>::vertex(ring, i);
  if constexpr (is_snapped_ring<R>) {
    return can_snap(p) ? ring_reach::within_snap_limit : ring_reach::within_far_limit;
  } else {
    const auto x = coordinate(p, 0), y = coordinate(p, 1);
    if (can_snap(x) && can_snap(y)) return ring_reach::within_snap_limit;
    return can_far_snap(x) && can_far_snap(y) ? ring_reach::within_far_limit : ring_reach::refused;
  }
}

// The reach of the vertex that reaches farthest.
template <FillableRing R>
constexpr ring_reach reach_of(const R& ring) {
  ring_reach reach = ring_reach::within_snap_limit;
  const std::size_t n = ring_size(ring);
  for (std::size_t i = 0; i < n; ++i) {
    const ring_reach r = reach_of_vertex(ring, i);
    if (r == ring_reach::refused) return r;
    if (r == ring_reach::within_far_limit) reach = r;
  }
  return reach;
}

}  // namespace irg::detail::inline IRG_ABI
