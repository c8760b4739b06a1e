// SPDX-License-Identifier: MIT
// The visible triangle of every pixel, against an exact oracle, and the same bytes however the work is done.
#include <irg/render/draw_triangles.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <irg/core/threads.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"
#include "support/ulp.hpp"
#include "support/visible_scenes.hpp"

namespace {

using irg::face_culling;
using irg::skip_options;
using greater = irg::nearer_is_greater;
using less = irg::nearer_is_less;
using test::scene_kind;
using test::triangle_scene;

// Depths within so many units in the last place of a float may be drawn in either order: 4 for each.
constexpr double k_ulp = 8;

struct tally {
  long long pixels = 0, covered = 0, hidden = 0;
  long long equal = 0;      // the two nearest are exactly as far
  long long close = 0;      // not exactly, but within k ulp; or so near to the far plane
  long long otherwise = 0;  // of these two, drawn otherwise than by the exact depths
  long long wrong = 0;
  std::string list;

  void report(const std::string& what, int scenes) const {
    MESSAGE(what, ": ", scenes, " scenes, ", covered, " of ", pixels, " pixels covered, ", hidden,
            " with something behind; ", equal, " exactly as far, ", close, " within ", k_ulp, " ulp, ", otherwise,
            " of these drawn otherwise, ", wrong, " wrong", list);
  }
};

template <irg::DepthOrder Order, class T = double>
void compare(const triangle_scene& s, face_culling culling, const test::id_picture& drawn, int number, tally& sum) {
  const test::visibility_oracle<Order> oracle(test::snapped_triangles<T>(s, culling), s.width, s.height);
  for (int y = 0; y < s.height; ++y)
    for (int x = 0; x < s.width; ++x) {
      const test::visible v = oracle.at(x, y);
      ++sum.pixels;
      sum.covered += v.nearest != 0;
      sum.hidden += v.runner_up != 0;
      const bool equal = v.runner_up != 0 && v.ulps == 0;
      const bool close = !equal && ((v.runner_up != 0 && v.ulps <= k_ulp) || oracle.ulps_behind(0, x, y) <= k_ulp);
      sum.equal += equal;
      sum.close += close;
      const std::uint32_t id = drawn.id(x, y);
      if (id == v.nearest) continue;
      const bool allowed = (equal || close) && oracle.ulps_behind(id, x, y) <= k_ulp;
      ++(allowed ? sum.otherwise : sum.wrong);
      if (sum.list.size() < 2000)
        sum.list += "\n  scene " + std::to_string(number) + " pixel " + std::to_string(x) + ", " + std::to_string(y) +
                    ": drawn " + std::to_string(id) + ", nearest " + std::to_string(v.nearest) + ", then " +
                    std::to_string(v.runner_up) + " by " + std::to_string(v.ulps) + " ulp";
    }
}

triangle_scene random_scene(test::random& r, int number, int least = 3, int most = 60) {
  const auto kind = static_cast<scene_kind>(number % test::scene_kinds);
  const bool tiny = kind == scene_kind::tiny;  // enough of them for the pixels
  const int width = static_cast<int>(r.integer(1, tiny ? 8 : 48)),
            height = static_cast<int>(r.integer(1, tiny ? 8 : 72));
  test::scene_maker make(r, kind, width, height);
  return make(static_cast<int>(r.integer(least, most)));
}

// ---- the oracle itself

test::snapped_triangle on_screen(irg::subpixel a, irg::subpixel b, irg::subpixel c, float da, float db, float dc,
                                 std::uint32_t id = 1) {
  return {{{a, da}, {b, db}, {c, dc}}, id};
}

TEST_CASE("visibility_oracle: large integers") {
  test::natural a, b;
  a.add(test::uint128{1} << 127, 127), a.add(5, 3);
  b.add(1, 254), b.add(40, 0);
  CHECK(a.compare(b) == 0);
  b.add(1, 0);
  CHECK(a.compare(b) == -1);
  CHECK(b.compare(a) == 1);
  test::natural carried, power;
  for (int i = 0; i < 300; ++i) carried.add(1, i);
  carried.add(1, 0), power.add(1, 300);
  CHECK(carried.compare(power) == 0);
  CHECK(a.times(0xffffffffffffffffu).compare(a) == 1);
  test::natural product, by_hand;
  product.add(test::uint128{0xfffffffffffffffu} << 64 | 0xabcdefu, 35);
  by_hand.add((test::uint128{0xfffffffffffffffu} << 64 | 0xabcdefu) * 13, 35);
  CHECK(product.times(13).compare(by_hand) == 0);
}

TEST_CASE("visibility_oracle: depths are compared as the fractions they are") {
  const std::int64_t third[3] = {1, 1, 1}, two_thirds[3] = {2, 4, 0}, large[3] = {1LL << 49, 1, 0},
                     larger[3] = {1LL << 49, 2, 0};
  const irg::screen_vertex v[3] = {{{}, 0.0f}, {{}, 1.0f}, {{}, 1.0f}},
                           tiny[3] = {{{}, 0.5f}, {{}, 1e-45f}, {{}, 0.0f}};
  using test::exact_depth;
  CHECK(exact_depth::compare(exact_depth(third, v), exact_depth(two_thirds, v)) == 0);
  CHECK(exact_depth::ulps_between(exact_depth(third, v), exact_depth(two_thirds, v)) == 0);
  CHECK(exact_depth::compare(exact_depth(large, v), exact_depth(larger, v)) == -1);
  // 2^48 / (2^49 + 1) + a subnormal's share: far below long double.
  const irg::screen_vertex none[3] = {{{}, 0.5f}, {{}, 0.0f}, {{}, 0.0f}};
  CHECK(exact_depth::compare(exact_depth(large, tiny), exact_depth(large, none)) == 1);
  CHECK(exact_depth::ulps_between(exact_depth(large, tiny), exact_depth(large, none)) > 0);
  const irg::screen_vertex next[3] = {{{}, 0.50000006f}, {{}, 0.50000006f}, {{}, 0.50000006f}},
                           half[3] = {{{}, 0.5f}, {{}, 0.5f}, {{}, 0.5f}};
  CHECK(exact_depth::ulps_between(exact_depth(third, next), exact_depth(two_thirds, half)) == 1);

  // Against rationals.
  test::random r(1);
  for (int i = 0; i < 2000; ++i) {
    std::int64_t w[2][3];
    irg::screen_vertex d[2][3];
    test::rational depth[2];
    for (int k = 0; k < 2; ++k) {
      test::rational sum, total;
      for (int n = 0; n < 3; ++n) {
        w[k][n] = r.integer(n == 0, i % 2 ? 9 : 1 << 20);
        d[k][n].depth = static_cast<float>(r.integer(0, 16)) / 16;
        sum = sum + test::rational(w[k][n]) * test::rational::of(static_cast<double>(d[k][n].depth));
        total = total + test::rational(w[k][n]);
      }
      depth[k] = sum / total;
    }
    const int expected = depth[0] < depth[1] ? -1 : depth[1] < depth[0] ? 1 : 0;
    REQUIRE(exact_depth::compare(exact_depth(w[0], d[0]), exact_depth(w[1], d[1])) == expected);
  }
}

TEST_CASE("visibility_oracle: who is seen, by hand") {
  using far_is_0 = test::visibility_oracle<greater>;
  using far_is_1 = test::visibility_oracle<less>;
  // The upper left half of a square of four pixels, then all of it; the centres (1, 0) and (0, 1) are on the diagonal,
  // a right edge.
  const auto half = on_screen({0, 0}, {512, 0}, {0, 512}, 0.5f, 0.5f, 0.5f, 1);
  const auto all = on_screen({-64, -64}, {2048, -64}, {-64, 2048}, 0.25f, 0.25f, 0.25f, 2);
  const far_is_0 g({half, all}, 2, 2);
  CHECK(g.at(0, 0).nearest == 1);
  CHECK(g.at(0, 0).runner_up == 2);
  CHECK(g.at(0, 0).ulps == 0x1p22);
  CHECK(g.at(1, 0).nearest == 2);
  CHECK(g.at(1, 0).runner_up == 0);
  CHECK(g.at(1, 1).nearest == 2);
  const far_is_1 l({half, all}, 2, 2);
  CHECK(l.at(0, 0).nearest == 2);
  CHECK(l.at(0, 0).runner_up == 1);
  CHECK(l.ulps_behind(1, 0, 0) == 0x1p22);
  CHECK(l.ulps_behind(1, 1, 0) == std::numeric_limits<double>::infinity());
  CHECK(l.ulps_behind(0, 0, 0) == 3 * 0x1p21);  // from 1/4 to 1
  CHECK(g.ulps_behind(0, 0, 0) == 0x1p23);
  // Equal depths, in either order; pieces of one source are not behind each other; the far plane is not seen.
  const auto other = on_screen({-64, 2048}, {2048, -64}, {-64, -64}, 0.25f, 0.25f, 0.25f, 3);
  for (const far_is_0& o : {far_is_0({all, other}, 2, 2), far_is_0({other, all}, 2, 2)}) {
    CHECK(o.at(0, 0).nearest == 2);
    CHECK(o.at(0, 0).runner_up == 3);
    CHECK(o.at(0, 0).ulps == 0);
  }
  CHECK(far_is_0({all, all}, 2, 2).at(1, 1).runner_up == 0);
  const auto far = on_screen({-64, -64}, {2048, -64}, {-64, 2048}, 0.0f, 0.0f, 0.0f, 1);
  CHECK(far_is_0({far}, 2, 2).at(0, 0).nearest == 0);
  CHECK(far_is_1({far}, 2, 2).at(0, 0).nearest == 1);
}

TEST_CASE("visibility_oracle: triangles round a point share out its pixels, each once") {
  test::random r(2);
  for (int i = 0; i < 300; ++i) {
    const auto any = [&] { return static_cast<std::int32_t>(r.integer(-2, 18)) * 128; };
    const irg::subpixel a{any(), any()}, b{any(), any()}, c{any(), any()}, m{any(), any()};
    const auto whole = on_screen(a, b, c, 1, 1, 1);
    const test::snapped_triangle parts[3] = {on_screen(a, b, m, 1, 1, 1), on_screen(b, c, m, 1, 1, 1),
                                             on_screen(c, a, m, 1, 1, 1)};
    std::int64_t w[3];
    for (int y = -2; y < 10; ++y)
      for (int x = -2; x < 10; ++x) {
        using oracle = test::visibility_oracle<greater>;
        const auto winding = [&](const test::snapped_triangle& t) {
          const std::int64_t area = irg::twice_signed_area(t.v[0].position, t.v[1].position, t.v[2].position);
          return oracle::covers(t, x, y, w) ? (area > 0 ? 1 : -1) : 0;
        };
        REQUIRE(winding(parts[0]) + winding(parts[1]) + winding(parts[2]) == winding(whole));
        if (oracle::covers(whole, x, y, w)) REQUIRE(w[0] + w[1] + w[2] == std::abs(irg::twice_signed_area(a, b, c)));
      }
  }
}

// ---- irg against the oracle

template <class T>
void exact_on_random_scenes(std::uint64_t seed, int scenes) {
  test::random r(seed);
  tally kinds[test::scene_kinds], sum;
  for (int i = 0; i < scenes; ++i) {
    const triangle_scene s = random_scene(r, i);
    const face_culling culling = i / test::scene_kinds % 3 == 0 ? face_culling::back : face_culling::none;
    compare<greater, T>(s, culling, test::visible_ids<greater, T>(s, culling), i, kinds[i % test::scene_kinds]);
  }
  const char* const names[] = {"any", "slivers", "crossing", "sheets", "tiny", "huge", "through the eye", "lattice"};
  for (int k = 0; k < test::scene_kinds; ++k) {
    kinds[k].report(names[k], scenes / test::scene_kinds);
    CHECK(kinds[k].covered > kinds[k].pixels / 50);
    CHECK(kinds[k].hidden > kinds[k].pixels / 100);
    sum.pixels += kinds[k].pixels, sum.close += kinds[k].close, sum.otherwise += kinds[k].otherwise;
    CHECK(kinds[k].wrong == 0);
  }
  MESSAGE(sum.close, " of ", sum.pixels, " pixels within ", k_ulp, " ulp");
  CHECK(test::enough(sum.close * 10000 <= sum.pixels));
  CHECK(test::enough(sum.otherwise * 10000 <= sum.pixels));
  CHECK(kinds[static_cast<int>(scene_kind::lattice)].equal > scenes);
}

TEST_CASE("visible triangle: the exact one in every pixel, on random scenes of every kind") {
  exact_on_random_scenes<double>(201, test::is_release_tier() ? 10000 : 1000);
}

TEST_CASE("visible triangle: the exact one in every pixel, vertices in floats") {
  exact_on_random_scenes<float>(202, test::is_release_tier() ? 10000 : 400);
}

TEST_CASE("visible triangle: the same where the smaller depth is nearer") {
  test::random r(203);
  const int scenes = test::is_release_tier() ? 10000 : 400;
  tally sum;
  for (int i = 0; i < scenes; ++i) {
    triangle_scene s = random_scene(r, i);
    s.to_clip = test::square_view<less>(0.125, 64);
    const face_culling culling = i / test::scene_kinds % 3 == 0 ? face_culling::back : face_culling::none;
    compare<less>(s, culling, test::visible_ids<less>(s, culling), i, sum);
  }
  sum.report("nearer_is_less", scenes);
  CHECK(sum.otherwise * 10000 <= sum.pixels);
  CHECK(sum.covered > sum.pixels / 4);
  CHECK(sum.wrong == 0);
}

// Depths between 0 and 1 in steps of 2^-20 have their distance from 1 exactly, and both orders the same ids.
TEST_CASE("visible triangle: both orders see the same") {
  test::random r(204);
  const irg::mat<double, 4, 4> reversed = irg::orthographic(irg::view_window<double>{-1, 1, -1, 1}, 0, 1),
                               standard = irg::orthographic(irg::view_window<double>{-1, 1, -1, 1}, 0, 1,
                                                            irg::depth_range::standard);
  long long different = 0, seen = 0;
  for (int i = 0; i < 200; ++i) {
    triangle_scene s{{}, {}, reversed, 32, 40};
    for (std::uint32_t k = 0; k < 24; ++k) {
      const auto coordinate = [&] { return static_cast<double>(r.integer(-80, 80)) / 64; };
      const double x = coordinate(), y = coordinate();
      const auto step = k / 3 % 4 == 0 ? 1 << 19 : r.integer(1, (1 << 20) - 1);
      s.positions.push_back({x, y, -static_cast<double>(step) * 0x1p-20});
      if (k % 3 == 2) s.triangles.push_back({{k - 2, k - 1, k}});
    }
    const auto one = test::visible_ids(s);
    s.to_clip = standard;
    const auto other = test::visible_ids<less>(s);
    const test::visibility_oracle<less> oracle(test::snapped_triangles(s, face_culling::none), 32, 40);
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 32; ++x) {
        const test::visible v = oracle.at(x, y);
        seen += v.nearest != 0;
        if (v.ulps == 0 || v.ulps > 64) different += one.id(x, y) != other.id(x, y);
      }
  }
  CHECK(seen > 100000);
  CHECK(different == 0);
}

