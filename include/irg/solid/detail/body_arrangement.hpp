// SPDX-License-Identifier: MIT
// Bodies cut at each other: the triangles that they meet in are replaced by pieces, all pieces fall into parts that no
// cut runs through, and each part is inside of every other body, outside, or on its surface. What lies in which bodies
// on either side of a part tells whether it bounds a combination of them. A step gives false where the bodies cut
// themselves, or are not turned outward.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <irg/solid/detail/body_triangles.hpp>
#include <irg/solid/detail/exact_crossings.hpp>
#include <irg/solid/detail/face_triangulation.hpp>

namespace irg::detail {

/// A triangle of the result before any is left out.
struct cut_triangle {
  std::uint32_t v[3];
  std::uint32_t source;  // of body_triangles
  std::uint32_t part;
};

/// Which bodies what lies close to a part is inside of: 0 or 1 for each.
struct part_sides {
  std::vector<unsigned char> below{}, above{};
  std::vector<unsigned char> is_known{};  // 1 for bodies that need not be asked about
};

inline namespace IRG_ABI {

template <class Exact = exact_point>
struct body_arrangement {
  using exact_type = Exact;

  // A contact on a triangle, or a cut from one to another.
  struct mark {
    std::uint32_t triangle, from, to;  // indices of keys, then vertices
    std::uint8_t from_place, to_place;
    cut_maker by;
    constexpr auto operator<=>(const mark&) const = default;
  };
  struct coplanar_pair {
    std::uint32_t triangle, other;
    constexpr auto operator<=>(const coplanar_pair&) const = default;
  };

  const body_triangles& bodies;
  exact_vertices<Exact> vertices{};
  std::vector<cut_triangle> triangles{};  // those of one body after another
  std::vector<signed char> directions{};  // of each triangle: 1 where it bounds the combination, -1 where turned, or 0
  std::vector<std::array<std::uint32_t, 3>> cuts{};  // edges at which parts end: from, to, the triangle
  std::vector<unsigned char> is_seam{};  // of each vertex, whether it may lie within a plane face or a straight edge
  std::uint32_t culprit = no_index;  // the body that is to blame, where a look at what failed tells it
  std::uint64_t met = 0;  // pairs of triangles whose boxes meet

  // What one step leaves to the next ones.
  body_boxes boxes{};
  std::vector<contact_key> keys{};
  std::vector<unsigned char> is_key_of_seam{};
  std::vector<mark> marks{};
  std::vector<coplanar_pair> coplanar{};
  std::vector<unsigned char> is_touched{};  // of each corner of the bodies
  std::vector<std::uint32_t> only_piece{};  // of a triangle that is not cut
  std::vector<triangle_side> sides{};  // of pieces along sides of triangles

  constexpr bool are_many() const noexcept { return bodies.ends.size() > 2; }  // places may have several names
  constexpr std::uint32_t body_of(std::uint32_t t) const noexcept { return bodies.body[triangles[t].source]; }
  constexpr std::uint32_t part_of(std::uint32_t t) noexcept {
    while (triangles[t].part != t) t = triangles[t].part = triangles[triangles[t].part].part;
    return t;
  }
  constexpr void join(std::uint32_t s, std::uint32_t t) noexcept {
    const std::uint32_t p = part_of(s), q = part_of(t);
    triangles[maximum(p, q)].part = minimum(p, q);
  }
};

// Whether side k of a triangle lies within a plane face.
template <class Bodies>
constexpr bool is_level_side(const Bodies& b, std::uint32_t t, std::uint8_t at) noexcept {
  const std::uint32_t twin = b.twin[3 * std::size_t{t} + at - 3];
  return twin != no_index && are_level(b, t, twin / 3);
}
template <class Bodies>
constexpr bool is_of_seam(const Bodies& b, const triangle_contact& c, std::uint32_t s, std::uint32_t t) noexcept {
  if (c.key.v[1] == no_index) return false;
  const bool first = c.at[0] != inside_triangle && is_level_side(b, s, c.at[0]);
  const bool second = c.at[1] != inside_triangle && is_level_side(b, t, c.at[1]);
  if (c.at[0] == inside_triangle) return second;
  if (c.at[1] == inside_triangle) return first;
  if (first == second) return first;
  // A true edge and a seam: a corner only where the edge goes through the plane.
  const triangle_indices &plane = b.triangles[first ? s : t], &edge = b.triangles[first ? t : s];
  const int k = c.at[first ? 1 : 0] - 3;
  const auto side = [&](std::uint32_t v) {
    return orient3d(b.positions[plane.v[0]], b.positions[plane.v[1]], b.positions[plane.v[2]], b.positions[v]);
  };
  return side(edge.v[k]) == 0 && side(edge.v[(k + 1) % 3]) == 0;
}

template <class Cut>
constexpr bool add_contacts(Cut& c, std::uint32_t s, std::uint32_t t) {
  const body_triangles& b = c.bodies;
  const auto first_seen = see_triangle(b.positions, b.triangles[s], s);
  const auto second_seen = see_triangle(b.positions, b.triangles[t], t);
  if (first_seen.turn == 0 || second_seen.turn == 0) {
    c.culprit = b.body[first_seen.turn == 0 ? s : t];
    return false;
  }
  const contact_finder found(first_seen, second_seen);
  const auto first = static_cast<std::uint32_t>(c.keys.size());
  for (int i = 0; i < found.count; ++i) {
    c.keys.push_back(found.contacts[i].key);
    c.is_key_of_seam.push_back(is_of_seam(b, found.contacts[i], s, t) ? 1 : 0);
  }
  const auto add = [&](int i, int k, int which, int side) {
    const triangle_contact &p = found.contacts[i], &q = found.contacts[k];
    const auto from = first + static_cast<std::uint32_t>(i), to = first + static_cast<std::uint32_t>(k);
    cut_maker on_s{{t, no_index}, b.body[t]}, on_t{{s, no_index}, b.body[s]};
    if (side < 3) {
      const seen_triangle& of = which == 0 ? first_seen : second_seen;
      on_s = on_t = {{of.v[side], of.v[(side + 1) % 3]}, b.body[which == 0 ? s : t]};
    }
    c.marks.push_back({s, from, to, p.at[0], q.at[0], on_s});
    c.marks.push_back({t, from, to, p.at[1], q.at[1], on_t});
  };
  for (int i = 0; i < found.count; ++i) add(i, i, 0, 3);
  found.each_segment(add);
  if (!found.are_coplanar || found.count < 3) return true;
  c.coplanar.push_back({s, t});
  c.coplanar.push_back({t, s});
  return true;
}

// Where triangles of two bodies meet.
template <class Cut>
constexpr bool find_contacts(Cut& c) {
  c.boxes = boxes_of_bodies(c.bodies);
  bool are_found = true;
  const auto use = [&](std::uint32_t s, std::uint32_t t) {
    ++c.met;
    are_found = add_contacts(c, s, t) && are_found;
  };
  for (std::size_t i = 0; i < c.boxes.bodies.size(); ++i)
    for (std::size_t k = i + 1; k < c.boxes.bodies.size(); ++k)
      if (c.boxes.bodies[i].meets(c.boxes.bodies[k]))
        box_pair_search<decltype(use)>(c.boxes.triangles, use)
            .search(c.boxes.trees[i].items(), c.boxes.trees[k].items());
  return are_found;
}

// Each key once, and a vertex for it.
template <class Cut>
constexpr void name_contacts(Cut& c) {
  std::vector<contact_key> sorted = c.keys;
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  std::vector<std::uint32_t> vertex;
  vertex.reserve(sorted.size());
  c.is_touched.assign(c.bodies.positions.size(), 0);
  for (const contact_key& key : sorted) {
    if (key.v[1] == no_index) c.is_touched[key.v[0]] = 1;
    vertex.push_back(key.v[1] == no_index ? key.v[0] : c.vertices.add(key));
  }
  const auto same = c.vertices.merge(c.are_many() ? vertex : std::vector<std::uint32_t>{});
  const auto named = [&](std::uint32_t i) {
    return same[vertex[static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), c.keys[i]) -
                                                sorted.begin())]];
  };
  c.is_seam.assign(c.vertices.at.size(), 0);
  for (std::uint32_t i = 0; i < c.keys.size(); ++i)
    if (c.is_key_of_seam[i] != 0) c.is_seam[named(i)] = 1;
  for (auto& m : c.marks) {
    m.from = named(m.from);
    m.to = named(m.to);
  }
  std::sort(c.marks.begin(), c.marks.end());
  c.marks.erase(std::unique(c.marks.begin(), c.marks.end()), c.marks.end());
  std::sort(c.coplanar.begin(), c.coplanar.end());
}

