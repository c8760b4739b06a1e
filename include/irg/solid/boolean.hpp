// SPDX-License-Identifier: MIT
// Union, intersection and differences of bodies, exactly: which faces meet, where and in which order, and what is
// inside of what, is decided by signs of polynomials in the corners' coordinates. New corners, where an edge goes
// through a face or crosses an edge, are rounded when they are handed out, and nowhere before.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <irg/core/function_ref.hpp>
#include <irg/core/vocabulary.hpp>
#include <irg/geometry/vocabulary.hpp>
#include <irg/mesh/mesh.hpp>
#if IRG_BODIES
#include <irg/core/conversion.hpp>
#include <irg/math/exact_sum.hpp>
#include <irg/solid/detail/body_arrangement.hpp>
#include <irg/solid/detail/body_triangles.hpp>
#include <irg/solid/detail/exact_vertices.hpp>
#include <irg/solid/detail/upward_crossings.hpp>
#include <irg/solid/self_intersections.hpp>
#endif

namespace irg {

/// How a combination of two bodies ended.
enum class [[nodiscard]] solid_boolean_status {
  ok,
  not_finite,  ///< a position is NaN or infinite
  open_edge,  ///< an edge has one face
  edge_of_many_faces,  ///< faces do not run along an edge as often one way as the other
  not_a_body,  ///< a body cuts itself, has faces without area where it meets another, or a shell turned inside out
  done [[deprecated("irg: done is now ok")]] = ok
};

/// Where a face of the result comes from.
struct solid_face_origin {
  std::uint32_t body = 0;  // 0 or 1; in a tree, of its bodies
  std::uint32_t face = 0;  // of that body
  bool turned = false;  // looks the other way, as faces of what is taken away do
  bool operator==(const solid_face_origin&) const = default;
};

/// What a corner of the result is, without rounding.
/// shape   positions are numbered through the bodies, those of the first one first. A corner: of[0]; an edge from
///         of[0] to of[1] and the plane of of[2], of[3] and of[4]; edges from of[0] to of[1] and from of[2] to of[3];
///         the planes of three positions each from of[0], of[3] and of[6] on
struct solid_corner_origin {
  [[deprecated("irg: no_index")]] static constexpr std::uint32_t none = no_index;
  std::uint32_t of[9] = {no_index, no_index, no_index, no_index, no_index, no_index, no_index, no_index, no_index};
  bool operator==(const solid_corner_origin&) const = default;
};

/// What combining bodies took: of `pairs`, those beyond `met` were skipped; no triangle of a part was placed but one.
struct solid_boolean_counts {
  std::uint64_t pairs = 0;  // of triangles, one of each of two bodies
  std::uint64_t met = 0;  // of these, pairs whose boxes have a point in common: where they meet is decided
  std::uint64_t parts = 0;  // of all bodies' surfaces, as the cuts divide them
  bool operator==(const solid_boolean_counts&) const = default;
};

/// A combination of bodies.
template <Floating T>
struct solid_boolean_result {
  solid_boolean_status status = solid_boolean_status::ok;
  std::uint32_t body = no_index;  // where status is not ok, the first of them that is to blame, if it is known
  mesh<T> value{};  // of triangles
  std::vector<solid_face_origin> faces{};  // of each face
  std::vector<solid_corner_origin> corners{};  // of each position
  solid_boolean_counts counts{};  // where status is ok
  bool operator==(const solid_boolean_result&) const = default;

  [[deprecated("irg: no_index")]] static constexpr std::uint32_t none = no_index;