// Skips switched off as the bits of a number say.
constexpr skip_options skips(int off) {
  const auto on = [&](int bit) { return (off & bit) != 0 ? irg::skipping::off : irg::skipping::on; };
  return {on(1), on(2), on(4)};
}

TEST_CASE("visible triangle: the same bytes with each skip on and off and on any number of threads") {
  test::random r(205);
  const int scenes = test::is_release_tier() ? 10000 : 400;
  constexpr int threads[] = {1, 2, 3, 7, 16};
  long long skipped = 0;
  const auto in_order = [&]<class Order>(const triangle_scene& s, Order, int i) {
    for (const face_culling culling : {face_culling::none, face_culling::back}) {
      const test::id_picture expected = test::visible_ids<Order>(s, culling);
      const irg::skip_counts& c = expected.stats.skipped;
      skipped += c.frustum + c.tiny + c.occluded;
      REQUIRE(test::visible_ids<Order>(s, culling, irg::skip_nothing).same(expected));
      REQUIRE(test::visible_ids<Order>(s, culling, skips(i % 8)).same(expected));
      // Each scene on two numbers of threads, each number on many scenes.
      for (const int k : {i % 5, (i / 5 + 1) % 5}) {
        const skip_options skip = skips(i / 25 % 8);
        const test::id_picture one = test::visible_ids<Order>(s, culling, skip, irg::parallel{threads[k]});
        REQUIRE(one.same(expected));
        REQUIRE(one.stats == test::visible_ids<Order>(s, culling, skip).stats);
      }
    }
  };
  for (int i = 0; i < scenes; ++i) {
    triangle_scene s = random_scene(r, i);
    s.width *= 1 + i % 3, s.height *= 2;  // more tiles to share out
    CAPTURE(i);
    in_order(s, greater{}, i);
    s.to_clip = test::square_view<less>(0.125, 64);
    in_order(s, less{}, i);
  }
  CHECK(skipped > scenes);
}

