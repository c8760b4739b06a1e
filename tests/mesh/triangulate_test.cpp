// SPDX-License-Identifier: MIT
#include <irg/mesh/triangulate.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <vector>

#include <irg/geometry/orient2d.hpp>
#include <irg/mesh/validate.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::mesh_corner;
struct lattice_point {
  std::int64_t x, y;
  bool operator==(const lattice_point&) const = default;
};
using ring = std::vector<lattice_point>;

/// One face in a plane: the lattice point (x, y) stands at origin + x u + y v.
template <class T>
struct placement {
  irg::point<T, 3> origin{T(0), T(0), T(0)};
  irg::vec<T, 3> u{T(1), T(0), T(0)}, v{T(0), T(1), T(0)};
};

template <class T>
irg::mesh<T> face_of(const ring& r, const placement<T>& place = {}) {
  irg::mesh<T> m;
  std::vector<std::uint32_t> indices;
  for (const auto& p : r) {
    const T x = static_cast<T>(p.x), y = static_cast<T>(p.y);
    indices.push_back(static_cast<std::uint32_t>(m.positions.size()));
    m.positions.push_back({place.origin.x + x * place.u.x + y * place.v.x,
                           place.origin.y + x * place.u.y + y * place.v.y,
                           place.origin.z + x * place.u.z + y * place.v.z});
  }
  irg::add_face(m, indices);
  return m;
}

std::int64_t cross(const lattice_point& a, const lattice_point& b, const lattice_point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
std::int64_t twice_area(const ring& r) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < r.size(); ++i) sum += cross({0, 0}, r[i], r[(i + 1) % r.size()]);
  return sum;
}

/// Triangles of a one-face mesh in lattice coordinates: position i is ring vertex i.
template <class T>
std::vector<ring> triangles_of(const irg::mesh<T>& m, const ring& r) {
  std::vector<ring> out;
  for (std::size_t f = 0; f < m.face_count(); ++f)
    out.push_back({r[m.corner(f, 0).position], r[m.corner(f, 1).position], r[m.corner(f, 2).position]});
  return out;
}

/// Whether the polygon holds (x + 1/3, y + 1/7), by counting crossings: no such point is on an edge between lattice
/// points closer than 21. Scaled by 21.
bool holds(const ring& r, lattice_point p) {
  bool in = false;
  for (std::size_t i = 0; i < r.size(); ++i) {
    lattice_point a = r[i], b = r[(i + 1) % r.size()];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (a.y > b.y) std::swap(a, b);
    in ^= cross(a, b, p) > 0;
  }
  return in;
}
ring scaled(ring r) {
  for (auto& p : r) p = {p.x * 21, p.y * 21};
  return r;
}

/// n - 2 triangles of the polygon's own direction, all with area, which make up its area: then they cover it exactly
/// once if they lie in it, which sample points decide.
template <class T>
void check_simple(const ring& r, const placement<T>& place = {}) {
  const irg::mesh<T> m = irg::triangulated(face_of<T>(r, place));
  REQUIRE(irg::validate(m) == irg::mesh_finding{});
  const auto triangles = triangles_of(m, r);
  REQUIRE(triangles.size() == r.size() - 2);
  const std::int64_t area = twice_area(r);
  std::int64_t sum = 0;
  for (const ring& t : triangles) {
    REQUIRE((twice_area(t) > 0) == (area > 0));
    REQUIRE(twice_area(t) != 0);
    sum += twice_area(t);
  }
  REQUIRE(sum == area);
  lattice_point low = r[0], high = r[0];
  for (const auto& p : r) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const std::int64_t step_x = (high.x - low.x) / 24 + 1, step_y = (high.y - low.y) / 24 + 1;
  std::vector<ring> large;
  for (const ring& t : triangles) large.push_back(scaled(t));
  const ring whole = scaled(r);
  for (std::int64_t y = low.y; y < high.y; y += step_y)
    for (std::int64_t x = low.x; x < high.x; x += step_x) {
      const lattice_point p{21 * x + 7, 21 * y + 3};
      const auto count = std::count_if(large.begin(), large.end(), [&](const ring& t) { return holds(t, p); });
      REQUIRE(count == (holds(whole, p) ? 1 : 0));
    }
}

