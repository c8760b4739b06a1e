// SPDX-License-Identifier: MIT
// A binary space partition of the picture's faces: the plane of a face parts the others into those nearer than it and
// those farther, which are parted in turn. A face on both sides is split. The tree, walked from far to near, is an
// order in which everything can be drawn.
//
// A part of a face is its face and limits (face_fragment), so that splitting makes no coordinate: which side a part
// lies on is decided at the pixels that it may have. Of planes equally deep the lower number is in front, so that
// coplanar faces have an order, too.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <irg/hidden/detail/crowded_window.hpp>
#include <irg/hidden/detail/part_box.hpp>
#include <irg/hidden/order_in_window.hpp>
#include <irg/hidden/ray_casting.hpp>
#include <irg/raster/draw_counts.hpp>
#include <irg/raster/face_fragment.hpp>
#include <irg/spatial/bsp_order.hpp>

namespace irg {

/// What a tree of faces consists of.
struct bsp_counts {
  std::int64_t faces = 0, pieces = 0;  // pieces: nodes, of which faces that were split have several
  std::int64_t depth = 0;
  constexpr bool operator==(const bsp_counts&) const = default;
};

/// The faces of a window as a tree, in space as the screen sees it.
/// shape   node 0 is the root; -1 stands for no child
struct bsp_of_faces {
  struct node {
    face_fragment part;
    cell_window box;  // holds all pixels of the part
    std::int32_t nearer = -1, farther = -1;
  };
  std::vector<screen_face> faces;
  std::vector<node> nodes;
  bsp_counts counts;

