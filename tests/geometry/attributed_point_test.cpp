// SPDX-License-Identifier: MIT
#include <irg/geometry/attributed_point.hpp>

#include <array>

#include "support/check_both.hpp"
#include "support/rational.hpp"

namespace {

struct own_vertex {
  irg::point<float, 2> position;
  int label = 0;
};
struct no_vertex {
  int position = 0;
};

}  // namespace

TEST_CASE("attributed_point: what is a polygon vertex, and what lies between two") {
  using A = irg::attributed_point<double, 2, 2>;
  static_assert(irg::PolygonVertex<A> && irg::PolygonVertex<irg::point<float, 3>> && irg::PolygonVertex<own_vertex>);
  static_assert(irg::PolygonVertex<std::array<double, 2>> && !irg::PolygonVertex<no_vertex> &&
                !irg::PolygonVertex<int>);
  static_assert(std::is_same_v<irg::vertex_scalar<own_vertex>, float>);
  static_assert(std::is_same_v<irg::vertex_position<A>, irg::point<double, 2>>);
  constexpr A a{{0, 0}, {1, 10}}, b{{8, 0}, {3, 20}};
  CHECK_BOTH(irg::lerp_vertex{}(a, b, 0.5).attributes[0] == 2);
  CHECK_BOTH(irg::lerp_vertex{}(a, b, 0.25).attributes[1] == 12.5);
  CHECK_BOTH(irg::lerp_vertex{}(a, b, 0.0).attributes[1] == 10);
  using R = irg::attributed_point<test::rational, 3, 1>;
  constexpr R p{{0, 0, 0}, {1}}, q{{0, 0, 9}, {2}};
  CHECK_BOTH((irg::lerp_vertex{}(p, q, test::rational(1, 3)).attributes[0] == test::rational(4, 3)));
}
