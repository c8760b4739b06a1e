// SPDX-License-Identifier: MIT
// The studio of the thesis as a value: bodies with their transformations and looks, two cameras, lamps. One camera
// takes the picture, the other watches bodies and camera from outside.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <irg/scene/camera.hpp>
#include <irg/scene/stored_body.hpp>
#include "studio_transformation.hpp"
#include <irg/shade/light.hpp>
#include <irg/view/view_pyramid.hpp>

namespace irg {

/// Whether something is drawn.
enum class display { hidden, shown };

/// The two pictures, side by side.
enum class studio_view { main, outer };

/// When a transformation takes place: in the world, before the camera's coordinates, or in these.
enum class studio_stage { before, after };

/// What is drawn of a body. Backs: faces that face away, and their edges.
enum class studio_part { points, edges, faces, backs };

/// What is drawn beside the bodies: the axes of the world and of the main camera, that camera as a body with its
/// screen, and the pyramid cut off that it sees.
enum class studio_helper { world_axes, camera_axes, camera, pyramid };

/// How light falls on faces; none: they have their colour.
enum class studio_shading { none, flat, gouraud, phong };

/// A body in the studio.
/// shape   positions and faces only: no normals, texture coordinates or parts; opacity 0 to 1
template <Floating T>
struct studio_body {
  stored_body<T> body;
  std::array<display, 4> parts{display::hidden, display::hidden, display::shown, display::hidden};
  studio_shading shading = studio_shading::flat;
  T opacity = T(1);
  std::array<std::vector<studio_transformation<T>>, 2> transformations{};  // by stage
  bool operator==(const studio_body&) const = default;

  [[nodiscard]] IRG_APART constexpr bool shows(studio_part p) const noexcept {
    return parts[static_cast<std::size_t>(p)] == display::shown;
  }
};

/// A camera of the studio: where it stands, how it projects, what it sees, and the helpers in its picture.
/// units   degrees
/// needs   finite numbers, eye and target apart, a pyramid in its domain with its far plane at a finite distance
template <Floating T>
struct studio_camera {
  point<T, 3> eye, target{};
  vec<T, 3> up{T(0), T(1), T(0)};
  projection_kind projection = projection_kind::perspective;
  T oblique_degrees = T(45), oblique_factor = cabinet_factor<T>;
  view_pyramid<T> pyramid{T(2), T(2), T(1.5), T(1), T(15)};
  std::array<display, 4> helpers{};
  bool operator==(const studio_camera&) const = default;

  [[nodiscard]] IRG_APART constexpr bool shows(studio_helper h) const noexcept {
    return helpers[static_cast<std::size_t>(h)] == display::shown;
  }
};

/// What became of an event.
enum class [[nodiscard]] studio_status {
  done,
  no_such_body,
  no_name,
  broken_faces,
  not_finite,
  edge_without_point,
  broken_surface,
  no_matrix,
  no_such_transformation,
  bad_opacity,
  eye_in_target,
  no_projection,
  bad_light,
  bad_lamp,
  no_such_lamp
};

/// All that a picture of the studio depends on.
template <Floating T>
struct studio {
  /// One lamp of full intensity alone; a direction with weight 0.
  [[nodiscard]] static constexpr std::vector<light<T>> white_lamp(const hpoint<T, 3>& position) {
    return std::vector<light<T>>(1, light<T>{position, {T(1), T(1), T(1)}});
  }

  std::vector<studio_body<T>> bodies;
  std::array<studio_camera<T>, 2> cameras{
      studio_camera<T>{{T(4), T(3), T(6)}},
      studio_camera<T>{.eye = {T(20), T(14), T(-4)},
                       .pyramid = {T(2), T(2), T(1.5), T(0.5), T(200)},
                       .helpers = {display::shown, display::shown, display::shown, display::shown}}};
  std::vector<light<T>> lamps = white_lamp({T(-5), T(10), T(8), T(1)});  // each part of an intensity 0 to 1
  T ambient = T(0.25);  // share of the light that comes from everywhere; of the rest each lamp gives its intensity
  bool operator==(const studio&) const = default;

  [[nodiscard]] IRG_APART constexpr studio_camera<T>& of(studio_view v) noexcept {
    return cameras[static_cast<std::size_t>(v)];
  }
  [[nodiscard]] IRG_APART constexpr const studio_camera<T>& of(studio_view v) const noexcept {
    return cameras[static_cast<std::size_t>(v)];
  }
};

inline namespace IRG_ABI {

/// The number of the body of that name, where there is one.
template <Floating T>
[[nodiscard]] constexpr std::optional<std::size_t> find_body(const studio<T>& s, const part_name& name) noexcept {
  for (std::size_t i = 0; i < s.bodies.size(); ++i)
    if (s.bodies[i].body.name == name) return i;
  return std::nullopt;
}

/// The camera that takes a picture of the screen of a studio camera. Parallel projections show as much as the pyramid
/// holds at the target's distance.
/// needs   a camera in its domain
template <Floating T>
[[nodiscard]] constexpr camera<T> camera_of(const studio_camera<T>& c) noexcept {
  return {c.eye,
          c.target,
          c.up,
          c.projection,
          vertical_angle_of(c.pyramid),
          c.pyramid.near_distance,
          c.pyramid.far_distance,
          {radians(c.oblique_degrees), c.oblique_factor}};
}

/// Where a body stands as the main camera sees it: its transformations before the camera, then those after it, brought
/// back from the camera's coordinates into the world's, so that both cameras see the same.
/// gives   exactly the transformations before the camera where there are none after it. A projection from an eye gives
///         a last row other than 0 0 0 1
/// exact   rounded as the products are
template <Floating T>
[[nodiscard]] constexpr mat<T, 4, 4> placement_of(const studio<T>& s, const studio_body<T>& b) noexcept {
  const auto before = matrix_of(std::span<const studio_transformation<T>>(b.transformations[0]));
  if (b.transformations[1].empty()) return before;
  const studio_camera<T>& c = s.of(studio_view::main);
  const camera_frame<T> frame = look_at_frame(c.eye, c.target, c.up);
  return camera_to_world(frame) * matrix_of(std::span<const studio_transformation<T>>(b.transformations[1])) *
         view_matrix(frame) * before;
}

}  // namespace IRG_ABI
}  // namespace irg