/// Signed areas agree for every polygon, simple or not.
void check_any(const ring& r) {
  const irg::mesh<double> m = irg::triangulated(face_of<double>(r));
  REQUIRE(irg::validate(m) == irg::mesh_finding{});
  std::int64_t sum = 0;
  for (const ring& t : triangles_of(m, r)) sum += twice_area(t);
  REQUIRE(m.face_count() == r.size() - 2);
  REQUIRE(sum == twice_area(r));
}

bool crosses(const lattice_point& a, const lattice_point& b, const lattice_point& c, const lattice_point& d) {
  const auto sign = [](std::int64_t x) { return x < 0 ? -1 : x > 0 ? 1 : 0; };
  const int s1 = sign(cross(a, b, c)), s2 = sign(cross(a, b, d)), s3 = sign(cross(c, d, a)), s4 = sign(cross(c, d, b));
  if (s1 * s2 > 0 || s3 * s4 > 0) return false;
  if (s1 != 0 || s2 != 0) return true;
  const auto overlap = [](std::int64_t p, std::int64_t q, std::int64_t s, std::int64_t t) {
    return std::max(std::min(p, q), std::min(s, t)) <= std::min(std::max(p, q), std::max(s, t));
  };
  return overlap(a.x, b.x, c.x, d.x) && overlap(a.y, b.y, c.y, d.y);
}

/// Whether no two edges meet but neighbours at their common corner.
bool is_simple(const ring& r) {
  const std::size_t n = r.size();
  for (std::size_t i = 0; i < n; ++i) {
    const auto &a = r[i], &b = r[(i + 1) % n], &c = r[(i + 2) % n];
    if (a == b) return false;
    if (cross(a, b, c) == 0 && (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y) < 0) return false;
    for (std::size_t j = i + 2; j < n; ++j)
      if (!(i == 0 && j == n - 1) && crosses(a, b, r[j], r[(j + 1) % n])) return false;
  }
  return true;
}

/// Random corners, untangled by reversing the run between two edges that meet; empty when that does not end.
ring random_simple(test::random& random, int n, int extent) {
  ring r;
  while (static_cast<int>(r.size()) < n) {
    const lattice_point p{random.integer(0, extent), random.integer(0, extent)};
    if (std::find(r.begin(), r.end(), p) == r.end()) r.push_back(p);
  }
  for (int pass = 0; pass < 200; ++pass) {
    bool changed = false;
    for (std::size_t i = 0; i < r.size(); ++i)
      for (std::size_t j = i + 2; j < r.size(); ++j)
        if (!(i == 0 && j == r.size() - 1) && crosses(r[i], r[i + 1], r[j], r[(j + 1) % r.size()])) {
          std::reverse(r.begin() + static_cast<std::ptrdiff_t>(i) + 1, r.begin() + static_cast<std::ptrdiff_t>(j) + 1);
          changed = true;
        }
    if (!changed) return is_simple(r) ? r : ring{};
  }
  return {};
}

ring reversed(ring r) {
  std::reverse(r.begin(), r.end());
  return r;
}

/// A comb: every second tooth is a notch that reaches almost through.
ring comb(int teeth) {
  ring r = {{0, 0}, {2 * teeth, 0}};
  for (int i = teeth; i-- > 0;) {
    r.push_back({2 * i + 1, 100});
    r.push_back({2 * i, 1});
  }
  return r;
}

/// A corridor that winds inwards.
ring spiral(int turns) {
  ring outer, inner;
  std::int64_t size = 8 * turns, x = 0, y = 0;
  const int dx[] = {1, 0, -1, 0}, dy[] = {0, 1, 0, -1};
  outer.push_back({x, y});
  inner.push_back({x, y + 1});
  for (int i = 0; size > 3; ++i) {
    const int d = i % 4, e = (i + 1) % 4;
    x += dx[d] * size;
    y += dy[d] * size;
    outer.push_back({x, y});
    inner.push_back({x - dx[d] + dx[e], y - dy[d] + dy[e]});
    if (i % 2 == 1 || i == 0) size -= i == 0 ? 0 : 2;
  }
  outer.insert(outer.end(), inner.rbegin(), inner.rend());
  return outer;
}

