// SPDX-License-Identifier: MIT
// triangle_bvh: triangles made ready for rays. What a ray crosses is decided exactly, as intersect_triangle does:
// nothing slips through between two triangles of a closed surface, at whatever scale.
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include <irg/core/function_ref.hpp>
#include <irg/geometry/ray.hpp>
#include <irg/spatial/bvh.hpp>
#if IRG_BODIES
#include <irg/spatial/detail/ray_packet_kernel.hpp>
#include <irg/spatial/detail/triangle_block_kernel.hpp>
#include <irg/spatial/detail/walk_bvh.hpp>
#endif

namespace irg {

namespace detail {
struct triangle_blocks;
}  // namespace detail

namespace detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API bvh build_triangle_tree(std::span<const box<T, 3>> boxes, const bvh_options& config,
                                const executor_ref& executor,
                                const function_ref<std::array<point<T, 3>, 3>(std::size_t)>& at);

}  // namespace detail::inline IRG_COMPILED_ABI

/// A triangle that a ray crosses, by its number, and where.
struct triangle_hit {
  std::uint32_t triangle = 0;
  ray_crossing at{};
  bool operator==(const triangle_hit&) const = default;
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
  /// exact   as build_bvh
  /// cost    as build_bvh; 160 bytes a triangle of floats, 270 of doubles. Spatial splits cut the triangles
  ///         themselves, not their boxes
  template <Executor E = sequential>
  IRG_APART constexpr explicit triangle_bvh(std::span<const triangle> triangles, const bvh_options& config = {},
                                            const E& executor = {})
      : triangle_bvh(
            triangles.size(), [triangles](std::size_t i) -> const triangle& { return triangles[i]; }, config,
            executor) {}

  /// The same of count triangles that at(i) gives.
  template <class At, Executor E = sequential>
  IRG_APART constexpr triangle_bvh(std::size_t count, const At& at, const bvh_options& config = {},
                                   const E& executor = {}) {
    const std::vector<box<T, 3>> boxes = boxes_of(count, at, executor);
    tree_ =
        detail::build_triangle_tree<T>(boxes, config, as_executor(executor), as_function<triangle(std::size_t)>(at));
    fill_blocks(at, executor);
  }

  /// The same triangles with their corners moved.
  /// needs   as many triangles as the tree was built of
  /// gives   as refit of a bvh
  /// exact   as refit of a bvh
  /// cost    as refit of a bvh
  IRG_APART constexpr void refit(std::span<const triangle> triangles) {
    const auto at = [triangles](std::size_t i) -> const triangle& { return triangles[i]; };
    const std::vector<box<T, 3>> boxes = boxes_of(triangles.size(), at, sequential{});
    irg::refit(tree_, std::span<const box<T, 3>>(boxes));
    fill_blocks(at, sequential{});
  }

  [[nodiscard]] IRG_INLINE constexpr const bvh& tree() const noexcept { return tree_; }

private:
  friend struct detail::triangle_blocks;

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
      boxes[i] = bounding_box(bounding_box(box<T, 3>{t[0], t[0]}, t[1]), t[2]);
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
        const triangle& t = at(number == no_index ? tree_.order[b * width] : number);
        for (std::size_t corner = 0; corner < 3; ++corner)
          for (int axis = 0; axis < 3; ++axis) blocks_[b].v[corner][axis][k] = t[corner][axis];
      }
    });
  }

  bvh tree_;
  std::vector<detail::triangle_block<T>> blocks_;
};

namespace detail {

// The corners as the rays of this header read them, eight triangles side by side.
struct triangle_blocks {
  template <Floating T>
  IRG_INLINE static constexpr std::span<const triangle_block<T>> of(const triangle_bvh<T>& triangles) noexcept {
    return triangles.blocks_;
  }
};

}  // namespace detail