  /// Whether there is one.
  IRG_INLINE constexpr explicit operator bool() const noexcept { return status == solid_boolean_status::ok; }
};

inline namespace IRG_ABI {

/// What two bodies have in common, what is in either, in the first but not the second, or in one of them alone.
/// shape   triangles: faces of the bodies as triangulated() cuts them, cut where they meet. Equal positions are one
///         corner; the places of corners, and the faces that triangles come from, are told beside. Triangles of one
///         plane and one part count as one face: no corner is made on the sides between them, and a new triangle goes
///         by the number of one of them
/// needs   meshes in which validate() finds no defect; closed, faces counter-clockwise seen from outside, of no faces
///         that go through each other; any number of shells, cavities too
/// gives   always a closed surface, which faces run along every edge of as often one way as the other; empty where
///         nothing is left. Where bodies touch from outside in an edge or a corner, it belongs to both sides: such an
///         edge has four faces. Faces that lie on each other count once, or not at all where they part nothing. A
///         status other than ok, and no faces, for what is no body: where it meets nothing, too, for a shell of
///         negative volume that no other of its body goes round; for bodies that cut themselves where that shows
/// exact   every decision, for all finite floats and doubles; places of new corners within 1 ulp of each coordinate
/// cost    O(n log n) for bodies that meet in few places, and what is cut: of two faces of n corners that lie on each
///         other, as many as n^2 pieces; the first parts are placed by a pass over the other body each, many of them by
///         a tree of its boxes
/// source  Zhou et al. 2016 (cut everything, then ask about parts); Attene 2020 (points by what they are made of)
template <Floating T>
[[nodiscard]] constexpr solid_boolean_result<T> solid_boolean(const mesh<T>& first, const mesh<T>& second,
                                                              boolean_operation operation);

}  // namespace IRG_ABI
}  // namespace irg

namespace irg::detail::inline IRG_COMPILED_ABI {

// What is inside of a combination of bodies: where is_in(v) holds for the bodies b with v[b] != 0.
template <Floating T>
IRG_API solid_boolean_result<T> boolean_of_bodies(const std::vector<const mesh<T>*>& bodies,
                                                  const function_ref<bool(const std::vector<unsigned char>&)>& is_in);

}  // namespace irg::detail::inline IRG_COMPILED_ABI

