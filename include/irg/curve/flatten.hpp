// SPDX-License-Identifier: MIT
// Bezier curves as polylines with a guaranteed chord error: pieces as long as the bound of each allows, one after the
// other. The bound of a piece comes from the second differences of its control points across the chord, which is the
// more nearly the error itself the shorter the piece.
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>

#include <irg/curve/bezier.hpp>
#include <irg/math/length.hpp>

namespace irg {

/// What flatten did: how many chords, and whether each was found within the tolerance.
struct flattening {
  std::size_t pieces = 0;
  bool within_tolerance = true;
  bool operator==(const flattening&) const = default;
};

namespace detail::inline IRG_ABI {

/// A bound of how far the curve of these control points is from its chord: degree (degree - 1) / 8 times the largest
/// second difference; of these only what is across the chord, where no control point lies beyond the chord's ends.
template <CurvePoint P>
constexpr scalar_of<P> chord_error_bound(std::span<const P> c) noexcept {
  using T = scalar_of<P>;
  using V = typename curve_sample<P>::vector;
  const std::size_t n = c.size() - 1;
  const V chord = scaled_difference(c[0], c[n], 1);
  const V along = normalized(chord);
  bool is_beside = true;
  for (const P& p : c) {
    const T from_begin = dot(scaled_difference(c[0], p, 1), along), to_end = dot(scaled_difference(p, c[n], 1), along);
    is_beside = is_beside && from_begin >= T(0) && to_end >= T(0);
  }
  T largest = 0;
  for (std::size_t k = 1; k < n; ++k) {
    V second = generate_coordinates<V>([&](int i) {
      return (coordinate(c[k + 1], i) - coordinate(c[k], i)) - (coordinate(c[k], i) - coordinate(c[k - 1], i));
    });
    const T ahead = is_beside ? dot(second, along) : T(0);
    second =
        generate_coordinates<V>([&](int i) { return coordinate(second, i) - product(ahead, coordinate(along, i)); });
    const T size = length(second);
    if (!(size <= largest) && largest == largest) largest = size;  // NaN stays
  }
  return product(largest, static_cast<T>(static_cast<int>(n * (n - 1)))) / T(8);
}

// How many rows of as many points as the curve has flatten works in.
inline constexpr std::size_t flatten_rows = 3;

/// The bound for the stretch of the curve from first to last of 2^16.
template <ControlPoints R>
constexpr scalar_of<control_point<R>> stretch_error_bound(const R& points, int first, int last,
                                                          std::span<control_point<R>> scratch) noexcept {
  using P = control_point<R>;
  const std::size_t count = ring_traits<R>::size(points);
  const auto left = scratch.first(count), right = scratch.subspan(count, count);
  bezier_split(points, curve_fraction<scalar_of<P>>(last, 65536), left, right);
  const auto rest = scratch.subspan(2 * count, count);
  bezier_split(left, curve_fraction<scalar_of<P>>(first, last), right, rest);
  return chord_error_bound(std::span<const P>(rest));
}

// Cuts 0 ... end into stretches as long as is_within(from, to) allows, but for a share of 1 / parts of them, and hands
// their ends to sink(to, whether within); a stretch of 1 is taken as it is.
template <class IsWithin, class Sink>
constexpr void each_longest_stretch(int end, int parts, const IsWithin& is_within, Sink&& sink) {
  int stride = end;
  for (int at = 0; at < end;) {
    int good = at, bad = minimum(at + stride, end);  // from the last stretch's length up, then halving
    while (good < end && is_within(at, bad)) {
      good = bad;
      bad = minimum(at + 2 * (bad - at), end);
    }
    while (good < end && bad - good > 1 + (good - at) / parts) {
      const int middle = good + (bad - good) / 2;
      (is_within(at, middle) ? good : bad) = middle;
    }
    const bool within = good > at;
    if (!within) ++good;
    stride = good - at;
    at = good;
    sink(at, within);
  }
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// Hands the points of a polyline near the Bezier curve to sink(point), the curve's first and last point included.
/// needs   one or more control points; scratch three times as long, its contents are lost
/// gives   how many chords there are, and whether each is within the tolerance; no chord is shorter than 2^-16 of the
///         parameter, so that tolerance 0 ends, too. A single control point is handed over alone
/// exact   no point of the curve is farther from the polyline than the tolerance and the rounding of bezier_point; the
///         points are bezier_point's at k / 2^16
/// cost    for each chord some 5 to 20 pairs of bezier_split
/// source  irg's own: the bound of linear interpolation across each chord
template <ControlPoints R, class Sink>
  requires CartesianPoint<control_point<R>> && Floating<scalar_of<control_point<R>>>
constexpr flattening flatten(const R& points, std::type_identity_t<scalar_of<control_point<R>>> tolerance,
                             std::span<control_point<R>> scratch, Sink&& sink) {
  using T = scalar_of<control_point<R>>;
  constexpr int end = 65536;
  const std::size_t count = ring_traits<R>::size(points);
  IRG_EXPECTS(count > 0 && scratch.size() >= detail::flatten_rows * count);
  flattening done;
  sink(ring_traits<R>::vertex(points, 0));
  if (count < 2) return done;
  detail::each_longest_stretch(
      end, end, [&](int from, int to) { return detail::stretch_error_bound(points, from, to, scratch) <= tolerance; },
      [&](int at, bool within) {
        ++done.pieces;
        done.within_tolerance = done.within_tolerance && within;
        sink(bezier_point(points, curve_fraction<T>(at, end), scratch));
      });
  return done;
}

/// The same, computed in a workspace; allocates where that has too little memory.
template <ControlPoints R, class Sink, WorkspaceFor<R> W = workspace_for<R>>
  requires CartesianPoint<control_point<R>> && Floating<scalar_of<control_point<R>>>
constexpr flattening flatten(const R& points, scalar_of<control_point<R>> tolerance, Sink&& sink, W&& memory = W{}) {
  return flatten(points, tolerance, detail::room_for(memory.points, points, detail::flatten_rows), sink);
}

}  // namespace IRG_ABI
}  // namespace irg
