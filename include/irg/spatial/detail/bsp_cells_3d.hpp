// SPDX-License-Identifier: MIT
// How a cell of a BSP tree in space is divided: which plane, and which pieces lie where. While the tree grows a piece
// that was cut also has its corners, rounded, with bounds of what they are off by and with the planes that meet in
// each: these decide where the bound leaves it open.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <irg/geometry/orient3d.hpp>
#include <irg/geometry/side_of_meeting.hpp>
#include <irg/math/error_free.hpp>
#include <irg/math/exact/sign_of.hpp>
#include <irg/math/vec.hpp>
#include <irg/spatial/bsp_data_3d.hpp>

namespace irg::detail {

// A plane in rounded numbers, with a bound of what they are off by: it tells the side of most points in a few
// operations, and says so where it does not.

// A rounded value, and how far it may be off.
struct bounded_value {
  double value, bound;

  /// 1 or -1, or 0 where the bound leaves it open.
  IRG_INLINE constexpr int sign() const noexcept { return value > bound ? 1 : value < -bound ? -1 : 0; }
};

// normal . (p - at). With u = 2^-53, s the largest difference between corners along an axis and D that of p and `at`: a
// normal's coordinate is at most 2s^2 and off by less than 8.1u s^2; products with p - at and their sum are off by
// 24u s^2 D more, in all less than 49u s^2 D. `error` is 64u s^2. What subnormals lose is less than 2^-1000.
struct rounded_plane {
  double normal[3], at[3], error, size;  // size: the sum of the normal's absolute values

