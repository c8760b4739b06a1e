// SPDX-License-Identifier: MIT
#include <irg/solid/csg_tree.hpp>

#include <initializer_list>
#include <vector>

#include <irg/mesh/shapes.hpp>
#include <irg/solid/measures.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/solid_facts.hpp"

namespace {

using irg::boolean_operation;
using tree = irg::csg_tree<double>;
using spans = std::vector<irg::solid_span<double>>;

constexpr tree box(double x, double y, double z, double size) {
  auto m = irg::shape_cube<double>();
  m.normals.clear();
  for (auto& c : m.corners) c.normal = irg::mesh_corner::none;
  for (auto& p : m.positions) p = {p.x * size + x, p.y * size + y, p.z * size + z};
  return tree(m);
}

}  // namespace

TEST_CASE("csg_tree: spans of a box with a hole, through sides and corners, at compile time, too") {
  constexpr auto is = [](double x, double y, std::initializer_list<double> ends) {
    const tree t = irg::combine(box(0, 0, 0, 4), box(1, 1, 1, 2), boolean_operation::difference);
    const spans s = irg::spans_upward(t, x, y);
    const double* end = ends.begin();
    if (2 * s.size() != ends.size()) return false;
    for (const auto& span : s) {
      if (span.from != end[0] || span.to != end[1]) return false;
      end += 2;
    }
    return true;
  };
  CHECK_BOTH(is(2, 2.5, {0, 1, 3, 4}));
  CHECK_BOTH(is(0.5, 0.5, {0, 4}));
  CHECK_BOTH(is(9, 0.5, {}));
  CHECK_BOTH(is(1, 1, {0, 1, 3, 4}));
  CHECK_BOTH(is(4, 4, {}));
  CHECK_BOTH(is(0, 0, {0, 4}));
  CHECK_BOTH(irg::spans_upward(tree(), 0.0, 0.0).empty());
  CHECK(irg::mesh_of(tree()).value.face_count() == 0);
  CHECK(irg::mesh_of(irg::combine(tree(), box(0, 0, 0, 1), boolean_operation::unite)).value.face_count() == 12);
  CHECK(irg::mesh_of(box(0, 0, 0, 1)).value.face_count() == 12);
}

TEST_CASE("csg_tree: trees of lattice boxes at random: mesh and spans say the same, to the last bit") {
  test::random r(20);
  for (int trial = 0; trial < 60; ++trial) {
    std::vector<tree> parts;
    for (int i = 0; i < 6; ++i) {
      const auto at = [&] { return static_cast<double>(r.integer(0, 4)); };
      const double x = at(), y = at(), z = at();
      parts.push_back(box(x, y, z, static_cast<double>(r.integer(1, 4))));
    }
    while (parts.size() > 1) {  // any two become one
      const auto i = static_cast<std::size_t>(r.integer(0, static_cast<std::int64_t>(parts.size()) - 2));
      parts[i] = irg::combine(parts[i], parts[i + 1], static_cast<boolean_operation>(r.integer(0, 3)));
      parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    }
    const auto made = irg::mesh_of(parts[0]);
    REQUIRE(made.status == irg::solid_boolean_status::done);
    CHECK(test::is_balanced(made.value));
    double volume = 0;
    for (int x = 0; x < 9; ++x)
      for (int y = 0; y < 9; ++y) {
        const spans s = irg::spans_upward(parts[0], x + 0.5, y + 0.25);
        CHECK(s == irg::spans_upward(tree(made.value), x + 0.5, y + 0.25));
        for (const auto& span : s) volume += span.to - span.from;
      }
    CHECK(irg::solid_volume(made.value) == volume);
  }
}

TEST_CASE("csg_tree: a chain of two hundred steps, and a body that is none") {
  tree all = box(0, 0, 0, 1);
  for (int i = 1; i < 200; ++i)
    all = irg::combine(std::move(all), box(i * 0.5, 0, 0, 1),
                       i % 2 ? boolean_operation::unite : boolean_operation::difference);
  CHECK(irg::mesh_of(all).status == irg::solid_boolean_status::done);
  tree open = box(0, 0, 0, 1);
  open.bodies[0].corners.resize(33);
  open.bodies[0].face_starts.pop_back();
  const auto made = irg::mesh_of(irg::combine(box(3, 0, 0, 1), open, boolean_operation::unite));
  CHECK(made.status == irg::solid_boolean_status::open_edge);
  CHECK(made.body == 1);
}