inline namespace IRG_COMPILED_ABI {

/// The triangle that the ray crosses first.
/// shape   rays of floats or doubles against triangles of either
/// gives   nothing where it crosses none and for an empty ray; of several crossed in one point the lowest number
/// exact   which triangles are crossed, as intersect_triangle; which of them is first, for all finite numbers; t and
///         weights as there. The same for every tree over these triangles
/// cost    some log n boxes and triangles; nothing allocated. With ray_counts, what the ray asked is added to them;
///         they cost nothing where they are not asked for
template <Floating T, Floating U, RayCounts C = const uncounted_rays>
[[nodiscard]] IRG_API std::optional<triangle_hit> closest_hit(const triangle_bvh<T>& triangles, const ray<U, 3>& r,
                                                              C& counts = not_counted) noexcept;

/// The triangles that rays cross first, hits[i] that of rays[i].
/// shape   rays that follow each other should start near each other and go about the same way, as those of a square of
///         4 by 4 pixels do: each 16 of them are taken through the tree as one where they can be
/// needs   as many hits as rays
/// exact   the same, bit for bit, as closest_hit of each ray
/// cost    of 16 such rays some three times that of one; of others, that of each. ray_counts count once what 16 rays
///         come to as one
template <Floating T, Floating U, RayCounts C = const uncounted_rays>
IRG_API void closest_hits(const triangle_bvh<T>& triangles, std::span<const ray<U, 3>> rays,
                          std::span<std::optional<triangle_hit>> hits, C& counts = not_counted);

/// Whether the ray crosses a triangle; with `admits`, one of those for which admits(number) holds.
/// exact   as closest_hit
/// cost    as closest_hit, and as a rule less
template <Floating T, Floating U, RayCounts C = const uncounted_rays>
[[nodiscard]] IRG_API bool any_hit(const triangle_bvh<T>& triangles, const ray<U, 3>& r,
                                   C& counts = not_counted) noexcept;

}  // namespace IRG_COMPILED_ABI

inline namespace IRG_ABI {

template <Floating T, Floating U, std::predicate<std::uint32_t> Admits, RayCounts C = const uncounted_rays>
[[nodiscard]] constexpr bool any_hit(const triangle_bvh<T>& triangles, const ray<U, 3>& r, const Admits& admits,
                                     C& counts = not_counted);

/// All triangles that the ray crosses, each once, into sink(hit), in no order that is promised.
/// gives   of a closed surface, as many as an origin in general position would: an odd number from inside to infinity
/// exact   as closest_hit
/// cost    as closest_hit; without limit to what is nearest
template <Floating T, Floating U, class Sink, RayCounts C = const uncounted_rays>
constexpr void all_hits(const triangle_bvh<T>& triangles, const ray<U, 3>& r, Sink&& sink, C& counts = not_counted);

}  // namespace IRG_ABI
}  // namespace irg

namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T, Floating U, RayCounts C>
IRG_API bool is_admitted_hit(const triangle_bvh<T>& triangles, const ray<U, 3>& r,
                             const function_ref<bool(std::uint32_t)>& admits, C& counts);
template <Floating T, Floating U, RayCounts C>
IRG_API void each_hit(const triangle_bvh<T>& triangles, const ray<U, 3>& r,
                      const function_ref<void(const triangle_hit&)>& sink, C& counts);

}  // namespace irg::detail::inline IRG_COMPILED_ABI

namespace irg::inline IRG_ABI {

template <Floating T, Floating U, std::predicate<std::uint32_t> Admits, RayCounts C>
[[nodiscard]] constexpr bool any_hit(const triangle_bvh<T>& triangles, const ray<U, 3>& r, const Admits& admits,
                                     C& counts) {
  return detail::is_admitted_hit(triangles, r, as_function<bool(std::uint32_t)>(admits), counts);
}

template <Floating T, Floating U, class Sink, RayCounts C>
constexpr void all_hits(const triangle_bvh<T>& triangles, const ray<U, 3>& r, Sink&& sink, C& counts) {
  detail::each_hit(triangles, r, as_function<void(const triangle_hit&)>(sink), counts);
}

}  // namespace irg::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail {

// Rays through the triangles of a bvh: four at once with one bound for all, and one by one those that it leaves open.

