// SPDX-License-Identifier: MIT
// What can be filled. Which side is inside is said by fill_rule, of core/ring.hpp.
#pragma once

#include <irg/core/ring.hpp>
#include <irg/raster/subpixel.hpp>

namespace irg {

/// A ring that can be filled: of snapped positions, or of points of two float or double coordinates, in pixels.
template <class R>
concept FillableRing =
    PolygonRing<R> && (std::same_as<ring_point<R>, subpixel> || (PlaneRing<R> && Floating<ring_scalar<R>>));

/// One ring that can be filled, or any number of them.
template <class P>
concept FillablePolygon = FillableRing<P> || (RingSequence<P> && FillableRing<ring_in<P>>);

}  // namespace irg
