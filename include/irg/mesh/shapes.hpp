// SPDX-License-Identifier: MIT
// The built-in bodies: boxes and other polyhedra, spheres, prisms and bodies of revolution; teapot.hpp has the teapot.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include <irg/core/conversion.hpp>
#include <irg/core/ring.hpp>
#include <irg/math/constants.hpp>
#include <irg/math/length.hpp>
#include <irg/mesh/half_edge_mesh.hpp>
#include <irg/mesh/mesh.hpp>
#include <irg/mesh/to_half_edges.hpp>
#include <irg/mesh/teapot.hpp>
#if IRG_BODIES
#include <irg/math/sqrt.hpp>
#include <irg/mesh/detail/rings.hpp>
#endif

namespace irg {

/// How finely a plane grid is cut.
struct grid_options {
  int columns = 10, rows = 10;  // cells along x and z; taken as 1 if less, as 4096 if more
  bool operator==(const grid_options&) const = default;
};

/// How finely a sphere is cut: columns around the axis and layers from pole to pole.
struct sphere_options {
  int slices = 32;  // taken as 3 if less, as 4096 if more
  int stacks = 16;  // taken as 2 if less, as 4096 if more
  bool operator==(const sphere_options&) const = default;
};

/// The size of a torus and how finely it is cut: around the axis (major) and around the tube (minor).
template <Floating T>
struct torus_options {
  T major_radius = 1, minor_radius = T(0.4);
  int major_segments = 48, minor_segments = 24;  // taken as 3 if less, as 4096 if more
  bool operator==(const torus_options&) const = default;
};

namespace detail::inline IRG_ABI {

/// Triangles over the positions of m, three digits each; digits count from 1 as in an OBJ file, up to 9, then A, B, C.
/// Of `per_normal` triangles, one after the other, each corner names the next normal.
template <class T, std::size_t N>
constexpr void add_triangles(mesh<T>& m, const char (&digits)[N], std::size_t per_normal) {
  for (std::size_t k = 0; k + 1 < N; ++k) {
    if (digits[k] == ' ') continue;
    const int position = digits[k] <= '9' ? digits[k] - '1' : digits[k] - 'A' + 9;
    const auto normal = static_cast<std::uint32_t>(m.corners.size() / (3 * per_normal));
    m.corners.push_back({static_cast<std::uint32_t>(position), normal, no_index});
    if (m.corners.size() % 3 == 0) m.face_starts.push_back(static_cast<std::uint32_t>(m.corners.size()));
  }
}

/// The normals of triangles in a sphere about the origin whose corners surround the way out: it is their sum.
template <class T>
constexpr void add_central_normals(mesh<T>& m) {
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    vec<T, 3> sum{};
    for (std::size_t k = 0; k < 3; ++k) sum = sum + to_vec(m.positions[m.corner(f, k).position]);
    if constexpr (Floating<T>) sum = normalized(sum);
    m.normals.push_back(sum);
  }
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The unit cube that exercises use, from (0, 0, 0) to (1, 1, 1).
/// shape   8 vertices, 12 triangles in the order of figure 4.1's file, counter-clockwise from outside, 6 normals
/// exact   yes
/// source  Mihajlovic 2016, 4.6, its f list (its P list runs the other way round)
template <Scalar T>
[[nodiscard]] constexpr mesh<T> shape_cube() {
  constexpr T o(0), i(1);
  mesh<T> m;
  m.positions = {{o, o, o}, {o, o, i}, {i, o, o}, {i, o, i}, {i, i, o}, {i, i, i}, {o, i, o}, {o, i, i}};
  detail::add_triangles(m, "132 342 354 564 576 786 718 128 153 175 246 268", 2);
  constexpr T j(-1);
  m.normals = {{o, j, o}, {i, o, o}, {o, i, o}, {j, o, o}, {o, o, j}, {o, o, i}};
  return m;
}

}  // namespace IRG_ABI

inline namespace IRG_COMPILED_ABI {

/// The regular tetrahedron in the unit sphere, on four corners of a cube.
/// shape   4 vertices, 4 triangles, counter-clockwise from outside, 4 normals
/// exact   vertices within 2u of the sphere
template <Floating T>
[[nodiscard]] IRG_API mesh<T> shape_tetrahedron();

}  // namespace IRG_COMPILED_ABI

inline namespace IRG_ABI {

/// The regular octahedron in the unit sphere, its vertices on the axes.
/// shape   6 vertices, 8 triangles, counter-clockwise from outside, 8 normals: of whole numbers (1, 1, 1) and the like
/// exact   vertices; normals of floats within an ulp
template <Scalar T>
[[nodiscard]] constexpr mesh<T> shape_octahedron() {
  constexpr T o(0), i(1), j(-1);
  mesh<T> m;
  m.positions = {{i, o, o}, {j, o, o}, {o, i, o}, {o, j, o}, {o, o, i}, {o, o, j}};
  detail::add_triangles(m, "135 325 245 415 316 236 426 146", 1);
  detail::add_central_normals(m);
  return m;
}

}  // namespace IRG_ABI

inline namespace IRG_COMPILED_ABI {

/// The regular icosahedron in the unit sphere, its vertices on three golden rectangles in the coordinate planes.
/// shape   12 vertices, 20 triangles, counter-clockwise from outside, 20 normals
/// exact   vertices within 3u of the sphere
template <Floating T>
[[nodiscard]] IRG_API mesh<T> shape_icosahedron();

/// The square [-1, 1] x [-1, 1] of the plane y = 0, facing up.
/// shape   (columns + 1)*(rows + 1) vertices along x, then z; 2*columns*rows triangles; one normal, (0, 1, 0)
/// exact   coordinates rounded once; mirror images in the coordinate planes are exact
template <Floating T>
[[nodiscard]] IRG_API mesh<T> shape_grid(const grid_options& options = {});

/// The sphere of radius 1 about the origin, poles at y = 1 and y = -1.
/// shape   slices*(stacks - 1) + 2 vertices, 2*slices*(stacks - 1) triangles, closed, counter-clockwise from outside;
///         one normal per vertex, equal to its position
/// exact   vertices lie within 3u of the sphere (u = 2^-53, float 2^-24); mirror images in the coordinate planes are
///         exact where slices is even (x, z by 4) and stacks any number
template <Floating T>
[[nodiscard]] IRG_API mesh<T> shape_sphere(const sphere_options& options = {});

/// The torus about the y axis, its tube's centre line in the plane y = 0.
/// shape   major_segments*minor_segments vertices and twice as many triangles, closed, counter-clockwise from outside;
///         one normal per vertex
/// needs   minor_radius > 0; above major_radius the surface passes through itself
/// exact   positions within 4u*(major_radius + minor_radius), normals within 3u of length 1
template <Floating T>
[[nodiscard]] IRG_API mesh<T> shape_torus(const torus_options<T>& options = {});

/// The body that a profile sweeps when it is turned about the y axis.
/// shape   the profile's points are (radius, height), from the lower end to the upper one, the body to its left. Sides
///         of four corners, of three at the axis; where the profile ends off the axis, a lid of `slices` corners
/// needs   two points or more, radii of 0 or more; a profile that does not cross itself
/// gives   a closed surface, counter-clockwise from outside; slices are taken as 3 if less, as 4096 if more
/// exact   positions within 3u of the radius; lids are plane, sides nearly
template <Floating T>
[[nodiscard]] IRG_API mesh<T> shape_revolution(const std::vector<point<T, 2>>& profile, int slices = 32);

}  // namespace IRG_COMPILED_ABI

inline namespace IRG_ABI {

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

}  // namespace IRG_ABI

inline namespace IRG_COMPILED_ABI {

/// The cylinder of radius 1 about the y axis, from y = -1 to y = 1; of few slices the prism.
template <Floating T>
[[nodiscard]] IRG_API mesh<T> shape_cylinder(int slices = 32);

/// The cone of radius 1 about the y axis, from y = -1 to its tip at y = 1; of few slices the pyramid.
template <Floating T>
[[nodiscard]] IRG_API mesh<T> shape_cone(int slices = 32);

/// The dodecahedron in the unit sphere: a corner over each face of the icosahedron, a face round each of its corners.
/// shape   20 vertices, 12 faces of five corners, closed, counter-clockwise from outside
/// exact   vertices within 4u of the sphere; faces are plane but for that
template <Floating T>
[[nodiscard]] IRG_API mesh<T> shape_dodecahedron();

}  // namespace IRG_COMPILED_ABI

}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

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

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API mesh<T> shape_tetrahedron() {
  const T i = 1 / sqrt_3<T>;
  mesh<T> m;
  m.positions = {{i, i, i}, {i, -i, -i}, {-i, i, -i}, {-i, -i, i}};
  detail::add_triangles(m, "123 142 134 243", 1);
  detail::add_central_normals(m);
  return m;
}

