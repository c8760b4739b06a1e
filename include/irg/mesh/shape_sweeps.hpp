// SPDX-License-Identifier: MIT
// Bodies that a curve or a polygon sweeps: turned about an axis, or pushed along one; and the dodecahedron. They have
// no normals: assign_crease_normals() or assign_vertex_normals() gives some.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include <irg/core/conversion.hpp>
#include <irg/core/ring.hpp>
#include <irg/math/length.hpp>
#include <irg/mesh/detail/rings.hpp>
#include <irg/mesh/half_edge_mesh.hpp>
#include <irg/mesh/shape_polyhedra.hpp>
#include <irg/mesh/to_half_edges.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// The vertices of a profile's point all round: one where it lies on the axis.
template <Floating T>
constexpr std::vector<std::uint32_t> add_turned_point(mesh<T>& m, T radius, T height, int slices) {
  std::vector<std::uint32_t> ring;
  for (int i = 0; i < slices; ++i) {
    if (i == 0 || radius != T(0)) {
      const vec<double, 2> across = circle_point(i, slices);
      m.positions.push_back(
          {converted<T>(product(widened(radius), across.x)), height, converted<T>(product(widened(radius), across.y))});
    }
    ring.push_back(static_cast<std::uint32_t>(m.positions.size() - 1));
  }
  return ring;
}

// A face without the corners that it has twice in a row.
template <Floating T>
constexpr void add_collapsed_face(mesh<T>& m, const std::vector<std::uint32_t>& corners) {
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (corners[i] != corners[i + 1 < corners.size() ? i + 1 : 0]) kept.push_back(corners[i]);
  if (kept.size() > 2) add_face(m, kept);
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// The body that a profile sweeps when it is turned about the y axis.
/// shape   the profile's points are (radius, height), from the lower end to the upper one, the body to its left. Sides
///         of four corners, of three at the axis; where the profile ends off the axis, a lid of `slices` corners
/// needs   two points or more, radii of 0 or more; a profile that does not cross itself
/// gives   a closed surface, counter-clockwise from outside; slices are taken as 3 if less, as 4096 if more
/// exact   positions within 3u of the radius; lids are plane, sides nearly
template <Floating T>
[[nodiscard]] constexpr mesh<T> shape_revolution(const std::vector<point<T, 2>>& profile, int slices = 32) {
  slices = detail::clamped(slices, 3, 4096);
  mesh<T> m;
  std::vector<std::uint32_t> lower, upper;
  for (std::size_t k = 0; k < profile.size(); ++k) {
    upper = detail::add_turned_point(m, profile[k].x, profile[k].y, slices);
    if (k == 0) detail::add_collapsed_face(m, upper);
    for (std::size_t i = 0, n = upper.size(); k > 0 && i < n; ++i) {
      const std::size_t next = i + 1 < n ? i + 1 : 0;
      detail::add_collapsed_face(m, {lower[i], upper[i], upper[next], lower[next]});
    }
    lower = upper;
  }
  detail::add_collapsed_face(m, {lower.rbegin(), lower.rend()});
  return m;
}

/// The prism over a polygon: from z = 0 to z = height.
/// shape   the polygon below, turned, the polygon above, then a side of four corners for each of its edges
/// needs   a simple polygon, counter-clockwise; height > 0
/// gives   a closed surface, counter-clockwise from outside
/// exact   yes: corners are the polygon's
template <PolygonRing R>
  requires Floating<scalar_of<ring_point<R>>>
[[nodiscard]] constexpr auto shape_extrusion(const R& polygon, std::type_identity_t<scalar_of<ring_point<R>>> height) {
  using T = scalar_of<ring_point<R>>;
  mesh<T> m;
  const auto n = static_cast<std::uint32_t>(ring_size(polygon));
  std::vector<std::uint32_t> below, above;
  for (std::uint32_t i = 0; i < n; ++i) {
    const auto p = ring_vertex(polygon, i);
    m.positions.push_back({coordinate(p, 0), coordinate(p, 1), T(0)});
    m.positions.push_back({coordinate(p, 0), coordinate(p, 1), height});
    below.push_back(2 * (n - 1 - i));
    above.push_back(2 * i + 1);
  }
  add_face(m, below);
  add_face(m, above);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t here = 2 * i, next = i + 1 < n ? here + 2 : 0;
    add_face(m, std::vector<std::uint32_t>{here, next, next + 1, here + 1});
  }
  return m;
}

/// The cylinder of radius 1 about the y axis, from y = -1 to y = 1; of few slices the prism.
template <Floating T>
[[nodiscard]] constexpr mesh<T> shape_cylinder(int slices = 32) {
  return shape_revolution<T>({{T(1), T(-1)}, {T(1), T(1)}}, slices);
}

/// The cone of radius 1 about the y axis, from y = -1 to its tip at y = 1; of few slices the pyramid.
template <Floating T>
[[nodiscard]] constexpr mesh<T> shape_cone(int slices = 32) {
  return shape_revolution<T>({{T(1), T(-1)}, {T(0), T(1)}}, slices);
}

/// The dodecahedron in the unit sphere: a corner over each face of the icosahedron, a face round each of its corners.
/// shape   20 vertices, 12 faces of five corners, closed, counter-clockwise from outside
/// exact   vertices within 4u of the sphere; faces are plane but for that
template <Floating T>
[[nodiscard]] constexpr mesh<T> shape_dodecahedron() {
  const mesh<T> dual = shape_icosahedron<T>();
  const half_edge_mesh<T> edges = to_half_edges(dual).value;
  mesh<T> m;
  for (std::size_t f = 0; f < dual.face_count(); ++f) {
    vec<T, 3> sum{};
    for (std::size_t k = 0; k < 3; ++k) sum = sum + to_vec(dual.positions[dual.corner(f, k).position]);
    m.positions.push_back(to_point(normalized(sum)));
  }
  for (std::uint32_t v = 0; v < dual.positions.size(); ++v) {
    std::vector<std::uint32_t> corners;
    each_half_edge_at(edges, v, [&](std::uint32_t h) { corners.push_back(edges.face(h)); });
    add_face(m, corners);
  }
  return m;
}

}  // namespace IRG_ABI
}  // namespace irg
