// SPDX-License-Identifier: MIT
// Convex rings: read, sent to a target of coverages, or mixed straight into pixels.
#pragma once

#include <type_traits>

#include <irg/raster/blend_span.hpp>
#include <irg/raster/detail/area_rows_kernel.hpp>
#include <irg/raster/detail/area_target.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// The pixels that a ring of this extent may cover in part.
template <class J>
constexpr cell_window cells_of_extent(const ring_extent<J>& e) noexcept {
  const auto above = [](J v) { return (v + (one_pixel - 1)) >> subpixel_bits; };
  return {e.left >> subpixel_bits, e.top >> subpixel_bits, above(e.right), above(e.bottom)};
}

// Sends the rows of a convex ring to the target.
// needs   vertex(i) for i < n, n >= 3
template <class F, class Vertices, class Target>
IRG_INLINE constexpr void area_of_vertices(const Vertices& vertex, std::size_t n,
                                           const ring_extent<std::int32_t>& extent, const cell_window& w,
                                           Target& target) {
  if (extent.top >= extent.bottom || intersect(w, cells_of_extent(extent)).empty()) return;
  // Twice the area, modulo 2^64; of a convex ring it fits.
  std::uint64_t area = 0;
  subpixel a = vertex(n - 1);
  for (std::size_t i = 0; i < n; ++i) {
    const subpixel b = vertex(i);
    area += static_cast<std::uint64_t>(std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x);
    a = b;
  }
  if (area != 0) area_rows<F>(vertex, n, extent, static_cast<std::int64_t>(area) > 0, w, target);
}

template <class F, FillableRing Ring, class Target>
IRG_INLINE constexpr bool area_of_ring(const Ring& ring, const cell_window& w, Target& target) {
  constexpr std::size_t kept = 16;  // vertices snapped once; longer rings are snapped twice
  subpixel snapped[kept];
  const std::size_t n = ring_size(ring);
  ring_extent<std::int32_t> extent;
  for (std::size_t i = 0; i < n; ++i) {
    if (reach_of_vertex(ring, i) != ring_reach::within_snap_limit) return false;
    const subpixel v = near_vertex(ring, i);
    if (i < kept) snapped[i] = v;
    extent.add(v, i);
  }
  if (n < 3) return true;
  if (n <= kept)
    area_of_vertices<F>([&](std::size_t i) { return snapped[i]; }, n, extent, w, target);
  else
    area_of_vertices<F>([&](std::size_t i) { return near_vertex(ring, i); }, n, extent, w, target);
  return true;
}

// Mixes a colour straight into rows.
template <class R, FillableRing Ring>
bool mix_convex_ring(R& raster, const Ring& ring, const pixel_of<R>& value, const cell_window& w) {
  area_mix_target<R> target(raster, value);
  return area_of_ring<pack<float, mix_lanes>>(ring, w, target);
}

// Sends the coverages of a convex ring to a sink.
template <FillableRing Ring, class Sink>
constexpr bool send_convex_areas(const Ring& ring, const cell_window& w, Sink& sink) {
  area_span_target<Sink> target{sink};
  if (!std::is_constant_evaluated()) return area_of_ring<pack<float, native_lanes<float>>>(ring, w, target);
  return area_of_ring<float>(ring, w, target);
}

// Mixes a value into the pixels of a raster that has rows.
template <class R, FillableRing Ring>
constexpr bool mix_convex_areas(R& raster, const Ring& ring, const pixel_of<R>& value, const cell_window& w) {
  if constexpr (mixes_in_lanes<pixel_of<R>>) {
    if (!std::is_constant_evaluated()) return mix_convex_ring(raster, ring, value, w);
  }
  const auto blend = [&](const coverage_span& span) { blend_span(raster, span, value); };
  return send_convex_areas(ring, w, blend);
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
