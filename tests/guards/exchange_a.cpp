// SPDX-License-Identifier: MIT
// The unit for any processor: asks the other one for objects, compares them with its own, and hands them back.
#include <cstdio>
#include <cstring>

#include "exchange.hpp"

#define TEXT_OF(name) #name
#define EXPANDED_TEXT_OF(name) TEXT_OF(name)
#ifdef __AVX__
#error "this unit must be built for any x86-64"
#endif

namespace {

int wrong = 0;

void check(bool holds, const char* what) {
  if (holds) return;
  std::printf("wrong: %s\n", what);
  ++wrong;
}

}  // namespace

int main() {
  check(std::strcmp(other_namespace(), EXPANDED_TEXT_OF(IRG_ABI)) != 0, "the units' namespaces differ");

  const irg::mesh<float> m = make_mesh();
  check(m.positions.size() == 4 && m.positions[3] == irg::point<float, 3>{0, 1, 0.5f}, "the mesh's positions");
  check(m.normals.size() == 1 && m.normals[0] == irg::vec<float, 3>{0, 0, 1}, "the mesh's normal");
  check(m.face_count() == 2 && m.face_size(1) == 3 && m.corner(1, 2).position == 3, "the mesh's faces");
  check(m.parts.size() == 1 && m.parts[0].group == "a group of a long name that is no small string", "the mesh's part");
  float dots = 0;
  for (const auto& p : m.positions) dots += irg::dot(irg::to_vec(p), irg::to_vec(p) * 2.0f);
  check(dots == 8.5f && sum_of_dots(m) == dots, "both units compute the same sum");
  irg::mesh<float> own = m;
  irg::add_face(own, std::vector<int>{3, 1, 0});
  check(!(own == make_mesh()) && own.face_count() == 3, "a copy that was changed");

  irg::image<irg::rgba8> picture = make_image();
  check(picture.width() == 5 && picture.height() == 3 && picture(4, 2) == irg::rgba8{10, 20, 30, 40}, "the image");
  picture(0, 0).g = 100;
  check(sum_of_greens(static_cast<const irg::image<irg::rgba8>&>(picture).view()) == 13 * 2 + 20 + 100,
        "the image sent back");

  const auto failed = fail_to_make_mesh();
  check(!failed && failed.error().line == 7 && failed.error().column == 9, "the error's place");
  check(std::strcmp(failed.error().message, "no mesh today") == 0, "the error's message");
  return wrong == 0 ? 0 : 1;
}
