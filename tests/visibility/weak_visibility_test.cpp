// SPDX-License-Identifier: MIT
#include <irg/visibility/weak_visibility.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <limits>

#include <irg/geometry/point_in_polygon.hpp>
#include <irg/visibility/cut_source.hpp>

#include "support/check_both.hpp"
#include "support/plane_sight_oracle.hpp"
#include "support/random.hpp"

namespace {

using irg::visibility_status;
using place = irg::point<double, 2>;
using wall = irg::segment<double, 2>;
using window = irg::box<double, 2>;
using rings = std::vector<std::vector<place>>;

constexpr window plan{{-5, -5}, {5, 5}};

constexpr bool shadow_of_one_wall() {
  const wall walls[] = {{{-1, 0}, {1, 0}}};
  const auto r = irg::weak_visibility(wall{{-2, 2}, {2, 2}}, walls, plan);
  const place umbra[] = {{0, -2}, {1, 0}, {-1, 0}};
  return r && r.status == visibility_status::ok && r.all.size() == 1 && r.some.size() == 1 && r.none.size() == 1 &&
         r.none[0].size() == 3 && std::equal(umbra, umbra + 3, r.none[0].begin()) && r.all[0].size() == 6;
}
bool lamp_with_a_corner_inwards() {
  const place lamp[] = {{-2, 2}, {0, 3}, {2, 2}, {0, 4}};
  const wall walls[] = {{{-1, 0}, {1, 0}}};
  const auto r = irg::weak_visibility(std::span<const place>(lamp), walls, plan);
  const place umbra[] = {{0, -2}, {1, 0}, {-1, 0}};  // as of a tube between its lower corners
  const place below[] = {{-1, -2}, {1, -2}, {1, -1}, {-1, -1}}, beside[] = {{3, 0}, {4, 0}, {4, 1}};
  const auto sight = [&](std::span<const place> region) {
    return irg::sight_between<double>(lamp, region, walls).value;
  };
  return r.status == visibility_status::ok && r.none.size() == 1 && r.none[0].size() == 3 &&
         std::equal(umbra, umbra + 3, r.none[0].begin()) && sight(below) == irg::seen_share::some &&
         sight(beside) == irg::seen_share::all && sight(umbra) == irg::seen_share::none;
}
constexpr bool nothing_in_the_way() {
  const auto r = irg::weak_visibility(wall{{0, 0}, {0, 0}}, {}, plan);
  return r.all.size() == 1 && r.all[0].size() == 4 && r.some.empty() && r.none.empty();
}
constexpr visibility_status status_of(const std::vector<place>& source, const std::vector<wall>& walls) {
  return irg::weak_visibility(std::span<const place>(source), walls, plan).status;
}
constexpr bool hostile() {
  constexpr double most = std::numeric_limits<double>::max(), nan = std::numeric_limits<double>::quiet_NaN();
  const wall walls[] = {{{-most, 0}, {most, 0}}};
  const auto half = irg::weak_visibility(wall{{0, 1}, {0, 1}}, walls, window{{-most, -most}, {most, most}});
  return half.all.size() == 1 && half.none.size() == 1 && half.some.empty() &&
         status_of({{nan, 0}}, {}) == visibility_status::not_finite &&
         status_of({}, {}) == visibility_status::source_not_simple &&
         status_of({{0, 0}, {2, 0}, {0, 2}, {2, 2}}, {}) == visibility_status::source_not_simple &&
         status_of({{-1, 0}, {1, 0}}, {{{0, -1}, {0, 1}}}) == visibility_status::source_crosses_obstacle &&
         irg::weak_visibility(wall{{0, 0}, {1, 0}}, {}, window{}).all.empty();
}
constexpr bool a_point_and_a_region() {
  const place lamp[] = {{0, 0}}, yard[] = {{4, 4}, {5, 4}, {4, 5}}, line[] = {{4, 4}, {5, 4}};
  return irg::sight_between<double>(lamp, yard, {}).value == irg::seen_share::all &&
         irg::sight_between<double>(lamp, line, {}).status == visibility_status::window_not_simple;
}
static_assert(shadow_of_one_wall() && a_point_and_a_region() && nothing_in_the_way() && hostile());

TEST_CASE("weak_visibility: constants as at run time") {
  CHECK(shadow_of_one_wall());
  CHECK(lamp_with_a_corner_inwards());
  CHECK(a_point_and_a_region());
  CHECK(nothing_in_the_way());
  CHECK(hostile());
}

TEST_CASE("weak_visibility: a square source, seen through a gap") {
  const std::vector<place> lamp{{-1, 3}, {1, 3}, {1, 4}, {-1, 4}};
  const std::vector<wall> walls{{{-5, 0}, {-0.5, 0}}, {{0.5, 0}, {5, 0}}};
  const auto r = irg::weak_visibility(std::span<const place>(lamp), walls, plan);
  CHECK(r.status == visibility_status::ok);
  CHECK(r.some.size() == 1);
  CHECK(r.none.size() == 2);
  const std::vector<place> backwards(lamp.rbegin(), lamp.rend());
  CHECK(irg::weak_visibility(std::span<const place>(backwards), walls, plan) == r);
}

double area_of(const rings& list) {
  double sum = 0;
  for (const auto& r : list)
    for (std::size_t i = 0; i < r.size(); ++i) {
      const place &a = r[i], &b = r[(i + 1) % r.size()];
      sum += (a.x * b.y - a.y * b.x) / 2;
    }
  return sum;
}

TEST_CASE("weak_visibility: a wall that ends on the source hides a part of it from all on its side") {
  const std::vector<wall> walls{{{0, 2}, {0, 0}}};
  const auto r = irg::weak_visibility(wall{{-2, 2}, {2, 2}}, walls, plan);
  CHECK(area_of(r.all) == 30);
  CHECK(area_of(r.some) == 70);
  CHECK(r.none.empty());
}

// The rings, each from its least vertex on, in order: the same parts give the same list.
rings in_order(rings list) {
  const auto less = [](const place& a, const place& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  for (auto& r : list) std::rotate(r.begin(), std::min_element(r.begin(), r.end(), less), r.end());
  std::sort(list.begin(), list.end(), [&](const auto& a, const auto& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), less);
  });
  return list;
}

