// SPDX-License-Identifier: MIT
// potentially_visible: for each cell of a plan the cells that can be seen from anywhere in it. A cell is seen through a
// sequence of portals when a straight line passes them all, between their ends.
//
// Lines that pass a sequence form one bundle with two extremes: the one that turns furthest right goes from a left end
// to a later right end, the one that turns furthest left from a right end to a later left end. Both touch ends of
// portals, numbers that were given, so two turns decide exactly whether a line of the bundle passes one portal more.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/geometry/compare.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/spatial/cell_grid.hpp>
#include <irg/visibility/cell_plan.hpp>

namespace irg {

/// How long to search.
struct visible_set_options {
  std::uint64_t most_doors = std::uint64_t{1} << 24;  ///< looked at from one cell; then all that it connects to is seen
  std::uint32_t most_parts = 256;  ///< of pairs of places, to find a line in space; then a way is held to be open
  bool operator==(const visible_set_options&) const = default;
};

/// Which cells may be seen from which.
/// shape   seen.is_full({to, from, 0}): a row of bits for each cell
struct visible_sets {
  cell_grid seen;
  std::int64_t unfinished = 0;  ///< cells whose search was too long: their rows hold all that is connected
  std::int64_t undecided =
      0;  ///< ways in space on which no line was found, and none ruled out: they are held to be open
  bool operator==(const visible_sets&) const = default;
};

inline namespace IRG_ABI {

/// The straight lines that pass a sequence of portals between their ends, leaving room to the right and to the left.
template <Floating T>
class stabbing_lines {
public:
  /// Whether one of the lines passes this doorway, too, after the others.
  /// needs   a doorway of the cell into which the last one leads, in a plan without defects
  /// gives   false for a portal without length
  /// exact   for all finite coordinates
  /// cost    two turns
  [[nodiscard]] constexpr bool passes(const doorway<T>& d) const noexcept {
    if (d.right == d.left) return false;
    if (steps_.empty()) return true;
    const extremes& e = steps_.back().reach;
    return lets_by(e.right_from, e.right_to, d.left, 1) && lets_by(e.left_from, e.left_to, d.right, -1);
  }

  /// Keeps the lines that pass this doorway, too.
  /// needs   passes(d)
  /// cost    a turn for each doorway before, and seldom twice as many
  constexpr void enter(const doorway<T>& d) {
    const bool is_first = steps_.empty();
    extremes e{d.left, d.right, d.right, d.left};
    if (!is_first) e = steps_.back().reach;
    steps_.push_back({d.right, d.left, e});
    if (is_first) return;
    if (orient2d(e.left_from, e.left_to, d.left) < 0) turn_right(steps_.back().reach);
    if (orient2d(e.right_from, e.right_to, d.right) > 0) turn_left(steps_.back().reach);
  }

  /// Goes back before the last doorway.
  /// needs   size() > 0
  constexpr void leave() noexcept { steps_.pop_back(); }
  [[nodiscard]] constexpr std::size_t size() const noexcept { return steps_.size(); }

private:
  struct extremes {
    point<T, 2> right_from{}, right_to{};  // no line turns further right
    point<T, 2> left_from{}, left_to{};
  };
  struct step {
    point<T, 2> right{}, left{};
    extremes reach{};
  };

  // Whether an end lies on that side of an extreme line, or where it comes in: a wall that begins at the last portal's
  // end, or goes on in line with it, hides nothing from the lines of the bundle.
  [[nodiscard]] static constexpr bool lets_by(const point<T, 2>& from, const point<T, 2>& to, const point<T, 2>& end,
                                              int side) noexcept {
    const int turn = orient2d(from, to, end);
    if (turn != 0) return turn == side;
    return compare_lexicographic(from, to) * compare_lexicographic(from, end) <= 0;
  }

  // The left extreme, turned so far to the right that it goes to the last left end: the right ends hold it back, of
  // those on one line the last.
  constexpr void turn_right(extremes& e) const noexcept {
    e.left_from = steps_.front().right;
    e.left_to = steps_.back().left;
    for (const step& s : steps_)
      if (orient2d(e.left_from, e.left_to, s.right) >= 0) e.left_from = s.right;
  }
  constexpr void turn_left(extremes& e) const noexcept {
    e.right_from = steps_.front().left;
    e.right_to = steps_.back().right;
    for (const step& s : steps_)
      if (orient2d(e.right_from, e.right_to, s.left) <= 0) e.right_from = s.left;
  }

  std::vector<step> steps_;
};

}  // namespace IRG_ABI

namespace detail::inline IRG_COMPILED_ABI {

template <class Sets, Floating T>
IRG_API Sets sets_seen(const door_lists<T>& lists, const visible_set_options& options);
template <class Sets, Floating T>
IRG_API Sets sets_connected(const door_lists<T>& lists, std::uint32_t most_portals);

}  // namespace detail::inline IRG_COMPILED_ABI

inline namespace IRG_ABI {

/// For each cell the cells of which something can be seen from somewhere in it, itself among them.
/// shape   a point is seen from another when the segment between them passes portals only and touches no wall, nor an
///         end of one; cells are seen when a point within is
/// needs   a plan without defects (validate)
/// gives   too much, never too little, where a search would look at more than options.most_doors doorways: what is
///         connected, and such cells are counted
/// exact   for all finite coordinates; symmetric
/// cost    for each cell the sequences of portals that lines from it pass, times the doors of a cell and the length of
///         the sequence; allocates the result, a bit for each pair of cells
/// source  Airey 1990; Teller and Sequin 1991
template <Floating T>
[[nodiscard]] constexpr visible_sets potentially_visible(const portal_graph<T>& graph,
                                                         const visible_set_options& options = {}) {
  return detail::sets_seen<visible_sets>(detail::portal_lists::of(graph), options);
}

/// The same for a plan.
template <Floating T>
[[nodiscard]] constexpr visible_sets potentially_visible(const cell_plan<T>& plan,
                                                         const visible_set_options& options = {}) {
  return potentially_visible(portal_graph<T>(plan), options);
}

/// The cells that a number of portals or fewer lead to, whatever the walls hide: what sight through portals is judged
/// against.
/// shape   as potentially_visible
/// cost    a pass over the portals for each cell
template <Floating T>
[[nodiscard]] constexpr visible_sets connected_cells(const portal_graph<T>& graph, std::uint32_t most_portals) {
  return detail::sets_connected<visible_sets>(detail::portal_lists::of(graph), most_portals);
}

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// Marks the cells that at most so many portals lead to from the cell of a row; none is marked before.
template <Floating T>
constexpr void mark_connected(const door_lists<T>& lists, int row, std::uint32_t most_portals, cell_grid& seen) {
  std::vector<std::uint32_t> reached(1, static_cast<std::uint32_t>(row));
  seen.set({row, row, 0});
  for (std::size_t first = 0, depth = 0; first < reached.size() && depth < most_portals; ++depth)
    for (const std::size_t last = reached.size(); first < last; ++first)
      for (const doorway<T>& d : doors_at(lists, reached[first]))
        if (const cell3 at{static_cast<int>(d.to), row, 0}; !seen.is_full(at)) {
          seen.set(at);
          reached.push_back(d.to);
        }
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <class Sets, Floating T>
IRG_API Sets sets_seen(const door_lists<T>& lists, const visible_set_options& options) {
  const auto cells = static_cast<int>(lists.first.size() - 1);
  Sets out{cell_grid(grid_extent{cells, cells, 1}), 0};
  stabbing_lines<T> lines;
  for (int row = 0; row < cells; ++row) {
    const auto enter = [&](const doorway<T>& d) {
      if (!lines.passes(d)) return false;
      lines.enter(d);
      out.seen.set({static_cast<int>(d.to), row, 0});
      return true;
    };
    out.seen.set({row, row, 0});
    if (walk_ways(
            static_cast<std::uint32_t>(row), options.most_doors, [&](std::uint32_t c) { return doors_at(lists, c); },
            enter, [&] { lines.leave(); }))
      continue;
    while (lines.size() > 0) lines.leave();
    for (int c = 0; c < cells; ++c) out.seen.set({c, row, 0}, false);
    mark_connected(lists, row, no_index, out.seen);
    ++out.unfinished;
  }
  return out;
}

template <class Sets, Floating T>
IRG_API Sets sets_connected(const door_lists<T>& lists, std::uint32_t most_portals) {
  const auto cells = static_cast<int>(lists.first.size() - 1);
  Sets out{cell_grid(grid_extent{cells, cells, 1}), 0};
  for (int row = 0; row < cells; ++row) mark_connected(lists, row, most_portals, out.seen);
  return out;
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
