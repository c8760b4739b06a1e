// SPDX-License-Identifier: MIT
// Which objects of a scene have to be drawn: neither beyond the frustum nor hidden whole by others. Decided by their
// boxes, before anything is made of them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <irg/core/contract.hpp>
#include <irg/mesh/validate.hpp>
#include <irg/render/drawable.hpp>
#include <irg/render/occlusion_culling.hpp>
#include <irg/render/options.hpp>
#include <irg/scene/scene.hpp>
#include <irg/view/affine.hpp>

namespace irg {
namespace detail {

// What is to be drawn, and how many triangles need not be.
struct object_selection {
  std::vector<std::uint32_t> drawn;  // numbers of objects
  std::int64_t beyond = 0, occluded = 0;
};

inline namespace IRG_ABI {

// The box of an object in the world, and its triangles once its faces are cut.
template <class T>
constexpr object_extent<T> extent_in_world(const object<T>& o) noexcept {
  object_extent<T> e{{}, o.shape.corners.size() - 2 * o.shape.face_count()};
  for (const point<T, 3>& p : o.shape.positions) e.bounds = enclosing_box(e.bounds, transform_point(o.placement, p));
  return e;
}

template <class Order, class T>
IRG_NOINLINE constexpr object_selection select_objects(const scene<T>& world, const mat<T, 4, 4>& to_clip, int width,
                                                       int height, const render_options& options) {
  object_selection result;
  std::vector<object_extent<T>> extents;
  extents.reserve(world.objects.size());
  result.drawn.reserve(world.objects.size());
  for (const object<T>& o : world.objects) {
    IRG_EXPECTS(find_face_defect(o.shape).defect == mesh_defect::none);
    extents.push_back(extent_in_world(o));
  }
  constexpr bool by_depth = !std::same_as<Order, drawing_order>;
  occlusion_culling<T, std::conditional_t<by_depth, Order, nearer_is_greater>> boxes(to_clip, width, height);
  if (by_depth && options.skip.occluded == skipping::on)
    for (const std::uint32_t i : boxes.choose_occluders(extents)) {
      const object<T>& o = world.objects[i];
      const drawable<T> body = make_drawable(transform_mesh(o.shape, o.placement));
      boxes.add_occluder(body.positions, body.triangles, options.culling);
    }
  for (std::uint32_t i = 0; i < extents.size(); ++i) {
    const auto triangles = static_cast<std::int64_t>(extents[i].triangles);
    if (options.skip.frustum == skipping::on && boxes.is_beyond(extents[i].bounds))
      result.beyond += triangles;
    else if (boxes.hides(extents[i].bounds))
      result.occluded += triangles;
    else
      result.drawn.push_back(i);
  }
  return result;
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
