// SPDX-License-Identifier: MIT
// Whether a mesh is closed, and whether it is the surface of a convex body: of such a body nothing but back faces is
// hidden by itself. A closed surface that bends one way at every edge may still wind round more than once; so the rays
// from a point within are counted, too.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include <irg/geometry/box.hpp>
#include <irg/geometry/orient3d.hpp>
#include <irg/geometry/point_on_triangle.hpp>
#include <irg/math/vec.hpp>
#include <irg/mesh/face_normal.hpp>
#include <irg/mesh/mesh.hpp>

namespace irg::inline IRG_ABI {

/// Whether a mesh is closed: along each side of a face one other side runs the other way.
/// gives   true for a mesh without faces; false where a side joins a position to itself or more than two faces meet.
///         Positions are told apart by their numbers: seams of equal positions are open
/// exact   no arithmetic
/// cost    sorts the sides; allocates them
template <Mesh M>
[[nodiscard]] constexpr bool is_closed(const M& m);

/// Whether a mesh is the whole surface of one convex body, its faces counter-clockwise seen from outside. Its front
/// faces then hide none of each other.
/// needs   as validate: faces that name positions of the mesh
/// gives   false for faces that are not plane, even in their last bit, and for faces without area, whose triangles may
///         bound a convex body all the same; for bodies turned inside out, and for positions that are not finite. Faces
///         in one plane may meet, and corners may lie on a line
/// exact   for the numbers as they are
/// cost    sorts the sides, then some eight signs of orient3d for each triangle; allocates sides and corners
/// source  Mehlhorn et al. 1999 (convexity by edges and one ray)
template <SpaceMesh M>
[[nodiscard]] constexpr bool is_convex_body(const M& m);

}  // namespace irg::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API bool is_closed_mesh(const mesh<T>& m);
template <Floating T>
IRG_API bool is_convex_mesh(const mesh<T>& m);

}  // namespace irg::detail::inline IRG_COMPILED_ABI

namespace irg::detail::inline IRG_ABI {

// The side of a face from one position to the next.
struct mesh_side {
  std::size_t from, to, face;
};

// All sides of a mesh, those between the same two positions beside each other, the one that ascends first.
template <Mesh M>
constexpr std::vector<mesh_side> sorted_sides(const M& m) {
  std::vector<mesh_side> sides;
  for (std::size_t f = 0; f < mesh_face_count(m); ++f)
    for (std::size_t k = 0, n = mesh_face_size(m, f); k < n; ++k)
      sides.push_back({mesh_face_vertex(m, f, k), mesh_face_vertex(m, f, k + 1 < n ? k + 1 : 0), f});
  std::sort(sides.begin(), sides.end(), [](const mesh_side& a, const mesh_side& b) {
    const std::size_t low_a = minimum(a.from, a.to), low_b = minimum(b.from, b.to);
    if (low_a != low_b) return low_a < low_b;
    const std::size_t high_a = maximum(a.from, a.to), high_b = maximum(b.from, b.to);
    return high_a != high_b ? high_a < high_b : a.from < b.from;
  });
  return sides;
}

// Whether each side has one other that runs back along it, in sides as above.
constexpr bool are_paired(const std::vector<mesh_side>& sides) noexcept {
  if (sides.size() % 2 != 0) return false;
  const auto joins = [](const mesh_side& a, const mesh_side& b) { return a.from == b.to && a.to == b.from; };
  for (std::size_t i = 0; i < sides.size(); i += 2) {
    const mesh_side &there = sides[i], &back = sides[i + 1];
    if (there.from == there.to || !joins(there, back)) return false;
    if (i > 0 && joins(sides[i - 1], there)) return false;
  }
  return true;
}

// Four corners that span a body, the first three of its first face: every face has at least one of them behind its
// plane, and none in front. So all faces look away from the middle of the four, which no rounding needs to find: a
// determinant with the middle is the mean of those with the four. What is left to see is that no face bends inward at a
// side, and that the surface winds round the middle once.
template <SpaceMesh M>
class convexity_check {
  using P = assignable<mesh_point<M>>;

public:
  constexpr explicit convexity_check(const M& m) : m_(m) {}

  constexpr bool operator()() {
    if (!is_finite_mesh() || is_surely_bent()) return false;
    const std::vector<mesh_side> sides = sorted_sides(m_);
    if (sides.empty() || !are_paired(sides) || !find_spanning_corners()) return false;
    for (std::size_t f = 0; f < mesh_face_count(m_); ++f)
      if (!is_plane_and_outward(f)) return false;
    for (std::size_t i = 0; i < sides.size(); i += 2)
      if (!bends_outward(sides[i].face, sides[i + 1].face)) return false;
    return faces_on_first_ray() == 1;
  }

private:
  constexpr bool is_finite_mesh() const {
    for (std::size_t v = 0; v < mesh_vertex_count(m_); ++v)
      for (int i = 0; i < 3; ++i)
        if (!is_finite(coordinate(mesh_position(m_, v), i))) return false;
    return true;
  }

