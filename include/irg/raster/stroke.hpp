// SPDX-License-Identifier: MIT
// Thick lines through many points with smooth edges, with joins and caps: the outline as convex rings that overlap, and
// the pixels that their union covers, each mixed once.
//
// Every segment is a rectangle, every bend a piece on its outer side, every cap a piece of its own. All rings turn the
// same way, so under the non-zero rule they are their union, whatever crosses.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <irg/core/function_ref.hpp>
#include <irg/raster/fill_polygon_aa.hpp>
#include <irg/raster/line_style.hpp>
#if IRG_BODIES
#include <irg/math/constants.hpp>
#include <irg/math/length.hpp>
#include <irg/math/trigonometry.hpp>
#endif

namespace irg::inline IRG_ABI {

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
constexpr bool stroke_outline(std::span<const point<double, 2>> points, const stroke_style& style, Sink&& sink);

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

}  // namespace irg::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <class T>
IRG_API bool outline_of_stroke(std::span<const point<T, 2>> points, const stroke_style& style,
                               const function_ref<void(std::span<const point<T, 2>>)>& sink);

}  // namespace irg::detail::inline IRG_COMPILED_ABI

namespace irg::inline IRG_ABI {

template <class Sink>
  requires requires(Sink& sink, std::span<const point<double, 2>> ring) { sink(ring); }
constexpr bool stroke_outline(std::span<const point<double, 2>> points, const stroke_style& style, Sink&& sink) {
  return detail::outline_of_stroke<double>(points, style, as_function<void(std::span<const point<double, 2>>)>(sink));
}

}  // namespace irg::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// The convex pieces of a thick line: rectangles, joins and caps, all of positive orientation.

constexpr bool can_stroke(std::span<const point<double, 2>> points, const stroke_style& style) noexcept {
  const auto moderate = [](double v) { return v >= -0x1p500 && v <= 0x1p500; };
  for (const auto& p : points)
    if (!moderate(p.x) || !moderate(p.y)) return false;
  return moderate(style.width) && moderate(style.mitre_limit);
}

// The points, equal neighbours once; of a closed path the last one differs from the first.
constexpr std::vector<point<double, 2>> without_repeats(std::span<const point<double, 2>> points,
                                                        polyline_shape shape) {
  std::vector<point<double, 2>> path;
  for (const auto& p : points)
    if (path.empty() || !(p == path.back())) path.push_back(p);
  while (shape == polyline_shape::closed && path.size() > 1 && path.back() == path.front()) path.pop_back();
  return path;
}

template <class Sink>
struct stroke_pieces {
  using position = point<double, 2>;
  using direction = vec<double, 2>;
  const stroke_style& style;
  double half;
  Sink& sink;
  std::vector<position> ring;

  static constexpr direction to_left(const direction& d) noexcept { return {-d.y, d.x}; }

  constexpr void hand_over() { sink(std::span<const position>(ring.data(), ring.size())); }

  // The sector from p + from to p + to, at most half a turn, positive.
  constexpr void sector(const position& p, const direction& from, const direction& to, double angle) {
    constexpr double sag = 0x1p-7;
    const double step = half > sag ? 2 * irg::acos(1 - sag / half) : pi<double>;
    const double pieces = step > 0 ? clamped(angle / step, 0.0, 4096.0) : 4096.0;
    const int count = static_cast<int>(pieces) + 1;
    ring = {p, p + from};
    for (int i = 1; i < count; ++i) {
      const auto t = sin_cos(angle * i / count);
      ring.push_back(p + (from * t.cosine + to_left(from) * t.sine));
    }
    ring.push_back(p + to);
    hand_over();
  }

  constexpr void segment(const position& a, const position& b, const direction& d) {
    const direction n = to_left(d) * half;
    ring = {a, a - n, b - n, b, b + n, a + n};  // a and b, so that it shares snapped edges with joins and caps
    hand_over();
  }

  // The piece between segments of directions d and e that meet at p; nothing where they go straight on, nor, unless
  // the join is round, straight back.
  constexpr void join(const position& p, const direction& d, const direction& e) {
    const double turn = product(d.x, e.y) - product(d.y, e.x), along = dot(d, e);
    if (turn == 0 && (along > 0 || style.joins != stroke_joins::round)) return;
    const double size = turn > 0 ? turn : 0 - turn;  // 0 of -0
    const direction one = to_left(d) * (turn < 0 ? half : -half), two = to_left(e) * (turn < 0 ? half : -half);
    const direction from = turn < 0 ? two : one, to = turn < 0 ? one : two;
    if (style.joins == stroke_joins::round) return sector(p, from, to, irg::atan2(size, along));
    const double limit = style.mitre_limit < 0 ? 0 : style.mitre_limit;
    const double opening = along < 0 ? product(size, size) / (1 - along) : 1 + along;  // 2 cos^2 of half the turn
    ring = {p, p + from, p + to};
    if (style.joins == stroke_joins::mitre && 2 <= product(product(limit, limit), opening))
      ring.insert(ring.begin() + 2, p + (along < 0 ? (d - e) * (half / size) : (from + to) / opening));
    hand_over();
  }

  // The cap at p of a line that ends there in direction d.
  constexpr void cap(const position& p, const direction& d) {
    const direction n = to_left(d) * half;
    if (style.caps == line_caps::butt) return;
    if (style.caps == line_caps::round) return sector(p, -n, n, pi<double>);
    const direction beyond = d * half;
    ring = {p, p - n, (p - n) + beyond, (p + n) + beyond, p + n};
    hand_over();
  }

  // A path that is one point.
  constexpr void dot_at(const position& p) {
    cap(p, {1, 0});
    cap(p, {-1, 0});
  }

  // Two or more points, no two neighbours equal.
  constexpr void whole(const std::vector<position>& path) {
    const bool closed = style.shape == polyline_shape::closed;
    const std::size_t n = path.size(), segments = closed ? n : n - 1;
    const auto towards = [&](std::size_t i) { return normalized(path[(i + 1) % n] - path[i]); };
    direction before = towards(closed ? n - 1 : 0);
    if (!closed) cap(path[0], -before);
    for (std::size_t i = 0; i < segments; ++i) {
      const direction d = towards(i);
      if (i > 0 || closed) join(path[i], before, d);
      segment(path[i], path[(i + 1) % n], d);
      before = d;
    }
    if (!closed) cap(path[n - 1], before);
  }
};

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <class T>
IRG_API bool outline_of_stroke(std::span<const point<T, 2>> points, const stroke_style& style,
                               const function_ref<void(std::span<const point<T, 2>>)>& sink) {
  if (!can_stroke(points, style)) return false;
  if (!(style.width > 0) || points.empty()) return true;
  stroke_pieces<const function_ref<void(std::span<const point<double, 2>>)>> pieces{style, 0.5 * style.width, sink, {}};
  const std::vector<point<double, 2>> path = without_repeats(points, style.shape);
  if (path.size() == 1)
    pieces.dot_at(path[0]);
  else
    pieces.whole(path);
  return true;
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
