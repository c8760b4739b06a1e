// SPDX-License-Identifier: MIT
// What the user of a line, a thick line, an antialiased one, a stroke or a text may choose.
#pragma once

#include <irg/core/config.hpp>
#include <irg/raster/subpixel.hpp>

namespace irg {

/// Which end cells of a line from a to b are drawn.
enum class line_ends {
  closed,     // both
  half_open,  // a but not b: the segments of a polyline draw each shared vertex once; a line from a to a draws nothing
};

/// Where a line goes that passes exactly half-way between two cells.
enum class line_ties {
  start_side,  // to the cell on the side of a; the line from b to a may have other cells
  symmetric,  // as if drawn in the canonical direction (x rising, y rising for steep lines): the same cells both ways
};

/// The choices together.
struct line_options {
  line_ends ends = line_ends::closed;
  line_ties ties = line_ties::start_side;
  bool operator==(const line_options&) const = default;
};

/// How a thick line ends.
enum class line_caps {
  butt,  // at its end points, square to its direction
  square,  // half the width further
  round,  // with half a disc around the end point
};

/// What a thick line is drawn with.
struct line_pen {
  std::int32_t width = one_pixel;  // in 1/256 pixel; nothing is drawn when it is not positive
  line_caps caps = line_caps::butt;
  bool operator==(const line_pen&) const = default;
};

/// How the rectangle of a line ends.
enum class line_aa_caps {
  butt,  // at the end points
  square,  // half a width beyond them
};

/// Lines wider than this, in 1/256 pixel, are not drawn.
inline constexpr std::int32_t max_line_aa_width = 64 * one_pixel;

/// The choices together.
/// units   width in 1/256 pixel
struct line_aa_options {
  std::int32_t width = one_pixel;
  line_aa_caps caps = line_aa_caps::butt;
  bool operator==(const line_aa_options&) const = default;
};

/// How two segments of a thick line meet on the outer side of the bend.
enum class stroke_joins {
  round,  // a sector around the common point
  mitre,  // the edges extended until they meet; a bevel where that is farther than the limit
  bevel,  // a straight cut
};

/// Whether a path has ends or returns to its first point.
enum class polyline_shape {
  open,  // from the first vertex to the last; a thick line has two caps
  closed,  // and from the last back to the first; a thick line has a join at each vertex and no caps
};

/// The choices together.
/// units   width as the points; the mitre's limit in widths, from the inner corner to the tip, as SVG has it
struct stroke_style {
  double width = 1;
  stroke_joins joins = stroke_joins::round;
  line_caps caps = line_caps::butt;
  double mitre_limit = 4;
  polyline_shape shape = polyline_shape::open;
  bool operator==(const stroke_style&) const = default;
};

/// Which part of the text lies at the position given, along the line.
enum class text_along { left, centre, right };

/// Which part lies there across the line; middle is that of the capitals and digits.
enum class text_across { baseline, middle, top, bottom };

/// The choices together.
/// units   size and weight in pixels, clockwise_degrees turn the text on the screen
struct text_style {
  double size = 20;  // of a line; capitals are 7/10 of it
  double clockwise_degrees = 0;  // about the position
  double weight = 0;  // of the strokes; when it is not positive, a twelfth of the size, but one pixel at least
  text_along along = text_along::left;
  text_across across = text_across::baseline;
  bool operator==(const text_style&) const = default;
};

/// The room that a text takes.
struct text_extent {
  double width = 0, ascent = 0, descent = 0;
  bool operator==(const text_extent&) const = default;
};

}  // namespace irg