  bsp_of_faces() = default;
  bsp_of_faces(const bsp_of_faces&) = delete;  // parts point to the faces
  bsp_of_faces& operator=(const bsp_of_faces&) = delete;
  bsp_of_faces(bsp_of_faces&&) = default;
  bsp_of_faces& operator=(bsp_of_faces&&) = default;
};

namespace detail {

// Parts that a subtree is made of, and where it is hung.
template <DepthOrder Order>
struct bsp_task {
  std::vector<bsp_of_faces::node> parts;
  std::int32_t parent = -1;
  face_part side = face_part::nearer;
  std::int64_t depth = 0;
};

inline constexpr std::size_t bsp_candidates = 8, bsp_sample = 24;

inline namespace IRG_ABI {

// How a part lies to the plane of a face: as one of its limits says, or as its pixels do.
template <DepthOrder Order>
constexpr window_order order_of_part(const bsp_of_faces::node& part, const screen_face& plane) noexcept {
  for (const face_limit& l : part.part.limits)
    if (l.plane == &plane) return l.part == face_part::nearer ? window_order::nearer : window_order::farther;
  return order_in_window<Order>(*part.part.face, plane, part.box);
}

// The place of the part whose plane splits few of a sample and leaves as many before it as behind.
template <DepthOrder Order>
constexpr std::size_t best_plane(const std::vector<bsp_of_faces::node>& parts) {
  std::size_t best = 0;
  std::int64_t least = -1;
  const std::size_t n = parts.size(), tried = lesser(bsp_candidates, n), asked = lesser(bsp_sample, n);
  for (std::size_t c = 0; c < tried; ++c) {
    const std::size_t k = c * n / tried + n / (2 * tried);
    std::int64_t side[3] = {};
    for (std::size_t i = 0; i < asked; ++i)
      ++side[static_cast<int>(order_of_part<Order>(parts[i * n / asked], *parts[k].part.face))];
    const std::int64_t uneven = greater(side[0], side[1]) - lesser(side[0], side[1]), cost = 4 * side[2] + uneven;
    if (least < 0 || cost < least) least = cost, best = k;
  }
  return best;
}

// Parts the others of a task by the plane of one of its parts, which becomes a node.
template <DepthOrder Order>
constexpr void part_by_plane(bsp_of_faces& tree, bsp_task<Order>& task, std::vector<bsp_task<Order>>& left) {
  const std::size_t k = best_plane<Order>(task.parts);
  const auto id = static_cast<std::int32_t>(tree.nodes.size());
  if (task.parent >= 0) {
    bsp_of_faces::node& parent = tree.nodes[static_cast<std::size_t>(task.parent)];
    (task.side == face_part::nearer ? parent.nearer : parent.farther) = id;
  }
  bsp_task<Order> nearer{{}, id, face_part::nearer, task.depth + 1},
      farther{{}, id, face_part::farther, task.depth + 1};
  const screen_face& plane = *task.parts[k].part.face;
  for (std::size_t i = 0; i < task.parts.size(); ++i) {
    if (i == k) continue;
    bsp_of_faces::node& p = task.parts[i];
    const window_order order = p.part.face == &plane ? window_order::farther : order_of_part<Order>(p, plane);
    if (order == window_order::crossing) {
      fragment_parts both = split_fragment(p.part, plane);
      const auto add = [](bsp_task<Order>& to, face_fragment&& part, const cell_window& of) {
        const cell_window box = trimmed_box<Order>(part, of);
        if (!has_no_pixel<Order>(part, box)) to.parts.push_back({std::move(part), box});
      };
      add(nearer, std::move(both.nearer), p.box);
      add(farther, std::move(both.farther), p.box);
    } else {
      (order == window_order::nearer ? nearer : farther).parts.push_back(std::move(p));
    }
  }
  tree.counts.depth = greater(tree.counts.depth, task.depth + 1);
  tree.nodes.push_back(std::move(task.parts[k]));
  if (!nearer.parts.empty()) left.push_back(std::move(nearer));
  if (!farther.parts.empty()) left.push_back(std::move(farther));
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// The tree of the faces that a window of the picture may show.
/// shape   faces: a container of screen_face
/// gives   an empty tree where no face touches the window
/// exact   sides by is_nearer at pixel centres
/// cost    n log n where planes split little: 8 planes are tried on 24 parts for each node; allocates. No recursion
/// source  Fuchs, Kedem and Naylor 1980
template <DepthOrder Order = nearer_is_greater, class Faces>
[[nodiscard]] constexpr bsp_of_faces build_bsp(const Faces& faces, const cell_window& window) {
  bsp_of_faces tree;
  tree.faces = detail::copied_faces<Order>(faces, window);
  tree.counts.faces = static_cast<std::int64_t>(tree.faces.size());
  std::vector<detail::bsp_task<Order>> left(1, detail::bsp_task<Order>{});
  for (const screen_face& f : tree.faces) left[0].parts.push_back({{&f, {}}, intersect(f.coverage.bounds, window)});
  if (tree.faces.empty()) left.clear();
  while (!left.empty()) {
    detail::bsp_task<Order> task = std::move(left.back());
    left.pop_back();
    detail::part_by_plane<Order>(tree, task, left);
  }
  tree.counts.pieces = static_cast<std::int64_t>(tree.nodes.size());
  return tree;
}

/// Calls visit(node) for all nodes of a tree in the order of their depths.
/// cost    linear, without recursion
template <class Visit>
constexpr void walk_bsp(const bsp_of_faces& tree, bsp_order order, Visit&& visit) {
  struct step {
    std::int32_t node;
    bool opened;
  };
  std::vector<step> left;
  if (!tree.nodes.empty()) left.push_back({0, false});
  while (!left.empty()) {
    const step s = left.back();
    left.pop_back();
    const bsp_of_faces::node& n = tree.nodes[static_cast<std::size_t>(s.node)];
    if (s.opened) {
      visit(n);
      continue;
    }
    const bool back = order == bsp_order::back_to_front;
    const std::int32_t first = back ? n.farther : n.nearer, last = back ? n.nearer : n.farther;
    if (last >= 0) left.push_back({last, false});
    left.push_back({s.node, true});
    if (first >= 0) left.push_back({first, false});
  }
}

/// Draws the faces of a tree from back to front: into each pixel that one of them covers the number of the nearest.
/// needs   a tree built in the same order, for a window that the ids hold
template <DepthOrder Order = nearer_is_greater>
constexpr void draw_bsp(const bsp_of_faces& tree, image<std::uint32_t>& ids) {
  walk_bsp(tree, bsp_order::back_to_front, [&](const bsp_of_faces::node& n) {
    covered_spans(n.part.face->coverage, n.box, [&](const span_of_cells& s) {
      for (int x = s.x_first; x < s.x_last; ++x)
        if (n.part.limits.empty() || covers<Order>(n.part, x, s.y)) ids(x, s.y) = n.part.face->number;
    });
  });
}

}  // namespace IRG_ABI

namespace detail {
inline namespace IRG_ABI {

// Faces by their places.
struct pointed_faces {
  const std::vector<window_face>& list;
  constexpr std::size_t size() const noexcept { return list.size(); }
  constexpr const screen_face& operator[](std::size_t i) const noexcept { return *list[i].face; }
};

inline constexpr std::size_t bsp_crowd = 16;  // faces: windows with more are cut into four, each with a tree of its own

template <DepthOrder Order>
constexpr void draw_by_trees(const std::vector<window_face>& list, const cell_window& w, image<std::uint32_t>& ids,
                             draw_counts& counts) {
  if (w.empty()) return;
  std::int64_t hidden = 0;
  const std::vector<window_face> faces = faces_of_window<Order>(list, w, hidden);
  if (is_one_pixel(w)) {
    if (const screen_face* seen = seen_in_pixel<Order>(faces, w)) ids(w.x_first, w.y_first) = seen->number;
  } else if (faces.size() > bsp_crowd) {
    for (const cell_window& part : quarters(w)) draw_by_trees<Order>(faces, part, ids, counts);
  } else {
    const bsp_of_faces tree = build_bsp<Order>(pointed_faces{faces}, w);
    counts.tested += tree.counts.pieces;
    draw_bsp<Order>(tree, ids);
  }
}

}  // namespace IRG_ABI
}  // namespace detail

/// A hidden-surface method: the faces as binary space partitions, drawn from back to front. A crowded window is cut
/// into four, since faces that cross each other make trees that grow with the square of their number.
/// gives   the number of the nearest face into the pixels that some face covers; the others stay as they are;
///         counts.tested counts the parts drawn
/// exact   as picture_face_at, in every pixel
/// cost    build_bsp, and each pixel as often as it is covered; memory for the tree, none for depths
/// source  Fuchs, Kedem and Naylor 1980
template <DepthOrder Order = nearer_is_greater>
struct bsp_painter {
  /// Whether the picture is the exact one.
  [[nodiscard]] IRG_APART static constexpr bool finds_nearest() noexcept { return true; }

  template <class Faces>
  IRG_APART constexpr void operator()(const Faces& faces, const cell_window& window, image<std::uint32_t>& ids,
                                      draw_counts& counts) const {
    const std::vector<screen_face> list = detail::copied_faces<Order>(faces, window);
    std::vector<detail::window_face> all;
    all.reserve(list.size());
    for (const screen_face& f : list) all.push_back(detail::window_face_of<Order>(f));
    detail::draw_by_trees<Order>(all, window, ids, counts);
  }
};

}  // namespace irg