// Puts one scene's triangles behind another's.
void append(triangle_scene& s, const triangle_scene& more) {
  const auto first = static_cast<std::uint32_t>(s.positions.size());
  s.positions.insert(s.positions.end(), more.positions.begin(), more.positions.end());
  for (const auto& t : more.triangles) s.triangles.push_back({{t.v[0] + first, t.v[1] + first, t.v[2] + first}});
}

// Pictures of several tiles, with triangles of all sizes: every path by size, and whatever rejects whole tiles.
TEST_CASE("visible triangle: the exact one in pictures of many tiles") {
  test::random r(206);
  const int scenes = test::is_release_tier() ? 400 : 10;
  tally sum;
  for (int i = 0; i < scenes; ++i) {
    const int width = static_cast<int>(r.integer(150, 400)), height = static_cast<int>(r.integer(100, 300));
    triangle_scene s{{}, {}, test::square_view(0.125), width, height};
    for (const auto kind : {scene_kind::any, scene_kind::sheets, scene_kind::slivers, scene_kind::tiny}) {
      test::scene_maker make(r, kind, width, height);
      append(s, make(static_cast<int>(r.integer(20, kind == scene_kind::sheets ? 400 : 80))));
    }
    const test::id_picture expected = test::visible_ids(s);
    compare<greater>(s, face_culling::none, expected, i, sum);
    REQUIRE(test::visible_ids(s, face_culling::none, irg::skip_nothing).same(expected));
    REQUIRE(test::visible_ids(s, face_culling::none, skip_options{}, irg::parallel{3}).same(expected));
  }
  sum.report("large pictures", scenes);
  CHECK(sum.covered > sum.pixels / 2);
  CHECK(sum.wrong == 0);
  CHECK(sum.close * 10000 <= sum.pixels);
}

