// SPDX-License-Identifier: MIT
// A scene that does not move, drawn through its BSP tree: the tree is built once, in space; for an eye its pieces are
// put in order, and painted from back to front without a depth buffer. A piece is drawn as its face, as snapped as in
// every other picture, in those pixels that lie within its limits.
//
// What tells a limit is the ray through the pixel's centre: where it meets the plane of the face, and on which side of
// the limit's plane that is. All are functions of the screen, linear in x, y and depth, and rounding keeps their order:
// of two faces that one plane cuts, the one in front of it is painted later than the one behind, in every pixel.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/hidden/detail/with_items.hpp>
#include <irg/math/mat.hpp>
#include <irg/raster/draw_counts.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/screen_face.hpp>
#include <irg/raster/screen_mapping.hpp>
#include <irg/spatial/bsp_tree_3d.hpp>
#if IRG_BODIES
#include <irg/core/contract.hpp>
#include <irg/core/conversion.hpp>
#include <irg/math/exact_matrix.hpp>
#include <irg/math/length.hpp>
#endif

namespace irg {
namespace detail {

// A plane of space on the screen: right x + down y + depth z + rest is positive in front of it, x and y being those of
// a pixel's centre in pixels.
struct plane_on_screen {
  double right = 0, down = 0, depth = 0, rest = 0;

  IRG_INLINE constexpr double at(double x, double y) const noexcept {
    return product(right, x) + product(down, y) + rest;
  }
};

struct placed_piece {
  std::uint32_t rank, limits;
};

// The pieces of a tree in their order from back to front, and the planes that limit them.
struct pieces_on_screen {
  std::vector<std::uint32_t> starts{};  // of each triangle's pieces
  std::vector<placed_piece> placed{};
  std::vector<plane_on_screen> of_node{}, of_triangle{};
};

inline namespace IRG_COMPILED_ABI {

template <Floating T>
IRG_API pieces_on_screen place_pieces(const bsp_tree_3d<T>& tree, const point<T, 3>& eye, const mat<T, 4, 4>& to_clip,
                                      const screen_mapping<T>& mapping);
template <Floating T>
IRG_API pieces_on_screen place_pieces(const bsp_tree_3d<T>& tree, const vec<T, 3>& to_eye, const mat<T, 4, 4>& to_clip,
                                      const screen_mapping<T>& mapping);
template <Floating T, class Faces>
IRG_API void paint_pieces(const bsp_data_3d<T>& d, const pieces_on_screen& p, const Faces& faces,
                          const cell_window& window, image<std::uint32_t>& ids, draw_counts& counts);

}  // namespace IRG_COMPILED_ABI
}  // namespace detail

/// A hidden-surface method for one eye: the pieces of a tree in their order from back to front.
/// shape   a method for `render`: the faces it is given have the numbers of the tree's triangles
/// needs   a tree that stays as it is while this lives; the eye from which to_clip projects, or the direction to it
template <Floating T>
class bsp_scene_painter {
public:
  template <class Eye>
  IRG_APART constexpr bsp_scene_painter(const bsp_tree_3d<T>& tree, const Eye& eye, const mat<T, 4, 4>& to_clip,
                                        const screen_mapping<T>& mapping)
      : data_(tree.data()), pieces_(detail::place_pieces<T>(tree, eye, to_clip, mapping)) {}

