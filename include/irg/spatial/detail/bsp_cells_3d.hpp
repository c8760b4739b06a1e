// SPDX-License-Identifier: MIT
// How a BSP tree in space grows, and how a cell is divided: by which plane, and which pieces lie where. While the tree
// grows a piece that was cut also has its corners, rounded, with bounds of what they are off by and with the planes
// that meet in each: these decide where the bound leaves it open.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <irg/core/contract.hpp>
#include <irg/core/conversion.hpp>
#include <irg/geometry/orient3d.hpp>
#include <irg/geometry/parametric_line.hpp>
#include <irg/geometry/side_of_meeting.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/exact/sign_of.hpp>
#include <irg/math/vec.hpp>
#include <irg/spatial/bsp_data_3d.hpp>
#include <irg/spatial/detail/growing_bsp_3d.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

IRG_INLINE constexpr rounded_plane plane_of_corners(const double (&a)[3], const double (&b)[3],
                                                    const double (&c)[3]) noexcept {
  double u[3]{}, v[3]{}, s = 0;
  for (int k = 0; k < 3; ++k) {
    u[k] = b[k] - a[k];
    v[k] = c[k] - a[k];
    s = maximum(s, maximum(magnitude(u[k]), magnitude(v[k])));
  }
  rounded_plane p{{product(u[1], v[2]) - product(u[2], v[1]), product(u[2], v[0]) - product(u[0], v[2]),
                   product(u[0], v[1]) - product(u[1], v[0])},
                  {a[0], a[1], a[2]},
                  s > 0x1p-300 && s < 0x1p300 ? 0x1p-47 * product(s, s) : infinity<double>,
                  0};
  p.size = 1.01 * (magnitude(p.normal[0]) + magnitude(p.normal[1]) + magnitude(p.normal[2]));
  return p;
}

// Perpendicular to an axis. Its value is a difference, whose sign rounding leaves right.
IRG_INLINE constexpr rounded_plane plane_across(int axis, const double (&at)[3]) noexcept {
  rounded_plane p{{0, 0, 0}, {at[0], at[1], at[2]}, 0, 1.01};
  p.normal[axis] = 1;
  return p;
}

}  // namespace IRG_ABI

// A corner of a piece, and what its next side lies on: side 0 to 2 of its triangle, or 3 + a node for that one's plane.
struct piece_corner {
  double at[3];
  double off;
  std::uint32_t next_side;
};

inline namespace IRG_ABI {

template <class T>
IRG_INLINE constexpr void copy_widened(const point<T, 3>& p, double (&to)[3]) noexcept {
  for (int k = 0; k < 3; ++k) to[k] = widened(p[k]);
}

template <class T>
constexpr rounded_plane plane_of(const bsp_data_3d<T>& d, const bsp_plane_3d& plane) noexcept {
  double a[3], b[3], c[3];
  if (plane.axis != bsp_plane_3d::of_triangle) {
    copy_widened(d.vertices[plane.source], a);
    return plane_across(static_cast<int>(plane.axis), a);
  }
  const auto& [v] = d.triangles[plane.source];
  copy_widened(d.vertices[v[0]], a);
  copy_widened(d.vertices[v[1]], b);
  copy_widened(d.vertices[v[2]], c);
  return plane_of_corners(a, b, c);
}

template <class T>
constexpr plane_points<T> points_of(const bsp_data_3d<T>& d, const bsp_plane_3d& plane) noexcept {
  if (plane.axis == bsp_plane_3d::of_triangle) {
    const auto& [v] = d.triangles[plane.source];
    return {d.vertices[v[0]], d.vertices[v[1]], d.vertices[v[2]]};
  }
  const int axis = static_cast<int>(plane.axis), next = (axis + 1) % 3, last = (axis + 2) % 3;
  const T at = d.vertices[plane.source][axis], unit = at < T(0) ? -at : T(0) < at ? at : T(1);
  plane_points<T> p;
  p.a[axis] = p.b[axis] = p.c[axis] = at;
  p.b[next] = unit;
  p.c[last] = unit;
  return p;
}

// A plane through a side of a triangle, not that of the triangle.
template <class T>
constexpr plane_points<T> points_of_side(const bsp_data_3d<T>& d, std::uint32_t triangle, std::uint32_t side) noexcept {
  const auto& [v] = d.triangles[triangle];
  const point<T, 3>&a = d.vertices[v[side]], &b = d.vertices[v[(side + 1) % 3]], &c = d.vertices[v[(side + 2) % 3]];
  plane_points<T> p{a, b, a};
  for (int k = 0; k < 3; ++k) {
    p.c = a;
    p.c[k] = a[k] == T(0) ? T(1) : T(0);
    if (orient3d(a, b, c, p.c) != 0) break;
  }
  return p;
}

}  // namespace IRG_ABI

