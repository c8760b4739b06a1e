// SPDX-License-Identifier: MIT
// What a renderer may be given, case by case. Where a case says "the same", it means every byte of ids and depths.
#include <irg/render/render.hpp>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <vector>

#include <irg/core/threads.hpp>
#include <irg/mesh/shapes.hpp>

#include "support/check_both.hpp"
#include "support/rendered.hpp"
#include "support/scenes.hpp"
#include "support/ulp.hpp"
#include "support/visible_scenes.hpp"

namespace {

using irg::face_culling;
using point = irg::point<double, 3>;
using test::scene_kind;
using test::triangle_scene;
using test::visible_ids;
using greater = irg::nearer_is_greater;
using less = irg::nearer_is_less;

constexpr double infinity = std::numeric_limits<double>::infinity();

// Draws with skipping on and off and on three threads, and expects the same.
template <irg::DepthOrder Order = greater>
test::id_picture drawn(const triangle_scene& s, face_culling culling = face_culling::none) {
  test::id_picture p = visible_ids<Order>(s, culling);
  REQUIRE(visible_ids<Order>(s, culling, irg::skip_nothing).same(p));
  REQUIRE(visible_ids<Order>(s, culling, irg::skip_options{}, irg::parallel{3}).same(p));
  return p;
}

template <class Picture>
int count_of_id(const Picture& p, std::uint32_t id) {
  int n = 0;
  for (int y = 0; y < p.id.height(); ++y)
    for (int x = 0; x < p.id.width(); ++x) n += p.id(x, y) == id;
  return n;
}

template <irg::DepthOrder Order = greater>
test::visibility_oracle<Order> oracle_of(const triangle_scene& s, face_culling culling = face_culling::none) {
  return {test::snapped_triangles(s, culling), s.width, s.height};
}

// Every pixel as the oracle has it.
template <irg::DepthOrder Order = greater>
void check_exact(const triangle_scene& s, const test::id_picture& p, face_culling culling = face_culling::none) {
  const auto oracle = oracle_of<Order>(s, culling);
  for (int y = 0; y < s.height; ++y)
    for (int x = 0; x < s.width; ++x) REQUIRE(p.id(x, y) == oracle.at(x, y).nearest);
}

// The ids are the same, all those of the second picture counted as 1; and so are the depths, but for rounding.
enum class depths { compared, of_other_planes };
void check_same_surface(const test::id_picture& a, const test::id_picture& b, depths which = depths::compared) {
  for (int y = 0; y < a.id.height(); ++y)
    for (int x = 0; x < a.id.width(); ++x) {
      REQUIRE(a.id(x, y) == (b.id(x, y) != 0 ? 1 : 0));
      if (which == depths::compared) REQUIRE(std::fabs(a.depth(x, y) - b.depth(x, y)) <= 0x1p-20f * b.depth(x, y));
    }
}

point middle(const point& a, const point& b) { return a + (b - a) * 0.5; }

// ---- around the eye

// With the near plane at distance 1, what lies between 2 in front of the eye and 0 is cut in the middle.
TEST_CASE("hostile: w = 0 exactly, -0, and w that is denormal or nearly, of either sign") {
  const point a{-1.7, -1.5, -2}, b{1.6, -1.4, -2};
  const double tiny[] = {0.0,         -0.0,         5e-324, -5e-324, 0x1p-1022, -0x1p-1022,
                         0x1.8p-1040, -0x1.8p-1040, 1e-300, -1e-300, 1e-30};
  for (const point& c : {point{0, 3, 0}, point{0.25, 0, 0}, point{0, 0, 0}, point{5e-324, -5e-324, 0}}) {
    const triangle_scene by_hand{
        {a, b, middle(b, c), middle(c, a)}, {{{0, 1, 2}}, {{0, 2, 3}}}, test::square_view(1), 40, 36};
    const auto expected = drawn(by_hand);
    if (c.y == 3) CHECK(count_of_id(expected, 0) < 40 * 36 - 300);
    for (const double w : tiny) {
      const triangle_scene s{{a, b, {c.x, c.y, -w}}, {{{0, 1, 2}}}, test::square_view(1), 40, 36};
      check_same_surface(drawn(s), expected);
      CHECK(drawn(s).same(drawn({{a, b, c}, s.triangles, s.to_clip, 40, 36})));
    }
  }
}

TEST_CASE("hostile: all three corners with w = 0 or nearly are nothing") {
  const triangle_scene frame{{{-1, -1, -2}, {1, -1, -2}, {0, 1, -3}}, {{{0, 1, 2}}}, test::square_view(0.125), 33, 40};
  for (const double w : {0.0, -0.0, 5e-324, -5e-324, 1e-300, -1e-300}) {
    triangle_scene s = frame;
    s.positions.insert(s.positions.end(), {{-1, -1, w}, {1, -1, w}, {0, 1, w}});
    s.triangles.push_back({{3, 4, 5}});
    CHECK(drawn(s).same(drawn(frame)));
  }
}

namespace {

// A world so small that w is subnormal, and 1/w overflows: the picture of the world as it would be at ordinary size.
template <class T>
void small_world(int least_power) {
  test::random r(309);
  for (int i = 0; i < 40; ++i) {
    const auto kind = i % 2 ? test::scene_kind::lattice : test::scene_kind::crossing;
    test::triangle_scene s{
        {}, {}, irg::mat<double, 4, 4>{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -0.5, 0}, {0, 0, -1, 0}}}, 40, 36};
    test::scene_maker make(r, kind, 40, 36);
    const test::triangle_scene like = make(10);
    s.triangles = like.triangles;
    // Few bits, so that scaling loses none.
    const auto rounded = [](double v) { return std::floor(v * 16) / 16; };
    for (const auto& p : like.positions) s.positions.push_back({rounded(p.x), rounded(p.y), rounded(p.z)});
    const auto expected = test::visible_ids<greater, T>(s);
    for (int power = least_power; power <= -4; power += power < least_power + 60 ? 4 : 97) {
      test::triangle_scene t = s;
      for (auto& p : t.positions) p = {std::ldexp(p.x, power), std::ldexp(p.y, power), std::ldexp(p.z, power)};
      const auto p = test::visible_ids<greater, T>(t);
      REQUIRE(p.same(expected));
      REQUIRE(test::visible_ids<greater, T>(t, face_culling::none, irg::skip_nothing).same(expected));
    }
  }
}

}  // namespace

