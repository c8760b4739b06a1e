// SPDX-License-Identifier: MIT
#include <irg/mesh/crease_normals.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <new>
#include <vector>

#include <irg/mesh/shapes.hpp>
#include <irg/mesh/teapot.hpp>
#include <irg/mesh/validate.hpp>

#include "short_memory.hpp"
#include "support/check_both.hpp"
#include "support/mesh_facts.hpp"
#include "support/random.hpp"

namespace {

using irg::mesh;
using irg::mesh_corner;
using irg::vec;

constexpr double degrees = irg::pi<double> / 180;

template <class T>
constexpr mesh<T> creased(mesh<T> m, double angle, irg::normal_weight weight = irg::normal_weight::angle) {
  irg::assign_crease_normals(m, static_cast<T>(angle * degrees), weight);
  return m;
}

// Whether every corner's normal is its own face's, but for the rounding of a product and a quotient.
template <class T>
constexpr bool is_faceted(const mesh<T>& m) {
  for (std::size_t f = 0; f < m.face_count(); ++f)
    for (std::size_t k = 0; k < m.face_size(f); ++k)
      if (!(length(m.normals[m.corner(f, k).normal] - *irg::face_normal(m, f)) <=
            3 * std::numeric_limits<T>::epsilon()))
        return false;
  return true;
}

// A strip of two triangles that turns by the angle at the edge from (0, 0, 0) to (0, 0, 1).
constexpr mesh<double> bent(double x, double y) {
  mesh<double> m;
  m.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {x, y, 0}};
  irg::add_face(m, std::array{0, 1, 2});
  irg::add_face(m, std::array{1, 0, 3});
  return m;
}

static_assert(creased(test::without_normals(irg::shape_cube<double>()), 60).normals.size() == 24);
static_assert(is_faceted(creased(test::without_normals(irg::shape_cube<double>()), 60)));
static_assert(creased(test::without_normals(irg::shape_cube<double>()), 91).normals.size() == 8);
static_assert(creased(mesh<double>{}, 60).normals.empty());
static_assert(creased(bent(-1, 0), 0).normals.size() == 4);
static_assert(creased(bent(0, 1), 89).normals.size() == 6);
constexpr std::size_t normals_without_crease() {
  mesh<double> m = bent(0, 1);
  irg::assign_crease_normals(m, std::numeric_limits<double>::quiet_NaN());
  return m.normals.size();
}
static_assert(normals_without_crease() == 6);

// The definition, in another way: the faces around a position are visited from a face over smooth edges.
bool meets(const mesh<double>& m, std::size_t f, std::uint32_t a, std::uint32_t b) {  // f has the edge from a to b
  for (std::size_t k = 0; k < m.face_size(f); ++k)
    if (m.corner(f, k).position == a && m.corner(f, (k + 1) % m.face_size(f)).position == b) return true;
  return false;
}
std::vector<bool> group_of(const mesh<double>& m, std::size_t face, std::uint32_t v, double crease) {
  std::vector<bool> in(m.face_count(), false);
  in[face] = true;
  for (bool grows = true; grows;) {
    grows = false;
    for (std::size_t f = 0; f < m.face_count(); ++f)
      for (std::size_t g = 0; g < m.face_count(); ++g)
        for (std::uint32_t w = 0; w < m.positions.size() && in[f] && !in[g]; ++w) {
          const bool forth = meets(m, f, v, w) && meets(m, g, w, v), back = meets(m, f, w, v) && meets(m, g, v, w);
          if (!forth && !back) continue;
          int uses = 0;
          for (std::size_t h = 0; h < m.face_count(); ++h) uses += meets(m, h, v, w) + meets(m, h, w, v);
          const auto a = irg::face_normal(m, f), b = irg::face_normal(m, g);
          if (uses == 2 && a && b && std::acos(std::fmin(1, dot(*a, *b))) <= crease) in[g] = grows = true;
        }
  }
  return in;
}

}  // namespace

TEST_CASE("crease normals: the groups are those of the definition") {
  test::random r(60);
  int smooth = 0, sharp = 0;
  for (int trial = 0; trial < 40; ++trial) {
    mesh<double> m = trial % 2 ? test::without_normals(irg::shape_icosahedron<double>())
                               : test::without_normals(irg::shape_cube<double>());
    for (auto& p : m.positions) p = {p.x + 0.6 * r.unit(), p.y + 0.6 * r.unit(), p.z + 0.6 * r.unit()};
    if (trial % 5 == 0) m.face_starts.pop_back(), m.corners.resize(m.face_starts.back());  // a hole
    if (trial % 7 == 0) irg::add_face(m, std::array{0, 1, 2});  // more than two at an edge
    if (trial % 3 == 0) std::swap(m.corners[0], m.corners[1]);  // the wrong way round
    const double crease = r.unit() * 120;
    const mesh<double> with = creased(m, crease);
    REQUIRE(irg::validate(with) == irg::mesh_finding{});
    for (std::size_t f = 0; f < m.face_count(); ++f)
      for (std::size_t k = 0; k < m.face_size(f); ++k) {
        const std::uint32_t v = m.corner(f, k).position;
        const auto in = group_of(m, f, v, crease * degrees);
        mesh<double> part = m;  // the group alone: vertex_normals knows no other faces
        part.corners.clear();
        part.face_starts = {0};
        for (std::size_t g = 0; g < m.face_count(); ++g)
          if (in[g]) {
            for (std::size_t i = 0; i < m.face_size(g); ++i) part.corners.push_back(m.corner(g, i));
            part.face_starts.push_back(static_cast<std::uint32_t>(part.corners.size()));
          }
        (part.face_count() > 1 ? smooth : sharp) += 1;
        CHECK(with.normals[with.corner(f, k).normal] == irg::vertex_normals(part, irg::normal_weight::angle)[v]);
      }
  }
  CHECK(smooth > 200);
  CHECK(sharp > 200);
}

