// SPDX-License-Identifier: MIT
// The edges of a grid surface that lie in line with the eye, those of the grid's lines below it. Each such line is seen
// in one upright plane, in two directions from the eye, and hides nothing but itself: the other edges that meet the
// plane meet it at the line's own vertices.
#pragma once

#include <array>
#include <cstdint>

#include <irg/hidden/detail/grid_sight.hpp>

namespace irg {
struct grid_edge_part;
}

namespace irg::detail {

template <class Sight>
struct IRG_APART grid_sight_lines {
  const Sight& sight;
  bool outer_hides, inner_hides;

  // Calls visit(part, seen) for each edge of the lines.
  template <class Visit>
  constexpr void visit(const Visit& visit) const {
    for (std::size_t i = 0; i < sight.x.size(); ++i)
      if (sight.x[i] == sight.eye.x) line(static_cast<int>(i), 1, visit);
    for (std::size_t j = 0; j < sight.z.size(); ++j)
      if (sight.z[j] == sight.eye.z) line(static_cast<int>(j), 0, visit);
  }

private:
  // The line of edges along `axis` (0: x, 1: z), in its plane: places along it and heights.
  struct sight_plane {
    const Sight& sight;
    int at, axis;
    constexpr int size() const noexcept { return static_cast<int>(axis == 0 ? sight.x.size() : sight.z.size()); }
    constexpr std::uint32_t vertex(int k) const noexcept {
      return axis == 0 ? sight.vertex(k, at) : sight.vertex(at, k);
    }
    constexpr double place(int k) const noexcept {
      return axis == 0 ? sight.x[static_cast<std::size_t>(k)] : sight.z[static_cast<std::size_t>(k)];
    }
    constexpr point<double, 2> point_at(int k) const noexcept { return {place(k), sight.heights[vertex(k)]}; }
    constexpr point<double, 2> eye() const noexcept { return {axis == 0 ? sight.eye.x : sight.eye.z, sight.eye.y}; }
    // 1 where vertex a is seen above vertex b, on one side of the eye.
    constexpr int compare(int a, int b) const noexcept {
      const int turn = orient2d(eye(), point_at(b), point_at(a));
      return place(a) > eye().x ? turn : -turn;
    }
    // Where the line of sight to vertex q meets the edge from k to k + 1.
    constexpr double meeting(int q, int k) const noexcept {
      const auto formula = [](const auto& p) {
        const auto x = p[2] - p[0], y = p[3] - p[1];
        const auto a = x * (p[5] - p[1]) - y * (p[4] - p[0]), b = x * (p[7] - p[1]) - y * (p[6] - p[0]);
        return std::array{a - b, a};
      };
      const auto e = eye(), s = point_at(q), a = point_at(k), b = point_at(k + 1);
      return irg::quotient_of<2>(formula, std::array{e.x, e.y, s.x, s.y, a.x, a.y, b.x, b.y}).value_or(0.0);
    }
    template <class Part>
    constexpr Part part(int k, double from, double to) const noexcept {
      return axis == 0 ? Part{k, at, k + 1, at, from, to} : Part{at, k, at, k + 1, from, to};
    }
  };

  template <class Visit, class Part = grid_edge_part>
  constexpr void line(int at, int axis, const Visit& visit) const {
    const sight_plane plane{sight, at, axis};
    const double eye = plane.eye().x;
    for (int k = 0; k + 1 < plane.size(); ++k)  // under the eye nothing is nearer
      if (plane.place(k) <= eye && eye <= plane.place(k + 1)) visit(plane.template part<Part>(k, 0, 1), true);
    int behind = 0;
    while (behind < plane.size() && plane.place(behind) <= eye) ++behind;
    walk<Part>(plane, behind, 1, visit);
    int before = plane.size() - 1;
    while (before >= 0 && plane.place(before) >= eye) --before;
    walk<Part>(plane, before, -1, visit);
  }

  // From vertex k away from the eye. Along an edge the slope of the line of sight rises, falls or stays.
  template <class Part, class Visit>
  constexpr void walk(const sight_plane& plane, int k, int step, const Visit& visit) const {
    int highest = k, lowest = k;
    for (; k >= 0 && k < plane.size() && k + step >= 0 && k + step < plane.size(); k += step) {
      const int next = k + step, rise = plane.compare(next, k);
      const bool tops = plane.compare(k, highest) == 0, bottoms = plane.compare(k, lowest) == 0;
      const int over = plane.compare(next, highest), under = plane.compare(next, lowest);
      const bool whole = (outer_hides && tops && rise >= 0) || (inner_hides && bottoms && rise <= 0);
      const bool emerges = (outer_hides && over > 0) || (inner_hides && under < 0);
      const int edge = step > 0 ? k : next;
      double from = 0, to = 1;
      if (!whole && emerges) (step > 0 ? from : to) = plane.meeting(over > 0 ? highest : lowest, edge);
      visit(plane.template part<Part>(edge, from, to), whole || emerges);
      if (over > 0) highest = next;
      if (under < 0) lowest = next;
    }
  }
};

}  // namespace irg::detail
