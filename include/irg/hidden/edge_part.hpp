// SPDX-License-Identifier: MIT
// What hidden lines come in: parts of edges, seen or hidden.
#pragma once

#include <cstddef>

namespace irg {

/// Whether a part of an edge is seen.
enum class line_visibility { visible, hidden };

/// A part of an edge, the whole of it having one visibility.
/// shape   edge: the number of the edge in its range; from < to: of the way from its first end to the second. Parts
///         that meet share the place
struct edge_part {
  std::size_t edge;
  line_visibility visibility;
  double from, to;
};

}  // namespace irg