// Where all depths differ in their last bits only, whatever rejects triangles unseen must not be a bit too eager.
TEST_CASE("visible triangle: layers some ulp apart, in tiles") {
  test::random r(209);
  const int scenes = test::is_release_tier() ? 2000 : 40;
  tally sum;
  for (int i = 0; i < scenes; ++i) {
    test::scene_maker make(r, scene_kind::layers, static_cast<int>(r.integer(60, 150)),
                           static_cast<int>(r.integer(60, 100)));
    const triangle_scene s = make(static_cast<int>(r.integer(10, 40)));
    const test::id_picture expected = test::visible_ids(s);
    compare<greater>(s, face_culling::none, expected, i, sum);
    REQUIRE(test::visible_ids(s, face_culling::none, irg::skip_nothing).same(expected));
  }
  sum.list.clear();
  sum.report("layers", scenes);
  CHECK(sum.covered > sum.pixels / 2);
  CHECK(sum.close > sum.pixels / 200);  // as intended here
  CHECK(sum.wrong == 0);
}

// More triangles than are taken in one portion, most smaller than a pixel, in two landscapes through each other; some
// that are cut before, between and behind them.
TEST_CASE("visible triangle: the exact one of a hundred thousand, on one thread and on three") {
  test::random r(207);
  triangle_scene s{{}, {}, test::square_view(0.125), 260, 190};
  for (const auto& [kind, triangles] : {std::pair{scene_kind::through_the_eye, 6},
                                        {scene_kind::sheets, 70000},
                                        {scene_kind::huge, 6},
                                        {scene_kind::sheets, 40000},
                                        {scene_kind::through_the_eye, 6}})
    append(s, test::scene_maker(r, kind, s.width, s.height)(triangles));
  CHECK(s.triangles.size() > 100000);
  const test::id_picture expected = test::visible_ids(s);
  tally sum;
  compare<greater>(s, face_culling::none, expected, 0, sum);
  sum.report("landscapes", 1);
  CHECK(sum.covered > sum.pixels / 2);
  CHECK(sum.wrong == 0);
  const test::id_picture other = test::visible_ids(s, face_culling::none, {}, irg::parallel{3});
  CHECK(other.same(expected));
  CHECK(other.stats == expected.stats);
  CHECK(test::visible_ids(s, face_culling::none, irg::skip_nothing).same(expected));
}

