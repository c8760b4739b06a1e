// SPDX-License-Identifier: MIT
// A scene made ready for many pictures: what does not change from one to the next is worked out once. Objects are moved
// into the world, cut into triangles and given normals when they are prepared; colours that depend on light and eye are
// kept as long as these stay the same.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <irg/raster/projected_vertices.hpp>
#include <irg/render/detail/bin/drawing_lists.hpp>
#include <irg/render/detail/occlude/object_extent.hpp>
#include <irg/render/drawable.hpp>
#include <irg/render/options.hpp>
#include <irg/scene/scene.hpp>
#if IRG_BODIES
#include <irg/render/occlusion_culling.hpp>
#include <irg/view/affine.hpp>
#endif

namespace irg {
namespace detail {

// All that the colours of an object depend on, beside its shape.
template <class T>
struct shading_key {
  picture_style style = picture_style::wire;
  face_culling culling = face_culling::back;
  material<T> surface;
  point<T, 3> eye;
  std::vector<light<T>> lights;
  rgb<T> ambient;
  distance_term distance = distance_term::none;
  T k = T(0);

  bool operator==(const shading_key&) const = default;
};

// What the last picture made of an object.
template <class T>
struct object_frame {
  shading_key<T> key;
  std::vector<rgb<float>> face_colours;  // of the fronts
  std::vector<std::array<float, 3>> vertex_colours[2];  // of the fronts, and if need be of the backs
  projected_vertices<T> vertices;
};
struct open_object;

}  // namespace detail

/// What the last picture made of an object, kept for the next one.
template <Floating T>
class kept_frame {
  friend struct detail::open_object;
  detail::object_frame<T> frame_;
};

/// An object made ready for pictures. Only its surface may be changed; another shape or place is prepared anew.
template <Floating T>
struct prepared_object {
  mesh<T> shape;  // in the world, its faces as they were
  drawable<T> body;  // their triangles
  object_extent<T> extent;
  material<T> surface;
  kept_frame<T> frame;  // belongs to render()
};

namespace detail {

struct open_object {
  template <class T>
  IRG_INLINE constexpr object_frame<T>& operator()(kept_frame<T>& kept) const noexcept {
    return kept.frame_;
  }
  template <class T>
  IRG_INLINE constexpr const object_frame<T>& operator()(const kept_frame<T>& kept) const noexcept {
    return kept.frame_;
  }
};
IRG_INLINE constexpr auto& kept_of(auto& object) noexcept { return open_object{}(object.frame); }

}  // namespace detail

/// A scene made ready for pictures. Whatever it has may be changed between two pictures; objects are added and replaced
/// as prepare_object makes them.
template <Floating T>
struct prepared_scene {
  std::vector<prepared_object<T>> objects;
  camera<T> view;
  std::vector<light<T>> lights;
  rgb<T> ambient{};
  distance_term distance = distance_term::none;
  T k = T(1);
  draw_workspace workspace;  // belongs to render()
};

inline namespace IRG_COMPILED_ABI {

/// A box around an object in the world, and the number of its triangles.
/// cost    one pass over the positions
template <Floating T>
[[nodiscard]] IRG_API object_extent<T> extent_of(const object<T>& o) noexcept;

/// An object made ready: moved into the world, cut into triangles, with normals where it had none.
/// needs   a mesh whose faces have no defect that validate (mesh/validate.hpp) knows
/// cost    linear, and ear clipping for faces of more than three corners; allocates the result
template <Floating T>
[[nodiscard]] IRG_API prepared_object<T> prepare_object(const object<T>& o);

/// A scene made ready, all of its objects prepared.
/// needs   as prepare_object
template <Floating T>
[[nodiscard]] IRG_API prepared_scene<T> prepare_scene(const scene<T>& world);

}  // namespace IRG_COMPILED_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg {
namespace detail::inline IRG_ABI {

// All of an object but its extent.
template <class T>
constexpr void prepare_rest(prepared_object<T>& to, const object<T>& from) {
  to.shape = transformed(from.shape, from.placement);
  to.body = make_drawable(to.shape);
  to.surface = from.surface;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API object_extent<T> extent_of(const object<T>& o) noexcept {
  object_extent<T> e{{}, o.shape.corners.size() - 2 * o.shape.face_count()};
  for (const point<T, 3>& p : o.shape.positions) e.bounds = bounding_box(e.bounds, transform_point(o.placement, p));
  return e;
}

template <Floating T>
[[nodiscard]] IRG_API prepared_object<T> prepare_object(const object<T>& o) {
  prepared_object<T> made;
  made.extent = extent_of(o);
  detail::prepare_rest(made, o);
  return made;
}

template <Floating T>
[[nodiscard]] IRG_API prepared_scene<T> prepare_scene(const scene<T>& world) {
  prepared_scene<T> ready{{}, world.view, world.lights, world.ambient, world.distance, world.k, {}};
  ready.objects.reserve(world.objects.size());
  for (const object<T>& o : world.objects) ready.objects.push_back(prepare_object(o));
  return ready;
}

}  // namespace IRG_COMPILED_ABI
}  // namespace irg
#endif
