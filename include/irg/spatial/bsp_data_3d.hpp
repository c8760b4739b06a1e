// SPDX-License-Identifier: MIT
// What a BSP tree in space consists of: numbers only, so that it can be written, read and checked.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/core/vocabulary.hpp>
#include <irg/math/vec.hpp>
#include <irg/spatial/bsp_order.hpp>
#if IRG_BODIES
#include <irg/core/is_finite.hpp>
#include <irg/geometry/point_on_triangle.hpp>
#endif

namespace irg {

/// A plane that divides a cell: of triangle `source`, whose front is where its corners run counter-clockwise; or, axis
/// being 0, 1 or 2, through vertex `source` across that axis, its front where the coordinate is greater.
struct bsp_plane_3d {
  static constexpr std::uint32_t of_triangle = 3;
  std::uint32_t source = no_index, axis = of_triangle;
  friend constexpr bool operator==(const bsp_plane_3d&, const bsp_plane_3d&) = default;
};

/// A limit of a piece: the part of it in front (1) or behind (-1) the plane of a node.
/// shape   next: the limit to which this one adds, or no_index
struct bsp_limit_3d {
  std::uint32_t node = no_index;
  std::int32_t side = 0;
  std::uint32_t next = no_index;
  friend constexpr bool operator==(const bsp_limit_3d&, const bsp_limit_3d&) = default;
};

/// A piece of a triangle: what all limits leave of it, the whole where there are none.
struct bsp_piece_3d {
  std::uint32_t triangle = no_index, limits = no_index;
  friend constexpr bool operator==(const bsp_piece_3d&, const bsp_piece_3d&) = default;
};

/// A plane that divides what is left: pieces first to last - 1 lie in it.
/// shape   front, back and beside are nodes, or no_index; `beside` has further pieces in the same plane and no cells
struct bsp_node_3d {
  bsp_plane_3d plane;
  std::uint32_t first = 0, last = 0, front = no_index, back = no_index, beside = no_index;
  friend constexpr bool operator==(const bsp_node_3d&, const bsp_node_3d&) = default;
};

/// The triangles of a tree, and the tree.
template <Floating T>
struct bsp_data_3d {
  std::vector<point<T, 3>> vertices;
  std::vector<triangle_indices> triangles;
  std::vector<bsp_node_3d> nodes;  // each stands before those below it; the first one is the root
  std::vector<bsp_piece_3d> pieces;
  std::vector<bsp_limit_3d> limits;  // each stands behind its `next`
  bool operator==(const bsp_data_3d&) const = default;
};

/// What is wrong with a tree's numbers. `index` is a number beyond its array, `flat` a triangle without area or not
/// finite that is used, `shape` a node that hangs nowhere, twice or before its parent, or pieces out of order.
enum class bsp_defect { none, index, flat, shape };

/// Where it is: in a triangle, a node, a piece or a limit.
enum class bsp_part { triangle, node, piece, limit };

/// A defect, and the place of what has it in its array.
struct bsp_fault {
  bsp_defect defect = bsp_defect::none;
  bsp_part part = bsp_part::triangle;
  std::size_t place = 0;
  friend constexpr bool operator==(const bsp_fault&, const bsp_fault&) = default;
};

inline namespace IRG_COMPILED_ABI {

/// The first thing by which these numbers are no tree that can be visited: with none, nothing is read out of bounds and
/// every visit ends. That the pieces lie where their nodes say is not looked into.
/// cost    linear; allocates a byte a node
template <Floating T>
[[nodiscard]] IRG_API bsp_fault find_bsp_fault(const bsp_data_3d<T>& d);

}  // namespace IRG_COMPILED_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

template <Floating T>
constexpr bool has_area(const bsp_data_3d<T>& d, std::uint32_t triangle) noexcept {
  const auto& [v] = d.triangles[triangle];
  for (const std::uint32_t i : v)
    for (int k = 0; k < 3; ++k)
      if (!is_finite(d.vertices[i][k])) return false;
  return !are_collinear(d.vertices[v[0]], d.vertices[v[1]], d.vertices[v[2]]);
}

// The first node that is wrong, or the number of nodes.
template <Floating T>
constexpr bsp_fault find_node_fault(const bsp_data_3d<T>& d) {
  std::vector<std::uint8_t> hung(d.nodes.size(), std::uint8_t{0});
  std::uint32_t pieces = 0;
  for (std::size_t i = 0; i < d.nodes.size(); ++i) {
    const bsp_node_3d& n = d.nodes[i];
    const auto wrong = [&](bsp_defect what) { return bsp_fault{what, bsp_part::node, i}; };
    if (i != 0 && hung[i] == 0) return wrong(bsp_defect::shape);
    const bool is_triangle = n.plane.axis == bsp_plane_3d::of_triangle;
    if (n.plane.axis > bsp_plane_3d::of_triangle) return wrong(bsp_defect::index);
    if (n.plane.source >= (is_triangle ? d.triangles.size() : d.vertices.size())) return wrong(bsp_defect::index);
    if (is_triangle && !has_area(d, n.plane.source)) return wrong(bsp_defect::flat);
    if (!is_triangle && !is_finite(d.vertices[n.plane.source][static_cast<int>(n.plane.axis)]))
      return wrong(bsp_defect::flat);
    if (n.first > n.last || n.last > d.pieces.size()) return wrong(bsp_defect::index);
    if (n.first != pieces) return wrong(bsp_defect::shape);
    pieces = n.last;
    for (const std::uint32_t below : {n.front, n.back, n.beside}) {
      if (below == no_index) continue;
      if (below >= d.nodes.size()) return wrong(bsp_defect::index);
      if (below <= i || hung[below] != 0) return wrong(bsp_defect::shape);
      hung[below] = 1;
    }
    if (n.beside != no_index && (d.nodes[n.beside].front != no_index || d.nodes[n.beside].back != no_index))
      return wrong(bsp_defect::shape);
  }
  if (pieces != d.pieces.size()) return {bsp_defect::shape, bsp_part::piece, pieces};
  return {};
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API bsp_fault find_bsp_fault(const bsp_data_3d<T>& d) {
  for (std::size_t i = 0; i < d.triangles.size(); ++i)
    for (const std::uint32_t v : d.triangles[i].v)
      if (v >= d.vertices.size()) return {bsp_defect::index, bsp_part::triangle, i};
  if (const bsp_fault f = detail::find_node_fault(d); f.defect != bsp_defect::none) return f;
  for (std::size_t i = 0; i < d.pieces.size(); ++i) {
    const bsp_piece_3d& p = d.pieces[i];
    if (p.triangle >= d.triangles.size() || (p.limits != no_index && p.limits >= d.limits.size()))
      return {bsp_defect::index, bsp_part::piece, i};
    if (!detail::has_area(d, p.triangle)) return {bsp_defect::flat, bsp_part::piece, i};
  }
  for (std::size_t i = 0; i < d.limits.size(); ++i) {
    const bsp_limit_3d& l = d.limits[i];
    if (l.node >= d.nodes.size()) return {bsp_defect::index, bsp_part::limit, i};
    if ((l.side != 1 && l.side != -1) || (l.next != no_index && l.next >= i))
      return {bsp_defect::shape, bsp_part::limit, i};
  }
  return {};
}

}  // namespace irg::inline IRG_COMPILED_ABI
#endif
