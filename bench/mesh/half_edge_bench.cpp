// SPDX-License-Identifier: MIT
// From an indexed mesh to half-edges: irg and OpenMesh, which builds face by face. Faces in the order in which they lie
// beside each other, and in any order.
#include <string>
#include <utility>
#include <vector>

#include <irg/mesh/shapes.hpp>
#include <irg/mesh/to_half_edges.hpp>

#include "../tests/support/random.hpp"
#include "support/measure.hpp"

#ifdef IRG_HAVE_OPENMESH
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wpedantic"
#pragma GCC diagnostic ignored "-Wconversion"
#endif
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif
#endif

namespace {

using namespace bench;
using body = irg::mesh<double>;

body torus(bool shuffled) {
  const int side = smoke() ? 10 : 1000;
  body m = irg::shape_torus<double>({.major_segments = side, .minor_segments = side / 2});
  m.normals.clear();
  for (auto& c : m.corners) c.normal = irg::mesh_corner::none;
  test::random random(20);
  for (std::size_t f = m.face_count(); shuffled && f > 1; --f) {
    const auto g = static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(f) - 1));
    for (std::size_t k = 0; k < 3; ++k) std::swap(m.corners[3 * f - 3 + k], m.corners[3 * g + k]);
  }
  return m;
}

#ifdef IRG_HAVE_OPENMESH
struct traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using open_mesh = OpenMesh::TriMesh_ArrayKernelT<traits>;

std::size_t build(const body& m) {
  open_mesh o;
  o.reserve(m.positions.size(), m.corners.size() / 2, m.face_count());
  std::vector<open_mesh::VertexHandle> v;
  v.reserve(m.positions.size());
  for (const auto& p : m.positions) v.push_back(o.add_vertex({p.x, p.y, p.z}));
  const auto at = [&](std::size_t f, std::size_t k) { return v[m.corner(f, k).position]; };
  for (std::size_t f = 0; f < m.face_count(); ++f) o.add_face(at(f, 0), at(f, 1), at(f, 2));
  return o.n_halfedges();
}
#endif

void enter_case(const std::string& name, bool shuffled) {
  const body& m = keep(torus(shuffled));
  auto& count = keep(std::size_t{0});
  const contest what{"half-edges of a mesh", name, "triangle", static_cast<std::int64_t>(m.face_count()), "", ""};
  const auto add = [&](const std::string& who, const auto& build_one) {
    contender c{who, [&m, &count, build_one] { count = build_one(m); }};
    c.judge = [&m, &count, who] {
      errors e;
      e.wrong = count == m.corners.size() ? 0 : 1;
      if (e.wrong != 0 && who == "irg") e.broken = "half-edges are missing";
      return e;
    };
    enter(what, std::move(c));
  };
  add("irg", [](const body& b) { return irg::to_half_edges(b).value.half_edges.size(); });
#ifdef IRG_HAVE_OPENMESH
  add("OpenMesh", [](const body& b) { return build(b); });
#endif
}

}  // namespace

int main(int argc, char** argv) {
  enter_case("torus 10^6", false);
  enter_case("torus 10^6 any order", true);
  return run_benchmarks(argc, argv);
}