// What lies beyond side k of piece p of triangle t: nothing that belongs to its part, another piece, or another
// triangle. The pieces stand among the triangles from `first` on.
template <class Cut, class Face>
constexpr void end_side(Cut& c, const Face& f, std::uint32_t first, std::uint32_t p, int k) {
  const face_piece& piece = f.pieces[p];
  const std::uint32_t from = piece.v[k], to = piece.v[(k + 1) % 3], u = f.local[from], v = f.local[to];
  if (piece.fixed[k] != no_index)
    c.cuts.push_back({u, v, first + p});
  else if (piece.beside[k] != no_index)
    c.join(first + p, first + piece.beside[k]);
  else if (c.bodies.twin[3 * std::size_t{f.number} + static_cast<std::size_t>(f.rim_of(from, to))] != no_index)
    c.sides.push_back({minimum(u, v), maximum(u, v), first + p});
}

// Cuts a triangle at its marks.
template <class Cut, class Face>
constexpr bool cut_at_marks(Cut& c, Face& f, std::span<const typename Cut::mark> marks) {
  f.points.clear();
  for (const auto& m : marks)
    if (m.from == m.to && m.from_place >= 3) f.points.push_back({m.from, m.from_place});
  std::sort(f.points.begin(), f.points.end(), [](const auto& p, const auto& q) { return p.v < q.v; });
  f.points.erase(std::unique(f.points.begin(), f.points.end(), [](const auto& p, const auto& q) { return p.v == q.v; }),
                 f.points.end());
  const std::uint32_t t = marks[0].triangle;
  if (!begin_triangulation(f, see_triangle(c.bodies.positions, c.bodies.triangles[t], t))) return false;
  for (const auto& m : marks)
    if (m.from != m.to && !insert_constraint(f, m.from, m.to, m.by)) return false;
  const auto first = static_cast<std::uint32_t>(c.triangles.size()), n = static_cast<std::uint32_t>(f.pieces.size());
  for (std::uint32_t p = 0; p < n; ++p) {
    const auto& v = f.pieces[p].v;
    c.triangles.push_back({{f.local[v[0]], f.local[v[1]], f.local[v[2]]}, t, first + p});
  }
  for (std::uint32_t p = 0; p < n; ++p)
    for (int k = 0; k < 3; ++k) end_side(c, f, first, p, k);
  return true;
}

