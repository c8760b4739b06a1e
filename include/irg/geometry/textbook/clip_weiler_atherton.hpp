// SPDX-License-Identifier: MIT
// Weiler and Atherton's clipping, as they tell it: both polygons are lists of vertices, into which the points are put
// where the boundaries cross. From a point where the subject enters the clip polygon the walk follows the subject, from
// one where it leaves, the clip polygon, until it is back at its start. polygon_boolean takes all polygons.
#pragma once

#include <irg/geometry/point_in_polygon.hpp>
#include <irg/geometry/textbook/weiler_atherton_lists.hpp>

namespace irg::textbook {

/// The common part of two polygons, and the two lists of the method.
/// shape   rings directed as the polygons'; entering and leaving have a meaning where the status is `ok`
template <Floating T>
struct weiler_atherton_clip {
  weiler_atherton_status status = weiler_atherton_status::ok;
  std::vector<std::vector<point<T, 2>>> rings{};
  std::vector<point<T, 2>> entering{}, leaving{};
  bool operator==(const weiler_atherton_clip&) const = default;
};

}  // namespace irg::textbook

namespace irg::detail::inline IRG_ABI {

template <Floating T, PlanePolygon Polygon>
constexpr std::vector<std::vector<point<T, 2>>> plain_rings(const Polygon& polygon) {
  std::vector<std::vector<point<T, 2>>> rings;
  each_ring(polygon, [&](const auto& ring) {
    rings.emplace_back();
    for (std::size_t i = 0; i < ring_size(ring); ++i) {
      const auto v = ring_vertex(ring, i);
      rings.back().push_back({static_cast<T>(coordinate(v, 0)), static_cast<T>(coordinate(v, 1))});
    }
    return true;
  });
  return rings;
}

// From an entering point along the subject, from a leaving one along the clip polygon, back to the start.
template <Floating T>
constexpr std::vector<point<T, 2>> walk_crossings(const textbook::weiler_atherton_lists<T>& l, std::size_t start,
                                                  std::vector<char>& walked) {
  std::vector<point<T, 2>> ring;
  std::size_t at = start;
  do {
    walked[at] = 1;
    const int which = l.crossings[at].enters ? 0 : 1;
    const std::vector<textbook::listed_vertex<T>>& list =
        (which == 0 ? l.subject : l.clip)[l.crossings[at].ring[which]];
    std::size_t i = l.crossings[at].place[which];
    do {
      ring.push_back(list[i].at);
      i = i + 1 < list.size() ? i + 1 : 0;
    } while (!list[i].crossing);
    at = *list[i].crossing;
  } while (at != start);
  return ring;
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::textbook::inline IRG_ABI {

/// The part of the subject within the clip polygon, by Weiler and Atherton's walk along entering and leaving points.
/// shape   rings or lists of rings: outer ones counter-clockwise, holes clockwise (y up), of floats, doubles or
///         integers of up to 32 bits; floats come out of floats, else doubles
/// needs   rings that neither cross themselves nor another ring of the same polygon
/// gives   a ring per part; status `touching`, and no rings, outside of general position
/// exact   which edges cross, and what enters, is decided exactly; crossings within 0.501 ulp
/// cost    each edge against each edge of the other polygon; allocates
/// source  Weiler and Atherton 1977
template <PlanePolygon A, PlanePolygon B>
  requires OverlayScalar<scalar_of<polygon_point<A>>> && OverlayScalar<scalar_of<polygon_point<B>>>
[[nodiscard]] constexpr auto clip_weiler_atherton(const A& subject, const B& clip) {
  using T = std::conditional_t<std::same_as<scalar_of<polygon_point<A>>, float> &&
                                   std::same_as<scalar_of<polygon_point<B>>, float>,
                               float, double>;
  if (!irg::is_finite(subject) || !irg::is_finite(clip))
    return weiler_atherton_clip<T>{weiler_atherton_status::not_finite};
  const std::vector<std::vector<point<T, 2>>> rings[] = {detail::plain_rings<T>(subject), detail::plain_rings<T>(clip)};
  const weiler_atherton_lists<T> l = list_crossings(rings[0], rings[1]);
  weiler_atherton_clip<T> result{l.status};
  if (l.status != weiler_atherton_status::ok) return result;
  for (const auto& c : l.crossings) (c.enters ? result.entering : result.leaving).push_back(c.at);
  std::vector<char> walked(l.crossings.size(), char{0});
  for (std::size_t k = 0; k < l.crossings.size(); ++k)
    if (l.crossings[k].enters && walked[k] == 0) result.rings.push_back(detail::walk_crossings(l, k, walked));
  // A ring that nothing crosses is within the other polygon, or it is not.
  for (const std::size_t which : {0u, 1u})
    for (std::size_t r = 0; r < rings[which].size(); ++r) {
      const auto& ring = rings[which][r];
      const bool crossed = (which == 0 ? l.subject : l.clip)[r].size() > ring.size();
      if (!crossed && !ring.empty() && point_in_polygon(rings[1 - which], ring[0]) == location::inside)
        result.rings.push_back(ring);
    }
  return result;
}

}  // namespace irg::textbook::inline IRG_ABI
