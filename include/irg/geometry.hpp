// SPDX-License-Identifier: MIT
// geometry: exact predicates, lines, planes, triangles, polygons, bounds, intersection, distance, clipping.
#pragma once

#include <irg/geometry/box.hpp>
#include <irg/geometry/clip_homogeneous.hpp>
#include <irg/geometry/plane.hpp>
