// SPDX-License-Identifier: MIT
// One view for occlusion culling: which objects are worth drawing into the mask, drawing them, and asking for boxes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <irg/render/detail/occlude/block_mask.hpp>
#include <irg/render/detail/occlude/mask_query.hpp>
#include <irg/render/detail/project/object_culling.hpp>
#include <irg/render/detail/bin/scratch_portion.hpp>

namespace irg {
namespace detail {

template <class T>
struct occlusion_view {
  mat<T, 4, 4> to_clip;
  screen_mapping<T> mapping;
  int width, height;
  float sign, farthest;  // of keys, as in tile.hpp
  object_culling<T> frustum;
  block_mask mask;  // without blocks until something is drawn
  projected_vertices<T> vertices;

  IRG_INLINE constexpr occlusion_view(const mat<T, 4, 4>& matrix, int w, int h, float key_sign, float farthest_key)
      : to_clip(matrix), mapping(map_to_screen<T>(greater(w, 1), greater(h, 1))), width(w), height(h), sign(key_sign),
        farthest(farthest_key), frustum(to_clip, mapping) {}
  IRG_INLINE constexpr bool has_pixels() const noexcept { return width > 0 && height > 0; }
};

// The pixels of an object's rectangle: for each of its triangles, and together.
struct occluder_worth {
  std::int64_t each, pixels;
  std::uint32_t object;

  IRG_INLINE constexpr bool operator<(const occluder_worth& o) const noexcept {
    return each != o.each ? o.each < each : object < o.object;
  }
};

inline namespace IRG_ABI {

// What makes an occluder: pixels for each of its triangles.
inline constexpr std::int64_t least_occluder_pixels = 16 * block_size * block_size;

template <class T>
constexpr mask_rectangle rectangle_of(const occlusion_view<T>& v, const box<T, 3>& bounds) noexcept {
  return project_box(bounds, v.to_clip, v.width, v.height, v.sign);
}

// The pixels of a box; all of the picture for one that reaches before the near plane.
template <class T>
constexpr std::int64_t pixels_of(const occlusion_view<T>& v, const box<T, 3>& bounds) noexcept {
  if (v.frustum.unseen(bounds)) return 0;
  const mask_rectangle r = rectangle_of(v, bounds);
  if (r.where == mask_place::outside) return 0;
  if (r.where == mask_place::before_the_eye) return std::int64_t{v.width} * v.height;
  return std::int64_t{r.pixels.x_last - r.pixels.x_first} * (r.pixels.y_last - r.pixels.y_first);
}

// See occlusion_culling::choose_occluders; object(i) has the bounds of object i, and how many triangles it has.
template <class T, class Object>
constexpr std::vector<std::uint32_t> choose_occluders(const occlusion_view<T>& v, std::size_t count,
                                                      const Object& object) {
  std::vector<std::uint32_t> occluders;
  std::vector<occluder_worth> candidates;
  if (count < 2 || !v.has_pixels()) return occluders;
  const std::int64_t picture = std::int64_t{v.width} * v.height;
  std::int64_t triangles = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto n = static_cast<std::int64_t>(object(i).triangles);
    triangles += n;
    if (n == 0 || n > picture / least_occluder_pixels) continue;
    const std::int64_t pixels = pixels_of(v, object(i).bounds);
    if (pixels / n >= least_occluder_pixels) candidates.push_back({pixels / n, pixels, static_cast<std::uint32_t>(i)});
  }
  std::sort(candidates.begin(), candidates.end());
  std::int64_t pixels_left = 4 * picture, triangles_left = greater(triangles / 16, std::int64_t{64});
  for (const occluder_worth& w : candidates) {
    const auto n = static_cast<std::int64_t>(object(w.object).triangles);
    if (n > triangles_left) continue;
    if (pixels_left < w.pixels && !occluders.empty()) break;
    occluders.push_back(w.object);
    pixels_left -= w.pixels;
    triangles_left -= n;
  }
  return occluders;
}

template <class T>
constexpr void add_occluder(occlusion_view<T>& v, std::span<const point<T, 3>> positions,
                            std::span<const triangle_indices> triangles, face_culling culling) {
  if (!v.has_pixels()) return;
  if (v.mask.layer.empty()) clear_block_mask(v.mask, v.width, v.height, v.sign, v.farthest);
  project_vertices<T>(v.vertices, positions, v.to_clip, v.mapping);
  const triangle_batch<T> batch{&v.vertices, triangles, 0};
  const listing_rules<T> rules{v.mapping, {v.width, v.height}, culling};
  bin_portion scratch = scratch_portion(rules.grid);
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    list_and_draw(scratch, batch, i, rules,
                  [&](const triangle_corners& c) { draw_block_mask(v.mask, *c.v[0], *c.v[1], *c.v[2]); });
}

template <class T>
constexpr bool hides_box(const occlusion_view<T>& v, const box<T, 3>& bounds) noexcept {
  // What is clipped is rounded once more, so that its box would not be sure to hold it.
  if (v.mask.layer.empty() || !v.frustum.unclipped(bounds)) return false;
  const mask_rectangle r = rectangle_of(v, bounds);
  return r.where == mask_place::on_screen && hidden_by_blocks(v.mask, r.pixels, r.key);
}

template <class T, class Object>
constexpr std::vector<std::uint32_t> visible_objects(occlusion_view<T>& v, std::span<const Object> objects,
                                                     face_culling culling) {
  struct extent {
    const box<T, 3>& bounds;
    std::size_t triangles;
  };
  const auto extent_of = [&](std::size_t i) { return extent{objects[i].bounds, objects[i].triangles.size()}; };
  for (const std::uint32_t i : choose_occluders(v, objects.size(), extent_of))
    add_occluder<T>(v, objects[i].positions, objects[i].triangles, culling);
  std::vector<std::uint32_t> visible;
  for (std::uint32_t i = 0; i < objects.size(); ++i)
    if (!v.frustum.unseen(objects[i].bounds) && !hides_box(v, objects[i].bounds)) visible.push_back(i);
  return visible;
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