TEST_CASE("hostile: a world so small that 1/w overflows gives the picture of a large one") {
  small_world<double>(-1069);
  small_world<float>(-144);
}

TEST_CASE("hostile: a matrix that brings corners to 0, 0, 0, 0: their triangles are left out, the rest stays") {
  for (const double w : {0.0, 1.0}) {
    // Clip space is the world; w is 1 where y is not 0, and all of the origin is 0.
    irg::mat<double, 4, 4> m{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0.5, 0, 0}, {0, 1, 0, 0}}};
    if (w == 0) m = {};
    const test::triangle_scene s{
        {{-1, 1, 0}, {1, 1, 0}, {0, 0, 0}, {0, 2, 0}}, {{{0, 1, 2}}, {{2, 2, 2}}, {{0, 2, 3}}}, m, 24, 24};
    const auto p = test::visible_ids(s);
    REQUIRE(test::visible_ids(s, face_culling::none, irg::skip_nothing).same(p));
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 24; ++x) REQUIRE(p.id(x, y) == 0);
  }
}

TEST_CASE("hostile: one, two and three corners behind the eye, every choice, cut by hand") {
  // 3 in front and 1 behind: the near plane at 1 cuts in the middle.
  const double x[3] = {-2.1, 2.3, 0.4}, y[3] = {-2.2, -1.9, 2.6};
  for (int behind = 0; behind < 8; ++behind) {
    triangle_scene s{{}, {{{0, 1, 2}}}, test::square_view(1), 44, 35};
    for (int k = 0; k < 3; ++k) s.positions.push_back({x[k], y[k], behind >> k & 1 ? 1.0 : -3.0});
    triangle_scene by_hand{{}, {}, s.to_clip, 44, 35};
    for (std::size_t k = 0; k < 3; ++k) {
      const point &from = s.positions[k], &to = s.positions[(k + 1) % 3];
      if (from.z < 0) by_hand.positions.push_back(from);
      if ((from.z < 0) != (to.z < 0)) by_hand.positions.push_back(middle(from, to));
    }
    for (std::uint32_t k = 1; k + 1 < by_hand.positions.size(); ++k) by_hand.triangles.push_back({{0, k, k + 1}});
    const auto whole = drawn(s);
    check_same_surface(whole, drawn(by_hand));
    check_same_surface(drawn(s, face_culling::back), drawn(by_hand, face_culling::back));
    CHECK((whole.stats.pixels.shaded > 10) == (behind != 7));
    // One way round it faces the eye, and only one.
    triangle_scene turned = s;
    std::swap(turned.triangles[0].v[0], turned.triangles[0].v[1]);
    check_same_surface(drawn(turned), drawn(by_hand), depths::of_other_planes);  // snapped, four corners are no plane
    const auto front = drawn(s, face_culling::back).stats.pixels.shaded,
               back = drawn(turned, face_culling::back).stats.pixels.shaded;
    CHECK(front + back == whole.stats.pixels.shaded);
    CHECK((front == 0 || back == 0));
  }
}

