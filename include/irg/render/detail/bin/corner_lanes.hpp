// SPDX-License-Identifier: MIT
// From the numbers of N triangles or pieces to their corners.
#pragma once

#include <cstdint>

#include <irg/core/lanes.hpp>
#include <irg/raster/vertex_lanes.hpp>
#include <irg/render/detail/bin/triangle_finder.hpp>

namespace irg::detail::inline IRG_ABI {

// The corners of N triangles or pieces, a lane each.
template <int N>
struct corner_lanes {
  using integers = pack<std::int32_t, N>;
  integers x[3], y[3], vertex[3];
  pack<float, N> depth[3], inverse_w[3];

  // The first `used` of a list; lanes beyond repeat the last.
  template <class T>
  IRG_INLINE const triangle_batch<T>* collect(const triangle_finder<T>& find, const std::uint32_t* numbers,
                                              int used) noexcept {
    if (used == N) return collect(find, lanes<integers>::load_bytes(numbers));
    return collect(
        find, gather<std::int32_t>(numbers, minimum(lanes<integers>::ramp(), lanes<integers>::broadcast(used - 1))));
  }

  // gives   the batch that all are of, with their indices of vertices; null when there is a piece, or several batches
  template <class T>
  IRG_INLINE const triangle_batch<T>* collect(const triangle_finder<T>& find, const integers& number) noexcept {
    using J = lanes<integers>;
    const auto first = static_cast<std::uint32_t>(number[0]);
    if (!find.is_piece(first)) {
      const triangle_batch<T>& batch = find.batch_of(first);
      const auto base = static_cast<std::int32_t>(batch.first_number);
      const integers i = number - base;
      if (mask_bits(both(i >= J::broadcast(0), i < J::broadcast(static_cast<std::int32_t>(batch.triangles.size())))) ==
          (1u << N) - 1) {
        collect_indexed(batch, i);
        return &batch;
      }
    }
    for (int i = 0; i < N; ++i) {
      const triangle_corners c = find.corners(static_cast<std::uint32_t>(number[i]));
      for (int k = 0; k < 3; ++k) {
        set_lane(x[k], i, c.v[k]->position.x);
        set_lane(y[k], i, c.v[k]->position.y);
        set_lane(depth[k], i, c.v[k]->depth);
        set_lane(inverse_w[k], i, c.v[k]->inverse_w);
      }
    }
    return nullptr;
  }

private:
  template <class T>
  IRG_INLINE void collect_indexed(const triangle_batch<T>& batch, const integers& triangle) noexcept {
    const triangle_indices* of[static_cast<unsigned>(N)];
    for (int i = 0; i < N; ++i) of[i] = batch.triangles.data() + triangle[i];
    for (int k = 0; k < 3; ++k) {
      vertex[k] = gather<std::int32_t>(batch.triangles.data(), triangle * 3 + k);
      const auto corner = load_vertices<N>(batch.vertices->screen.data(), [&](int i) { return of[i]->v[k]; });
      x[k] = corner.x;
      y[k] = corner.y;
      depth[k] = corner.depth;
      inverse_w[k] = corner.inverse_w;
    }
  }
};

}  // namespace irg::detail::inline IRG_ABI