constexpr irg::mesh<double> l_shape(bool clockwise) {
  irg::mesh<double> m;
  for (const auto& p : {irg::point<double, 3>{0, 5, 0}, {2, 5, 0}, {2, 5, 1}, {1, 5, 1}, {1, 5, 2}, {0, 5, 2}})
    m.positions.push_back(p);
  if (clockwise)
    irg::add_face(m, std::initializer_list<int>{5, 4, 3, 2, 1, 0});
  else
    irg::add_face(m, std::initializer_list<int>{0, 1, 2, 3, 4, 5});
  return m;
}

/// A number of the triangles' corners in order: the same in constant evaluation and at run time.
template <class T>
constexpr std::uint64_t digest(const irg::mesh<T>& m) {
  std::uint64_t h = 14695981039346656037u;
  for (const auto& c : m.corners) h = (h ^ c.position) * 1099511628211u;
  return h;
}

}  // namespace

TEST_CASE("triangulate: at compile time as at run time") {
  constexpr std::uint64_t ordinary = digest(irg::triangulated(l_shape(false)));
  constexpr std::uint64_t other_way = digest(irg::triangulated(l_shape(true)));
  CHECK(digest(irg::triangulated(l_shape(false))) == ordinary);
  CHECK(digest(irg::triangulated(l_shape(true))) == other_way);
  CHECK_BOTH(irg::triangulated(irg::mesh<float>{}) == irg::mesh<float>{});
  constexpr auto degenerate = [] {
    irg::mesh<float> m;
    m.positions.push_back({1, 2, 3});
    irg::add_face(m, std::initializer_list<int>{0, 0, 0, 0, 0});
    return irg::triangulated(m).face_count();
  };
  CHECK_BOTH(degenerate() == 3);
  constexpr auto hostile = [](double hair) {  // the widest square there is; corner 3 lies off its diagonal by a hair
    constexpr double huge = std::numeric_limits<double>::max();
    irg::mesh<double> m;
    for (const auto& p : {irg::point<double, 3>{-huge, -huge, 0}, {huge, -huge, 0}, {huge, huge, 0}, {-hair, hair, 0}})
      m.positions.push_back(p);
    irg::add_face(m, std::initializer_list<int>{0, 1, 2, 3});
    const auto t = irg::triangulated(m);
    return t.corner(0, 0).position * 100 + t.corner(0, 1).position * 10 + t.corner(0, 2).position;
  };
  CHECK_BOTH(hostile(0x1p-1074) == 12);   // convex: the diagonal 0 2
  CHECK_BOTH(hostile(-0x1p-1074) == 301);  // reflex: the diagonal 1 3
}

TEST_CASE("triangulate: an L by hand") {
  const ring l = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  check_simple<double>(l);
  check_simple<float>(reversed(l));
  check_simple<double>(l, {{0, 5, 0}, {0, 0, 1}, {1, 0, 0}});
}

TEST_CASE("triangulate: convex faces are fans, triangles stay") {
  irg::mesh<double> m = face_of<double>({{0, 0}, {3, 0}, {4, 2}, {2, 4}, {-1, 2}});
  const auto t = irg::triangulated(m);
  REQUIRE(t.face_count() == 3);
  for (std::uint32_t f = 0; f < 3; ++f)
    for (std::uint32_t k = 0; k < 3; ++k) CHECK(t.corner(f, k).position == (k == 0 ? 0 : f + k));
  CHECK(irg::triangulated(t) == t);
}

