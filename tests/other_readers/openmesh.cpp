// SPDX-License-Identifier: MIT
// Writes bodies in every format and encoding into the folder that is named, and reads each file by OpenMesh: the same
// vertices, the same faces, the same normals and texture coordinates where the format has one for each vertex.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include <irg/io/mesh_file.hpp>
#include <irg/mesh/shapes.hpp>

namespace {

using open_mesh = OpenMesh::PolyMesh_ArrayKernelT<>;  // floats
using options = OpenMesh::IO::Options;

int tried = 0, failed = 0;

/// Whether a number has come through a text that a reader may have rounded twice.
bool near(double a, double b) { return std::abs(a - b) <= 1e-6 * std::abs(a); }

/// What differs between the body and what OpenMesh made of the file; "" when nothing does.
template <class T>
std::string difference(const irg::mesh<T>& m, const std::string& path, irg::mesh_format format, bool attributes) {
  open_mesh read;
  read.request_vertex_normals();
  read.request_vertex_texcoords2D();
  options found(options::VertexNormal | options::VertexTexCoord);
  if (!OpenMesh::IO::read_mesh(read, path, found)) return "is refused";
  const bool triangles = format == irg::mesh_format::stl;
  if (read.n_vertices() != m.positions.size()) return "has other vertices";
  if (!triangles && read.n_faces() != m.face_count()) return "has other faces";
  if (triangles) return read.n_faces() == irg::triangulated(m).face_count() ? "" : "has other triangles";
  for (std::size_t v = 0; v < m.positions.size(); ++v) {
    const open_mesh::VertexHandle h(static_cast<int>(v));
    for (unsigned i = 0; i < 3; ++i)
      if (!near(static_cast<double>(m.positions[v][static_cast<int>(i)]), static_cast<double>(read.point(h)[i])))
        return "has another position";
    if (!attributes || format == irg::mesh_format::obj) continue;
    for (unsigned i = 0; i < 3; ++i)
      if (!near(static_cast<double>(m.normals[v][static_cast<int>(i)]), static_cast<double>(read.normal(h)[i])))
        return "has another normal";
    for (unsigned i = 0; i < 2; ++i)
      if (!near(static_cast<double>(m.texcoords[v][static_cast<int>(i)]), static_cast<double>(read.texcoord2D(h)[i])))
        return "has another texture coordinate";
  }
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    std::vector<std::size_t> corners;
    for (const auto v : read.fv_range(open_mesh::FaceHandle(static_cast<int>(f))))
      corners.push_back(static_cast<std::size_t>(v.idx()));
    if (corners.size() != m.face_size(f)) return "has a face of other corners";
    std::size_t turn = 0;  // OpenMesh may begin a face elsewhere
    while (turn < corners.size() && corners[turn] != m.corner(f, 0).position) ++turn;
    for (std::size_t k = 0; k < corners.size(); ++k)
      if (corners[(turn + k) % corners.size()] != m.corner(f, k).position) return "has a face of other corners";
  }
  return "";
}

template <class T>
void try_body(const std::string& folder, const std::string& name, irg::mesh<T> m, bool attributes) {
  m.normals.clear();
  m.texcoords.clear();
  m.parts.clear();
  const std::uint32_t none = irg::no_index;
  for (irg::mesh_corner& c : m.corners)
    c = {c.position, attributes ? c.position : none, attributes ? c.position : none};
  for (const irg::point<T, 3>& p : m.positions) {
    if (!attributes) break;
    m.normals.push_back({p.z, p.x, p.y});
    m.texcoords.push_back({p.y, p.z});
  }
  for (const char* ending : {"obj", "stl", "ply", "off"})
    for (const irg::mesh_encoding e :
         {irg::mesh_encoding::text, irg::mesh_encoding::little_endian, irg::mesh_encoding::big_endian}) {
      const std::string path = folder + "/body." + ending;
      const irg::mesh_format format = *irg::mesh_format_of_name(path);
      const bool has_form = e == irg::mesh_encoding::text || format == irg::mesh_format::ply ||
                            (format == irg::mesh_format::stl && e == irg::mesh_encoding::little_endian);
      if (!has_form) continue;
      const auto saved = irg::save_mesh(path, m, e);
      const std::string wrong = saved ? difference(m, path, format, attributes) : saved.error().message;
      ++tried;
      failed += wrong.empty() ? 0 : 1;
      if (!wrong.empty())
        std::printf("other_readers: %s as %s, encoding %d: the file %s\n", name.c_str(), ending, static_cast<int>(e),
                    wrong.c_str());
    }
}

/// A prism over a polygon of so many corners.
template <class T>
irg::mesh<T> prism(std::uint32_t corners) {
  irg::mesh<T> m;
  for (std::uint32_t i = 0; i < 2 * corners; ++i) {
    const double angle = 6.283185307179586 * (i % corners) / corners;
    m.positions.push_back(
        {static_cast<T>(std::cos(angle)), static_cast<T>(std::sin(angle)), static_cast<T>(i / corners)});
  }
  std::vector<std::uint32_t> bottom, top;
  for (std::uint32_t i = 0; i < corners; ++i) {
    bottom.push_back(corners - 1 - i);
    top.push_back(corners + i);
  }
  irg::add_face(m, bottom);
  irg::add_face(m, top);
  for (std::uint32_t i = 0; i < corners; ++i) {
    const std::uint32_t next = (i + 1) % corners;
    irg::add_face(m, std::vector{i, next, corners + next, corners + i});
  }
  return m;
}

template <class T>
void try_bodies(const std::string& folder) {
  for (const bool attributes : {false, true}) {
    try_body<T>(folder, "cube", irg::shape_cube<T>(), attributes);
    try_body<T>(folder, "tetrahedron", irg::shape_tetrahedron<T>(), attributes);
    try_body<T>(folder, "sphere", irg::shape_sphere<T>(), attributes);
    try_body<T>(folder, "prism of 255 sides", prism<T>(255), attributes);
    try_body<T>(folder, "prism of 300 sides", prism<T>(300), attributes);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return std::puts("usage: openmesh FOLDER"), 2;
  try_bodies<float>(argv[1]);
  try_bodies<double>(argv[1]);
  std::printf("other_readers: OpenMesh read %d of %d files as they were written\n", tried - failed, tried);
  return failed == 0 ? 0 : 1;
}
