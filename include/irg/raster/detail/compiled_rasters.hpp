// SPDX-License-Identifier: MIT
// What irg::compiled draws into and fills: views of pixels of four 8-bit channels, rings whose vertices stand side by
// side. Programs without it do without these: what is drawn, and the sink, are part of their innermost loops.
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

// Whether irg::compiled draws.
inline constexpr bool draws_in_library = !IRG_BODIES;

template <class P>
concept CompiledPixel = std::same_as<P, rgba8> || std::same_as<P, bgra8>;

template <class R>
concept CompiledRaster = EvenRowRaster<R> && CompiledPixel<pixel_of<R>>;

template <class V>
concept CompiledVertex =
    std::same_as<V, subpixel> || std::same_as<V, point<float, 2>> || std::same_as<V, point<double, 2>>;

template <class R>
concept CompiledRing =
    PolygonRing<R> && CompiledVertex<ring_point<R>> && std::convertible_to<const R&, std::span<const ring_point<R>>>;

}  // namespace irg::detail
