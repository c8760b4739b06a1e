// SPDX-License-Identifier: MIT
#include <irg/curve/bezier_surface.hpp>

#include <cmath>
#include <vector>

#include "support/check_both.hpp"
#include "support/random.hpp"

using namespace irg;

namespace {

using P3 = point<double, 3>;
using V3 = vec<double, 3>;
using bicubic = bezier_patch<P3>;

constexpr bezier_patch<P3, 1, 1> quad{{{{P3{0, 0, 0}, P3{0, 2, 0}}, {P3{3, 0, 0}, P3{3, 2, 6}}}}};

bicubic random_patch(test::random& r) {
  bicubic patch;
  for (auto& row : patch.points)
    for (P3& p : row) p = {r.unit(), r.unit(), r.unit()};
  return patch;
}

constexpr bool is_near(const V3& a, const V3& b, double tolerance) { return length(a - b) <= tolerance; }

/// One octant of a unit sphere's Bezier imitation, its upper border shrunk to the pole (0, 1, 0).
constexpr bicubic capped() {
  constexpr double k = 0.55;
  constexpr std::array<std::array<double, 2>, 4> ring{{{1, 0}, {1, k}, {k, 1}, {0, 1}}},
      profile{{{0, 1}, {k, 1}, {1, k}, {1, 0}}};
  bicubic patch;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      patch.points[i][j] = {ring[i][0] * profile[j][0], profile[j][1], ring[i][1] * profile[j][0]};
  return patch;
}

}  // namespace

TEST_CASE("bezier surface: type facts") {
  static_assert(sizeof(bicubic) == 16 * sizeof(P3));
  static_assert(noexcept(patch_sample(bicubic{}, 0.5, 0.5)));
}

TEST_CASE("bezier surface: a bilinear patch by hand") {
  CHECK_BOTH(patch_sample(quad, 0.5, 0.5) == surface_sample<P3>{{1.5, 1, 1.5}, {3, 0, 3}, {0, 2, 3}, {0, 0, 6}});
  CHECK_BOTH(*patch_normal(quad, 0.0, 0.0) == V3{0, 0, 1});
  CHECK_BOTH(is_near(*patch_normal(quad, 0.5, 0.5), normalized(V3{-2, -3, 2}), 2e-16));
}

TEST_CASE("bezier surface: points and derivatives against Bernstein sums") {
  test::random r(1);
  for (int k = 0; k < 2000; ++k) {
    const bicubic patch = random_patch(r);
    const double u = r.unit(), v = r.unit();
    const auto bu = bernstein_basis<3>(u), bv = bernstein_basis<3>(v);
    const auto cu = bernstein_basis<2>(u), cv = bernstein_basis<2>(v);
    V3 p{}, du{}, dv{}, duv{};
    const auto at = [&](std::size_t i, std::size_t j) { return to_vec(patch.points[i][j]); };
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j) {
        p += at(i, j) * (bu[i] * bv[j]);
        if (i < 3) du += (at(i + 1, j) - at(i, j)) * (3 * cu[i] * bv[j]);
        if (j < 3) dv += (at(i, j + 1) - at(i, j)) * (3 * bu[i] * cv[j]);
        if (i < 3 && j < 3) duv += (at(i + 1, j + 1) - at(i + 1, j) - at(i, j + 1) + at(i, j)) * (9 * cu[i] * cv[j]);
      }
    const auto s = patch_sample(patch, u, v);
    CHECK(is_near(to_vec(s.point), p, 1e-14));
    CHECK(is_near(s.du, du, 1e-14));
    CHECK(is_near(s.dv, dv, 1e-14));
    CHECK(is_near(s.duv, duv, 1e-13));
    const auto n = patch_normal(patch, u, v);
    REQUIRE(n);
    CHECK(std::abs(dot(*n, normalized(s.du))) < 1e-12);
    CHECK(dot(*n, cross(s.du, s.dv)) > 0);
  }
}

TEST_CASE("bezier surface: borders are the border curves, corners the corner points, bit for bit") {
  test::random r(2);
  for (int k = 0; k < 500; ++k) {
    const bicubic patch = random_patch(r);
    const auto t = curve_fraction<double>(static_cast<int>(r.integer(0, 13)), 13);
    std::array<P3, 4> first{}, last{};
    for (std::size_t i = 0; i < 4; ++i) first[i] = patch.points[i][0], last[i] = patch.points[i][3];
    CHECK(patch_point(patch, 0.0, t) == bezier_point(patch.points[0], t));
    CHECK(patch_point(patch, 1.0, t) == bezier_point(patch.points[3], t));
    CHECK(patch_point(patch, t, 0.0) == bezier_point(first, t));
    CHECK(patch_point(patch, t, 1.0) == bezier_point(last, t));
    CHECK(patch_point(patch, 0.0, 1.0) == patch.points[0][3]);
    CHECK(patch_point(patch, 1.0, 0.0) == patch.points[3][0]);
  }
}

TEST_CASE("bezier surface: normals where a border has shrunk to a point") {
  // u leads from x towards z, v from the pole down: outside.
  CHECK_BOTH(*patch_normal(capped(), 0.0, 0.0) == V3{0, 1, 0});
  CHECK_BOTH(*patch_normal(capped(), 0.3, 0.0) == V3{0, 1, 0});
  CHECK_BOTH(*patch_normal(capped(), 1.0, 0.0) == V3{0, 1, 0});
  bicubic turned = capped(), swapped = capped();
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      turned.points[i][j] = capped().points[i][3 - j];
      swapped.points[i][j] = capped().points[j][i];
    }
  CHECK(*patch_normal(turned, 0.3, 1.0) == V3{0, -1, 0});
  CHECK(*patch_normal(swapped, 0.0, 0.3) == V3{0, -1, 0});
  CHECK(is_near(*patch_normal(capped(), 0.3, 1e-9), V3{0, 1, 0}, 1e-8));
}

TEST_CASE("bezier surface: no normal") {
  CHECK_BOTH(!patch_normal(bicubic{}, 0.5, 0.5));
  bicubic line;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) line.points[i][j] = {static_cast<double>(i + j), 0, 0};
  CHECK(!patch_normal(line, 0.5, 0.5));
  const auto flat = [](const V3& du, const V3& dv) {
    return surface_normal(surface_sample<P3>{{}, du, dv, {0, 0, 1}}, curve_parameter<double>(0.5),
                          curve_parameter<double>(0.5));
  };
  // Parallel derivatives, whose rounded directions differ.
  CHECK_BOTH(!flat({1, 2, 3}, {3, 6, 9}));
  for (int i = 1; i < 40; ++i) CHECK(!flat(V3{1, 2, 3} * (0x1p-1000 * i), V3{-7, -14, -21}));
  CHECK(flat({1, 2, 3}, {3, 6, std::nextafter(9.0, 10.0)}).has_value());
}

TEST_CASE("bezier surface: tessellation visits the lattice in order") {
  std::vector<P3> seen;
  tessellate(quad, 2, 4, [&](int i, int j, const surface_sample<P3>& s) {
    CHECK(static_cast<std::size_t>(i * 5 + j) == seen.size());
    seen.push_back(s.point);
  });
  REQUIRE(seen.size() == 15);
  CHECK(seen[0] == P3{0, 0, 0});
  CHECK(seen[7] == P3{1.5, 1, 1.5});
  CHECK(seen[14] == P3{3, 2, 6});
}
