// SPDX-License-Identifier: MIT
// From the number of a triangle or piece to its corners.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <irg/raster/triangle_batch.hpp>
#include <irg/render/detail/bin/drawing_lists.hpp>

namespace irg::detail {

// The three vertices of a triangle.
struct triangle_corners {
  const screen_vertex* v[3];
};

IRG_INLINE constexpr triangle_corners corners_of(const screen_vertex (&v)[3]) noexcept {
  return {{&v[0], &v[1], &v[2]}};
}

// The vertices of a batch's triangle.
// needs   indices of vertices that are there
template <class T>
IRG_INLINE constexpr triangle_corners corners_of(const triangle_batch<T>& batch, std::uint32_t i) noexcept {
  const auto& [v] = batch.triangles[i];
  const screen_vertex* screen = batch.vertices->screen.data();
  return {{screen + v[0], screen + v[1], screen + v[2]}};
}

// Finds triangles and pieces by their numbers.
template <class T>
struct triangle_finder {
  std::span<const triangle_batch<T>> batches;
  const triangle_bins* bins;

  IRG_INLINE constexpr const triangle_batch<T>& batch_of(std::uint32_t number) const noexcept {
    std::size_t b = 0;
    for (std::size_t size = batches.size(); size > 1;) {
      const std::size_t half = size / 2;
      if (batches[b + half].first_number <= number) b += half;
      size -= half;
    }
    return batches[b];
  }
  IRG_INLINE constexpr bool is_piece(std::uint32_t number) const noexcept { return number >= bins->triangle_count; }
  IRG_INLINE constexpr const clipped_piece& piece(std::uint32_t number) const noexcept {
    return bins->pieces[number - bins->triangle_count];
  }
  // The source triangle: the number by which ties are decided.
  IRG_INLINE constexpr std::uint32_t source(std::uint32_t number) const noexcept {
    return is_piece(number) ? piece(number).source : number;
  }
  IRG_INLINE constexpr triangle_corners corners(std::uint32_t number) const noexcept {
    if (is_piece(number)) return corners_of(piece(number).v);
    const triangle_batch<T>& b = batch_of(number);
    return corners_of(b, number - b.first_number);
  }
};

}  // namespace irg::detail
