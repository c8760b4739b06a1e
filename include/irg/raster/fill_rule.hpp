// SPDX-License-Identifier: MIT
// What can be filled. Which side is inside is said by fill_rule, of core/ring.hpp.
#pragma once

#include <irg/core/ring.hpp>
#include <irg/raster/subpixel.hpp>

namespace irg {

/// A ring that can be filled: of snapped positions, or of points of two float or double coordinates, in pixels.
template <class R>
concept FillableRing =
    PolygonRing<R> && (std::same_as<ring_point<R>, subpixel> ||
                       (Point<ring_point<R>> && size_of<ring_point<R>> == 2 && Floating<scalar_of<ring_point<R>>>));

/// Any number of rings that can be filled, in a container with size() and [] or a plain array.
template <class R>
concept FillableRings = requires(const R& rings, std::size_t i) {
  requires FillableRing<std::remove_cvref_t<decltype(rings[i])>>;
  requires std::is_array_v<R> || requires {
    { rings.size() } -> std::convertible_to<std::size_t>;
  };
};

/// One ring, or any number of them.
template <class P>
concept FillablePolygon = FillableRing<P> || FillableRings<P>;

}  // namespace irg
