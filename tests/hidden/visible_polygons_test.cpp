// SPDX-License-Identifier: MIT
#include <irg/hidden/visible_polygons.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>
#include <vector>

#include "hidden/method_scenes.hpp"
#include "support/big_rational.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::screen_face;
using irg::screen_vertex;
using irg::visible_polygon_map;
using irg::visible_ring;

constexpr screen_vertex at(int x, int y, float depth) { return {{x * 256, y * 256}, depth}; }
constexpr screen_face face(const screen_vertex& a, const screen_vertex& b, const screen_vertex& c, std::uint32_t n) {
  return irg::make_screen_face(a, b, c, n);
}

// Twice the area of a ring, exactly where its corners are integers.
constexpr double double_area(const visible_polygon_map& map, const visible_ring& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.count; ++i) {
    const auto p = corner_of(map, ring, i), q = corner_of(map, ring, i + 1 == ring.count ? 0 : i + 1);
    sum += p.x * q.y - q.x * p.y;
  }
  return sum;
}
constexpr double double_area_of(const visible_polygon_map& map, std::uint32_t number) {
  double sum = 0;
  for (const visible_ring& r : map.rings)
    if (r.number == number) sum += double_area(map, r);
  return sum;
}
constexpr visible_polygon_map seen(const std::vector<screen_face>& faces) {
  return irg::visible_polygons(faces, {0, 0, 16, 16});
}

TEST_CASE("visible_polygons: nothing, one face, a hole, faces through each other, faces in one plane") {
  CHECK_BOTH(seen({}).rings.size() == 1);
  CHECK_BOTH(double_area_of(seen({}), irg::no_index) == 512);
  CHECK_BOTH(irg::visible_polygons(std::vector<screen_face>{}, {3, 3, 3, 9}).rings.empty());
  CHECK_BOTH(seen({face(at(1, 1, 1), at(2, 2, 1), at(5, 5, 1), 0)}).rings.size() == 1);  // seen edge on
  // A face all inside: a ring of its own and a hole in the background.
  CHECK_BOTH(seen({face(at(4, 4, 1), at(12, 4, 1), at(4, 12, 1), 7)}).rings.size() == 3);
  CHECK_BOTH(double_area_of(seen({face(at(4, 4, 1), at(12, 4, 1), at(4, 12, 1), 7)}), 7) == 64);
  // Two that cross along x = 8, over all the window.
  CHECK_BOTH(double_area_of(seen({face(at(-16, -16, 3), at(48, -16, -5), at(-16, 48, 3), 1),
                                  face(at(-16, -16, 0), at(48, -16, 0), at(-16, 48, 0), 2)}),
                            1) == 256);
  // In one plane the lower number is seen; two of one number are one region.
  CHECK_BOTH(double_area_of(seen({face(at(0, 0, 0), at(16, 0, 0), at(0, 16, 0), 2),
                                  face(at(0, 0, 0), at(16, 0, 0), at(16, 16, 0), 1)}),
                            2) == 128);
  CHECK_BOTH(
      seen({face(at(0, 0, 0), at(16, 0, 0), at(16, 16, 0), 4), face(at(0, 0, 0), at(16, 16, 0), at(0, 16, 1), 4)})
          .corners.size() == 4);
}

// The number at a point by the rings. `well`: they wind round it once for this number and not for any other; `close`:
// it lies so near a boundary that rounding may have moved that across.
std::uint32_t number_at(const visible_polygon_map& map, double x, double y, bool& close, bool& well) {
  std::map<std::uint32_t, int> windings;
  close = false;
  for (std::size_t i = 0; i < map.rings.size();) {
    const std::uint32_t number = map.rings[i].number;
    int winding = 0;
    for (; i < map.rings.size() && map.rings[i].number == number; ++i) {
      const visible_ring& ring = map.rings[i];
      for (std::size_t k = 0; k < ring.count; ++k) {
        const auto p = corner_of(map, ring, k), q = corner_of(map, ring, k + 1 == ring.count ? 0 : k + 1);
        const double turn = (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
        const double length = std::hypot(q.x - p.x, q.y - p.y);
        const double along = (q.x - p.x) * (x - p.x) + (q.y - p.y) * (y - p.y);
        if (std::fabs(turn) <= 0x1p-27 * length && along >= -0x1p-20 * length && along <= length * (length + 0x1p-20))
          close = true;
        if (p.y <= y && q.y > y && turn > 0) ++winding;
        if (q.y <= y && p.y > y && turn < 0) --winding;
      }
    }
    if (winding != 0) windings[number] = winding;
  }
  well = windings.size() == 1 && windings.begin()->second == 1;
  return windings.empty() ? irg::no_index : windings.begin()->first;
}

TEST_CASE("visible_polygons: every pixel's centre lies in the region of the face that the picture shows there") {
  const bool release = std::getenv("IRG_RELEASE_TIER") != nullptr;
  const int scenes = release ? 2000 : 45, size = 24;
  std::int64_t pixels = 0, close_ones = 0, wrong = 0, badly = 0, open = 0;
  for (int s = 0; s < scenes; ++s) {
    test::random r(static_cast<std::uint64_t>(s) + 77);
    test::face_scene_maker make(r.next(), size);
    const auto kind = static_cast<test::face_scene>(s % test::face_scenes);
    const test::face_list faces = make(kind, static_cast<int>(r.integer(3, release ? 96 : 32)));
    const test::id_image exact = test::exact_ids(faces, size, size);
    const visible_polygon_map map = irg::visible_polygons(faces, {0, 0, size, size});
    CAPTURE(s);
    // Each step from corner to corner is taken once and once back, but for those along the window's sides.
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> steps;
    for (const visible_ring& ring : map.rings)
      for (std::size_t k = 0; k < ring.count; ++k)
        ++steps[{map.corners[ring.first + k], map.corners[ring.first + (k + 1 == ring.count ? 0 : k + 1)]}];
    for (const auto& [step, times] : steps) {
      const auto p = map.places[step.first], q = map.places[step.second];
      const bool on_side = (p.x == q.x && (p.x == 0 || p.x == size)) || (p.y == q.y && (p.y == 0 || p.y == size));
      const auto back = steps.find({step.second, step.first});
      const bool paired = back != steps.end() && back->second == times;
      if (!paired && !(on_side && back == steps.end() && times == 1)) ++open;
    }
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x, ++pixels) {
        bool close = false, well = false;
        const std::uint32_t number = number_at(map, x + 0.5, y + 0.5, close, well);
        close_ones += close ? 1 : 0;
        if (close) continue;
        badly += well ? 0 : 1;
        wrong += number == exact(x, y) ? 0 : 1;
      }
  }
  CHECK(open == 0);
  CHECK(badly == 0);
  CHECK(wrong == 0);
  MESSAGE(scenes, " scenes, ", pixels, " pixels, of which ", close_ones, " lie on a boundary");
}