TEST_CASE("hostile: triangles through the eye are seen from the edge: nothing, the rest as it was") {
  const triangle_scene frame{{{-1, -1, -2}, {1, -1, -2}, {0, 1, -3}}, {{{0, 1, 2}}}, test::square_view(0.125), 32, 32};
  const std::vector<point> through_the_eye[] = {{{0, 0, 0}, {1, 0, -4}, {-1, 0, -4}},  // with a corner in it
                                                {{0, 0, 0}, {0, 0, -4}, {0, 0, -8}},  // a ray
                                                {{1, 0, -4}, {-1, 0, 4}, {2, 0, -1}},  // with an edge
                                                {{1, 1, -4}, {-3, -3, 2}, {4, 4, 3}},  // with its inside
                                                {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
                                                {{0, 0, 0}, {0, 0, 0}, {1, 1, -4}}};
  for (const auto& corners : through_the_eye)
    for (const bool first : {false, true}) {
      triangle_scene s = frame;
      s.positions.insert(s.positions.end(), corners.begin(), corners.end());
      s.triangles.insert(first ? s.triangles.begin() : s.triangles.end(), {{3, 4, 5}});
      const auto p = drawn(s), alone = drawn(frame);
      CHECK(p.depth == alone.depth);
      CHECK(p.stats.pixels == alone.stats.pixels);
    }
}

// ---- numbers that are none

TEST_CASE("hostile: NaN and infinity in each coordinate: those triangles go, the rest stays") {
  test::random r(301);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < 60; ++i) {
    test::scene_maker make(r, i % 2 ? scene_kind::sheets : scene_kind::any, 40, 70);
    const triangle_scene s = make(30);
    for (const double odd : {nan, -nan, infinity, -infinity}) {
      const auto bad = static_cast<std::uint32_t>(r.integer(0, static_cast<std::int64_t>(s.positions.size()) - 1));
      triangle_scene hurt = s, without = s;
      hurt.positions[bad][i % 3] = odd;
      if (i % 5 == 0) hurt.positions[bad] = {odd, odd, odd};
      for (auto& t : without.triangles)
        if (std::find(t.v, t.v + 3, bad) != t.v + 3) t = {{bad, bad, bad}};
      REQUIRE(drawn(hurt).same(drawn(without)));
      REQUIRE(drawn(hurt, face_culling::back).same(drawn(without, face_culling::back)));
    }
  }
}

TEST_CASE("hostile: a matrix that is not finite draws nothing") {
  for (const double odd : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity})
    for (int entry = 0; entry < 16; ++entry) {
      triangle_scene s{{{-1, -1, -2}, {1, -1, -2}, {0.5, 1, -3}}, {{{0, 1, 2}}}, test::square_view(0.125), 20, 20};
      s.to_clip(entry / 4, entry % 4) = odd;
      CHECK(count_of_id(drawn(s), 1) == 0);
    }
}

// ---- the clip planes

TEST_CASE("hostile: corners in every choice of the 27 cells of the clip planes: exact, skipped or not") {
  test::random r(302);
  const auto cell = [&](int number) {
    const auto in = [&](int which) { return which + static_cast<double>(r.integer(6, 58)) / 64; };
    const double w = in(number / 9) * 3 - 2;  // 1 to 4 is within
    const double x = (in(number % 3) * 2 - 3) * std::fabs(w), y = (in(number / 3 % 3) * 2 - 3) * std::fabs(w);
    return point{x, y, -w};
  };
  long long drawn_pixels = 0;
  for (int a = 0; a < 27; ++a)
    for (int b = 0; b < 27; ++b)
      for (int c = b; c < 27; ++c) {
        const triangle_scene s{{cell(a), cell(b), cell(c)}, {{{0, 1, 2}}}, test::square_view(1, 4), 11, 9};
        const auto culling = (a + b + c) % 2 ? face_culling::none : face_culling::back;
        const auto p = visible_ids(s, culling);
        REQUIRE(visible_ids(s, culling, irg::skip_nothing).same(p));
        check_exact(s, p, culling);
        drawn_pixels += p.stats.pixels.shaded;
      }
  CHECK(drawn_pixels > 27 * 27 * 14);
}

