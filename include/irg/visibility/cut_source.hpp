// SPDX-License-Identifier: MIT
// A source and obstacles that cross its edges, cut where they do, so that weak_visibility answers.
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <irg/geometry/crossing_point.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/segment.hpp>
#include <irg/math/vec.hpp>

namespace irg {

/// The ring of a source and obstacles, none of which cross its edges.
template <Floating T>
struct cut_source {
  std::vector<point<T, 2>> ring;
  std::vector<segment<T, 2>> obstacles;
};

inline namespace IRG_ABI {

/// Cuts the edges of a ring and the obstacles that cross them, in the points nearest to where they do: a light that
/// walls cut, for weak_visibility.
/// needs   finite coordinates
/// gives   edges and obstacles bent by as much as these points are rounded; an obstacle along an edge that another one
///         cuts may come to lie beside it. In plans so fine that bent ones cross again
///         and again, some may be left that cross; weak_visibility says so
/// exact   which ones cross; where is correctly rounded
/// cost    the edges times the obstacles, a few times over; allocates
template <Floating T>
[[nodiscard]] constexpr cut_source<T> cut_source_rounded(
    std::span<const point<T, 2>> ring, std::span<const std::type_identity_t<segment<T, 2>>> obstacles) {
  cut_source<T> out;
  out.ring.assign(ring.begin(), ring.end());
  std::vector<segment<T, 2>> open(obstacles.begin(), obstacles.end());
  const auto crosses = [](const segment<T, 2>& e, const segment<T, 2>& o) {
    return orient2d(e.a, e.b, o.a) * orient2d(e.a, e.b, o.b) < 0 &&
           orient2d(o.a, o.b, e.a) * orient2d(o.a, o.b, e.b) < 0;
  };
  // Whether the obstacle crossed an edge, and both are cut. Of the two, one at least gets a new corner.
  const auto cut = [&](const segment<T, 2>& o) {
    for (std::size_t i = 0; i < out.ring.size(); ++i) {
      const segment<T, 2> e{out.ring[i], out.ring[i + 1 < out.ring.size() ? i + 1 : 0]};
      if (!crosses(e, o)) continue;
      const point<T, 2> at = *crossing_point(e, o);
      if (!(at == e.a) && !(at == e.b)) out.ring.insert(out.ring.begin() + static_cast<std::ptrdiff_t>(i) + 1, at);
      if (at == o.a || at == o.b) {
        open.push_back(o);
      } else {
        open.push_back({o.a, at});
        open.push_back({at, o.b});
      }
      return true;
    }
    return false;
  };
  std::size_t cuts_left = 4 * ring.size() * obstacles.size();
  for (bool bent = true; bent;) {
    bent = false;
    while (!open.empty()) {
      const segment<T, 2> o = open.back();
      open.pop_back();
      if (cuts_left > 0 && cut(o))
        bent = true, --cuts_left;
      else
        out.obstacles.push_back(o);
    }
    if (bent) open.swap(out.obstacles);  // edges that were bent since may be crossed now
  }
  return out;
}

}  // namespace IRG_ABI
}  // namespace irg
