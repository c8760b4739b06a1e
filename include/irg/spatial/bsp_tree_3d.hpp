// SPDX-License-Identifier: MIT
// BSP tree of triangles in space: built once for a scene that does not move, it tells for every eye which triangle lies
// behind which. A triangle that a plane cuts gets no new corners: a piece is its triangle and the planes that limit it,
// so that every decision is exact. No recursion: depth is bounded by memory only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <irg/core/contract.hpp>
#include <irg/core/conversion.hpp>
#include <irg/core/vocabulary.hpp>
#include <irg/spatial/bsp_data_3d.hpp>
#include <irg/spatial/detail/growing_bsp_3d.hpp>
#if IRG_BODIES
#include <irg/spatial/detail/bsp_cells_3d.hpp>
#endif

namespace irg {

/// The tree of some triangles.
template <Floating T>
class bsp_tree_3d {
public:
  bsp_tree_3d() = default;

  /// needs   indices of vertices; fewer than 2^32 - 4 triangles, nodes and pieces; one candidate and one judge at least
  /// gives   triangles without area, or with NaN or infinity, are left out and counted
  /// cost    allocates. A cell is divided by the plane of one of its triangles or, where that cuts fewer or leaves the
  ///         sides more alike, by one across an axis through a corner, so that convex bodies make no chains; every
  ///         plane meets every piece in its cell. A piece without a side of its triangle, which reaches across its
  ///         cell, is taken first: its plane cuts only what goes through it. O(n log n) where little is cut; triangles
  ///         that go through each other make a piece at least for each point that three of them have in common
  /// source  Fuchs, Kedem and Naylor 1980
  IRG_APART constexpr bsp_tree_3d(std::span<const point<T, 3>> vertices, std::span<const triangle_indices> triangles,
                                  const bsp_options& choice = {}) {
    detail::add_triangles(tree_, vertices, triangles, choice);
    fixed_ = detail::sizes_of(tree_);
  }

  /// A tree from what data() gave.
  /// needs   find_bsp_fault(data).defect == bsp_defect::none
  IRG_APART constexpr explicit bsp_tree_3d(bsp_data_3d<T> data) {
    tree_.data = std::move(data);
    IRG_EXPECTS(find_bsp_fault(tree_.data).defect == bsp_defect::none);
    detail::make_walkable(tree_);
    fixed_ = detail::sizes_of(tree_);
  }

  /// What the tree consists of. Node 0 is the root.
  [[nodiscard]] IRG_APART constexpr const bsp_data_3d<T>& data() const noexcept { return tree_.data; }
  /// How often a plane cut a triangle, or a piece of one, in two.
  [[nodiscard]] IRG_APART constexpr std::size_t splits() const noexcept { return tree_.splits; }
  /// Triangles without area, or with NaN or infinity.
  [[nodiscard]] IRG_APART constexpr std::size_t left_out() const noexcept { return tree_.left_out; }

  /// The corners of a piece as points, to draw it or hand it on: counter-clockwise as those of its triangle.
  /// exact   the triangle's corners are given points; others are rounded, by about as much as the planes are steep to
  ///         each other. Fewer than three where rounding leaves no area
  /// cost    the corners times the limits; allocates
  [[nodiscard]] IRG_APART constexpr std::vector<point<T, 3>> rounded(const bsp_piece_3d& p) const {
    return detail::rounded_ring(tree_, p);
  }

  /// Adds triangles that move: they are cut by the planes that are there, and divide the cells that they come to. Their
  /// numbers follow those of the triangles before, fixed ones and merged ones.
  /// shape   indices count from the vertices given here
  /// needs   arrays that are not the tree's own; else as the tree
  /// gives   the tree as it was where memory gives out
  /// cost    as building the tree, of these triangles alone
  IRG_APART constexpr void merge(std::span<const point<T, 3>> vertices, std::span<const triangle_indices> triangles,
                                 const bsp_options& choice = {}) {
    struct undo {
      detail::growing_bsp_3d<T>* tree;
      detail::bsp_sizes before;
      IRG_APART constexpr ~undo() {
        if (tree != nullptr) detail::shrink_to(*tree, before);
      }
    };
    undo guard{&tree_, detail::sizes_of(tree_)};
    detail::add_triangles(tree_, vertices, triangles, choice);
    guard.tree = nullptr;
  }
  /// Takes away all triangles that were merged in: the tree is what it was.
  /// cost    linear in what was added
  IRG_APART constexpr void remove_merged() { detail::shrink_to(tree_, fixed_); }