bool same(const visible_polygon_map& a, const visible_polygon_map& b) {
  return a.places == b.places && a.corners == b.corners &&
         std::equal(a.rings.begin(), a.rings.end(), b.rings.begin(), b.rings.end(), [](const auto& p, const auto& q) {
           return p.number == q.number && p.first == q.first && p.count == q.count;
         });
}

TEST_CASE("visible_polygons: depths of all sizes; neither the order of the faces nor that of depths changes a bit") {
  test::random r(5);
  int wrong = 0, different = 0;
  for (int s = 0; s < 20; ++s) {
    test::face_list faces;
    const auto vertex = [&] {
      const auto x = static_cast<std::int32_t>(r.integer(-2048, 6144)),
                 y = static_cast<std::int32_t>(r.integer(0, 4096));
      const auto digits = static_cast<double>(r.integer(-(1 << 24), 1 << 24));
      return screen_vertex{{x, y}, static_cast<float>(std::ldexp(digits, static_cast<int>(r.integer(-170, 100))))};
    };
    for (std::uint32_t n = 0; n < 12; ++n) {
      const screen_vertex a = vertex(), b = vertex(), c = vertex();
      faces.push_back(face(a, b, c, n));
    }
    const visible_polygon_map map = irg::visible_polygons(faces, {0, 0, 16, 16});
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) {
        bool close = false, well = false;
        const std::uint32_t number = number_at(map, x + 0.5, y + 0.5, close, well);
        if (!close && (!well || number != irg::picture_face_at(faces, x, y).value_or(irg::no_index))) ++wrong;
      }
    std::reverse(faces.begin(), faces.end());
    std::swap(faces[3], faces[8]);
    different += same(map, irg::visible_polygons(faces, {0, 0, 16, 16})) ? 0 : 1;
    for (screen_face& f : faces) {
      for (screen_vertex& v : f.v) v.depth = -v.depth;
      f = face(f.v[0], f.v[1], f.v[2], f.number);
    }
    different += same(map, irg::visible_polygons<irg::nearer_is_less>(faces, {0, 0, 16, 16})) ? 0 : 1;
  }
  CHECK(wrong == 0);
  CHECK(different == 0);
}

TEST_CASE("visible_polygons: two planes that meet in a line of which a coefficient is -2^64") {
  const std::vector<screen_face> faces{
      irg::make_screen_face({{1664, 1664}, 3.0f}, {{640, 1664}, 0.0f}, {{1920, -128}, 0.0f}, 3),
      irg::make_screen_face({{1408, 896}, 0.0f}, {{1408, 640}, -1.0f}, {{1920, 128}, 1.0f}, 84)};
  const irg::cell_window w{0, 0, 7, 7};
  const auto map = irg::visible_polygons<irg::nearer_is_less>(faces, w);
  const auto turned = irg::visible_polygons<irg::nearer_is_less>(std::vector<screen_face>{faces[1], faces[0]}, w);
  CHECK(irg::picture_face_at<irg::nearer_is_less>(faces, 5, 2) == 84);
  CHECK(double_area_of(map, 84) > 1);
  CHECK(double_area_of(map, 84) == double_area_of(turned, 84));
}

TEST_CASE("visible_polygons: faces and windows at the ends of the range, equal faces by the hundred") {
  constexpr int end = irg::snap_limit;
  const auto huge = irg::visible_polygons(
      std::vector<screen_face>{face(at(-end, -end, 1), at(end, -end, 1), at(end, end, 1), 5)}, {-end, -end, end, end});
  CHECK(huge.places.size() == 4);
  CHECK(double_area_of(huge, 5) == 4.0 * end * end);
  test::face_list equal;
  for (std::uint32_t n = 0; n < 500; ++n) equal.push_back(face(at(1, 1, 1), at(9, 2, 2), at(3, 9, 3), 700 - n));
  const auto map = seen(equal);
  CHECK(map.rings.size() == 3);
  CHECK(map.rings[0].number == 201);
}

}  // namespace
