// SPDX-License-Identifier: MIT
// fill_rule: what counts as the inside of rings that cross themselves or each other.
#pragma once

namespace irg {

/// The inside of a set of rings, told by the winding number of a point: how often the rings run round it.
enum class fill_rule {
  even_odd,  // the winding number is odd; a ring inside another is a hole whichever way it runs
  non_zero,  // the winding number is not 0; a hole must run the other way than the ring around it
};

}  // namespace irg
