// SPDX-License-Identifier: MIT
#include <irg/core/plane_concept.hpp>

#include <array>
#include <string>

#include <irg/math/vec.hpp>

#include "support/archetypes.hpp"
#include "support/check_both.hpp"
#include "support/own_types.hpp"

namespace {

using own::plain_plane;
struct mixed_plane {
  double a, b, c;
  float d;
};
struct no_distance {
  double a, b, c;
};
struct named {
  std::string a, b, c, d;
};

static_assert(irg::Plane<plain_plane> && irg::Plane<std::array<float, 4>> && irg::Plane<std::array<int, 4>>);
static_assert(irg::Plane<archetype::plane<archetype::scalar>>);
static_assert(!irg::Plane<mixed_plane> && !irg::Plane<no_distance> && !irg::Plane<named>);
static_assert(!irg::Plane<std::array<float, 3>> && !irg::Plane<std::array<float, 5>> && !irg::Plane<float>);
// A type that says that it is a vector or a position is no plane.
static_assert(!irg::Plane<irg::vec<float, 4>> && !irg::Plane<irg::hpoint<float, 3>>);
static_assert(!irg::Plane<archetype::vector<float, 4>>);
static_assert(std::same_as<irg::plane_traits<plain_plane>::scalar, double>);

// a*x + b*y + c*z + d at (x, y, z), through the concept alone.
template <irg::Plane P>
constexpr auto value_at(const P& p, irg::plane_scalar<P> x, irg::plane_scalar<P> y, irg::plane_scalar<P> z) {
  using irg::plane_coefficient;
  return plane_coefficient(p, 0) * x + plane_coefficient(p, 1) * y + plane_coefficient(p, 2) * z +
         plane_coefficient(p, 3);
}

constexpr bool archetype_is_enough() {
  using number = archetype::scalar;
  const archetype::plane<number> p(number(2), number(3), number(5), number(7));
  return value_at(p, number(1), number(10), number(100)) == number(539);
}

}  // namespace

TEST_CASE("plane: each coefficient in its place") {
  CHECK_BOTH(value_at(plain_plane{2, 3, 5, 7}, 1, 10, 100) == 539.0);
  CHECK_BOTH(value_at(std::array<int, 4>{2, 3, 5, 7}, 1, 10, 100) == 539);
  CHECK_BOTH(archetype_is_enough());
}

TEST_CASE("plane: Eigen and GLM vectors of four") {
#ifdef IRG_HAVE_EIGEN
  static_assert(irg::Plane<Eigen::Vector4d> && !irg::Plane<Eigen::Vector3d>);
  CHECK(value_at(Eigen::Vector4d(2, 3, 5, 7), 1, 10, 100) == 539.0);
#else
  MESSAGE("skipped: Eigen was not found");
#endif
#ifdef IRG_HAVE_GLM
  static_assert(irg::Plane<glm::vec4> && !irg::Plane<glm::vec3>);
  CHECK_BOTH(value_at(glm::dvec4(2, 3, 5, 7), 1, 10, 100) == 539.0);
#else
  MESSAGE("skipped: GLM was not found");
#endif
}