template <Floating T>
[[nodiscard]] IRG_API mesh<T> shape_icosahedron() {
  const double golden = golden_ratio<double>, length = sqrt(1 + product(golden, golden));
  const T o = 0, i = converted<T>(1 / length), g = converted<T>(golden / length);
  mesh<T> m;
  m.positions = {{-i, g, o},  {i, g, o},  {-i, -g, o}, {i, -g, o}, {o, -i, g},  {o, i, g},
                 {o, -i, -g}, {o, i, -g}, {g, o, -i},  {g, o, i},  {-g, o, -i}, {-g, o, i}};
  detail::add_triangles(m, "1C6 162 128 18B 1BC 26A 6C5 CB3 B87 829 4A5 453 437 479 49A 5A6 35C 73B 978 A92", 1);
  detail::add_central_normals(m);
  return m;
}

template <Floating T>
[[nodiscard]] IRG_API mesh<T> shape_grid(const grid_options& options) {
  const int columns = clamped(options.columns, 1, 4096), rows = clamped(options.rows, 1, 4096);
  const auto place = [](int k, int n) { return static_cast<T>(2 * k - n) / static_cast<T>(n); };
  mesh<T> m;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) m.positions.push_back({place(i, columns), T(0), place(j, rows)});
  m.normals = {{T(0), T(1), T(0)}};
  const auto corner = [&](int i, int j) {
    m.corners.push_back({static_cast<std::uint32_t>(j * (columns + 1) + i), 0, no_index});
  };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      corner(i, j), corner(i, j + 1), corner(i + 1, j + 1);
      m.face_starts.push_back(static_cast<std::uint32_t>(m.corners.size()));
      corner(i, j), corner(i + 1, j + 1), corner(i + 1, j);
      m.face_starts.push_back(static_cast<std::uint32_t>(m.corners.size()));
    }
  return m;
}

