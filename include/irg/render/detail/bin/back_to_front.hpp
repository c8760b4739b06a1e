// SPDX-License-Identifier: MIT
// The lists of tiles from the farthest triangle to the nearest.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <irg/core/executor.hpp>
#include <irg/raster/triangle_batch.hpp>
#include <irg/render/detail/bin/bin_triangles.hpp>
#if IRG_BODIES
#include <algorithm>
#include <cstddef>

#include <irg/raster/depth.hpp>
#include <irg/render/detail/bin/triangle_finder.hpp>
#endif

namespace irg::detail::inline IRG_COMPILED_ABI {

// As bin_triangles; the numbers of all lists, each put in order. With drawing_order they stay as they are.
template <class Order, Floating T>
IRG_API std::vector<std::uint32_t> bin_back_to_front(triangle_bins& bins, std::span<const triangle_batch<T>> batches,
                                                     const listing_rules<T>& rules, const executor_ref& executor);

}  // namespace irg::detail::inline IRG_COMPILED_ABI

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// The depth of a triangle's centroid: z / w of the sum of its corners in clip space. Not in front of the eye counts as
// nearest of all, and so do triangles that are not drawn because a vertex is not there.
template <class T>
struct centroid_depth {
  T depth = T(0);
  bool behind_eye = false;
  std::uint32_t number = 0;
};

template <class T>
constexpr centroid_depth<T> centroid_depth_of(const triangle_batch<T>& batch, std::uint32_t i) noexcept {
  const auto& [v] = batch.triangles[i];
  const std::uint32_t number = batch.first_number + i;
  if (!has_vertices(batch, i)) return {T(0), true, number};
  const hpoint<T, 3> a = clip_position(*batch.vertices, v[0]), b = clip_position(*batch.vertices, v[1]),
                     c = clip_position(*batch.vertices, v[2]);
  const T z = a.z + (b.z + c.z), w = a.w + (b.w + c.w);
  if (!(T(0) < w)) return {T(0), true, number};
  const T depth = z / w;
  return {depth == depth ? depth : T(0), false, number};
}

// The place of every triangle in the order from the farthest to the nearest; of equal ones the first given first.
template <class Order, class T>
constexpr std::vector<std::uint32_t> back_to_front(std::span<const triangle_batch<T>> batches, std::uint32_t count) {
  std::vector<std::uint32_t> place(count, 0);
  for (std::uint32_t i = 0; i < count; ++i) place[i] = i;
  if constexpr (!std::same_as<Order, drawing_order>) {
    std::vector<centroid_depth<T>> all;
    all.reserve(count);
    for (const triangle_batch<T>& b : batches)
      for (std::uint32_t i = 0; i < b.triangles.size(); ++i) all.push_back(centroid_depth_of(b, i));
    std::sort(all.begin(), all.end(), [](const centroid_depth<T>& a, const centroid_depth<T>& b) {
      if (a.behind_eye != b.behind_eye) return b.behind_eye;
      if (a.depth == b.depth) return a.number < b.number;
      return static_cast<bool>(Order::nearer(b.depth, a.depth));
    });
    for (std::uint32_t i = 0; i < count; ++i) place[all[i].number] = i;
  }
  return place;
}

// The lists of all tiles, each put in the order of places. Two counting sorts: by place, then by tile.
template <class T>
constexpr std::vector<std::uint32_t> sorted_lists(const triangle_bins& bins, const triangle_finder<T>& find,
                                                  const std::vector<std::uint32_t>& place, std::size_t tiles) {
  struct entry {
    std::uint32_t tile = 0, number = 0;
  };
  std::vector<std::uint32_t> start(place.size() + 1, 0), next(bins.tile_first.begin(), bins.tile_first.end());
  for (const std::uint32_t number : bins.numbers) ++start[place[find.source(number)] + 1];
  for (std::size_t i = 0; i < place.size(); ++i) start[i + 1] += start[i];
  std::vector<entry> by_place(bins.numbers.size(), entry{});
  for (std::size_t t = 0; t < tiles; ++t)
    for (std::uint32_t i = bins.tile_first[t]; i < bins.tile_first[t + 1]; ++i)
      by_place[start[place[find.source(bins.numbers[i])]]++] = {static_cast<std::uint32_t>(t), bins.numbers[i]};
  std::vector<std::uint32_t> numbers(bins.numbers.size(), 0);
  for (const entry& e : by_place) numbers[next[e.tile]++] = e.number;
  return numbers;
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <class Order, Floating T>
IRG_API std::vector<std::uint32_t> bin_back_to_front(triangle_bins& bins, std::span<const triangle_batch<T>> batches,
                                                     const listing_rules<T>& rules, const executor_ref& executor) {
  bin_triangles(bins, batches, rules, executor);
  return sorted_lists<T>(bins, {batches, &bins}, back_to_front<Order, T>(batches, bins.triangle_count),
                         rules.grid.count());
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
