// SPDX-License-Identifier: MIT
#include <irg/hidden/faces_around.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

#include <irg/geometry/point_in_polygon.hpp>
#include <irg/hidden/visible_polygons.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using place = irg::point<double, 3>;
using body = irg::mesh<double>;

// What is seen in each side, and the numbers of the faces that are, rising.
struct surroundings {
  std::vector<irg::visible_polygon_map> sides;
  std::vector<std::uint32_t> seen;
};
constexpr surroundings look(const place& eye, const body& m, const irg::cube_options<double>& options) {
  surroundings out;
  irg::faces_around(
      eye, m,
      [&](std::size_t, const std::vector<irg::screen_face>& faces) {
        irg::visible_polygon_map map = irg::visible_polygons(faces, irg::cell_window{0, 0, options.size, options.size});
        for (const auto& r : map.rings)
          if (r.number != irg::no_index) out.seen.push_back(r.number);
        out.sides.push_back(std::move(map));
      },
      options);
  std::sort(out.seen.begin(), out.seen.end());
  out.seen.erase(std::unique(out.seen.begin(), out.seen.end()), out.seen.end());
  return out;
}

void add(body& m, const std::vector<place>& corners) {
  std::vector<std::uint32_t> face;
  for (const place& p : corners) {
    face.push_back(static_cast<std::uint32_t>(m.positions.size()));
    m.positions.push_back(p);
  }
  irg::add_face(m, face);
}

double area_of(const irg::visible_polygon_map& map, std::uint32_t number) {
  double sum = 0;
  for (const auto& r : map.rings)
    for (std::size_t i = 0; r.number == number && i < r.count; ++i) {
      const auto a = corner_of(map, r, i), b = corner_of(map, r, i + 1 < r.count ? i + 1 : 0);
      sum += (a.x * b.y - a.y * b.x) / 2;
    }
  return sum;
}

constexpr bool sees_nothing() {
  const surroundings around = look(place{0, 0, 0}, body{}, {4, 0.5});
  return around.seen.empty() && around.sides[5].rings.size() == 1 && around.sides[0].rings[0].number == irg::no_index;
}

TEST_CASE("faces_around: a room from within, each wall on its own side") {
  body room;
  const double s = 2;
  const std::vector<std::vector<place>> walls{
      {{s, -s, -s}, {s, s, -s}, {s, s, s}, {s, -s, s}}, {{-s, -s, -s}, {-s, s, -s}, {-s, s, s}, {-s, -s, s}},
      {{-s, s, -s}, {s, s, -s}, {s, s, s}, {-s, s, s}}, {{-s, -s, -s}, {s, -s, -s}, {s, -s, s}, {-s, -s, s}},
      {{-s, -s, s}, {s, -s, s}, {s, s, s}, {-s, s, s}}, {{-s, -s, -s}, {s, -s, -s}, {s, s, -s}, {-s, s, -s}}};
  for (const auto& w : walls) add(room, w);
  add(room, {{0.5, -0.25, -0.25}, {0.5, 0.25, -0.25}, {0.5, 0.25, 0.25}, {0.5, -0.25, 0.25}});  // a picture on a stand
  add(room, {{1, -0.25, -0.25}, {1, 0.25, -0.25}, {1, 0.25, 0.25}, {1, -0.25, 0.25}});  // behind it
  const auto around = look(place{0, 0, 0}, room, {256, 0.125});
  CHECK(around.seen == std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6});
  for (std::uint32_t i = 1; i < 6; ++i) CHECK(area_of(around.sides[i], i) == 256 * 256);
  CHECK(area_of(around.sides[0], 6) == 128 * 128);
  CHECK(area_of(around.sides[0], 0) == 256 * 256 - 128 * 128);
  CHECK_BOTH(sees_nothing());
}

TEST_CASE("faces_around: places and directions lead back to each other") {
  test::random r(1);
  for (int i = 0; i < 200; ++i) {
    const irg::vec<double, 3> d{r.unit() - 0.5, r.unit() - 0.5, r.unit() - 0.5};
    const auto [side, at] = irg::place_of(512, d);
    const auto back = irg::direction_of(512, side, at);
    const double longest = std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
    for (int k = 0; k < 3; ++k) CHECK(std::fabs(back[k] - d[k] / longest) < 1e-14);
  }
}