TEST_CASE("triangulate: corners keep their normals and texture coordinates, parts their faces") {
  irg::mesh<float> m = face_of<float>({{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}});
  irg::add_face(m, std::vector<int>{0, 1, 2});
  irg::add_face(m, std::vector<int>{0, 1, 2, 4});
  m.normals.assign(12, {});
  m.texcoords.assign(12, {});
  for (std::uint32_t i = 0; i < 12; ++i) m.corners[i].normal = i, m.corners[i].texcoord = 11 - i;
  m.parts = {{"a", "", "", 0, 0}, {"b", "", "", 0, 1}, {"c", "", "", 1, 0}, {"d", "", "", 1, 2}, {"e", "", "", 3, 0}};
  REQUIRE(irg::validate(m) == irg::mesh_finding{});
  const auto t = irg::triangulated(m);
  CHECK(irg::validate(t) == irg::mesh_finding{});
  CHECK(t.face_count() == 3 + 1 + 2);
  CHECK(t.parts ==
        std::vector<irg::mesh_part>{
            {"a", "", "", 0, 0}, {"b", "", "", 0, 3}, {"c", "", "", 3, 0}, {"d", "", "", 3, 3}, {"e", "", "", 6, 0}});
  for (std::size_t f = 0; f < t.face_count(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const mesh_corner& c = t.corner(f, k);
      REQUIRE(c == m.corners[c.normal]);  // each corner whole, from the face it belongs to
      REQUIRE((c.normal < 5) == (f < 3));
    }
  CHECK(t.positions == m.positions);
}

TEST_CASE("triangulate: named shapes, both ways round, from every start, in every plane") {
  const ring shapes[] = {{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}},  // concave pentagon
                         {{0, 0}, {2, 0}, {4, 0}, {4, 4}, {2, 4}, {0, 4}, {0, 2}},  // square with flat corners
                         {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1, 3}},  // triangle with flat corners
                         {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 1}},  // and on every side
                         {{0, 0}, {10, 0}, {10, 10}, {5, 1}},  // dart
                         {{0, 3}, {3, 3}, {4, 0}, {5, 3}, {8, 3}, {6, 5}, {7, 8}, {4, 6}, {1, 8}, {2, 5}},  // star
                         {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 4}, {4, 4}, {4, 2}, {0, 2}},  // C, collinear runs
                         {{0, 0}, {1, 1000000}, {2, 0}, {1, 999999}},  // sliver notch
                         {{0, 0}, {8, 0}, {8, 2}, {6, 2}, {6, 4}, {4, 4}, {4, 6}, {2, 6}, {2, 8}, {0, 8}},  // stairs
                         comb(9),
                         spiral(3)};
  const placement<double> places[] = {{},
                                      {{0, 0, 7}, {0, 1, 0}, {0, 0, 1}},
                                      {{1, 2, 3}, {0, 0, 1}, {1, 0, 0}},
                                      {{1, 2, 3}, {1, 0, 1}, {0, 1, 1}},
                                      {{-5, 0, 9}, {0, 1, -2}, {3, 1, 0}},
                                      {{0x1p20, 0, 0}, {0x1p-10, 0, 0x1p-9}, {0, 0x1p-8, 0}}};
  for (ring r : shapes) {
    REQUIRE(is_simple(r));
    for (std::size_t start = 0; start < r.size(); ++start) {
      for (const auto& place : places) {
        check_simple<double>(r, place);
        check_simple<double>(reversed(r), place);
      }
      check_simple<float>(r);
      std::rotate(r.begin(), r.begin() + 1, r.end());
    }
  }
}

TEST_CASE("triangulate: random simple polygons") {
  test::random random(1);
  const int rounds = std::getenv("IRG_RELEASE_TIER") ? 200'000 : 3000;
  int simple = 0;
  for (int i = 0; i < rounds; ++i) {
    const int n = static_cast<int>(random.integer(4, i % 20 == 0 ? 60 : 12));
    const ring r = random_simple(random, n, static_cast<int>(n / 4 + random.integer(3, 16)));
    if (r.empty()) continue;
    ++simple;
    check_simple<double>(i % 2 == 0 ? r : reversed(r));
    if (i % 4 == 0) check_simple<float>(r, {{0, 0, 0}, {1, 2, 0}, {0, 1, 1}});
  }
  CHECK(simple > rounds / 2);
}

