// SPDX-License-Identifier: MIT
// Bodies cut at each other: the triangles that they meet in are replaced by pieces, all pieces fall into parts that no
// cut runs through, and each part is inside of every other body, outside, or on its surface. What lies in which bodies
// on either side of a part tells whether it bounds a combination of them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <irg/solid/detail/body_triangles.hpp>
#include <irg/solid/detail/exact_crossings.hpp>
#include <irg/solid/detail/face_cutter.hpp>
#include <irg/solid/point_in_solid.hpp>

namespace irg::detail {

/// Which bodies what lies close to a part is inside of: 0 or 1 for each.
struct part_sides {
  std::vector<unsigned char> below, above;
};

/// A triangle of the result before any is left out.
struct cut_triangle {
  std::uint32_t v[3];
  std::uint32_t source;  // of body_triangles
  std::uint32_t part;
};

inline namespace IRG_ABI {

template <class Bodies, class Exact = exact_point>
class body_cutter {
public:
  exact_vertices<Exact> vertices;
  std::vector<cut_triangle> triangles;  // those of one body after another
  std::vector<signed char> directions;  // of each triangle: 1 where it bounds the combination, -1 where turned, or 0
  std::vector<std::array<std::uint32_t, 3>> cuts;  // edges at which parts end: from, to, the triangle
  std::vector<unsigned char> is_seam;  // of each vertex, whether it may lie within a plane face or a straight edge
  bool failed = false;  // the bodies cut themselves, or are not turned outward
  std::uint32_t culprit = no_index;  // the body that is to blame, where a look at what failed tells it
  std::uint64_t met = 0;  // pairs of triangles whose boxes meet

  /// needs   is_in(v): whether what is inside of the bodies b with v[b] != 0 alone is in the combination
  template <class IsIn>
  constexpr body_cutter(const Bodies& b, const IsIn& is_in) : b_(b), cutter_(vertices) {
    vertices.at = b.positions;
    vertices.corners = static_cast<std::uint32_t>(b.positions.size());
    vertices.triangles = &b.triangles;
    find_contacts();
    if (!failed) name_contacts();
    if (!failed) cut_all();
    if (!failed) place_parts(is_in);
  }

private:
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
  struct border_side {
    std::uint32_t low, high, triangle;
    constexpr auto operator<=>(const border_side&) const = default;
  };

  constexpr void find_contacts() {
    boxes_.reserve(b_.triangles.size());
    for (const triangle_indices& t : b_.triangles) {
      space_box box = no_box();
      for (const std::uint32_t v : t.v) box.add(b_.positions[v]);
      boxes_.push_back(box);
    }
    const std::size_t bodies = b_.ends.size();
    std::vector<std::vector<std::uint32_t>> lots(bodies);
    body_boxes_.assign(bodies, no_box());
    for (std::uint32_t i = 0; i < bodies; ++i) {
      lots[i].resize(b_.ends[i] - b_.first_of(i), 0);
      for (std::uint32_t t = b_.first_of(i); t < b_.ends[i]; ++t) {
        lots[i][t - b_.first_of(i)] = t;
        body_boxes_[i].add(boxes_[t]);
      }
    }
    for (const std::vector<std::uint32_t>& lot : lots) trees_.emplace_back(lot, 2);  // seen from above
    const auto use = [this](std::uint32_t s, std::uint32_t t) { ++met, add_contacts(s, t); };
    for (std::size_t i = 0; i < bodies; ++i)
      for (std::size_t k = i + 1; k < bodies; ++k)
        if (body_boxes_[i].meets(body_boxes_[k])) box_pair_search<decltype(use)>(boxes_, use).search(lots[i], lots[k]);
  }

  constexpr void add_contacts(std::uint32_t s, std::uint32_t t) {
    const auto a = see_triangle(b_.positions, b_.triangles[s], s), b = see_triangle(b_.positions, b_.triangles[t], t);
    if (a.turn == 0 || b.turn == 0) {
      failed = true;
      culprit = b_.body[a.turn == 0 ? s : t];
      return;
    }
    const contact_finder found(a, b);
    const auto first = static_cast<std::uint32_t>(keys_.size());
    for (int i = 0; i < found.count; ++i) {
      keys_.push_back(found.contacts[i].key);
      seams_.push_back(is_of_seam(found.contacts[i], s, t) ? 1 : 0);
    }
    const auto add = [&](int i, int k, int which, int side) {
      const triangle_contact &p = found.contacts[i], &q = found.contacts[k];
      const auto from = first + static_cast<std::uint32_t>(i), to = first + static_cast<std::uint32_t>(k);
      cut_maker on_s{{t, no_index}, b_.body[t]}, on_t{{s, no_index}, b_.body[s]};
      if (side < 3) {
        const seen_triangle& of = which == 0 ? a : b;
        on_s = on_t = {{of.v[side], of.v[(side + 1) % 3]}, b_.body[which == 0 ? s : t]};
      }
      marks_.push_back({s, from, to, p.at[0], q.at[0], on_s});
      marks_.push_back({t, from, to, p.at[1], q.at[1], on_t});
    };
    for (int i = 0; i < found.count; ++i) add(i, i, 0, 3);
    found.each_segment(add);
    if (!found.are_coplanar || found.count < 3) return;
    coplanar_.push_back({s, t});
    coplanar_.push_back({t, s});
  }

  // Whether side k of a triangle lies within a plane face.
  constexpr bool is_level_side(std::uint32_t t, std::uint8_t at) const noexcept {
    const std::uint32_t twin = b_.twin[3 * std::size_t{t} + at - 3];
    return twin != no_index && are_level(b_, t, twin / 3);
  }
  constexpr bool is_of_seam(const triangle_contact& c, std::uint32_t s, std::uint32_t t) const noexcept {
    if (c.key.v[1] == no_index) return false;
    const bool first = c.at[0] != inside_triangle && is_level_side(s, c.at[0]);
    const bool second = c.at[1] != inside_triangle && is_level_side(t, c.at[1]);
    if (c.at[0] == inside_triangle) return second;
    if (c.at[1] == inside_triangle) return first;
    if (first == second) return first;
    // A true edge and a seam: a corner only where the edge goes through the plane.
    const triangle_indices &plane = b_.triangles[first ? s : t], &edge = b_.triangles[first ? t : s];
    const int k = c.at[first ? 1 : 0] - 3;
    const auto side = [&](std::uint32_t v) {
      return orient3d(b_.positions[plane.v[0]], b_.positions[plane.v[1]], b_.positions[plane.v[2]], b_.positions[v]);
    };
    return side(edge.v[k]) == 0 && side(edge.v[(k + 1) % 3]) == 0;
  }

  // Each key once, and a vertex for it.
  constexpr void name_contacts() {
    std::vector<contact_key> sorted = keys_;
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    std::vector<std::uint32_t> vertex;
    vertex.reserve(sorted.size());
    touched_.assign(b_.positions.size(), 0);
    for (const contact_key& key : sorted) {
      if (key.v[1] == no_index) touched_[key.v[0]] = 1;
      vertex.push_back(key.v[1] == no_index ? key.v[0] : vertices.add(key));
    }
    const bool are_many = b_.ends.size() > 2;
    std::vector<std::uint32_t> same(vertices.at.size(), 0);
    for (std::uint32_t v = 0; v < same.size(); ++v) same[v] = v;
    if (are_many) {  // places of three bodies have several names
      std::vector<std::uint32_t> some = vertex;
      vertices.merge(some, same);
    }
    const auto named = [&](std::uint32_t i) {
      return same[vertex[static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), keys_[i]) -
                                                  sorted.begin())]];
    };
    is_seam.assign(vertices.at.size(), 0);
    for (std::uint32_t i = 0; i < keys_.size(); ++i)
      if (seams_[i] != 0) is_seam[named(i)] = 1;
    for (mark& m : marks_) m.from = named(m.from), m.to = named(m.to);
    std::sort(marks_.begin(), marks_.end());
    marks_.erase(std::unique(marks_.begin(), marks_.end()), marks_.end());
    std::sort(coplanar_.begin(), coplanar_.end());
  }

  constexpr void cut_all() {
    triangles.reserve(b_.triangles.size() + 3 * marks_.size());
    piece_of_.assign(b_.triangles.size(), no_index);
    std::size_t next = 0;
    for (std::uint32_t t = 0; t < b_.triangles.size() && !failed; ++t) {
      const auto first = static_cast<std::uint32_t>(triangles.size());
      if (next == marks_.size() || marks_[next].triangle != t) {
        const triangle_indices& n = b_.triangles[t];
        piece_of_[t] = first;
        triangles.push_back({{n.v[0], n.v[1], n.v[2]}, t, first});
        continue;
      }
      const std::size_t begin = next;
      while (next < marks_.size() && marks_[next].triangle == t) ++next;
      cut_one(t, begin, next);
    }
    if (!failed) join_parts();
    if (!failed && b_.ends.size() > 2) merge_crossings();
  }

  // Where three triangles meet, each of them was cut by itself.
  constexpr void merge_crossings() {
    std::vector<std::uint32_t> made, same(vertices.at.size(), 0);
    for (std::uint32_t v = 0; v < same.size(); ++v) {
      same[v] = v;
      if (v >= vertices.corners) made.push_back(v);
    }
    vertices.merge(made, same);
    for (cut_triangle& t : triangles)
      for (std::uint32_t& v : t.v) v = same[v];
    for (auto& [from, to, triangle] : cuts) from = same[from], to = same[to];
    is_seam.assign(same.size(), 0);
    std::fill(is_seam.begin() + vertices.corners, is_seam.end(), static_cast<unsigned char>(1));
  }

  constexpr void cut_one(std::uint32_t t, std::size_t begin, std::size_t end) {
    points_.clear();
    for (std::size_t i = begin; i < end; ++i) {
      const mark& m = marks_[i];
      if (m.from == m.to && m.from_place >= 3) points_.push_back({m.from, m.from_place});
    }
    std::sort(points_.begin(), points_.end(), [](const placed_vertex& p, const placed_vertex& q) { return p.v < q.v; });
    points_.erase(std::unique(points_.begin(), points_.end(),
                              [](const placed_vertex& p, const placed_vertex& q) { return p.v == q.v; }),
                  points_.end());
    cutter_.begin(see_triangle(b_.positions, b_.triangles[t], t), points_);
    for (std::size_t i = begin; i < end; ++i)
      if (marks_[i].from != marks_[i].to) cutter_.cut(marks_[i].from, marks_[i].to, marks_[i].by);
    failed = failed || cutter_.failed;
    if (failed) return;
    const auto first = static_cast<std::uint32_t>(triangles.size());
    for (std::uint32_t p = 0; p < cutter_.pieces.size(); ++p) {
      const face_piece& piece = cutter_.pieces[p];
      triangles.push_back(
          {{cutter_.vertex(piece.v[0]), cutter_.vertex(piece.v[1]), cutter_.vertex(piece.v[2])}, t, first + p});
    }
    for (std::uint32_t p = 0; p < cutter_.pieces.size(); ++p)
      for (int k = 0; k < 3; ++k) end_side(t, first, p, k);
  }

  // What lies beyond side k of a piece: nothing that belongs to its part, another piece, or another triangle.
  constexpr void end_side(std::uint32_t t, std::uint32_t first, std::uint32_t p, int k) {
    const face_piece& piece = cutter_.pieces[p];
    const std::uint32_t from = piece.v[k], to = piece.v[(k + 1) % 3];
    const std::uint32_t u = cutter_.vertex(from), v = cutter_.vertex(to);
    if (piece.fixed[k] != no_index) {
      cuts.push_back({u, v, first + p});
    } else if (piece.beside[k] != no_index) {
      join(first + p, first + piece.beside[k]);
    } else if (b_.twin[3 * std::size_t{t} + static_cast<std::size_t>(cutter_.rim_of(from, to))] != no_index) {
      sides_.push_back({lesser(u, v), greater(u, v), first + p});
    }
  }

  constexpr std::uint32_t part_of(std::uint32_t t) noexcept {
    while (triangles[t].part != t) t = triangles[t].part = triangles[triangles[t].part].part;
    return t;
  }
  constexpr void join(std::uint32_t s, std::uint32_t t) noexcept {
    s = part_of(s), t = part_of(t);
    triangles[greater(s, t)].part = lesser(s, t);
  }

  constexpr void join_parts() {
    for (std::uint32_t t = 0; t < b_.triangles.size(); ++t) {
      if (piece_of_[t] == no_index) continue;
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t twin = b_.twin[3 * std::size_t{t} + k];
        if (twin == no_index) continue;
        const std::uint32_t other = piece_of_[twin / 3];
        if (other != no_index) {
          if (other < piece_of_[t]) join(piece_of_[t], other);
        } else {
          const std::uint32_t u = b_.triangles[t].v[k], v = b_.triangles[t].v[(k + 1) % 3];
          sides_.push_back({lesser(u, v), greater(u, v), piece_of_[t]});
        }
      }
    }
    // Sides of pieces along sides of triangles: two of the same body each.
    std::sort(sides_.begin(), sides_.end());
    for (std::size_t i = 0, next = 0; i < sides_.size(); i = next) {
      while (next < sides_.size() && sides_[next].low == sides_[i].low && sides_[next].high == sides_[i].high) ++next;
      for (std::size_t k = i; k < next;) {  // those of a body stand together
        const std::uint32_t body = body_of(sides_[k].triangle);
        if (k + 1 == next || body_of(sides_[k + 1].triangle) != body) {
          failed = true;
          return;
        }
        join(sides_[k].triangle, sides_[k + 1].triangle);
        k += 2;
      }
    }
    for (std::uint32_t t = 0; t < triangles.size(); ++t) triangles[t].part = part_of(t);
  }
  constexpr std::uint32_t body_of(std::uint32_t t) const noexcept { return b_.body[triangles[t].source]; }

  // Asks for one triangle of each part where it lies; a corner that does not touch another body answers at once.
  template <class IsIn>
  constexpr void place_parts(const IsIn& is_in) {
    directions.assign(triangles.size(), 0);
    std::vector<std::uint32_t> corner(triangles.size(), no_index);
    for (const cut_triangle& t : triangles)
      if (corner[t.part] == no_index)
        for (const std::uint32_t v : t.v)
          if (v < vertices.corners && touched_[v] == 0) corner[t.part] = v;
    part_sides sides;
    for (std::uint32_t t = 0; t < triangles.size() && !failed; ++t) {
      if (const std::uint32_t part = triangles[t].part; part != t) {
        directions[t] = directions[part];  // the first of a part stands before
        continue;
      }
      sides.below.assign(b_.ends.size(), 0), sides.above.assign(b_.ends.size(), 0);
      sides.below[body_of(t)] = 1;
      if (corner[t] != no_index)
        place_corner(body_of(t), corner[t], sides);
      else if (!place_piece(t, sides))
        continue;
      const bool below = is_in(sides.below);
      if (below != is_in(sides.above)) directions[t] = below ? 1 : -1;
    }
  }

  constexpr bool is_in_winding(std::uint32_t body, const upward_crossings& count) {
    const bool is_none = count.winding < 0 || count.winding > 1;
    if (is_none && !count.on_surface && culprit == no_index) culprit = body;
    failed = failed || count.on_surface || is_none;
    return count.winding > 0;
  }

  template <class Use>
  constexpr void each_above(const point<double, 3>& p, double slack, std::uint32_t body, const Use& use) {
    const auto is_off = [&](const space_box& box) {
      return p.x + slack < box.low[0] || box.high[0] < p.x - slack || p.y + slack < box.low[1] ||
             box.high[1] < p.y - slack || box.high[2] < p.z - slack;
    };
    if (is_off(body_boxes_[body])) return;
    trees_[body].each(boxes_, is_off, [&](std::uint32_t t) { use(b_.triangles[t]); });
  }

  constexpr void place_corner(std::uint32_t own, std::uint32_t v, part_sides& sides) {
    const point<double, 3>& p = b_.positions[v];
    for (std::uint32_t body = 0; body < b_.ends.size(); ++body) {
      if (body == own) continue;
      upward_crossings count;
      each_above(p, 0.0, body, [&](const triangle_indices& t) {
        count_upward_crossing(b_.positions[t.v[0]], b_.positions[t.v[1]], b_.positions[t.v[2]], p, count);
      });
      if (is_in_winding(body, count)) sides.below[body] = sides.above[body] = 1;
    }
  }

  // By the middle of a piece, which is no double. False where the piece lies on one of an earlier body, which stands
  // for both.
  constexpr bool place_piece(std::uint32_t piece, part_sides& sides) {
    const cut_triangle& t = triangles[piece];
    const std::uint32_t own = b_.body[t.source];
    const Exact a = vertices.exact(t.v[0]), b = vertices.exact(t.v[1]), c = vertices.exact(t.v[2]);
    const Exact middle = Exact::mean_of(a, b, c);
    const near_point<Exact> at{middle, middle.rounded()};
    std::vector<unsigned char> is_on(b_.ends.size(), 0);
    auto pair = std::lower_bound(coplanar_.begin(), coplanar_.end(), coplanar_pair{t.source, 0});
    for (; pair != coplanar_.end() && pair->triangle == t.source; ++pair) {
      const std::uint32_t body = b_.body[pair->other];
      const int turn = turn_of_cover(b_.positions, b_.triangles[t.source], b_.triangles[pair->other], at);
      if (turn == 0) continue;
      if (body < own) return false;
      is_on[body] = 1;
      (turn > 0 ? sides.below : sides.above)[body] = 1;
    }
    const point<double, 3>& nearby = at.rounded;
    const double slack =
        greater(greater(magnitude(nearby.x), magnitude(nearby.y)), magnitude(nearby.z)) * 0x1p-50 + 0x1p-1000;
    for (std::uint32_t body = 0; body < b_.ends.size(); ++body) {
      if (body == own || is_on[body] != 0) continue;
      upward_crossings count;
      each_above(nearby, slack, body,
                 [&](const triangle_indices& other) { count_exact_crossing(b_.positions, other, at, count); });
      if (is_in_winding(body, count)) sides.below[body] = sides.above[body] = 1;
    }
    return true;
  }

  const Bodies& b_;
  face_cutter<exact_vertices<Exact>> cutter_;
  std::vector<space_box> boxes_, body_boxes_;
  std::vector<box_tree> trees_;  // of each body
  std::vector<contact_key> keys_;
  std::vector<unsigned char> seams_;
  std::vector<mark> marks_;
  std::vector<coplanar_pair> coplanar_;
  std::vector<unsigned char> touched_;
  std::vector<std::uint32_t> piece_of_;  // the only piece of a triangle that is not cut
  std::vector<border_side> sides_;
  std::vector<placed_vertex> points_;
};

}  // namespace IRG_ABI
}  // namespace irg::detail
