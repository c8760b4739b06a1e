// SPDX-License-Identifier: MIT
// What raster's doors take: views of pixels of four 8-bit channels, and rings whose vertices stand side by side.
// Programs without the library go by no door here: what is drawn, and the sink, are part of their innermost loops.
#pragma once

#include <concepts>
#include <span>

#include <irg/colour/pixel.hpp>
#include <irg/core/ring.hpp>
#include <irg/math/vec.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/paint.hpp>
#include <irg/raster/subpixel.hpp>

namespace irg::detail {

// Whether what is drawn goes by doors.
inline constexpr bool draws_by_doors = !IRG_BODIES;

template <class P>
concept DoorPixel = std::same_as<P, rgba8> || std::same_as<P, bgra8>;

template <class R>
concept DoorRaster = EvenRowRaster<R> && DoorPixel<pixel_of<R>>;

template <class V>
concept DoorVertex = std::same_as<V, subpixel> || std::same_as<V, point<float, 2>> || std::same_as<V, point<double, 2>>;

template <class R>
concept DoorRing =
    PolygonRing<R> && DoorVertex<ring_point<R>> && std::convertible_to<const R&, std::span<const ring_point<R>>>;

}  // namespace irg::detail
