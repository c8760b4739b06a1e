// SPDX-License-Identifier: MIT
// A binary space partition of the picture's faces: the plane of a face parts the others into those nearer than it and
// those farther, which are parted in turn. A face on both sides is split. The tree, walked from far to near, is an
// order in which everything can be drawn.
//
// A part of a face is its face and limits (face_fragment), so that splitting makes no coordinate: which side a part
// lies on is decided at the pixels that it may have. Of planes equally deep the lower number is in front, so that
// coplanar faces have an order, too.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <irg/hidden/ray_casting.hpp>
#include <irg/raster/draw_counts.hpp>
#include <irg/raster/face_fragment.hpp>
#include <irg/raster/image.hpp>
#include <irg/spatial/bsp_order.hpp>
#if IRG_BODIES
#include <irg/hidden/detail/crowded_window.hpp>
#include <irg/hidden/detail/pixel_hull.hpp>
#include <irg/hidden/order_in_window.hpp>
#include <irg/raster/triangle_coverage.hpp>
#endif

namespace irg {

/// What a tree of faces consists of.
struct bsp_counts {
  std::int64_t faces = 0, pieces = 0;  // pieces: nodes, of which faces that were split have several
  std::int64_t depth = 0;
  std::int64_t asked = 0;  // parts that were asked, one by one, on which side of a plane they lie
  bool operator==(const bsp_counts&) const = default;
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

namespace detail::inline IRG_COMPILED_ABI {

template <DepthOrder Order>
IRG_API bsp_of_faces tree_of_faces(std::vector<screen_face>& list, const cell_window& window);
template <DepthOrder Order>
IRG_API void draw_tree(image<std::uint32_t>& ids, const bsp_of_faces& tree);
template <DepthOrder Order>
IRG_API void paint_by_trees(image<std::uint32_t>& ids, std::vector<screen_face>& list, const cell_window& window,
                            draw_counts& counts);

}  // namespace detail::inline IRG_COMPILED_ABI

inline namespace IRG_ABI {

/// The tree of the faces that a window of the picture may show.
/// shape   faces: a container of screen_face
/// gives   an empty tree where no face touches the window. A face is cut by the planes alone that some of its pixels
///         lie before and some behind: none of a convex body, but where pixels on its outline belong to two faces
///         equally near, or where rounding has bent its faces
/// exact   sides by is_nearer at pixel centres
/// cost    n log n where planes split little, and for convex bodies: 8 planes are tried for each node, up to 32 where
///         all of them cut, and meet the parts that their bounds do not tell from them. Faces that go through each
///         other make as many pieces as their planes cut them in. Allocates; no recursion deeper than log n
/// source  Fuchs, Kedem and Naylor 1980
template <DepthOrder Order = nearer_is_greater, class Faces>
[[nodiscard]] constexpr bsp_of_faces build_bsp(const Faces& faces, const cell_window& window) {
  std::vector<screen_face> list = detail::copied_faces<Order>(faces, window);
  return detail::tree_of_faces<Order>(list, window);
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
constexpr void draw_bsp(image<std::uint32_t>& ids, const bsp_of_faces& tree) {
  static_assert(detail::has_methods<Order>,
                "irg: define IRG_HEADER_ONLY before the first header of irg to draw faces in an order of your own");
  detail::draw_tree<Order>(ids, tree);
}
template <DepthOrder Order = nearer_is_greater>
[[deprecated("irg: draw_bsp(ids, tree)")]] constexpr void draw_bsp(const bsp_of_faces& tree,
                                                                   image<std::uint32_t>& ids) {
  draw_bsp<Order>(ids, tree);
}

}  // namespace IRG_ABI

/// A hidden-surface method: the faces as binary space partitions, drawn from back to front. A crowded window is cut
/// into four, since faces that cross each other make trees that grow with the square of their number.
/// gives   the number of the nearest face into the pixels that some face covers; the others stay as they are;
///         counts.tested counts the parts drawn
/// exact   as picture_face_at, in every pixel
/// cost    build_bsp, and each pixel as often as it is covered; memory for the tree, none for depths
/// source  Fuchs, Kedem and Naylor 1980
template <DepthOrder Order = nearer_is_greater>
struct bsp_painter : exact_method {
  template <class Faces>
  IRG_APART constexpr void operator()(const Faces& faces, const cell_window& window, image<std::uint32_t>& ids,
                                      draw_counts& counts) const {
    std::vector<screen_face> list = detail::copied_faces<Order>(faces, window);
    detail::paint_by_trees<Order>(ids, list, window, counts);
  }
};

}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

/// A corner of a face among pixels and stretched depths, whose places are the centres of pixels.
constexpr point<double, 3> stretched(const screen_vertex& v, double stretch) noexcept {
  const auto place = [](std::int32_t at) { return product(static_cast<double>(at) - half_pixel, 1.0 / one_pixel); };
  return {place(v.position.x), place(v.position.y), product(widened(v.depth), stretch)};
}

/// The plane of a face among pixels and stretched depths: positive before it. Zero for orders that know no depths.
///
/// The form is area (z - z0) - (right (x - x0) + down (y - y0)), where differences of positions are exact, those of
/// depths off by u = 2^-53 of themselves, area by u, right and down by 4u of the sum of their terms. Nothing is
/// subnormal: depths are floats, stretched by less than 2^160.
template <DepthOrder Order>
constexpr linear_form<3> plane_form(const screen_face& f, double stretch) noexcept {
  const point<double, 3> o = stretched(f.v[0], stretch), p = stretched(f.v[1], stretch), q = stretched(f.v[2], stretch);
  const vec<double, 3> u = p - o, v = q - o;
  const double a = product(u[2], v[1]), b = product(v[2], u[1]), c = product(v[2], u[0]), d = product(u[2], v[0]);
  const double e = product(u[0], v[1]), g = product(u[1], v[0]), area = e - g;
  const double sign = area < 0 ? -depth_sense<Order> : depth_sense<Order>;
  return {{sign * (b - a), sign * (d - c), sign * area},
          {magnitude(a) + magnitude(b), magnitude(c) + magnitude(d), magnitude(e) + magnitude(g)},
          o};
}

// A part, and the corners of the hull of its pixels, of which there are some.
struct bsp_open_part {
  bsp_of_faces::node node;
  pixel_hull pixels{};
};
using bsp_face_cells = bsp_open_cells<bsp_open_part, 3>;

// Parts that a subtree is made of, and where it is hung.
struct bsp_task {
  std::uint32_t cell = no_index;
  std::int32_t parent = -1;
  face_part side = face_part::nearer;
  std::int64_t depth = 0;
};

inline constexpr std::size_t bsp_candidates = 8, bsp_sample = 24, bsp_looks = 40;

// How a part lies to the plane of a face: as one of its limits says, or as its pixels do.
template <DepthOrder Order>
constexpr window_order order_of_part(const bsp_open_part& p, const screen_face& plane) noexcept {
  for (const face_limit& l : p.node.part.limits)
    if (l.plane == &plane) return l.part == face_part::nearer ? window_order::nearer : window_order::farther;
  const window_order order = order_in_window<Order>(*p.node.part.face, plane, p.node.box);
  return order == window_order::crossing ? order_of_pixels<Order>(p.pixels, *p.node.part.face, plane) : order;
}

// A tree that is being built. Parts stand in cells with boxes of pixels and depths; depths are stretched so that the
// picture is about as deep as wide, by a power of two, which rounds nothing.
template <DepthOrder Order>
struct bsp_face_state {
  bsp_of_faces& tree;
  double stretch = 1;
  std::vector<bsp_of_faces::node> unseen{};
  bsp_face_cells cells{}, known{};
  std::uint32_t faces = no_index;  // all of them, in known, once ties were met
  std::vector<bsp_task> left{};
};

// How much depths are stretched.
constexpr double stretch_of(const std::vector<screen_face>& faces, const cell_window& window) noexcept {
  double stretch = 1;
  float low = 0.0f, high = 0.0f;
  for (const screen_face& f : faces) {
    low = minimum(low, f.depth_low);
    high = maximum(high, f.depth_high);
  }
  const double wide = maximum(window.x_last - window.x_first, window.y_last - window.y_first);
  const double deep = widened(high) - widened(low);
  while (deep > 0 && deep * stretch < wide) stretch *= 2;
  while (deep * stretch > 2 * wide && stretch > 0x1p-200) stretch *= 0.5;
  return stretch;
}

template <DepthOrder Order>
constexpr bsp_face_cells::entry entry_of_part(const bsp_face_state<Order>& s, bsp_of_faces::node&& node,
                                              const pixel_hull& pixels, std::uint32_t place) {
  const screen_face& f = *node.part.face;
  const cell_window& w = node.box;
  const box<double, 3> bounds{
      {static_cast<double>(w.x_first), static_cast<double>(w.y_first), widened(f.depth_low) * s.stretch},
      {static_cast<double>(w.x_last - 1), static_cast<double>(w.y_last - 1), widened(f.depth_high) * s.stretch}};
  bsp_bounds<3> within =
      bounds_of<3>(std::array{stretched(f.v[0], s.stretch), stretched(f.v[1], s.stretch), stretched(f.v[2], s.stretch)},
                   plane_form<Order>(f, s.stretch).slope);
  within.around = bounds;
  return {{std::move(node), pixels}, within, place};
}

template <DepthOrder Order>
constexpr void open_root(bsp_face_state<Order>& s, const cell_window& window) {
  std::vector<bsp_face_cells::entry> all;
  all.reserve(s.tree.faces.size());
  for (const screen_face& f : s.tree.faces) {
    const cell_window box = intersect(f.coverage.bounds, window);
    bsp_of_faces::node node{face_fragment{&f}, box};
    const pixel_hull pixels = hull_of_face(f, box);
    if (pixels.empty())
      s.unseen.push_back(std::move(node));
    else
      all.push_back(entry_of_part(s, std::move(node), pixels, static_cast<std::uint32_t>(&f - s.tree.faces.data())));
  }
  if (const std::uint32_t cell = s.cells.make_cell(std::move(all)); cell != no_index) s.left.push_back({cell});
}

// How the parts of a cell lie to a plane, or some of them where many lie near it.
template <DepthOrder Order>
constexpr bsp_sides sides_of_plane(const bsp_face_state<Order>& s, std::uint32_t cell, const screen_face& plane) {
  const auto count = [&](const bsp_open_part& p, bsp_sides& sides) {
    if (p.node.part.face == &plane) return;
    ++s.tree.counts.asked;
    const window_order order = order_of_part<Order>(p, plane);
    ++(order == window_order::nearer ? sides.front : order == window_order::farther ? sides.back : sides.cut);
  };
  const std::size_t n = s.cells.size(cell), asked = minimum(bsp_sample, n);
  const linear_form<3> form = plane_form<Order>(plane, s.stretch);
  const auto side_of = [&](const bsp_bounds<3>& b) { return rounded_side_of(b, form); };
  bsp_sides sides = s.cells.count_sides(cell, side_of, count, bsp_looks);
  if (sides.front + sides.back + sides.cut + bsp_sample < n) {
    sides = {};
    for (std::size_t i = 0; i < asked; ++i) count(s.cells.at(cell, i * n / asked), sides);
    sides = {sides.front * n / asked, sides.back * n / asked, sides.cut * n / asked};
  }
  return sides;
}

// The face whose plane cuts few and leaves as many before it as behind; more are tried while each cuts some.
template <DepthOrder Order>
constexpr const screen_face& best_face_plane(const bsp_face_state<Order>& s, std::uint32_t cell) {
  const std::size_t n = s.cells.size(cell), tried = minimum(bsp_candidates, n), most = minimum(4 * bsp_candidates, n);
  const screen_face* best = nullptr;
  std::size_t least = 0, least_cut = 0;
  for (std::size_t c = 0; c < most && (c < tried || least_cut > 0); ++c) {
    // Steps of an odd part of the whole, so that further ones fall between those before.
    const std::size_t k = c < tried ? c * n / tried + n / (2 * tried) : c * n / most;
    const screen_face& plane = *s.cells.at(cell, k).node.part.face;
    const bsp_sides sides = sides_of_plane(s, cell, plane);
    const std::size_t cost = 8 * sides.cut + maximum(sides.front, sides.back) - minimum(sides.front, sides.back);
    if (best != nullptr && cost >= least) continue;
    least = cost;
    least_cut = sides.cut;
    best = &plane;
  }
  return *best;
}

template <DepthOrder Order, class Nearer, class Farther>
constexpr void split_part(bsp_face_state<Order>& s, const bsp_face_cells::entry& e, const screen_face& plane,
                          const Nearer& nearer, const Farther& farther) {
  const bsp_open_part& p = e.item;
  const hull_halves hulls = split_hull<Order>(p.pixels, *p.node.part.face, plane);
  fragment_parts both = split_fragment(p.node.part, plane);
  bsp_of_faces::node in_front{std::move(both.nearer), window_of(hulls.nearer)};
  bsp_of_faces::node behind{std::move(both.farther), window_of(hulls.farther)};
  nearer(entry_of_part(s, std::move(in_front), hulls.nearer, e.place));
  farther(entry_of_part(s, std::move(behind), hulls.farther, e.place));
}

// A part on both sides of a plane only since some of its pixels lie in it, by their numbers, as on the common edge of
// two faces, of which one has the pixels: on the side of the others where no face is there that these pixels must be
// told from.
template <DepthOrder Order>
constexpr window_order order_without_ties(bsp_face_state<Order>& s, const bsp_open_part& p, const screen_face& plane) {
  const screen_face& f = *p.node.part.face;
  const pixels_in_plane ties = find_pixels_in_plane<Order>(p.pixels, f, plane);
  if (ties.others == window_order::crossing) return window_order::crossing;
  if (s.faces == no_index) {
    std::vector<bsp_face_cells::entry> all;
    for (const screen_face& g : s.tree.faces)
      all.push_back(
          entry_of_part(s, {face_fragment{&g}, g.coverage.bounds}, {}, static_cast<std::uint32_t>(all.size())));
    s.faces = s.known.make_cell(std::move(all));
  }
  for (cell at = ties.first;; at.x += ties.step.x, at.y += ties.step.y) {
    const auto may_hold = [&](const bsp_bounds<3>& b) {
      const auto& [low, high] = b.around;
      return low[0] <= at.x && at.x <= high[0] && low[1] <= at.y && at.y <= high[1];
    };
    if (s.known.any_of(s.faces, may_hold, [&](const bsp_open_part& other) {
          const screen_face& g = *other.node.part.face;
          return &g != &f && covers(g, at.x, at.y) && compare_depths<Order>(g, plane, at.x, at.y) == 0;
        }))
      return window_order::crossing;
    if (at == ties.last) return ties.others;
  }
}

// Parts the others of a cell by the plane of one of its parts, which becomes a node.
template <DepthOrder Order>
constexpr void part_by_plane(bsp_face_state<Order>& s, const bsp_task& task) {
  const screen_face& plane = best_face_plane(s, task.cell);
  const auto id = static_cast<std::int32_t>(s.tree.nodes.size());
  if (task.parent >= 0) {
    bsp_of_faces::node& parent = s.tree.nodes[static_cast<std::size_t>(task.parent)];
    (task.side == face_part::nearer ? parent.nearer : parent.farther) = id;
  }
  s.tree.nodes.push_back({});
  s.tree.counts.depth = maximum(s.tree.counts.depth, task.depth + 1);
  const linear_form<3> form = plane_form<Order>(plane, s.stretch);
  const auto side_of = [&](const bsp_bounds<3>& b) { return rounded_side_of(b, form); };
  const bsp_halves halves =
      s.cells.divide(task.cell, side_of, [&](bsp_face_cells::entry&& e, const auto& nearer, const auto& farther) {
        bsp_open_part& p = e.item;
        if (p.node.part.face == &plane) {
          bsp_of_faces::node& here = s.tree.nodes[static_cast<std::size_t>(id)];
          if (here.part.face == nullptr)
            here = std::move(p.node);
          else
            farther(std::move(e));
          return;
        }
        ++s.tree.counts.asked;
        window_order order = order_of_part<Order>(p, plane);
        if (order == window_order::crossing) order = order_without_ties(s, p, plane);
        if (order == window_order::crossing)
          split_part(s, e, plane, nearer, farther);
        else if (order == window_order::nearer)
          nearer(std::move(e));
        else
          farther(std::move(e));
      });
  if (halves.front != no_index) s.left.push_back({halves.front, id, face_part::nearer, task.depth + 1});
  if (halves.back != no_index) s.left.push_back({halves.back, id, face_part::farther, task.depth + 1});
}

// Faces without pixels have no side: they become a balanced tree of their own, below the last node on the way farther.
template <DepthOrder Order>
constexpr void hang_unseen(bsp_face_state<Order>& s) {
  const std::size_t first = s.tree.nodes.size();
  std::int64_t depth = 1;
  if (first != 0 && !s.unseen.empty()) {
    bsp_of_faces::node* last = &s.tree.nodes[0];
    for (; last->farther >= 0; ++depth) last = &s.tree.nodes[static_cast<std::size_t>(last->farther)];
    last->farther = static_cast<std::int32_t>(first);
    ++depth;
  }
  const auto child = [&](std::size_t i) {
    return i < s.unseen.size() ? static_cast<std::int32_t>(first + i) : std::int32_t{-1};
  };
  for (std::size_t i = 0; i < s.unseen.size(); ++i) {
    s.unseen[i].nearer = child(2 * i + 1);
    s.unseen[i].farther = child(2 * i + 2);
    s.tree.nodes.push_back(std::move(s.unseen[i]));
  }
  if (!s.unseen.empty())
    s.tree.counts.depth =
        maximum(s.tree.counts.depth, depth + static_cast<std::int64_t>(std::bit_width(s.unseen.size())) - 1);
}

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
    draw_bsp<Order>(ids, tree);
  }
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <DepthOrder Order>
IRG_API bsp_of_faces tree_of_faces(std::vector<screen_face>& list, const cell_window& window) {
  leave_out_repeated<Order>(list);
  bsp_of_faces tree;
  tree.faces = std::move(list);
  tree.counts.faces = static_cast<std::int64_t>(tree.faces.size());
  bsp_face_state<Order> s{tree, stretch_of(tree.faces, window)};
  for (open_root(s, window); !s.left.empty();) {
    const bsp_task task = s.left.back();
    s.left.pop_back();
    part_by_plane(s, task);
  }
  hang_unseen(s);
  tree.counts.pieces = static_cast<std::int64_t>(tree.nodes.size());
  return tree;
}

template <DepthOrder Order>
IRG_API void draw_tree(image<std::uint32_t>& ids, const bsp_of_faces& tree) {
  walk_bsp(tree, bsp_order::back_to_front, [&](const bsp_of_faces::node& n) {
    covered_spans(n.part.face->coverage, n.box, [&](const span_of_cells& s) {
      for (int x = s.x_first; x < s.x_last; ++x)
        if (n.part.limits.empty() || covers<Order>(n.part, x, s.y)) ids(x, s.y) = n.part.face->number;
    });
  });
}

template <DepthOrder Order>
IRG_API void paint_by_trees(image<std::uint32_t>& ids, std::vector<screen_face>& list, const cell_window& window,
                            draw_counts& counts) {
  leave_out_repeated<Order>(list);
  std::vector<window_face> all;
  all.reserve(list.size());
  for (const screen_face& f : list) all.push_back(window_face_of<Order>(f));
  draw_by_trees<Order>(all, window, ids, counts);
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