// The plane of a node.
struct dividing_node {
  std::uint32_t number;
  const rounded_plane& plane;
};

// Where the pieces of a cell go.
struct cell_sides {
  std::vector<open_piece>&front, &back, &on;
};

struct best_plane {
  bsp_plane_3d plane;
  std::size_t cost;
};

struct plane_costs {
  std::size_t judges, cut;
};

template <Floating T>
struct bsp_cells_3d {
  bsp_data_3d<T>& d;
  std::vector<piece_corner> corners{};  // of all pieces that were cut
  std::vector<piece_corner> ring{};  // of the piece that is cut, with their sides
  std::vector<int> side{};
};

inline namespace IRG_ABI {

// Whether a piece reaches across its cell: no side of its triangle is left. Its plane cuts what goes through it
// alone, so that it makes no cut that is not needed (Paterson and Yao 1990).
template <Floating T>
constexpr bool reaches_across(const bsp_cells_3d<T>& cells, const open_piece& p) noexcept {
  if (p.count == 0) return false;
  for (std::uint32_t k = 0; k < p.count; ++k)
    if (cells.corners[p.first + k].next_side < 3) return false;
  return true;
}

template <Floating T>
constexpr int side_of_vertex(const bsp_cells_3d<T>& cells, std::uint32_t v, const dividing_node& by) noexcept {
  const bsp_plane_3d& plane = cells.d.nodes[by.number].plane;
  if (plane.axis == bsp_plane_3d::of_triangle) {
    const auto& [of] = cells.d.triangles[plane.source];
    if (v == of[0] || v == of[1] || v == of[2]) return 0;
  }
  double at[3];
  copy_widened(cells.d.vertices[v], at);
  const int sure = by.plane(at, 0.0).sign();
  return sure != 0 ? sure : exact_side(cells.d, plane, cells.d.vertices[v]);
}

// Where a side crosses a plane. With values f and g at its ends of different signs, off by at most e, the share
// f / (f - g) of the way is off by at most e / |f - g|, and some roundings.
constexpr piece_corner crossing_corner(const piece_corner& a, const piece_corner& b, const rounded_plane& plane) {
  const bounded_value f = plane(a.at, a.off), g = plane(b.at, b.off);
  const double whole = f.value - g.value, share = f.value / whole;
  piece_corner c{{}, 0.0, 0};
  double length = 0, size = 0;
  for (int k = 0; k < 3; ++k) {
    const double way = b.at[k] - a.at[k];
    c.at[k] = a.at[k] + product(share, way);
    length = maximum(length, magnitude(way));
    size = maximum(size, maximum(magnitude(a.at[k]), magnitude(b.at[k])));
  }
  const double off = maximum(f.bound, g.bound) / magnitude(whole) + 0x1p-50;
  c.off = 1.01 * (maximum(a.off, b.off) + product(length, off) + product(size, 0x1p-50)) + 0x1p-1000;
  return c;
}

// The part of a ring at one side of the plane that cuts it.
template <Floating T>
constexpr open_piece cut_piece(bsp_cells_3d<T>& cells, const open_piece& p, int keep, const dividing_node& by) {
  const auto first = static_cast<std::uint32_t>(cells.corners.size());
  const std::size_t n = cells.ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = i + 1 < n ? i + 1 : 0;
    const int here = cells.side[i] * keep, there = cells.side[next] * keep;
    if (here >= 0) cells.corners.push_back(cells.ring[i]);
    if (here == 0 && there < 0) cells.corners.back().next_side = by.number + 3;
    if (here * there >= 0) continue;
    cells.corners.push_back(crossing_corner(cells.ring[i], cells.ring[next], by.plane));
    cells.corners.back().next_side = here > 0 ? by.number + 3 : cells.ring[i].next_side;
  }
  const auto limit = static_cast<std::uint32_t>(cells.d.limits.size());
  cells.d.limits.push_back({by.number, keep, p.limits});
  return {p.triangle, limit, first, static_cast<std::uint32_t>(cells.corners.size()) - first};
}

