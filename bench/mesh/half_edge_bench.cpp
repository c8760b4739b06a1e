// SPDX-License-Identifier: MIT
// From an indexed mesh to half-edges: irg and OpenMesh, which builds face by face. Faces in the order in which they lie
// beside each other, and in any order. Then normals of vertices, beside OpenMesh's, and beside two limits: each array
// read or written once, and the loads and sums that normals need, without their arithmetic.
#include <string>
#include <utility>
#include <vector>

#include <irg/mesh/normals.hpp>
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
  for (auto& c : m.corners) c.normal = irg::no_index;
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

using normals = std::vector<irg::vec<double, 3>>;

normals read_once(const body& m) {
  std::uint32_t sum = 0;
  for (const auto& c : m.corners) sum += c.position;
  for (const std::uint32_t f : m.face_starts) sum += f;
  normals out(m.positions.size());
  for (std::size_t v = 0; v < out.size(); ++v) out[v] = {m.positions[v].x + sum, m.positions[v].y, m.positions[v].z};
  return out;
}
/// The positions of each triangle's corners, as the faces name them, and nothing but one sum into each corner's normal.
normals gather_and_scatter(const body& m) {
  normals out(m.positions.size());
  for (std::size_t c = 0; c + 2 < m.corners.size(); c += 3) {
    const std::size_t at[3] = {m.corners[c].position, m.corners[c + 1].position, m.corners[c + 2].position};
    const irg::vec<double, 3> sum{m.positions[at[0]].x + m.positions[at[1]].x + m.positions[at[2]].x,
                                  m.positions[at[0]].y + m.positions[at[1]].y + m.positions[at[2]].y,
                                  m.positions[at[0]].z + m.positions[at[1]].z + m.positions[at[2]].z};
    for (const std::size_t i : at) out[i] += sum;
  }
  return out;
}
normals load_and_add(const body& m) {
  normals out(m.positions.size());
  for (std::size_t c = 0; c + 2 < m.corners.size(); c += 3) {
    const auto& i = m.corners;
    const auto sum = (m.positions[i[c + 1].position] - m.positions[i[c].position]) +
                     (m.positions[i[c + 2].position] - m.positions[i[c].position]);
    for (std::size_t k = 0; k < 3; ++k) out[i[c + k].position] += sum;
  }
  return out;
}

void enter_normals() {
  const body& m = keep(torus(false));
  auto& out = keep(normals{});
  const contest what{"vertex normals", "torus 10^6", "triangle", static_cast<std::int64_t>(m.face_count()), "", ""};
  const auto add = [&](const std::string& who, const auto& make) {
    contender c{who, [make] { make(); }};
    c.judge = [] { return errors{}; };
    enter(what, std::move(c));
  };
  add("irg", [&m, &out] { out = irg::vertex_normals(m); });
  add("limit: gather and scatter", [&m, &out] { out = gather_and_scatter(m); });
  add("limit: loads and sums", [&m, &out] { out = load_and_add(m); });
  add("limit: each array once", [&m, &out] { out = read_once(m); });
#ifdef IRG_HAVE_OPENMESH
  auto& o = keep(open_mesh{});
  std::vector<open_mesh::VertexHandle> v;
  for (const auto& p : m.positions) v.push_back(o.add_vertex({p.x, p.y, p.z}));
  for (std::size_t f = 0; f < m.face_count(); ++f)
    o.add_face(v[m.corner(f, 0).position], v[m.corner(f, 1).position], v[m.corner(f, 2).position]);
  o.request_face_normals();
  o.request_vertex_normals();
  add("OpenMesh", [&o] {
    o.update_face_normals();
    o.update_vertex_normals();
  });
#endif
}

}  // namespace

int main(int argc, char** argv) {
  enter_case("torus 10^6", false);
  enter_case("torus 10^6 any order", true);
  enter_normals();
  return run_benchmarks(argc, argv);
}
