// SPDX-License-Identifier: MIT
// How two flats lie: two lines, two planes, or a line and a plane.
#pragma once

namespace irg {

/// How two lines, two planes, or a line and a plane lie: `none` when one of them is none (equal points, a zero normal)
/// or a number is NaN or infinite; `coincident` when they are the same or one contains the other; `skew` for lines of
/// space without a common plane.
enum class flat_relation { none, crossing, parallel, coincident, skew };

}  // namespace irg
