// SPDX-License-Identifier: MIT
// The minimax tests of lectures between bodies, polygons and edges: what has disjoint rectangles in the projection
// plane cannot hide each other. Coordinates beyond x and y are not looked at.
#pragma once

#include <cstdint>

#include <irg/geometry/box.hpp>
#include <irg/geometry/vocabulary.hpp>

namespace irg {
namespace detail {

template <class T>
inline constexpr bool is_segment = false;
template <class T, int N>
inline constexpr bool is_segment<segment<T, N>> = true;

}  // namespace detail

/// What has a rectangle in the projection plane: bodies (meshes), polygons (rings of points) and edges (segments).
template <class X>
concept HasRectangle = Mesh<X> || (PolygonRing<X> && Point<ring_point<X>>) || detail::is_segment<X>;

/// The minimax tests, by what they are between, in either order.
enum class minimax_test { edge_edge, edge_polygon, edge_body, polygon_polygon, polygon_body, body_body };

/// How often a minimax test was made, and how often it showed that neither hides the other.
struct minimax_count {
  std::int64_t tested = 0, apart = 0;
  bool operator==(const minimax_count&) const = default;
};

/// The work of minimax tests.
/// shape   test[k] counts those of minimax_test k
struct minimax_counts {
  minimax_count test[6];
  bool operator==(const minimax_counts&) const = default;
};

namespace detail {

// 0 for an edge, 1 for a polygon, 2 for a body.
template <HasRectangle X>
inline constexpr int minimax_rank = is_segment<X> ? 0
                                    : Mesh<X>     ? 2
                                                  : 1;

}  // namespace detail

/// The minimax test between things of types A and B.
template <HasRectangle A, HasRectangle B>
inline constexpr minimax_test minimax_test_of = [] {
  constexpr int a = detail::minimax_rank<A>, b = detail::minimax_rank<B>, low = a < b ? a : b;
  return static_cast<minimax_test>(a + b + (low > 0 ? 1 : 0));
}();

inline namespace IRG_ABI {

/// The smallest rectangle around the x and y of a body, polygon or edge.
/// gives   the empty box when there are no points; coordinates that are NaN are passed over
/// exact   no arithmetic
template <HasRectangle X>
[[nodiscard]] constexpr auto rectangle_of(const X& x) noexcept {
  const auto b = bounding_box(x);
  using T = std::remove_cvref_t<decltype(b.low[0])>;
  return box<T, 2>{{b.low[0], b.low[1]}, {b.high[0], b.high[1]}};
}

/// The minimax test between any two of body, polygon and edge: whether their rectangles in the projection plane
/// overlap. Where they do not, neither hides the other.
/// gives   false when either has no points
/// exact   comparisons alone
/// source  Mihajlovic 2016, 7.1: body-body, polygon-body, edge-body, polygon-polygon, edge-polygon and edge-edge
template <HasRectangle A, HasRectangle B>
[[nodiscard]] constexpr bool rectangles_overlap(const A& a, const B& b,
                                                box_boundary boundary = box_boundary::closed) noexcept {
  return overlap(rectangle_of(a), rectangle_of(b), boundary);
}

/// The same, counted.
template <HasRectangle A, HasRectangle B>
constexpr bool rectangles_overlap(const A& a, const B& b, minimax_counts& counts,
                                  box_boundary boundary = box_boundary::closed) noexcept {
  minimax_count& count = counts.test[static_cast<int>(minimax_test_of<A, B>)];
  const bool found = rectangles_overlap(a, b, boundary);
  ++count.tested;
  if (!found) ++count.apart;
  return found;
}

}  // namespace IRG_ABI
}  // namespace irg
