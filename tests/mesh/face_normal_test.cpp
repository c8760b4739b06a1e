// SPDX-License-Identifier: MIT
#include <irg/mesh/face_normal.hpp>

#include <array>
#include <cmath>
#include <limits>

#include <irg/mesh/shapes.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

using namespace irg;

namespace {

using V3 = vec<double, 3>;
using P3 = point<double, 3>;
constexpr double largest = std::numeric_limits<double>::max();

/// A mesh of one polygon.
template <class T, std::size_t N>
constexpr mesh<T> polygon(const std::array<point<T, 3>, N>& vertices) {
  mesh<T> m;
  std::array<std::uint32_t, N> indices{};
  for (std::size_t k = 0; k < N; ++k) {
    m.positions.push_back(vertices[k]);
    indices[k] = static_cast<std::uint32_t>(k);
  }
  add_face(m, indices);
  return m;
}

template <class T>
constexpr mesh<T> right_angle(T size) {
  return polygon<T, 3>({point<T, 3>{T(0), T(0), T(0)}, point<T, 3>{size, T(0), T(0)}, point<T, 3>{T(0), size, T(0)}});
}

constexpr bool is_near(const V3& a, const V3& b, double tolerance) { return length(a - b) <= tolerance; }

}  // namespace

TEST_CASE("face_normal: type facts") {
  static_assert(std::is_same_v<decltype(face_normal(mesh<float>{}, 0)), std::optional<vec<float, 3>>>);
  static_assert(noexcept(face_normal(std::declval<const mesh<double>&>(), 0)));
}

TEST_CASE("face_normal: Newell's sums, golden") {
  CHECK_BOTH(newell_normal(std::array<P3, 4>{P3{0, 0, 0}, P3{1, 0, 0}, P3{1, 1, 0}, P3{0, 1, 0}}) == V3{0, 0, 2});
  CHECK_BOTH(newell_normal(std::array<P3, 4>{P3{0, 0, 0}, P3{2, 0, 0}, P3{2, 2, 1}, P3{0, 2, 0}}) == V3{-2, -2, 8});
  CHECK_BOTH(newell_normal(std::array<P3, 3>{P3{1, 0, 0}, P3{0, 2, 0}, P3{0, 0, 3}}) == V3{6, 3, 2});
  CHECK_BOTH(newell_normal(std::array<P3, 3>{P3{0, 0, 0}, P3{1, 1, 1}, P3{2, 2, 2}}) == V3{});
}

TEST_CASE("face_normal: the faces of the cube, golden") {
  constexpr std::array<V3, 12> expected{V3{0, -1, 0}, V3{0, -1, 0}, V3{1, 0, 0},  V3{1, 0, 0},
                                        V3{0, 1, 0},  V3{0, 1, 0},  V3{-1, 0, 0}, V3{-1, 0, 0},
                                        V3{0, 0, -1}, V3{0, 0, -1}, V3{0, 0, 1},  V3{0, 0, 1}};
  const mesh<double> cube = shape_cube<double>();
  for (std::size_t f = 0; f < 12; ++f) CHECK(*face_normal(cube, f) == expected[f]);
}

TEST_CASE("face_normal: random triangles against 64-bit cross products, far from the origin") {
  test::random r(1);
  for (int k = 0; k < 20000; ++k) {
    const double away = (r.next() & 1u) != 0 ? 1e6 : 0;
    const auto at = [&] { return P3{away + r.unit(), away - r.unit(), away + r.unit()}; };
    const P3 p = at(), q = at(), s = at();
    const mesh<double> m = polygon<double, 3>({p, q, s});
    const auto d = [&](double x, double y) { return static_cast<long double>(x) - static_cast<long double>(y); };
    const long double ax = d(q.x, p.x), ay = d(q.y, p.y), az = d(q.z, p.z), bx = d(s.x, p.x), by = d(s.y, p.y),
                      bz = d(s.z, p.z);
    const long double x = ay * bz - az * by, y = az * bx - ax * bz, z = ax * by - ay * bx,
                      n = std::sqrt(x * x + y * y + z * z);
    if (n < 1e-3L) continue;
    const V3 exact{static_cast<double>(x / n), static_cast<double>(y / n), static_cast<double>(z / n)};
    CHECK(is_near(*face_normal(m, 0), exact, 3e-13));
  }
}

TEST_CASE("face_normal: faces of any size") {
  CHECK_BOTH(*face_normal(right_angle(1.0), 0) == V3{0, 0, 1});
  CHECK_BOTH(*face_normal(right_angle(1e-200), 0) == V3{0, 0, 1});
  CHECK_BOTH(*face_normal(right_angle(5e-324), 0) == V3{0, 0, 1});
  CHECK_BOTH(*face_normal(right_angle(largest), 0) == V3{0, 0, 1});
  CHECK_BOTH(*face_normal(right_angle(3e38f), 0) == vec<float, 3>{0, 0, 1});
  CHECK_BOTH(*face_normal(right_angle(1e-45f), 0) == vec<float, 3>{0, 0, 1});
  CHECK_BOTH(*face_normal(polygon<double, 3>({P3{-largest, 0, 0}, P3{largest, 0, 0}, P3{0, largest, 0}}), 0) ==
             V3{0, 0, 1});
  CHECK_BOTH(*face_normal(polygon<double, 3>({P3{0, 0, 0}, P3{1, 0, 0}, P3{0, 1e-300, 0}}), 0) == V3{0, 0, 1});
}

TEST_CASE("face_normal: degenerate and hostile faces have none") {
  constexpr double nan_ = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  CHECK_BOTH(!face_normal(polygon<double, 3>({P3{0, 0, 0}, P3{1, 1, 1}, P3{2, 2, 2}}), 0));
  CHECK_BOTH(!face_normal(polygon<double, 3>({P3{7, 7, 7}, P3{7, 7, 7}, P3{7, 7, 7}}), 0));
  CHECK_BOTH(!face_normal(polygon<double, 2>({P3{0, 0, 0}, P3{1, 0, 0}}), 0));
  CHECK_BOTH(!face_normal(polygon<double, 3>({P3{0, 0, 0}, P3{1, nan_, 0}, P3{0, 1, 0}}), 0));
  CHECK_BOTH(!face_normal(polygon<double, 3>({P3{0, 0, 0}, P3{1, 0, 0}, P3{0, inf, 0}}), 0));
  // A bow tie's halves cancel.
  CHECK_BOTH(!face_normal(polygon<double, 4>({P3{0, 0, 0}, P3{1, 1, 0}, P3{1, 0, 0}, P3{0, 1, 0}}), 0));
}
