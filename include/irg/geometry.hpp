// SPDX-License-Identifier: MIT
// geometry: planes, boxes, convexity of polygons, homogeneous clipping.
#pragma once

#include <irg/geometry/box.hpp>
#include <irg/geometry/clip_homogeneous.hpp>
#include <irg/geometry/depth_sign.hpp>
#include <irg/geometry/plane.hpp>
#include <irg/geometry/polygon_convexity.hpp>