// The objects of a scene come in batches, each over vertices of its own; numbers, ties and bytes are those of one.
TEST_CASE("visible triangle: the same in one batch and in several") {
  test::random r(210);
  for (int i = 0; i < 64; ++i) {
    triangle_scene s = random_scene(r, i, 6);
    for (std::size_t k = s.triangles.size() / 2; k-- > 0;) s.triangles.push_back(s.triangles[k]);  // ties
    const test::id_picture expected = test::visible_ids(s);
    const auto mapping = irg::map_to_screen<double>({s.width, s.height});
    const auto count = static_cast<std::int64_t>(s.triangles.size());
    const auto cut = static_cast<std::size_t>(r.integer(0, count)),
               end = static_cast<std::size_t>(r.integer(static_cast<std::int64_t>(cut), count));
    const irg::projected_vertices<double> vertices[3] = {
        irg::project_vertices<double>(s.positions, s.to_clip, mapping),
        irg::project_vertices<double>(s.positions, s.to_clip, mapping),
        irg::project_vertices<double>(s.positions, s.to_clip, mapping)};
    const std::span<const irg::triangle_indices> all(s.triangles);
    const irg::triangle_batch<double> batches[3] = {
        {&vertices[0], all.first(cut), 0},
        {&vertices[1], all.subspan(cut, end - cut), static_cast<std::uint32_t>(cut)},
        {&vertices[2], all.subspan(end), static_cast<std::uint32_t>(end)}};
    irg::image<std::uint32_t> id(s.width, s.height, 9999u);
    irg::image<float> depth(s.width, s.height, 0.5f);
    const auto shader = [](const irg::triangle_batch<double>& b, std::uint32_t triangle, irg::facing) {
      return irg::solid_shader<std::uint32_t>{b.first_number + triangle + 1};
    };
    irg::draw_workspace workspace;
    for (int again = 0; again < 2; ++again) {  // a workspace that was used before
      const auto stats = irg::shade_batches<greater, double>(
          irg::render_target{id, depth}, {batches, mapping}, shader,
          {.culling = face_culling::none, .clear = irg::clearing::before_drawing, .workspace = &workspace});
      REQUIRE(id == expected.id);
      REQUIRE(depth == expected.depth);
      REQUIRE(stats == expected.stats);
    }
  }
}

