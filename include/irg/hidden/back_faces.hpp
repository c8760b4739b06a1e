// SPDX-License-Identifier: MIT
// Back faces: polygons of a closed body that turn their outer side away from the eye, and so can be left out before
// anything is projected. The result must be the side that the eye sees; every form decides it exactly for the numbers
// that it is given, so all agree on planes and normals that are not rounded. Back-face removal alone makes a right
// picture of a single opaque convex body only; of other bodies it leaves hidden faces over, but what it removes is
// certainly invisible.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/core/vocabulary.hpp>
#include <irg/geometry/compare.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/orient3d.hpp>
#include <irg/geometry/polygon_orientation.hpp>
#include <irg/geometry/side_of_polygon.hpp>
#include <irg/mesh/face_normal.hpp>
#include <irg/mesh/mesh.hpp>

namespace irg {

/// What becomes of faces seen from their edge. They cover no area, but their outlines can be drawn.
enum class edge_on_faces { hidden, drawn };

/// Which way the normals of a body point.
enum class normals_point { outward, inward };

namespace detail {

// A face of a mesh as a ring.
template <class M>
struct mesh_face_ring {
  const M* m;
  std::size_t face;

  IRG_INLINE constexpr std::size_t size() const noexcept { return mesh_face_size(*m, face); }
  IRG_INLINE constexpr mesh_point<M> operator[](std::size_t k) const noexcept {
    return mesh_position(*m, mesh_face_vertex(*m, face, k));
  }
};

inline namespace IRG_COMPILED_ABI {

template <Floating T>
IRG_API facing facing_in_mesh(const mesh<T>& m, std::size_t f, const hpoint<T, 3>& eye) noexcept;
template <Floating T>
IRG_API std::vector<std::uint32_t> front_faces_of_mesh(const mesh<T>& m, const hpoint<T, 3>& eye,
                                                       edge_on_faces edge_on);

}  // namespace IRG_COMPILED_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// Whether a face of which the eye sees this side is left out.
[[nodiscard]] IRG_INLINE constexpr bool is_hidden(facing side, edge_on_faces edge_on = edge_on_faces::hidden) noexcept {
  return side == facing::back || (side == facing::edge_on && edge_on == edge_on_faces::hidden);
}

/// The side of a face that an eye sees, by the value of its plane at the eye: positive in front. No angle is needed.
/// shape   the plane's normal points outward; the eye is a point, or homogeneous: weight 0 is the direction towards an
///         infinitely far eye, as in parallel projection
/// exact   for every finite float, double and integer, as side_of
/// source  Mihajlovic 2016, 7.1; the same as the angle's form
template <Plane P, Coordinates Q>
  requires requires(const P& face, const Q& eye) { side_of(face, eye); }
[[nodiscard]] constexpr facing facing_by_plane(const P& face, const Q& eye) noexcept {
  return static_cast<facing>(static_cast<int>(side_of(face, eye)));
}

/// The side of a face that an eye sees, by the angle between the normal and the direction from the face's centre to the
/// eye: below a right angle in front.
/// gives   edge_on when the eye is in the centre or the normal is 0
/// exact   the sign of the cosine, for every finite float, double and integer
/// source  Mihajlovic 2016, 7.1, whose text says that normals point inward; what it describes holds for outward ones
template <Scalar T>
[[nodiscard]] constexpr facing facing_by_angle(const vec<T, 3>& normal, const point<T, 3>& centre,
                                               const point<T, 3>& eye,
                                               normals_point direction = normals_point::outward) noexcept {
  const point<T, 3> tip{normal.x, normal.y, normal.z};
  const int sign = order_along_line(point<T, 3>{}, tip, eye, centre);
  return static_cast<facing>(direction == normals_point::outward ? sign : -sign);
}

/// The side of a face that an eye sees, by the order of its vertices in the picture plane, y up: the sign of the
/// polygon's area. The polygon may be concave.
/// gives   edge_on for collinear vertices and for fewer than three
/// exact   as orientation_of: for every finite float, double and integer
/// source  Mihajlovic 2016, 7.3, with the area in place of its edges
template <PlaneRing R>
[[nodiscard]] constexpr facing facing_by_order(const R& projected,
                                               orientation order = orientation::counter_clockwise) noexcept {
  return static_cast<facing>(static_cast<int>(order) * static_cast<int>(orientation_of(projected)));
}

/// The side of face f of a mesh that an eye sees.
/// shape   vertices counter-clockwise seen from outside; the eye's weight is not negative: 0 for the direction towards
///         an infinitely far eye
/// gives   edge_on for faces without area and for coordinates that are not finite
/// exact   for every finite float and double, by Newell's normal, as side_of_polygon
/// cost    as side_of_polygon
template <SpaceMesh M>
[[nodiscard]] constexpr facing facing_of(const M& m, std::size_t f,
                                         const hpoint<scalar_of<mesh_point<M>>, 3>& eye) noexcept {
  if constexpr (std::same_as<M, mesh<scalar_of<mesh_point<M>>>>)
    return detail::facing_in_mesh(m, f, eye);
  else
    return static_cast<facing>(static_cast<int>(side_of_polygon(detail::mesh_face_ring<M>{&m, f}, eye)));
}

/// The faces of a mesh that are left when back faces are removed, in their order.
/// shape   as facing_of
/// cost    linear; allocates the result
template <SpaceMesh M>
[[nodiscard]] constexpr std::vector<std::uint32_t> front_faces(const M& m,
                                                               const hpoint<scalar_of<mesh_point<M>>, 3>& eye,
                                                               edge_on_faces edge_on = edge_on_faces::hidden) {
  if constexpr (std::same_as<M, mesh<scalar_of<mesh_point<M>>>>) {
    return detail::front_faces_of_mesh(m, eye, edge_on);
  } else {
    std::vector<std::uint32_t> left;
    for (std::size_t f = 0; f < mesh_face_count(m); ++f)
      if (!is_hidden(facing_of(m, f, eye), edge_on)) left.push_back(static_cast<std::uint32_t>(f));
    return left;
  }
}

IRG_RENAMED(side_by_plane, facing_by_plane)
IRG_RENAMED(side_by_angle, facing_by_angle)
IRG_RENAMED(side_by_order, facing_by_order)
IRG_RENAMED(side_of_face, facing_of)

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API facing facing_in_mesh(const mesh<T>& m, std::size_t f, const hpoint<T, 3>& eye) noexcept {
  return static_cast<facing>(static_cast<int>(side_of_polygon(mesh_face_ring<mesh<T>>{&m, f}, eye)));
}

template <Floating T>
IRG_API std::vector<std::uint32_t> front_faces_of_mesh(const mesh<T>& m, const hpoint<T, 3>& eye,
                                                       edge_on_faces edge_on) {
  std::vector<std::uint32_t> left;
  for (std::size_t f = 0; f < m.face_count(); ++f)
    if (!is_hidden(facing_in_mesh(m, f, eye), edge_on)) left.push_back(static_cast<std::uint32_t>(f));
  return left;
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
