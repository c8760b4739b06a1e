// SPDX-License-Identifier: MIT
// The unit sphere and the torus as closed triangle meshes with smooth normals.
#pragma once

#include <irg/core/conversion.hpp>
#include <irg/mesh/detail/rings.hpp>
#include <irg/mesh/mesh.hpp>

namespace irg {

/// How finely a sphere is cut: columns around the axis and layers from pole to pole.
struct sphere_options {
  int slices = 32;  // taken as 3 if less, as 4096 if more
  int stacks = 16;  // taken as 2 if less, as 4096 if more
};

/// The size of a torus and how finely it is cut: around the axis (major) and around the tube (minor).
template <Floating T>
struct torus_options {
  T major_radius = 1, minor_radius = T(0.4);
  int major_segments = 48, minor_segments = 24;  // taken as 3 if less, as 4096 if more
};

inline namespace IRG_ABI {

/// The sphere of radius 1 about the origin, poles at y = 1 and y = -1.
/// shape   slices*(stacks - 1) + 2 vertices, 2*slices*(stacks - 1) triangles, closed, counter-clockwise from outside;
///         one normal per vertex, equal to its position
/// exact   vertices lie within 3u of the sphere (u = 2^-53, float 2^-24); mirror images in the coordinate planes are
///         exact where slices is even (x, z by 4) and stacks any number
template <Floating T>
[[nodiscard]] constexpr mesh<T> shape_sphere(const sphere_options& options = {}) {
  const int slices = detail::clamped(options.slices, 3, 4096), stacks = detail::clamped(options.stacks, 2, 4096);
  mesh<T> m;
  detail::add_rings(m, slices, stacks, detail::ring_end::pole, detail::ring_end::pole, [&](int i, int j) {
    const vec<double, 2> across = detail::circle_point(i, slices), down = detail::circle_point(j, 2 * stacks);
    const vec<T, 3> n{converted<T>(down.y * across.x), converted<T>(down.x), converted<T>(down.y * across.y)};
    return detail::surface_vertex<T>{to_point(n), n};
  });
  return m;
}

/// The torus about the y axis, its tube's centre line in the plane y = 0.
/// shape   major_segments*minor_segments vertices and twice as many triangles, closed, counter-clockwise from outside;
///         one normal per vertex
/// needs   minor_radius > 0; above major_radius the surface passes through itself
/// exact   positions within 4u*(major_radius + minor_radius), normals within 3u of length 1
template <Floating T>
[[nodiscard]] constexpr mesh<T> shape_torus(const torus_options<T>& options = {}) {
  const int major = detail::clamped(options.major_segments, 3, 4096);
  const int minor = detail::clamped(options.minor_segments, 3, 4096);
  const double ring_radius = widened(options.major_radius), tube_radius = widened(options.minor_radius);
  mesh<T> m;
  detail::add_rings(m, major, minor, detail::ring_end::closed, detail::ring_end::closed, [&](int i, int j) {
    const vec<double, 2> across = detail::circle_point(i, major), tube = detail::circle_point(j, minor);
    const double radius = ring_radius + product(tube_radius, tube.x);
    return detail::surface_vertex<T>{
        {converted<T>(radius * across.x), converted<T>(0 - product(tube_radius, tube.y)),
         converted<T>(radius * across.y)},
        {converted<T>(tube.x * across.x), converted<T>(0 - tube.y), converted<T>(tube.x * across.y)}};
  });
  return m;
}

}  // namespace IRG_ABI
}  // namespace irg
