// SPDX-License-Identifier: MIT
// What can be made of two sets of points, polygons of the plane or bodies of space.
#pragma once

namespace irg {

/// What to make of a and b.
enum class boolean_operation { intersection, unite, difference, symmetric_difference };

}  // namespace irg