// A fan around a corner that lies exactly on a clip plane, in a plane z = rise * x + away, its rim far beyond the
// picture. What is left of it is known: `columns` of the picture, each pixel once.
struct fan {
  const char* name;
  point hub;
  double rise, away;
  int first_column, last_column;
};

TEST_CASE("hostile: a corner exactly on each clip plane: every pixel once") {
  test::random r(303);
  const double guard = (1 << 15) / 16;  // of a picture of 32 x 32 pixels
  for (const fan& f :
       {fan{"near", {0, 0.25, 0}, -1, 0, 16, 32}, fan{"far", {0, 0.25, -64}, -1, -64, 0, 16},
        fan{"left", {-guard, 0.125, -8}, 0, -8, 0, 32}, fan{"right", {guard, 0.125, -8}, 0, -8, 0, 32},
        fan{"bottom", {0.125, -guard, -8}, 0, -8, 0, 32}, fan{"top", {0.125, guard, -8}, 0, -8, 0, 32}}) {
    CAPTURE(f.name);
    for (int trial = 0; trial < 20; ++trial) {
      triangle_scene s{{f.hub}, {}, irg::orthographic(irg::view_window<double>{-1, 1, -1, 1}, 0, 64), 32, 32};
      const double far_out = f.rise == 0 ? 2 * guard : 16;
      std::vector<point> rim;  // round a square, from its lower left corner
      for (int side = 0; side < 4; ++side) {
        const int steps = static_cast<int>(r.integer(1, 4));
        for (int k = 0; k < steps; ++k) {
          const double along = k == 0 ? -1 : static_cast<double>(r.integer(-63 + 32 * k, -63 + 32 * k + 31)) / 64;
          const double u = far_out * along, v = far_out;
          const double x = side == 0   ? u
                           : side == 1 ? v
                           : side == 2 ? -u
                                       : -v,
                       y = side == 0   ? -v
                           : side == 1 ? u
                           : side == 2 ? v
                                       : -u;
          rim.push_back({x, y, f.rise * x + f.away});
        }
      }
      const auto n = static_cast<std::uint32_t>(rim.size());
      s.positions.insert(s.positions.end(), rim.begin(), rim.end());
      for (std::uint32_t k = 0; k < n; ++k) {
        s.triangles.push_back({{0, 1 + k, 1 + (k + 1) % n}});
        if (trial % 2) std::swap(s.triangles.back().v[0], s.triangles.back().v[1]);
      }
      for (const auto skip : {irg::skip_options{}, irg::skip_nothing}) {
        const auto p = visible_ids(s, face_culling::none, skip);
        for (int y = 0; y < 32; ++y)
          for (int x = 0; x < 32; ++x) REQUIRE((p.id(x, y) != 0) == (x >= f.first_column && x < f.last_column));
        REQUIRE(p.stats.pixels.tested == 32 * (f.last_column - f.first_column));
      }
    }
  }
}

// ---- depth

TEST_CASE("hostile: of equal depths the lowest index, copies in any order and turned round") {
  test::random r(304);
  long long ties = 0;
  for (int i = 0; i < 80; ++i) {
    const auto kind = static_cast<scene_kind>(i % test::scene_kinds);
    test::scene_maker make(r, kind, 40, 66);
    const triangle_scene s = make(20);
    triangle_scene copies = s;
    const std::size_t n = s.triangles.size();
    const bool turn =
        kind != scene_kind::through_the_eye && kind != scene_kind::huge;  // these are clipped to other fans
    for (std::size_t k = n; k-- > 0;) {
      copies.triangles.push_back(s.triangles[k]);
      if (turn && r.integer(0, 1)) std::swap(copies.triangles.back().v[1], copies.triangles.back().v[2]);
    }
    const auto once = drawn(s), twice = drawn(copies);
    REQUIRE(twice.same(once));
    ties += twice.stats.pixels.ties - once.stats.pixels.ties;
  }
  CHECK(ties > 20000);
}

