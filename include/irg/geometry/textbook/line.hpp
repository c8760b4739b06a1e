// SPDX-License-Identifier: MIT
// A line by its quotients as printed. line_through (geometry/line.hpp) is the one to use.
#pragma once

#include <optional>

#include <irg/geometry/line.hpp>

namespace irg::textbook::inline IRG_ABI {

/// The line by the quotients as printed, (y - y1)/(y2 - y1) = (x - x1)/(x2 - x1).
/// gives   nothing for equal points and for lines along an axis, whose quotients do not exist. The side of positive
///         values is the left one only where x or y falls from p to q, not both or neither
/// exact   each operation rounded once
/// source  Mihajlovic 2016, formula 2.6 as printed
template <Point P>
  requires(size_of<P> == 2 && Real<scalar_of<P>>)
[[nodiscard]] constexpr std::optional<line<scalar_of<P>>> line_through(const P& p, const P& q) noexcept {
  using T = scalar_of<P>;
  const T width = coordinate(q, 0) - coordinate(p, 0), height = coordinate(q, 1) - coordinate(p, 1);
  if (width == T(0) || height == T(0)) return std::nullopt;
  return line<T>{T(-1) / width, T(1) / height, coordinate(p, 0) / width - coordinate(p, 1) / height};
}

}  // namespace irg::textbook::inline IRG_ABI
