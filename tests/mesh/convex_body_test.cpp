// SPDX-License-Identifier: MIT
#include <irg/mesh/convex_body.hpp>

#include <array>
#include <cstdlib>
#include <limits>
#include <vector>

#include <irg/mesh/shapes.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::is_closed;
using irg::is_convex_body;

namespace {

using convex_body_mesh = irg::mesh<double>;
using convex_body_point = irg::point<double, 3>;

// Whether every face has all corners behind its plane: convexity of a closed surface by its definition, in integers.
bool is_convex_by_definition(const convex_body_mesh& m) {
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    std::array<std::int64_t, 3> p[3]{};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i)
        p[k][i] = static_cast<std::int64_t>(m.positions[m.corner(f, k).position][static_cast<int>(i)]);
    std::array<std::int64_t, 3> u{}, v{};
    for (std::size_t i = 0; i < 3; ++i) u[i] = p[1][i] - p[0][i], v[i] = p[2][i] - p[0][i];
    const std::int64_t n[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    for (const irg::mesh_corner& c : m.corners) {
      const convex_body_point& q = m.positions[c.position];
      std::int64_t height = 0;
      for (std::size_t i = 0; i < 3; ++i)
        height += n[i] * (static_cast<std::int64_t>(q[static_cast<int>(i)]) - p[0][i]);
      if (height > 0) return false;
    }
  }
  return true;
}

// The hull of points, no four of which are in a plane: triples with all other points behind them.
convex_body_mesh hull_by_triples(const std::vector<convex_body_point>& points) {
  convex_body_mesh m;
  m.positions = points;
  const std::size_t n = points.size();
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n; ++b)
      for (std::size_t c = a + 1; c < n; ++c) {
        if (c == b) continue;
        bool outer = true;
        for (std::size_t d = 0; d < n && outer; ++d)
          outer = d == a || d == b || d == c || irg::orient3d(points[a], points[b], points[c], points[d]) < 0;
        if (outer) irg::add_face(m, std::array{a, b, c});
      }
  return m;
}

// A double pyramid over a ring of `around` corners that winds `turns` times round the axis.
constexpr std::array<std::array<int, 2>, 10> ten{
    {{100, 0}, {81, 59}, {31, 95}, {-31, 95}, {-81, 59}, {-100, 0}, {-81, -59}, {-31, -95}, {31, -95}, {81, -59}}};
constexpr convex_body_mesh double_pyramid(std::size_t around, std::size_t turns) {
  convex_body_mesh m;
  for (std::size_t i = 0; i < around; ++i) {
    const auto& at = ten[i * turns * 10 / around % 10];
    m.positions.push_back({static_cast<double>(at[0]), static_cast<double>(at[1]), 0});
  }
  m.positions.push_back({0, 0, 50});
  m.positions.push_back({0, 0, -50});
  for (std::size_t i = 0; i < around; ++i) {
    irg::add_face(m, std::array{i, (i + 1) % around, around});
    irg::add_face(m, std::array{(i + 1) % around, i, around + 1});
  }
  return m;
}

convex_body_mesh turned_inside_out(const convex_body_mesh& m) {
  convex_body_mesh out;
  out.positions = m.positions;
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    std::vector<std::uint32_t> back;
    for (std::size_t k = m.face_size(f); k-- > 0;) back.push_back(m.corner(f, k).position);
    irg::add_face(out, back);
  }
  return out;
}

constexpr convex_body_mesh both(convex_body_mesh m, const convex_body_mesh& other, double right) {
  const auto first = static_cast<std::uint32_t>(m.positions.size());
  for (const auto& p : other.positions) m.positions.push_back({p.x + right, p.y, p.z});
  for (std::size_t f = 0; f < other.face_count(); ++f) {
    std::vector<std::uint32_t> face;
    for (std::size_t k = 0; k < other.face_size(f); ++k) face.push_back(first + other.corner(f, k).position);
    irg::add_face(m, face);
  }
  return m;
}

}  // namespace

TEST_CASE("convex body: known bodies") {
  CHECK_BOTH((is_closed(irg::shape_cube<double>()) && is_convex_body(irg::shape_cube<double>())));
  CHECK_BOTH((is_convex_body(irg::shape_tetrahedron<double>()) && is_convex_body(irg::shape_octahedron<double>())));
  CHECK_BOTH(is_convex_body(double_pyramid(5, 1)));
  CHECK(is_convex_body(irg::shape_icosahedron<double>()));
  CHECK(is_closed(irg::shape_torus<double>()));
  CHECK(!is_convex_body(irg::shape_torus<double>()));
  CHECK(!is_closed(irg::shape_teapot<double>()));
  CHECK(!is_convex_body(irg::shape_grid<double>()));
}

