// SPDX-License-Identifier: MIT
// BSP tree of segments in the plane: built once, it tells for every eye which one lies behind which. A segment that a
// line cuts gets no new coordinates: a piece is its segment and the lines of the segments that end it, so that every
// decision is exact. No recursion: depth is bounded by memory only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/vocabulary.hpp>
#include <irg/spatial/bsp_order.hpp>
#if IRG_BODIES
#include <algorithm>
#include <array>
#include <utility>

#include <irg/core/contract.hpp>
#include <irg/core/coordinates.hpp>
#include <irg/core/conversion.hpp>
#include <irg/core/is_finite.hpp>
#include <irg/geometry/crossing_point.hpp>
#include <irg/geometry/intersect_lines.hpp>
#include <irg/math/error_free.hpp>
#endif

namespace irg {

/// A piece of a segment: from its end a, or where the line of segment `from` cuts it, to its end b, or to `to`'s line.
struct bsp_piece_2d {
  std::uint32_t segment = no_index, from = no_index, to = no_index;
  friend constexpr bool operator==(const bsp_piece_2d&, const bsp_piece_2d&) = default;
};

/// A line that divides what is left, through the ends of a segment: pieces first to last - 1 lie on it.
/// shape   left and right are nodes, or no_index
struct bsp_node_2d {
  std::uint32_t segment = no_index, first = 0, last = 0, left = no_index, right = no_index;
  bool operator==(const bsp_node_2d&) const = default;
};

namespace detail {

template <Floating T>
struct growing_bsp_2d {
  std::vector<segment<T, 2>> segments{};
  std::vector<bsp_node_2d> nodes{};
  std::vector<bsp_piece_2d> pieces{};
  std::size_t splits = 0, left_out = 0;
};

inline namespace IRG_COMPILED_ABI {

// Makes the tree of the segments that are there.
template <Floating T>
IRG_API void grow_bsp_2d(growing_bsp_2d<T>& tree, const bsp_options& choice);
template <Floating T>
IRG_API segment<T, 2> rounded_piece(const growing_bsp_2d<T>& tree, const bsp_piece_2d& p) noexcept;

}  // namespace IRG_COMPILED_ABI
}  // namespace detail

/// The tree of some segments.
template <Floating T>
class bsp_tree_2d {
public:
  /// needs   fewer than 2^32 - 1 pieces; one candidate and one judge at least
  /// gives   segments without length, or with NaN or infinity, are left out and counted
  /// cost    allocates; a line meets the pieces of its cell that their bounds do not tell from it: O(n log n) where
  ///         sides are alike, and for walls around a convex room, each of which leaves all others on one side; segments
  ///         that cross each other make n^2 pieces at worst
  /// source  Fuchs, Kedem and Naylor 1980
  IRG_APART constexpr explicit bsp_tree_2d(std::span<const segment<T, 2>> segments, const bsp_options& choice = {})
      : tree_{{segments.begin(), segments.end()}} {
    detail::grow_bsp_2d(tree_, choice);
  }

  /// The first one is the root; a node stands before those below it.
  [[nodiscard]] IRG_APART constexpr std::span<const bsp_node_2d> nodes() const noexcept {
    return {tree_.nodes.data(), tree_.nodes.size()};
  }
  [[nodiscard]] IRG_APART constexpr std::span<const bsp_piece_2d> pieces() const noexcept {
    return {tree_.pieces.data(), tree_.pieces.size()};
  }
  /// How often a line cut a segment in two.
  [[nodiscard]] IRG_APART constexpr std::size_t splits() const noexcept { return tree_.splits; }
  /// Segments without length, or with NaN or infinity.
  [[nodiscard]] IRG_APART constexpr std::size_t left_out() const noexcept { return tree_.left_out; }

  /// A piece with its ends as points, to draw it.
  /// exact   ends of segments are given points; cuts are within 0.501 ulp of where the lines cross
  [[nodiscard]] IRG_APART constexpr segment<T, 2> rounded(const bsp_piece_2d& p) const noexcept {
    return detail::rounded_piece(tree_, p);
  }

