// SPDX-License-Identifier: MIT
// fractal: escape time, Mandelbrot, Julia, deep zooms.
#pragma once

#include <irg/fractal/escape_picture.hpp>
#include <irg/fractal/deep_mandelbrot.hpp>
#include <irg/fractal/precise_mandelbrot.hpp>
#include <irg/fractal/distance_estimate.hpp>
#include <irg/fractal/settle_time.hpp>
#include <irg/fractal/escape_time.hpp>
#include <irg/fractal/mandelbrot.hpp>
#include <irg/fractal/julia.hpp>
#include <irg/fractal/escape_colour.hpp>
#include <irg/fractal/complex_plane.hpp>
