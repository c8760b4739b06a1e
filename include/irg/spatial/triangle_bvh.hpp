// SPDX-License-Identifier: MIT
// triangle_bvh: triangles made ready for rays. What a ray crosses is decided exactly, as cross_triangle does: nothing
// slips through between two triangles of a closed surface, at whatever scale.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <irg/spatial/bvh.hpp>
#include <irg/spatial/detail/triangle_walk.hpp>

namespace irg {

/// A triangle that a ray crosses, by its number, and where.
struct triangle_hit {
  std::uint32_t triangle = 0;
  ray_crossing at{};
  constexpr bool operator==(const triangle_hit&) const = default;
};

/// Triangles in a tree of boxes, for many rays.
template <Floating T>
class triangle_bvh {
public:
  using triangle = std::array<point<T, 3>, 3>;

  constexpr triangle_bvh() = default;

  /// The tree over triangles; triangle i is triangles[i].
  /// needs   fewer than 2^28 triangles
  /// gives   a tree that rays pass by where there are none. Triangles with a corner that is NaN or infinite are left
  ///         out
  /// exact, cost   as build_bvh; 160 bytes a triangle of floats, 270 of doubles. Spatial splits cut the triangles
  ///         themselves, not their boxes
  template <Executor E = sequential>
  IRG_APART constexpr explicit triangle_bvh(std::span<const triangle> triangles, const bvh_config& config = {},
                                            const E& executor = {})
      : triangle_bvh(
            triangles.size(), [triangles](std::size_t i) -> const triangle& { return triangles[i]; }, config,
            executor) {}

  /// The same of count triangles that at(i) gives.
  template <class At, Executor E = sequential>
  IRG_APART constexpr triangle_bvh(std::size_t count, const At& at, const bvh_config& config = {},
                                   const E& executor = {}) {
    const std::vector<box<T, 3>> boxes = boxes_of(count, at, executor);
    tree_ = detail::build_tree(std::span<const box<T, 3>>(boxes), config, executor,
                               [&at](double scale) { return detail::triangle_cut<At>{at, scale}; });
    fill_blocks(at, executor);
  }

  /// The same triangles with their corners moved.
  /// needs   as many triangles as the tree was built of
  /// gives, exact, cost   as refit of a bvh
  IRG_APART constexpr void refit(std::span<const triangle> triangles) {
    const auto at = [triangles](std::size_t i) -> const triangle& { return triangles[i]; };
    const std::vector<box<T, 3>> boxes = boxes_of(triangles.size(), at, sequential{});
    irg::refit(tree_, std::span<const box<T, 3>>(boxes));
    fill_blocks(at, sequential{});
  }

  [[nodiscard]] IRG_INLINE constexpr const bvh& tree() const noexcept { return tree_; }
  [[nodiscard]] IRG_INLINE constexpr std::span<const detail::triangle_block<T>> blocks() const noexcept {
    return blocks_;
  }

private:
  static constexpr std::size_t portion = 16384;

  template <class E, class Task>
  IRG_APART static constexpr void in_portions(std::size_t count, const E& executor, const Task& task) {
    executor((count + portion - 1) / portion, [&](std::size_t p) {
      const std::size_t last = (p + 1) * portion < count ? (p + 1) * portion : count;
      for (std::size_t i = p * portion; i < last; ++i) task(i);
    });
  }

  template <class At, class E>
  [[nodiscard]] IRG_APART static constexpr std::vector<box<T, 3>> boxes_of(std::size_t count, const At& at,
                                                                           const E& executor) {
    std::vector<box<T, 3>> boxes(count, box<T, 3>{});
    in_portions(count, executor, [&](std::size_t i) {
      const triangle& t = at(i);
      constexpr T most = (std::numeric_limits<T>::max)();
      bool finite = true;
      for (const point<T, 3>& p : t)
        for (int axis = 0; axis < 3; ++axis) finite = finite && -most <= p[axis] && p[axis] <= most;
      if (!finite) return;
      boxes[i] = enclosing_box(enclosing_box(box<T, 3>{t[0], t[0]}, t[1]), t[2]);
    });
    return boxes;
  }

  template <class At, class E>
  IRG_APART constexpr void fill_blocks(const At& at, const E& executor) {
    constexpr std::size_t width = bvh_node::block;
    blocks_.resize(tree_.order.size() / width, detail::triangle_block<T>{});
    in_portions(blocks_.size(), executor, [&](std::size_t b) {
      for (std::size_t k = 0; k < width; ++k) {
        const std::uint32_t number = tree_.order[b * width + k];
        const triangle& t = at(number == bvh_node::none ? tree_.order[b * width] : number);
        for (std::size_t corner = 0; corner < 3; ++corner)
          for (int axis = 0; axis < 3; ++axis) blocks_[b].v[corner][axis][k] = t[corner][axis];
      }
    });
  }

