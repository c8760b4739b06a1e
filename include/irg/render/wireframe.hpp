// SPDX-License-Identifier: MIT
// Wireframe: the edges of the faces as one-pixel lines.
#pragma once

#include <algorithm>
#include <compare>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <irg/core/executor.hpp>
#include <irg/mesh/mesh.hpp>
#include <irg/raster/fill_span.hpp>
#include <irg/raster/draw_line.hpp>
#include <irg/render/options.hpp>
#include <irg/render/projected_vertices.hpp>

namespace irg {

/// An edge between two vertices, the smaller index first: the same line for both faces that share it.
struct mesh_edge {
  std::uint32_t a, b;
  constexpr auto operator<=>(const mesh_edge&) const = default;
};

namespace detail {
inline namespace IRG_ABI {

// The pixel that holds a snapped position.
IRG_INLINE constexpr cell cell_of(const subpixel& p) noexcept { return {p.x >> subpixel_bits, p.y >> subpixel_bits}; }

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
    area += signed_double_area(origin, v.screen[m.corner(f, k).position].position,
                               v.screen[m.corner(f, k + 1).position].position);
  return area >= 0;
}

// The line of an edge on the screen; nothing when it is out of sight, or a vertex is not there.
template <class T>
constexpr std::optional<std::pair<cell, cell>> line_of(const projected_vertices<T>& v, const mesh_edge& e,
                                                       const screen_mapping<T>& mapping) noexcept {
  if (e.b >= v.codes.size()) return std::nullopt;
  const clip_planes cut = (v.codes[e.a] | v.codes[e.b]).cut_planes();
  if (cut == clip_planes::none) return std::pair{cell_of(v.screen[e.a].position), cell_of(v.screen[e.b].position)};
  const auto left = clip_segment_homogeneous(clip_vertex<T, 0>{clip_position(v, e.a)},
                                             clip_vertex<T, 0>{clip_position(v, e.b)}, mapping.guard);
  if (!left) return std::nullopt;
  return std::pair{cell_of(to_screen(left->first.position, mapping).position),
                   cell_of(to_screen(left->second.position, mapping).position)};
}

}  // namespace IRG_ABI
}  // namespace detail

inline namespace IRG_ABI {

/// Draws the edges of a mesh's faces, each once, and returns what it did: `triangles` counts n - 2 for a face of
/// n corners, pixels.shaded the cells of all lines.
/// shape   `vertices` are the mesh's positions, projected; faces may have any number of corners
/// needs   face_starts as in mesh.hpp
/// gives   faces that face away are left out when culling is `back`; an edge is drawn if any of its faces is. Edges to
///         vertices that are not there are left out
/// exact   the same pixels for every executor; lines by line_bresenham from the smaller vertex index to the larger
template <Floating T, RowRaster Colour, Executor E = sequential>
constexpr render_stats draw_wireframe(Colour& colour, const projected_vertices<T>& vertices, const mesh<T>& m,
                                      const screen_mapping<T>& mapping, const pixel_of<Colour>& line,
                                      face_culling culling = face_culling::none, const E& executor = {}) {
  render_stats stats;
  std::vector<mesh_edge> edges;
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    const std::size_t corners = m.face_size(f);
    stats.triangles += static_cast<std::int64_t>(corners) - 2;
    if (culling == face_culling::back && detail::shows_back(vertices, m, f)) {
      stats.skipped.backface += static_cast<std::int64_t>(corners) - 2;
      continue;
    }
    for (std::size_t k = 0; k < corners; ++k) {
      const std::uint32_t p = m.corner(f, k).position, q = m.corner(f, (k + 1) % corners).position;
      edges.push_back({lesser(p, q), greater(p, q)});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  struct line_on_screen {
    cell from, to;
  };
  std::vector<line_on_screen> lines;
  for (const mesh_edge& e : edges)
    if (const auto l = detail::line_of(vertices, e, mapping)) lines.push_back({l->first, l->second});
  const int height = height_of(colour), rows = 64, bands = (height + rows - 1) / rows;
  std::vector<std::int64_t> shaded(static_cast<std::size_t>(bands), 0);
  executor(shaded.size(), [&](std::size_t band) {
    const int y = static_cast<int>(band) * rows;
    for (const line_on_screen& l : lines)
      line_bresenham(l.from, l.to, {0, y, width_of(colour), lesser(y + rows, height)}, [&](cell c) {
        set_pixel(colour, c.x, c.y, line);
        ++shaded[band];
      });
  });
  for (const std::int64_t n : shaded) stats.pixels.shaded += n;
  stats.pixels.tested = stats.pixels.shaded;
  return stats;
}

}  // namespace IRG_ABI
}  // namespace irg