// Two squares in one plane, cut along different diagonals. Parallel to the picture they have one depth, and the lower
// index has every pixel. Tilted, their corners are snapped and rounded one by one, so that the four triangles have four
// planes: who is seen follows these, as the oracle knows.
TEST_CASE("hostile: squares over each other in one plane") {
  test::random r(305);
  const auto squares = [&](double tilt, bool same_place) {
    triangle_scene s{{}, {{{0, 1, 2}}, {{0, 2, 3}}, {{4, 5, 7}}, {{5, 6, 7}}}, test::square_view(0.125), 48, 48};
    for (int k = 0; k < 2; ++k) {
      const auto offset = [&] { return same_place ? 0.0 : static_cast<double>(r.integer(-1000, 1000)) / 4001; };
      const double dx = offset(), dy = offset();
      for (const auto& [x, y] : {std::pair{-1.5, -1.5}, {1.5, -1.5}, {1.5, 1.5}, {-1.5, 1.5}})
        s.positions.push_back({x + dx, y + dy, -2.5 + tilt * (x + dx)});
    }
    return s;
  };
  int mixed = 0, depend = 0;
  for (int i = 0; i < 20; ++i) {
    const triangle_scene level = squares(0, i == 0), tilted = squares(0.37, i == 0);
    const auto p = drawn(level);
    const auto alone = drawn({level.positions, {level.triangles[0], level.triangles[1]}, level.to_clip, 48, 48});
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 48; ++x)
        if (alone.id(x, y) != 0) REQUIRE(p.id(x, y) == alone.id(x, y));
    const auto q = drawn(tilted);
    check_exact(tilted, q);
    mixed += count_of_id(q, 1) + count_of_id(q, 2) > 100 && count_of_id(q, 3) + count_of_id(q, 4) > 100;
    triangle_scene other = tilted;  // the first square cut as the second
    other.triangles[0] = {{0, 1, 3}}, other.triangles[1] = {{1, 2, 3}};
    const auto o = drawn(other);
    bool differs = false;
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 48; ++x) differs = differs || (o.id(x, y) > 2) != (q.id(x, y) > 2);
    depend += differs;
  }
  MESSAGE("of 20 tilted pairs ", mixed, " show both squares, ", depend, " depend on the diagonal");
  CHECK(mixed > 10);
}

TEST_CASE("hostile: slivers and steep triangles: depths within their corners' range, and accurate") {
  test::random r(306);
  double worst = 0;
  for (int i = 0; i < 160; ++i) {
    const scene_kind kinds[] = {scene_kind::slivers, scene_kind::crossing, scene_kind::huge, scene_kind::lattice};
    test::scene_maker make(r, kinds[i % 4], 50, 40);
    triangle_scene s = make(24);
    if (i / 4 % 2) s.to_clip = test::square_view(0.125, 100);
    const auto snapped = test::snapped_triangles(s, face_culling::none);
    const test::visibility_oracle<greater> oracle(snapped, 50, 40);
    std::vector<std::pair<float, float>> range(s.triangles.size() + 1, {2.0f, -1.0f});
    for (const auto& t : snapped)
      for (const auto& v : t.v)
        range[t.id] = {std::min(range[t.id].first, v.depth), std::max(range[t.id].second, v.depth)};
    const auto p = visible_ids(s);
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 50; ++x) {
        const std::uint32_t id = p.id(x, y);
        if (id == 0) continue;
        REQUIRE(range[id].first <= p.depth(x, y));
        REQUIRE(p.depth(x, y) <= range[id].second);
        worst = std::max(worst, oracle.ulps_off(p.depth(x, y), id, x, y));
      }
  }
  MESSAGE("depths within ", worst, " ulp of exact");
  CHECK(worst <= 4);
}

