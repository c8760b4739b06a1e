// SPDX-License-Identifier: MIT
// What irg::compiled has of mesh, for float and double.
#include <irg/mesh/convex_body.hpp>
#include <irg/mesh/crease_normals.hpp>
#include <irg/mesh/from_half_edges.hpp>
#include <irg/mesh/merge_positions.hpp>
#include <irg/mesh/merge_vertices.hpp>
#include <irg/mesh/mesh_faults.hpp>
#include <irg/mesh/normals.hpp>
#include <irg/mesh/orient_faces.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/mesh/teapot.hpp>
#include <irg/mesh/to_half_edges.hpp>
#include <irg/mesh/triangulate.hpp>

namespace irg {

#define IRG_FOR_NUMBERS(T)                                                                     \
  template void assign_crease_normals(mesh<T>&, T, normal_weight);                             \
  template mesh<T> to_mesh(const half_edge_mesh<T>&);                                          \
  template mesh<T> with_merged_positions(mesh<T>);                                             \
  template merged_vertices merge_vertices(const mesh<T>&);                                     \
  template std::vector<mesh_fault> list_faults(const mesh<T>&);                                \
  template mesh<T> shape_tetrahedron();                                                        \
  template mesh<T> shape_icosahedron();                                                        \
  template mesh<T> shape_dodecahedron();                                                       \
  template mesh<T> shape_grid(const grid_options&);                                            \
  template mesh<T> shape_sphere(const sphere_options&);                                        \
  template mesh<T> shape_torus(const torus_options<T>&);                                       \
  template mesh<T> shape_revolution(const std::vector<point<T, 2>>&, int);                     \
  template mesh<T> shape_cylinder(int);                                                        \
  template mesh<T> shape_cone(int);                                                            \
  template mesh<T> shape_teapot(const teapot_options&);                                        \
  template void detail::cut_mesh(mesh<T>&, const triangulate_options&);                        \
  template orient_status detail::orient_mesh(mesh<T>&);                                        \
  template checked<half_edge_mesh<T>, half_edge_status> detail::half_edges_of(const mesh<T>&); \
  template std::vector<vec<T, 3>> detail::normals_at_positions(const mesh<T>&, normal_weight); \
  template bool detail::is_closed_mesh(const mesh<T>&);                                        \
  template bool detail::is_convex_mesh(const mesh<T>&);
IRG_FOR_NUMBERS(float)
IRG_FOR_NUMBERS(double)
#undef IRG_FOR_NUMBERS

}  // namespace irg
