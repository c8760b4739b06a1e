// SPDX-License-Identifier: MIT
#include <irg/mesh/merge_positions.hpp>

#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include <irg/mesh/shapes.hpp>
#include <irg/mesh/validate.hpp>

#include "support/check_both.hpp"
#include "support/mesh_files.hpp"
#include "support/random.hpp"

namespace {

using irg::with_merged_positions;

template <class T>
constexpr irg::mesh<T> two_triangles(irg::point<T, 3> a, irg::point<T, 3> b) {
  irg::mesh<T> m;
  m.positions = {{0, 0, 0}, {1, 0, 0}, a, b, {1, 0, 0}, {0, 1, 0}};
  irg::add_face(m, std::initializer_list<int>{0, 1, 2});
  irg::add_face(m, std::initializer_list<int>{3, 4, 5});
  return m;
}

}  // namespace

TEST_CASE("with_merged_positions: equal positions become the first of them, at compile time, too") {
  CHECK_BOTH([] {
    const auto m = with_merged_positions(two_triangles<double>({5, 5, 5}, {0, 0, 0}));
    return m.positions == std::vector<irg::point<double, 3>>{{0, 0, 0}, {1, 0, 0}, {5, 5, 5}, {0, 1, 0}} &&
           m.corner(1, 0).position == 0 && m.corner(1, 1).position == 1 && m.corner(1, 2).position == 3;
  }());
  CHECK_BOTH(with_merged_positions(irg::mesh<float>{}) == irg::mesh<float>{});
  // -0 is 0, but neighbours in the last place are not the same
  CHECK_BOTH(with_merged_positions(two_triangles<float>({-0.0f, -0.0f, 0}, {0, 0, -0.0f})).positions.size() == 3);
  CHECK_BOTH(with_merged_positions(two_triangles<double>({0, 0, 5e-324}, {0, 0, 0})).positions.size() == 4);
  CHECK_BOTH(with_merged_positions(two_triangles<double>({1e300, 1e-300, 0}, {1e300, 0, 1e-300})).positions.size() ==
             5);
}

TEST_CASE("with_merged_positions: what is no number stays apart and breaks no order") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto m = with_merged_positions(two_triangles<double>({nan, 0, 0}, {nan, 0, 0}));
  CHECK(m.positions.size() == 4);
}

TEST_CASE("with_merged_positions: a map from numbers to places says the same") {
  test::random r(20);
  for (int trial = 0; trial < 300; ++trial) {
    irg::mesh<double> m;
    const std::int64_t count = r.integer(1, 200), kinds = r.integer(1, 4);
    for (std::int64_t v = 0; v < count; ++v) {
      const double x = static_cast<double>(r.integer(-kinds, kinds)) * 1e-310;
      const double y = static_cast<double>(r.integer(0, kinds)) * 1e300, z = r.integer(0, 1) == 0 ? -0.0 : 0.0;
      m.positions.push_back({x, y, z});
    }
    for (std::int64_t f = 0; f < count; ++f) {
      const std::int64_t a = r.integer(0, count - 1), b = r.integer(0, count - 1);
      irg::add_face(m, std::vector<std::int64_t>{a, b, r.integer(0, count - 1)});
    }
    std::map<std::vector<double>, std::uint32_t> places;
    std::vector<irg::point<double, 3>> kept;
    irg::mesh<double> expected = m;
    std::vector<std::uint32_t> to;
    for (const auto& p : m.positions) {
      const auto [at, is_new] = places.try_emplace({p[0], p[1], p[2]}, static_cast<std::uint32_t>(kept.size()));
      if (is_new) kept.push_back(p);
      to.push_back(at->second);
    }
    expected.positions = kept;
    for (irg::mesh_corner& c : expected.corners) c.position = to[c.position];
    CHECK(with_merged_positions(m) == expected);
  }
}

TEST_CASE("with_merged_positions: a closed body whose faces were torn apart is whole again") {
  const irg::mesh<float> sphere = irg::shape_sphere<float>();
  irg::mesh<float> torn = sphere;
  torn.positions.clear();
  for (irg::mesh_corner& c : torn.corners) {
    torn.positions.push_back(sphere.positions[c.position]);
    c.position = static_cast<std::uint32_t>(torn.positions.size() - 1);
  }
  CHECK(test::in_order_of_use(with_merged_positions(torn)) == test::in_order_of_use(sphere));
}
