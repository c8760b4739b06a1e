// SPDX-License-Identifier: MIT
// colour: pixel types and their layouts, mixing, sRGB.
#pragma once

#include <irg/colour/pixel.hpp>
#include <irg/colour/encode_pixel.hpp>
#include <irg/colour/pixel_layout.hpp>
#include <irg/colour/convert_pixel.hpp>
#include <irg/colour/mix.hpp>
#include <irg/colour/palette.hpp>
#include <irg/colour/over.hpp>
#include <irg/colour/srgb.hpp>
#include <irg/colour/srgb_lanes.hpp>
