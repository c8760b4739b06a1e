// SPDX-License-Identifier: MIT
// Wireframe: the edges of the faces as one-pixel lines.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <irg/core/executor.hpp>
#include <irg/mesh/mesh.hpp>
#include <irg/raster/fill_span.hpp>
#include <irg/raster/draw_line.hpp>
#include <irg/render/options.hpp>
#include <irg/raster/projected_vertices.hpp>
#include <irg/raster/triangle_coverage.hpp>
#include <irg/render/detail/wireframe_steps.hpp>

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
/// shape   faces may have any number of corners; for doubles `{vertices, mesh, mapping}` is enough at the call
/// needs   face_starts as in mesh.hpp
/// gives   faces wholly beyond a border of the picture or of the depth range are passed over and counted as
///         skipped.frustum, none when drawn.frustum is off; of the others those that face away are left out when
///         culling is `back`. An edge is drawn if any of its faces is. Edges to vertices that are not there are left
///         out
/// exact   the same pixels for every executor, and with drawn.frustum on and off; lines by line_bresenham from the
///         smaller vertex index to the larger
template <Floating T = double, RowRaster Colour, Executor E = sequential>
constexpr render_stats draw_wireframe(Colour& colour, const projected_mesh<T>& drawn, const pixel_of<Colour>& line,
                                      face_culling culling = face_culling::none, const E& executor = {}) {
  const auto& [vertices, m, mapping, frustum] = drawn;
  const cell_window picture{0, 0, width_of(colour), height_of(colour)};
  const bool may_skip = frustum == skipping::on && vertices.any.outside != 0;
  render_stats stats;
  std::vector<std::uint64_t> edges;
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    const std::size_t corners = m.face_size(f);
    stats.triangles += static_cast<std::int64_t>(corners) - 2;
    if (may_skip && detail::lies_beyond(drawn, f, picture)) {
      stats.skipped.frustum += static_cast<std::int64_t>(corners) - 2;
      continue;
    }
    if (culling == face_culling::back && detail::shows_back(vertices, m, f)) {
      stats.skipped.backface += static_cast<std::int64_t>(corners) - 2;
      continue;
    }
    for (std::size_t k = 0; k < corners; ++k)
      edges.push_back(detail::edge_of(m.corner(f, k).position, m.corner(f, (k + 1) % corners).position));
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::vector<detail::line_on_screen> lines;
  for (const std::uint64_t edge : edges)
    if (const detail::line_on_screen l = detail::line_of(vertices, edge, mapping); l.seen) lines.push_back(l);
  const int height = height_of(colour), rows = 64, bands = (height + rows - 1) / rows;
  std::vector<std::int64_t> shaded(static_cast<std::size_t>(bands), 0);
  executor(shaded.size(), [&](std::size_t band) {
    const int y = static_cast<int>(band) * rows;
    for (const detail::line_on_screen& l : lines)
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
