// SPDX-License-Identifier: MIT
// Cyrus and Beck's line clipping against a convex polygon, or a convex solid given by its planes: of the boundaries
// that the line crosses inwards the last one counts, of those that it crosses outwards the first.
#pragma once

#include <optional>
#include <span>

#include <irg/geometry/vocabulary.hpp>
#include <irg/geometry/detail/half_space.hpp>

namespace irg {

namespace detail::inline IRG_ABI {

// The segment's part inside of n half-spaces: boundary(i) is the i-th.
template <class T, int D, Point P, class Boundary>
constexpr std::optional<clipped_line<P>> clip_by_half_spaces(const P& a, const P& b, std::size_t n,
                                                             const Boundary& boundary) noexcept {
  std::optional<half_space<T, D>> entry, exit;
  for (std::size_t i = 0; i < n; ++i) {
    const half_space<T, D> h = boundary(i);
    const int from = half_space_side(h, a), to = half_space_side(h, b);
    if (from < 0 && to < 0) return std::nullopt;
    if (from < 0 && (!entry || compare_half_space_crossings(a, b, *entry, h, 1) < 0)) entry = h;
    if (to < 0 && (!exit || compare_half_space_crossings(a, b, h, *exit, 1) < 0)) exit = h;
  }
  if (entry && exit && compare_half_space_crossings(a, b, *entry, *exit, -1) > 0) return std::nullopt;
  const auto first = entry ? meet_half_space(a, b, *entry) : half_space_meeting<T, P>{a, T(0)};
  const auto second = exit ? meet_half_space(a, b, *exit) : half_space_meeting<T, P>{b, T(1)};
  return clipped_line<P>{first.at, second.at, first.t, second.t < first.t ? first.t : second.t};
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The part of the segment from a to b that lies in a convex polygon, which includes its boundary.
/// needs   a convex polygon, of either orientation; collinear and repeated vertices are allowed
/// gives   nothing when no point is visible, when a coordinate is NaN or infinite, and when the polygon has no area; a
///         segment that touches the polygon in one point gives this point twice
/// exact   the decision, for all finite floats and doubles; which boundaries are crossed; coordinates and parameters of
///         cut ends within 0.501 ulp, between those of a and b, the same for the segment from b to a. On a slanted
///         boundary no double may lie on the line, so that clipping again may move an end by an ulp
/// cost    two orientation tests per edge, 0.1 us per boundary that is crossed. Where the polygon is a window,
///         clip_line_liang_barsky gives the same in a fraction of the time
/// source  Cyrus and Beck 1978
template <Point P, PlaneRing R>
  requires(size_of<P> == 2 && Real<scalar_of<P>> && std::same_as<ring_scalar<R>, scalar_of<P>>)
[[nodiscard]] constexpr std::optional<clipped_line<P>> clip_line_cyrus_beck(const P& a, const P& b,
                                                                            const R& polygon) noexcept {
  if (!is_finite(a, b)) return std::nullopt;
  for (std::size_t i = 0; i < ring_size(polygon); ++i)
    if (!is_finite(ring_vertex(polygon, i))) return std::nullopt;
  const int turn = detail::turn_of_convex(polygon);
  if (turn == 0) return std::nullopt;
  return detail::clip_by_half_spaces<scalar_of<P>, 2>(
      a, b, ring_size(polygon), [&](std::size_t i) { return detail::half_space_at(polygon, i, turn); });
}

/// The part of the segment from a to b that lies on or above all planes: a convex solid's, when they look inwards.
/// gives   nothing when no point is visible and when a coordinate or coefficient is NaN or infinite; the whole segment
///         when there are no planes
/// exact   as for a polygon, for the planes as their coefficients say
/// cost    two exact signs per plane, 0.2 us per plane that is crossed
/// source  Cyrus and Beck 1978
template <Point P>
  requires(size_of<P> == 3 && Real<scalar_of<P>>)
[[nodiscard]] constexpr std::optional<clipped_line<P>> clip_line_cyrus_beck(
    const P& a, const P& b, std::span<const plane<scalar_of<P>>> planes) noexcept {
  if (!is_finite(a, b)) return std::nullopt;
  using T = scalar_of<P>;
  for (const plane<T>& p : planes)
    if (!is_finite(p)) return std::nullopt;
  return detail::clip_by_half_spaces<T, 3>(a, b, planes.size(), [&](std::size_t i) {
    return detail::half_space<T, 3>{{planes[i].a, planes[i].b, planes[i].c, planes[i].d}};
  });
}

IRG_REFUSES_VECTORS(clip_line_cyrus_beck);

}  // namespace IRG_ABI
}  // namespace irg