template <class Cut>
constexpr bool cut_faces(Cut& c) {
  const std::size_t n = c.bodies.triangles.size();
  c.triangles.reserve(n + 3 * c.marks.size());
  c.only_piece.assign(n, no_index);
  face_triangulation<decltype(c.vertices)> face{c.vertices};
  std::size_t next = 0;
  for (std::uint32_t t = 0; t < n; ++t) {
    const std::size_t begin = next;
    while (next < c.marks.size() && c.marks[next].triangle == t) ++next;
    if (begin == next) {
      const auto& v = c.bodies.triangles[t].v;
      c.only_piece[t] = static_cast<std::uint32_t>(c.triangles.size());
      c.triangles.push_back({{v[0], v[1], v[2]}, t, c.only_piece[t]});
    } else if (!cut_at_marks(c, face, {c.marks.data() + begin, next - begin})) {
      return false;
    }
  }
  return true;
}

// Joins triangles that are not cut with their neighbours, and what lies along sides of triangles: two pieces of the
// same body each.
template <class Cut>
constexpr bool join_parts(Cut& c) {
  for (std::uint32_t t = 0; t < c.bodies.triangles.size(); ++t) {
    const std::uint32_t piece = c.only_piece[t];
    if (piece == no_index) continue;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t twin = c.bodies.twin[3 * std::size_t{t} + k];
      if (twin == no_index) continue;
      const std::uint32_t other = c.only_piece[twin / 3];
      const auto& v = c.triangles[piece].v;
      if (other == no_index)
        c.sides.push_back({minimum(v[k], v[(k + 1) % 3]), maximum(v[k], v[(k + 1) % 3]), piece});
      else if (other < piece)
        c.join(piece, other);
    }
  }
  std::sort(c.sides.begin(), c.sides.end());
  for (std::size_t i = 0; i < c.sides.size(); i += 2) {  // those of an edge and of a body stand together
    if (i + 1 == c.sides.size()) return false;
    const triangle_side &s = c.sides[i], &t = c.sides[i + 1];
    if (s.low != t.low || s.high != t.high || c.body_of(s.triangle) != c.body_of(t.triangle)) return false;
    c.join(s.triangle, t.triangle);
  }
  for (std::uint32_t t = 0; t < c.triangles.size(); ++t) c.triangles[t].part = c.part_of(t);
  return true;
}

// Where three triangles meet, each of them was cut by itself.
template <class Cut>
constexpr void merge_crossings(Cut& c) {
  std::vector<std::uint32_t> made;
  for (std::uint32_t v = c.vertices.corners; v < c.vertices.at.size(); ++v) made.push_back(v);
  const auto same = c.vertices.merge(std::move(made));
  for (cut_triangle& t : c.triangles)
    for (std::uint32_t& v : t.v) v = same[v];
  for (auto& [from, to, triangle] : c.cuts) {
    from = same[from];
    to = same[to];
  }
  c.is_seam.assign(same.size(), 0);
  std::fill(c.is_seam.begin() + c.vertices.corners, c.is_seam.end(), static_cast<unsigned char>(1));
}

