// SPDX-License-Identifier: MIT
// What can happen in the studio, as plain data, and what each event makes of it. An event that cannot be leaves the
// studio as it was, and says why.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <irg/core/is_finite.hpp>
#include <irg/mesh/validate.hpp>
#include <irg/view/axonometry.hpp>
#include <irg/view/polar_camera.hpp>

#include "studio.hpp"

namespace irg {

/// A body comes in; behind one of the same name it is called name(2), name(3), ... by the first number that is free.
template <Floating T>
struct load_body {
  stored_body<T> body;
};
/// Events that name a body; without a name, drop_body apart, they are about all bodies.
struct drop_body {
  part_name name;
};
struct show_part {
  part_name name;
  studio_part part = studio_part::points;
  display how = display::shown;
};
struct shade_body {
  part_name name;
  studio_shading shading = studio_shading::flat;
};
template <Floating T>
struct set_opacity {
  part_name name;
  T opacity = T(1);
};
/// All faces get one colour.
struct colour_body {
  part_name name;
  rgba8 colour;
};
/// At the end of the list of its stage.
template <Floating T>
struct add_transformation {
  part_name name;
  studio_stage stage = studio_stage::before;
  studio_transformation<T> transformation;
};
/// Takes the transformation number `from`, counted from 0, out of its list and puts it in again as number `to`.
struct move_transformation {
  part_name name;
  studio_stage stage = studio_stage::before;
  std::size_t from = 0, to = 0;
};
/// Puts another transformation in the place of number `which`.
template <Floating T>
struct change_transformation {
  part_name name;
  studio_stage stage = studio_stage::before;
  std::size_t which = 0;
  studio_transformation<T> transformation;
};
struct remove_transformation {
  part_name name;
  studio_stage stage = studio_stage::before;
  std::size_t which = 0;
};
template <Floating T>
struct aim_camera {
  studio_view view = studio_view::main;
  point<T, 3> eye, target;
  vec<T, 3> up{T(0), T(1), T(0)};
};
/// About its target, by angles in degrees; then `factor` times as far from it.
template <Floating T>
struct orbit_camera {
  studio_view view = studio_view::main;
  T azimuth_degrees{}, elevation_degrees{}, factor = T(1);
};
/// Angle in degrees and factor are those of an oblique projection; others leave them.
template <Floating T>
struct set_projection {
  studio_view view = studio_view::main;
  projection_kind kind = projection_kind::perspective;
  T oblique_degrees = T(45), oblique_factor = cabinet_factor<T>;
};
/// A parallel projection along a direction: axonometries. The eye keeps its distance.
template <Floating T>
struct see_along {
  studio_view view = studio_view::main;
  vec<T, 3> to_viewer;
};
template <Floating T>
struct set_pyramid {
  studio_view view = studio_view::main;
  view_pyramid<T> pyramid;
};
struct show_helper {
  studio_view view = studio_view::main;
  studio_helper helper = studio_helper::world_axes;
  display how = display::shown;
};
/// A single lamp, of full intensity, in place of all lamps, and the share of light from everywhere.
template <Floating T>
struct set_light {
  hpoint<T, 3> lamp;
  T ambient{};
};
template <Floating T>
struct set_ambient {
  T ambient{};
};
/// Lamp number `which`, counted from 0; behind the last one it is a new lamp.
template <Floating T>
struct set_lamp {
  std::size_t which = 0;
  light<T> lamp{{T(0), T(0), T(0), T(1)}, {T(1), T(1), T(1)}};
};
/// Those behind it move up.
struct drop_lamp {
  std::size_t which = 0;
};

/// Any of them.
template <Floating T>
using studio_event = std::variant<load_body<T>, drop_body, show_part, shade_body, set_opacity<T>, colour_body,
                                  add_transformation<T>, move_transformation, remove_transformation, aim_camera<T>,
                                  orbit_camera<T>, set_projection<T>, see_along<T>, set_pyramid<T>, show_helper,
                                  set_light<T>, change_transformation<T>, set_ambient<T>, set_lamp<T>, drop_lamp>;

inline namespace IRG_ABI {

/// A sentence, without a full stop.
[[nodiscard]] constexpr const char* sentence_of(studio_status s) noexcept {
  switch (s) {
    case studio_status::done: return "done";
    case studio_status::no_such_body: return "no body has this name";
    case studio_status::no_name: return "body has no name";
    case studio_status::broken_faces: return "body has a face that is none";
    case studio_status::not_finite: return "a number is not finite";
    case studio_status::edge_without_point: return "body has an edge without a point";
    case studio_status::broken_surface: return "body has a surface that is none";
    case studio_status::no_matrix: return "transformation has no matrix";
    case studio_status::no_such_transformation: return "list has no transformation of this number";
    case studio_status::bad_opacity: return "opacity is not from 0 to 1";
    case studio_status::eye_in_target: return "eye and target are one point, or too far apart";
    case studio_status::no_projection: return "camera has no projection";
    case studio_status::bad_light: return "ambient light is not from 0 to 1";
    case studio_status::bad_lamp: return "part of a lamp's light is not from 0 to 1";
    case studio_status::no_such_lamp: return "no lamp has this number";
  }
  return "";
}

/// What an event makes of the studio.
/// gives   a status; when it is not `done` the studio is as it was. Events about all bodies leave out those that cannot
///         follow
/// cost    at most the number of bodies, and for load_body that of the body
template <Floating T>
constexpr studio_status apply_event(studio<T>& s, const studio_event<T>& e);

}  // namespace IRG_ABI

namespace detail {
inline namespace IRG_ABI {

// The number of a name among those that begin with `plain`: 1 for itself, n for plain(n) up to `most`, 0 for others.
constexpr std::size_t number_of_name(std::string_view name, std::string_view plain, std::size_t most) noexcept {
  if (!name.starts_with(plain)) return 0;
  name.remove_prefix(plain.size());
  if (name.empty()) return 1;
  if (name.size() < 3 || name.front() != '(' || name.back() != ')' || name[1] == '0') return 0;
  std::size_t n = 0;
  for (const char c : name.substr(1, name.size() - 2)) {
    if (c < '0' || c > '9') return 0;
    n = 10 * n + static_cast<std::size_t>(c - '0');
    if (n > most) return 0;
  }
  return n < 2 ? 0 : n;
}

// Names are words of scripts in quotes and values of XML: quotes and control characters become question marks.
template <class T>
constexpr part_name free_name(const studio<T>& s, const part_name& wanted) {
  part_name name;
  for (const char c : std::string_view(wanted))
    name.push_back(static_cast<unsigned char>(c) < 32 || c == 127 || c == '"' ? '?' : c);
  const std::size_t most = s.bodies.size() + 1;  // a number up to this is free
  std::vector<char> is_taken(most + 1, '\0');
  for (const studio_body<T>& b : s.bodies) is_taken[number_of_name(b.body.name, name, most)] = 1;
  std::size_t n = 1;
  while (is_taken[n] != 0) ++n;
  if (n == 1) return name;
  char digits[20] = {};
  std::size_t first = sizeof digits;
  for (; n != 0; n /= 10) digits[--first] = static_cast<char>('0' + n % 10);
  name.push_back('(');
  for (; first < sizeof digits; ++first) name.push_back(digits[first]);
  name.push_back(')');
  return name;
}

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
    if (f != no_index && f >= b.surfaces.size()) return studio_status::broken_surface;
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
    const std::optional<std::size_t> i = find_body(s, name);
    return i ? change(s.bodies[*i]) : studio_status::no_such_body;
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
  if (!is_finite(c.eye, c.target, c.up) || !is_finite(c.oblique_degrees, c.oblique_factor))
    return studio_status::not_finite;
  const T away = length(c.target - c.eye);
  if (!(T(0) < away) || !is_finite(away)) return studio_status::eye_in_target;
  if (!(T(0) < p.width && T(0) < p.height && T(0) < p.distance && T(0) < p.near_distance) ||
      !is_finite(p.width, p.height, p.distance, p.far_distance) ||
      !view_projection_checked(camera_of(c), p.width / p.height).ok())
    return studio_status::no_projection;
  place = c;
  return studio_status::done;
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

template <Floating T>
constexpr studio_status apply_event(studio<T>& s, load_body<T> e) {
  if (const studio_status bad = detail::status_of_body(e.body); bad != studio_status::done) return bad;
  mesh<T>& m = e.body.shape;
  m.normals.clear();
  m.texcoords.clear();
  m.parts.clear();
  for (mesh_corner& c : m.corners) c = {c.position, no_index, no_index};
  e.body.name = detail::free_name(s, e.body.name);
  studio_body<T> b;
  b.body = std::move(e.body);
  s.bodies.push_back(std::move(b));
  return studio_status::done;
}
template <Floating T>
constexpr studio_status apply_event(studio<T>& s, const drop_body& e) {
  const std::optional<std::size_t> i = find_body(s, e.name);
  if (!i) return studio_status::no_such_body;
  s.bodies.erase(s.bodies.begin() + static_cast<std::ptrdiff_t>(*i));
  return studio_status::done;
}
template <Floating T>
constexpr studio_status apply_event(studio<T>& s, const show_part& e) {
  return detail::change_bodies(s, e.name, [&](studio_body<T>& b) {
    b.parts[static_cast<std::size_t>(e.part)] = e.how;
    return studio_status::done;
  });
}
template <Floating T>
constexpr studio_status apply_event(studio<T>& s, const shade_body& e) {
  return detail::change_bodies(s, e.name, [&](studio_body<T>& b) {
    b.shading = e.shading;
    return studio_status::done;
  });
}
template <Floating T>
constexpr studio_status apply_event(studio<T>& s, const set_opacity<T>& e) {
  if (!(T(0) <= e.opacity && e.opacity <= T(1))) return studio_status::bad_opacity;
  return detail::change_bodies(s, e.name, [&](studio_body<T>& b) {
    b.opacity = e.opacity;
    return studio_status::done;
  });
}
template <Floating T>
constexpr studio_status apply_event(studio<T>& s, const colour_body& e) {
  if (e.name.empty())
    for (studio_body<T>& b : s.bodies)
      if (b.body.surfaces.empty()) b.body.surfaces.reserve(1);
  return detail::change_bodies(s, e.name, [&](studio_body<T>& b) {
    if (b.body.surfaces.empty()) b.body.surfaces.push_back({});
    for (stored_surface<T>& f : b.body.surfaces) f.colour = e.colour;
    for (std::uint32_t& f : b.body.surface_of_face)
      if (f == no_index) f = 0;
    return studio_status::done;
  });
}
template <Floating T>
constexpr studio_status apply_event(studio<T>& s, const add_transformation<T>& e) {
  if (!matrix_of(e.transformation)) return studio_status::no_matrix;
  if (e.name.empty())  // room for all first: they change together or not at all
    for (studio_body<T>& b : s.bodies) detail::make_room(detail::list_of(b, e.stage));
  return detail::change_bodies(s, e.name, [&](studio_body<T>& b) {
    detail::list_of(b, e.stage).push_back(e.transformation);
    return studio_status::done;
  });
}
template <Floating T>
constexpr studio_status apply_event(studio<T>& s, const move_transformation& e) {
  return detail::change_bodies(s, e.name, [&](studio_body<T>& b) {
    auto& list = detail::list_of(b, e.stage);
    if (e.from >= list.size() || e.to >= list.size()) return studio_status::no_such_transformation;
    const auto at = [&](std::size_t i) { return list.begin() + static_cast<std::ptrdiff_t>(i); };
    if (e.from < e.to)
      std::rotate(at(e.from), at(e.from + 1), at(e.to + 1));
    else
      std::rotate(at(e.to), at(e.from), at(e.from + 1));
    return studio_status::done;
  });
}
template <Floating T>
constexpr studio_status apply_event(studio<T>& s, const change_transformation<T>& e) {
  if (!matrix_of(e.transformation)) return studio_status::no_matrix;
  return detail::change_bodies(s, e.name, [&](studio_body<T>& b) {
    auto& list = detail::list_of(b, e.stage);
    if (e.which >= list.size()) return studio_status::no_such_transformation;
    list[e.which] = e.transformation;
    return studio_status::done;
  });
}
template <Floating T>
constexpr studio_status apply_event(studio<T>& s, const remove_transformation& e) {
  return detail::change_bodies(s, e.name, [&](studio_body<T>& b) {
    auto& list = detail::list_of(b, e.stage);
    if (e.which >= list.size()) return studio_status::no_such_transformation;
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(e.which));
    return studio_status::done;
  });
}
template <Floating T>
constexpr studio_status apply_event(studio<T>& s, const aim_camera<T>& e) noexcept {
  studio_camera<T> c = s.of(e.view);
  c.eye = e.eye;
  c.target = e.target;
  c.up = e.up;
  return detail::put_camera(s.of(e.view), c);
}
template <Floating T>
constexpr studio_status apply_event(studio<T>& s, const orbit_camera<T>& e) noexcept {
  if (!is_finite(e.azimuth_degrees) || !is_finite(e.elevation_degrees) || !is_finite(e.factor))
    return studio_status::not_finite;
  studio_camera<T> c = s.of(e.view);
  polar_camera<T> polar = polar_of(look_at_frame(c.eye, c.target, c.up), length(c.target - c.eye));
  polar.target = c.target;
  polar.distance = polar.distance * e.factor;
  const auto frame = try_frame_of(orbited(polar, radians(e.azimuth_degrees), radians(e.elevation_degrees)));
  if (!frame) return studio_status::not_finite;
  c.eye = frame->position;
  c.up = frame->up;
  return detail::put_camera(s.of(e.view), c);
}
template <Floating T>
constexpr studio_status apply_event(studio<T>& s, const set_projection<T>& e) noexcept {
  studio_camera<T> c = s.of(e.view);
  c.projection = e.kind;
  if (e.kind == projection_kind::oblique) {
    c.oblique_degrees = e.oblique_degrees;
    c.oblique_factor = e.oblique_factor;
  }
  return detail::put_camera(s.of(e.view), c);
}
template <Floating T>
constexpr studio_status apply_event(studio<T>& s, const see_along<T>& e) noexcept {
  studio_camera<T> c = s.of(e.view);
  if (!is_finite(e.to_viewer)) return studio_status::not_finite;
  c.projection = projection_kind::orthographic;
  c.eye = c.target + normalized(e.to_viewer) * length(c.target - c.eye);
  c.up = {T(0), T(1), T(0)};
  return detail::put_camera(s.of(e.view), c);
}
template <Floating T>
constexpr studio_status apply_event(studio<T>& s, const set_pyramid<T>& e) noexcept {
  studio_camera<T> c = s.of(e.view);
  c.pyramid = e.pyramid;
  return detail::put_camera(s.of(e.view), c);
}
template <Floating T>
constexpr studio_status apply_event(studio<T>& s, const show_helper& e) noexcept {
  s.of(e.view).helpers[static_cast<std::size_t>(e.helper)] = e.how;
  return studio_status::done;
}
template <Floating T>
constexpr studio_status apply_event(studio<T>& s, const set_ambient<T>& e) noexcept {
  if (!(T(0) <= e.ambient && e.ambient <= T(1))) return studio_status::bad_light;
  s.ambient = e.ambient;
  return studio_status::done;
}
template <Floating T>
constexpr studio_status apply_event(studio<T>& s, const set_lamp<T>& e) {
  if (const studio_status bad = detail::status_of_lamp(e.lamp); bad != studio_status::done) return bad;
  if (e.which > s.lamps.size()) return studio_status::no_such_lamp;
  if (e.which == s.lamps.size())
    s.lamps.push_back(e.lamp);
  else
    s.lamps[e.which] = e.lamp;
  return studio_status::done;
}
template <Floating T>
constexpr studio_status apply_event(studio<T>& s, const drop_lamp& e) noexcept {
  if (e.which >= s.lamps.size()) return studio_status::no_such_lamp;
  s.lamps.erase(s.lamps.begin() + static_cast<std::ptrdiff_t>(e.which));
  return studio_status::done;
}
template <Floating T>
constexpr studio_status apply_event(studio<T>& s, const set_light<T>& e) {
  if (!(T(0) <= e.ambient && e.ambient <= T(1))) return studio_status::bad_light;
  auto alone = studio<T>::white_lamp(e.lamp);
  if (const studio_status bad = detail::status_of_lamp(alone[0]); bad != studio_status::done) return bad;
  s.lamps = std::move(alone);
  s.ambient = e.ambient;
  return studio_status::done;
}

// Whatever event it is.
template <Floating T>
constexpr studio_status apply_event(studio<T>& s, const studio_event<T>& e) {
  return std::visit([&](const auto& one) { return apply_event(s, one); }, e);
}

}  // namespace IRG_ABI
}  // namespace irg
