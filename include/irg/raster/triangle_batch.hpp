// SPDX-License-Identifier: MIT
// What the triangle stage draws: triangles over projected vertices, one batch per object.
#pragma once

#include <cstdint>
#include <span>

#include <irg/core/vocabulary.hpp>
#include <irg/raster/projected_vertices.hpp>

namespace irg {

/// Triangles over the vertices of one object. Triangle i has the number first_number + i in the picture.
template <Floating T>
struct triangle_batch {
  const projected_vertices<T>* vertices = nullptr;
  std::span<const triangle_indices> triangles;
  std::uint32_t first_number = 0;
  std::uint32_t object = 0;  // by which a shading knows it
};

inline namespace IRG_ABI {

/// Whether the vertices that a triangle names are there.
template <class T>
[[nodiscard]] IRG_INLINE constexpr bool has_vertices(const triangle_batch<T>& batch, std::uint32_t triangle) noexcept {
  const auto [a, b, c] = batch.triangles[triangle].v;
  return maximum(maximum(a, b), c) < batch.vertices->screen.size();
}

}  // namespace IRG_ABI
}  // namespace irg
