// SPDX-License-Identifier: MIT
// Cells and portals in space: convex cells of any kind, and the flat convex openings between them. Which cells may be
// seen from which, and what an eye sees: too much, never too little.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <irg/core/function_ref.hpp>
#include <irg/math/vec.hpp>
#include <irg/visibility/potentially_visible.hpp>
#include <irg/visibility/space_plan.hpp>
#if IRG_BODIES
#include <irg/core/contraction.hpp>
#include <irg/core/conversion.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/orient3d.hpp>
#include <irg/spatial/cell_grid.hpp>
#include <irg/visibility/detail/space_blockers.hpp>
#include <irg/visibility/view_through_portals.hpp>
#endif

namespace irg {
inline namespace IRG_COMPILED_ABI {

/// For each cell the cells of which something may be seen from somewhere in it, itself among them.
/// shape   as potentially_visible of plans in the plane; symmetric
/// needs   a plan without defects, fewer than 2^31 cells
/// gives   exactly what lines see that pass portals within their edges, and too much, never too little, where it says
///         so: ways on which it finds neither a line nor that there is none in options.most_parts parts, as where lines
///         touch edges only, are held to be open and counted; where a search would look at more than options.most_doors
///         portals it gives all cells that see this one, and such searches are counted
/// exact   lines are found by signs, and none is ruled out but by signs and bounds of what rounding does. With
///         coordinates above 2^300, or all below 2^-300, the middle one of each three portals on a way meets the hull
///         of the others, and ways are counted as undecided
/// cost    for each sequence of portals that is tried the pairs of portals before, each the planes through three of
///         their corners, and a part of the search for a line, seldom more than one. At most most_doors times
///         most_parts of them for each cell
/// source  Teller and Sequin 1991, with a search for their stabbing lines
template <Floating T>
[[nodiscard]] IRG_API visible_sets potentially_visible(const space_plan<T>& plan,
                                                       const visible_set_options& options = {});

}  // namespace IRG_COMPILED_ABI

inline namespace IRG_ABI {

/// Calls sink(cell) for each cell that an eye may see and each way on which it may, its own cell first.
/// needs   a plan without defects; the cell that holds the eye, which is finite
/// gives   too much, never too little, of what is seen within the edges of portals: each two portals on a way are seen
///         through one another. Nothing through a portal in whose plane the eye is
/// exact   for all finite coordinates
/// cost    the edges times the corners of each two portals on a way
/// source  Luebke and Georges 1995
template <Floating T, class Sink>
  requires std::invocable<Sink&, std::uint32_t>
constexpr void view_through_portals(const space_plan<T>& plan, std::uint32_t cell, const point<T, 3>& eye, Sink&& sink);

}  // namespace IRG_ABI

namespace detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API void send_cells_seen(const space_plan<T>& plan, std::uint32_t cell, const point<T, 3>& eye,
                             const function_ref<void(std::uint32_t)>& sink);

}  // namespace detail::inline IRG_COMPILED_ABI

