// SPDX-License-Identifier: MIT
// pick: what a pixel of a picture shows, without drawing it.
#pragma once

#include <cstddef>
#include <optional>

#include <irg/core/sinks.hpp>
#include <irg/core/vocabulary.hpp>
#include <irg/render/prepared_scene.hpp>
#if IRG_BODIES
#include <cstdint>
#include <vector>

#include <irg/raster/face_order.hpp>
#include <irg/raster/screen_face.hpp>
#include <irg/render/visibility_buffer.hpp>
#include <irg/render/window_faces.hpp>
#endif

namespace irg {

/// What a pixel shows: an object of the scene, a face of its mesh, and the point of it in the world.
template <Floating T>
struct picked_point {
  std::size_t object = 0, face = 0;
  point<T, 3> at{};
  bool operator==(const picked_point&) const = default;
};

inline namespace IRG_COMPILED_ABI {

/// What is seen in a pixel of a picture of this size.
/// needs   as render
/// gives   nothing outside of the picture and where the background is seen
/// exact   the face that render() shows there; the point is rounded
/// cost    the vertices and triangles once, as for a picture, then the triangles of one tile: for a click. All pixels
///         of a picture: draw_visibility
template <Floating T>
IRG_API std::optional<picked_point<T>> pick(prepared_scene<T>& world, const extent2& size, cell pixel,
                                            face_culling culling = face_culling::back);

/// The same of a scene as it is, for one click.
/// cost    as prepare_scene, too
template <Floating T>
[[nodiscard]] IRG_API std::optional<picked_point<T>> pick(const scene<T>& world, const extent2& size, cell pixel,
                                                          face_culling culling = face_culling::back);

}  // namespace IRG_COMPILED_ABI

inline namespace IRG_ABI {

// A size that is a cell, which no bare braces are.
template <class World, std::same_as<cell> Size>
[[deprecated("irg: pick(world, extent2{width, height}, pixel)")]] constexpr auto pick(
    World&& world, const Size& size, cell pixel, face_culling culling = face_culling::back) {
  return pick(world, extent2{size.x, size.y}, pixel, culling);
}

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API std::optional<picked_point<T>> pick(prepared_scene<T>& world, const extent2& size, cell pixel,
                                            face_culling culling) {
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size.width || pixel.y >= size.height) return std::nullopt;
  const screen_mapping<T> mapping = map_to_screen<T>(size);
  const mat<T, 4, 4> to_clip = view_projection(world.view, static_cast<T>(size.width) / static_cast<T>(size.height));
  std::vector<triangle_batch<T>> batches;
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < world.objects.size(); ++i) {
    prepared_object<T>& o = world.objects[i];
    project_vertices<T>(o.body.positions, to_clip, mapping, detail::kept_of(o).vertices);
    batches.push_back({&detail::kept_of(o).vertices, o.body.triangles, number, static_cast<std::uint32_t>(i)});
    number += static_cast<std::uint32_t>(o.body.triangles.size());
  }
  const detail::picture_tiles grid(size.width, size.height);
  detail::triangle_bins& bins = detail::lists_of(world.workspace).bins;
  detail::bin_triangles<T>(bins, batches, {mapping, grid, culling}, as_executor(sequential{}));
  const std::size_t tile =
      static_cast<std::size_t>(pixel.y / detail::tile_size) * static_cast<std::size_t>(grid.across) +
      static_cast<std::size_t>(pixel.x / detail::tile_size);
  const window_faces<T> faces =
      detail::make_window_faces{}(detail::triangle_finder<T>{batches, &bins}, bins.list_of(tile));
  std::optional<screen_face> first;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const screen_face f = faces[i];
    if (covers(f, pixel.x, pixel.y) && (!first || is_nearer(f, *first, pixel.x, pixel.y))) first = f;
  }
  // As render() has it: nothing is seen in the far plane.
  if (first && !nearer_is_greater::nearer(depth_at(set_up_face(*first), pixel.x, pixel.y), nearer_is_greater::farthest))
    return std::nullopt;
  if (!first) return std::nullopt;
  const triangle_batch<T>& batch = detail::triangle_finder<T>{batches, nullptr}.batch_of(first->number);
  const auto weights = barycentrics_at(batch, mapping, first->number, pixel.x, pixel.y);
  if (!weights) return std::nullopt;
  const drawable<T>& body = world.objects[batch.object].body;
  const std::uint32_t triangle = first->number - batch.first_number;
  const auto [a, b, c] = body.triangles[triangle].v;
  const point<T, 3>& p = body.positions[a];
  const vec<T, 3> along = (body.positions[b] - p) * converted<T>(weights->weight1) +
                          (body.positions[c] - p) * converted<T>(weights->weight2);
  return picked_point<T>{batch.object, body.face_of[triangle], p + along};
}

template <Floating T>
[[nodiscard]] IRG_API std::optional<picked_point<T>> pick(const scene<T>& world, const extent2& size, cell pixel,
                                                          face_culling culling) {
  prepared_scene<T> ready = prepare_scene(world);
  return pick(ready, size, pixel, culling);
}

}  // namespace irg::inline IRG_COMPILED_ABI
#endif
