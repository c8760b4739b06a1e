// SPDX-License-Identifier: MIT
#include <irg/visibility/visibility_polygon.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "support/check_both.hpp"
#include "support/plane_sight_oracle.hpp"
#include "support/random.hpp"

namespace {

using irg::obstacle_ends;
using irg::sight_stop;
using irg::visibility_status;
using place = irg::point<double, 2>;
using wall = irg::segment<double, 2>;
using window = irg::box<double, 2>;
using vertex = irg::sight_vertex<double>;

constexpr window room{{-4, -4}, {4, 4}};

// One wall: its shadow, seen from the middle of the room.
constexpr bool shadow_of_one_wall() {
  const wall walls[] = {{{1, 1}, {1, -1}}};
  const auto seen = irg::visibility_polygon(place{0, 0}, room, walls);
  const vertex want[] = {{{1, 1}, sight_stop::nothing, 0},   {{4, 4}, sight_stop::boundary, 2},
                         {{-4, 4}, sight_stop::boundary, 3}, {{-4, -4}, sight_stop::boundary, 0},
                         {{4, -4}, sight_stop::nothing, 0},  {{1, -1}, sight_stop::obstacle, 0}};
  return seen && seen.status == visibility_status::ok && std::equal(seen.ring.begin(), seen.ring.end(), want, want + 6);
}
// Two walls that touch: closed they hide the corner behind, open they let a needle through.
constexpr std::size_t vertices_past_a_joint(obstacle_ends ends) {
  const wall walls[] = {{{1, 1}, {1, -1}}, {{1, 1}, {-1, 1}}};
  return irg::visibility_polygon(place{0, 0}, room, walls, {.ends = ends}).ring.size();
}
constexpr bool hostile() {
  constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  const wall walls[] = {{{least, most}, {least, -most}}, {{-1, 1}, {-1, 1}}};
  const auto seen = irg::visibility_polygon(place{0, 0}, window{{-most, -most}, {most, most}}, walls);
  return seen.status == visibility_status::ok && seen.ring.size() == 4 && seen.ring[0].at == place{least, most};
}
constexpr bool nothing_there() {
  const auto nan = irg::visibility_polygon(place{std::numeric_limits<double>::quiet_NaN(), 0}, room);
  const auto none = irg::visibility_polygon(place{0, 0}, window{}), beyond = irg::visibility_polygon(place{5, 0}, room);
  return !nan && nan.status == visibility_status::not_finite && none.status == visibility_status::source_outside &&
         beyond.status == visibility_status::source_outside && nan.ring.empty() && beyond.ring.empty();
}
// No wall; one before an edge of the room; two that cross, seen before one edge; what stops nothing; no polygon at all.
constexpr irg::sight_counts counts_of(const place& source, const window& domain, std::span<const wall> walls) {
  irg::sight_counts counts;
  const auto seen = irg::visibility_polygon(source, domain, walls, {}, counts);
  return seen == irg::visibility_polygon(source, domain, walls) ? counts : irg::sight_counts{-1};
}
constexpr bool counted_by_hand() {
  const wall one[] = {{{1, 1}, {1, -1}}}, cross[] = {{{1, -1}, {2, 1}}, {{2, -1}, {1, 1}}};
  const wall idle[] = {{{1, 1}, {1, 1}}, {{1, 0}, {2, 0}}};
  constexpr window tall{{-4, -8}, {4, 8}};
  // Of those that cross, the edge of the room behind is held against the second from its lower end to the direction
  // where the turn begins, against either on its side of the crossing after that; once they are held against each other.
  return counts_of({0, 0}, room, {}) == irg::sight_counts{4, 4, 4, 0, 0} &&
         counts_of({0, 0}, room, one) == irg::sight_counts{5, 3, 4, 1, 0} &&
         counts_of({0, 0}, tall, cross) == irg::sight_counts{6, 3, 8, 4, 1} &&
         counts_of({0, 0}, room, idle) == irg::sight_counts{6, 6, 4, 0, 0} &&
         counts_of({5, 0}, room, one) == irg::sight_counts{5, 5, 6, 0, 0} &&
         counts_of({0, 0}, window{}, one) == irg::sight_counts{1, 1, 0, 0, 0} &&
         counts_of({0, std::numeric_limits<double>::infinity()}, room, one).passed_over <= 5;
}
static_assert(counted_by_hand());
TEST_CASE("visibility_polygon: counts of scenes worked out by hand") { CHECK(counted_by_hand()); }

TEST_CASE("visibility_polygon: counting changes nothing, and adds") {
  test::random r(23);
  irg::sight_counts sum;
  std::int64_t walls = 0;
  for (int i = 0; i < 200; ++i) {
    std::vector<wall> some;
    for (auto n = r.integer(0, 12); n > 0; --n) {
      const auto number = [&] { return static_cast<double>(r.integer(-6, 6)); };
      const place a{number(), number()};
      const place b{number(), number()};
      some.push_back({a, b});
    }
    const irg::sight_options options{i % 2 == 0 ? obstacle_ends::closed : obstacle_ends::open};
    const place source{static_cast<double>(r.integer(-4, 4)), static_cast<double>(r.integer(-4, 4))};
    const irg::sight_counts before = sum;
    CHECK(irg::visibility_polygon(source, room, some, options, sum) ==
          irg::visibility_polygon(source, room, some, options));
    walls += static_cast<std::int64_t>(some.size()) + 4;
    CHECK(sum.walls == walls);
    CHECK(before.passed_over <= sum.passed_over);
    CHECK(sum.passed_over - before.passed_over <= sum.walls - before.walls);
    CHECK(sum.crossings - before.crossings <= sum.compared - before.compared);
  }
}

// Walls cross in one direction twice, and only the nearer crossing, at (-40/17, 134/17), is seen.
constexpr bool one_crossing_behind_another() {
  const wall walls[] = {{{-2, 9}, {-4, 6}}, {{-2, 8}, {-8, 6}}, {{8, 7}, {5, 12}}, {{-2, 2}, {-3, 1}},
                        {{0, 6}, {-5, 10}}, {{-2, 8}, {-9, 7}}, {{3, 9}, {4, 12}}, {{-4, 6}, {-5, 12}}};
  bool is_seen = false;
  for (const vertex& v : irg::visibility_polygon(place{0, 7}, window{{-8, -8}, {8, 8}}, walls).ring)
    is_seen = is_seen || v.at == place{-40.0 / 17, 134.0 / 17};
  return is_seen;
}
static_assert(shadow_of_one_wall() && hostile() && nothing_there() && one_crossing_behind_another());
static_assert(vertices_past_a_joint(obstacle_ends::closed) == 6 && vertices_past_a_joint(obstacle_ends::open) == 8);

TEST_CASE("visibility_polygon: constants as at run time") {
  CHECK(shadow_of_one_wall());
  CHECK(hostile());
  CHECK(nothing_there());
  CHECK(one_crossing_behind_another());
  CHECK(vertices_past_a_joint(obstacle_ends::closed) == 6);
  CHECK(vertices_past_a_joint(obstacle_ends::open) == 8);
}

TEST_CASE("visibility_polygon: a source on the boundary, on an obstacle, on a corner") {
  const auto on_wall = irg::visibility_polygon(place{-4, 0}, room);
  CHECK((on_wall && on_wall.status == visibility_status::source_on_boundary));
  CHECK(on_wall.ring.size() == 5);
  CHECK(std::count_if(on_wall.ring.begin(), on_wall.ring.end(), [](const auto& v) { return v.at == place{-4, 0}; }) ==
        1);
  CHECK(irg::visibility_polygon(place{4, 4}, room).ring.size() == 4);
  const wall walls[] = {{{-1, 0}, {1, 0}}};
  const auto on_obstacle = irg::visibility_polygon(place{0, 0}, room, walls);
  CHECK((on_obstacle && on_obstacle.status == visibility_status::source_on_obstacle));
  CHECK(on_obstacle.ring.size() == 4);
  const wall dots[] = {{{0, 0}, {0, 0}}};
  CHECK(irg::visibility_polygon(place{0, 0}, room, dots).status == visibility_status::source_on_obstacle);
  CHECK(irg::visibility_polygon(place{0, 0}, room, dots, {.ends = obstacle_ends::open}).status ==
        visibility_status::ok);
}

TEST_CASE("visibility_polygon: corners of the domain end needles, whichever side they come from") {
  const wall walls[] = {{{1, 1}, {1, 0}}, {{2, 0}, {2, -1}}};
  for (const double up : {1.0, -1.0}) {
    const std::vector<place> spiked{{-4, -4 * up}, {4, -4 * up},  {4, 4 * up}, {3.5, 4 * up},
                                    {3, 0},        {2.5, 4 * up}, {-4, 4 * up}};
    const auto seen = irg::visibility_polygon(place{0, 0}, spiked, walls, {.ends = obstacle_ends::open});
    const auto count = [&](const place& p) {
      return std::count_if(seen.ring.begin(), seen.ring.end(), [&](const auto& v) { return v.at == p; });
    };
    CHECK(count({3, 0}) == 1);
    CHECK(count({4, 0}) == 0);
  }
}

TEST_CASE("visibility_polygon: domains of any container and any type of point") {
  const std::array<double, 2> ring[] = {{-4, -4}, {4, -4}, {4, 4}, {-4, 4}};
  CHECK(irg::visibility_polygon(place{1, 0}, ring) == irg::visibility_polygon(place{1, 0}, room));
}

TEST_CASE("visibility_polygon: rings without area, without vertices") {
  const std::vector<std::vector<place>> none, empty(1), one{{{0, 0}}}, flat{{{-1, 0}, {1, 0}}};
  for (const auto* rings : {&none, &empty, &one, &flat}) {
    CHECK(irg::visibility_polygon(place{0, 0}, *rings).status == visibility_status::source_outside);
    CHECK(irg::visibility_polygon(place{0, 1}, *rings).ring.empty());
  }
}

TEST_CASE("visibility_polygon: directions that rounded angles mix up are in their order") {
  test::random r(7);
  const place source{1.0 / 3, 1.0 / 7};
  std::vector<place> points;
  for (int i = 0; i < 3000; ++i) {
    const double t = 1 + 9 * r.unit();
    points.push_back({source.x + 0.7 * t, source.y + 0.3 * t});
  }
  const auto sorted = irg::detail::ordered_directions(source, points);
  int wrong = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const std::uint32_t a = sorted.order[i - 1], b = sorted.order[i];
    const int turn = irg::orient2d(source, points[a], points[b]);
    wrong += turn < 0 || (turn == 0) != (sorted.rank[a] == sorted.rank[b]);
  }
  CHECK(wrong == 0);
}

