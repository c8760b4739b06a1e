// SPDX-License-Identifier: MIT
// Which objects of a scene have to be drawn: neither beyond the frustum nor hidden whole by others. Decided by their
// boxes, before anything is made of them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <irg/render/options.hpp>
#include <irg/render/prepared_scene.hpp>

namespace irg {
namespace detail {

// The objects of a scene, prepared when they are asked for: those that are not seen never are.
template <class T>
struct IRG_APART objects_to_prepare {
  std::span<const object<T>> source;
  std::vector<object_extent<T>> extents;
  std::vector<prepared_object<T>> made;
  std::vector<std::uint8_t> is_made;

  constexpr explicit objects_to_prepare(std::span<const object<T>> objects)
      : source(objects), is_made(objects.size(), 0) {
    extents.reserve(source.size());
    made.reserve(source.size());
    for (const object<T>& o : source) {
      extents.push_back(extent_of(o));
      made.emplace_back();  // filling the vector would compile the copying of all that an object has
    }
  }
  constexpr std::size_t size() const noexcept { return source.size(); }
  constexpr const object_extent<T>& extent(std::size_t i) const noexcept { return extents[i]; }
  constexpr mesh<T> shape(std::size_t i) const { return transform_mesh(source[i].shape, source[i].placement); }
  constexpr prepared_object<T>& operator[](std::size_t i) {
    if (is_made[i] == 0) made[i] = prepare_object(source[i]);
    is_made[i] = 1;
    return made[i];
  }
};

// The objects of a scene that are prepared already.
template <class T>
struct IRG_APART prepared_objects {
  std::span<prepared_object<T>> made;

  constexpr std::size_t size() const noexcept { return made.size(); }
  constexpr const object_extent<T>& extent(std::size_t i) const noexcept { return made[i].extent; }
  constexpr const mesh<T>& shape(std::size_t i) const noexcept { return made[i].shape; }
  constexpr prepared_object<T>& operator[](std::size_t i) const noexcept { return made[i]; }
};

// What is to be drawn, and how many triangles need not be.
struct object_selection {
  std::vector<std::uint32_t> drawn;  // numbers of objects
  std::int64_t beyond = 0, occluded = 0;
};

inline namespace IRG_ABI {

template <class T, class Objects>
IRG_NOINLINE constexpr object_selection select_objects(Objects& objects, const mat<T, 4, 4>& to_clip, int width,
                                                       int height, const render_options& options) {
  object_selection result;
  std::vector<object_extent<T>> extents;
  extents.reserve(objects.size());
  result.drawn.reserve(objects.size());
  for (std::size_t i = 0; i < objects.size(); ++i) extents.push_back(objects.extent(i));
  occlusion_culling<T> boxes(to_clip, width, height);
  if (options.hidden != hidden_surface_method::none && options.skip.occluded == skipping::on)
    for (const std::uint32_t i : boxes.choose_occluders(extents)) {
      const drawable<T>& body = objects[i].body;
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