namespace irg::detail::inline IRG_ABI {

constexpr bool is_in_combination(bool first, bool second, boolean_operation operation) noexcept {
  switch (operation) {
    case boolean_operation::union_: return first || second;
    case boolean_operation::intersection: return first && second;
    case boolean_operation::difference: return first && !second;
    default: return first != second;
  }
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <Floating T>
[[nodiscard]] constexpr solid_boolean_result<T> solid_boolean(const mesh<T>& first, const mesh<T>& second,
                                                              boolean_operation operation) {
  const auto is_in = [operation](const std::vector<unsigned char>& in) {
    return detail::is_in_combination(in[0] != 0, in[1] != 0, operation);
  };
  return detail::boolean_of_bodies<T>({&first, &second}, as_function<bool(const std::vector<unsigned char>&)>(is_in));
}

}  // namespace irg::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail {

// Takes corners out of a surface that are there only because a plane face was cut: where a diagonal met something, or a
// body that does not bound the result there. The triangles round such a corner, plane by plane, are cut anew without
// it, so that faces keep the corners that the bodies have, and nothing else is ever rounded.

/// A triangle of the result.
struct kept_triangle {
  std::uint32_t v[3];
  std::uint32_t source;
  bool turned, is_there = true;
};

inline namespace IRG_ABI {

template <class Vertices>
struct seam_removal {
  // A side seen from the corner that goes: from, to, of which triangle.
  struct spoke {
    std::uint32_t from, to, triangle;
  };
  // Triangles of one plane side by side: polygon runs round them, without the corner.
  struct sector {
    std::vector<std::uint32_t> polygon, triangles;
    bool is_closed = false;
  };

  const body_triangles& bodies;
  Vertices& vertices;
  const std::vector<unsigned char>& is_seam;  // of each vertex
  std::vector<kept_triangle>& surface;
  std::vector<std::vector<std::uint32_t>> around{};  // of each vertex that is_seam, the triangles, those that went too
  std::vector<spoke> spokes{};
  std::vector<sector> sectors{};
  std::vector<kept_triangle> cuts{};
};

template <class Seams>
constexpr void note_corners(Seams& s, std::uint32_t t) {
  for (const std::uint32_t v : s.surface[t].v)
    if (s.is_seam[v] != 0) s.around[v].push_back(t);
}

// The triangles level with the first that is left and joined to it.
template <class Seams>
constexpr void take_sector(Seams& s) {
  const auto first = s.spokes.back();
  s.spokes.pop_back();
  s.sectors.push_back({{first.from, first.to}, {first.triangle}});
  auto& [polygon, triangles, is_closed] = s.sectors.back();
  const kept_triangle level = s.surface[first.triangle];
  for (bool grows = true; grows && !is_closed;) {
    grows = false;
    for (std::size_t i = 0; i < s.spokes.size() && !grows; ++i) {
      const auto next = s.spokes[i];
      const bool after = next.from == polygon.back(), before = next.to == polygon.front();
      const kept_triangle& k = s.surface[next.triangle];
      if ((!after && !before) || k.turned != level.turned || !are_level(s.bodies, level.source, k.source)) continue;
      if (after && before)
        is_closed = true;
      else if (after)
        polygon.push_back(next.to);
      else
        polygon.insert(polygon.begin(), next.from);
      triangles.push_back(next.triangle);
      s.spokes.erase(s.spokes.begin() + static_cast<std::ptrdiff_t>(i));
      grows = true;
    }
  }
}

// Whether the corner lies within a plane, or within one edge of all that meet there.
template <class Seams>
constexpr bool is_straight(Seams& s, std::uint32_t p) {
  std::uint32_t low = no_index, high = no_index, triangle = no_index;
  for (const auto& [polygon, triangles, is_closed] : s.sectors) {
    if (is_closed) continue;
    const std::uint32_t a = minimum(polygon.front(), polygon.back()), b = maximum(polygon.front(), polygon.back());
    if (low != no_index && (low != a || high != b)) return false;
    if (a == b || polygon.size() < 3) return false;
    if (low == no_index) triangle = s.surface[triangles.front()].source;
    low = a;
    high = b;
  }
  if (low == no_index) return true;
  const seen_triangle seen = see_triangle(s.bodies.positions, s.bodies.triangles[triangle], triangle);
  return s.vertices.turn(low, p, high, seen.axis) == 0;
}

// Ears come off until none are left.
template <class Seams>
constexpr bool cut_anew(Seams& s, const typename Seams::sector& of) {
  const kept_triangle level = s.surface[of.triangles.front()];
  const seen_triangle seen = see_triangle(s.bodies.positions, s.bodies.triangles[level.source], level.source);
  const int direction = level.turned ? -seen.turn : seen.turn;
  const auto turn = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return s.vertices.turn(a, b, c, seen.axis) * direction;
  };
  std::vector<std::uint32_t> ring = of.polygon;
  while (ring.size() > 2) {
    const std::size_t n = ring.size();
    std::size_t ear = n;
    for (std::size_t i = 0; i < n && ear == n; ++i) {
      const std::uint32_t a = ring[i], b = ring[(i + 1) % n], c = ring[(i + 2) % n];
      if (turn(a, b, c) <= 0) continue;
      bool is_free = true;
      for (std::size_t k = 3; k < n && is_free; ++k) {
        const std::uint32_t q = ring[(i + k) % n];
        if (q == a || q == b || q == c) return false;  // touches itself
        is_free = turn(a, b, q) < 0 || turn(b, c, q) < 0 || turn(c, a, q) < 0;
      }
      if (is_free) ear = i;
    }
    if (ear == n) return false;
    const std::size_t tip = (ear + 1) % n;
    s.cuts.push_back({{ring[ear], ring[tip], ring[(ear + 2) % n]}, level.source, level.turned});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(tip));
  }
  return true;
}