TEST_CASE("convex body: surfaces that bend outward at every edge and are no convex body") {
  // A double pyramid over a pentagram: closed, and each edge of it bends outward.
  CHECK_BOTH((is_closed(double_pyramid(5, 2)) && !is_convex_body(double_pyramid(5, 2))));
  CHECK_BOTH(!is_convex_body(both(irg::shape_cube<double>(), irg::shape_cube<double>(), 0)));  // twice
  CHECK_BOTH(!is_convex_body(both(irg::shape_cube<double>(), irg::shape_cube<double>(), 8)));  // apart
}

TEST_CASE("convex body: hostile meshes") {
  CHECK_BOTH((is_closed(convex_body_mesh{}) && !is_convex_body(convex_body_mesh{})));
  CHECK(!is_convex_body(turned_inside_out(irg::shape_cube<double>())));
  convex_body_mesh sheet;  // a triangle and its back
  sheet.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  irg::add_face(sheet, std::array{0, 1, 2});
  CHECK(!is_closed(sheet));
  irg::add_face(sheet, std::array{0, 2, 1});
  CHECK((is_closed(sheet) && !is_convex_body(sheet)));
  convex_body_mesh open = irg::shape_cube<double>();
  open.corners.resize(open.corners.size() - open.face_size(open.face_count() - 1));
  open.face_starts.pop_back();
  CHECK((!is_closed(open) && !is_convex_body(open)));
  convex_body_mesh point;  // sides from a position to itself
  point.positions = {{0, 0, 0}};
  irg::add_face(point, std::array{0, 0, 0});
  CHECK((!is_closed(point) && !is_convex_body(point)));
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    convex_body_mesh m = irg::shape_tetrahedron<double>();
    m.positions[2].y = bad;
    CHECK(!is_convex_body(m));
  }
  for (const double scale : {1e-300, 1e300}) {
    convex_body_mesh m = irg::shape_octahedron<double>();
    for (auto& p : m.positions) p = {p.x * scale, p.y * scale, p.z * scale};
    CHECK(is_convex_body(m));
  }
}

TEST_CASE("convex body: one unit in the last place") {
  convex_body_mesh m = double_pyramid(4, 1);  // its ring is a plane quadrilateral, so no face is bent
  CHECK(is_convex_body(m) == is_convex_by_definition(m));
  // A cube of quadrilaterals with one corner off by the least step: its faces are no longer plane.
  convex_body_mesh cube;
  for (int i = 0; i < 8; ++i) cube.positions.push_back({i & 1 ? 1.0 : 0.0, i & 2 ? 1.0 : 0.0, i & 4 ? 1.0 : 0.0});
  for (const std::array<int, 4>& f :
       {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
    irg::add_face(cube, f);
  CHECK(is_convex_body(cube));
  cube.positions[7].z = 1 + std::numeric_limits<double>::epsilon();
  CHECK(!is_convex_body(cube));
  // The same corner, with faces cut so that the cut bends outward, or inward.
  for (const bool outward : {true, false}) {
    convex_body_mesh cut;
    cut.positions = cube.positions;
    for (const std::array<int, 4>& f : {std::array{0, 2, 3, 1}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
      irg::add_face(cut, f);
    const auto top = outward ? std::array{std::array{4, 5, 7}, std::array{4, 7, 6}}
                             : std::array{std::array{4, 5, 6}, std::array{5, 7, 6}};
    for (const auto& f : top) irg::add_face(cut, f);
    CHECK(is_convex_body(cut) == outward);
  }
}

TEST_CASE("convex body: random hulls, and the same with a corner moved") {
  const int trials = std::getenv("IRG_RELEASE_TIER") ? 20000 : 60;
  test::random r(16);
  int convex = 0, dented = 0;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<convex_body_point> points;
    const std::int64_t reach = trial % 2 == 0 ? 1000 : 40, depth = trial % 3 == 0 ? 3 : reach;
    const auto number = [&](std::int64_t most) { return static_cast<double>(r.integer(-most, most)); };
    const std::int64_t count = r.integer(4, 11);
    for (std::int64_t i = 0; i < count; ++i) {
      const double x = number(reach), y = number(reach), z = number(depth);
      points.push_back({x, y, z});
    }
    convex_body_mesh m = hull_by_triples(points);
    if (!is_closed(m) || m.face_count() == 0) continue;  // four points in a plane
    CHECK((is_convex_by_definition(m) && is_convex_body(m)));
    ++convex;
    const std::size_t moved = m.corner(0, 0).position;
    m.positions[moved] = {number(reach), number(reach), number(depth)};
    if (is_convex_body(m)) CHECK(is_convex_by_definition(m));
    if (!is_convex_by_definition(m)) {
      CHECK(!is_convex_body(m));
      ++dented;
    }
  }
  CHECK((convex > trials / 2 && dented > trials / 4));
}
