// SPDX-License-Identifier: MIT
// occlusion_culling: objects that are hidden whole are found by their boxes, before a vertex of theirs is touched. The
// large and simple objects in front are drawn into a small mask; what lies behind it is left out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <irg/geometry/box.hpp>
#include <irg/render/detail/occlude/occlusion_view.hpp>
#include <irg/raster/triangle_batch.hpp>

namespace irg {

/// What is known of an object before it is drawn: a box around all its positions, and how many triangles it has.
template <Floating T>
struct object_extent {
  box<T, 3> bounds;
  std::size_t triangles = 0;
};

/// An object that may be left out.
template <Floating T>
struct occludable_object {
  box<T, 3> bounds;  // around all positions
  std::span<const point<T, 3>> positions;
  std::span<const triangle_indices> triangles;
};

/// Chooses occluders among the objects of a picture, and tells which of the others they hide.
/// shape   one view: a matrix to clip space and the size of the picture, at most 65536 x 65536
/// exact   draw_batches leaves the same picture and depths with the hidden objects and without them, as long as all
///         occluders that are not hidden themselves are drawn, with the same matrix, size, Order and culling of faces.
///         At every pixel a hidden object is farther than some occluder, never as near: ties are not concerned
/// source  Greene, Kass and Miller 1993 for asking for boxes first; Hasselgren, Andersson and Akenine-Moller 2016 for
///         blocks with one layer that is not yet complete
template <Floating T, DepthOrder Order = nearer_is_greater>
  requires(detail::key_sign<Order> != 0 && !std::same_as<Order, drawing_order>)
class occlusion_culling {
public:
  IRG_INLINE constexpr occlusion_culling(const mat<T, 4, 4>& to_clip, int width, int height)
      : view_(to_clip, width, height, detail::key_sign<Order>, Order::farthest * detail::key_sign<Order>) {}

  /// The objects that are worth drawing as occluders, the best first: those whose box covers 1024 pixels or more for
  /// each of their triangles.
  /// gives   none among fewer than two objects; together at most a sixteenth of all triangles, though always up to 64,
  ///         and boxes of four times the picture's size, though always one
  /// cost    the boxes of objects of few triangles, and sorting those that qualify
  [[nodiscard]] IRG_APART IRG_INLINE constexpr std::vector<std::uint32_t> choose_occluders(
      std::span<const object_extent<T>> objects) const {
    return detail::choose_occluders(view_, objects.size(), [&](std::size_t i) -> auto& { return objects[i]; });
  }

  /// Draws an occluder into the mask.
  /// gives   triangles that face away, where those are culled, and those with a corner that is not finite or not there
  ///         hide nothing
  /// cost    its vertices, and the blocks of 8 x 8 pixels that its triangles cover
  IRG_INLINE constexpr void add_occluder(std::span<const point<T, 3>> positions,
                                         std::span<const triangle_indices> triangles,
                                         face_culling culling = face_culling::back) {
    detail::add_occluder(view_, positions, triangles, culling);
  }

  /// Whether everything in a box is hidden by the occluders.
  /// gives   false for a box that is empty, has a coordinate that is not a number, or reaches before the near plane, to
  ///         the far plane, or beyond the guard band
  /// cost    eight corners, and the blocks of its rectangle until one shows
  [[nodiscard]] IRG_INLINE constexpr bool hides(const box<T, 3>& bounds) const noexcept {
    return detail::hides_box(view_, bounds);
  }

  /// Whether everything in a box lies beyond a plane of the frustum.
  [[nodiscard]] IRG_INLINE constexpr bool is_beyond(const box<T, 3>& bounds) const noexcept {
    return view_.frustum.unseen(bounds);
  }

  /// The numbers of the objects that may be seen, in their order: not beyond the frustum, and not hidden by the
  /// occluders that are chosen among them, or were added before.
  /// cost    the boxes, and the occluders
  IRG_INLINE constexpr std::vector<std::uint32_t> visible_objects(std::span<const occludable_object<T>> objects,
                                                                  face_culling culling = face_culling::back) {
    return detail::visible_objects(view_, objects, culling);
  }

  /// Forgets the occluders; the memory is kept for the next ones.
  IRG_INLINE constexpr void clear() noexcept { view_.mask.layer.clear(); }

private:
  detail::occlusion_view<T> view_;
};

}  // namespace irg
