// SPDX-License-Identifier: MIT
// triangulate: a mesh of polygons becomes a mesh of triangles on the same vertices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <irg/geometry/flat_ring.hpp>
#include <irg/geometry/triangulate_ear_clipping.hpp>
#include <irg/mesh/mesh.hpp>

namespace irg {

struct triangulate_options {
  /// How many corner-in-triangle tests a face may take, times its corners, before the rest of it becomes a fan. Bounds
  /// the time that hostile faces can take; ordinary faces of 10^5 corners need a few dozen.
  std::size_t tests_per_corner = 1024;
  bool operator==(const triangulate_options&) const = default;
};

inline namespace IRG_ABI {

/// The same surface made of triangles.
/// shape   a face of n corners gives n - 2 triangles of its corners in its own direction, in place of it; no vertex is
///         added, so that neighbours still share whole edges. parts count triangles then
/// needs   a mesh in which validate() finds no defect, and at most 1,431,655,765 triangles in it
/// gives   for a simple planar polygon, convex or not: triangles that cover it exactly once, none of them without area.
///         Straight corners are allowed, and so are holes that bridges join to the ring. For others the signed area is
///         kept, in every projection: folds go as triangles without area, what crosses itself is cut as far as ears go
///         and finished as a fan, faces without area are fans
/// exact   decisions on the corners' own coordinates, without the one along which the Newell normal is longest, are
///         exact for every finite float and double; which coordinate that is, is decided in rounded arithmetic
/// cost    linear for strictly convex faces, else O(n log n) and up to tests_per_corner * n tests
/// source  Meisters 1975
template <Scalar T>
[[nodiscard]] constexpr mesh<T> triangulated(mesh<T> m, triangulate_options options = {});

}  // namespace IRG_ABI

namespace detail::inline IRG_COMPILED_ABI {

// Cuts all faces of a mesh.
template <Floating T>
IRG_API void cut_mesh(mesh<T>& m, const triangulate_options& options);

}  // namespace detail::inline IRG_COMPILED_ABI

namespace detail::inline IRG_ABI {

// The triangles of one face of a mesh, by corner numbers: of the face without the coordinate along which it looks
// largest.

/// The positions of a face's corners, as a ring.
template <Scalar T>
struct face_ring {
  const mesh<T>* m;
  std::size_t face;
  constexpr std::size_t size() const noexcept { return m->face_size(face); }
  constexpr point<T, 3> operator[](std::size_t i) const noexcept { return m->positions[m->corner(face, i).position]; }
};

/// Works on one face after another. `sink(i, j, k)` takes each triangle, as numbers of corners in the face's own
/// direction.
template <Scalar T>
class face_clipper {
public:
  constexpr explicit face_clipper(std::size_t tests_per_corner) : options_{tests_per_corner} {}

  template <class Sink>
  constexpr void operator()(const mesh<T>& m, std::size_t face, Sink&& sink) {
    const face_ring<T> ring{&m, face};
    const auto n = static_cast<std::uint32_t>(ring.size());
    if (n == 3) return sink(0u, 1u, 2u);
    // A face whose area along the first axis is lost in rounding is looked at along the others.
    const int axis = dropped_axis(ring).value_or(2);
    if (clip(ring, axis, sink) || clip(ring, 0, sink) || clip(ring, 1, sink) || clip(ring, 2, sink)) return;
    for (std::uint32_t i = 2; i < n; ++i) sink(0u, i - 1, i);
  }

private:
  ear_clipping_options options_;
  ear_clipping_memory<T> memory_;

  template <class Sink>
  constexpr bool clip(const face_ring<T>& ring, int axis, Sink&& sink) {
    // A position that is NaN or infinite leaves nothing to decide: such faces are cut into a fan.
    const flat_ring<face_ring<T>> flat(ring, axis);
    return is_finite(flat) && triangulate_ear_clipping(flat, sink, memory_, options_);
  }
};

template <Scalar T>
constexpr void cut_faces(mesh<T>& m, const triangulate_options& options) {
  const std::size_t triangles = m.corners.size() - 2 * m.face_count();
  IRG_EXPECTS(triangles <= 0xffffffffu / 3);
  if (triangles == m.face_count()) return;
  std::vector<mesh_corner> corners;
  corners.reserve(3 * triangles);
  std::vector<std::uint32_t> face_starts;
  face_starts.reserve(triangles + 1);
  face_starts.push_back(0);

  face_clipper<T> clip(options.tests_per_corner);
  std::size_t part = 0, face_end = m.parts.empty() ? 0 : m.parts[0].face_count;
  const auto finish_parts = [&](std::size_t faces_done) {
    for (; part < m.parts.size() && face_end == faces_done; ++part) {
      const std::size_t first = part == 0 ? 0 : m.parts[part - 1].first_face + m.parts[part - 1].face_count;
      m.parts[part].first_face = first;
      m.parts[part].face_count = face_starts.size() - 1 - first;
      if (part + 1 < m.parts.size()) face_end += m.parts[part + 1].face_count;
    }
  };
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    finish_parts(f);
    clip(m, f, [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
      for (const std::uint32_t corner : {i, j, k}) corners.push_back(m.corner(f, corner));
      face_starts.push_back(static_cast<std::uint32_t>(corners.size()));
    });
  }
  finish_parts(m.face_count());
  m.corners = std::move(corners);
  m.face_starts = std::move(face_starts);
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

template <Scalar T>
[[nodiscard]] constexpr mesh<T> triangulated(mesh<T> m, triangulate_options options) {
  if constexpr (Floating<T>)
    detail::cut_mesh(m, options);
  else
    detail::cut_faces(m, options);
  return m;
}

IRG_RENAMED(triangulate, triangulated)

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API void cut_mesh(mesh<T>& m, const triangulate_options& options) {
  cut_faces(m, options);
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
