// SPDX-License-Identifier: MIT
// Random houses as plans of cells and portals, and straight lines that are walked through them one by one.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <irg/geometry/orient2d.hpp>
#include <irg/visibility/cell_plan.hpp>

#include "random.hpp"

namespace test {

/// A rectangle cut into rooms, with doors: every room is reached, and some have more doors than that takes.
struct house_maker {
  struct room {
    std::int64_t x0, y0, x1, y1;
  };
  test::random& r;
  std::vector<room> rooms{};

  void cut(const room& at, int levels) {
    const std::int64_t wide = at.x1 - at.x0, high = at.y1 - at.y0;
    if (levels == 0 || std::max(wide, high) < 16) return rooms.push_back(at);
    const bool across = wide > high || (wide == high && r.integer(0, 1) == 0);
    const std::int64_t place = across ? r.integer(at.x0 + 6, at.x1 - 6) : r.integer(at.y0 + 6, at.y1 - 6);
    cut(across ? room{at.x0, at.y0, place, at.y1} : room{at.x0, at.y0, at.x1, place}, levels - 1);
    cut(across ? room{place, at.y0, at.x1, at.y1} : room{at.x0, place, at.x1, at.y1}, levels - 1);
  }

  template <class T>
  irg::cell_plan<T> plan(std::int64_t size, int levels) {
    cut({0, 0, size, size}, levels);
    irg::cell_plan<T> out;
    const auto at = [](std::int64_t x, std::int64_t y) {
      return irg::point<T, 2>{static_cast<T>(x), static_cast<T>(y)};
    };
    for (const room& c : rooms)
      out.cells.push_back({{at(c.x0, c.y0), at(c.x1, c.y0), at(c.x1, c.y1), at(c.x0, c.y1)}, T(0), T(3)});
    std::vector<std::size_t> group(rooms.size());
    for (std::size_t i = 0; i < group.size(); ++i) group[i] = i;
    for (std::size_t i = 0; i < rooms.size(); ++i)
      for (std::size_t k = 0; k < rooms.size(); ++k) {
        const room &a = rooms[i], &b = rooms[k];
        const bool beside = a.x1 == b.x0, above = a.y1 == b.y0;
        const std::int64_t first = beside ? std::max(a.y0, b.y0) : std::max(a.x0, b.x0);
        const std::int64_t last = beside ? std::min(a.y1, b.y1) : std::min(a.x1, b.x1);
        if ((!beside && !above) || last - first < 3 || (group[i] == group[k] && r.integer(0, 3) != 0)) continue;
        const std::int64_t low = r.integer(first, last - 2), high = r.integer(low + 1, std::min(last, low + 4));
        std::replace(group.begin(), group.end(), group[k], group[i]);
        out.portals.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k),
                               beside ? at(a.x1, low) : at(low, a.y1), beside ? at(a.x1, high) : at(high, a.y1)});
      }
    return out;
  }
};

template <class T>
irg::cell_plan<T> random_house(test::random& r, std::int64_t size, int levels) {
  house_maker maker{r};
  return maker.plan<T>(size, levels);
}

/// The same house with walls half a unit thick: a doorway is a cell of its own.
template <class T>
irg::cell_plan<T> with_thick_walls(irg::cell_plan<T> thin) {
  irg::cell_plan<T> out;
  const T half = T(0.25), jamb = T(0.375);
  for (auto& c : thin.cells) {
    const irg::point<T, 2> low = c.corners[0], high = c.corners[2];
    c.corners = {{low.x + half, low.y + half},
                 {high.x - half, low.y + half},
                 {high.x - half, high.y - half},
                 {low.x + half, high.y - half}};
    out.cells.push_back(c);
  }
  for (const auto& d : thin.portals) {
    const bool beside = d.a.x == d.b.x;
    const irg::point<T, 2> low =
        beside ? irg::point<T, 2>{d.a.x - half, d.a.y + jamb} : irg::point<T, 2>{d.a.x + jamb, d.a.y - half};
    const irg::point<T, 2> high =
        beside ? irg::point<T, 2>{d.b.x + half, d.b.y - jamb} : irg::point<T, 2>{d.b.x - jamb, d.b.y + half};
    const auto door = static_cast<std::uint32_t>(out.cells.size());
    const irg::point<T, 2> right{high.x, low.y}, left{low.x, high.y};
    out.cells.push_back({{low, right, high, left}, thin.cells[d.first].floor, thin.cells[d.first].ceiling});
    out.portals.push_back({d.first, door, low, beside ? left : right});
    out.portals.push_back({door, d.second, beside ? right : left, high});
  }
  return out;
}

/// Two triangles in each cell of a bent grid, whole sides between them open or walls: walls in all directions, many at
/// one corner.
template <class T>
irg::cell_plan<T> random_triangles(test::random& r, int size, int open_of_ten) {
  std::vector<irg::point<T, 2>> at;
  for (int y = 0; y <= size; ++y)
    for (int x = 0; x <= size; ++x) {
      const std::int64_t u = r.integer(-2, 2), v = r.integer(-2, 2);
      at.push_back({static_cast<T>(10 * x + u), static_cast<T>(10 * y + v)});
    }
  irg::cell_plan<T> out;
  std::vector<std::vector<std::size_t>> corners;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const auto a = static_cast<std::size_t>(y * (size + 1) + x), b = a + 1,
                 c = b + static_cast<std::size_t>(size) + 1, d = c - 1;
      for (const auto& t : {std::vector{a, b, c}, std::vector{a, c, d}}) {
        corners.push_back(t);
        out.cells.push_back({{at[t[0]], at[t[1]], at[t[2]]}, T(0), T(3)});
      }
    }
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      for (std::size_t u = 0; u < 3; ++u)
        for (std::size_t v = 0; v < 3; ++v) {
          const std::size_t a = corners[i][u], b = corners[i][(u + 1) % 3];
          if (corners[k][v] == b && corners[k][(v + 1) % 3] == a && r.integer(0, 9) < open_of_ten)
            out.portals.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k), at[a], at[b]});
        }
  return out;
}

/// The cells that the line from p, a point of the cell, towards q goes through until a wall stops it.
template <class T>
std::vector<std::uint32_t> walked_cells(const irg::portal_graph<T>& g, std::uint32_t cell, const irg::point<T, 2>& p,
                                        const irg::point<T, 2>& q) {
  std::vector<std::uint32_t> out{cell};
  for (bool on = true; on && out.size() < 10000;) {
    on = false;
    for (const irg::doorway<T>& d : g.doors(out.back()))
      if (irg::orient2d(p, q, d.right) < 0 && irg::orient2d(p, q, d.left) > 0) {
        out.push_back(d.to);
        on = true;
        break;
      }
  }
  return out;
}

}  // namespace test
