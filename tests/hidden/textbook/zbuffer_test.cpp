// SPDX-License-Identifier: MIT
#include <irg/hidden/textbook/zbuffer.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string_view>
#include <vector>

#include <irg/colour/pixel.hpp>
#include <irg/raster/draw_triangle.hpp>
#include <irg/raster/textbook/fill_convex.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/triangle_coverage.hpp>

#include "support/archetypes.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

namespace {

using irg::image;
using irg::nearer_is_greater;
using irg::nearer_is_less;
using test::rational;
using P = irg::point<double, 3>;
using triangle = std::array<P, 3>;

constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();

constexpr auto nothing_drawn = [](const auto& picture, const auto& background) {
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      if (!(picture(x, y) == background)) return false;
  return true;
};

// The slides' run: 6 x 5 samples at whole numbers, boundaries included, the named triangles in the given order.
struct golden_run {
  image<char> screen{6, 5};
  image<double> depth{6, 5};
};

template <class Order>
constexpr golden_run run(std::string_view order, double sign) {
  constexpr irg::cell flat[3][3] = {{{0, 0}, {5, 0}, {0, 4}}, {{0, 0}, {5, 4}, {0, 4}}, {{1, 1}, {4, 1}, {1, 3}}};
  constexpr int heights[3][3] = {{0, 0, 0}, {-5, 5, 5}, {0, 0, 0}};
  golden_run g;
  const irg::textbook::zbuffer buffers{Order{}, g.screen, g.depth};
  buffers.clear('.', sign * -100);
  for (const char name : order) {
    const int k = name - 'a';
    triangle t{};
    for (int i = 0; i < 3; ++i)
      t[static_cast<std::size_t>(i)] = {double(flat[k][i].x), double(flat[k][i].y), sign * heights[k][i]};
    irg::depth_walk<double> walk(
        *irg::plane_depth_steps(*irg::plane_through(t[0], t[1], t[2]), irg::picture_grid<double>{0, 0, 1, 1}));
    irg::textbook::convex_spans(flat[k], irg::textbook::sample_rule::closed, irg::window_of(g.screen),
                                [&](irg::span_of_cells s) {
                                  walk.start(s.x_first, s.y);
                                  for (int x = s.x_first; x < s.x_last; ++x, walk.next())
                                    buffers.set_pixel(x, s.y, walk.value(), name);
                                });
  }
  return g;
}

constexpr bool screen_is(const golden_run& g, const std::array<std::string_view, 5>& rows) {
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 6; ++x)
      if (g.screen(x, y) != rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)]) return false;
  return true;
}

constexpr bool depth_is_golden(const golden_run& g, double sign) {
  constexpr double rows[5][6] = {{0, 0, 0, 0, 0, 0},
                                 {0, 0, 0, 0, 0, -100},
                                 {0, 0, 0, -100, -100, -100},
                                 {2.5, 2.5, 2.5, 2.5, -100, -100},
                                 {5, 5, 5, 5, 5, 5}};
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 6; ++x)
      if (g.depth(x, y) != sign * rows[y][x]) return false;
  return true;
}

TEST_CASE("textbook::zbuffer: the slides' run; the first drawn wins ties, the depths do not depend on the order") {
  constexpr std::array<std::string_view, 5> abc{"aaaaaa", "aaaac.", "aaa...", "bbbb..", "bbbbbb"},
      cba{"aaaaaa", "acccc.", "bcc...", "bbbb..", "bbbbbb"};
  CHECK_BOTH(screen_is(run<nearer_is_greater>("abc", 1), abc));
  CHECK_BOTH(screen_is(run<nearer_is_greater>("cba", 1), cba));
  // The same with distances: smaller wins.
  CHECK_BOTH(screen_is(run<nearer_is_less>("abc", -1), abc));
  CHECK_BOTH(screen_is(run<nearer_is_less>("cba", -1), cba));
  for (const std::string_view order : {"abc", "acb", "bac", "bca", "cab", "cba"}) {
    CHECK(depth_is_golden(run<nearer_is_greater>(order, 1), 1));
    CHECK(depth_is_golden(run<nearer_is_less>(order, -1), -1));
  }
}