template <Floating T>
constexpr int side_of_corner(const bsp_cells_3d<T>& cells, std::uint32_t triangle, std::size_t i,
                             const std::array<int, 3>& at, const dividing_node& by) {
  const std::uint32_t last = cells.ring[i == 0 ? cells.ring.size() - 1 : i - 1].next_side,
                      next = cells.ring[i].next_side;
  if (last < 3 && next < 3) return at[next];
  const int sure = by.plane(cells.ring[i].at, cells.ring[i].off).sign();
  if (sure != 0) return sure;
  const auto points = [&](std::uint32_t side) {
    return side < 3 ? points_of_side(cells.d, triangle, side) : points_of(cells.d, cells.d.nodes[side - 3].plane);
  };
  const plane_points<T> whole = points_of(cells.d, {triangle, bsp_plane_3d::of_triangle});
  return sign_of(side_of_meeting(whole, points(last), points(next), points_of(cells.d, cells.d.nodes[by.number].plane))
                     .value_or(irg::side::on));
}

// A triangle that a plane cuts: is the piece of it cut, too?
template <Floating T>
constexpr bool part_piece(bsp_cells_3d<T>& cells, const open_piece& p, const std::array<int, 3>& at,
                          const dividing_node& by, const cell_sides& to) {
  cells.ring.clear();
  cells.side.clear();
  if (p.count == 0) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      cells.ring.push_back({{}, 0.0, k});
      copy_widened(cells.d.vertices[cells.d.triangles[p.triangle].v[k]], cells.ring.back().at);
      cells.side.push_back(at[k]);
    }
  } else {
    cells.ring.assign(cells.corners.begin() + p.first, cells.corners.begin() + p.first + p.count);
    int low = 0, high = 0;
    for (std::size_t i = 0; i < cells.ring.size(); ++i) {
      cells.side.push_back(side_of_corner(cells, p.triangle, i, at, by));
      low = minimum(low, cells.side.back());
      high = maximum(high, cells.side.back());
    }
    if (low == 0 || high == 0) {
      (low == 0 ? to.front : to.back).push_back(p);
      return false;
    }
  }
  to.front.push_back(cut_piece(cells, p, 1, by));
  to.back.push_back(cut_piece(cells, p, -1, by));
  return true;
}

// How a piece lies to a plane, as far as rounded numbers tell: for the choice, which any answer leaves right.
template <Floating T>
constexpr std::pair<bool, bool> rough_sides(const bsp_cells_3d<T>& cells, const open_piece& p,
                                            const rounded_plane& plane) noexcept {
  bool front = false, back = false;
  const auto take = [&](int side) {
    front = front || side > 0;
    back = back || side < 0;
  };
  for (std::uint32_t k = 0; k < p.count; ++k)
    take(plane(cells.corners[p.first + k].at, cells.corners[p.first + k].off).sign());
  for (std::size_t k = 0; p.count == 0 && k < 3; ++k) {
    double at[3];
    copy_widened(cells.d.vertices[cells.d.triangles[p.triangle].v[k]], at);
    take(plane(at, 0.0).sign());
  }
  return {front, back};
}

// Takes a plane if it costs less. One across an axis must leave something at each side, or nothing is won.
template <Floating T>
constexpr void judge_plane(const bsp_cells_3d<T>& cells, const bsp_plane_3d& plane,
                           const std::vector<open_piece>& pieces, const plane_costs& c, best_plane& best_one) noexcept {
  const rounded_plane rounded = plane_of(cells.d, plane);
  std::size_t front = 0, back = 0, cut = 0;
  for (std::size_t i = 0; i < c.judges; ++i) {
    const auto [f, b] = rough_sides(cells, pieces[i * pieces.size() / c.judges], rounded);
    cut += f && b;
    front += f && !b;
    back += b && !f;
  }
  if (plane.axis != bsp_plane_3d::of_triangle && (front == 0 || back == 0)) return;
  const std::size_t cost = (front < back ? back - front : front - back) + cut * c.cut;
  if (cost < best_one.cost) best_one = {plane, cost};
}

