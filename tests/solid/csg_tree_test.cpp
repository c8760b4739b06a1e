// SPDX-License-Identifier: MIT
#include <irg/solid/csg_tree.hpp>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <utility>
#include <vector>

#include <irg/geometry/orient3d.hpp>
#include <irg/mesh/mesh_faults.hpp>
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

int trials(int few, int many) { return std::getenv("IRG_RELEASE_TIER") ? many : few; }

// A tetrahedron with corners that next() gives.
template <class Next>
tree tetrahedron(const Next& next) {
  for (;;) {
    irg::mesh<double> m;
    for (int i = 0; i < 4; ++i) {
      const double x = next(), y = next();
      m.positions.push_back({x, y, next()});
    }
    const int turn = irg::orient3d(m.positions[0], m.positions[1], m.positions[2], m.positions[3]);
    if (turn == 0) continue;
    if (turn > 0) std::swap(m.positions[1], m.positions[2]);
    for (const auto& f : {std::initializer_list<int>{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}) irg::add_face(m, f);
    return tree(m);
  }
}

// Any two neighbours become one, till one is left.
tree combine_at_random(std::vector<tree> parts, test::random& r) {
  while (parts.size() > 1) {
    const auto i = static_cast<std::size_t>(r.integer(0, static_cast<std::int64_t>(parts.size()) - 2));
    parts[i] = irg::combine(parts[i], parts[i + 1], static_cast<boolean_operation>(r.integer(0, 3)));
    parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(i) + 1);
  }
  return parts[0];
}

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
    sum = sum + abs(test::dot(test::minus(t[1], t[0]),
                              test::cross(test::minus(t[2], t[0]), test::minus(t[3], t[0]))));
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
    std::vector<bool> in;
    for (const auto& step : t.steps) {
      const auto at = [&](std::uint32_t s) -> bool { return s != irg::csg_step::none && in[s]; };
      const bool a = at(step.first), b = at(step.second);
      if (step.body != irg::csg_step::none)
        in.push_back((set >> step.body & 1u) != 0);
      else
        in.push_back(step.operation == boolean_operation::unite          ? a || b
                     : step.operation == boolean_operation::intersection ? a && b
                     : step.operation == boolean_operation::difference   ? a && !b
                                                                         : a != b);
    }
    if (in.back()) sum = sum + alone[set];
  }
  return sum;
}

// Six times the volume of what mesh_of makes, which is closed and says where it comes from.
big_rational six_volumes_made(const tree& t) {
  const auto made = irg::mesh_of(t);
  REQUIRE(made.status == irg::solid_boolean_status::done);
  REQUIRE(test::is_balanced(made.value));
  REQUIRE(made.faces.size() == made.value.face_count());
  return test::six_volumes(made, t.bodies);
}
#endif

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
    parts = {combine_at_random(parts, r)};
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

#ifdef IRG_HAVE_MPFR
TEST_CASE("csg_tree: trees of lattice bodies at random: volumes by inclusion and exclusion, in rationals") {
  test::random r(23);
  int with_volume = 0;
  for (int trial = 0, n = trials(120, 10000); trial < n; ++trial) {
    const std::int64_t size = trial % 3 == 0 ? 2 : trial % 3 == 1 ? 4 : 1000;
    const auto at = [&] { return static_cast<double>(r.integer(-size, size)); };
    std::vector<tree> parts;
    for (int i = 0, count = static_cast<int>(r.integer(3, 5)); i < count; ++i)
      if (r.integer(0, 2) == 0) {
        const double x = at(), y = at(), z = at();
        parts.push_back(box(x, y, z, static_cast<double>(r.integer(1, size))));
      } else {
        parts.push_back(tetrahedron(at));
      }
    const tree t = combine_at_random(parts, r);
    CAPTURE(trial);
    const big_rational volume = six_volumes_by_sets(t);
    const bool same = six_volumes_made(t) == volume;
    REQUIRE(same);
    with_volume += volume.sign();
  }
  CHECK(with_volume > trials(120, 10000) / 2);
}

TEST_CASE("csg_tree: deep trees are not rounded on the way") {
  test::random r(24);
  for (int trial = 0, n = trials(4, 60); trial < n; ++trial) {
    CAPTURE(trial);
    const auto at = [&] { return r.unit(); };
    tree deep = tetrahedron(at);
    for (int step = 0; step < 14; ++step)
      deep = irg::combine(std::move(deep), tetrahedron(at), step % 3 == 1 ? boolean_operation::difference : boolean_operation::symmetric_difference);
    const tree other = tetrahedron(at);
    const big_rational one = six_volumes_made(deep), two = six_volumes_made(other);
    const big_rational both = six_volumes_made(irg::combine(deep, other, boolean_operation::intersection));
    const bool either = six_volumes_made(irg::combine(deep, other, boolean_operation::unite)) == one + two - both;
    const bool less = six_volumes_made(irg::combine(deep, other, boolean_operation::difference)) == one - both;
    const bool none = six_volumes_made(irg::combine(deep, deep, boolean_operation::difference)).sign() == 0;
    CHECK(either);
    CHECK(less);
    CHECK(none);
  }
}
#endif

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
