// SPDX-License-Identifier: MIT
#include <irg/solid/csg_tree.hpp>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

#include <irg/mesh/shapes.hpp>
#include <irg/solid/boolean.hpp>
#include <irg/solid/measures.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/solid_facts.hpp"
#include "support/solid_trees.hpp"

namespace {

using irg::boolean_operation;
using test::box;
using test::tetrahedron;
using tree = test::solid_tree;

int trials(int few, int many) { return std::getenv("IRG_RELEASE_TIER") ? many : few; }

#ifdef IRG_HAVE_MPFR
using test::big_rational;
using corners = std::array<test::rational_point, 4>;

// What of these tetrahedra lies behind a plane.
std::vector<corners> clip(const std::vector<corners>& all, const test::rational_point& on,
                          const test::rational_point& normal) {
  std::vector<corners> kept;
  for (corners t : all) {
    big_rational height[4];
    int in = 0;
    for (std::size_t i = 0; i < 4; ++i) {  // those behind come first
      height[i] = test::dot(normal, test::minus(t[i], on));
      if (height[i].sign() >= 0) continue;
      std::swap(t[i], t[static_cast<std::size_t>(in)]);
      std::swap(height[i], height[in++]);
    }
    const auto cut = [&](std::size_t i, std::size_t k) {
      return test::on_way(t[i], t[k], height[i] / (height[i] - height[k]));
    };
    if (in == 4) kept.push_back(t);
    if (in == 1) kept.push_back({t[0], cut(0, 1), cut(0, 2), cut(0, 3)});
    // A prism from u[0..2] to v[0..2].
    const auto add_prism = [&](const auto& u, const auto& v) {
      kept.push_back({u[0], u[1], u[2], v[2]});
      kept.push_back({u[0], u[1], v[1], v[2]});
      kept.push_back({u[0], v[0], v[1], v[2]});
    };
    using three = std::array<test::rational_point, 3>;
    if (in == 2) add_prism(three{t[0], cut(0, 2), cut(0, 3)}, three{t[1], cut(1, 2), cut(1, 3)});
    if (in == 3) add_prism(three{t[0], t[1], t[2]}, three{cut(0, 3), cut(1, 3), cut(2, 3)});
  }
  return kept;
}

// Six times what all bodies of a set have in common, all convex.
big_rational six_common(const std::vector<irg::mesh<double>>& bodies, unsigned set) {
  std::vector<corners> left;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if ((set >> b & 1u) == 0) continue;
    const auto p = test::rational_points(bodies[b]);
    const bool is_first = left.empty() && (set & ((1u << b) - 1)) == 0;
    for (std::size_t f = 0; f < bodies[b].face_count(); ++f) {
      const auto at = [&](std::size_t k) { return p[bodies[b].corner(f, k).position]; };
      if (is_first)
        left.push_back({p[0], at(0), at(1), at(2)});
      else
        left = clip(left, at(0), test::cross(test::minus(at(1), at(0)), test::minus(at(2), at(0))));
    }
  }
  big_rational sum = 0;
  for (const corners& t : left)
    sum = sum + abs(test::dot(test::minus(t[1], t[0]), test::cross(test::minus(t[2], t[0]), test::minus(t[3], t[0]))));
  return sum;
}

// Six times the volume of a tree of convex bodies: what lies in a set of them alone, by inclusion and exclusion.
big_rational six_volumes_by_sets(const tree& t) {
  const unsigned sets = 1u << t.bodies.size();
  std::vector<big_rational> alone(sets, 0);
  for (unsigned set = 1; set < sets; ++set) alone[set] = six_common(t.bodies, set);
  for (std::size_t b = 0; b < t.bodies.size(); ++b)
    for (unsigned set = 0; set < sets; ++set)
      if ((set >> b & 1u) == 0) alone[set] = alone[set] - alone[set | 1u << b];
  big_rational sum = 0;
  for (unsigned set = 1; set < sets; ++set) {
    if (test::has(t, [set](std::uint32_t body) { return (set >> body & 1u) != 0; })) sum = sum + alone[set];
  }
  return sum;
}