// Leaves a corner where it is unless all that is round it can be cut without it.
template <class Seams>
constexpr void remove_corner(Seams& s, std::uint32_t p) {
  s.spokes.clear();
  for (const std::uint32_t t : s.around[p]) {
    const kept_triangle& k = s.surface[t];
    if (!k.is_there) continue;
    const std::size_t i = k.v[0] == p ? 0 : k.v[1] == p ? 1 : 2;
    s.spokes.push_back({k.v[(i + 1) % 3], k.v[(i + 2) % 3], t});
  }
  s.sectors.clear();
  while (!s.spokes.empty()) take_sector(s);
  if (!is_straight(s, p)) return;
  s.cuts.clear();
  for (const auto& of : s.sectors)
    if (!cut_anew(s, of)) return;
  for (const auto& of : s.sectors)
    for (const std::uint32_t t : of.triangles) s.surface[t].is_there = false;
  for (const kept_triangle& k : s.cuts) {
    s.surface.push_back(k);
    note_corners(s, static_cast<std::uint32_t>(s.surface.size() - 1));
  }
}

template <class Seams>
constexpr void remove_seams(Seams& s) {
  s.around.resize(s.is_seam.size());
  for (std::uint32_t t = 0; t < s.surface.size(); ++t) note_corners(s, t);
  for (std::uint32_t v = 0; v < s.is_seam.size(); ++v)
    if (s.is_seam[v] != 0 && !s.around[v].empty()) remove_corner(s, v);
}

}  // namespace IRG_ABI
}  // namespace irg::detail

