// SPDX-License-Identifier: MIT
#include <irg/render/draw_transparent.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <irg/core/threads.hpp>

#include "support/check_both.hpp"
#include "support/ulp.hpp"
#include "support/visible_scenes.hpp"

namespace {

using irg::depth_test;
using irg::face_culling;
using irg::facing;
using irg::rgba8;
using irg::skip_options;
using irg::transparent_options;
using batch = irg::triangle_batch<double>;
using greater = irg::nearer_is_greater;
using less = irg::nearer_is_less;
using test::scene_kind;
using test::triangle_scene;

struct picture {
  irg::image<rgba8> colour;
  irg::image<float> depth;
  irg::render_counts stats;
  constexpr bool same(const picture& o) const { return colour == o.colour && depth == o.depth; }
};

// Any colour and opacity, by the triangle's number and its side.
constexpr rgba8 colour_of(std::uint32_t triangle, facing side) {
  test::random r(triangle * 2 + (side == facing::front ? 0 : 1));
  const std::uint64_t bits = r.next();
  const auto byte = [&](int i) { return static_cast<std::uint8_t>(bits >> 8 * i & 255); };
  return {byte(0), byte(1), byte(2), bits >> 40 & 7 ? byte(3) : (bits >> 44 & 1 ? std::uint8_t{255} : std::uint8_t{0})};
}

constexpr auto colours = [](const batch& b, std::uint32_t triangle, facing side) {
  return irg::solid_shader<rgba8>{colour_of(b.first_number + triangle, side)};
};

// The opaque triangles, their numbers turned into colours.
template <class Order>
constexpr picture opaque_part(const triangle_scene& s) {
  const auto ids = test::visible_ids<Order>(s);
  picture p{irg::image<rgba8>(s.width, s.height, {250, 249, 246, 255}), ids.depth, {}};
  for (int y = 0; y < s.height; ++y)
    for (int x = 0; x < s.width; ++x)
      if (ids.id(x, y) != 0) {
        p.colour(x, y) = colour_of(ids.id(x, y) * 31, facing::front);
        p.colour(x, y).a = 255;
      }
  return p;
}

template <class Order, depth_test Test = depth_test::nearer, class Blend = irg::over_in_light,
          class E = irg::sequential>
constexpr picture blended(picture p, const triangle_scene& s, const transparent_options<Blend>& settings = {},
                          const E& executor = {}) {
  const auto mapping = irg::map_to_screen<double>({s.width, s.height});
  const auto vertices = irg::project_vertices<double>(s.positions, s.to_clip, mapping);
  const batch one[1] = {{&vertices, s.triangles, 0}};
  p.stats = irg::draw_transparent<Order, Test, double>(irg::render_target{p.colour, p.depth}, {one, mapping}, colours,
                                                       settings, executor);
  return p;
}

// ---- the oracle: every triangle drawn alone, then every pixel by itself

struct layer {
  test::id_picture alone;
  double depth;  // of the centroid
  bool last;
  std::uint32_t number;
  bool front;
};

template <class Order>
std::vector<layer> layers_of(const triangle_scene& s, face_culling culling) {
  std::vector<layer> all;
  for (std::uint32_t i = 0; i < s.triangles.size(); ++i) {
    triangle_scene one = s;
    one.triangles = {s.triangles[i]};
    const auto& v = s.triangles[i].v;
    const auto a = s.to_clip * s.positions[v[0]], b = s.to_clip * s.positions[v[1]], c = s.to_clip * s.positions[v[2]];
    const double z = a.z + (b.z + c.z), w = a.w + (b.w + c.w);
    const bool front = test::visible_ids<Order>(one, face_culling::back).stats.skipped.backface == 0;
    all.push_back({test::visible_ids<Order>(one, culling), z / w, !(w > 0), i, front});
  }
  std::sort(all.begin(), all.end(), [](const layer& a, const layer& b) {
    if ((a.last && b.last) || a.depth == b.depth) return a.number < b.number;
    if (a.last || b.last) return b.last;
    return Order::nearer(1.0f, 0.0f) ? a.depth < b.depth : a.depth > b.depth;
  });
  return all;
}

template <class Order, class Blend>
picture composed(picture p, const triangle_scene& s, face_culling culling, bool equal_too, const Blend& blend,
                 long long& mixed) {
  const auto layers = layers_of<Order>(s, culling);
  for (int y = 0; y < s.height; ++y)
    for (int x = 0; x < s.width; ++x)
      for (const layer& l : layers) {
        const float there = p.depth(x, y), depth = l.alone.depth(x, y);
        if (l.alone.id(x, y) == 0) continue;
        if (!(Order::nearer(depth, there) || (equal_too && depth == there))) continue;
        p.colour(x, y) = blend(p.colour(x, y), colour_of(l.number, l.front ? facing::front : facing::back));
        ++mixed;
      }
  return p;
}

constexpr scene_kind kinds[] = {
    scene_kind::any,    scene_kind::crossing, scene_kind::huge,   scene_kind::through_the_eye,
    scene_kind::sheets, scene_kind::lattice,  scene_kind::slivers};

template <class Order>
void against_composition(std::uint64_t seed, int scenes) {
  test::random r(seed);
  long long mixed = 0, hidden = 0, passed_over = 0;
  for (int i = 0; i < scenes; ++i) {
    CAPTURE(i);
    const int width = static_cast<int>(r.integer(1, i % 5 == 0 ? 150 : 40)),
              height = static_cast<int>(r.integer(1, 72));
    triangle_scene walls =
                       test::scene_maker(r, kinds[r.integer(0, 6)], width, height)(static_cast<int>(r.integer(0, 9))),
                   glass = test::scene_maker(r, kinds[i % 7], width, height)(static_cast<int>(r.integer(1, 24)));
    walls.to_clip = glass.to_clip = test::square_view<Order>(0.125, 64);
    if (i % 3 == 0)  // glass on the walls
      for (std::size_t k = 0; k < walls.triangles.size(); k += 2) {
        for (std::uint32_t v : walls.triangles[k].v) glass.positions.push_back(walls.positions[v]);
        const auto n = static_cast<std::uint32_t>(glass.positions.size());
        glass.triangles.push_back({{n - 3, n - 2, n - 1}});
        glass.triangles.push_back(glass.triangles.back());  // equal depths: by number
      }
    const picture before = opaque_part<Order>(walls);
    const face_culling culling = i % 4 == 3 ? face_culling::back : face_culling::none;
    const picture drawn = blended<Order>(before, glass, {culling, {}});
    long long here = 0;
    const picture expected = composed<Order>(before, glass, culling, false, irg::over_in_light{}, here);
    REQUIRE(drawn.same(expected));
    REQUIRE(drawn.stats.pixels.shaded == here);
    mixed += here;
    hidden += drawn.stats.pixels.tested - drawn.stats.pixels.shaded;
    passed_over += drawn.stats.skipped.occluded;
    here = 0;
    REQUIRE(blended<Order, depth_test::nearer_or_equal>(before, glass,
                                                        transparent_options<irg::over_as_encoded>{culling, {}})
                .same(composed<Order>(before, glass, culling, true, irg::over_as_encoded{}, here)));
    // However the work is done.
    const picture plain = blended<Order>(before, glass, {culling, irg::skip_nothing});
    REQUIRE(plain.same(expected));
    REQUIRE(plain.stats.pixels.shaded == drawn.stats.pixels.shaded);
    REQUIRE(plain.stats.skipped == irg::skip_counts{0, plain.stats.skipped.backface, 0, 0});
    for (const int threads : {1, 2, 3, 16}) {
      const picture other = blended<Order>(before, glass, {culling, {}}, irg::parallel{threads});
      REQUIRE(other.same(expected));
      REQUIRE(other.stats == drawn.stats);
    }
  }
  CHECK(mixed > scenes * 500);
  CHECK(hidden > scenes * 10);
  CHECK(passed_over > scenes / 10);
}

TEST_CASE("draw_transparent: every pixel as composed one by one from triangles drawn alone") {
  against_composition<greater>(301, test::is_release_tier() ? 3000 : 120);
}

TEST_CASE("draw_transparent: the same where the smaller depth is nearer") {
  against_composition<less>(302, test::is_release_tier() ? 3000 : 60);
}

// ---- by hand: squares of the whole picture, at distances, seen in parallel

struct pane {
  double distance;
  rgba8 colour;
};

template <class Order = greater, depth_test Test = depth_test::nearer, class Blend = irg::over_as_encoded>
constexpr rgba8 through(std::initializer_list<pane> panes, float wall_depth = 0.0f, irg::skipping occluded = {}) {
  std::vector<irg::point<double, 3>> positions;
  std::vector<irg::triangle_indices> triangles;
  std::vector<rgba8> colour_of_pane;
  for (const pane& p : panes) {
    const auto n = static_cast<std::uint32_t>(positions.size());
    positions.push_back({-3, -3, -p.distance});
    positions.push_back({9, -3, -p.distance});
    positions.push_back({-3, 9, -p.distance});
    triangles.push_back({{n, n + 1, n + 2}});
    colour_of_pane.push_back(p.colour);
  }
  irg::image<rgba8> colour(1, 1, {0, 0, 0, 255});
  irg::image<float> depth(1, 1, wall_depth);
  const auto mapping = irg::map_to_screen<double>({1, 1});
  const auto vertices = irg::project_vertices<double>(
      positions, irg::orthographic(irg::view_window<double>{-1, 1, -1, 1}, 0, 8), mapping);
  const batch one[1] = {{&vertices, triangles, 0}};
  irg::draw_transparent<Order, Test, double>(
      irg::render_target{colour, depth}, {one, mapping},
      [&](const batch&, std::uint32_t i, facing) { return irg::solid_shader<rgba8>{colour_of_pane[i]}; },
      transparent_options<Blend>{face_culling::none, {{}, {}, occluded}});
  return colour(0, 0);
}

TEST_CASE("draw_transparent: panes by hand") {
  constexpr rgba8 red{200, 0, 0, 51}, blue{0, 0, 200, 51}, black{0, 0, 0, 255};
  CHECK_BOTH(through({{2, red}}) == rgba8{40, 0, 0, 255});
  CHECK_BOTH(through({{2, red}, {4, blue}}) == rgba8{40, 0, 32, 255});
  CHECK_BOTH(through({{4, blue}, {2, red}}) == rgba8{40, 0, 32, 255});
  CHECK_BOTH(through({{4, red}, {2, blue}}) == rgba8{32, 0, 40, 255});
  CHECK_BOTH(through({}) == black);
  // Equally far: the first given lies below.
  CHECK_BOTH(through({{2, red}, {2, blue}}) == rgba8{32, 0, 40, 255});
  CHECK_BOTH(through({{2, blue}, {2, red}}) == rgba8{40, 0, 32, 255});
  // In the order given.
  CHECK_BOTH(through<irg::drawing_order>({{2, red}, {4, blue}}) == rgba8{32, 0, 40, 255});
  // A wall at distance 3 (depth 5/8) between them, before both, and on one of them.
  CHECK_BOTH(through({{4, blue}, {2, red}}, 0.625f) == rgba8{40, 0, 0, 255});
  CHECK_BOTH(through({{4, blue}, {2, red}}, 0.625f, irg::skipping::off) == rgba8{40, 0, 0, 255});
  CHECK_BOTH(through({{4, blue}, {2, red}}, 0.875f) == black);
  CHECK_BOTH(through({{4, blue}, {2, red}}, 0.75f) == black);
  CHECK_BOTH(through<greater, depth_test::nearer_or_equal>({{4, blue}, {2, red}}, 0.75f) == rgba8{40, 0, 0, 255});
  CHECK_BOTH(through<greater, depth_test::equal>({{4, blue}, {2, red}}, 0.5f) == rgba8{0, 0, 40, 255});
  CHECK_BOTH(through<greater, depth_test::always>({{4, blue}, {2, red}}, 0.9f) == rgba8{40, 0, 32, 255});
  CHECK_BOTH(through<greater, depth_test::never>({{4, blue}, {2, red}}) == black);
  CHECK_BOTH(through<greater, depth_test::nearer, irg::over_in_light>({{2, {255, 255, 255, 51}}}) ==
             rgba8{124, 124, 124, 255});
  // Outside of the depth range, and not finite.
  CHECK_BOTH(through({{9, blue}, {-1, red}}) == black);
  constexpr double inf = std::numeric_limits<double>::infinity(), no_number = std::numeric_limits<double>::quiet_NaN();
  CHECK(through({{no_number, blue}, {2, red}, {inf, blue}, {-inf, blue}}) == rgba8{40, 0, 0, 255});
}

TEST_CASE("draw_transparent: depths that are no numbers hide what is behind them, skips or not") {
  test::random r(303);
  for (int i = 0; i < 60; ++i) {
    const triangle_scene glass = test::scene_maker(r, kinds[i % 7], 70, 20)(12);
    picture before{irg::image<rgba8>(70, 20, {1, 2, 3, 255}), irg::image<float>(70, 20, 0.0f), {}};
    for (int y = 0; y < 20; ++y)
      for (int x = 0; x < 70; ++x) {
        const auto kind = r.integer(0, 9);
        before.depth(x, y) = kind < i % 10   ? std::numeric_limits<float>::quiet_NaN()
                             : kind % 3 == 0 ? static_cast<float>(r.unit()) * 0.1f
                                             : 0.0f;
      }
    const picture on = blended<greater>(before, glass),
                  off = blended<greater>(before, glass, {face_culling::none, irg::skip_nothing});
    REQUIRE(on.colour == off.colour);
    for (int y = 0; y < 20; ++y)
      for (int x = 0; x < 70; ++x)
        if (before.depth(x, y) != before.depth(x, y)) REQUIRE(on.colour(x, y) == rgba8{1, 2, 3, 255});
  }
}

// ---- an opacity at each vertex

struct light_and_opacity {
  static constexpr int attribute_count = 4;
  std::span<const std::array<float, 4>> vertices;
  constexpr const float* attributes(const batch&, std::uint32_t v, facing) const { return vertices[v].data(); }
  constexpr rgba8 pixel(const std::array<float, 4>& a) const {
    return irg::encode({a[0], a[1], a[2]}, static_cast<std::uint8_t>(irg::clamped(a[3], 0.0f, 1.0f) * 255.0f + 0.5f));
  }
};

TEST_CASE("draw_transparent: opacity of each vertex, in two batches") {
  const irg::point<double, 3> positions[] = {{-1, -1, -2}, {3, -1, -2}, {-1, 3, -2}};
  const std::array<float, 4> values[] = {{1, 1, 1, 0}, {1, 1, 1, 1}, {1, 1, 1, 0}};
  const irg::triangle_indices triangles[] = {{{0, 1, 2}}};
  const auto mapping = irg::map_to_screen<double>({16, 16});
  const auto vertices = irg::project_vertices<double>(
      positions, irg::orthographic(irg::view_window<double>{-1, 1, -1, 1}, 0, 8), mapping);
  irg::image<rgba8> colour(16, 16, {0, 0, 0, 255});
  irg::image<float> depth(16, 16, 0.0f);
  const batch two[2] = {{&vertices, triangles, 0}, {&vertices, triangles, 1}};
  const auto stats =
      irg::draw_transparent(irg::render_target{colour, depth}, {two, mapping}, light_and_opacity{values});
  CHECK(stats.pixels.shaded == 2 * 256);
  CHECK(stats.triangles == 2);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      // The opacity is (x + 1/2) / 32, rounded to 1/255 and laid over twice.
      const double a = std::floor(255 * (x + 0.5) / 32 + 0.5) / 255, light = 1 - (1 - a) * (1 - a);
      const double code = light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
      CHECK(std::abs(colour(x, y).r - 255 * code) < 2);
      CHECK(depth(x, y) == 0.0f);
    }
}

