#include <cstdio>
#include <irg/mesh/shapes.hpp>
#include <irg/solid/boolean.hpp>

int main() {
  const auto cube = irg::shape_cube<double>();
  const auto ball = irg::shape_sphere<double>();
  const auto cut = irg::solid_boolean(cube, ball, irg::boolean_operation::difference);
  std::printf("%zu faces\n", cut.value.face_count());
  for (const auto& p : cut.value.positions) std::printf("%.17g %.17g %.17g\n", p.x, p.y, p.z);
}
