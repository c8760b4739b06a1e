// SPDX-License-Identifier: MIT
// Normals of vertices: of those of the faces around each (face_normal.hpp), with three kinds of weights.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include <irg/core/conversion.hpp>
#include <irg/core/instructions.hpp>
#include <irg/math/angle_between.hpp>
#include <irg/math/constants.hpp>
#include <irg/math/hypot.hpp>
#include <irg/math/length.hpp>
#include <irg/mesh/face_normal.hpp>
#include <irg/mesh/mesh.hpp>

namespace irg {

/// How much each face around a vertex counts for the vertex's normal.
enum class normal_weight {
  average,  // all faces alike, the form of lectures; depends on how polygons are cut into triangles
  angle,    // by the face's angle at the vertex; does not depend on it
  area,     // by the face's area; does not depend on it as long as the vertex keeps its share of the area
};

inline namespace IRG_ABI {

/// The normal at every vertex of a mesh, of length 1: the normals of the faces around it, weighted, summed in the order
/// of the faces, and normalised. Faces without a normal are passed over.
/// shape   one vector per position, in the positions' order
/// gives   the zero vector where there is no direction: at positions that no face uses, and where the sum is exactly
///         zero, as on both sides of a thin sheet; never NaN
/// exact   each coordinate of the sum rounded once per face; areas smaller than 2^-1000 of the mesh's count nothing, of
///         floats those smaller than 2^-149
/// cost    one pass over the corners; allocates the result
/// source  Mihajlovic 2016, 7.3 (average; its division by the count is left out as it keeps the direction); Thuermer
///         and Wuethrich 1998 (angle); area: the length of Newell's vector
template <SpaceMesh M>
[[nodiscard]] constexpr std::vector<mesh_normal<M>> vertex_normals(const M& m,
                                                                   normal_weight weight = normal_weight::average);

/// Gives a mesh smooth shading: its normals become those of vertex_normals, and every corner names the normal of its
/// position.
/// exact   as vertex_normals
/// cost    one pass over the corners; allocates the normals
template <Floating T>
constexpr void assign_vertex_normals(mesh<T>& m, normal_weight weight = normal_weight::average) {
  m.normals = vertex_normals(m, weight);
  for (mesh_corner& corner : m.corners) corner.normal = corner.position;
}

}  // namespace IRG_ABI

namespace detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API std::vector<vec<T, 3>> normals_at_positions(const mesh<T>& m, normal_weight weight);

}  // namespace detail::inline IRG_COMPILED_ABI

namespace detail::inline IRG_ABI {

// Unit vectors by the block, in loops that compilers turn into lanes: bit for bit what newell_sum of a triangle's edges
// and try_normalized give one by one, but for the signs of zeros, which sums that begin at 0 do not keep.

/// Vectors of doubles, one coordinate after the other.
struct unit_block {
  static constexpr std::size_t size = 64;
  double u[3][size], v[3][size];
  std::uint64_t is_odd[size];  // not 0 where a vector is too long, too short or no number for this
};

/// Puts u x v in the place of u, for two edges of a triangle in the unit that edges_of takes.
inline void put_crosses(unit_block& b, std::size_t count) noexcept {
  for (std::size_t i = 0; i < count; ++i) {
    double largest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double p = magnitude(b.u[k][i]), q = magnitude(b.v[k][i]);
      largest = largest < p ? p : largest;
      largest = largest < q ? q : largest;
    }
    // normalizing_power_of_two, of what is not odd.
    const std::uint64_t exponent = bits_of(largest) & (std::uint64_t{0x7ff} << 52);
    const double unit = from_bits((std::uint64_t{2046} << 52) - exponent);
    const double ux = b.u[0][i] * unit, uy = b.u[1][i] * unit, uz = b.u[2][i] * unit;
    const double vx = b.v[0][i] * unit, vy = b.v[1][i] * unit, vz = b.v[2][i] * unit;
    const double x = product(uy, vz) - product(uz, vy), y = product(uz, vx) - product(ux, vz),
                 z = product(ux, vy) - product(uy, vx);
    b.u[0][i] = x;
    b.u[1][i] = y;
    b.u[2][i] = z;
    const double none = (x - x) + (y - y) + (z - z);  // NaN where one is
    b.is_odd[i] = (largest >= 0x1p-900 ? 0u : 1u) | (largest <= 0x1p900 ? 0u : 1u) | (none == 0 ? 0u : 1u);
  }
}

/// Makes u of length 1, as put_direction, but for odd ones.
inline void put_units(unit_block& b, std::size_t count) noexcept {
  for (std::size_t i = 0; i < count; ++i) {
    const double square = sum_of_squares(b.u[0][i], b.u[1][i], b.u[2][i]);
    b.is_odd[i] |= (square >= 0x1p-800 ? 0u : 1u) | (square <= 0x1p1000 ? 0u : 1u);
    b.v[0][i] = square;
  }
  for (std::size_t i = 0; i < count; ++i) b.v[2][i] = square_root_instruction(b.v[0][i]);
  for (std::size_t i = 0; i < count; ++i) {
    const double length =
        hypot_from_root(b.v[0][i], b.v[2][i], magnitude(b.u[0][i]), magnitude(b.u[1][i]), magnitude(b.u[2][i]));
    for (std::size_t k = 0; k < 3; ++k) b.u[k][i] = b.u[k][i] / length;
  }
}

/// Whether this is run time.
constexpr bool takes_blocks() noexcept { return !std::is_constant_evaluated(); }