struct scene {
  std::vector<place> source;
  std::vector<wall> walls;
  std::vector<place> second{};  // ring of the source, a hole in the first or beside it
};

irg::source_regions<double> parts_of(const scene& s, const window& in = plan) {
  if (s.second.empty()) return irg::weak_visibility(std::span<const place>(s.source), s.walls, in);
  const rings both{s.source, s.second};
  return irg::weak_visibility(std::span<const std::vector<place>>(both), s.walls, in);
}

scene random_scene(test::random& r, int size, int most_walls) {
  const auto any = [&] {
    const auto x = static_cast<double>(r.integer(-size, size)), y = static_cast<double>(r.integer(-size, size));
    return place{x, y};
  };
  scene s;
  const place at = any();
  const double left = r.integer(0, 1) == 0 ? 1 : -1;
  const auto ring = [&](std::initializer_list<place> corners) {
    std::vector<place> out;
    for (const place& p : corners) out.push_back({at.x + left * p.x, at.y + p.y});
    return out;
  };
  switch (r.integer(0, 8)) {
    case 0: s.source = {at}; break;
    case 1: s.source = {at, any()}; break;
    case 3: s.source = ring({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}); break;
    case 4: s.source = ring({{0, 0}, {3, 1}, {0, 2}, {1, 1}}); break;
    case 5: s.source = ring({{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}); break;
    case 6:
      s.source = ring({{0, 0}, {3, 0}, {3, 3}, {0, 3}});
      s.second = ring({{1, 1}, {1, 2}, {2, 1}});
      break;
    case 7:
      s.source = ring({{0, 0}, {1, 0}, {0, 1}});
      s.second = ring({{1, 1}, {2, 1}, {2, 2}});
      break;
    case 2: s.source = {at, {at.x + 1, at.y}, {at.x, at.y + 1}}; break;
    default: s.source = {at, {at.x, at.y + 2}, {at.x + 2, at.y + 2}, {at.x + 1, at.y}}; break;
  }
  for (auto n = r.integer(0, most_walls); n > 0; --n) {
    const place a = any(), b = any();
    s.walls.push_back({a, b});
  }
  return s;
}

TEST_CASE("weak_visibility: skipping sight lines changes nothing, and the parts make up the window") {
  test::random r(4);
  const int times = std::getenv("IRG_RELEASE_TIER") != nullptr ? 30 : 1;
  int wrong = 0;
  std::size_t skipped = 0;
  for (int i = 0; i < 60 * times; ++i) {
    const scene s = random_scene(r, 3, 2);
    const auto few = parts_of(s);
    const rings both{s.source, s.second};
    constexpr auto every = irg::detail::line_choice::all;
    const std::span<const irg::segment<double, 2>> walls(s.walls);
    const auto all =
        s.second.empty()
            ? irg::detail::regions_of_source(plan, std::span<const place>(s.source), walls, every)
            : irg::detail::regions_of_source(plan, std::span<const std::vector<place>>(both), walls, every);
    wrong += in_order(few.all) != in_order(all.all) || in_order(few.some) != in_order(all.some) ||
             in_order(few.none) != in_order(all.none) || all.skipped != 0;
    skipped += few.skipped;
    if (few.status == visibility_status::ok)
      wrong += std::fabs(area_of(few.all) + area_of(few.some) + area_of(few.none) - 100) > 1e-9;
  }
  CHECK(wrong == 0);
  CHECK(skipped > 0);
}

// Powers of two stretch the plane without rounding: all comes out the same, stretched.
TEST_CASE("weak_visibility: plans of all sizes, and such as are much wider than high") {
  test::random r(11);
  int wrong = 0;
  for (int i = 0; i < 40; ++i) {
    const scene s = random_scene(r, 3, 3);
    const auto want = parts_of(s);
    for (const int ex : {-990, 0, 990}) {
      const int ey = i % 2 == 0 ? ex : -ex / 2;
      const auto stretched = [&](const place& p) { return place{std::ldexp(p.x, ex), std::ldexp(p.y, ey)}; };
      scene t = s;
      for (place& p : t.source) p = stretched(p);
      for (place& p : t.second) p = stretched(p);
      for (wall& w : t.walls) w = {stretched(w.a), stretched(w.b)};
      auto expected = want;
      for (auto* list : {&expected.all, &expected.some, &expected.none})
        for (auto& ring : *list)
          for (place& p : ring) p = stretched(p);
      const window room{stretched(plan.low), stretched(plan.high)};
      wrong += !(parts_of(t, room) == expected);
    }
  }
  CHECK(wrong == 0);
}

#ifdef IRG_HAVE_MPFR
namespace oracle = test::plane_sight;
using oracle::number;

oracle::place exactly(const place& p) { return {number(p.x), number(p.y)}; }

// 0 when nothing of the source is seen from p, 1 when some is, 2 when all: by one ray between all critical directions.
int share_seen(const scene& s, const place& from) {
  const oracle::place p = exactly(from);
  std::vector<oracle::edge> walls, edges;
  for (const wall& w : s.walls) walls.push_back({exactly(w.a), exactly(w.b), irg::sight_stop::obstacle, 0});
  const std::size_t n = s.source.size();
  for (const auto* ring : {&s.source, &s.second})
    for (std::size_t i = 0; i < ring->size(); ++i)
      edges.push_back({exactly((*ring)[i]), exactly((*ring)[(i + 1) % ring->size()]), irg::sight_stop::boundary, 0});
  std::vector<oracle::place> all;
  for (const auto* list : {&walls, &edges})
    for (const auto& e : *list) {
      all.push_back(e.a - p);
      all.push_back(e.b - p);
    }
  for (const auto& w : walls)  // where walls cut the source
    for (const auto& e : edges)
      if (const auto t = oracle::meets(w.a, w.b - w.a, e); t && *t < number(1))
        all.push_back(w.a + *t * (w.b - w.a) - p);
  if (n == 1 || (n == 2 && s.source[0] == s.source[1])) {
    const oracle::place d = edges[0].a - p;
    for (const auto& w : walls)
      if (const auto t = oracle::meets(p, d, w); t && *t < number(1)) return 0;
    return 2;
  }
  const auto half = [](const oracle::place& d) { return d.y.sign() < 0 || (d.y.sign() == 0 && d.x.sign() < 0); };
  std::sort(all.begin(), all.end(), [&](const auto& a, const auto& b) {
    return half(a) != half(b) ? half(b) : oracle::cross(a, b).sign() > 0;
  });
  bool some = false, every = true;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const oracle::place &a = all[i], &b = all[(i + 1) % all.size()];
    if (oracle::cross(a, b).sign() <= 0) continue;  // no source in more than half a turn
    const oracle::place d = number(1) / oracle::dot(a, a) * a + number(1) / oracle::dot(b, b) * b;
    std::optional<number> first, last, wall_at;
    int count = 0;
    for (const auto& e : edges)
      if (const auto t = oracle::meets(p, d, e)) {
        ++count;
        if (!first || *t < *first) first = t;
        if (!last || *last < *t) last = t;
      }
    if (count == 0) continue;
    for (const auto& w : walls)
      if (const auto t = oracle::meets(p, d, w); t && (!wall_at || *t < *wall_at)) wall_at = t;
    // Odd: p is within the source. A wall along the edge of an area hides what is behind.
    if (!wall_at || count % 2 == 1 || (n == 2 ? !(*wall_at < *first) : *first < *wall_at)) some = true;
    if (wall_at && *wall_at < *last) every = false;
  }
  return every ? 2 : some ? 1 : 0;
}

