// SPDX-License-Identifier: MIT
#include <irg/solid/point_in_solid.hpp>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include <irg/mesh/convex_body.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/solid/solid_locator.hpp>

#include "support/big_rational.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/ulp.hpp"

using irg::location;
using irg::point_in_convex_solid;
using irg::point_in_solid;

namespace {

using solid_mesh = irg::mesh<double>;
using solid_point = irg::point<double, 3>;

// The course's prism over an L, whose two bases are faces of six corners.
constexpr solid_mesh prism_over_l() {
  constexpr std::array<std::array<double, 2>, 6> foot{{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}};
  solid_mesh m;
  for (const double z : {0.0, 1.0})
    for (const auto& p : foot) m.positions.push_back({p[0], p[1], z});
  irg::add_face(m, std::array<std::size_t, 6>{5, 4, 3, 2, 1, 0});
  irg::add_face(m, std::array<std::size_t, 6>{6, 7, 8, 9, 10, 11});
  for (std::size_t i = 0; i < 6; ++i)
    irg::add_face(m, std::array<std::size_t, 4>{i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6});
  return m;
}

constexpr solid_mesh moved(solid_mesh m, double scale, const solid_point& to) {
  for (solid_point& p : m.positions) p = {p.x * scale + to.x, p.y * scale + to.y, p.z * scale + to.z};
  return m;
}

solid_mesh inside_out(const solid_mesh& m) {
  solid_mesh out;
  out.positions = m.positions;
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    std::vector<std::size_t> face;
    for (std::size_t k = m.face_size(f); k-- > 0;) face.push_back(m.corner(f, k).position);
    irg::add_face(out, face);
  }
  return out;
}

solid_mesh joined(solid_mesh a, const solid_mesh& b) {
  const std::size_t shift = a.positions.size();
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (std::size_t f = 0; f < b.face_count(); ++f) {
    std::vector<std::size_t> face;
    for (std::size_t k = 0; k < b.face_size(f); ++k) face.push_back(b.corner(f, k).position + shift);
    irg::add_face(a, face);
  }
  return a;
}

// A body of unit cubes: full ones among side x side x side, and its surface of squares.
struct cube_heap {
  static constexpr int side = 4;
  std::array<bool, side * side * side> full{};

  bool at(int x, int y, int z) const {
    const bool within = x >= 0 && y >= 0 && z >= 0 && x < side && y < side && z < side;
    return within && full[static_cast<std::size_t>((z * side + y) * side + x)];
  }

  solid_mesh surface() const {
    solid_mesh m;
    const auto corner = [](int x, int y, int z) {
      return static_cast<std::size_t>((z * (side + 1) + y) * (side + 1) + x);
    };
    for (int z = 0; z <= side; ++z)
      for (int y = 0; y <= side; ++y)
        for (int x = 0; x <= side; ++x)
          m.positions.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
    for (int z = 0; z < side; ++z)
      for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
          if (!at(x, y, z)) continue;
          const auto c = [&](int i, int j, int k) { return corner(x + i, y + j, z + k); };
          const auto face = [&](std::size_t p, std::size_t q, std::size_t r, std::size_t s) {
            irg::add_face(m, std::array{p, q, r, s});
          };
          if (!at(x - 1, y, z)) face(c(0, 0, 0), c(0, 0, 1), c(0, 1, 1), c(0, 1, 0));
          if (!at(x + 1, y, z)) face(c(1, 0, 0), c(1, 1, 0), c(1, 1, 1), c(1, 0, 1));
          if (!at(x, y - 1, z)) face(c(0, 0, 0), c(1, 0, 0), c(1, 0, 1), c(0, 0, 1));
          if (!at(x, y + 1, z)) face(c(0, 1, 0), c(0, 1, 1), c(1, 1, 1), c(1, 1, 0));
          if (!at(x, y, z - 1)) face(c(0, 0, 0), c(0, 1, 0), c(1, 1, 0), c(1, 0, 0));
          if (!at(x, y, z + 1)) face(c(0, 0, 1), c(1, 0, 1), c(1, 1, 1), c(0, 1, 1));
        }
    return m;
  }

  // Of a point whose coordinates are halves of whole numbers, by the cubes that it is within or touches.
  location locate(int x2, int y2, int z2) const {
    int any = 0, all = 0;
    for (int k = 0; k < 8; ++k) {
      const auto cell = [&](int twice, int upper) { return twice % 2 != 0 ? (twice - 1) / 2 : twice / 2 - 1 + upper; };
      ++all;
      any += at(cell(x2, k & 1), cell(y2, k >> 1 & 1), cell(z2, k >> 2 & 1));
    }
    return any == 0 ? location::outside : any == all ? location::inside : location::boundary;
  }
};

