// SPDX-License-Identifier: MIT
// Private to the chapter: surfaces made of closed rings of vertices, such as spheres, tori and turned bodies, and the
// points of a circle with all the symmetry that numbers allow.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include <irg/math/constants.hpp>
#include <irg/math/sqrt.hpp>
#include <irg/math/trigonometry.hpp>
#include <irg/mesh/mesh.hpp>

namespace irg::detail::inline IRG_ABI {

/// What stands at an end of a stack of rings.
enum class ring_end {
  open,    // a ring: the surface has a border
  pole,    // one vertex
  closed,  // nothing: the last ring joins the first; holds for both ends or none
};

/// A vertex with its normal.
template <Floating T>
struct surface_vertex {
  point<T, 3> position;
  vec<T, 3> normal;
};

/// The cosine (x) and sine (y) of k/n of a full turn.
/// needs   0 <= k < n <= 2^28
/// exact   0 and 1 are exact at quarter turns, sine and cosine are equal at an eighth; points that mirror each other in
///         an axis or diagonal do so bit for bit
constexpr vec<double, 2> circle_point(int k, int n) noexcept {
  const int quarter = 4 * k / n, rest = 4 * k - quarter * n;  // the angle is (quarter + rest/n) right angles
  const bool beyond_diagonal = 2 * rest > n;
  const int lesser_part = beyond_diagonal ? n - rest : rest;
  const double angle = half_pi<double> * static_cast<double>(lesser_part) / static_cast<double>(n);
  double c = 2 * lesser_part == n ? sqrt(0.5) : cos(angle), s = 2 * lesser_part == n ? c : sin(angle);
  if (beyond_diagonal) std::swap(c, s);
  // 0 - s rather than -s: the axes have no negative zeros.
  if (quarter == 0) return {c, s};
  if (quarter == 1) return {0 - s, c};
  if (quarter == 2) return {0 - c, 0 - s};
  return {s, 0 - c};
}

template <class T>
constexpr void add_smooth_triangle(mesh<T>& m, std::size_t a, std::size_t b, std::size_t c, std::size_t to_normal) {
  for (const std::size_t v : {a, b, c})
    m.corners.push_back({static_cast<std::uint32_t>(v), static_cast<std::uint32_t>(v + to_normal), no_index});
  m.face_starts.push_back(static_cast<std::uint32_t>(m.corners.size()));
}

/// Appends a surface with `around` columns that close and rows 0 to `rows` from end to end; vertex(i, j) gives the
/// vertex of column i in row j. Seams and poles are single vertices, and no triangle is degenerate by its indices.
/// shape   the outside is where i x j points to: seen from there, j rises counter-clockwise of i
/// needs   around >= 3, rows >= 1 (3 when closed); fewer than 2^32 corners in all
template <class T, class Vertex>
constexpr void add_rings(mesh<T>& m, int around, int rows, ring_end first, ring_end last, const Vertex& vertex) {
  const std::size_t base = m.positions.size(), to_normal = m.normals.size() - base;
  const int last_row = last == ring_end::closed ? rows - 1 : rows;
  for (int j = 0; j <= last_row; ++j) {
    const bool is_pole = (j == 0 && first == ring_end::pole) || (j == rows && last == ring_end::pole);
    for (int i = 0; i < (is_pole ? 1 : around); ++i) {
      const surface_vertex<T> v = vertex(i, j);
      m.positions.push_back(v.position);
      m.normals.push_back(v.normal);
    }
  }
  const auto index = [&](int i, int j) {
    const std::size_t row = static_cast<std::size_t>(j > last_row ? 0 : j), ring = static_cast<std::size_t>(around);
    const std::size_t before = first == ring_end::pole && row > 0 ? 1 + (row - 1) * ring : row * ring;
    const bool is_pole = (j == 0 && first == ring_end::pole) || (j == rows && last == ring_end::pole);
    return base + before + static_cast<std::size_t>(is_pole ? 0 : i < around ? i : 0);
  };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < around; ++i) {
      const std::size_t a = index(i, j), b = index(i + 1, j), c = index(i + 1, j + 1), d = index(i, j + 1);
      if (a != b) add_smooth_triangle(m, a, b, c, to_normal);
      if (c != d) add_smooth_triangle(m, a, c, d, to_normal);
    }
}

}  // namespace irg::detail::inline IRG_ABI
