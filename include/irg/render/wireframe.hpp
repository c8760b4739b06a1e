// SPDX-License-Identifier: MIT
// Wireframe: the edges of the faces as one-pixel lines.
#pragma once

#include <cstdint>
#include <vector>

#include <irg/core/executor.hpp>
#include <irg/mesh/mesh.hpp>
#include <irg/raster/draw_counts.hpp>
#include <irg/raster/line_bresenham.hpp>
#include <irg/raster/projected_vertices.hpp>
#include <irg/raster/triangle_coverage.hpp>
#if IRG_BODIES
#include <algorithm>

#include <irg/geometry/clip_homogeneous.hpp>
#endif

namespace irg {

/// A mesh and its positions, projected with a mapping; whether faces beyond a border of the picture are passed over.
template <Floating T>
struct projected_mesh {
  const projected_vertices<T>& vertices;
  const mesh<T>& shape;
  const screen_mapping<T>& mapping;
  skipping frustum = skipping::on;
};
template <class T>
projected_mesh(const projected_vertices<T>&, const mesh<T>&, const screen_mapping<T>&) -> projected_mesh<T>;
template <class T>
projected_mesh(const projected_vertices<T>&, const mesh<T>&, const screen_mapping<T>&, skipping) -> projected_mesh<T>;

inline namespace IRG_ABI {

/// Draws the edges of a mesh's faces, each once, and returns what it did: `triangles` counts n - 2 for a face of
/// n corners, pixels.shaded the cells of all lines.
/// shape   faces may have any number of corners; `{vertices, mesh, mapping}` is enough at the call
/// needs   face_starts as in mesh.hpp
/// gives   faces wholly beyond a border of the picture or of the depth range are passed over and counted as
///         skipped.frustum, none when drawn.frustum is off; of the others those that face away are left out when
///         culling is `back`. An edge is drawn if any of its faces is. Edges to vertices that are not there are left
///         out
/// exact   the same pixels for every executor, and with drawn.frustum on and off; lines by line_bresenham from the
///         smaller vertex index to the larger
template <Floating T = double, RowRaster Colour, Executor E = sequential>
constexpr render_counts draw_wireframe(Colour& colour, const projected_mesh<T>& drawn, const pixel_of<Colour>& line,
                                       face_culling culling = face_culling::none, const E& executor = {});

/// The same of floats.
template <RowRaster Colour, Executor E = sequential>
constexpr render_counts draw_wireframe(Colour& colour, const projected_mesh<float>& drawn, const pixel_of<Colour>& line,
                                       face_culling culling = face_culling::none, const E& executor = {}) {
  return draw_wireframe<float>(colour, drawn, line, culling, executor);
}

}  // namespace IRG_ABI
}  // namespace irg

namespace irg::detail {

// Where the line of an edge runs on the screen, if any of it can be seen.
struct line_on_screen {
  bool seen = false;
  cell from{}, to{};
};

inline namespace IRG_ABI {

// Whether a face shows its back, by the sign of its area on the screen; faces that reach behind the eye or beyond the
// guard band are taken to show their front, and so are those of which a vertex is not there.
template <class T>
constexpr bool shows_back(const projected_vertices<T>& v, const mesh<T>& m, std::size_t f) noexcept {
  std::int64_t area = 0;
  const std::size_t n = m.face_size(f);
  for (std::size_t k = 0; k < n; ++k) {
    const std::uint32_t corner = m.corner(f, k).position;
    if (corner >= v.codes.size() || v.codes[corner].cut != 0) return false;
  }
  const subpixel origin = v.screen[m.corner(f, 0).position].position;
  for (std::size_t k = 1; k + 1 < n; ++k)
    area += twice_signed_area(origin, v.screen[m.corner(f, k).position].position,
                              v.screen[m.corner(f, k + 1).position].position);
  return area >= 0;
}

// An edge between two vertices as one number, the smaller index first: the same for both faces that share it.
IRG_INLINE constexpr std::uint64_t edge_of(std::uint32_t p, std::uint32_t q) noexcept {
  return std::uint64_t{minimum(p, q)} << 32 | maximum(p, q);
}

}  // namespace IRG_ABI

inline namespace IRG_COMPILED_ABI {

// The lines of a mesh's edges in a picture of this size, each once; what is passed over is counted.
template <Floating T>
IRG_API std::vector<line_on_screen> lines_of_faces(const projected_mesh<T>& drawn, face_culling culling,
                                                   const cell_window& picture, render_counts& counts);

}  // namespace IRG_COMPILED_ABI
}  // namespace irg::detail