TEST_CASE("crease normals: bodies") {
  for (const auto& body :
       {test::without_normals(irg::shape_cube<double>()), test::without_normals(irg::shape_tetrahedron<double>()),
        test::without_normals(irg::shape_octahedron<double>()),
        test::without_normals(irg::shape_icosahedron<double>())}) {
    mesh<double> bare = body;
    bare.normals.clear();
    for (mesh_corner& c : bare.corners) c.normal = irg::no_index;
    const mesh<double> all = creased(bare, 180);  // every edge smooth: one normal at a position
    CHECK(all.normals.size() == bare.positions.size());
    const auto at = irg::vertex_normals(bare, irg::normal_weight::angle);
    for (const mesh_corner& c : all.corners) CHECK(all.normals[c.normal] == at[c.position]);
    CHECK(is_faceted(creased(bare, 30)));
  }
  mesh<double> teapot = irg::shape_teapot<double>();
  const mesh<double> same = creased(teapot, 60);  // which has normals
  CHECK(same == teapot);
}

TEST_CASE("crease normals: only corners without a normal get one") {
  mesh<double> m = test::without_normals(irg::shape_cube<double>());
  m.normals = {vec<double, 3>{0, 0, 5}};
  m.corners[0].normal = 0;
  m.corners[7].normal = 0;
  const mesh<double> with = creased(m, 60);
  CHECK(with.normals[0] == vec<double, 3>{0, 0, 5});
  CHECK(with.corners[0].normal == 0);
  CHECK(with.corners[7].normal == 0);
  for (std::size_t c = 0; c < with.corners.size(); ++c)
    if (c != 0 && c != 7) CHECK(with.corners[c].normal > 0);
}

#ifdef __cpp_exceptions
TEST_CASE("crease normals: where memory gives out, the mesh is as it was") {
  const mesh<double> cube = test::without_normals(irg::shape_cube<double>());
  for (long left = 0;; ++left) {
    REQUIRE(left < 1000);
    mesh<double> m = cube;
    test::allocations_left = left;
    bool failed = false;
    try {
      irg::assign_crease_normals(m, 0.5);
    } catch (const std::bad_alloc&) {
      failed = true;
    }
    test::allocations_left = -1;
    if (!failed) break;
    CHECK(m == cube);
  }
}
#endif

TEST_CASE_TEMPLATE("crease normals: hostile meshes", T, float, double) {
  constexpr T largest = std::numeric_limits<T>::max(), smallest = std::numeric_limits<T>::denorm_min();
  for (const T size : {largest, T(1), smallest * 16}) {
    mesh<T> m = test::without_normals(irg::shape_cube<T>());
    for (auto& p : m.positions)
      for (int i = 0; i < 3; ++i) p[i] = p[i] > 0 ? size : size == largest ? -largest : T(0);
    CHECK(is_faceted(creased(m, 60)));
  }
  mesh<T> m;
  m.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {std::numeric_limits<T>::quiet_NaN(), 0, 0}};
  irg::add_face(m, std::array{0, 1, 1});  // a position twice
  irg::add_face(m, std::array{0, 0, 0});  // no area
  irg::add_face(m, std::array{5, 1, 0});  // no number
  irg::add_face(m, std::array{0, 1, 2, 3});  // not flat
  irg::add_face(m, std::array{1, 0, 4});
  irg::add_face(m, std::array{1, 0, 4});  // twice the same
  m = creased(m, 60);
  for (const mesh_corner& c : m.corners) {
    REQUIRE(c.normal < m.normals.size());
    const double size = static_cast<double>(irg::length(m.normals[c.normal]));
    CHECK((size == 0 || std::fabs(size - 1) < 1e-6));
  }
  CHECK(m.normals[m.corners[3].normal] == vec<T, 3>{});
}

TEST_CASE("crease normals: a fan of many faces around one position takes no square of their number") {
  mesh<double> m;
  constexpr int count = 200000;
  m.positions.push_back({0, 0, 1});
  for (int i = 0; i < count; ++i)
    m.positions.push_back({std::cos(i * 1e-5 * irg::pi<double>), std::sin(i * 1e-5 * irg::pi<double>), 0});
  for (int i = 1; i < count; ++i) irg::add_face(m, std::array{0, i, i + 1});
  CHECK(creased(m, 60).normals.size() == static_cast<std::size_t>(count) + 1);
}
