// SPDX-License-Identifier: MIT
// The facets of a grid surface in covering order with their corners transformed, one row of which is kept, as the
// source describes it. `visible_grid_edges` transforms nothing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include <irg/hidden/grid_covering_order.hpp>

namespace irg::textbook {

/// What is remembered of the vertices that were transformed: nothing, so that each is transformed anew for every facet
/// at it, or the row on which the next facets stand.
enum class vertex_memory { none, row };

/// How much was done to transform the vertices of all facets.
struct transform_counts {
  std::int64_t facets = 0, transforms = 0;
  bool operator==(const transform_counts&) const = default;
};

inline namespace IRG_ABI {

/// Calls visit(facet, corners) for the facets in covering order, corners[2*di + dj] being what transform(i, j) gives
/// for the facet's corner (di, dj). Returns how often it was asked.
/// needs   loops of covering_loops; a transform whose results have a default, and are the same when asked again
/// gives   with a row kept, each vertex transformed once where one loop covers the surface (as from a corner), else at
///         most twice: on the lines where loops meet, but once where all four do. Without: once for each facet at it
/// cost    memory for one row of m + 1 vertices, where all vertices together take (n + 1) (m + 1)
/// source  Special-cases chapter, 3 (storage; described there, not coded)
template <class Transform, class Visit>
constexpr transform_counts visit_transformed_facets(const grid_covering& c, const Transform& transform, Visit&& visit,
                                                    vertex_memory memory = vertex_memory::row) {
  using vertex = std::remove_cvref_t<decltype(transform(0, 0))>;
  transform_counts counts;
  const auto ask = [&](int i, int j) {
    ++counts.transforms;
    return transform(i, j);
  };
  if (memory == vertex_memory::none) {
    visit_in_covering_order(c, [&](const grid_facet& f) {
      ++counts.facets;
      const std::array<vertex, 4> corners{ask(f.i - 1, f.j - 1), ask(f.i - 1, f.j), ask(f.i, f.j - 1), ask(f.i, f.j)};
      visit(f, corners);
    });
    return counts;
  }
  std::vector<vertex> row(static_cast<std::size_t>(c.m) + 1, vertex{});  // [j] is (i, j), for the line i that is behind
  const auto kept = [&](int j) -> vertex& { return row[static_cast<std::size_t>(j)]; };
  vertex start{};  // where the loops meet: each of them begins at it
  bool started = false;
  // From the lines `i` and `j` to n or 0 and m or 0.
  const auto loop = [&](int i, int last_i, int j_first, int last_j) {
    if (i == last_i || j_first == last_j) return;
    const int along_i = i < last_i ? 1 : -1, along_j = j_first < last_j ? 1 : -1;
    if (!started) start = ask(i, j_first);
    started = true;
    kept(j_first) = start;
    for (int j = j_first; j != last_j; j += along_j) kept(j + along_j) = ask(i, j + along_j);
    for (; i != last_i; i += along_i) {
      vertex behind = ask(i + along_i, j_first);
      for (int j = j_first; j != last_j; j += along_j) {
        vertex next = ask(i + along_i, j + along_j);
        std::array<vertex, 4> corners{};
        const std::size_t di = along_i > 0 ? 0 : 2, dj = along_j > 0 ? 0 : 1;  // of the corner that is reached first
        corners[di + dj] = kept(j), corners[di + (1 - dj)] = kept(j + along_j);
        corners[(2 - di) + dj] = behind, corners[(2 - di) + (1 - dj)] = next;
        ++counts.facets;
        visit(grid_facet{maximum(i, i + along_i), maximum(j, j + along_j)}, corners);
        kept(j) = behind;
        behind = next;
      }
      kept(last_j) = behind;
    }
  };
  for (const bool j_rises : {true, false}) {
    const int j = j_rises ? c.first_j - 1 : maximum(0, c.last_j), last_j = j_rises ? c.m : 0;
    loop(c.first_i - 1, c.n, j, last_j);
    loop(maximum(0, c.last_i), 0, j, last_j);
  }
  return counts;
}

}  // namespace IRG_ABI
}  // namespace irg::textbook
