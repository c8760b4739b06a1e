// SPDX-License-Identifier: MIT
// On which side of a line or a plane something lies.
#pragma once

namespace irg {

/// On which side of a plane or a line a point lies: where the normal points to (above), on it, or on the other side.
/// The values are the signs of the equation there.
enum class side { below = -1, on = 0, above = 1 };

}  // namespace irg