// In how many of the three parts a place stands or is missing against what rationals say.
template <class Parts>
int wrong_parts(const Parts& got, const scene& s, const place& p) {
  const int want = share_seen(s, p);
  const rings* parts[] = {&got.none, &got.some, &got.all};
  int wrong = 0;
  for (int k = 0; k < 3; ++k) {
    const bool inside = irg::point_in_polygon(*parts[k], p, irg::fill_rule::even_odd) == irg::location::inside;
    wrong += inside != (k == want);
  }
  return wrong;
}

int wrong_places(const scene& s, test::random& r, int samples) {
  const auto got = parts_of(s);
  if (got.status != visibility_status::ok) return 0;
  std::vector<place> corners;
  for (const auto* list : {&got.all, &got.some, &got.none})
    for (const auto& ring : *list) corners.insert(corners.end(), ring.begin(), ring.end());
  int wrong = 0;
  for (int i = 0; i < samples; ++i) {
    const double x = 10 * r.unit() - 5, y = 10 * r.unit() - 5;
    const place& c = corners[static_cast<std::size_t>(r.integer(0, static_cast<std::int64_t>(corners.size()) - 1))];
    const place p = i % 2 == 0 ? place{x, y} : place{c.x + x / 5000, c.y + y / 5000};  // close to a corner
    if (!(-5 < p.x && p.x < 5 && -5 < p.y && p.y < 5)) continue;
    wrong += wrong_parts(got, s, p);
  }
  return wrong;
}

