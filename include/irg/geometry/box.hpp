// SPDX-License-Identifier: MIT
// Axis-parallel boxes: extents of point sets, and the minimax test that rejects most pairs before any real work.
#pragma once

#include <cstddef>
#include <limits>

#include <irg/core/contract.hpp>
#include <irg/core/mesh_concept.hpp>
#include <irg/core/ring.hpp>
#include <irg/math/length.hpp>
#include <irg/math/vec.hpp>

namespace irg {

namespace detail {

// What an empty box starts from: every number is below `low` or equal to it, and above `high` or equal to it. Numbers
// without limits (rationals) have no such bounds; there 1 and 0 merely say "empty".
template <class T>
struct IRG_APART empty_extent {
  using limits = std::numeric_limits<T>;
  IRG_INLINE static constexpr T low() noexcept {
    if constexpr (!limits::is_specialized)
      return T(1);
    else if constexpr (limits::has_infinity)
      return limits::infinity();
    else
      return (limits::max)();
  }
  IRG_INLINE static constexpr T high() noexcept {
    if constexpr (!limits::is_specialized)
      return T(0);
    else if constexpr (limits::has_infinity)
      return -limits::infinity();
    else
      return limits::lowest();
  }
};

template <class T, int N>
IRG_INLINE constexpr point<T, N> diagonal_point(T x) noexcept {
  return generate_coordinates<point<T, N>>([&](int) IRG_INLINE_LAMBDA { return x; });
}

}  // namespace detail

/// All points p with low <= p <= high on every axis.
/// shape   empty when low <= high fails on some axis (NaN included); a box made with {} is empty
template <Scalar T, int N>
struct box {
  point<T, N> low = detail::diagonal_point<T, N>(detail::empty_extent<T>::low());
  point<T, N> high = detail::diagonal_point<T, N>(detail::empty_extent<T>::high());

