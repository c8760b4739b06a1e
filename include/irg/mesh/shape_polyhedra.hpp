// SPDX-License-Identifier: MIT
// Bodies with flat faces: the cube of exercises, three Platonic bodies, and a plane grid. Each corner has the normal
// of its face, so that smooth shading shows the edges.
#pragma once

#include <cstddef>
#include <cstdint>

#include <irg/core/conversion.hpp>
#include <irg/math/constants.hpp>
#include <irg/math/length.hpp>
#include <irg/math/sqrt.hpp>
#include <irg/mesh/mesh.hpp>

namespace irg {

/// How finely a plane grid is cut.
struct grid_options {
  int columns = 10, rows = 10;  // cells along x and z; taken as 1 if less, as 4096 if more
};

namespace detail {
inline namespace IRG_ABI {

/// Triangles over the positions of m, three digits each; digits count from 1 as in an OBJ file, up to 9, then A, B, C.
/// Of `per_normal` triangles, one after the other, each corner names the next normal.
template <class T, std::size_t N>
constexpr void add_triangles(mesh<T>& m, const char (&digits)[N], std::size_t per_normal) {
  for (std::size_t k = 0; k + 1 < N; ++k) {
    if (digits[k] == ' ') continue;
    const int position = digits[k] <= '9' ? digits[k] - '1' : digits[k] - 'A' + 9;
    const auto normal = static_cast<std::uint32_t>(m.corners.size() / (3 * per_normal));
    m.corners.push_back({static_cast<std::uint32_t>(position), normal, mesh_corner::none});
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

}  // namespace IRG_ABI
}  // namespace detail

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

/// The regular tetrahedron in the unit sphere, on four corners of a cube.
/// shape   4 vertices, 4 triangles, counter-clockwise from outside, 4 normals
/// exact   vertices within 2u of the sphere
template <Floating T>
[[nodiscard]] constexpr mesh<T> shape_tetrahedron() {
  const T i = 1 / sqrt_3<T>;
  mesh<T> m;
  m.positions = {{i, i, i}, {i, -i, -i}, {-i, i, -i}, {-i, -i, i}};
  detail::add_triangles(m, "123 142 134 243", 1);
  detail::add_central_normals(m);
  return m;
}

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

/// The regular icosahedron in the unit sphere, its vertices on three golden rectangles in the coordinate planes.
/// shape   12 vertices, 20 triangles, counter-clockwise from outside, 20 normals
/// exact   vertices within 3u of the sphere
template <Floating T>
[[nodiscard]] constexpr mesh<T> shape_icosahedron() {
  const double golden = golden_ratio<double>, length = sqrt(1 + product(golden, golden));
  const T o = 0, i = converted<T>(1 / length), g = converted<T>(golden / length);
  mesh<T> m;
  m.positions = {{-i, g, o},  {i, g, o},  {-i, -g, o}, {i, -g, o}, {o, -i, g},  {o, i, g},
                 {o, -i, -g}, {o, i, -g}, {g, o, -i},  {g, o, i},  {-g, o, -i}, {-g, o, i}};
  detail::add_triangles(m, "1C6 162 128 18B 1BC 26A 6C5 CB3 B87 829 4A5 453 437 479 49A 5A6 35C 73B 978 A92", 1);
  detail::add_central_normals(m);
  return m;
}

/// The square [-1, 1] x [-1, 1] of the plane y = 0, facing up.
/// shape   (columns + 1)*(rows + 1) vertices along x, then z; 2*columns*rows triangles; one normal, (0, 1, 0)
/// exact   coordinates rounded once; mirror images in the coordinate planes are exact
template <Floating T>
[[nodiscard]] constexpr mesh<T> shape_grid(const grid_options& options = {}) {
  const auto limited = [](int n) { return n < 1 ? 1 : n > 4096 ? 4096 : n; };
  const int columns = limited(options.columns), rows = limited(options.rows);
  const auto place = [](int k, int n) { return static_cast<T>(2 * k - n) / static_cast<T>(n); };
  mesh<T> m;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) m.positions.push_back({place(i, columns), T(0), place(j, rows)});
  m.normals = {{T(0), T(1), T(0)}};
  const auto corner = [&](int i, int j) {
    m.corners.push_back({static_cast<std::uint32_t>(j * (columns + 1) + i), 0, mesh_corner::none});
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

}  // namespace IRG_ABI
}  // namespace irg
