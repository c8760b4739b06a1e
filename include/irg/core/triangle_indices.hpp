// SPDX-License-Identifier: MIT
// A triangle as three indices of vertices.
#pragma once

#include <cstdint>

namespace irg {

/// Three indices of vertices, counter-clockwise seen from outside.
struct triangle_indices {
  std::uint32_t v[3];
  constexpr bool operator==(const triangle_indices&) const = default;
};

}  // namespace irg