  // A look at a few faces and corners before anything is sorted: whether one of these lies in front of one of those.
  constexpr bool is_surely_bent() const {
    constexpr std::size_t few = 4, some = 32;
    const std::size_t n = mesh_face_count(m_);
    for (std::size_t i = 0; i < minimum(few, n); ++i) {
      const std::size_t f = i * n / minimum(few, n);
      for (std::size_t j = 0; j < minimum(some, n); ++j) {
        const std::size_t g = j * n / minimum(some, n);
        if (mesh_face_size(m_, f) >= 3 && mesh_face_size(m_, g) >= 1 &&
            orient3d(at(f, 0), at(f, 1), at(f, 2), at(g, 0)) > 0)
          return true;
      }
    }
    return false;
  }

  constexpr P at(std::size_t f, std::size_t k) const {
    return as_assignable(mesh_position(m_, mesh_face_vertex(m_, f, k)));
  }

  // Positive where p is in front of the plane of a face.
  constexpr int side(std::size_t f, const P& p) const {
    const std::size_t k = apex_[f];
    return orient3d(at(f, 0), at(f, k - 1), at(f, k), p);
  }
  // Positive where a, b and c run counter-clockwise seen from outside, the point being behind them.
  static constexpr int turn(const P& a, const P& b, const P& c, const P& behind) { return -orient3d(a, b, c, behind); }

  // Of each face, a corner that is not on a line with the first and the one before it.
  constexpr bool find_spanning_corners() {
    for (std::size_t f = 0; f < mesh_face_count(m_); ++f) {
      std::size_t k = 2;
      while (k < mesh_face_size(m_, f) && are_collinear(at(f, 0), at(f, k - 1), at(f, k))) ++k;
      if (k >= mesh_face_size(m_, f)) return false;
      apex_.push_back(k);
    }
    spanning_ = {at(0, 0), at(0, apex_[0] - 1), at(0, apex_[0]), P{}};
    for (std::size_t f = 1; f < mesh_face_count(m_); ++f)
      for (std::size_t k = 0; k < mesh_face_size(m_, f); ++k)
        if (const int s = side(0, at(f, k)); s != 0) {
          spanning_[3] = at(f, k);
          return s < 0;
        }
    return false;
  }

  constexpr bool is_plane_and_outward(std::size_t f) const {
    const P* behind = nullptr;
    for (const P& p : spanning_) {
      const int s = side(f, p);
      if (s > 0) return false;
      if (s < 0) behind = &p;
    }
    const std::size_t n = mesh_face_size(m_, f);
    for (std::size_t k = 0; k < n; ++k) {
      const P before = at(f, k == 0 ? n - 1 : k - 1), here = at(f, k), after = at(f, k + 1 < n ? k + 1 : 0);
      if (side(f, here) != 0 || turn(before, here, after, *behind) < 0 || turn(at(f, 0), here, after, *behind) < 0)
        return false;
    }
    return true;
  }

  // Of two plane faces with a side in common: when one lies behind the plane of the other, so does the other.
  constexpr bool bends_outward(std::size_t f, std::size_t g) const {
    if (mesh_face_size(m_, f) < mesh_face_size(m_, g)) std::swap(f, g);
    for (std::size_t k = 0; k < mesh_face_size(m_, g); ++k)
      if (side(f, at(g, k)) > 0) return false;
    return true;
  }

  // How many triangles, fanned from the faces' first corners, the ray from the fourth spanning corner to the first
  // meets, moved a little towards the second and infinitely less towards the third: then it meets no side. It begins
  // behind every face that does not hold its start, so that it leaves the surface as often as this winds round.
  constexpr std::size_t faces_on_first_ray() const {
    const auto is_left_of_ray = [&](const P& a, const P& b) {
      for (std::size_t i = 0; i < 3; ++i)
        if (const int sign = turn(a, b, spanning_[i], spanning_[3]); sign != 0) return sign > 0;
      return false;
    };
    std::size_t met = 0;
    for (std::size_t f = 0; f < mesh_face_count(m_); ++f)
      for (std::size_t k = 2; k < mesh_face_size(m_, f); ++k) {
        const P a = at(f, 0), b = at(f, k - 1), c = at(f, k);
        if (is_left_of_ray(a, b) && is_left_of_ray(b, c) && is_left_of_ray(c, a)) ++met;
      }
    return met;
  }

  const M& m_;
  std::vector<std::size_t> apex_{};
  std::array<P, 4> spanning_{};
};

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <Mesh M>
[[nodiscard]] constexpr bool is_closed(const M& m) {
  if constexpr (detail::OwnMesh<M>)
    return detail::is_closed_mesh(m);
  else
    return detail::are_paired(detail::sorted_sides(m));
}

template <SpaceMesh M>
[[nodiscard]] constexpr bool is_convex_body(const M& m) {
  if constexpr (detail::OwnMesh<M>)
    return detail::is_convex_mesh(m);
  else
    return detail::convexity_check<M>(m)();
}

}  // namespace irg::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API bool is_closed_mesh(const mesh<T>& m) {
  return are_paired(sorted_sides(m));
}
template <Floating T>
IRG_API bool is_convex_mesh(const mesh<T>& m) {
  return convexity_check<mesh<T>>(m)();
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