// The whole picture covered twice, from 8 to some thousand ulp apart: the nearer is seen. What ranges are refused is in
// view/projection_test.
TEST_CASE("hostile: pairs that stored depth tells apart are never drawn in the wrong order, near/far up to 1e12") {
  test::random r(307);
  const struct {
    double near, far;
  } ranges[] = {{1e-3, 1e9}, {1e-3, infinity}, {0.1, 1e5}, {0.1, infinity}, {1, 1.001}};
  const int pairs = test::is_release_tier() ? 20000 : 400;
  long long apart = 0, wrong = 0, nearly = 0;
  for (const auto& range : ranges)
    for (int i = 0; i < pairs; ++i) {
      const double last = range.far == infinity ? 1e12 : range.far;
      const auto between = [&](double t) { return range.near * std::exp2(std::log2(last / range.near) * t); };
      const double t = 0.999 * r.unit(), own = between(t);
      triangle_scene s{{}, {{{0, 1, 2}}, {{3, 4, 5}}}, test::square_view(range.near, range.far), 13, 11};
      const double ratio = 1 + std::exp2(-24 + 8 * r.unit());
      const double slope = i % 3 == 0 ? 0.2 : i % 3 == 1 ? 1e-6 : 0;  // tilted both alike
      const bool swap = r.integer(0, 1) != 0;
      for (int k = 0; k < 2; ++k)
        for (int corner = 0; corner < 3; ++corner) {
          const double away =
              std::min(last, std::max(range.near, own * (1 + slope * (corner - 1)))) * ((k != 0) != swap ? ratio : 1);
          const double x = corner == 0 ? -4 : corner == 1 ? 4 : 0.5, y = corner == 2 ? 5 : -3;
          s.positions.push_back({x * away, y * away, -away});
        }
      const auto oracle = oracle_of(s);
      const auto p = visible_ids(s);
      for (int y = 0; y < s.height; ++y)
        for (int x = 0; x < s.width; ++x) {
          const test::visible v = oracle.at(x, y);
          if (v.runner_up == 0 || v.ulps < 8) continue;
          ++apart, nearly += v.ulps < 64;
          wrong += p.id(x, y) != v.nearest;
        }
    }
  MESSAGE(apart, " pixels with two depths 8 ulp or more apart, ", nearly, " of them less than 64; ", wrong, " wrong");
  CHECK(apart > 5 * pairs * 13 * 11 / 3);
  CHECK(nearly > pairs * 13 * 11 / 4);
  CHECK(wrong == 0);
}

TEST_CASE("hostile: on the near plane drawn, on the far plane itself not, touching it drawn up to there") {
  const auto in_order = [](auto order) {
    using Order = decltype(order);
    const auto at = [](double a, double b, double c) {
      return triangle_scene{{{-3 * a, -3 * a, -a}, {3 * b, -3 * b, -b}, {0, 3 * c, -c}},
                            {{{0, 1, 2}}},
                            test::square_view<Order>(1, 4),
                            24,
                            24};
    };
    const float nearest = 1.0f - Order::farthest;
    const auto near = drawn<Order>(at(1, 1, 1)), far = drawn<Order>(at(4, 4, 4)), touching = drawn<Order>(at(4, 1, 2)),
               none = drawn<Order>({{}, {}, test::square_view<Order>(1, 4), 24, 24});
    CHECK(count_of_id(near, 1) > 200);
    CHECK(count_of_id(far, 1) == 0);
    CHECK(far.same(none));
    CHECK(count_of_id(touching, 1) == count_of_id(near, 1));
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 24; ++x) {
        REQUIRE(near.depth(x, y) == (near.id(x, y) == 1 ? nearest : Order::farthest));
        REQUIRE(far.depth(x, y) == Order::farthest);
        REQUIRE((touching.id(x, y) == 1) == Order::nearer(touching.depth(x, y), Order::farthest));
      }
    // Nothing hides what is on the near plane, and of two there the first is seen.
    triangle_scene both = at(1, 1, 1);
    both.positions.insert(both.positions.begin(), {{-3, -3, -1.5}, {3, -3, -1.25}, {0, 3, -1.75}});
    both.triangles = {{{0, 1, 2}}, {{3, 4, 5}}, {{3, 4, 5}}};
    const auto p = drawn<Order>(both);
    CHECK(count_of_id(p, 2) == count_of_id(near, 1));
    CHECK(count_of_id(p, 3) == 0);
  };
  in_order(greater{});
  in_order(less{});
}

TEST_CASE("hostile: 1 x 1, 65535 x 1, 1 x 65535: exact; pictures without pixels: nothing") {
  test::random r(308);
  for (const auto& [width, height] : {std::pair{1, 1}, {65535, 1}, {1, 65535}, {65535, 2}, {3, 65535}})
    for (int i = 0; i < (width * height == 1 ? 40 : 4); ++i) {
      triangle_scene s{{}, {}, test::square_view(0.125), width, height};
      for (std::uint32_t k = 0; k < 12; ++k) {
        // As much of the picture as fits, in x and in y.
        const std::int64_t x = r.integer(-width * 1024LL / 2, width * 1024LL * 3 / 2),
                           y = r.integer(-height * 1024LL / 2, height * 1024LL * 3 / 2);
        s.positions.push_back(test::seen_at(x, y, r.integer(1024, 8192), width, height));
        if (k % 3 == 2) s.triangles.push_back({{k - 2, k - 1, k}});
      }
      const auto p = drawn(s);
      check_exact(s, p);
      if (width * height > 1) CHECK(p.stats.pixels.shaded > 0);
    }
  for (const auto& [width, height] : {std::pair{0, 0}, {0, 7}, {7, 0}}) {
    const triangle_scene s{
        {{-1, -1, -2}, {1, -1, -2}, {0, 1, -2}}, {{{0, 1, 2}}}, test::square_view(0.125), width, height};
    CHECK(drawn(s).stats.pixels == irg::draw_counts{});
  }
}

