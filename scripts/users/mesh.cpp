#include <cstdio>
#include <irg/mesh/normals.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/mesh/teapot.hpp>
#include <irg/mesh/validate.hpp>

int main() {
  auto pot = irg::shape_teapot<double>();
  irg::assign_vertex_normals(pot, irg::normal_weight::angle);
  const auto fault = irg::validate(pot);
  std::printf("%zu faces, %d\n", pot.face_count(), static_cast<int>(fault.defect));
  for (const auto& n : irg::vertex_normals(irg::shape_torus<double>())) std::printf("%.17g\n", n.x);
}
