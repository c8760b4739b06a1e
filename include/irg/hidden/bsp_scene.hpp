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

#include <irg/math/exact_matrix.hpp>
#include <irg/math/length.hpp>
#include <irg/math/mat.hpp>
#include <irg/raster/draw_counts.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/screen_face.hpp>
#include <irg/raster/screen_mapping.hpp>
#include <irg/spatial/bsp_tree_3d.hpp>

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
      : tree_(tree) {
    order_pieces(eye);
    put_planes_on_screen(to_clip, mapping);
  }

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
    std::vector<part> parts;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const std::uint32_t n = faces[i].number;
      IRG_EXPECTS(n + 1 < starts_.size());
      for (std::uint32_t k = starts_[n]; k < starts_[n + 1]; ++k)
        parts.push_back({placed_[k].rank, placed_[k].limits, static_cast<std::uint32_t>(i)});
    }
    std::sort(parts.begin(), parts.end(),
              [](const part& a, const part& b) { return a.rank != b.rank ? a.rank < b.rank : a.face < b.face; });
    for (const part& p : parts) paint(p.limits, faces[p.face], window, ids);
    counts.tested += static_cast<std::int64_t>(parts.size());
  }

private:
  struct placed_piece {
    std::uint32_t rank, limits;
  };
  struct part {
    std::uint32_t rank, limits, face;
  };

  template <class Eye>
  IRG_APART constexpr void order_pieces(const Eye& eye) {
    const bsp_data_3d<T>& d = tree_.data();
    starts_.assign(d.triangles.size() + 1, 0u);
    for (const bsp_piece_3d& p : d.pieces) ++starts_[p.triangle + 1];
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    placed_.assign(d.pieces.size(), placed_piece{});
    std::vector<std::uint32_t> next = starts_;
    std::uint32_t rank = 0;
    tree_.visit(eye, bsp_order::back_to_front,
                [&](const bsp_piece_3d& p) { placed_[next[p.triangle]++] = {rank++, p.limits}; });
  }

  IRG_APART constexpr void put_planes_on_screen(const mat<T, 4, 4>& to_clip, const screen_mapping<T>& mapping);

  IRG_APART constexpr void paint(std::uint32_t limits, const screen_face& f, const cell_window& window,
                                 image<std::uint32_t>& ids) const {
    const bsp_data_3d<T>& d = tree_.data();
    covered_spans(f.coverage, window, [&](const span_of_cells& s) {
      const double y = s.y + 0.5;
      for (int i = s.x_first; i < s.x_last; ++i) {
        bool within = true;
        if (limits != no_index) {
          const double x = i + 0.5, z = depth_of(f, x, y);
          for (std::uint32_t l = limits; within && l != no_index; l = d.limits[l].next) {
            const detail::plane_on_screen& p = of_node_[d.limits[l].node];
            within = (p.at(x, y) + product(p.depth, z) > 0) == (d.limits[l].side > 0);
          }
        }
        if (within) ids(i, s.y) = f.number;
      }
    });
  }
  // Where the ray through a pixel meets the plane of a face, no farther than its corners: it may pass beside them by as
  // much as they were snapped.
  [[nodiscard]] IRG_APART constexpr double depth_of(const screen_face& f, double x, double y) const noexcept {
    const detail::plane_on_screen& p = of_triangle_[f.number];
    const double z = -p.at(x, y) / p.depth, low = widened(f.depth_low), high = widened(f.depth_high);
    return !(low < z) ? low : high < z ? high : z;
  }

  const bsp_tree_3d<T>& tree_;
  std::vector<std::uint32_t> starts_{};
  std::vector<placed_piece> placed_{};
  std::vector<detail::plane_on_screen> of_node_{}, of_triangle_{};
};

namespace detail::inline IRG_ABI {

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

}  // namespace detail::inline IRG_ABI

template <Floating T>
IRG_APART constexpr void bsp_scene_painter<T>::put_planes_on_screen(const mat<T, 4, 4>& to_clip,
                                                                    const screen_mapping<T>& mapping) {
  const bsp_data_3d<T>& d = tree_.data();
  mat<double, 4, 4> m;
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 4; ++k) m(i, k) = widened(to_clip(i, k));
  // (p, 1), (a, 1), (u, 0) and (v, 0) have the determinant (u x v) . (p - a), and to_clip multiplies it by its own.
  const bool turned = determinant_sign(m) < 0;
  const auto put = [&](const double(&a)[3], const double(&u)[3], const double(&v)[3]) {
    const detail::plane_on_screen p = detail::to_plane_on_screen(a, u, v, m, mapping);
    return turned ? detail::plane_on_screen{-p.right, -p.down, -p.depth, -p.rest} : p;
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
  of_node_.assign(d.nodes.size(), {});
  of_triangle_.assign(d.triangles.size(), {});
  for (const bsp_limit_3d& l : d.limits)
    if (detail::plane_on_screen& p = of_node_[l.node]; p.right == 0 && p.down == 0 && p.depth == 0 && p.rest == 0)
      p = d.nodes[l.node].plane.axis == bsp_plane_3d::of_triangle ? put_triangle(d.nodes[l.node].plane.source)
                                                                  : put_axis(d.nodes[l.node].plane);
  for (const bsp_piece_3d& p : d.pieces)
    if (p.limits != no_index) of_triangle_[p.triangle] = put_triangle(p.triangle);
}

}  // namespace irg
