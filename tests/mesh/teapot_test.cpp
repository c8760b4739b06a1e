// SPDX-License-Identifier: MIT
#include <irg/mesh/teapot.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <set>

#include <irg/geometry/box.hpp>
#include <irg/mesh/normals.hpp>

#include "support/check_both.hpp"
#include "support/mesh_facts.hpp"

using namespace irg;

namespace {

using P3 = point<double, 3>;
using key = std::array<double, 3>;

template <class V>
key key_of(const V& v) {
  return {v[0] + 0.0, v[1] + 0.0, v[2] + 0.0};  // without negative zeros
}

std::set<key> positions_of(const mesh<double>& m) {
  std::set<key> all;
  for (const P3& p : m.positions) all.insert(key_of(p));
  return all;
}

constexpr mesh<double> with_bottom(int n) { return shape_teapot<double>({n, teapot_bottom::with}); }
constexpr mesh<double> without_bottom(int n) { return shape_teapot<double>({n, teapot_bottom::without}); }

template <class T>
constexpr std::uint64_t hash(const mesh<T>& m) {
  std::uint64_t h = 14695981039346656037u;
  const auto add = [&](T x) { h = (h ^ bits_of(static_cast<double>(x))) * 1099511628211u; };
  for (const auto& p : m.positions) add(p.x), add(p.y), add(p.z);
  for (const auto& n : m.normals) add(n.x), add(n.y), add(n.z);
  return h;
}

}  // namespace

TEST_CASE("teapot: the patches are Newell's, exactly") {
  constexpr auto patches = teapot_patches<double>();
  // One published point of every patch of the drawing's side, as (x, y, z) with z up: patch, along the ring, row.
  struct sample {
    std::size_t patch, i, j;
    double x, y, z;
  };
  constexpr std::array<sample, 22> published{{
      {0, 0, 0, 1.4, 0, 2.4},
      {0, 1, 1, 1.3375, -0.749, 2.53125},
      {1, 2, 2, -1.4375, -0.805, 2.53125},
      {2, 1, 3, -1.5, 0.84, 2.4},
      {4, 2, 1, 0.98, -1.75, 1.875},
      {7, 3, 2, 2, 0, 1.35},
      {8, 1, 1, 2, -1.12, 0.45},
      {10, 2, 2, -0.84, 1.5, 0.225},
      {11, 0, 3, 0, 1.5, 0.15},
      {12, 0, 0, -1.6, 0, 2.025},
      {12, 2, 1, -2.5, -0.3, 2.25},
      {13, 1, 2, -3, 0.3, 2.25},
      {14, 1, 2, -2.5, -0.3, 1.125},
      {14, 3, 3, -1.9, 0, 0.6},
      {16, 1, 0, 1.7, -0.66, 1.425},
      {16, 2, 1, 3.1, -0.66, 0.825},
      {17, 3, 2, 2.3, 0, 2.1},
      {18, 2, 1, 3.525, -0.25, 2.49375},
      {19, 1, 2, 3.45, 0.15, 2.5125},
      {20, 1, 1, 0.8, -0.45, 3.15},
      {22, 0, 3, -0.2, 0, 2.7},
      {25, 1, 2, -0.728, -1.3, 2.55},
  }};
  for (const sample& s : published) CHECK(patches[s.patch].points[s.i][s.j] == P3{s.x, s.z, -s.y});
  // All 512 of them, pinned after a comparison with the complete published list.
  std::uint64_t h = 14695981039346656037u;
  for (const auto& patch : patches)
    for (const auto& line : patch.points)
      for (const P3& p : line)
        for (int i = 0; i < 3; ++i) h = (h ^ bits_of(p[i])) * 1099511628211u;
  CHECK(h == std::uint64_t{2040237524079003905u});
}

