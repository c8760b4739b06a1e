// SPDX-License-Identifier: MIT
// Thick lines through many points with smooth edges, with joins and caps: the outline as convex rings that overlap, and
// the pixels that their union covers, each mixed once.
//
// Every segment is a rectangle, every bend a piece on its outer side, every cap a piece of its own. All rings turn the
// same way, so under the non-zero rule they are their union, whatever crosses.
#pragma once

#include <span>
#include <vector>

#include <irg/raster/detail/stroke_pieces.hpp>
#include <irg/raster/fill_polygon_aa.hpp>

namespace irg {
inline namespace IRG_ABI {

/// Hands the outline of a thick line through the points to sink(ring), ring by ring: the stroke is their union.
/// shape   convex rings of std::span<const point<double, 2>>, all positive (counter-clockwise where y goes up), as
///         far as the width is not lost in the rounding of the coordinates
/// units   those of the points; arcs are cut into chords within 1/128 of the circle: 1/128 pixel of pixels;
///         at most 4097 chords per arc, which is enough up to a width of 2 * 10^5
/// needs   coordinates, width and mitre limit of at most 2^500 in size
/// gives   false and no ring otherwise, and for NaN. No ring for no points or a width of 0 or less. Repeated points
///         count once; points that are all equal give a disc with round caps, a level square with square ones, nothing
///         with butt ones. A turn of 180 degrees has half a disc with round joins, nothing otherwise
/// exact   every vertex within a few roundings of its coordinates; the tip of a mitre, which lies up to the limit away,
///         within as many as the limit says where that is more
/// cost    a root and two divisions per segment; a sine and a cosine per vertex of an arc; allocates one ring
template <class Sink>
  requires requires(Sink& sink, std::span<const point<double, 2>> ring) { sink(ring); }
constexpr bool stroke_outline(std::span<const point<double, 2>> points, const stroke_style& style, Sink&& sink) {
  if (!detail::can_stroke(points, style)) return false;
  if (!(style.width > 0) || points.empty()) return true;
  detail::stroke_pieces<std::remove_reference_t<Sink>> pieces{style, 0.5 * style.width, sink, {}};
  const std::vector<point<double, 2>> path = detail::without_repeats(points, style.shape);
  if (path.size() == 1)
    pieces.dot_at(path[0]);
  else
    pieces.whole(path);
  return true;
}

/// Paints a thick line through the points with smooth edges, each pixel once, as far as it is covered.
/// units   pixels; the outline's vertices are snapped to 1/256 pixel
/// gives   false and nothing painted when stroke_outline gives false or a vertex is beyond snap_limit
/// exact   with round joins and caps, a pixel that lies within half the width less 1/64 pixel of the path is covered
///         whole, one beyond half the width and 1/64 pixel not at all; between, the area of the snapped outline
/// cost    that of polygon_coverage for the rings of stroke_outline: each of their crossings counts, so a path of n
///         segments that is scribbled into one spot costs their square
template <WritableRaster R, CoveragePaintFor<R> Paint = pixel_of<R>>
constexpr bool draw_stroke(R& raster, std::span<const point<double, 2>> points, const stroke_style& style,
                           const Paint& paint) {
  std::vector<std::vector<point<double, 2>>> rings;
  const auto keep = [&](std::span<const point<double, 2>> ring) { rings.emplace_back(ring.begin(), ring.end()); };
  if (!stroke_outline(points, style, keep)) return false;
  return fill_polygon_aa(raster, rings, fill_rule::non_zero, paint);
}

}  // namespace IRG_ABI
}  // namespace irg