TEST_CASE("textbook::zbuffer: SetPixel; strict, and false for NaN and outside of the buffers") {
  constexpr auto go = [] {
    image<char> screen(2, 2);
    image<double> depth(2, 3);
    const irg::textbook::zbuffer buffers{nearer_is_greater{}, screen, depth};
    buffers.clear('.', -10);
    bool right = buffers.window == irg::cell_window{0, 0, 2, 2};
    right = right && buffers.set_pixel(1, 1, 3, 'a') && !buffers.set_pixel(1, 1, 3, 'b');
    right = right && buffers.set_pixel(1, 1, 4, 'c') && !buffers.set_pixel(1, 1, nan, 'd');
    right = right && !buffers.set_pixel(0, 0, -10, 'e') && screen(0, 0) == '.';  // as far as the back plane
    right = right && !buffers.set_pixel(-1, 0, 5, 'f') && !buffers.set_pixel(0, 2, 5, 'f') &&
            !buffers.set_pixel(2, 0, 5, 'f') && !buffers.set_pixel(0, -1, 5, 'f');
    return right && screen(1, 1) == 'c' && depth(1, 1) == 4 && depth(0, 2) == -10;
  };
  CHECK_BOTH(go());
}

TEST_CASE("textbook::zbuffer: exact depths, in rasters that have nothing but get and set") {
  constexpr auto go = [] {
    archetype::writable_raster<archetype::pixel> screen;
    archetype::writable_raster<rational> depth;
    const irg::textbook::zbuffer buffers{nearer_is_greater{}, screen, depth};
    buffers.clear({'.'}, -1);
    const bool right = buffers.set_pixel(1, 0, rational(1, 3), archetype::pixel{1}) &&
                       !buffers.set_pixel(1, 0, rational(333, 1000), archetype::pixel{2}) &&
                       buffers.set_pixel(1, 0, rational(334, 1000), archetype::pixel{3});
    return right && screen.peek(1, 0).tint == 3 && screen.peek(7, 5).tint == '.';
  };
  CHECK_BOTH(go());
}

// Faces drawn by shade_triangle and by the textbook.
template <class Order>
int faces_drawn_otherwise(Order order, std::uint64_t seed) {
  constexpr int size = 30;
  test::random r(seed);
  image<int> ids(size, size, -1), book_ids(size, size, -1);
  image<float> depth(size, size, Order::farthest), book_depth(size, size, Order::farthest);
  const irg::textbook::zbuffer buffers{order, book_ids, book_depth};
  for (int i = 0; i < 10; ++i) {
    irg::screen_vertex v[3];
    for (auto& c : v)
      c = {{static_cast<std::int32_t>(r.integer(-2000, 9000)), static_cast<std::int32_t>(r.integer(-2000, 9000))},
           static_cast<float>(1.2 * r.unit() - 0.1),
           static_cast<float>(0.5 + r.unit())};
    if (i % 4 == 3) v[2].position = v[1].position;  // edge on
    for (int times = 0; times < 1 + i % 2; ++times) {
      irg::shade_triangle<Order>(ids, depth, {v[0], v[1], v[2]}, irg::solid_shader<int>{i});
      irg::textbook::zbuffer_face(buffers, irg::make_screen_face(v[0], v[1], v[2], 0), i);
    }
  }
  int wrong = 0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      wrong += ids(x, y) != book_ids(x, y) || std::memcmp(&depth(x, y), &book_depth(x, y), sizeof(float)) != 0;
  return wrong;
}

TEST_CASE("zbuffer_face: the pixels and the bits of shade_triangle, in every order") {
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    REQUIRE(faces_drawn_otherwise(nearer_is_greater{}, seed) == 0);
    REQUIRE(faces_drawn_otherwise(nearer_is_less{}, seed) == 0);
    REQUIRE(faces_drawn_otherwise(irg::drawing_order{}, seed) == 0);
  }
}

P random_corner(test::random& r, int size, int height) {
  const auto any = [&](int n) { return static_cast<double>(r.integer(-n / 4, n + n / 4)) / 256; };
  const double x = any(size * 256), y = any(size * 256);
  return {x, y, static_cast<double>(r.integer(-height, height)) / 16};
}

