// SPDX-License-Identifier: MIT
// solid: point in solid, winding number, booleans (CSG).
#pragma once

#include <irg/solid/point_in_solid.hpp>
#include <irg/solid/solid_locator.hpp>
#include <irg/solid/winding_number_rounded.hpp>
#include <irg/solid/boolean.hpp>
#include <irg/solid/csg_tree.hpp>
#include <irg/solid/csg_spans.hpp>
#include <irg/solid/self_intersections.hpp>
#include <irg/solid/orient_outward.hpp>
#include <irg/solid/measures.hpp>