TEST_CASE("triangulate: every polygon of 4 and 5 corners on a small lattice, crossing itself or not") {
  const auto at = [](int i) { return lattice_point{i % 3, i / 3}; };
  for (int code = 0; code < 9 * 9 * 9 * 9; ++code) {
    const ring r = {at(code % 9), at(code / 9 % 9), at(code / 81 % 9), at(code / 729)};
    check_any(r);
    if (is_simple(r)) check_simple<double>(r);
  }
  for (int code = 0; code < 9 * 9 * 9 * 9; ++code) {
    const ring r = {at(4), at(code % 9), at(code / 9 % 9), at(code / 81 % 9), at(code / 729)};
    check_any(r);
    if (is_simple(r)) check_simple<double>(r);
  }
}

TEST_CASE("triangulate: faces that touch themselves") {
  // Squares with holes, joined by bridges that are walked twice: cut like simple ones, without a triangle of no area.
  check_simple<double>({{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {3, 3}, {3, 6}, {6, 6}, {6, 3}, {3, 3}});
  check_simple<double>(
      {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {1, 1}, {0, 0}, {4, 1}, {8, 5}, {8, 1}, {4, 1}});
  check_simple<double>({{0, 0}, {8, 0}, {8, 8}, {0, 8}, {2, 6}, {6, 6}, {6, 2}, {2, 2}, {2, 6}, {0, 8}});
  check_simple<double>({{0, 0},
                        {33, 23},
                        {32, 19},
                        {27, 17},
                        {32, 22},
                        {33, 23},
                        {0, 0},
                        {40, 0},
                        {40, 40},
                        {0, 40},
                        {4, 31},
                        {6, 34},
                        {10, 32},
                        {9, 28},
                        {5, 29},
                        {4, 31},
                        {0, 40}});
  // A spike has no area: it goes without leaving triangles that turn the other way.
  ring spiked = {{0, 0}, {4, 0}, {4, 4}, {9, 9}, {4, 4}, {1, 3}, {0, 4}};
  for (std::size_t start = 0; start < spiked.size(); ++start) {
    for (const ring& t : triangles_of(irg::triangulated(face_of<double>(spiked)), spiked)) CHECK(twice_area(t) >= 0);
    std::rotate(spiked.begin(), spiked.begin() + 1, spiked.end());
  }
  check_any({{0, 0}, {4, 0}, {4, 4}, {9, 9}, {4, 4}, {0, 4}});  // spike
  check_any({{0, 0}, {2, 2}, {4, 0}, {4, 4}, {2, 2}, {0, 4}});  // two triangles at one point
  check_any({{0, 0}, {4, 0}, {0, 0}, {4, 0}, {0, 0}});  // to and fro
  check_any({{0, 0}, {5, 9}, {10, 0}, {0, 6}, {10, 6}});  // pentagram
  test::random random(9);
  for (int i = 0; i < 3000; ++i) {
    ring r;
    for (auto n = random.integer(4, 14); n > 0; --n) r.push_back({random.integer(0, 4), random.integer(0, 4)});
    check_any(r);
  }
}

TEST_CASE("triangulate: decisions are exact where rounded arithmetic fails") {
  // A dart whose notch lies off the diagonal by one ulp or not at all, far from and near the origin, at every scale.
  for (const double offset : {0.0, 0.5, 12.0, 1e6})
    for (const double scale : {0x1p-1060, 0x1p-500, 1.0, 0x1p500, 0x1p1000})
      for (int ulps = -2; ulps <= 2; ++ulps) {
        if (scale == 0x1p-1060 && offset != 0) continue;
        irg::mesh<double> m;
        double middle = offset + 12;
        for (int i = 0; i < ulps; ++i) middle = std::nextafter(middle, 1e300);
        for (int i = 0; i > ulps; --i) middle = std::nextafter(middle, -1e300);
        const double a = offset, b = offset + 24;
        for (const auto& p : {irg::point<double, 3>{a, a, 0}, {b, a, 0}, {b, b, 0}, {offset + 12, middle, 0}})
          m.positions.push_back({p.x * scale, p.y * scale, 0});
        irg::add_face(m, std::vector<int>{0, 1, 2, 3});
        if (m.positions[3].y / scale != middle) continue;  // subnormal: the ulp is lost
        const auto t = irg::triangulated(m);
        REQUIRE(t.face_count() == 2);
        // Corner 3 above the diagonal: convex, a fan. On it or below: the only diagonal with area is 1 3.
        const bool from_zero =
            t.corner(0, 0).position == 0 && t.corner(0, 1).position == 1 && t.corner(0, 2).position == 2;
        CHECK(from_zero == (ulps > 0));
      }
}

TEST_CASE("triangulate: a face whose area is lost in rounding is looked at along every axis") {
  const ring l = {{2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 0}};  // whose fan would be wrong
  check_simple<double>(l, {{0x1p1000, 0, 0}, {0, 0x1p-500, 0}, {0, 0, 0x1p-500}});
  check_simple<double>(l, {{0, 0x1p1000, 0}, {0, 0, 0x1p-500}, {0x1p-500, 0, 0}});
  check_simple<double>(l, {{0, 0, 0x1p1000}, {0x1p-500, 0, 0}, {0, 0x1p-500, 0}});
}

TEST_CASE("triangulate: large faces") {
  const auto circle = [](int n, auto radius) {
    irg::mesh<double> m;
    std::vector<std::uint32_t> indices;
    for (int i = 0; i < n; ++i) {
      const double t = 6.283185307179586 * i / n, r = radius(i);
      indices.push_back(static_cast<std::uint32_t>(i));
      m.positions.push_back({r * std::cos(t), r * std::sin(t), 0});
    }
    irg::add_face(m, indices);
    return m;
  };
  const auto all_forward = [](const irg::mesh<double>& t) {
    using flat = irg::point<double, 2>;
    for (std::size_t f = 0; f < t.face_count(); ++f) {
      const auto &a = t.positions[t.corner(f, 0).position], &b = t.positions[t.corner(f, 1).position],
                 &c = t.positions[t.corner(f, 2).position];
      if (irg::orient2d(flat{a.x, a.y}, flat{b.x, b.y}, flat{c.x, c.y}) <= 0) return false;
    }
    return true;
  };
  SUBCASE("10^6 corners, convex") {
    const auto t = irg::triangulated(circle(1'000'000, [](int) { return 1e9; }));
    CHECK(t.face_count() == 999'998);
    CHECK(all_forward(t));
  }
  SUBCASE("10^5 corners, jagged") {
    test::random random(4);
    const auto t = irg::triangulated(circle(100'000, [&](int) { return 1 + random.unit() * 0.01; }));
    CHECK(t.face_count() == 99'998);
    CHECK(all_forward(t));
  }
  SUBCASE("10^6 corners at three points") {
    irg::mesh<double> m;
    m.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    std::vector<int> indices;
    for (int i = 0; i < 1'000'000; ++i) indices.push_back(i % 3);
    irg::add_face(m, indices);
    CHECK(irg::triangulated(m).face_count() == 999'998);
  }
  SUBCASE("a comb of 2001 corners, within its budget and beyond") {
    check_simple<double>(comb(1000));
    const auto t = irg::triangulated(face_of<double>(comb(1000)), {.tests_per_corner = 1});
    CHECK(t.face_count() == 2000);
    std::int64_t sum = 0;
    for (const ring& r : triangles_of(t, comb(1000))) sum += twice_area(r);
    CHECK(sum == twice_area(comb(1000)));
  }
}

TEST_CASE("triangulate: other scalars") {
  irg::mesh<int> m = face_of<int>({{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}});
  CHECK(irg::triangulated(m).face_count() == 3);
  check_simple<int>({{0, 3}, {3, 3}, {4, 0}, {5, 3}, {8, 3}, {6, 5}, {7, 8}, {4, 6}, {1, 8}, {2, 5}});
}
