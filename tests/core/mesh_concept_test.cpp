// SPDX-License-Identifier: MIT
#include <irg/core/mesh_concept.hpp>

#include <array>
#include <vector>

#include <irg/math/vec.hpp>

#include "support/archetypes.hpp"
#include "support/check_both.hpp"
#include "support/own_types.hpp"

namespace {

struct triangles {  // as many engines have them: no mesh until its traits say how it is read
  std::vector<std::array<float, 3>> vertices;
  std::vector<std::array<int, 3>> indices;
};
struct incomplete {};
struct without_points {};
struct of_vectors {};

}  // namespace

template <>
struct irg::mesh_traits<triangles> {
  using point = std::array<float, 3>;
  static std::size_t vertex_count(const triangles& m) { return m.vertices.size(); }
  static const point& position(const triangles& m, std::size_t v) { return m.vertices[v]; }
  static std::size_t face_count(const triangles& m) { return m.indices.size(); }
  static int face_size(const triangles&, std::size_t) { return 3; }
  static int face_vertex(const triangles& m, std::size_t f, std::size_t k) { return m.indices[f][k]; }
};
template <>
struct irg::mesh_traits<incomplete> {  // face_vertex is missing
  using point = irg::point<float, 3>;
  static std::size_t vertex_count(const incomplete&);
  static point position(const incomplete&, std::size_t);
  static std::size_t face_count(const incomplete&);
  static std::size_t face_size(const incomplete&, std::size_t);
};
template <>
struct irg::mesh_traits<without_points> : irg::mesh_traits<triangles> {
  using point = float;
};
template <>
struct irg::mesh_traits<of_vectors> : irg::mesh_traits<triangles> {
  using point = irg::vec<float, 3>;
};

namespace {

static_assert(irg::Mesh<triangles> && irg::Mesh<archetype::mesh<archetype::point<archetype::scalar, 3>>>);
static_assert(!irg::Mesh<incomplete> && !irg::Mesh<without_points> && !irg::Mesh<of_vectors>);
static_assert(!irg::Mesh<int> && !irg::Mesh<std::vector<irg::point<float, 3>>> && !irg::Mesh<void>);

// Six times the volume inside, by the divergence theorem, through the concept alone.
template <irg::Mesh M>
constexpr auto six_volumes(const M& m) {
  using scalar = irg::scalar_of<irg::mesh_point<M>>;
  scalar sum = scalar(0);
  for (std::size_t f = 0; f < irg::mesh_face_count(m); ++f)
    for (std::size_t k = 2; k < irg::mesh_face_size(m, f); ++k) {
      const auto a = irg::mesh_position(m, irg::mesh_face_vertex(m, f, 0));
      const auto b = irg::mesh_position(m, irg::mesh_face_vertex(m, f, k - 1));
      const auto c = irg::mesh_position(m, irg::mesh_face_vertex(m, f, k));
      const auto at = [](const auto& p, int i) { return irg::coordinate(p, i); };
      sum = sum + (at(a, 0) * (at(b, 1) * at(c, 2) - at(b, 2) * at(c, 1)) -
                   at(a, 1) * (at(b, 0) * at(c, 2) - at(b, 2) * at(c, 0)) +
                   at(a, 2) * (at(b, 0) * at(c, 1) - at(b, 1) * at(c, 0)));
    }
  return sum;
}

constexpr bool archetype_is_enough() {
  using number = archetype::scalar;
  using corner = archetype::point<number, 3>;
  const auto at = [](int x, int y, int z) { return corner::of(number(x), number(y), number(z)); };
  const archetype::mesh<corner> m(at(1, 1, 1), at(3, 1, 1), at(1, 4, 1), at(1, 1, 6));
  return irg::mesh_vertex_count(m) == 4 && six_volumes(m) == number(2 * 3 * 5);
}

}  // namespace

TEST_CASE("mesh: an archetype is enough") { CHECK_BOTH(archetype_is_enough()); }

TEST_CASE("mesh: a user's own mesh, its faces outward") {
  const triangles m{{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 5}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  CHECK(six_volumes(m) == 30.0f);
  CHECK(irg::mesh_face_vertex(m, 1, 2) == 3);
}

TEST_CASE("mesh: without faces") {
  const triangles m;
  CHECK(irg::mesh_vertex_count(m) == 0);
  CHECK(six_volumes(m) == 0.0f);
}

TEST_CASE("SpaceMesh: positions in space, of floats or doubles") {
  static_assert(irg::SpaceMesh<triangles>);
  static_assert(!irg::SpaceMesh<incomplete> && !irg::SpaceMesh<int>);
}
