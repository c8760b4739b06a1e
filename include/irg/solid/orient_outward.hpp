// SPDX-License-Identifier: MIT
// Shells that look the wrong way are turned: outer ones come to look outward, cavities into themselves.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <irg/core/vocabulary.hpp>
#include <irg/mesh/mesh.hpp>
#if IRG_BODIES
#include <irg/geometry/exact_point.hpp>
#include <irg/mesh/convex_body.hpp>
#include <irg/mesh/from_half_edges.hpp>
#include <irg/mesh/merge_vertices.hpp>
#include <irg/mesh/orient_faces.hpp>
#include <irg/mesh/to_half_edges.hpp>
#include <irg/mesh/to_mesh.hpp>
#include <irg/solid/detail/body_triangles.hpp>
#include <irg/solid/detail/box_pairs.hpp>
#include <irg/solid/detail/exact_crossings.hpp>
#include <irg/solid/measures.hpp>
#include <irg/solid/solid_locator.hpp>
#endif

namespace irg {

/// What orient_outward made of a mesh.
enum class [[nodiscard]] outward_status {
  ok,
  no_surface,  ///< faces cannot be made to run alike, or do not make a surface: to_half_edges() tells why
  open,  ///< an edge has one face: there is no inside. Faces run alike
  done [[deprecated("irg: done is now ok")]] = ok
};

inline namespace IRG_COMPILED_ABI {

/// Turns the faces of a closed surface so that they are counter-clockwise seen from outside, whichever way each of them
/// ran before: those of shells within others so that what lies between is inside.
/// shape   faces keep their numbers; normals of corners stay
/// needs   a mesh in which validate() finds no defect, with finite positions; shells that do not cut each other, but
///         may touch
/// gives   for `no_surface` the mesh as it was
/// exact   always, for the triangles that triangulated() makes of the faces
/// cost    O(n log n), and for each shell a pass over the others: exact volumes and one ray
template <Floating T>
IRG_API outward_status orient_outward(mesh<T>& m);

}  // namespace IRG_COMPILED_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// Each shell by itself, with its own positions alone: a vertex belongs to one.
template <Floating T>
constexpr std::vector<mesh<T>> meshes_of_shells(const mesh<T>& m, const half_edge_shells& shells) {
  std::vector<mesh<T>> each(shells.count, mesh<T>{});
  std::vector<std::uint32_t> number(m.positions.size(), no_index), corners;
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    mesh<T>& shell = each[shells.of_face[f]];
    corners.clear();
    for (std::size_t k = 0; k < m.face_size(f); ++k) {
      const std::uint32_t v = m.corner(f, k).position;
      if (number[v] == no_index) {
        number[v] = static_cast<std::uint32_t>(shell.positions.size());
        shell.positions.push_back(m.positions[v]);
      }
      corners.push_back(number[v]);
    }
    add_face(shell, corners);
  }
  return each;
}

template <Floating T>
constexpr space_box box_round(const mesh<T>& m) noexcept {
  space_box box = no_box();
  for (const point<T, 3>& p : m.positions) box.add(point<double, 3>{widened(p.x), widened(p.y), widened(p.z)});
  return box;
}
constexpr bool is_within(const space_box& a, const space_box& b) noexcept {
  for (int i = 0; i < 3; ++i)
    if (a.low[i] < b.low[i] || b.high[i] < a.high[i]) return false;
  return true;
}

enum class volume_part { whole, turned };

// Adds six times the volume that a closed surface encloses, as it is or as if it were turned inside out.
template <Floating T>
constexpr void add_six_volumes(exact_accumulator<3>& sum, const mesh<T>& surface, volume_part part) {
  each_solid_triangle(triangulated(surface), [&](const auto& a, const auto& b, const auto& c) {
    if (part == volume_part::whole)
      add_volume(sum, a, b, c);
    else
      add_volume(sum, a, c, b);
  });
}

// -1 where a closed surface is inside out: also where its volume is too small for a number.
template <Floating T>
constexpr int sign_of_volume(const mesh<T>& surface) {
  exact_accumulator<3> sum;
  add_six_volumes(sum, surface, volume_part::whole);
  return sum.sign();
}