// ---- light

constexpr irg::picture_style styles[] = {irg::picture_style::flat, irg::picture_style::gouraud,
                                         irg::picture_style::phong};

irg::scene<double> lit_cube() {
  irg::scene<double> s;
  s.objects.push_back({irg::shape_cube<double>()});
  s.objects[0].surface = {{0.5, 0.25, 0.75}, {0.8, 0.7, 0.6}, {0.9, 0.9, 0.9}, 12};
  s.view.eye = {3, 2, 4};
  s.view.target = {0.5, 0.5, 0.5};
  s.ambient = {0.4, 0.6, 0.2};
  return s;
}

// Whether every pixel of the cube has the colour of the ambient light alone.
bool ambient_alone(const irg::scene<double>& s, irg::picture_style style, face_culling culling = face_culling::back) {
  const test::rendered r = test::render(s, 40, 40, {style, {}, culling});
  const auto& k = s.objects[0].surface.ambient;
  const irg::rgba8 expected = irg::encode({static_cast<float>(s.ambient.r * k.r), static_cast<float>(s.ambient.g * k.g),
                                           static_cast<float>(s.ambient.b * k.b)});
  bool all = r.stats.drawn > 100;
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x) {
      const irg::rgba8 p = r.picture.colour(x, y);
      all = all && (p == irg::picture_colours{}.background || p == expected);
    }
  return all;
}

TEST_CASE("hostile: no lights: the ambient light alone") {
  const auto s = lit_cube();
  for (const auto style : styles) CHECK(ambient_alone(s, style));
  auto lit = s;
  lit.lights.push_back({{3, 4, 5, 1}, {1, 1, 1}});
  for (const auto style : styles) CHECK(!ambient_alone(lit, style));
}

TEST_CASE("hostile: lights inside the body light its outside nowhere; without any direction, nothing") {
  using place = irg::hpoint<double, 3>;
  auto s = lit_cube();
  s.lights.resize(1);
  for (const place& p : {place{0.5, 0.5, 0.5, 1}, place{0.4, 0.6, 0.45, 1}, place{0, 0, 0, 1}, place{0, 0, 0, 0}}) {
    s.lights[0] = {p, {1, 1, 1}};  // the third stands in a corner of the cube
    for (const auto style : styles) CHECK(ambient_alone(s, style));
  }
  s.lights[0] = {{0.01, 0.99, 0.02, 1}, {1, 1, 1}};  // so near a corner that normals in between may lean to it
  for (const auto style : {irg::picture_style::flat, irg::picture_style::gouraud}) CHECK(ambient_alone(s, style));
}

TEST_CASE("hostile: a light in the plane of a face grazes it, one in a pixel's own point has no direction there") {
  irg::scene<double> s = lit_cube();
  irg::mesh<double> wall;
  wall.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  irg::add_face(wall, std::vector<int>{0, 1, 2, 3});
  s.objects[0].shape = wall;
  s.view.eye = {0, 0, 4}, s.view.target = {0, 0, 0};
  for (const auto& place : {irg::hpoint<double, 3>{0.25, 0.125, 0, 1}, {0, 0, 0, 1}, {-1, -1, 0, 1}, {7, 3, 0, 0}}) {
    auto lit = s;
    lit.lights.push_back({place, {1, 1, 1}});
    for (const auto style : styles) CHECK(ambient_alone(lit, style));
  }
}

TEST_CASE("hostile: normals of length 0: the ambient light alone, on either side") {
  auto s = lit_cube();
  s.lights.push_back({{3, 4, 5, 1}, {1, 1, 1}});
  auto& m = s.objects[0].shape;
  m.normals = {{0, 0, 0}};
  for (auto& c : m.corners) c.normal = 0;
  for (const auto style : {irg::picture_style::gouraud, irg::picture_style::phong})
    for (const auto culling : {face_culling::back, face_culling::none}) CHECK(ambient_alone(s, style, culling));
}

// ---- whole scenes