/// Calls add(face, k, unit) for the corners of the next faces, as many triangles as a block has room for, and
/// other(face) for faces that are something else; gives the first face that is left.
template <class M, class Add, class Other>
std::size_t for_block_of_triangles(const M& m, std::size_t face, unit_block& b, const Add& add, const Other& other) {
  const std::size_t faces = mesh_traits<M>::face_count(m);
  std::size_t count = 0;
  for (; count < b.size && face + count < faces && mesh_traits<M>::face_size(m, face + count) == 3; ++count) {
    const auto at = [&](std::size_t k) -> decltype(auto) {
      return mesh_traits<M>::position(m, mesh_traits<M>::face_vertex(m, face + count, k));
    };
    const auto &p = at(0), &q = at(1), &r = at(2);
    for (int i = 0; i < 3; ++i) {
      b.u[i][count] = widened(coordinate(q, i)) - widened(coordinate(p, i));
      b.v[i][count] = widened(coordinate(r, i)) - widened(coordinate(p, i));
    }
  }
  put_crosses(b, count);
  put_units(b, count);
  for (std::size_t i = 0; i < count; ++i)
    if (b.is_odd[i] != 0)
      other(face + i);
    else
      for (std::size_t k = 0; k < 3; ++k) add(face + i, k, vec<double, 3>{b.u[0][i], b.u[1][i], b.u[2][i]});
  face += count;
  if (count < b.size && face < faces) other(face++);
  return face;
}

/// normalized, one after the other.
template <class V>
constexpr void normalize_all(std::vector<V>& all) {
  std::size_t i = 0;
  if constexpr (std::is_same_v<scalar_of<V>, double>) {
    unit_block b;
    for (; takes_blocks() && i + b.size <= all.size(); i += b.size) {
      for (std::size_t j = 0; j < b.size; ++j) {
        for (int k = 0; k < 3; ++k) b.u[k][j] = coordinate(all[i + j], k);
        b.is_odd[j] = 0;
      }
      put_units(b, b.size);
      for (std::size_t j = 0; j < b.size; ++j)
        all[i + j] =
            b.is_odd[j] != 0 ? normalized(all[i + j]) : generate_coordinates<V>([&](int k) { return b.u[k][j]; });
    }
  }
  for (; i < all.size(); ++i) all[i] = normalized(all[i]);
}

/// The interior angle of a polygon at vertex k, up to two pi where it is not convex.
template <class Position>
constexpr double corner_angle(const polygon_edges<Position>& edge, std::size_t k,
                              const vec<double, 3>& normal) noexcept {
  const vec<double, 3> next = edge(k, k + 1 < edge.count ? k + 1 : 0);
  const vec<double, 3> previous = edge(k, k > 0 ? k - 1 : edge.count - 1);
  const double angle = angle_between(next, previous);
  return dot(cross(next, previous), normal) < 0 ? two_pi<double> - angle : angle;
}

/// A power of two that brings the mesh's finite coordinates below 4: the unit in which areas are compared.
template <class M>
constexpr double area_scale(const M& m) noexcept {
  double largest = 0;
  for (std::size_t v = 0; v < mesh_traits<M>::vertex_count(m); ++v)
    for (int i = 0; i < 3; ++i) {
      const double size = magnitude(widened(coordinate(mesh_traits<M>::position(m, v), i)));
      if (is_finite(size)) largest = maximum(largest, size);
    }
  return largest > 0 ? normalizing_power_of_two(largest) : 1;
}

/// Calls f(k, unit, share) for every corner of a face that has a normal: the face's unit normal, and how much it counts
/// for the vertex; areas in units of `scale`.
template <class M, class F>
constexpr void for_weighted_corners(const M& m, std::size_t face, normal_weight weight, double scale, const F& f) {
  const auto edges = edges_of_face(m, face);
  const vec<double, 3> sum = newell_sum(edges);
  const auto unit = try_normalized(sum);
  if (!unit) return;
  double share = 1;
  if (weight == normal_weight::area) {
    const double ratio = scale / edges.before / edges.after;
    share = length(sum) * ratio * ratio;
  }
  for (std::size_t k = 0; k < edges.count; ++k) {
    if (weight == normal_weight::angle) share = corner_angle(edges, k, *unit);
    f(k, *unit, share);
  }
}

template <SpaceMesh M>
constexpr std::vector<mesh_normal<M>> sum_vertex_normals(const M& m, normal_weight weight) {
  using V = mesh_normal<M>;
  std::vector<V> normals(mesh_traits<M>::vertex_count(m), V{});
  const auto add = [&](std::size_t f, std::size_t k, const vec<double, 3>& n) IRG_INLINE_LAMBDA {
    normals[mesh_traits<M>::face_vertex(m, f, k)] +=
        generate_coordinates<V>([&](int i) { return converted<scalar_of<V>>(n[i]); });
  };
  const double scale = weight == normal_weight::area ? area_scale(m) : 1;
  const auto add_face = [&](std::size_t f) {
    for_weighted_corners(m, f, weight, scale, [&](std::size_t k, const vec<double, 3>& unit, double share) {
      add(f, k, generate_coordinates<vec<double, 3>>([&](int i) { return product(unit[i], share); }));
    });
  };
  std::size_t face = 0;
  if (takes_blocks() && weight == normal_weight::average) {
    unit_block block;
    while (face < mesh_traits<M>::face_count(m)) face = for_block_of_triangles(m, face, block, add, add_face);
  }
  for (; face < mesh_traits<M>::face_count(m); ++face) add_face(face);
  normalize_all(normals);
  return normals;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

template <SpaceMesh M>
[[nodiscard]] constexpr std::vector<mesh_normal<M>> vertex_normals(const M& m, normal_weight weight) {
  if constexpr (detail::OwnMesh<M>)
    return detail::normals_at_positions(m, weight);
  else
    return detail::sum_vertex_normals(m, weight);
}

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API std::vector<vec<T, 3>> normals_at_positions(const mesh<T>& m, normal_weight weight) {
  return sum_vertex_normals(m, weight);
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
