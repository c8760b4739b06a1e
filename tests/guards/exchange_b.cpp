// SPDX-License-Identifier: MIT
// The unit for the newer instruction set: makes objects for the other one, and reads its objects.
#include "exchange.hpp"

#define TEXT_OF(name) #name
#define EXPANDED_TEXT_OF(name) TEXT_OF(name)
#ifndef __AVX2__
#error "this unit must be built for a newer instruction set than the other one"
#endif

const char* other_namespace() { return EXPANDED_TEXT_OF(IRG_ABI); }

irg::mesh<float> make_mesh() {
  irg::mesh<float> m;
  m.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.5f}};
  m.normals = {irg::cross(m.positions[1] - m.positions[0], m.positions[2] - m.positions[0])};
  irg::add_face(m, std::vector<int>{0, 1, 2});
  irg::add_face(m, std::vector<int>{0, 2, 3});
  m.parts = {{"a thing", "a group of a long name that is no small string", "red", 0, 2}};
  return m;
}

irg::image<irg::rgba8> make_image() {
  irg::image<irg::rgba8> picture(5, 3, irg::rgba8{1, 2, 3, 255});
  picture(4, 2) = {10, 20, 30, 40};
  return picture;
}

irg::result<irg::mesh<float>> fail_to_make_mesh() { return irg::parse_error{7, 9, "no mesh today"}; }

float sum_of_dots(const irg::mesh<float>& m) {
  float sum = 0;
  for (const auto& p : m.positions) sum += irg::dot(irg::to_vec(p), irg::to_vec(p) * 2.0f);
  return sum;
}

int sum_of_greens(const irg::image_view<const irg::rgba8>& picture) {
  int sum = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) sum += picture(x, y).g;
  return sum;
}
