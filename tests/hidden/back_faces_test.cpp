// SPDX-License-Identifier: MIT
#include <irg/hidden/textbook/back_faces.hpp>
#include <irg/hidden/back_faces.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <limits>
#include <vector>

#include <irg/mesh/shapes.hpp>

#include "support/check_both.hpp"
#include "support/exact.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

namespace {

using irg::facing;
using irg::orientation;
using point2 = irg::point<double, 2>;
using point3 = irg::point<double, 3>;
using vec3 = irg::vec<double, 3>;
using hpoint3 = irg::hpoint<double, 3>;
using faces = std::vector<std::uint32_t>;

// The course's cube: 12 triangles, counter-clockwise seen from outside.
constexpr irg::mesh<double> course_cube() {
  irg::mesh<double> m;
  for (const point3& p : {point3{0, 0, 0}, point3{0, 0, 1}, point3{1, 0, 0}, point3{1, 0, 1}, point3{1, 1, 0},
                          point3{1, 1, 1}, point3{0, 1, 0}, point3{0, 1, 1}})
    m.positions.push_back(p);
  constexpr std::uint32_t f[12][3] = {{0, 2, 1}, {2, 3, 1}, {2, 4, 3}, {4, 5, 3}, {4, 6, 5}, {6, 7, 5},
                                      {6, 0, 7}, {0, 1, 7}, {0, 4, 2}, {0, 6, 4}, {1, 3, 5}, {1, 5, 7}};
  for (const auto& face : f) irg::add_face(m, face);
  return m;
}

constexpr point3 corner_of(const irg::mesh<double>& m, std::size_t f, std::size_t k) {
  return m.positions[m.corner(f, k).position];
}

// The faces of the course's cube that are visible, counted from 1, by all three forms in space.
constexpr bool shows(const point3& eye, std::initializer_list<std::uint32_t> visible,
                     std::initializer_list<std::uint32_t> edge_on) {
  const irg::mesh<double> m = course_cube();
  const auto expected = [&](std::uint32_t f) {
    for (const std::uint32_t v : visible)
      if (v == f + 1) return facing::front;
    for (const std::uint32_t v : edge_on)
      if (v == f + 1) return facing::edge_on;
    return facing::back;
  };
  faces drawn, hidden;
  for (std::uint32_t f = 0; f < 12; ++f) {
    const point3 a = corner_of(m, f, 0), b = corner_of(m, f, 1), c = corner_of(m, f, 2);
    const auto plane = *irg::plane_through(a, b, c);
    const point3 centre{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3, (a.z + b.z + c.z) / 3};
    const facing side = expected(f);
    if (irg::facing_by_plane(plane, eye) != side || irg::facing_of(m, f, irg::to_homogeneous(eye)) != side)
      return false;
    if (irg::facing_by_angle(irg::normal_of(plane), centre, eye) != side) return false;
    if (!irg::is_hidden(side)) hidden.push_back(f);
    if (side != facing::back) drawn.push_back(f);
  }
  return irg::front_faces(m, irg::to_homogeneous(eye)) == hidden &&
         irg::front_faces(m, irg::to_homogeneous(eye), irg::edge_on_faces::drawn) == drawn;
}

TEST_CASE("back_faces: the course's cube from five eyes") {
  CHECK_BOTH(shows({1, 1, 3}, {11, 12}, {3, 4, 5, 6}));
  CHECK_BOTH(shows({3, 2, 2}, {3, 4, 5, 6, 11, 12}, {}));
  CHECK_BOTH(shows({0.5, 0.5, 5}, {11, 12}, {}));
  CHECK_BOTH(shows({5, 0.5, 0.5}, {3, 4}, {}));
  CHECK_BOTH(shows({-2, -3, -4}, {1, 2, 7, 8, 9, 10}, {}));
  CHECK_BOTH(shows({1, 5, 1}, {5, 6}, {3, 4, 11, 12}));
}

TEST_CASE("back_faces: normals that point inward give the complement, as the course's text would have it") {
  CHECK_BOTH(irg::facing_by_angle(vec3{0, 0, 1}, point3{}, point3{0, 0, 5}) == facing::front);
  CHECK_BOTH(irg::facing_by_angle(vec3{0, 0, 1}, point3{}, point3{0, 0, 5}, irg::normals_point::inward) ==
             facing::back);
  CHECK_BOTH(irg::facing_by_angle(vec3{0, 0, -1}, point3{}, point3{0, 0, 5}, irg::normals_point::inward) ==
             facing::front);
  CHECK_BOTH(irg::facing_by_angle(vec3{0, 0, 1}, point3{}, point3{3, 0, 0}, irg::normals_point::inward) ==
             facing::edge_on);
}

template <std::size_t N>
constexpr bool back_by_both(const point2 (&ring)[N], bool back) {
  const bool by_order = irg::facing_by_order(ring, orientation::clockwise) != facing::front;
  std::array<point2, N> reversed{};
  for (std::size_t i = 0; i < N; ++i) reversed[i] = ring[N - 1 - i];
  return by_order == back && irg::textbook::is_back_by_edges(ring) == back &&
         irg::textbook::is_back_by_edges(reversed, orientation::counter_clockwise) == back &&
         (irg::facing_by_order(reversed) != facing::front) == back;
}

TEST_CASE("back_faces: the course's values, orientation in the projection plane") {
  constexpr point2 cw[] = {{0, 0}, {0, 2}, {2, 0}}, ccw[] = {{0, 0}, {2, 0}, {0, 2}};
  constexpr point2 cw_square[] = {{0, 0}, {0, 1}, {1, 1}, {1, 0}}, ccw_square[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  constexpr point2 line[] = {{0, 0}, {1, 1}, {2, 2}};
  CHECK_BOTH(back_by_both(cw, false));
  CHECK_BOTH(back_by_both(ccw, true));
  CHECK_BOTH(back_by_both(cw_square, false));
  CHECK_BOTH(back_by_both(ccw_square, true));
  CHECK_BOTH(back_by_both(line, true));
  CHECK_BOTH(irg::facing_by_order(line) == facing::edge_on);
  CHECK_BOTH(irg::facing_by_order(std::array<point2, 0>{}) == facing::edge_on);
  CHECK_BOTH(irg::facing_by_order(std::array{point2{1, 2}, point2{3, 4}}) == facing::edge_on);
}

// The side by rationals, from the first vertex and the cross product of two edges.
facing exact_side(const irg::mesh<double>& m, const point3& eye) {
  __extension__ using I = __int128;
  const auto d = [&](const point3& a, int i) { return static_cast<I>(a[i]) - static_cast<I>(corner_of(m, 0, 0)[i]); };
  const point3 b = corner_of(m, 0, 1), c = corner_of(m, 0, 2);
  I value = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    value += d(eye, i) * (d(b, j) * d(c, k) - d(b, k) * d(c, j));
  }
  return value > 0 ? facing::front : value < 0 ? facing::back : facing::edge_on;
}

TEST_CASE("back_faces: random triangles of integers, exactly") {
  const bool release = std::getenv("IRG_RELEASE_TIER") != nullptr;
  test::random r(7);
  int edge_on = 0;
  for (int trial = 0; trial < (release ? 2000000 : 20000); ++trial) {
    const int range = trial % 2 ? 5 : 1 << 16;
    const auto number = [&] { return static_cast<double>(r.integer(-range, range)); };
    irg::mesh<double> m;
    for (int i = 0; i < 3; ++i) m.positions.push_back({number(), number(), number()});
    irg::add_face(m, std::array{0, 1, 2});
    const point3 eye{number(), number(), number()};
    const facing side = exact_side(m, eye);
    edge_on += side == facing::edge_on;
    CHECK(irg::facing_of(m, 0, irg::to_homogeneous(eye)) == side);
    const auto plane = irg::plane_through(m.positions[0], m.positions[1], m.positions[2]);
    if (plane) CHECK(irg::facing_by_angle(irg::normal_of(*plane), m.positions[0], eye) == side);
  }
  CHECK(edge_on > 100);
}

static_assert(irg::facing_by_angle(vec3{1e-300, 1e300, 1}, point3{1, 1, 1}, point3{1e300, 1, -1}) == facing::back);

// A vector is no eye: it is refused in a question, too.
template <class Eye>
concept sees_by_plane = requires(const irg::plane<double>& face, const Eye& eye) { irg::facing_by_plane(face, eye); };
static_assert(sees_by_plane<irg::point<double, 3>> && sees_by_plane<irg::hpoint<double, 3>>);
static_assert(!sees_by_plane<irg::vec<double, 3>>);

#ifdef IRG_HAVE_MPFR
// Sides by rationals: Newell's normal as the sum of the cross products of neighbouring vertices themselves.
TEST_CASE_TEMPLATE("back_faces: every form is exact, for coordinates of every size", T, double, float) {
  using E = test::exact;
  test::random r(9);
  int edge_on = 0;
  for (const test::spread kind : test::all_spreads)
    for (int trial = 0; trial < test::trials(300); ++trial) {
      const auto any = [&] { return test::any_coordinate<T>(r, kind); };
      const std::size_t n = 3 + static_cast<std::size_t>(trial % 3);
      irg::mesh<T> m;
      std::vector<int> face;
      for (std::size_t k = 0; k < n; ++k) {
        m.positions.push_back({any(), any(), trial % 5 == 0 ? T(1) : any()});
        face.push_back(static_cast<int>(k));
      }
      irg::add_face(m, face);
      const T weight = trial % 4 == 0 ? T(0) : trial % 4 == 1 ? std::abs(any()) : T(1);
      const irg::hpoint<T, 3> eye{any(), any(), trial % 7 == 0 ? T(1) : any(), weight};
      const auto at = [&](std::size_t k, int i) { return E(static_cast<double>(m.positions[k % n][i])); };
      const auto sign = [](const E& x) { return static_cast<facing>(x.sign()); };
      E value(0), area(0), cosine(0);
      for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        E normal(0);
        for (std::size_t v = 0; v < n; ++v) normal = normal + at(v, j) * at(v + 1, k) - at(v, k) * at(v + 1, j);
        if (i == 2) area = normal;
        const E way = E(static_cast<double>(eye[i])) - E(static_cast<double>(eye.w)) * at(0, i);
        value = value + normal * way;
        cosine = cosine + at(1, i) * (at(2, i) - at(0, i));
      }
      const facing side = irg::facing_of(m, 0, eye);
      CHECK(side == sign(value));
      edge_on += side == facing::edge_on;
      const irg::point<T, 3> p0 = m.positions[0], p1 = m.positions[1], p2 = m.positions[2];
      CHECK(irg::facing_by_angle(irg::vec<T, 3>{p1.x, p1.y, p1.z}, p0, p2) == sign(cosine));
      std::vector<irg::point<T, 2>> flat;
      for (const auto& q : m.positions) flat.push_back({q.x, q.y});
      CHECK(irg::facing_by_order(flat) == sign(area));
      CHECK(irg::facing_by_order(flat, orientation::clockwise) == sign(E(0) - area));
      if (n == 3 && area.sign() != 0)
        CHECK(irg::textbook::is_back_by_edges(flat, orientation::counter_clockwise) == (area.sign() < 0));
    }
  CHECK(edge_on > 100);
}
#endif

