// SPDX-License-Identifier: MIT
// Union, intersection and differences of bodies, exactly: which faces meet, where and in which order, and what is
// inside of what, is decided by signs of polynomials in the corners' coordinates. New corners, where an edge goes
// through a face or crosses an edge, are rounded when they are handed out, and nowhere before.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/core/vocabulary.hpp>
#include <irg/core/conversion.hpp>
#include <irg/geometry/vocabulary.hpp>
#include <irg/mesh/mesh.hpp>
#include <irg/solid/detail/body_arrangement.hpp>
#include <irg/solid/detail/seam_removal.hpp>
#include <irg/solid/detail/shell_sides.hpp>
#include <irg/solid/self_intersections.hpp>

namespace irg {

/// How a combination of two bodies ended.
enum class [[nodiscard]] solid_boolean_status {
  done,
  not_finite,  ///< a position is NaN or infinite
  open_edge,  ///< an edge has one face
  edge_of_many_faces,  ///< faces do not run along an edge as often one way as the other
  not_a_body,  ///< a body cuts itself, has faces without area where it meets another, or a shell turned inside out
};

/// Where a face of the result comes from.
struct solid_face_origin {
  std::uint32_t body = 0;  // 0 or 1; in a tree, of its bodies
  std::uint32_t face = 0;  // of that body
  bool turned = false;  // looks the other way, as faces of what is taken away do
  constexpr bool operator==(const solid_face_origin&) const = default;
};

/// What a corner of the result is, without rounding.
/// shape   positions are numbered through the bodies, those of the first one first. A corner: of[0]; an edge from
///         of[0] to of[1] and the plane of of[2], of[3] and of[4]; edges from of[0] to of[1] and from of[2] to of[3];
///         the planes of three positions each from of[0], of[3] and of[6] on
struct solid_corner_origin {
  static constexpr std::uint32_t none = no_index;
  std::uint32_t of[9] = {none, none, none, none, none, none, none, none, none};
  constexpr bool operator==(const solid_corner_origin&) const = default;
};

/// What combining bodies took: of `pairs`, those beyond `met` were skipped; no triangle of a part was placed but one.
struct solid_boolean_counts {
  std::uint64_t pairs = 0;  // of triangles, one of each of two bodies
  std::uint64_t met = 0;  // of these, pairs whose boxes have a point in common: where they meet is decided
  std::uint64_t parts = 0;  // of all bodies' surfaces, as the cuts divide them
  constexpr bool operator==(const solid_boolean_counts&) const = default;
};

/// A combination of bodies.
template <Floating T>
struct solid_boolean_result {
  static constexpr std::uint32_t none = no_index;
  solid_boolean_status status = solid_boolean_status::done;
  std::uint32_t body =
      none;  // where status is not done, the first of them that is to blame, or none if it is not known
  mesh<T> value{};  // of triangles
  std::vector<solid_face_origin> faces{};  // of each face
  std::vector<solid_corner_origin> corners{};  // of each position
  solid_boolean_counts counts{};  // where status is done
};

namespace detail::inline IRG_ABI {

constexpr bool is_in_combination(bool first, bool second, boolean_operation operation) noexcept {
  switch (operation) {
    case boolean_operation::unite: return first || second;
    case boolean_operation::intersection: return first && second;
    case boolean_operation::difference: return first && !second;
    default: return first != second;
  }
}

// Whether the edges at cuts are walked as often one way as the other.
template <class Cut>
constexpr bool are_cuts_closed(const Cut& cut) {
  struct walk {
    std::uint32_t low, high;
    int times;
  };
  std::vector<walk> walks;
  for (const auto& [from, to, triangle] : cut.cuts)
    if (const bool turned = cut.directions[triangle] < 0; cut.directions[triangle] != 0)
      walks.push_back({lesser(from, to), greater(from, to), (from < to) != turned ? 1 : -1});
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
  if (key.v[3] == three_triangles) {
    for (std::size_t k = 0; k < 9; ++k) origin.of[k] = b.triangles[key.v[k / 3]].v[k % 3];
    return origin;
  }
  const std::size_t corners = key.v[3] == no_index ? 2 : 4;
  for (std::size_t k = 0; k < corners; ++k) origin.of[k] = key.v[k];
  if (corners == 2) std::copy_n(b.triangles[key.v[2]].v, 3, origin.of + 2);
  return origin;
}

// The triangles that bound the result, without the corners that are none.
template <class Cut>
constexpr std::vector<kept_triangle> keep_triangles(Cut& cut, const body_triangles& b) {
  std::vector<kept_triangle> kept;
  for (std::size_t t = 0; t < cut.triangles.size(); ++t) {
    const cut_triangle& from = cut.triangles[t];
    if (cut.directions[t] > 0) kept.push_back({{from.v[0], from.v[1], from.v[2]}, from.source, false});
    if (cut.directions[t] < 0) kept.push_back({{from.v[2], from.v[1], from.v[0]}, from.source, true});
  }
  seam_removal<decltype(cut.vertices)> seams{b, cut.vertices, cut.is_seam, kept};
  if (std::find(cut.is_seam.begin(), cut.is_seam.end(), 1) != cut.is_seam.end()) remove_seams(seams);
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
    out.faces.push_back({b.body[from.source], b.face[from.source], from.turned});
  }
}

template <class Cut>
constexpr solid_boolean_counts counts_of(const Cut& cut, const body_triangles& b) noexcept {
  solid_boolean_counts counts{0, cut.met, 0};
  for (std::uint32_t i = 0; i < b.ends.size(); ++i)
    counts.pairs += std::uint64_t{b.first_of(i)} * (b.ends[i] - b.first_of(i));
  for (std::size_t t = 0; t < cut.triangles.size(); ++t) counts.parts += cut.triangles[t].part == t ? 1u : 0u;
  return counts;
}

// What is inside of a combination of bodies: where is_in(v) holds for the bodies b with v[b] != 0.
template <Floating T, class IsIn>
constexpr solid_boolean_result<T> boolean_of_bodies(const std::vector<const mesh<T>*>& bodies, const IsIn& is_in) {
  const auto b = make_body_triangles(bodies);
  switch (b.fault) {
    case surface_fault::none: break;
    case surface_fault::not_finite: return {solid_boolean_status::not_finite, b.faulty};
    case surface_fault::open_edge: return {solid_boolean_status::open_edge, b.faulty};
    case surface_fault::edge_of_many_faces: return {solid_boolean_status::edge_of_many_faces, b.faulty};
  }
  if (const std::uint32_t turned = find_inside_out(b); turned != no_index)
    return {solid_boolean_status::not_a_body, turned};
  body_arrangement<> cut{b};
  if (!arrange_bodies(cut, is_in) || !are_cuts_closed(cut)) {
    std::uint32_t culprit = cut.culprit;
    for (std::uint32_t i = 0; i < bodies.size() && culprit == no_index; ++i)
      if (!self_intersections(*bodies[i]).empty()) culprit = i;
    return {solid_boolean_status::not_a_body, culprit};
  }
  solid_boolean_result<T> out;
  out.counts = counts_of(cut, b);
  collect_result(out, cut, b, keep_triangles(cut, b));
  return out;
}

}  // namespace detail::inline IRG_ABI

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
///         status other than done, and no faces, for what is no body: where it meets nothing, too, for a shell of
///         negative volume that no other of its body goes round; for bodies that cut themselves where that shows
/// exact   every decision, for all finite floats and doubles; places of new corners within 1 ulp of each coordinate
/// cost    O(n log n) for bodies that meet in few places, and what is cut: of two faces of n corners that lie on each
///         other, as many as n^2 pieces; the first parts are placed by a pass over the other body each, many of them by
///         a tree of its boxes
/// source  Zhou et al. 2016 (cut everything, then ask about parts); Attene 2020 (points by what they are made of)
template <Floating T>
[[nodiscard]] constexpr solid_boolean_result<T> solid_boolean(const mesh<T>& first, const mesh<T>& second,
                                                              boolean_operation operation) {
  return detail::boolean_of_bodies<T>({&first, &second}, [operation](const std::vector<unsigned char>& in) {
    return detail::is_in_combination(in[0] != 0, in[1] != 0, operation);
  });
}

}  // namespace IRG_ABI
}  // namespace irg