// Whether a closed shell encloses less than another, whichever way the faces of either run.
template <Floating T>
constexpr bool encloses_less(const mesh<T>& shell, const mesh<T>& other) {
  exact_accumulator<3> rest;
  add_six_volumes(rest, other, sign_of_volume(other) < 0 ? volume_part::turned : volume_part::whole);
  add_six_volumes(rest, shell, sign_of_volume(shell) < 0 ? volume_part::whole : volume_part::turned);
  return rest.sign() > 0;
}

// Where a point without rounding lies against a closed surface.
template <std::same_as<double> T>
constexpr location place_of_exact(const exact_point& p, const std::vector<point<T, 3>>& positions,
                                  const std::vector<triangle_indices>& surface) {
  const near_point<exact_point> at{p};
  upward_crossings count;
  for (const triangle_indices& t : surface) {
    if (is_off_ray_upward(box_of_triangle(positions, t), at.rounded, at.slack())) continue;
    const seen_triangle s = see_triangle(positions, t, 0);
    bool is_on = s.turn != 0 && side_of_plane(*s.p[0], *s.p[1], *s.p[2], p) == side::on;
    for (int k = 0; k < 3 && is_on; ++k)
      is_on = irg::orientation_along(s.axis, exact_point(*s.p[k]), exact_point(*s.p[(k + 1) % 3]), p) * s.turn >= 0;
    if (is_on) return location::boundary;
    count_exact_crossing(positions, t, at, count);
  }
  return count.winding != 0 ? location::inside : location::outside;
}

// As the first middle of a triangle does that is not on the other shell.
template <class M>
constexpr bool middle_lies_within(const M& shell, const M& other) {
  const auto surface = list_triangles(other);
  for (const auto& t : list_triangles(shell)) {
    const auto at = [&](std::size_t k) { return exact_point(shell.positions[t.v[k]]); };
    const location where = place_of_exact(exact_point::mean_of(at(0), at(1), at(2)), other.positions, surface);
    if (where != location::boundary) return where == location::inside;
  }
  return false;
}

// Whether a closed shell lies within another that it does not cut: as the first corner does that is not on the other,
// or, where all are, the first middle of a triangle.
template <Floating T>
constexpr bool lies_within(const mesh<T>& shell, const mesh<T>& other) {
  const auto corner = [&](std::size_t i) { return shell.positions[shell.corners[i].position]; };
  if (const location where = point_in_solid(other, corner(0)); where != location::boundary)
    return where == location::inside;
  const solid_locator<T> locate(other);
  for (std::size_t i = 1; i < shell.corners.size(); ++i)
    if (const location where = locate(corner(i)); where != location::boundary) return where == location::inside;
  if (!encloses_less(shell, other)) return false;
  return middle_lies_within(to_mesh<double>(shell), to_mesh<double>(other));
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API outward_status orient_outward(mesh<T>& m) {
  mesh<T> turned = m;
  if (orient_faces(turned) != orient_status::ok) return outward_status::no_surface;
  const auto half_edges = to_half_edges(turned);
  if (half_edges.status != half_edge_status::ok) return outward_status::no_surface;
  if (counts_of(half_edges.value).borders > 0) {
    m = std::move(turned);
    return outward_status::open;
  }
  const half_edge_shells shells = shells_of(half_edges.value);
  const std::vector<mesh<T>> each = detail::meshes_of_shells(turned, shells);
  std::vector<detail::space_box> boxes;
  boxes.reserve(each.size());
  for (const mesh<T>& shell : each) boxes.push_back(detail::box_round(shell));
  std::vector<unsigned char> turn(shells.count, 0);
  for (std::uint32_t s = 0; s < shells.count; ++s) {
    bool is_cavity = false;
    for (std::uint32_t t = 0; t < shells.count; ++t)
      if (t != s && detail::is_within(boxes[s], boxes[t]) && detail::lies_within(each[s], each[t]))
        is_cavity = !is_cavity;
    turn[s] = (detail::sign_of_volume(each[s]) < 0) != is_cavity ? 1 : 0;
  }
  for (std::size_t f = 0; f < turned.face_count(); ++f)
    if (turn[shells.of_face[f]] != 0) turn_face(turned, f);
  m = std::move(turned);
  return outward_status::ok;
}

}  // namespace irg::inline IRG_COMPILED_ABI
#endif