// The number of the triangle that the ray meets first, and by how much it passes its sides, as a part of its size.
std::uint32_t first_met(const body& m, const irg::vec<double, 3>& d, double& margin) {
  std::uint32_t best = irg::no_index;
  double least = 1e300;
  margin = 1;
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    const place &a = m.positions[m.corner(f, 0).position], &b = m.positions[m.corner(f, 1).position],
                &c = m.positions[m.corner(f, 2).position];
    const auto volume = [&](const place& u, const place& v) {
      return d.x * (u.y * v.z - u.z * v.y) + d.y * (u.z * v.x - u.x * v.z) + d.z * (u.x * v.y - u.y * v.x);
    };
    const double s = volume(b, c), t = volume(c, a), u = volume(a, b), sum = s + t + u;
    for (const double part : {s / sum, t / sum, u / sum}) margin = std::min(margin, std::fabs(part));
    if (sum == 0 || s / sum < 0 || t / sum < 0 || u / sum < 0) continue;
    const double x = (s * a.x + t * b.x + u * c.x) / sum, y = (s * a.y + t * b.y + u * c.y) / sum,
                 z = (s * a.z + t * b.z + u * c.z) / sum;
    const double at = x * d.x + y * d.y + z * d.z;
    if (at > 0 && at < least) least = at, best = static_cast<std::uint32_t>(f);
  }
  return best;
}

TEST_CASE("faces_around: each direction shows what a ray in it meets first") {
  test::random r(9);
  const int times = std::getenv("IRG_RELEASE_TIER") != nullptr ? 40 : 1;
  int wrong = 0, judged = 0, unseen = 0;
  for (int i = 0; i < 12 * times; ++i) {
    body m;
    for (int k = 0; k < 30; ++k) {
      const auto any = [&](double size) {
        const double x = size * (r.unit() - 0.5), y = size * (r.unit() - 0.5);
        return place{x, y, size * (r.unit() - 0.5)};
      };
      const place at = any(8);
      const auto beside = [&] {
        const place p = any(3);
        return place{at.x + p.x, at.y + p.y, at.z + p.z};
      };
      add(m, {beside(), beside(), beside()});
    }
    const auto around = look(place{0, 0, 0}, m, {1024, 1e-6});
    for (int k = 0; k < 200; ++k) {
      const irg::vec<double, 3> d{r.unit() - 0.5, r.unit() - 0.5, r.unit() - 0.5};
      double margin = 0;
      const std::uint32_t want = first_met(m, d, margin);
      if (margin < 1e-3) continue;  // within some pixels of a side of a triangle
      ++judged;
      const auto [side, at] = irg::place_of(1024, d);
      const auto& map = around.sides[side];
      std::vector<std::vector<irg::point<double, 2>>> rings;
      for (const auto& ring : map.rings)
        if (ring.number == want) {
          rings.emplace_back();
          for (std::size_t n = 0; n < ring.count; ++n) rings.back().push_back(corner_of(map, ring, n));
        }
      wrong += irg::point_in_polygon(rings, at, irg::fill_rule::even_odd) == irg::location::outside;
      unseen += want != irg::no_index && !std::binary_search(around.seen.begin(), around.seen.end(), want);
    }
  }
  CHECK(judged > 1000 * times);
  CHECK(unseen == 0);
  CHECK(wrong <= judged / 500);  // near the line in which two triangles pass through each other
}

#pragma GCC diagnostic ignored "-Wdeprecated-declarations"  // the old order goes on compiling
TEST_CASE("faces_around: without options, and in the old order") {
  body m;
  add(m, {{1, -1, -1}, {1, 1, -1}, {1, 0, 2}});
  std::size_t faces[3] = {};
  irg::faces_around(place{0, 0, 0}, m, [&](std::size_t, const auto& seen) { faces[0] += seen.size(); });
  irg::faces_around(place{0, 0, 0}, m, [&](std::size_t, const auto& seen) { faces[1] += seen.size(); }, {1024});
  irg::faces_around(place{0, 0, 0}, m, {1024}, [&](std::size_t, const auto& seen) { faces[2] += seen.size(); });
  CHECK(faces[0] > 0);
  CHECK(faces[0] == faces[1]);
  CHECK(faces[0] == faces[2]);
}

}  // namespace