TEST_CASE("draw_transparent: called with defaults for order, test and blending") {
  const irg::point<double, 3> positions[] = {{-1, -1, -2}, {3, -1, -2}, {-1, 3, -2}};
  const irg::triangle_indices triangles[] = {{{0, 1, 2}}};
  const auto mapping = irg::map_to_screen<double>({2, 2});
  const auto vertices = irg::project_vertices<double>(
      positions, irg::orthographic(irg::view_window<double>{-1, 1, -1, 1}, 0, 8), mapping);
  const std::vector<batch> panes{{&vertices, triangles}};
  irg::image<rgba8> colour(2, 2, {0, 0, 0, 255});
  irg::image<float> depth(2, 2, 0.0f);
  irg::draw_transparent(
      irg::render_target{colour, depth}, irg::projected_triangles{panes, mapping},
      [](const batch&, std::uint32_t, facing) { return irg::solid_shader<rgba8>{{255, 255, 255, 51}}; });
  CHECK(colour == irg::image<rgba8>(2, 2, {124, 124, 124, 255}));
}

TEST_CASE("draw_transparent: pictures of no size, batches of no triangles") {
  irg::image<rgba8> colour;
  irg::image<float> depth;
  const auto mapping = irg::map_to_screen<double>({1, 1});
  CHECK(irg::draw_transparent(irg::render_target{colour, depth}, {{}, mapping}, colours) == irg::render_counts{});
  const auto vertices =
      irg::project_vertices<double>({}, irg::orthographic(irg::view_window<double>{-1, 1, -1, 1}, 0, 8), mapping);
  const batch none[1] = {{&vertices, {}, 0}};
  CHECK(irg::draw_transparent(irg::render_target{colour, depth}, {none, mapping}, colours) == irg::render_counts{});
}

}  // namespace