// Six times the volume of what mesh_of makes, which is closed and says where it comes from.
big_rational six_volumes_made(const tree& t) {
  const auto made = irg::to_mesh(t);
  REQUIRE(made.status == irg::solid_boolean_status::ok);
  REQUIRE(test::is_balanced(made.value));
  REQUIRE(made.faces.size() == made.value.face_count());
  return test::six_volumes(made, t.bodies);
}
#endif

}  // namespace

TEST_CASE("csg_tree: nothing, bodies by themselves, the same body twice, steps that are not used") {
  const auto faces = [](const tree& t) {
    const auto made = irg::to_mesh(t);
    CHECK(made.status == irg::solid_boolean_status::ok);
    return made.value.face_count();
  };
  CHECK(faces(tree()) == 0);
  CHECK(faces(irg::csg_boolean(tree(), box(0, 0, 0, 1), boolean_operation::union_)) == 12);
  CHECK(faces(box(0, 0, 0, 1)) == 12);
  tree shared = box(0, 0, 0, 1);
  shared.steps.push_back({irg::no_index, boolean_operation::symmetric_difference, 0, 0});
  CHECK(faces(shared) == 0);
  shared.steps.push_back({irg::no_index, boolean_operation::union_, 1, 0});
  CHECK(faces(shared) == 12);
  tree with_unused = irg::csg_boolean(box(0, 0, 0, 1), box(0.5, 0, 0, 1), boolean_operation::union_);
  with_unused.steps.push_back({1, {}, irg::no_index, irg::no_index});
  const auto made = irg::to_mesh(with_unused);
  CHECK(made.value.face_count() == 12);
  CHECK(made.faces[0].body == 1);
  // Three bodies apart, of 12 triangles each: all pairs, none of which meets, and three parts.
  const tree apart = irg::csg_boolean(irg::csg_boolean(box(0, 0, 0, 1), box(3, 0, 0, 1), boolean_operation::union_),
                                      box(6, 0, 0, 1), boolean_operation::union_);
  CHECK(irg::to_mesh(apart).counts == irg::solid_boolean_counts{3 * 144, 0, 3});
}

#ifdef IRG_HAVE_MPFR
TEST_CASE("csg_tree: trees of lattice bodies at random: volumes by inclusion and exclusion, in rationals") {
  test::random r(23);
  int with_volume = 0;
  for (int trial = 0, n = trials(40, 1000); trial < n; ++trial) {
    const std::int64_t size = trial % 3 == 0 ? 2 : trial % 3 == 1 ? 4 : 1000;
    const tree t = test::lattice_tree(r, size);
    CAPTURE(trial);
    const big_rational volume = six_volumes_by_sets(t);
    const bool same = six_volumes_made(t) == volume;
    REQUIRE(same);
    with_volume += volume.sign();
  }
  CHECK(with_volume > trials(40, 1000) / 2);
}

TEST_CASE("csg_tree: deep trees are not rounded on the way") {
  test::random r(24);
  for (int trial = 0, n = trials(2, 20); trial < n; ++trial) {
    CAPTURE(trial);
    const auto at = [&] { return static_cast<double>(r.integer(-512, 512)) / 1024; };
    tree deep = tetrahedron(at);
    for (int step = 0; step < 10; ++step)
      deep = irg::csg_boolean(std::move(deep), tetrahedron(at),
                              step % 3 == 1 ? boolean_operation::difference : boolean_operation::symmetric_difference);
    const tree other = tetrahedron(at);
    const big_rational one = six_volumes_made(deep), two = six_volumes_made(other);
    const big_rational both = six_volumes_made(irg::csg_boolean(deep, other, boolean_operation::intersection));
    const bool either = six_volumes_made(irg::csg_boolean(deep, other, boolean_operation::union_)) == one + two - both;
    const bool less = six_volumes_made(irg::csg_boolean(deep, other, boolean_operation::difference)) == one - both;
    const bool none = six_volumes_made(irg::csg_boolean(deep, deep, boolean_operation::difference)).sign() == 0;
    CHECK(either);
    CHECK(less);
    CHECK(none);
  }
}
#endif

