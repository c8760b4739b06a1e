// SPDX-License-Identifier: MIT
// What the events of the studio are made of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/core/is_finite.hpp>
#include <irg/mesh/validate.hpp>
#include <irg/scene/studio.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

template <class T>
constexpr studio_status status_of_body(const stored_body<T>& b) noexcept {
  if (b.name.empty()) return studio_status::no_name;
  const mesh_defect d = validate(b.shape).defect;
  if (d == mesh_defect::position_not_finite || d == mesh_defect::normal_not_finite ||
      d == mesh_defect::texcoord_not_finite)
    return studio_status::not_finite;
  if (d != mesh_defect::none) return studio_status::broken_faces;
  for (const stored_edge& e : b.edges)
    if (e.from >= b.shape.positions.size() || e.to >= b.shape.positions.size())
      return studio_status::edge_without_point;
  if (b.surface_of_face.size() != b.shape.face_count()) return studio_status::broken_surface;
  for (const std::uint32_t f : b.surface_of_face)
    if (f != stored_body<T>::no_surface && f >= b.surfaces.size()) return studio_status::broken_surface;
  for (const stored_surface<T>& f : b.surfaces) {
    const material<T>& m = f.reflection;
    for (const rgb<T>& c : {m.ambient, m.diffuse, m.specular})
      if (!(c.r >= T(0) && c.g >= T(0) && c.b >= T(0) && is_finite(c.r + c.g + c.b)))
        return studio_status::broken_surface;
    if (!(m.shininess > T(0)) || !is_finite(m.shininess)) return studio_status::broken_surface;
  }
  return studio_status::done;
}

template <class T>
constexpr studio_status status_of_lamp(const light<T>& lamp) noexcept {
  const auto share = [](const T& x) { return T(0) <= x && x <= T(1); };
  const hpoint<T, 3>& p = lamp.position;
  if (!is_finite(p.x) || !is_finite(p.y) || !is_finite(p.z) || !is_finite(p.w)) return studio_status::not_finite;
  const rgb<T>& i = lamp.intensity;
  return share(i.r) && share(i.g) && share(i.b) ? studio_status::done : studio_status::bad_lamp;
}

// Calls change(body) for the bodies that a name stands for; its status is that of the last.
template <class T, class Change>
constexpr studio_status change_bodies(studio<T>& s, const part_name& name, const Change& change) {
  if (!name.empty()) {
    const std::size_t i = find_body(s, name);
    return i == s.bodies.size() ? studio_status::no_such_body : change(s.bodies[i]);
  }
  for (studio_body<T>& b : s.bodies) static_cast<void>(change(b));
  return studio_status::done;
}

template <class T>
constexpr std::vector<studio_transformation<T>>& list_of(studio_body<T>& b, studio_stage stage) noexcept {
  return b.transformations[static_cast<std::size_t>(stage)];
}

// Makes room for one more, as push_back would.
template <class List>
constexpr void make_room(List& list) {
  if (list.size() == list.capacity()) list.reserve(2 * list.size() + 1);
}

// The camera, put into its place if it can be a camera.
template <class T>
constexpr studio_status put_camera(studio_camera<T>& place, const studio_camera<T>& c) noexcept {
  const view_pyramid<T>& p = c.pyramid;
  if (!is_finite(c.eye, c.target, c.up) || !is_finite(c.oblique_angle, c.oblique_factor))
    return studio_status::not_finite;
  const T away = length(c.target - c.eye);
  if (!(T(0) < away) || !is_finite(away)) return studio_status::eye_in_target;
  if (!(T(0) < p.width && T(0) < p.height && T(0) < p.distance && T(0) < p.near_distance) ||
      !is_finite(p.width, p.height, p.distance, p.far_distance) ||
      !view_projection_checked(camera_of(c), p.width / p.height).is_ordinary())
    return studio_status::no_projection;
  place = c;
  return studio_status::done;
}

}  // namespace IRG_ABI
}  // namespace detail
}  // namespace irg