TEST_CASE("weak_visibility: as dense samples in rationals say") {
  test::random r(6);
  const int times = std::getenv("IRG_RELEASE_TIER") != nullptr ? 20 : 1;
  int wrong = 0;
  for (int i = 0; i < 250 * times; ++i) {
    const scene s = random_scene(r, 2 + i % 3, 5);
    wrong += wrong_places(s, r, 12);
  }
  CHECK(wrong == 0);
}

TEST_CASE("weak_visibility: sources that walls cut, cut where they do") {
  test::random r(16);
  const int times = std::getenv("IRG_RELEASE_TIER") != nullptr ? 20 : 1;
  int wrong = 0, judged = 0;
  for (int i = 0; i < 600 * times; ++i) {
    scene s = random_scene(r, 2, 4);
    if (s.source.size() < 3 || !s.second.empty()) continue;
    if (parts_of(s).status != visibility_status::source_crosses_obstacle) continue;
    const auto cut = irg::cut_source_rounded<double>(s.source, s.walls);
    const auto got = irg::weak_visibility(std::span<const place>(cut.ring), cut.obstacles, plan);
    if (got.status != visibility_status::ok) continue;
    ++judged;
    for (int k = 0; k < 12; ++k) {
      const double x = 10 * r.unit() - 5;
      wrong += wrong_parts(got, s, {x, 10 * r.unit() - 5});
    }
  }
  CHECK(wrong == 0);
  CHECK(judged > 50 * times);
}