namespace irg::detail::inline IRG_ABI {

// Which bodies have a shell that is turned inside out: one of negative volume, by an exact sign, that is no cavity.
// What cutting bodies at each other shows of that only where they meet is found here for all shells.

// Triangles by shells, those of a body one after another: joined along sides, also those of four faces.
struct body_shells {
  std::vector<std::uint32_t> shell{};  // of each triangle
  std::vector<std::uint32_t> order{}, starts{};  // the triangles of shell s: order[i] for i from starts[s] to the next
};

template <class Bodies>
constexpr body_shells find_shells(const Bodies& b) {
  const auto side_of = [&](std::uint32_t t, std::uint32_t k, std::uint32_t triangle) {
    const std::uint32_t v = b.triangles[t].v[k], w = b.triangles[t].v[(k + 1) % 3];
    return triangle_side{minimum(v, w), maximum(v, w), triangle};
  };
  std::vector<triangle_side> rims;
  for (std::uint32_t t = 0; t < b.triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k)
      if (b.twin[3 * std::size_t{t} + k] == no_index) rims.push_back(side_of(t, k, t));
  std::sort(rims.begin(), rims.end());
  std::vector<unsigned char> is_met(rims.size(),
                                    0);  // of the first of an edge and a body, whether its faces were taken
  body_shells s;
  s.shell.assign(b.triangles.size(), no_index);
  s.order.reserve(b.triangles.size());
  const auto take = [&s](std::uint32_t t) {
    if (s.shell[t] != no_index) return;
    s.shell[t] = static_cast<std::uint32_t>(s.starts.size() - 1);
    s.order.push_back(t);
  };
  for (std::uint32_t first = 0; first < b.triangles.size(); ++first) {
    if (s.shell[first] != no_index) continue;
    s.starts.push_back(static_cast<std::uint32_t>(s.order.size()));
    take(first);
    for (std::size_t i = s.starts.back(); i < s.order.size(); ++i) {
      const std::uint32_t t = s.order[i];
      for (std::uint32_t k = 0; k < 3; ++k) {
        if (const std::uint32_t twin = b.twin[3 * std::size_t{t} + k]; twin != no_index) {
          take(twin / 3);
          continue;
        }
        const triangle_side side = side_of(t, k, b.first_of(b.body[t]));
        auto r = std::lower_bound(rims.begin(), rims.end(), side);
        unsigned char& met = is_met[static_cast<std::size_t>(r - rims.begin())];
        if (met != 0) continue;
        met = 1;
        for (; r != rims.end() && r->low == side.low && r->high == side.high && b.body[r->triangle] == b.body[t]; ++r)
          take(r->triangle);
      }
    }
  }
  s.starts.push_back(static_cast<std::uint32_t>(s.order.size()));
  return s;
}

// In rounded numbers, where these are sure: with u = 2^-53, each determinant of differences is off by less than 16u
// of `size`, the product of its rows' sums, and n of them summed by less than n u of the sum of sizes more.
template <class Bodies>
constexpr int sign_of_volume(const Bodies& b, const body_shells& s, std::uint32_t shell) {
  const point<double, 3>& from = b.positions[b.triangles[s.order[s.starts[shell]]].v[0]];
  double volume = 0, size = 0;
  const auto sum_of = [](const vec<double, 3>& v) { return magnitude(v[0]) + magnitude(v[1]) + magnitude(v[2]); };
  for (std::uint32_t i = s.starts[shell]; i < s.starts[shell + 1]; ++i) {
    const triangle_indices& t = b.triangles[s.order[i]];
    const point<double, 3>& a = b.positions[t.v[0]];
    const vec<double, 3> x = a - from, y = b.positions[t.v[1]] - a, z = b.positions[t.v[2]] - a;
    volume += dot(x, cross(y, z));
    size += product(product(sum_of(x), sum_of(y)), sum_of(z));
  }
  const double error = product(size, (static_cast<double>(s.starts[shell + 1] - s.starts[shell]) + 32) * 0x1p-52);
  if (size < 0x1p1000 && error > 0x1p-900 && magnitude(volume) > error) return volume < 0 ? -1 : 1;
  exact_accumulator<3> sum;
  for (std::uint32_t i = s.starts[shell]; i < s.starts[shell + 1]; ++i) {
    const triangle_indices& t = b.triangles[s.order[i]];
    const point<double, 3>&p = b.positions[t.v[0]], &q = b.positions[t.v[1]], &r = b.positions[t.v[2]];
    for (int k = 0; k < 3; ++k) {
      sum.add(p[k], q[(k + 1) % 3], r[(k + 2) % 3]);
      sum.subtract(p[k], q[(k + 2) % 3], r[(k + 1) % 3]);
    }
  }
  return sum.sign();
}

// Whether the other shells of its body run round a shell, as its first corner tells that is not on one of them; they
// do where none tells.
template <class Bodies>
constexpr bool is_cavity(const Bodies& b, const body_shells& s, body_boxes& boxes, std::uint32_t shell) {
  const std::uint32_t body = b.body[s.order[s.starts[shell]]];
  if (boxes.trees.empty()) boxes = boxes_of_bodies(b);
  for (std::uint32_t i = s.starts[shell]; i < s.starts[shell + 1]; ++i) {
    const point<double, 3>& p = b.positions[b.triangles[s.order[i]].v[0]];
    upward_crossings count;
    each_above(boxes, body, p, 0.0, [&](std::uint32_t t) {
      const triangle_indices& n = b.triangles[t];
      if (s.shell[t] != shell)
        count_upward_crossing(b.positions[n.v[0]], b.positions[n.v[1]], b.positions[n.v[2]], p, count);
    });
    if (!count.on_surface) return count.winding > 0;
  }
  return true;
}

/// The first body that has a shell turned inside out, or no_index.
template <class Bodies>
constexpr std::uint32_t find_inside_out(const Bodies& b) {
  const body_shells s = find_shells(b);
  body_boxes boxes;  // made where they are asked for
  for (std::uint32_t i = 0; i + 1 < s.starts.size(); ++i)
    if (sign_of_volume(b, s, i) < 0 && !is_cavity(b, s, boxes, i)) return b.body[s.order[s.starts[i]]];
  return no_index;
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg {

namespace detail::inline IRG_ABI {

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
      walks.push_back({minimum(from, to), maximum(from, to), (from < to) != turned ? 1 : -1});
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
      out.value.corners.push_back({number[v], no_index, no_index});
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

}  // namespace detail::inline IRG_ABI

namespace detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API solid_boolean_result<T> boolean_of_bodies(const std::vector<const mesh<T>*>& bodies,
                                                  const function_ref<bool(const std::vector<unsigned char>&)>& is_in) {
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

}  // namespace detail::inline IRG_COMPILED_ABI
}  // namespace irg
#endif