  /// Calls sink(piece) for all pieces, so that of two that a ray from the eye crosses the farther one comes first, or
  /// the nearer. Pieces that the ray touches with an end only, and those that the eye lies on, have no such order.
  /// needs   a finite eye
  /// cost    one side of a line for each node
  template <class Sink>
  IRG_APART constexpr void visit(const point<T, 2>& eye, bsp_order order, Sink&& sink) const {
    std::vector<visit_step> open;
    if (!tree_.nodes.empty()) open.push_back({0, false});
    while (!open.empty()) {
      const auto [i, own] = open.back();
      open.pop_back();
      const bsp_node_2d& n = tree_.nodes[i];
      if (own) {
        for (std::uint32_t p = n.first; p < n.last; ++p) sink(tree_.pieces[p]);
        continue;
      }
      const int eye_side = side(n, eye);
      const bool left_first = (eye_side > 0) == (order == bsp_order::front_to_back);
      const std::uint32_t early = left_first ? n.left : n.right, late = left_first ? n.right : n.left;
      // With the eye on the line, what lies there is nearest on every ray that leaves the line.
      const bool own_last = eye_side == 0 && order == bsp_order::back_to_front;
      const bool own_first = eye_side == 0 && order == bsp_order::front_to_back;
      if (own_last) open.push_back({i, true});
      if (late != no_index) open.push_back({late, false});
      if (eye_side != 0) open.push_back({i, true});
      if (early != no_index) open.push_back({early, false});
      if (own_first) open.push_back({i, true});
    }
  }

  /// The cell that holds a point, or the first node whose line does.
  /// needs   a finite point
  [[nodiscard]] IRG_APART constexpr bsp_place locate(const point<T, 2>& p) const noexcept {
    bsp_place place;
    for (std::uint32_t i = tree_.nodes.empty() ? no_index : 0; i != no_index;) {
      place = {i, side(tree_.nodes[i], p)};
      if (place.side == 0) break;
      i = place.side > 0 ? tree_.nodes[i].left : tree_.nodes[i].right;
    }
    return place;
  }

private:
  struct visit_step {
    std::uint32_t node;
    bool own;  // only the node's own pieces are left to call
  };

  [[nodiscard]] IRG_APART constexpr int side(const bsp_node_2d& n, const point<T, 2>& p) const noexcept {
    return orient2d(tree_.segments[n.segment].a, tree_.segments[n.segment].b, p);
  }
  detail::growing_bsp_2d<T> tree_{};
};

}  // namespace irg