triangle random_triangle(test::random& r, int size, int height) {
  const P a = random_corner(r, size, height), b = random_corner(r, size, height);
  return {a, b, random_corner(r, size, height)};
}

rational exact_depth(const triangle& t, int x, int y) {
  const auto q = [](double v, int scale) { return rational(static_cast<std::int64_t>(v * scale), scale); };
  const auto corner = [&](std::size_t i) {
    return irg::point<rational, 3>{q(t[i].x, 256), q(t[i].y, 256), q(t[i].z, 16)};
  };
  return *irg::plane_depth(*irg::plane_through(corner(0), corner(1), corner(2)), rational(2 * x + 1, 2),
                           rational(2 * y + 1, 2));
}

// Which triangle is seen at a pixel, exactly: the first of the nearest; and by how much it is nearer than the next.
struct seen {
  int id = -1;
  double depth = 0, margin = inf;
};
seen exact_view(const std::vector<triangle>& scene, int x, int y) {
  seen s;
  std::vector<rational> all;
  rational best;
  for (std::size_t k = 0; k < scene.size(); ++k) {
    const auto snapped = [&](std::size_t i) {
      return irg::subpixel{irg::snap(scene[k][i].x), irg::snap(scene[k][i].y)};
    };
    const irg::triangle_coverage t = irg::cover_triangle(snapped(0), snapped(1), snapped(2));
    bool covered = false;
    irg::covered_spans(t, {x, y, x + 1, y + 1}, [&](irg::span_of_cells) { covered = true; });
    if (!covered) continue;
    const rational z = exact_depth(scene[k], x, y);
    if (s.id < 0 || best < z) s.id = static_cast<int>(k), best = z;
    all.push_back(z);
  }
  for (const rational& z : all)
    if (z < best) s.margin = std::min(s.margin, static_cast<double>(best - z));
  s.depth = static_cast<double>(best);
  return s;
}

TEST_CASE("zbuffer_polygon: ids and depths against the rational plane of each triangle, both orders") {
  const int scenes = std::getenv("IRG_RELEASE_TIER") != nullptr ? 2000 : 60;
  constexpr int size = 12;
  test::random r(21);
  int compared = 0, too_close = 0;
  for (int n = 0; n < scenes; ++n) {
    std::vector<triangle> scene;
    for (int k = 0; k < 8; ++k) scene.push_back(random_triangle(r, size, 160));
    image<int> ids(size, size), distance_ids(size, size);
    image<double> depth(size, size), distance(size, size);
    const irg::textbook::zbuffer toward{nearer_is_greater{}, ids, depth};
    const irg::textbook::zbuffer away{nearer_is_less{}, distance_ids, distance};
    toward.clear(-1, -1000);
    away.clear(-1, 1000);
    for (int k = 0; k < 8; ++k) {
      triangle t = scene[static_cast<std::size_t>(k)];
      REQUIRE(irg::textbook::zbuffer_polygon(toward, t, k));
      for (P& p : t) p.z = -p.z;
      REQUIRE(irg::textbook::zbuffer_polygon(away, t, k));
    }
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const seen s = exact_view(scene, x, y);
        REQUIRE(ids(x, y) == distance_ids(x, y));
        REQUIRE(depth(x, y) == -distance(x, y));
        if (s.id < 0) {
          REQUIRE(ids(x, y) == -1);
          continue;
        }
        if (s.margin < 1e-8) {
          ++too_close;
          continue;
        }
        REQUIRE(ids(x, y) == s.id);
        REQUIRE(std::abs(depth(x, y) - s.depth) < 1e-8);
        ++compared;
      }
  }
  CHECK(compared > scenes * 90);
  CHECK(too_close < compared / 1000);
}