  bvh tree_;
  std::vector<detail::triangle_block<T>> blocks_;
};

inline namespace IRG_ABI {

/// The triangle that the ray crosses first.
/// shape   rays of floats or doubles against triangles of either
/// gives   nothing where it crosses none and for an empty ray; of several crossed in one point the lowest number
/// exact   which triangles are crossed, as cross_triangle; which of them is first, for all finite numbers; t and
///         weights as there. The same for every tree over these triangles
/// cost    some log n boxes and triangles; nothing allocated. With ray_counts, what the ray asked is added to them;
///         they cost nothing where they are not asked for
template <Floating T, Floating U, detail::RayCounts C = const detail::uncounted>
[[nodiscard]] constexpr std::optional<triangle_hit> closest_hit(const triangle_bvh<T>& triangles, const ray<U, 3>& r,
                                                                C& counts = detail::not_counted) noexcept {
  std::optional<triangle_hit> hit;
  detail::find_first_crossing(triangles.tree(), triangles.blocks(), r, counts,
                              [&](const detail::triangle_ray& q, const detail::first_crossing& x) {
                                hit = triangle_hit{x.number, detail::finished_crossing(q, triangles.blocks(), x)};
                              });
  return hit;
}

/// The triangles that rays cross first, hits[i] that of rays[i].
/// shape   rays that follow each other should start near each other and go about the same way, as those of a square of
///         4 by 4 pixels do: each 16 of them are taken through the tree as one where they can be
/// needs   as many hits as rays
/// exact   the same, bit for bit, as closest_hit of each ray
/// cost    of 16 such rays some three times that of one; of others, that of each. ray_counts count once what 16 rays
///         come to as one
template <Floating T, Floating U, detail::RayCounts C = const detail::uncounted>
constexpr void closest_hits(const triangle_bvh<T>& triangles, std::span<const ray<U, 3>> rays,
                            std::span<std::optional<triangle_hit>> hits, C& counts = detail::not_counted) {
  IRG_EXPECTS(rays.size() == hits.size());
  std::size_t i = 0;
  for (; i < rays.size(); ++i) {
    if constexpr (std::is_same_v<U, float>)
      while (detail::walks_in_packets() && rays.size() - i >= detail::ray_packet::size) {
        const auto put = [&](unsigned k, const auto& q, const detail::first_crossing& x) {
          hits[i + k] = triangle_hit{x.number, detail::finished_crossing(q, triangles.blocks(), x)};
        };
        for (std::size_t k = 0; k < detail::ray_packet::size; ++k) hits[i + k] = std::nullopt;
        if (!detail::find_packet_crossings(triangles.tree(), triangles.blocks(), rays.data() + i, counts, put)) {
          for (std::size_t k = 0; k < detail::ray_packet::size; ++k)
            hits[i + k] = closest_hit(triangles, rays[i + k], counts);
        }
        i += detail::ray_packet::size;
      }
    if (i < rays.size()) hits[i] = closest_hit(triangles, rays[i], counts);
  }
}

/// Whether the ray crosses a triangle; with `admits`, one of those for which admits(number) holds.
/// exact, cost   as closest_hit, and as a rule less
template <Floating T, Floating U, std::predicate<std::uint32_t> Admits, detail::RayCounts C = const detail::uncounted>
[[nodiscard]] constexpr bool any_hit(const triangle_bvh<T>& triangles, const ray<U, 3>& r, const Admits& admits,
                                     C& counts = detail::not_counted) {
  return detail::crosses_any(triangles.tree(), triangles.blocks(), r, counts, admits);
}
template <Floating T, Floating U, detail::RayCounts C = const detail::uncounted>
[[nodiscard]] constexpr bool any_hit(const triangle_bvh<T>& triangles, const ray<U, 3>& r,
                                     C& counts = detail::not_counted) noexcept {
  return any_hit(triangles, r, [](std::uint32_t) { return true; }, counts);
}

/// All triangles that the ray crosses, each once, into sink(hit), in no order that is promised.
/// gives   of a closed surface, as many as an origin in general position would: an odd number from inside to infinity
/// exact, cost   as closest_hit; without limit to what is nearest
template <Floating T, Floating U, class Sink, detail::RayCounts C = const detail::uncounted>
constexpr void all_hits(const triangle_bvh<T>& triangles, const ray<U, 3>& r, Sink&& sink,
                        C& counts = detail::not_counted) {
  detail::each_crossing(triangles.tree(), triangles.blocks(), r, counts,
                        [&](const detail::triangle_ray& q, const detail::first_crossing& x) {
                          sink(triangle_hit{x.number, detail::finished_crossing(q, triangles.blocks(), x)});
                        });
}

}  // namespace IRG_ABI
}  // namespace irg
