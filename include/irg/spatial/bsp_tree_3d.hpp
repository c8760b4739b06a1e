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
#include <irg/geometry/parametric_line.hpp>
#include <irg/core/vocabulary.hpp>
#include <irg/spatial/bsp_data_3d.hpp>
#include <irg/spatial/detail/bsp_cells_3d.hpp>

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
                                  const bsp_choice& choice = {}) {
    add(vertices, triangles, choice);
    fixed_ = sizes();
  }

  /// A tree from what data() gave.
  /// needs   find_bsp_fault(data).defect == bsp_defect::none
  IRG_APART constexpr explicit bsp_tree_3d(bsp_data_3d<T> data) : data_(std::move(data)) {
    IRG_EXPECTS(find_bsp_fault(data_).defect == bsp_defect::none);
    for (const bsp_node_3d& n : data_.nodes) planes_.push_back(detail::plane_of(data_, n.plane));
    for (std::uint32_t i = 0; i < data_.nodes.size(); ++i) steps_.push_back(step_at(i));
    fixed_ = sizes();
  }

  /// What the tree consists of. Node 0 is the root.
  [[nodiscard]] IRG_APART constexpr const bsp_data_3d<T>& data() const noexcept { return data_; }
  /// How often a plane cut a triangle, or a piece of one, in two.
  [[nodiscard]] IRG_APART constexpr std::size_t splits() const noexcept { return splits_; }
  /// Triangles without area, or with NaN or infinity.
  [[nodiscard]] IRG_APART constexpr std::size_t left_out() const noexcept { return left_out_; }

  /// The corners of a piece as points, to draw it or hand it on: counter-clockwise as those of its triangle.
  /// exact   the triangle's corners are given points; others are rounded, by about as much as the planes are steep to
  ///         each other. Fewer than three where rounding leaves no area
  /// cost    the corners times the limits; allocates
  [[nodiscard]] IRG_APART constexpr std::vector<point<T, 3>> rounded(const bsp_piece_3d& p) const {
    std::vector<point<T, 3>> ring, kept;
    for (const std::uint32_t v : data_.triangles[p.triangle].v) ring.push_back(data_.vertices[v]);
    for (std::uint32_t l = p.limits; l != bsp_none && !ring.empty(); l = data_.limits[l].next, std::swap(ring, kept)) {
      kept.clear();
      const detail::rounded_plane& plane = planes_[data_.limits[l].node];
      const auto height = [&](const point<T, 3>& q) {
        const double at[3] = {widened(q[0]), widened(q[1]), widened(q[2])};
        return plane(at, 0.0).value * data_.limits[l].side;
      };
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const point<T, 3>&a = ring[i], &b = ring[i + 1 < ring.size() ? i + 1 : 0];
        const double f = height(a), g = height(b);
        if (f >= 0) kept.push_back(a);
        if ((f < 0 && g > 0) || (f > 0 && g < 0)) kept.push_back(point_between(a, b, converted<T>(f / (f - g))));
      }
    }
    return ring;
  }

  /// Adds triangles that move: they are cut by the planes that are there, and divide the cells that they come to. Their
  /// numbers follow those of the triangles before, fixed ones and merged ones.
  /// shape   indices count from the vertices given here
  /// needs   arrays that are not the tree's own; else as the tree
  /// gives   the tree as it was where memory gives out
  /// cost    as building the tree, of these triangles alone
  IRG_APART constexpr void merge(std::span<const point<T, 3>> vertices, std::span<const triangle_indices> triangles,
                                 const bsp_choice& choice = {}) {
    struct undo {
      bsp_tree_3d* tree;
      size_of_tree before;
      IRG_APART constexpr ~undo() {
        if (tree != nullptr) tree->shrink_to(before);
      }
    };
    undo guard{this, sizes()};
    add(vertices, triangles, choice);
    guard.tree = nullptr;
  }
  /// Takes away all triangles that were merged in: the tree is what it was.
  /// cost    linear in what was added
  IRG_APART constexpr void remove_merged() { shrink_to(fixed_); }

  /// Calls sink(piece) for all pieces, so that of two that a ray from the eye crosses the farther one comes first, or
  /// the nearer; of those in one plane the lower number counts as the nearer. Pieces in a plane that holds the eye are
  /// seen edge on and have no such order.
  /// needs   a finite eye
  /// cost    one side of a plane for each node
  template <class Sink>
  IRG_APART constexpr void visit(const point<T, 3>& eye, bsp_order order, Sink&& sink) const {
    const double at[3] = {widened(eye[0]), widened(eye[1]), widened(eye[2])};
    const double reach = greater(greater(magnitude(at[0]), magnitude(at[1])), magnitude(at[2]));
    walk(order, sink, [&](std::uint32_t i) {
      const int sure = steps_[i].plane(at, reach).sign();
      return sure != 0 ? sure : detail::exact_side(data_, data_.nodes[i].plane, eye);
    });
  }
  /// The same from infinitely far away, in the direction to the eye: for parallel projections.
  /// needs   a finite direction
  template <class Sink>
  IRG_APART constexpr void visit(const vec<T, 3>& to_eye, bsp_order order, Sink&& sink) const {
    walk(order, sink, [&](std::uint32_t i) { return detail::side_of_direction(data_, data_.nodes[i].plane, to_eye); });
  }

  /// The cell that holds a point, or the first node whose plane does.
  /// needs   a finite point
  [[nodiscard]] IRG_APART constexpr bsp_place locate(const point<T, 3>& p) const noexcept {
    const double at[3] = {widened(p[0]), widened(p[1]), widened(p[2])};
    bsp_place place;
    for (std::uint32_t i = data_.nodes.empty() ? bsp_none : 0; i != bsp_none;) {
      const int sure = planes_[i](at, 0.0).sign();
      place = {i, sure != 0 ? sure : detail::exact_side(data_, data_.nodes[i].plane, p)};
      if (place.side == 0) break;
      i = place.side > 0 ? data_.nodes[i].front : data_.nodes[i].back;
    }
    return place;
  }

