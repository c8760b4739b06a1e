// SPDX-License-Identifier: MIT
// The constrained triangulation of one triangle by the segments at which other bodies meet it: points go in one after
// the other, and edges that cross a segment are flipped until it is one; where segments of two bodies cross, there is a
// new point. Every decision is a sign of exact_vertices. A step that finds what should not meet to meet gives false, or
// no_index.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <irg/solid/detail/exact_vertices.hpp>

namespace irg::detail {

/// What a cut is made by: a triangle, or a side by its ends, of a body.
struct cut_maker {
  std::uint32_t v[2] = {no_index, no_index}, body = no_index;
  constexpr auto operator<=>(const cut_maker&) const = default;
};

/// A piece of a triangle.
/// shape   side k goes from v[k] to the next; beyond it lies piece beside[k]; it is a cut where fixed[k] tells by what
struct face_piece {
  std::uint32_t v[3];
  std::uint32_t beside[3] = {no_index, no_index, no_index};
  std::uint32_t fixed[3] = {no_index, no_index, no_index};
};

/// A point on a triangle, and where on it: 0 to 6, see contact places.
struct placed_vertex {
  std::uint32_t v;
  std::uint8_t place;
};

inline namespace IRG_ABI {

/// A triangle and what it is cut into. Pieces name their corners by places in `local`.
template <class Vertices>
struct face_triangulation {
  struct edge {
    std::uint32_t from, to;
  };

  Vertices& vertices;
  int axis = 0, turn = 1;  // along which the triangle is seen, and how it runs then
  std::uint32_t number = 0;  // of the triangle
  std::vector<placed_vertex> points{};  // on it, in any order, each once
  std::vector<face_piece> pieces{};
  std::vector<std::uint32_t> local{}, piece_of{};  // the vertex that a corner is; one of the pieces that have it
  std::vector<std::uint8_t> rims{};  // of each corner, bit k where it lies on side k of the triangle
  std::vector<cut_maker> makers{};  // of the cuts, the newest last
  std::vector<std::uint32_t> along{};  // the points on one side
  std::vector<edge> crossed{};  // edges that a segment crosses

  constexpr std::uint32_t add_corner(std::uint32_t v, unsigned on_rims) {
    local.push_back(v);
    rims.push_back(static_cast<std::uint8_t>(on_rims));
    piece_of.push_back(0);
    return static_cast<std::uint32_t>(local.size() - 1);
  }
  constexpr std::uint32_t corner_of(std::uint32_t v) const noexcept {
    const auto at = std::find(local.begin(), local.end(), v);
    return at == local.end() ? no_index : static_cast<std::uint32_t>(at - local.begin());
  }
  /// The side of the triangle that an edge of a piece lies on; 3 when none.
  constexpr int rim_of(std::uint32_t l, std::uint32_t m) const noexcept {
    const int common = rims[l] & rims[m];
    return common == 0 ? 3 : common == 1 ? 0 : common == 2 ? 1 : 2;
  }
  constexpr int turn_of(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    if ((rims[a] & rims[b] & rims[c]) != 0) return 0;
    return vertices.turn(local[a], local[b], local[c], axis) * turn;
  }
  // On which side of the way from `at` to `end` a corner lies: 0 for an end.
  constexpr int side_of_way(std::uint32_t at, std::uint32_t end, std::uint32_t l) const {
    return l == at || l == end ? 0 : turn_of(at, end, l);
  }
  constexpr void remember(std::uint32_t piece) noexcept {
    for (const std::uint32_t l : pieces[piece].v) piece_of[l] = piece;
  }
  constexpr void replace_neighbour(std::uint32_t piece, std::uint32_t before, std::uint32_t after) noexcept {
    if (piece == no_index) return;
    auto& beside = pieces[piece].beside;
    if (auto* const at = std::find(beside, beside + 3, before); at != beside + 3) *at = after;
  }
};

// The pieces round a corner, one after the other; no_index behind the last.
struct piece_walk {
  std::uint32_t l, first, at = first;
  bool is_back = false;
};

constexpr int side_from(const face_piece& t, std::uint32_t l) noexcept { return t.v[0] == l ? 0 : t.v[1] == l ? 1 : 2; }

template <class Face>
constexpr void go_round(const Face& f, piece_walk& w) noexcept {
  const int k = side_from(f.pieces[w.at], w.l);
  w.at = f.pieces[w.at].beside[w.is_back ? k : (k + 2) % 3];
  if (w.is_back || (w.at != no_index && w.at != w.first)) return;
  w.is_back = true;
  w.at = w.at == w.first ? no_index : f.pieces[w.first].beside[side_from(f.pieces[w.first], w.l)];
}

// The piece that has a side from a to b; sought round both, since one of them may have many.
template <class Face>
constexpr std::uint32_t piece_with(const Face& f, std::uint32_t a, std::uint32_t b) noexcept {
  piece_walk x{a, f.piece_of[a]}, y{b, f.piece_of[b]};
  while (x.at != no_index) {
    const face_piece& one = f.pieces[x.at];
    if (one.v[(side_from(one, a) + 1) % 3] == b) return x.at;
    go_round(f, x);
    if (y.at == no_index) continue;
    const face_piece& other = f.pieces[y.at];
    const int k = side_from(other, b);
    if (other.v[(k + 1) % 3] == a && other.beside[k] != no_index) return other.beside[k];
    go_round(f, y);
  }
  return no_index;
}

// Divides a piece at a point of its side k: it keeps the first half of that side, as its side 0; a new piece, which is
// given back, has the second, as its side 0.
template <class Face>
constexpr std::uint32_t halve_piece(Face& f, std::uint32_t piece, int k, std::uint32_t p) {
  const face_piece t = f.pieces[piece];
  const int l = (k + 1) % 3, m = (k + 2) % 3;
  const auto half = static_cast<std::uint32_t>(f.pieces.size());
  f.pieces[piece] = {{t.v[k], p, t.v[m]}, {no_index, half, t.beside[m]}, {t.fixed[k], no_index, t.fixed[m]}};
  f.pieces.push_back({{p, t.v[l], t.v[m]}, {no_index, t.beside[l], piece}, {t.fixed[k], t.fixed[l], no_index}});
  f.replace_neighbour(t.beside[l], piece, half);
  f.remember(piece);
  f.remember(half);
  return half;
}
// Puts p on side k of a piece, and of the one beyond.
template <class Face>
constexpr void split_side(Face& f, std::uint32_t piece, int k, std::uint32_t p) {
  const std::uint32_t beyond = f.pieces[piece].beside[k];
  const std::uint32_t half = halve_piece(f, piece, k, p);
  if (beyond == no_index) return;
  int j = 0;
  while (f.pieces[beyond].beside[j] != piece) ++j;
  const std::uint32_t other = halve_piece(f, beyond, j, p);
  // piece has the near end of the side, beyond the far one.
  f.pieces[piece].beside[0] = other;
  f.pieces[other].beside[0] = piece;
  f.pieces[half].beside[0] = beyond;
  f.pieces[beyond].beside[0] = half;
}
// Puts p inside a piece, which becomes three.
template <class Face>
constexpr void split_piece(Face& f, std::uint32_t piece, std::uint32_t p) {
  const face_piece t = f.pieces[piece];
  const auto a = static_cast<std::uint32_t>(f.pieces.size()), b = a + 1;
  f.pieces[piece] = {{t.v[0], t.v[1], p}, {t.beside[0], a, b}, {t.fixed[0], no_index, no_index}};
  f.pieces.push_back({{t.v[1], t.v[2], p}, {t.beside[1], b, piece}, {t.fixed[1], no_index, no_index}});
  f.pieces.push_back({{t.v[2], t.v[0], p}, {t.beside[2], piece, a}, {t.fixed[2], no_index, no_index}});
  f.replace_neighbour(t.beside[1], piece, a);
  f.replace_neighbour(t.beside[2], piece, b);
  for (const std::uint32_t i : {piece, a, b}) f.remember(i);
}
// The edge from a to b, of piece `one` and back of `other`, becomes the other diagonal.
template <class Face>
constexpr void flip_edge(Face& f, std::uint32_t one, std::uint32_t other, std::uint32_t a, std::uint32_t b) {
  const face_piece s = f.pieces[one], t = f.pieces[other];
  const int k = side_from(s, a), j = side_from(t, b);
  const int s_next = (k + 1) % 3, s_last = (k + 2) % 3, t_next = (j + 1) % 3, t_last = (j + 2) % 3;
  const std::uint32_t x = s.v[s_last], y = t.v[t_last];
  f.pieces[one] = {
      {x, a, y}, {s.beside[s_last], t.beside[t_next], other}, {s.fixed[s_last], t.fixed[t_next], no_index}};
  f.pieces[other] = {
      {y, b, x}, {t.beside[t_last], s.beside[s_next], one}, {t.fixed[t_last], s.fixed[s_next], no_index}};
  f.replace_neighbour(t.beside[t_next], other, one);
  f.replace_neighbour(s.beside[s_next], one, other);
  f.remember(one);
  f.remember(other);
}

// Cuts side k at its points, which come into order along it first.
template <class Face>
constexpr bool insert_on_side(Face& f, int k) {
  f.along.clear();
  for (const placed_vertex& p : f.points)
    if (p.place == 3 + k) f.along.push_back(p.v);
  if (f.along.empty()) return true;
  auto last = static_cast<std::uint32_t>(k);
  const std::uint32_t end = (last + 1) % 3, from = f.local[last], to = f.local[end];
  int axis = 0;
  const auto &a = f.vertices.at[from], &b = f.vertices.at[to];
  for (int i = 1; i < 3; ++i)
    if (magnitude(b[i] - a[i]) > magnitude(b[axis] - a[axis])) axis = i;
  const int way = f.vertices.compare(from, to, axis);
  std::sort(f.along.begin(), f.along.end(),
            [&](std::uint32_t u, std::uint32_t v) { return f.vertices.compare(u, v, axis) == way; });
  for (const std::uint32_t v : f.along) {
    const std::uint32_t piece = piece_with(f, last, end);
    if (piece == no_index) return false;
    const std::uint32_t p = f.add_corner(v, 1u << k);
    split_side(f, piece, side_from(f.pieces[piece], last), p);
    last = p;
  }
  return true;
}

// Puts a point in the piece that has it, found by a walk from the newest one.
template <class Face>
constexpr bool insert_point(Face& f, std::uint32_t v) {
  const std::uint32_t p = f.add_corner(v, 0);
  auto at = static_cast<std::uint32_t>(f.pieces.size() - 1);
  const std::size_t limit = 4 * f.pieces.size() + 16;
  for (std::size_t steps = 0; steps < limit + f.pieces.size(); ++steps) {
    if (steps >= limit) at = static_cast<std::uint32_t>(steps - limit);  // the walk went in circles: one by one
    int zeros = 0, zero = 0, out = 3;
    for (int k = 0; k < 3 && out == 3; ++k) {
      const int sign = f.turn_of(f.pieces[at].v[k], f.pieces[at].v[(k + 1) % 3], p);
      if (sign < 0) out = k;
      if (sign != 0) continue;
      ++zeros;
      zero = k;
    }
    if (out != 3) {
      at = f.pieces[at].beside[out] == no_index ? at : f.pieces[at].beside[out];
      continue;
    }
    if (zeros == 0) split_piece(f, at, p);
    if (zeros == 1) split_side(f, at, zero, p);
    return zeros < 2;
  }
  return false;
}

/// Begins with a triangle, of which `points` are set.
template <class Face>
constexpr bool begin_triangulation(Face& f, const seen_triangle& t) {
  f.axis = t.axis;
  f.turn = t.turn;
  f.number = t.number;
  f.local.clear();
  f.piece_of.clear();
  f.rims.clear();
  f.makers.clear();
  for (int k = 0; k < 3; ++k) f.add_corner(t.v[k], 1u << k | 1u << (k + 2) % 3);
  f.pieces.assign(1, face_piece{{0, 1, 2}});
  f.remember(0);
  for (int k = 0; k < 3; ++k)
    if (!insert_on_side(f, k)) return false;
  for (const placed_vertex& p : f.points)
    if (p.place == inside_triangle && !insert_point(f, p.v)) return false;
  return true;
}

// Makes side k of a piece a cut by the newest maker.
template <class Face>
constexpr void fix_side(Face& f, std::uint32_t piece, int k) noexcept {
  const auto by = static_cast<std::uint32_t>(f.makers.size() - 1);
  f.pieces[piece].fixed[k] = by;
  const std::uint32_t beyond = f.pieces[piece].beside[k];
  for (int j = 0; beyond != no_index && j < 3; ++j)
    if (f.pieces[beyond].beside[j] == piece) f.pieces[beyond].fixed[j] = by;
}

// Puts a corner where the newest cut crosses side k of a piece, a cut of another body.
template <class Face>
constexpr std::uint32_t insert_crossing(Face& f, std::uint32_t piece, int k) {
  const cut_maker &one = f.makers[f.pieces[piece].fixed[k]], &other = f.makers.back();
  if (one.body == other.body) return no_index;
  const bool by_side = one.v[1] != no_index, by_other_side = other.v[1] != no_index;
  contact_key key{{f.number, one.v[0], other.v[0], three_triangles}};
  if (by_side && by_other_side)
    key = {{one.v[0], one.v[1], other.v[0], other.v[1]}};
  else if (by_side || by_other_side)
    key = {{(by_side ? one : other).v[0], (by_side ? one : other).v[1], (by_side ? other : one).v[0], no_index}};
  else
    std::sort(key.v, key.v + 3);
  const std::uint32_t p = f.add_corner(f.vertices.add(key), 0);
  split_side(f, piece, k, p);
  return p;
}

// Collects the edges between `at` and the next corner on the way to `end`, the first of them beyond piece `piece`, and
// gives that corner.
template <class Face>
constexpr std::uint32_t find_crossed(Face& f, std::uint32_t at, std::uint32_t end, std::uint32_t piece) {
  f.crossed.clear();
  int k = (side_from(f.pieces[piece], at) + 1) % 3;
  for (;;) {
    const face_piece& t = f.pieces[piece];
    const std::uint32_t right = t.v[k], left = t.v[(k + 1) % 3], beyond = t.beside[k];
    if (beyond == no_index || f.crossed.size() > 2 * f.pieces.size()) return no_index;
    if (t.fixed[k] != no_index) return insert_crossing(f, piece, k);
    f.crossed.push_back({right, left});
    const int j = side_from(f.pieces[beyond], left);  // runs back from left to right
    const std::uint32_t top = f.pieces[beyond].v[(j + 2) % 3];
    const int sign = f.side_of_way(at, end, top);
    if (sign == 0) return top;
    k = sign > 0 ? (j + 1) % 3 : (j + 2) % 3;  // top is the new left or the new right
    piece = beyond;
  }
}

/// Flips the edges between `at` and the next corner on the way to `end`, the first of them beyond piece `first`, until
/// an edge joins the two; gives that corner.
/// source  Sloan 1993
template <class Face>
constexpr std::uint32_t insert_edge(Face& f, std::uint32_t at, std::uint32_t end, std::uint32_t first) {
  const std::uint32_t reached = find_crossed(f, at, end, first);
  if (reached == no_index) return no_index;
  const std::size_t limit = 16 * f.crossed.size() * f.crossed.size() + 64;
  for (std::size_t i = 0; i < f.crossed.size(); ++i) {
    if (i == limit) return no_index;
    const auto [a, b] = f.crossed[i];
    const std::uint32_t one = piece_with(f, a, b), other = piece_with(f, b, a);
    if (one == no_index || other == no_index) return no_index;
    const std::uint32_t x = f.pieces[one].v[(side_from(f.pieces[one], a) + 2) % 3];
    const std::uint32_t y = f.pieces[other].v[(side_from(f.pieces[other], b) + 2) % 3];
    if (f.turn_of(y, x, a) <= 0 || f.turn_of(y, x, b) >= 0) {  // not convex: later
      f.crossed.push_back({a, b});
      continue;
    }
    flip_edge(f, one, other, a, b);
    const int sign_x = f.side_of_way(at, reached, x), sign_y = f.side_of_way(at, reached, y);
    if (sign_x * sign_y >= 0) continue;
    f.crossed.push_back({sign_x < 0 ? x : y, sign_x < 0 ? y : x});
  }
  const std::uint32_t done = piece_with(f, at, reached);
  if (done == no_index) return no_index;
  fix_side(f, done, side_from(f.pieces[done], at));
  return reached;
}

// Whether q, on the line from a to b, lies on b's side of a.
template <class Face>
constexpr bool is_ahead(Face& f, std::uint32_t a, std::uint32_t b, std::uint32_t q) {
  for (int axis = 0; axis < 3; ++axis)
    if (const int way = f.vertices.compare(f.local[a], f.local[b], axis); way != 0)
      return f.vertices.compare(f.local[a], f.local[q], axis) == way;
  return false;
}

// Makes the edge from `at` to the next corner on the way to `end` a cut, and gives that corner.
template <class Face>
constexpr std::uint32_t advance_constraint(Face& f, std::uint32_t at, std::uint32_t end) {
  for (piece_walk w{at, f.piece_of[at]}; w.at != no_index; go_round(f, w)) {
    const face_piece& t = f.pieces[w.at];
    const int k = side_from(t, at);
    const std::uint32_t q = t.v[(k + 1) % 3], r = t.v[(k + 2) % 3];
    const int sign_q = f.side_of_way(at, end, q), sign_r = f.side_of_way(at, end, r);
    if (sign_q == 0 && (q == end || is_ahead(f, at, end, q))) {
      fix_side(f, w.at, k);
      return q;
    }
    if (sign_r == 0 && (r == end || is_ahead(f, at, end, r))) {
      fix_side(f, w.at, (k + 2) % 3);
      return r;
    }
    if (sign_q < 0 && sign_r > 0) return insert_edge(f, at, end, w.at);
  }
  return no_index;
}

/// Makes a cut from one vertex of the triangle or of its points to another.
template <class Face>
constexpr bool insert_constraint(Face& f, std::uint32_t from, std::uint32_t to, const cut_maker& by) {
  f.makers.push_back(by);
  std::uint32_t at = f.corner_of(from);
  const std::uint32_t end = f.corner_of(to);
  if (at == no_index || end == no_index) return false;
  for (std::size_t steps = 0; at != end; ++steps) {  // each comes to a corner further on
    if (steps > f.local.size()) return false;
    at = advance_constraint(f, at, end);
    if (at == no_index) return false;
  }
  return true;
}

}  // namespace IRG_ABI
}  // namespace irg::detail