// Judges some of the pieces that reach across the cell; false where there are none.
template <Floating T>
constexpr bool judge_across(const bsp_cells_3d<T>& cells, const std::vector<open_piece>& pieces, std::size_t tried,
                            const plane_costs& c, best_plane& best_one) {
  std::vector<std::uint32_t> across;
  for (const open_piece& p : pieces)
    if (reaches_across(cells, p)) across.push_back(p.triangle);
  const std::size_t some = minimum(tried, across.size());
  for (std::size_t i = 0; i < some; ++i)
    judge_plane(cells, {across[i * across.size() / some], bsp_plane_3d::of_triangle}, pieces, c, best_one);
  return some > 0;
}

// The vertex in the middle of some.
template <Floating T>
constexpr std::uint32_t median_vertex(const bsp_cells_3d<T>& cells, const std::vector<open_piece>& pieces,
                                      std::size_t judges, std::uint32_t axis) {
  std::vector<std::pair<T, std::uint32_t>> all;
  all.reserve(judges);
  for (std::size_t i = 0; i < judges; ++i) {
    const std::uint32_t v = cells.d.triangles[pieces[i * pieces.size() / judges].triangle].v[i % 3];
    all.push_back({cells.d.vertices[v][static_cast<int>(axis)], v});
  }
  std::sort(all.begin(), all.end());
  return all[all.size() / 2].second;
}

// The plane by which a cell is divided: of some that are tried the one of the least cost.
template <Floating T>
constexpr bsp_plane_3d dividing_plane(const bsp_cells_3d<T>& cells, const std::vector<open_piece>& pieces,
                                      const bsp_options& choice) {
  const std::size_t n = pieces.size(), tried = minimum(choice.candidates, n), judges = minimum(choice.judges, n);
  best_plane best_one{{pieces.front().triangle, bsp_plane_3d::of_triangle}, ~std::size_t{0}};
  if (tried > 1 && judge_across(cells, pieces, tried, {judges, choice.cut_costs}, best_one)) return best_one.plane;
  for (std::size_t i = 0; tried > 1 && i < tried; ++i)
    judge_plane(cells, {pieces[i * n / tried].triangle, bsp_plane_3d::of_triangle}, pieces, {judges, choice.cut_costs},
                best_one);
  for (std::uint32_t axis = 0; tried > 1 && n > tried && axis < 3; ++axis)
    judge_plane(cells, {median_vertex(cells, pieces, judges, axis), axis}, pieces, {judges, choice.cut_costs},
                best_one);
  return best_one.plane;
}

// Parts the pieces of a cell by the plane of a node; returns how many were cut.
template <Floating T>
constexpr std::size_t divide_cell(bsp_cells_3d<T>& cells, const std::vector<open_piece>& pieces,
                                  const dividing_node& by, const cell_sides& to) {
  std::size_t cuts = 0;
  for (const open_piece& p : pieces) {
    std::array<int, 3> at{};
    const auto& [v] = cells.d.triangles[p.triangle];
    for (std::size_t k = 0; k < 3; ++k) at[k] = side_of_vertex(cells, v[k], by);
    const int low = minimum(minimum(at[0], at[1]), at[2]), high = maximum(maximum(at[0], at[1]), at[2]);
    if (low == 0 && high == 0)
      to.on.push_back(p);
    else if (low >= 0)
      to.front.push_back(p);
    else if (high <= 0)
      to.back.push_back(p);
    else
      cuts += part_piece(cells, p, at, by, to) ? 1u : 0u;
  }
  return cuts;
}

}  // namespace IRG_ABI

// A tree that grows by adding, and goes back to what it was.