  // off   how far each coordinate of p may be off
  IRG_INLINE constexpr bounded_value operator()(const double (&p)[3], double off) const noexcept {
    constexpr double least = 0x1p-1000;
    const double dx = p[0] - at[0], dy = p[1] - at[1], dz = p[2] - at[2];
    const double reach = greater(greater(magnitude(dx), magnitude(dy)), magnitude(dz));
    const double value = product(normal[0], dx) + product(normal[1], dy) + product(normal[2], dz);
    return {value, product(error, reach) + product(size, off) + least};
  }
};

inline namespace IRG_ABI {

IRG_INLINE constexpr rounded_plane plane_of_corners(const double (&a)[3], const double (&b)[3],
                                                    const double (&c)[3]) noexcept {
  double u[3]{}, v[3]{}, s = 0;
  for (int k = 0; k < 3; ++k) {
    u[k] = b[k] - a[k];
    v[k] = c[k] - a[k];
    s = greater(s, greater(magnitude(u[k]), magnitude(v[k])));
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

// The same for points without error, in fewer numbers: normal . p - offset. With R the largest coordinate of p and A
// that of `at`, the products and sums of normal . p and of `offset` are off by less than 24u s^2 R and 24u s^2 A, and
// the normal by 24.3u s^2 (R + A): `error` R + `error_at` is above both.
struct walked_plane {
  double normal[3], offset, error, error_at;

  IRG_INLINE constexpr explicit walked_plane(const rounded_plane& p) noexcept
      : normal{p.normal[0], p.normal[1], p.normal[2]},
        offset(product(p.normal[0], p.at[0]) + product(p.normal[1], p.at[1]) + product(p.normal[2], p.at[2])),
        error(greater(p.error, 0x1p-50 * p.size)),
        error_at(product(error, greater(greater(magnitude(p.at[0]), magnitude(p.at[1])), magnitude(p.at[2]))) +
                 0x1p-1000) {}

  // reach   the largest coordinate of p
  IRG_INLINE constexpr bounded_value operator()(const double (&p)[3], double reach) const noexcept {
    return {product(normal[0], p[0]) + product(normal[1], p[1]) + product(normal[2], p[2]) - offset,
            product(error, reach) + error_at};
  }
};

// A piece that no node holds yet: `count` corners from `first` on, none where it is the whole triangle.
struct open_piece {
  std::uint32_t triangle, limits, first, count;
};

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

// 1, -1 or 0: in front of a plane, behind, on it.
template <class T>
IRG_NOINLINE constexpr int exact_side(const bsp_data_3d<T>& d, const bsp_plane_3d& plane,
                                      const point<T, 3>& p) noexcept {
  if (plane.axis != bsp_plane_3d::of_triangle) {
    const T at = d.vertices[plane.source][static_cast<int>(plane.axis)], x = p[static_cast<int>(plane.axis)];
    return at < x ? 1 : x < at ? -1 : 0;
  }
  const auto& [v] = d.triangles[plane.source];
  return orient3d(d.vertices[v[0]], d.vertices[v[1]], d.vertices[v[2]], p);
}

// Of a point infinitely far away.
template <class T>
constexpr int side_of_direction(const bsp_data_3d<T>& d, const bsp_plane_3d& plane, const vec<T, 3>& to) noexcept {
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

template <class T>
class IRG_APART bsp_cells_3d {
public:
  constexpr explicit bsp_cells_3d(bsp_data_3d<T>& d) : d_(d) {}

  // The plane by which a cell is divided: of some that are tried the one of the least cost.
  constexpr bsp_plane_3d dividing_plane(const std::vector<open_piece>& pieces, const bsp_choice& choice) const {
    const std::size_t n = pieces.size(), tried = lesser(choice.candidates, n), judges = lesser(choice.judges, n);
    best best_one{{pieces.front().triangle, bsp_plane_3d::of_triangle}, ~std::size_t{0}};
    if (tried > 1 && judge_across(pieces, tried, {judges, choice.cut_costs}, best_one)) return best_one.plane;
    for (std::size_t i = 0; tried > 1 && i < tried; ++i)
      judge({pieces[i * n / tried].triangle, bsp_plane_3d::of_triangle}, pieces, {judges, choice.cut_costs}, best_one);
    for (std::uint32_t axis = 0; tried > 1 && n > tried && axis < 3; ++axis)
      judge({median_vertex(pieces, judges, axis), axis}, pieces, {judges, choice.cut_costs}, best_one);
    return best_one.plane;
  }

  // Parts the pieces of a cell by the plane of a node; returns how many were cut.
  constexpr std::size_t divide(const std::vector<open_piece>& pieces, const dividing_node& by, const cell_sides& to) {
    std::size_t cuts = 0;
    for (const open_piece& p : pieces) {
      std::array<int, 3> at{};
      const auto& [v] = d_.triangles[p.triangle];
      for (std::size_t k = 0; k < 3; ++k) at[k] = side_of_vertex(v[k], by);
      const int low = lesser(lesser(at[0], at[1]), at[2]), high = greater(greater(at[0], at[1]), at[2]);
      if (low == 0 && high == 0)
        to.on.push_back(p);
      else if (low >= 0)
        to.front.push_back(p);
      else if (high <= 0)
        to.back.push_back(p);
      else
        cuts += part(p, at, by, to) ? 1u : 0u;
    }
    return cuts;
  }

private:
  struct best {
    bsp_plane_3d plane;
    std::size_t cost;
  };
  struct costs {
    std::size_t judges, cut;
  };

  // Whether a piece reaches across its cell: no side of its triangle is left. Its plane cuts what goes through it
  // alone, so that it makes no cut that is not needed (Paterson and Yao 1990).
  constexpr bool reaches_across(const open_piece& p) const noexcept {
    if (p.count == 0) return false;
    for (std::uint32_t k = 0; k < p.count; ++k)
      if (corners_[p.first + k].next_side < 3) return false;
    return true;
  }

  constexpr int side_of_vertex(std::uint32_t v, const dividing_node& by) const noexcept {
    const bsp_plane_3d& plane = d_.nodes[by.number].plane;
    if (plane.axis == bsp_plane_3d::of_triangle) {
      const auto& [of] = d_.triangles[plane.source];
      if (v == of[0] || v == of[1] || v == of[2]) return 0;
    }
    double at[3];
    copy_widened(d_.vertices[v], at);
    const int sure = by.plane(at, 0.0).sign();
    return sure != 0 ? sure : exact_side(d_, plane, d_.vertices[v]);
  }

  // A triangle that a plane cuts: is the piece of it cut, too?
  constexpr bool part(const open_piece& p, const std::array<int, 3>& at, const dividing_node& by,
                      const cell_sides& to) {
    ring_.clear();
    side_.clear();
    if (p.count == 0) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        ring_.push_back({{}, 0.0, k});
        copy_widened(d_.vertices[d_.triangles[p.triangle].v[k]], ring_.back().at);
        side_.push_back(at[k]);
      }
    } else {
      ring_.assign(corners_.begin() + p.first, corners_.begin() + p.first + p.count);
      int low = 0, high = 0;
      for (std::size_t i = 0; i < ring_.size(); ++i) {
        side_.push_back(side_of_corner(p.triangle, i, at, by));
        low = lesser(low, side_.back());
        high = greater(high, side_.back());
      }
      if (low == 0 || high == 0) {
        (low == 0 ? to.front : to.back).push_back(p);
        return false;
      }
    }
    to.front.push_back(cut(p, 1, by));
    to.back.push_back(cut(p, -1, by));
    return true;
  }

  constexpr int side_of_corner(std::uint32_t triangle, std::size_t i, const std::array<int, 3>& at,
                               const dividing_node& by) const {
    const std::uint32_t last = ring_[i == 0 ? ring_.size() - 1 : i - 1].next_side, next = ring_[i].next_side;
    if (last < 3 && next < 3) return at[next];
    const int sure = by.plane(ring_[i].at, ring_[i].off).sign();
    if (sure != 0) return sure;
    const auto points = [&](std::uint32_t side) {
      return side < 3 ? points_of_side(d_, triangle, side) : points_of(d_, d_.nodes[side - 3].plane);
    };
    const plane_points<T> whole = points_of(d_, {triangle, bsp_plane_3d::of_triangle});
    return side_of_meeting(whole, points(last), points(next), points_of(d_, d_.nodes[by.number].plane)).value_or(0);
  }

  // The part of a ring at one side of the plane that cuts it.
  constexpr open_piece cut(const open_piece& p, int keep, const dividing_node& by) {
    const auto first = static_cast<std::uint32_t>(corners_.size());
    const std::size_t n = ring_.size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t next = i + 1 < n ? i + 1 : 0;
      const int here = side_[i] * keep, there = side_[next] * keep;
      if (here >= 0) corners_.push_back(ring_[i]);
      if (here == 0 && there < 0) corners_.back().next_side = by.number + 3;
      if (here * there >= 0) continue;
      corners_.push_back(crossing(ring_[i], ring_[next], by.plane));
      corners_.back().next_side = here > 0 ? by.number + 3 : ring_[i].next_side;
    }
    const auto limit = static_cast<std::uint32_t>(d_.limits.size());
    d_.limits.push_back({by.number, keep, p.limits});
    return {p.triangle, limit, first, static_cast<std::uint32_t>(corners_.size()) - first};
  }

  // Where a side crosses a plane. With values f and g at its ends of different signs, off by at most e, the share
  // f / (f - g) of the way is off by at most e / |f - g|, and some roundings.
  static constexpr piece_corner crossing(const piece_corner& a, const piece_corner& b, const rounded_plane& plane) {
    const bounded_value f = plane(a.at, a.off), g = plane(b.at, b.off);
    const double whole = f.value - g.value, share = f.value / whole;
    piece_corner c{{}, 0.0, 0};
    double length = 0, size = 0;
    for (int k = 0; k < 3; ++k) {
      const double way = b.at[k] - a.at[k];
      c.at[k] = a.at[k] + product(share, way);
      length = greater(length, magnitude(way));
      size = greater(size, greater(magnitude(a.at[k]), magnitude(b.at[k])));
    }
    const double off = greater(f.bound, g.bound) / magnitude(whole) + 0x1p-50;
    c.off = 1.01 * (greater(a.off, b.off) + product(length, off) + product(size, 0x1p-50)) + 0x1p-1000;
    return c;
  }

  // How a piece lies to a plane, as far as rounded numbers tell: for the choice, which any answer leaves right.
  constexpr std::pair<bool, bool> rough_sides(const open_piece& p, const rounded_plane& plane) const noexcept {
    bool front = false, back = false;
    const auto take = [&](int side) {
      front = front || side > 0;
      back = back || side < 0;
    };
    for (std::uint32_t k = 0; k < p.count; ++k) take(plane(corners_[p.first + k].at, corners_[p.first + k].off).sign());
    for (std::size_t k = 0; p.count == 0 && k < 3; ++k) {
      double at[3];
      copy_widened(d_.vertices[d_.triangles[p.triangle].v[k]], at);
      take(plane(at, 0.0).sign());
    }
    return {front, back};
  }

  // Judges some of the pieces that reach across the cell; false where there are none.
  constexpr bool judge_across(const std::vector<open_piece>& pieces, std::size_t tried, const costs& c,
                              best& best_one) const {
    std::vector<std::uint32_t> across;
    for (const open_piece& p : pieces)
      if (reaches_across(p)) across.push_back(p.triangle);
    const std::size_t some = lesser(tried, across.size());
    for (std::size_t i = 0; i < some; ++i)
      judge({across[i * across.size() / some], bsp_plane_3d::of_triangle}, pieces, c, best_one);
    return some > 0;
  }

  // Takes a plane if it costs less. One across an axis must leave something at each side, or nothing is won.
  constexpr void judge(const bsp_plane_3d& plane, const std::vector<open_piece>& pieces, const costs& c,
                       best& best_one) const noexcept {
    const rounded_plane rounded = plane_of(d_, plane);
    std::size_t front = 0, back = 0, cut = 0;
    for (std::size_t i = 0; i < c.judges; ++i) {
      const auto [f, b] = rough_sides(pieces[i * pieces.size() / c.judges], rounded);
      cut += f && b;
      front += f && !b;
      back += b && !f;
    }
    if (plane.axis != bsp_plane_3d::of_triangle && (front == 0 || back == 0)) return;
    const std::size_t cost = (front < back ? back - front : front - back) + cut * c.cut;
    if (cost < best_one.cost) best_one = {plane, cost};
  }

  // The vertex in the middle of some.
  constexpr std::uint32_t median_vertex(const std::vector<open_piece>& pieces, std::size_t judges,
                                        std::uint32_t axis) const {
    std::vector<std::pair<T, std::uint32_t>> all;
    all.reserve(judges);
    for (std::size_t i = 0; i < judges; ++i) {
      const std::uint32_t v = d_.triangles[pieces[i * pieces.size() / judges].triangle].v[i % 3];
      all.push_back({d_.vertices[v][static_cast<int>(axis)], v});
    }
    std::sort(all.begin(), all.end());
    return all[all.size() / 2].second;
  }

  bsp_data_3d<T>& d_;
  std::vector<piece_corner> corners_{}, ring_{};
  std::vector<int> side_{};
};

}  // namespace irg::detail
