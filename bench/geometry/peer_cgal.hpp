// SPDX-License-Identifier: MIT
// CGAL's predicates: EPICK (static filters, intervals, exact numbers last) and the exact numbers alone.
#pragma once

#ifdef IRG_HAVE_CGAL
#define CGAL_USE_GMP 1
#define CGAL_USE_MPFR 1
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mpzf.h>
#include <CGAL/Simple_cartesian.h>

#include "geometry/predicate_sets.hpp"

namespace bench::cgal {

using epick = CGAL::Exact_predicates_inexact_constructions_kernel;

template <int D>
using point_of = std::conditional_t<D == 2, epick::Point_2, epick::Point_3>;

template <int N, int D>
std::vector<std::array<point_of<D>, static_cast<std::size_t>(N)>> points_of(const point_set<double, N, D>& s) {
  std::vector<std::array<point_of<D>, static_cast<std::size_t>(N)>> all(s.calls.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = 0; k < all[i].size(); ++k) {
      const auto& p = s.calls[i][k];
      if constexpr (D == 2)
        all[i][k] = point_of<D>(p[0], p[1]);
      else
        all[i][k] = point_of<D>(p[0], p[1], p[2]);
    }
  return all;
}

/// The predicate that N points of D coordinates have.
template <int N, int D, class P>
int sign(const std::array<P, static_cast<std::size_t>(N)>& p) {
  if constexpr (N == 3)
    return static_cast<int>(epick().orientation_2_object()(p[0], p[1], p[2]));
  else if constexpr (N == 4 && D == 3)
    return static_cast<int>(epick().orientation_3_object()(p[0], p[1], p[2], p[3]));
  else if constexpr (N == 4)
    return static_cast<int>(epick().side_of_oriented_circle_2_object()(p[0], p[1], p[2], p[3]));
  else
    return static_cast<int>(epick().side_of_oriented_sphere_3_object()(p[0], p[1], p[2], p[3], p[4]));
}

}  // namespace bench::cgal
#endif