#ifdef IRG_HAVE_MPFR
namespace oracle = test::plane_sight;

template <class T>
oracle::place exactly(const irg::point<T, 2>& p) {
  return {oracle::number(static_cast<double>(p.x)), oracle::number(static_cast<double>(p.y))};
}

template <class T>
struct scene {
  irg::point<T, 2> source;
  std::vector<std::vector<irg::point<T, 2>>> rings;
  std::vector<irg::segment<T, 2>> obstacles;
  irg::sight_options options;
};

template <class T>
bool agrees(const scene<T>& s) {
  std::vector<oracle::edge> edges;
  for (std::size_t i = 0; i < s.obstacles.size(); ++i)
    edges.push_back({exactly(s.obstacles[i].a), exactly(s.obstacles[i].b), sight_stop::obstacle, i});
  std::size_t count = 0;
  for (const auto& ring : s.rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      edges.push_back({exactly(ring[i]), exactly(ring[(i + 1) % ring.size()]), sight_stop::boundary, count++});
  oracle::scene brute(exactly(s.source), edges, s.options);
  const auto got = irg::visibility_polygon(s.source, s.rings, s.obstacles, s.options);
  bool on_boundary = false;
  for (const auto& e : edges)
    on_boundary = on_boundary || (e.stop == sight_stop::boundary && !oracle::same(e.a, e.b) && brute.is_on(e));
  if (!on_boundary && !brute.is_inside(exactly(s.source))) return got.status == visibility_status::source_outside;
  const auto want = brute.ring();
  if (want.empty()) return got.status == visibility_status::source_outside;
  if ((got.status == visibility_status::source_on_boundary) != on_boundary || got.ring.size() != want.size())
    return false;
  const auto agree = [&](const irg::sight_vertex<T>& v, const oracle::corner& w) {
    return v.at.x == test::nearest<T>(w.at.x) && v.at.y == test::nearest<T>(w.at.y) && v.stop == w.stop &&
           v.index == w.index;
  };
  for (std::size_t turn = 0; turn < want.size(); ++turn) {
    std::size_t i = 0;
    while (i < want.size() && agree(got.ring[i], want[(i + turn) % want.size()])) ++i;
    if (i == want.size()) return true;
  }
  return false;
}

// Coordinates are small integers times powers of two: of one size, or each of a size of its own.
template <class T>
scene<T> random_scene(test::random& r, int size, int spread) {
  const auto number = [&] {
    const auto n = static_cast<T>(r.integer(-size, size));
    const auto e = static_cast<int>(spread == 0 ? 0 : r.integer(-spread, spread));
    return std::ldexp(n, e);
  };
  const auto any = [&] {
    const T x = number(), y = number();
    return irg::point<T, 2>{x, y};
  };
  scene<T> s;
  s.options.ends = r.integer(0, 1) == 0 ? obstacle_ends::closed : obstacle_ends::open;
  s.options.rule = r.integer(0, 1) == 0 ? irg::fill_rule::even_odd : irg::fill_rule::non_zero;
  s.source = any();
  for (auto i = r.integer(0, 5); i > 0; --i) {
    const auto a = any(), b = any();
    s.obstacles.push_back({a, b});
  }
  const T far_off = std::ldexp(static_cast<T>(size), spread);
  if (r.integer(0, 2) != 0)
    s.rings.push_back({{-far_off, -far_off}, {far_off, -far_off}, {far_off, far_off}, {-far_off, far_off}});
  if (r.integer(0, 1) == 0) {
    s.rings.emplace_back();
    for (auto i = r.integer(1, 6); i > 0; --i) s.rings.back().push_back(any());
  }
  return s;
}

TEST_CASE("visibility_polygon: brute force over all directions, in rationals") {
  test::random r(22);
  const int times = std::getenv("IRG_RELEASE_TIER") != nullptr ? 60 : 1;
  int wrong = 0;
  for (int i = 0; i < 700 * times; ++i) wrong += !agrees(random_scene<double>(r, 2 + i % 3, 0));
  CHECK(wrong == 0);
  for (int i = 0; i < 50 * times; ++i) wrong += !agrees(random_scene<double>(r, 1000000, 0));
  CHECK(wrong == 0);
  for (int i = 0; i < 50 * times; ++i) {  // directions that doubles hardly tell apart
    scene<double> s = random_scene<double>(r, 2, 0);
    s.source = {s.source.x / 3, s.source.y / 7};
    for (auto& o : s.obstacles)
      for (place* p : {&o.a, &o.b})
        *p = {s.source.x + p->x / 5 + std::ldexp(p->y, -53), s.source.y + p->y / 5 + std::ldexp(p->x, -53)};
    wrong += !agrees(s);
  }
  CHECK(wrong == 0);
  for (int i = 0; i < 100 * times; ++i) wrong += !agrees(random_scene<double>(r, 3, i % 2 == 0 ? 2 : 1020));
  CHECK(wrong == 0);
  for (int i = 0; i < 100 * times; ++i) wrong += !agrees(random_scene<float>(r, 3, i % 2 == 0 ? 0 : 120));
  CHECK(wrong == 0);
}
#endif

}  // namespace
