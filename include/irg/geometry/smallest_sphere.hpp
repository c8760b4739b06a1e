// SPDX-License-Identifier: MIT
// The smallest circle or sphere around points: which points it rests on is decided exactly.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include <irg/core/conversion.hpp>
#include <irg/core/ring.hpp>
#include <irg/geometry/detail/smallest_sphere_steps.hpp>
#include <irg/geometry/sphere.hpp>
#include <irg/math/vec.hpp>

namespace irg::inline IRG_ABI {

/// The smallest circle or sphere around the points of a range or ring.
/// gives   nothing for no points, and when a coordinate is NaN or infinite; radius 0 when all points are equal
/// exact   the points it rests on; centre and radius as sphere_through's, so that points may stand out by that much
/// cost    some ten passes over the points as a rule, also where all lie on one sphere up to rounding; nothing
///         allocates
/// source  Welzl 1991, for the few points that matter; these are found by taking in the farthest point each time, after
///         Gaertner 1999
template <PolygonRing R>
  requires(Point<ring_point<R>> && Floating<ring_scalar<R>> &&
           (size_of<ring_point<R>> == 2 || size_of<ring_point<R>> == 3))
[[nodiscard]] constexpr std::optional<bounding_sphere<ring_scalar<R>, size_of<ring_point<R>>>> smallest_sphere(
    const R& points) noexcept {
  using P = assignable<ring_point<R>>;
  if (ring_size(points) == 0) return std::nullopt;
  for (std::size_t i = 0; i < ring_size(points); ++i)
    for (int k = 0; k < size_of<P>; ++k)
      if (!detail::is_finite(coordinate(ring_vertex(points, i), k))) return std::nullopt;
  detail::smallest_ball<P> ball(as_assignable(ring_vertex(points, 0)));
  for (;;) {  // the ball grows each time, and there are only so many
    const auto rounded = ball.rounded();
    const auto close = ball.close();
    std::size_t farthest = ring_size(points);
    double most = 0;
    for (std::size_t i = 0; i < ring_size(points); ++i) {
      const P p = as_assignable(ring_vertex(points, i));
      detail::guessed_side guess = detail::guess_side(rounded, p);
      if (guess.side == 0)
        if (const auto closer = detail::close_side(close, p); closer.side != 0) guess = closer;
      if (guess.side < 0 || (farthest < ring_size(points) && !(most < guess.excess))) continue;
      if (guess.side == 0 && !ball.is_outside(p)) continue;
      farthest = i, most = guess.excess;
    }
    if (farthest == ring_size(points)) return rounded;
    ball.grow(as_assignable(ring_vertex(points, farthest)));
  }
}

}  // namespace irg::inline IRG_ABI