  /// Whether the box contains no point.
  [[nodiscard]] IRG_INLINE constexpr bool empty() const noexcept {
    for (int i = 0; i < N; ++i)
      if (!(low[i] < high[i] || low[i] == high[i])) return true;
    return false;
  }
  bool operator==(const box&) const = default;
};

/// Whether boxes that share no more than their boundary overlap.
enum class box_boundary {
  closed,  // touching counts
  open,    // touching does not count; a flat box inside another one still does
};

/// A ball by its centre and radius.
template <Scalar T, int N>
struct bounding_sphere {
  point<T, N> centre;
  T radius{};
  bool operator==(const bounding_sphere&) const = default;
};

inline namespace IRG_ABI {

/// Writes the two corners, "((0, 0), (1, 1))".
template <class S, class T, int N>
  requires TextStream<S, T>
constexpr S& operator<<(S& stream, const box<T, N>& b) {
  return print_list(stream, 2, [&](int i) { return i == 0 ? b.low : b.high; });
}

/// The smallest box around b and p.
/// gives   a coordinate of p that is NaN is passed over, the others count
/// exact   no arithmetic
template <class T, int N>
[[nodiscard]] IRG_INLINE constexpr box<T, N> bounding_box(const box<T, N>& b, const point<T, N>& p) noexcept {
  if constexpr (!std::numeric_limits<T>::is_specialized)
    if (b.empty()) return {p, p};
  return {generate_coordinates<point<T, N>>([&](int i) { return minimum(p[i], b.low[i]); }),
          generate_coordinates<point<T, N>>([&](int i) { return maximum(p[i], b.high[i]); })};
}

/// The smallest box around a and b.
/// gives   the other one when one is empty
/// exact   no arithmetic
template <class T, int N>
[[nodiscard]] IRG_INLINE constexpr box<T, N> bounding_box(const box<T, N>& a, const box<T, N>& b) noexcept {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return bounding_box(bounding_box(a, b.low), b.high);
}

/// The smallest box around the points of a range or ring.
/// gives   the empty box when there are none; coordinates that are NaN are passed over
/// exact   no arithmetic
/// cost    one pass
template <PolygonRing R>
  requires Point<typename ring_traits<R>::point>
[[nodiscard]] constexpr auto bounding_box(const R& points) noexcept {
  using P = typename ring_traits<R>::point;
  using T = scalar_of<P>;
  box<T, size_of<P>> b;
  for (std::size_t k = 0; k < ring_traits<R>::size(points); ++k) {
    const P p = ring_traits<R>::vertex(points, k);
    b = bounding_box(b, generate_coordinates<point<T, size_of<P>>>([&](int i) { return coordinate(p, i); }));
  }
  return b;
}

/// The smallest box around all positions of a mesh, used by a face or not.
/// gives   the empty box when there are none; coordinates that are NaN are passed over
/// exact   no arithmetic
/// cost    one pass
template <Mesh M>
[[nodiscard]] constexpr auto bounding_box(const M& m) noexcept {
  using P = typename mesh_traits<M>::point;
  using T = scalar_of<P>;
  box<T, size_of<P>> b;
  for (std::size_t v = 0; v < mesh_traits<M>::vertex_count(m); ++v) {
    const P p = mesh_traits<M>::position(m, v);
    b = bounding_box(b, generate_coordinates<point<T, size_of<P>>>([&](int i) { return coordinate(p, i); }));
  }
  return b;
}

/// The minimax test: whether two boxes have a point in common.
/// gives   false when either is empty
/// exact   comparisons alone
/// source  Mihajlovic 2016, 7.1 (tests of bounding rectangles)
template <class T, int N>
[[nodiscard]] IRG_INLINE constexpr bool overlap(const box<T, N>& a, const box<T, N>& b,
                                                box_boundary boundary = box_boundary::closed) noexcept {
  if (a.empty() || b.empty()) return false;
  for (int i = 0; i < N; ++i) {
    if (a.high[i] < b.low[i] || b.high[i] < a.low[i]) return false;
    if (boundary == box_boundary::open && (a.high[i] == b.low[i] || b.high[i] == a.low[i])) return false;
  }
  return true;
}

/// The box of the points that lie in both boxes.
/// gives   an empty box when there is none; one without volume where they touch
/// exact   comparisons alone
template <class T, int N>
[[nodiscard]] IRG_INLINE constexpr box<T, N> intersect(const box<T, N>& a, const box<T, N>& b) noexcept {
  if (!overlap(a, b)) return {};
  return {generate_coordinates<point<T, N>>([&](int i) { return maximum(a.low[i], b.low[i]); }),
          generate_coordinates<point<T, N>>([&](int i) { return minimum(a.high[i], b.high[i]); })};
}

/// Whether p lies in the box or on its boundary.
/// gives   false when a coordinate of p is NaN
/// exact   comparisons alone
template <class T, int N>
[[nodiscard]] IRG_INLINE constexpr bool contains(const box<T, N>& b, const point<T, N>& p) noexcept {
  return !box<T, N>{p, p}.empty() && overlap(b, box<T, N>{p, p});
}

/// The edge lengths.
/// gives   zeros for the empty box; infinity where the difference is beyond the range
/// exact   each difference rounded once
template <class T, int N>
[[nodiscard]] constexpr vec<T, N> extent(const box<T, N>& b) noexcept {
  if (b.empty()) return {};
  return b.high - b.low;
}

/// The point halfway between low and high.
/// needs   a box that is not empty
/// exact   (low + high)/2, rounded once unless subnormal; no overflow for finite corners
template <Real T, int N>
[[nodiscard]] constexpr point<T, N> centre(const box<T, N>& b) noexcept {
  IRG_EXPECTS(!b.empty());
  return generate_coordinates<point<T, N>>([&](int i) {
    if constexpr (std::numeric_limits<T>::is_bounded) {
      const T half = (std::numeric_limits<T>::max)() / T(2);
      if (half < b.high[i] || b.low[i] < -half) return b.low[i] / T(2) + b.high[i] / T(2);
    }
    return (b.low[i] + b.high[i]) / T(2);
  });
}

/// Corner k of the box: bit i of k chooses low (0) or high (1) on axis i.
/// needs   0 <= k < 2^N
template <class T, int N>
[[nodiscard]] IRG_INLINE constexpr point<T, N> corner(const box<T, N>& b, unsigned k) noexcept {
  IRG_EXPECTS(k < (1u << N));
  return generate_coordinates<point<T, N>>([&](int i) { return (k >> i & 1u) != 0 ? b.high[i] : b.low[i]; });
}

/// The ball about the centre of the box that reaches to its corners.
/// needs   a box that is not empty
/// exact   radius within 2 ulp
template <Floating T, int N>
[[nodiscard]] constexpr bounding_sphere<T, N> bounding_sphere_of(const box<T, N>& b) noexcept {
  const point<T, N> middle = centre(b);
  const vec<T, N> half = generate_coordinates<vec<T, N>>([&](int i) {
    return maximum(b.high[i] - middle[i], middle[i] - b.low[i]);  // the centre may be rounded towards either
  });
  return {middle, length(half)};
}

/// The ball about the centre of a mesh's box that just holds all its vertices: as a rule tighter than the box's own.
/// needs   a mesh with vertices
/// exact   radius within 2 ulp
template <Mesh M>
  requires Floating<scalar_of<mesh_point<M>>>
[[nodiscard]] constexpr auto bounding_sphere_of(const M& m) noexcept {
  using traits = mesh_traits<M>;
  using T = scalar_of<typename traits::point>;
  bounding_sphere<T, size_of<typename traits::point>> ball{centre(bounding_box(m)), T(0)};
  for (std::size_t v = 0; v < traits::vertex_count(m); ++v) {
    const auto from_centre = generate_coordinates<vec<T, size_of<typename traits::point>>>(
        [&](int i) { return coordinate(traits::position(m, v), i) - ball.centre[i]; });
    ball.radius = maximum(ball.radius, length(from_centre));
  }
  return ball;
}

IRG_RENAMED(size, extent)
IRG_RENAMED(enclosing_box, bounding_box)
IRG_RENAMED(sphere_around, bounding_sphere_of)

}  // namespace IRG_ABI
}  // namespace irg