// ---- order

TEST_CASE("visible triangle: 100 orders of the triangles, one depth buffer and one set of visible triangles") {
  test::random r(208);
  long long compared = 0, close = 0;
  for (int scene = 0; scene < 10; ++scene) {
    const auto kinds = {scene_kind::any, scene_kind::crossing, scene_kind::sheets, scene_kind::huge,
                        scene_kind::slivers};
    test::scene_maker make(r, kinds.begin()[scene % 5], 60, 70);
    const triangle_scene s = make(40);
    const test::id_picture expected = test::visible_ids(s);
    const test::visibility_oracle<greater> oracle(test::snapped_triangles(s, face_culling::none), 60, 70);
    std::vector<std::uint32_t> order(s.triangles.size());
    for (int shuffle = 0; shuffle < 10; ++shuffle) {
      for (std::uint32_t i = 0; i < order.size(); ++i) {
        order[i] = i;
        std::swap(order[i], order[static_cast<std::size_t>(r.integer(0, i))]);
      }
      triangle_scene t = s;
      for (std::size_t i = 0; i < order.size(); ++i) t.triangles[i] = s.triangles[order[i]];
      const test::id_picture m =
          test::visible_ids(t, face_culling::none, skip_options{}, irg::parallel{1 + shuffle % 3});
      REQUIRE(m.depth == expected.depth);
      for (int y = 0; y < 70; ++y)
        for (int x = 0; x < 60; ++x) {
          const test::visible v = oracle.at(x, y);
          if (v.runner_up != 0 && v.ulps <= k_ulp) {
            ++close;
            continue;
          }
          ++compared;
          REQUIRE((m.id(x, y) == 0 ? 0 : order[m.id(x, y) - 1] + 1) == expected.id(x, y));
        }
    }
  }
  CHECK(close * 1000 < compared);
}

