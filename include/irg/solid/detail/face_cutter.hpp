// SPDX-License-Identifier: MIT
// One triangle cut along the segments at which other bodies meet it: points go in one after the other, and edges that
// cross a segment are turned until it is one; where segments of two bodies cross, there is a new point. Every decision
// is a sign of exact_vertices.
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

template <class Vertices>
class face_cutter {
public:
  std::vector<face_piece> pieces;
  bool failed = false;  // what should not meet meets

  constexpr explicit face_cutter(Vertices& vertices) : vertices_(vertices) {}

  /// Begins with a triangle and its points, in any order, each once.
  constexpr void begin(const seen_triangle& t, std::vector<placed_vertex>& points) {
    axis_ = t.axis, turn_ = t.turn, number_ = t.number;
    makers_.clear(), pieces.clear(), local_.clear(), sides_.clear(), piece_of_.clear();
    for (int k = 0; k < 3; ++k) add_vertex(t.v[k], static_cast<std::uint8_t>(1u << k | 1u << (k + 2) % 3));
    pieces.push_back({{0, 1, 2}});
    remember(0);
    for (int k = 0; k < 3; ++k) cut_border(points, t.v[k], t.v[(k + 1) % 3], k);
    for (const placed_vertex& p : points)
      if (p.place == inside_triangle) insert(p.v);
  }

  /// Makes a cut from one vertex of the triangle or of its points to another.
  constexpr void cut(std::uint32_t from, std::uint32_t to, const cut_maker& by) {
    makers_.push_back(by);
    std::uint32_t at = local(from);
    const std::uint32_t end = local(to);
    // Each step comes to a vertex further on.
    for (std::size_t steps = 0; at != end && !failed; ++steps) {
      if (steps > local_.size()) failed = true;
      at = step(at, end);
    }
  }