// Every style by method by culling by range of light, drawn with every skip and with none: the same bytes, depths that
// are depths, and as many pixels drawn as show something.
void draw_every_way(const irg::scene<double>& s, int width, int height) {
  using method = irg::hidden_surface_method;
  for (int i = 0; i < 32; ++i) {
    irg::render_options o{static_cast<irg::picture_style>(i % 4),
                          i / 4 % 2 ? method::none : method::zbuffer,
                          i / 8 % 2 ? face_culling::none : face_culling::back,
                          {},
                          i / 16 ? irg::intensity_range::rescale : irg::intensity_range::clamp};
    const test::rendered skipping = test::render(s, width, height, o);
    o.skip = irg::skip_nothing;
    const test::rendered plain = test::render(s, width, height, o);
    REQUIRE(skipping.picture == plain.picture);
    REQUIRE(skipping.stats.drawn == plain.stats.drawn);
    if (o.style == irg::picture_style::wire) continue;
    const float farthest = o.hidden == method::none ? irg::drawing_order::farthest : greater::farthest;
    std::int64_t shown = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const float depth = plain.picture.depth(x, y);
        REQUIRE((depth == farthest || (0 <= depth && depth <= 1)));
        shown += depth != farthest;
      }
    REQUIRE(shown <= plain.stats.drawn);  // a far plane's depth is that of nothing
  }
}

TEST_CASE("hostile: scenes at 1e300 and 1e-300, odd numbers in every part, meshes of nothing, every way to draw") {
  using numbers = std::numeric_limits<double>;
  irg::scene<double> usual = lit_cube();
  usual.objects.push_back({irg::shape_sphere<double>({.slices = 7, .stacks = 5})});
  usual.lights = {{{3, 4, 5, 1}, {2, 2, 2}}, {{-0.4, 1, 0.7, 0}, {0.7, 0.8, 0.9}}};
  for (const auto& [width, height] : {std::pair{1, 1}, {70, 3}, {21, 17}}) draw_every_way(usual, width, height);
  for (const double k : {1e300, 1e-300}) {
    auto s = usual;
    for (auto& o : s.objects)
      for (int i = 0; i < 3; ++i) o.placement(i, i) = k;
    s.view.eye = {3 * k, 2 * k, 4 * k}, s.view.target = {k / 2, k / 2, k / 2}, s.view.near_distance *= k;
    draw_every_way(s, 21, 17);
    s = usual;
    for (auto& p : s.objects[1].shape.positions) p = {p.x * k, p.y * k, p.z * k};
    draw_every_way(s, 21, 17);
  }
  for (const double odd : {numbers::quiet_NaN(), infinity, -infinity, numbers::max()}) {
    irg::scene<double> hurt[] = {usual, usual, usual, usual, usual, usual, usual, usual};
    hurt[0].objects[0].shape.positions[3].y = odd;
    for (auto& n : hurt[1].objects[1].shape.normals) n.x = odd;
    hurt[2].objects[0].placement(1, 2) = odd;
    hurt[3].objects[0].placement(3, 3) = odd;
    hurt[4].lights[0].position.x = odd;
    hurt[5].lights[0].position.w = odd;
    hurt[6].lights[1].intensity.g = odd;
    hurt[7].objects[1].surface.diffuse = {odd, 1, odd};
    for (const auto& s : hurt) draw_every_way(s, 9, 8);
  }
  for (const point& eye : {point{0.5, 0.5, 0.5}, point{0, 0, 0}})  // within a cube, and in its corner
    for (const double first : {5e-324, 1.0}) {
      auto s = usual;
      s.view.eye = eye, s.view.target = {3, 1, 2}, s.view.near_distance = first;
      draw_every_way(s, 9, 8);
    }
  auto s = usual;
  s.objects.resize(1);
  s.lights.assign(300, {{1, 2, 3, 1}, {}});
  draw_every_way(s, 9, 8);
  irg::mesh<double> one, in_one_point, line;
  one.positions = {{0, 0, 0}};
  in_one_point.positions = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  irg::add_face(in_one_point, std::vector<int>{0, 1, 2});
  line.positions = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {1, 1, 1}};
  irg::add_face(line, std::vector<int>{0, 1, 2, 3});
  s = usual;
  for (const auto& m : {irg::mesh<double>{}, one, in_one_point, line}) s.objects.insert(s.objects.begin(), {m});
  draw_every_way(s, 21, 17);
  for (auto& o : s.objects) o.placement(2, 2) = 0;
  draw_every_way(s, 21, 17);
}

}  // namespace