TEST_CASE("csg_tree: a chain of steps as one tree, and step after step: the same volume, to the last bit") {
  test::random r(25);
  tree all = box(0, 0, 0, 8);
  irg::mesh<double> by_steps = all.bodies[0];
  for (int step = 0, n = trials(100, 1000); step < n; ++step) {
    const auto at = [&] { return static_cast<double>(r.integer(-64, 512)) / 64; };
    const double x = at(), y = at();
    const tree next = box(x, y, at(), 0.75);
    const auto operation = step % 2 ? boolean_operation::difference : boolean_operation::union_;
    by_steps = irg::solid_boolean(by_steps, next.bodies[0], operation).value;
    all = irg::csg_boolean(std::move(all), next, operation);
  }
  const auto made = irg::to_mesh(all);
  REQUIRE(made.status == irg::solid_boolean_status::ok);
  CHECK(test::is_balanced(made.value));
  CHECK(irg::solid_volume(made.value) == irg::solid_volume(by_steps));
}

TEST_CASE("csg_tree: six balls, whose steps would cut themselves where they are rounded") {
  tree all;
  test::random r(26);
  for (int i = 0; i < 6; ++i) {
    irg::mesh<double> ball = irg::shape_sphere<double>({.slices = 16, .stacks = 12});
    const double x = r.unit(), y = r.unit(), z = r.unit();
    for (auto& p : ball.positions) p = {p.x + x, p.y + y, p.z + z};
    all = irg::csg_boolean(std::move(all), tree(ball),
                           i % 2 ? boolean_operation::difference : boolean_operation::symmetric_difference);
  }
  const auto made = irg::to_mesh(all);
  REQUIRE(made.status == irg::solid_boolean_status::ok);
  CHECK(test::is_balanced(made.value));
  for (const auto& face : made.faces) CHECK(face.body < 6);
}

TEST_CASE("csg_tree: a body that is none") {
  tree open = box(0, 0, 0, 1);
  open.bodies[0].corners.resize(33);
  open.bodies[0].face_starts.pop_back();
  const auto made = irg::to_mesh(irg::csg_boolean(box(3, 0, 0, 1), open, boolean_operation::union_));
  CHECK(made.status == irg::solid_boolean_status::open_edge);
  CHECK(made.body == 1);
}

TEST_CASE("csg_tree: the steps of two trees put together name their own bodies and steps") {
  using T = irg::csg_tree<double>;
  constexpr std::uint32_t none = irg::no_index;
  const T leaf(irg::mesh<double>{});
  const T both =
      irg::csg_boolean(irg::csg_boolean(leaf, leaf, boolean_operation::union_),
                       irg::csg_boolean(leaf, leaf, boolean_operation::intersection), boolean_operation::difference);
  REQUIRE(both.bodies.size() == 4);
  REQUIRE(both.steps.size() == 7);
  const std::uint32_t body[]{0, 1, none, 2, 3, none, none}, first[]{none, none, 0, none, none, 3, 2},
      second[]{none, none, 1, none, none, 4, 5};
  for (std::size_t i = 0; i < 7; ++i) {
    CHECK(both.steps[i].body == body[i]);
    CHECK(both.steps[i].first == first[i]);
    CHECK(both.steps[i].second == second[i]);
  }
  CHECK(both.steps[2].operation == boolean_operation::union_);
  CHECK(both.steps[5].operation == boolean_operation::intersection);
  CHECK(both.steps[6].operation == boolean_operation::difference);
  // Nothing has no step.
  const T with_nothing = irg::csg_boolean(leaf, T{}, boolean_operation::difference),
          of_nothing = irg::csg_boolean(T{}, leaf, boolean_operation::difference);
  CHECK((with_nothing.steps.back().first == 0 && with_nothing.steps.back().second == none));
  CHECK((of_nothing.steps.back().first == none && of_nothing.steps.back().second == 0));
}
