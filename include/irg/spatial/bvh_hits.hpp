// SPDX-License-Identifier: MIT
// What a ray meets of anything in a bvh: spheres, patches, boxes of other trees. The tree finds the primitives whose
// boxes the ray meets; the caller's test tells whether and when it meets them.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include <irg/spatial/bvh_node.hpp>
#include <irg/spatial/detail/walk_bvh.hpp>

namespace irg {

/// A primitive that a ray meets, and when.
template <Floating T>
struct primitive_hit {
  std::uint32_t primitive = no_index;
  T t{};
  bool operator==(const primitive_hit&) const = default;
};

/// test(number, ray) gives the first t at which the ray meets a primitive, or nothing.
template <class F, class T>
concept RayTest = Floating<T> && requires(const F& test, std::uint32_t number, const ray<T, 3>& r) {
  { test(number, r) } -> std::convertible_to<std::optional<T>>;
};

namespace detail::inline IRG_ABI {

// Calls use(number, t) for the primitives of a leaf that the ray meets, until it gives true; for those at whose place
// of the order asks(place) holds.
template <class T, class Test, class Use, class Asks>
IRG_INLINE constexpr bool meet_leaf(const bvh& tree, std::uint32_t leaf, const ray<T, 3>& r, const Test& test,
                                    const Use& use, const Asks& asks) {
  for (std::uint32_t i = bvh_node::first_place(leaf); i <= bvh_node::last_place(leaf); ++i) {
    if (!asks(i)) continue;
    const std::optional<T> t = test(tree.order[i], r);
    if (t && r.low <= *t && *t <= r.high && use(tree.order[i], *t)) return true;
  }
  return false;
}

template <class T>
IRG_INLINE constexpr ray<T, 3> from_zero(ray<T, 3> r) noexcept {
  r.low = maximum(r.low, T(0));
  return r;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The primitive that the ray meets first.
/// shape   the ray that test is asked about ends at what was found so far
/// gives   nothing where it meets none and for an empty ray; of those met at the same t the one of the lowest number
/// exact   no primitive is missed whose box the ray meets; the rest is the test's. It may find what is 2^-20 of t
///         farther than what is nearest, but no more, before what is nearer
/// cost    some log n boxes and primitives; nothing allocated. With ray_counts, what the ray asked is added to them;
///         they cost nothing where they are not asked for
template <Floating T, RayTest<T> Test, RayCounts C = const uncounted_rays>
[[nodiscard]] constexpr std::optional<primitive_hit<T>> closest_hit(const bvh& tree, const ray<T, 3>& r,
                                                                    const Test& test, C& counts = not_counted) {
  detail::count_rays(counts, 1);
  detail::box_ray b;
  if (!detail::set_box_ray(b, r, tree.scale)) return std::nullopt;
  ray<T, 3> rest = detail::from_zero(r);
  std::optional<primitive_hit<T>> best;
  detail::walk_near_to_far(tree, b, counts, [&](std::uint32_t leaf) {
    detail::meet_leaf(
        tree, leaf, rest, test,
        [&](std::uint32_t number, T t) {
          if (!best || t < best->t || number < best->primitive) {
            best = {number, t};
            rest.high = t;
            // What is subnormal in T is off by more than later_time's slack.
            b.high = detail::later_time(b, exactly_widened(t) + widened((std::numeric_limits<T>::min)()));
          }
          return false;
        },
        [](std::uint32_t) { return true; });
  });
  return best;
}

/// Whether the ray meets a primitive.
/// exact   no primitive is missed whose box the ray meets
/// cost    as closest_hit, and as a rule less
template <Floating T, RayTest<T> Test, RayCounts C = const uncounted_rays>
[[nodiscard]] constexpr bool any_hit(const bvh& tree, const ray<T, 3>& r, const Test& test, C& counts = not_counted) {
  detail::count_rays(counts, 1);
  detail::box_ray b;
  if (!detail::set_box_ray(b, r, tree.scale)) return false;
  const ray<T, 3> whole = detail::from_zero(r);
  return detail::walk_anyhow(tree, b, counts, [&](std::uint32_t leaf) {
    return detail::meet_leaf(
        tree, leaf, whole, test, [](std::uint32_t, T) { return true; }, [](std::uint32_t) { return true; });
  });
}

/// All primitives that the ray meets, each once, into sink(hit), in no order that is promised.
/// exact   as any_hit
/// cost    as closest_hit; without limit to what is nearest
template <Floating T, RayTest<T> Test, class Sink, RayCounts C = const uncounted_rays>
constexpr void all_hits(const bvh& tree, const ray<T, 3>& r, const Test& test, Sink&& sink, C& counts = not_counted) {
  detail::count_rays(counts, 1);
  detail::box_ray b;
  if (!detail::set_box_ray(b, r, tree.scale)) return;
  const ray<T, 3> whole = detail::from_zero(r);
  detail::walk_anyhow(tree, b, counts, [&](std::uint32_t leaf) {
    detail::meet_leaf(
        tree, leaf, whole, test,
        [&](std::uint32_t number, T t) {
          sink(primitive_hit<T>{number, t});
          return false;
        },
        [&](std::uint32_t place) { return detail::is_first_met(tree, place, b); });
    return false;
  });
}

/// The primitives whose boxes have a point in common with a box, each once, into sink(number).
/// gives   more than those, by what the tree's boxes are rounded by: none is missed
/// cost    log n and the primitives found; nothing allocated
template <Floating T, class Sink>
constexpr void each_in_box(const bvh& tree, const box<T, 3>& b, Sink&& sink) {
  if (tree.nodes.empty() || !detail::is_held(b)) return;
  const detail::bvh_item asked = detail::item_of(b, 0, tree.scale);
  const auto meets = [&](std::uint32_t slot) {
    const bvh_node& node = tree.nodes[slot / bvh_node::width];
    const int k = static_cast<int>(slot % bvh_node::width);
    bool both = node.child[k] != no_index;
    for (int i = 0; i < 3; ++i) both = both && asked.v[i] <= node.high(i, k) && node.low(i, k) <= 0.0f - asked.v[4 + i];
    return both;
  };
  std::uint32_t waiting[detail::bvh_waiting];
  int top = 0;
  waiting[top++] = 0;
  while (top > 0) {
    const std::uint32_t at = waiting[--top];
    const bvh_node& node = tree.nodes[at];
    for (std::uint32_t k = 0; k < bvh_node::width; ++k) {
      if (!meets(at * bvh_node::width + k)) continue;
      if (!bvh_node::is_leaf(node.child[k])) {
        waiting[top++] = node.child[k];
        continue;
      }
      for (std::uint32_t i = bvh_node::first_place(node.child[k]); i <= bvh_node::last_place(node.child[k]); ++i)
        if (detail::is_first_met(tree, i, meets)) sink(tree.order[i]);
    }
  }
}

}  // namespace IRG_ABI
}  // namespace irg
