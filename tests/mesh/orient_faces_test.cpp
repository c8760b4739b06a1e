// SPDX-License-Identifier: MIT
#include <irg/mesh/orient_faces.hpp>

#include <initializer_list>

#include <irg/mesh/convex_body.hpp>
#include <irg/mesh/shapes.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

constexpr irg::mesh<double> moebius_strip() {
  irg::mesh<double> m;
  for (int i = 0; i < 6; ++i) m.positions.push_back({double(i), double(i % 2), double(i * i)});
  for (const auto& f : {std::initializer_list<int>{0, 1, 3, 2}, {2, 3, 5, 4}, {4, 5, 0, 1}}) irg::add_face(m, f);
  return m;
}

}  // namespace

TEST_CASE("orient_faces: one turned face is turned back; a strip with one side is left alone; at compile time, too") {
  CHECK_BOTH([] {
    auto m = irg::shape_cube<double>();
    const auto before = m;
    irg::turn_face(m, 5);
    return m != before && irg::orient_faces(m) == irg::orient_status::ok && m == before;
  }());
  CHECK_BOTH([] {
    auto m = moebius_strip();
    const auto before = m;
    return irg::orient_faces(m) == irg::orient_status::one_sided && m == before;
  }());
  CHECK_BOTH([] {
    irg::mesh<float> none;
    return irg::orient_faces(none) == irg::orient_status::ok && none.face_count() == 0;
  }());
}

TEST_CASE("orient_faces: bodies of which half the faces are turned at random become whole") {
  test::random r(20);
  for (int trial = 0; trial < 60; ++trial) {
    auto m = trial % 2 ? irg::shape_torus<double>() : irg::shape_sphere<double>({.slices = 12, .stacks = 7});
    const auto before = m;
    for (std::size_t f = 0; f < m.face_count(); ++f)
      if (r.integer(0, 1) == 1) irg::turn_face(m, f);
    const bool first_is_turned = m.corners[1] != before.corners[1];
    CHECK(irg::orient_faces(m) == irg::orient_status::ok);
    CHECK(irg::is_closed(m) == irg::is_closed(before));
    auto expected = before;
    for (std::size_t f = 0; f < m.face_count() && first_is_turned; ++f) irg::turn_face(expected, f);
    CHECK(m == expected);
  }
}
