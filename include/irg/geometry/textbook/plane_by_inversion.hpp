// SPDX-License-Identifier: MIT
// The plane by inversion of a matrix as printed. plane_by_inversion (geometry/plane_by_inversion.hpp) has the
// consistent form.
#pragma once

#include <irg/geometry/plane_by_inversion.hpp>

namespace irg::textbook {
inline namespace IRG_ABI {

/// The formula as printed, D in the matrix and 1 on the right side: its solution ends in 1/D, not in D.
/// needs   a d that is not zero
/// source  Mihajlovic 2016, formula 4.3
template <HomogeneousPoint P>
  requires(size_of<P> == 4 && Real<scalar_of<P>>)
[[nodiscard]] constexpr checked<plane<scalar_of<P>>, inversion_outcome> plane_by_inversion(const P& p1, const P& p2,
                                                                                           const P& p3,
                                                                                           scalar_of<P> d) noexcept {
  return irg::plane_by_inversion(p1, p2, p3, scalar_of<P>(1) / d);
}

}  // namespace IRG_ABI
}  // namespace irg::textbook
