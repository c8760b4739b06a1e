// SPDX-License-Identifier: MIT
// Triangles of one ring by cutting off ears, every decision exact. It takes any ring, also one that crosses itself.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/geometry/detail/ear_clipper.hpp>
#include <irg/geometry/polygon.hpp>

namespace irg {

struct ear_clipping_options {
  /// How many vertex-in-triangle tests a ring may take, times its vertices, before the rest of it becomes a fan. Bounds
  /// the time that hostile rings can take; ordinary rings of 10^5 vertices need a few dozen.
  std::size_t tests_per_vertex = 1024;
};

inline namespace IRG_ABI {

/// Calls sink(i, j, k) for each triangle of a ring, as vertex numbers in the ring's own direction.
/// shape   n - 2 triangles for n vertices
/// needs   finite coordinates, fewer than 2^31 vertices
/// gives   for a simple polygon, convex or not: triangles that cover it exactly once, none of them without area.
///         Straight vertices are allowed, and so are holes that bridges join to the ring. For others the signed area is
///         kept: folds go as triangles without area, what crosses itself is cut as far as ears go and finished as a
///         fan. False, and no triangle, for fewer than three vertices and for rings without area
/// exact   decisions are exact for all finite floats and all integers
/// cost    linear for strictly convex rings, else O(n log n) and up to tests_per_vertex * n tests
/// source  Meisters 1975
template <PlaneRing R, class Emit>
constexpr bool triangulate_ear_clipping(const R& ring, const Emit& sink, ear_clipping_memory<ring_scalar<R>>& memory,
                                        ear_clipping_options options = {}) {
  const std::size_t n = ring_size(ring);
  memory.points.clear();
  if (n < 3) return false;
  for (std::size_t i = 0; i < n; ++i) {
    const auto p = ring_vertex(ring, i);
    memory.points.push_back({coordinate(p, 0), coordinate(p, 1)});
  }
  return detail::ear_clipper<ring_scalar<R>>(memory, options.tests_per_vertex)(sink);
}

/// The triangles of a ring, as above.
/// gives   n - 2 triangles without area, a fan, for a ring without area; none when a coordinate is NaN or infinite
template <PlaneRing R>
[[nodiscard]] constexpr std::vector<std::array<std::uint32_t, 3>> triangulate_ear_clipping(
    const R& ring, ear_clipping_options options = {}) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const auto n = static_cast<std::uint32_t>(ring_size(ring));
  if (n < 3 || !is_finite(ring)) return triangles;
  triangles.reserve(n - 2);
  const auto sink = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) { triangles.push_back({i, j, k}); };
  ear_clipping_memory<ring_scalar<R>> memory;
  if (!triangulate_ear_clipping(ring, sink, memory, options))
    for (std::uint32_t i = 2; i < n; ++i) sink(0, i - 1, i);
  return triangles;
}

}  // namespace IRG_ABI
}  // namespace irg