namespace irg::inline IRG_ABI {

template <Floating T, RowRaster Colour, Executor E>
constexpr render_counts draw_wireframe(Colour& colour, const projected_mesh<T>& drawn, const pixel_of<Colour>& line,
                                       face_culling culling, const E& executor) {
  render_counts stats;
  const std::vector<detail::line_on_screen> lines =
      detail::lines_of_faces(drawn, culling, {0, 0, width_of(colour), height_of(colour)}, stats);
  const int height = height_of(colour), rows = 64, bands = (height + rows - 1) / rows;
  std::vector<std::int64_t> shaded(static_cast<std::size_t>(bands), 0);
  executor(shaded.size(), [&](std::size_t band) {
    const int y = static_cast<int>(band) * rows;
    for (const detail::line_on_screen& l : lines)
      line_bresenham(l.from, l.to, {0, y, width_of(colour), minimum(y + rows, height)}, [&](cell c) {
        set_pixel(colour, c.x, c.y, line);
        ++shaded[band];
      });
  });
  for (const std::int64_t n : shaded) stats.pixels.shaded += n;
  stats.pixels.tested = stats.pixels.shaded;
  return stats;
}

}  // namespace irg::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail {
inline namespace IRG_ABI {

// The pixel that holds a snapped position.
IRG_INLINE constexpr cell cell_of(const subpixel& p) noexcept { return {p.x >> subpixel_bits, p.y >> subpixel_bits}; }

// The line of an edge; not seen when it is out of sight, or a vertex is not there.
template <class T>
constexpr line_on_screen line_of(const projected_vertices<T>& v, std::uint64_t edge,
                                 const screen_mapping<T>& mapping) noexcept {
  const auto a = static_cast<std::size_t>(edge >> 32), b = static_cast<std::size_t>(edge & 0xffffffff);
  if (b >= v.codes.size()) return {};
  const clip_planes cut = (v.codes[a] | v.codes[b]).cut_planes();
  if (cut == clip_planes::none) return {true, cell_of(v.screen[a].position), cell_of(v.screen[b].position)};
  const auto left = clip_segment_homogeneous(clip_vertex<T, 0>{clip_position(v, a)},
                                             clip_vertex<T, 0>{clip_position(v, b)}, mapping.guard);
  if (!left) return {};
  return {true, cell_of(to_screen(left->first.position, mapping).position),
          cell_of(to_screen(left->second.position, mapping).position)};
}

// Whether nothing of a face is in the picture: its corners are beyond one border or depth plane, and no line of it has
// a cell there. Decided on the cells between which the lines are drawn, not by the corners' codes alone: a corner
// beyond a border by less than 1/512 pixel is snapped into the picture. No cell of a Bresenham line is outside the box
// of its two ends, so a line whose ends are beyond one border draws nothing; a face passed over loses no pixel.
template <class Drawn>
constexpr bool lies_beyond(const Drawn& drawn, std::size_t f, const cell_window& picture) noexcept {
  const auto& v = drawn.vertices;
  const auto& m = drawn.shape;
  const std::size_t n = m.face_size(f);
  clip_code_pair all{static_cast<std::uint8_t>(clip_planes::all), static_cast<std::uint8_t>(clip_planes::all)};
  for (std::size_t k = 0; k < n; ++k) {
    const std::uint32_t corner = m.corner(f, k).position;
    if (corner >= v.codes.size()) return false;
    all = all & v.codes[corner];
  }
  if (all.outside == 0) return false;
  for (std::size_t k = 0; k < n; ++k) {
    const std::uint64_t edge = edge_of(m.corner(f, k).position, m.corner(f, (k + 1) % n).position);
    const line_on_screen l = line_of(v, edge, drawn.mapping);
    const bool beyond = (l.from.x < picture.x_first && l.to.x < picture.x_first) ||
                        (l.from.x >= picture.x_last && l.to.x >= picture.x_last) ||
                        (l.from.y < picture.y_first && l.to.y < picture.y_first) ||
                        (l.from.y >= picture.y_last && l.to.y >= picture.y_last);
    if (l.seen && !beyond) return false;
  }
  return true;
}

}  // namespace IRG_ABI

inline namespace IRG_COMPILED_ABI {

template <Floating T>
IRG_API std::vector<line_on_screen> lines_of_faces(const projected_mesh<T>& drawn, face_culling culling,
                                                   const cell_window& picture, render_counts& counts) {
  const auto& [vertices, m, mapping, frustum] = drawn;
  const bool may_skip = frustum == skipping::on && vertices.any.outside != 0;
  std::vector<std::uint64_t> edges;
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    const std::size_t corners = m.face_size(f);
    counts.triangles += static_cast<std::int64_t>(corners) - 2;
    if (may_skip && lies_beyond(drawn, f, picture)) {
      counts.skipped.frustum += static_cast<std::int64_t>(corners) - 2;
      continue;
    }
    if (culling == face_culling::back && shows_back(vertices, m, f)) {
      counts.skipped.backface += static_cast<std::int64_t>(corners) - 2;
      continue;
    }
    for (std::size_t k = 0; k < corners; ++k)
      edges.push_back(edge_of(m.corner(f, k).position, m.corner(f, (k + 1) % corners).position));
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::vector<line_on_screen> lines;
  for (const std::uint64_t edge : edges)
    if (const line_on_screen l = line_of(vertices, edge, mapping); l.seen) lines.push_back(l);
  return lines;
}

}  // namespace IRG_COMPILED_ABI
}  // namespace irg::detail
#endif
