// SPDX-License-Identifier: MIT
// draw_polyline, draw_polygon: straight lines from vertex to vertex, each shared vertex painted once.
#pragma once

#include <irg/raster/draw_line.hpp>
#include <irg/raster/line_style.hpp>

namespace irg {

/// Cells, or points of ints, in sequence: the vertices of a polyline. Models: std::vector<cell>, std::array, std::span.
template <class T>
concept CellSequence = requires(const T& cells, std::size_t i) {
  { cells.size() } -> std::convertible_to<std::size_t>;
  { as_cell(cells[i]) } -> std::same_as<cell>;
};

inline namespace IRG_ABI {

/// Paints the pixels of the lines that join the vertices one after the other.
/// shape   each segment without its end, which the next one starts with; the last vertex of an open one, too
/// gives   nothing without vertices; one pixel when all vertices are equal
/// exact   the cells of draw_line; a function paint is called once per vertex that two segments share, but as often as
///         segments cross or overlap elsewhere
template <WritableRaster R, CellSequence Vertices, PaintFor<R> Paint = pixel_of<R>>
constexpr void draw_polyline(R& raster, const Vertices& vertices, const Paint& paint,
                             polyline_shape shape = polyline_shape::open, line_ties ties = line_ties::start_side) {
  const auto size = static_cast<std::size_t>(vertices.size());
  if (size == 0) return;
  const line_options half_open{line_ends::half_open, ties};
  const cell first = as_cell(vertices[0]);
  cell from = first;
  bool moved = false;
  for (std::size_t i = 1; i < size; ++i) {
    const cell to = as_cell(vertices[i]);
    draw_line(raster, from, to, paint, half_open);
    moved = moved || !(from == to);
    from = to;
  }
  if (shape == polyline_shape::closed && moved)
    draw_line(raster, from, first, paint, half_open);
  else
    draw_line(raster, from, from, paint);
}

/// Paints the pixels of a polygon's outline: the lines of a closed polyline.
/// gives   as draw_polyline
/// exact   as draw_polyline
template <WritableRaster R, CellSequence Vertices, PaintFor<R> Paint = pixel_of<R>>
constexpr void draw_polygon(R& raster, const Vertices& vertices, const Paint& paint,
                            line_ties ties = line_ties::start_side) {
  draw_polyline(raster, vertices, paint, polyline_shape::closed, ties);
}

}  // namespace IRG_ABI
}  // namespace irg
