// SPDX-License-Identifier: MIT
// Which way round points run.
#pragma once

namespace irg {

/// Which way round a polygon or a triangle runs, as the sign of its area says: `degenerate` when that is zero.
enum class orientation { clockwise = -1, degenerate = 0, counter_clockwise = 1 };

}  // namespace irg