TEST_CASE("teapot: the bottom's patches") {
  constexpr auto patches = teapot_patches<float>();
  constexpr std::array<std::array<float, 3>, 4> rows{
      {{1.5f, 0.84f, 0.15f}, {1.5f, 0.84f, 0.075f}, {1.425f, 0.798f, 0}, {0, 0, 0}}};
  for (std::size_t j = 0; j < 4; ++j) {
    const auto [r, c, y] = rows[j];
    using P = point<float, 3>;
    CHECK(patches[28].points[0][j] == P{r, y, 0});
    CHECK(patches[28].points[1][j] == P{r, y, c});
    CHECK(patches[29].points[1][j] == P{-c, y, r});
    CHECK(patches[30].points[1][j] == P{-r, y, -c});
    CHECK(patches[31].points[2][j] == P{r, y, -c});
  }
}

TEST_CASE("teapot: counts") {
  CHECK_BOTH(with_bottom(1).face_count() == 56);
  CHECK_BOTH(without_bottom(1).face_count() == 52);
  for (const int n : {1, 2, 3, 10}) {
    const auto m = static_cast<std::size_t>(n);
    CHECK(with_bottom(n).face_count() == 64 * m * m - 8 * m);
    CHECK(without_bottom(n).face_count() == 56 * m * m - 4 * m);
  }
  CHECK_BOTH(with_bottom(-3) == with_bottom(1));
}

TEST_CASE("teapot: patch borders are welded and nothing else is lost") {
  for (const int n : {1, 2, 3, 7}) {
    const mesh<double> m = with_bottom(n);
    const auto all = positions_of(m);
    std::set<key> visited;
    for (const auto& patch : teapot_patches<double>()) {
      tessellate(patch, n, n, [&](int i, int, const auto& s) {
        if (i == 0 || s.du != vec<double, 3>{}) visited.insert(key_of(s.point));  // of a pole's row, one
      });
      for (const std::size_t i : {0u, 3u})
        for (const std::size_t j : {0u, 3u}) CHECK(all.count(key_of(patch.points[i][j])) == 1);
    }
    CHECK(visited == all);
    // The handle ends at a vertex of the body; flat handle and spout (n = 1) meet no other vertices.
    CHECK(all.size() + 1 == m.positions.size());
  }
}

TEST_CASE("teapot: consistently oriented, with the right borders and topology") {
  for (const int n : {2, 3, 10}) {
    const auto whole = test::facts_of(with_bottom(n)), open = test::facts_of(without_bottom(n));
    CHECK(whole.repeated_edges == 0);
    CHECK(whole.looped_edges == 0);
    CHECK(whole.border_edges == static_cast<std::size_t>(16 * n));
    CHECK(open.border_edges == static_cast<std::size_t>(20 * n));
    CHECK(whole.euler == 2);  // two discs, two tubes
    CHECK(open.euler == 1);
    CHECK(whole.vertices == with_bottom(n).positions.size());
    CHECK(whole.volume > 20);
  }
}

TEST_CASE("teapot: extents") {
  const auto b = bounding_box(with_bottom(10));
  CHECK(b.low == P3{-3, 0, -2});
  CHECK(b.high.x == doctest::Approx(3.434).epsilon(1e-6));
  CHECK(b.high.y == 3.15);
  CHECK(b.high.z == 2);
  CHECK(bounding_box(without_bottom(10)).low.y == 0.15);
}

TEST_CASE("teapot: its own mirror image in z, positions and normals, bit for bit") {
  const mesh<double> m = with_bottom(10);
  std::set<std::array<key, 2>> all;
  for (std::size_t v = 0; v < m.positions.size(); ++v) all.insert({key_of(m.positions[v]), key_of(m.normals[v])});
  std::size_t missing = 0;
  for (std::size_t v = 0; v < m.positions.size(); ++v) {
    const auto p = m.positions[v];
    const auto n = m.normals[v];
    missing += 1 - all.count({key_of(P3{p.x, p.y, -p.z}), key_of(P3{n.x, n.y, -n.z})});
  }
  CHECK(missing == 0);
}