TEST_CASE("point_in_solid: the course's cube and the prism over an L") {
  constexpr auto cube = [] { return irg::shape_cube<double>(); };
  CHECK_BOTH(point_in_convex_solid(cube(), {0.5, 0.5, 0.5}) == location::inside);
  CHECK_BOTH(point_in_solid(cube(), {0.25, 0.75, 0.125}) == location::inside);
  CHECK_BOTH(point_in_convex_solid(cube(), {2, 0, 0}) == location::outside);
  CHECK_BOTH(point_in_solid(cube(), {1, 1, 1}) == location::boundary);
  CHECK_BOTH(point_in_convex_solid(cube(), {1, 1, 1}) == location::boundary);
  CHECK_BOTH(point_in_solid(cube(), {0.5, 0.5, 1}) == location::boundary);
  CHECK_BOTH(point_in_solid(cube(), {-1, -1, -1}) == location::outside);
  CHECK_BOTH(point_in_solid(prism_over_l(), {0.5, 2.5, 0.75}) == location::inside);
  CHECK_BOTH(point_in_solid(prism_over_l(), {2, 2, 0.5}) == location::outside);
  CHECK_BOTH(point_in_solid(prism_over_l(), {-1, 0.5, 0.5}) == location::outside);
  CHECK_BOTH(point_in_solid(prism_over_l(), {1, 1, 0.5}) == location::boundary);  // on the reflex side
  CHECK_BOTH(point_in_solid(prism_over_l(), {2, 2, 1}) == location::outside);  // in a base's plane, beside it
  CHECK_BOTH(point_in_solid(prism_over_l(), {2, 1, 0.5}) == location::boundary);
  CHECK_BOTH(point_in_convex_solid(prism_over_l(), {0.5, 2.5, 0.75}) == location::outside);  // not its domain
  CHECK_BOTH(point_in_solid(solid_mesh{}, {0, 0, 0}) == location::outside);
}

TEST_CASE("point_in_solid: every half of a whole number in and round heaps of cubes (oracle: the cubes)") {
  test::random random(41);
  for (int heap = 0, heaps = std::getenv("IRG_RELEASE_TIER") ? 300 : 4; heap < heaps; ++heap) {
    cube_heap h;
    for (bool& f : h.full) f = random.integer(0, 99) < 20 + 20 * (heap % 4);
    const solid_mesh surface = h.surface();
    const irg::solid_locator locate(surface);
    const double scale = std::ldexp(1.0, heap % 3 == 0 ? 0 : heap % 3 == 1 ? 1015 : -1060);
    const solid_mesh scaled = moved(surface, scale, {});
    const irg::solid_locator locate_scaled(scaled);
    irg::solid_locator_counts counts;
    std::uint64_t wrong = 0;
    for (int z = -1; z <= 2 * cube_heap::side + 1; ++z)
      for (int y = -1; y <= 2 * cube_heap::side + 1; ++y)
        for (int x = -1; x <= 2 * cube_heap::side + 1; ++x) {
          const solid_point p{x * 0.5, y * 0.5, z * 0.5}, q{p.x * scale, p.y * scale, p.z * scale};
          const location expected = h.locate(x, y, z);
          wrong += locate(p, irg::fill_rule::non_zero, &counts) != expected;
          wrong += locate_scaled(q, irg::fill_rule::even_odd) != expected;
          if ((x + y + z) % 16 == 0) wrong += point_in_solid(surface, p) != expected;
        }
    CHECK(wrong == 0);
    CHECK(counts.triangles * 4 < counts.points * 2 * surface.face_count());  // the tree leaves most of them out
  }
}

