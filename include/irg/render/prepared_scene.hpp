// SPDX-License-Identifier: MIT
// A scene made ready for many pictures: what does not change from one to the next is worked out once. Objects are moved
// into the world, cut into triangles and given normals when they are prepared; colours that depend on light and eye are
// kept as long as these stay the same.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <irg/render/draw_triangles.hpp>
#include <irg/render/drawable.hpp>
#include <irg/render/occlusion_culling.hpp>
#include <irg/scene/scene.hpp>
#include <irg/view/affine.hpp>

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

}  // namespace detail

/// An object made ready for pictures. Only its surface may be changed; another shape or place is prepared anew.
template <Floating T>
struct prepared_object {
  mesh<T> shape;  // in the world, its faces as they were
  drawable<T> body;  // their triangles
  object_extent<T> extent;
  material<T> surface;
  detail::object_frame<T> frame;  // belongs to render()
};

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

inline namespace IRG_ABI {

/// A box around an object in the world, and the number of its triangles.
/// cost    one pass over the positions
template <Floating T>
[[nodiscard]] constexpr object_extent<T> extent_of(const object<T>& o) noexcept {
  object_extent<T> e{{}, o.shape.corners.size() - 2 * o.shape.face_count()};
  for (const point<T, 3>& p : o.shape.positions) e.bounds = bounding_box(e.bounds, transform_point(o.placement, p));
  return e;
}

/// An object made ready: moved into the world, cut into triangles, with normals where it had none.
/// needs   a mesh whose faces have no defect that validate (mesh/validate.hpp) knows
/// cost    linear, and ear clipping for faces of more than three corners; allocates the result
template <Floating T>
[[nodiscard]] constexpr prepared_object<T> prepare_object(const object<T>& o) {
  mesh<T> shape = transformed(o.shape, o.placement);
  drawable<T> body = make_drawable(shape);
  return {std::move(shape), std::move(body), extent_of(o), o.surface, {}};
}

/// A scene made ready, all of its objects prepared.
/// needs   as prepare_object
template <Floating T>
[[nodiscard]] constexpr prepared_scene<T> prepare_scene(const scene<T>& world) {
  prepared_scene<T> ready{{}, world.view, world.lights, world.ambient, world.distance, world.k, {}};
  ready.objects.reserve(world.objects.size());
  for (const object<T>& o : world.objects) ready.objects.push_back(prepare_object(o));
  return ready;
}

}  // namespace IRG_ABI
}  // namespace irg
