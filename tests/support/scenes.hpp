// SPDX-License-Identifier: MIT
// Seeded scenes that hold everything a renderer may be given.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <irg/math/constants.hpp>
#include <irg/mesh/mesh.hpp>
#include <irg/scene/scene.hpp>
#include <irg/view/affine.hpp>

#include "support/random.hpp"

namespace test {

/// A number of any size and sign, a multiple of 2^-20 of its power of two.
inline double number_of_any_size(random& r, int least_exponent, int greatest_exponent) {
  const double v = static_cast<double>(r.integer(-(1 << 20), 1 << 20)) * 0x1p-20;
  return std::ldexp(v, static_cast<int>(r.integer(least_exponent, greatest_exponent)));
}

/// What positions of a random mesh are like.
enum class positions {
  ordinary,    // around the target, as far out as the eye stands
  everywhere,  // behind and through the eye as well, and far beyond the guard band
  hostile      // some NaN, infinite, or near the largest numbers
};

template <class T>
irg::point<T, 3> random_position(random& r, positions kind) {
  const auto coordinate = [&] {
    if (kind == positions::hostile && r.integer(0, 39) == 0) {
      constexpr T largest = std::numeric_limits<T>::max(), infinite = std::numeric_limits<T>::infinity();
      const T odd[6] = {std::numeric_limits<T>::quiet_NaN(), infinite, -infinite, largest, -largest, largest / T(64)};
      return odd[r.integer(0, 5)];
    }
    if (kind == positions::ordinary) return static_cast<T>(number_of_any_size(r, 0, 1));
    return static_cast<T>(r.integer(0, 3) == 0 ? number_of_any_size(r, -6, 24) : number_of_any_size(r, 0, 4));
  };
  const T x = coordinate(), y = coordinate(), z = coordinate();
  return {x, y, z};
}

/// Triangles and quadrilaterals without any order, some of them sharing corners, some with normals of their own.
template <class T>
irg::mesh<T> random_mesh(random& r, int faces, positions kind) {
  irg::mesh<T> m;
  const bool normals = r.integer(0, 1) == 0;
  for (int f = 0; f < faces; ++f) {
    const std::uint32_t corners = r.integer(0, 4) == 0 ? 4 : 3;
    for (std::uint32_t k = 0; k < corners; ++k) {
      irg::mesh_corner c;
      if (m.positions.size() > 3 && r.integer(0, 2) == 0) {
        c.position = static_cast<std::uint32_t>(r.integer(0, static_cast<std::int64_t>(m.positions.size()) - 1));
      } else {
        c.position = static_cast<std::uint32_t>(m.positions.size());
        m.positions.push_back(random_position<T>(r, kind));
      }
      if (normals) {
        c.normal = static_cast<std::uint32_t>(m.normals.size());
        m.normals.push_back(irg::to_vec(random_position<T>(r, positions::ordinary)));
      }
      m.corners.push_back(c);
    }
    m.face_starts.push_back(static_cast<std::uint32_t>(m.corners.size()));
  }
  return m;
}

/// A scene of two objects, seen from a place near their middle when positions are not ordinary.
template <class T>
irg::scene<T> random_scene(random& r, int faces, positions kind) {
  irg::scene<T> s;
  s.objects.push_back({random_mesh<T>(r, faces, kind)});
  s.objects.push_back(
      {random_mesh<T>(r, faces / 2, kind), irg::rotation_y(T(1)) * irg::scaling(irg::vec<T, 3>{-1, 1, 1})});
  s.objects[0].surface = {{T(0.8), T(0.4), T(0.2)}, {T(0.8), T(0.4), T(0.2)}, {T(0.3), T(0.3), T(0.3)}, T(20)};
  s.objects[1].surface.diffuse = {T(0.1), T(0.5), T(0.9)};
  s.lights = {{{T(3), T(4), T(5), T(1)}, {T(1), T(1), T(1)}},
              {{T(-1), T(0.5), T(0.25), T(0)}, {T(0.4), T(0.4), T(0.5)}}};
  s.ambient = {T(0.1), T(0.1), T(0.15)};
  s.view.eye = kind == positions::ordinary ? irg::point<T, 3>{1, 2, 5} : random_position<T>(r, positions::ordinary);
  s.view.target = {T(0.25), T(0), T(-1)};
  s.view.vertical_angle = T(r.integer(20, 120)) * irg::pi<T> / T(180);
  if (r.integer(0, 3) == 0) {
    s.view.projection = irg::projection_kind::orthographic;
    s.view.near_distance = T(-20), s.view.far_distance = T(20);
  } else if (r.integer(0, 2) == 0) {
    s.view.near_distance = T(0.5), s.view.far_distance = T(6);
  } else if (r.integer(0, 1) == 0) {
    s.view.near_distance = T(0.0001);
  }
  return s;
}

}  // namespace test
