// SPDX-License-Identifier: MIT
// Triangles in space for tests of BSP trees: at random, mended into degenerate ones, in planes, in rods over each other.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <irg/core/vocabulary.hpp>
#include <irg/math/vec.hpp>

#include "support/random.hpp"

namespace test {

using space_point = irg::point<double, 3>;

struct space_scene {
  std::vector<space_point> vertices{};
  std::vector<irg::triangle_indices> triangles{};

  void add(const space_point& a, const space_point& b, const space_point& c) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), {a, b, c});
    triangles.push_back({{first, first + 1, first + 2}});
  }
};

/// n triangles with small whole coordinates, so that corners lie in planes of others; where `wide`, times powers of two.
inline space_scene whole_numbers(random& r, int n, bool wide) {
  space_scene s;
  const auto coordinate = [&] {
    const auto whole = static_cast<double>(r.integer(-5, 5));
    return wide ? std::ldexp(whole, static_cast<int>(r.integer(-200, 200))) : whole;
  };
  for (int i = 0; i < n; ++i) {
    double c[9];
    for (double& x : c) x = coordinate();
    s.add({c[0], c[1], c[2]}, {c[3], c[4], c[5]}, {c[6], c[7], c[8]});
  }
  return s;
}

/// Triangles that lie one above the other.
inline space_scene storeys(int n) {
  space_scene s;
  for (int i = 0; i < n; ++i) {
    const auto z = static_cast<double>(i);
    s.add({0, 0, z}, {1, 0, z}, {0, 1, z});
  }
  return s;
}

/// Three rods, each over the next at one end and under the one before at the other.
inline space_scene three_rods() {
  space_scene s;
  const space_point at[3] = {{0, 4, 0}, {-4, -3, 0}, {4, -3, 0}};
  for (int i = 0; i < 3; ++i) {
    space_point a = at[i], b = at[(i + 1) % 3];
    const double dx = (b[0] - a[0]) / 4, dy = (b[1] - a[1]) / 4;
    a = {a[0] - dx, a[1] - dy, 1};
    b = {b[0] + dx, b[1] + dy, -1};
    s.add({a[0] - dy / 4, a[1] + dx / 4, a[2]}, {a[0] + dy / 4, a[1] - dx / 4, a[2]}, b);
  }
  return s;
}

/// A round body of 2 * fineness^2 triangles.
inline space_scene ball(std::uint32_t fineness) {
  space_scene s;
  const std::uint32_t row = fineness + 1;
  for (std::uint32_t i = 0; i < row; ++i)
    for (std::uint32_t j = 0; j < row; ++j) {
      const double a = 6.2831853 * i / fineness, b = 3.14159265 * j / fineness;
      s.vertices.push_back({std::cos(a) * std::sin(b), std::sin(a) * std::sin(b), std::cos(b)});
    }
  for (std::uint32_t i = 0; i < fineness; ++i)
    for (std::uint32_t j = 0; j < fineness; ++j) {
      const std::uint32_t at = i * row + j;
      s.triangles.push_back({{at, at + 1, at + row}});
      s.triangles.push_back({{at + 1, at + row + 1, at + row}});
    }
  return s;
}

}  // namespace test
