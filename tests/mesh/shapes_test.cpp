// SPDX-License-Identifier: MIT
#include <irg/mesh/shapes.hpp>

#include <irg/mesh/validate.hpp>

#include "support/check_both.hpp"

namespace {

// The volume by the divergence theorem, six times over: positive when faces run counter-clockwise seen from outside.
template <class T>
constexpr T six_volumes(const irg::mesh<T>& m) {
  T sum = 0;
  for (std::size_t f = 0; f < m.face_count(); ++f)
    for (std::size_t k = 1; k + 1 < m.face_size(f); ++k) {
      const auto at = [&](std::size_t i) { return irg::to_vec(m.positions[m.corner(f, i).position]); };
      sum += irg::dot(at(0), irg::cross(at(k), at(k + 1)));
    }
  return sum;
}

template <class T>
constexpr bool sound_and_outward(const irg::mesh<T>& m) {
  return irg::validate(m) == irg::mesh_finding{} && six_volumes(m) > 0;
}

TEST_CASE("shapes: every body is valid and faces outward, in float and in double") {
  CHECK_BOTH(sound_and_outward(irg::shape_cube<double>()));
  CHECK_BOTH(sound_and_outward(irg::shape_tetrahedron<float>()));
  CHECK_BOTH(sound_and_outward(irg::shape_octahedron<double>()));
  CHECK_BOTH(sound_and_outward(irg::shape_icosahedron<double>()));
  CHECK(sound_and_outward(irg::shape_sphere<float>()));
  CHECK(sound_and_outward(irg::shape_torus<double>()));
  CHECK(sound_and_outward(irg::shape_teapot<float>()));
  CHECK(sound_and_outward(irg::shape_teapot<double>()));
}

TEST_CASE("shapes: the cube of the course has volume 1") { CHECK_BOTH(six_volumes(irg::shape_cube<double>()) == 6.0); }

}  // namespace
