// SPDX-License-Identifier: MIT
// What a line's user may choose: which of its ends are drawn, and which way exact ties go.
#pragma once

#include <irg/core/config.hpp>

namespace irg {

/// Which end cells of a line from a to b are drawn.
enum class line_ends {
  closed,     // both
  half_open,  // a but not b: the segments of a polyline draw each shared vertex once; a line from a to a draws nothing
};

/// Where a line goes that passes exactly half-way between two cells.
enum class line_ties {
  start_side,  // to the cell on the side of a; the line from b to a may have other cells
  symmetric,  // as if drawn in the canonical direction (x rising, y rising for steep lines): the same cells both ways
};

/// The choices together.
struct line_options {
  line_ends ends = line_ends::closed;
  line_ties ties = line_ties::start_side;
  constexpr bool operator==(const line_options&) const = default;
};

}  // namespace irg