// A crossing that weights are still to be found of.
struct first_crossing {
  crossing_time time{};
  std::uint32_t number = no_index, place = 0;  // of the triangle, and where it is among the blocks
  int turn = 0;
};

struct space_triangle {
  point<double, 3> a, b, c;
};

inline namespace IRG_ABI {

// What triangles need of a ray, made when it comes to the first of them: most rays come to none. Of floats, most rays
// that come to some are told by floats to cross none.
template <class T, class U>
class late_triangle_ray {
public:
  static constexpr bool has_floats = std::is_same_v<T, float> && std::is_same_v<U, float>;

  IRG_INLINE constexpr late_triangle_ray(const bvh& tree, const ray<U, 3>& r) noexcept : tree_(tree), given_(r) {}

  IRG_INLINE constexpr const triangle_ray& prepared() noexcept {
    if (!made_) make();
    return ray_;
  }
  IRG_INLINE constexpr const triangle_ray& ray_for_triangles() const noexcept { return ray_; }

  /// A bit for each triangle of a leaf that the ray does not certainly pass by.
  IRG_INLINE constexpr unsigned open_triangles(std::span<const triangle_block<T>> blocks, std::uint32_t leaf) noexcept {
    if constexpr (has_floats)
      if (sees_in_floats()) {
        if (!floats_made_) make_floats();
        if (floats_.error > 0) return leaf_ahead(blocks.data(), leaf, floats_);
      }
    const triangle_ray& q = prepared();
    return leaf_met(blocks, leaf, q.shear, bound_);
  }

private:
  constexpr void make() noexcept {
    set_triangle_ray(ray_, given_);
    bound_ = bound_of(tree_, ray_.r.origin);
    made_ = true;
  }
  IRG_INLINE void make_floats() noexcept {
    set_float_shear(floats_, given_, reach_of(tree_, exactly_widened(given_.origin)));
    floats_made_ = true;
  }

  const bvh& tree_;
  const ray<U, 3>& given_;
  // None of these is zeroed, which would cost as much as a node.
  triangle_ray ray_;
  float_shear floats_;
  double bound_;
  bool made_ = false, floats_made_ = false;
};

template <class T>
IRG_INLINE constexpr space_triangle triangle_at(std::span<const triangle_block<T>> blocks,
                                                std::uint32_t place) noexcept {
  const auto& v = blocks[place / bvh_node::block].v;
  const std::uint32_t k = place % bvh_node::block;
  const auto corner = [&](int i) -> space_point {
    return {exactly_widened(v[i][0][k]), exactly_widened(v[i][1][k]), exactly_widened(v[i][2][k])};
  };
  return {corner(0), corner(1), corner(2)};
}

// -1, 0 or 1, as a is crossed before b, with it, or after it.
template <class T>
IRG_NOINLINE constexpr int exact_order(const triangle_ray& q, std::span<const triangle_block<T>> blocks,
                                       const first_crossing& a, const first_crossing& b) noexcept {
  const space_triangle first = triangle_at(blocks, a.place), second = triangle_at(blocks, b.place);
  if (first.a == second.a && first.b == second.b && first.c == second.c) return 0;
  std::array<double, 24> in{};
  const auto put = [&in](std::size_t at, const auto& p) {
    for (int i = 0; i < 3; ++i) in[at + static_cast<std::size_t>(i)] = p[i];
  };
  put(9, q.r.origin);
  put(12, q.r.direction);
  put(0, first.a);
  put(3, first.b);
  put(6, first.c);
  put(15, second.a);
  put(18, second.b);
  put(21, second.c);
  const int sign = irg::sign_of<6>(
      [](const auto& x) {
        const std::array other = {x[15], x[16], x[17], x[18], x[19], x[20], x[21], x[22],
                                  x[23], x[9],  x[10], x[11], x[12], x[13], x[14]};
        return height_along(x) * advance_along(other) - height_along(other) * advance_along(x);
      },
      in);
  return sign * a.turn * b.turn;
}

template <class T>
IRG_INLINE constexpr bool is_before(const triangle_ray& q, std::span<const triangle_block<T>> blocks,
                                    const first_crossing& a, const first_crossing& b) noexcept {
  const double apart = a.time.t - b.time.t, error = a.time.error + b.time.error;
  if (apart > error) return false;
  const int order = -apart > error ? -1 : exact_order(q, blocks, a, b);
  return order != 0 ? order < 0 : a.number < b.number;
}

// The crossing with the triangle at a place, if there is one, into use(crossing); gives what that gives.
template <class Use>
IRG_INLINE constexpr bool cross_place(const bvh& tree, const space_triangle& t, std::uint32_t place,
                                      const triangle_ray& q, const sheared_sides<double>& sides, const Use& use) {
  const timed_crossing found = cross_in_time(q, t.a, t.b, t.c, sides, largest_from(q.r.origin, t.a, t.b, t.c));
  return found.hit && use(first_crossing{found.time, tree.order[place], place, found.turn});
}

// Calls use(crossing) for the triangles of a leaf that the ray crosses, of those whose bits are set, until it gives
// true.
template <class T, class Use>
IRG_INLINE constexpr bool cross_leaf(const bvh& tree, std::span<const triangle_block<T>> blocks, std::uint32_t leaf,
                                     const triangle_ray& q, unsigned bits, const Use& use) {
  for (; bits != 0; bits &= bits - 1) {
    const std::uint32_t place = bvh_node::first_place(leaf) + static_cast<std::uint32_t>(std::countr_zero(bits));
    const space_triangle t = triangle_at(blocks, place);
    if (cross_place(tree, t, place, q, sides_round(q, t.a, t.b, t.c), use)) return true;
  }
  return false;
}

template <class T>
constexpr ray_crossing finished_crossing(const triangle_ray& q, std::span<const triangle_block<T>> blocks,
                                         const first_crossing& f) noexcept {
  ray_crossing x{f.turn < 0 ? facing::front : facing::back, f.time.t, 0, 0};
  const space_triangle t = triangle_at(blocks, f.place);
  set_weights(x, q, t.a, t.b, t.c, sides_round(q, t.a, t.b, t.c), largest_from(q.r.origin, t.a, t.b, t.c));
  return x;
}

// The first crossing into use(triangle_ray, crossing), if there is one.
template <class T, class U, class Use, RayCounts C>
IRG_INLINE constexpr void find_first_crossing(const bvh& tree, std::span<const triangle_block<T>> blocks,
                                              const ray<U, 3>& r, C& counts, const Use& use) {
  count_rays(counts, 1);
  box_ray b;
  if (!set_box_ray(b, r, tree.scale)) return;
  late_triangle_ray<T, U> q(tree, r);
  std::optional<first_crossing> best;
  walk_near_to_far<box_arithmetic::fused>(tree, b, counts, [&](std::uint32_t leaf) IRG_NOINLINE_LAMBDA {
    const unsigned open = q.open_triangles(blocks, leaf);
    if (open == 0) return;
    cross_leaf(tree, blocks, leaf, q.prepared(), open, [&](const first_crossing& x) {
      if (!best || is_before(q.ray_for_triangles(), blocks, x, *best)) {
        best = x;
        b.high = later_time(b, x.time.t + x.time.error);
      }
      return false;
    });
  });
  if (best) use(q.ray_for_triangles(), *best);
}

// What the rays of a packet have met so far.
struct packet_crossings {
  // Each is made when its ray comes to a triangle, and crosses one: most packets come to none.
  union {
    triangle_ray rays[ray_packet::size];
  };
  union {
    first_crossing best[ray_packet::size];
  };
  double bound[ray_packet::size];
  packet_shear shear;
  unsigned ready = 0, hit = 0;  // a bit for each ray

  packet_crossings() noexcept {}  // zeroes nothing
};

// The first crossings of 16 rays into use(k, triangle_ray, crossing); false where they do not go as one.
template <class T, class Use, RayCounts C>
bool find_packet_crossings(const bvh& tree, std::span<const triangle_block<T>> blocks, const ray<float, 3>* rays,
                           C& counts, const Use& use) {
  ray_packet p;
  if (!set_up_packet(p, rays, tree.scale)) return false;
  count_rays(counts, ray_packet::size);
  std::optional<packet_crossings> found;
  walk_packet(tree.nodes.data(), p, counts, [&](std::uint32_t leaf, unsigned bits) {
    if (!found) set_packet_shear(found.emplace().shear, tree.scale, rays);
    packet_crossings& f = *found;
    bool nearer = false;
    const auto prepare = [&](unsigned k) {
      if ((f.ready >> k & 1) == 0) {
        set_triangle_ray(*new (static_cast<void*>(&f.rays[k])) triangle_ray, rays[k]);
        f.bound[k] = bound_of(tree, f.rays[k].r.origin);
        f.ready |= 1u << k;
      }
    };
    const auto take = [&](unsigned k) {
      return [&, k](const first_crossing& x) {
        if ((f.hit >> k & 1) == 0 || is_before(f.rays[k], blocks, x, f.best[k])) {
          new (static_cast<void*>(&f.best[k])) first_crossing(x);
          f.hit |= 1u << k;
          p.high[k] = minimum(p.high[k], later_time(p.whole, x.time.t + x.time.error));
          nearer = true;
        }
        return false;
      };
    };
    if (f.shear.error > 0 && std::popcount(bits) > 3) {
      const std::uint32_t first = bvh_node::first_place(leaf), last = bvh_node::last_place(leaf);
      for (std::uint32_t i = first; i <= last; ++i) {
        const auto& block = blocks[i / bvh_node::block];
        unsigned open = bits & rays_at_triangle<packet_lanes>(f.shear, block, i % bvh_node::block);
        if (open == 0) continue;
        const space_triangle t = triangle_at(blocks, i);
        for (; open != 0; open &= open - 1) {
          const auto k = static_cast<unsigned>(std::countr_zero(open));
          prepare(k);
          cross_place(tree, t, i, f.rays[k], sides_round(f.rays[k], t.a, t.b, t.c), take(k));
        }
      }
    } else {
      for (; bits != 0; bits &= bits - 1) {
        const auto k = static_cast<unsigned>(std::countr_zero(bits));
        prepare(k);
        cross_leaf(tree, blocks, leaf, f.rays[k], leaf_met(blocks, leaf, f.rays[k].shear, f.bound[k]), take(k));
      }
    }
    if (nearer) p.whole.high = latest_of(p);
  });
  if (found)
    for (unsigned bits = found->hit; bits != 0; bits &= bits - 1) {
      const auto k = static_cast<unsigned>(std::countr_zero(bits));
      use(k, found->rays[k], found->best[k]);
    }
  return true;
}

template <class T, class U, class Admits, RayCounts C>
constexpr bool crosses_any(const bvh& tree, std::span<const triangle_block<T>> blocks, const ray<U, 3>& r, C& counts,
                           const Admits& admits) {
  count_rays(counts, 1);
  box_ray b;
  if (!set_box_ray(b, r, tree.scale)) return false;
  late_triangle_ray<T, U> q(tree, r);
  return walk_anyhow<box_arithmetic::fused>(tree, b, counts, [&](std::uint32_t leaf) IRG_NOINLINE_LAMBDA {
    const unsigned open = q.open_triangles(blocks, leaf);
    return open != 0 && cross_leaf(tree, blocks, leaf, q.prepared(), open,
                                   [&](const first_crossing& x) { return admits(x.number); });
  });
}

template <class T, class U, class Use, RayCounts C>
constexpr void each_crossing(const bvh& tree, std::span<const triangle_block<T>> blocks, const ray<U, 3>& r, C& counts,
                             const Use& use) {
  count_rays(counts, 1);
  box_ray b;
  if (!set_box_ray(b, r, tree.scale)) return;
  late_triangle_ray<T, U> q(tree, r);
  walk_anyhow<box_arithmetic::fused>(tree, b, counts, [&](std::uint32_t leaf) IRG_NOINLINE_LAMBDA {
    const unsigned open = q.open_triangles(blocks, leaf);
    if (open == 0) return false;
    cross_leaf(tree, blocks, leaf, q.prepared(), open, [&](const first_crossing& x) {
      if (is_first_met<box_arithmetic::fused>(tree, x.place, b)) use(q.ray_for_triangles(), x);
      return false;
    });
    return false;
  });
}

}  // namespace IRG_ABI
}  // namespace irg::detail

namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API bvh build_triangle_tree(std::span<const box<T, 3>> boxes, const bvh_options& config,
                                const executor_ref& executor,
                                const function_ref<std::array<point<T, 3>, 3>(std::size_t)>& at) {
  using triangle_at = function_ref<std::array<point<T, 3>, 3>(std::size_t)>;
  return build_tree(boxes, config, executor, [&at](double scale) { return triangle_cut<triangle_at>{at, scale}; });
}

template <Floating T, Floating U, RayCounts C>
IRG_API bool is_admitted_hit(const triangle_bvh<T>& triangles, const ray<U, 3>& r,
                             const function_ref<bool(std::uint32_t)>& admits, C& counts) {
  return crosses_any(triangles.tree(), triangle_blocks::of(triangles), r, counts, admits);
}

template <Floating T, Floating U, RayCounts C>
IRG_API void each_hit(const triangle_bvh<T>& triangles, const ray<U, 3>& r,
                      const function_ref<void(const triangle_hit&)>& sink, C& counts) {
  const std::span<const triangle_block<T>> blocks = triangle_blocks::of(triangles);
  each_crossing(triangles.tree(), blocks, r, counts, [&](const triangle_ray& q, const first_crossing& x) {
    sink(triangle_hit{x.number, finished_crossing(q, blocks, x)});
  });
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI

namespace irg::inline IRG_COMPILED_ABI {

template <Floating T, Floating U, RayCounts C>
[[nodiscard]] IRG_API std::optional<triangle_hit> closest_hit(const triangle_bvh<T>& triangles, const ray<U, 3>& r,
                                                              C& counts) noexcept {
  std::optional<triangle_hit> hit;
  detail::find_first_crossing(triangles.tree(), detail::triangle_blocks::of(triangles), r, counts,
                              [&](const detail::triangle_ray& q, const detail::first_crossing& x) {
                                hit = triangle_hit{
                                    x.number, detail::finished_crossing(q, detail::triangle_blocks::of(triangles), x)};
                              });
  return hit;
}

template <Floating T, Floating U, RayCounts C>
IRG_API void closest_hits(const triangle_bvh<T>& triangles, std::span<const ray<U, 3>> rays,
                          std::span<std::optional<triangle_hit>> hits, C& counts) {
  IRG_EXPECTS(rays.size() == hits.size());
  std::size_t i = 0;
  for (; i < rays.size(); ++i) {
    if constexpr (std::is_same_v<U, float>)
      while (detail::walks_in_packets() && rays.size() - i >= detail::ray_packet::size) {
        const auto put = [&](unsigned k, const auto& q, const detail::first_crossing& x) {
          hits[i + k] = triangle_hit{x.number, detail::finished_crossing(q, detail::triangle_blocks::of(triangles), x)};
        };
        for (std::size_t k = 0; k < detail::ray_packet::size; ++k) hits[i + k] = std::nullopt;
        if (!detail::find_packet_crossings(triangles.tree(), detail::triangle_blocks::of(triangles), rays.data() + i,
                                           counts, put)) {
          for (std::size_t k = 0; k < detail::ray_packet::size; ++k)
            hits[i + k] = closest_hit(triangles, rays[i + k], counts);
        }
        i += detail::ray_packet::size;
      }
    if (i < rays.size()) hits[i] = closest_hit(triangles, rays[i], counts);
  }
}

template <Floating T, Floating U, RayCounts C>
[[nodiscard]] IRG_API bool any_hit(const triangle_bvh<T>& triangles, const ray<U, 3>& r, C& counts) noexcept {
  return detail::crosses_any(triangles.tree(), detail::triangle_blocks::of(triangles), r, counts,
                             [](std::uint32_t) { return true; });
}

}  // namespace irg::inline IRG_COMPILED_ABI
#endif
