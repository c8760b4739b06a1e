// SPDX-License-Identifier: MIT
// cells_from_bsp: walls become a plan of convex cells by themselves. The leaves of a BSP tree of the walls are the
// cells, and where two of them meet without a wall between is a portal.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <irg/geometry/box.hpp>
#include <irg/geometry/vocabulary.hpp>
#include <irg/spatial/bsp_tree_2d.hpp>
#include <irg/visibility/cell_plan.hpp>
#if IRG_BODIES
#include <irg/core/contract.hpp>
#include <irg/geometry/crossing_point.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/triangulate_ear_clipping.hpp>
#endif

namespace irg {

/// A plan that was made of walls.
template <Floating T>
struct bsp_cells {
  cell_plan<T> plan;
  std::size_t cut = 0;  ///< leaves that became triangles, because rounded corners bent them
  std::size_t left_out = 0;  ///< leaves without area when their corners are rounded
  bool operator==(const bsp_cells&) const = default;
};

inline namespace IRG_COMPILED_ABI {

/// The cells and portals of what is in a window, by a BSP tree of its walls. All cells have the heights 0 and 1.
/// needs   a tree of these walls; a window with finite corners that has an area, coordinates below 2^500
/// gives   a plan without defects, the insides of closed walls among its cells. Walls may cross, touch, overlap, and
///         reach out of the window
/// exact   which leaves there are and which meet; corners are correctly rounded, so that walls and cells may be bent by
///         half an ulp where lines cross. On lines along the axes nothing is rounded
/// cost    the sides of each leaf for each node above it; allocates the result
/// source  Airey 1990; Teller and Sequin 1991
template <Floating T>
[[nodiscard]] IRG_API bsp_cells<T> cells_from_bsp(const bsp_tree_2d<T>& tree,
                                                  std::span<const std::type_identity_t<segment<T, 2>>> walls,
                                                  const box<T, 2>& window);

}  // namespace IRG_COMPILED_ABI

inline namespace IRG_ABI {

/// The same for walls whose tree is not wanted otherwise.
template <Floating T>
[[nodiscard]] constexpr bsp_cells<T> cells_from_bsp(std::span<const segment<T, 2>> walls, const box<T, 2>& window) {
  return cells_from_bsp(bsp_tree_2d<T>(walls), walls, window);
}

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// From the leaves of a BSP tree to convex cells and portals. Leaves are lists of lines, and whether a line divides one
// is decided exactly; corners are rounded once, so that two leaves round the same corner alike. What rounding bends out
// of convexity is cut into triangles between the rounded corners.

template <Floating T>
class bsp_cell_builder {
public:
  constexpr bsp_cell_builder(const bsp_tree_2d<T>& tree, std::span<const segment<T, 2>> walls, const box<T, 2>& window)
      : tree_(tree), walls_(walls) {
    for (const auto& n : tree.nodes()) lines_.push_back(walls[n.segment]);
    const point<T, 2>&low = window.low, &high = window.high, right{high.x, low.y}, left{low.x, high.y};
    for (const segment<T, 2>& side : {segment<T, 2>{low, right}, {right, high}, {high, left}, {left, low}})
      lines_.push_back(side);
  }

  // The leaves become cells, which have no heights of their own; says how many were cut, and how many left out.
  constexpr cell_plan<T> run(std::size_t& cut, std::size_t& left_out) {
    find_leaves();
    std::vector<std::array<std::vector<stretch>, 2>> beside(tree_.nodes().size());
    for (std::uint32_t f = 0; f < leaves_.size(); ++f) note_sides(f, beside);
    for (std::uint32_t n = 0; n < beside.size(); ++n) join(n, beside[n]);
    for (std::uint32_t f = 0; f < leaves_.size(); ++f) add_cells(f, cut, left_out);
    for (const gap& g : gaps_) add_portal(g);
    return std::move(plan_);
  }

private:
  struct open_part {
    std::uint32_t node;
    std::vector<std::uint32_t> sides;
  };
  struct made_cell {
    std::uint32_t cell;
    std::array<std::uint32_t, 3> corners;
  };
  struct leaf {
    std::vector<std::uint32_t> sides{};  // lines, counter-clockwise; corner k is where sides k - 1 and k cross
    std::vector<point<T, 2>> corners{};
    std::vector<std::vector<point<T, 2>>> ends{};  // of the portals in each side
    std::uint32_t first = 0, last = 0;  // its cells
  };
  struct stretch {
    point<T, 2> a{}, b{};  // forward along the line
    std::uint32_t leaf = 0, side = 0;
  };
  struct gap {
    std::uint32_t first = 0, second = 0;
    point<T, 2> a{}, b{};
  };

  const bsp_tree_2d<T>& tree_;
  std::span<const segment<T, 2>> walls_;
  std::vector<segment<T, 2>> lines_{};  // of the nodes, then of the window
  std::vector<leaf> leaves_{};
  std::vector<gap> gaps_{};
  cell_plan<T> plan_{};

  // On which side of a line the corners of a leaf lie.
  constexpr std::vector<int> corner_sides(const std::vector<std::uint32_t>& sides, const segment<T, 2>& line) const {
    std::vector<int> out;
    for (std::size_t k = 0; k < sides.size(); ++k) {
      const std::uint32_t before = sides[k == 0 ? sides.size() - 1 : k - 1];
      out.push_back(sign_of(side_of_crossing(lines_[before], lines_[sides[k]], line).value_or(irg::side::on)));
    }
    return out;
  }

  // What of a leaf lies on one side of a line that divides it.
  static constexpr std::vector<std::uint32_t> part_of(const std::vector<std::uint32_t>& sides,
                                                      const std::vector<int>& at, std::uint32_t line, int side) {
    std::vector<std::uint32_t> out;
    for (std::size_t k = 0; k < sides.size(); ++k) {
      const int from = at[k] * side, to = at[k + 1 < sides.size() ? k + 1 : 0] * side;
      if (from > 0 || to > 0) out.push_back(sides[k]);
      if (from > 0 && to <= 0) out.push_back(line);
    }
    return out;
  }

  constexpr void find_leaves() {
    std::vector<open_part> open;
    const auto window = static_cast<std::uint32_t>(tree_.nodes().size());
    open.push_back({tree_.nodes().empty() ? no_index : 0, {window, window + 1, window + 2, window + 3}});
    while (!open.empty()) {
      const auto [n, sides] = std::move(open.back());
      open.pop_back();
      if (n == no_index) {
        leaves_.push_back(leaf{});
        leaves_.back().sides = sides;
        continue;
      }
      const bsp_node_2d& node = tree_.nodes()[n];
      const std::vector<int> at = corner_sides(sides, lines_[n]);
      const bool any_left = std::find(at.begin(), at.end(), 1) != at.end(),
                 any_right = std::find(at.begin(), at.end(), -1) != at.end();
      const bool is_divided = any_left && any_right;
      for (const int side : {-1, 1}) {
        if (side < 0 ? !any_right : !any_left) continue;
        open.push_back({side < 0 ? node.right : node.left, {}});
        if (is_divided)
          open.back().sides = part_of(sides, at, n, side);
        else
          open.back().sides = sides;
      }
    }
  }

  // Whether p comes before q along a line, both rounded from points of it: rounding keeps the order of coordinates.
  static constexpr bool comes_before(const segment<T, 2>& line, const point<T, 2>& p, const point<T, 2>& q) noexcept {
    if (p.x != q.x) return (p.x < q.x) == (line.a.x < line.b.x);
    return p.y != q.y && (p.y < q.y) == (line.a.y < line.b.y);
  }

  // Rounds the corners of a leaf, and notes what of its sides lies on the lines of nodes.
  constexpr void note_sides(std::uint32_t f, std::vector<std::array<std::vector<stretch>, 2>>& beside) {
    leaf& l = leaves_[f];
    const std::size_t n = l.sides.size();
    for (std::size_t k = 0; k < n; ++k)
      l.corners.push_back(*intersection_point(lines_[l.sides[k == 0 ? n - 1 : k - 1]], lines_[l.sides[k]]));
    l.ends.resize(n);
    for (std::uint32_t k = 0; k < n; ++k) {
      if (l.sides[k] >= beside.size()) continue;
      const segment<T, 2>& line = lines_[l.sides[k]];
      const point<T, 2>&a = l.corners[k], &b = l.corners[k + 1 < n ? k + 1 : 0];
      if (a == b) continue;
      const bool runs_forward = comes_before(line, a, b);  // with the leaf to the left of it
      beside[l.sides[k]][runs_forward ? 0 : 1].push_back({runs_forward ? a : b, runs_forward ? b : a, f, k});
    }
  }

  // The walls on the line of a node, in order.
  constexpr std::vector<segment<T, 2>> walls_on(std::uint32_t n) const {
    const bsp_node_2d& node = tree_.nodes()[n];
    std::vector<segment<T, 2>> out;
    for (std::uint32_t i = node.first; i < node.last; ++i) {
      const bsp_piece_2d& p = tree_.pieces()[i];
      const segment<T, 2>& s = walls_[p.segment];
      const point<T, 2> a = p.from == no_index ? s.a : *intersection_point(s, walls_[p.from]),
                        b = p.to == no_index ? s.b : *intersection_point(s, walls_[p.to]);
      out.push_back(comes_before(lines_[n], a, b) ? segment<T, 2>{a, b} : segment<T, 2>{b, a});
    }
    std::sort(out.begin(), out.end(), [&](const auto& u, const auto& v) { return comes_before(lines_[n], u.a, v.a); });
    return out;
  }

  // The gaps between walls on the line of a node, by the leaves on both sides.
  constexpr void join(std::uint32_t n, std::array<std::vector<stretch>, 2>& beside) {
    const auto before = [&](const point<T, 2>& p, const point<T, 2>& q) { return comes_before(lines_[n], p, q); };
    for (auto& list : beside)
      std::sort(list.begin(), list.end(), [&](const stretch& u, const stretch& v) { return before(u.a, v.a); });
    const std::vector<segment<T, 2>> walls = walls_on(n);
    for (std::size_t i = 0, k = 0; i < beside[0].size() && k < beside[1].size();) {
      const stretch &l = beside[0][i], &r = beside[1][k];
      point<T, 2> from = before(l.a, r.a) ? r.a : l.a;
      const point<T, 2> to = before(l.b, r.b) ? l.b : r.b;
      for (const auto& w : walls) {
        if (before(from, w.a)) add_gap(l, r, from, before(w.a, to) ? w.a : to);
        if (before(from, w.b)) from = w.b;
      }
      add_gap(l, r, from, to);
      (before(l.b, r.b) ? i : k) += 1;
    }
  }

  constexpr void add_gap(const stretch& l, const stretch& r, const point<T, 2>& from, const point<T, 2>& to) {
    if (!comes_before(lines_[leaves_[l.leaf].sides[l.side]], from, to)) return;
    gaps_.push_back({l.leaf, r.leaf, from, to});
    for (const stretch* s : {&l, &r})
      for (const point<T, 2>& p : {from, to}) leaves_[s->leaf].ends[s->side].push_back(p);
  }

  constexpr void add_cells(std::uint32_t f, std::size_t& cut, std::size_t& left_out) {
    leaf& l = leaves_[f];
    std::vector<point<T, 2>> ring;
    for (std::size_t k = 0; k < l.sides.size(); ++k) {
      ring.push_back(l.corners[k]);
      const segment<T, 2> side{l.corners[k], l.corners[k + 1 < l.sides.size() ? k + 1 : 0]};
      const bool is_bent = std::any_of(l.ends[k].begin(), l.ends[k].end(),
                                       [&](const point<T, 2>& p) { return orient2d(side.a, side.b, p) != 0; });
      if (!is_bent) continue;  // portals lie on it as it is
      std::sort(l.ends[k].begin(), l.ends[k].end(),
                [&](const auto& p, const auto& q) { return comes_before(side, p, q); });
      ring.insert(ring.end(), l.ends[k].begin(), l.ends[k].end());
    }
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
    l.first = l.last = static_cast<std::uint32_t>(plan_.cells.size());
    plan_cell<T> whole;
    whole.corners = ring;
    if (defect_of_cell(whole) == plan_defect::none) {
      plan_.cells.push_back(std::move(whole));
      ++l.last;
      return;
    }
    if (add_triangles(l, ring))
      ++cut;
    else
      ++left_out;
  }

  constexpr bool add_triangles(leaf& l, const std::vector<point<T, 2>>& ring) {
    if (ring.size() < 3 || orientation_of(ring) != orientation::counter_clockwise) return false;
    const auto triangles = triangulate_ear_clipping(ring);
    std::vector<made_cell> made;
    for (const auto& t : triangles) {
      plan_cell<T> c{{ring[t[0]], ring[t[1]], ring[t[2]]}};
      if (defect_of_cell(c) != plan_defect::none) continue;
      made.push_back({static_cast<std::uint32_t>(plan_.cells.size()), t});
      plan_.cells.push_back(std::move(c));
    }
    l.last = static_cast<std::uint32_t>(plan_.cells.size());
    for (std::size_t i = 0; i < made.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        for (std::size_t u = 0; u < 3; ++u)
          for (std::size_t v = 0; v < 3; ++v) {
            const std::uint32_t a = made[i].corners[u], b = made[i].corners[(u + 1) % 3];
            if (made[k].corners[v] == b && made[k].corners[(v + 1) % 3] == a)
              plan_.portals.push_back({made[i].cell, made[k].cell, ring[a], ring[b]});
          }
    return !made.empty();
  }

  // The cell of a leaf that holds a gap in one of its sides.
  constexpr std::optional<std::uint32_t> cell_at(std::uint32_t f, const gap& g) const noexcept {
    for (std::uint32_t c = leaves_[f].first; c < leaves_[f].last; ++c)
      if (side_of_wall(plan_.cells[c], g.a, g.b) != 0) return c;
    return std::nullopt;
  }

  constexpr void add_portal(const gap& g) {
    const auto first = cell_at(g.first, g), second = cell_at(g.second, g);
    if (first && second) plan_.portals.push_back({*first, *second, g.a, g.b});
  }
};

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API bsp_cells<T> cells_from_bsp(const bsp_tree_2d<T>& tree,
                                                  std::span<const std::type_identity_t<segment<T, 2>>> walls,
                                                  const box<T, 2>& window) {
  IRG_EXPECTS(window.low.x < window.high.x && window.low.y < window.high.y);
  bsp_cells<T> out;
  out.plan = detail::bsp_cell_builder<T>(tree, walls, window).run(out.cut, out.left_out);
  return out;
}

}  // namespace irg::inline IRG_COMPILED_ABI
#endif
