// SPDX-License-Identifier: MIT
// Trees of boxes and tetrahedra to try things on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <utility>
#include <vector>

#include <irg/geometry/orient3d.hpp>
#include <irg/mesh/mesh_faults.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/solid/csg_tree.hpp>

#include "support/random.hpp"

namespace test {

using solid_tree = irg::csg_tree<double>;

/// A cube by its least corner.
constexpr solid_tree box(double x, double y, double z, double size) {
  auto m = irg::shape_cube<double>();
  m.normals.clear();
  for (auto& c : m.corners) c.normal = irg::no_index;
  for (auto& p : m.positions) p = {p.x * size + x, p.y * size + y, p.z * size + z};
  return solid_tree(m);
}

/// A tetrahedron with corners that next() gives.
template <class Next>
solid_tree tetrahedron(const Next& next) {
  for (;;) {
    irg::mesh<double> m;
    for (int i = 0; i < 4; ++i) {
      const double x = next(), y = next();
      m.positions.push_back({x, y, next()});
    }
    const int turn = irg::orient3d(m.positions[0], m.positions[1], m.positions[2], m.positions[3]);
    if (turn == 0) continue;
    if (turn > 0) std::swap(m.positions[1], m.positions[2]);
    for (const auto& f : {std::initializer_list<int>{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}) irg::add_face(m, f);
    return solid_tree(m);
  }
}

/// Any two neighbours become one, till one is left.
inline solid_tree combine_at_random(std::vector<solid_tree> parts, random& r) {
  while (parts.size() > 1) {
    const auto i = static_cast<std::size_t>(r.integer(0, static_cast<std::int64_t>(parts.size()) - 2));
    parts[i] = irg::csg_boolean(parts[i], parts[i + 1], static_cast<irg::boolean_operation>(r.integer(0, 3)));
    parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(i) + 1);
  }
  return parts[0];
}

/// Boxes and tetrahedra with whole corners up to `size`.
inline solid_tree lattice_tree(random& r, std::int64_t size) {
  const auto at = [&] { return static_cast<double>(r.integer(-size, size)); };
  std::vector<solid_tree> parts;
  for (int i = 0, count = static_cast<int>(r.integer(3, 5)); i < count; ++i)
    if (r.integer(0, 2) == 0) {
      const double x = at(), y = at(), z = at();
      parts.push_back(box(x, y, z, static_cast<double>(r.integer(1, size))));
    } else {
      parts.push_back(tetrahedron(at));
    }
  return combine_at_random(std::move(parts), r);
}

/// Whether a tree has what lies in the bodies b with in(b) alone.
template <class In>
bool has(const solid_tree& tree, const In& in) {
  std::vector<bool> is;
  for (const auto& step : tree.steps) {
    const auto at = [&](std::uint32_t s) -> bool { return s != irg::no_index && is[s]; };
    const bool a = at(step.first), b = at(step.second);
    if (step.body != irg::no_index)
      is.push_back(in(step.body));
    else
      is.push_back(step.operation == irg::boolean_operation::union_         ? a || b
                   : step.operation == irg::boolean_operation::intersection ? a && b
                   : step.operation == irg::boolean_operation::difference   ? a && !b
                                                                            : a != b);
  }
  return !is.empty() && is.back();
}

}  // namespace test