TEST_CASE("zbuffer_polygon: coverage is fill_convex's, so that tilings hold; every depth within the corners' range") {
  test::random r(22);
  for (int n = 0; n < 400; ++n) {
    // A fan: coplanar triangles around a hub, steep ones among them.
    constexpr int size = 24;
    const double slope = std::pow(10.0, 8 * r.unit() - 2);
    const auto on_plane = [&](double x, double y) { return P{x, y, slope * (x - y / 3)}; };
    const auto any = [&] { return static_cast<double>(r.integer(0, size * 256)) / 256; };
    const double hub_x = any(), hub_y = any();
    std::vector<P> rim;
    for (int i = 0; i < 9; ++i) {
      const double angle = i * 0.698131700797731831;
      rim.push_back(on_plane(12 + 11 * std::cos(angle), 12 + 11 * std::sin(angle)));
    }
    const bool inside = std::hypot(hub_x - 12, hub_y - 12) < 9;
    const P hub = inside ? on_plane(hub_x, hub_y) : on_plane(12, 12);
    image<int> count(size, size, 0), filled(size, size, 0);
    image<double> depth(size, size, 0);
    image<int> ids(size, size, 0);
    const irg::textbook::zbuffer buffers{irg::drawing_order{}, ids, depth};
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const triangle t{hub, rim[i], rim[(i + 1) % rim.size()]};
      const double low = std::min({t[0].z, t[1].z, t[2].z}), high = std::max({t[0].z, t[1].z, t[2].z});
      buffers.clear(0, 0);
      irg::textbook::zbuffer_polygon(buffers, t, 1);
      for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
          if (ids(x, y) == 0) continue;
          REQUIRE((low <= depth(x, y) && depth(x, y) <= high));
          ++count(x, y);
        }
      const irg::point<double, 2> flat[] = {{t[0].x, t[0].y}, {t[1].x, t[1].y}, {t[2].x, t[2].y}};
      irg::fill_convex(filled, flat, [](int there) { return there + 1; });
    }
    REQUIRE(count == filled);
    int most = 0;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) most = std::max(most, count(x, y));
    REQUIRE(most == 1);
  }
}

TEST_CASE("zbuffer_polygon: a sample that the rounding of corners to 1/256 puts outside of a steep triangle") {
  // The corner is snapped onto the centre of pixel (5, 5), which is 0.001 beyond it, where the plane is far too low.
  constexpr auto go = [](auto order, double sign) {
    const triangle t{P{5.501, 5.501, 0}, P{20, 5.501, sign * 1e8}, P{6, 20, sign * 1e8}};
    image<int> ids(24, 24);
    image<double> depth(24, 24);
    const irg::textbook::zbuffer buffers{order, ids, depth};
    buffers.clear(0, sign * -1e9);
    irg::textbook::zbuffer_polygon(buffers, t, 1);
    const double plane_there = sign * *irg::plane_depth(*irg::plane_through(t[0], t[1], t[2]), 5.5, 5.5);
    bool right = plane_there < -1000 && ids(5, 5) == 1 && depth(5, 5) == 0;
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 24; ++x)
        right = right && (ids(x, y) == 0 || (0 <= sign * depth(x, y) && sign * depth(x, y) <= 1e8));
    return right;
  };
  CHECK_BOTH(go(nearer_is_greater{}, 1));
  CHECK_BOTH(go(nearer_is_less{}, -1));
}

