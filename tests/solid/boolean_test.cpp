// SPDX-License-Identifier: MIT
#include <irg/solid/boolean.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <limits>
#include <utility>
#include <vector>

#include <irg/geometry/orient3d.hpp>
#include <irg/mesh/mesh_faults.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/solid/measures.hpp>
#include <irg/solid/point_in_solid.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/solid_facts.hpp"

namespace {

using irg::boolean_operation;
using irg::solid_boolean;
using irg::solid_boolean_status;
using body = irg::mesh<double>;
using place = irg::point<double, 3>;

constexpr boolean_operation all_operations[] = {boolean_operation::union_, boolean_operation::intersection,
                                                boolean_operation::difference, boolean_operation::symmetric_difference};

constexpr body box(const place& low, const place& high) {
  body m = irg::shape_cube<double>();
  m.normals.clear();
  for (auto& c : m.corners) c.normal = irg::no_index;
  for (place& p : m.positions)
    for (int i = 0; i < 3; ++i) p[i] = p[i] == 0 ? low[i] : high[i];
  return m;
}
constexpr body cube(double x, double y, double z, double size = 1) {
  return box({x, y, z}, {x + size, y + size, z + size});
}

body tetrahedron(place a, place b, place c, const place& d) {
  if (irg::orient3d(a, b, c, d) > 0) std::swap(b, c);
  body m;
  m.positions = {a, b, c, d};
  for (const auto& f : {std::initializer_list<int>{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}) irg::add_face(m, f);
  return m;
}

constexpr double volume(const body& a, const body& b, boolean_operation operation) {
  const auto r = solid_boolean(a, b, operation);
  return r.status == solid_boolean_status::ok ? irg::solid_volume(r.value) : -1;
}
// Of what the four operations make.
std::vector<double> volumes(const body& a, const body& b) {
  std::vector<double> all;
  for (const auto operation : all_operations) all.push_back(volume(a, b, operation));
  return all;
}
using numbers = std::vector<double>;

// All four are closed, and their volumes fit together to the last bit; the sign of what the bodies have in common.
int check_identities(const body& a, const body& b) {
  irg::solid_boolean_result<double> made[4];
  for (int i = 0; i < 4; ++i) {
    made[i] = solid_boolean(a, b, all_operations[i]);
    REQUIRE(made[i]);
    REQUIRE(test::is_balanced(made[i].value));
    REQUIRE(made[i].faces.size() == made[i].value.face_count());
    REQUIRE(made[i].corners.size() == made[i].value.positions.size());
  }
#ifdef IRG_HAVE_MPFR
  test::big_rational v[4];
  for (int i = 0; i < 4; ++i) v[i] = test::six_volumes(made[i], {a, b});
  const test::big_rational first = test::six_volumes(a, test::rational_points(a));
  const test::big_rational second = test::six_volumes(b, test::rational_points(b));
  const bool either = first + second == v[0] + v[1], less = v[2] == first - v[1], one = v[3] == v[0] - v[1];
  REQUIRE(either);
  REQUIRE(less);
  REQUIRE(one);
  REQUIRE(v[1].sign() >= 0);
  return v[1].sign();
#else
  return made[1].value.face_count() > 0 ? 1 : 0;
#endif
}

int trials(int few, int many) { return std::getenv("IRG_RELEASE_TIER") ? many : few; }

}  // namespace

TEST_CASE("solid_boolean: cubes, at compile time, too") {
  CHECK_BOTH(volume(cube(0, 0, 0), cube(1, 1, 1, 2), boolean_operation::intersection) == 0);
  CHECK(volume(cube(0, 0, 0, 2), cube(1, 1, 1, 2), boolean_operation::intersection) == 1);
  CHECK(volumes(cube(0, 0, 0, 2), cube(1, 1, 1, 2)) == numbers{15, 1, 7, 14});
}

TEST_CASE("solid_boolean: a body with itself, with nothing, with what is apart, inside, round it") {
  const body a = irg::shape_icosahedron<double>(), none;
  const double v = irg::solid_volume(a);
  CHECK(volumes(a, a) == numbers{v, v, 0, 0});
  CHECK(solid_boolean(a, a, boolean_operation::difference).value == none);
  CHECK(volumes(a, none) == numbers{v, 0, v, v});
  CHECK(volumes(none, a) == numbers{v, 0, 0, v});
  CHECK(solid_boolean(none, none, boolean_operation::union_).value == none);
  CHECK(volumes(cube(0, 0, 0), cube(5, 0, 0)) == numbers{2, 0, 1, 2});
  CHECK(volumes(cube(0, 0, 0, 4), cube(1, 1, 1)) == numbers{64, 1, 63, 63});
  CHECK(volumes(cube(1, 1, 1), cube(0, 0, 0, 4)) == numbers{64, 1, 0, 63});
}

namespace {

// Pairs of triangles, and those whose boxes meet, by asking all; with a number of parts that is known otherwise.
constexpr irg::solid_boolean_counts counted_by_force(const body& a, const body& b, std::uint64_t parts) {
  const body of[2] = {irg::triangulated(a), irg::triangulated(b)};
  irg::solid_boolean_counts counts{0, 0, parts};
  for (std::size_t f = 0; f < of[0].face_count(); ++f)
    for (std::size_t g = 0; g < of[1].face_count(); ++g) {
      bool meet = true;
      for (int axis = 0; axis < 3; ++axis) {
        const auto at = [&](std::size_t k, std::size_t face, std::size_t corner) {
          return of[k].positions[of[k].corner(face, corner).position][axis];
        };
        const auto low = [&](std::size_t k, std::size_t n) {
          return std::min({at(k, n, 0), at(k, n, 1), at(k, n, 2)});
        };
        const auto high = [&](std::size_t k, std::size_t n) {
          return std::max({at(k, n, 0), at(k, n, 1), at(k, n, 2)});
        };
        meet = meet && low(0, f) <= high(1, g) && low(1, g) <= high(0, f);
      }
      ++counts.pairs;
      if (meet) ++counts.met;
    }
  return counts;
}

}  // namespace

TEST_CASE("solid_boolean: the pairs whose boxes meet are counted, and the parts") {
  const auto counts = [](const body& a, const body& b, boolean_operation operation = boolean_operation::union_) {
    return solid_boolean(a, b, operation).counts;
  };
  CHECK_BOTH(solid_boolean(cube(0, 0, 0), cube(5, 0, 0), boolean_operation::union_).counts ==
             irg::solid_boolean_counts{144, 0, 2});
  const body block = cube(0, 0, 0, 4), corner = cube(3, 3, 3, 4), within = cube(1, 1, 1);
  CHECK(counts(block, within) == counted_by_force(block, within, 2));
  // The corner of each is in the other: two parts each.
  CHECK(counts(block, corner) == counted_by_force(block, corner, 4));
  CHECK(counts(block, corner).met < 144);
  // A bar through a block: its ends and its middle, the block's two windows and the rest. The same for what is kept.
  const body bar = box({1, 1, -1}, {2, 2, 5});
  for (const boolean_operation operation : all_operations)
    CHECK(counts(block, bar, operation) == counted_by_force(block, bar, 6));
  CHECK(counts(bar, block) == counted_by_force(bar, block, 6));
  CHECK(counts(block, body{}) == irg::solid_boolean_counts{0, 0, 1});
  // Where many pairs are told apart by halves: a ball that cuts a ring along two circles, and a small one in its hole.
  const auto ring = irg::shape_torus<double>({.minor_radius = 0.4, .major_segments = 40, .minor_segments = 20});
  body ball = irg::shape_sphere<double>({.slices = 30, .stacks = 16});
  const auto cut = counted_by_force(ball, ring, 5);
  CHECK(counts(ball, ring, boolean_operation::difference) == cut);
  CHECK(cut.met * 20 < cut.pairs);
  for (place& p : ball.positions) p = {p.x / 16, p.y / 16, p.z / 16};
  CHECK(counts(ball, ring) == counted_by_force(ball, ring, 2));
  body open = cube(0, 0, 0);
  open.corners.resize(33);
  open.face_starts.pop_back();
  CHECK(counts(open, block) == irg::solid_boolean_counts{});
}

TEST_CASE("solid_boolean: faces in one plane that touch, overlap, face each other") {
  CHECK(volumes(cube(0, 0, 0), cube(1, 0, 0)) == numbers{2, 0, 1, 2});  // a whole face
  CHECK(volumes(cube(0, 0, 0), cube(1, 0.5, 0.25)) == numbers{2, 0, 1, 2});  // part of one
  CHECK(volumes(cube(0, 0, 0), cube(0.5, 0, 0)) == numbers{1.5, 0.5, 0.5, 1});  // four faces run on
  CHECK(volumes(cube(0, 0, 0), cube(0, 0, 0.5, 0.5)) == numbers{1, 0.125, 0.875, 0.875});  // three within the other's
  CHECK(solid_boolean(cube(0, 0, 0), cube(1, 0, 0), boolean_operation::intersection).value.face_count() == 0);
}

TEST_CASE("solid_boolean: an edge or a corner in common, an edge that lies in a face, a corner in an edge") {
  CHECK(volumes(cube(0, 0, 0), cube(1, 1, 0)) == numbers{2, 0, 1, 2});
  CHECK(volumes(cube(0, 0, 0), cube(1, 1, 1)) == numbers{2, 0, 1, 2});
  const auto edge = solid_boolean(cube(0, 0, 0), cube(1, 1, 0), boolean_operation::union_).value;
  CHECK(irg::list_faults(edge) ==
        std::vector<irg::mesh_fault>{
            {irg::mesh_fault_kind::edge_of_many_faces, irg::list_faults(edge)[0].a, irg::list_faults(edge)[0].b, 4}});
  const auto corner = solid_boolean(cube(0, 0, 0), cube(1, 1, 1), boolean_operation::union_).value;
  REQUIRE(irg::list_faults(corner).size() == 1);
  CHECK(irg::list_faults(corner)[0].kind == irg::mesh_fault_kind::vertex_of_many_fans);
  const body wedge = tetrahedron({0.25, 0.25, 1}, {0.75, 0.75, 1}, {0.25, 0.75, 2}, {0.75, 0.25, 2});
  CHECK(check_identities(cube(0, 0, 0), wedge) == 0);  // stands on its edge
  const body arrow = tetrahedron({1, 0.5, 1}, {2, 0, 2}, {2, 1, 2}, {3, 0, 3});
  CHECK(check_identities(cube(0, 0, 0), arrow) == 0);  // its corner on an edge
  const body cross = tetrahedron({0.5, -1, 2}, {1.5, 2, 0}, {3, 0, 2}, {3, 1, 3});
  check_identities(cube(0, 0, 0), cross);
}

TEST_CASE("solid_boolean: lattice bodies at random, volumes against each other in rationals") {
  test::random r(20);
  int common = 0;
  for (int trial = 0, n = trials(1200, 100000); trial < n; ++trial) {
    const std::int64_t size = trial % 3 == 0 ? 2 : trial % 3 == 1 ? 4 : 1000;
    const auto any = [&] {
      const auto x = [&] { return static_cast<double>(r.integer(-size, size)); };
      return place{x(), x(), x()};
    };
    const auto any_body = [&] {
      for (;;) {
        place p[4] = {any(), any(), any(), any()};
        if (r.integer(0, 1) == 0) {
          if (irg::orient3d(p[0], p[1], p[2], p[3]) != 0) return tetrahedron(p[0], p[1], p[2], p[3]);
        } else if (p[0].x != p[1].x && p[0].y != p[1].y && p[0].z != p[1].z) {
          for (int i = 0; i < 3; ++i)
            if (p[0][i] > p[1][i]) std::swap(p[0][i], p[1][i]);
          return box(p[0], p[1]);
        }
      }
    };
    const body a = any_body(), b = any_body();
    CAPTURE(trial);
    common += check_identities(a, b) > 0 ? 1 : 0;
  }
  CHECK(common > 100);
}

TEST_CASE("solid_boolean: heaps of lattice boxes, one step after another, against their cells") {
  test::random r(21);
  constexpr int side = 5;
  for (int trial = 0, n = trials(60, 3000); trial < n; ++trial) {
    CAPTURE(trial);
    body heap;
    std::vector<char> cells(side * side * side, 0);
    for (int step = 0; step < 12; ++step) {
      place low{}, high{};
      for (int i = 0; i < 3; ++i) {
        const auto a = r.integer(0, side - 1), b = r.integer(0, side - 1);
        low[i] = static_cast<double>(std::min(a, b)), high[i] = static_cast<double>(std::max(a, b) + 1);
      }
      const auto which = static_cast<std::size_t>(step == 0 ? 0 : r.integer(0, 3));
      const auto operation = all_operations[which];
      auto next = solid_boolean(heap, box(low, high), operation);
      REQUIRE(next.status == solid_boolean_status::ok);
      REQUIRE(test::is_balanced(next.value));
      heap = std::move(next.value);
      double count = 0;
      for (int i = 0; i < side * side * side; ++i) {
        const int x = i % side, y = i / side % side, z = i / side / side;
        const bool in = low.x <= x && x < high.x && low.y <= y && y < high.y && low.z <= z && z < high.z;
        char& c = cells[static_cast<std::size_t>(i)];
        c = which == 0 ? c | in : which == 1 ? c & in : which == 2 ? c & !in : c ^ in;
        count += c;
        if (step % 4 == 3 || trial % 8 == 0) {
          const auto where = irg::point_in_solid(heap, {x + 0.5, y + 0.5, z + 0.5});
          REQUIRE((where == irg::location::inside) == (c != 0));
        }
      }
      REQUIRE(irg::solid_volume(heap) == count);
    }
  }
}

TEST_CASE("solid_boolean: a cube less itself turned by a little or by much") {
  const body a = cube(-1, -1, -1, 2);
  std::vector<double> angles;
  for (int k = 0; k <= 90; k += 5) angles.push_back(k * 3.14159265358979323846 / 180);
  angles.insert(angles.end(), {1e-15, 1e-12, 1e-300, 5e-324});
  for (const double angle : angles) {
    body b = a;
    const double c = std::cos(angle), s = std::sin(angle);
    for (place& p : b.positions) p = {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
    CAPTURE(angle);
    CHECK(check_identities(a, b) == 1);
  }
  // Round a slanted axis, no face in a common plane.
  for (int k = 1; k < 40; ++k) {
    body b = a;
    const double t = k * 0.04, c = std::cos(t), s = std::sin(t);
    for (place& p : b.positions) {
      p = {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
      p = {p.x, c * p.y - s * p.z, s * p.y + c * p.z};
    }
    CAPTURE(k);
    CHECK(check_identities(a, b) == 1);
  }
}

TEST_CASE("solid_boolean: bodies of 600 decades") {
  for (const double size : {1e-300, 1e-150, 1e-80, 1.0, 1e80, 1e150, 1e300}) {
    CAPTURE(size);
    check_identities(cube(0, 0, 0, size), cube(size / 2, size / 4, size / 8, size));
    body t = irg::shape_icosahedron<double>();
    for (place& p : t.positions) p = {p.x * size, p.y * size, p.z * size};
    check_identities(cube(0, 0, 0, size), t);
  }
  check_identities(cube(0, 0, 0), box({0.25, 0.25, -1e300}, {0.5, 0.5, 1e300}));
  check_identities(cube(-1e200, -1e200, -1e200, 2e200),
                   tetrahedron({0, 0, 0}, {1e250, 0, 1}, {0, 1e-250, 0}, {3, 4, 1e10}));
}

TEST_CASE("solid_boolean: spheres, tori, float and double") {
  body a = irg::shape_sphere<double>({.slices = 24, .stacks = 13}), b = a;
  for (place& p : b.positions) p = {p.x + 0.5, p.y + 0.25, p.z + 0.125};
  check_identities(a, b);
  check_identities(a, irg::shape_torus<double>());
  body c = irg::shape_torus<double>();
  for (place& p : c.positions) p = {p.y + 1, p.z, p.x};
  check_identities(c, irg::shape_torus<double>());  // two links of a chain
  const auto r = solid_boolean(irg::shape_sphere<float>(), irg::shape_torus<float>(), boolean_operation::difference);
  CHECK(r.status == solid_boolean_status::ok);
  CHECK(test::is_balanced(r.value));
}

TEST_CASE("solid_boolean: prisms of many corners that stand on one plane") {
  constexpr int n = 24;
  body a;
  std::vector<int> low, high;
  for (int i = 0; i < n; ++i) {
    const double t = i * 6.28318530717958647692 / n, x = std::cos(t), y = std::sin(t);
    a.positions.push_back({x, y, 0});
    a.positions.push_back({x, y, 2});
    low.push_back(2 * (n - 1 - i)), high.push_back(2 * i + 1);
    const int next = 2 * ((i + 1) % n);
    irg::add_face(a, std::initializer_list<int>{2 * i, next, next + 1, 2 * i + 1});
  }
  irg::add_face(a, low), irg::add_face(a, high);
  body b = a;
  for (place& p : b.positions) p = {p.x + 0.3, p.y + 0.1, p.z};
  CHECK(check_identities(a, b) == 1);
  // No corners where only diagonals of the caps cross.
  CHECK(solid_boolean(a, b, boolean_operation::union_).value.face_count() == 8 * n + 4);
}

TEST_CASE("solid_boolean: each face tells where it comes from") {
  const body a = cube(0, 0, 0, 2), b = cube(1, 1, 1, 2);
  const auto r = solid_boolean(a, b, boolean_operation::difference);
  for (std::size_t f = 0; f < r.faces.size(); ++f) {
    const body& from = r.faces[f].body == 0 ? a : b;
    CHECK(r.faces[f].turned == (r.faces[f].body == 1));
    const auto at = [&](std::size_t k) { return from.positions[from.corner(r.faces[f].face, k).position]; };
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(irg::orient3d(at(0), at(1), at(2), r.value.positions[r.value.corner(f, k).position]) == 0);
  }
}

TEST_CASE("solid_boolean: what is no body is refused with the reason") {
  const body good = cube(0.25, 0.25, 0.25);
  const auto status = [&](const body& bad) {
    const auto r = solid_boolean(good, bad, boolean_operation::union_);
    CHECK(r.value == body{});
    CHECK((r.status == solid_boolean_status::not_a_body || r.body == 1));
    return r.status;
  };
  body open = cube(0, 0, 0);
  open.corners.resize(33);
  open.face_starts.pop_back();
  CHECK(status(open) == solid_boolean_status::open_edge);
  body turned = cube(0, 0, 0);
  std::swap(turned.corners[0], turned.corners[1]);
  CHECK(status(turned) == solid_boolean_status::edge_of_many_faces);
  body fin = cube(0, 0, 0);
  fin.positions.push_back({2, 2, 2});
  irg::add_face(fin, std::initializer_list<int>{0, 1, 8});
  CHECK(status(fin) != solid_boolean_status::ok);
  body infinite = cube(0, 0, 0);
  infinite.positions[3].x = std::numeric_limits<double>::infinity();
  CHECK(status(infinite) == solid_boolean_status::not_finite);
  body inside_out = cube(0, 0, 0);
  for (std::size_t f = 0; f < 12; ++f) std::swap(inside_out.corners[3 * f], inside_out.corners[3 * f + 1]);
  CHECK(status(inside_out) == solid_boolean_status::not_a_body);
}

namespace {

// Adds the faces of a body to another, as they are or turned.
void add_shell(body& to, const body& shell, bool is_turned) {
  const auto first = static_cast<std::uint32_t>(to.positions.size());
  to.positions.insert(to.positions.end(), shell.positions.begin(), shell.positions.end());
  for (std::size_t f = 0; f < shell.face_count(); ++f) {
    std::vector<std::uint32_t> corners;
    for (std::size_t k = 0; k < shell.face_size(f); ++k) corners.push_back(first + shell.corner(f, k).position);
    if (is_turned) std::reverse(corners.begin(), corners.end());
    irg::add_face(to, corners);
  }
}
body shells(std::initializer_list<std::pair<body, bool>> list) {
  body all;
  for (const auto& [shell, is_turned] : list) add_shell(all, shell, is_turned);
  return all;
}
constexpr std::uint32_t no_body = irg::no_index;

// That a body is refused and named, first and second, by every operation; or taken.
void check_culprit(const body& good, const body& bad, bool is_named = true) {
  for (const auto operation : all_operations) {
    const auto second = solid_boolean(good, bad, operation), first = solid_boolean(bad, good, operation);
    CHECK(second.status == solid_boolean_status::not_a_body);
    CHECK(!second);
    CHECK(first.status == solid_boolean_status::not_a_body);
    CHECK(second.body == (is_named ? 1 : no_body));
    CHECK(first.body == (is_named ? 0 : no_body));
    CHECK(second.value == body{});
  }
}

}  // namespace

TEST_CASE("solid_boolean: a shell turned inside out is refused, and named, wherever it is") {
  const body good = cube(0, 0, 0), inside_out = shells({{cube(0, 0, 0), true}});
  for (const double x : {0.5, 1.0, 5.0}) check_culprit(cube(x, 0, 0), inside_out);  // cuts it, touches it, is apart
  check_culprit(cube(-1, -1, -1, 4), inside_out);
  check_culprit(cube(0.25, 0.25, 0.25, 0.5), inside_out);
  check_culprit(cube(9, 0, 0), shells({{cube(0, 0, 0), false}, {cube(3, 0, 0), true}}));
  check_culprit(cube(9, 0, 0), shells({{cube(0, 0, 0, 4), true}, {cube(1, 1, 1, 2), false}}));  // all of it turned
  // Small, far off, of all magnitudes: the sign of the volume is exact.
  for (const double size : {0x1p-340, 0x1p-20, 0x1p340}) check_culprit(good, shells({{cube(0, 0, 0, size), true}}));
  check_culprit(good, shells({{tetrahedron({0x1p-300, 5, 0}, {0x1p300, 5, 1}, {0, 6, 0}, {7, 7, 0x1p-200}), true}}));
  CHECK(solid_boolean(good, good, boolean_operation::union_).body == no_body);
}

TEST_CASE("solid_boolean: cavities, shells in them and shells that touch are a body") {
  const body good = cube(9, 0, 0);
  const auto sum = [&](const body& b) { return volume(good, b, boolean_operation::union_); };
  CHECK(sum(shells({{cube(0, 0, 0, 4), false}, {cube(1, 1, 1, 2), true}})) == 57);
  CHECK(sum(shells({{cube(1, 1, 1, 2), true}, {cube(0, 0, 0, 4), false}})) == 57);
  CHECK(sum(shells({{cube(0, 0, 0, 8), false}, {cube(1, 1, 1, 6), true}, {cube(2, 2, 2, 2), false}})) == 305);
  CHECK(sum(shells({{cube(0, 0, 0, 4), false}, {cube(0, 0, 0, 2), true}})) == 57);  // a notch, as a shell
  CHECK(sum(shells({{cube(0, 0, 0), false}, {cube(1, 1, 0), false}})) == 3);  // joined in an edge
  body sponge = cube(0, 0, 0, 100);
  int holes = 0;
  for (int i = 0, n = trials(500, 20000); i < n; ++i, ++holes)
    add_shell(sponge, cube(1 + i % 30 * 3, 1 + i / 30 % 30 * 3, 1 + i / 900 * 3, 1), true);
  const body away = cube(200, 0, 0);
  CHECK(volume(away, sponge, boolean_operation::union_) == 1e6 - holes + 1);
}

TEST_CASE("solid_boolean: a body that cuts itself is named where it shows") {
  const body crossed = shells({{cube(0, 0, 0, 2), false}, {cube(1, 1, 1, 2), false}});
  check_culprit(cube(1.25, 1.25, 1.25, 0.5), crossed);  // where it is twice
  check_culprit(cube(1.5, 1.5, 1.5, 4), crossed);
  // A face without area where the other body meets it.
  body flat = cube(0, 0, 0);
  const auto mid = static_cast<std::uint32_t>(flat.positions.size());
  flat.positions.push_back({0.5, 0, 0});
  irg::add_face(flat, std::vector<std::uint32_t>{0, 1, mid});
  const auto r = solid_boolean(cube(0.25, -0.5, -0.5), flat, boolean_operation::union_);
  CHECK(r.status != solid_boolean_status::ok);
  CHECK(r.body == 1);
}

TEST_CASE("solid_boolean: a chain of a thousand steps stays a body") {
  test::random r(22);
  body all = cube(0, 0, 0, 8);
  int done = 0;
  for (int step = 0, n = trials(60, 1000); step < n; ++step) {
    const double x = static_cast<double>(r.integer(-64, 512)) / 64, y = static_cast<double>(r.integer(-64, 512)) / 64,
                 z = static_cast<double>(r.integer(-64, 512)) / 64;
    auto next =
        solid_boolean(all, cube(x, y, z, 0.75), step % 2 ? boolean_operation::difference : boolean_operation::union_);
    REQUIRE(next.status == solid_boolean_status::ok);
    REQUIRE(test::is_balanced(next.value));
    all = std::move(next.value);
    ++done;
  }
  CHECK(done >= 60);
}
