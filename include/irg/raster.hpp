// SPDX-License-Identifier: MIT
// raster: images and views, spans, lines, triangles, depth.
#pragma once

#include <irg/raster/depth.hpp>
#include <irg/raster/draw_line.hpp>
#include <irg/raster/draw_triangle.hpp>
#include <irg/raster/fill_rule.hpp>
#include <irg/raster/fill_span.hpp>
#include <irg/raster/foreign_view.hpp>
#include <irg/raster/fragment.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/line_bresenham.hpp>
#include <irg/raster/line_options.hpp>
#include <irg/raster/paint.hpp>
#include <irg/raster/subpixel.hpp>
#include <irg/raster/triangle_coverage.hpp>
#include <irg/raster/view_opencv.hpp>
#include <irg/raster/view_sdl.hpp>
#include <irg/raster/window.hpp>