inline namespace IRG_ABI {

template <Floating T>
constexpr std::uint32_t& link_of(growing_bsp_3d<T>& tree, const bsp_link& l) noexcept {
  bsp_node_3d& n = tree.data.nodes[l.node];
  return l.where == hung::in_front ? n.front : l.where == hung::behind ? n.back : n.beside;
}

template <Floating T>
constexpr bsp_walk_step step_at(const growing_bsp_3d<T>& tree, std::uint32_t i) {
  const bsp_node_3d& n = tree.data.nodes[i];
  const bool has_one = n.beside == no_index && n.last - n.first <= 1;
  return {walked_plane(tree.planes[i]),
          {n.back, n.front},
          !has_one           ? several_pieces
          : n.first < n.last ? n.first
                             : no_index};
}

template <Floating T>
constexpr std::uint32_t make_node(growing_bsp_3d<T>& tree, bsp_plane_3d plane) {
  const auto here = static_cast<std::uint32_t>(tree.data.nodes.size());
  const auto end = static_cast<std::uint32_t>(tree.data.pieces.size());
  tree.data.nodes.push_back({plane, end, end, no_index, no_index, no_index});
  tree.planes.push_back(plane_of(tree.data, plane));
  return here;
}

template <Floating T>
constexpr void hang(growing_bsp_3d<T>& tree, std::uint32_t node, const bsp_link& at) {
  if (at.node < tree.steps.size()) tree.links.push_back(at);  // it was there before
  link_of(tree, at) = node;
}

// A new node for pieces in the plane of one that is there.
template <Floating T>
constexpr std::uint32_t make_node_beside(growing_bsp_3d<T>& tree, std::uint32_t node) {
  while (tree.data.nodes[node].beside != no_index) node = tree.data.nodes[node].beside;
  const std::uint32_t here = make_node(tree, tree.data.nodes[node].plane);
  hang(tree, here, {node, hung::beside});
  return here;
}

template <Floating T>
constexpr void put_pieces(growing_bsp_3d<T>& tree, std::uint32_t node, const std::vector<open_piece>& on) {
  for (const open_piece& p : on) tree.data.pieces.push_back({p.triangle, p.limits});
  tree.data.nodes[node].last = static_cast<std::uint32_t>(tree.data.pieces.size());
}

// The root's cell: all triangles with area.
template <Floating T>
constexpr auto take_triangles(growing_bsp_3d<T>& tree, std::span<const point<T, 3>> vertices,
                              std::span<const triangle_indices> triangles) {
  const auto base = static_cast<std::uint32_t>(tree.data.vertices.size());
  tree.data.vertices.insert(tree.data.vertices.end(), vertices.begin(), vertices.end());
  typename growing_bsp_3d<T>::open_cell all{{}, {no_index, hung::in_front}};
  for (const triangle_indices& t : triangles) {
    const auto number = static_cast<std::uint32_t>(tree.data.triangles.size());
    for (const std::uint32_t v : t.v) IRG_EXPECTS(v < vertices.size());
    tree.data.triangles.push_back({{t.v[0] + base, t.v[1] + base, t.v[2] + base}});
    if (has_area(tree.data, number))
      all.pieces.push_back({number, no_index, 0, 0});
    else
      ++tree.left_out;
  }
  return all;
}

}  // namespace IRG_ABI

inline namespace IRG_COMPILED_ABI {

template <Floating T>
IRG_NOINLINE IRG_API int exact_side(const bsp_data_3d<T>& d, const bsp_plane_3d& plane, const point<T, 3>& p) noexcept {
  if (plane.axis != bsp_plane_3d::of_triangle) {
    const T at = d.vertices[plane.source][static_cast<int>(plane.axis)], x = p[static_cast<int>(plane.axis)];
    return at < x ? 1 : x < at ? -1 : 0;
  }
  const auto& [v] = d.triangles[plane.source];
  return orient3d(d.vertices[v[0]], d.vertices[v[1]], d.vertices[v[2]], p);
}

template <Floating T>
IRG_API int side_of_direction(const bsp_data_3d<T>& d, const bsp_plane_3d& plane, const vec<T, 3>& to) noexcept {
  if (plane.axis != bsp_plane_3d::of_triangle) {
    const T x = to[static_cast<int>(plane.axis)];
    return T(0) < x ? 1 : x < T(0) ? -1 : 0;
  }
  std::array<double, 15> in{};
  std::size_t n = 0;
  for (const std::uint32_t v : d.triangles[plane.source].v)
    for (int k = 0; k < 3; ++k) in[n++] = widened(d.vertices[v][k]);
  for (int k = 0; k < 3; ++k) in[n++] = widened(to[k]);
  return irg::sign_of<3>(
      [](const auto& x) {
        const auto ux = x[3] - x[0], uy = x[4] - x[1], uz = x[5] - x[2];
        const auto vx = x[6] - x[0], vy = x[7] - x[1], vz = x[8] - x[2];
        return (uy * vz - uz * vy) * (x[9] - x[12]) + (uz * vx - ux * vz) * (x[10] - x[13]) +
               (ux * vy - uy * vx) * (x[11] - x[14]);
      },
      in);
}

template <Floating T>
IRG_API std::vector<point<T, 3>> rounded_ring(const growing_bsp_3d<T>& tree, const bsp_piece_3d& p) {
  const bsp_data_3d<T>& d = tree.data;
  std::vector<point<T, 3>> ring, kept;
  for (const std::uint32_t v : d.triangles[p.triangle].v) ring.push_back(d.vertices[v]);
  for (std::uint32_t l = p.limits; l != no_index && !ring.empty(); l = d.limits[l].next, std::swap(ring, kept)) {
    kept.clear();
    const rounded_plane& plane = tree.planes[d.limits[l].node];
    const auto height = [&](const point<T, 3>& q) {
      const double at[3] = {widened(q[0]), widened(q[1]), widened(q[2])};
      return plane(at, 0.0).value * d.limits[l].side;
    };
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const point<T, 3>&a = ring[i], &b = ring[i + 1 < ring.size() ? i + 1 : 0];
      const double f = height(a), g = height(b);
      if (f >= 0) kept.push_back(a);
      if ((f < 0 && g > 0) || (f > 0 && g < 0)) kept.push_back(point_between(a, b, converted<T>(f / (f - g))));
    }
  }
  return ring;
}

