// SPDX-License-Identifier: MIT
// The triangle stage: cull, clip, sort into bands of rows, and draw each band. Bands are independent of each other, so
// an executor may draw them in any order on any thread, and small enough to stay in the cache while they are drawn.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <irg/core/executor.hpp>
#include <irg/raster/fill_span.hpp>
#include <irg/render/options.hpp>
#include <irg/render/projected_vertices.hpp>

namespace irg {

/// Three indices of vertices, counter-clockwise seen from outside.
struct triangle_indices {
  std::uint32_t v[3];
  constexpr bool operator==(const triangle_indices&) const = default;
};

/// Which way a triangle shows itself.
enum class facing { front, back };

/// Where the corners of a piece lie in its source triangle: the weights of the source's second and third vertex.
struct triangle_shares {
  fragment<float> corner[3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

  /// The value at corner k of a quantity given at the source's vertices.
  IRG_INLINE constexpr float operator()(int k, float at0, float at1, float at2) const noexcept {
    return corner[k].interpolate(at0, at1, at2);
  }
};

/// Whether the picture and its depth are cleared first: band by band, just before each is drawn, while it is in the
/// cache.
enum class clearing { none, before_drawing };

/// How drawing is set up: what is left out, and what the picture is cleared to first, if it is.
template <class P>
struct draw_settings {
  face_culling culling = face_culling::back;
  skipping skip = skipping::on;
  clearing clear = clearing::none;
  P background{};
};

namespace detail {

inline constexpr int band_height = 32;

// A part of a source triangle that a clip plane left over.
struct clipped_piece {
  screen_vertex v[3];
  triangle_shares shares;
  std::uint32_t source;
};

// What became of a triangle: of several pieces' fates the greatest counts.
enum class listing { tiny, out_of_sight, listed };

// What each band has to draw, in order: numbers below the triangle count name whole triangles, the rest pieces.
struct draw_list {
  std::vector<clipped_piece> pieces;
  std::vector<std::vector<std::uint32_t>> bands;
  skip_counts skipped;
};

inline namespace IRG_ABI {

IRG_INLINE constexpr int band_count(int height) noexcept { return (height + band_height - 1) / band_height; }

// Whether culling leaves out a triangle or polygon of this signed area: fronts are negative, because y is down.
IRG_INLINE constexpr bool is_culled(std::int64_t area, face_culling culling) noexcept {
  return area > 0 && culling == face_culling::back;
}

// Puts one triangle on the lists of the bands it touches, or says why not.
constexpr listing enlist(draw_list& list, std::uint32_t number, const screen_vertex& a, const screen_vertex& b,
                         const screen_vertex& c, std::int64_t area, int width, int height, skipping skip) {
  const cell_window bounds = centres_within(a.position, b.position, c.position);
  if (skip == skipping::on && (area == 0 || bounds.empty())) return listing::tiny;
  const cell_window seen = intersect(bounds, {0, 0, width, height});
  if (seen.empty()) return listing::out_of_sight;
  for (int band = seen.y_first / band_height; band <= (seen.y_last - 1) / band_height; ++band)
    list.bands[static_cast<std::size_t>(band)].push_back(number);
  return listing::listed;
}

IRG_INLINE constexpr void count_skipped(skip_counts& counts, listing why, skipping skip) noexcept {
  if (skip == skipping::off) return;
  if (why == listing::tiny) ++counts.tiny;
  if (why == listing::out_of_sight) ++counts.frustum;
}

// Clips a triangle, and puts what is left of it on the lists as a fan of pieces. It faces one way, and is one skip at
// most, however many pieces it comes to.
template <class T>
constexpr void enlist_clipped(draw_list& list, std::uint32_t source, std::uint32_t triangle_count,
                              const hpoint<T, 3> (&corner)[3], const screen_mapping<T>& mapping, int width, int height,
                              face_culling culling, skipping skip) {
  const clip_vertex<T, 2> polygon[3] = {
      {corner[0], {T(0), T(0)}}, {corner[1], {T(1), T(0)}}, {corner[2], {T(0), T(1)}}};
  const auto left = clip_homogeneous(polygon, mapping.guard);
  if (left.count < 3) return count_skipped(list.skipped, listing::out_of_sight, skip);

  screen_vertex on_screen[9];
  fragment<float> share[9];
  for (int k = 0; k < left.count; ++k) {
    on_screen[k] = to_screen(left.vertices[k].position, mapping);
    share[k] = {static_cast<float>(left.vertices[k].attributes[0]), static_cast<float>(left.vertices[k].attributes[1]),
                0};
  }
  const auto area_of = [&](int k) {
    return signed_double_area(on_screen[0].position, on_screen[k].position, on_screen[k + 1].position);
  };
  std::int64_t area = 0;
  for (int k = 1; k + 1 < left.count; ++k) area += area_of(k);
  if (is_culled(area, culling)) return static_cast<void>(++list.skipped.backface);
  listing result = listing::tiny;
  for (int k = 1; k + 1 < left.count && area != 0; ++k) {
    // Snapping may turn round a piece thinner than 1/256 pixel; the pieces beside it cover its place.
    if (area_of(k) != 0 && (area_of(k) > 0) != (area > 0)) continue;
    const clipped_piece piece{
        {on_screen[0], on_screen[k], on_screen[k + 1]}, {{share[0], share[k], share[k + 1]}}, source};
    const auto number = triangle_count + static_cast<std::uint32_t>(list.pieces.size());
    const listing l = enlist(list, number, piece.v[0], piece.v[1], piece.v[2], area_of(k), width, height, skip);
    if (l == listing::listed) list.pieces.push_back(piece);
    result = greater(result, l);
  }
  count_skipped(list.skipped, result, skip);
}

template <class T>
constexpr draw_list list_triangles(const projected_vertices<T>& v, std::span<const triangle_indices> triangles,
                                   const screen_mapping<T>& mapping, int width, int height, face_culling culling,
                                   skipping skip) {
  draw_list list;
  list.bands.resize(static_cast<std::size_t>(band_count(height)));
  const auto count = static_cast<std::uint32_t>(triangles.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto [a, b, c] = triangles[i].v;
    const clip_planes cut = v.cut[a] | v.cut[b] | v.cut[c];
    // Beyond one plane with all corners. Where clipping comes first, its rounding has a say in where the triangle
    // lands, and only the depth planes, by which it decides itself, are sure to change nothing.
    const clip_planes sure = cut == clip_planes::none ? clip_planes::all : clip_planes::depth;
    if (skip == skipping::on && overlap(v.outside[a] & v.outside[b] & v.outside[c], sure)) {
      ++list.skipped.frustum;
      continue;
    }
    if (cut != clip_planes::none) {
      enlist_clipped<T>(list, i, count, {v.clip[a], v.clip[b], v.clip[c]}, mapping, width, height, culling, skip);
      continue;
    }
    const std::int64_t area = signed_double_area(v.screen[a].position, v.screen[b].position, v.screen[c].position);
    if (is_culled(area, culling))
      ++list.skipped.backface;
    else
      count_skipped(list.skipped, enlist(list, i, v.screen[a], v.screen[b], v.screen[c], area, width, height, skip),
                    skip);
  }
  return list;
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// Draws triangles into a picture and its depth buffer, and returns what it did.
/// shape   colour and depth are rasters of one size; make_shader(triangle, shares, facing) gives the pixel shader of a
///         triangle or, after clipping, of a piece of it
/// needs   indices in range; `depth` holds depths of the same order, unless they are cleared first
/// gives   equal depths go to the triangle drawn first; triangles with a corner that is not finite are left out
/// exact   the same bytes for every executor and with skipping on and off
/// cost    one pass over the triangles, then the pixels; allocates the bands' lists
template <DepthOrder Order = nearer_is_greater, Floating T, RowRaster Colour, RowRaster Depth, class MakeShader,
          Executor E = sequential>
constexpr render_stats draw_triangles(Colour& colour, Depth& depth, const projected_vertices<T>& vertices,
                                      std::span<const triangle_indices> triangles, const screen_mapping<T>& mapping,
                                      const MakeShader& make_shader,
                                      const draw_settings<pixel_of<Colour>>& settings = {}, const E& executor = {}) {
  const int width = width_of(colour), height = height_of(colour);
  const detail::draw_list list =
      detail::list_triangles(vertices, triangles, mapping, width, height, settings.culling, settings.skip);
  std::vector<render_stats> done(list.bands.size(), render_stats{});
  executor(list.bands.size(), [&](std::size_t band) {
    const int y_first = static_cast<int>(band) * detail::band_height,
              y_last = lesser(y_first + detail::band_height, height);
    const cell_window window{0, y_first, width, y_last};
    if (settings.clear == clearing::before_drawing)
      for (int y = y_first; y < y_last; ++y) {
        fill_span(colour, {y, 0, width}, settings.background);
        fill_span(depth, {y, 0, width}, Order::farthest);
      }
    const auto draw = [&](const screen_vertex& a, const screen_vertex& b, const screen_vertex& c, std::uint32_t source,
                          const triangle_shares& shares) {
      const triangle_coverage t = cover_triangle(a.position, b.position, c.position);
      if (t.double_area == 0) return;
      const auto shader = make_shader(source, shares, t.flipped ? facing::front : facing::back);
      done[band].pixels += draw_triangle<Order>(colour, depth, t, a, b, c, shader, window);
    };
    const auto count = static_cast<std::uint32_t>(triangles.size());
    for (const std::uint32_t number : list.bands[band]) {
      if (number < count) {
        const auto [a, b, c] = triangles[number].v;
        draw(vertices.screen[a], vertices.screen[b], vertices.screen[c], number, {});
      } else {
        const detail::clipped_piece& piece = list.pieces[number - count];
        draw(piece.v[0], piece.v[1], piece.v[2], piece.source, piece.shares);
      }
    }
  });
  render_stats stats;
  for (const render_stats& s : done) stats += s;
  stats.triangles = static_cast<std::int64_t>(triangles.size());
  stats.skipped = list.skipped;
  return stats;
}

}  // namespace IRG_ABI
}  // namespace irg