  /// Writes into the ids of a window the numbers of the faces that are seen; counts.tested counts the parts painted.
  /// shape   faces: a container of screen_face, of a scene projected by to_clip and mapping, clipped ones in pieces
  /// gives   the picture that z-buffer and painter draw, but where two depths, or a face's border and the pixel's
  ///         centre, are as near to each other as snapping corners to 1/256 pixel can bring them: planes in space were
  ///         not snapped. Faces that lie in one plane, of which the lower number is seen, are among these
  /// cost    n log n in the pieces of the window's faces, then each pixel as often as it is covered; allocates 12 bytes
  ///         a piece, no depths
  template <class Faces>
  IRG_APART constexpr void operator()(const Faces& faces, const cell_window& window, image<std::uint32_t>& ids,
                                      draw_counts& counts) const {
    detail::with_items<screen_face>(
        faces, [&](const auto& of_faces) { detail::paint_pieces(data_, pieces_, of_faces, window, ids, counts); });
  }

private:
  const bsp_data_3d<T>& data_;
  detail::pieces_on_screen pieces_;
};

}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// From a point of the plane and two directions in it, u x v pointing to its front.
template <class T>
constexpr plane_on_screen to_plane_on_screen(const double (&a)[3], const double (&u)[3], const double (&v)[3],
                                             const mat<double, 4, 4>& to_clip, const screen_mapping<T>& mapping) {
  vec<double, 4> at, along, across;
  for (int i = 0; i < 4; ++i) {
    const auto moved = [&](const double(&w)[3]) {
      return product(to_clip(i, 0), w[0]) + product(to_clip(i, 1), w[1]) + product(to_clip(i, 2), w[2]);
    };
    at[i] = moved(a) + to_clip(i, 3);
    along[i] = moved(u);
    across[i] = moved(v);
  }
  // Their sizes are free, and products of three must stay within the range.
  const auto ordinary_at = scaled_near_one(at), ordinary_along = scaled_near_one(along),
             ordinary_across = scaled_near_one(across);
  const auto &p = ordinary_at.c, &q = ordinary_along.c, &r = ordinary_across.c;
  // What is perpendicular to all three.
  double k[4];
  for (int i = 0; i < 4; ++i) {
    const int x = (i + 1) % 4, y = (i + 2) % 4, z = (i + 3) % 4;
    const double minor = product(p[x], product(q[y], r[z]) - product(q[z], r[y])) -
                         product(p[y], product(q[x], r[z]) - product(q[z], r[x])) +
                         product(p[z], product(q[x], r[y]) - product(q[y], r[x]));
    k[i] = i % 2 == 0 ? minor : -minor;
  }
  const double right = k[0] / widened(mapping.half_width), down = -k[1] / widened(mapping.half_height);
  return {right, down, k[2],
          k[3] - product(right, widened(mapping.centre_x)) - product(down, widened(mapping.centre_y))};
}

// eye   a point, or the direction to one that is infinitely far away
template <class T, class Eye>
constexpr void order_pieces(const bsp_tree_3d<T>& tree, const Eye& eye, pieces_on_screen& p) {
  const bsp_data_3d<T>& d = tree.data();
  p.starts.assign(d.triangles.size() + 1, 0u);
  for (const bsp_piece_3d& piece : d.pieces) ++p.starts[piece.triangle + 1];
  for (std::size_t i = 1; i < p.starts.size(); ++i) p.starts[i] += p.starts[i - 1];
  p.placed.assign(d.pieces.size(), placed_piece{});
  std::vector<std::uint32_t> next = p.starts;
  std::uint32_t rank = 0;
  tree.visit(eye, bsp_order::back_to_front,
             [&](const bsp_piece_3d& piece) { p.placed[next[piece.triangle]++] = {rank++, piece.limits}; });
}

template <class T>
constexpr void put_planes_on_screen(const bsp_data_3d<T>& d, const mat<T, 4, 4>& to_clip,
                                    const screen_mapping<T>& mapping, pieces_on_screen& on) {
  mat<double, 4, 4> m;
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 4; ++k) m(i, k) = widened(to_clip(i, k));
  // (p, 1), (a, 1), (u, 0) and (v, 0) have the determinant (u x v) . (p - a), and to_clip multiplies it by its own.
  const bool turned = determinant_sign(m) < 0;
  const auto put = [&](const double(&a)[3], const double(&u)[3], const double(&v)[3]) {
    const plane_on_screen p = to_plane_on_screen(a, u, v, m, mapping);
    return turned ? plane_on_screen{-p.right, -p.down, -p.depth, -p.rest} : p;
  };
  const auto put_triangle = [&](std::uint32_t triangle) {
    double a[3], u[3], v[3];
    for (int k = 0; k < 3; ++k) {
      const auto at = [&](std::size_t corner) { return widened(d.vertices[d.triangles[triangle].v[corner]][k]); };
      a[k] = at(0);
      u[k] = at(1) - at(0);
      v[k] = at(2) - at(0);
    }
    return put(a, u, v);
  };
  const auto put_axis = [&](const bsp_plane_3d& plane) {
    double a[3], u[3] = {}, v[3] = {};
    for (int k = 0; k < 3; ++k) a[k] = widened(d.vertices[plane.source][k]);
    u[(plane.axis + 1) % 3] = 1;
    v[(plane.axis + 2) % 3] = 1;
    return put(a, u, v);
  };
  on.of_node.assign(d.nodes.size(), {});
  on.of_triangle.assign(d.triangles.size(), {});
  for (const bsp_limit_3d& l : d.limits)
    if (plane_on_screen& p = on.of_node[l.node]; p.right == 0 && p.down == 0 && p.depth == 0 && p.rest == 0)
      p = d.nodes[l.node].plane.axis == bsp_plane_3d::of_triangle ? put_triangle(d.nodes[l.node].plane.source)
                                                                  : put_axis(d.nodes[l.node].plane);
  for (const bsp_piece_3d& p : d.pieces)
    if (p.limits != no_index) on.of_triangle[p.triangle] = put_triangle(p.triangle);
}