TEST_CASE("back_faces: what cannot be seen, and what is out of range") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  irg::mesh<double> m;
  m.positions = {{0, 0, 0},   {1, 0, 0},     {2, 0, 0},     {0, 1, 0},     {nan, 0, 0},
                 {inf, 1, 0}, {1e308, 0, 0}, {0, 1e308, 0}, {0, 5e-324, 0}};
  for (const auto& f : {std::array{0, 1, 2}, {0, 0, 0}, {0, 1, 4}, {0, 1, 5}, {0, 6, 7}, {0, 1, 8}})
    irg::add_face(m, f);
  for (std::size_t f = 0; f < 4; ++f) CHECK(irg::facing_of(m, f, hpoint3{0, 0, 1, 1}) == facing::edge_on);
  for (std::size_t f = 4; f < 6; ++f) {
    CHECK(irg::facing_of(m, f, hpoint3{0, 0, 1, 1}) == facing::front);
    CHECK(irg::facing_of(m, f, hpoint3{0, 0, -1, 1}) == facing::back);
    CHECK(irg::facing_of(m, f, hpoint3{0, 0, nan, 1}) == facing::edge_on);
  }
  CHECK(irg::front_faces(m, hpoint3{0, 0, 1, 1}) == faces{4, 5});
}

TEST_CASE("back_faces: rationals and floats") {
  using Q = test::rational;
  using irg::point;
  const auto plane =
      irg::plane_through(point<Q, 3>{Q(0), Q(0), Q(0)}, point<Q, 3>{Q(1), Q(0), Q(0)}, point<Q, 3>{Q(0), Q(1), Q(0)});
  CHECK(irg::facing_by_plane(*plane, point<Q, 3>{Q(1), Q(2), Q(1) / Q(1000000007)}) == facing::front);
  CHECK(irg::facing_by_plane(*plane, point<Q, 3>{Q(1), Q(2), Q(0)}) == facing::edge_on);
  irg::mesh<float> m;
  m.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  irg::add_face(m, std::array{0, 1, 2});
  CHECK(irg::front_faces(m, irg::hpoint<float, 3>{0, 0, 1e-30f, 1}) == faces{0});
}

}  // namespace
