// SPDX-License-Identifier: MIT
// A parametric plane whose origin is the middle one of three points. parametric_plane_through
// (geometry/parametric_plane.hpp) begins with the first.
#pragma once

#include <optional>

#include <irg/geometry/parametric_plane.hpp>

namespace irg::textbook {
inline namespace IRG_ABI {

/// The plane whose origin is the middle point: directions a - b and c - b, origin b.
/// gives   nothing when the points lie exactly on a line, or a coordinate is NaN or infinite
/// exact   as parametric_plane_through
/// source  Hank n.d., 1.3.2, which refuses coincident points only
template <Point P>
  requires(size_of<P> == 3)
[[nodiscard]] constexpr std::optional<parametric_plane<scalar_of<P>>> parametric_plane_at_middle(const P& a, const P& b,
                                                                                                 const P& c) noexcept {
  return parametric_plane_through(b, a, c);
}

/// The same with Hank's check: points must differ from each other, nothing more. (0,0,0), (1,1,1), (2,2,2) pass
/// and give two dependent directions.
/// source  Hank n.d., 1.3.2 as printed
template <Point P>
  requires(size_of<P> == 3)
[[nodiscard]] constexpr std::optional<parametric_plane<scalar_of<P>>> parametric_plane_as_printed(const P& a,
                                                                                                  const P& b,
                                                                                                  const P& c) noexcept {
  using T = scalar_of<P>;
  if (same_place(a, b) || same_place(b, c) || same_place(a, c)) return std::nullopt;
  return parametric_plane<T>{detail::displacement<T>(b, a), detail::displacement<T>(b, c), detail::as_point<T>(b)};
}

}  // namespace IRG_ABI
}  // namespace irg::textbook