  /// The vertex that a corner of a piece is.
  constexpr std::uint32_t vertex(std::uint32_t l) const noexcept { return local_[l]; }
  /// The side of the triangle that an edge of a piece lies on; 3 when none.
  constexpr int rim_of(std::uint32_t l, std::uint32_t m) const noexcept {
    const unsigned common = sides_[l] & sides_[m];
    return common == 0 ? 3 : common == 1 ? 0 : common == 2 ? 1 : 2;
  }

private:
  constexpr std::uint32_t add_vertex(std::uint32_t v, std::uint8_t sides) {
    local_.push_back(v);
    sides_.push_back(sides);
    piece_of_.push_back(0);
    return static_cast<std::uint32_t>(local_.size() - 1);
  }
  constexpr std::uint32_t local(std::uint32_t v) {
    for (std::uint32_t l = 0; l < local_.size(); ++l)
      if (local_[l] == v) return l;
    failed = true;
    return 0;
  }
  constexpr int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if ((sides_[a] & sides_[b] & sides_[c]) != 0) return 0;
    return vertices_.turn(local_[a], local_[b], local_[c], axis_) * turn_;
  }
  constexpr void remember(std::uint32_t piece) {
    for (const std::uint32_t l : pieces[piece].v) piece_of_[l] = piece;
  }
  constexpr void replace_neighbour(std::uint32_t piece, std::uint32_t before, std::uint32_t after) {
    if (piece == no_index) return;
    for (std::uint32_t& b : pieces[piece].beside)
      if (b == before) {
        b = after;
        return;
      }
  }

  // Cuts side k at its points, which come into order along it first.
  constexpr void cut_border(const std::vector<placed_vertex>& points, std::uint32_t from, std::uint32_t to, int k) {
    along_.clear();
    for (const placed_vertex& p : points)
      if (p.place == 3 + k) along_.push_back(p.v);
    if (along_.empty()) return;
    int axis = 0;
    const auto &a = vertices_.at[from], &b = vertices_.at[to];
    for (int i = 1; i < 3; ++i)
      if (magnitude(b[i] - a[i]) > magnitude(b[axis] - a[axis])) axis = i;
    const int way = vertices_.compare(from, to, axis);
    std::sort(along_.begin(), along_.end(),
              [&](std::uint32_t u, std::uint32_t v) { return vertices_.compare(u, v, axis) == way; });
    std::uint32_t last = static_cast<std::uint32_t>(k);
    for (const std::uint32_t v : along_) {
      const std::uint32_t piece = piece_with(last, static_cast<std::uint32_t>((k + 1) % 3));
      const std::uint32_t p = add_vertex(v, static_cast<std::uint8_t>(1u << k));
      split_side(piece, side_from(piece, last), p);
      last = p;
    }
  }

  constexpr int side_from(std::uint32_t piece, std::uint32_t l) const noexcept {
    const face_piece& t = pieces[piece];
    return t.v[0] == l ? 0 : t.v[1] == l ? 1 : 2;
  }
  // Calls use(piece) for the pieces round a vertex as long as it says so.
  template <class Use>
  constexpr void each_piece_at(std::uint32_t l, const Use& use) {
    const std::uint32_t first = piece_of_[l];
    std::uint32_t at = first;
    do {
      if (!use(at)) return;
      at = pieces[at].beside[(side_from(at, l) + 2) % 3];
    } while (at != no_index && at != first);
    if (at == first) return;
    for (at = pieces[first].beside[side_from(first, l)]; at != no_index; at = pieces[at].beside[side_from(at, l)])
      if (!use(at)) return;
  }

  // The pieces round a vertex, one after the other; none behind the last.
  struct round_walk {
    std::uint32_t l, first, at;
    bool is_back = false;
  };
  constexpr void go_on(round_walk& w) const noexcept {
    const int k = side_from(w.at, w.l);
    w.at = pieces[w.at].beside[w.is_back ? k : (k + 2) % 3];
    if (w.is_back || (w.at != no_index && w.at != w.first)) return;
    w.is_back = true;
    w.at = w.at == w.first ? no_index : pieces[w.first].beside[side_from(w.first, w.l)];
  }

  // The piece that has a side from a to b; sought round both, since one of them may have many.
  constexpr std::uint32_t piece_with(std::uint32_t a, std::uint32_t b) {
    round_walk x{a, piece_of_[a], piece_of_[a]}, y{b, piece_of_[b], piece_of_[b]};
    while (x.at != no_index) {
      if (pieces[x.at].v[(side_from(x.at, a) + 1) % 3] == b) return x.at;
      go_on(x);
      if (y.at == no_index) continue;
      const int k = side_from(y.at, b);
      if (pieces[y.at].v[(k + 1) % 3] == a && pieces[y.at].beside[k] != no_index) return pieces[y.at].beside[k];
      go_on(y);
    }
    failed = true;
    return 0;
  }

  // Puts p on side k of a piece, and of the one beyond.
  constexpr void split_side(std::uint32_t piece, int k, std::uint32_t p) {
    const std::uint32_t beyond = pieces[piece].beside[k];
    const std::uint32_t half = halve(piece, k, p);
    if (beyond == no_index) return;
    int j = 0;
    while (pieces[beyond].beside[j] != piece) ++j;
    const std::uint32_t other = halve(beyond, j, p);
    // piece has the near end of the side, beyond the far one.
    pieces[piece].beside[0] = other, pieces[other].beside[0] = piece;
    pieces[half].beside[0] = beyond, pieces[beyond].beside[0] = half;
  }
  // The piece keeps the first half of side k, as its side 0; the new one has the second, as its side 0.
  constexpr std::uint32_t halve(std::uint32_t piece, int k, std::uint32_t p) {
    const face_piece t = pieces[piece];
    const int l = (k + 1) % 3, m = (k + 2) % 3;
    const auto half = static_cast<std::uint32_t>(pieces.size());
    pieces[piece] = {{t.v[k], p, t.v[m]}, {no_index, half, t.beside[m]}, {t.fixed[k], no_index, t.fixed[m]}};
    pieces.push_back({{p, t.v[l], t.v[m]}, {no_index, t.beside[l], piece}, {t.fixed[k], t.fixed[l], no_index}});
    replace_neighbour(t.beside[l], piece, half);
    remember(piece), remember(half);
    return half;
  }

  constexpr void insert(std::uint32_t v) {
    const std::uint32_t p = add_vertex(v, 0);
    std::uint32_t at = static_cast<std::uint32_t>(pieces.size() - 1);
    const std::size_t limit = 4 * pieces.size() + 16;
    for (std::size_t steps = 0; steps < limit + pieces.size(); ++steps) {
      if (steps >= limit) at = static_cast<std::uint32_t>(steps - limit);  // the walk went in circles: one by one
      int zeros = 0, zero = 0, out = 3;
      for (int k = 0; k < 3 && out == 3; ++k) {
        const int sign = turn(pieces[at].v[k], pieces[at].v[(k + 1) % 3], p);
        if (sign < 0) out = k;
        if (sign == 0) ++zeros, zero = k;
      }
      if (out != 3) {
        at = pieces[at].beside[out] == no_index ? at : pieces[at].beside[out];
        continue;
      }
      if (zeros == 0)
        split(at, p);
      else if (zeros == 1)
        split_side(at, zero, p);
      else
        failed = true;
      return;
    }
    failed = true;
  }
  constexpr void split(std::uint32_t piece, std::uint32_t p) {
    const face_piece t = pieces[piece];
    const auto a = static_cast<std::uint32_t>(pieces.size()), b = a + 1;
    pieces[piece] = {{t.v[0], t.v[1], p}, {t.beside[0], a, b}, {t.fixed[0], no_index, no_index}};
    pieces.push_back({{t.v[1], t.v[2], p}, {t.beside[1], b, piece}, {t.fixed[1], no_index, no_index}});
    pieces.push_back({{t.v[2], t.v[0], p}, {t.beside[2], piece, a}, {t.fixed[2], no_index, no_index}});
    replace_neighbour(t.beside[1], piece, a);
    replace_neighbour(t.beside[2], piece, b);
    remember(piece), remember(a), remember(b);
  }

  constexpr void fix(std::uint32_t piece, int k) {
    const auto by = static_cast<std::uint32_t>(makers_.size() - 1);
    pieces[piece].fixed[k] = by;
    const std::uint32_t beyond = pieces[piece].beside[k];
    for (int j = 0; beyond != no_index && j < 3; ++j)
      if (pieces[beyond].beside[j] == piece) pieces[beyond].fixed[j] = by;
  }

  // Whether q, on the line from a to b, lies on b's side of a.
  constexpr bool is_ahead(std::uint32_t a, std::uint32_t b, std::uint32_t q) {
    for (int axis = 0; axis < 3; ++axis)
      if (const int way = vertices_.compare(local_[a], local_[b], axis); way != 0)
        return vertices_.compare(local_[a], local_[q], axis) == way;
    return false;
  }

  // Makes the edge from `at` to the next vertex on the way to `end` a cut, and gives that vertex.
  constexpr std::uint32_t step(std::uint32_t at, std::uint32_t end) {
    std::uint32_t reached = no_index, first = no_index;
    each_piece_at(at, [&](std::uint32_t piece) {
      const int k = side_from(piece, at);
      const std::uint32_t q = pieces[piece].v[(k + 1) % 3], r = pieces[piece].v[(k + 2) % 3];
      const int sign_q = q == end ? 0 : turn(at, end, q), sign_r = r == end ? 0 : turn(at, end, r);
      if (sign_q == 0 && (q == end || is_ahead(at, end, q))) {
        fix(piece, k);
        reached = q;
      } else if (sign_r == 0 && (r == end || is_ahead(at, end, r))) {
        fix(piece, (k + 2) % 3);
        reached = r;
      } else if (sign_q < 0 && sign_r > 0) {
        first = piece;
      }
      return reached == no_index && first == no_index;
    });
    if (reached != no_index) return reached;
    if (first == no_index) {
      failed = true;
      return end;
    }
    return force(at, end, first);
  }

  // Puts a vertex where the newest cut crosses side k of a piece, a cut of another body.
  constexpr std::uint32_t cross(std::uint32_t piece, int k) {
    const cut_maker &one = makers_[pieces[piece].fixed[k]], &other = makers_.back();
    failed = failed || one.body == other.body;
    if (failed) return 0;
    const bool by_side = one.v[1] != no_index, by_other_side = other.v[1] != no_index;
    contact_key key{{number_, one.v[0], other.v[0], three_triangles}};
    if (by_side && by_other_side)
      key = {{one.v[0], one.v[1], other.v[0], other.v[1]}};
    else if (by_side || by_other_side)
      key = {{(by_side ? one : other).v[0], (by_side ? one : other).v[1], (by_side ? other : one).v[0], no_index}};
    else
      std::sort(key.v, key.v + 3);
    const std::uint32_t p = add_vertex(vertices_.add(key), 0);
    split_side(piece, k, p);
    return p;
  }

  // Turns the edges between `at` and the next vertex on the way to `end`, the first of them beyond piece `first`.
  constexpr std::uint32_t force(std::uint32_t at, std::uint32_t end, std::uint32_t first) {
    crossing_.clear();
    std::uint32_t piece = first, reached = no_index;
    int k = (side_from(first, at) + 1) % 3;
    while (reached == no_index) {
      const face_piece& t = pieces[piece];
      const std::uint32_t right = t.v[k], left = t.v[(k + 1) % 3], beyond = t.beside[k];
      if (beyond == no_index || crossing_.size() > 2 * pieces.size()) failed = true;
      if (!failed && t.fixed[k] != no_index) {
        reached = cross(piece, k);
        break;
      }
      if (failed) return end;
      crossing_.push_back({right, left});
      const int j = side_from(beyond, left);  // runs back from left to right
      const std::uint32_t top = pieces[beyond].v[(j + 2) % 3];
      const int sign = top == end ? 0 : turn(at, end, top);
      if (sign == 0) reached = top;
      k = sign > 0 ? (j + 1) % 3 : (j + 2) % 3;  // top is the new left or the new right
      piece = beyond;
    }
    if (failed) return end;
    std::size_t tries = 0;
    const std::size_t limit = 16 * crossing_.size() * crossing_.size() + 64;
    for (std::size_t i = 0; i < crossing_.size(); ++i) {
      if (++tries > limit) {
        failed = true;
        return end;
      }
      const auto [a, b] = crossing_[i];
      const std::uint32_t one = piece_with(a, b), other = piece_with(b, a);
      if (failed) return end;
      const std::uint32_t x = pieces[one].v[(side_from(one, a) + 2) % 3];
      const std::uint32_t y = pieces[other].v[(side_from(other, b) + 2) % 3];
      if (turn(y, x, a) <= 0 || turn(y, x, b) >= 0) {  // no diagonal: later
        crossing_.push_back({a, b});
        continue;
      }
      flip(one, other, a, b);
      const int sign_x = x == at || x == reached ? 0 : turn(at, reached, x);
      const int sign_y = y == at || y == reached ? 0 : turn(at, reached, y);
      if (sign_x * sign_y < 0) crossing_.push_back(sign_x < 0 ? edge{x, y} : edge{y, x});
    }
    const std::uint32_t done = piece_with(at, reached);
    if (!failed) fix(done, side_from(done, at));
    return reached;
  }

  // The edge from a to b, of `one` and back of `other`, becomes the other diagonal.
  constexpr void flip(std::uint32_t one, std::uint32_t other, std::uint32_t a, std::uint32_t b) {
    const face_piece s = pieces[one], t = pieces[other];
    const int k = side_from(one, a), j = side_from(other, b);
    const int s_next = (k + 1) % 3, s_last = (k + 2) % 3, t_next = (j + 1) % 3, t_last = (j + 2) % 3;
    const std::uint32_t x = s.v[s_last], y = t.v[t_last];
    pieces[one] = {
        {x, a, y}, {s.beside[s_last], t.beside[t_next], other}, {s.fixed[s_last], t.fixed[t_next], no_index}};
    pieces[other] = {
        {y, b, x}, {t.beside[t_last], s.beside[s_next], one}, {t.fixed[t_last], s.fixed[s_next], no_index}};
    replace_neighbour(t.beside[t_next], other, one);
    replace_neighbour(s.beside[s_next], one, other);
    remember(one), remember(other);
  }

  struct edge {
    std::uint32_t from, to;
  };

  Vertices& vertices_;
  int axis_ = 0, turn_ = 1;
  std::uint32_t number_ = 0;
  std::vector<cut_maker> makers_;  // of the cuts, the newest last
  std::vector<std::uint32_t> local_, piece_of_, along_;
  std::vector<std::uint8_t> sides_;
  std::vector<edge> crossing_;
};

}  // namespace IRG_ABI
}  // namespace irg::detail