inline namespace IRG_ABI {

template <Floating T, class Sink>
  requires std::invocable<Sink&, std::uint32_t>
constexpr void view_through_portals(const space_plan<T>& plan, std::uint32_t cell, const point<T, 3>& eye,
                                    Sink&& sink) {
  detail::send_cells_seen(plan, cell, eye, as_function<void(std::uint32_t)>(sink));
}

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// Ways through the doors of a plan in space, for potentially_visible and view_through_portals.

// A portal as one passes it.
template <Floating T>
struct space_doorway {
  std::uint32_t to = 0;
  std::vector<point<T, 3>> ring{};
};

// The doors of each cell.
template <Floating T>
using space_doors = std::vector<std::vector<space_doorway<T>>>;

template <Floating T>
constexpr space_doors<T> doors_of(const space_plan<T>& plan) {
  space_doors<T> doors(plan.cells.size(), std::vector<space_doorway<T>>{});
  for (const auto& p : plan.portals) {
    std::vector<point<T, 3>> ring;
    for (const auto& v : p.ring)
      if (ring.empty() || (!(v == ring.back()) && !(v == ring[0]))) ring.push_back(v);
    if (ring.size() < 3) continue;
    doors[p.first].push_back({p.second, ring});
    std::reverse(ring.begin(), ring.begin() + 3);  // its first three corners tell its plane, the last may not
    std::reverse(ring.begin() + 3, ring.end());
    doors[p.second].push_back({p.first, std::move(ring)});
  }
  return doors;
}

// Calls sink(cell) for each cell on a way; may_pass(passed, door) says whether it goes on. False when more than
// most_doors were looked at.
template <Floating T, class MayPass, class Sink>
constexpr bool walk_doors(const space_doors<T>& doors, std::uint32_t cell, std::uint64_t most_doors,
                          const MayPass& may_pass, Sink& sink) {
  std::vector<const space_doorway<T>*> passed;
  sink(cell);
  const auto enter = [&](const space_doorway<T>& d) {
    if (!may_pass(passed, d)) return false;
    passed.push_back(&d);
    sink(d.to);
    return true;
  };
  const auto doors_of_cell = [&](std::uint32_t c) -> const auto& { return doors[c]; };
  return walk_ways(cell, most_doors, doors_of_cell, enter, [&] { passed.pop_back(); });
}

// Whether each two of some doors and one more may be passed by a line.
template <Floating T>
constexpr bool face_each_other(const std::vector<const space_doorway<T>*>& passed, const space_doorway<T>& d) noexcept {
  for (const auto* before : passed)
    if (are_on_side<T>(before->ring, d.ring, 1) || are_on_side<T>(d.ring, before->ring, -1)) return false;
  return true;
}

// Whether no door misses the hull of one before it and one after them all.
template <Floating T>
constexpr bool meet_hulls(const std::vector<const space_doorway<T>*>& passed, const space_doorway<T>& d) {
  for (std::size_t i = 0; i + 1 < passed.size(); ++i) {
    std::vector<point<T, 3>> both = passed[i]->ring;
    both.insert(both.end(), d.ring.begin(), d.ring.end());
    for (std::size_t k = i + 1; k < passed.size(); ++k)
      if (are_parted<T>(both, passed[k]->ring)) return false;
  }
  return true;
}

// Whether a straight line passes a sequence of flat convex openings within their edges. It joins a place of the first
// to one of the last; the pairs of places are cut into parts until a line is found, which is proved by exact signs, or
// no part is left. A part is left out when for some edges, each as often as it takes, the volumes that its lines span
// with them sum to nothing positive: lines within all edges span positive ones. Volumes are linear in each of both
// places, so corners of the part tell.

template <Floating T>
struct space_opening {
  std::vector<point<double, 3>> ring{};
  bool is_moderate = false;
  int u = 0, v = 1, w = 2;  // in coordinates u and v it has an area, the greatest or nearly
};

struct space_line {
  point<double, 3> from{}, to{};
};

// Rectangles around parts of the first and the last opening.
struct end_rectangles {
  double low[2][2]{}, high[2][2]{};
};

template <Floating T>
struct space_stabbing {
  std::size_t most_parts;
  std::vector<space_opening<T>> openings{};
  std::vector<space_line> lines{};  // that pass the openings up to each
  std::vector<end_rectangles> parts{};  // to be searched
  std::vector<double> most{};  // a row for each edge, of what corners span with it at most, by columns of pairs
};

template <Floating T>
constexpr bool are_moderate(const space_stabbing<T>& s) noexcept {
  for (const auto& o : s.openings)
    if (!o.is_moderate) return false;
  return true;
}

template <Floating T>
constexpr bool choose_axes(space_opening<T>& o) noexcept {
  double greatest = 0, area = -1;
  for (const auto& v : o.ring)
    for (int i = 0; i < 3; ++i) greatest = maximum(greatest, magnitude(v[i]));
  if (!(0x1p-300 < greatest && greatest < 0x1p300)) return false;
  for (int w = 0; w < 3; ++w) {
    const int u = (w + 1) % 3, v = (w + 2) % 3;
    double twice = 0;
    for (std::size_t i = 1; i + 1 < o.ring.size(); ++i) {
      const point<double, 3>&p = o.ring[0], &q = o.ring[i], &r = o.ring[i + 1];
      twice += product(q[u] - p[u], r[v] - p[v]) - product(q[v] - p[v], r[u] - p[u]);
    }
    const point<double, 2> a{o.ring[0][u], o.ring[0][v]}, b{o.ring[1][u], o.ring[1][v]}, c{o.ring[2][u], o.ring[2][v]};
    if (orient2d(a, b, c) == 0 || magnitude(twice) <= area) continue;
    area = magnitude(twice);
    o.u = u;
    o.v = v;
    o.w = w;
  }
  return area >= 0;
}

// The place of an opening's plane with two of its coordinates, nearly.
template <Floating T>
constexpr point<double, 3> lift(const space_opening<T>& o, double u, double v) noexcept {
  const point<double, 3>&p = o.ring[0], &q = o.ring[1], &r = o.ring[2];
  const double qu = q[o.u] - p[o.u], qv = q[o.v] - p[o.v], qw = q[o.w] - p[o.w];
  const double ru = r[o.u] - p[o.u], rv = r[o.v] - p[o.v], rw = r[o.w] - p[o.w];
  const double area = product(qu, rv) - product(qv, ru), du = u - p[o.u], dv = v - p[o.v];
  point<double, 3> out{};
  out[o.u] = u;
  out[o.v] = v;
  out[o.w] = p[o.w];
  if (area == 0) return out;
  const double s = (product(du, rv) - product(dv, ru)) / area, t = (product(qu, dv) - product(qv, du)) / area;
  out[o.w] += product(s, qw) + product(t, rw);
  return out;
}

// Appends points in whose hull the plane's place is: one, or two on both sides. False when none are found.
template <Floating T>
constexpr bool add_lifted(const space_opening<T>& o, double u, double v, std::vector<point<double, 3>>& out) {
  const point<double, 3> at = lift(o, u, v);
  const auto side = [&](const point<double, 3>& p) { return orient3d(o.ring[0], o.ring[1], o.ring[2], p); };
  if (!(magnitude(at[o.w]) < 0x1p350)) return false;
  if (side(at) == 0) return out.push_back(at), true;
  double scale = 0;
  for (const auto& p : o.ring) scale = maximum(scale, magnitude(p[o.w] - at[o.w]) + magnitude(p[o.w]));
  for (double off = 0x1p-51; off < 1; off *= 8) {
    point<double, 3> above = at, below = at;
    above[o.w] += off * scale;
    below[o.w] -= off * scale;
    if (side(above) * side(below) > 0) continue;
    out.push_back(below);
    out.push_back(above);
    return true;
  }
  return false;
}

template <Floating T>
constexpr const space_opening<T>& end_opening(const space_stabbing<T>& s, int which) noexcept {
  return which == 0 ? s.openings.front() : s.openings.back();
}

constexpr double halfway(double a, double b) noexcept { return a + (b - a) / 2; }

template <Floating T>
constexpr space_line middle_line(const space_stabbing<T>& s, const end_rectangles& p) noexcept {
  const auto middle = [&](int which) {
    return lift(end_opening(s, which), halfway(p.low[which][0], p.high[which][0]),
                halfway(p.low[which][1], p.high[which][1]));
  };
  return {middle(0), middle(1)};
}

// Whether a line passes all openings.
template <Floating T>
constexpr bool passes_all(const space_stabbing<T>& s, const space_line& l) noexcept {
  for (const auto& o : s.openings)
    for (std::size_t i = 0; i < o.ring.size(); ++i)
      if (orient3d(l.from, o.ring[i + 1 < o.ring.size() ? i + 1 : 0], o.ring[i], l.to) <= 0) return false;
  return true;
}

// No less than the volume that a line from p to q spans with an edge from a to b, and not above 0 where it is not.
template <Floating T>
constexpr double most_volume(const point<double, 3>& p, const point<double, 3>& q, const point<double, 3>& a,
                             const point<double, 3>& b) noexcept {
  double x[3][3]{};
  for (int i = 0; i < 3; ++i) {
    x[0][i] = b[i] - p[i];
    x[1][i] = a[i] - p[i];
    x[2][i] = q[i] - p[i];
  }
  double sum = 0, size = 0;
  for (int i = 0; i < 3; ++i) {
    const double left = product(x[0][(i + 1) % 3], x[1][(i + 2) % 3]);
    const double right = product(x[0][(i + 2) % 3], x[1][(i + 1) % 3]);
    sum += product(left - right, x[2][i]);
    size += product(magnitude(left) + magnitude(right), magnitude(x[2][i]));
  }
  const double error = 0x1p-48 * size + 0x1p-1000;  // more than rounding and what is too small for doubles
  if (sum > error || sum < -error) return sum + error;
  return orient3d(p, b, a, q) > 0 ? 2 * error : 0;
}

// Two players in turn take the edge that is worst for the corners taken so far, and the corner that is best for the
// edges: their shares tend to the sums that tell.
// source  Brown 1951
template <Floating T>
constexpr bool sums_to_nothing(const space_stabbing<T>& s, const std::vector<point<double, 3>>& from,
                               const std::vector<point<double, 3>>& to, space_line& guess) {
  const std::size_t columns = from.size() * to.size(), rows = s.most.size() / columns;
  std::vector<double> of_edges(columns, 0.0), size(columns, 0.0), of_corners(rows, 0.0), share(columns, 0.0);
  std::size_t corner = 0;
  for (int turn = 0; turn < 96; ++turn) {
    share[corner] += 1;
    std::size_t edge = 0;
    for (std::size_t r = 0; r < rows; ++r) {
      of_corners[r] += s.most[r * columns + corner];
      if (of_corners[r] < of_corners[edge]) edge = r;
    }
    if (turn > 8 && of_corners[edge] > 0 && turn % 8 == 0) break;
    bool is_nothing = true;
    corner = 0;
    for (std::size_t c = 0; c < columns; ++c) {
      const double here = s.most[edge * columns + c];
      of_edges[c] += here;
      size[c] += magnitude(here);
      is_nothing = is_nothing && of_edges[c] <= -0x1p-40 * size[c];
      if (of_edges[c] > of_edges[corner]) corner = c;
    }
    if (is_nothing) return true;
  }
  guess = {};
  double all = 0;
  for (std::size_t c = 0; c < columns; ++c) all += share[c];
  for (std::size_t c = 0; c < columns; ++c)
    for (int i = 0; i < 3; ++i) {
      guess.from[i] += product(share[c] / all, from[c / to.size()][i]);
      guess.to[i] += product(share[c] / all, to[c % to.size()][i]);
    }
  return false;
}

// Whether no line from one list of corners' hull to the other passes all openings, as far as sums of volumes tell;
// otherwise a line that may.
template <Floating T>
constexpr bool misses_some(space_stabbing<T>& s, const std::vector<point<double, 3>>& from,
                           const std::vector<point<double, 3>>& to, space_line& guess) {
  const std::size_t columns = from.size() * to.size();
  std::size_t rows = 0;
  s.most.clear();
  for (const auto& o : s.openings)
    for (std::size_t i = 0; i < o.ring.size(); ++i, ++rows) {
      double greatest = 0;
      bool is_outside = true;
      for (const auto& p : from)
        for (const auto& q : to) {
          s.most.push_back(most_volume<T>(p, q, o.ring[i], o.ring[i + 1 < o.ring.size() ? i + 1 : 0]));
          is_outside = is_outside && s.most.back() <= 0;
          greatest = maximum(greatest, magnitude(s.most.back()));
        }
      if (is_outside) return true;
      for (std::size_t c = 0; c < columns; ++c) s.most[rows * columns + c] /= greatest;
    }
  return sums_to_nothing(s, from, to, guess);
}

// Cuts a part in two where it is widest.
template <Floating T>
constexpr bool cut_ends(space_stabbing<T>& s, const end_rectangles& p) {
  int which = 0, k = 0;
  for (int i = 0; i < 2; ++i)
    for (int n = 0; n < 2; ++n)
      if (p.high[i][n] - p.low[i][n] > p.high[which][k] - p.low[which][k]) {
        which = i;
        k = n;
      }
  const double at = halfway(p.low[which][k], p.high[which][k]);
  if (!(p.low[which][k] < at && at < p.high[which][k])) return false;
  end_rectangles below = p, above = p;
  below.high[which][k] = above.low[which][k] = at;
  s.parts.push_back(below);
  s.parts.push_back(above);
  return true;
}

// Whether a line passes them all. Nothing where that was not found out with so many parts, or coordinates are above
// 2^300, or all of an opening below 2^-300.
template <Floating T>
constexpr std::optional<bool> is_passed(space_stabbing<T>& s) {
  if (!are_moderate(s)) return std::nullopt;
  end_rectangles whole;
  for (int which = 0; which < 2; ++which) {
    const space_opening<T>& o = end_opening(s, which);
    for (int k = 0; k < 2; ++k) {
      const int axis = k == 0 ? o.u : o.v;
      whole.low[which][k] = whole.high[which][k] = o.ring[0][axis];
      for (const auto& v : o.ring) {
        whole.low[which][k] = minimum(whole.low[which][k], v[axis]);
        whole.high[which][k] = maximum(whole.high[which][k], v[axis]);
      }
    }
  }
  s.parts.assign(1, whole);
  std::vector<point<double, 3>> corners[2];
  for (std::size_t count = 0; !s.parts.empty(); ++count) {
    if (count == s.most_parts) return std::nullopt;
    const end_rectangles p = s.parts.back();
    s.parts.pop_back();
    for (int which = 0; which < 2; ++which) {
      corners[which].clear();
      for (const double u : {p.low[which][0], p.high[which][0]})
        for (const double v : {p.low[which][1], p.high[which][1]})
          if (!add_lifted(end_opening(s, which), u, v, corners[which])) return std::nullopt;
    }
    space_line guess;
    if (misses_some(s, corners[0], corners[1], guess)) continue;
    for (const space_line& l : {guess, middle_line(s, p)})
      if (passes_all(s, l)) {
        s.lines.back() = l;
        return true;
      }
    if (!cut_ends(s, p)) return std::nullopt;
  }
  return false;
}

template <Floating T>
constexpr void enter_opening(space_stabbing<T>& s, const std::vector<point<T, 3>>& ring) {
  space_opening<T> o;
  for (const auto& v : ring) o.ring.push_back({widened(v.x), widened(v.y), widened(v.z)});
  o.is_moderate = choose_axes(o);
  s.openings.push_back(std::move(o));
  s.lines.push_back(s.lines.empty() ? space_line{} : s.lines.back());
}

// Whether the line that passed all but the last one passes that, too.
template <Floating T>
constexpr bool is_passed_as_before(const space_stabbing<T>& s) noexcept {
  return s.openings.size() < 2 || (are_moderate(s) && passes_all(s, s.lines.back()));
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API void send_cells_seen(const space_plan<T>& plan, std::uint32_t cell, const point<T, 3>& eye,
                             const function_ref<void(std::uint32_t)>& sink) {
  if (cell >= plan.cells.size()) return;
  const auto may_pass = [&](const auto& passed, const space_doorway<T>& d) {
    if (orient3d(d.ring[0], d.ring[1], d.ring[2], eye) <= 0) return false;
    for (const auto* before : passed)
      if (!seen_through_both(eye, before->ring, d.ring)) return false;
    return true;
  };
  walk_doors(doors_of(plan), cell, ~std::uint64_t{0}, may_pass, sink);
}
}  // namespace irg::detail::inline IRG_COMPILED_ABI

namespace irg::inline IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API visible_sets potentially_visible(const space_plan<T>& plan, const visible_set_options& options) {
  const auto cells = static_cast<int>(plan.cells.size());
  visible_sets out{cell_grid(grid_extent{cells, cells, 1}), 0, 0};
  const detail::space_doors<T> doors = detail::doors_of(plan);
  for (int row = 0; row < cells; ++row) {
    detail::space_stabbing<T> lines{options.most_parts};
    const auto may_pass = [&](const auto& passed, const detail::space_doorway<T>& d) {
      if (!detail::face_each_other(passed, d)) return false;
      lines.openings.resize(passed.size(), detail::space_opening<T>{});
      lines.lines.resize(passed.size(), detail::space_line{});
      detail::enter_opening(lines, d.ring);
      if (detail::is_passed_as_before(lines)) return true;
      if (!detail::meet_hulls(passed, d)) return false;
      const auto is_passed = detail::is_passed(lines);
      if (!is_passed) ++out.undecided;
      return is_passed.value_or(true);
    };
    const auto see = [&](std::uint32_t c) { out.seen.set({static_cast<int>(c), row, 0}); };
    if (detail::walk_doors(doors, static_cast<std::uint32_t>(row), options.most_doors, may_pass, see)) continue;
    for (std::uint32_t c = 0; c < plan.cells.size(); ++c) see(c);
    ++out.unfinished;
  }
  for (int row = 0; row < cells; ++row)  // what one way rules out is not seen the other way
    for (int c = 0; c < row; ++c)
      for (const cell3& at : {cell3{c, row, 0}, cell3{row, c, 0}})
        if (!out.seen.is_full({at.y, at.x, 0})) out.seen.set(at, false);
  return out;
}

}  // namespace irg::inline IRG_COMPILED_ABI
#endif