// How many triangles are cut and cover a pixel's centre, and how many are cut and have one in the box of what is left.
std::pair<std::int64_t, std::int64_t> cut_triangles(const triangle_scene& s) {
  const auto mapping = irg::map_to_screen<double>({s.width, s.height});
  std::vector<int> found(s.triangles.size(), 0);
  for (const test::snapped_triangle& t : test::snapped_triangles(s, face_culling::none)) {
    bool cut = false;
    for (const std::uint32_t v : s.triangles[t.id - 1].v) {
      const auto p = s.to_clip * s.positions[v];
      cut = cut || p.z < 0 || p.z > p.w || std::fabs(p.x) > mapping.guard.guard_x * p.w ||
            std::fabs(p.y) > mapping.guard.guard_y * p.w;
    }
    if (!cut) continue;
    std::int64_t weight[3];
    const auto [x_low, x_high] = std::minmax({t.v[0].position.x, t.v[1].position.x, t.v[2].position.x});
    const auto [y_low, y_high] = std::minmax({t.v[0].position.y, t.v[1].position.y, t.v[2].position.y});
    for (int y = 0; y < s.height; ++y)
      for (int x = 0; x < s.width; ++x) {
        const int cx = x * 256 + 128, cy = y * 256 + 128;
        const bool boxed = x_low <= cx && cx <= x_high && y_low <= cy && cy <= y_high;
        const bool covered = boxed && test::visibility_oracle<greater>::covers(t, x, y, weight);
        found[t.id - 1] = std::max(found[t.id - 1], covered ? 2 : boxed ? 1 : 0);
      }
  }
  return {std::count(found.begin(), found.end(), 2),
          std::count_if(found.begin(), found.end(), [](int f) { return f > 0; })};
}

TEST_CASE("visibility: triangles that are cut are counted once each, whatever is skipped") {
  test::random r(77);
  std::int64_t least = 0, most = 0, counted = 0;
  for (int i = 0; i < 60; ++i) {
    test::scene_maker make(r, i % 3 == 0 ? scene_kind::huge : scene_kind::through_the_eye, 24, 17);
    const triangle_scene s = make(20);
    const auto [covering, boxed] = cut_triangles(s);
    const std::int64_t clipped = test::visible_ids(s).stats.clipped;
    REQUIRE(covering <= clipped);
    REQUIRE(clipped <= boxed);
    REQUIRE(test::visible_ids(s, face_culling::none, irg::skip_nothing).stats.clipped == clipped);
    least += covering, most += boxed, counted += clipped;
  }
  CHECK(least > 100);
  CHECK(counted < 60 * 20);
  MESSAGE(counted, " triangles are cut; ", least, " cover a centre, of ", most, " the box holds one");
}

}  // namespace