TEST_CASE("point_in_solid: shells within shells, overlaps, bodies turned inside out") {
  const solid_mesh cube = moved(irg::shape_cube<double>(), 2, {-1, -1, -1}), small_cube = moved(cube, 0.5, {});
  const solid_mesh hollow = joined(cube, inside_out(small_cube)), twice = joined(cube, small_cube);
  CHECK(point_in_solid(hollow, {0, 0, 0}) == location::outside);
  CHECK(point_in_solid(hollow, {0.75, 0, 0}) == location::inside);
  CHECK(point_in_solid(hollow, {0.5, 0.25, 0.25}) == location::boundary);
  CHECK(irg::winding_number(twice, {0, 0, 0}) == 2);
  CHECK(irg::winding_number(twice, {0.75, 0, 0}) == 1);
  CHECK(point_in_solid(twice, {0, 0, 0}) == location::inside);
  CHECK(point_in_solid(twice, {0, 0, 0}, irg::fill_rule::even_odd) == location::outside);
  CHECK(irg::winding_number(inside_out(cube), {0, 0, 0}) == -1);
  CHECK(irg::winding_number(inside_out(cube), {3, 0, 0}) == 0);
  CHECK(!irg::winding_number(cube, {1, 0, 0}));
}

TEST_CASE("point_in_solid: NaN, infinity, faces that are not finite, faces without area") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  solid_mesh cube = moved(irg::shape_cube<double>(), 2, {-1, -1, -1});
  for (const solid_point& p : {solid_point{nan, 0, 0}, {0, inf, 0}, {0, 0, -inf}}) {
    CHECK(point_in_solid(cube, p) == location::outside);
    CHECK(point_in_convex_solid(cube, p) == location::outside);
    CHECK(irg::solid_locator(cube)(p) == location::outside);
  }
  const std::size_t v = cube.positions.size();
  cube.positions.insert(cube.positions.end(), {{5, 5, nan}, {0, 0, 7}, {0, 0, 9}});
  irg::add_face(cube, std::array<std::size_t, 3>{0, 1, v});
  irg::add_face(cube, std::array<std::size_t, 3>{v + 1, v + 2, v + 1});  // a needle over the cube
  CHECK(point_in_solid(cube, {0, 0, 0}) == location::inside);
  CHECK(point_in_solid(cube, {0, 0, 8}) == location::boundary);
  CHECK(point_in_solid(cube, {0, 0, 10}) == location::outside);
}

#ifdef IRG_HAVE_MPFR
using rational = test::big_rational;
using rational_point = std::array<rational, 3>;

rational_point exactly(const solid_point& p) { return {rational(p.x), rational(p.y), rational(p.z)}; }

// Positive where d is on the side from which a, b, c are seen counter-clockwise.
int side_in_rationals(const rational_point& a, const rational_point& b, const rational_point& c,
                      const rational_point& d) {
  rational_point u, v, w;
  for (std::size_t i = 0; i < 3; ++i) u[i] = b[i] - a[i], v[i] = c[i] - a[i], w[i] = d[i] - a[i];
  return ((u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] + (u[0] * v[1] - u[1] * v[0]) * w[2])
      .sign();
}

// By a ray in any direction that meets no side, counting what it meets; 2 where the point is on a face.
int location_in_rationals(const solid_mesh& m, const solid_point& at, test::random& random) {
  const rational_point p = exactly(at);
  for (;;) {
    const auto number = [&] { return static_cast<double>(random.integer(-1000000, 1000000)); };
    const double x = number(), y = number(), z = number();
    rational_point to = exactly({x, y, z});
    for (std::size_t i = 0; i < 3; ++i) to[i] = to[i] + p[i];
    int met = 0;
    bool usable = true;
    for (std::size_t f = 0; f < m.face_count() && usable; ++f) {
      rational_point v[3];
      for (std::size_t k = 0; k < 3; ++k) v[k] = exactly(m.positions[m.corner(f, k).position]);
      const int from = side_in_rationals(v[0], v[1], v[2], p);
      int sides[3];
      for (std::size_t k = 0; k < 3; ++k) sides[k] = side_in_rationals(p, to, v[k], v[(k + 1) % 3]);
      if (from == 0) {
        // In the plane of the face: on it when no side has it on its other hand.
        rational_point n;
        for (std::size_t i = 0; i < 3; ++i) {
          const std::size_t j = (i + 1) % 3, l = (i + 2) % 3;
          n[i] = v[0][i] + (v[1][j] - v[0][j]) * (v[2][l] - v[0][l]) - (v[1][l] - v[0][l]) * (v[2][j] - v[0][j]);
        }
        // A face without area lies on its neighbours.
        bool on = !(n[0] == v[0][0] && n[1] == v[0][1] && n[2] == v[0][2]);
        if (!on) continue;
        for (std::size_t k = 0; k < 3 && on; ++k) {
          rational_point above = v[k];
          for (std::size_t i = 0; i < 3; ++i) above[i] = v[k][i] + (n[i] - v[0][i]);
          on = side_in_rationals(v[k], v[(k + 1) % 3], above, p) <= 0;
        }
        if (on) return 2;
        continue;
      }
      usable = sides[0] != 0 && sides[1] != 0 && sides[2] != 0;
      if (!usable || sides[0] != sides[1] || sides[1] != sides[2]) continue;
      // The line meets the face; ahead where the ray's direction leads towards its plane.
      rational_point moved_face = v[0];
      for (std::size_t i = 0; i < 3; ++i) moved_face[i] = v[0][i] + (to[i] - p[i]);
      const int along = side_in_rationals(v[0], v[1], v[2], moved_face);
      if (along != from) met += along > 0 ? 1 : -1;
    }
    if (usable) return met != 0 ? 1 : 0;
  }
}

