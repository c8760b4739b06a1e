// SPDX-License-Identifier: MIT
#include <irg/solid/csg_spans.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <limits>
#include <utility>
#include <vector>

#include <irg/solid/measures.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/solid_facts.hpp"
#include "support/solid_trees.hpp"

namespace {

using irg::boolean_operation;
using test::box;
using tree = test::solid_tree;
using spans = std::vector<irg::solid_span<double>>;
using ray = irg::ray<double, 3>;

bool have_same_ends(const spans& a, const spans& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& s, const auto& t) { return s.from == t.from && s.to == t.to; });
}

// Looks at a span's faces: the line goes through their planes there, in, then out.
void check_faces(const tree& t, const ray& r, const spans& all) {
  for (const auto& span : all)
    for (const bool is_in : {true, false}) {
      const auto& face = is_in ? span.entered : span.left;
      if (face.body == irg::no_index) continue;
      const auto& m = t.bodies[face.body];
      const auto at = [&](std::size_t k) { return m.positions[m.corner(face.face, k).position]; };
      const auto n = cross(at(1) - at(0), at(2) - at(0));
      CHECK((dot(n, r.direction) < 0) == (is_in != face.turned));
    }
}

#ifdef IRG_HAVE_MPFR
using test::big_rational;

// The stretch of a line in a convex body, of the line moved by infinitely little where it runs along a face.
std::pair<big_rational, big_rational> stretch_of(const irg::mesh<double>& m, const ray& r) {
  const auto p = test::rational_points(m);
  const test::rational_point from{big_rational(r.origin.x), big_rational(r.origin.y), big_rational(r.origin.z)};
  const test::rational_point way{big_rational(r.direction.x), big_rational(r.direction.y), big_rational(r.direction.z)};
  big_rational low = -1000000, high = 1000000;
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    const auto at = [&](std::size_t k) { return p[m.corner(f, k).position]; };
    const auto n = test::cross(test::minus(at(1), at(0)), test::minus(at(2), at(0)));
    const big_rational slope = test::dot(n, way), height = test::dot(n, test::minus(at(0), from));
    if (slope.sign() == 0) {
      const int signs[] = {-height.sign(), n[0].sign(), n[1].sign(), n[2].sign()};
      if (*std::find_if(signs, signs + 4, [](int s) { return s != 0; }) > 0) return {0, 0};
    } else if (const big_rational t = height / slope; slope.sign() < 0) {
      if (low < t) low = t;
    } else if (t < high) {
      high = t;
    }
  }
  return {low, high};
}

// Ends of stretches in a tree of convex bodies.
std::vector<big_rational> ends_of(const tree& t, const ray& r) {
  std::vector<std::pair<big_rational, big_rational>> in;
  std::vector<big_rational> marks, ends;
  for (const auto& body : t.bodies) {
    in.push_back(stretch_of(body, r));
    if (!(in.back().first < in.back().second)) in.back().second = in.back().first;
    marks.push_back(in.back().first);
    marks.push_back(in.back().second);
  }
  std::sort(marks.begin(), marks.end());
  bool was_in = false;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const bool is_last = i + 1 == marks.size();
    if (!is_last && marks[i] == marks[i + 1]) continue;
    const big_rational middle = is_last ? marks[i] + 1 : (marks[i] + marks[i + 1]) / 2;
    const bool is_in = test::has(t, [&](std::uint32_t b) { return in[b].first < middle && middle < in[b].second; });
    if (is_in != was_in) ends.push_back(marks[i]);
    was_in = is_in;
  }
  return ends;
}
#endif

}  // namespace

