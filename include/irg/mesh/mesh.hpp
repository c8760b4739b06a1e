// SPDX-License-Identifier: MIT
// mesh<T>: an indexed face set. Faces are polygons of three or more corners; each corner names a position and, where
// the mesh has them, a normal and a texture coordinate of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/core/vocabulary.hpp>
#include <irg/core/mesh_concept.hpp>
#include <irg/math/vec.hpp>
#include <irg/mesh/part_name.hpp>

namespace irg {

/// One corner of a face: indices into positions, normals and texcoords. Ordered by these, in this order.
struct mesh_corner {
  [[deprecated("irg: no_index")]] static constexpr std::uint32_t none = no_index;
  std::uint32_t position = 0;
  std::uint32_t normal = no_index;
  std::uint32_t texcoord = no_index;
  bool operator==(const mesh_corner&) const = default;
  IRG_INLINE constexpr bool operator<(const mesh_corner& o) const noexcept {
    if (position != o.position) return position < o.position;
    return normal != o.normal ? normal < o.normal : texcoord < o.texcoord;
  }
};

/// A named run of faces: an object, a group or a stretch of one material.
struct mesh_part {
  part_name object, group, material;
  std::size_t first_face = 0, face_count = 0;
  bool operator==(const mesh_part&) const = default;
};

/// Polygons that share their positions.
/// shape   face f has the corners face_starts[f] to face_starts[f + 1] - 1, counter-clockwise seen from outside;
///         face_starts has one entry more than there are faces, its first is 0; parts cover the faces in order
template <Scalar T>
struct mesh {
  std::vector<point<T, 3>> positions;
  std::vector<vec<T, 3>> normals;
  std::vector<vec<T, 2>> texcoords;
  std::vector<mesh_corner> corners;
  std::vector<std::uint32_t> face_starts = {0};
  std::vector<mesh_part> parts;

  [[nodiscard]] IRG_INLINE constexpr std::size_t face_count() const noexcept {
    return face_starts.empty() ? 0 : face_starts.size() - 1;
  }
  [[nodiscard]] IRG_INLINE constexpr std::size_t face_size(std::size_t f) const noexcept {
    return face_starts[f + 1] - face_starts[f];
  }
  [[nodiscard]] IRG_INLINE constexpr const mesh_corner& corner(std::size_t f, std::size_t k) const noexcept {
    return corners[face_starts[f] + k];
  }

  bool operator==(const mesh&) const = default;
};

template <class T>
struct mesh_traits<mesh<T>> {
  using point = irg::point<T, 3>;
  IRG_INLINE static constexpr std::size_t vertex_count(const mesh<T>& m) noexcept { return m.positions.size(); }
  IRG_INLINE static constexpr const point& position(const mesh<T>& m, std::size_t v) noexcept { return m.positions[v]; }
  IRG_INLINE static constexpr std::size_t face_count(const mesh<T>& m) noexcept { return m.face_count(); }
  IRG_INLINE static constexpr std::size_t face_size(const mesh<T>& m, std::size_t f) noexcept { return m.face_size(f); }
  IRG_INLINE static constexpr std::size_t face_vertex(const mesh<T>& m, std::size_t f, std::size_t k) noexcept {
    return m.corner(f, k).position;
  }
};

namespace detail {

template <class M>
inline constexpr bool is_own_mesh = false;
template <Floating T>
inline constexpr bool is_own_mesh<mesh<T>> = true;

/// irg's own mesh of floats or doubles, which irg::compiled takes.
template <class M>
concept OwnMesh = is_own_mesh<M>;

}  // namespace detail

inline namespace IRG_ABI {

/// Appends a face whose corners name positions only.
/// needs   three or more indices, each < positions.size()
template <class T, class Indices>
constexpr void add_face(mesh<T>& m, const Indices& positions) {
  for (const auto i : positions) m.corners.push_back({static_cast<std::uint32_t>(i), no_index, no_index});
  m.face_starts.push_back(static_cast<std::uint32_t>(m.corners.size()));
}
/// The same of indices in braces: add_face(m, {0, 1, 2}).
template <class T, std::integral Index, std::size_t N>
constexpr void add_face(mesh<T>& m, const Index (&positions)[N]) {
  add_face<T, Index[N]>(m, positions);
}

}  // namespace IRG_ABI
}  // namespace irg

/// The hash of a corner, for std::unordered_map and its like.
template <>
struct std::hash<irg::mesh_corner> {
  IRG_INLINE constexpr std::size_t operator()(const irg::mesh_corner& c) const noexcept {
    const std::uint64_t position = c.position, texcoord = c.texcoord;
    const std::uint64_t h = (position << 32 | c.normal) * 0x9e3779b97f4a7c15u + texcoord * 0xc2b2ae3d27d4eb4fu;
    return static_cast<std::size_t>(h ^ h >> 32);
  }
};
