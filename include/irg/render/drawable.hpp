// SPDX-License-Identifier: MIT
// A mesh made ready for drawing: faces cut into triangles, and one vertex for each position and normal that meet.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <irg/core/vocabulary.hpp>
#include <irg/mesh/mesh.hpp>
#if IRG_BODIES
#include <irg/mesh/normals.hpp>
#include <irg/mesh/triangulate.hpp>
#include <irg/render/draw_triangles.hpp>
#endif

namespace irg {

/// Triangles over shared vertices, in world coordinates.
/// shape   positions and normals are parallel; triangle i comes from face face_of[i] of the mesh
template <Floating T>
struct drawable {
  std::vector<point<T, 3>> positions;
  std::vector<vec<T, 3>> normals;  // zero where the mesh gives no direction
  std::vector<triangle_indices> triangles;
  std::vector<std::uint32_t> face_of;
  bool operator==(const drawable&) const = default;
};

inline namespace IRG_COMPILED_ABI {

/// The triangles of a mesh. Meshes without normals get the usual vertex normals (the average of the faces around).
/// needs   a valid mesh (mesh/validate.hpp)
/// cost    linear; allocates the result
template <Floating T>
[[nodiscard]] IRG_API drawable<T> make_drawable(mesh<T> m);

}  // namespace IRG_COMPILED_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg {
namespace detail::inline IRG_ABI {

// Numbers the pairs of position and normal that occur in the corners. Pairs of one position form a chain, of which the
// newest are looked through: where a thousand normals meet, a pair may be numbered twice, which changes no picture.
template <class T>
class corner_vertices {
public:
  constexpr explicit corner_vertices(std::size_t positions) : first_(positions, no_index) {}

  constexpr std::uint32_t operator()(const mesh<T>& m, const mesh_corner& c, drawable<T>& out) {
    int looks = 64;
    for (std::uint32_t v = first_[c.position]; v != no_index && looks > 0; v = next_[v], --looks)
      if (normal_[v] == c.normal) return v;
    const auto v = static_cast<std::uint32_t>(out.positions.size());
    out.positions.push_back(m.positions[c.position]);
    out.normals.push_back(c.normal == no_index ? vec<T, 3>{} : m.normals[c.normal]);
    normal_.push_back(c.normal);
    next_.push_back(first_[c.position]);
    first_[c.position] = v;
    return v;
  }

private:
  std::vector<std::uint32_t> first_, next_, normal_;
};

}  // namespace detail::inline IRG_ABI

inline namespace IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API drawable<T> make_drawable(mesh<T> m) {
  bool has_normals = !m.normals.empty();
  for (const mesh_corner& c : m.corners) has_normals = has_normals && c.normal != no_index;
  if (!has_normals) assign_vertex_normals(m, normal_weight::average);
  drawable<T> out;
  out.positions.reserve(m.positions.size());
  out.normals.reserve(m.positions.size());
  out.triangles.reserve(m.face_count());
  out.face_of.reserve(m.face_count());
  for (std::size_t f = 0; f < m.face_count(); ++f)  // triangulate keeps the faces' order
    out.face_of.insert(out.face_of.end(), m.face_size(f) - 2, static_cast<std::uint32_t>(f));
  m = triangulated(std::move(m));
  detail::corner_vertices<T> vertex_of(m.positions.size());
  for (std::size_t t = 0; t < m.face_count(); ++t) {
    const std::uint32_t a = vertex_of(m, m.corner(t, 0), out), b = vertex_of(m, m.corner(t, 1), out),
                        c = vertex_of(m, m.corner(t, 2), out);
    out.triangles.push_back({{a, b, c}});
  }
  return out;
}

}  // namespace IRG_COMPILED_ABI
}  // namespace irg
#endif
