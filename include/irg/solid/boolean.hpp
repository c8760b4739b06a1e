// SPDX-License-Identifier: MIT
// Union, intersection and differences of bodies, exactly: which faces meet, where and in which order, and what is
// inside of what, is decided by signs of polynomials in the corners' coordinates. New corners, where an edge goes
// through a face or crosses an edge, are rounded when they are handed out, and nowhere before.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/core/conversion.hpp>
#include <irg/geometry/boolean_operation.hpp>
#include <irg/mesh/mesh.hpp>
#include <irg/solid/detail/body_cutter.hpp>
#include <irg/solid/detail/seam_remover.hpp>

namespace irg {

/// How a combination of two bodies ended.
enum class [[nodiscard]] solid_boolean_status {
  done,
  not_finite,  ///< a position is NaN or infinite
  open_edge,  ///< an edge has one face
  edge_of_many_faces,  ///< faces do not run along an edge as often one way as the other
  not_a_body,  ///< the bodies cut themselves, have faces without area where they meet, or are not turned outward
};

/// Where a face of the result comes from.
struct solid_face_origin {
  std::uint32_t body = 0;  // 0 or 1
  std::uint32_t face = 0;  // of that body
  bool turned = false;  // looks the other way, as faces of what is taken away do
  constexpr bool operator==(const solid_face_origin&) const = default;
};

/// What a corner of the result is, without rounding.
/// shape   positions are numbered through both bodies, those of the first one first. A corner: of[0]; an edge from
///         of[0] to of[1] and the plane of of[2], of[3] and of[4]; edges from of[0] to of[1] and from of[2] to of[3]
struct solid_corner_origin {
  static constexpr std::uint32_t none = 0xffffffffu;
  std::uint32_t of[5] = {none, none, none, none, none};
  constexpr bool operator==(const solid_corner_origin&) const = default;
};

/// A combination of two bodies.
template <Floating T>
struct solid_boolean_result {
  solid_boolean_status status = solid_boolean_status::done;
  std::uint32_t body = 0;  // where status is not done, which of the two is to blame, if it is one of them: 0 or 1
  mesh<T> value{};  // of triangles
  std::vector<solid_face_origin> faces{};  // of each face
  std::vector<solid_corner_origin> corners{};  // of each position
};

namespace detail {
inline namespace IRG_ABI {

constexpr bool is_in_combination(bool first, bool second, boolean_operation operation) noexcept {
  switch (operation) {
    case boolean_operation::unite: return first || second;
    case boolean_operation::intersection: return first && second;
    case boolean_operation::difference: return first && !second;
    default: return first != second;
  }
}

// 1 where a part of the first (0) or second (1) body bounds the result, -1 where it does so turned, else 0.
constexpr int direction_of_part(int body, part_place place, boolean_operation operation) noexcept {
  const bool on = place == part_place::on_same_side || place == part_place::on_other_side;
  if (on && body == 1) return 0;  // the first one's stands for both
  const bool other_below = on ? place == part_place::on_same_side : place == part_place::inside;
  const bool other_above = on ? place == part_place::on_other_side : place == part_place::inside;
  const bool below =
      body == 0 ? is_in_combination(true, other_below, operation) : is_in_combination(other_below, true, operation);
  const bool above =
      body == 0 ? is_in_combination(false, other_above, operation) : is_in_combination(other_above, false, operation);
  return below == above ? 0 : below ? 1 : -1;
}

// Whether the edges at cuts are walked as often one way as the other.
template <class Cut>
constexpr bool are_cuts_closed(const Cut& cut, const std::vector<int>& direction) {
  struct walk {
    std::uint32_t low, high;
    int times;
  };
  std::vector<walk> walks;
  for (const auto& [from, to, triangle] : cut.cuts)
    if (const int times = direction[triangle]; times != 0)
      walks.push_back({lesser(from, to), greater(from, to), from < to ? times : -times});
  std::sort(walks.begin(), walks.end(),
            [](const walk& a, const walk& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; });
  int sum = 0;
  for (std::size_t i = 0; i < walks.size(); ++i) {
    if (i > 0 && (walks[i].low != walks[i - 1].low || walks[i].high != walks[i - 1].high)) {
      if (sum != 0) return false;
      sum = 0;
    }
    sum += walks[i].times;
  }
  return sum == 0;
}

template <class Cut>
constexpr solid_corner_origin origin_of_corner(const Cut& cut, const body_triangles& b, std::uint32_t v) {
  solid_corner_origin origin;
  if (v < cut.vertices.corners) {
    origin.of[0] = v;
    return origin;
  }
  const contact_key& key = cut.vertices.keys[v - cut.vertices.corners];
  origin.of[0] = key.v[0], origin.of[1] = key.v[1];
  if (key.v[3] != no_index)
    origin.of[2] = key.v[2], origin.of[3] = key.v[3];
  else
    for (std::size_t k = 0; k < 3; ++k) origin.of[2 + k] = b.triangles[key.v[2]].v[k];
  return origin;
}

// The triangles that bound the result, without the corners that are none.
template <class Cut>
constexpr std::vector<kept_triangle> keep_triangles(Cut& cut, const body_triangles& b,
                                                    const std::vector<int>& direction) {
  std::vector<kept_triangle> kept;
  for (std::size_t t = 0; t < direction.size(); ++t) {
    const cut_triangle& from = cut.triangles[t];
    if (direction[t] > 0) kept.push_back({{from.v[0], from.v[1], from.v[2]}, from.source, false});
    if (direction[t] < 0) kept.push_back({{from.v[2], from.v[1], from.v[0]}, from.source, true});
  }
  if (std::find(cut.is_seam.begin(), cut.is_seam.end(), 1) != cut.is_seam.end())
    seam_remover(kept, cut.vertices, cut.is_seam,
                 [&b](std::uint32_t s, std::uint32_t t) { return are_level(b, s, t); });
  return kept;
}

template <Floating T, class Cut>
constexpr void collect_result(solid_boolean_result<T>& out, const Cut& cut, const body_triangles& b,
                              const std::vector<kept_triangle>& kept) {
  std::vector<std::uint32_t> number(cut.vertices.at.size(), no_index);
  for (const kept_triangle& from : kept) {
    if (!from.is_there) continue;
    for (const std::uint32_t v : from.v) {
      if (number[v] == no_index) {
        number[v] = static_cast<std::uint32_t>(out.value.positions.size());
        const point<double, 3>& p = cut.vertices.at[v];
        out.value.positions.push_back({converted<T>(p.x), converted<T>(p.y), converted<T>(p.z)});
        out.corners.push_back(origin_of_corner(cut, b, v));
      }
      out.value.corners.push_back({number[v], mesh_corner::none, mesh_corner::none});
    }
    out.value.face_starts.push_back(static_cast<std::uint32_t>(out.value.corners.size()));
    out.faces.push_back({static_cast<std::uint32_t>(b.body_of(from.source)), b.face[from.source], from.turned});
  }
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// What two bodies have in common, what is in either, in the first but not the second, or in one of them alone.
/// shape   triangles: faces of the bodies as triangulate() cuts them, cut where they meet. Equal positions are one
///         corner; the places of corners, and the faces that triangles come from, are told beside. Triangles of one
///         plane and one part count as one face: no corner is made on the sides between them, and a new triangle goes
///         by the number of one of them
/// needs   meshes in which validate() finds no defect; closed, faces counter-clockwise seen from outside, of no faces
///         that go through each other; any number of shells, cavities too
/// gives   always a closed surface, which faces run along every edge of as often one way as the other; empty where
///         nothing is left. Where bodies touch from outside in an edge or a corner, it belongs to both sides: such an
///         edge has four faces. Faces that lie on each other count once, or not at all where they part nothing. A
///         status other than done, and no faces, for what is no body
/// exact   every decision, for all finite floats and doubles; places of new corners within 1 ulp of each coordinate
/// cost    O(n log n) for bodies that meet in few places, and what is cut; parts are placed by a pass over the other
///         body each
/// source  Zhou et al. 2016 (cut everything, then ask about parts); Attene 2020 (points by what they are made of)
template <Floating T>
[[nodiscard]] constexpr solid_boolean_result<T> solid_boolean(const mesh<T>& first, const mesh<T>& second,
                                                              boolean_operation operation) {
  const detail::body_triangles b = detail::make_body_triangles(first, second);
  for (std::uint32_t body = 0; body < 2; ++body) switch (b.fault[body]) {
      case detail::surface_fault::none: break;
      case detail::surface_fault::not_finite: return {solid_boolean_status::not_finite, body};
      case detail::surface_fault::open_edge: return {solid_boolean_status::open_edge, body};
      case detail::surface_fault::edge_of_many_faces: return {solid_boolean_status::edge_of_many_faces, body};
    }
  detail::body_cutter cut(b);
  if (cut.failed) return {solid_boolean_status::not_a_body};
  std::vector<int> direction(cut.triangles.size(), 0);
  for (std::size_t t = 0; t < direction.size(); ++t) {
    const detail::cut_triangle& from = cut.triangles[t];
    direction[t] =
        static_cast<int>(detail::direction_of_part(b.body_of(from.source), cut.places[from.part], operation));
  }
  if (!detail::are_cuts_closed(cut, direction)) return {solid_boolean_status::not_a_body};
  solid_boolean_result<T> out;
  detail::collect_result(out, cut, b, detail::keep_triangles(cut, b, direction));
  return out;
}

}  // namespace IRG_ABI
}  // namespace irg
