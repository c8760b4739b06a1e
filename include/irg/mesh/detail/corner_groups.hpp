// SPDX-License-Identifier: MIT
// Corners of a mesh in groups.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include <irg/core/config.hpp>

namespace irg::detail {

/// Corners of a mesh in groups, each known by its lowest corner.
class IRG_APART corner_groups {
public:
  constexpr explicit corner_groups(std::size_t count) : above_(count, 0) {
    std::iota(above_.begin(), above_.end(), std::uint32_t{0});
  }
  constexpr std::uint32_t of(std::uint32_t corner) noexcept {
    while (above_[corner] != corner) corner = above_[corner] = above_[above_[corner]];
    return corner;
  }
  constexpr void join(std::uint32_t a, std::uint32_t b) noexcept {
    a = of(a);
    b = of(b);
    above_[a < b ? b : a] = a < b ? a : b;
  }

private:
  std::vector<std::uint32_t> above_;
};

}  // namespace irg::detail