  /// Calls sink(piece) for all pieces, so that of two that a ray from the eye crosses the farther one comes first, or
  /// the nearer; of those in one plane the lower number counts as the nearer. Pieces in a plane that holds the eye are
  /// seen edge on and have no such order.
  /// needs   a finite eye
  /// cost    one side of a plane for each node
  template <class Sink>
  IRG_APART constexpr void visit(const point<T, 3>& eye, bsp_order order, Sink&& sink) const {
    const double at[3] = {widened(eye[0]), widened(eye[1]), widened(eye[2])};
    const double reach = maximum(maximum(magnitude(at[0]), magnitude(at[1])), magnitude(at[2]));
    walk(order, sink, [&](std::uint32_t i) {
      const int sure = tree_.steps[i].plane(at, reach).sign();
      return sure != 0 ? sure : detail::exact_side(tree_.data, tree_.data.nodes[i].plane, eye);
    });
  }
  /// The same from infinitely far away, in the direction to the eye: for parallel projections.
  /// needs   a finite direction
  template <class Sink>
  IRG_APART constexpr void visit(const vec<T, 3>& to_eye, bsp_order order, Sink&& sink) const {
    walk(order, sink,
         [&](std::uint32_t i) { return detail::side_of_direction(tree_.data, tree_.data.nodes[i].plane, to_eye); });
  }

  /// The cell that holds a point, or the first node whose plane does.
  /// needs   a finite point
  [[nodiscard]] IRG_APART constexpr bsp_place locate(const point<T, 3>& p) const noexcept {
    const double at[3] = {widened(p[0]), widened(p[1]), widened(p[2])};
    bsp_place place;
    for (std::uint32_t i = tree_.data.nodes.empty() ? no_index : 0; i != no_index;) {
      const int sure = tree_.planes[i](at, 0.0).sign();
      place = {i, sure != 0 ? sure : detail::exact_side(tree_.data, tree_.data.nodes[i].plane, p)};
      if (place.side == 0) break;
      i = place.side > 0 ? tree_.data.nodes[i].front : tree_.data.nodes[i].back;
    }
    return place;
  }

private:
  template <class Sink, class Side>
  IRG_APART constexpr void walk(bsp_order order, Sink& sink, const Side& side_of_eye) const {
    const bool to_back = order == bsp_order::front_to_back;
    struct left_open {
      std::uint32_t own, late;  // what is left: a node's own pieces, and what lies beyond them
    };
    std::vector<left_open> open;
    for (std::uint32_t i = tree_.data.nodes.empty() ? no_index : 0; i != no_index || !open.empty();) {
      if (i == no_index) {
        const left_open l = open.back();
        open.pop_back();
        give(l.own, to_back, sink);
        i = l.late;
        continue;
      }
      const detail::bsp_walk_step& n = tree_.steps[i];
      const bool front_first = (side_of_eye(i) > 0) == to_back;
      const std::uint32_t early = n.below[front_first ? 1 : 0], late = n.below[front_first ? 0 : 1];
      if (early != no_index)
        open.push_back({i, late});
      else
        give(i, to_back, sink);
      i = early != no_index ? early : late;
    }
  }
  // The pieces in a node's plane: those of nodes beside it have higher numbers.
  template <class Sink>
  IRG_APART constexpr void give(std::uint32_t node, bool to_back, Sink& sink) const {
    if (const detail::bsp_walk_step& n = tree_.steps[node]; n.piece != detail::several_pieces) {
      if (n.piece != no_index) sink(tree_.data.pieces[n.piece]);
      return;
    }
    if (to_back) {
      for (std::uint32_t i = node; i != no_index; i = tree_.data.nodes[i].beside)
        for (std::uint32_t p = tree_.data.nodes[i].first; p < tree_.data.nodes[i].last; ++p) sink(tree_.data.pieces[p]);
      return;
    }
    const auto give_node = [&](const bsp_node_3d& n) {
      for (std::uint32_t p = n.last; p-- > n.first;) sink(tree_.data.pieces[p]);
    };
    if (tree_.data.nodes[node].beside == no_index) return give_node(tree_.data.nodes[node]);
    std::vector<std::uint32_t> nodes;  // to be taken from the end
    for (std::uint32_t i = node; i != no_index; i = tree_.data.nodes[i].beside) nodes.push_back(i);
    for (; !nodes.empty(); nodes.pop_back()) give_node(tree_.data.nodes[nodes.back()]);
  }

  detail::growing_bsp_3d<T> tree_{};
  detail::bsp_sizes fixed_{};  // without what was merged in
};

}  // namespace irg
