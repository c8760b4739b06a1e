// SPDX-License-Identifier: MIT
// Where a point lies with regard to a region.
#pragma once

namespace irg {

/// Where a point lies with regard to a polygon, a body or another region that has a boundary.
enum class location { outside = -1, boundary = 0, inside = 1 };

}  // namespace irg