TEST_CASE("zbuffer_polygon: 100 random permutations of triangles without ties give the same picture") {
  constexpr int size = 40;
  test::random r(23);
  std::vector<triangle> scene;
  for (int k = 0; k < 12; ++k) scene.push_back(random_triangle(r, size, 1600));
  std::vector<int> order(scene.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<int>(k);
  const auto draw = [&](const std::vector<int>& in) {
    image<int> ids(size, size);
    image<double> depth(size, size);
    const irg::textbook::zbuffer buffers{nearer_is_greater{}, ids, depth};
    buffers.clear(-1, -1000);
    for (const int k : in) irg::textbook::zbuffer_polygon(buffers, scene[static_cast<std::size_t>(k)], k);
    return std::pair{ids, depth};
  };
  const auto first = draw(order);
  for (int n = 0; n < 100; ++n) {
    for (std::size_t i = order.size() - 1; i > 0; --i)
      std::swap(order[i], order[static_cast<std::size_t>(r.integer(0, static_cast<std::int64_t>(i)))]);
    REQUIRE(draw(order) == first);
  }
}

TEST_CASE("zbuffer_polygon: equal depths stay with the first drawn, whichever diagonal cuts a quad") {
  constexpr auto go = [] {
    constexpr P a{1, 1, 4}, b{9, 1, 4}, c{9, 7, 4}, d{1, 7, 4};
    image<char> one(10, 8), other(10, 8);
    image<double> depth(10, 8);
    const irg::textbook::zbuffer left{nearer_is_greater{}, one, depth}, right{nearer_is_greater{}, other, depth};
    left.clear('.', 0);
    irg::textbook::zbuffer_polygon(left, triangle{a, b, c}, '1');
    irg::textbook::zbuffer_polygon(left, triangle{a, c, d}, '1');
    irg::textbook::zbuffer_polygon(left, triangle{a, b, d}, '2');
    irg::textbook::zbuffer_polygon(left, triangle{b, c, d}, '2');
    right.clear('.', 0);
    irg::textbook::zbuffer_polygon(right, triangle{b, d, a}, '1');
    irg::textbook::zbuffer_polygon(right, triangle{d, b, c}, '1');
    irg::textbook::zbuffer_polygon(right, std::array{d, c, b, a}, '2');
    return one == other && one(5, 4) == '1' && one(0, 0) == '.';
  };
  CHECK_BOTH(go());
}

TEST_CASE("zbuffer_polygon: degenerate input draws nothing and is true; what is out of range is false") {
  constexpr auto draw = [](const auto& ring, bool expected) {
    image<char> screen(8, 8);
    image<double> depth(8, 8);
    const irg::textbook::zbuffer buffers{nearer_is_greater{}, screen, depth};
    buffers.clear('.', -100);
    return irg::textbook::zbuffer_polygon(buffers, ring, 'x') == expected && nothing_drawn(screen, '.') &&
           nothing_drawn(depth, -100.0);
  };
  CHECK_BOTH(draw(std::array<P, 0>{}, true));
  CHECK_BOTH(draw(std::array{P{1, 1, 1}}, true));
  CHECK_BOTH(draw(std::array{P{1, 1, 1}, P{5, 5, 5}}, true));
  CHECK_BOTH(draw(triangle{P{1, 1, 1}, P{1, 1, 1}, P{1, 1, 1}}, true));
  CHECK_BOTH(draw(triangle{P{0, 0, 1}, P{2, 2, 3}, P{6, 6, 7}}, true));           // collinear
  CHECK_BOTH(draw(triangle{P{1, 1, 0}, P{6, 1, 0}, P{3, 1, 9}}, true));           // edge on: C = 0
  CHECK_BOTH(draw(triangle{P{1, 0, 0}, P{6, 5, 0}, P{3, 2, 9}}, true));           // edge on, aslant
  CHECK_BOTH(draw(triangle{P{0, 0, -200}, P{8, 0, -200}, P{0, 8, -200}}, true));  // behind the back plane
  CHECK_BOTH(draw(triangle{P{0, 0, -100}, P{8, 0, -100}, P{0, 8, -100}}, true));  // in the back plane
  CHECK_BOTH(draw(triangle{P{20, 0, 1}, P{30, 0, 1}, P{20, 8, 1}}, true));        // beside the picture
  for (const double bad : {nan, inf, -inf, 0x1p31, -1e300})
    for (int i = 0; i < 9; ++i) {
      double c[] = {0, 0, 1, 8, 0, 1, 0, 8, 1};
      c[i] = bad;
      CHECK(draw(triangle{P{c[0], c[1], c[2]}, P{c[3], c[4], c[5]}, P{c[6], c[7], c[8]}}, false));
    }
  // The reach itself is drawn, without overflow, in floats as well.
  using Pf = irg::point<float, 3>;
  image<char> screen(8, 8);
  image<float> depth(8, 8);
  const irg::textbook::zbuffer buffers{nearer_is_greater{}, screen, depth};
  buffers.clear('.', -0x1p31f);
  CHECK(irg::textbook::zbuffer_polygon(
      buffers, std::array{Pf{-0x1p30f, -0x1p30f, 1}, Pf{0x1p30f, -0x1p30f, 0x1p30f}, Pf{0, 0x1p30f, -0x1p30f}}, 'x'));
  CHECK(nothing_drawn(screen, 'x'));
}

TEST_CASE("zbuffer_polygon: zero-size targets, empty windows, and nothing outside of the window or the stride") {
  const triangle t{P{-9, -9, 1}, P{90, -9, 1}, P{-9, 90, 1}};
  image<char> none;
  image<double> no_depth;
  const irg::textbook::zbuffer empty{nearer_is_greater{}, none, no_depth};
  empty.clear('.', 0);
  CHECK(irg::textbook::zbuffer_polygon(empty, t, 'x'));

  std::vector<char> memory(10 * 6, 'g');
  std::vector<double> depths(11 * 6, -7);
  irg::image_view<char> screen(memory.data() + 1, 7, 5, 10);
  irg::image_view<double> depth(depths.data() + 1, 7, 5, 11 * sizeof(double));
  const irg::textbook::zbuffer buffers{nearer_is_greater{}, screen, depth};
  irg::textbook::zbuffer part = buffers;
  part.window = intersect(buffers.window, irg::cell_window{2, 1, 50, 3});
  CHECK(irg::textbook::zbuffer_polygon(part, t, 'x'));
  for (int i = 0; i < 60; ++i) {
    const int x = i % 10 - 1, y = i / 10;
    CHECK(memory[static_cast<std::size_t>(i)] == (x >= 2 && x < 7 && y >= 1 && y < 3 ? 'x' : 'g'));
  }
  for (int i = 0; i < 66; ++i) {
    const int x = i % 11 - 1, y = i / 11;
    CHECK(depths[static_cast<std::size_t>(i)] == (x >= 2 && x < 7 && y >= 1 && y < 3 ? 1 : -7));
  }
  part.window = {5, 1, 2, 3};
  CHECK(irg::textbook::zbuffer_polygon(part, t, 'y'));
  CHECK(std::find(memory.begin(), memory.end(), 'y') == memory.end());
}

// Triangles in front of an eye at (0, 0, 20), seen on 24 x 24 pixels about the axis.
constexpr irg::point<double, 2> middle{12, 12};

TEST_CASE(
    "zbuffer_polygon_perspective: 1/(d - z) and that of distances give the same picture; depths against the ray") {
  constexpr int size = 24;
  test::random r(24);
  int compared = 0;
  for (int n = 0; n < 40; ++n) {
    std::vector<triangle> scene;
    for (int k = 0; k < 6; ++k) {
      const auto corner = [&] {
        const double z = static_cast<double>(r.integer(-640, 160)) / 16, reach = 11 * (20 - z) / 20;
        return P{reach * (2 * r.unit() - 1), reach * (2 * r.unit() - 1), z};
      };
      const P a = corner(), b = corner();
      scene.push_back({a, b, corner()});
    }
    image<int> ids(size, size), distance_ids(size, size);
    image<double> inverse(size, size), distance(size, size);
    const irg::textbook::zbuffer toward{nearer_is_greater{}, ids, inverse};
    const irg::textbook::zbuffer away{nearer_is_less{}, distance_ids, distance};
    toward.clear(-1, 1.0 / 1020);
    away.clear(-1, -1.0 / 1020);
    for (int k = 0; k < 6; ++k) {
      triangle t = scene[static_cast<std::size_t>(k)];
      REQUIRE(irg::textbook::zbuffer_polygon_perspective(toward, t, 20, k, middle));
      for (P& p : t) p.z = -p.z;
      REQUIRE(irg::textbook::zbuffer_polygon_perspective(away, t, -20, k, middle));
    }
    REQUIRE(ids == distance_ids);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        REQUIRE(inverse(x, y) == -distance(x, y));
        // The nearest by the ray through the pixel's centre, among what the pixel may show: the rounding of corners to
        // 1/256 adds and takes samples at the edges, where planes reach beyond their corners.
        const double z = 20 - 1 / inverse(x, y), at_x = x + 0.5 - middle.x, at_y = y + 0.5 - middle.y;
        if (ids(x, y) < 0) continue;
        const triangle& t = scene[static_cast<std::size_t>(ids(x, y))];
        const auto exact = irg::plane_depth_perspective(*irg::plane_through(t[0], t[1], t[2]), 20.0, at_x, at_y);
        const double low = std::min({t[0].z, t[1].z, t[2].z}), high = std::max({t[0].z, t[1].z, t[2].z});
        REQUIRE((low - 1e-12 <= z && z <= high + 1e-12));
        if (exact && low < *exact && *exact < high) {
          REQUIRE(std::abs(z - *exact) < 1e-8);
          ++compared;
        }
        for (int k = 0; k < 6; ++k) {
          if (k == ids(x, y)) continue;
          const triangle& other = scene[static_cast<std::size_t>(k)];
          image<int> alone(size, size, -1);
          image<double> its_depth(size, size, 0);
          irg::textbook::zbuffer one{nearer_is_greater{}, alone, its_depth};
          one.window = {x, y, x + 1, y + 1};
          irg::textbook::zbuffer_polygon_perspective(one, other, 20, k, middle);
          if (alone(x, y) == k) REQUIRE(its_depth(x, y) <= inverse(x, y) + 1e-15);
        }
      }
  }
  CHECK(compared > 5000);
}