private:
  // Where a node hangs: below another one, in front or behind, or beside one of the same plane.
  enum class hung { in_front, behind, beside };
  struct link {
    std::uint32_t node;
    hung where;
  };
  struct task {
    std::vector<detail::open_piece> pieces;
    link at;
  };
  struct size_of_tree {
    std::size_t vertices = 0, triangles = 0, nodes = 0, pieces = 0, limits = 0, splits = 0, left_out = 0, links = 0;
  };

  IRG_APART constexpr void shrink_to(const size_of_tree& to) {
    for (; links_.size() > to.links; links_.pop_back()) {
      link_of(links_.back()) = bsp_none;
      steps_[links_.back().node] = step_at(links_.back().node);
    }
    data_.vertices.resize(to.vertices, point<T, 3>{});
    data_.triangles.resize(to.triangles, triangle_indices{});
    data_.nodes.resize(to.nodes, bsp_node_3d{});
    planes_.erase(planes_.begin() + static_cast<std::ptrdiff_t>(to.nodes), planes_.end());
    steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(to.nodes), steps_.end());
    data_.pieces.resize(to.pieces, bsp_piece_3d{});
    data_.limits.resize(to.limits, bsp_limit_3d{});
    splits_ = to.splits, left_out_ = to.left_out;
  }
  [[nodiscard]] IRG_APART constexpr size_of_tree sizes() const noexcept {
    return {data_.vertices.size(),
            data_.triangles.size(),
            data_.nodes.size(),
            data_.pieces.size(),
            data_.limits.size(),
            splits_,
            left_out_,
            links_.size()};
  }

  IRG_APART constexpr std::uint32_t& link_of(const link& l) noexcept {
    bsp_node_3d& n = data_.nodes[l.node];
    return l.where == hung::in_front ? n.front : l.where == hung::behind ? n.back : n.beside;
  }

  IRG_APART constexpr void add(std::span<const point<T, 3>> vertices, std::span<const triangle_indices> triangles,
                               const bsp_choice& choice) {
    IRG_EXPECTS(choice.candidates > 0 && choice.judges > 0);
    const std::size_t links_before = links_.size();
    const auto base = static_cast<std::uint32_t>(data_.vertices.size());
    data_.vertices.insert(data_.vertices.end(), vertices.begin(), vertices.end());
    detail::bsp_cells_3d<T> cells{data_};
    task all{{}, {bsp_none, hung::in_front}};
    for (const triangle_indices& t : triangles) {
      const auto number = static_cast<std::uint32_t>(data_.triangles.size());
      for (const std::uint32_t v : t.v) IRG_EXPECTS(v < vertices.size());
      data_.triangles.push_back({{t.v[0] + base, t.v[1] + base, t.v[2] + base}});
      if (detail::has_area(data_, number))
        all.pieces.push_back({number, bsp_none, 0, 0});
      else
        ++left_out_;
    }
    std::vector<task> open;
    if (!all.pieces.empty()) open.push_back(std::move(all));
    std::vector<detail::open_piece> on;
    while (!open.empty()) {
      task t = std::move(open.back());
      open.pop_back();
      // The root, or what hangs where this would hang: there only before anything is added.
      std::uint32_t here = t.at.node != bsp_none ? link_of(t.at) : data_.nodes.empty() ? bsp_none : 0;
      const bool is_new = here == bsp_none;
      if (is_new) {
        here = make_node(cells.dividing_plane(t.pieces, choice));
        if (t.at.node != bsp_none) hang(here, t.at);
      }
      on.clear();
      task front{{}, {here, hung::in_front}}, back{{}, {here, hung::behind}};
      splits_ += cells.divide(t.pieces, {here, planes_[here]}, {front.pieces, back.pieces, on});
      if (!on.empty()) put_pieces(is_new ? here : beside(here), on);
      if (!back.pieces.empty()) open.push_back(std::move(back));
      if (!front.pieces.empty()) open.push_back(std::move(front));
    }
    for (auto i = static_cast<std::uint32_t>(steps_.size()); i < data_.nodes.size(); ++i) steps_.push_back(step_at(i));
    for (std::size_t i = links_before; i < links_.size(); ++i) steps_[links_[i].node] = step_at(links_[i].node);
  }
  IRG_APART constexpr std::uint32_t make_node(bsp_plane_3d plane) {
    const auto here = static_cast<std::uint32_t>(data_.nodes.size());
    const auto end = static_cast<std::uint32_t>(data_.pieces.size());
    data_.nodes.push_back({plane, end, end, bsp_none, bsp_none, bsp_none});
    planes_.push_back(detail::plane_of(data_, plane));
    return here;
  }
  IRG_APART constexpr void hang(std::uint32_t node, const link& at) {
    if (at.node < steps_.size()) links_.push_back(at);  // it was there before
    link_of(at) = node;
  }
  // A new node for pieces in the plane of one that is there.
  IRG_APART constexpr std::uint32_t beside(std::uint32_t node) {
    while (data_.nodes[node].beside != bsp_none) node = data_.nodes[node].beside;
    const std::uint32_t here = make_node(data_.nodes[node].plane);
    hang(here, {node, hung::beside});
    return here;
  }
  IRG_APART constexpr void put_pieces(std::uint32_t node, const std::vector<detail::open_piece>& on) {
    for (const detail::open_piece& p : on) data_.pieces.push_back({p.triangle, p.limits});
    data_.nodes[node].last = static_cast<std::uint32_t>(data_.pieces.size());
  }

  // What a visit asks of a node: its plane, what is below it behind and in front, and its piece if it has but one.
  struct walk_step {
    detail::walked_plane plane;
    std::uint32_t below[2], piece;
  };
  static constexpr std::uint32_t several = bsp_none - 1;

  [[nodiscard]] IRG_APART constexpr walk_step step_at(std::uint32_t i) const {
    const bsp_node_3d& n = data_.nodes[i];
    const bool has_one = n.beside == bsp_none && n.last - n.first <= 1;
    return {detail::walked_plane(planes_[i]),
            {n.back, n.front},
            !has_one           ? several
            : n.first < n.last ? n.first
                               : bsp_none};
  }

  template <class Sink, class Side>
  IRG_APART constexpr void walk(bsp_order order, Sink& sink, const Side& side_of_eye) const {
    const bool to_back = order == bsp_order::front_to_back;
    struct left_open {
      std::uint32_t own, late;  // what is left: a node's own pieces, and what lies beyond them
    };
    std::vector<left_open> open;
    for (std::uint32_t i = data_.nodes.empty() ? bsp_none : 0; i != bsp_none || !open.empty();) {
      if (i == bsp_none) {
        const left_open l = open.back();
        open.pop_back();
        give(l.own, to_back, sink);
        i = l.late;
        continue;
      }
      const walk_step& n = steps_[i];
      const bool front_first = (side_of_eye(i) > 0) == to_back;
      const std::uint32_t early = n.below[front_first ? 1 : 0], late = n.below[front_first ? 0 : 1];
      if (early != bsp_none)
        open.push_back({i, late});
      else
        give(i, to_back, sink);
      i = early != bsp_none ? early : late;
    }
  }
  // The pieces in a node's plane: those of nodes beside it have higher numbers.
  template <class Sink>
  IRG_APART constexpr void give(std::uint32_t node, bool to_back, Sink& sink) const {
    if (const walk_step& n = steps_[node]; n.piece != several) {
      if (n.piece != bsp_none) sink(data_.pieces[n.piece]);
      return;
    }
    if (to_back) {
      for (std::uint32_t i = node; i != bsp_none; i = data_.nodes[i].beside)
        for (std::uint32_t p = data_.nodes[i].first; p < data_.nodes[i].last; ++p) sink(data_.pieces[p]);
      return;
    }
    const auto give_node = [&](const bsp_node_3d& n) {
      for (std::uint32_t p = n.last; p-- > n.first;) sink(data_.pieces[p]);
    };
    if (data_.nodes[node].beside == bsp_none) return give_node(data_.nodes[node]);
    std::vector<std::uint32_t> nodes;  // to be taken from the end
    for (std::uint32_t i = node; i != bsp_none; i = data_.nodes[i].beside) nodes.push_back(i);
    for (; !nodes.empty(); nodes.pop_back()) give_node(data_.nodes[nodes.back()]);
  }

  bsp_data_3d<T> data_{};
  std::vector<detail::rounded_plane> planes_{};  // of the nodes
  std::vector<walk_step> steps_{};
  std::vector<link> links_{};  // from what was there to what was merged in
  size_of_tree fixed_{};
  std::size_t splits_ = 0, left_out_ = 0;
};

}  // namespace irg
