// SPDX-License-Identifier: MIT
// Where a piece of a triangle lies in it.
#pragma once

#include <irg/core/config.hpp>

namespace irg {

/// The weights of the second and third vertex of a source triangle; the first has the rest of 1.
struct source_weights {
  float second = 0, third = 0;
  bool operator==(const source_weights&) const = default;
};

/// Where the corners of a piece lie in its source triangle.
struct piece_weights {
  source_weights corner[3] = {{0, 0}, {1, 0}, {0, 1}};
  bool operator==(const piece_weights&) const = default;
};

}  // namespace irg