TEST_CASE("zbuffer_polygon_perspective: the eye in the plane, behind a corner, nowhere") {
  constexpr auto draw = [](const triangle& t, double d, bool expected) {
    image<char> screen(24, 24);
    image<double> depth(24, 24);
    const irg::textbook::zbuffer buffers{nearer_is_greater{}, screen, depth};
    buffers.clear('.', 0);
    return irg::textbook::zbuffer_polygon_perspective(buffers, t, d, 'x', middle) == expected &&
           nothing_drawn(screen, '.');
  };
  CHECK_BOTH(draw({P{1, 1, 0}, P{5, 5, 0}, P{3, 3, 5}}, 20, true));  // the plane holds the eye
  CHECK_BOTH(draw({P{1, 1, 0}, P{5, 1, 0}, P{3, 5, 20}}, 20, false));  // a corner beside the eye
  CHECK_BOTH(draw({P{1, 1, 0}, P{5, 1, 0}, P{3, 5, 30}}, 20, false));  // behind it
  CHECK_BOTH(draw({P{1, 1, 0}, P{5, 1, 0}, P{3, 5, 5}}, 0, false));
  CHECK_BOTH(draw({P{1, 1, 0}, P{5, 1, 0}, P{3, 5, 5}}, nan, false));
  CHECK_BOTH(draw({P{1, 1, 0}, P{5, 1, 0}, P{3, 5, 5}}, inf, false));
  CHECK_BOTH(draw({P{1, 1, 0}, P{5, nan, 0}, P{3, 5, 5}}, 20, false));
  CHECK_BOTH(draw({P{1, 1, 0}, P{5, 1, 0}, P{5, 1, 0}}, 20, true));
  // So near to the eye that its picture is out of reach.
  CHECK(draw({P{1, 1, 19.9999999999}, P{5, 1, 19.9999999999}, P{3, 5, 19.9999999999}}, 20, false));
}

