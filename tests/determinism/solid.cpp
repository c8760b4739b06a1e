// SPDX-License-Identifier: MIT
#include <irg/mesh/from_half_edges.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/mesh/to_half_edges.hpp>
#include <irg/solid/boolean.hpp>
#include <irg/solid/csg_spans.hpp>

#include <array>
#include <initializer_list>

#include "hashes.hpp"

namespace {

template <class T>
constexpr void add_mesh(determinism::hasher& h, const irg::mesh<T>& m) {
  for (const auto& p : m.positions)
    for (int i = 0; i < 3; ++i) h.add(p[i]);
  for (const auto& c : m.corners) h.add(c.position);
}

template <class T>
constexpr irg::point<T, 3> any_place(test::random& r) {
  const T x = static_cast<T>(r.unit()), y = static_cast<T>(r.unit());
  return irg::point<T, 3>{x, y, static_cast<T>(r.unit())};
}
template <class T>
constexpr irg::mesh<T> tetrahedron(test::random& r) {
  irg::mesh<T> m;
  const auto a = any_place<T>(r), b = any_place<T>(r), c = any_place<T>(r), d = any_place<T>(r);
  m.positions = {a, b, c, d};
  if (irg::orient3d(a, b, c, d) > 0) m.positions = {a, c, b, d};
  for (const auto& f : {std::array{0, 1, 2}, std::array{0, 3, 1}, std::array{1, 3, 2}, std::array{2, 3, 0}})
    irg::add_face(m, f);
  return m;
}

// Slanted tetrahedra combined: what faces there are, and where, to the last bit.
template <class T>
constexpr std::uint64_t combined(int rounds) {
  test::random r(61);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    const irg::mesh<T> a = tetrahedron<T>(r), b = tetrahedron<T>(r);
    for (const auto operation : {irg::boolean_operation::union_, irg::boolean_operation::difference})
      add_mesh(h, irg::solid_boolean(a, b, operation).value);
  }
  return h.value();
}
constexpr std::uint64_t solid_boolean_float(int rounds) { return combined<float>(rounds); }
constexpr std::uint64_t solid_boolean_double(int rounds) { return combined<double>(rounds); }
// In constant evaluation one pair takes more steps than clang allows; tests/solid has one that takes fewer.
HASHED(solid_boolean_float, 0, 300);
HASHED(solid_boolean_double, 0, 300);

// Trees of five, their meshes, and stretches of lines in them.
template <class T>
constexpr std::uint64_t trees(int rounds) {
  test::random r(62);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    irg::csg_tree<T> tree(tetrahedron<T>(r));
    for (int k = 0; k < 4; ++k)
      tree =
          irg::csg_boolean(tree, irg::csg_tree<T>(tetrahedron<T>(r)), static_cast<irg::boolean_operation>(2 + k % 2));
    add_mesh(h, irg::to_mesh(tree).value);
    const irg::csg_spans<T> through(tree);
    for (int k = 0; k < 8; ++k) {
      const irg::point<T, 3> from = any_place<T>(r), to = any_place<T>(r);
      for (const auto& span : through.along(irg::ray_between(from, to)))
        h.add(span.from), h.add(span.to), h.add(span.left.face);
    }
  }
  return h.value();
}
constexpr std::uint64_t solid_trees_float(int rounds) { return trees<float>(rounds); }
constexpr std::uint64_t solid_trees_double(int rounds) { return trees<double>(rounds); }
HASHED(solid_trees_float, 0, 60);
HASHED(solid_trees_double, 0, 60);

constexpr std::uint64_t mesh_half_edges(int rounds) {
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    const auto b = irg::to_half_edges(irg::shape_torus<double>({.major_segments = 3 + i, .minor_segments = 3})).value;
    for (const auto& e : b.half_edges) h.add(e.next), h.add(e.origin);
    add_mesh(h, irg::to_mesh(b));
  }
  return h.value();
}
HASHED(mesh_half_edges, 1, 20);

}  // namespace
