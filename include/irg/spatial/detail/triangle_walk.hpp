// SPDX-License-Identifier: MIT
// Rays through the triangles of a bvh: four at once with one bound for all, and one by one those that it leaves open.
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <optional>
#include <span>

#include <irg/spatial/detail/triangle_block_kernel.hpp>
#include <irg/spatial/detail/walk_bvh.hpp>

namespace irg::detail {

// A crossing that weights are still to be found of.
struct first_crossing {
  crossing_time time{};
  std::uint32_t number = bvh_node::none;
  int turn = 0;
  double largest = 0;  // the largest coordinate of a corner, seen from the origin
  point<double, 3> corner[3]{};
  sheared_sides<double> sides{};
};

inline namespace IRG_ABI {

// No coordinate of a corner in the tree, seen from the origin, is larger.
IRG_INLINE constexpr double reach_of(const bvh& tree, const space_point& origin) noexcept {
  constexpr double slack = 1 + 0x1p-50;
  double most = 0;
  for (int i = 0; i < 3; ++i) most = greater(most, magnitude(origin[i]));
  return (most + 1 / tree.scale) * slack;
}

IRG_INLINE constexpr double bound_of(const bvh& tree, const space_point& origin) noexcept {
  constexpr double largest = 0x1p250;
  const double m = reach_of(tree, origin);
  return m < largest ? side_bound(m) : std::numeric_limits<double>::infinity();
}

// What triangles need of a ray, made when it comes to the first of them: most rays come to none.
class late_triangle_ray {
public:
  IRG_INLINE constexpr late_triangle_ray(const bvh& tree, const ray<double, 3>& r) noexcept : tree_(tree), given_(r) {}

  IRG_INLINE constexpr void prepare() noexcept {
    if (!ray_) make();
  }
  IRG_INLINE constexpr const triangle_ray& ray_for_triangles() const noexcept { return *ray_; }
  IRG_INLINE constexpr double bound() const noexcept { return bound_; }

private:
  constexpr void make() noexcept {
    ray_ = make_triangle_ray(given_);
    bound_ = bound_of(tree_, given_.origin);
  }

  const bvh& tree_;
  const ray<double, 3>& given_;
  std::optional<triangle_ray> ray_{};
  double bound_ = 0;
};

// -1, 0 or 1, as a is crossed before b, with it, or after it.
IRG_NOINLINE constexpr int exact_order(const std::same_as<triangle_ray> auto& q, const first_crossing& a,
                                       const first_crossing& b) noexcept {
  bool same = true;
  for (int i = 0; i < 3; ++i) same = same && a.corner[i] == b.corner[i];
  if (same) return 0;
  std::array<double, 24> in{};
  const auto put = [&in](std::size_t at, const auto& p) { in[at] = p[0], in[at + 1] = p[1], in[at + 2] = p[2]; };
  put(9, q.r.origin);
  put(12, q.r.direction);
  for (std::size_t i = 0; i < 3; ++i) {
    put(3 * i, a.corner[i]);
    put(15 + 3 * i, b.corner[i]);
  }
  const int sign = irg::sign_of<6>(
      [](const auto& x) {
        const std::array second = {x[15], x[16], x[17], x[18], x[19], x[20], x[21], x[22],
                                   x[23], x[9],  x[10], x[11], x[12], x[13], x[14]};
        return height_along(x) * advance_along(second) - height_along(second) * advance_along(x);
      },
      in);
  return sign * a.turn * b.turn;
}

IRG_INLINE constexpr bool is_before(const std::same_as<triangle_ray> auto& q, const first_crossing& a,
                                    const first_crossing& b) noexcept {
  const double apart = a.time.t - b.time.t, error = a.time.error + b.time.error;
  if (apart > error) return false;
  const int order = -apart > error ? -1 : exact_order(q, a, b);
  return order != 0 ? order < 0 : a.number < b.number;
}

// Calls use(crossing) for the triangles of a leaf that the ray crosses, until it gives true.
template <class T, class Use>
IRG_INLINE constexpr bool cross_leaf(const bvh& tree, std::span<const triangle_block<T>> blocks, std::uint32_t leaf,
                                     const triangle_ray& q, double bound, const Use& use) {
  const std::uint32_t number = bvh_node::number_of(leaf);
  const triangle_block<T>& block = blocks[number];
  double sides[3][triangle_block<T>::width];
  unsigned bits = triangles_met(block, q.shear, bound, sides) & ((1u << bvh_node::count_of(leaf)) - 1);
  for (; bits != 0; bits &= bits - 1) {
    const int k = std::countr_zero(bits);
    first_crossing x;
    for (int i = 0; i < 3; ++i)
      x.corner[i] = {exactly_widened(block.v[i][0][k]), exactly_widened(block.v[i][1][k]),
                     exactly_widened(block.v[i][2][k])};
    x.sides = {sides[0][k], sides[1][k], sides[2][k]};
    x.largest = largest_from(q.r.origin, x.corner[0], x.corner[1], x.corner[2]);
    const timed_crossing found = cross_in_time(q, x.corner[0], x.corner[1], x.corner[2], x.sides, x.largest);
    if (!found.hit) continue;
    x.time = found.time;
    x.turn = found.turn;
    x.number = tree.order[number * bvh_node::block + static_cast<std::uint32_t>(k)];
    if (use(x)) return true;
  }
  return false;
}

constexpr ray_crossing finished_crossing(const std::same_as<triangle_ray> auto& q, const first_crossing& f) noexcept {
  ray_crossing x{f.turn < 0 ? facing::front : facing::back, f.time.t, 0, 0};
  set_weights(x, q, f.corner[0], f.corner[1], f.corner[2], f.sides, f.largest);
  return x;
}

// The first crossing into use(triangle_ray, crossing), if there is one.
template <class T, class Use>
IRG_INLINE constexpr void find_first_crossing(const bvh& tree, std::span<const triangle_block<T>> blocks,
                                              const ray<double, 3>& r, const Use& use) {
  if (is_empty(r)) return;
  late_triangle_ray q(tree, r);
  std::optional<first_crossing> best;
  box_ray b = make_box_ray(r, tree.scale);
  walk_near_to_far(tree, b, [&](std::uint32_t leaf) IRG_INLINE_LAMBDA {
    q.prepare();
    cross_leaf(tree, blocks, leaf, q.ray_for_triangles(), q.bound(), [&](const first_crossing& x) {
      if (!best || is_before(q.ray_for_triangles(), x, *best)) {
        best = x;
        b.high = later_time(b, x.time.t + x.time.error);
      }
      return false;
    });
  });
  if (best) use(q.ray_for_triangles(), *best);
}

template <class T, class Counts>
constexpr bool crosses_any(const bvh& tree, std::span<const triangle_block<T>> blocks, const ray<double, 3>& r,
                           const Counts& counts) {
  if (is_empty(r)) return false;
  late_triangle_ray q(tree, r);
  return walk_anyhow(tree, make_box_ray(r, tree.scale), [&](std::uint32_t leaf) IRG_INLINE_LAMBDA {
    q.prepare();
    return cross_leaf(tree, blocks, leaf, q.ray_for_triangles(), q.bound(),
                      [&](const first_crossing& x) { return counts(x.number); });
  });
}

template <class T, class Use>
constexpr void each_crossing(const bvh& tree, std::span<const triangle_block<T>> blocks, const ray<double, 3>& r,
                             const Use& use) {
  if (is_empty(r)) return;
  late_triangle_ray q(tree, r);
  walk_anyhow(tree, make_box_ray(r, tree.scale), [&](std::uint32_t leaf) IRG_INLINE_LAMBDA {
    q.prepare();
    cross_leaf(tree, blocks, leaf, q.ray_for_triangles(), q.bound(),
               [&](const first_crossing& x) { return use(q.ray_for_triangles(), x), false; });
    return false;
  });
}

}  // namespace IRG_ABI
}  // namespace irg::detail