constexpr std::uint64_t hash_of_scene() {
  image<int> ids(9, 9);
  image<float> depth(9, 9);
  const irg::textbook::zbuffer buffers{nearer_is_greater{}, ids, depth};
  buffers.clear(-1, -100);
  using Pf = irg::point<float, 3>;
  irg::textbook::zbuffer_polygon(buffers, std::array{Pf{0.3f, 0.7f, 1.1f}, Pf{8.6f, 1.9f, 3.3f}, Pf{2.2f, 8.8f, -1.7f}},
                                 1);
  irg::textbook::zbuffer_polygon(buffers, std::array{Pf{8, 8, 2.1f}, Pf{1, 7, 0.3f}, Pf{4, 0, 2.9f}, Pf{7, 1, 3.1f}},
                                 2);
  irg::textbook::zbuffer_polygon_perspective(buffers, std::array{Pf{1, 1, -9}, Pf{9, 2, 7}, Pf{3, 9, 1}}, 13, 3);
  std::uint64_t h = 14695981039346656037u;
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 9; ++x) {
      h = (h ^ static_cast<std::uint64_t>(ids(x, y) + 2)) * 1099511628211u;
      h = (h ^ std::bit_cast<std::uint32_t>(depth(x, y))) * 1099511628211u;
    }
  return h;
}

TEST_CASE("zbuffer_polygon: the same bits in constant evaluation and at run time") {
  constexpr std::uint64_t constant = hash_of_scene();
  CHECK(hash_of_scene() == constant);
}

}  // namespace
