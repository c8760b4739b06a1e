// SPDX-License-Identifier: MIT
// The directions that row_sweep.hpp has not found blocked yet.
#pragma once

#include <cstdint>

namespace irg::detail {

// A direction, x over y; closed when the direction itself belongs to the sector that it ends.
struct sweep_slope {
  std::int64_t num = 0, den = 1;
  bool closed = true;
};

// The end of a sector, and the column floor(y num / den) = x that it has reached in the row y, with the rest.
struct sweep_end {
  sweep_slope slope;
  std::int64_t x = 0, rest = 0, dx = 0, drest = 0;
};
struct open_sector {
  sweep_end low, high;
};

}  // namespace irg::detail
