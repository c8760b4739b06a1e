// SPDX-License-Identifier: MIT
// A source and obstacles that cross its edges, cut where they do, so that weak_visibility answers.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <irg/geometry/vocabulary.hpp>
#include <irg/math/vec.hpp>
#if IRG_BODIES
#include <irg/geometry/compare.hpp>
#include <irg/geometry/crossing_point.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/visibility/detail/turn_between.hpp>
#endif

namespace irg {

/// The ring of a source and obstacles, none of which cross its edges.
template <Floating T>
struct cut_source {
  std::vector<point<T, 2>> ring;
  std::vector<segment<T, 2>> obstacles;
  bool operator==(const cut_source&) const = default;
};

/// The pieces of a segment and obstacles, none of which cross them.
template <Floating T>
struct cut_segment {
  std::vector<std::vector<point<T, 2>>> pieces;
  std::vector<segment<T, 2>> obstacles;
  bool operator==(const cut_segment&) const = default;
};

inline namespace IRG_COMPILED_ABI {

/// Cuts the edges of a ring and the obstacles that cross them, in the points nearest to where they do: a light that
/// walls cut, for weak_visibility.
/// needs   finite coordinates; three points or more, else nothing is cut across the way back
/// gives   edges and obstacles bent by as much as these points are rounded, obstacles along an edge with it. In plans
///         so fine that bent ones cross again and again, some may be left that cross; weak_visibility says so
/// exact   which ones cross, and which lie along an edge; where is correctly rounded
/// cost    the edges times the obstacles, a few times over; allocates
template <Floating T>
[[nodiscard]] IRG_API cut_source<T> cut_source_rounded(std::span<const point<T, 2>> ring,
                                                       std::span<const std::type_identity_t<segment<T, 2>>> obstacles);

/// The same for a segment that shines: its pieces are a source of weak_visibility as a list.
template <Floating T>
[[nodiscard]] IRG_API cut_segment<T> cut_segment_rounded(
    const segment<T, 2>& source, std::span<const std::type_identity_t<segment<T, 2>>> obstacles);

}  // namespace IRG_COMPILED_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// A chain of edges and obstacles. First the ends of obstacles on edges become corners, and obstacles along edges are
// cut at corners: these are edges then, or in none. When an edge is bent where an obstacle crosses it, such obstacles
// are bent with it.
template <Floating T>
class source_cutter {
public:
  std::vector<point<T, 2>> chain{};
  std::vector<segment<T, 2>> obstacles{};

  constexpr source_cutter(std::span<const point<T, 2>> points, std::span<const segment<T, 2>> walls)
      : chain(points.begin(), points.end()), obstacles(walls.begin(), walls.end()), is_ring_(points.size() > 2) {}

  constexpr void run() {
    cuts_left_ = 4 * (chain.size() + 2) * obstacles.size();
    for (bool bent = true; bent;) {
      bent = false;
      follow_edges();
      for (std::size_t k = 0; k < obstacles.size() && cuts_left_ > 0; ++k)
        for (; cuts_left_ > 0 && cut(k); --cuts_left_) bent = true;
    }
  }

private:
  bool is_ring_;
  std::size_t cuts_left_ = 0;

  constexpr std::size_t edge_count() const noexcept {
    return is_ring_ || chain.empty() ? chain.size() : chain.size() - 1;
  }
  constexpr segment<T, 2> edge(std::size_t i) const noexcept {
    return {chain[i], chain[i + 1 < chain.size() ? i + 1 : 0]};
  }
  constexpr void add_corner(std::size_t i, const point<T, 2>& p) {
    chain.insert(chain.begin() + static_cast<std::ptrdiff_t>(i) + 1, p);
  }

  static constexpr bool holds_within(const segment<T, 2>& e, const point<T, 2>& p) noexcept {
    return orient2d(e.a, e.b, p) == 0 && compare_lexicographic(e.a, p) * compare_lexicographic(p, e.b) > 0;
  }

  constexpr void follow_edges() {
    for (const auto& o : obstacles)
      for (const auto& p : {o.a, o.b})
        for (std::size_t i = 0; i < edge_count(); ++i)
          if (holds_within(edge(i), p)) add_corner(i, p);
    for (std::size_t k = 0; k < obstacles.size(); ++k)
      for (const auto& p : chain)
        if (const segment<T, 2> o = obstacles[k]; holds_within(o, p)) {
          obstacles[k] = {o.a, p};
          obstacles.push_back({p, o.b});
        }
  }

  // Whether an obstacle crosses an edge, and both are cut. Of the two, one at least gets a new corner.
  constexpr bool cut(std::size_t k) {
    const segment<T, 2> o = obstacles[k];
    for (std::size_t i = 0; i < edge_count(); ++i) {
      const segment<T, 2> e = edge(i);
      if (!cross_properly(e, o)) continue;
      const point<T, 2> at = *intersection_point(e, o);
      if (!(at == e.a) && !(at == e.b)) {
        add_corner(i, at);
        for (std::size_t n = obstacles.size(); n-- > 0;)
          if (const segment<T, 2> w = obstacles[n]; (w.a == e.a && w.b == e.b) || (w.a == e.b && w.b == e.a)) {
            obstacles[n] = {w.a, at};
            obstacles.push_back({at, w.b});
          }
      }
      if (at == o.a || at == o.b) return true;
      obstacles[k] = {o.a, at};
      obstacles.push_back({at, o.b});
      return true;
    }
    return false;
  }
};

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API cut_source<T> cut_source_rounded(std::span<const point<T, 2>> ring,
                                                       std::span<const std::type_identity_t<segment<T, 2>>> obstacles) {
  detail::source_cutter<T> all(ring, obstacles);
  all.run();
  return {std::move(all.chain), std::move(all.obstacles)};
}

template <Floating T>
[[nodiscard]] IRG_API cut_segment<T> cut_segment_rounded(
    const segment<T, 2>& source, std::span<const std::type_identity_t<segment<T, 2>>> obstacles) {
  const point<T, 2> ends[] = {source.a, source.b};
  detail::source_cutter<T> all(ends, obstacles);
  all.run();
  cut_segment<T> out;
  for (std::size_t i = 0; i + 1 < all.chain.size(); ++i) out.pieces.push_back({all.chain[i], all.chain[i + 1]});
  out.obstacles = std::move(all.obstacles);
  return out;
}

}  // namespace irg::inline IRG_COMPILED_ABI
#endif
