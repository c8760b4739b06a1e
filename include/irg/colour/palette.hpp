// SPDX-License-Identifier: MIT
// Palettes: colours for integers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <irg/colour/mix.hpp>

namespace irg {

/// A palette that goes round: from each colour to the next, and from the last to the first, in even steps.
/// needs   N and steps at least 1
template <Mixable P, std::size_t N>
struct cyclic_palette {
  std::array<P, N> stops{};
  int steps = 1;  // from one stop to the next

  /// The colour of any integer: stops[k] for k * steps, mixed in between.
  /// gives   the same for i and i + N * steps
  /// exact   mix with the coverage 256 r / steps, rounded down, at r steps from a stop
  IRG_APART constexpr P operator()(int i) const noexcept {
    const std::int64_t period = static_cast<std::int64_t>(N) * steps;
    const std::int64_t place = (i % period + period) % period, step = place % steps;
    const auto stop = static_cast<std::size_t>(place / steps);
    return mix(stops[stop], stops[(stop + 1) % N], static_cast<std::uint8_t>(step * 256 / steps));
  }
  bool operator==(const cyclic_palette&) const = default;
};

}  // namespace irg