template <Floating T>
[[nodiscard]] IRG_API mesh<T> shape_sphere(const sphere_options& options) {
  const int slices = clamped(options.slices, 3, 4096), stacks = clamped(options.stacks, 2, 4096);
  mesh<T> m;
  detail::add_rings(m, slices, stacks, detail::ring_end::pole, detail::ring_end::pole, [&](int i, int j) {
    const vec<double, 2> across = detail::circle_point(i, slices), down = detail::circle_point(j, 2 * stacks);
    const vec<T, 3> n{converted<T>(down.y * across.x), converted<T>(down.x), converted<T>(down.y * across.y)};
    return detail::surface_vertex<T>{to_point(n), n};
  });
  return m;
}

template <Floating T>
[[nodiscard]] IRG_API mesh<T> shape_torus(const torus_options<T>& options) {
  const int major = clamped(options.major_segments, 3, 4096);
  const int minor = clamped(options.minor_segments, 3, 4096);
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

template <Floating T>
[[nodiscard]] IRG_API mesh<T> shape_revolution(const std::vector<point<T, 2>>& profile, int slices) {
  slices = clamped(slices, 3, 4096);
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

template <Floating T>
[[nodiscard]] IRG_API mesh<T> shape_cylinder(int slices) {
  return shape_revolution<T>({{T(1), T(-1)}, {T(1), T(1)}}, slices);
}

template <Floating T>
[[nodiscard]] IRG_API mesh<T> shape_cone(int slices) {
  return shape_revolution<T>({{T(1), T(-1)}, {T(0), T(1)}}, slices);
}

template <Floating T>
[[nodiscard]] IRG_API mesh<T> shape_dodecahedron() {
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

}  // namespace irg::inline IRG_COMPILED_ABI
#endif
