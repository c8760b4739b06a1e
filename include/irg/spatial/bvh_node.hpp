// SPDX-License-Identifier: MIT
// What a bvh is made of, and what rays ask of it.
#pragma once

#include <concepts>
#include <cstdint>
#include <vector>

#include <irg/core/vocabulary.hpp>
#include <irg/core/scalar.hpp>

namespace irg {

/// Up to eight boxes, side by side, and what is in each: a node, or up to eight primitives.
/// shape   bounds are in units of the tree: first all lows along x, then along y and z, then the highs; boxes that hold
///         nothing are empty
struct alignas(32) bvh_node {
  static constexpr int width = 8;
  [[deprecated("irg: no_index")]] static constexpr std::uint32_t none = no_index;
  static constexpr std::uint32_t leaf = 0x80000000;
  static constexpr std::uint32_t block = 4, most = 8;  // leaves take places of the order by fours, eight at most

  float bounds[6 * width];
  std::uint32_t child[width];

  bool operator==(const bvh_node&) const = default;

  IRG_INLINE constexpr float& low(int axis, int k) noexcept { return bounds[axis * width + k]; }
  IRG_INLINE constexpr float& high(int axis, int k) noexcept { return bounds[(3 + axis) * width + k]; }
  [[nodiscard]] IRG_INLINE constexpr float low(int axis, int k) const noexcept { return bounds[axis * width + k]; }
  [[nodiscard]] IRG_INLINE constexpr float high(int axis, int k) const noexcept {
    return bounds[(3 + axis) * width + k];
  }

  // A child is the index of a node; or the number of a leaf's first block and its count of primitives - 1.
  IRG_INLINE static constexpr bool is_leaf(std::uint32_t child) noexcept { return (child & leaf) != 0; }
  IRG_INLINE static constexpr std::uint32_t leaf_of(std::uint32_t number, std::uint32_t count) noexcept {
    return leaf | number << 3 | (count - 1);
  }
  IRG_INLINE static constexpr std::uint32_t number_of(std::uint32_t child) noexcept { return (child & ~leaf) >> 3; }
  IRG_INLINE static constexpr std::uint32_t count_of(std::uint32_t child) noexcept { return (child & 7) + 1; }
  IRG_INLINE static constexpr std::uint32_t first_place(std::uint32_t child) noexcept {
    return block * number_of(child);
  }
  IRG_INLINE static constexpr std::uint32_t last_place(std::uint32_t child) noexcept {
    return first_place(child) + (child & 7);
  }
};

/// A tree of boxes, made by build_bvh.
/// shape   nodes[0] is the root, and a node stands before those in it; the primitives of a leaf are those of the order
///         from first_place on, no_index behind them up to a multiple of four. Boxes are in units of 1/scale, a
///         power of two: no coordinate is larger than 1. Where primitives are in several leaves, earlier[i] is the
///         place of the last reference before that at place i of the order to the same primitive, and block b is that
///         of the leaf with box boxes[b] % 8 of nodes[boxes[b] / 8]; without such both are empty
struct bvh {
  std::vector<bvh_node> nodes;
  std::vector<std::uint32_t> order;
  std::vector<std::uint32_t> earlier, boxes;
  double scale = 1;

  bool operator==(const bvh&) const = default;
};

/// What rays have asked of trees so far: of all primitives times `rays`, those beyond `primitives` were skipped.
/// exact   for the boxes as the tree holds them, which are rounded outwards. A box that a ray passes by at less than
///         that may count with one processor and not with another
struct [[gnu::visibility("default")]] ray_counts {
  std::uint64_t rays = 0;  // also those without points
  std::uint64_t nodes = 0;  // gone through, eight boxes tested in each
  std::uint64_t leaves = 0;  // come to
  std::uint64_t primitives = 0;  // in these leaves
  bool operator==(const ray_counts&) const = default;
};

/// Stands for ray_counts where nobody asks for them: no code is made.
struct [[gnu::visibility("default")]] uncounted_rays {};
inline constexpr uncounted_rays not_counted{};

/// Where rays are counted, or not.
template <class C>
concept RayCounts = std::same_as<C, ray_counts> || std::same_as<C, const uncounted_rays>;

/// Where a ray crosses a triangle abc.
/// shape   side: which one the ray comes from; the point is origin + t*direction, and a, b and c weighted by
///         1 - weight_b - weight_c, weight_b and weight_c
struct ray_crossing {
  facing side = facing::front;
  double t = 0, weight_b = 0, weight_c = 0;
  bool operator==(const ray_crossing&) const = default;
};

namespace detail {

// Four triangles side by side.
template <Floating T>
struct triangle_block {
  static constexpr int width = 4;
  T v[3][3][width];  // corner, axis, triangle
};

}  // namespace detail
}  // namespace irg
