// SPDX-License-Identifier: MIT
// curve: Bezier (both forms), B-spline, NURBS, surfaces, tessellation, paths.
#pragma once

#include <irg/curve/bezier.hpp>
#include <irg/curve/bezier_surface.hpp>