TEST_CASE("weak_visibility: segments that walls cut, cut where they do") {
  test::random r(17);
  const int times = std::getenv("IRG_RELEASE_TIER") != nullptr ? 20 : 1;
  int wrong = 0, judged = 0;
  for (int i = 0; i < 500 * times; ++i) {
    scene s = random_scene(r, 2, 4);
    s.source.resize(2, place{});
    s.second.clear();
    if (s.source[0] == s.source[1]) continue;
    if (parts_of(s).status != visibility_status::source_crosses_obstacle) continue;
    const auto cut = irg::cut_segment_rounded<double>({s.source[0], s.source[1]}, s.walls);
    const auto got = irg::weak_visibility(std::span<const std::vector<place>>(cut.pieces), cut.obstacles, plan);
    if (got.status != visibility_status::ok) continue;
    ++judged;
    for (int k = 0; k < 12; ++k) {
      const double x = 10 * r.unit() - 5;
      wrong += wrong_parts(got, s, {x, 10 * r.unit() - 5});
    }
  }
  CHECK(wrong == 0);
  CHECK(judged > 50 * times);
}

TEST_CASE("sight_between: what places in the region see in rationals, and the other way round") {
  test::random r(8);
  const int times = std::getenv("IRG_RELEASE_TIER") != nullptr ? 20 : 1;
  int wrong = 0, seen[3]{};
  for (int i = 0; i < 150 * times; ++i) {
    const scene s = random_scene(r, 3, 5), other = random_scene(r, 3, 0);
    if (s.source.size() < 3 || !s.second.empty() || other.source.size() < 3 || !other.second.empty()) continue;
    const auto got = irg::sight_between<double>(s.source, other.source, s.walls);
    if (got.status != visibility_status::ok) continue;
    ++seen[static_cast<int>(got.value)];
    const auto back = irg::sight_between<double>(other.source, s.source, s.walls);
    wrong += back.status == visibility_status::ok && back.value != got.value;
    int least = 2, most = 0;
    for (int k = 0; k < 40; ++k) {
      const double x = 12 * r.unit() - 6, y = 12 * r.unit() - 6;
      const auto n = static_cast<std::int64_t>(other.source.size());
      const place& c = other.source[static_cast<std::size_t>(r.integer(0, n - 1))];
      const place p{c.x + x / 3, c.y + y / 3};
      if (irg::point_in_polygon(other.source, p, irg::fill_rule::even_odd) != irg::location::inside) continue;
      const int share = share_seen(s, p);
      least = std::min(least, share);
      most = std::max(most, share);
    }
    wrong += got.value == irg::seen_share::all && least < 2;
    wrong += got.value == irg::seen_share::none && most > 0;
  }
  CHECK(wrong == 0);
  for (const int n : seen) CHECK(test::enough(n > 3));
}
#endif

}  // namespace