TEST_CASE("teapot: normals") {
  const mesh<double> m = with_bottom(10);
  REQUIRE(m.normals.size() == m.positions.size());
  std::size_t against = 0;
  for (const auto& n : m.normals) CHECK(std::abs(length(n) - 1) <= 4e-16);
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    const auto flat = face_normal(m, f);
    REQUIRE(flat);
    for (std::size_t k = 0; k < 3; ++k) against += dot(*flat, m.normals[m.corner(f, k).normal]) > 0.3 ? 0u : 1u;
  }
  CHECK(against == 0);
  // Outside of a turned body: away from the axis at the belly, along it at the poles.
  for (std::size_t v = 0; v < m.positions.size(); ++v) {
    const auto p = m.positions[v];
    const auto n = m.normals[v];
    if (p == P3{2, 0.9, 0}) CHECK(n == vec<double, 3>{1, 0, 0});
    if (p == P3{0, 3.15, 0}) CHECK(n == vec<double, 3>{0, 1, 0});
    if (p == P3{0, 0, 0}) CHECK(n == vec<double, 3>{0, -1, 0});
  }
  CHECK(m.positions.size() == 3242);
  for (const int n : {1, 2, 5})
    for (const auto& normal : shape_teapot<float>({n, teapot_bottom::with}).normals)
      CHECK(std::abs(length(normal) - 1) < 2e-7f);
}

TEST_CASE("teapot: normals of one patch's border agree with its neighbour's") {
  constexpr auto patches = teapot_patches<double>();
  const auto agree = [&](std::size_t a, std::size_t b, bool along_u) {
    for (int k = 0; k <= 8; ++k) {
      const auto t = curve_fraction<double>(k, 8);
      const auto first = along_u ? patch_normal(patches[a], 1.0, t) : patch_normal(patches[a], t, 1.0);
      const auto second = along_u ? patch_normal(patches[b], 0.0, t) : patch_normal(patches[b], t, 0.0);
      REQUIRE(first);
      REQUIRE(second);
      CHECK(length(*first - *second) < 2e-14);
    }
  };
  for (const std::size_t group : {0u, 4u, 8u, 20u, 24u, 28u})
    for (std::size_t q = 0; q < 4; ++q) agree(group + q, group + (q + 1) % 4, true);
  for (const std::size_t group : {12u, 14u, 16u, 18u}) agree(group, group + 1, true), agree(group + 1, group, true);
  for (std::size_t q = 0; q < 4; ++q)
    agree(q, 4 + q, false), agree(4 + q, 8 + q, false), agree(8 + q, 28 + q, false), agree(20 + q, 24 + q, false);
  for (std::size_t side = 0; side < 2; ++side) agree(12 + side, 14 + side, false), agree(16 + side, 18 + side, false);
}

TEST_CASE("teapot: the same bits in constant evaluation") {
  constexpr std::uint64_t single = hash(shape_teapot<float>({1, teapot_bottom::with})), twice = hash(with_bottom(1));
  static_assert(single != twice);
  CHECK(hash(shape_teapot<float>({1, teapot_bottom::with})) == single);
  CHECK(hash(with_bottom(1)) == twice);
}

#ifdef IRG_MODELS_DIR
TEST_CASE("teapot: every vertex of the public model teapot.obj is one of ours") {
  std::FILE* file = std::fopen(IRG_MODELS_DIR "/teapot.obj", "r");
  if (file == nullptr) {
    MESSAGE("skipped: no teapot.obj in " IRG_MODELS_DIR);
    return;
  }
  const mesh<double> m = with_bottom(10);
  int count = 0;
  double worst = 0;
  char line[256];
  while (std::fgets(line, sizeof line, file) != nullptr) {
    P3 p;
    if (std::sscanf(line, "v %lf %lf %lf", &p.x, &p.y, &p.z) != 3) continue;
    double nearest = 1e9;
    for (const P3& q : m.positions) nearest = std::min(nearest, length(q - p));
    worst = std::max(worst, nearest);
    ++count;
  }
  std::fclose(file);
  CHECK(count == 3644);
  CHECK(worst < 1e-6);  // six decimals are printed
}
#endif