// Asks for a point that is on no body but those that are known. count(t, crossings): as count_upward_crossing, for the
// triangles that may stand over p, or over a point within `slack` of it.
template <class Cut, class Count>
constexpr bool place_point(Cut& c, const point<double, 3>& p, double slack, part_sides& sides, const Count& count) {
  bool is_placed = true;
  for (std::uint32_t body = 0; body < sides.is_known.size(); ++body) {
    if (sides.is_known[body] != 0) continue;
    upward_crossings found;
    each_above(c.boxes, body, p, slack, [&](std::uint32_t t) { count(c.bodies.triangles[t], found); });
    const bool is_body = found.winding == 0 || found.winding == 1;
    if (!is_body && !found.on_surface && c.culprit == no_index) c.culprit = body;
    is_placed = is_placed && is_body && !found.on_surface;
    sides.below[body] = sides.above[body] = found.winding > 0 ? 1 : 0;
  }
  return is_placed;
}

template <class Cut>
constexpr bool place_corner(Cut& c, std::uint32_t v, part_sides& sides) {
  const auto& at = c.bodies.positions;
  return place_point(c, at[v], 0.0, sides, [&](const triangle_indices& t, upward_crossings& count) {
    count_upward_crossing(at[t.v[0]], at[t.v[1]], at[t.v[2]], at[v], count);
  });
}

// By the middle of a piece, which is no double. Where the piece lies on one of an earlier body, which stands for both,
// its own two sides are made alike, so that it bounds nothing.
template <class Cut>
constexpr bool place_piece(Cut& c, std::uint32_t piece, part_sides& sides) {
  using exact = typename Cut::exact_type;
  const body_triangles& b = c.bodies;
  const cut_triangle& t = c.triangles[piece];
  const exact p = c.vertices.exact(t.v[0]), q = c.vertices.exact(t.v[1]), r = c.vertices.exact(t.v[2]);
  const exact middle = exact::mean_of(p, q, r);
  const near_point<exact> at{middle};
  auto pair = std::lower_bound(c.coplanar.begin(), c.coplanar.end(), typename Cut::coplanar_pair{t.source, 0});
  for (; pair != c.coplanar.end() && pair->triangle == t.source; ++pair) {
    const std::uint32_t body = b.body[pair->other];
    const int turn = turn_of_cover(b.positions, b.triangles[t.source], b.triangles[pair->other], at);
    if (turn == 0) continue;
    if (body < b.body[t.source]) {
      sides.above = sides.below;
      return true;
    }
    sides.is_known[body] = 1;
    (turn > 0 ? sides.below : sides.above)[body] = 1;
  }
  return place_point(c, at.rounded, at.slack(), sides, [&](const triangle_indices& other, upward_crossings& count) {
    count_exact_crossing(b.positions, other, at, count);
  });
}

// Asks for one triangle of each part where it lies; a corner that does not touch another body answers at once.
template <class Cut, class IsIn>
constexpr bool place_parts(Cut& c, const IsIn& is_in) {
  c.directions.assign(c.triangles.size(), 0);
  std::vector<std::uint32_t> corner(c.triangles.size(), no_index);
  for (const cut_triangle& t : c.triangles)
    if (corner[t.part] == no_index)
      for (const std::uint32_t v : t.v)
        if (v < c.vertices.corners && c.is_touched[v] == 0) corner[t.part] = v;
  part_sides sides;
  for (std::uint32_t t = 0; t < c.triangles.size(); ++t) {
    if (const std::uint32_t part = c.triangles[t].part; part != t) {
      c.directions[t] = c.directions[part];  // the first of a part stands before
      continue;
    }
    for (auto* list : {&sides.below, &sides.above, &sides.is_known}) list->assign(c.bodies.ends.size(), 0);
    sides.below[c.body_of(t)] = sides.is_known[c.body_of(t)] = 1;
    if (!(corner[t] != no_index ? place_corner(c, corner[t], sides) : place_piece(c, t, sides))) return false;
    const bool below = is_in(sides.below);
    if (below != is_in(sides.above)) c.directions[t] = below ? 1 : -1;
  }
  return true;
}

/// Cuts the bodies at each other and places the parts.
/// needs   is_in(v): whether what is inside of the bodies b with v[b] != 0 alone is in the combination
template <class Cut, class IsIn>
constexpr bool arrange_bodies(Cut& c, const IsIn& is_in) {
  c.vertices.at = c.bodies.positions;
  c.vertices.corners = static_cast<std::uint32_t>(c.bodies.positions.size());
  c.vertices.triangles = &c.bodies.triangles;
  if (!find_contacts(c)) return false;
  name_contacts(c);
  if (!cut_faces(c) || !join_parts(c)) return false;
  if (c.are_many()) merge_crossings(c);
  return place_parts(c, is_in);
}

}  // namespace IRG_ABI
}  // namespace irg::detail