TEST_CASE("csg_spans: stretches of a box with a hole, through sides and corners, at compile time, too") {
  constexpr auto is = [](double x, double y, std::initializer_list<double> ends) {
    const tree t = irg::csg_boolean(box(0, 0, 0, 4), box(1, 1, 1, 2), boolean_operation::difference);
    const spans s = irg::csg_spans(t).upward(x, y);
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
  CHECK_BOTH(irg::csg_spans(tree()).upward(0.0, 0.0).empty());
}

TEST_CASE("csg_spans: from a ray's low to its high end, in lengths of its direction; the faces at the ends") {
  constexpr auto along = [](const ray& r) {
    return irg::csg_spans(irg::csg_boolean(box(0, 0, 0, 4), box(1, 1, 1, 2), boolean_operation::difference)).along(r);
  };
  CHECK_BOTH(along({{-2, 2, 2}, {2, 0, 0}}).size() == 2);
  CHECK_BOTH(along({{-2, 2, 2}, {2, 0, 0}})[0].from == 1.0);
  CHECK_BOTH(along({{-2, 2, 2}, {2, 0, 0}})[0].to == 1.5);
  CHECK_BOTH(along({{-2, 2, 2}, {2, 0, 0}})[0].left.body == 1);
  CHECK_BOTH(along({{-2, 2, 2}, {2, 0, 0}})[0].left.turned);
  CHECK_BOTH(along({{0.5, 2, 2}, {2, 0, 0}})[0].from == 0.0);
  CHECK_BOTH(along({{0.5, 2, 2}, {2, 0, 0}})[0].entered.body == irg::no_index);
  CHECK_BOTH(along({{0, 2, 2}, {1, 0, 0}, 0.0, 3.5})[1].to == 3.5);
  CHECK_BOTH(along({{0, 2, 2}, {1, 0, 0}, 0.0, 3.5})[1].left.body == irg::no_index);
  CHECK_BOTH(along({{2, 2, 2}, {1, 1, 1}, 0.0, 0.5}).empty());  // in the hole
  CHECK_BOTH(along({{2, 2, 2}, {1, 1, 1}})[0].from == 1.0);  // through two corners
  CHECK_BOTH(along({{2, 2, 2}, {1, 1, 1}})[0].to == 2.0);
  CHECK_BOTH(along({{5, 2, 2}, {1, 0, 0}}).empty());
}

TEST_CASE("csg_spans: rays without points, empty trees, bodies that are not finite, 600 decades") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const irg::csg_spans<double> one(box(0, 0, 0, 1));
  CHECK(one.along({{0.5, 0.5, 0.5}, {0, 0, 0}}).empty());
  CHECK(one.along({{nan, 0.5, 0.5}, {1, 0, 0}}).empty());
  CHECK(one.along({{0.5, 0.5, 0.5}, {inf, 0, 0}}).empty());
  CHECK(one.along({{0.5, 0.5, 0.5}, {1, 0, 0}, 2.0, 1.0}).empty());
  CHECK(one.upward(nan, 0).empty());
  CHECK(irg::csg_spans(tree()).along({{0, 0, 0}, {1, 0, 0}}).empty());
  tree broken = box(0, 0, 0, 1);
  broken.bodies[0].positions[0].x = inf;
  CHECK(irg::csg_spans(irg::csg_boolean(broken, box(0, 0, 0, 1), boolean_operation::union_)).upward(0.5, 0.25).size() ==
        1);
  for (const double size : {1e-300, 1e-150, 1e150, 1e300})
    for (const double length : {1e-5, 1.0, 1e5}) {
      const auto s = irg::csg_spans(box(0, 0, 0, size)).along({{-size, size / 2, size / 2}, {size * length, 0, 0}});
      CAPTURE(size);
      REQUIRE(s.size() == 1);
      CHECK(s[0].from == doctest::Approx(1 / length));
      CHECK(s[0].to == doctest::Approx(2 / length));
    }
  // Nearer than numbers are.
  const tree thin = irg::csg_boolean(box(0, 0, 0, 1), box(0, 0, 0x1p-60, 1), boolean_operation::difference);
  CHECK(irg::csg_spans(thin).along({{0.5, 0.25, -1}, {0, 0, 1}}).empty());
  CHECK(irg::csg_spans(thin).upward(0.5, 0.25).size() == 1);
}

TEST_CASE("csg_spans: trees of lattice boxes at random: mesh and spans say the same, to the last bit") {
  test::random r(20);
  for (int trial = 0; trial < 60; ++trial) {
    std::vector<tree> parts;
    for (int i = 0; i < 6; ++i) {
      const auto at = [&] { return static_cast<double>(r.integer(0, 4)); };
      const double x = at(), y = at(), z = at();
      parts.push_back(box(x, y, z, static_cast<double>(r.integer(1, 4))));
    }
    const tree t = test::combine_at_random(std::move(parts), r);
    const auto made = irg::to_mesh(t);
    REQUIRE(made.status == irg::solid_boolean_status::ok);
    CHECK(test::is_balanced(made.value));
    const irg::csg_spans<double> through(t), through_mesh{tree(made.value)};
    double volume = 0;
    for (int x = 0; x < 9; ++x)
      for (int y = 0; y < 9; ++y) {
        const spans s = through.upward(x + 0.5, y + 0.25);
        CHECK(have_same_ends(s, through_mesh.upward(x + 0.5, y + 0.25)));
        for (const auto& span : s) volume += span.to - span.from;
      }
    CHECK(irg::solid_volume(made.value) == volume);
    for (int i = 0; i < 60; ++i) {  // every second one from lattice points in lattice directions
      const auto at = [&] { return static_cast<double>(r.integer(-2, 10)) + (i % 2 == 0 ? 0.0 : r.unit()); };
      const auto way = [&] { return static_cast<double>(r.integer(-2, 2)) + (i % 2 == 0 ? 0.0 : r.unit()); };
      ray l;
      for (int k = 0; k < 3; ++k) l.origin[k] = at(), l.direction[k] = way();
      CHECK(have_same_ends(through.along(l), through_mesh.along(l)));
      check_faces(t, l, through.along(l));
    }
  }
}

#ifdef IRG_HAVE_MPFR
TEST_CASE("csg_spans: trees of lattice bodies, lines through sides, corners and along faces: ends in rationals") {
  test::random r(27);
  int met = 0;
  for (int trial = 0, n = std::getenv("IRG_RELEASE_TIER") ? 20000 : 400; trial < n; ++trial) {
    const std::int64_t size = trial % 2 == 0 ? 2 : 5;
    const tree t = test::lattice_tree(r, size);
    const irg::csg_spans<double> through(t);
    for (int i = 0; i < 8; ++i) {
      ray l;
      for (int k = 0; k < 3; ++k) {
        l.origin[k] = static_cast<double>(r.integer(-size, size));
        l.direction[k] = static_cast<double>(r.integer(-2, 2));
      }
      if (l.direction.x == 0 && l.direction.y == 0 && l.direction.z == 0) continue;
      for (int k = 0; k < 3; ++k) l.origin[k] -= 64 * l.direction[k];
      const auto ends = ends_of(t, l);
      const spans s = through.along(l);
      CAPTURE(trial);
      REQUIRE(2 * s.size() == ends.size());
      for (std::size_t k = 0; k < s.size(); ++k) {
        CHECK(test::distance(s[k].from, ends[2 * k]) <= 0x1p-47);
        CHECK(test::distance(s[k].to, ends[2 * k + 1]) <= 0x1p-47);
      }
      check_faces(t, l, s);
      met += static_cast<int>(s.size());
    }
  }
  CHECK(met > 400);
}
#endif