location located(int code) { return code == 2 ? location::boundary : code == 1 ? location::inside : location::outside; }

TEST_CASE("point_in_solid: tetrahedra of any magnitude, points on and beside their parts (oracle: rationals)") {
  test::random random(42);
  int found[3] = {};
  for (int i = 0, n = std::getenv("IRG_RELEASE_TIER") ? 100000 : 400; i < n; ++i) {
    const int reach = i % 4 == 0 ? 2 : i % 4 == 1 ? 60 : 480;
    const auto number = [&] {
      const double m = static_cast<double>(random.integer(-8, 8));
      return std::ldexp(m, static_cast<int>(random.integer(-reach, reach)));
    };
    solid_mesh m;
    for (int k = 0; k < 4; ++k) {
      const double x = number(), y = number(), z = number();
      m.positions.push_back({x, y, z});
    }
    const auto& v = m.positions;
    const int turn = side_in_rationals(exactly(v[0]), exactly(v[1]), exactly(v[2]), exactly(v[3]));
    if (turn == 0) continue;
    const std::size_t b = turn < 0 ? 1 : 2, c = 3 - b;
    irg::add_face(m, std::array<std::size_t, 3>{0, b, c});
    irg::add_face(m, std::array<std::size_t, 3>{0, 3, b});
    irg::add_face(m, std::array<std::size_t, 3>{b, 3, c});
    irg::add_face(m, std::array<std::size_t, 3>{c, 3, 0});
    CHECK(irg::is_convex_body(m));
    const irg::solid_locator locate(m);
    for (int k = 0; k < 8; ++k) {
      const auto any = [&] { return v[static_cast<std::size_t>(random.integer(0, 3))]; };
      const auto half = [](const solid_point& s, const solid_point& t) {
        return solid_point{s.x * 0.5 + t.x * 0.5, s.y * 0.5 + t.y * 0.5, s.z * 0.5 + t.z * 0.5};
      };
      solid_point p = any();
      for (int step = 0; step < k % 5; ++step) {
        const solid_point q = any();
        p = half(p, q);
      }
      if (k == 7) p.z = number();
      const location expected = located(location_in_rationals(m, p, random));
      ++found[static_cast<int>(expected) + 1];
      CHECK(point_in_solid(m, p) == expected);
      CHECK(point_in_convex_solid(m, p) == expected);
      CHECK(locate(p) == expected);
    }
  }
  CHECK(found[0] > 100);
  CHECK(found[1] > 100);
  CHECK(found[2] > 100);
}

TEST_CASE("point_in_solid: a torus, points that its corners, sides and planes are aligned with (oracle: rationals)") {
  test::random random(43);
  solid_mesh torus = irg::triangulated(irg::shape_torus<double>());
  torus = moved(torus, 8, {});
  for (solid_point& p : torus.positions) p = {std::nearbyint(p.x), std::nearbyint(p.y), std::nearbyint(p.z)};
  const irg::solid_locator locate(torus);
  int wrong = 0, inside = 0;
  for (int i = 0, n = std::getenv("IRG_RELEASE_TIER") ? 2000 : 20; i < n; ++i) {
    const auto number = [&](int r) { return static_cast<double>(random.integer(-r, r)); };
    const double x = number(12), y = number(4), z = number(12);
    const location expected = located(location_in_rationals(torus, {x, y, z}, random));
    inside += expected == location::inside;
    wrong += locate({x, y, z}) != expected;
  }
  CHECK(wrong == 0);
  CHECK(inside > 0);
}
#endif

}  // namespace