template <Floating T>
IRG_API void shrink_to(growing_bsp_3d<T>& tree, const bsp_sizes& to) {
  for (; tree.links.size() > to.links; tree.links.pop_back()) {
    link_of(tree, tree.links.back()) = no_index;
    tree.steps[tree.links.back().node] = step_at(tree, tree.links.back().node);
  }
  tree.data.vertices.resize(to.vertices, point<T, 3>{});
  tree.data.triangles.resize(to.triangles, triangle_indices{});
  tree.data.nodes.resize(to.nodes, bsp_node_3d{});
  tree.planes.erase(tree.planes.begin() + static_cast<std::ptrdiff_t>(to.nodes), tree.planes.end());
  tree.steps.erase(tree.steps.begin() + static_cast<std::ptrdiff_t>(to.nodes), tree.steps.end());
  tree.data.pieces.resize(to.pieces, bsp_piece_3d{});
  tree.data.limits.resize(to.limits, bsp_limit_3d{});
  tree.splits = to.splits;
  tree.left_out = to.left_out;
}

template <Floating T>
IRG_API void add_triangles(growing_bsp_3d<T>& tree, std::span<const point<T, 3>> vertices,
                           std::span<const triangle_indices> triangles, const bsp_options& choice) {
  using open_cell = typename growing_bsp_3d<T>::open_cell;
  IRG_EXPECTS(choice.candidates > 0 && choice.judges > 0);
  const std::size_t links_before = tree.links.size();
  bsp_cells_3d<T> cells{tree.data};
  open_cell all = take_triangles(tree, vertices, triangles);
  std::vector<open_cell> open;
  if (!all.pieces.empty()) open.push_back(std::move(all));
  std::vector<open_piece> on;
  while (!open.empty()) {
    open_cell t = std::move(open.back());
    open.pop_back();
    // The root, or what hangs where this would hang: there only before anything is added.
    std::uint32_t here = t.at.node != no_index ? link_of(tree, t.at) : tree.data.nodes.empty() ? no_index : 0;
    const bool is_new = here == no_index;
    if (is_new) {
      here = make_node(tree, dividing_plane(cells, t.pieces, choice));
      if (t.at.node != no_index) hang(tree, here, t.at);
    }
    on.clear();
    open_cell front{{}, {here, hung::in_front}}, back{{}, {here, hung::behind}};
    tree.splits += divide_cell(cells, t.pieces, {here, tree.planes[here]}, {front.pieces, back.pieces, on});
    if (!on.empty()) put_pieces(tree, is_new ? here : make_node_beside(tree, here), on);
    if (!back.pieces.empty()) open.push_back(std::move(back));
    if (!front.pieces.empty()) open.push_back(std::move(front));
  }
  for (auto i = static_cast<std::uint32_t>(tree.steps.size()); i < tree.data.nodes.size(); ++i)
    tree.steps.push_back(step_at(tree, i));
  for (std::size_t i = links_before; i < tree.links.size(); ++i)
    tree.steps[tree.links[i].node] = step_at(tree, tree.links[i].node);
}

template <Floating T>
IRG_API void make_walkable(growing_bsp_3d<T>& tree) {
  for (const bsp_node_3d& n : tree.data.nodes) tree.planes.push_back(plane_of(tree.data, n.plane));
  for (std::uint32_t i = 0; i < tree.data.nodes.size(); ++i) tree.steps.push_back(step_at(tree, i));
}

}  // namespace IRG_COMPILED_ABI
}  // namespace irg::detail