template <class T, class Eye>
constexpr pieces_on_screen pieces_seen_from(const bsp_tree_3d<T>& tree, const Eye& eye, const mat<T, 4, 4>& to_clip,
                                            const screen_mapping<T>& mapping) {
  pieces_on_screen p;
  order_pieces(tree, eye, p);
  put_planes_on_screen(tree.data(), to_clip, mapping, p);
  return p;
}

// Where the ray through a pixel meets the plane of a face, no farther than its corners: it may pass beside them by as
// much as they were snapped.
constexpr double depth_on_plane(const plane_on_screen& p, const screen_face& f, double x, double y) noexcept {
  const double z = -p.at(x, y) / p.depth, low = widened(f.depth_low), high = widened(f.depth_high);
  return !(low < z) ? low : high < z ? high : z;
}

// Draws a piece: its face, within its limits.
template <class T>
struct piece_painter {
  const bsp_data_3d<T>& d;
  const pieces_on_screen& on;
  const cell_window& window;
  image<std::uint32_t>& ids;

  constexpr void operator()(std::uint32_t limits, const screen_face& f) const {
    covered_spans(f.coverage, window, [&](const span_of_cells& s) {
      const double y = s.y + 0.5;
      for (int i = s.x_first; i < s.x_last; ++i) {
        bool within = true;
        if (limits != no_index) {
          const double x = i + 0.5, z = depth_on_plane(on.of_triangle[f.number], f, x, y);
          for (std::uint32_t l = limits; within && l != no_index; l = d.limits[l].next) {
            const plane_on_screen& p = on.of_node[d.limits[l].node];
            within = (p.at(x, y) + product(p.depth, z) > 0) == (d.limits[l].side > 0);
          }
        }
        if (within) ids(i, s.y) = f.number;
      }
    });
  }
};

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API pieces_on_screen place_pieces(const bsp_tree_3d<T>& tree, const point<T, 3>& eye, const mat<T, 4, 4>& to_clip,
                                      const screen_mapping<T>& mapping) {
  return pieces_seen_from(tree, eye, to_clip, mapping);
}

template <Floating T>
IRG_API pieces_on_screen place_pieces(const bsp_tree_3d<T>& tree, const vec<T, 3>& to_eye, const mat<T, 4, 4>& to_clip,
                                      const screen_mapping<T>& mapping) {
  return pieces_seen_from(tree, to_eye, to_clip, mapping);
}

template <Floating T, class Faces>
IRG_API void paint_pieces(const bsp_data_3d<T>& d, const pieces_on_screen& p, const Faces& faces,
                          const cell_window& window, image<std::uint32_t>& ids, draw_counts& counts) {
  struct part {
    std::uint32_t rank, limits, face;
  };
  std::vector<part> parts;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const std::uint32_t n = faces[i].number;
    IRG_EXPECTS(n + 1 < p.starts.size());
    for (std::uint32_t k = p.starts[n]; k < p.starts[n + 1]; ++k)
      parts.push_back({p.placed[k].rank, p.placed[k].limits, static_cast<std::uint32_t>(i)});
  }
  std::sort(parts.begin(), parts.end(),
            [](const part& a, const part& b) { return a.rank != b.rank ? a.rank < b.rank : a.face < b.face; });
  const piece_painter<T> paint{d, p, window, ids};
  for (const part& one : parts) paint(one.limits, faces[one.face]);
  counts.tested += static_cast<std::int64_t>(parts.size());
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
