// SPDX-License-Identifier: MIT
// What the user of a thick line with joins may choose.
#pragma once

#include <irg/raster/line_pen.hpp>

namespace irg {

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
  constexpr bool operator==(const stroke_style&) const = default;
};

}  // namespace irg
