// SPDX-License-Identifier: MIT
// What a BSP tree in space is while it grows and what a visit asks of it; bsp_cells_3d.hpp says how it grows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <irg/core/scalar.hpp>
#include <irg/core/vocabulary.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/vec.hpp>
#include <irg/spatial/bsp_data_3d.hpp>

namespace irg::detail {

// A plane in rounded numbers, with a bound of what they are off by: it tells the side of most points in a few
// operations, and says so where it does not.

// A rounded value, and how far it may be off.
struct bounded_value {
  double value, bound;

  /// 1 or -1, or 0 where the bound leaves it open.
  IRG_INLINE constexpr int sign() const noexcept { return value > bound ? 1 : value < -bound ? -1 : 0; }
};

// normal . (p - at). With u = 2^-53, s the largest difference between corners along an axis and D that of p and `at`: a
// normal's coordinate is at most 2s^2 and off by less than 8.1u s^2; products with p - at and their sum are off by
// 24u s^2 D more, in all less than 49u s^2 D. `error` is 64u s^2. What subnormals lose is less than 2^-1000.
struct rounded_plane {
  double normal[3], at[3], error, size;  // size: the sum of the normal's absolute values

  // off   how far each coordinate of p may be off
  IRG_INLINE constexpr bounded_value operator()(const double (&p)[3], double off) const noexcept {
    constexpr double least = 0x1p-1000;
    const double dx = p[0] - at[0], dy = p[1] - at[1], dz = p[2] - at[2];
    const double reach = maximum(maximum(magnitude(dx), magnitude(dy)), magnitude(dz));
    const double value = product(normal[0], dx) + product(normal[1], dy) + product(normal[2], dz);
    return {value, product(error, reach) + product(size, off) + least};
  }
};

// The same for points without error, in fewer numbers: normal . p - offset. With R the largest coordinate of p and A
// that of `at`, the products and sums of normal . p and of `offset` are off by less than 24u s^2 R and 24u s^2 A, and
// the normal by 24.3u s^2 (R + A): `error` R + `error_at` is above both.
struct walked_plane {
  double normal[3], offset, error, error_at;

  IRG_INLINE constexpr explicit walked_plane(const rounded_plane& p) noexcept
      : normal{p.normal[0], p.normal[1], p.normal[2]},
        offset(product(p.normal[0], p.at[0]) + product(p.normal[1], p.at[1]) + product(p.normal[2], p.at[2])),
        error(maximum(p.error, 0x1p-50 * p.size)),
        error_at(product(error, maximum(maximum(magnitude(p.at[0]), magnitude(p.at[1])), magnitude(p.at[2]))) +
                 0x1p-1000) {}

  // reach   the largest coordinate of p
  IRG_INLINE constexpr bounded_value operator()(const double (&p)[3], double reach) const noexcept {
    return {product(normal[0], p[0]) + product(normal[1], p[1]) + product(normal[2], p[2]) - offset,
            product(error, reach) + error_at};
  }
};

// A piece that no node holds yet: `count` corners from `first` on, none where it is the whole triangle.
struct open_piece {
  std::uint32_t triangle, limits, first, count;
};

// Where a node hangs: below another one, in front or behind, or beside one of the same plane.
enum class hung { in_front, behind, beside };
struct bsp_link {
  std::uint32_t node;
  hung where;
};

// What a visit asks of a node: its plane, what is below it behind and in front, and its piece if it has but one.
struct bsp_walk_step {
  walked_plane plane;
  std::uint32_t below[2], piece;
};
inline constexpr std::uint32_t several_pieces = no_index - 1;

struct bsp_sizes {
  std::size_t vertices = 0, triangles = 0, nodes = 0, pieces = 0, limits = 0, splits = 0, left_out = 0, links = 0;
};

template <Floating T>
struct growing_bsp_3d {
  // The pieces of a cell, and where the node hangs that is to divide it.
  struct open_cell {
    std::vector<open_piece> pieces;
    bsp_link at;
  };

  bsp_data_3d<T> data{};
  std::vector<rounded_plane> planes{};  // of the nodes
  std::vector<bsp_walk_step> steps{};
  std::vector<bsp_link> links{};  // from what was there to what was merged in
  std::size_t splits = 0, left_out = 0;
};

inline namespace IRG_ABI {

template <Floating T>
constexpr bsp_sizes sizes_of(const growing_bsp_3d<T>& tree) noexcept {
  const bsp_data_3d<T>& d = tree.data;
  return {d.vertices.size(), d.triangles.size(), d.nodes.size(), d.pieces.size(),
          d.limits.size(),   tree.splits,        tree.left_out,  tree.links.size()};
}

}  // namespace IRG_ABI

inline namespace IRG_COMPILED_ABI {

template <Floating T>
IRG_API void add_triangles(growing_bsp_3d<T>& tree, std::span<const point<T, 3>> vertices,
                           std::span<const triangle_indices> triangles, const bsp_options& choice);
template <Floating T>
IRG_API void shrink_to(growing_bsp_3d<T>& tree, const bsp_sizes& to);

// Adds to the numbers of a tree what a visit asks.
template <Floating T>
IRG_API void make_walkable(growing_bsp_3d<T>& tree);

// The corners of a piece, rounded.
template <Floating T>
IRG_API std::vector<point<T, 3>> rounded_ring(const growing_bsp_3d<T>& tree, const bsp_piece_3d& p);

// 1, -1 or 0: in front of a plane, behind, on it.
template <Floating T>
IRG_API int exact_side(const bsp_data_3d<T>& d, const bsp_plane_3d& plane, const point<T, 3>& p) noexcept;
// Of a point infinitely far away.
template <Floating T>
IRG_API int side_of_direction(const bsp_data_3d<T>& d, const bsp_plane_3d& plane, const vec<T, 3>& to) noexcept;

}  // namespace IRG_COMPILED_ABI
}  // namespace irg::detail