#if IRG_BODIES
namespace irg::detail {
inline namespace IRG_ABI {

// How the tree grows.
template <Floating T>
struct bsp_growth_2d {
  struct cell {
    std::uint32_t pieces, parent;  // a cell of bsp_open_cells, a node
    int side;
  };
  using entry = typename bsp_open_cells<bsp_piece_2d, 2>::entry;

  growing_bsp_2d<T>& tree;
  double scale = 1;

  constexpr void run(const bsp_options& choice) {
    IRG_EXPECTS(choice.candidates > 0 && choice.judges > 0);
    bsp_open_cells<bsp_piece_2d, 2> cells;
    std::vector<cell> open;
    open.push_back({cells.make_cell(usable()), no_index, 0});
    while (!open.empty()) {
      const cell c = open.back();
      open.pop_back();
      if (c.pieces != no_index) divide(cells, c, open, choice);
    }
  }

  [[nodiscard]] constexpr int end_side(std::uint32_t line, const bsp_piece_2d& p, bool at_a) const noexcept {
    const segment<T, 2>&s = tree.segments[p.segment], &l = tree.segments[line];
    const std::uint32_t cut = at_a ? p.from : p.to;
    if (cut == line) return 0;
    if (cut == no_index) return orient2d(l.a, l.b, at_a ? s.a : s.b);
    return sign_of(side_of_crossing(s, tree.segments[cut], l).value_or(irg::side::on));
  }
  // A point in doubles that no difference of overflows.
  [[nodiscard]] constexpr point<double, 2> scaled(const point<T, 2>& p) const noexcept {
    return {product(widened(p[0]), scale), product(widened(p[1]), scale)};
  }
  // The line of a segment: positive to the left of it.
  [[nodiscard]] constexpr linear_form<2> form_of(const segment<T, 2>& s) const noexcept {
    const point<double, 2> a = scaled(s.a), b = scaled(s.b);
    const double dx = b[0] - a[0], dy = b[1] - a[1];
    return {{-dy, dx}, {magnitude(dy), magnitude(dx)}, a};
  }
  constexpr std::vector<entry> usable() {
    std::vector<entry> all;
    for (std::uint32_t i = 0; i < tree.segments.size(); ++i) {
      const segment<T, 2>& s = tree.segments[i];
      if (!is_finite(s.a, s.b) || s.a == s.b)
        ++tree.left_out;
      else
        all.push_back({{i, no_index, no_index}, {}, i});
    }
    for (const entry& e : all)
      for (const point<T, 2>& p : {tree.segments[e.place].a, tree.segments[e.place].b})
        if (maximum(magnitude(widened(p[0])), magnitude(widened(p[1]))) > 0x1p200) scale = 0x1p-850;
    for (entry& e : all) {
      const segment<T, 2>& s = tree.segments[e.place];
      const linear_form<2> line = form_of(s);
      e.bounds = bounds_of<2>(std::array{scaled(s.a), scaled(s.b)}, line.slope);
    }
    return all;
  }
  template <class Cells>
  [[nodiscard]] constexpr std::uint32_t dividing_line(const Cells& cells, std::uint32_t pieces,
                                                      const bsp_options& choice) const {
    const std::size_t n = cells.size(pieces), candidates = minimum(choice.candidates, n),
                      judges = minimum(choice.judges, n);
    std::uint32_t best = cells.first(pieces).segment;
    if (candidates < 2) return best;
    std::vector<bsp_piece_2d> judge;
    for (std::size_t k = 0; k < judges; ++k) judge.push_back(cells.at(pieces, k * n / judges));
    std::size_t least = ~std::size_t{0};
    for (std::size_t i = 0; i < candidates; ++i) {
      const std::uint32_t line = cells.at(pieces, i * n / candidates).segment;
      std::size_t left = 0, right = 0, cut = 0;
      for (const bsp_piece_2d& p : judge) {
        if (p.segment == line) continue;
        const int a = end_side(line, p, true), b = end_side(line, p, false);
        cut += a * b < 0;
        left += a + b > 0;
        right += a + b < 0;
      }
      const std::size_t cost = (left < right ? right - left : left - right) + cut * choice.cut_costs;
      if (cost < least) {
        least = cost;
        best = line;
      }
    }
    return best;
  }
  template <class Cells>
  constexpr void divide(Cells& cells, const cell& c, std::vector<cell>& open, const bsp_options& choice) {
    const auto here = static_cast<std::uint32_t>(tree.nodes.size());
    if (c.parent != no_index) (c.side > 0 ? tree.nodes[c.parent].left : tree.nodes[c.parent].right) = here;
    const std::uint32_t line = dividing_line(cells, c.pieces, choice);
    const std::size_t first = tree.pieces.size();
    const linear_form<2> form = form_of(tree.segments[line]);
    const bsp_halves halves = cells.divide(
        c.pieces, [&](const bsp_bounds<2>& b) { return rounded_side_of(b, form); },
        [&](entry&& e, const auto& left, const auto& right) {
          const bsp_piece_2d& p = e.item;
          const int a = p.segment == line ? 0 : end_side(line, p, true),
                    b = p.segment == line ? 0 : end_side(line, p, false);
          if (a == 0 && b == 0) {
            tree.pieces.push_back(p);
          } else if (a * b < 0) {
            ++tree.splits;
            entry from_a = e, to_b = e;
            from_a.item.to = to_b.item.from = line;
            left(std::move(a > 0 ? from_a : to_b));
            right(std::move(a > 0 ? to_b : from_a));
          } else if (a + b > 0) {
            left(std::move(e));
          } else {
            right(std::move(e));
          }
        });
    std::sort(tree.pieces.begin() + static_cast<std::ptrdiff_t>(first), tree.pieces.end(),
              [](const bsp_piece_2d& p, const bsp_piece_2d& q) { return p.segment < q.segment; });
    tree.nodes.push_back(
        {line, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(tree.pieces.size()), no_index, no_index});
    open.push_back({halves.back, here, -1});
    open.push_back({halves.front, here, 1});
  }
};

}  // namespace IRG_ABI

inline namespace IRG_COMPILED_ABI {

template <Floating T>
IRG_API void grow_bsp_2d(growing_bsp_2d<T>& tree, const bsp_options& choice) {
  bsp_growth_2d<T>{tree}.run(choice);
}

template <Floating T>
IRG_API segment<T, 2> rounded_piece(const growing_bsp_2d<T>& tree, const bsp_piece_2d& p) noexcept {
  const auto& all = tree.segments;
  const segment<T, 2>& s = all[p.segment];
  const auto end = [&](std::uint32_t cut, const point<T, 2>& given) {
    return cut == no_index ? given : intersect_lines(s.a, s.b, all[cut].a, all[cut].b).at;
  };
  return {end(p.from, s.a), end(p.to, s.b)};
}

}  // namespace IRG_COMPILED_ABI
}  // namespace irg::detail
#endif
