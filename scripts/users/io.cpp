#include <cstdio>
#include <irg/io/image_file.hpp>
#include <irg/io/mesh_file.hpp>
#include <irg/mesh/shapes.hpp>

int main() {
  if (!irg::save_mesh("cube.obj", irg::shape_cube<double>())) return 1;
  const auto read = irg::load_mesh("cube.obj");
  if (!read) return 1;
  std::printf("%zu faces\n", read->face_count());
  return irg::save_image("white.png", irg::image<irg::rgba8>(64, 48, {255, 255, 255, 255})) ? 0 : 1;
}
