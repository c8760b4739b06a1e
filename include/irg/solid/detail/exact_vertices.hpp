// SPDX-License-Identifier: MIT
// The vertices of bodies that are cut at each other: those they had, and the places where a side goes through a
// triangle or crosses a side, or where three triangles meet. Decisions look at rounded coordinates first; where these
// do not tell, the place itself is computed, once, without rounding.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include <irg/math/exact/nearest_float.hpp>
#include <irg/geometry/exact_point.hpp>
#include <irg/geometry/intersect_plane_line.hpp>
#include <irg/solid/detail/triangle_contacts.hpp>

namespace irg::detail::inline IRG_ABI {

// Rounded coordinates are off by less than 1.01u times their size. Of a determinant of differences below D, of numbers
// below M, the error is less than 25u M D, since D is at most 2M; of three rows, less than 103u M D^2.
inline constexpr double rounded_turn_bound = 0x1p-48, rounded_side_bound = 0x1p-46;
// Where M D D is above, nothing has been lost to underflow.
inline constexpr double least_size = 0x1p-900, most_size = 0x1p300;

// orient2d of three points of which some are rounded; 0 where that does not tell.
constexpr int sure_turn(const point<double, 2>& p, const point<double, 2>& q, const point<double, 2>& r) noexcept {
  const auto largest = [](const point<double, 2>& x) { return maximum(magnitude(x.x), magnitude(x.y)); };
  const double ax = q.x - p.x, ay = q.y - p.y, bx = r.x - p.x, by = r.y - p.y;
  const double size = maximum(maximum(largest(p), largest(q)), largest(r));
  const double reach = maximum(maximum(magnitude(ax), magnitude(ay)), maximum(magnitude(bx), magnitude(by)));
  const double value = product(ax, by) - product(ay, bx), bound = product(size, reach) * rounded_turn_bound;
  const bool is_sure = bound > least_size && size < most_size && magnitude(value) > bound;
  return !is_sure ? 0 : value > 0 ? 1 : -1;
}

template <class Exact>
class exact_vertices {
public:
  std::vector<point<double, 3>> at;  // rounded, where they are no corners of the bodies
  std::uint32_t corners = 0;  // the first of those that were made
  std::vector<contact_key> keys;  // of those
  const std::vector<triangle_indices>* triangles = nullptr;

  constexpr std::uint32_t add(const contact_key& key) {
    keys.push_back(key);
    exact_.push_back({});
    const auto v = static_cast<std::uint32_t>(at.size());
    at.push_back({});
    if (key.v[3] == no_index) {
      const triangle_indices& t = (*triangles)[key.v[2]];
      const auto meeting = intersect_plane_line(at[t.v[0]], at[t.v[1]], at[t.v[2]], at[key.v[0]], at[key.v[1]]);
      at[v] = meeting.at;
    } else {
      at[v] = exact(v).rounded();
    }
    return v;
  }

  // The place without rounding. Those of corners stand in one of three slots until it is used again.
  constexpr const Exact& exact(std::uint32_t v, std::size_t slot = 0) {
    if (v < corners) return slots_[slot] = Exact(at[v]);
    Exact& e = exact_[v - corners];
    if (e.is_known()) return e;
    const contact_key& key = keys[v - corners];
    const auto corner = [&](std::size_t i) -> const point<double, 3>& { return at[key.v[i]]; };
    const auto plane = [&](std::size_t i) {
      const triangle_indices& t = (*triangles)[key.v[i]];
      return std::array{at[t.v[0]], at[t.v[1]], at[t.v[2]]};
    };
    if (key.v[3] == three_triangles) return e = Exact::on_planes({plane(0), plane(1), plane(2)});
    if (key.v[3] != no_index) return e = Exact::on_lines(corner(0), corner(1), corner(2), corner(3));
    const auto [p, q, r] = plane(2);
    return e = Exact::on_plane(p, q, r, corner(0), corner(1));
  }

  // orient2d of three of them, seen along an axis.
  constexpr int turn(std::uint32_t u, std::uint32_t v, std::uint32_t w, int axis) {
    if (u < corners && v < corners && w < corners) return orientation_along(axis, at[u], at[v], at[w]);
    if (const int sign = sure_turn(seen_along(axis, at[u]), seen_along(axis, at[v]), seen_along(axis, at[w]));
        sign != 0)
      return sign;
    return irg::orientation_along(axis, exact(u, 0), exact(v, 1), exact(w, 2));
  }

  // Which of two is farther along an axis.
  constexpr int compare(std::uint32_t u, std::uint32_t v, int axis) {
    const double p = at[u][axis], q = at[v][axis];
    if (u < corners && v < corners) return compare_numbers(p, q);
    const double bound = maximum(magnitude(p), magnitude(q)) * 0x1p-50;
    if (bound > least_size && magnitude(p - q) > bound) return p < q ? -1 : 1;
    return irg::compare_along(axis, exact(u, 0), exact(v, 1));
  }

  // Vertices in one place become one: of each vertex the least of `some` that lies where it does, of others their own
  // number.
  constexpr std::vector<std::uint32_t> merge(std::vector<std::uint32_t> some) {
    std::vector<std::uint32_t> to(at.size(), 0);
    for (std::uint32_t v = 0; v < to.size(); ++v) to[v] = v;
    const auto order = [this](std::uint32_t u, std::uint32_t v) {
      for (int axis = 0; axis < 3; ++axis)
        if (const int way = compare(u, v, axis); way != 0) return way;
      return 0;
    };
    std::sort(some.begin(), some.end(), [&](std::uint32_t u, std::uint32_t v) {
      const int way = u == v ? 0 : order(u, v);
      return way != 0 ? way < 0 : u < v;
    });
    for (std::size_t i = 0, first = 0; i < some.size(); ++i) {
      if (order(some[first], some[i]) != 0) first = i;
      to[some[i]] = some[first];
    }
    return to;
  }

private:
  std::vector<Exact> exact_;
  Exact slots_[3];
};

}  // namespace irg::detail::inline IRG_ABI
